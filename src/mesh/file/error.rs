//! Reasons why a file cannot be read or written, with the line concerned.

use std::fmt;
use std::io;

use super::format::FileFormat;
use super::scan::POINT;
use crate::mesh::build_error::BuildError;
use crate::mesh::faults::Faults;
use crate::mesh::id::ElementKind;

/// A failure to read or write a file. Lines are those of the file, from 1; vertices and faces are
/// counted from 1.
#[derive(Debug)]
pub struct FileError {
    pub file: String,
    pub line: Option<u32>,
    pub reason: FileReason,
}

/// The reason why a file cannot be read or written.
#[derive(Debug)]
pub enum FileReason {
    Io(io::Error),
    /// The folder to write to does not exist.
    NoFolder(String),
    /// The folder to write to takes no new file.
    ClosedFolder {
        folder: String,
        error: io::Error,
    },
    /// The file to write is protected.
    ReadOnly,
    /// The ending of the name is that of no format.
    UnknownEnding(String),
    /// The file is compressed.
    Compressed,
    /// Vertices of halfedge tables were to be merged.
    MergedTables,
    /// The file violates its format, in words.
    Malformed(String),
    /// There is no vertex in the file, which so is probably of no format of meshes.
    NoVertex(FileFormat),
    /// The file is truncated, or parts of it cannot be read, in words. A repair skips them.
    Damaged(String),
    /// The polygons of the file are not a mesh. A repair helps.
    Faults(FileFaults),
    /// More elements than can be numbered.
    TooLarge {
        kind: ElementKind,
    },
    /// A vertex that cannot be written.
    NotFinite {
        vertex: u32,
    },
    /// The mesh cannot be written as a list of polygons, for this reason, in words.
    NotPolygons(String),
    /// The format cannot hold the mesh, for this reason, in words.
    Unheld(String),
}

/// Endings of the names of compressed files.
const PACKED: [&str; 5] = ["gz", "bz2", "xz", "zst", "zip"];

/// A line, and what is wrong.
pub(super) type Failure = (Option<u32>, FileReason);

/// The kind of row that an index of a corner refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Indexed {
    Vertex,
    Texture,
    Normal,
}

impl Indexed {
    /// The message that no row has this index.
    pub(super) fn missing(self, index: i64, have: usize) -> String {
        let [one, many] = match self {
            Self::Vertex => ["vertex", "vertices"],
            Self::Texture => ["texture coordinate", "texture coordinates"],
            Self::Normal => ["normal", "normals"],
        };
        let things = if have == 1 { one } else { many };
        format!("there is no {one} {index}: the file has {have} {things}")
    }
}

/// Everything that keeps the polygons of a file from being a mesh, by kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FileFaults {
    pub kinds: Vec<FileFaultKind>,
    /// From which number the faces count vertices, in words, if that alone seems to be wrong. A
    /// repair would make another mesh of them.
    pub wrong_start: Option<&'static str>,
}

/// The faults of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct FileFaultKind {
    /// The kind, in words, singular or plural as `count` is.
    pub kind: &'static str,
    pub count: usize,
    /// The first faults: their lines, if the file has lines, and what is wrong.
    pub first: Vec<(Option<u32>, String)>,
}

/// Indices of a file that refer to no element.
#[derive(Clone, Debug, Default)]
pub(super) struct BadIndices {
    count: usize,
    /// How many are 0 where the first is 1.
    zeros: usize,
    /// How many are the number of vertices where the first is 0.
    ends: usize,
    first: Vec<(Option<u32>, String)>,
}

impl BadIndices {
    /// Adds an index, described by `words` if it is one of the first.
    pub(super) fn add(&mut self, line: Option<u32>, words: impl FnOnce() -> String) {
        self.count += 1;
        if self.first.len() < 3 {
            let told = (line, words());
            if !self.first.contains(&told) {
                self.first.push(told);
            }
        }
    }

    /// Adds a 0 of a file that counts from 1.
    pub(super) fn add_zero(&mut self, line: u32) {
        self.zeros += 1;
        self.add(Some(line), || "0 is not an index: they count from 1, or back from -1".to_owned());
    }

    /// Adds an index of no vertex in a file that counts from 0.
    pub(super) fn add_vertex(&mut self, line: Option<u32>, index: f64, vertices: usize) {
        self.ends += usize::from(index == vertices as f64);
        self.add(line, || {
            format!("there is no vertex {index}: there are {vertices}, counted from 0")
        });
    }

    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// The number of the first element in the format, if all would refer to elements if the file
    /// counted as other formats do.
    pub(super) fn shifted_from(&self) -> Option<u32> {
        match self.count {
            0 => None,
            count if count == self.zeros => Some(1),
            count if count == self.ends => Some(0),
            _ => None,
        }
    }

    /// Adds the bad indices of the next part of a file, which starts after `lines` lines.
    pub(super) fn append(&mut self, part: Self, lines: u32) {
        for (line, words) in part.first {
            self.add(line.map(|line| line + lines), || words);
            self.count -= 1;
        }
        self.count += part.count;
        self.zeros += part.zeros;
        self.ends += part.ends;
    }
}

