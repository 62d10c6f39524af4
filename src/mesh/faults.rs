//! All faults that keep polygons from being a mesh, by kind.

use glam::DVec3;

use super::build_error::BuildError;
use super::polygons::Polygons;
use super::repair::{NONE, PolygonList, repeated};

/// The faults that keep a list of polygons from being a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Faults {
    /// The faults of each kind that occurs.
    pub kinds: Vec<FaultKind>,
}

/// The faults of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct FaultKind {
    /// The first ones, three at most.
    pub first: Vec<BuildError>,
    pub count: usize,
}

/// The number of faults of a kind that are listed.
const TOLD: usize = 3;

impl Faults {
    /// Finds all faults. Polygons that are faulty in themselves, and repeats of others, are left
    /// out of the checks of edges and vertices, and vertices at faulty edges are not reported as
    /// pinched.
    pub fn of(positions: &[DVec3], polygons: &Polygons) -> Self {
        let mut faults = Self { kinds: Vec::new() };
        for (v, &position) in (0..).zip(positions).filter(|(_, at)| !at.is_finite()) {
            faults.add(BuildError::NotFinite { vertex: v, position });
        }
        let mut list = PolygonList::new(positions.to_vec(), polygons.clone());
        let vertices = positions.len();
        let mut sorted = Vec::new();
        list.retain(|polygon, corners| {
            let fault = BuildError::of_polygon(polygon, corners, vertices, &mut sorted);
            let is_sound = fault.is_none();
            fault.into_iter().for_each(|fault| faults.add(fault));
            is_sound
        });
        let mut is_repeated = vec![false; list.faces.len()];
        for polygons in repeated(&list) {
            is_repeated[polygons[1]] = true;
            let polygons = polygons.map(|polygon| list.faces[polygon] as usize);
            faults.add(BuildError::Doubled { polygons });
        }
        list.retain(|polygon, _| !is_repeated[polygon]);
        faults.look_at_edges(&list);
        faults
    }

    fn add(&mut self, fault: BuildError) {
        let kind = std::mem::discriminant(&fault);
        let known = self.kinds.iter_mut();
        let mut known = known.filter(|known| std::mem::discriminant(&known.first[0]) == kind);
        match known.next() {
            Some(known) => {
                known.count += 1;
                if known.first.len() < TOLD {
                    known.first.push(fault);
                }
            }
            None => self.kinds.push(FaultKind { first: vec![fault], count: 1 }),
        }
    }

    fn look_at_edges(&mut self, list: &PolygonList) {
        let (corners, loops) = (&list.corners, list.loops());
        let polygon = |side: u32| list.faces[loops.polygon(side) as usize] as usize;
        let ends = |side: u32| loops.ends(side);
        let mut twins = vec![NONE; corners.len()];
        let mut at_fault = vec![false; list.positions.len()];
        let mut faulty = Vec::new();
        for edge in list.sides().edges() {
            let Some(fault) = BuildError::of_edge(edge, ends, polygon) else {
                if let [(_, a), (_, b)] = *edge {
                    twins[a as usize] = b;
                    twins[b as usize] = a;
                }
                continue;
            };
            faulty.push(fault);
            ends(edge[0].1).into_iter().for_each(|v| at_fault[v as usize] = true);
        }
        // In the order in which the faults show when the polygons are read one by one.
        faulty.sort_by_key(|fault| match fault {
            BuildError::SameDirection { polygons, .. } => polygons[1],
            BuildError::EdgeUsedThrice { polygons, .. } => polygons[2],
            _ => 0,
        });
        faulty.into_iter().for_each(|fault| self.add(fault));

        let mut fans = list.clone();
        fans.number_fans(&loops, &twins);
        let mut first_fan = vec![NONE; list.positions.len()];
        let mut is_pinched = vec![false; list.positions.len()];
        for (corner, &vertex) in corners.iter().enumerate() {
            let v = vertex as usize;
            if fans.corners[corner] as usize == v {
                if first_fan[v] == NONE {
                    first_fan[v] = corner as u32;
                }
            } else if !at_fault[v] && !std::mem::replace(&mut is_pinched[v], true) {
                let polygons = [polygon(first_fan[v]), polygon(corner as u32)];
                self.add(BuildError::BowTie { vertex: v as u32, polygons });
            }
        }
    }
}
