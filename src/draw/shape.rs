//! A picture as data: paths, inks and strokes, in named groups.
//!
//! Both writers, [`svg`](super::svg) and [`png`](super::png), show the same picture.

use glam::DVec2;

use super::curve::{Curve, left};
use super::curve_fit::follow;
use super::letters::{Glyph, Label, Style, moved, words};
use super::raster::Image;
use super::status::Status;

/// A step of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Step {
    Move(DVec2),
    Line(DVec2),
    /// A parabola: its control point and its end.
    Curve(DVec2, DVec2),
    Close,
}

/// A path to fill or to stroke.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Path {
    pub steps: Vec<Step>,
}

impl Path {
    pub fn move_to(&mut self, to: DVec2) {
        self.steps.push(Step::Move(to));
    }

    pub fn line_to(&mut self, to: DVec2) {
        self.steps.push(Step::Line(to));
    }

    pub fn curve_to(&mut self, by: DVec2, to: DVec2) {
        self.steps.push(Step::Curve(by, to));
    }

    pub fn close(&mut self) {
        self.steps.push(Step::Close);
    }

    /// Adds a polygon.
    pub fn polygon(&mut self, corners: impl IntoIterator<Item = DVec2>) {
        self.polyline(corners);
        self.close();
    }

    fn polyline(&mut self, points: impl IntoIterator<Item = DVec2>) {
        for (at, point) in points.into_iter().enumerate() {
            if at == 0 { self.move_to(point) } else { self.line_to(point) }
        }
    }

    pub fn along(curve: &Curve) -> Self {
        let mut path = Self::default();
        path.move_to(curve.points()[0]);
        follow(&mut path, curve.points());
        path
    }

    /// A wave around a curve, which begins and ends on it.
    pub fn waved(curve: &Curve, height: f64, wavelength: f64) -> Self {
        let mut path = Self::default();
        let length = curve.length();
        let halves = 2.0 * (length / wavelength).round().max(1.0);
        path.move_to(curve.at(0.0).0);
        for half in 0..halves as usize {
            // The first and the last half wave are lower, so that the wave leaves its ends
            // smoothly.
            let is_last = half == 0 || half + 1 == halves as usize;
            let high = if is_last { height } else { 2.0 * height };
            let sign = if half % 2 == 0 { 1.0 } else { -1.0 };
            let (middle, way) = curve.at((half as f64 + 0.5) / halves * length);
            let (end, _) = curve.at((half as f64 + 1.0) / halves * length);
            path.curve_to(middle + left(way) * (sign * high), end);
        }
        path
    }

    /// The path around a polygon.
    pub fn around(corners: &[DVec2]) -> Self {
        let mut path = Self::default();
        if let Some(&first) = corners.first() {
            path.move_to(first);
            follow(&mut path, corners);
            path.close();
        }
        path
    }

    /// A box with cut corners, slightly larger than a text centered at zero.
    pub fn plate(label: &Label) -> Self {
        let mut path = Self::default();
        let (half, cut) = (label.half + AIR, 2.0 * AIR);
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        path.polygon(corners.into_iter().flat_map(|(x, y)| {
            let corner = half * DVec2::new(x, y);
            let [across, down] = [DVec2::new(x * cut, 0.0), DVec2::new(0.0, y * cut)];
            // At each corner, the cut that comes first on the way around.
            if x == y { [corner - down, corner - across] } else { [corner - across, corner - down] }
        }));
        path.turned(label.rotation())
    }

    pub fn circle(center: DVec2, radius: f64) -> Self {
        let mut path = Self::default();
        // Eight parabolas have no visible deviation from a circle.
        let bend = radius / (std::f64::consts::PI / 8.0).cos();
        let at = |eighths: f64, radius: f64| {
            center + DVec2::from_angle(eighths * std::f64::consts::FRAC_PI_4) * radius
        };
        path.move_to(at(0.0, radius));
        for eighth in 0..8 {
            let eighth = f64::from(eighth);
            path.curve_to(at(eighth + 0.5, bend), at(eighth + 1.0, radius));
        }
        path.close();
        path
    }

