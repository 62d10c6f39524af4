//! The standard library: operations and algorithms written in the language itself.
//!
//! The files below `std/` are part of the program, and `use "std/triangle.hedge"` finds them
//! wherever it runs. They are what people read first, so they are kept as texts to be read:
//! what each file is for stands at its head, what each operation does above it.
//!
//! Beside them lie targets: files of styles, which say how C++ is spelled for a mesh class.
//!
//! Here are the names and the texts, nothing else; a program that uses one reads it as any other file.

mod shelf;

pub use shelf::{FOLDER, LibraryFile, file, files, target, targets};
