//! The edges and paths of a panel, and the halfedges along them.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::curve::{angle, turn};
use super::fan::FAN;
use super::figure::Dart;
use super::panel::{LETTERS, Panel, SMALL_LETTERS};
use super::pen::{double_arrow, draw, harpoon};
use super::room::Spot;
use super::shape::{Group, Path};
use super::spots::beside;
use super::status::Status;

/// How far a halfedge lies inside its face.
const ASIDE: f64 = 10.0;

impl Panel<'_> {
    /// The line of an edge or path, and the name of the edge.
    pub(super) fn strand(&mut self, at: usize) {
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
            Path::waved(&curve, 2.4, 15.0)
        } else {
            Path::along(&curve)
        };
        let group = match strand.edge {
            Some(edge) => self.group(edge),
            None => {
                self.groups.push(Group {
                    is_faded: !self.stands_out(of),
                    ..Group::default()
                });
                self.groups.len() - 1
            }
        };
        let width = if strand.is_path { 1.2 } else { 1.7 };
        draw(&mut self.groups[group], line, status, width);
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
    pub(super) fn items(&mut self, at: usize) {
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
