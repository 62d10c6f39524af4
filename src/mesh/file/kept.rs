//! Statements of a file that the mesh cannot represent, kept to be written back.

use std::collections::HashMap;
use std::fmt;

use super::corners::OfCorner;
use super::scan::Scanner;
use crate::mesh::polygons::Polygons;

/// Marks a missing index.
pub(super) const MISSING: u32 = u32::MAX;

/// Everything kept beside the mesh.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    /// The operands of `mtllib`.
    pub(super) libraries: Vec<Vec<u8>>,
    /// The lines `comment` and `obj_info` of a PLY file.
    pub(super) comments: Vec<Vec<u8>>,
    /// The operands of `o`, `g`, `usemtl` and `s`, which states refer to by index.
    pub(super) names: Vec<Vec<u8>>,
    /// The numbers of the physical groups of a Gmsh file, by name.
    pub(super) group_numbers: HashMap<Vec<u8>, i64>,
    /// The states, each with the index of the face at which it starts.
    pub(super) states: Vec<(u32, State)>,
    pub(super) texture: Rows,
    pub(super) normals: Rows,
    /// For each corner of the file's faces, in order, its row. Both stay empty while no corner has
    /// one, and are as long as the corners otherwise.
    pub(super) corner_texture: Vec<u32>,
    pub(super) corner_normals: Vec<u32>,
    /// The polygons as read; none if neither corners nor faces have anything to keep.
    pub(super) corners: Polygons,
    /// The keywords of statements that are not part of a mesh, such as `l` and `p`: the first few,
    /// with their lines.
    pub(super) skipped: Vec<(String, u32)>,
    /// Other parts of the file that are not in the mesh.
    pub(super) notes: Vec<Note>,
}

/// A part of a file that is not in the mesh.
#[derive(Clone, Debug)]
pub(super) struct Note {
    /// In words, singular and plural.
    what: [String; 2],
    count: usize,
    /// The first line where it occurs.
    line: Option<u32>,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.count, self.what[usize::from(self.count != 1)])?;
        self.line.map_or(Ok(()), |line| write!(f, ", first in line {line}"))
    }
}

/// The number of keywords of skipped statements that are reported.
const MOST_SKIPPED: usize = 8;

/// The statements in force at a face, by their indices in `names`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct State(pub(super) [u32; 4]);

