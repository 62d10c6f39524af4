//! Operations in steps: they call others, all or nothing.
//!
//! What a step has done is undone if a later one refuses, or if at the end the mesh is not of
//! the level that it was: a journal of the mesh knows what was written, so both cost no more
//! than the steps did.

use std::ops::ControlFlow;

use super::{Call, Machine, Message, Outcome, Plan, Trap, Watch};
use crate::mesh::{BelowLevel, Bookmark, Level, Mesh, validate_level_near};

/// What the plan of an operation in steps has besides its code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Steps {
    /// The operations that it calls, by number. The refusals of each stand among its own, from
    /// a number on.
    pub calls: Vec<(u16, u16)>,
    /// The number of the first of the refusals that [`BELOW`] tells, in that order.
    pub below: u16,
}

/// Why a mesh is not of its level any more.
pub const BELOW: [&str; 10] = [
    "the mesh would be broken",
    "a face would have fewer than three sides",
    "a face would meet a vertex twice",
    "a vertex would keep a single edge",
    "a vertex would have holes only around it",
    "a vertex would lie on two holes",
    "an edge would have a hole on both sides",
    "an edge would end where it begins",
    "two edges would have the same ends",
    "two faces would have the same corners",
];

/// The place of a reason in [`BELOW`].
fn place(below: &BelowLevel) -> u16 {
    match below {
        BelowLevel::Invalid(_) => 0,
        BelowLevel::SmallFace { .. } => 1,
        BelowLevel::MeetsTwice { .. } => 2,
        BelowLevel::SingleSpoke { .. } => 3,
        BelowLevel::NoFaceAround { .. } => 4,
        BelowLevel::Pinched { .. } => 5,
        BelowLevel::NoFaceAlong { .. } => 6,
        BelowLevel::EndsWhereItBegins { .. } => 7,
        BelowLevel::DoubleEdge { .. } => 8,
        BelowLevel::SameCorners { .. } => 9,
    }
}

impl Steps {
    /// The refusal of an operation that it calls, as its own.
    pub(super) fn refusal_of(&self, op: u16, reason: Option<u16>) -> Option<u16> {
        let called = self.calls.iter().find(|(called, _)| *called == op);
        called.zip(reason).map(|((_, first), reason)| first.saturating_add(reason))
    }
}

impl Machine {
    /// Runs the code of an operation; if it is one in steps, all of it or nothing.
    pub(super) fn carry_out<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        call: Call<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        match &plan.steps {
            None => self.execute::<OBSERVED>(mesh, call, watch),
            Some(steps) => self.take::<OBSERVED>(mesh, (plan, steps), call, watch),
        }
    }

    /// Finds out whether an operation would be applied. Nothing of it stays.
    pub(super) fn consider<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        call: Call<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        match &plan.steps {
            None => {
                let call = Call { code: plan.asking(), ..call };
                self.execute::<OBSERVED>(mesh, call, watch)
            }
            Some(steps) => {
                let before = self.before(mesh);
                let line = std::mem::take(&mut self.line);
                let mut silent = Silent(watch);
                let outcome =
                    self.try_out::<OBSERVED>(mesh, (plan, steps), call, &before, &mut silent);
                self.line = line;
                self.undo(mesh, before);
                Ok(match outcome? {
                    Outcome::Applied { .. } => Outcome::Applied { result: None },
                    refused => refused,
                })
            }
        }
    }

    #[cold]
    fn take<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        steps: (&Plan, &Steps),
        call: Call<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        let before = self.before(mesh);
        let outcome = self.try_out::<OBSERVED>(mesh, steps, call, &before, watch);
        match outcome {
            Ok(Outcome::Applied { .. }) => self.keep(mesh, before),
            _ => self.undo(mesh, before),
        }
        outcome
    }

    /// Does what an operation in steps does, which is to be kept or undone then.
    fn try_out<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        (plan, steps): (&Plan, &Steps),
        call: Call<'_>,
        before: &Before,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        // Steps that call each other can take long without a loop.
        if self.progress.tick(watch).is_break() {
            return Err(Trap::new(Message::Interrupted));
        }
        let outcome = match OBSERVED || call.code.drains() {
            true => self.execute::<true>(mesh, call, watch)?,
            false => self.execute::<false>(mesh, call, watch)?,
        };
        if let Outcome::Applied { .. } = outcome
            && let Err(below) =
                validate_level_near(mesh, plan.level, &mesh.written_since(&before.mark))
        {
            let reason = Some(steps.below.saturating_add(place(&below)));
            return Ok(Outcome::Refused { reason });
        }
        Ok(outcome)
    }

    fn before(&self, mesh: &mut Mesh) -> Before {
        Before {
            mark: mesh.open_journal(),
            level: self.level,
            holding: self.holding,
            drains: self.drains.open_ones(),
            created: self.created.as_ref().map_or(0, Vec::len),
        }
    }

    fn keep(&mut self, mesh: &mut Mesh, before: Before) {
        self.put_back(&before);
        mesh.keep(before.mark);
    }

    fn undo(&mut self, mesh: &mut Mesh, before: Before) {
        self.put_back(&before);
        mesh.roll_back(before.mark);
        if let Some(all) = &mut self.created {
            all.truncate(before.created);
        }
    }

    /// Within, other levels may have been passed, and loops been left.
    fn put_back(&mut self, before: &Before) {
        (self.level, self.holding) = (before.level, before.holding);
        self.drains.leave(before.drains);
    }
}

/// What the machine and the mesh were like before an operation in steps.
struct Before {
    mark: Bookmark,
    level: Level,
    holding: u32,
    drains: usize,
    created: usize,
}

/// Looks on for somebody who is not to see what is printed.
struct Silent<'w>(&'w mut dyn Watch);

impl Watch for Silent<'_> {
    fn turn(&mut self, depth: u16, done: u64, total: Option<u64>) -> ControlFlow<()> {
        self.0.turn(depth, done, total)
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.0.tick()
    }
}
