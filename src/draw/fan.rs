//! Directions in which the fans of a vertex spread.

use std::f64::consts::TAU;

use super::curve::turn;
use crate::diagram::{NameId, Spoke, Star};

/// The radius of a fan.
pub(super) const FAN: f64 = 34.0;
/// The angle left free beside a spoke, and the maximum angle of a fan.
const FREE: f64 = 0.32;
const WIDEST: f64 = 2.0;

/// The loops, spokes and fans around a vertex.
pub(super) struct Around {
    /// The directions of all strands that end there.
    pub drawn: Vec<f64>,
    /// The sectors inside loops, counterclockwise from one angle to another: no fan lies there.
    pub corners: Vec<[f64; 2]>,
}

impl Around {
    fn is_in_loop(&self, angle: f64) -> bool {
        self.corners.iter().any(|&[start, end]| turn(start, angle) < turn(start, end))
    }
}

/// The angles that each fan of a vertex spreads between. `spoke` gives the direction of a halfedge,
/// `wish` the preferred direction of a fan.
pub(super) fn fans(
    star: &Star,
    around: &Around,
    spoke: impl Fn(NameId) -> Option<f64>,
    wish: impl Fn(NameId) -> Option<f64>,
) -> Vec<(NameId, [f64; 2])> {
    let known = |at: usize| star.spokes[at].halfedge().and_then(&spoke);
    let count = star.spokes.len();
    let mut fans = Vec::new();
    let mut taken: Vec<f64> = Vec::new();
    for at in 0..count {
        let Spoke::Fan(fan) = star.spokes[at] else { continue };
        let before = (1..=count).find_map(|step| known((at + count - step) % count));
        let behind = (1..=count).find_map(|step| known((at + step) % count));
        let (from, width) = match (before, behind) {
            (Some(from), Some(to)) => (from, turn(from, to)),
            _ => (around.drawn.first().copied().unwrap_or(0.0), TAU),
        };
        let worth = |pair: &[f64; 2]| {
            let gap = (pair[1] - pair[0]).min(WIDEST);
            let middle = from + (pair[0] + pair[1]) / 2.0;
            let off = wish(fan.name).map_or(0.0, |wish| {
                let off = turn(wish, middle);
                off.min(TAU - off)
            });
            if around.is_in_loop(middle) {
                gap - 2.0 * TAU
            } else if gap < 0.5 {
                gap - TAU
            } else {
                gap - 0.8 * off
            }
        };
        // If there are as many gaps between two spokes as fans and rests, each has its own.
        let is_known = |at: usize| known(at % count).is_some();
        let earlier = (1..count).take_while(|step| !is_known(at + count - step));
        let later = (1..count).take_while(|step| !is_known(at + step));
        let (earlier, later) = (earlier.count(), later.count());
        let mut open = gaps(from, width, around.drawn.iter());
        open.retain(|[low, high]| !around.is_in_loop(from + (low + high) / 2.0));
        let mut best = ([0.0, width], f64::MIN);
        if open.len() == earlier + 1 + later {
            best.0 = open[earlier];
        } else {
            for pair in gaps(from, width, around.drawn.iter().chain(&taken)) {
                let worth = worth(&pair);
                if worth > best.1 + 1e-6 {
                    best = (pair, worth);
                }
            }
        }
        let [low, high] = best.0;
        let middle = from + (low + high) / 2.0;
        let spread = (high - low - 2.0 * FREE).clamp(0.3, WIDEST);
        taken.push(middle);
        fans.push((fan.name, [middle - spread / 2.0, middle + spread / 2.0]));
    }
    fans
}

/// The gaps that some angles leave in a sector, each as its start and end relative to `from`.
fn gaps<'a>(from: f64, width: f64, angles: impl Iterator<Item = &'a f64>) -> Vec<[f64; 2]> {
    let cuts = angles.map(|&angle| turn(from, angle));
    let mut cuts: Vec<_> = cuts.filter(|&cut| cut < width - 1e-6).collect();
    cuts.extend([0.0, width]);
    cuts.sort_by(f64::total_cmp);
    cuts.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[low, high]| high - low > 1e-6).collect()
}
