//! Halfedge tables as text, for small meshes that no OBJ file can hold: broken ones above all.
//!
//! A line holds one element with its pointers, `-` where one is missing. `mesh WORD` begins a
//! table, so that one file can show a mesh before and after something; `name WORD` says what a
//! name stands for, in all of them. `#` begins a remark.
//!
//! ```text
//! # flip: `a.twin` is not set
//! mesh before
//! vertex 0 halfedge 0 at 1 0 0
//! halfedge 0 next 1 prev 2 twin 3 vertex 0 edge 0 face 0
//! edge 0 halfedge 0
//! face 0 halfedge 0
//! hole 1 halfedge 3
//! name v0 vertex 0
//! name P halfedge 3 4
//! ```
//!
//! What has no line does not live, whoever points at it. Attribute columns are left out.

use std::fmt;

use glam::DVec3;

use super::connectivity::{HalfedgeRecord, Mesh};
use super::id::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, VertexId};

/// Ids in a file are smaller than this, so that a line cannot ask for gigabytes.
const MOST: u32 = 1 << 20;

/// Tables and names, as in a file.
#[derive(Clone, Debug, Default)]
pub struct Dump {
    /// What is said at the top.
    pub remarks: Vec<String>,
    /// Each table with its name.
    pub meshes: Vec<(String, Mesh)>,
    /// What each name stands for: elements of one kind.
    pub names: Vec<(String, Vec<Element>)>,
}

/// Why a file is no dump, and in which line, from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DumpError {
    pub line: usize,
    pub reason: DumpReason,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DumpReason {
    /// A line that begins with no word of the format.
    Unknown(String),
    /// A line that has another form than this.
    NotOfForm(&'static str),
    NotAnId(String),
    NotANumber(String),
    /// An element with two lines.
    Twice(Element),
    /// An element before the first `mesh`.
    NoMesh,
}

impl fmt::Display for DumpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: ", self.line)?;
        match &self.reason {
            DumpReason::Unknown(word) => write!(f, "`{word}` begins no line of a dump"),
            DumpReason::NotOfForm(form) => write!(f, "expected `{form}`"),
            DumpReason::NotAnId(text) => write!(f, "`{text}` is no id below {MOST}"),
            DumpReason::NotANumber(text) => write!(f, "`{text}` is no number"),
            DumpReason::Twice(element) => write!(f, "{element} has a line already"),
            DumpReason::NoMesh => write!(f, "no `mesh` line comes before it"),
        }
    }
}

impl std::error::Error for DumpError {}

/// The text of a dump.
pub fn write_dump(dump: &Dump) -> String {
    let mut lines: Vec<String> = Vec::new();
    let remarks = dump.remarks.iter().flat_map(|remark| remark.lines());
    lines.extend(remarks.map(|line| format!("# {line}")));
    for (name, mesh) in &dump.meshes {
        lines.push(format!("mesh {name}"));
        write_mesh(mesh, &mut lines);
    }
    for (name, elements) in &dump.names {
        let kind = elements
            .first()
            .map_or(ElementKind::Halfedge, |first| first.kind);
        let ids: String = elements.iter().map(|of| format!(" {}", of.index)).collect();
        lines.push(format!("name {name} {kind}{ids}"));
    }
    lines.push(String::new());
    lines.join("\n")
}

fn write_mesh(mesh: &Mesh, lines: &mut Vec<String>) {
    let id = |element: Element| match element.index {
        u32::MAX => "-".into(),
        index => index.to_string(),
    };
    for vertex in mesh.vertices() {
        let half = id(mesh.vertex_halfedge(vertex).into());
        let DVec3 { x, y, z } = mesh.position(vertex);
        lines.push(format!(
            "vertex {} halfedge {half} at {x} {y} {z}",
            vertex.0
        ));
    }
    for half in mesh.halfedges() {
        let record = mesh.halfedge(half);
        lines.push(format!(
            "halfedge {} next {} prev {} twin {} vertex {} edge {} face {}",
            half.0,
            id(record.next.into()),
            id(record.prev.into()),
            id(record.twin.into()),
            id(record.vertex.into()),
            id(record.edge.into()),
            id(record.face.into()),
        ));
    }
    for edge in mesh.edges() {
        let half = id(mesh.edge_halfedge(edge).into());
        lines.push(format!("edge {} halfedge {half}", edge.0));
    }
    for face in mesh.faces() {
        let half = id(mesh.face_halfedge(face).into());
        let word = if mesh.is_hole(face) { "hole" } else { "face" };
        lines.push(format!("{word} {} halfedge {half}", face.0));
    }
}

