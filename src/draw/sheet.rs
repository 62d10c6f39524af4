//! A whole operation on one sheet: a row for each rule, before and after side by side.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use glam::DVec2;

use super::arrows::harpoon;
use super::curve::{Curve, direction};
use super::figure::{Figure, Node};
use super::label_boxes::{Room, Spot};
use super::label_positions::{beyond_dot, widest_circle, widest_gap};
use super::layout::places;
use super::letters::{Label, Style, name, words};
use super::panel::{LETTERS, Panel};
use super::shape::{Group, Ink, Path, Picture, Step, Stroke, TextBox};
use super::status::Status;
use crate::diagram::{Drawing, Kind, NameId, Op, Rule};

/// The margin around everything, and the minimum and maximum gap between the two sides.
const MARGIN: f64 = 26.0;
const BETWEEN: f64 = 112.0;
const MOST_BETWEEN: f64 = 260.0;
/// The size of captions.
const CAPTION: f64 = 15.0;
/// How much cheaper a separate place on each side must be than one on both, for a name to have two.
const APART: f64 = 14.0;
/// The factor by which a figure with overlapping texts is enlarged, and the maximum number of
/// times.
const GROWTH: f64 = 1.15;
const TRIES: usize = 8;

/// The distance from the captions to the verdict on a counterexample.
const VERDICT: f64 = 30.0;

/// The gap between two columns, and the minimum number of rules for two columns.
const GUTTER: f64 = 84.0;
const MANY: usize = 4;

/// Draws an operation, its rules one below the other.
pub fn draw_op(op: &Op) -> Picture {
    drawn(op, 1)
}

/// Draws an operation for a slide or a sheet of its own, with many rules in two columns.
pub fn draw_sheet(op: &Op) -> Picture {
    drawn(op, if op.rules.len() < MANY { 1 } else { 2 })
}

fn drawn(op: &Op, columns: usize) -> Picture {
    let labelled = op.rules.len() > 1;
    let row = |(at, rule): (usize, &Rule)| {
        let number = (at + 1).to_string();
        let label = rule.label.clone().or(labelled.then_some(number));
        let prefix = match &label {
            Some(label) => format!("{}-{label}-", op.name),
            None => format!("{}-", op.name),
        };
        let below = match &rule.example {
            Some(of) => vec!["for example,".to_string(), format!("on {}", of.mesh)],
            None => label.into_iter().collect(),
        };
        (below, Row::new(rule, &prefix))
    };
    let rows: Vec<(Vec<String>, Row)> = op.rules.iter().enumerate().map(row).collect();
    let mut sheet = Sheet::new(&op.name);
    for (below, _) in &rows {
        let above = words(&op.name, Style::Italic, LETTERS).half.x;
        let below = below.iter().map(|line| words(line, Style::Upright, CAPTION).half.x);
        let widest = below.fold(above, f64::max);
        sheet.between = sheet.between.max((2.0 * widest + 30.0).min(MOST_BETWEEN));
    }
    sheet.widths =
        [0, 1].map(|side| rows.iter().map(|(_, row)| row.sides[side].width()).fold(90.0, f64::max));
    sheet.columns = columns;
    let mut rows = rows.into_iter();
    loop {
        let beside: Vec<_> = rows.by_ref().take(columns).collect();
        if beside.is_empty() {
            return sheet.finish();
        }
        let height = beside.iter().map(|(_, row)| row.high - row.low).fold(0.0, f64::max);
        let has_verdict = beside.iter().any(|(_, row)| row.verdict.is_some());
        for (column, (below, row)) in beside.into_iter().enumerate() {
            let left = MARGIN + column as f64 * (sheet.column() + GUTTER);
            // Rows beside each other are centered at the same height.
            let top = sheet.y + (height - (row.high - row.low)) / 2.0;
            if column > 0 {
                let x = left - GUTTER / 2.0;
                sheet.divide(DVec2::new(x, sheet.y), DVec2::new(x, sheet.y + height + 24.0));
            }
            sheet.row(&op.name, &below, row, DVec2::new(left, top));
        }
        sheet.y += height + if has_verdict { 64.0 + VERDICT } else { 64.0 };
    }
}

