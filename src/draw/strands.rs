//! The edges and paths of a panel, and the halfedges along them.

use std::f64::consts::TAU;

use super::arrows::{double_arrow, draw, harpoon, head};
use super::curve::{Curve, angle, area, distance, sides, turn};
use super::fan::FAN;
use super::figure::{Dart, Orbit};
use super::label_boxes::Spot;
use super::label_positions::{beside, widest_circle};
use super::panel::{LETTERS, Panel, SMALL_LETTERS};
use super::shape::{Group, Path};
use super::status::Status;

/// The distance of a halfedge from its edge, inside its face, and the least in a thin face.
const ASIDE: f64 = 10.5;
const LEAST_ASIDE: f64 = 3.0;
/// The distance that arrows keep from each other at a corner.
const BETWEEN: f64 = 5.0;
/// The gap between spokes, in radians, below which arrows keep clear of a fan in it.
const WIDE: f64 = 3.4;
/// The minimum and maximum length trimmed from an arrow at an end.
const LEAST_TRIM: u16 = 12;
const MOST_TRIM: u16 = 140;

impl Panel<'_> {
    /// Draws the line of an edge or path, and adds the name of the edge.
    pub(super) fn strand(&mut self, at: usize) {
        let strand = &self.side.strands[at];
        let curve = self.curves[at].clone();
        let Some(of) = strand.edge.or(strand.items[0]) else { return };
        let status = match strand.edge {
            Some(edge) => self.status(edge),
            // An edge that is not listed is drawn with its halfedge's status; but that its halfedge
            // is reassigned says nothing about the edge.
            None => match self.status(of) {
                Status::Reassigned if !strand.is_path => Status::Kept,
                status => status,
            },
        };
        let line =
            if strand.is_path { Path::waved(&curve, 2.4, 17.0) } else { Path::along(&curve) };
        let group = match strand.edge {
            Some(edge) => self.group(edge),
            None => {
                self.groups.push(Group { is_faded: !self.stands_out(of), ..Group::default() });
                self.groups.len() - 1
            }
        };
        let width = if strand.is_path { 1.2 } else { 1.7 };
        draw(&mut self.groups[group], line, status, width);
        self.room.draw(&curve, if strand.is_path { 4.0 } else { 1.5 });
        if let Some(edge) = strand.edge {
            let length = curve.length();
            let is_straight = strand.nodes.len() == 2;
            self.text(group, edge, SMALL_LETTERS, |label| {
                // A name that is too wide to fit between the halfedges runs along them.
                let way = curve.start_direction();
                let [wide, high] = [label.half.x * way.y.abs(), label.half.y * way.x.abs()];
                let is_wide = wide > ASIDE - 4.0 || wide + high > ASIDE - 2.0;
                let mut label = match is_straight && is_wide {
                    true => label.turned_along(way),
                    false => label,
                };
                // Only descenders fill the rest of the line.
                label.half.y *= 0.85;
                let parts = [0.5, 0.44, 0.56, 0.38, 0.62, 0.32, 0.68, 0.26, 0.74];
                let spot = |(place, part): (usize, f64)| Spot {
                    at: curve.at(length * part).0,
                    cost: 3.0 * place as f64,
                };
                (label, parts.into_iter().enumerate().map(spot).collect())
            });
        }
    }

    /// Draws the halfedges or paths along a strand.
    pub(super) fn items(&mut self, at: usize) {
        let strand = &self.side.strands[at];
        let pairs: Vec<_> = strand.items.into_iter().zip([true, false]).collect();
        for (item, forward) in pairs {
            let Some(item) = item else { continue };
            let dart = Dart { strand: at, forward };
            let curve = self.along(dart);
            let place = self.in_loop(dart);
            let aside = place.map_or(ASIDE, |(orbit, _)| self.aside(orbit));
            let [start, end] = match place {
                Some(place) => self.trims(place, aside),
                None => self.outer_trims(dart),
            };
            let length = curve.length();
            let aside = if strand.is_path { aside + 2.5 } else { aside };
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
            self.room.draw(&arrow, 1.5);
            self.room.draw(&head(&arrow), 0.5);
            self.text(group, item, LETTERS, |label| {
                let spots = beside(&arrow, &label);
                (label, spots)
            });
        }
    }

    /// The lengths trimmed from a dart at its ends, so that it keeps clear of its neighbors.
    fn trims(&self, (orbit, at): (&Orbit, usize), aside: f64) -> [f64; 2] {
        let count = orbit.darts.len();
        let neighbor = |step: usize| self.along(orbit.darts[(at + step) % count]);
        let [here, before, behind] = [0, count - 1, 1].map(neighbor);
        // The near halves of the neighbors, either of which may be the dart itself.
        let (middle, end) = (before.length() / 2.0, before.length());
        let before = before.cut(middle, end);
        let behind = behind.cut(0.0, behind.length() / 2.0);
        let arrow = here.offset(aside);
        [clear(&arrow, &before, aside), clear(&arrow.reversed(), &behind, aside)]
    }

    /// The loop that a dart lies in, and its place there.
    fn in_loop(&self, dart: Dart) -> Option<(&Orbit, usize)> {
        self.side.loops.iter().find_map(|orbit| {
            let at = orbit.darts.iter().position(|other| *other == dart)?;
            Some((orbit, at))
        })
    }

    /// The distance of the halfedges of a loop from their edges: less in a face that is too thin for
    /// the arrows of both its sides.
    fn aside(&self, orbit: &Orbit) -> f64 {
        let outline = self.outline(orbit);
        let around: f64 = sides(&outline).map(|[a, b]| a.distance(b)).sum();
        // The circle in a convex polygon has at most twice its area by its perimeter as radius.
        let is_thin = area(&outline) < 2.0 * ASIDE * around;
        if !is_thin || !self.encloses(orbit, &outline) {
            return ASIDE;
        }
        (widest_circle(&outline) / 2.0).clamp(LEAST_ASIDE, ASIDE)
    }

    /// The same for a dart outside of all loops: up to the next spoke on its left.
    fn outer_trims(&self, dart: Dart) -> [f64; 2] {
        let curve = self.along(dart);
        let nodes = self.side.nodes(dart);
        let (start, end) = (angle(curve.start_direction()), angle(-curve.end_direction()));
        let aside = curve.offset(ASIDE);
        let trim = |node: usize, aside: &Curve, side: f64, open: &dyn Fn(f64) -> f64| {
            let spokes = self.spokes(node).into_iter();
            let spokes = spokes.map(|spoke| (open(angle(spoke.start_direction())), spoke));
            let next = spokes.min_by(|(a, _), (b, _)| a.total_cmp(b));
            let (gap, clear) =
                next.map_or((TAU, 0.0), |(gap, spoke)| (gap, clear(aside, &spoke, side)));
            let mut fans = self.fans.iter().filter(|(at, ..)| *at == node);
            let fan = fans.any(|(_, _, [from, to])| open((from + to) / 2.0) < gap && gap < WIDE);
            clear.max(if fan { FAN + 5.0 } else { 15.0 })
        };
        let last = nodes[nodes.len() - 1];
        [
            trim(nodes[0], &aside, -ASIDE, &|other| turn(start, other)),
            trim(last, &aside.reversed(), ASIDE, &|other| turn(other, end)),
        ]
    }
}

/// The length trimmed from an arrow at a corner, so that it is as far from the neighbor as from
/// its own edge, and clear of the arrow on that side of the neighbor.
fn clear(arrow: &Curve, neighbor: &Curve, side: f64) -> f64 {
    let other = neighbor.offset(side);
    let is_clear = |trim: &f64| {
        let at = arrow.at(*trim).0;
        let far = |curve: &Curve| {
            curve.segments().map(|segment| distance(at, segment)).fold(f64::MAX, f64::min)
        };
        far(neighbor) > side.abs() - 0.1 && far(&other) > BETWEEN.min(side.abs() / 2.0)
    };
    let mut trims = (LEAST_TRIM..MOST_TRIM).map(f64::from);
    trims.find(is_clear).unwrap_or(MOST_TRIM.into())
}
