//! The vertices of a panel, and the fans around them.

use glam::DVec2;

use super::arrows::stroke;
use super::curve::{Curve, angle, direction};
use super::fan::{Around, FAN, fans};
use super::label_boxes::{Spot, reach};
use super::label_positions::DOT;
use super::letters::name;
use super::panel::{LETTERS, Panel};
use super::shape::{Group, Ink, Path, Stroke};
use super::status::Status;
use crate::diagram::NameId;

impl Panel<'_> {
    /// The angles that the fans spread between; a fan of the earlier panel stays as close to its
    /// direction as possible.
    pub(super) fn spread(&self) -> Vec<(usize, NameId, [f64; 2])> {
        let view =
            if self.is_after { &self.figure.drawing.after } else { &self.figure.drawing.before };
        let mut all = Vec::new();
        for star in &view.side().stars {
            let Some(node) = self.figure.vertex(star.vertex.name) else { continue };
            let spoke = |name: NameId| {
                let dart = self.side.darts[name.index()]?;
                Some(angle(self.along(dart).start_direction()))
            };
            let wish = |fan: NameId| {
                let (_, _, [from, to]) = self.earlier.iter().find(|(_, name, _)| *name == fan)?;
                Some((from + to) / 2.0)
            };
            let around = Around { drawn: self.directions(node), corners: self.corners(node) };
            let fans = fans(star, &around, spoke, wish);
            all.extend(fans.into_iter().map(|(fan, sector)| (node, fan, sector)));
        }
        all
    }

    /// Draws the fans and their names.
    pub(super) fn draw_fans(&mut self) {
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

    /// Writes the name of a fan before all other texts, since it has the fewest places to go.
    fn fan_name(&mut self, group: usize, fan: NameId, center: DVec2, middle: f64) {
        let word = self.figure.drawing.rule.name(fan);
        if !word.named || !self.stands_out(fan) {
            return;
        }
        let label = name(&word.text, LETTERS);
        let spot = |step: usize, far: f64| {
            let sign = if step.is_multiple_of(2) { 1.0 } else { -1.0 };
            let way = direction(middle + sign * 0.1 * step.div_ceil(2) as f64);
            Spot {
                at: center + way * (FAN + far + reach(label.half, way)),
                cost: step as f64 + far,
            }
        };
        let spots = [6.0, 10.0, 14.0, 22.0].into_iter();
        let spots = spots.flat_map(|far| (0..12).map(move |step| spot(step, far)));
        let spots: Vec<_> = spots.collect();
        self.write(group, fan, &label, self.room.best(&label, &spots).at);
    }

    /// Draws the dots of a vertex, and returns the index of its group.
    pub(super) fn vertex(&mut self, vertex: NameId) -> usize {
        let status = self.status(vertex);
        let index = self.group(vertex);
        for node in self.dots(vertex) {
            dot(&mut self.groups[index], self.places[node], status);
        }
        index
    }
}

fn dot(group: &mut Group, place: DVec2, status: Status) {
    let ink = Ink::Of(status);
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
}