/// Places of a file that cannot be read, and can be skipped.
#[derive(Clone, Debug, Default)]
pub(super) struct Damage {
    pub(super) count: usize,
    /// The first such place: its line, if the file has lines, and what is wrong.
    pub(super) first: Option<(Option<u32>, String)>,
}

impl Damage {
    /// Adds a damaged place, described by `words` if it is the first.
    pub(super) fn add(&mut self, line: Option<u32>, words: impl FnOnce() -> String) {
        self.count += 1;
        self.first.get_or_insert_with(|| (line, words()));
    }

    /// Adds the damage of the next part of a file, which starts after `lines` lines.
    pub(super) fn append(&mut self, part: Self, lines: u32) {
        self.count += part.count;
        if let (None, Some((line, words))) = (&self.first, part.first) {
            self.first = Some((line.map(|line| line + lines), words));
        }
    }
}

impl FileFaults {
    /// The faults of the polygons of a file. The lines are empty if the file has none.
    pub(super) fn new(faults: &Faults, bad_indices: BadIndices, lines: [&[u32]; 2]) -> Self {
        let mut all = Self::default();
        if bad_indices.count > 0 {
            let kind = BAD_INDICES[usize::from(bad_indices.count != 1)];
            all.kinds.push(FileFaultKind {
                kind,
                count: bad_indices.count,
                first: bad_indices.first,
            });
        }
        let told = faults.kinds.iter().filter(|kind| {
            bad_indices.count == 0 || !matches!(kind.first[0], BuildError::NoSuchVertex { .. })
        });
        all.kinds.extend(told.map(|kind| FileFaultKind {
            kind: names(&kind.first[0])[usize::from(kind.count != 1)],
            count: kind.count,
            first: kind.first.iter().map(|fault| describe(fault, lines)).collect(),
        }));
        all
    }

    /// The number of faults.
    pub fn count(&self) -> usize {
        self.kinds.iter().map(|kind| kind.count).sum()
    }

    /// The line of the fault, if there is only one.
    pub(super) fn line(&self) -> Option<u32> {
        match &self.kinds[..] {
            [FileFaultKind { count: 1, first, .. }] => first.first()?.0,
            _ => None,
        }
    }
}

impl fmt::Display for FileFaults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let [FileFaultKind { count: 1, first, .. }] = &self.kinds[..]
            && let Some((_, words)) = first.first()
        {
            write!(f, "{words}")?;
            return match self.wrong_start {
                Some(start) => write!(f, "; the faces seem to count vertices {start}"),
                None => Ok(()),
            };
        }
        write!(f, "{} faults keep its faces from being a mesh", self.count())?;
        for FileFaultKind { kind, count, first } in &self.kinds {
            write!(f, "\n  {count} {kind}")?;
            for (at, (line, words)) in first.iter().enumerate() {
                f.write_str(if at == 0 { ":" } else { ";" })?;
                if let Some(line) = line {
                    write!(f, " line {line},")?;
                }
                write!(f, " {words}")?;
            }
            if first.len() < *count {
                write!(f, "; …")?;
            }
        }
        if let Some(start) = self.wrong_start {
            write!(f, "\n  its faces seem to count vertices {start}")?;
        }
        Ok(())
    }
}

const PINCHED: [&str; 2] = ["pinched vertex", "pinched vertices"];
pub(super) const BAD_INDICES: [&str; 2] = ["index out of range", "indices out of range"];

/// The kind of a fault in words, singular and plural.
fn names(fault: &BuildError) -> [&'static str; 2] {
    match fault {
        BuildError::TooLarge { .. } => ["too large"; 2],
        BuildError::NotFinite { .. } => {
            ["vertex without coordinates", "vertices without coordinates"]
        }
        BuildError::TooFewCorners { .. } => {
            ["face with fewer than three corners", "faces with fewer than three corners"]
        }
        BuildError::NoSuchVertex { .. } => BAD_INDICES,
        BuildError::RepeatedCorner { .. } => {
            ["face with a vertex twice", "faces with a vertex twice"]
        }
        BuildError::EdgeUsedThrice { .. } => {
            ["edge of three faces or more", "edges of three faces or more"]
        }
        BuildError::SameDirection { .. } => {
            ["edge whose faces do not run alike", "edges whose faces do not run alike"]
        }
        BuildError::Doubled { .. } => ["face that is there twice", "faces that are there twice"],
        BuildError::BowTie { .. } => PINCHED,
    }
}