/// Reads the text of a dump.
pub fn read_dump(text: &str) -> Result<Dump, DumpError> {
    let mut dump = Dump::default();
    let mut table: Option<(String, Table)> = None;
    let finish = |table: Option<(String, Table)>, dump: &mut Dump| {
        dump.meshes
            .extend(table.map(|(name, table)| (name, table.mesh())));
    };
    for (at, line) in text.lines().enumerate() {
        let failed = |reason| DumpError {
            line: at + 1,
            reason,
        };
        if let Some(remark) = line.trim_start().strip_prefix('#') {
            dump.remarks.push(remark.trim().into());
            continue;
        }
        let words: Vec<_> = line.split_whitespace().collect();
        match words.as_slice() {
            [] => {}
            ["mesh", name] => {
                finish(table.take(), &mut dump);
                table = Some(((*name).into(), Table::default()));
            }
            ["mesh", ..] => return Err(failed(DumpReason::NotOfForm("mesh WORD"))),
            ["name", words @ ..] => dump.names.push(read_name(words).map_err(failed)?),
            words => {
                let (_, table) = table.as_mut().ok_or_else(|| failed(DumpReason::NoMesh))?;
                table.read(words).map_err(failed)?;
            }
        }
    }
    finish(table, &mut dump);
    Ok(dump)
}

fn read_name(words: &[&str]) -> Result<(String, Vec<Element>), DumpReason> {
    const FORM: &str = "name WORD KIND ID…";
    let [name, kind, ids @ ..] = words else {
        return Err(DumpReason::NotOfForm(FORM));
    };
    let mut kinds = ElementKind::ALL.into_iter();
    let kind = kinds.find(|known| known.name() == *kind);
    let kind = kind.ok_or(DumpReason::NotOfForm(FORM))?;
    let element = |id: &&str| {
        Ok(Element {
            kind,
            index: read_id(id)?,
        })
    };
    let elements = ids.iter().map(element).collect::<Result<_, _>>()?;
    Ok(((*name).into(), elements))
}

fn read_id(text: &str) -> Result<u32, DumpReason> {
    let id = text.parse().ok().filter(|&id: &u32| id < MOST);
    id.ok_or_else(|| DumpReason::NotAnId(text.into()))
}

/// An id, or `-` for none.
fn read_pointer(text: &str) -> Result<u32, DumpReason> {
    match text {
        "-" => Ok(u32::MAX),
        text => read_id(text),
    }
}

fn read_number(text: &str) -> Result<f64, DumpReason> {
    let number = text.parse();
    number.map_err(|_| DumpReason::NotANumber(text.into()))
}

/// The lines of one mesh: for each kind the elements by their ids.
#[derive(Default)]
struct Table {
    vertices: Vec<Option<(HalfedgeId, DVec3)>>,
    halfedges: Vec<Option<HalfedgeRecord>>,
    edges: Vec<Option<HalfedgeId>>,
    faces: Vec<Option<(HalfedgeId, bool)>>,
}

impl Table {
    fn read(&mut self, words: &[&str]) -> Result<(), DumpReason> {
        let halfedge = |text: &str| read_pointer(text).map(HalfedgeId);
        match words {
            ["vertex", id, "halfedge", half, "at", x, y, z] => {
                let at = DVec3::new(read_number(x)?, read_number(y)?, read_number(z)?);
                let vertex = (halfedge(half)?, at);
                put(
                    &mut self.vertices,
                    ElementKind::Vertex,
                    read_id(id)?,
                    vertex,
                )
            }
            ["vertex", ..] => Err(DumpReason::NotOfForm("vertex ID halfedge ID at X Y Z")),
            #[rustfmt::skip]
            ["halfedge", id, "next", next, "prev", prev, "twin", twin, "vertex", vertex,
             "edge", edge, "face", face] => {
                let record = HalfedgeRecord {
                    next: halfedge(next)?,
                    prev: halfedge(prev)?,
                    twin: halfedge(twin)?,
                    vertex: VertexId(read_pointer(vertex)?),
                    edge: EdgeId(read_pointer(edge)?),
                    face: FaceId(read_pointer(face)?),
                };
                put(&mut self.halfedges, ElementKind::Halfedge, read_id(id)?, record)
            }
            ["halfedge", ..] => Err(DumpReason::NotOfForm(
                "halfedge ID next ID prev ID twin ID vertex ID edge ID face ID",
            )),
            ["edge", id, "halfedge", half] => {
                let half = halfedge(half)?;
                put(&mut self.edges, ElementKind::Edge, read_id(id)?, half)
            }
            ["edge", ..] => Err(DumpReason::NotOfForm("edge ID halfedge ID")),
            [word @ ("face" | "hole"), id, "halfedge", half] => {
                let face = (halfedge(half)?, *word == "hole");
                put(&mut self.faces, ElementKind::Face, read_id(id)?, face)
            }
            ["face" | "hole", ..] => Err(DumpReason::NotOfForm("face ID halfedge ID")),
            words => Err(DumpReason::Unknown(words[0].into())),
        }
    }

