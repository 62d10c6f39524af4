//! Where the fans of a vertex spread.

use std::f64::consts::TAU;

use super::curve::turn;
use crate::diagram::{NameId, Spoke, Star};

/// How far a fan reaches.
pub(super) const FAN: f64 = 34.0;
/// How much is left free beside a spoke, and how wide a fan spreads at most.
const FREE: f64 = 0.4;
const WIDEST: f64 = 2.0;

/// For each fan of a vertex with a name the angles it spreads between. `drawn` are the
/// directions of all that is drawn there, `spoke` tells that of a halfedge, `wish` one that a
/// fan would like.
pub(super) fn fans(
    star: &Star,
    drawn: &[f64],
    spoke: impl Fn(NameId) -> Option<f64>,
    wish: impl Fn(NameId) -> Option<f64>,
) -> Vec<(NameId, [f64; 2])> {
    let known = |at: usize| match star.spokes[at] {
        Spoke::Halfedge(name) => spoke(name.name),
        _ => None,
    };
    let count = star.spokes.len();
    let mut fans = Vec::new();
    let mut taken: Vec<f64> = Vec::new();
    for at in 0..count {
        let Spoke::Fan(fan) = star.spokes[at] else {
            continue;
        };
        let before = (1..=count).find_map(|step| known((at + count - step) % count));
        let behind = (1..=count).find_map(|step| known((at + step) % count));
        let (from, width) = match (before, behind) {
            (Some(from), Some(to)) => (from, turn(from, to)),
            _ => (drawn.first().copied().unwrap_or(0.0), TAU),
        };
        let mut cuts: Vec<_> = drawn
            .iter()
            .chain(&taken)
            .map(|&angle| turn(from, angle))
            .filter(|&cut| cut < width - 1e-6)
            .collect();
        cuts.extend([0.0, width]);
        cuts.sort_by(f64::total_cmp);
        let worth = |pair: &[f64]| {
            let gap = (pair[1] - pair[0]).min(WIDEST);
            let middle = from + (pair[0] + pair[1]) / 2.0;
            let off = wish(fan.name).map_or(0.0, |wish| {
                let off = turn(wish, middle);
                off.min(TAU - off)
            });
            if gap < 0.5 {
                gap - TAU
            } else {
                gap - 0.8 * off
            }
        };
        let mut best = (0.0, width, f64::MIN);
        for pair in cuts.windows(2) {
            let worth = worth(pair);
            if worth > best.2 + 1e-6 {
                best = (pair[0], pair[1], worth);
            }
        }
        let middle = from + (best.0 + best.1) / 2.0;
        let spread = (best.1 - best.0 - 2.0 * FREE).clamp(0.3, WIDEST);
        taken.push(middle);
        fans.push((fan.name, [middle - spread / 2.0, middle + spread / 2.0]));
    }
    fans
}
