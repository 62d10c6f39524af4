//! Knowledge of the level of the mesh while operations change it.
//!
//! An operation with a guard takes for granted that the mesh has its level. Most operations keep
//! the level; after another one the mesh may have it still, so it is asked anew, where an
//! operation is called that needs it: near what was written since, or everywhere, once as much
//! was written as there is. So the asking costs no more than the writing did, and a script that
//! goes to and fro between such operations is no slower than the operations are.

use super::{Machine, Message, Plan};
use crate::mesh::{
    BelowLevel, Bookmark, ElementKind, Footprint, Level, Mesh, validate_level, validate_level_near,
    validate_level_of_valid,
};

/// The number of levels that an operation keeps that keeps all.
const MOST_KEPT: usize = 2;

/// The known level of a mesh.
#[derive(Clone, Debug)]
pub(super) struct KnownLevel {
    /// It has this level.
    now: Level,
    /// It had this one before what is `written` was.
    was: Level,
    /// It had this one when nothing was written, and has it still while nothing has `lowered` it;
    /// but what is written need not be known before an operation wants it.
    at_start: Level,
    /// Whether it is known to be valid, which operations keep.
    is_valid: bool,
    written: Footprint,
    /// The number of the operation that was applied last of those that may have lowered the level,
    /// plus 1; 0 if there is none.
    pub(super) lowered: u32,
}

impl KnownLevel {
    pub(super) fn new(now: Level) -> Self {
        let is_valid = now > Level::Map;
        let written = Footprint::default();
        Self { now, was: now, at_start: now, is_valid, written, lowered: 0 }
    }

    /// Of a mesh that has a level before anything is written.
    pub(super) fn at_start(level: Level) -> Self {
        Self { at_start: level, is_valid: true, ..Self::new(Level::Map) }
    }

    /// The level that the mesh surely has.
    pub(super) fn now(&self) -> Level {
        self.now
    }

    /// Makes sure that the mesh has a level.
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

    /// Whether what an operation writes has to be known when it has been applied.
    #[inline]
    fn is_lowered_by(&self, plan: &Plan) -> bool {
        if !plan.may_lower() && self.now == self.was {
            return false;
        }
        plan.level_after(self.now) < self.was
    }

    /// Whether the mesh is to be asked before an operation, or what it writes has to be known.
    #[cfg(feature = "native")]
    #[inline]
    fn watches(&self, plan: &Plan) -> bool {
        self.now < plan.level || self.is_lowered_by(plan)
    }

    /// A number for what decides that: the level that the mesh has and the one that it had.
    #[cfg(feature = "native")]
    #[inline]
    pub(super) fn state(&self) -> u64 {
        (self.now as usize * Level::ALL.len() + self.was as usize) as u64
    }

    /// The states, as bits, in which nothing has to be known when an operation is applied; or, if
    /// it is only asked, before.
    #[cfg(feature = "native")]
    pub(super) fn quiet_states(plan: &Plan, is_asked: bool) -> u64 {
        let of = |now| Level::ALL.map(|was| Self { was, ..Self::new(now) });
        let states = Level::ALL.into_iter().flat_map(of);
        let quiet = states.filter(|known| match is_asked {
            true => known.now >= plan.level,
            false => !known.watches(plan),
        });
        quiet.fold(0, |bits, known| bits | 1 << known.state())
    }

    /// An operation has been applied that wrote these.
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
    /// Whether a mesh may have a lower level when it has been applied.
    #[inline]
    pub(super) fn may_lower(&self) -> bool {
        self.keeps.len() < MOST_KEPT
    }
}

impl Machine {
    /// Makes sure that the mesh has the level of an operation that is called.
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

    /// The known level at a call within steps, before any of them is taken. What is given
    /// back is known again when they are undone, or done.
    pub(super) fn begin_steps(&mut self, mesh: &Mesh, calls: &[(u16, u16)]) -> KnownLevel {
        let plans = calls.iter().filter_map(|&(op, _)| self.plans.get(usize::from(op))?.as_ref());
        let wanted = plans.map(|plan| plan.level).max().unwrap_or(Level::Map);
        if wanted > self.known.now && wanted <= self.known.was {
            // Asked before, the answer holds for later calls too.
            let _ = self.known.expect(mesh, wanted);
        }
        let KnownLevel { lowered, at_start, is_valid, now, .. } = self.known;
        let inner = KnownLevel { lowered, at_start, is_valid, ..KnownLevel::new(now) };
        std::mem::replace(&mut self.known, inner)
    }

    /// Whether the mesh is to be asked before an operation, or what it writes has to be known.
    #[cfg(feature = "native")]
    #[inline]
    pub(super) fn watches_level(&self, plan: &Plan) -> bool {
        self.known.watches(plan)
    }

    /// Opens a journal for an operation that is about to be called, if what it writes has to be
    /// known.
    #[inline]
    pub(super) fn begin_op(&self, mesh: &mut Mesh, plan: &Plan) -> Option<Bookmark> {
        self.known.is_lowered_by(plan).then(|| mesh.open_journal())
    }

    /// Ends it.
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
        let Some(mark) = mark else {
            return;
        };
        if applied {
            let written = mesh.written_since(&mark);
            self.known.lower(mesh, plan, written);
        }
        mesh.keep(mark);
    }
}
