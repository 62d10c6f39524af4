//! Cutting at non-manifold edges, and splitting vertices so that each fan has its own.
//!
//! Two sides are joined where they are the only ones of their edge and run in opposite directions.
//! The corners at a vertex that are connected across joined sides are a fan. Each fan gets its own
//! vertex, the first one the old one. This separates the polygons at all other edges, except where
//! two of them are in the same fan at each end of the edge. If these two run in opposite
//! directions, they are joined there; otherwise another corner is isolated, until no such edge is
//! left.
//!
//! At an edge of three polygons or more, two of them are joined first where they run in opposite
//! directions and are a fan of their own around one end of the edge: they are one sheet, on which
//! the others stand. Since that joins their fans around the other end, it continues along a line of
//! such edges.

use std::collections::HashMap;

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
    join_sheets(list, &loops, &mut twins);
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

/// Joins two sides of edges of three polygons or more where they are a sheet around one end.
fn join_sheets(list: &PolygonList, loops: &Loops, twins: &mut [u32]) {
    let sides = list.sides();
    let crowded: Vec<_> = sides.edges().filter(|edge| edge.len() > 2).collect();
    if crowded.is_empty() {
        return;
    }
    let mut fans = Fans { next: (0..twins.len() as u32).collect() };
    for (side, &twin) in (0..).zip(&*twins) {
        if twin != NONE && side < twin {
            fans.join(loops, [side, twin]);
        }
    }
    let ends = |edge: &[(u32, u32)]| {
        [edge[0].1, loops.next(edge[0].1)].map(|corner| list.corners[corner as usize])
    };
    let mut around: HashMap<u32, Vec<usize>> = HashMap::new();
    for (number, edge) in crowded.iter().enumerate() {
        ends(edge).into_iter().for_each(|end| around.entry(end).or_default().push(number));
    }
    let mut waiting: Vec<usize> = (0..crowded.len()).rev().collect();
    let mut is_waiting = vec![true; crowded.len()];
    while let Some(number) = waiting.pop() {
        is_waiting[number] = false;
        let edge = crowded[number];
        for end in ends(edge) {
            let mut fan = |side: u32| {
                let is_begin = list.corners[side as usize] == end;
                fans.of(if is_begin { side } else { loops.next(side) })
            };
            let mut at_end: Vec<_> =
                edge.iter().enumerate().map(|(at, &(_, side))| (fan(side), at, side)).collect();
            at_end.sort_unstable();
            let pairs = at_end.chunk_by(|one, other| one.0 == other.0).filter_map(|fan| {
                let &[(_, at, a), (_, _, b)] = fan else { return None };
                let is_open = [a, b].iter().all(|&side| twins[side as usize] == NONE);
                let are_opposite = list.corners[a as usize] != list.corners[b as usize];
                (is_open && are_opposite).then_some((at, [a, b]))
            });
            let sheet = pairs.min().map(|(_, sides)| sides);
            let Some([a, b]) = sheet else { continue };
            (twins[a as usize], twins[b as usize]) = (b, a);
            fans.join(loops, [a, b]);
            let near = ends(edge).into_iter().flat_map(|end| around[&end].iter().copied());
            waiting.extend(near.filter(|&near| !std::mem::replace(&mut is_waiting[near], true)));
        }
    }
}

/// The corners at each vertex that are connected, as a forest of disjoint sets.
struct Fans {
    next: Vec<u32>,
}

impl Fans {
    /// The set of a corner.
    fn of(&mut self, mut corner: u32) -> u32 {
        while self.next[corner as usize] != corner {
            let further = self.next[self.next[corner as usize] as usize];
            self.next[corner as usize] = further;
            corner = further;
        }
        corner
    }

    /// Connects the corners at both ends of two sides that are joined.
    fn join(&mut self, loops: &Loops, [a, b]: [u32; 2]) {
        for [one, other] in [[a, loops.next(b)], [loops.next(a), b]] {
            let [one, other] = [one, other].map(|corner| self.of(corner));
            self.next[one.max(other) as usize] = one.min(other);
        }
    }
}

/// Joins the sides of edges that are left with two in opposite directions, and isolates corners at
/// the other unjoined edges. Returns whether any corner was isolated.
fn isolate(list: &PolygonList, loops: &Loops, twins: &mut [u32]) -> bool {
    let mut found = false;
    for edge in list.sides().edges() {
        let is_open = |&&(_, side): &&(u32, u32)| twins[side as usize] == NONE;
        let open: Vec<_> = edge.iter().filter(is_open).map(|&(_, side)| side).collect();
        if let (2, &[a, b]) = (edge.len(), open.as_slice())
            && list.corners[a as usize] != list.corners[b as usize]
        {
            twins[a as usize] = b;
            twins[b as usize] = a;
            continue;
        }
        // One of them keeps its vertices, if no others are joined there.
        let kept = usize::from(edge.len() == open.len());
        for &side in open.iter().skip(kept) {
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
