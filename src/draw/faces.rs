//! The faces and holes of a panel.

use glam::DVec2;

use super::figure::Orbit;
use super::hatch::{hatch, ticks};
use super::panel::{LETTERS, Panel};
use super::room::Spot;
use super::shape::{Ink, Path, Stroke};
use super::spots::inner_spots;
use crate::diagram::{LoopKind, NameId};

impl Panel<'_> {
    /// What lies on both sides of an edge.
    pub(super) fn ground(&self, edge: NameId) -> Ink {
        let mut strands = self.side.strands.iter();
        let at = strands.position(|strand| strand.edge == Some(edge));
        let in_faces = |at: usize| {
            let mut faces = self.side.loops.iter();
            faces.any(|orbit| {
                orbit.kind != LoopKind::Hole && orbit.darts.iter().any(|dart| dart.strand == at)
            })
        };
        match at {
            Some(at) if in_faces(at) => Ink::Face,
            _ => Ink::Paper,
        }
    }

    fn outline(&self, orbit: &Orbit) -> Vec<DVec2> {
        let mut corners = Vec::new();
        for dart in &orbit.darts {
            let curve = self.along(*dart);
            corners.extend(&curve.points()[..curve.points().len() - 1]);
        }
        corners
    }

    /// The inside of a loop, and its name.
    pub(super) fn face(&mut self, orbit: &Orbit) {
        let group = self.group(orbit.face);
        let outline = self.outline(orbit);
        let is_hole = orbit.kind == LoopKind::Hole;
        let is_inside = area(&outline) > 0.0;
        if is_inside && !is_hole {
            self.groups[group].fill(Path::around(&outline), Ink::Face);
        }
        if is_hole {
            let lines = match is_inside {
                true => hatch(&outline),
                false => ticks(&outline),
            };
            for line in lines {
                let stroke = Stroke::solid(Ink::Muted, 0.9);
                self.groups[group].stroke(Path::along(&line), stroke);
            }
        }
        let low = outline.iter().map(|at| at.y).fold(f64::MIN, f64::max);
        let middle = outline.iter().copied().sum::<DVec2>() / outline.len().max(1) as f64;
        self.text(group, orbit.face, LETTERS, |label| {
            if is_inside {
                inner_spots(&outline)
            } else {
                let below = DVec2::new(middle.x, low.max(middle.y) + 34.0 + label.half.y);
                let steps = (-8..=8).map(f64::from);
                steps
                    .map(|step| Spot {
                        at: below + DVec2::X * (step * 14.0),
                        cost: step.abs(),
                    })
                    .collect()
            }
        });
        if is_hole && let Some(text) = self.texts.last_mut() {
            text.ground = Some(Ink::Paper);
        }
    }
}

/// Twice the area of a polygon, positive if it runs counterclockwise.
fn area(outline: &[DVec2]) -> f64 {
    let count = outline.len();
    let pieces = (0..count).map(|at| outline[(at + 1) % count].perp_dot(outline[at]));
    pieces.sum()
}
