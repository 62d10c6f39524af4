//! The lines of one mesh, and the mesh that they describe.

use glam::DVec3;

use super::DumpReason;
use super::read::{Ids, read_number};
use crate::mesh::attribute::{AttributeType, Value};
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, VertexId};
use crate::mesh::records::HalfedgeRecord;

/// The lines of one mesh: the elements of each kind by id.
#[derive(Default)]
pub(super) struct Table {
    vertices: Vec<Option<(HalfedgeId, DVec3)>>,
    halfedges: Vec<Option<HalfedgeRecord>>,
    edges: Vec<Option<HalfedgeId>>,
    faces: Vec<Option<(HalfedgeId, bool)>>,
    columns: Vec<Column>,
}

/// An `attribute` line and the values after it.
struct Column {
    kind: ElementKind,
    name: String,
    default: Value,
    values: Vec<(u32, Value)>,
}

impl Table {
    pub(super) fn read(&mut self, words: &[&str], ids: Ids) -> Result<(), DumpReason> {
        let halfedge = |text: &str| ids.read_pointer(text).map(HalfedgeId);
        match words {
            ["vertex", id, "halfedge", half, "at", x, y, z] => {
                let at = DVec3::new(read_number(x)?, read_number(y)?, read_number(z)?);
                let vertex = (halfedge(half)?, at);
                put(&mut self.vertices, ElementKind::Vertex, ids.read(id)?, vertex)
            }
            ["vertex", ..] => Err(DumpReason::NotOfForm("vertex ID halfedge ID at X Y Z")),
            #[rustfmt::skip]
            ["halfedge", id, "next", next, "prev", prev, "twin", twin, "vertex", vertex,
             "edge", edge, "face", face] => {
                let record = HalfedgeRecord {
                    next: halfedge(next)?,
                    prev: halfedge(prev)?,
                    twin: halfedge(twin)?,
                    vertex: VertexId(ids.read_pointer(vertex)?),
                    edge: EdgeId(ids.read_pointer(edge)?),
                    face: FaceId(ids.read_pointer(face)?),
                };
                put(&mut self.halfedges, ElementKind::Halfedge, ids.read(id)?, record)
            }
            ["halfedge", ..] => Err(DumpReason::NotOfForm(
                "halfedge ID next ID prev ID twin ID vertex ID edge ID face ID",
            )),
            ["edge", id, "halfedge", half] => {
                let half = halfedge(half)?;
                put(&mut self.edges, ElementKind::Edge, ids.read(id)?, half)
            }
            ["edge", ..] => Err(DumpReason::NotOfForm("edge ID halfedge ID")),
            [word @ ("face" | "hole"), id, "halfedge", half] => {
                let face = (halfedge(half)?, *word == "hole");
                put(&mut self.faces, ElementKind::Face, ids.read(id)?, face)
            }
            ["face" | "hole", ..] => Err(DumpReason::NotOfForm("face ID halfedge ID")),
            ["attribute", kind, name, ty, default @ ..] => {
                self.begin_column(kind, name, ty, default)
            }
            ["attribute", ..] => Err(DumpReason::NotOfForm("attribute KIND WORD TYPE DEFAULT")),
            ["value", id, value @ ..] => self.read_value_of(ids.read(id)?, value),
            ["value", ..] => Err(DumpReason::NotOfForm("value ID VALUE")),
            [word, ..] => Err(DumpReason::Unknown((*word).into())),
            [] => Ok(()),
        }
    }

    fn begin_column(
        &mut self,
        kind: &str,
        name: &str,
        ty: &str,
        default: &[&str],
    ) -> Result<(), DumpReason> {
        const FORM: &str = "attribute KIND WORD TYPE DEFAULT";
        let ty = AttributeType::ALL.iter().copied().find(|known| known.name() == ty);
        let (Some(kind), Some(ty)) = (ElementKind::named(kind), ty) else {
            return Err(DumpReason::NotOfForm(FORM));
        };
        if self.columns.iter().any(|column| column.kind == kind && column.name == name) {
            return Err(DumpReason::AttributeTwice(name.into()));
        }
        self.columns.push(Column {
            kind,
            name: name.into(),
            default: read_value(ty, default)?,
            values: Vec::new(),
        });
        Ok(())
    }

    fn read_value_of(&mut self, index: u32, words: &[&str]) -> Result<(), DumpReason> {
        let column = self.columns.last().ok_or(DumpReason::NoAttribute)?;
        let kind = column.kind;
        let at = index as usize;
        let lives = match kind {
            ElementKind::Vertex => self.vertices.get(at).is_some_and(Option::is_some),
            ElementKind::Halfedge => self.halfedges.get(at).is_some_and(Option::is_some),
            ElementKind::Edge => self.edges.get(at).is_some_and(Option::is_some),
            ElementKind::Face => self.faces.get(at).is_some_and(Option::is_some),
        };
        if !lives {
            return Err(DumpReason::ValueOf(Element { kind, index }));
        }
        let value = read_value(column.default.attribute_type(), words)?;
        self.columns.last_mut().ok_or(DumpReason::NoAttribute)?.values.push((index, value));
        Ok(())
    }

    pub(super) fn mesh(self) -> Mesh {
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
        for column in self.columns {
            let Ok(id) = mesh.add_column(column.kind, &column.name, column.default) else {
                continue; // a second one of a name was refused above
            };
            for (index, value) in column.values {
                let set = mesh.set_value(id, index, value);
                debug_assert!(set, "the value was read for a living element of the column");
            }
        }
        mesh.recycle();
        mesh
    }
}

/// Reads a value from its numbers.
fn read_value(ty: AttributeType, words: &[&str]) -> Result<Value, DumpReason> {
    let wrong = || DumpReason::NotAValue(ty);
    match (ty, words) {
        (AttributeType::Bool, [word]) => word.parse().map(Value::Bool).map_err(|_| wrong()),
        (AttributeType::Int, [word]) => word.parse().map(Value::Int).map_err(|_| wrong()),
        (AttributeType::Bool | AttributeType::Int, _) => Err(wrong()),
        (_, words) => {
            let reals = words.iter().map(|word| read_number(word));
            let reals = reals.collect::<Result<Vec<_>, _>>()?;
            Value::from_reals(ty, &reals).ok_or_else(wrong)
        }
    }
}

/// Stores an element, whose slot must be free.
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
