//! Drawing of one side of a rule: first the lines, then the texts where the lines leave room.
//!
//! The kinds of elements have modules of their own: [`faces`](super::faces),
//! [`strands`](super::strands) and [`stars`](super::stars).

use glam::DVec2;

use super::curve::{Curve, angle, crossings, distance, sides};
use super::family_sector::sector;
use super::figure::{Dart, Figure, Node, Side, Strand};
use super::label_boxes::{Room, Spot};
use super::letters::{Label, name};
use super::shape::{Group, Ink, Path};
use super::status::Status;
use crate::diagram::{Kind, NameId};
use crate::mesh::is_inside;

/// The size of the letters.
pub(super) const LETTERS: f64 = 17.0;
pub(super) const SMALL_LETTERS: f64 = 14.0;
/// The distance to which the hatching of a hole around a figure reaches.
const TICKS: f64 = 40.0;

/// A side that is being drawn.
pub(super) struct Panel<'a> {
    pub figure: &'a Figure<'a>,
    pub side: &'a Side,
    pub is_after: bool,
    /// Whether each name stands out.
    strong: Vec<bool>,
    /// The fans of the earlier panel.
    pub earlier: Vec<(usize, NameId, [f64; 2])>,
    pub places: &'a [DVec2],
    pub curves: Vec<Curve>,
    prefix: String,
    /// The fans at each node, and the angles they spread between.
    pub fans: Vec<(usize, NameId, [f64; 2])>,
    pub groups: Vec<Group>,
    pub texts: Vec<Text>,
    /// The hatching of holes.
    pub hatched: Vec<Hatched>,
    /// The space that is taken.
    pub room: Room,
}

/// The hatching of a hole.
pub(super) struct Hatched {
    pub group: usize,
    pub outline: Vec<DVec2>,
    /// True if the hole lies around the outline.
    pub is_around: bool,
}

impl Hatched {
    /// True if it may cover a place.
    fn reaches(&self, at: DVec2) -> bool {
        let is_inside = is_inside(at, &self.outline);
        match self.is_around {
            true => !is_inside && sides(&self.outline).any(|side| distance(at, side) < TICKS),
            false => is_inside,
        }
    }
}

/// A text that has no place yet.
pub(super) struct Text {
    group: usize,
    name: NameId,
    label: Label,
    spots: Vec<Spot>,
    /// The background that separates it from the lines below it.
    pub ground: Option<Ink>,
}

