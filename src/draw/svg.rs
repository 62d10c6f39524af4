//! A picture as SVG.
//!
//! Colours are in attributes, so that any viewer shows them; a style sheet overrides them in dark
//! mode. Coordinates are rounded only when they are written.

use std::fmt::Write;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;

use super::shape::{FADED, Group, Ink, Paint, Path, Picture, Shape, Stroke};
use super::steps::{Grain, data};
use super::words::Words;

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
        if let Some((image, data)) = self.image.as_ref().and_then(|i| Some((i, i.png()?))) {
            let (side, data) = (image.size, BASE64_STANDARD.encode(data));
            let _ = writeln!(
                text,
                "<image width=\"{side}\" height=\"{side}\" xlink:href=\"data:image/png;base64,{data}\"/>"
            );
        }
        let title = escaped(&self.title);
        // Pages hold several pictures, so that ids begin with the title.
        let prefix = format!("{title}-");
        let words = Words::of(self, &prefix, 1.0, 1000.0);
        text.push_str(&words.definitions("xlink:href"));
        for group in &self.groups {
            write_group(&mut text, group, &words);
        }
        text.push_str("</svg>\n");
        text
    }
}

fn write_group(text: &mut String, group: &Group, words: &Words) {
    let faded = if group.is_faded { format!(" opacity=\"{FADED}\"") } else { String::new() };
    if group.id.is_empty() {
        let _ = writeln!(text, "<g{faded}>");
    } else {
        let _ = write!(text, "<g id=\"{}\"{faded}>", escaped(&group.id));
        let _ = writeln!(text, "<title>{}</title>", escaped(&group.title));
    }
    for shape in &group.shapes {
        match shape.paint {
            Paint::Fill(ink) => write_fill(text, shape, ink, words),
            Paint::Stroke(stroke) => write_stroke(text, &shape.path, stroke),
        }
    }
    text.push_str("</g>\n");
}

fn write_fill(text: &mut String, shape: &Shape, ink: Ink, words: &Words) {
    let ([light, _], class) = (ink.colours(), ink.class());
    let fill = format!("class=\"fill-{class}\" fill=\"#{light:06x}\"");
    if shape.glyphs.is_empty() {
        let _ = writeln!(text, "<path {fill} d=\"{}\"/>", data(&shape.path, TENTHS));
        return;
    }
    let (id, [x, y]) = words.used(&shape.glyphs);
    let turn = words.turned(shape.turn);
    let _ = writeln!(text, "<use {fill} xlink:href=\"#{id}\" x=\"{x}\" y=\"{y}\"{turn}/>");
}

fn write_stroke(text: &mut String, path: &Path, stroke: Stroke) {
    let ([light, _], class) = (stroke.ink.colours(), stroke.ink.class());
    let mut more = String::new();
    if let Some([dash, gap]) = stroke.dash {
        let _ = write!(more, " stroke-dasharray=\"{} {}\"", number(dash), number(gap));
    }
    if stroke.opacity < 1.0 {
        let _ = write!(more, " stroke-opacity=\"{}\"", stroke.opacity);
    }
    let _ = writeln!(
        text,
        "<path class=\"stroke-{class}\" fill=\"none\" stroke=\"#{light:06x}\" \
         stroke-width=\"{}\"{more} d=\"{}\"/>",
        number(stroke.width),
        data(path, TENTHS)
    );
}

/// Coordinates of pictures are rounded to tenths.
const TENTHS: Grain = Grain { parts: 10.0, measure: 10.0, slack: 1 };

/// A number with at most one decimal place; 0 if it is not finite.
fn number(value: f64) -> f64 {
    let rounded = (value * 10.0).round() / 10.0;
    // Adding zero turns `-0` into `0`.
    if rounded.is_finite() { rounded + 0.0 } else { 0.0 }
}

/// Escapes a text for XML.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
