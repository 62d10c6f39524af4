//! Masks that are kept up to date while operations change the mesh.

use super::binding::Bound;
use super::questions::Free;
use super::{Arguments, Error, Op, Session, Verdict, new_name};
use crate::mesh::{Bookmark, ElementKind, Level, Mesh};
use crate::rewrite::Asked;
use crate::run::Argument;

/// A mask that a session keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct KeptMask(u64);

/// The masks that a session keeps.
#[derive(Debug, Default)]
pub(super) struct Masks {
    all: Vec<Kept>,
}

#[derive(Debug)]
struct Kept {
    name: KeptMask,
    op: Op,
    /// The arguments, without that for the parameter that ranges over all elements.
    values: Vec<Option<Argument>>,
    at: usize,
    kind: ElementKind,
    slot: usize,
    /// The level that the mesh was known to have when the verdicts were computed.
    level: Level,
    asked: Asked,
    verdicts: Vec<Verdict>,
    applies: Counted,
}

/// Truth values, and for each block of them how many are true.
#[derive(Debug, Default)]
struct Counted {
    values: Vec<bool>,
    counts: Vec<usize>,
}

impl Counted {
    /// The number of values in a block.
    const BLOCK: usize = 512;

    fn resize(&mut self, len: usize) {
        (len..self.values.len()).for_each(|at| self.set(at, false));
        self.values.resize(len, false);
        self.counts.resize(len.div_ceil(Self::BLOCK), 0);
    }

    fn set(&mut self, at: usize, value: bool) {
        let count = &mut self.counts[at / Self::BLOCK];
        let was = std::mem::replace(&mut self.values[at], value);
        *count = *count + usize::from(value) - usize::from(was);
    }

    fn count(&self) -> usize {
        self.counts.iter().sum()
    }

    /// The place of the true value that so many come before.
    fn nth(&self, mut before: usize) -> Option<usize> {
        let block = self.counts.iter().position(|&count| match before.checked_sub(count) {
            Some(rest) => {
                before = rest;
                false
            }
            None => true,
        })?;
        let start = block * Self::BLOCK;
        let mut places = (start..).zip(&self.values[start..]).filter(|&(_, &value)| value);
        places.nth(before).map(|(place, _)| place)
    }
}

impl Masks {
    pub(super) fn are_kept(&self) -> bool {
        !self.all.is_empty()
    }

    /// Notes what was written since a mark, also when that is about to be undone.
    pub(super) fn note(&mut self, mesh: &Mesh, mark: &Bookmark) {
        for kept in &mut self.all {
            mesh.each_written(mark, |written| kept.asked.note(mesh, written));
        }
    }

    /// Adapts to a mesh whose noted writes have been undone.
    pub(super) fn shrink(&mut self, mesh: &Mesh) {
        self.all.iter_mut().for_each(|kept| kept.asked.shrink(mesh));
    }

    /// Forgets all verdicts: the mesh may have changed in any way.
    pub(super) fn forget(&mut self) {
        self.all.iter_mut().for_each(|kept| kept.asked.forget());
    }
}

impl Session {
    /// Keeps a mask: the elements at which an operation would be applied. Later changes by
    /// operations are noted, and only what depends on them is computed again when
    /// [`kept_mask`](Self::kept_mask) or [`kept_verdicts`](Self::kept_verdicts) is called. After a
    /// script that may change the mesh, and after changes by hand, everything is computed again.
    ///
    /// ```
    /// # use hedgerow::{Program, Session, mesh::shape};
    /// # fn main() -> Result<(), hedgerow::Error> {
    /// let program = Program::load("std/triangle.hedge")?;
    /// let mut session = Session::new(&program, shape::icosphere(1));
    /// let flip = program.op("flip")?;
    /// let mask = session.keep_mask(&flip, ())?;
    /// for _ in 0..10 {
    ///     let edge = session.kept_mask(mask)?.iter().position(|&can| can).expect("one can flip");
    ///     assert!(session.apply(&flip, hedgerow::mesh::EdgeId(edge as u32))?.is_applied());
    ///     assert_eq!(session.kept_mask(mask)?.to_vec(), session.mask(&flip, ())?);
    /// }
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As for [`mask`](Self::mask).
    pub fn keep_mask(&mut self, op: &Op, arguments: impl Arguments) -> Result<KeptMask, Error> {
        let Free { application, at, kind, slot } = self.free_parameter(op, arguments)?;
        let names = application.columns().names();
        let asked = Asked::new(kind, application.question(at), names);
        let name = KeptMask(new_name());
        self.masks.all.push(Kept {
            name,
            op: op.clone(),
            values: self.values.clone(),
            at,
            kind,
            slot,
            level: self.known.level(),
            asked,
            verdicts: Vec::new(),
            applies: Counted::default(),
        });
        let current = self.bring_up_to_date(name);
        if current.is_err() {
            self.drop_mask(name);
        }
        current.map(|_| name)
    }

