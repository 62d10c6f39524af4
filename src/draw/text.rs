//! An operation as text, for terminals and editors: lines of box characters, names on them.
//!
//! The places are those of the picture, four characters wide for two high. A halfedge is its
//! name with an arrow, inside its face. Marks tell what is new and what is erased.

use glam::DVec2;

use super::curve::{Curve, left};
use super::figure::{Dart, Figure, Side};
use super::place::places;
use super::sector::sector;
use super::status::Status;
use crate::diagram::{Drawing, NameId, Op, Rule};

/// How many characters the radius of a figure is, across and down.
const UNIT: DVec2 = DVec2::new(16.0, 8.0);
/// The largest drawing in characters, across and down.
const MOST: DVec2 = DVec2::new(160.0, 80.0);
/// What stands between the two sides.
const BETWEEN: &str = "    =>    ";

/// Draws an operation as text.
pub fn text_op(op: &Op) -> String {
    let mut text = String::new();
    for rule in &op.rules {
        match &rule.label {
            Some(label) => text.push_str(&format!("{}, rule {label}\n\n", op.name)),
            None => text.push_str(&format!("{}\n\n", op.name)),
        }
        text.push_str(&text_rule(rule));
        text.push('\n');
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

fn text_rule(rule: &Rule) -> String {
    let rule = rule.to_draw();
    let figure = Figure::new(Drawing::new(&rule));
    let unit = places(&figure);
    let none = (DVec2::splat(f64::MAX), DVec2::splat(f64::MIN));
    let (low, high) = unit
        .iter()
        .fold(none, |(low, high), at| (low.min(*at), high.max(*at)));
    let size = (high - low).max(DVec2::splat(0.01));
    let scale = UNIT.min(MOST / size);
    let places: Vec<_> = unit
        .iter()
        .map(|at| (*at - low) * scale + DVec2::new(3.0, 1.0))
        .collect();
    let size = (size * scale + DVec2::new(8.0, 3.0)).min(MOST + 8.0);
    let [before, after] = [&figure.before, &figure.after].map(|side| {
        let mut canvas = Canvas::new(size);
        canvas.side(&figure, side, &places);
        canvas.lines()
    });
    let width = before
        .iter()
        .map(|line| line.chars().count())
        .max()
        .unwrap_or(0);
    let middle = before.len() / 2;
    let mut text = String::new();
    for (row, (before, after)) in before.iter().zip(&after).enumerate() {
        let gap = " ".repeat(width - before.chars().count());
        let between = if row == middle {
            BETWEEN.to_string()
        } else {
            " ".repeat(BETWEEN.len())
        };
        let line = format!("{before}{gap}{between}{after}");
        text.push_str(line.trim_end());
        text.push('\n');
    }
    for (word, status) in [("new", Status::New), ("erase", Status::Erased)] {
        let of = (0..rule.names.len() as u32).map(NameId);
        // Of a family the first.
        let of = of.filter(|&name| rule.is_first(name));
        let of = of.filter(|&name| Status::of(&figure.drawing, name) == status);
        let names: Vec<_> = of.map(|name| rule.name(name).text.as_str()).collect();
        if !names.is_empty() {
            text.push_str(&format!("{word} {}\n", names.join(" ")));
        }
    }
    text
}

struct Canvas {
    width: i64,
    height: i64,
    cells: Vec<char>,
    /// Which cells hold letters.
    taken: Vec<bool>,
}

impl Canvas {
    fn new(size: DVec2) -> Self {
        let (width, height) = (size.x.ceil() as i64 + 6, size.y.ceil() as i64);
        let count = (width * height).max(0) as usize;
        Self {
            width,
            height,
            cells: vec![' '; count],
            taken: vec![false; count],
        }
    }

    fn side(&mut self, figure: &Figure, side: &Side, places: &[DVec2]) {
        let rule = figure.drawing.rule;
        let word = |name: NameId| rule.name(name);
        let strong = sector(rule);
        let is_written = |name: &NameId| word(*name).named && strong[name.index()];
        let curves: Vec<_> = side
            .strands
            .iter()
            .map(|strand| {
                let points: Vec<_> = strand.nodes.iter().map(|&node| places[node]).collect();
                Curve::smooth(&points)
            })
            .collect();
        for (strand, curve) in side.strands.iter().zip(&curves) {
            self.draw(curve, strand.is_path);
        }
        for &vertex in &side.shown {
            for node in figure.nodes_of(vertex) {
                let text = match strong[vertex.index()] {
                    true => &word(vertex).text,
                    false => "•",
                };
                self.write(text, places[node], 0);
            }
        }
        for (at, (strand, curve)) in side.strands.iter().zip(&curves).enumerate() {
            for (item, forward) in strand.items.into_iter().zip([true, false]) {
                let Some(item) = item.filter(is_written) else {
                    continue;
                };
                let dart = Dart {
                    strand: at,
                    forward,
                };
                let along = if dart.forward {
                    curve.clone()
                } else {
                    curve.reversed()
                };
                let (middle, way) = along.at(along.length() / 2.0);
                let aside = left(way);
                let by = DVec2::new(aside.x * 3.0, aside.y * 1.1);
                let text = format!("{}{}", word(item).text, arrow(way));
                self.write(&text, middle + by, 6);
            }
            if let Some(edge) = strand.edge.filter(is_written) {
                let middle = curve.at(curve.length() / 2.0).0;
                self.write(&word(edge).text, middle, 3);
            }
        }
        for orbit in side.loops.iter().filter(|orbit| is_written(&orbit.face)) {
            let nodes = side.around(&orbit.darts);
            let middle = nodes.iter().map(|&node| places[node]).sum::<DVec2>();
            let middle = middle / nodes.len().max(1) as f64;
            self.write(&word(orbit.face).text, middle, 12);
        }
    }

    fn index(&self, x: i64, y: i64) -> Option<usize> {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then_some((y * self.width + x) as usize)
    }

    fn draw(&mut self, curve: &Curve, is_path: bool) {
        let steps = (curve.length() * 3.0).clamp(1.0, 4000.0) as usize;
        let mut last_row = None;
        for step in 0..=steps {
            let (at, way) = curve.at(curve.length() * step as f64 / steps as f64);
            let slope = (way.y * 2.0).abs() / way.x.abs().max(1e-9);
            let mark = match () {
                () if is_path => '·',
                () if slope < 0.4 => '─',
                () if slope > 5.0 => '│',
                () if (way.x > 0.0) == (way.y > 0.0) => '╲',
                () => '╱',
            };
            // One mark a row where a line is slanted, or it would be as thick as wide.
            let row = at.y.round() as i64;
            let is_slanted = slope > 0.7;
            if is_slanted && last_row == Some(row) {
                continue;
            }
            last_row = Some(row);
            if let Some(cell) = self.index(at.x.round() as i64, row) {
                self.cells[cell] = mark;
            }
        }
    }

    /// Writes a text around a place, or at the nearest free one up to some steps away.
    fn write(&mut self, text: &str, at: DVec2, steps: i64) {
        let length = text.chars().count() as i64;
        let (x, y) = (at.x.round() as i64 - length / 2, at.y.round() as i64);
        let mut best = None;
        for dy in -steps / 2..=steps / 2 {
            for dx in -steps..=steps {
                let cost = dx.abs() + 3 * dy.abs();
                let cells: Option<Vec<_>> = (-1..=length)
                    .map(|step| self.index(x + dx + step, y + dy))
                    .collect();
                let Some(cells) = cells else { continue };
                if cells.iter().any(|&cell| self.taken[cell]) {
                    continue;
                }
                let lines = cells
                    .iter()
                    .filter(|&&cell| self.cells[cell] != ' ')
                    .count() as i64;
                let cost = cost + if steps > 3 { 8 * lines } else { 0 };
                if best.as_ref().is_none_or(|(other, _)| cost < *other) {
                    best = Some((cost, cells));
                }
            }
        }
        let Some((_, cells)) = best else { return };
        if let (Some(&first), Some(&last)) = (cells.first(), cells.last()) {
            self.clear([first, last]);
        }
        for (letter, cell) in text.chars().zip(&cells[1..]) {
            self.cells[*cell] = letter;
            self.taken[*cell] = true;
        }
    }

    /// Takes lines away from the sides of a name, so that they do not read as letters.
    fn clear(&mut self, sides: [usize; 2]) {
        for side in sides {
            if !self.taken[side] && self.cells[side] != '─' {
                self.cells[side] = ' ';
            }
        }
    }

    fn lines(&self) -> Vec<String> {
        let rows = self.cells.chunks(self.width.max(1) as usize);
        rows.map(|row| row.iter().collect::<String>().trim_end().to_string())
            .collect()
    }
}

/// The arrow of a direction.
fn arrow(way: DVec2) -> char {
    let eighth = (way.y * 2.0).atan2(way.x) / std::f64::consts::FRAC_PI_4;
    let arrows = ['→', '↘', '↓', '↙', '←', '↖', '↑', '↗'];
    arrows[(eighth.round() as i64).rem_euclid(8) as usize]
}
