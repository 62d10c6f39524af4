//! Letters as outlines, so that a picture looks the same on machines without fonts.
//!
//! A line of `letters/italic.txt` and `letters/upright.txt` is a character's code, its width and
//! its outline, in thousandths of an em, y up: those of ASCII, Latin-1 and the Greek alphabet, and a
//! few signs. There is no kerning and no hinting. A missing character is left to the fonts of the
//! viewer in an SVG, and is a box in a PNG.

use glam::DVec2;
use std::sync::LazyLock;

use super::shape::Path;

/// The style of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Style {
    Italic,
    Upright,
}

/// The height of capitals and ascenders, and the depth of descenders, in ems.
const ASCENT: f64 = 0.68;
const DESCENT: f64 = 0.2;
/// The size of a subscript, and how far it is lowered, in ems.
const SUBSCRIPT: f64 = 0.72;
const DROP: f64 = 0.17;

struct Letter {
    code: char,
    width: f64,
    outline: Vec<(char, Vec<f64>)>,
}

static ITALIC: LazyLock<Vec<Letter>> = LazyLock::new(|| read(include_str!("letters/italic.txt")));
static UPRIGHT: LazyLock<Vec<Letter>> = LazyLock::new(|| read(include_str!("letters/upright.txt")));

fn read(text: &str) -> Vec<Letter> {
    let letter = |line: &str| {
        let mut parts = line.splitn(3, ' ');
        let code = u32::from_str_radix(parts.next()?, 16).ok()?;
        Some(Letter {
            code: char::from_u32(code)?,
            width: parts.next()?.parse().ok()?,
            outline: outline(parts.next().unwrap_or("")),
        })
    };
    text.lines().filter_map(letter).collect()
}

fn outline(text: &str) -> Vec<(char, Vec<f64>)> {
    let mut steps: Vec<(char, String)> = Vec::new();
    for character in text.chars() {
        match steps.last_mut() {
            _ if character.is_ascii_alphabetic() => steps.push((character, String::new())),
            Some((_, numbers)) => numbers.push(character),
            None => {}
        }
    }
    let numbers = |text: &str| text.split(' ').filter_map(|part| part.parse().ok()).collect();
    steps.into_iter().map(|(step, text)| (step, numbers(&text))).collect()
}

/// A typeset letter: its style, character, origin and size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Glyph {
    pub style: Style,
    pub code: char,
    pub at: DVec2,
    pub size: f64,
}

/// The outline of a letter at a thousand units to the em, y down; `None` if it is missing.
pub(super) fn letter(style: Style, code: char) -> Option<Path> {
    find(style, code)?;
    let mut setting = Setting::default();
    setting.add(code.encode_utf8(&mut [0; 4]), style, 1000.0, 0.0);
    Some(setting.path)
}

fn find(style: Style, code: char) -> Option<&'static Letter> {
    let letters = match style {
        Style::Italic => &*ITALIC,
        Style::Upright => &*UPRIGHT,
    };
    letters.iter().find(|letter| letter.code == code)
}

/// A typeset text: its outline, with the center of its box at zero.
#[derive(Clone, Debug)]
pub(super) struct Label {
    /// The outline.
    pub path: Path,
    /// The same letter by letter, before rotation.
    pub glyphs: Vec<Glyph>,
    /// Half its width and half its height, before rotation.
    pub half: DVec2,
    /// Its rotation in degrees, clockwise.
    pub turn: i32,
}

impl Label {
    /// The same text turned to run along a direction, but never upside down.
    pub fn turned_along(mut self, way: DVec2) -> Self {
        let way = if way.x < -1e-6 || (way.x.abs() <= 1e-6 && way.y > 0.0) { -way } else { way };
        self.turn = way.y.atan2(way.x).to_degrees().round() as i32;
        self.path = self.path.turned(self.rotation());
        self
    }

    /// Its rotation, as a unit vector.
    pub fn rotation(&self) -> DVec2 {
        DVec2::from_angle(f64::from(self.turn).to_radians())
    }

