//! One side of a rule, drawn: first the lines, then the texts where the lines leave room.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::curve::{Curve, angle, direction, inside, left, turn};
use super::fan::fans;
use super::figure::{Dart, Figure, Node, Orbit, Side, Strand};
use super::hatch::{hatch, ticks};
use super::letters::{Label, name};
use super::room::{Room, Spot, reach};
use super::shape::{Group, Ink, Path, Stroke};
use super::status::Status;
use crate::diagram::{Kind, LoopKind, NameId};

/// How far a halfedge lies inside its face.
const ASIDE: f64 = 10.0;
/// The radius of a vertex.
const DOT: f64 = 4.5;
/// How far a fan reaches.
const FAN: f64 = 34.0;
/// The size of the letters.
pub(super) const LETTERS: f64 = 17.0;
const SMALL_LETTERS: f64 = 14.0;
/// How finely a face is searched for room.
const GRID: u32 = 24;

/// A side while it is drawn.
pub(super) struct Panel<'a> {
    figure: &'a Figure<'a>,
    side: &'a Side,
    is_after: bool,
    earlier: Vec<(usize, NameId, [f64; 2])>,
    places: &'a [DVec2],
    curves: Vec<Curve>,
    prefix: String,
    /// The fans at each node, and the angles they spread between.
    fans: Vec<(usize, NameId, [f64; 2])>,
    groups: Vec<Group>,
    texts: Vec<Text>,
    /// What is drawn where.
    pub room: Room,
}

/// A text that waits for its spot.
struct Text {
    group: usize,
    name: NameId,
    label: Label,
    spots: Vec<Spot>,
    ink: Ink,
    /// What it is set off with from the lines below it.
    ground: Option<Ink>,
}

impl<'a> Panel<'a> {
    /// Draws everything but the texts: `before`, or `after` an earlier panel.
    pub fn new(
        figure: &'a Figure<'a>,
        earlier: Option<&Panel>,
        places: &'a [DVec2],
        prefix: &str,
    ) -> Self {
        let is_after = earlier.is_some();
        let side = if is_after {
            &figure.after
        } else {
            &figure.before
        };
        let curve = |strand: &Strand| {
            let points: Vec<_> = strand.nodes.iter().map(|&node| places[node]).collect();
            Curve::smooth(&points)
        };
        let mut panel = Self {
            figure,
            side,
            is_after,
            earlier: earlier.map_or_else(Vec::new, |panel| panel.fans.clone()),
            places,
            curves: side.strands.iter().map(curve).collect(),
            prefix: format!("{prefix}{}", if is_after { "after" } else { "before" }),
            fans: Vec::new(),
            groups: Vec::new(),
            texts: Vec::new(),
            room: Room::default(),
        };
        panel.fans = panel.spread();
        for orbit in &side.loops {
            panel.face(orbit);
        }
        for at in 0..side.strands.len() {
            panel.strand(at);
        }
        for at in 0..side.strands.len() {
            panel.items(at);
        }
        panel.draw_fans();
        panel
    }

