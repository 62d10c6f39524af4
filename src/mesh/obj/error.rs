//! Why a file cannot be read or written, with the line where that shows.

use std::fmt;
use std::io;

use crate::mesh::build_error::BuildError;
use crate::mesh::id::ElementKind;

/// A failure to read or write a file. Lines and numbers are the file's: from 1.
#[derive(Debug)]
pub struct ObjError {
    pub file: String,
    pub line: Option<u32>,
    pub reason: ObjReason,
}

#[derive(Debug)]
pub enum ObjReason {
    Io(io::Error),
    /// The folder to write to does not exist.
    NoFolder(String),
    /// The file to write is protected.
    ReadOnly,
    /// A statement with a word where a number should be, or too few of them.
    NotNumbers {
        statement: &'static str,
        needs: &'static str,
    },
    NotAnIndex {
        text: String,
    },
    ZeroIndex,
    /// An index that leads out of the file.
    NoSuch {
        what: Indexed,
        index: i64,
        have: usize,
    },
    FewCorners {
        corners: usize,
    },
    NotFinite {
        vertex: u32,
    },
    RepeatedCorner {
        vertex: u32,
    },
    EdgeUsedThrice {
        ends: [u32; 2],
        lines: [u32; 3],
    },
    SameDirection {
        from: u32,
        to: u32,
        lines: [u32; 2],
    },
    BowTie {
        vertex: u32,
        lines: [u32; 2],
    },
    TooLarge {
        kind: ElementKind,
    },
    /// The table of faces that came back is not the one sent.
    Garbled,
}

/// What a corner of a face names by an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Indexed {
    Vertex,
    Texture,
    Normal,
}

impl Indexed {
    fn names(self) -> [&'static str; 2] {
        match self {
            Self::Vertex => ["vertex", "vertices"],
            Self::Texture => ["texture coordinate", "texture coordinates"],
            Self::Normal => ["normal", "normals"],
        }
    }
}

impl fmt::Display for ObjError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}: {}", self.file, self.reason),
            None => write!(f, "{}: {}", self.file, self.reason),
        }
    }
}

impl fmt::Display for ObjReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => write!(f, "{error}"),
            Self::ReadOnly => f.write_str("the file is read-only"),
            Self::NoFolder(folder) => write!(f, "the folder `{folder}` does not exist"),
            Self::NotNumbers { statement, needs } => write!(f, "`{statement}` needs {needs}"),
            Self::NotAnIndex { text } => write!(f, "`{text}` is not a corner of a face"),
            Self::ZeroIndex => write!(f, "0 is no index: they count from 1, or back from -1"),
            Self::NoSuch { what, index, have } => {
                let [one, many] = what.names();
                let things = if *have == 1 { one } else { many };
                write!(f, "there is no {one} {index}: the file has {have} {things}")
            }
            Self::FewCorners { corners } => {
                let s = if *corners == 1 { "" } else { "s" };
                write!(f, "a face needs 3 corners or more, and this has {corners} corner{s}")
            }
            Self::NotFinite { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not a finite number")
            }
            Self::RepeatedCorner { vertex } => {
                write!(f, "the face has vertex {vertex} as a corner twice")
            }
            Self::EdgeUsedThrice { ends: [v, w], lines: [a, b, c] } => write!(
                f,
                "the faces of lines {a}, {b} and {c} share the edge between vertices {v} and {w}, and an edge has two sides"
            ),
            Self::SameDirection { from, to, lines: [a, b] } => write!(
                f,
                "the faces of lines {a} and {b} both run from vertex {from} to vertex {to}, so one of them is turned over"
            ),
            Self::BowTie { vertex, lines: [a, b] } => write!(
                f,
                "the faces of lines {a} and {b} meet at vertex {vertex} only, so the surface is pinched there"
            ),
            Self::TooLarge { kind } => {
                write!(f, "there are more {} than can be numbered", kind.plural())
            }
            Self::Garbled => write!(f, "the faces could not be read"),
        }
    }
}

impl std::error::Error for ObjError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.reason {
            ObjReason::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl ObjReason {
    /// The same reason in the numbers of the file, and the line to show: the last one
    /// of those concerned.
    pub(super) fn from_build(
        error: &BuildError,
        vertex_lines: &[u32],
        face_lines: &[u32],
    ) -> (Option<u32>, Self) {
        let face_line = |polygon: usize| face_lines.get(polygon).copied().unwrap_or(0);
        match *error {
            BuildError::TooLarge { kind } => (None, Self::TooLarge { kind }),
            BuildError::NotFinite { vertex, .. } => {
                let line = vertex_lines.get(vertex as usize).copied();
                (line, Self::NotFinite { vertex: vertex + 1 })
            }
            BuildError::TooFewCorners { polygon, corners } => {
                (Some(face_line(polygon)), Self::FewCorners { corners })
            }
            BuildError::NoSuchVertex { polygon, vertex, vertices } => {
                let index = i64::from(vertex) + 1;
                let reason = Self::NoSuch { what: Indexed::Vertex, index, have: vertices };
                (Some(face_line(polygon)), reason)
            }
            BuildError::RepeatedCorner { polygon, vertex } => {
                (Some(face_line(polygon)), Self::RepeatedCorner { vertex: vertex + 1 })
            }
            BuildError::EdgeUsedThrice { ends: [v, w], polygons } => {
                let mut lines = polygons.map(face_line);
                lines.sort_unstable();
                let reason = Self::EdgeUsedThrice { ends: [v + 1, w + 1], lines };
                (lines.last().copied(), reason)
            }
            BuildError::SameDirection { from, to, polygons } => {
                let mut lines = polygons.map(face_line);
                lines.sort_unstable();
                let reason = Self::SameDirection { from: from + 1, to: to + 1, lines };
                (lines.last().copied(), reason)
            }
            BuildError::BowTie { vertex, polygons } => {
                let mut lines = polygons.map(face_line);
                lines.sort_unstable();
                (lines.last().copied(), Self::BowTie { vertex: vertex + 1, lines })
            }
        }
    }
}
