//! The standard library: operations and algorithms written in the language itself.
//!
//! The files below `std/` are part of the program, and `use "std/triangle.hedge"` finds them
//! wherever it runs. Users read them first, so they are kept readable: the head of each file says
//! what it is for, and the comment above each operation what it does.
//!
//! Beside them are targets: style files, which say how C++ is spelled for a mesh class.
//!
//! This module has the names and the texts only; a program that uses a library file reads it like
//! any other file.

mod shelf;

pub use shelf::{FOLDER, LibraryFile, file, files, outside, target, targets};