/// Describes a fault in the numbering of the file, with the line to show: the last of those
/// concerned.
fn describe(fault: &BuildError, [vertex_lines, face_lines]: [&[u32]; 2]) -> (Option<u32>, String) {
    let line = |polygon: usize| face_lines.get(polygon).copied();
    // In a file without lines, faces are named by number.
    let [the_face, the_faces] = match face_lines {
        [] => ["face", "faces"],
        _ => ["the face of line", "the faces of lines"],
    };
    let faces = |polygons: &[usize]| {
        let name = |&polygon: &usize| line(polygon).unwrap_or(polygon as u32 + 1);
        let mut names: Vec<_> = polygons.iter().map(name).collect();
        names.sort_unstable();
        let last = names.last().copied().filter(|_| !face_lines.is_empty());
        (last, names)
    };
    let face = |polygon: usize| match line(polygon) {
        Some(_) => "the face".to_owned(),
        None => format!("{the_face} {}", polygon + 1),
    };
    match *fault {
        BuildError::TooLarge { .. } => (None, fault.to_string()),
        BuildError::NotFinite { vertex, .. } => {
            let line = vertex_lines.get(vertex as usize).copied();
            (line, FileReason::NotFinite { vertex: vertex + 1 }.to_string())
        }
        BuildError::TooFewCorners { polygon, corners } => {
            let s = if corners == 1 { "" } else { "s" };
            let this = if face_lines.is_empty() { face(polygon) } else { "this".to_owned() };
            let words =
                format!("a face needs 3 corners or more, and {this} has {corners} corner{s}");
            (line(polygon), words)
        }
        BuildError::NoSuchVertex { polygon, vertex, vertices } => {
            (line(polygon), Indexed::Vertex.missing(i64::from(vertex) + 1, vertices))
        }
        BuildError::RepeatedCorner { polygon, vertex } => {
            let words = format!("{} has vertex {} as a corner twice", face(polygon), vertex + 1);
            (line(polygon), words)
        }
        BuildError::EdgeUsedThrice { ends: [v, w], polygons } => {
            let (line, names) = faces(&polygons);
            let words = format!(
                "{the_faces} {}, {} and {} share the edge between vertices {} and {}, and an edge \
                 has two sides",
                names[0],
                names[1],
                names[2],
                v + 1,
                w + 1
            );
            (line, words)
        }
        BuildError::Doubled { polygons } => {
            let (line, names) = faces(&polygons);
            let words = format!("{the_faces} {} and {} are the same", names[0], names[1]);
            (line, words)
        }
        BuildError::SameDirection { from, to, polygons } => {
            let (line, names) = faces(&polygons);
            let words = format!(
                "{the_faces} {} and {} both run from vertex {} to vertex {}, so one of them is \
                 turned over",
                names[0],
                names[1],
                from + 1,
                to + 1
            );
            (line, words)
        }
        BuildError::BowTie { vertex, polygons } => {
            let (line, names) = faces(&polygons);
            let words = format!(
                "{the_faces} {} and {} meet at vertex {} only, so the surface is pinched there",
                names[0],
                names[1],
                vertex + 1
            );
            (line, words)
        }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}: {}", self.file, self.reason),
            None => write!(f, "{}: {}", self.file, self.reason),
        }
    }
}

impl fmt::Display for FileReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => write!(f, "{error}"),
            Self::ReadOnly => f.write_str("the file is read-only"),
            Self::NoFolder(folder) => write!(f, "the folder `{folder}` does not exist"),
            Self::ClosedFolder { folder, error } => write!(
                f,
                "no new file, which would replace this one when it is complete, can be made in the \
                 folder `{folder}`: {}",
                error.kind() // the error itself names the new file
            ),
            Self::Compressed => f.write_str("it is compressed: unpack it first"),
            Self::UnknownEnding(end) if PACKED.contains(&end.to_ascii_lowercase().as_str()) => {
                write!(f, "no compressed mesh (`.{end}`) is read or written: unpack it first")
            }
            Self::UnknownEnding(end) => write!(
                f,
                "no mesh is read from or written to `.{end}`: name it {}",
                FileFormat::listed()
            ),
            Self::MergedTables => f.write_str(
                "the vertices of halfedge tables are not merged: convert it to .obj or .ply first",
            ),
            Self::Malformed(words) | Self::Damaged(words) | Self::Unheld(words) => {
                f.write_str(words)
            }
            Self::NoVertex(FileFormat::Obj) => {
                f.write_str("there is no vertex in it: is it an OBJ file?")
            }
            Self::NoVertex(_) => f.write_str("there is no vertex in it"),
            Self::NotPolygons(why) => write!(f, "no list of polygons holds this mesh{why}"),
            Self::Faults(faults) => write!(f, "{faults}"),
            Self::TooLarge { kind } => {
                write!(f, "there are more {} than can be numbered", kind.plural())
            }
            Self::NotFinite { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not a finite number")
            }
        }
    }
}

impl FileError {
    /// True if a repair would fix it.
    pub fn is_mendable(&self) -> bool {
        match &self.reason {
            FileReason::Faults(faults) => faults.wrong_start.is_none(),
            FileReason::Damaged(words) => !words.ends_with(POINT),
            _ => false,
        }
    }
}

impl FileReason {
    /// True if vertices are pinched, as happens where equal positions differ slightly.
    #[cfg(feature = "cli")]
    pub(crate) fn is_pinched(&self) -> bool {
        match self {
            Self::Faults(faults) => faults.kinds.iter().any(|kind| PINCHED.contains(&kind.kind)),
            _ => false,
        }
    }
}

impl std::error::Error for FileError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.reason {
            FileReason::Io(error) | FileReason::ClosedFolder { error, .. } => Some(error),
            _ => None,
        }
    }
}