impl<'a> Panel<'a> {
    /// Draws everything but the texts: `before`, or `after` if there is an earlier panel.
    pub fn new(
        figure: &'a Figure<'a>,
        earlier: Option<&Panel>,
        places: &'a [DVec2],
        prefix: &str,
    ) -> Self {
        let is_after = earlier.is_some();
        let side = if is_after { &figure.after } else { &figure.before };
        let curve = |strand: &Strand| {
            let points: Vec<_> = strand.nodes.iter().map(|&node| places[node]).collect();
            Curve::smooth(&points)
        };
        let mut panel = Self {
            figure,
            side,
            is_after,
            strong: sector(figure.drawing.rule),
            earlier: earlier.map_or_else(Vec::new, |panel| panel.fans.clone()),
            places,
            curves: side.strands.iter().map(curve).collect(),
            prefix: format!("{prefix}{}", if is_after { "after" } else { "before" }),
            fans: Vec::new(),
            groups: Vec::new(),
            texts: Vec::new(),
            hatched: Vec::new(),
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

    /// The nodes at which a vertex is drawn: those where strands end, or else its first.
    pub fn dots(&self, vertex: NameId) -> Vec<usize> {
        let ends: Vec<_> = self.side.strands.iter().flat_map(Strand::ends).collect();
        let dots = self.figure.nodes_of(vertex);
        let dots: Vec<_> = dots.filter(|node| ends.contains(node)).collect();
        match dots.is_empty() && self.shown().contains(&vertex) {
            true => self.figure.vertex(vertex).into_iter().collect(),
            false => dots,
        }
    }

    /// The number of pairs of strands that cross.
    pub fn crossings(&self) -> usize {
        crossings(&self.curves)
    }

    /// The curves of the strands that end at a node, each starting there.
    pub fn spokes(&self, node: usize) -> Vec<Curve> {
        let mut spokes = Vec::new();
        for (strand, curve) in self.side.strands.iter().zip(&self.curves) {
            let [from, to] = strand.ends();
            if from == node {
                spokes.push(curve.clone());
            }
            if to == node {
                spokes.push(curve.reversed());
            }
        }
        spokes
    }

    /// The directions in which strands leave a node.
    pub fn directions(&self, node: usize) -> Vec<f64> {
        self.spokes(node).into_iter().map(|spoke| angle(spoke.start_direction())).collect()
    }

    /// The sectors at a node that lie in loops, counterclockwise from one angle to another.
    pub fn corners(&self, node: usize) -> Vec<[f64; 2]> {
        let mut corners = Vec::new();
        for orbit in &self.side.loops {
            let next = orbit.darts.iter().cycle().skip(1);
            for (&dart, &next) in orbit.darts.iter().zip(next) {
                if self.side.nodes(next)[0] == node {
                    let [into, out] = [self.along(dart), self.along(next)];
                    corners.push([angle(out.start_direction()), angle(-into.end_direction())]);
                }
            }
        }
        corners
    }

    /// Places the texts, those of the vertices where `vertices` says, and returns what was drawn.
    pub fn finish(mut self, vertices: &[(usize, Label, [DVec2; 2])]) -> (Vec<Group>, Room) {
        let side = usize::from(self.is_after);
        for &vertex in &self.side.shown {
            let group = self.vertex(vertex);
            let dots = self.dots(vertex);
            for (_, label, at) in vertices.iter().filter(|(node, ..)| dots.contains(node)) {
                self.write(group, vertex, label, at[side]);
            }
        }
        let mut texts = std::mem::take(&mut self.texts);
        // Texts with the fewest spots come first.
        texts.sort_by_key(|text| text.spots.len());
        for text in texts {
            let at = self.room.best(&text.label, &text.spots).at;
            if let Some(ground) = text.ground {
                self.groups[text.group].fill(Path::plate(&text.label).moved(at), ground);
            }
            self.write(text.group, text.name, &text.label, at);
        }
        (self.groups, self.room)
    }

    /// Writes the name of an element; holes are not hatched behind it.
    pub fn write(&mut self, group: usize, of: NameId, label: &Label, at: DVec2) {
        self.room.put(&self.figure.drawing.rule.name(of).text, label, at);
        for hole in &self.hatched {
            // What is painted later would cover the name.
            if hole.reaches(at) && hole.group <= group {
                self.groups[hole.group].fill(Path::plate(label).moved(at), Ink::Paper);
            }
        }
        let ink = Ink::Of(self.status(of));
        self.groups[group].write(label, at, ink);
    }

    pub fn status(&self, name: NameId) -> Status {
        Status::of(&self.figure.drawing, name)
    }

    /// Adds a group for the shapes of a name, and returns its index.
    pub fn group(&mut self, name: NameId) -> usize {
        let of = self.figure.drawing.rule.name(name);
        let status = self.status(name).word();
        let id =
            if of.named { format!("{}-{}", self.prefix, id_word(&of.text)) } else { String::new() };
        let title = format!("{} {}, {status}", of.kind.word(), of.text);
        let mut group = Group::named(id, title);
        group.is_faded = !self.stands_out(name);
        self.groups.push(group);
        self.groups.len() - 1
    }

    /// True if a name is not faded.
    pub fn stands_out(&self, name: NameId) -> bool {
        self.strong[name.index()]
    }

    /// Adds a text for a name, to be placed where there is room; faded elements have none.
    pub fn text(
        &mut self,
        group: usize,
        of: NameId,
        size: f64,
        spots: impl Fn(Label) -> (Label, Vec<Spot>),
    ) {
        let word = self.figure.drawing.rule.name(of);
        if !word.named || !self.stands_out(of) {
            return;
        }
        let (label, spots) = spots(name(&word.text, size));
        let ground = (word.kind == Kind::Edge).then(|| self.ground(of));
        self.texts.push(Text { group, name: of, label, spots, ground });
    }

    pub fn along(&self, dart: Dart) -> Curve {
        let curve = &self.curves[dart.strand];
        if dart.forward { curve.clone() } else { curve.reversed() }
    }

    /// The places of ends that have no name.
    pub fn loose(&self) -> Vec<DVec2> {
        let strands = self.side.strands.iter().flat_map(Strand::ends);
        let loose = strands.filter(|&end| self.figure.nodes[end] == Node::Loose);
        loose.map(|end| self.places[end]).collect()
    }
}

/// A name as a part of an id: `h'` and `h[i+1]` become `h-prime` and `h-i-plus-1`.
fn id_word(text: &str) -> String {
    text.replace('-', "-minus-")
        .replace(' ', "-")
        .replace('\'', "-prime")
        .replace('+', "-plus-")
        .replace('[', "-")
        .replace(']', "")
}
