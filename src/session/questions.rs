//! Questions about whether operations would be applied; nothing is written.

use super::binding::Bound;
use super::{Arguments, Error, Op, Reason, Session, Verdict};
use crate::compile::width;
use crate::mesh::{Element, ElementKind};
use crate::rewrite::{Outcome, Trap};
use crate::run::{Application, Argument, Prepared};

/// The parameter of an operation that ranges over all elements.
pub(super) struct Free<'o> {
    pub(super) application: &'o Application,
    /// Its number.
    pub(super) at: usize,
    pub(super) kind: ElementKind,
    /// Its slot in the window.
    pub(super) slot: usize,
}

/// The first parameter that is an element and has no value: its number, its kind, and its slot in
/// the window.
pub(super) fn free_parameter(
    parameters: &Prepared,
    values: &[Option<Argument>],
) -> Option<(usize, ElementKind, usize)> {
    let mut slot = 0;
    for (at, (param, value)) in parameters.params().iter().zip(values).enumerate() {
        if let (None, Some(kind)) = (value, param.ty.element_kind()) {
            return Some((at, kind, slot));
        }
        slot += usize::from(width(param.ty));
    }
    None
}

impl Op {
    pub(super) fn verdict(&self, outcome: Outcome) -> Verdict {
        match outcome {
            Outcome::Applied { .. } => Verdict::Applies,
            Outcome::Refused { reason } => Verdict::Refuses(self.reason(reason).number),
        }
    }
}

/// A match of an operation: the elements that its drawing denotes at a place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Match {
    /// The index of the matching rule among those of the operation.
    pub rule: usize,
    /// The names of its `before`, each with the elements that it denotes: one, or one for each
    /// index of a family. Empty for an operation in steps, which has no drawing.
    pub names: Vec<(String, Vec<Element>)>,
}

impl Session {
    /// True if an operation would be applied.
    ///
    /// # Errors
    /// As for [`apply`](Self::apply).
    pub fn can(&mut self, op: &Op, arguments: impl Arguments) -> Result<bool, Error> {
        Ok(self.ask(op, arguments)?.is_none())
    }

    /// The reason why an operation would refuse, if it would.
    ///
    /// # Errors
    /// As for [`apply`](Self::apply).
    pub fn why(&mut self, op: &Op, arguments: impl Arguments) -> Result<Option<Reason>, Error> {
        Ok(self.ask(op, arguments)?.map(|reason| op.reason(reason)))
    }

    /// The rule of an operation that matches, with the elements that its names denote; or why the
    /// operation would refuse.
    ///
    /// # Errors
    /// As for [`apply`](Self::apply).
    pub fn matched(
        &mut self,
        op: &Op,
        arguments: impl Arguments,
    ) -> Result<Result<Match, Reason>, Error> {
        if let Some(reason) = self.ask(op, arguments)? {
            return Ok(Err(op.reason(reason)));
        }
        let Some((rule, names)) = self.engine.machine.matched(op.application()?.plan()) else {
            return Ok(Ok(Match::default()));
        };
        let names = names.into_iter().map(|(name, kind, ids)| {
            let elements = ids.into_iter().map(|index| Element { kind, index });
            (name.to_owned(), elements.collect())
        });
        Ok(Ok(Match { rule, names: names.collect() }))
    }

    /// Whether an operation would be applied, for each slot of the first parameter that is an
    /// element and is not among the arguments, holes being faces. `false` for dead slots.
    ///
    /// # Errors
    /// As for [`apply`](Self::apply); or no such parameter is left.
    pub fn mask(&mut self, op: &Op, arguments: impl Arguments) -> Result<Vec<bool>, Error> {
        self.ask_everywhere(op, arguments, |verdict| verdict == Verdict::Applies)
    }

    /// As [`mask`](Self::mask), with the reasons.
    ///
    /// # Errors
    /// As for [`mask`](Self::mask).
    pub fn verdicts(&mut self, op: &Op, arguments: impl Arguments) -> Result<Vec<Verdict>, Error> {
        self.ask_everywhere(op, arguments, |verdict| verdict)
    }

    /// The refusal, if the operation would refuse, with the number of its reason if that is known.
    fn ask(&mut self, op: &Op, arguments: impl Arguments) -> Result<Option<Option<u16>>, Error> {
        let application = self.enter(op, arguments, Bound::ToAsk)?;
        let asked = self.with_own_defaults(|session| session.ask_at(application));
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
        let Free { application, at, kind, slot } = self.free_parameter(op, arguments)?;
        let mut answers = vec![answer(Verdict::Gone); self.mesh.capacity(kind)];
        let living: Vec<u32> = self.mesh.elements(kind).collect();
        let Some(&first) = living.first() else { return Ok(answers) };
        self.values[at] = Some(Argument::Element(kind, first));
        self.make_ready(op, application, Bound::ToAsk)?;
        self.with_own_defaults(|session| {
            for id in living {
                session.slots[slot] = u64::from(id);
                let asked = session.ask_at(application);
                let trapped = |trap| session.trapped_at(application, trap, (kind, id));
                answers[id as usize] = answer(op.verdict(asked.map_err(trapped)?));
            }
            Ok(answers)
        })
    }

    /// Asks whether an operation would be applied where the slots tell.
    pub(super) fn ask_at(&mut self, application: &Application) -> Result<Outcome, Trap> {
        let Self { engine, mesh, slots, watch, .. } = self;
        engine.machine.ask(mesh, application.plan(), slots, &mut **watch)
    }

    /// Takes the arguments, and finds the parameter that ranges over all elements.
    pub(super) fn free_parameter<'o>(
        &mut self,
        op: &'o Op,
        arguments: impl Arguments,
    ) -> Result<Free<'o>, Error> {
        self.expect_own(&op.program)?;
        let application = op.application()?;
        let parameters = application.parameters();
        self.give(parameters, arguments)?;
        match free_parameter(parameters, &self.values) {
            Some((at, kind, slot)) => Ok(Free { application, at, kind, slot }),
            None => Err(self.no_free_parameter(op.name())),
        }
    }

    pub(super) fn no_free_parameter(&self, name: &str) -> Error {
        let message = format!("`{name}` has no parameter left that is an element");
        self.wrong("wrong-argument", message)
    }

    /// The error for a trap while an operation was tested at an element.
    pub(super) fn trapped_at(
        &self,
        application: &Application,
        trap: Trap,
        (kind, id): (ElementKind, u32),
    ) -> Error {
        let told = application.told(trap, &self.mesh);
        self.error(told.note(format!("asked at {kind} {id}")))
    }
}
