//! Definitions of an SVG, written once and referenced wherever they occur: letters, and the words
//! made of them.
//!
//! A name occurs on both sides of an operation and in each of its rules, and most words of a
//! picture share letters. Both SVG writers use these definitions; a use of a word gives only its
//! place and its colour.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use glam::DVec2;

use super::letters::{Glyph, Style, letter as outline};
use super::shape::{Picture, Shape};
use super::steps::{Grain, data};
use super::svg::escaped;

/// A letter of a word: its style, its character, and, in tenths, its offset right and down from the
/// first letter and its size.
type Set = (Style, char, [i64; 3]);

/// The words of a picture, each with its number.
pub(super) struct Words<'a> {
    /// The text before every id.
    prefix: &'a str,
    /// The attribute that references a definition.
    link: &'a str,
    /// The number of steps to a unit of the picture.
    steps: f64,
    /// The size at which letters are defined.
    em: f64,
    numbers: BTreeMap<Vec<Set>, usize>,
}

impl<'a> Words<'a> {
    /// Collects the words of a picture, for a writer with `steps` steps to a unit, which defines
    /// letters at a size of `em`.
    pub fn of(picture: &Picture, [prefix, link]: [&'a str; 2], steps: f64, em: f64) -> Self {
        let mut numbers = BTreeMap::new();
        for shape in picture.groups.iter().flat_map(|group| &group.shapes) {
            if !shape.glyphs.is_empty() {
                let number = numbers.len();
                numbers.entry(set(&shape.glyphs)).or_insert(number);
            }
        }
        Self { prefix, link, steps, em, numbers }
    }

    /// The definitions of letters and words.
    pub fn definitions(&self) -> String {
        let Self { prefix, link, steps, em, .. } = self;
        let letters = self.numbers.keys().flatten();
        let letters: BTreeSet<_> = letters.map(|&(style, code, _)| (style, code)).collect();
        // Without a colour: they inherit that of their use.
        let mut text = String::from("<defs>\n");
        for (style, code) in letters {
            let grain = Grain { parts: em / 1000.0, measure: 1.0, slack: 1 };
            let id = letter_id(style, code);
            let _ = match outline(style, code) {
                Some(outline) => {
                    let outline = data(&outline, grain);
                    writeln!(text, "<path id=\"{prefix}{id}\" d=\"{outline}\"/>")
                }
                None => {
                    let code = escaped(code.encode_utf8(&mut [0; 4]));
                    writeln!(text, "<text id=\"{prefix}{id}\" font-size=\"{em}\">{code}</text>")
                }
            };
        }
        for (word, number) in &self.numbers {
            let _ = write!(text, "<g id=\"{prefix}w{number}\">");
            // Consecutive letters of one size are scaled together; their places are relative to
            // that scale.
            for run in word.chunk_by(|(_, _, a), (_, _, b)| a[2] == b[2]) {
                let size = run[0].2[2] as f64;
                let scale = (size * steps / em * 1000.0).round() / 10_000.0;
                let _ = write!(text, "<g transform=\"scale({scale})\">");
                for &(style, code, [x, y, _]) in run {
                    let id = letter_id(style, code);
                    let _ = write!(text, "<use {link}=\"#{prefix}{id}\"");
                    for (axis, tenths) in [("x", x), ("y", y)] {
                        let place = (tenths as f64 * em / size).round();
                        if place != 0.0 {
                            let _ = write!(text, " {axis}=\"{place}\"");
                        }
                    }
                    text.push_str("/>");
                }
                text.push_str("</g>");
            }
            text.push_str("</g>\n");
        }
        text.push_str("</defs>\n");
        text
    }

    /// A shape as an element with these attributes: its path, or its word where that is used.
    pub fn element(&self, shape: &Shape, attributes: &str, grain: Grain) -> String {
        let Some(first) = shape.glyphs.first() else {
            return format!("<path {attributes} d=\"{}\"/>", data(&shape.path, grain));
        };
        let Self { prefix, link, .. } = self;
        let number = self.numbers.get(&set(&shape.glyphs)).copied().unwrap_or(0);
        let [x, y] = self.place(first.at);
        let turn = shape.turn.map_or_else(String::new, |(turn, around)| {
            let [x, y] = self.place(around);
            format!(" transform=\"rotate({turn} {x} {y})\"")
        });
        format!("<use {attributes} {link}=\"#{prefix}w{number}\" x=\"{x}\" y=\"{y}\"{turn}/>")
    }

    /// A place in steps, rounded to tenths of a unit.
    fn place(&self, at: DVec2) -> [f64; 2] {
        // Adding zero turns `-0` into `0`.
        at.to_array().map(|length| (length * 10.0).round() * self.steps / 10.0 + 0.0)
    }
}

/// Letters with their offsets from the first.
fn set(glyphs: &[Glyph]) -> Vec<Set> {
    let tenths = |length: f64| (length * 10.0).round() as i64;
    let first = glyphs.first().map_or(DVec2::ZERO, |first| first.at);
    let glyphs = glyphs.iter().map(|glyph| {
        let by = glyph.at - first;
        let numbers = [tenths(by.x), tenths(by.y), tenths(glyph.size)];
        (glyph.style, glyph.code, numbers)
    });
    glyphs.collect()
}

fn letter_id(style: Style, code: char) -> String {
    let style = match style {
        Style::Italic => 'i',
        Style::Upright => 'u',
    };
    format!("{style}{:x}", u32::from(code))
}
