//! File formats, recognized by file name endings or by content.

use std::fmt;
use std::path::Path;

use super::error::FileReason;

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
        let count =
            bytes.get(80..84).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
        let begins = bytes.trim_ascii_start();
        let word = begins.split(u8::is_ascii_whitespace).next().unwrap_or_default();
        let is_line = |line: &[u8]| line.starts_with(b"mesh ");
        if count.is_some_and(|count| bytes.len() as u64 == 84 + 50 * u64::from(count)) {
            Self::Stl
        } else if word.eq_ignore_ascii_case(b"ply") {
            Self::Ply
        } else if word.eq_ignore_ascii_case(b"solid") {
            Self::Stl
        } else if word.ends_with(b"OFF") {
            Self::Off
        } else if word == b"$MeshFormat" {
            Self::Msh
        } else if begins
            .split(|&b| b == b'\n')
            .find(|line| !line.starts_with(b"#"))
            .is_some_and(is_line)
        {
            Self::Halfedges
        } else {
            Self::Obj
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
