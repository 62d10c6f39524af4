//! A picture as SVG.
//!
//! Colours are in attributes, so that any viewer shows them; a style sheet overrides them in dark
//! mode. Coordinates are rounded only when they are written.

use std::fmt::{Display, Write};

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;

use super::shape::{FADED, Group, Ink, Paint, Picture, Stroke};
use super::steps::Grain;
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
        let words = Words::of(self, [&prefix, "xlink:href"], 1.0, 1000.0);
        text.push_str(&words.definitions());
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
        let ink = match shape.paint {
            Paint::Fill(ink) | Paint::Stroke(Stroke { ink, .. }) => ink,
        };
        let ([light, _], class) = (ink.colours(), ink.class());
        let attributes = match shape.paint {
            Paint::Fill(_) => format!("class=\"fill-{class}\" fill=\"#{light:06x}\""),
            Paint::Stroke(stroke) => format!(
                "class=\"stroke-{class}\" fill=\"none\" stroke=\"#{light:06x}\"{}",
                stroke_attributes(stroke, number)
            ),
        };
        let _ = writeln!(text, "{}", words.element(shape, &attributes, TENTHS));
    }
    text.push_str("</g>\n");
}

/// The width, the dashes and the opacity of a stroke, its lengths rounded by `length`.
pub(super) fn stroke_attributes<T: Display>(stroke: Stroke, length: fn(f64) -> T) -> String {
    let mut text = format!(" stroke-width=\"{}\"", length(stroke.width));
    if let Some([dash, gap]) = stroke.dash.map(|dash| dash.map(length)) {
        let _ = write!(text, " stroke-dasharray=\"{dash} {gap}\"");
    }
    if stroke.opacity < 1.0 {
        let _ = write!(text, " stroke-opacity=\"{}\"", stroke.opacity);
    }
    text
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
