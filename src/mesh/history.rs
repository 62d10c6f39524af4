//! The states that a mesh goes through, step by step, to go back and forth among them.
//!
//! A recorder notes what is written as a [journal](super::journal) does. To go to a state is to put
//! back what was written between it and the one that is shown, and costs that, however large the
//! mesh is and however many steps lie before. Each note that is put back becomes the note of what
//! was there instead, so the same notes lead both ways.
//!
//! A history has as many steps as fit into a limit of memory, from some step on.

use std::collections::HashSet;

use super::attribute::ColumnId;
use super::connectivity::Mesh;
use super::journal::Note;

/// States of a mesh, each a step from the next, and the one that is shown.
#[derive(Clone, Debug, Default)]
pub struct History {
    mesh: Mesh,
    notes: Vec<Note>,
    /// Where the notes of each step end.
    ends: Vec<usize>,
    /// The number of steps that were taken before, and of those that can be gone.
    first: u64,
    count: usize,
    /// The number of steps that have been taken where the mesh is shown.
    at: usize,
}

/// What records a history.
#[derive(Clone, Debug)]
pub(super) struct Recorder {
    ends: Vec<usize>,
    /// The number of steps so far, and of those that are not recorded.
    steps: u64,
    first: u64,
    /// The most bytes of the notes.
    most: usize,
    /// The history, if there is no room for more.
    full: Option<History>,
    /// What this step has written.
    seen: HashSet<(u8, u32, Option<ColumnId>)>,
}

impl Mesh {
    /// Records a history from now on: of the steps behind the first ones, those that fit into so
    /// many bytes. Nothing else is different.
    pub fn record_history(&mut self, first: u64, most: usize) {
        let (ends, seen) = (Vec::new(), HashSet::new());
        let recorder = Recorder { ends, steps: 0, first, most, full: None, seen };
        self.journal.recorder = Some(Box::new(recorder));
    }

    /// A step ends, if a history is recorded.
    #[inline]
    pub fn end_step(&mut self) {
        if self.journal.recorder.is_some() && !self.journal.may_roll_back() {
            self.record_step();
        }
    }

    #[cold]
    fn record_step(&mut self) {
        let Some(mut recorder) = self.journal.recorder.take() else { return };
        recorder.steps += 1;
        if recorder.full.is_some() || recorder.steps <= recorder.first {
            self.journal.notes.clear();
        } else {
            self.leave_first_notes(&mut recorder);
            recorder.ends.push(self.journal.notes.len());
            if self.journal.bytes() > recorder.most {
                let mut full = self.history_of(&mut recorder);
                // More may be written behind the last step, which nobody notes.
                full.count -= 1;
                recorder.full = Some(full);
            }
        }
        self.journal.recorder = Some(recorder);
    }

    /// Leaves of the notes of the last step the first one about each record: the others are about
    /// what stood there in between.
    fn leave_first_notes(&mut self, recorder: &mut Recorder) {
        let notes = &mut self.journal.notes;
        let start = recorder.ends.last().copied().unwrap_or(0);
        let mut end = start;
        recorder.seen.clear();
        for at in start..notes.len() {
            if notes[at].is_of_columns() {
                recorder.seen.clear();
            }
            if notes[at].place().is_none_or(|place| recorder.seen.insert(place)) {
                notes.swap(end, at);
                end += 1;
            }
        }
        notes.truncate(end);
    }

    fn history_of(&mut self, recorder: &mut Recorder) -> History {
        let notes = std::mem::take(&mut self.journal.notes);
        let ends = std::mem::take(&mut recorder.ends);
        let mut mesh = self.clone();
        mesh.keep_all();
        let count = ends.len();
        History { mesh, notes, at: count, ends, first: recorder.first, count }
    }

    /// Ends the recording. What was written behind the last step belongs to that. `None` if no
    /// history was recorded.
    pub fn take_history(&mut self) -> Option<History> {
        let mut recorder = self.journal.recorder.take()?;
        let history = match recorder.full.take() {
            Some(full) => full,
            None => {
                if let Some(last) = recorder.ends.last_mut() {
                    *last = self.journal.notes.len();
                }
                self.history_of(&mut recorder)
            }
        };
        if !self.journal.is_open() {
            self.journal.notes.clear();
        }
        Some(history)
    }
}

impl History {
    /// The numbers of the first and the last state: so many steps have been taken there.
    pub fn span(&self) -> [u64; 2] {
        [self.first, self.first + self.count as u64]
    }

    /// The mesh after so many steps; `None` if that is not among the states.
    pub fn go(&mut self, step: u64) -> Option<&Mesh> {
        let to = usize::try_from(step.checked_sub(self.first)?).ok()?;
        if to > self.count {
            return None;
        }
        let start = |at: usize| if at == 0 { 0 } else { self.ends[at - 1] };
        let here = start(self.at);
        let there = start(to);
        match there < here {
            true => {
                let notes = self.notes[there..here].iter_mut().rev();
                notes.for_each(|note| self.mesh.put_back(note));
            }
            false => {
                let notes = self.notes[here..there].iter_mut();
                notes.for_each(|note| self.mesh.put_back(note));
            }
        }
        self.at = to;
        Some(&self.mesh)
    }

    /// The memory that it takes, in bytes.
    pub fn bytes(&self) -> usize {
        self.mesh.bytes() + self.notes.capacity() * size_of::<Note>()
    }
}
