//! A picture as a compact SVG, for viewers that limit the size of an image, as editors do.
//!
//! It shows the same as [`Picture::svg`] in about half as many characters: coordinates are in
//! fifths of a unit, colours are given once, in a style sheet, and elements have no ids. Viewers
//! without style sheets are not supported.

use std::fmt::Write;

use super::shape::{FADED, Group, Ink, Paint, Picture, Shape};
use super::steps::Grain;
use super::svg::{escaped, stroke_attributes};
use super::words::Words;

/// The number of steps per unit.
const STEPS: f64 = 5.0;
const GRAIN: Grain = Grain { parts: STEPS, measure: 1.0, slack: 2 };
/// The maximum width at which it is shown, in units: hovers are small, and crop what is wider.
const WIDEST: f64 = 460.0;
/// The number of steps to the size of a letter.
const EM: f64 = 125.0;

impl Picture {
    /// The picture as a small SVG.
    pub fn compact_svg(&self) -> String {
        let [width, height] = self.size().map(f64::ceil);
        let shown = (WIDEST / width).min(1.0);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" \
             viewBox=\"0 0 {} {}\"><title>{}</title><style>path{{stroke-linecap:round;\
             stroke-linejoin:round}}",
            (width * shown).round(),
            (height * shown).round(),
            width * STEPS,
            height * STEPS,
            escaped(&self.title)
        );
        write_inks(&mut text, 0);
        text.push_str("@media(prefers-color-scheme:dark){");
        write_inks(&mut text, 1);
        let _ = write!(
            text,
            "}}</style><rect class=\"f{}\" width=\"100%\" height=\"100%\"/>",
            name(Ink::Paper)
        );
        let words = Words::of(self, ["", "href"], STEPS, EM);
        text.push_str(&words.definitions());
        for group in &self.groups {
            write_group(&mut text, group, &words);
        }
        text.push_str("</svg>");
        text
    }
}

/// Writes the classes of a colour scheme: 0 is light, 1 is dark.
fn write_inks(text: &mut String, time: usize) {
    for ink in Ink::ALL {
        let (name, colour) = (name(ink), ink.colours()[time]);
        let _ = write!(
            text,
            ".f{name}{{fill:#{colour:06x}}}.s{name}{{stroke:#{colour:06x};fill:none}}"
        );
    }
}

/// The one-letter class of an ink.
fn name(ink: Ink) -> char {
    ink.class().chars().next().unwrap_or('x')
}

fn write_group(text: &mut String, group: &Group, words: &Words) {
    if group.is_faded {
        let _ = write!(text, "<g opacity=\"{FADED}\">");
    }
    for shape in &group.shapes {
        write_shape(text, shape, words);
    }
    if group.is_faded {
        text.push_str("</g>");
    }
}

fn write_shape(text: &mut String, shape: &Shape, words: &Words) {
    let attributes = match shape.paint {
        Paint::Fill(ink @ Ink::Colour(_)) => {
            format!("class=\"f\" style=\"fill:#{:06x}\"", ink.colours()[0])
        }
        Paint::Fill(ink) => format!("class=\"f{}\"", name(ink)),
        Paint::Stroke(stroke) => {
            format!("class=\"s{}\"{}", name(stroke.ink), stroke_attributes(stroke, steps))
        }
    };
    text.push_str(&words.element(shape, &attributes, GRAIN));
}

/// A length in steps; NaN becomes 0.
fn steps(length: f64) -> i64 {
    (length * STEPS).round() as i64
}