/// The drawn side of a rule, and its bounds.
struct DrawnSide {
    groups: Vec<Group>,
    texts: Vec<TextBox>,
    low: DVec2,
    high: DVec2,
}

impl DrawnSide {
    fn width(&self) -> f64 {
        self.high.x - self.low.x
    }
}

/// The two sides of a rule, at the same heights.
struct Row {
    sides: [DrawnSide; 2],
    low: f64,
    high: f64,
    statuses: BTreeSet<Status>,
    crossings: usize,
    is_tidy: bool,
    /// The way in which it breaks a mesh, if it is a counterexample.
    verdict: Option<String>,
}

impl Row {
    fn new(rule: &Rule, prefix: &str) -> Self {
        let rule = rule.to_draw();
        let figure = Figure::new(Drawing::new(&rule));
        let unit = places(&figure);
        let mut scale = scale(&figure, &unit);
        let first = Self::drawn(&figure, &unit, scale, prefix);
        if first.is_tidy {
            return first;
        }
        let mut rows = (0..TRIES).map(|_| {
            scale *= GROWTH;
            Self::drawn(&figure, &unit, scale, prefix)
        });
        // What no size makes tidy stays small.
        rows.find(|row| row.is_tidy).unwrap_or(first)
    }

    fn drawn(figure: &Figure, unit: &[Vec<DVec2>; 2], scale: f64, prefix: &str) -> Self {
        let scaled = |unit: &Vec<DVec2>| unit.iter().map(|&at| at * scale).collect::<Vec<_>>();
        let places = unit.each_ref().map(scaled);
        let before = Panel::new(figure, None, &places[0], prefix);
        let after = Panel::new(figure, Some(&before), &places[1], prefix);
        let panels = [before, after];
        let crossings = panels.iter().map(Panel::crossings).sum();
        let labels = vertex_labels(figure, &panels);
        let rule = figure.drawing.rule;
        let statuses = rule.ids().map(|name| Status::of(&figure.drawing, name)).collect();
        let mut is_tidy = true;
        let sides = panels.map(|panel| {
            let loose = panel.loose();
            let (mut groups, room) = panel.finish(&labels);
            let mut dots = Group::default();
            for at in loose {
                dots.fill(Path::circle(at, 2.5), Ink::Muted);
            }
            if !dots.shapes.is_empty() {
                groups.push(dots);
            }
            is_tidy &= room.is_tidy();
            let (low, high) = bounds(&groups, &room).unwrap_or_default();
            DrawnSide { groups, texts: room.texts, low, high }
        });
        // An empty side has no height of its own.
        let seen = sides.iter().filter(|side| side.low != side.high);
        let low = seen.clone().map(|side| side.low.y).reduce(f64::min).unwrap_or(0.0);
        let high = seen.map(|side| side.high.y).reduce(f64::max).unwrap_or(0.0);
        let verdict = rule.broken.as_ref().map(|broken| broken.verdict.replace('`', ""));
        Self { sides, low, high, statuses, crossings, is_tidy, verdict }
    }
}