    /// The current values of a kept mask, as [`mask`](Self::mask) would return them, also of an
    /// operation of another program than the current one.
    ///
    /// # Errors
    /// The mask is not kept (`unknown-mask`), or as for [`mask`](Self::mask).
    pub fn kept_mask(&mut self, mask: KeptMask) -> Result<&[bool], Error> {
        let at = self.bring_up_to_date(mask)?;
        Ok(&self.masks.all[at].applies.values)
    }

    /// The number of elements at which the operation of a kept mask would be applied. It does not
    /// look at each of them, unless they have to be computed again.
    ///
    /// # Errors
    /// As for [`kept_mask`](Self::kept_mask).
    pub fn kept_count(&mut self, mask: KeptMask) -> Result<usize, Error> {
        let at = self.bring_up_to_date(mask)?;
        Ok(self.masks.all[at].applies.count())
    }

    /// One of the elements at which the operation of a kept mask would be applied: the one at
    /// `share` of the way through them, 0 the first, below 1; `None` if there are none. It does not
    /// look at each of them, as for [`kept_count`](Self::kept_count).
    ///
    /// # Errors
    /// As for [`kept_mask`](Self::kept_mask).
    pub fn pick_kept(&mut self, mask: KeptMask, share: f64) -> Result<Option<usize>, Error> {
        let at = self.bring_up_to_date(mask)?;
        let applies = &self.masks.all[at].applies;
        let count = applies.count();
        let before = (share.clamp(0.0, 1.0) * count as f64) as usize;
        Ok(applies.nth(before.min(count.saturating_sub(1))))
    }

    /// The current verdicts of a kept mask, as [`verdicts`](Self::verdicts) would return them.
    ///
    /// # Errors
    /// As for [`kept_mask`](Self::kept_mask).
    pub fn kept_verdicts(&mut self, mask: KeptMask) -> Result<&[Verdict], Error> {
        let at = self.bring_up_to_date(mask)?;
        Ok(&self.masks.all[at].verdicts)
    }

    /// Stops keeping a mask.
    pub fn drop_mask(&mut self, mask: KeptMask) {
        self.masks.all.retain(|kept| kept.name != mask);
    }

    /// Computes again what may have changed. Returns the index of the mask.
    fn bring_up_to_date(&mut self, mask: KeptMask) -> Result<usize, Error> {
        let Some(at) = self.masks.all.iter().position(|kept| kept.name == mask) else {
            let message = "this mask is not kept, or belongs to another session";
            return Err(self.wrong("unknown-mask", message));
        };
        let mut kept = self.masks.all.swap_remove(at);
        let done = self.ask_again(&mut kept);
        self.masks.all.push(kept);
        done.map(|()| self.masks.all.len() - 1)
    }

    fn ask_again(&mut self, kept: &mut Kept) -> Result<(), Error> {
        let current = self.engine.program.clone();
        self.use_program(&kept.op.program);
        let ready = self.make_mask_ready(kept);
        let done = ready.and_then(|()| self.with_own_defaults(|session| session.ask_stale(kept)));
        self.use_program(&current);
        done
    }

    fn make_mask_ready(&mut self, kept: &mut Kept) -> Result<(), Error> {
        let Kept { op, values, at, kind, level, asked, .. } = kept;
        let (at, kind) = (*at, *kind);
        let application = op.application()?;
        let first = self.mesh.elements(kind).next();
        if let Some(first) = first {
            self.values.clone_from(values);
            self.values[at] = Some(Argument::Element(kind, first));
            self.make_ready(op, application, Bound::ToAsk)?;
        }
        if std::mem::replace(level, self.known.level()) != self.known.level() {
            asked.forget();
        }
        Ok(())
    }

    fn ask_stale(&mut self, kept: &mut Kept) -> Result<(), Error> {
        let Kept { op, kind, slot, asked, verdicts, applies, .. } = kept;
        let (kind, slot) = (*kind, *slot);
        let application = op.application()?;
        let capacity = self.mesh.capacity(kind);
        verdicts.resize(capacity, Verdict::Gone);
        applies.resize(capacity);
        while let Some(id) = asked.next_stale(&self.mesh, &self.slots) {
            let verdict = match self.mesh.is_alive(kind, id) {
                false => Verdict::Gone,
                true => {
                    self.slots[slot] = u64::from(id);
                    let question = (application.plan(), self.slots.as_slice());
                    let machine = &mut self.engine.machine;
                    let noted = (&mut *asked, id);
                    let answer =
                        machine.ask_again(&mut self.mesh, question, noted, &mut *self.watch);
                    let answer = answer.map_err(|trap| {
                        asked.make_stale(id);
                        self.trapped_at(application, trap, (kind, id))
                    })?;
                    op.verdict(answer)
                }
            };
            verdicts[id as usize] = verdict;
            applies.set(id as usize, verdict == Verdict::Applies);
        }
        Ok(())
    }
}
