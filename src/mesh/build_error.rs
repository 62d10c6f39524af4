//! Reasons why a list of polygons is not a mesh, in terms of the list.

use std::fmt;

use glam::DVec3;

use super::id::ElementKind;

/// The reason why a list of polygons is not a mesh. Polygons and vertices are given by their
/// indices in the lists, from 0.
#[derive(Clone, Debug, PartialEq)]
pub enum BuildError {
    TooLarge {
        kind: ElementKind,
    },
    NotFinite {
        vertex: u32,
        position: DVec3,
    },
    TooFewCorners {
        polygon: usize,
        corners: usize,
    },
    NoSuchVertex {
        polygon: usize,
        vertex: u32,
        vertices: usize,
    },
    RepeatedCorner {
        polygon: usize,
        vertex: u32,
    },
    /// Three or more polygons share an edge; the first three.
    EdgeUsedThrice {
        ends: [u32; 2],
        polygons: [usize; 3],
    },
    /// Two polygons have the same corners in the same order. Only [`Faults`](super::Faults)
    /// distinguishes it from [`Self::SameDirection`].
    Doubled {
        polygons: [usize; 2],
    },
    /// Two polygons run along an edge in the same direction: their orientations disagree.
    SameDirection {
        from: u32,
        to: u32,
        polygons: [usize; 2],
    },
    /// The faces around a vertex form more than one fan; a polygon from each of two.
    BowTie {
        vertex: u32,
        polygons: [usize; 2],
    },
}

impl BuildError {
    /// The fault of a single polygon. `sorted` is scratch space.
    #[inline]
    pub(super) fn of_polygon(
        polygon: usize,
        corners: &[u32],
        vertices: usize,
        sorted: &mut Vec<u32>,
    ) -> Option<Self> {
        if let &[a, b, c] = corners
            && a != b
            && b != c
            && c != a
            && (a.max(b).max(c) as usize) < vertices
        {
            return None; // as most are
        }
        if corners.len() < 3 {
            return Some(Self::TooFewCorners { polygon, corners: corners.len() });
        }
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Some(Self::NoSuchVertex { polygon, vertex, vertices });
        }
        let vertex = repeated(corners, sorted)?;
        Some(Self::RepeatedCorner { polygon, vertex })
    }

    /// The fault of the sides between two vertices.
    #[inline]
    pub(super) fn of_edge(
        sides: &[(u32, u32)],
        ends: impl Fn(u32) -> [u32; 2],
        polygon: impl Fn(u32) -> usize,
    ) -> Option<Self> {
        match *sides {
            [] | [_] => None,
            [(_, a), (_, b)] => {
                let [from, to] = ends(a);
                let fault = || Self::SameDirection { from, to, polygons: [a, b].map(polygon) };
                (ends(b)[0] == from).then(fault)
            }
            [(_, a), (_, b), (_, c), ..] => {
                Some(Self::EdgeUsedThrice { ends: ends(a), polygons: [a, b, c].map(polygon) })
            }
        }
    }
}

/// A number that occurs twice among corners. `sorted` is scratch space.
pub(super) fn repeated(corners: &[u32], sorted: &mut Vec<u32>) -> Option<u32> {
    if corners.len() <= 8 {
        let earlier = |(i, v): (usize, &u32)| corners[..i].contains(v).then_some(*v);
        return corners.iter().enumerate().find_map(earlier);
    }
    sorted.clear();
    sorted.extend_from_slice(corners);
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { kind } => {
                write!(f, "there are more {} than can be numbered", kind.plural())
            }
            Self::NotFinite { vertex, position } => {
                let DVec3 { x, y, z } = position;
                write!(f, "vertex {vertex} lies at {x} {y} {z}, which is not finite")
            }
            Self::TooFewCorners { polygon, corners } => {
                let s = if *corners == 1 { "" } else { "s" };
                write!(f, "polygon {polygon} has {corners} corner{s}; a face needs 3 or more")
            }
            Self::NoSuchVertex { polygon, vertex, vertices } => {
                write!(
                    f,
                    "polygon {polygon} names vertex {vertex}, but there are {vertices} vertices"
                )
            }
            Self::RepeatedCorner { polygon, vertex } => {
                write!(f, "polygon {polygon} has vertex {vertex} as a corner twice")
            }
            Self::EdgeUsedThrice { ends: [v, w], polygons: [a, b, c] } => write!(
                f,
                "polygons {a}, {b} and {c} share the edge between vertices {v} and {w}; an edge has two sides"
            ),
            Self::Doubled { polygons: [a, b] } => {
                write!(f, "polygons {a} and {b} have the same corners in the same order")
            }
            Self::SameDirection { from, to, polygons: [a, b] } => write!(
                f,
                "polygons {a} and {b} both run from vertex {from} to vertex {to}; one of them is turned over"
            ),
            Self::BowTie { vertex, polygons: [a, b] } => write!(
                f,
                "polygons {a} and {b} meet at vertex {vertex} without an edge to join their fans"
            ),
        }
    }
}

impl std::error::Error for BuildError {}