/// The names of the vertices, with their places on both sides: the same on both, unless the vertex
/// moves or something is in the way.
fn vertex_labels(figure: &Figure, panels: &[Panel; 2]) -> Vec<(usize, Label, [DVec2; 2])> {
    let rule = figure.drawing.rule;
    let mut rooms = [panels[0].room.clone(), panels[1].room.clone()];
    let mut labels = Vec::new();
    for (node, of) in figure.nodes.iter().enumerate() {
        let Node::Vertex(vertex) = *of else { continue };
        let shown = [0, 1].map(|side| panels[side].dots(vertex).contains(&node));
        let is_named = rule.name(vertex).named && panels[0].stands_out(vertex);
        if shown == [false, false] || !is_named {
            continue;
        }
        let directions: Vec<_> = panels.iter().flat_map(|panel| panel.directions(node)).collect();
        let wanted = widest_gap(&directions);
        let word = &rule.name(vertex).text;
        let label = name(word, LETTERS);
        let centers = [0, 1].map(|side| panels[side].places[node]);
        let best = |sides: &[usize], wanted: f64| {
            let center = centers[sides[0]];
            let spot = |step: usize, far: f64| {
                let way = direction(wanted + TAU * step as f64 / 48.0);
                let at = center + way * (beyond_dot(&label, way) + far);
                let costs = sides.iter().map(|&side| rooms[side].cost(at, &label));
                let turn = step.min(48 - step) as f64;
                let cost = costs.sum::<f64>() + turn + far * 1.2;
                Spot { at, cost }
            };
            let spots = [0.0, 6.0, 14.0, 24.0, 36.0].into_iter();
            let spots = spots.flat_map(|far| (0..48).map(move |step| spot(step, far)));
            Room::default().best(&label, &spots.collect::<Vec<_>>())
        };
        let sides: Vec<_> = (0..2).filter(|&side| shown[side]).collect();
        let common = best(&sides, wanted);
        let mut at = [common.at; 2];
        if sides.len() == 2 {
            let has_moved = centers[0] != centers[1];
            let alone = [0, 1].map(|side| {
                let directions = panels[side].directions(node);
                best(&[side], widest_gap(&directions))
            });
            let worst = alone.iter().map(|spot| spot.cost).fold(0.0, f64::max);
            if has_moved || common.cost > worst + APART {
                at = alone.map(|spot| spot.at);
            }
        }
        for side in sides {
            rooms[side].put(word, &label, at[side]);
        }
        labels.push((node, label, at));
    }
    labels
}

/// The room that a name needs beyond that of a short one; a subscript does not count.
fn excess(rule: &Rule, name: NameId) -> f64 {
    const SHORT: usize = 3;
    const LONG: usize = 20;
    const LETTER: f64 = 8.5;
    let name = rule.name(name);
    let letters = name.text.chars().take_while(|&letter| letter != '[').count().min(LONG);
    if name.named { letters.saturating_sub(SHORT) as f64 * LETTER } else { 0.0 }
}

/// The scale in picture units per radius of the figure: edges become long enough, and faces wide
/// enough, for arrows and names.
fn scale(figure: &Figure, places: &[Vec<DVec2>; 2]) -> f64 {
    let rule = figure.drawing.rule;
    let mut scale: f64 = 128.0;
    let is_named = |name: NameId| rule.name(name).named;
    let longest = |names: &mut dyn Iterator<Item = NameId>| {
        names.map(|name| excess(rule, name)).fold(0.0, f64::max)
    };
    let mut want = |wanted: f64, length: f64| {
        if length > 0.05 {
            scale = scale.max(wanted / length);
        }
    };
    for (side, places) in [&figure.before, &figure.after].into_iter().zip(places) {
        for strand in &side.strands {
            let pairs = strand.nodes.windows(2);
            let lengths = pairs.map(|pair| (places[pair[0]] - places[pair[1]]).length());
            let names = || strand.items.iter().flatten().copied().chain(strand.edge);
            let named = names().any(is_named);
            want(if named { 122.0 } else { 76.0 } + longest(&mut names()), lengths.sum());
        }
        for orbit in &side.loops {
            let outline = orbit.darts.iter().flat_map(|dart| {
                let nodes = side.nodes(*dart).into_iter();
                let curve = Curve::smooth(&nodes.map(|node| places[node]).collect::<Vec<_>>());
                let points = curve.points();
                // A few points along a curve give its shape.
                let step = (points.len() / 6).max(1);
                points[..points.len() - 1].iter().copied().step_by(step).collect::<Vec<_>>()
            });
            let strands = || orbit.darts.iter().map(|dart| &side.strands[dart.strand]);
            let wide = match strands().any(|strand| strand.is_path) {
                _ if !is_named(orbit.face) => 30.0,
                true => 43.0,
                false => 52.0,
            };
            let items = strands().flat_map(|strand| strand.items.iter().flatten().copied());
            let wide = wide + longest(&mut items.chain([orbit.face])) / 2.0;
            want(wide, widest_circle(&outline.collect::<Vec<_>>()));
        }
    }
    // Only one sector of a family has names; the others may be narrow.
    let most = if rule.size().is_some() { 250.0 } else { 320.0 };
    // Vertices have their names outside.
    scale.min(most + 2.0 * longest(&mut rule.ids().filter(|&name| rule.kind(name) != Kind::Vertex)))
}

