//! A picture as SVG.
//!
//! Colours stand in the attributes, so that any viewer shows them; a style sheet changes them
//! where a viewer asks for dark. Coordinates are rounded here and nowhere else.

use std::collections::BTreeMap;
use std::fmt::Write;

use glam::DVec2;

use super::shape::{Group, Ink, Paint, Path, Picture, Step, Stroke};

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
        let mut seen = Seen::of(self);
        for group in &self.groups {
            seen.write_group(&mut text, group);
        }
        text.push_str("</svg>\n");
        text
    }
}

/// What is filled more than once, but for its place: names, and the dots of vertices. It is
/// written where it comes first, and used again from there.
struct Seen {
    title: String,
    /// How often each outline comes, and the number it has got.
    outlines: BTreeMap<String, (usize, Option<usize>)>,
    numbers: usize,
}

/// An outline shorter than this is written again.
const WORTH_USING: usize = 90;

impl Seen {
    fn of(picture: &Picture) -> Self {
        let mut outlines = BTreeMap::new();
        let shapes = picture.groups.iter().flat_map(|group| &group.shapes);
        for shape in shapes.filter(|shape| matches!(shape.paint, Paint::Fill(_))) {
            let outline = outlines.entry(data(&shape.path, start(&shape.path)));
            outline.or_insert((0, None)).0 += 1;
        }
        Self {
            title: picture.title.clone(),
            outlines,
            numbers: 0,
        }
    }

    fn write_group(&mut self, text: &mut String, group: &Group) {
        if group.id.is_empty() {
            text.push_str("<g>\n");
        } else {
            let _ = write!(text, "<g id=\"{}\">", escaped(&group.id));
            let _ = writeln!(text, "<title>{}</title>", escaped(&group.title));
        }
        for shape in &group.shapes {
            match shape.paint {
                Paint::Fill(ink) => self.write_fill(text, &shape.path, ink),
                Paint::Stroke(stroke) => write_stroke(text, &shape.path, stroke),
            }
        }
        text.push_str("</g>\n");
    }

    fn write_fill(&mut self, text: &mut String, path: &Path, ink: Ink) {
        let ([light, _], class) = (ink.colours(), ink.class());
        let fill = format!("class=\"fill-{class}\" fill=\"#{light:06x}\"");
        let from = start(path);
        let outline = data(path, from);
        let place = format!("{} {}", number(from.x), number(from.y));
        let known = self.outlines.get_mut(&outline);
        let id = |number: usize| format!("{}-outline-{number}", escaped(&self.title));
        let _ = match known {
            Some((times, number)) if *times > 1 && outline.len() >= WORTH_USING => match *number {
                Some(number) => writeln!(
                    text,
                    "<use {fill} xlink:href=\"#{}\" transform=\"translate({place})\"/>",
                    id(number)
                ),
                None => {
                    self.numbers += 1;
                    *number = Some(self.numbers);
                    // The path itself has no colour: it takes that of the place where it is used.
                    writeln!(
                        text,
                        "<defs><path id=\"{0}\" d=\"{outline}\"/></defs>\n\
                         <use {fill} xlink:href=\"#{0}\" transform=\"translate({place})\"/>",
                        id(self.numbers)
                    )
                }
            },
            _ => writeln!(text, "<path {fill} d=\"{}\"/>", data(path, DVec2::ZERO)),
        };
    }
}

/// Where a path begins.
fn start(path: &Path) -> DVec2 {
    match path.steps.first() {
        Some(Step::Move(to) | Step::Line(to) | Step::Curve(_, to)) => *to,
        Some(Step::Close) | None => DVec2::ZERO,
    }
}

fn write_stroke(text: &mut String, path: &Path, stroke: Stroke) {
    let ([light, _], class) = (stroke.ink.colours(), stroke.ink.class());
    let mut more = String::new();
    if let Some([dash, gap]) = stroke.dash {
        let _ = write!(more, " stroke-dasharray=\"{dash} {gap}\"");
    }
    if stroke.opacity < 1.0 {
        let _ = write!(more, " stroke-opacity=\"{}\"", stroke.opacity);
    }
    let _ = writeln!(
        text,
        "<path class=\"stroke-{class}\" fill=\"none\" stroke=\"#{light:06x}\" \
         stroke-width=\"{}\"{more} d=\"{}\"/>",
        number(stroke.width),
        data(path, DVec2::ZERO)
    );
}

/// The steps of a path, seen from a place, each but the first relative to the one before. The
/// places are rounded, not the steps, so that nothing adds up.
fn data(path: &Path, from: DVec2) -> String {
    let mut data = Steps::default();
    for step in &path.steps {
        match *step {
            Step::Move(to) => data.to('m', &[to - from]),
            Step::Line(to) => data.to('l', &[to - from]),
            Step::Curve(by, to) => data.to('q', &[by - from, to - from]),
            Step::Close => data.close(),
        }
    }
    data.text
}

/// Steps as text, in hundredths.
#[derive(Default)]
struct Steps {
    text: String,
    at: [i64; 2],
    /// Where the last polygon began: to close it leads back there.
    began: [i64; 2],
}

impl Steps {
    fn to(&mut self, step: char, points: &[DVec2]) {
        self.text.push(step);
        let mut last = self.at;
        for (nth, point) in points.iter().enumerate() {
            last = [point.x, point.y].map(hundredths);
            for (axis, (to, from)) in last.into_iter().zip(self.at).enumerate() {
                let way = to - from;
                // A sign parts two numbers as well as a space does.
                if (nth > 0 || axis > 0) && way >= 0 {
                    self.text.push(' ');
                }
                let _ = write!(self.text, "{}", way as f64 / 100.0);
            }
        }
        self.at = last;
        if step == 'm' {
            self.began = last;
        }
    }

    fn close(&mut self) {
        self.text.push('z');
        self.at = self.began;
    }
}

/// A coordinate in hundredths; what is no number is 0.
fn hundredths(value: f64) -> i64 {
    (value * 100.0).round() as i64
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
