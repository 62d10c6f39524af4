//! A history of the states of a mesh, step by step, to go back and forth among them.
//!
//! A recorder notes writes as a [journal](super::journal) does. To go to a state is to put back
//! what was written between it and the current one, and costs that, however large the mesh is and
//! however many steps lie before. Each note that is put back becomes the note of what it replaced,
//! so the same notes lead both ways.
//!
//! A history keeps the last steps, as many as fit into a limit of memory.

use super::connectivity::Mesh;
use super::notes::{Note, Recorder};

/// Successive states of a mesh, and the one that is shown.
#[derive(Clone, Debug, Default)]
pub struct History {
    mesh: Mesh,
    notes: Vec<Note>,
    /// The end of the notes of each step.
    ends: Vec<usize>,
    /// The number of steps before the oldest state.
    first: u64,
    /// The number of steps from the oldest state to the one that is shown.
    at: usize,
}

impl Mesh {
    /// Starts recording a history of the last steps, as many as fit into `most` bytes. Nothing else
    /// changes.
    pub fn record_history(&mut self, most: usize) {
        self.journal.recorder = Some(Box::new(Recorder { most, ..Recorder::default() }));
    }

    /// Whether a history is recorded.
    #[cfg(feature = "native")]
    #[inline]
    pub(crate) fn is_recorded(&self) -> bool {
        self.journal.recorder.is_some()
    }

    /// Ends a step, if a history is recorded and no journal is open.
    #[inline]
    pub fn end_step(&mut self) {
        if self.journal.recorder.is_some() && !self.journal.may_roll_back() {
            self.record_step();
        }
    }

    #[cold]
    fn record_step(&mut self) {
        let notes = &mut self.journal.notes;
        let Some(recorder) = &mut self.journal.recorder else { return };
        // The first note about a record holds its value before the step; the others, values in
        // between.
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
        recorder.ends.push(end);
        while notes.len() * size_of::<Note>() > recorder.most {
            let gone = recorder.ends.len().div_ceil(2);
            let cut = recorder.ends[gone - 1];
            notes.drain(..cut);
            recorder.ends.drain(..gone);
            recorder.ends.iter_mut().for_each(|end| *end -= cut);
            recorder.first += gone as u64;
        }
    }

    /// Ends the recording. Writes after the last step belong to that step. `None` if no history was
    /// recorded.
    pub fn take_history(&mut self) -> Option<History> {
        let recorder = self.journal.recorder.take()?;
        let Recorder { mut ends, first, .. } = *recorder;
        let mut notes = std::mem::take(&mut self.journal.notes);
        match ends.last_mut() {
            Some(last) => *last = notes.len(),
            None => notes.clear(),
        }
        let mut mesh = self.clone();
        mesh.keep_all();
        Some(History { mesh, notes, at: ends.len(), ends, first })
    }
}

impl History {
    /// The numbers of steps that lead to the first and to the last state.
    pub fn span(&self) -> [u64; 2] {
        [self.first, self.first + self.ends.len() as u64]
    }

    /// The mesh after `step` steps; `None` if that is not among the states.
    pub fn go(&mut self, step: u64) -> Option<&Mesh> {
        let to = usize::try_from(step.checked_sub(self.first)?).ok()?;
        if to > self.ends.len() {
            return None;
        }
        let start = |at: usize| if at == 0 { 0 } else { self.ends[at - 1] };
        let (here, there) = (start(self.at), start(to));
        match there < here {
            true => {
                self.notes[there..here].iter_mut().rev().for_each(|note| self.mesh.put_back(note));
            }
            false => self.notes[here..there].iter_mut().for_each(|note| self.mesh.put_back(note)),
        }
        self.at = to;
        Some(&self.mesh)
    }
}
