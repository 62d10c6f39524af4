//! Emitted code, handed to compilers: in every style, with every reserved word as a name, and for
//! the mesh class of a course, whose expectations it has to meet.

mod compiler;
mod reserved;
mod scotty3d;
mod styles;
