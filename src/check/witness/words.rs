//! The verdict on a broken mesh, with the names of the drawing in place of numbers.

use super::literal::Carried;
use super::place::Place;
use super::sketch::{HalfedgeRole, VertexRole};
use crate::diagnostic::counted;
use crate::diagram::{Drawing, NameId};
use crate::mesh::{Element, ElementKind, HalfedgeId, Invalid, Mesh};

/// Elements in words.
pub(super) struct Words<'a> {
    pub drawing: &'a Drawing<'a>,
    pub place: &'a Place,
    pub carried: &'a Carried,
}

impl Words<'_> {
    /// The verdict of the validator in words.
    pub fn verdict(&self, invalid: &Invalid) -> String {
        match *invalid {
            Invalid::Dangling { of, pointer, to } if to.index == u32::MAX => {
                format!("{} is not set", self.pointer(of, pointer))
            }
            Invalid::Dangling { of, pointer, to } => {
                let pointer = self.pointer(of, pointer);
                format!("{pointer} is {}, which is erased", self.element(to))
            }
            Invalid::NotInverse { halfedge, pointer, to, back } => {
                let inverse = if pointer == "next" { "prev" } else { "next" };
                format!(
                    "{} is {}, but {} is {}",
                    self.pointer(halfedge.into(), pointer),
                    self.element(to.into()),
                    self.pointer(to.into(), inverse),
                    self.element(back.into()),
                )
            }
            Invalid::TwinOfItself { halfedge } => {
                format!("{} is its own twin", self.element(halfedge.into()))
            }
            Invalid::TwinNotMutual { halfedge, twin, back } => format!(
                "{} is {}, but {} is {}",
                self.pointer(halfedge.into(), "twin"),
                self.element(twin.into()),
                self.pointer(twin.into(), "twin"),
                self.element(back.into()),
            ),
            Invalid::Disagree { halfedges: [a, b], says: [x, y] } => format!(
                "{} and {} come into one {}, but {} is {} and {} is {}",
                self.element(a.into()),
                self.element(b.into()),
                orbit_word(x.kind),
                self.pointer(a.into(), x.kind.name()),
                self.element(x),
                self.pointer(b.into(), y.kind.name()),
                self.element(y),
            ),
            Invalid::ForeignHalfedge { element, halfedge, says } => format!(
                "{} is {}, but {} is {}",
                self.pointer(element, "halfedge"),
                self.element(halfedge.into()),
                self.pointer(halfedge.into(), element.kind.name()),
                self.element(says),
            ),
            Invalid::SeveralOrbits { element, halfedges: [a, b] } if a.is_none() => format!(
                "{} is not set, but {} is {}",
                self.pointer(element, "halfedge"),
                self.pointer(b.into(), element.kind.name()),
                self.element(element),
            ),
            Invalid::SeveralOrbits { element, halfedges: [a, b] } => format!(
                "{} would be two {}s, one with {} and one with {}",
                self.element(element),
                orbit_word(element.kind),
                self.element(a.into()),
                self.element(b.into()),
            ),
            Invalid::NotFinite { .. } => invalid.to_string(),
        }
    }

    /// `` `b'.twin` ``
    fn pointer(&self, of: Element, pointer: &str) -> String {
        match self.name(of) {
            Some(name) => format!("`{}.{pointer}`", self.drawing.rule.name(name).text),
            None => format!("the `{pointer}` of {}", self.element(of)),
        }
    }

    /// The name that is bound to an element.
    fn name(&self, element: Element) -> Option<NameId> {
        let mut names = self.drawing.rule.names_of(element.kind.into());
        names.find(|name| self.carried.elements[name.index()] == Some(element.index))
    }

    /// An element by its name, or by what it lies at.
    pub fn element(&self, element: Element) -> String {
        if let Some(name) = self.name(element) {
            return self.drawing.rule.quoted(name);
        }
        let before = &self.place.mesh;
        let known = before.is_alive(element.kind, element.index);
        if !known {
            return if element.index == u32::MAX { "not set".into() } else { element.to_string() };
        }
        match element.kind {
            ElementKind::Halfedge => self.halfedge(HalfedgeId(element.index)),
            ElementKind::Vertex => match self.place.vertices[element.index as usize] {
                VertexRole::Named(name) => self.drawing.rule.quoted(name),
                VertexRole::Along(path) => {
                    format!("a vertex along {}", self.drawing.rule.quoted(path))
                }
                VertexRole::Loose => format!("the far {}", element),
            },
            ElementKind::Edge => {
                let half = before.edge_halfedge(crate::mesh::EdgeId(element.index));
                format!("the edge of {}", self.halfedge(half))
            }
            ElementKind::Face => {
                let half = before.face_halfedge(crate::mesh::FaceId(element.index));
                format!("the loop of {}", self.halfedge(half))
            }
        }
    }

    fn halfedge(&self, half: HalfedgeId) -> String {
        let rule = self.drawing.rule;
        match self.place.halfedges[half.index()] {
            HalfedgeRole::Named(name) => rule.quoted(name),
            HalfedgeRole::OnPath(path) => {
                let run = &self.place.runs[path.index()];
                let path = rule.quoted(path);
                let at = run.iter().position(|&other| other == half).unwrap_or(0);
                match at {
                    _ if run.len() == 1 => format!("the halfedge of {path}"),
                    0 => format!("the first halfedge of {path}"),
                    at if at + 1 == run.len() => format!("the last halfedge of {path}"),
                    at => format!("halfedge {} of {path}", at + 1),
                }
            }
            HalfedgeRole::TwinOf(other) => {
                format!("the undrawn twin of {}", self.halfedge(HalfedgeId(other as u32)))
            }
            HalfedgeRole::Further(vertex) => match self.place.vertices[vertex] {
                VertexRole::Named(name) => format!("a further spoke of {}", rule.quoted(name)),
                VertexRole::Along(_) | VertexRole::Loose => "a further spoke".into(),
            },
        }
    }
}

/// "4 vertices, 5 edges, 2 faces and a hole"
pub(super) fn size(mesh: &Mesh) -> String {
    let vertices = counted(mesh.vertex_count(), "vertex", "vertices");
    let edges = counted(mesh.edge_count(), "edge", "edges");
    let faces = counted(mesh.face_count(), "face", "faces");
    match mesh.hole_count() {
        0 => format!("{vertices}, {edges} and {faces}"),
        holes => {
            let holes = counted(holes, "hole", "holes");
            format!("{vertices}, {edges}, {faces} and {holes}")
        }
    }
}

fn orbit_word(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::Vertex => "ring",
        ElementKind::Edge => "pair",
        ElementKind::Face | ElementKind::Halfedge => "loop",
    }
}
