//! Placement of texts: boxes must not overlap each other, and should not cover lines.

use glam::DVec2;

use super::curve::Curve;
use super::letters::Label;
use super::shape::TextBox;

/// The costs of a box on a box, and of a box on a line.
const ON_BOX: f64 = 1000.0;
const ON_LINE: f64 = 40.0;
/// The minimum gap between boxes, and the preferred one.
const AIR: f64 = 1.5;
const WIDE_AIR: f64 = 8.0;
/// The cost of a gap of zero; it falls to zero at the preferred gap.
const CLOSE: f64 = 10.0;

/// A candidate place for a text, and its cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub at: DVec2,
    pub cost: f64,
}

/// The boxes and lines drawn so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Room {
    lines: Vec<([DVec2; 2], f64)>,
    boxes: Vec<(DVec2, DVec2)>,
    /// The texts placed so far.
    pub texts: Vec<TextBox>,
}

impl Room {
    /// Registers a curve with its half width, to keep texts away from it.
    pub fn draw(&mut self, curve: &Curve, half_width: f64) {
        self.lines.extend(curve.segments().map(|segment| (segment, half_width)));
    }

    /// The cost of placing a text at `at`.
    pub fn cost(&self, at: DVec2, label: &Label) -> f64 {
        label.boxes().into_iter().map(|(by, half)| self.cost_of_box(at + by, half)).sum()
    }

    fn cost_of_box(&self, at: DVec2, half: DVec2) -> f64 {
        let near = |(other, other_half): &(DVec2, DVec2)| {
            let apart = (at - *other).abs() - half - *other_half;
            match apart.max_element() {
                gap if gap < AIR => ON_BOX,
                gap => CLOSE * (1.0 - gap / WIDE_AIR).max(0.0),
            }
        };
        let boxes: f64 = self.boxes.iter().map(near).sum();
        let half = half + AIR;
        let lines =
            self.lines.iter().filter(|(segment, width)| touches(*segment, at, half + *width));
        boxes + ON_LINE * (lines.take(6).count() as f64)
    }

    /// The spot with the lowest total cost.
    pub fn best(&self, label: &Label, spots: &[Spot]) -> Spot {
        let mut best = Spot { at: DVec2::ZERO, cost: f64::MAX };
        for spot in spots {
            // Boxes and lines only add to the cost.
            if spot.cost >= best.cost - 1e-9 {
                continue;
            }
            let cost = spot.cost + self.cost(spot.at, label);
            if cost < best.cost - 1e-9 {
                best = Spot { cost, ..*spot };
            }
        }
        best
    }

    /// Places a text.
    pub fn put(&mut self, text: &str, label: &Label, at: DVec2) {
        for (by, half) in label.boxes() {
            self.boxes.push((at + by, half));
            self.texts.push(TextBox {
                text: text.to_string(),
                from: (at + by - half).to_array(),
                to: (at + by + half).to_array(),
            });
        }
    }

    /// True if no two texts overlap.
    pub fn is_tidy(&self) -> bool {
        let boxes = &self.boxes;
        (0..boxes.len()).all(|at| {
            boxes[..at].iter().all(|(other, other_half)| {
                let apart = (boxes[at].0 - *other).abs();
                let reach = boxes[at].1 + *other_half;
                apart.x >= reach.x - 1e-6 || apart.y >= reach.y - 1e-6
            })
        })
    }
}

/// True if a segment touches a box.
fn touches([a, b]: [DVec2; 2], center: DVec2, half: DVec2) -> bool {
    let (from, along) = (a - center, b - a);
    // Most segments are far away.
    let [near, far] = [from.min(from + along), from.max(from + along)];
    if near.cmpgt(half).any() || far.cmplt(-half).any() {
        return false;
    }
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for (from, along, half) in [(from.x, along.x, half.x), (from.y, along.y, half.y)] {
        if along.abs() < 1e-12 {
            if from.abs() > half {
                return false;
            }
            continue;
        }
        let (t, u) = ((-half - from) / along, (half - from) / along);
        low = low.max(t.min(u));
        high = high.min(t.max(u));
    }
    low <= high
}

/// The distance from the center of a box to its border in a direction.
pub(super) fn reach(half: DVec2, direction: DVec2) -> f64 {
    let x = half.x / direction.x.abs().max(1e-9);
    let y = half.y / direction.y.abs().max(1e-9);
    x.min(y)
}
