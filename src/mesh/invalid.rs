//! A broken law as data and in words.

use std::fmt;

use glam::DVec3;

use super::id::{Element, ElementKind, HalfedgeId};

/// A broken law, with the elements that show it.
#[derive(Clone, Debug, PartialEq)]
pub enum Invalid {
    Dangling {
        of: Element,
        pointer: &'static str,
        to: Element,
    },
    /// `next` leads to where `prev` does not lead back, or the other way round.
    NotInverse {
        halfedge: HalfedgeId,
        pointer: &'static str,
        to: HalfedgeId,
        back: HalfedgeId,
    },
    TwinOfItself {
        halfedge: HalfedgeId,
    },
    TwinNotMutual {
        halfedge: HalfedgeId,
        twin: HalfedgeId,
        back: HalfedgeId,
    },
    /// Two halfedges, one after the other in an orbit, name different elements.
    Disagree {
        halfedges: [HalfedgeId; 2],
        says: [Element; 2],
    },
    /// An element whose halfedge names another element.
    ForeignHalfedge {
        element: Element,
        halfedge: HalfedgeId,
        says: Element,
    },
    /// An element that two orbits name; a halfedge of each, the element's own first.
    SeveralOrbits {
        element: Element,
        halfedges: [HalfedgeId; 2],
    },
    NotFinite {
        vertex: Element,
        position: DVec3,
    },
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dangling { of, pointer, to } if to.index == u32::MAX => {
                write!(f, "{of} has no `{pointer}`")
            }
            Self::Dangling { of, pointer, to } => {
                write!(f, "the `{pointer}` of {of} is {to}, which does not exist")
            }
            Self::NotInverse { halfedge, pointer: "prev", to, back } => {
                write!(f, "the `prev` of {halfedge} is {to}, but after {to} comes {back}")
            }
            Self::NotInverse { halfedge, to, back, .. } => {
                write!(f, "after {halfedge} comes {to}, but the `prev` of {to} is {back}")
            }
            Self::TwinOfItself { halfedge } => write!(f, "{halfedge} is its own twin"),
            Self::TwinNotMutual { halfedge, twin, back } => {
                write!(f, "the twin of {halfedge} is {twin}, but the twin of {twin} is {back}")
            }
            Self::Disagree { halfedges: [a, b], says: [x, y] } => {
                let orbit = orbit_name(x.kind);
                write!(f, "{a} and {b} lie in one {orbit}, but one says {x} and the other {y}")
            }
            Self::ForeignHalfedge { element, halfedge, says } => {
                write!(f, "the `halfedge` of {element} is {halfedge}, which says {says}")
            }
            Self::SeveralOrbits { element, halfedges: [a, b] } if a.is_none() => {
                write!(f, "{element} has no `halfedge`, but {b} says {element}")
            }
            Self::SeveralOrbits { element, halfedges: [a, b] } => {
                let orbit = orbit_name(element.kind);
                write!(f, "{element} would be two {orbit}s, one with {a} and one with {b}")
            }
            Self::NotFinite { vertex, position: DVec3 { x, y, z } } => {
                write!(f, "{vertex} lies at {x} {y} {z}, which is not finite")
            }
        }
    }
}

impl std::error::Error for Invalid {}

fn orbit_name(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::Vertex => "fan",
        ElementKind::Edge => "pair",
        ElementKind::Face | ElementKind::Halfedge => "loop",
    }
}
