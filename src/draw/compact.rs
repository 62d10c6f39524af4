//! A picture as a small SVG, for those who limit the size of an image, as editors do.
//!
//! It shows the same as [`Picture::svg`], in about a third of the letters: steps are relative
//! and count tenths of a unit, colours stand once, in a style sheet, and a letter is drawn
//! together with the ground around it. Viewers that read no style sheets are not served.

use std::fmt::Write;

use glam::DVec2;

use super::shape::{Group, Ink, Paint, Path, Picture, Shape, Step, Stroke};
use super::svg::escaped;

/// How many steps a unit has.
const STEPS: f64 = 10.0;

impl Picture {
    /// The picture as a small SVG.
    pub fn compact_svg(&self) -> String {
        let [width, height] = self.size().map(f64::ceil);
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {} {}\"><title>{}</title><style>path{{stroke-linecap:round;\
             stroke-linejoin:round;fill:none;paint-order:stroke}}",
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
            "path.f{name},rect.f{name}{{fill:#{colour:06x}}}path.s{name}{{stroke:#{colour:06x}}}"
        );
    }
}

/// The letter of an ink.
fn name(ink: Ink) -> char {
    ink.class().chars().next().unwrap_or('x')
}

fn write_group(text: &mut String, group: &Group) {
    let mut shapes = group.shapes.iter().peekable();
    while let Some(shape) = shapes.next() {
        // The ground around a letter, and the letter on it.
        let is_ground = matches!(shape.paint, Paint::Stroke(_));
        let above = shapes.next_if(|above| is_ground && is_fill(above) && above.path == shape.path);
        write_shape(text, shape, above);
    }
}

fn is_fill(shape: &Shape) -> bool {
    matches!(shape.paint, Paint::Fill(_))
}

fn write_shape(text: &mut String, shape: &Shape, above: Option<&Shape>) {
    let mut classes = Vec::new();
    let mut more = String::new();
    for part in std::iter::once(shape).chain(above) {
        match part.paint {
            Paint::Fill(ink @ Ink::Shade(_)) => {
                let _ = write!(more, " style=\"fill:#{:06x}\"", ink.colours()[0]);
            }
            Paint::Fill(ink) => classes.push(format!("f{}", name(ink))),
            Paint::Stroke(stroke) => {
                classes.push(format!("s{}", name(stroke.ink)));
                write_stroke(&mut more, stroke);
            }
        }
    }
    let classes = classes.join(" ");
    let data = data(&shape.path);
    let _ = write!(text, "<path class=\"{classes}\"{more} d=\"{data}\"/>");
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

fn data(path: &Path) -> String {
    let mut data = String::new();
    let (mut start, mut at) = ([0, 0], [0, 0]);
    let mut last = ' ';
    for step in &path.steps {
        let round = |point: DVec2| [steps(point.x), steps(point.y)];
        let (letter, points): (char, Vec<_>) = match *step {
            Step::Move(to) => ('m', vec![round(to)]),
            Step::Line(to) => ('l', vec![round(to)]),
            Step::Curve(by, to) => ('q', vec![round(by), round(to)]),
            Step::Close => {
                data.push('z');
                (at, last) = (start, 'z');
                continue;
            }
        };
        // A second `m` would be read as a line.
        let mut is_first = letter != last || letter == 'm';
        if is_first {
            data.push(letter);
        }
        for point in &points {
            for (to, from) in point.iter().zip(at) {
                let by = to - from;
                if !is_first && by >= 0 {
                    data.push(' ');
                }
                is_first = false;
                let _ = write!(data, "{by}");
            }
        }
        at = points[points.len() - 1];
        if letter == 'm' {
            start = at;
        }
        last = letter;
    }
    data
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
        assert_eq!(data(&path), "m10 20l20-5 0 10zm-10-20q10 0 10 10");
    }
}
