//! The steps of a path as SVG writes them, in as few characters as possible.

use glam::DVec2;

use super::shape::{Path, Step};

/// The format in which the numbers of a path are written.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Grain {
    /// The number of parts to a unit; places are rounded to parts.
    pub parts: f64,
    /// The number of parts that is written as 1.
    pub measure: f64,
    /// The number of parts by which a control point may be off, for the curve to be written as a
    /// smooth continuation.
    pub slack: i64,
}

/// The steps of a path, each but the first relative to the one before. The places are rounded, not
/// the steps, so that errors do not add up.
pub(super) fn data(path: &Path, grain: Grain) -> String {
    let mut data = Steps { grain, ..Steps::default() };
    for step in &path.steps {
        match *step {
            Step::Move(to) => data.to('m', &[to]),
            Step::Line(to) => data.to('l', &[to]),
            Step::Curve(by, to) => data.curve(by, to),
            Step::Close => data.close(),
        }
    }
    data.text
}

/// Steps as text.
#[derive(Default)]
struct Steps {
    grain: Grain,
    text: String,
    last: Option<char>,
    at: [i64; 2],
    /// The start of the current polygon, where closing it leads.
    began: [i64; 2],
    /// The control point of a smooth continuation.
    smooth: Option<[i64; 2]>,
}

impl Steps {
    fn rounded(&self, point: DVec2) -> [i64; 2] {
        [point.x, point.y].map(|value| (value * self.grain.parts).round() as i64)
    }

    fn curve(&mut self, by: DVec2, to: DVec2) {
        let wanted = self.rounded(by);
        let is_near = |smooth: &[i64; 2]| {
            smooth.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= self.grain.slack)
        };
        let by = match self.smooth.filter(is_near) {
            Some(smooth) => {
                self.to('t', &[to]);
                smooth
            }
            None => {
                self.to('q', &[by, to]);
                wanted
            }
        };
        self.smooth = Some([0, 1].map(|axis| 2 * self.at[axis] - by[axis]));
    }

    fn to(&mut self, step: char, points: &[DVec2]) {
        // A step like the last one needs no letter; a second `m` would be read as a line.
        let is_new = self.last != Some(step) || step == 'm';
        if is_new {
            self.text.push(step);
        }
        let mut last = self.at;
        for (nth, &point) in points.iter().enumerate() {
            last = self.rounded(point);
            for (axis, (to, from)) in last.into_iter().zip(self.at).enumerate() {
                self.number(to - from, nth == 0 && axis == 0 && is_new);
            }
        }
        (self.at, self.last, self.smooth) = (last, Some(step), None);
        if step == 'm' {
            self.began = last;
        }
    }

    fn number(&mut self, way: i64, is_first: bool) {
        // A sign separates two numbers as well as a space does.
        if !is_first && way >= 0 {
            self.text.push(' ');
        }
        let number = (way as f64 / self.grain.measure).to_string();
        // The zero before a decimal point is redundant.
        let is_part = (way.abs() as f64) < self.grain.measure;
        self.text.push_str(&number.replacen("0.", ".", usize::from(is_part)));
    }

    fn close(&mut self) {
        self.text.push('z');
        (self.at, self.last, self.smooth) = (self.began, Some('z'), None);
    }
}
