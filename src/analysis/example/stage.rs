//! The small meshes that ops are shown on, the simplest first.

use crate::mesh::{Mesh, shape};

/// A mesh and its name.
pub(super) struct Stage {
    pub(super) name: &'static str,
    pub(super) mesh: Mesh,
}

fn stages<const N: usize>(all: [(&'static str, Mesh); N]) -> impl Iterator<Item = Stage> {
    all.into_iter().map(|(name, mesh)| Stage { name, mesh })
}

/// Meshes without a boundary.
pub(super) fn closed() -> impl Iterator<Item = Stage> {
    stages([
        ("a cube", shape::cube()),
        ("an octahedron", shape::octahedron()),
        ("an icosahedron", shape::icosahedron()),
        ("a torus", shape::torus(4, 4)),
        ("a torus of triangles", shape::triangle_torus(4, 4)),
        ("a tetrahedron", shape::tetrahedron()),
        ("two squares, back to back", shape::pillow(4)),
    ])
}

/// Meshes with a boundary, in groups: of squares, of triangles, others.
pub(super) fn open() -> impl Iterator<Item = Vec<Stage>> {
    let squares = stages([
        ("a grid", shape::grid(3, 2)),
        ("a grid", shape::grid(2, 2)),
        ("a grid", shape::grid(3, 1)),
        ("a grid", shape::grid(2, 1)),
        ("a single square", shape::single_polygon(4)),
        ("a larger grid", shape::grid(4, 4)),
    ]);
    let triangles = stages([
        ("a grid of triangles", shape::triangle_grid(2, 1)),
        ("a grid of triangles", shape::triangle_grid(2, 2)),
        ("a disk of triangles", shape::fan(5)),
        ("a single triangle", shape::single_polygon(3)),
        ("a larger grid of triangles", shape::triangle_grid(4, 4)),
    ]);
    let others = stages([("an open cylinder", shape::tube(4, 1))]);
    [squares.collect(), triangles.collect(), others.collect()].into_iter()
}
