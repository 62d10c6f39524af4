//! The pointers of a counterexample that contradict each other.

use serde_json::{Value, json};

use super::element::shown;
use super::frame::Frame;
use crate::mesh::{Element, ElementKind, Invalid, Mesh};

/// The reason why a mesh is invalid, as pointers `{ from, pointer, to }` between elements of the
/// mesh before: only those have known positions.
pub(super) fn broken(invalid: &Invalid, before: &Mesh, frame: &Frame) -> Vec<Value> {
    let shown = |element| shown(before, frame, element);
    let is_there = |of: &Element| before.is_alive(of.kind, of.index);
    pointers(invalid)
        .into_iter()
        .filter(|(from, _, to)| is_there(from) && is_there(to))
        .map(|(from, pointer, to)| {
            json!({ "from": shown(from), "pointer": pointer, "to": shown(to) })
        })
        .collect()
}

fn pointers(invalid: &Invalid) -> Vec<(Element, &'static str, Element)> {
    let to = |kind: ElementKind| kind.name();
    match *invalid {
        Invalid::Dangling { of, pointer, to } => vec![(of, pointer, to)],
        Invalid::NotInverse { halfedge, pointer, to, back } => {
            let inverse = if pointer == "next" { "prev" } else { "next" };
            vec![(halfedge.into(), pointer, to.into()), (to.into(), inverse, back.into())]
        }
        Invalid::TwinOfItself { halfedge } => {
            vec![(halfedge.into(), "twin", halfedge.into())]
        }
        Invalid::TwinNotMutual { halfedge, twin, back } => {
            vec![(halfedge.into(), "twin", twin.into()), (twin.into(), "twin", back.into())]
        }
        Invalid::Disagree { halfedges: [a, b], says: [x, y] } => {
            vec![(a.into(), to(x.kind), x), (b.into(), to(y.kind), y)]
        }
        Invalid::ForeignHalfedge { element, halfedge, says } => {
            vec![(element, "halfedge", halfedge.into()), (halfedge.into(), to(says.kind), says)]
        }
        Invalid::SeveralOrbits { element, halfedges: [a, b] } => {
            vec![(a.into(), to(element.kind), element), (b.into(), to(element.kind), element)]
        }
        Invalid::NotFinite { .. } => Vec::new(),
    }
}
