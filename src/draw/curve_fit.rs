//! Points approximated by few lines and parabolas, with no visible deviation.
//!
//! A run of points becomes a line if all lie on it; else the parabola between its ends that leaves
//! and arrives in the directions of the points, if all lie on that; else it is split at the point
//! farthest from the line (D. H. Douglas and T. K. Peucker, "Algorithms for the reduction of the
//! number of points", 1973), which finds corners.

use glam::DVec2;

use super::curve::distance;
use super::shape::Path;

/// The largest deviation, too small to be seen.
const UNSEEN: f64 = 0.08;
/// The number of segments as which a parabola is compared with its points.
const PIECES: usize = 12;

/// Extends the path along a run of points, the first of which is its current end.
pub(super) fn follow(path: &mut Path, points: &[DVec2]) {
    let &[first, ref rest @ .., last] = points else { return };
    let far = |at: &usize| distance(rest[*at], [first, last]);
    let farthest = (0..rest.len()).max_by(|a, b| far(a).total_cmp(&far(b)));
    let Some(farthest) = farthest.filter(|at| far(at) > UNSEEN) else { return path.line_to(last) };
    if let Some(by) = bend(points) {
        return path.curve_to(by, last);
    }
    // A corner is the farthest point; on a smooth curve any point will do.
    follow(path, &points[..=farthest + 1]);
    follow(path, &points[farthest + 1..]);
}

/// The control point of the parabola along some points, if they lie on it.
fn bend(points: &[DVec2]) -> Option<DVec2> {
    let &[first, second, third, .., last] = points else { return None };
    let [earlier, before] = [points[points.len() - 3], points[points.len() - 2]];
    // The directions of the parabolas through the three points at each end.
    let out = (second - first) * 4.0 - (third - first);
    let into = (last - before) * 4.0 - (last - earlier);
    let turn = out.perp_dot(into);
    if turn.abs() < 1e-9 {
        return None;
    }
    let along = (last - first).perp_dot(into) / turn;
    let by = first + out * along;
    let back = (last - by).dot(into);
    if along <= 0.0 || back <= 0.0 {
        return None;
    }
    let at = |t: f64| first.lerp(by, t).lerp(by.lerp(last, t), t);
    let pieces: Vec<_> = (0..=PIECES).map(|piece| at(piece as f64 / PIECES as f64)).collect();
    let lies_on =
        |point: &DVec2| pieces.windows(2).any(|pair| distance(*point, [pair[0], pair[1]]) < UNSEEN);
    points.iter().all(lies_on).then_some(by)
}
