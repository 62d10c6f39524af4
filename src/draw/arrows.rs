//! Lines and arrows, styled by the status of an element.

use super::curve::{Curve, left};
use super::shape::{Group, Ink, Path, Stroke};
use super::status::Status;

/// The stroke for an element with the given status.
pub(super) fn stroke(status: Status, width: f64) -> Stroke {
    let mut stroke = Stroke::solid(Ink::Of(status), width);
    match status {
        Status::Kept => stroke.width = width * 0.8,
        Status::Reassigned | Status::New => stroke.width = width * 1.2,
        Status::Erased => stroke.dash = Some([width * 2.4, width * 2.8]),
    }
    stroke
}

/// Draws a line; a new element has a highlight behind it.
pub(super) fn draw(group: &mut Group, path: Path, status: Status, width: f64) {
    if status == Status::New {
        let mut band = Stroke::solid(Ink::Of(status), width + 5.0);
        band.opacity = 0.17;
        group.stroke(path.clone(), band);
    }
    group.stroke(path, stroke(status, width));
}

/// A halfedge: a line with half an arrowhead, on the side of its face.
pub(super) fn harpoon(group: &mut Group, curve: &Curve, status: Status) {
    draw(group, Path::along(curve), status, 1.6);
    let (tip, way) = curve.at(f64::MAX);
    let base = tip - way * 10.0;
    let corners = [tip + way * 1.5, base + left(way) * 5.5, base + way * 2.5];
    group.fill(Path::around(&corners), Ink::Of(status));
}

/// The barb of a harpoon, on the side of its face.
pub(super) fn head(curve: &Curve) -> Curve {
    let (tip, way) = curve.at(f64::MAX);
    Curve::through([tip - way * 10.0 + left(way) * 5.5, tip])
}

/// A path: a double line with an open arrowhead.
pub(super) fn double_arrow(group: &mut Group, curve: &Curve, status: Status) {
    let length = curve.length();
    let shaft = curve.cut(0.0, length - 4.0);
    for aside in [1.9, -1.9] {
        draw(group, Path::along(&shaft.offset(aside)), status, 1.2);
    }
    let (tip, way) = curve.at(f64::MAX);
    let head = [1.0, -1.0].map(|sign| tip - way * 7.5 + left(way) * (5.5 * sign));
    let mut stroke = stroke(status, 1.5);
    stroke.dash = None;
    group.stroke(Path::along(&Curve::through([head[0], tip, head[1]])), stroke);
}
