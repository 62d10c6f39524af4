//! A picture as PNG, in its light colours.

use std::fmt::{self, Display};

use tiny_skia::{
    Color, FillRule, FilterQuality, LineCap, LineJoin, PathBuilder, Pixmap, PixmapPaint, PixmapRef,
    StrokeDash, Transform,
};

use super::raster::Image;
use super::shape::{FADED, Ink, Paint, Path, Picture, Step};

/// The maximum width and height of an image.
pub(super) const MOST_PIXELS: u32 = 16_384;

/// The reason why a picture cannot be an image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TooLarge {
    width: u32,
    height: u32,
}

impl Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "an image of {} by {} pixels is too large", self.width, self.height)
    }
}

impl std::error::Error for TooLarge {}

impl Picture {
    /// The picture as PNG, with `scale` pixels to a unit.
    pub fn png(&self, scale: f64) -> Result<Vec<u8>, TooLarge> {
        let pixmap = self.pixmap(scale)?;
        let (width, height) = (pixmap.width(), pixmap.height());
        pixmap.encode_png().map_err(|_| TooLarge { width, height })
    }

    /// The picture as pixels, with `scale` pixels to a unit: the number of pixels in a row, and all
    /// of them, row by row, as red, green and blue.
    pub fn rgb(&self, scale: f64) -> Result<(usize, Vec<[u8; 3]>), TooLarge> {
        let pixmap = self.pixmap(scale)?;
        let pixels = pixmap.pixels().iter().map(|one| [one.red(), one.green(), one.blue()]);
        Ok((pixmap.width() as usize, pixels.collect()))
    }

    fn pixmap(&self, scale: f64) -> Result<Pixmap, TooLarge> {
        let most = f64::from(MOST_PIXELS);
        let [width, height] = self.size().map(|side| (side * scale).ceil().clamp(1.0, most + 1.0));
        let too_large = TooLarge { width: width as u32, height: height as u32 };
        if width > most || height > most {
            return Err(too_large);
        }
        let pixmap = Pixmap::new(width as u32, height as u32);
        let mut pixmap = pixmap.ok_or_else(|| too_large.clone())?;
        pixmap.fill(colour(Ink::Paper, 1.0));
        let transform = Transform::from_scale(scale as f32, scale as f32);
        if let Some(image) = &self.image {
            let pixels = image.pixmap().ok_or_else(|| too_large.clone())?;
            let part = (image.size * scale) as f32 / image.side as f32;
            let smooth = PixmapPaint { quality: FilterQuality::Bilinear, ..PixmapPaint::default() };
            let place = Transform::from_scale(part, part);
            pixmap.draw_pixmap(0, 0, pixels, &smooth, place, None);
        }
        let shapes = self.groups.iter().flat_map(|group| {
            let opacity = if group.is_faded { FADED } else { 1.0 };
            group.shapes.iter().map(move |shape| (shape, opacity))
        });
        for (shape, opacity) in shapes {
            let Some(path) = path(&shape.path) else { continue };
            match shape.paint {
                Paint::Fill(ink) => {
                    let paint = paint(ink, opacity);
                    pixmap.fill_path(&path, &paint, FillRule::Winding, transform, None);
                }
                Paint::Stroke(stroke) => {
                    let dash = stroke.dash.map(|dash| dash.map(|part| part as f32).to_vec());
                    let lines = tiny_skia::Stroke {
                        width: stroke.width as f32,
                        line_cap: LineCap::Round,
                        line_join: LineJoin::Round,
                        dash: dash.and_then(|dash| StrokeDash::new(dash, 0.0)),
                        ..tiny_skia::Stroke::default()
                    };
                    let paint = paint(stroke.ink, stroke.opacity * opacity);
                    pixmap.stroke_path(&path, &paint, &lines, transform, None);
                }
            }
        }
        Ok(pixmap)
    }
}

impl Image {
    /// The image as a pixmap of `tiny_skia`; `None` if it is too large.
    fn pixmap(&self) -> Option<PixmapRef<'_>> {
        PixmapRef::from_bytes(self.pixels.as_flattened(), self.side, self.side)
    }

    /// The image as a PNG file.
    pub fn png(&self) -> Option<Vec<u8>> {
        self.pixmap()?.encode_png().ok()
    }
}

fn paint(ink: Ink, opacity: f64) -> tiny_skia::Paint<'static> {
    let mut paint = tiny_skia::Paint::default();
    paint.set_color(colour(ink, opacity));
    paint
}

fn colour(ink: Ink, opacity: f64) -> Color {
    let [_, red, green, blue] = ink.colours()[0].to_be_bytes();
    let alpha = (opacity.clamp(0.0, 1.0) * 255.0).round() as u8;
    Color::from_rgba8(red, green, blue, alpha)
}

fn path(path: &Path) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for step in &path.steps {
        match *step {
            Step::Move(to) => builder.move_to(to.x as f32, to.y as f32),
            Step::Line(to) => builder.line_to(to.x as f32, to.y as f32),
            Step::Curve(by, to) => {
                builder.quad_to(by.x as f32, by.y as f32, to.x as f32, to.y as f32);
            }
            Step::Close => builder.close(),
        }
    }
    builder.finish()
}
