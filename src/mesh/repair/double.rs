//! Duplicate polygons.

use super::RepairReport;
use super::polygon_list::PolygonList;

/// Drops duplicates of polygons: those with the same corners in the same order, and those that are
/// the back of another where an edge has three polygons or more. Two polygons back to back and
/// alone are a closed surface, and stay.
pub(super) fn drop_doubled(list: &mut PolygonList, report: &mut RepairReport) {
    let groups = groups(list);
    if groups.is_empty() {
        return;
    }
    let mut dropped = vec![false; list.ends.len()];
    // The rest of each group: at most one of either direction.
    let mut pairs = Vec::new();
    for group in &groups {
        let (first, others) = (group[0], &group[1..]);
        let mut back = None;
        for &other in others {
            if !is_back(list, first, other) || back.is_some() {
                dropped[other] = true;
            } else {
                back = Some(other);
            }
        }
        pairs.extend(back.map(|back| (first, back)));
    }
    if !pairs.is_empty() {
        let crowded = crowded(list, &dropped);
        for (first, back) in pairs {
            // The sides of both are the same edges.
            dropped[back] |= list.range(first).any(|side| crowded[side]);
        }
    }
    let before = list.ends.len();
    list.retain(|polygon, _| !dropped[polygon]);
    report.doubled_faces += before - list.ends.len();
}

/// Pairs of the first polygon with some corners in some order, and another with the same corners in
/// the same order.
pub(in crate::mesh) fn repeated(list: &PolygonList) -> Vec<[usize; 2]> {
    let mut pairs = Vec::new();
    for group in groups(list) {
        let first = group[0];
        let mut back = None;
        for &other in &group[1..] {
            if runs_alike(list, first, other) {
                pairs.push([first, other]);
            } else if let Some(back) = back {
                pairs.push([back, other]);
            } else {
                back = Some(other);
            }
        }
    }
    pairs.sort_unstable_by_key(|&[_, other]| other);
    pairs
}

/// Whether each side is at an edge of three polygons or more, not counting dropped ones.
fn crowded(list: &PolygonList, dropped: &[bool]) -> Vec<bool> {
    let mut at_dropped = vec![false; list.corners.len()];
    for (polygon, _) in dropped.iter().enumerate().filter(|(_, dropped)| **dropped) {
        at_dropped[list.range(polygon)].fill(true);
    }
    let mut crowded = vec![false; list.corners.len()];
    for edge in list.sides().edges() {
        if edge.iter().filter(|&&(_, side)| !at_dropped[side as usize]).count() > 2 {
            edge.iter().for_each(|&(_, side)| crowded[side as usize] = true);
        }
    }
    crowded
}

/// Groups of polygons with the same corners in the same cyclic order, forward or backward.
fn groups(list: &PolygonList) -> Vec<Vec<usize>> {
    let hashed = |polygon| (hash(&list.corners[list.range(polygon)]), polygon as u32);
    let mut hashes: Vec<(u64, u32)> = (0..list.ends.len()).map(hashed).collect();
    hashes.sort_unstable();
    let mut groups = Vec::new();
    for alike in hashes.chunk_by(|a, b| a.0 == b.0).filter(|alike| alike.len() > 1) {
        let mut rest: Vec<usize> = alike.iter().map(|&(_, polygon)| polygon as usize).collect();
        while rest.len() > 1 {
            let first = rest[0];
            let is_same =
                |&other: &usize| runs_alike(list, first, other) || is_back(list, first, other);
            let (group, others) = rest.into_iter().partition::<Vec<_>, _>(is_same);
            if group.len() > 1 {
                groups.push(group);
            }
            rest = others;
        }
    }
    groups
}

/// A hash that does not depend on the first corner or the direction: it goes from the least vertex
/// towards the lesser of its neighbors.
fn hash(corners: &[u32]) -> u64 {
    let mix = |hash: u64, &v: &u32| {
        (hash.rotate_left(26) ^ u64::from(v)).wrapping_mul(0x9E37_79B9_7F4A_7C15)
    };
    let least = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap_or(0);
    let (head, tail) = corners.split_at(least);
    let forward = tail.iter().chain(head);
    let backward = tail.iter().take(1).chain(head.iter().rev()).chain(tail.iter().skip(1).rev());
    if forward.clone().nth(1) <= backward.clone().nth(1) {
        forward.fold(0, mix)
    } else {
        backward.fold(0, mix)
    }
}

/// True if two polygons have the same corners in the same cyclic order.
fn runs_alike(list: &PolygonList, first: usize, other: usize) -> bool {
    let (first, other) = (&list.corners[list.range(first)], &list.corners[list.range(other)]);
    let start = other.iter().position(|v| *v == first[0]);
    first.len() == other.len()
        && start.is_some_and(|start| first.iter().eq(other[start..].iter().chain(&other[..start])))
}

/// True if a polygon has the corners of another in the opposite cyclic order.
fn is_back(list: &PolygonList, first: usize, other: usize) -> bool {
    let (first, other) = (&list.corners[list.range(first)], &list.corners[list.range(other)]);
    let start = other.iter().position(|v| *v == first[0]);
    first.len() == other.len()
        && start.is_some_and(|start| {
            let (head, tail) = other.split_at(start + 1);
            first.iter().eq(head.iter().rev().chain(tail.iter().rev()))
        })
}
