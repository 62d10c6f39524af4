//! What a file says that the mesh has no place for, kept to be written back.

/// Stands for "none" where an index of the file may be missing.
pub(super) const MISSING: u32 = u32::MAX;

/// Everything kept beside the mesh.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    /// The operands of `mtllib`.
    pub(super) libraries: Vec<Vec<u8>>,
    /// The operands of `o`, `g`, `usemtl` and `s`, which states name by place.
    pub(super) names: Vec<Vec<u8>>,
    /// Where a state begins to hold: the place of the face, from 0.
    pub(super) states: Vec<(u32, State)>,
    pub(super) texture: Rows,
    pub(super) normals: Rows,
    /// Per corner of the file's faces, in order. Both stay empty while no corner has
    /// one, and are as long as the corners otherwise.
    pub(super) corner_texture: Vec<u32>,
    pub(super) corner_normals: Vec<u32>,
    /// The vertex of each corner, from 0; empty if no corner has anything to keep.
    pub(super) corner_vertices: Vec<u32>,
    /// The statements that are no part of a mesh, such as `l` and `p`: the first few words.
    pub(super) passed_over: Vec<String>,
}

/// The statements in force at a face, by their places in `names`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct State(pub(super) [u32; 4]);

impl State {
    /// The statements that make a state, in the order in which they are written.
    pub(super) const KEYWORDS: [&'static str; 4] = ["o", "g", "usemtl", "s"];

    pub(super) const EMPTY: Self = Self([MISSING; 4]);
}

impl Kept {
    /// Notes a statement that is not kept.
    pub(super) fn pass_over(&mut self, keyword: &[u8]) {
        let word = String::from_utf8_lossy(&keyword[..keyword.len().min(16)]);
        let is_word = word.starts_with(|c: char| c.is_ascii_alphabetic());
        let known = &mut self.passed_over;
        if is_word && known.len() < 8 && !known.iter().any(|other| *other == word) {
            known.push(word.into_owned());
        }
    }

    /// The state at a face of the file.
    pub(super) fn state(&self, face: u32) -> State {
        let after = self.states.partition_point(|&(first, _)| first <= face);
        after.checked_sub(1).map_or(State::EMPTY, |i| self.states[i].1)
    }

    /// Notes a statement that holds from `face` on.
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
}

/// A table of up to three numbers a row.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    pub(super) rows: Vec<[f64; 3]>,
    /// How many of the three are written.
    pub(super) width: usize,
}

impl Rows {
    /// Adds a row; false if it has fewer than `least` numbers or something else.
    pub(super) fn push<'t>(&mut self, words: impl Iterator<Item = &'t [u8]>, least: usize) -> bool {
        let mut row = [0.0; 3];
        let mut width = 0;
        for (place, word) in row.iter_mut().zip(words) {
            let Some(number) = number(word) else {
                return false;
            };
            *place = number;
            width += 1;
        }
        self.width = self.width.max(width);
        self.rows.push(row);
        width >= least
    }
}

pub(super) fn number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}