/// The corners of the box around everything that is drawn.
fn bounds(groups: &[Group], room: &Room) -> Option<(DVec2, DVec2)> {
    let steps = groups.iter().flat_map(|group| &group.shapes).flat_map(|shape| &shape.path.steps);
    let points = steps.flat_map(|step| match *step {
        Step::Move(to) | Step::Line(to) => [to, to],
        Step::Curve(by, to) => [by, to],
        Step::Close => [DVec2::NAN; 2],
    });
    let boxes = room.texts.iter().flat_map(|text| [text.from.into(), text.to.into()]);
    points.chain(boxes).filter(|at: &DVec2| !at.is_nan()).fold(None, |all, at| {
        let (low, high) = all.unwrap_or((at, at));
        Some((low.min(at), high.max(at)))
    })
}

struct Sheet {
    picture: Picture,
    /// The widths of the two sides, and of the gap between them.
    widths: [f64; 2],
    between: f64,
    columns: usize,
    y: f64,
    statuses: BTreeSet<Status>,
}

impl Sheet {
    fn new(title: &str) -> Self {
        Self {
            picture: Picture { title: title.to_string(), ..Picture::default() },
            widths: [0.0; 2],
            between: BETWEEN,
            columns: 1,
            y: MARGIN,
            statuses: BTreeSet::new(),
        }
    }

    /// The width of a column.
    fn column(&self) -> f64 {
        self.widths[0] + self.between + self.widths[1]
    }

    fn row(&mut self, op: &str, below: &[String], row: Row, at: DVec2) {
        let height = row.high - row.low;
        let middle = at.y + height / 2.0;
        let mut left = at.x;
        for (side, half) in row.sides.into_iter().enumerate() {
            let center = left + self.widths[side] / 2.0;
            left += self.widths[side] + self.between;
            if half.low == half.high {
                let at = DVec2::new(center, middle);
                self.words("nothing", Style::Italic, CAPTION, Ink::Muted, at);
            }
            let caption = ["before", "after"][side];
            let caption_at = DVec2::new(center, at.y + height + 24.0);
            self.words(caption, Style::Upright, CAPTION, Ink::Muted, caption_at);
            let by = DVec2::new(center - half.low.midpoint(half.high).x, at.y - row.low);
            self.picture.groups.extend(half.groups.into_iter().map(|group| group.moved(by)));
            let moved = |text: TextBox| TextBox {
                from: (DVec2::from(text.from) + by).to_array(),
                to: (DVec2::from(text.to) + by).to_array(),
                ..text
            };
            self.picture.texts.extend(half.texts.into_iter().map(moved));
        }
        let from = at.x + self.widths[0] + 24.0;
        let to = from + self.between - 48.0;
        self.arrow(DVec2::new(from, middle), DVec2::new(to, middle));
        let center = (from + to) / 2.0;
        let above = DVec2::new(center, middle - 20.0);
        self.words(op, Style::Italic, LETTERS, Ink::Of(Status::Kept), above);
        for (nth, line) in below.iter().enumerate() {
            let at = DVec2::new(center, middle + 21.0 + 19.0 * nth as f64);
            self.words(line, Style::Upright, CAPTION, Ink::Muted, at);
        }
        if let Some(verdict) = row.verdict {
            let width = self.column();
            let at = DVec2::new(at.x + width / 2.0, at.y + height + 24.0 + VERDICT);
            self.words_within(
                width,
                &verdict,
                (Style::Upright, CAPTION),
                Ink::Of(Status::Kept),
                at,
            );
        }
        self.picture.crossings += row.crossings;
        self.statuses.extend(row.statuses);
    }

