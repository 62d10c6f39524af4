//! Curves as polylines: sampled, cut, offset and waved.
//!
//! Coordinates are those of a picture: x to the right, y down. Left of a direction is the
//! side a person walking along it would call left, and a halfedge has its face there.

use glam::DVec2;

/// The approximate distance between the points of a smooth curve.
const STEP: f64 = 4.0;

/// A polyline of at least two points.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Curve {
    points: Vec<DVec2>,
}

impl Curve {
    /// The polyline through `points`; for fewer than two points, a curve of length zero.
    pub fn through(points: impl IntoIterator<Item = DVec2>) -> Self {
        let mut points: Vec<_> = points.into_iter().collect();
        let last = points.last().copied().unwrap_or(DVec2::ZERO);
        while points.len() < 2 {
            points.push(last);
        }
        Self { points }
    }

    /// A smooth curve through `points` (E. Catmull and R. Rom, "A class of local
    /// interpolating splines", 1974).
    pub fn smooth(points: &[DVec2]) -> Self {
        if points.len() < 3 {
            return Self::through(points.iter().copied());
        }
        let count = points.len();
        let mut samples = vec![points[0]];
        for at in 0..count - 1 {
            let (from, to) = (points[at], points[at + 1]);
            // At the ends it continues as the parabola through the last three points.
            let before = if at == 0 { (from - to) * 3.0 + points[2] } else { points[at - 1] };
            let behind =
                if at + 2 < count { points[at + 2] } else { (to - from) * 3.0 + points[at - 1] };
            let steps = ((to - from).length() / STEP).clamp(2.0, 80.0) as usize;
            for step in 1..=steps {
                let t = step as f64 / steps as f64;
                let (t2, t3) = (t * t, t * t * t);
                let point = 2.0 * from
                    + (to - before) * t
                    + (2.0 * before - 5.0 * from + 4.0 * to - behind) * t2
                    + (3.0 * from - before - 3.0 * to + behind) * t3;
                samples.push(point / 2.0);
            }
        }
        Self::through(samples)
    }

    /// An arc around `center`, from one angle to another (counterclockwise if it grows).
    pub fn arc(center: DVec2, radius: f64, from: f64, to: f64) -> Self {
        let steps = ((to - from).abs() * radius / STEP).clamp(4.0, 120.0) as usize;
        Self::through((0..=steps).map(|step| {
            let angle = from + (to - from) * step as f64 / steps as f64;
            center + direction(angle) * radius
        }))
    }

    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    pub fn segments(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        self.points.windows(2).map(|pair| [pair[0], pair[1]])
    }

    /// True if it crosses another.
    pub fn crosses(&self, other: &Self) -> bool {
        self.segments().any(|a| other.segments().any(|b| cross(a, b)))
    }

    pub fn length(&self) -> f64 {
        self.segments().map(|[a, b]| (b - a).length()).sum()
    }

    /// The same curve in the opposite direction.
    pub fn reversed(&self) -> Self {
        Self::through(self.points.iter().rev().copied())
    }

    /// The point at the arc length `along`, and the direction there.
    pub fn at(&self, along: f64) -> (DVec2, DVec2) {
        let mut left = along.max(0.0);
        let mut last = (self.points[0], DVec2::X);
        for [a, b] in self.segments() {
            let length = (b - a).length();
            if length == 0.0 {
                continue;
            }
            let direction = (b - a) / length;
            if left <= length {
                return (a + direction * left, direction);
            }
            left -= length;
            last = (b, direction);
        }
        last
    }

    /// The direction in which it starts.
    pub fn start_direction(&self) -> DVec2 {
        self.at(0.0).1
    }

    /// The direction in which it ends.
    pub fn end_direction(&self) -> DVec2 {
        self.at(f64::MAX).1
    }

    /// The part between two arc lengths.
    pub fn cut(&self, from: f64, to: f64) -> Self {
        let mut points = vec![self.at(from).0];
        let mut along = 0.0;
        for [a, b] in self.segments() {
            along += (b - a).length();
            if along > from + 0.01 && along < to - 0.01 {
                points.push(b);
            }
        }
        points.push(self.at(to).0);
        Self::through(points)
    }

    /// Every point moved to the left by `distance`.
    pub fn offset(&self, distance: f64) -> Self {
        let count = self.points.len();
        let piece = |at: usize| (self.points[at + 1] - self.points[at]).normalize_or_zero();
        Self::through((0..count).map(|at| {
            let behind = if at + 1 < count { piece(at) } else { DVec2::ZERO };
            let before = if at > 0 { piece(at - 1) } else { DVec2::ZERO };
            self.points[at] + left((before + behind).normalize_or_zero()) * distance
        }))
    }
}

/// A direction turned left by a quarter turn.
pub(super) fn left(direction: DVec2) -> DVec2 {
    DVec2::new(direction.y, -direction.x)
}

/// The direction of an angle, counterclockwise from the right.
pub(super) fn direction(angle: f64) -> DVec2 {
    DVec2::new(angle.cos(), -angle.sin())
}

/// The angle of a direction, counterclockwise from the right.
pub(super) fn angle(direction: DVec2) -> f64 {
    (-direction.y).atan2(direction.x)
}

/// The counterclockwise angle from one angle to another: above 0, up to a full turn.
pub(super) fn turn(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(std::f64::consts::TAU);
    if turn < 1e-9 { std::f64::consts::TAU } else { turn }
}

/// The distance of a point from a segment.
pub(super) fn distance(point: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let t = ((point - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
    (a + along * t - point).length()
}

/// True if two segments cross at a point inside both.
fn cross([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let slack = 1e-6;
    side(a, b, c) * side(a, b, d) < -slack && side(c, d, a) * side(c, d, b) < -slack
}

/// The number of pairs of curves that cross.
pub(super) fn crossings(curves: &[Curve]) -> usize {
    let earlier = |at: usize| curves[..at].iter().filter(|other| curves[at].crosses(other)).count();
    (0..curves.len()).map(earlier).sum()
}

/// The sides of a polygon.
pub(super) fn sides(corners: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// The corners of the box around some points.
pub(super) fn bounds(points: impl IntoIterator<Item = DVec2>) -> (DVec2, DVec2) {
    let none = (DVec2::splat(f64::MAX), DVec2::splat(f64::MIN));
    points.into_iter().fold(none, |(low, high), at| (low.min(at), high.max(at)))
}

/// The mean of some points; zero if there are none.
pub(super) fn mean(points: &[DVec2]) -> DVec2 {
    points.iter().copied().sum::<DVec2>() / points.len().max(1) as f64
}

/// Twice the area of a polygon, positive if it runs counterclockwise.
pub(super) fn area(outline: &[DVec2]) -> f64 {
    sides(outline).map(|[a, b]| b.perp_dot(a)).sum()
}
