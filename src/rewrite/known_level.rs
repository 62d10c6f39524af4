//! Tracking of the level of the mesh while operations change it.
//!
//! An operation with a guard requires that the mesh has its level. Most operations keep the level;
//! after another one the mesh may still have it, so it is validated again when an operation is
//! called that needs it: near everything written since, or everywhere once more has been written
//! than there are halfedges. So validation costs no more than the writes did, and a script that
//! alternates between such operations is not slowed down by more than a constant factor.

use super::{Machine, Message, Plan};
use crate::mesh::{
    BelowLevel, Bookmark, ElementKind, Footprint, Level, Mesh, validate_level, validate_level_near,
    validate_level_of_valid,
};

/// The number of levels in the list of an operation that keeps all levels.
const MOST_KEPT: usize = 2;

/// The known level of a mesh.
#[derive(Clone, Debug)]
pub(super) struct KnownLevel {
    /// The mesh has this level.
    now: Level,
    /// The level that it had before the writes in `written`.
    was: Level,
    /// The level that it had at the start, and still has while no operation has `lowered` it; it is
    /// used only when an operation needs it, so writes need not be tracked for it.
    at_start: Level,
    /// Whether the mesh is known to be valid; operations keep it valid.
    is_valid: bool,
    written: Footprint,
    /// The number plus 1 of the last applied operation that may have lowered the level; 0 if there
    /// is none.
    pub(super) lowered: u32,
}

impl KnownLevel {
    pub(super) fn new(now: Level) -> Self {
        let is_valid = now > Level::Map;
        let written = Footprint::default();
        Self { now, was: now, at_start: now, is_valid, written, lowered: 0 }
    }

    /// The known level of a mesh that has this level before anything is written.
    pub(super) fn at_start(level: Level) -> Self {
        Self { at_start: level, is_valid: true, ..Self::new(Level::Map) }
    }

    /// The level that the mesh is known to have.
    pub(super) fn now(&self) -> Level {
        self.now
    }

    /// Makes sure that the mesh has a level, validating it if necessary.
    pub(super) fn expect(&mut self, mesh: &Mesh, level: Level) -> Result<(), BelowLevel> {
        if self.now >= level {
            return Ok(());
        }
        let found = match self.was >= level {
            _ if self.lowered == 0 && self.at_start >= level => self.at_start,
            true => match validate_level_near(mesh, self.was, &self.written) {
                Ok(()) => self.was,
                Err(_) => {
                    validate_level_near(mesh, level, &self.written)?;
                    level
                }
            },
            false if self.is_valid => {
                validate_level_of_valid(mesh, level)?;
                level
            }
            false => {
                validate_level(mesh, level)?;
                level
            }
        };
        *self = Self { is_valid: true, ..Self::new(found) };
        Ok(())
    }

    /// Whether the writes of an operation have to be tracked.
    #[inline]
    fn is_lowered_by(&self, plan: &Plan) -> bool {
        if !plan.may_lower() && self.now == self.was {
            return false;
        }
        plan.level_after(self.now) < self.was
    }

    /// Whether the mesh has to be validated before an operation, or its writes have to be tracked.
    #[cfg(feature = "native")]
    #[inline]
    fn watches(&self, plan: &Plan) -> bool {
        self.now < plan.level || self.is_lowered_by(plan)
    }

    /// A number for the state on which this depends: the levels `now` and `was`.
    #[cfg(feature = "native")]
    #[inline]
    pub(super) fn state(&self) -> u64 {
        (self.now as usize * Level::ALL.len() + self.was as usize) as u64
    }

    /// The states, as bits, in which an operation can be applied, or, if `is_asked`, asked, without
    /// validating the mesh or tracking writes.
    #[cfg(feature = "native")]
    pub(super) fn quiet_states(plan: &Plan, is_asked: bool) -> u64 {
        let of = |now| Level::ALL.map(|was| Self { was, ..Self::new(now) });
        let quiet = Level::ALL.into_iter().flat_map(of).filter(|known| match is_asked {
            true => known.now >= plan.level,
            false => !known.watches(plan),
        });
        quiet.fold(0, |bits, known| bits | 1 << known.state())
    }

    /// Notes that an operation has been applied, with its writes.
    fn lower(&mut self, mesh: &Mesh, plan: &Plan, written: Footprint) {
        self.now = plan.level_after(self.now);
        self.written.append(written);
        if self.written.len() > mesh.capacity(ElementKind::Halfedge) {
            self.was = self.now;
            self.written = Footprint::default();
        }
    }
}

impl Plan {
    /// Whether applying the operation may lower the level of a mesh.
    #[inline]
    pub(super) fn may_lower(&self) -> bool {
        self.keeps.len() < MOST_KEPT
    }
}

impl Machine {
    /// Makes sure that the mesh has the level that a called operation requires.
    pub(super) fn expect_level(&mut self, mesh: &Mesh, plan: &Plan) -> Result<(), Message> {
        let known = &mut self.known;
        known.expect(mesh, plan.level).map_err(|below| Message::BelowLevel {
            op: plan.name.clone(),
            level: plan.level,
            why: below.to_string(),
            after: known.lowered.checked_sub(1).and_then(|op| {
                let applied = self.plans.get(op as usize)?.as_ref()?;
                (applied.level_after(plan.level) < plan.level).then(|| applied.name.clone())
            }),
        })
    }

    /// Begins the steps of an operation; returns the known level from before, for
    /// [`end_steps`](Self::end_steps).
    pub(super) fn begin_steps(&mut self, mesh: &Mesh, calls: &[(u16, u16)]) -> KnownLevel {
        let plans = calls.iter().filter_map(|&(op, _)| self.plans.get(usize::from(op))?.as_ref());
        let wanted = plans.map(|plan| plan.level).max().unwrap_or(Level::Map);
        if wanted > self.known.now && wanted <= self.known.was {
            // If the level is validated now, the result is kept for later calls too.
            let _ = self.known.expect(mesh, wanted);
        }
        let KnownLevel { lowered, at_start, is_valid, now, .. } = self.known;
        let inner = KnownLevel { lowered, at_start, is_valid, ..KnownLevel::new(now) };
        std::mem::replace(&mut self.known, inner)
    }

    /// Ends the steps of an operation: the known level is that from before, or what the steps have
    /// found and tracked if that is more and they are not undone.
    pub(super) fn end_steps(&mut self, before: KnownLevel, is_applied: bool) {
        if !is_applied || self.known.was <= before.was {
            self.known = before;
        }
    }

    /// Whether the mesh has to be validated before an operation, or its writes have to be tracked.
    #[cfg(feature = "native")]
    #[inline]
    pub(super) fn watches_level(&self, plan: &Plan) -> bool {
        self.known.watches(plan)
    }

    /// Opens a journal for an operation that is about to be called, if its writes have to be
    /// tracked.
    #[inline]
    pub(super) fn begin_op(&self, mesh: &mut Mesh, plan: &Plan) -> Option<Bookmark> {
        self.known.is_lowered_by(plan).then(|| mesh.open_journal())
    }

    /// Ends the call that [`begin_op`](Self::begin_op) began.
    #[inline]
    pub(super) fn end_op(
        &mut self,
        mesh: &mut Mesh,
        (op, plan): (u16, &Plan),
        mark: Option<Bookmark>,
        applied: bool,
    ) {
        if applied && plan.may_lower() {
            self.known.lowered = u32::from(op) + 1;
        }
        let Some(mark) = mark else { return };
        if applied {
            self.known.lower(mesh, plan, mesh.written_since(&mark));
        }
        mesh.keep(mark);
    }
}
