//! Places on a mesh as one writes them: `edge:3-7`, `halfedge:3-7`, `vertex:3`, `face:12`.

use crate::diagram::Type;
use crate::mesh::{EdgeId, FaceId, HalfedgeId, Obj, VertexId};

/// An element by the numbers of its file: from 1 in OBJ files, ids in tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// The edge between two vertices.
    Edge(u32, u32),
    /// The halfedge from one vertex to another.
    Halfedge(u32, u32),
    /// A vertex.
    Vertex(u32),
    /// A face.
    Face(u32),
}

/// Reads a place.
pub(super) fn read(text: &str) -> Result<Place, String> {
    let wrong = || {
        format!(
            "`{text}` is no place: write edge:A-B, halfedge:A-B, vertex:A or face:N with the numbers of the file"
        )
    };
    let (kind, numbers) = text.split_once(':').ok_or_else(wrong)?;
    let number = |text: &str| text.parse::<u32>().map_err(|_| wrong());
    let pair = || {
        let (from, to) = numbers.split_once('-').ok_or_else(wrong)?;
        Ok::<_, String>((number(from)?, number(to)?))
    };
    match kind {
        "edge" => pair().map(|(from, to)| Place::Edge(from, to)),
        "halfedge" => pair().map(|(from, to)| Place::Halfedge(from, to)),
        "vertex" => number(numbers).map(Place::Vertex),
        "face" => number(numbers).map(Place::Face),
        _ => Err(wrong()),
    }
}

impl Place {
    /// The type of the element.
    pub fn ty(self) -> Type {
        match self {
            Place::Edge(..) => Type::Edge,
            Place::Halfedge(..) => Type::Halfedge,
            Place::Vertex(_) => Type::Vertex,
            Place::Face(_) => Type::Face,
        }
    }

    /// `edge:A-B` where a halfedge is wanted is the one from A to B, and the other way around.
    pub fn as_wanted(self, wanted: Type) -> Self {
        match (self, wanted) {
            (Place::Edge(from, to), Type::Halfedge) => Place::Halfedge(from, to),
            (Place::Halfedge(from, to), Type::Edge) => Place::Edge(from, to),
            (place, _) => place,
        }
    }

    /// The id of the element on a mesh.
    ///
    /// At an edge `A-B` this also makes the halfedge from `A` to `B` the edge's `halfedge`.
    pub fn find(self, obj: &mut Obj) -> Result<u32, String> {
        match self {
            Place::Vertex(number) => Ok(vertex(obj, number)?.0),
            Place::Face(number) => match obj.face_by_number(number) {
                Some(FaceId(face)) => Ok(face),
                None => Err(format!("the mesh has no face {number}")),
            },
            Place::Halfedge(from, to) => Ok(halfedge(obj, from, to)?.0),
            Place::Edge(from, to) => {
                let half = halfedge(obj, from, to)?;
                let EdgeId(edge) = obj.mesh.edge(half);
                obj.mesh.set_edge_halfedge(EdgeId(edge), half);
                Ok(edge)
            }
        }
    }
}

fn vertex(obj: &Obj, number: u32) -> Result<VertexId, String> {
    obj.vertex_by_number(number)
        .ok_or_else(|| format!("the mesh has no vertex {number}"))
}

fn halfedge(obj: &Obj, from: u32, to: u32) -> Result<HalfedgeId, String> {
    let (start, end) = (vertex(obj, from)?, vertex(obj, to)?);
    let found = obj
        .mesh
        .spokes(start)
        .find(|&half| obj.mesh.target(half) == end);
    found.ok_or_else(|| format!("no edge joins the vertices {from} and {to}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_read() {
        assert_eq!(read("edge:3-7"), Ok(Place::Edge(3, 7)));
        assert_eq!(read("face:1"), Ok(Place::Face(1)));
        for text in [
            "",
            "edge",
            "edge:3",
            "vertex:-1",
            "corner:1",
            "face:99999999999",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
    }
}