    /// A thin line between two columns.
    fn divide(&mut self, from: DVec2, to: DVec2) {
        let mut stroke = Stroke::solid(Ink::Muted, 0.9);
        stroke.opacity = 0.4;
        let mut group = Group::default();
        group.stroke(Path::along(&Curve::through([from, to])), stroke);
        self.picture.groups.push(group);
    }

    /// Writes words that fit between the figures.
    fn words(&mut self, text: &str, style: Style, size: f64, ink: Ink, at: DVec2) {
        self.words_within(self.between, text, (style, size), ink, at);
    }

    /// Writes words; what is wider than `room` is made smaller, so that it does not cover the
    /// figures.
    fn words_within(
        &mut self,
        room: f64,
        text: &str,
        (style, size): (Style, f64),
        ink: Ink,
        at: DVec2,
    ) {
        let mut label = words(text, style, size);
        let most = room / 2.0 - 6.0;
        if label.half.x > most {
            label = words(text, style, size * most / label.half.x);
        }
        let mut group = Group::default();
        group.write(&label, at, ink);
        self.picture.groups.push(group);
        self.picture.texts.push(TextBox {
            text: text.to_string(),
            from: (at - label.half).to_array(),
            to: (at + label.half).to_array(),
        });
    }

    fn arrow(&mut self, from: DVec2, to: DVec2) {
        let ink = Ink::Of(Status::Kept);
        let mut group = Group::default();
        for aside in [-2.6, 2.6] {
            let by = DVec2::Y * aside;
            let line = Curve::through([from + by, to - DVec2::X * 5.0 + by]);
            group.stroke(Path::along(&line), Stroke::solid(ink, 1.6));
        }
        let back = [-1.0, 1.0].map(|sign| to + DVec2::new(-9.0, 8.0 * sign));
        group.stroke(Path::along(&Curve::through([back[0], to, back[1]])), Stroke::solid(ink, 1.6));
        self.picture.groups.push(group);
    }

    /// Adds the legend and sets the size.
    fn finish(mut self) -> Picture {
        let columns = self.columns as f64;
        let width = columns * self.column() + (columns - 1.0) * GUTTER;
        let statuses: Vec<_> =
            Status::ALL.into_iter().filter(|status| self.statuses.contains(status)).collect();
        let label = |status: Status| (status, words(status.word(), Style::Upright, CAPTION));
        let labels: Vec<_> = statuses.into_iter().map(label).collect();
        let widths = labels.iter().map(|(_, label)| 2.0 * label.half.x + 38.0 + 30.0);
        let mut x = MARGIN + (width - widths.sum::<f64>() + 30.0) / 2.0;
        for (status, label) in labels {
            let at = DVec2::new(x, self.y);
            let mut group = Group::default();
            let line = Curve::through([at, at + DVec2::X * 30.0]);
            harpoon(&mut group, &line, status);
            self.picture.groups.push(group);
            let middle = at + DVec2::new(38.0 + label.half.x, 0.0);
            self.words(status.word(), Style::Upright, CAPTION, Ink::Muted, middle);
            x += 38.0 + 2.0 * label.half.x + 30.0;
        }
        self.picture.size = DVec2::new(width + 2.0 * MARGIN, self.y + 22.0);
        self.picture
    }
}
