//! The formats of files, told by the ends of their names.

use std::fmt;
use std::path::Path;

use super::error::FileReason;

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileFormat {
    /// Wavefront OBJ.
    Obj,
    /// The polygon file format of Stanford.
    Ply,
    /// Stereolithography.
    Stl,
    /// The object file format of Geomview, with its prefixes.
    Off,
    /// Gmsh, version 2.2 and 4.1.
    Msh,
    /// Tables of halfedges.
    Halfedges,
}

impl FileFormat {
    pub const ALL: [Self; 6] =
        [Self::Obj, Self::Ply, Self::Stl, Self::Off, Self::Msh, Self::Halfedges];

    /// The endings of the names of such files, behind the dot.
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

    /// The format of a file of this name; without an ending, OBJ.
    ///
    /// # Errors
    /// [`FileReason::UnknownEnding`].
    pub fn of(path: &Path) -> Result<Self, FileReason> {
        let Some(end) = path.extension() else { return Ok(Self::Obj) };
        let mut all = Self::ALL.into_iter();
        let known = all.find(|format| end.eq_ignore_ascii_case(format.ending()));
        known.ok_or_else(|| FileReason::UnknownEnding(end.to_string_lossy().into_owned()))
    }

    /// All endings, as a sentence lists them.
    pub(super) fn listed() -> String {
        let endings = Self::ALL.map(|format| format!(".{}", format.ending()));
        let [others @ .., last] = &endings;
        format!("{} or {last}", others.join(", "))
    }
}

impl fmt::Display for FileFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, ".{}", self.ending())
    }
}

/// The encoding of the numbers of a file, where its format leaves a choice: PLY, STL, MSH.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// As text.
    Ascii,
    /// As bytes, the lowest first.
    #[default]
    LittleEndian,
    /// As bytes, the highest first: PLY alone.
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
