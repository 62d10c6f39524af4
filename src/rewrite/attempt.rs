//! Asking whether an operation would apply, without applying it.
//!
//! A drawn operation makes all its tests before its first write, so it is run up to that point. An
//! operation in steps is applied and then undone. Either way the mesh, the counts and the random
//! numbers are left unchanged. While the key of a `drain` asks an operation, only the operation's
//! reads are noted as dependencies of the key; the writes, which are undone, are not.

use std::ops::ControlFlow;

use super::engine::CodeKind;
use super::inst::group;
use super::{Call, Inst, Machine, Message, Outcome, Plan, Trap, Watch};
use crate::mesh::Mesh;

/// The first number of the texts that are made while code runs.
const FIRST_INTERNED: u32 = 1 << 31;

/// Texts that are made while code runs; no two are equal.
#[derive(Clone, Debug, Default)]
pub(super) struct Interner(Vec<String>);

impl Interner {
    /// The number of a text: its place in the constant texts if it is one of them.
    pub(super) fn number(&mut self, constant: &[String], text: &str) -> u32 {
        if let Some(known) = constant.iter().position(|known| known == text) {
            return known as u32;
        }
        let number = self.0.iter().position(|known| known == text).unwrap_or_else(|| {
            self.0.push(text.to_owned());
            self.0.len() - 1
        });
        FIRST_INTERNED | number as u32
    }

    /// The text of a number.
    pub(super) fn text<'t>(&'t self, constant: &'t [String], number: u32) -> Option<&'t str> {
        let found = match number & FIRST_INTERNED {
            0 => constant.get(number as usize),
            _ => self.0.get((number ^ FIRST_INTERNED) as usize),
        };
        found.map(String::as_str)
    }
}

impl Inst {
    /// Whether the instruction writes to the mesh.
    pub(super) fn writes(&self) -> bool {
        matches!(self, group!(writes))
    }

    /// Whether running drains are notified before the instruction is executed.
    #[inline]
    pub(super) fn is_observed_write(&self) -> bool {
        self.writes() || matches!(self, Inst::WriteDeferred { .. })
    }
}

impl Machine {
    /// Asks an operation whether it would apply; if not, the outcome has the number of the reason.
    #[cold]
    pub(super) fn attempt(
        &mut self,
        mesh: &mut Mesh,
        caller: &Call<'_>,
        call: [u16; 2],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        let (plan, call) = self.begin_call(mesh, caller, call)?;
        self.consider(mesh, plan, call, watch)
    }

    /// [`attempt`](Self::attempt) for a call that is already set up.
    pub(super) fn consider(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        call: Call<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        let Some(steps) = &plan.steps else {
            let dry = Call { kind: CodeKind::Dry, ..call };
            if let Some(outcome) = self.run_native(mesh, dry, watch) {
                return outcome;
            }
            self.is_dry = true;
            let outcome = self.execute::<true>(mesh, call, watch);
            self.is_dry = false;
            return outcome;
        };
        let (random, muted) = (self.random.clone(), self.drains.mute());
        let created = self.created.as_ref().map_or(0, Vec::len);
        let mark = mesh.open_journal();
        let known = self.begin_steps(mesh, &steps.calls);
        let outcome = self.take::<true>(mesh, (plan, steps), call, &mut Silent(watch));
        mesh.roll_back(mark);
        // What the steps have found out about the level is no more so.
        self.end_steps(known, false);
        self.drains.unmute(muted);
        self.random = random;
        if let Some(all) = &mut self.created {
            all.truncate(created);
        }
        outcome
    }

    /// The reason why an operation refuses, as text; empty if it does not refuse.
    pub(super) fn reason_of(&self, op: u16, outcome: Outcome) -> &str {
        let Outcome::Refused { reason } = outcome else { return "" };
        let plan = self.plans.get(usize::from(op)).and_then(Option::as_ref);
        let refusal = plan.zip(reason).and_then(|(plan, at)| plan.refusals.get(usize::from(at)));
        refusal.map_or("the diagram does not match here", |refusal| &refusal.reason)
    }

    /// A random number from 0 up to, but without, `bound`.
    pub(super) fn chosen_below(&mut self, bound: i64) -> Result<i64, Message> {
        match u64::try_from(bound) {
            Ok(bound) if bound > 0 => Ok(self.random.below(bound) as i64),
            _ => Err(Message::NothingToChoose),
        }
    }
}

/// A watcher that drops printed lines and passes everything else on.
struct Silent<'w>(&'w mut dyn Watch);

impl Watch for Silent<'_> {
    fn iteration(&mut self, depth: u16, done: u64, total: Option<u64>) -> ControlFlow<()> {
        self.0.iteration(depth, done, total)
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.0.tick()
    }

    fn print(&mut self, _line: &str) {}
}
