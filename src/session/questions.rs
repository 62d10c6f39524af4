//! Whether operations would be applied: nothing is written.

use super::{Arguments, Error, Op, Reason, Session, Verdict};
use crate::diagnostic::Diagnostic;
use crate::rewrite::{Outcome, Unwatched};
use crate::run::Argument;

impl Session {
    /// Whether an operation would be applied.
    ///
    /// # Errors
    /// As of [`apply`](Self::apply).
    pub fn can(&mut self, op: &Op, arguments: impl Arguments) -> Result<bool, Error> {
        Ok(self.ask(op, arguments)?.is_none())
    }

    /// Why an operation would refuse, if it would.
    ///
    /// # Errors
    /// As of [`apply`](Self::apply).
    pub fn why(&mut self, op: &Op, arguments: impl Arguments) -> Result<Option<Reason>, Error> {
        let refusal = self.ask(op, arguments)?;
        Ok(refusal.map(|reason| self.reason(op, reason)))
    }

    /// At which elements an operation would be applied: for each slot of the first parameter that
    /// is an element and is not among the arguments, holes among faces. Where there is no element,
    /// it would not.
    ///
    /// # Errors
    /// As of [`apply`](Self::apply); or no such parameter is left.
    pub fn mask(&mut self, op: &Op, arguments: impl Arguments) -> Result<Vec<bool>, Error> {
        self.ask_everywhere(op, arguments, |verdict| verdict == Verdict::Applies)
    }

    /// The same with the reasons.
    ///
    /// # Errors
    /// As of [`mask`](Self::mask).
    pub fn verdicts(&mut self, op: &Op, arguments: impl Arguments) -> Result<Vec<Verdict>, Error> {
        self.ask_everywhere(op, arguments, |verdict| verdict)
    }

    /// The number of the refusal, if it is one.
    fn ask(&mut self, op: &Op, arguments: impl Arguments) -> Result<Option<Option<u16>>, Error> {
        self.expect_own(&op.program)?;
        let application = op.application()?;
        self.give(application.parameters(), arguments)?;
        self.make_ready(op, application)?;
        let plan = application.plan();
        let asked = self.machine.ask(&mut self.mesh, plan, &self.slots, &mut Unwatched);
        match asked.map_err(|trap| self.trapped(application, trap))? {
            Outcome::Applied { .. } => Ok(None),
            Outcome::Refused { reason } => Ok(Some(reason)),
        }
    }

    fn ask_everywhere<T: Clone>(
        &mut self,
        op: &Op,
        arguments: impl Arguments,
        answer: impl Fn(Verdict) -> T,
    ) -> Result<Vec<T>, Error> {
        self.expect_own(&op.program)?;
        let application = op.application()?;
        let parameters = application.parameters();
        self.give(parameters, arguments)?;
        let mut places = parameters.params().iter().zip(&self.values).enumerate();
        let free = places.find_map(|(at, (param, value))| match value {
            None => Some((at, crate::compile::element_kind(param.ty)?)),
            Some(_) => None,
        });
        let Some((at, kind)) = free else {
            let message = format!("`{}` has no parameter left that is an element", op.name());
            let error = Diagnostic::error("wrong-argument", message, super::error::NOWHERE);
            return Err(self.error(error));
        };
        let mut answers = vec![answer(Verdict::Gone); self.mesh.capacity(kind)];
        let ids = 0..answers.len() as u32;
        let living: Vec<u32> = ids.filter(|&id| self.mesh.is_alive(kind, id)).collect();
        let Some(&first) = living.first() else {
            return Ok(answers);
        };
        self.values[at] = Some(Argument::Element(kind, first));
        self.make_ready(op, application)?;
        let before = parameters.params()[..at].iter();
        let slot = before.map(|param| usize::from(crate::compile::width(param.ty))).sum::<usize>();
        let plan = application.plan();
        let unknown = op.reasons().len() - 1;
        for id in living {
            self.slots[slot] = u64::from(id);
            let asked = self.machine.ask(&mut self.mesh, plan, &self.slots, &mut Unwatched);
            let verdict = match asked {
                Ok(Outcome::Applied { .. }) => Verdict::Applies,
                Ok(Outcome::Refused { reason }) => {
                    Verdict::Refuses(reason.map_or(unknown, usize::from).min(unknown))
                }
                Err(trap) => {
                    let told = application.told(trap, &self.mesh);
                    return Err(self.error(told.note(format!("asked at {kind} {id}"))));
                }
            };
            answers[id as usize] = answer(verdict);
        }
        Ok(answers)
    }
}
