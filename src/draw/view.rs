//! A mesh seen from a distance: faces shaded by their orientation, edges, the boundary, and an
//! attribute in colour.
//!
//! Visibility is decided per pixel (see [`raster`](super::raster)). Each face draws its half of its
//! edges, so that what hides the face hides them too. Faces with a corner at no finite position are
//! not drawn.

use glam::{DVec2, DVec3};

use super::colours::{Colours, LEGEND, LINE, PALE};
use super::curve::{area, distance, sides};
use super::png::MOST_PIXELS;
use super::raster::{Image, Raster, weigh};
use super::shape::Picture;
use crate::mesh::{ColumnId, ElementKind, FaceId, HalfedgeId, Mesh};

/// The view of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The direction from the middle of the mesh to the viewer.
    pub from: DVec3,
    /// The width and height of the picture, without a legend.
    pub size: f64,
    /// The attribute that is shown in colour: a number, the length of a vector or matrix, or a
    /// truth value, of which edges show only those that hold. A few whole numbers have colours of
    /// their own, except at vertices. Vectors of an attribute named `color` or `colour` with
    /// components from 0 to 1 are colours themselves: red, green and blue.
    pub attribute: Option<ColumnId>,
}

impl Default for View {
    fn default() -> Self {
        Self { from: DVec3::new(0.5, 0.4, 1.0), size: 800.0, attribute: None }
    }
}

/// The fraction of a picture that is left free on each side.
const FREE: f64 = 0.05;
/// The maximum widths of the lines of edges and of the boundary, in units of the picture.
const EDGE: f64 = 1.1;
const BOUNDARY: f64 = 2.0;
/// Pictures up to this size have two pixels per unit.
const FINE: f64 = 2048.0;

const FACE: [u8; 3] = [178, 205, 236];
const ON_BOUNDARY: [u8; 3] = [0xc2, 0x41, 0x0c];

impl View {
    /// The least and the greatest size.
    pub const SIZES: [u32; 2] = [16, MOST_PIXELS];

    /// The same view, which shows the colours that the faces or vertices of the mesh have, unless it
    /// shows another attribute.
    pub fn with_own_colours(self, mesh: &Mesh) -> Self {
        let own = |(column, _)| {
            let colours = Colours::new(mesh, column)?;
            let is_area = matches!(colours.kind, ElementKind::Face | ElementKind::Vertex);
            (is_area && colours.are_own()).then_some(column)
        };
        let mut columns: Vec<_> = mesh.public_columns().filter_map(own).collect();
        columns.sort_by_key(|column| column.kind != ElementKind::Face);
        Self { attribute: self.attribute.or(columns.first().copied()), ..self }
    }
}

/// Draws a mesh. A size beyond [`View::SIZES`] becomes the nearest one within.
pub fn draw_mesh(mesh: &Mesh, view: &View) -> Picture {
    let [least, most] = View::SIZES.map(f64::from);
    let size =
        if view.size.is_finite() { view.size.clamp(least, most) } else { View::default().size };
    let colours = view.attribute.and_then(|column| Colours::new(mesh, column));
    let height = colours.as_ref().map_or(0.0, Colours::height);
    let legend = if height > 0.0 { LEGEND } else { 0.0 };
    let mut picture = Picture {
        title: "mesh".into(),
        // The legend may be higher than the mesh.
        size: DVec2::new(size + legend, size.max(height)),
        ..Picture::default()
    };
    let eye = Eye::new(view.from);
    let mut faces: Vec<_> = mesh.faces().filter_map(|face| Seen::new(mesh, face, &eye)).collect();
    let corners = || faces.iter().flat_map(|face| &face.corners);
    let none = (DVec3::splat(f64::MAX), DVec3::splat(f64::MIN));
    let (low, high) = corners().fold(none, |(low, high), at| (low.min(*at), high.max(*at)));
    let extent = (high - low).truncate().max_element();
    if extent > 0.0 && extent.is_finite() {
        let fine = if size <= FINE { 2.0 } else { 1.0 };
        let side = (size * fine).ceil();
        let width = 2.0 * side;
        let scale = width * (1.0 - 2.0 * FREE) / extent;
        let middle = low + (high - low) / 2.0;
        let center = DVec3::new(width / 2.0, width / 2.0, 0.0);
        let corners = faces.iter_mut().flat_map(|face| &mut face.corners);
        corners.for_each(|at| *at = (*at - middle) * scale + center);
        let pen = Pen::new(&faces, width / size);
        picture.image = Some(Image::new(side as u32, size, |raster| {
            for face in &faces {
                if raster.meets(&face.corners) {
                    face.draw(mesh, colours.as_ref(), &pen, raster);
                }
            }
        }));
    }
    if let Some(colours) = colours {
        let at = DVec2::new(size + LEGEND / 2.0, picture.size.y / 2.0);
        picture.groups.extend(colours.legend(at));
    }
    picture
}

