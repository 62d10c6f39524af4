//! Undoing changes back to a mark.

use super::level::Known;
use super::{Error, Session, new_name};
use crate::mesh::{Bookmark, Level};

/// A state of the mesh that can be restored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark(u64);

/// The open marks of a session, the innermost last.
#[derive(Debug, Default)]
pub(super) struct Marks {
    open: Vec<(Mark, Bookmark, Known)>,
    /// The level that was found behind a mark and forgotten when the mark was undone: the next mark
    /// looks for it first, so that it stays known.
    forgotten: Option<Level>,
}

impl Session {
    /// Marks the state of the mesh. From then on all writes are recorded, which takes time and
    /// memory in proportion to them, until the mark is [undone](Self::undo) or [kept](Self::keep).
    pub fn mark(&mut self) -> Mark {
        if let Some(level) = self.marks.forgotten.take() {
            self.known.seek(level, &self.mesh);
        }
        self.end_lost_marks();
        let mark = Mark(new_name());
        if self.marks.open.is_empty() {
            self.mesh.sign_journal(mark.0);
        }
        self.marks.open.push((mark, self.mesh.open_journal(), self.known));
        mark
    }

    /// Restores the mesh to its state at a mark, bit for bit, and ends that mark and all later
    /// ones. The cost is proportional to what was written.
    ///
    /// # Errors
    /// The mark has ended, also by another mesh in the place of the marked one, or belongs to
    /// another session (`unknown-mark`).
    pub fn undo(&mut self, mark: Mark) -> Result<(), Error> {
        self.end(mark, |session, bookmark, known| {
            session.masks.note(&session.mesh, &bookmark);
            session.mesh.roll_back(bookmark);
            session.masks.shrink(&session.mesh);
            let found = session.known.level();
            if found > known.level() {
                session.marks.forgotten = Some(found);
            }
            session.known = known;
            session.release_others();
            // Columns may have been added since.
            session.engine.unbind();
        })
    }

    /// Ends a mark and all later ones, and keeps what was written since.
    ///
    /// # Errors
    /// As for [`undo`](Self::undo).
    pub fn keep(&mut self, mark: Mark) -> Result<(), Error> {
        self.end(mark, |session, bookmark, _| session.mesh.keep(bookmark))
    }

    fn end(
        &mut self,
        mark: Mark,
        mut with: impl FnMut(&mut Self, Bookmark, Known),
    ) -> Result<(), Error> {
        self.end_lost_marks();
        let Some(at) = self.marks.open.iter().position(|(open, ..)| *open == mark) else {
            let message = "this mark has ended, belongs to another session, or was of a mesh \
                           that another one has replaced";
            return Err(self.wrong("unknown-mark", message));
        };
        while self.marks.open.len() > at {
            if let Some((_, bookmark, known)) = self.marks.open.pop() {
                with(self, bookmark, known);
            }
        }
        Ok(())
    }

    /// Ends all marks if the mesh is not the one that they were set on.
    fn end_lost_marks(&mut self) {
        let first = self.marks.open.first();
        if first.is_some_and(|(first, ..)| !self.mesh.is_journal_of(first.0)) {
            self.marks.open.clear();
        }
    }

    /// Does several things, all or nothing: if they end in an error or a panic, the mesh is
    /// restored to its state before. If `act` puts another mesh in its place, through
    /// [`mesh_mut`](Self::mesh_mut), that one stays.
    ///
    /// ```
    /// # use hedgerow::{Program, Session, mesh::shape};
    /// # fn main() -> Result<(), hedgerow::Error> {
    /// let program = Program::parse("p", "script go() {
    ///   for v in vertices {
    ///     v.position = 2 * v.position
    ///     assert degree(v) < 0
    ///   }
    /// }")?;
    /// let mut session = Session::new(&program, shape::cube());
    /// let before = session.mesh().positions().to_vec();
    /// let go = program.script("go")?;
    /// assert!(session.attempt(|session| session.run(&go, ())).is_err());
    /// assert_eq!(session.mesh().positions(), before);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// The errors of `act`.
    pub fn attempt<T, E>(&mut self, act: impl FnOnce(&mut Self) -> Result<T, E>) -> Result<T, E> {
        let mark = self.mark();
        let mut trial = Trial { session: self, mark, fails: true };
        let done = act(trial.session);
        trial.fails = done.is_err();
        done
    }
}

/// A guard that undoes everything since its mark when dropped, or keeps it after a success.
struct Trial<'s> {
    session: &'s mut Session,
    mark: Mark,
    fails: bool,
}

impl Drop for Trial<'_> {
    fn drop(&mut self) {
        // If the caller has ended the mark itself, there is nothing left to do.
        let _ = match self.fails {
            true => self.session.undo(self.mark),
            false => self.session.keep(self.mark),
        };
    }
}
