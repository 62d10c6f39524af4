//! A picture as SVG.
//!
//! Colours stand in the attributes, so that any viewer shows them; a style sheet changes them
//! where a viewer asks for dark. Coordinates are rounded here and nowhere else.

use std::fmt::Write;

use glam::DVec2;

use super::shape::{Group, Ink, Paint, Path, Picture, Shape, Step};

impl Picture {
    /// The picture as SVG.
    pub fn svg(&self) -> String {
        let [width, height] = self.size().map(f64::ceil);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
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
        for group in &self.groups {
            write_group(&mut text, group);
        }
        text.push_str("</svg>\n");
        text
    }
}

fn write_group(text: &mut String, group: &Group) {
    if group.id.is_empty() {
        text.push_str("<g>\n");
    } else {
        let _ = write!(text, "<g id=\"{}\">", escaped(&group.id));
        let _ = writeln!(text, "<title>{}</title>", escaped(&group.title));
    }
    for shape in &group.shapes {
        write_shape(text, shape);
    }
    text.push_str("</g>\n");
}

fn write_shape(text: &mut String, shape: &Shape) {
    let d = data(&shape.path);
    let _ = match shape.paint {
        Paint::Fill(ink) => {
            let ([light, _], class) = (ink.colours(), ink.class());
            writeln!(
                text,
                "<path class=\"fill-{class}\" fill=\"#{light:06x}\" d=\"{d}\"/>"
            )
        }
        Paint::Stroke(stroke) => {
            let ([light, _], class) = (stroke.ink.colours(), stroke.ink.class());
            let mut more = String::new();
            if let Some([dash, gap]) = stroke.dash {
                let _ = write!(more, " stroke-dasharray=\"{dash} {gap}\"");
            }
            if stroke.opacity < 1.0 {
                let _ = write!(more, " stroke-opacity=\"{}\"", stroke.opacity);
            }
            writeln!(
                text,
                "<path class=\"stroke-{class}\" fill=\"none\" stroke=\"#{light:06x}\" \
                 stroke-width=\"{}\"{more} d=\"{d}\"/>",
                number(stroke.width)
            )
        }
    };
}

fn data(path: &Path) -> String {
    let mut data = String::new();
    for step in &path.steps {
        match *step {
            Step::Move(to) => point(&mut data, 'M', to),
            Step::Line(to) => point(&mut data, 'L', to),
            Step::Curve(by, to) => {
                point(&mut data, 'Q', by);
                point(&mut data, ' ', to);
            }
            Step::Close => data.push('Z'),
        }
    }
    data
}

fn point(data: &mut String, step: char, at: DVec2) {
    let _ = write!(data, "{step}{} {}", number(at.x), number(at.y));
}

/// A number with at most two digits behind the point; what is no number is 0.
fn number(value: f64) -> f64 {
    let rounded = (value * 100.0).round() / 100.0;
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