    /// The same path, moved.
    pub fn moved(&self, by: DVec2) -> Self {
        self.mapped(|at| at + by)
    }

    /// The same path turned around zero.
    pub fn turned(&self, rotation: DVec2) -> Self {
        self.mapped(|at| rotation.rotate(at))
    }

    fn mapped(&self, place: impl Fn(DVec2) -> DVec2) -> Self {
        let steps = self.steps.iter().map(|&step| match step {
            Step::Move(to) => Step::Move(place(to)),
            Step::Line(to) => Step::Line(place(to)),
            Step::Curve(bend, to) => Step::Curve(place(bend), place(to)),
            Step::Close => Step::Close,
        });
        Self { steps: steps.collect() }
    }
}

/// The ink of a line or an area: a meaning, with a light and a dark colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Ink {
    /// The background.
    Paper,
    /// The inside of a face.
    Face,
    /// Elements that are shown for orientation only.
    Muted,
    /// A colour that represents a number; the same in light and in dark.
    Colour([u8; 3]),
    /// An element, by its status.
    Of(Status),
}

impl Ink {
    /// The inks that differ between light and dark.
    pub const ALL: [Ink; 7] = [
        Ink::Paper,
        Ink::Face,
        Ink::Muted,
        Ink::Of(Status::Kept),
        Ink::Of(Status::Reassigned),
        Ink::Of(Status::New),
        Ink::Of(Status::Erased),
    ];

    /// Its light and its dark colour. Blue, green and vermilion after M. Okabe and K. Ito, "Color
    /// universal design", 2008, darkened or lightened for contrast.
    pub fn colours(self) -> [u32; 2] {
        match self {
            Ink::Paper => [0xffffff, 0x15181d],
            Ink::Face => [0xf1f4f9, 0x20252d],
            Ink::Muted => [0x8b939e, 0x7c8591],
            Ink::Colour([red, green, blue]) => [u32::from_be_bytes([0, red, green, blue]); 2],
            Ink::Of(Status::Kept) => [0x3a4048, 0xd3d8df],
            Ink::Of(Status::Reassigned) => [0x0065b3, 0x6db9ff],
            Ink::Of(Status::New) => [0x00794f, 0x43d69c],
            Ink::Of(Status::Erased) => [0xc2410c, 0xff9768],
        }
    }

    /// Its class in an SVG.
    pub fn class(self) -> &'static str {
        match self {
            Ink::Paper => "paper",
            Ink::Face => "face",
            Ink::Muted => "muted",
            Ink::Colour(_) => "colour",
            Ink::Of(status) => status.word(),
        }
    }
}

/// The way a path is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Paint {
    Fill(Ink),
    Stroke(Stroke),
}

/// The width of the background around a text on a line.
const AIR: f64 = 2.0;

/// The size of the letters of a note.
const NOTE: f64 = 15.0;

/// The opacity of faded groups.
pub(super) const FADED: f64 = 0.28;

/// A line: its ink, width, dashes and opacity. Its ends are round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stroke {
    pub ink: Ink,
    pub width: f64,
    /// The lengths of a dash and of a gap.
    pub dash: Option<[f64; 2]>,
    pub opacity: f64,
}

impl Stroke {
    /// A line without dashes.
    pub fn solid(ink: Ink, width: f64) -> Self {
        Self { ink, width, dash: None, opacity: 1.0 }
    }
}

/// A path and how it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Shape {
    pub path: Path,
    pub paint: Paint,
    /// The letters of a text before rotation; the path is their outline.
    pub glyphs: Vec<Glyph>,
    /// The rotation of the letters in degrees, clockwise, and its center.
    pub turn: Option<(i32, DVec2)>,
}

/// Shapes that belong to one element.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Group {
    /// Its id, unique in its picture; empty for decoration.
    pub id: String,
    /// The title that a viewer shows: "halfedge a, reassigned".
    pub title: String,
    pub shapes: Vec<Shape>,
    /// True if it is drawn faded.
    pub is_faded: bool,
}