    fn mesh(self) -> Mesh {
        let mut mesh = Mesh::default();
        for vertex in self.vertices {
            let id = mesh.add_vertex();
            match vertex {
                Some((half, at)) => {
                    mesh.set_vertex_halfedge(id, half);
                    mesh.set_position(id, at);
                }
                None => mesh.erase_vertex(id),
            }
        }
        for record in self.halfedges {
            let id = mesh.add_halfedge();
            match record {
                Some(record) => mesh.halfedges[id.index()] = record,
                None => mesh.erase_halfedge(id),
            }
        }
        for half in self.edges {
            let id = mesh.add_edge();
            match half {
                Some(half) => mesh.set_edge_halfedge(id, half),
                None => mesh.erase_edge(id),
            }
        }
        for face in self.faces {
            let id = mesh.add_face();
            match face {
                Some((half, hole)) => {
                    mesh.set_face_halfedge(id, half);
                    mesh.set_hole(id, hole);
                }
                None => mesh.erase_face(id),
            }
        }
        mesh.recycle();
        mesh
    }
}

/// Puts an element in its place, which is free.
fn put<T>(
    table: &mut Vec<Option<T>>,
    kind: ElementKind,
    index: u32,
    element: T,
) -> Result<(), DumpReason> {
    let at = index as usize;
    if table.len() <= at {
        table.resize_with(at + 1, || None);
    }
    match table[at].replace(element) {
        None => Ok(()),
        Some(_) => Err(DumpReason::Twice(Element { kind, index })),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{identical, shape, validate};

    #[test]
    fn a_broken_mesh_makes_the_round_trip() {
        let before = shape::cube();
        let mut after = before.clone();
        after.erase_halfedge(HalfedgeId(4));
        after.set_twin(HalfedgeId(0), HalfedgeId::NONE);
        let dump = Dump {
            remarks: vec!["a cube".into()],
            meshes: vec![("before".into(), before), ("after".into(), after)],
            names: vec![
                ("v".into(), vec![VertexId(3).into()]),
                ("P".into(), vec![HalfedgeId(1).into(), HalfedgeId(2).into()]),
                ("Q".into(), Vec::new()),
            ],
        };
        let text = write_dump(&dump);
        let read = read_dump(&text).unwrap();
        assert_eq!(write_dump(&read), text);
        assert_eq!(read.names, dump.names);
        for ((name, mesh), (other, original)) in read.meshes.iter().zip(&dump.meshes) {
            assert_eq!(name, other);
            assert!(identical(mesh, original));
            assert_eq!(validate(mesh), validate(original));
        }
    }

    #[test]
    fn malformed_lines_are_refused_in_words() {
        let cases = [
            (
                "vertex 0 halfedge 0 at 0 0 0",
                "line 1: no `mesh` line comes before it",
            ),
            (
                "mesh m\nvertx 0",
                "line 2: `vertx` begins no line of a dump",
            ),
            ("mesh m\n\nedge 0", "line 3: expected `edge ID halfedge ID`"),
            (
                "mesh m\nedge -1 halfedge 0",
                "line 2: `-1` is no id below 1048576",
            ),
            (
                "mesh m\nedge 4294967295 halfedge 0",
                "line 2: `4294967295` is no id below 1048576",
            ),
            (
                "mesh m\nvertex 0 halfedge - at 0 y 0",
                "line 2: `y` is no number",
            ),
            (
                "mesh m\nface 0 halfedge 0\nhole 0 halfedge 0",
                "line 3: face 0 has a line already",
            ),
            ("name v", "line 1: expected `name WORD KIND ID…`"),
        ];
        for (text, told) in cases {
            assert_eq!(read_dump(text).unwrap_err().to_string(), told);
        }
    }
}
