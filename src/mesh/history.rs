//! The states that a mesh goes through, step by step, to go back and forth among them.
//!
//! A recorder notes what is written as a [journal](super::journal) does. To go to a state is to put
//! back what was written between it and the one that is shown, and costs that, however large the
//! mesh is and however many steps lie before. Each note that is put back becomes the note of what
//! was there instead, so the same notes lead both ways.
//!
//! A history has the last steps, as many as fit into a limit of memory.

use super::connectivity::Mesh;
use super::notes::{Note, Recorder};

/// States of a mesh, each a step from the next, and the one that is shown.
#[derive(Clone, Debug, Default)]
pub struct History {
    mesh: Mesh,
    notes: Vec<Note>,
    /// Where the notes of each step end.
    ends: Vec<usize>,
    /// The number of steps that were taken before.
    first: u64,
    /// The number of steps that have been taken where the mesh is shown.
    at: usize,
}

impl Mesh {
    /// Records a history from now on: of the last steps as many as fit into so many bytes. Nothing
    /// else is different.
    pub fn record_history(&mut self, most: usize) {
        self.journal.recorder = Some(Box::new(Recorder { most, ..Recorder::default() }));
    }

    /// Whether a history is recorded.
    #[cfg(feature = "native")]
    #[inline]
    pub(crate) fn is_recorded(&self) -> bool {
        self.journal.recorder.is_some()
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
        let notes = &mut self.journal.notes;
        let Some(recorder) = &mut self.journal.recorder else { return };
        // The first note about a record tells what it was; the others what stood there in between.
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

    /// Ends the recording. What was written behind the last step belongs to that. `None` if no
    /// history was recorded.
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
    /// The numbers of the first and the last state: so many steps have been taken there.
    pub fn span(&self) -> [u64; 2] {
        [self.first, self.first + self.ends.len() as u64]
    }

    /// The mesh after so many steps; `None` if that is not among the states.
    pub fn go(&mut self, step: u64) -> Option<&Mesh> {
        let to = usize::try_from(step.checked_sub(self.first)?).ok()?;
        if to > self.ends.len() {
            return None;
        }
        let start = |at: usize| if at == 0 { 0 } else { self.ends[at - 1] };
        let (here, there) = (start(self.at), start(to));
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
}