impl Group {
    /// A group for an element.
    pub fn named(id: String, title: String) -> Self {
        Self { id, title, ..Self::default() }
    }

    /// Adds an area; consecutive areas with the same ink are one path.
    pub fn fill(&mut self, path: Path, ink: Ink) {
        match self.shapes.last_mut() {
            Some(last) if last.paint == Paint::Fill(ink) && last.glyphs.is_empty() => {
                last.path.steps.extend(path.steps);
            }
            _ => self.push(path, Paint::Fill(ink)),
        }
    }

    /// Adds a text, centered at a place.
    pub fn write(&mut self, label: &Label, at: DVec2, ink: Ink) {
        self.shapes.push(Shape {
            path: label.path.moved(at),
            paint: Paint::Fill(ink),
            glyphs: moved(&label.glyphs, at),
            turn: (label.turn != 0).then_some((label.turn, at)),
        });
    }

    /// Adds a line; consecutive lines with the same stroke are one path.
    pub fn stroke(&mut self, path: Path, stroke: Stroke) {
        match self.shapes.last_mut() {
            Some(last) if last.paint == Paint::Stroke(stroke) => last.path.steps.extend(path.steps),
            _ => self.push(path, Paint::Stroke(stroke)),
        }
    }

    fn push(&mut self, path: Path, paint: Paint) {
        self.shapes.push(Shape { path, paint, glyphs: Vec::new(), turn: None });
    }

    /// The same group, moved.
    pub fn moved(mut self, by: DVec2) -> Self {
        for shape in &mut self.shapes {
            shape.path = shape.path.moved(by);
            shape.glyphs = moved(&shape.glyphs, by);
            shape.turn = shape.turn.map(|(turn, at)| (turn, at + by));
        }
        self
    }
}

/// A text of a picture, and the box it fills; a slanted text fills several side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct TextBox {
    pub text: String,
    /// Its upper left corner.
    pub from: [f64; 2],
    /// Its lower right corner.
    pub to: [f64; 2],
}

/// A picture: [`svg`](Picture::svg) or [`png`](Picture::png) it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    pub(super) title: String,
    pub(super) size: DVec2,
    /// The image below the groups, in the upper left corner.
    pub(super) image: Option<Image>,
    pub(super) groups: Vec<Group>,
    pub(super) texts: Vec<TextBox>,
    pub(super) crossings: usize,
}

impl Picture {
    /// Its width and height.
    pub fn size(&self) -> [f64; 2] {
        self.size.to_array()
    }

    /// True if no part of a mesh is seen in it.
    pub fn is_blank(&self) -> bool {
        let is_seen = |image: &Image| image.pixels.iter().any(|pixel| pixel[3] > 0);
        !self.image.as_ref().is_some_and(is_seen)
    }

    /// Adds a line of text at the bottom.
    pub fn add_note(&mut self, text: &str) {
        let label = words(&text.replace('`', ""), Style::Upright, NOTE);
        let width = 2.0 * (label.half.x + NOTE);
        // What is drawn stays in the middle of a picture that the note makes wider.
        let wider = DVec2::new((width - self.size.x).max(0.0) / 2.0, 0.0);
        let mut group = Group::default();
        let at = DVec2::new(self.size.x / 2.0, self.size.y + NOTE / 2.0);
        group.write(&label, at, Ink::Of(Status::Erased));
        self.size += DVec2::new(2.0 * wider.x, 2.0 * NOTE);
        self.groups.push(group);
        let groups = std::mem::take(&mut self.groups).into_iter();
        self.groups = groups.map(|group| group.moved(wider)).collect();
    }

    /// The boxes of its texts.
    pub fn texts(&self) -> &[TextBox] {
        &self.texts
    }

    /// The number of pairs of edges and paths that cross; zero if the pattern is planar and keeps
    /// its places.
    pub fn crossings(&self) -> usize {
        self.crossings
    }
}
