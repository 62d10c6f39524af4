//! A picture as a small SVG, for those who limit the size of an image, as editors do.
//!
//! It shows the same as [`Picture::svg`], in about half of the letters: steps count tenths of a
//! unit, colours stand once, in a style sheet, and nothing has a name. Viewers that read no
//! style sheets are not served.

use std::fmt::Write;

use super::letters::letter as outline;
use super::shape::{FADED, Group, Ink, Paint, Picture, Shape, Stroke};
use super::svg::{data, escaped, id, letters};

/// How many steps a unit has.
const STEPS: f64 = 10.0;

impl Picture {
    /// The picture as a small SVG.
    pub fn compact_svg(&self) -> String {
        let [width, height] = self.size().map(f64::ceil);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {} {}\"><title>{}</title><style>path{{stroke-linecap:round;\
             stroke-linejoin:round}}",
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
        text.push_str("<defs>");
        for letter in letters(self) {
            let outline = outline(letter.0, letter.1);
            let _ = write!(
                text,
                "<path id=\"{}\" d=\"{}\"/>",
                id(letter),
                data(&outline, 1.0, 1.0)
            );
        }
        text.push_str("</defs>");
        for group in &self.groups {
            write_group(&mut text, group);
        }
        text.push_str("</svg>");
        text
    }
}

/// The colours of one time of day.
fn write_inks(text: &mut String, time: usize) {
    for ink in Ink::ALL {
        let (name, colour) = (name(ink), ink.colours()[time]);
        let _ = write!(
            text,
            ".f{name}{{fill:#{colour:06x}}}.s{name}{{stroke:#{colour:06x};fill:none}}"
        );
    }
}

/// The letter of an ink.
fn name(ink: Ink) -> char {
    ink.class().chars().next().unwrap_or('x')
}

fn write_group(text: &mut String, group: &Group) {
    if group.is_faded {
        let _ = write!(text, "<g opacity=\"{FADED}\">");
    }
    for shape in &group.shapes {
        write_shape(text, shape);
    }
    if group.is_faded {
        text.push_str("</g>");
    }
}

fn write_shape(text: &mut String, shape: &Shape) {
    let mut more = String::new();
    let class = match shape.paint {
        Paint::Fill(ink @ Ink::Shade(_)) => {
            let _ = write!(more, " style=\"fill:#{:06x}\"", ink.colours()[0]);
            'f'.to_string()
        }
        Paint::Fill(ink) => format!("f{}", name(ink)),
        Paint::Stroke(stroke) => {
            write_stroke(&mut more, stroke);
            format!("s{}", name(stroke.ink))
        }
    };
    if shape.glyphs.is_empty() {
        let data = data(&shape.path, STEPS, 1.0);
        let _ = write!(text, "<path class=\"{class}\"{more} d=\"{data}\"/>");
        return;
    }
    let _ = write!(text, "<g class=\"{class}\"{more}>");
    for glyph in &shape.glyphs {
        let [x, y] = glyph.at.to_array().map(steps);
        let _ = write!(
            text,
            "<use href=\"#{}\" transform=\"translate({x} {y})scale({})\"/>",
            id((glyph.style, glyph.code)),
            (glyph.size * STEPS).round() / 1000.0
        );
    }
    text.push_str("</g>");
}

fn write_stroke(more: &mut String, stroke: Stroke) {
    let _ = write!(more, " stroke-width=\"{}\"", steps(stroke.width));
    if let Some([dash, gap]) = stroke.dash {
        let _ = write!(more, " stroke-dasharray=\"{} {}\"", steps(dash), steps(gap));
    }
    if stroke.opacity < 1.0 {
        let _ = write!(more, " stroke-opacity=\"{}\"", stroke.opacity);
    }
}

/// A length in steps; what is no number is 0.
fn steps(length: f64) -> i64 {
    (length * STEPS).round() as i64
}
