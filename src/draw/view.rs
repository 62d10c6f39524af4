//! A mesh as it is seen from afar: faces shaded by where they look, edges, and its boundary.
//!
//! What is farther away is drawn first (the painter's algorithm), so that a picture of a mesh
//! is made of the same paths as that of a diagram. Faces that pass through each other are
//! beyond it. What has no place is not drawn.

use glam::{DVec2, DVec3};

use super::shape::{Group, Ink, Path, Picture, Stroke};
use super::status::Status;
use crate::mesh::{FaceId, HalfedgeId, Mesh};

/// How a mesh is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where one stands, as a direction from the middle of the mesh.
    pub from: DVec3,
    /// The width and height of the picture.
    pub size: f64,
}

impl Default for View {
    fn default() -> Self {
        Self {
            from: DVec3::new(0.5, 0.4, 1.0),
            size: 800.0,
        }
    }
}

/// The part of a picture that is left free on each side.
const FREE: f64 = 0.05;
/// The longest line is drawn as wide as this, short ones thinner.
const WIDEST: f64 = 1.1;

/// Draws a mesh.
pub fn draw_mesh(mesh: &Mesh, view: &View) -> Picture {
    let size = if view.size.is_finite() {
        view.size.clamp(16.0, 16_384.0)
    } else {
        View::default().size
    };
    let eye = Eye::new(view.from);
    let mut faces: Vec<_> = mesh
        .faces()
        .filter_map(|face| Seen::new(mesh, face, &eye))
        .collect();
    faces.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.face.cmp(&b.face)));
    let corners = || faces.iter().flat_map(|face| &face.corners);
    let none = (DVec2::splat(f64::MAX), DVec2::splat(f64::MIN));
    let (low, high) = corners().fold(none, |(low, high), at| (low.min(*at), high.max(*at)));
    let mut picture = Picture {
        title: "mesh".into(),
        size: DVec2::splat(size),
        ..Picture::default()
    };
    let extent = (high - low).max_element();
    if !(extent > 0.0 && extent.is_finite()) {
        return picture;
    }
    let scale = size * (1.0 - 2.0 * FREE) / extent;
    let middle = low + (high - low) / 2.0;
    let place = |at: DVec2| (at - middle) * scale + size / 2.0;
    let sides = faces
        .iter()
        .map(|face| face.corners.len())
        .sum::<usize>()
        .max(1);
    let length = |face: &Seen| face.sides().map(|[a, b]| (b - a).length()).sum::<f64>();
    let mean = faces.iter().map(length).sum::<f64>() / sides as f64 * scale;
    let line = (mean * 0.06).min(WIDEST);
    let mut group = Group::default();
    for face in &faces {
        let outline: Vec<_> = face.corners.iter().map(|&at| place(at)).collect();
        let path = Path::around(&outline);
        let ink = Ink::Shade(face.shade);
        group.fill(path.clone(), ink);
        // Neighbours meet without a seam.
        group.stroke(path.clone(), Stroke::solid(ink, 0.6));
        if line > 0.12 {
            let mut stroke = Stroke::solid(Ink::Shade(20), line);
            stroke.opacity = 0.75;
            group.stroke(path, stroke);
        }
        for (side, half) in face.halfedges.iter().enumerate() {
            if mesh.is_boundary_halfedge(mesh.twin(*half)) {
                let mut path = Path::default();
                path.move_to(outline[side]);
                path.line_to(outline[(side + 1) % outline.len()]);
                let width = (line * 3.0).clamp(1.2, 2.6);
                let ink = Ink::Of(Status::Erased);
                group.stroke(path, Stroke::solid(ink, width));
            }
        }
    }
    picture.groups.push(group);
    picture
}

/// The directions of a picture, and that towards the one who looks.
struct Eye {
    right: DVec3,
    down: DVec3,
    near: DVec3,
    light: DVec3,
}

impl Eye {
    fn new(from: DVec3) -> Self {
        let near = match from.try_normalize() {
            Some(near) if near.is_finite() => near,
            _ => View::default().from.normalize(),
        };
        let up = if near.y.abs() > 0.999 {
            DVec3::NEG_Z
        } else {
            DVec3::Y
        };
        let right = up.cross(near).normalize_or(DVec3::X);
        let down = right.cross(near);
        Self {
            right,
            down,
            near,
            light: (near - right * 0.5 - down * 0.8).normalize_or(near),
        }
    }
}

/// A face as it is seen.
struct Seen {
    face: FaceId,
    halfedges: Vec<HalfedgeId>,
    corners: Vec<DVec2>,
    depth: f64,
    shade: u8,
}

impl Seen {
    fn new(mesh: &Mesh, face: FaceId, eye: &Eye) -> Option<Self> {
        if mesh.get_is_hole(face) != Some(false) {
            return None;
        }
        let halfedges: Vec<_> = mesh.face_halfedges(face).collect();
        let mut corners = Vec::new();
        let mut depth = 0.0;
        for &half in &halfedges {
            let at = mesh.get_position(mesh.get_vertex(half)?)?;
            if !at.is_finite() {
                return None;
            }
            corners.push(DVec2::new(at.dot(eye.right), at.dot(eye.down)));
            depth += at.dot(eye.near);
        }
        depth /= corners.len().max(1) as f64;
        let normal = mesh.normal(face);
        // The inside of a mesh with a boundary is darker.
        let (normal, most) = match normal.dot(eye.near) < 0.0 {
            true => (-normal, 0.6),
            false => (normal, 1.0),
        };
        let bright = (0.42 + 0.58 * normal.dot(eye.light).max(0.0)) * most;
        Some(Self {
            face,
            halfedges,
            corners,
            depth,
            shade: (bright * 255.0).clamp(0.0, 255.0) as u8,
        })
    }

    fn sides(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        let count = self.corners.len();
        (0..count).map(move |at| [self.corners[at], self.corners[(at + 1) % count]])
    }
}
