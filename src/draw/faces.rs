//! The faces and holes of a panel.

use glam::DVec2;

use super::curve::{Curve, area, left, mean};
use super::figure::Orbit;
use super::hatch::{hatch, ticks};
use super::label_boxes::Spot;
use super::label_positions::inner_spots;
use super::panel::{Hatched, LETTERS, Panel};
use super::shape::{Ink, Path, Stroke};
use crate::diagram::{LoopKind, NameId};
use crate::mesh::is_inside;

impl Panel<'_> {
    /// The background colour around an edge.
    pub(super) fn ground(&self, edge: NameId) -> Ink {
        let at = self.side.strands.iter().position(|strand| strand.edge == Some(edge));
        let in_faces = |at: usize| {
            self.side.loops.iter().any(|orbit| {
                let is_beside = orbit.darts.iter().any(|dart| dart.strand == at);
                orbit.kind != LoopKind::Hole
                    && is_beside
                    && self.encloses(orbit, &self.outline(orbit))
            })
        };
        match at {
            Some(at) if in_faces(at) => Ink::Face,
            _ => Ink::Paper,
        }
    }

    /// True if a face or hole lies within its outline: the loop closes and is not the outside.
    pub(super) fn encloses(&self, orbit: &Orbit, outline: &[DVec2]) -> bool {
        self.side.is_closed(&orbit.darts) && area(outline) > 0.0
    }

    /// The outline as one curve; that of a loop that does not close in pieces.
    fn borders(&self, orbit: &Orbit, outline: &[DVec2]) -> Vec<Curve> {
        if self.side.is_closed(&orbit.darts) {
            return vec![Curve::through(outline.iter().chain(outline.first()).copied())];
        }
        orbit.darts.iter().map(|&dart| self.along(dart)).collect()
    }

    pub(super) fn outline(&self, orbit: &Orbit) -> Vec<DVec2> {
        let mut corners = Vec::new();
        for dart in &orbit.darts {
            let curve = self.along(*dart);
            corners.extend(&curve.points()[..curve.points().len() - 1]);
        }
        corners
    }

    /// Draws the inside of a loop, and adds its name.
    pub(super) fn face(&mut self, orbit: &Orbit) {
        let group = self.group(orbit.face);
        let outline = self.outline(orbit);
        let is_hole = orbit.kind == LoopKind::Hole;
        let is_inside = self.encloses(orbit, &outline);
        let islands = if is_inside { self.islands(&outline) } else { Vec::new() };
        if is_inside && !is_hole {
            self.groups[group].fill(Path::around(&outline), Ink::Face);
            for island in &islands {
                self.groups[group].fill(Path::around(island), Ink::Paper);
            }
        }
        if is_hole {
            let lines = match is_inside {
                true => hatch(&outline, &islands),
                false => self.borders(orbit, &outline).iter().flat_map(ticks).collect(),
            };
            self.hatched.push(Hatched { group, outline: outline.clone(), is_around: !is_inside });
            for line in lines {
                let stroke = Stroke::solid(Ink::Muted, 0.9);
                self.groups[group].stroke(Path::along(&line), stroke);
            }
        }
        let low = outline.iter().map(|at| at.y).fold(f64::MIN, f64::max);
        let middle = mean(&outline);
        let is_closed = self.side.is_closed(&orbit.darts);
        let along: Vec<_> = orbit.darts.iter().map(|&dart| self.along(dart)).collect();
        self.text(group, orbit.face, LETTERS, |label| {
            // A loop that does not close still runs around something, or has an inner side.
            if is_inside || !is_closed && !is_hole && area(&outline) > 0.0 {
                return (label, inner_spots(&outline, &islands));
            }
            if !is_closed && !is_hole {
                return (label, along.iter().flat_map(inner_side).collect());
            }
            let below = DVec2::new(middle.x, low.max(middle.y) + 40.0 + label.half.y);
            let spot = |step: f64| Spot { at: below + DVec2::X * (step * 14.0), cost: step.abs() };
            (label, (-8..=8).map(f64::from).map(spot).collect())
        });
    }

    /// The place inside a loop with the most room for its name; `None` if the loop is the outside.
    pub(super) fn middle(&self, orbit: &Orbit) -> Option<DVec2> {
        let outline = self.outline(orbit);
        if !self.encloses(orbit, &outline) {
            return None;
        }
        let spots = inner_spots(&outline, &self.islands(&outline));
        spots.iter().min_by(|a, b| a.cost.total_cmp(&b.cost)).map(|spot| spot.at)
    }

    /// The islands in a polygon: the outlines of the loops inside it that run clockwise.
    fn islands(&self, outline: &[DVec2]) -> Vec<Vec<DVec2>> {
        let outlines = self.side.loops.iter().map(|orbit| self.outline(orbit));
        let is_island = |other: &Vec<DVec2>| {
            area(other) < 0.0 && other.iter().all(|&at| is_inside(at, outline))
        };
        outlines.filter(is_island).collect()
    }
}

/// Spots on the inner side of a halfedge, away from its own name.
fn inner_side(curve: &Curve) -> Vec<Spot> {
    let mut spots = Vec::new();
    for (rank, part) in [0.5, 0.35, 0.65].into_iter().enumerate() {
        let (point, direction) = curve.at(part * curve.length());
        for away in [50.0, 70.0] {
            let cost = rank as f64 + away / 10.0;
            spots.push(Spot { at: point + left(direction) * away, cost });
        }
    }
    spots
}
