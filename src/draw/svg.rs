//! A picture as SVG.
//!
//! Colours stand in the attributes, so that any viewer shows them; a style sheet changes them
//! where a viewer asks for dark. Coordinates are rounded here and nowhere else.

use std::collections::BTreeSet;
use std::fmt::Write;

use glam::DVec2;

use super::letters::{Style, letter as outline};
use super::shape::{FADED, Group, Ink, Paint, Path, Picture, Shape, Step, Stroke};

impl Picture {
    /// The picture as SVG.
    pub fn svg(&self) -> String {
        let [width, height] = self.size().map(f64::ceil);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\">\n<title>{}</title>\n<style>\n\
             path {{ stroke-linecap: round; stroke-linejoin: round }}\n\
             @media (prefers-color-scheme: dark) {{\n",
            escaped(&self.title)
        );
        for ink in Ink::ALL {
            let [_, dark] = ink.colours();
            let class = ink.class();
            let _ = writeln!(
                text,
                ".fill-{class} {{ fill: #{dark:06x} }} .stroke-{class} {{ stroke: #{dark:06x} }}"
            );
        }
        text.push_str("}\n</style>\n");
        let [light, _] = Ink::Paper.colours();
        let _ = writeln!(
            text,
            "<rect class=\"fill-paper\" width=\"{width}\" height=\"{height}\" rx=\"10\" fill=\"#{light:06x}\"/>"
        );
        let title = escaped(&self.title);
        // Without a colour: they take that of the place where they are used.
        text.push_str("<defs>\n");
        for letter in letters(self) {
            let outline = data(&outline(letter.0, letter.1), 1.0, 1.0);
            let _ = writeln!(
                text,
                "<path id=\"{title}-{}\" d=\"{outline}\"/>",
                id(letter)
            );
        }
        text.push_str("</defs>\n");
        for group in &self.groups {
            write_group(&mut text, group, &title);
        }
        text.push_str("</svg>\n");
        text
    }
}

/// The letters of a picture: each is written once, and used wherever it stands.
pub(super) fn letters(picture: &Picture) -> BTreeSet<(Style, char)> {
    let shapes = picture.groups.iter().flat_map(|group| &group.shapes);
    let glyphs = shapes.flat_map(|shape| &shape.glyphs);
    glyphs.map(|glyph| (glyph.style, glyph.code)).collect()
}

/// What a letter is called.
pub(super) fn id((style, code): (Style, char)) -> String {
    let style = match style {
        Style::Italic => 'i',
        Style::Upright => 'u',
    };
    format!("{style}{:x}", u32::from(code))
}

fn write_group(text: &mut String, group: &Group, title: &str) {
    let faded = match group.is_faded {
        true => format!(" opacity=\"{FADED}\""),
        false => String::new(),
    };
    if group.id.is_empty() {
        let _ = writeln!(text, "<g{faded}>");
    } else {
        let _ = write!(text, "<g id=\"{}\"{faded}>", escaped(&group.id));
        let _ = writeln!(text, "<title>{}</title>", escaped(&group.title));
    }
    for shape in &group.shapes {
        match shape.paint {
            Paint::Fill(ink) => write_fill(text, shape, ink, title),
            Paint::Stroke(stroke) => write_stroke(text, &shape.path, stroke),
        }
    }
    text.push_str("</g>\n");
}

fn write_fill(text: &mut String, shape: &Shape, ink: Ink, title: &str) {
    let ([light, _], class) = (ink.colours(), ink.class());
    let fill = format!("class=\"fill-{class}\" fill=\"#{light:06x}\"");
    if shape.glyphs.is_empty() {
        let _ = writeln!(
            text,
            "<path {fill} d=\"{}\"/>",
            data(&shape.path, TENTHS, TENTHS)
        );
        return;
    }
    let _ = write!(text, "<g {fill}>");
    for glyph in &shape.glyphs {
        let [x, y] = glyph.at.to_array().map(number);
        let _ = write!(
            text,
            "<use xlink:href=\"#{title}-{}\" transform=\"translate({x} {y})scale({})\"/>",
            id((glyph.style, glyph.code)),
            (glyph.size * 10.0).round() / 10_000.0
        );
    }
    text.push_str("</g>\n");
}

