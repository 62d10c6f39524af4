//! Colours for numbers: dark blue for the least, yellow for the greatest.
//!
//! The colours are those of S. van der Walt and N. Smith, "A better default colormap for
//! Matplotlib", 2015, whose brightness increases evenly, also in greyscale and for colour-blind
//! viewers.

use glam::DVec2;

use super::letters::{Style, words};
use super::shape::{Group, Ink, Path};
use super::status::Status;

/// Samples at equal distances.
const COLOURS: [u32; 9] =
    [0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725];
/// The number of stripes in a legend, its size, and that of its letters.
const STRIPES: usize = 48;
const BAR: DVec2 = DVec2::new(16.0, 240.0);
const LETTERS: f64 = 14.0;
/// The distance of two squares in a legend.
pub(super) const SWATCH: f64 = 56.0;

/// The colour of a fraction between 0 and 1.
pub fn viridis(part: f64) -> [u8; 3] {
    let last = COLOURS.len() - 1;
    let along = part.clamp(0.0, 1.0) * last as f64;
    let at = (along as usize).min(last - 1);
    let [from, to] = [COLOURS[at], COLOURS[at + 1]].map(u32::to_be_bytes);
    let mix = |part: usize| {
        let (a, b) = (f64::from(from[part]), f64::from(to[part]));
        (a + (b - a) * (along - at as f64)).round() as u8
    };
    [mix(1), mix(2), mix(3)]
}

/// The range of the numbers that are shown.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    low: f64,
    high: f64,
}

impl Range {
    /// The range of some numbers; those that are not finite do not count. Numbers that would be
    /// written alike, such as lengths up to rounding, count as one.
    pub fn of(numbers: impl Iterator<Item = f64>) -> Option<Self> {
        let range = numbers.filter(|number| number.is_finite()).fold(None, |range, number| {
            let Self { low, high } = range.unwrap_or(Self { low: number, high: number });
            Some(Self { low: low.min(number), high: high.max(number) })
        });
        range.map(|Self { low, high }| Self {
            low,
            high: if number(low) == number(high) { low } else { high },
        })
    }

    /// The least and the greatest number.
    pub fn ends(self) -> [f64; 2] {
        [self.low, self.high]
    }

    pub fn colour(self, number: f64) -> [u8; 3] {
        let wide = self.high - self.low;
        viridis(if wide > 0.0 { (number - self.low) / wide } else { 0.5 })
    }

    /// A colour bar around a place, with a title above and the numbers at its ends.
    pub(super) fn legend(self, title: &str, center: DVec2) -> Group {
        let mut group = Group::default();
        let top = center - BAR / 2.0;
        let high = BAR.y / STRIPES as f64;
        for stripe in 0..STRIPES {
            let [from, to] = [stripe, stripe + 1].map(|at| top.y + at as f64 * high);
            let mut path = Path::default();
            // Slightly overlapping, so that there is no seam.
            let corners = [(0.0, from), (BAR.x, from), (BAR.x, to + 0.5), (0.0, to + 0.5)];
            path.polygon(corners.map(|(x, y)| DVec2::new(top.x + x, y)));
            let part = 1.0 - (stripe as f64 + 0.5) / STRIPES as f64;
            group.fill(path, Ink::Colour(viridis(part)));
        }
        let [above, below] = [-BAR.y / 2.0 - 14.0, BAR.y / 2.0 + 14.0];
        let at = |y: f64| DVec2::new(center.x, center.y + y);
        write(&mut group, title, Style::Italic, at(above - 22.0));
        write(&mut group, &number(self.high), Style::Upright, at(above));
        write(&mut group, &number(self.low), Style::Upright, at(below));
        group
    }
}

/// A square for each of a few values around a place, with the value below it, and a title above.
pub(super) fn swatches(title: &str, values: &[(String, [u8; 3])], center: DVec2) -> Group {
    let mut group = Group::default();
    let half = DVec2::splat(BAR.x / 2.0);
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let first = (values.len() as f64 - 1.0) / 2.0;
    for (number, (text, colour)) in values.iter().enumerate() {
        let at = center + DVec2::new(0.0, (number as f64 - first) * SWATCH);
        let mut path = Path::default();
        path.polygon(corners.map(|(x, y)| at + half * DVec2::new(x, y)));
        group.fill(path, Ink::Colour(*colour));
        write(&mut group, text, Style::Upright, at + DVec2::new(0.0, BAR.x + 8.0));
    }
    let above = center.y - first * SWATCH - BAR.x - 14.0;
    write(&mut group, title, Style::Italic, DVec2::new(center.x, above));
    group
}

fn write(group: &mut Group, text: &str, style: Style, at: DVec2) {
    group.write(&words(text, style, LETTERS), at, Ink::Of(Status::Kept));
}

/// A number with four significant digits, and a power of ten if it is very large or small.
pub fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    let text = match rounded.abs() {
        0.0 => "0".to_string(),
        size if (1e-3..1e6).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    };
    text.replace('-', "\u{2212}")
}
