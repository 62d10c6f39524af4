//! Cutting at non-manifold edges, and splitting vertices so that each fan has its own.
//!
//! Two sides are joined where they are the only ones of their edge and run in opposite directions.
//! The corners at a vertex that are connected across joined sides are a fan. Each fan gets its own
//! vertex, the first one the old one. This separates the polygons at all other edges, except where
//! two of them are in the same fan at each end of the edge. If these two run in opposite
//! directions, they are joined there; otherwise another corner is isolated, until no such edge is
//! left.

use super::RepairReport;
use super::polygon_list::{NONE, PolygonList};
use crate::mesh::loops::Loops;

/// Cuts and splits until the polygons are a mesh.
pub(super) fn split(list: &mut PolygonList, report: &mut RepairReport) {
    let mut twins = vec![NONE; list.corners.len()];
    let mut is_cut = false;
    for edge in list.sides().edges() {
        match *edge {
            [_] => {}
            [(_, a), (_, b)] if list.corners[a as usize] != list.corners[b as usize] => {
                twins[a as usize] = b;
                twins[b as usize] = a;
            }
            [_, _] => report.twisted_edges += 1,
            _ => report.crowded_edges += 1,
        }
        is_cut |= edge.len() > 2 || (edge.len() == 2 && twins[edge[0].1 as usize] == NONE);
    }
    let (corners, ends) = (list.corners.clone(), list.ends.clone());
    let loops = Loops::new(&corners, &ends);
    let positions = list.positions.len();
    loop {
        list.corners.copy_from_slice(&corners);
        list.positions.truncate(positions);
        list.vertices.truncate(positions);
        list.number_fans(&loops, &twins);
        if !is_cut || !isolate(list, &loops, &mut twins) {
            break;
        }
    }
    report.split_vertices = list.positions.len() - positions;
}

impl PolygonList {
    /// Gives each fan of corners a vertex.
    pub(in crate::mesh) fn number_fans(&mut self, loops: &Loops, twins: &[u32]) {
        let mut is_taken = vec![false; self.positions.len()];
        let mut seen = vec![false; self.corners.len()];
        for first in 0..self.corners.len() {
            if seen[first] {
                continue;
            }
            let old = self.corners[first];
            let vertex = if is_taken[old as usize] {
                self.positions.push(self.positions[old as usize]);
                self.vertices.push(self.vertices[old as usize]);
                self.positions.len() as u32 - 1
            } else {
                is_taken[old as usize] = true;
                old
            };
            let mut reach = |corner: u32| {
                let is_new = !std::mem::replace(&mut seen[corner as usize], true);
                self.corners[corner as usize] = vertex;
                is_new
            };
            reach(first as u32);
            // Around the vertex in one direction, and if that ends, in the other.
            let mut corner = first as u32;
            let closed = loop {
                let twin = twins[loops.prev(corner) as usize];
                if twin == NONE {
                    break false;
                }
                corner = twin;
                if !reach(corner) {
                    break true;
                }
            };
            corner = first as u32;
            while !closed && twins[corner as usize] != NONE {
                corner = loops.next(twins[corner as usize]);
                if !reach(corner) {
                    break;
                }
            }
        }
    }
}

/// Joins the sides of edges that are left with two in opposite directions, and isolates corners at
/// the other unjoined edges. Returns whether any corner was isolated.
fn isolate(list: &PolygonList, loops: &Loops, twins: &mut [u32]) -> bool {
    let mut found = false;
    for edge in list.sides().edges() {
        let unjoined = edge.len() > 1 && twins[edge[0].1 as usize] == NONE;
        if let &[(_, a), (_, b)] = edge
            && unjoined
            && list.corners[a as usize] != list.corners[b as usize]
        {
            twins[a as usize] = b;
            twins[b as usize] = a;
            continue;
        }
        for &(_, side) in edge.iter().skip(1).filter(|_| unjoined) {
            // The previous side at the same corner is joined, or else the corner would be a fan of
            // its own.
            let before = loops.prev(side) as usize;
            let twin = std::mem::replace(&mut twins[before], NONE);
            if twin != NONE {
                twins[twin as usize] = NONE;
                found = true;
            }
        }
    }
    found
}