fn write_stroke(text: &mut String, path: &Path, stroke: Stroke) {
    let ([light, _], class) = (stroke.ink.colours(), stroke.ink.class());
    let mut more = String::new();
    if let Some([dash, gap]) = stroke.dash {
        let _ = write!(
            more,
            " stroke-dasharray=\"{} {}\"",
            number(dash),
            number(gap)
        );
    }
    if stroke.opacity < 1.0 {
        let _ = write!(more, " stroke-opacity=\"{}\"", stroke.opacity);
    }
    let _ = writeln!(
        text,
        "<path class=\"stroke-{class}\" fill=\"none\" stroke=\"#{light:06x}\" \
         stroke-width=\"{}\"{more} d=\"{}\"/>",
        number(stroke.width),
        data(path, TENTHS, TENTHS)
    );
}

/// Coordinates of pictures count tenths.
const TENTHS: f64 = 10.0;

/// The steps of a path, each but the first relative to the one before, rounded to parts of a
/// unit and written in a measure of so many parts. The places are rounded, not the steps, so
/// that nothing adds up.
pub(super) fn data(path: &Path, parts: f64, measure: f64) -> String {
    let mut data = Steps {
        parts,
        measure,
        ..Steps::default()
    };
    for step in &path.steps {
        match *step {
            Step::Move(to) => data.to('m', &[to]),
            Step::Line(to) => data.to('l', &[to]),
            Step::Curve(by, to) => data.to('q', &[by, to]),
            Step::Close => data.close(),
        }
    }
    data.text
}

/// Steps as text.
#[derive(Default)]
struct Steps {
    parts: f64,
    measure: f64,
    text: String,
    last: Option<char>,
    at: [i64; 2],
    /// Where the last polygon began: to close it leads back there.
    began: [i64; 2],
}

impl Steps {
    fn to(&mut self, step: char, points: &[DVec2]) {
        // A step like the last one needs no letter; a second `m` would be read as a line.
        let is_new = self.last != Some(step) || step == 'm';
        if is_new {
            self.text.push(step);
        }
        let mut last = self.at;
        for (nth, point) in points.iter().enumerate() {
            last = [point.x, point.y].map(|value| (value * self.parts).round() as i64);
            for (axis, (to, from)) in last.into_iter().zip(self.at).enumerate() {
                let way = to - from;
                // A sign parts two numbers as well as a space does.
                if (nth > 0 || axis > 0 || !is_new) && way >= 0 {
                    self.text.push(' ');
                }
                let number = (way as f64 / self.measure).to_string();
                // The zero before a point says nothing.
                let is_part = (way.abs() as f64) < self.measure;
                self.text
                    .push_str(&number.replacen("0.", ".", usize::from(is_part)));
            }
        }
        (self.at, self.last) = (last, Some(step));
        if step == 'm' {
            self.began = last;
        }
    }

    fn close(&mut self) {
        self.text.push('z');
        (self.at, self.last) = (self.began, Some('z'));
    }
}

/// A number with at most one digit behind the point; what is no number is 0.
fn number(value: f64) -> f64 {
    let rounded = (value * 10.0).round() / 10.0;
    // Adding zero makes an end of `-0`.
    if rounded.is_finite() {
        rounded + 0.0
    } else {
        0.0
    }
}

/// A text inside XML.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_relative_and_close_to_where_they_began() {
        let mut path = Path::default();
        path.move_to(DVec2::new(1.0, 2.0));
        path.line_to(DVec2::new(3.0, 1.5));
        path.line_to(DVec2::new(3.0, 2.5));
        path.close();
        path.move_to(DVec2::new(0.0, 0.0));
        path.curve_to(DVec2::new(1.0, 0.0), DVec2::new(1.0, 1.0));
        assert_eq!(
            data(&path, 10.0, 1.0),
            "m10 20l20-5 0 10zm-10-20q10 0 10 10"
        );
        assert_eq!(data(&path, 10.0, 10.0), "m1 2l2-.5 0 1zm-1-2q1 0 1 1");
    }
}