/// Half the widths of lines, in pixels.
struct Pen {
    edge: f64,
    /// An edge that shows a value.
    coloured: f64,
    /// The most, and the least in a face that is smaller.
    boundary: f64,
    least: f64,
}

impl Pen {
    /// Line widths that leave small faces visible; `unit` is the number of pixels per unit.
    fn new(faces: &[Seen], unit: f64) -> Self {
        let mut lengths = (0.0, 0.0);
        for face in faces {
            for [a, b] in sides(&flat(&face.corners)) {
                lengths = (lengths.0 + (b - a).length(), lengths.1 + 1.0);
            }
        }
        let mean = lengths.0 / f64::max(lengths.1, 1.0);
        // Very small faces would be covered by their edges.
        let edge = if mean < 2.0 * unit { 0.0 } else { (mean * 0.06).min(EDGE * unit) };
        Self {
            edge: edge / 2.0,
            coloured: (mean * 0.07).clamp(0.5 * unit, 1.4 * unit),
            boundary: (edge * 4.0).clamp(1.2 * unit, BOUNDARY * unit),
            least: 0.7 * unit,
        }
    }
}

/// The axes of a picture, the direction towards the viewer, and that of the light.
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
        let up = if near.y.abs() > 0.999 { DVec3::NEG_Z } else { DVec3::Y };
        let right = up.cross(near).normalize_or(DVec3::X);
        let down = right.cross(near);
        Self { right, down, near, light: (near - right * 0.5 - down * 0.8).normalize_or(near) }
    }
}

/// A projected face.
struct Seen {
    face: FaceId,
    halfedges: Vec<HalfedgeId>,
    /// To the right, down, and towards the viewer.
    corners: Vec<DVec3>,
    /// Its brightness, up to 1.
    bright: f64,
}

/// About the radius of the largest circle in a face: exactly in a triangle.
fn inscribed(corners: &[DVec2]) -> f64 {
    let around: f64 = sides(corners).map(|[a, b]| (b - a).length()).sum();
    area(corners).abs() / around.max(f64::MIN_POSITIVE)
}

/// The corners of a face without their depth.
fn flat(corners: &[DVec3]) -> Vec<DVec2> {
    corners.iter().map(|at| at.truncate()).collect()
}

impl Seen {
    fn new(mesh: &Mesh, face: FaceId, eye: &Eye) -> Option<Self> {
        if mesh.get_is_hole(face) != Some(false) {
            return None;
        }
        let halfedges: Vec<_> = mesh.face_halfedges(face).collect();
        let mut corners = Vec::new();
        for &half in &halfedges {
            let at = mesh.get_position(mesh.get_vertex(half)?)?;
            if !at.is_finite() {
                return None;
            }
            corners.push(DVec3::new(at.dot(eye.right), at.dot(eye.down), at.dot(eye.near)));
        }
        let normal = mesh.normal(face);
        // Back faces, which show the inside of a mesh with a boundary, are darker.
        let (normal, most) = match normal.dot(eye.near) < 0.0 {
            true => (-normal, 0.6),
            false => (normal, 1.0),
        };
        let bright = (0.42 + 0.58 * normal.dot(eye.light).max(0.0)) * most;
        Some(Self { face, halfedges, corners, bright })
    }

