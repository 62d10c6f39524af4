//! An operation as text, for terminals and editors: lines of box-drawing characters, with names.
//!
//! The layout is that of the picture. A halfedge is its name with an arrow, inside its face; a fan
//! is its name as the language writes it, `*S`, beside its vertex. The lines below list what is new
//! and what is erased.

use std::ops::Range;

use glam::DVec2;

use super::curve::{Curve, bounds, direction, left, mean};
use super::figure::Figure;
use super::layout::places;
use super::panel::Panel;
use super::status::Status;
use crate::diagram::{Drawing, Kind, LoopKind, NameId, Op, Rule};

/// The approximate width of a side in characters, and the minimum and maximum number of characters
/// to the radius of a figure.
const WIDTH: f64 = 35.0;
const UNIT: [f64; 2] = [16.0, 24.0];
/// The scale of the axes: a character is twice as high as it is wide.
const SLIM: DVec2 = DVec2::new(1.0, 0.5);
/// The largest drawing in characters, across and down.
const MOST: DVec2 = DVec2::new(160.0, 80.0);
/// The radius of the figure before it is scaled to characters.
const RADIUS: f64 = 250.0;
/// The distance from its vertex at which a fan is written.
const FAN: DVec2 = DVec2::new(4.5, 2.0);
/// The text between the two sides.
const BETWEEN: &str = "   =>   ";
/// The usual number of columns, where nothing says how many there are.
pub const COLUMNS: usize = 100;

