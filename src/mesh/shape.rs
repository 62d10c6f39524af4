//! Named small meshes.
//!
//! Faces run counterclockwise seen from outside, or from above for flat shapes. A count
//! too small to make the shape is raised to the smallest that does.

use std::collections::HashMap;
use std::f64::consts::TAU;

use glam::DVec3;

use super::connectivity::Mesh;
use super::polygons::Polygons;

fn build<P: AsRef<[u32]>>(positions: Vec<DVec3>, polygons: impl IntoIterator<Item = P>) -> Mesh {
    let polygons: Polygons = polygons.into_iter().collect();
    Mesh::from_owned_polygons(positions, &polygons).expect("a named shape is a mesh")
}

fn points<const N: usize>(points: [[f64; 3]; N]) -> Vec<DVec3> {
    points.map(DVec3::from_array).to_vec()
}

/// `n` points around the unit circle at height `z`.
fn circle(n: u32, z: f64) -> impl Iterator<Item = DVec3> {
    (0..n).map(move |i| {
        let angle = TAU * f64::from(i) / f64::from(n);
        DVec3::new(angle.cos(), angle.sin(), z)
    })
}

pub fn tetrahedron() -> Mesh {
    build(
        points([[1., 1., 1.], [-1., -1., 1.], [-1., 1., -1.], [1., -1., -1.]]),
        [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
    )
}

/// Six quads.
pub fn cube() -> Mesh {
    let corner = |i: u32, bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
    build(
        (0..8).map(|i| DVec3::new(corner(i, 0), corner(i, 1), corner(i, 2))).collect(),
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]],
    )
}

pub fn octahedron() -> Mesh {
    let mut positions: Vec<DVec3> = circle(4, 0.0).collect();
    positions.extend([DVec3::Z, DVec3::NEG_Z]);
    let around = (0..4).flat_map(|i| [[i, (i + 1) % 4, 4], [(i + 1) % 4, i, 5]]);
    build(positions, around)
}

pub fn icosahedron() -> Mesh {
    let (positions, triangles) = icosahedron_triangles();
    build(positions, triangles)
}

fn icosahedron_triangles() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    // Two rings of five between two poles.
    let height = 1.0 / 5f64.sqrt();
    let radius = 2.0 * height;
    let mut positions = vec![DVec3::Z];
    for (turn, z) in [(0.0, height), (0.5, -height)] {
        positions.extend((0..5).map(|i| {
            let angle = TAU * (f64::from(i) + turn) / 5.0;
            DVec3::new(radius * angle.cos(), radius * angle.sin(), z)
        }));
    }
    positions.push(DVec3::NEG_Z);
    let triangles = (0..5).flat_map(|i| {
        let j = (i + 1) % 5;
        let (a, b, c, d) = (1 + i, 1 + j, 6 + i, 6 + j);
        [[0, a, b], [a, c, b], [b, c, d], [11, d, c]]
    });
    (positions, triangles.collect())
}

/// An icosahedron with every triangle split in four, `k` times over, on the unit sphere.
pub fn icosphere(k: u32) -> Mesh {
    let (mut positions, mut triangles) = icosahedron_triangles();
    for _ in 0..k {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let sum = positions[a as usize] + positions[b as usize];
                positions.push(sum.normalize_or_zero());
                positions.len() as u32 - 1
            })
        };
        let split = triangles.iter().flat_map(|&[a, b, c]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        });
        triangles = split.collect();
    }
    build(positions, triangles)
}

/// `n` by `m` unit squares in the plane.
pub fn grid(n: u32, m: u32) -> Mesh {
    let (n, m) = (n.max(1), m.max(1));
    build(lattice(n + 1, m + 1), squares(n, m, n + 1, m + 1))
}

/// A grid with each square cut in two: a disk of `2nm` triangles.
pub fn triangle_grid(n: u32, m: u32) -> Mesh {
    let (n, m) = (n.max(1), m.max(1));
    build(lattice(n + 1, m + 1), squares(n, m, n + 1, m + 1).flat_map(halves))
}

/// `n` by `m` quads around a torus; 3 by 3 at least.
pub fn torus(n: u32, m: u32) -> Mesh {
    let (n, m) = (n.max(3), m.max(3));
    build(torus_points(n, m), squares(n, m, n, m))
}

/// A torus with each quad cut in two.
pub fn triangle_torus(n: u32, m: u32) -> Mesh {
    let (n, m) = (n.max(3), m.max(3));
    build(torus_points(n, m), squares(n, m, n, m).flat_map(halves))
}

/// An open cylinder: `n` quads around, `m` along.
pub fn tube(n: u32, m: u32) -> Mesh {
    let (n, m) = (n.max(3), m.max(1));
    build((0..=m).flat_map(|j| circle(n, f64::from(j))).collect(), squares(n, m, n, m + 1))
}

/// `n` triangles around vertex 0.
pub fn fan(n: u32) -> Mesh {
    let n = n.max(3);
    let positions = std::iter::once(DVec3::ZERO).chain(circle(n, 0.0));
    build(positions.collect(), (0..n).map(|i| [0, 1 + i, 1 + (i + 1) % n]))
}

/// One face with `n` sides and the hole around it.
pub fn single_polygon(n: u32) -> Mesh {
    let n = n.max(3);
    build(circle(n, 0.0).collect(), [(0..n).collect::<Vec<_>>()])
}

/// Two faces with `n` sides, back to back.
pub fn pillow(n: u32) -> Mesh {
    let n = n.max(3);
    build(circle(n, 0.0).collect(), [(0..n).collect::<Vec<_>>(), (0..n).rev().collect()])
}

fn lattice(n: u32, m: u32) -> Vec<DVec3> {
    (0..m).flat_map(|j| (0..n).map(move |i| DVec3::new(f64::from(i), f64::from(j), 0.0))).collect()
}

fn torus_points(n: u32, m: u32) -> Vec<DVec3> {
    let ring = |j: u32| {
        let (sin, cos) = (TAU * f64::from(j) / f64::from(m)).sin_cos();
        circle(n, 0.0).map(move |p| p * (2.0 + cos) + DVec3::Z * sin)
    };
    (0..m).flat_map(ring).collect()
}

/// `n` by `m` quads over points in rows of `columns`, wrapping around at the ends.
fn squares(n: u32, m: u32, columns: u32, rows: u32) -> impl Iterator<Item = [u32; 4]> {
    (0..m).flat_map(move |j| {
        (0..n).map(move |i| {
            let at = |i: u32, j: u32| i % columns + j % rows * columns;
            [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
        })
    })
}

fn halves([a, b, c, d]: [u32; 4]) -> [[u32; 3]; 2] {
    [[a, b, c], [a, c, d]]
}