    fn draw(&self, mesh: &Mesh, colours: Option<&Colours>, pen: &Pen, raster: &mut Raster) {
        let corners = flat(&self.corners);
        let room = inscribed(&corners) / 2.0;
        let lines = self.halfedges.iter().zip(sides(&corners)).filter_map(|(&half, side)| {
            let (half_width, colour) = self.line(mesh, half, colours, pen)?;
            let half_width = half_width.min(room.max(pen.least));
            Some((side, (side[1] - side[0]).normalize_or_zero(), half_width, colour))
        });
        let lines: Vec<_> = lines.collect();
        let of_vertices = colours.filter(|colours| colours.kind == ElementKind::Vertex);
        let values: Option<Vec<_>> = of_vertices.map(|colours| {
            let vertices = self.halfedges.iter().map(|&half| mesh.vertex(half));
            vertices.map(|vertex| colours.value(mesh, vertex.0)).collect()
        });
        let ground = match colours {
            None => self.shaded(FACE, 1.0),
            Some(colours) if colours.kind == ElementKind::Face => {
                self.shaded(colours.colour(colours.value(mesh, self.face.0)), 0.5)
            }
            Some(_) => self.shaded(PALE, 1.0),
        };
        let mut weights = vec![0.0; corners.len()];
        let (mut row, mut near_row) = (f64::NAN, Vec::new());
        raster.polygon(&self.corners, |at| {
            if at.y != row {
                row = at.y;
                near_row.clear();
                near_row.extend(lines.iter().rev().filter(|(side, _, half_width, _)| {
                    let [low, high] = [side[0].y.min(side[1].y), side[0].y.max(side[1].y)];
                    low - half_width <= row && row <= high + half_width
                }));
            }
            // Most places are far from the whole line through a side.
            let near = near_row.iter().find(|(side, along, half_width, _)| {
                (at - side[0]).perp_dot(*along).abs() <= *half_width
                    && distance(at, *side) < *half_width
            });
            match (near, colours, &values) {
                (Some((_, _, _, colour)), ..) => *colour,
                (None, Some(colours), Some(values)) => {
                    weigh(at, &corners, &mut weights);
                    let parts = values.iter().zip(&weights);
                    let value = parts.map(|(&value, weight)| value * weight).sum();
                    self.shaded(colours.colour(value), 0.5)
                }
                _ => ground,
            }
        });
    }

    /// Half the width and the colour of the line along a halfedge.
    fn line(
        &self,
        mesh: &Mesh,
        half: HalfedgeId,
        colours: Option<&Colours>,
        pen: &Pen,
    ) -> Option<(f64, [u8; 3])> {
        // A boundary line lies entirely in its only face.
        let is_on_boundary = mesh.is_boundary_halfedge(mesh.twin(half));
        let index = colours.and_then(|colours| match colours.kind {
            ElementKind::Edge => Some((colours, mesh.edge(half).0)),
            ElementKind::Halfedge => Some((colours, half.0)),
            _ => None,
        });
        let value = index.map(|(colours, index)| (colours, colours.value(mesh, index)));
        if let Some((colours, value)) = value.filter(|(colours, value)| !colours.leaves(*value)) {
            let colour = colours.colour(value);
            let sides = if is_on_boundary { 2.0 } else { 1.0 };
            return Some((pen.coloured * sides, colour));
        }
        if is_on_boundary {
            return Some((pen.boundary, ON_BOUNDARY));
        }
        (pen.edge > 0.0).then(|| {
            let ground = self.shaded(FACE, 1.0);
            // A quarter of the face shines through.
            let mixed = [0, 1, 2].map(|at| (3 * u16::from(LINE[at]) + u16::from(ground[at])) / 4);
            (pen.edge, mixed.map(|part| part as u8))
        })
    }

    /// A colour shaded by the light on the face; less strongly where colours represent values.
    fn shaded(&self, colour: [u8; 3], strength: f64) -> [u8; 3] {
        let bright = 1.0 - strength * (1.0 - self.bright);
        colour.map(|part| (f64::from(part) * bright).round().clamp(0.0, 255.0) as u8)
    }
}