/// Draws an operation as text; its sides stand one below the other where both do not fit into so
/// many columns.
pub fn text_op(op: &Op, columns: usize) -> String {
    let mut text = String::new();
    for rule in &op.rules {
        let what = match (&rule.example, &rule.label) {
            (Some(example), _) => format!(", for example on {}", example.mesh),
            (None, Some(label)) => format!(", rule {label}"),
            (None, None) => String::new(),
        };
        text.push_str(&format!("{}{what}\n\n{}\n", op.name, text_rule(rule, columns)));
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

fn text_rule(rule: &Rule, columns: usize) -> String {
    let rule = rule.to_draw();
    let figure = Figure::new(Drawing::new(&rule));
    let places = places(&figure).map(|unit| unit.iter().map(|&at| at * RADIUS).collect::<Vec<_>>());
    let before = Panel::new(&figure, None, &places[0], "");
    let after = Panel::new(&figure, Some(&before), &places[1], "");
    let curves = before.curves.iter().chain(&after.curves).flat_map(Curve::points);
    let (low, high) = bounds(places.iter().flatten().chain(curves).map(|&at| at / RADIUS));
    let size = (high - low).max(DVec2::splat(0.01));
    // A whole number of rows, so that slanted lines are even.
    let rows = (WIDTH / size.x * SLIM.y).clamp(UNIT[0] * SLIM.y, UNIT[1] * SLIM.y);
    let scale = SLIM * (rows.floor() / SLIM.y);
    let scale = scale.min(MOST / size);
    // Half of the longest name has room beside the vertices.
    let longest = rule.names.iter().filter(|name| name.named).map(|name| name.text.chars().count());
    let margin = (longest.max().unwrap_or(0) / 2 + 1).max(3) as f64;
    let grid = Grid { scale: scale / RADIUS, by: DVec2::new(margin, 2.0) - low * scale };
    let size = (size * scale).min(MOST) + DVec2::new(2.0 * margin + 2.0, 5.0);
    let [before, after] = [before, after].map(|panel| {
        let mut canvas = Canvas::new(size);
        canvas.side(&panel, &grid);
        canvas.lines()
    });
    // Rows above and below that are empty on both sides are omitted.
    let rows = used(before.len(), |row| !before[*row].is_empty() || !after[*row].is_empty());
    let [before, after] = [&before[rows.clone()], &after[rows]];
    let [width, other] = [before, after]
        .map(|lines| lines.iter().map(|line| line.chars().count()).max().unwrap_or(0));
    let mut text = if width + BETWEEN.len() + other > columns {
        let between = ["", BETWEEN.trim_end(), ""].map(str::to_string);
        [trimmed(before), &between, trimmed(after)].concat().join("\n")
    } else {
        let middle = before.len() / 2;
        let beside = before.iter().zip(after).enumerate().map(|(row, (before, after))| {
            let between = if row == middle { BETWEEN } else { "" };
            let line = format!("{before:width$}{between:0$}{after}", BETWEEN.len());
            line.trim_end().to_string()
        });
        beside.collect::<Vec<_>>().join("\n")
    };
    text.push('\n');
    let told = [("new", Status::New), ("erase", Status::Erased)];
    let told = told.map(|(word, status)| (word, told_names(&figure, status)));
    let told = told.iter().filter(|(_, names)| !names.is_empty());
    let told: String = told.map(|(word, names)| format!("{word} {names}\n")).collect();
    if told.is_empty() { text } else { format!("{text}\n{told}") }
}

/// The rows from the first to the last one that is used.
fn used(count: usize, is_used: impl Fn(&usize) -> bool) -> Range<usize> {
    let first = (0..count).find(&is_used).unwrap_or(0);
    first..(0..count).rfind(&is_used).map_or(first, |last| last + 1)
}

/// Lines without the empty ones around them.
fn trimmed(lines: &[String]) -> &[String] {
    &lines[used(lines.len(), |row| !lines[*row].is_empty())]
}

/// The names with a status, of a family only the first; elements without a name are counted.
fn told_names(figure: &Figure, status: Status) -> String {
    let rule = figure.drawing.rule;
    let of = rule.ids().filter(|&name| rule.is_first(name));
    let of: Vec<_> = of.filter(|&name| Status::of(&figure.drawing, name) == status).collect();
    let named = of.iter().map(|&name| rule.name(name));
    let names: Vec<_> = named.filter(|name| name.named).map(|name| name.text.as_str()).collect();
    let mut parts = if names.is_empty() { Vec::new() } else { vec![names.join(" ")] };
    // Halfedges are not counted: every edge has two.
    for (kind, one, more) in [
        (Kind::Vertex, "vertex", "vertices"),
        (Kind::Edge, "edge", "edges"),
        (Kind::Face, "face", "faces"),
    ] {
        let is_counted = |&&name: &&NameId| !rule.name(name).named && rule.kind(name) == kind;
        match of.iter().filter(is_counted).count() {
            0 => {}
            1 => parts.push(format!("1 {one}")),
            count => parts.push(format!("{count} {more}")),
        }
    }
    parts.join(", ")
}

/// The mapping from places in a picture to characters.
struct Grid {
    scale: DVec2,
    by: DVec2,
}

impl Grid {
    fn place(&self, at: DVec2) -> DVec2 {
        at * self.scale + self.by
    }
}

struct Canvas {
    width: i64,
    height: i64,
    cells: Vec<char>,
    /// Whether each cell holds a letter.
    taken: Vec<bool>,
}

impl Canvas {
    fn new(size: DVec2) -> Self {
        let (width, height) = (size.x.ceil() as i64 + 6, size.y.ceil() as i64);
        let count = (width * height).max(0) as usize;
        Self { width, height, cells: vec![' '; count], taken: vec![false; count] }
    }

    fn side(&mut self, panel: &Panel, grid: &Grid) {
        let (figure, side) = (panel.figure, panel.side);
        let rule = figure.drawing.rule;
        let word = |name: NameId| rule.name(name);
        let is_written = |name: &NameId| word(*name).named && panel.stands_out(*name);
        let curve = |curve: &Curve| Curve::through(curve.points().iter().map(|&at| grid.place(at)));
        let curves: Vec<_> = panel.curves.iter().map(curve).collect();
        for (strand, curve) in side.strands.iter().zip(&curves) {
            self.draw(curve, strand.is_path);
        }
        for &vertex in &side.shown {
            for node in panel.dots(vertex) {
                let text = if is_written(&vertex) { &word(vertex).text } else { "•" };
                self.write(text, grid.place(panel.places[node]), 0);
            }
        }
        for &(node, fan, [from, to]) in panel.fans.iter().filter(|(_, fan, _)| is_written(fan)) {
            let way = direction((from + to) / 2.0) * FAN;
            self.write(&format!("*{}", word(fan).text), grid.place(panel.places[node]) + way, 6);
        }
        for (strand, curve) in side.strands.iter().zip(&curves) {
            for (item, forward) in strand.items.into_iter().zip([true, false]) {
                let Some(item) = item.filter(is_written) else { continue };
                let along = if forward { curve.clone() } else { curve.reversed() };
                let (middle, way) = along.at(along.length() / 2.0);
                let aside = left(way);
                let by = DVec2::new(aside.x * 3.0, aside.y * 1.1);
                self.write(&format!("{}{}", word(item).text, arrow(way)), middle + by, 6);
            }
            if let Some(edge) = strand.edge.filter(is_written) {
                let middle = curve.at(curve.length() / 2.0).0;
                self.write(&word(edge).text, middle, 3);
            }
        }
        for orbit in side.loops.iter().filter(|orbit| is_written(&orbit.face)) {
            let nodes = side.around(&orbit.darts);
            let around: Vec<_> = nodes.iter().map(|&node| panel.places[node]).collect();
            let middle = mean(&around);
            let low = curves.iter().flat_map(Curve::points).map(|at| at.y);
            let below = low.fold(0.0, f64::max) + 1.5;
            let middle = match panel.middle(orbit) {
                Some(middle) => grid.place(middle),
                // It is the outside.
                None => DVec2::new(grid.place(middle).x, below),
            };
            let text = &word(orbit.face).text;
            match orbit.kind {
                LoopKind::Hole => self.write(&format!("hole {text}"), middle, 12),
                _ => self.write(text, middle, 12),
            }
        }
    }

    fn index(&self, x: i64, y: i64) -> Option<usize> {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then_some((y * self.width + x) as usize)
    }

    fn draw(&mut self, curve: &Curve, is_path: bool) {
        let steps = (curve.length() * 4.0).clamp(1.0, 4000.0) as usize;
        // One mark per row in the middle of a slanted line, or it would be several characters
        // thick.
        let mut slanted: Option<(DVec2, char)> = None;
        let mut flat: Option<f64> = None;
        for step in 0..=steps {
            let (at, way) = curve.at(curve.length() * step as f64 / steps as f64);
            let slope = (way.y * 2.0).abs() / way.x.abs().max(1e-9);
            // A flat line changes rows in steps.
            let is_flat = slope <= 0.7;
            let is_step = flat.is_some_and(|row| row != at.y.round());
            flat = is_flat.then_some(at.y.round());
            let mark = match () {
                () if is_path => '·',
                () if is_flat && !is_step => '─',
                () if slope > 5.0 => '│',
                () if (way.x > 0.0) == (way.y > 0.0) => '╲',
                () => '╱',
            };
            let off = |at: DVec2| (at.y - at.y.round()).abs();
            let last = slanted.filter(|(last, _)| last.y.round() != at.y.round());
            if let Some((last, mark)) = last {
                self.mark(last, mark);
                slanted = None;
            }
            if is_flat {
                self.mark(at, mark);
            } else if slanted.is_none_or(|(best, _)| off(at) < off(best)) {
                slanted = Some((at, mark));
            }
        }
        if let Some((last, mark)) = slanted {
            self.mark(last, mark);
        }
    }

    fn mark(&mut self, at: DVec2, mark: char) {
        if let Some(cell) = self.index(at.x.round() as i64, at.y.round() as i64) {
            self.cells[cell] = mark;
        }
    }

    /// Writes a text centered at a place, or at the nearest free one up to `steps` away; further
    /// away if there is none.
    fn write(&mut self, text: &str, at: DVec2, steps: i64) {
        let length = text.chars().count() as i64;
        let (x, y) = (at.x.round() as i64 - length / 2, at.y.round() as i64);
        let mut best = None;
        for dy in -steps / 2..=steps / 2 {
            for dx in -steps..=steps {
                let cost = dx.abs() + 3 * dy.abs();
                let cells: Option<Vec<_>> =
                    (-1..=length).map(|step| self.index(x + dx + step, y + dy)).collect();
                let Some(cells) = cells else { continue };
                if cells.iter().any(|&cell| self.taken[cell]) {
                    continue;
                }
                let lines = cells.iter().filter(|&&cell| self.cells[cell] != ' ').count() as i64;
                let cost = cost + if steps > 3 { 8 * lines } else { 0 };
                if best.as_ref().is_none_or(|(other, _)| cost < *other) {
                    best = Some((cost, cells));
                }
            }
        }
        let Some((_, cells)) = best else {
            // A name must not be lost.
            if steps < 12 {
                self.write(text, at, steps + 3);
            }
            return;
        };
        if let (Some(&first), Some(&last)) = (cells.first(), cells.last()) {
            self.clear([first, last]);
        }
        for (letter, cell) in text.chars().zip(&cells[1..]) {
            self.cells[*cell] = letter;
            self.taken[*cell] = true;
        }
    }

    /// Removes line marks beside a name, so that they do not read as letters.
    fn clear(&mut self, sides: [usize; 2]) {
        for side in sides {
            if !self.taken[side] && self.cells[side] != '─' {
                self.cells[side] = ' ';
            }
        }
    }

    fn lines(&self) -> Vec<String> {
        let rows = self.cells.chunks(self.width.max(1) as usize);
        rows.map(|row| row.iter().collect::<String>().trim_end().to_string()).collect()
    }
}

/// The arrow character of a direction.
fn arrow(way: DVec2) -> char {
    let eighth = (way.y * 2.0).atan2(way.x) / std::f64::consts::FRAC_PI_4;
    let arrows = ['→', '↘', '↓', '↙', '←', '↖', '↑', '↗'];
    arrows[(eighth.round() as i64).rem_euclid(8) as usize]
}