    /// The boxes it fills side by side, as centers and half sizes: one, or several if it is
    /// slanted.
    pub fn boxes(&self) -> Vec<(DVec2, DVec2)> {
        let along = self.rotation();
        let wide = along.abs() * self.half.x + along.perp().abs() * self.half.y;
        if self.turn % 90 == 0 {
            return vec![(DVec2::ZERO, wide)];
        }
        let count = (2.0 * self.half.x / self.half.y).ceil().max(1.0);
        let piece = along * (2.0 * self.half.x / count);
        let half = match piece.x > piece.y.abs() {
            true => DVec2::new(piece.x / 2.0, wide.y.min(self.half.y + piece.y.abs() / 2.0)),
            false => DVec2::new(wide.x.min(self.half.y + piece.x / 2.0), piece.y.abs() / 2.0),
        };
        // Slightly smaller than a piece, so that they do not overlap.
        let half = half - 1e-6;
        let middle = |at: usize| piece * (at as f64 - (count - 1.0) / 2.0);
        (0..count as usize).map(|at| (middle(at), half)).collect()
    }
}

/// The same letters, moved.
pub(super) fn moved(glyphs: &[Glyph], by: DVec2) -> Vec<Glyph> {
    glyphs.iter().map(|&glyph| Glyph { at: glyph.at + by, ..glyph }).collect()
}

/// Typesets a name: letters in italics, trailing digits and the text in brackets as a subscript,
/// primes raised.
pub(super) fn name(text: &str, size: f64) -> Label {
    let (text, index) = text.split_once('[').unwrap_or((text, ""));
    let index = index.trim_end_matches(']');
    let stem = text.trim_end_matches('\'');
    let primes = text.len() - stem.len();
    let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    // A number, alone or behind a word, is no subscript.
    let (letters, digits) = match letters.is_empty() || letters.ends_with(' ') {
        true => (stem, ""),
        false => stem.split_at(letters.len()),
    };
    let mut setting = Setting::default();
    setting.add(letters, Style::Italic, size, 0.0);
    let top = setting.x;
    let (small, drop) = (size * SUBSCRIPT, DROP * size);
    setting.add(digits, Style::Upright, small, drop);
    if !digits.is_empty() && !index.is_empty() {
        setting.add(",", Style::Upright, small, drop);
    }
    for part in index.chars() {
        let (style, part) = match part {
            '-' => (Style::Upright, '\u{2212}'),
            part if part.is_ascii_alphabetic() => (Style::Italic, part),
            part => (Style::Upright, part),
        };
        setting.add(part.encode_utf8(&mut [0; 4]), style, small, drop);
    }
    let behind = setting.x;
    if primes > 0 {
        setting.x = top;
        setting.add(&"\u{2032}".repeat(primes), Style::Upright, size, 0.0);
        setting.x = setting.x.max(behind);
    }
    setting.label(size)
}

/// Typesets a line of words.
pub(super) fn words(text: &str, style: Style, size: f64) -> Label {
    let mut setting = Setting::default();
    setting.add(text, style, size, 0.0);
    setting.label(size)
}

#[derive(Default)]
struct Setting {
    path: Path,
    glyphs: Vec<Glyph>,
    x: f64,
}

impl Setting {
    fn add(&mut self, text: &str, style: Style, size: f64, drop: f64) {
        let scale = size / 1000.0;
        for code in text.chars() {
            let x = self.x;
            self.glyphs.push(Glyph { style, code, at: DVec2::new(x, drop), size });
            let place = |p: &[f64]| DVec2::new(x + p[0] * scale, drop - p[1] * scale);
            let Some(letter) = find(style, code) else {
                // East Asian characters fill a square.
                let width = if code < '\u{1100}' { 600.0 } else { 1000.0 };
                let right = width - 60.0;
                let corners = [[60., 0.], [60., 600.], [right, 600.], [right, 0.]];
                self.path.polygon(corners.map(|corner| place(&corner)));
                self.x += width * scale;
                continue;
            };
            for (step, numbers) in &letter.outline {
                let points: Vec<_> = numbers.chunks_exact(2).map(place).collect();
                match (step, &points[..]) {
                    ('M', &[to]) => self.path.move_to(to),
                    ('L', &[to]) => self.path.line_to(to),
                    ('Q', &[by, to]) => self.path.curve_to(by, to),
                    _ => self.path.close(),
                }
            }
            self.x += letter.width * scale;
        }
    }

    fn label(self, size: f64) -> Label {
        let half = DVec2::new(self.x / 2.0, (ASCENT + DESCENT) / 2.0 * size);
        let middle = DVec2::new(half.x, -(ASCENT - DESCENT) / 2.0 * size);
        let (path, glyphs) = (self.path.moved(-middle), moved(&self.glyphs, -middle));
        Label { path, glyphs, half, turn: 0 }
    }
}
