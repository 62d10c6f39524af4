//! Positions for a small mesh: the longest loop outside on a circle, everything else in the
//! middle of its neighbors.
//!
//! After W. T. Tutte, "How to draw a graph", 1963, with a few rounds of averaging instead of
//! a linear system.

use glam::DVec3;

use super::place::Place;
use crate::mesh::{FaceId, VertexId};

const ROUNDS: usize = 60;

/// Gives every vertex a position.
pub(super) fn lay_out(place: &mut Place) {
    let mesh = &mut place.mesh;
    let around = |&face: &FaceId| {
        let mut around: Vec<VertexId> = Vec::new();
        for vertex in mesh.face_vertices(face) {
            if !around.contains(&vertex) {
                around.push(vertex);
            }
        }
        // Seen from inside, the loop outside runs clockwise.
        around.reverse();
        around
    };
    let rims = place.outside.iter().map(around);
    let whole = || mesh.vertices().collect();
    let rim = rims.max_by_key(Vec::len).unwrap_or_else(whole);
    for (at, &vertex) in rim.iter().enumerate() {
        let turn = std::f64::consts::TAU * at as f64 / rim.len() as f64;
        mesh.set_position(vertex, DVec3::new(turn.cos(), turn.sin(), 0.0));
    }
    let inner: Vec<_> = mesh.vertices().filter(|vertex| !rim.contains(vertex)).collect();
    for round in 0..ROUNDS {
        for (at, &vertex) in inner.iter().enumerate() {
            let (mut sum, mut count) = (DVec3::ZERO, 0.0);
            for neighbor in mesh.neighbors(vertex).filter(|&other| other != vertex) {
                sum += mesh.position(neighbor);
                count += 1.0;
            }
            let middle = if count > 0.0 { sum / count } else { DVec3::ZERO };
            // A vertex with one neighbor would fall onto it.
            let apart = if count == 1.0 && round + 1 == ROUNDS {
                let turn = at as f64;
                DVec3::new(turn.cos(), turn.sin(), 0.0) * 0.1
            } else {
                DVec3::ZERO
            };
            mesh.set_position(vertex, middle + apart);
        }
    }
    let ids: Vec<_> = mesh.vertices().collect();
    for vertex in ids {
        // No more digits than a reader wants.
        let position = (mesh.position(vertex) * 1e6).round() / 1e6;
        mesh.set_position(vertex, position + DVec3::ZERO);
    }
}
