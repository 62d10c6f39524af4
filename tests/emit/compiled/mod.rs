//! Emitted code, handed to compilers: each operation alone, in every style, with every reserved word as a name, and for
//! the mesh class of a course, whose expectations it has to meet.

mod alone;
mod compiler;
mod reserved;
mod scotty3d;
mod styles;