impl State {
    /// The keywords of the statements that make up a state, in the order in which they are written.
    pub(super) const KEYWORDS: [&'static str; 4] = ["o", "g", "usemtl", "s"];

    /// What these statements name, in the plural.
    pub(super) const NAMED: [&'static str; 4] =
        ["objects", "groups", "materials", "smoothing groups"];

    pub(super) const EMPTY: Self = Self([MISSING; 4]);
}

impl Kept {
    /// Notes a statement that is not kept.
    pub(super) fn skip(&mut self, keyword: &str, line: u32) {
        let word: String = keyword.chars().take(16).collect();
        let known = &mut self.skipped;
        // Only the first of a file are reported, and these are among the first of its parts.
        if known.len() <= 2 * MOST_SKIPPED && !known.iter().any(|(other, _)| *other == word) {
            known.push((word, line));
        }
    }

    /// The first keywords of statements that are not kept, with their lines.
    pub(super) fn skipped_keywords(&self) -> impl Iterator<Item = (&str, u32)> {
        let known = self.skipped.iter().take(MOST_SKIPPED + 1).enumerate();
        // If there are more, the last is an ellipsis.
        known.map(|(i, (word, line))| (if i < MOST_SKIPPED { word } else { "…" }, *line))
    }

    /// Adds what is noted for the next part of a file, which starts after `lines` lines.
    pub(super) fn append(&mut self, skipped: Vec<(String, u32)>, notes: Vec<Note>, lines: u32) {
        skipped.into_iter().for_each(|(word, line)| self.skip(&word, line + lines));
        for note in notes {
            match self.notes.iter_mut().find(|known| known.what == note.what) {
                Some(known) => known.count += note.count,
                None => {
                    let line = note.line.map(|line| line + lines);
                    self.notes.push(Note { line, ..note });
                }
            }
        }
    }

    /// Notes a part of the file that is not in the mesh, in words, singular and plural.
    pub(super) fn note(&mut self, what: [&str; 2], line: u32) {
        match self.notes.iter_mut().find(|known| known.what == what) {
            Some(known) => known.count += 1,
            None => {
                let what = what.map(str::to_owned);
                self.notes.push(Note { what, count: 1, line: Some(line) });
            }
        }
    }

    /// Notes something that occurs `count` times in a file, in words, singular and plural.
    pub(super) fn note_count(&mut self, what: [impl Into<String>; 2], count: usize) {
        if count > 0 {
            self.notes.push(Note { what: what.map(Into::into), count, line: None });
        }
    }

    /// Notes the lines behind the last element of a file; `before` lines precede the text.
    pub(super) fn note_lines_behind(&mut self, rest: &mut Scanner, element: &str, before: u32) {
        let what = ["line", "lines"].map(|word| format!("{word} behind the last {element}"));
        while rest.next_line() {
            self.note(what.each_ref().map(String::as_str), before + rest.line());
            rest.end_line();
        }
    }

    /// Notes the bytes behind the last element of a binary file, unless all are blank.
    pub(super) fn note_bytes_behind(&mut self, rest: &[u8], element: &str) {
        if !rest.trim_ascii().is_empty() {
            let what = ["byte", "bytes"].map(|word| format!("{word} behind the last {element}"));
            self.note_count(what, rest.len());
        }
    }

    /// The texture coordinates or normals, and the row of each corner.
    pub(super) fn at_corners(&mut self, what: OfCorner) -> (&mut Rows, &mut Vec<u32>) {
        match what {
            OfCorner::Texture => (&mut self.texture, &mut self.corner_texture),
            OfCorner::Normal => (&mut self.normals, &mut self.corner_normals),
        }
    }

    /// True if corners of the file have something to keep.
    pub(super) fn has_corners(&self) -> bool {
        !(self.corner_texture.is_empty() && self.corner_normals.is_empty())
    }

    /// True if the polygon of each corner of the file is needed.
    pub(super) fn needs_polygons(&self) -> bool {
        self.has_corners() || !self.states.is_empty()
    }

    /// The state at a face of the file.
    pub(super) fn state(&self, face: u32) -> State {
        let after = self.states.partition_point(|&(first, _)| first <= face);
        after.checked_sub(1).map_or(State::EMPTY, |i| self.states[i].1)
    }

    /// Notes a statement that is in force from `face` on.
    pub(super) fn enter_state(&mut self, face: u32, keyword: usize, name: &[u8]) {
        let mut state = self.states.last().map_or(State::EMPTY, |&(_, state)| state);
        let known = self.names.get(state.0[keyword] as usize);
        if known.is_some_and(|known| known == name) {
            return;
        }
        state.0[keyword] = self.names.len() as u32;
        self.names.push(name.to_vec());
        match self.states.last_mut() {
            Some((first, last)) if *first == face => *last = state,
            _ => self.states.push((face, state)),
        }
    }

    /// Adds one statement for each face, given the index of its name in `names`; an invalid index
    /// means none.
    pub(super) fn add_states(&mut self, keyword: usize, names: &[Vec<u8>], numbers: &[f64]) {
        let first = self.names.len() as u32;
        self.names.extend_from_slice(names);
        let mut before = std::mem::take(&mut self.states).into_iter().peekable();
        let mut state = State::EMPTY;
        for (face, &number) in (0..).zip(numbers) {
            let old = state;
            if let Some((_, others)) = before.next_if(|&(at, _)| at == face) {
                state = others; // the name of this keyword follows
            }
            let is_named = number >= 0.0 && number < names.len() as f64;
            state.0[keyword] = if is_named { first + number as u32 } else { MISSING };
            if state != old {
                self.states.push((face, state));
            }
        }
    }
}

/// A table of rows of up to three numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    pub(super) rows: Vec<[f64; 3]>,
    /// The number of columns that are written.
    pub(super) width: usize,
}
