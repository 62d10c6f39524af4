//! Orienting polygons consistently with their neighbors.

use super::RepairReport;
use super::polygon_list::{NONE, PolygonList};

/// Turns polygons over so that neighbors are oriented consistently across every edge that has two
/// of them, as far as possible: in each connected part the smaller share is turned, or, if the
/// shares are equal, the one without the first polygon.
pub(super) fn orient(list: &mut PolygonList, report: &mut RepairReport) {
    // For each side, the other side of its edge, if there is exactly one.
    let mut partners = vec![NONE; list.corners.len()];
    let mut any_turned = false;
    for edge in list.sides().edges() {
        if let &[(_, a), (_, b)] = edge {
            partners[a as usize] = b;
            partners[b as usize] = a;
            any_turned |= list.corners[a as usize] == list.corners[b as usize];
        }
    }
    if !any_turned {
        return;
    }
    let loops = list.loops();
    let mut turned: Vec<Option<bool>> = vec![None; list.ends.len()];
    let mut part: Vec<usize> = Vec::new();
    for first in 0..list.ends.len() {
        if turned[first].is_some() {
            continue;
        }
        part.clear();
        part.push(first);
        turned[first] = Some(false);
        let mut done = 0;
        while let Some(&polygon) = part.get(done) {
            done += 1;
            let is_turned = turned[polygon] == Some(true);
            for side in list.range(polygon) {
                let partner = partners[side];
                if partner == NONE {
                    continue;
                }
                let other = loops.polygon(partner) as usize;
                if turned[other].is_none() {
                    let runs_alike = list.corners[side] != list.corners[partner as usize];
                    turned[other] = Some(is_turned == runs_alike);
                    part.push(other);
                }
            }
        }
        let share = part.iter().filter(|&&polygon| turned[polygon] == Some(true)).count();
        if share * 2 > part.len() {
            part.iter().for_each(|&polygon| turned[polygon] = turned[polygon].map(|it| !it));
        }
    }
    for (polygon, _) in turned.iter().enumerate().filter(|(_, turned)| **turned == Some(true)) {
        // It still begins at the same corner.
        let behind_first = list.range(polygon).start + 1..list.range(polygon).end;
        list.corners[behind_first.clone()].reverse();
        list.corner_origins[behind_first].reverse();
        report.turned_faces += 1;
    }
}