    /// The vertices it shows.
    pub fn shown(&self) -> &'a [NameId] {
        &self.side.shown
    }

    /// The place of a vertex.
    pub fn place(&self, vertex: NameId) -> DVec2 {
        self.figure
            .vertex(vertex)
            .map_or(DVec2::ZERO, |node| self.places[node])
    }

    /// How many pairs of strands cross.
    pub fn crossings(&self) -> usize {
        let mut count = 0;
        for (at, curve) in self.curves.iter().enumerate() {
            for other in &self.curves[..at] {
                let crosses = |a| other.segments().any(|b| super::curve::cross(a, b));
                count += usize::from(curve.segments().any(crosses));
            }
        }
        count
    }

    /// The directions in which strands leave a node.
    pub fn directions(&self, node: usize) -> Vec<f64> {
        let mut angles = Vec::new();
        for (strand, curve) in self.side.strands.iter().zip(&self.curves) {
            let [from, to] = strand.ends();
            if from == node {
                angles.push(angle(curve.start_direction()));
            }
            if to == node {
                angles.push(angle(-curve.end_direction()));
            }
        }
        angles
    }

    /// Puts the texts, the vertices' at their places, and hands out what was drawn.
    pub fn finish(mut self, vertices: &[(NameId, Label, DVec2)]) -> (Vec<Group>, Room) {
        for &(vertex, ref label, at) in vertices {
            if self.side.shown.contains(&vertex) {
                self.vertex(vertex, label, at);
            }
        }
        let mut texts = std::mem::take(&mut self.texts);
        // Those with the fewest places to go come first.
        texts.sort_by_key(|text| text.spots.len());
        for text in texts {
            let at = self.room.best(text.label.half, &text.spots);
            let word = self.figure.drawing.rule.name(text.name).text.clone();
            self.room.put(&word, &text.label, at);
            let group = &mut self.groups[text.group];
            if let Some(ground) = text.ground {
                let halo = Stroke::solid(ground, 8.0);
                group.stroke(text.label.path.moved(at), halo);
            }
            group.fill(text.label.path.moved(at), text.ink);
        }
        (self.groups, self.room)
    }

    fn status(&self, name: NameId) -> Status {
        Status::of(&self.figure.drawing, name)
    }

    fn group(&mut self, name: NameId) -> usize {
        let of = self.figure.drawing.rule.name(name);
        let status = self.status(name).word();
        let id = if of.named {
            format!("{}-{}", self.prefix, id_word(&of.text))
        } else {
            String::new()
        };
        let title = format!("{} {}, {status}", of.kind.word(), of.text);
        self.groups.push(Group::named(id, title));
        self.groups.len() - 1
    }

    fn text(&mut self, group: usize, of: NameId, size: f64, spots: impl Fn(&Label) -> Vec<Spot>) {
        let word = self.figure.drawing.rule.name(of);
        if !word.named {
            return;
        }
        let label = name(&word.text, size);
        let spots = spots(&label);
        self.texts.push(Text {
            group,
            name: of,
            label,
            spots,
            ink: Ink::Of(self.status(of)),
            ground: (word.kind == Kind::Edge).then(|| self.ground(of)),
        });
    }

    /// What lies on both sides of an edge.
    fn ground(&self, edge: NameId) -> Ink {
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

    fn along(&self, dart: Dart) -> Curve {
        let curve = &self.curves[dart.strand];
        if dart.forward {
            curve.clone()
        } else {
            curve.reversed()
        }
    }

    fn face(&mut self, orbit: &Orbit) {
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

    /// The line of an edge or path, and the name of the edge.
    fn strand(&mut self, at: usize) {
        let strand = &self.side.strands[at];
        let curve = self.curves[at].clone();
        let Some(of) = strand.edge.or(strand.items[0]) else {
            return;
        };
        let status = match strand.edge {
            Some(edge) => self.status(edge),
            // An edge that is not drawn itself is what its halfedge is, new or erased; else
            // nothing is said of it.
            None => match self.status(of) {
                Status::Reassigned if !strand.is_path => Status::Kept,
                status => status,
            },
        };
        let line = if strand.is_path {
            curve.waved(2.4, 15.0)
        } else {
            curve.clone()
        };
        let group = match strand.edge {
            Some(edge) => self.group(edge),
            None => {
                self.groups.push(Group::default());
                self.groups.len() - 1
            }
        };
        let width = if strand.is_path { 1.2 } else { 1.7 };
        draw(&mut self.groups[group], &line, status, width);
        self.room
            .draw(&curve, if strand.is_path { 4.0 } else { 1.5 });
        if let Some(edge) = strand.edge {
            let length = curve.length();
            self.text(group, edge, SMALL_LETTERS, |_| {
                let parts = [0.5, 0.44, 0.56, 0.38, 0.62, 0.32, 0.68, 0.26, 0.74];
                let spot = |(place, part): (usize, f64)| Spot {
                    at: curve.at(length * part).0,
                    cost: 3.0 * place as f64,
                };
                parts.into_iter().enumerate().map(spot).collect()
            });
        }
    }

    /// The halfedges or paths along a strand.
    fn items(&mut self, at: usize) {
        let strand = &self.side.strands[at];
        let pairs: Vec<_> = strand.items.into_iter().zip([true, false]).collect();
        for (item, forward) in pairs {
            let Some(item) = item else { continue };
            let dart = Dart {
                strand: at,
                forward,
            };
            let curve = self.along(dart);
            let [start, end] = self.trims(dart);
            let length = curve.length();
            let aside = if strand.is_path { ASIDE + 2.5 } else { ASIDE };
            let (start, end) = if start + end > length - 12.0 {
                (length * 0.3, length * 0.3)
            } else {
                (start, end)
            };
            let arrow = curve.cut(start, length - end).offset(aside);
            let group = self.group(item);
            let status = self.status(item);
            if strand.is_path {
                double_arrow(&mut self.groups[group], &arrow, status);
            } else {
                harpoon(&mut self.groups[group], &arrow, status);
            }
            self.room.draw(&arrow, 2.5);
            self.text(group, item, LETTERS, |label| beside(&arrow, label));
        }
    }

    /// How much of a dart is left out at its ends, so that it keeps clear of its neighbours.
    fn trims(&self, dart: Dart) -> [f64; 2] {
        let orbit = self.side.loops.iter().find_map(|orbit| {
            let at = orbit.darts.iter().position(|other| *other == dart)?;
            Some((orbit, at))
        });
        let Some((orbit, at)) = orbit else {
            return self.outer_trims(dart);
        };
        let count = orbit.darts.len();
        let neighbor = |step: usize| self.along(orbit.darts[(at + step) % count]);
        let (here, before, behind) = (self.along(dart), neighbor(count - 1), neighbor(1));
        let corner = |into: DVec2, out: DVec2| clear(turn(angle(out), angle(-into)));
        [
            corner(before.end_direction(), here.start_direction()) + 5.0,
            corner(here.end_direction(), behind.start_direction()) + 5.0,
        ]
    }

    /// The same for a halfedge outside of all loops: up to the next spoke on its left.
    fn outer_trims(&self, dart: Dart) -> [f64; 2] {
        let curve = self.along(dart);
        let nodes = self.side.nodes(dart);
        let (start, end) = (
            angle(curve.start_direction()),
            angle(-curve.end_direction()),
        );
        let trim = |node: usize, open: &dyn Fn(f64) -> f64| {
            let angles = self.directions(node);
            let gap = angles.into_iter().map(open).fold(TAU, f64::min);
            let mut fans = self.fans.iter().filter(|(at, ..)| *at == node);
            let fan = fans.any(|(_, _, [from, to])| open((from + to) / 2.0) < gap && gap < PI);
            clear(gap).max(if fan { FAN } else { 10.0 }) + 5.0
        };
        [
            trim(nodes[0], &|other| turn(start, other)),
            trim(nodes[nodes.len() - 1], &|other| turn(other, end)),
        ]
    }

    /// Where the fans spread; one that has been drawn before, as near to there as may be.
    fn spread(&self) -> Vec<(usize, NameId, [f64; 2])> {
        let view = if self.is_after {
            &self.figure.drawing.after
        } else {
            &self.figure.drawing.before
        };
        let mut all = Vec::new();
        for star in &view.side().stars {
            let Some(node) = self.figure.vertex(star.vertex.name) else {
                continue;
            };
            let spoke = |name: NameId| {
                let dart = self.side.darts[name.index()]?;
                Some(angle(self.along(dart).start_direction()))
            };
            let wish = |fan: NameId| {
                let mut earlier = self.earlier.iter();
                let (_, _, [from, to]) = earlier.find(|(_, name, _)| *name == fan)?;
                Some((from + to) / 2.0)
            };
            let fans = fans(star, &self.directions(node), spoke, wish);
            all.extend(fans.into_iter().map(|(fan, sector)| (node, fan, sector)));
        }
        all
    }

    fn draw_fans(&mut self) {
        for (node, fan, [from, to]) in self.fans.clone() {
            let center = self.places[node];
            let status = self.status(fan);
            let group = self.group(fan);
            let stubs = ((to - from) / 0.5).round().clamp(2.0, 5.0) as usize;
            for stub in 0..=stubs {
                let angle = from + (to - from) * stub as f64 / stubs as f64;
                let way = direction(angle);
                let line = Curve::through([center + way * 9.0, center + way * FAN]);
                let mut stroke = stroke(status, 1.2);
                stroke.dash = None;
                self.groups[group].stroke(Path::along(&line), stroke);
                self.room.draw(&line, 1.0);
            }
            let arc = Curve::arc(center, FAN * 0.66, from - 0.12, to + 0.12);
            let mut band = stroke(status, 6.0);
            band.opacity = 0.4;
            band.dash = None;
            self.groups[group].stroke(Path::along(&arc), band);
            self.room.draw(&arc, 3.0);
            self.fan_name(group, fan, center, (from + to) / 2.0);
        }
    }

    /// The name of a fan; it comes before all others, since it has but one place.
    fn fan_name(&mut self, group: usize, fan: NameId, center: DVec2, middle: f64) {
        let word = self.figure.drawing.rule.name(fan);
        if !word.named {
            return;
        }
        let label = name(&word.text, LETTERS);
        let spot = |step: usize| {
            let sign = if step.is_multiple_of(2) { 1.0 } else { -1.0 };
            let way = direction(middle + sign * 0.1 * step.div_ceil(2) as f64);
            Spot {
                at: center + way * (FAN + 6.0 + reach(label.half, way)),
                cost: step as f64,
            }
        };
        let at = self
            .room
            .best(label.half, &(0..16).map(spot).collect::<Vec<_>>());
        self.room.put(&word.text, &label, at);
        let ink = Ink::Of(self.status(fan));
        self.groups[group].fill(label.path.moved(at), ink);
    }

    fn vertex(&mut self, vertex: NameId, label: &Label, at: DVec2) {
        let place = self.place(vertex);
        let status = self.status(vertex);
        let ink = Ink::Of(status);
        let index = self.group(vertex);
        let group = &mut self.groups[index];
        match status {
            Status::Kept | Status::Reassigned => group.fill(Path::circle(place, DOT), ink),
            Status::New => {
                let mut halo = Stroke::solid(ink, 8.0);
                halo.opacity = 0.22;
                group.stroke(Path::circle(place, DOT), halo);
                group.fill(Path::circle(place, DOT), ink);
            }
            Status::Erased => {
                group.fill(Path::circle(place, DOT), Ink::Paper);
                group.stroke(Path::circle(place, DOT), Stroke::solid(ink, 1.8));
                for way in [DVec2::ONE, DVec2::new(1.0, -1.0)] {
                    let line = Curve::through([place - way * 3.0, place + way * 3.0]);
                    group.stroke(Path::along(&line), Stroke::solid(ink, 1.6));
                }
            }
        }
        group.fill(label.path.moved(at), ink);
        let word = self.figure.drawing.rule.name(vertex).text.clone();
        self.room.put(&word, label, at);
    }

    /// Dots of ends that have no name.
    pub fn loose(&self) -> Vec<DVec2> {
        let strands = self.side.strands.iter().flat_map(Strand::ends);
        let loose = strands.filter(|&end| self.figure.nodes[end] == Node::Loose);
        loose.map(|end| self.places[end]).collect()
    }
}

/// How much of two halfedges is left out at a corner that is open so wide.
fn clear(open: f64) -> f64 {
    let trim = if open < PI {
        (ASIDE + 1.0) / (open / 2.0).tan()
    } else {
        0.0
    };
    trim.clamp(7.0, 60.0)
}

/// Twice the area of a polygon, positive if it runs counterclockwise.
fn area(outline: &[DVec2]) -> f64 {
    let count = outline.len();
    let pieces = (0..count).map(|at| outline[(at + 1) % count].perp_dot(outline[at]));
    pieces.sum()
}

/// The line with which something is drawn.
fn stroke(status: Status, width: f64) -> Stroke {
    let mut stroke = Stroke::solid(Ink::Of(status), width);
    match status {
        Status::Kept => stroke.width = width * 0.8,
        Status::Reassigned | Status::New => stroke.width = width * 1.2,
        Status::Erased => stroke.dash = Some([width * 2.4, width * 2.8]),
    }
    stroke
}

/// Draws a line; what is new as with a marker behind it.
pub(super) fn draw(group: &mut Group, curve: &Curve, status: Status, width: f64) {
    if status == Status::New {
        let mut band = Stroke::solid(Ink::Of(status), width + 5.0);
        band.opacity = 0.17;
        group.stroke(Path::along(curve), band);
    }
    group.stroke(Path::along(curve), stroke(status, width));
}

/// A halfedge: a line with half an arrowhead, on the side of its face.
pub(super) fn harpoon(group: &mut Group, curve: &Curve, status: Status) {
    draw(group, curve, status, 1.6);
    let tip = curve.at(f64::MAX).0;
    let way = curve.end_direction();
    let base = tip - way * 10.0;
    let corners = [tip + way * 1.5, base + left(way) * 5.5, base + way * 2.5];
    group.fill(Path::around(&corners), Ink::Of(status));
}

/// A path: a double line with an open arrowhead.
fn double_arrow(group: &mut Group, curve: &Curve, status: Status) {
    let length = curve.length();
    let shaft = curve.cut(0.0, length - 4.0);
    for aside in [1.9, -1.9] {
        draw(group, &shaft.offset(aside), status, 1.2);
    }
    let (tip, way) = curve.at(f64::MAX);
    let head = [1.0, -1.0].map(|sign| tip - way * 7.5 + left(way) * (5.5 * sign));
    let mut stroke = stroke(status, 1.5);
    stroke.dash = None;
    group.stroke(
        Path::along(&Curve::through([head[0], tip, head[1]])),
        stroke,
    );
}

/// The spots beside an arrow, inside before outside.
fn beside(arrow: &Curve, label: &Label) -> Vec<Spot> {
    let length = arrow.length();
    let mut spots = Vec::new();
    for (place, part) in [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82]
        .into_iter()
        .enumerate()
    {
        let (at, way) = arrow.at(length * part);
        let aside = left(way);
        for (far, gap) in [5.0, 8.0, 12.0, 20.0].into_iter().enumerate() {
            // The support of the box, so that a slanted line does not touch its corner.
            let clear = label.half.x * aside.x.abs() + label.half.y * aside.y.abs();
            let clear = clear.min(reach(label.half, aside) + 4.0);
            spots.push(Spot {
                at: at + aside * (clear + gap - 2.0),
                cost: 2.0 * place as f64 + 4.0 * far as f64,
            });
        }
    }
    spots
}

/// Points inside a polygon, and how far each is from its sides.
fn inner_points(outline: &[DVec2]) -> Vec<(DVec2, f64)> {
    let (low, high) = outline.iter().fold(
        (DVec2::splat(f64::MAX), DVec2::splat(f64::MIN)),
        |(low, high), &at| (low.min(at), high.max(at)),
    );
    let sides = (0..outline.len()).map(|i| [outline[i], outline[(i + 1) % outline.len()]]);
    let sides: Vec<_> = sides.collect();
    let room = |at: DVec2| {
        let far = sides.iter().map(|side| super::curve::distance(at, *side));
        far.fold(f64::MAX, f64::min)
    };
    let steps = 1..GRID;
    let points = steps
        .clone()
        .flat_map(|row| steps.clone().map(move |column| (column, row)));
    points
        .map(|(column, row)| {
            low + (high - low) * DVec2::new(column.into(), row.into()) / f64::from(GRID)
        })
        .filter(|&at| inside(at, outline))
        .map(|at| (at, room(at)))
        .collect()
}

/// The radius of the widest circle inside a polygon, about.
pub(super) fn widest_circle(outline: &[DVec2]) -> f64 {
    let points = inner_points(outline).into_iter();
    points.map(|(_, room)| room).fold(0.0, f64::max)
}

/// Spots inside a polygon, those with most room first.
fn inner_spots(outline: &[DVec2]) -> Vec<Spot> {
    let points = inner_points(outline);
    let most = points.iter().map(|(_, room)| *room).fold(0.0, f64::max);
    let good = points.iter().filter(|(_, room)| *room > most - 1.0);
    let good: Vec<_> = good.map(|(at, _)| *at).collect();
    let center = good.iter().copied().sum::<DVec2>() / good.len().max(1) as f64;
    let mut all = vec![Spot {
        at: center,
        cost: 0.0,
    }];
    all.extend(points.into_iter().map(|(at, room)| Spot {
        at,
        cost: 1.0 + (most - room) * 0.5 + (at - center).length() * 0.2,
    }));
    all
}

/// The middle of the widest gap between directions.
pub(super) fn widest_gap(angles: &[f64]) -> f64 {
    let mut best = (0.0, PI / 2.0);
    for &from in angles {
        let gap = angles.iter().map(|&to| turn(from, to)).fold(TAU, f64::min);
        if gap > best.0 + 1e-6 {
            best = (gap, from + gap / 2.0);
        }
    }
    best.1
}

/// The radius that keeps a text off a vertex.
pub(super) fn beyond_dot(label: &Label, way: DVec2) -> f64 {
    DOT + 5.0 + reach(label.half, way)
}

/// A name as a part of an id: `h'` and `h[2]` become `h-prime` and `h-2`.
fn id_word(text: &str) -> String {
    text.replace('\'', "-prime")
        .replace('[', "-")
        .replace(']', "")
}
