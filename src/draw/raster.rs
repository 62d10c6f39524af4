//! Rasterization of polygons in space: each pixel shows the nearest one.
//!
//! Each pixel stores the depth of what it shows (the z-buffer of E. Catmull, "A subdivision
//! algorithm for computer display of curved surfaces", 1974), so that faces hide each other in any
//! order, and also where they intersect. Finally four pixels become one, which smooths lines.

use std::ops::Range;

use glam::{DVec2, DVec3};

use super::curve::sides;

/// A square image: rows of pixels as red, green, blue and opacity, with premultiplied colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// The number of pixels in a row, and the width in the picture.
    pub side: u32,
    pub size: f64,
    pub pixels: Vec<[u8; 4]>,
}

/// The most pixels of a raster that are held at a time.
const MOST_HELD: usize = 1 << 26;

impl Image {
    /// An image of so many pixels in a row, to be `size` wide in a picture. `draw` draws on a raster of
    /// twice the side; it is called for each part of a large one, from above.
    pub fn new(side: u32, size: f64, mut draw: impl FnMut(&mut Raster)) -> Self {
        let width = 2 * side as usize;
        // Two rows become one.
        let most = (MOST_HELD / width.max(1)).max(2) / 2 * 2;
        let mut pixels = Vec::with_capacity(side as usize * side as usize);
        for first in (0..width).step_by(most) {
            let mut raster = Raster::new(width, first..(first + most).min(width));
            draw(&mut raster);
            raster.shrink(&mut pixels);
        }
        Self { side, size, pixels }
    }
}

/// Some rows of a square of pixels to draw on.
pub struct Raster {
    side: usize,
    rows: Range<usize>,
    near: Vec<f32>,
    pixels: Vec<[u8; 4]>,
}

impl Raster {
    fn new(side: usize, rows: Range<usize>) -> Self {
        let count = side * rows.len();
        Self { side, rows, near: vec![f32::NEG_INFINITY; count], pixels: vec![[0; 4]; count] }
    }

    /// Whether a polygon with these corners may be seen in it.
    pub fn meets(&self, corners: &[DVec3]) -> bool {
        !self.rows_of(corners).is_empty()
    }

    /// The rows of the polygon with these corners.
    fn rows_of(&self, corners: &[DVec3]) -> Range<usize> {
        let rows = span(corners.iter().map(|at| at.y), self.side);
        rows.start.max(self.rows.start)..rows.end.min(self.rows.end)
    }

    /// Draws a polygon; its corners are in pixels, with z towards the viewer. The colour is that of
    /// the place of a pixel.
    pub fn polygon(&mut self, corners: &[DVec3], mut colour: impl FnMut(DVec2) -> [u8; 3]) {
        let flat: Vec<_> = corners.iter().map(|corner| corner.truncate()).collect();
        let mut weights = vec![0.0; corners.len()];
        let plane = plane(corners);
        let mut cuts = Vec::new();
        for row in self.rows_of(corners) {
            let y = row as f64 + 0.5;
            cuts.clear();
            let cut = sides(&flat).filter(|[a, b]| (a.y <= y) != (b.y <= y));
            cuts.extend(cut.map(|[a, b]| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)));
            cuts.sort_by(f64::total_cmp);
            for pair in cuts.chunks_exact(2) {
                for column in span(pair.iter().copied(), self.side) {
                    let at = DVec2::new(column as f64 + 0.5, y);
                    let near = match plane {
                        Some((origin, slope)) => origin.z + slope.dot(at - origin.truncate()),
                        None => {
                            weigh(at, &flat, &mut weights);
                            corners.iter().zip(&weights).map(|(c, w)| c.z * w).sum()
                        }
                    } as f32;
                    let place = (row - self.rows.start) * self.side + column;
                    if near > self.near[place] {
                        self.near[place] = near;
                        let [red, green, blue] = colour(at);
                        self.pixels[place] = [red, green, blue, 255];
                    }
                }
            }
        }
    }

    /// Adds the pixels of an image; each is the mean of four.
    fn shrink(&self, image: &mut Vec<[u8; 4]>) {
        let side = self.side / 2;
        let mean = |place: usize| {
            let first = 2 * (place / side) * self.side + 2 * (place % side);
            let four = [first, first + 1, first + self.side, first + self.side + 1];
            let part = |part: usize| four.iter().map(|&at| u16::from(self.pixels[at][part])).sum();
            std::array::from_fn(|at| {
                let sum: u16 = part(at);
                (sum / 4) as u8
            })
        };
        image.extend((0..self.pixels.len() / 4).map(mean));
    }
}

/// A corner of a flat polygon with more than three sides, and how its depth changes along the rows
/// and columns; `None` for other polygons.
fn plane(corners: &[DVec3]) -> Option<(DVec3, DVec2)> {
    let (&origin, rest) = corners.split_first()?;
    let normal: DVec3 = rest.windows(2).map(|two| (two[0] - origin).cross(two[1] - origin)).sum();
    let normal = normal.try_normalize()?;
    let is_flat = rest.iter().all(|corner| normal.dot(corner - origin).abs() < 1e-3);
    (corners.len() > 3 && is_flat && normal.z.abs() > 0.01)
        .then(|| (origin, -normal.truncate() / normal.z))
}

/// The pixels whose centers lie between the least and the greatest of some numbers.
fn span(values: impl Iterator<Item = f64>, side: usize) -> std::ops::Range<usize> {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = values.fold(none, |(low, high), x| (low.min(x), high.max(x)));
    // NaN and negative numbers become zero.
    let pixel = |value: f64| ((value - 0.5).ceil() as usize).min(side);
    pixel(low)..pixel(high)
}

/// The mean value coordinates of a place (M. S. Floater, "Mean value coordinates", 2003): in a
/// triangle the barycentric ones; in other polygons they are continuous, and linear along a side.
pub fn weigh(at: DVec2, corners: &[DVec2], weights: &mut [f64]) {
    if let &[a, b, c] = corners {
        let whole = (b - a).perp_dot(c - a);
        let (second, third) = ((at - a).perp_dot(c - a), (b - a).perp_dot(at - a));
        let (second, third) = (second / whole, third / whole);
        weights.copy_from_slice(&[1.0 - second - third, second, third]);
        return;
    }
    weights.fill(0.0);
    let count = corners.len();
    let mut sum = 0.0;
    for here in 0..count {
        let next = (here + 1) % count;
        let (a, b) = (corners[here] - at, corners[next] - at);
        let (far, farther) = (a.length(), b.length());
        let (across, along) = (a.perp_dot(b), a.dot(b));
        if across.abs() < 1e-9 && along <= 0.0 {
            // On the side, or at a corner.
            weights.fill(0.0);
            let t = far / (far + farther).max(1e-12);
            weights[here] = 1.0 - t;
            weights[next] = t;
            return;
        }
        let half = if across.abs() < 1e-9 { 0.0 } else { (far * farther - along) / across };
        for (corner, far) in [(here, far), (next, farther)] {
            weights[corner] += half / far.max(1e-12);
            sum += half / far.max(1e-12);
        }
    }
    weights.iter_mut().for_each(|weight| *weight /= sum);
}
