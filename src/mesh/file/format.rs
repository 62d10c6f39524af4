//! File formats, recognized by file name endings or by content.

use std::fmt;
use std::path::Path;

use super::error::FileReason;
use super::scan::without_mark;
use super::{msh, off, stl};

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileFormat {
    /// Wavefront OBJ.
    Obj,
    /// The Stanford polygon file format.
    Ply,
    /// Stereolithography.
    Stl,
    /// The Geomview object file format, with its prefixes.
    Off,
    /// Gmsh, versions 2.2 and 4.1.
    Msh,
    /// Halfedge tables.
    Halfedges,
}

impl FileFormat {
    pub const ALL: [Self; 6] =
        [Self::Obj, Self::Ply, Self::Stl, Self::Off, Self::Msh, Self::Halfedges];

    /// The file name ending, without the dot.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Stl => "stl",
            Self::Off => "off",
            Self::Msh => "msh",
            Self::Halfedges => "halfedges",
        }
    }

    /// The format of a file of the given name; OBJ without an ending.
    ///
    /// # Errors
    /// [`FileReason::UnknownEnding`].
    pub fn of(path: &Path) -> Result<Self, FileReason> {
        let Some(end) = path.extension() else { return Ok(Self::Obj) };
        let known = Self::ALL.into_iter().find(|format| end.eq_ignore_ascii_case(format.ending()));
        known.ok_or_else(|| FileReason::UnknownEnding(end.to_string_lossy().into_owned()))
    }

    /// The format of a file without a name, from its first bytes and its length; OBJ if no other
    /// format matches.
    pub fn of_bytes(bytes: &[u8]) -> Self {
        let lines = without_mark(bytes).split(|&b| b == b'\n').map(<[u8]>::trim_ascii);
        let line = lines.into_iter().find(|line| !line.is_empty() && !line.starts_with(b"#"));
        let line = line.unwrap_or_default();
        let word = line.split(u8::is_ascii_whitespace).next().unwrap_or_default();
        match word {
            _ if stl::is_whole(bytes) => Self::Stl,
            _ if word.eq_ignore_ascii_case(b"ply") => Self::Ply,
            _ if word.eq_ignore_ascii_case(b"solid") => Self::Stl,
            _ if off::is_head(word) => Self::Off,
            [b'$', ..] => Self::Msh,
            b"mesh" => Self::Halfedges,
            _ if msh::is_of_mujoco(bytes) => Self::Msh,
            _ if stl::is_likely(bytes) => Self::Stl,
            _ => Self::Obj,
        }
    }

    /// All endings, listed for a sentence.
    pub(super) fn listed() -> String {
        let [others @ .., last] = &Self::ALL.map(|format| format!(".{}", format.ending()));
        format!("{} or {last}", others.join(", "))
    }
}

impl fmt::Display for FileFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, ".{}", self.ending())
    }
}

/// The encoding of the numbers of a PLY, STL or MSH file. MSH is always written as text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// As text.
    Ascii,
    /// As bytes, little-endian.
    #[default]
    LittleEndian,
    /// As bytes, big-endian: only PLY is written so.
    BigEndian,
}

/// The version of a Gmsh file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MshVersion {
    /// Version 2.2.
    V2,
    /// Version 4.1.
    #[default]
    V4,
}
