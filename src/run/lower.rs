//! Lowering of the statements of a script to register code.

use std::sync::Arc;

use super::call::FunctionCall;
use super::function::Known;
use super::live::{Exits, Liveness, calls};
use crate::compile::{Scope, copy, lower, lower_into, narrow, width};
use crate::diagram::{Access, Expr, ExprKind, NameId, Param, Type, Unary};
use crate::lower::{Effects, Variables};
use crate::resolve::{Body, Statement, StatementKind};
use crate::rewrite::{Assembler, Inst, Label, Phase, Refusal, Reg};
use crate::source::Span;

/// Writes the code of a script.
pub(super) struct Lowering<'p> {
    pub(super) asm: Assembler,
    pub(super) names: Names,
    liveness: Liveness<'p>,
    /// The loops around the current statement, the innermost last.
    pub(super) loops: Vec<Loop>,
    /// The variables of those loops that visit elements, the innermost last.
    visited: Vec<u32>,
    /// The number of drains around the current statement.
    pub(super) drains: u32,
    /// The number of parameters, which are the first variables.
    pub(super) params: usize,
    pub(super) variables: Variables,
    /// The buffer in which the running `update` keeps its writes back.
    pub(super) held: Option<u16>,
    /// The operations that are called or asked, each with the place of its first occurrence.
    pub(super) called: Vec<(usize, Span)>,
    /// The functions that are called.
    pub(super) functions: Vec<usize>,
    /// By number, whether each function of the program may call an operation.
    pub(super) calls_ops: Arc<[bool]>,
    /// The reasons for which an operation in steps may itself refuse.
    pub(super) refusals: Vec<Refusal>,
    /// The target of the jump where it refuses.
    refuses: Label,
    ending: Ending,
}

/// The effect of `return`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ending {
    /// The script ends.
    Script,
    /// The function returns its value to its caller.
    Function,
    /// The operation has been applied, and returns an element.
    Steps,
}

/// A body with its parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Routine<'p> {
    pub(super) params: &'p [Param],
    pub(super) body: &'p Body,
}

/// The labels of a loop: the start of the next iteration, and the end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Loop {
    pub(super) again: Label,
    pub(super) end: Label,
}

/// The registers of variables, and the places in the source.
#[derive(Debug, Default)]
pub(super) struct Names {
    registers: Vec<Reg>,
    pub(super) places: Vec<Span>,
}

impl Scope for Names {
    /// A script has no drawn elements.
    fn element(&self, _name: NameId) -> Reg {
        Reg(0)
    }

    fn local(&self, variable: u32) -> Reg {
        self.registers.get(variable as usize).copied().unwrap_or(Reg(0))
    }

    fn declare(&mut self, variable: u32, reg: Reg) {
        if let Some(known) = self.registers.get_mut(variable as usize) {
            *known = reg;
        }
    }

    fn place(&mut self, span: Span) -> u32 {
        self.places.push(span);
        self.places.len() as u32 - 1
    }

    fn is_of_statements(&self) -> bool {
        true
    }
}

impl<'p> Lowering<'p> {
    /// Begins the code of a script: the registers are the parameters, then for each of them whether
    /// it is given, then the other variables.
    pub(super) fn of_script(routine: Routine<'p>, known: Known<'_>) -> Self {
        let mut effects = Effects::of_block(&routine.body.block);
        let defaults = routine.params.iter().filter_map(|param| param.default.as_ref());
        defaults.for_each(|default| effects.see(default));
        let mut lowering = Self::with_parameters(routine, effects, known);
        let given: Vec<Reg> = routine.params.iter().map(|_| lowering.asm.reg()).collect();
        lowering.other_variables(routine);
        for (variable, (param, condition)) in (0..).zip(routine.params.iter().zip(given)) {
            if let Some(default) = &param.default {
                let to = lowering.asm.label();
                lowering.asm.emit(Inst::JumpIf { condition, to });
                lowering.set(variable, default);
                lowering.asm.bind(to);
            }
        }
        lowering
    }

    /// Begins the code of a script that is called like a function: whether a parameter is given is
    /// itself a parameter.
    pub(super) fn of_called_script(routine: Routine<'p>, known: Known<'_>) -> Self {
        Self { ending: Ending::Function, ..Self::of_script(routine, known) }
    }

    /// Begins the code of a function: the registers are the parameters, then the other variables.
    pub(super) fn of_function(routine: Routine<'p>, known: Known<'_>) -> Self {
        let effects = Effects::of_block(&routine.body.block);
        Self { ending: Ending::Function, ..Self::of_steps(routine, effects, known) }
    }

    /// Begins the code of an operation in steps: the registers are the parameters, then the other
    /// variables.
    pub(super) fn of_steps(routine: Routine<'p>, effects: Effects, known: Known<'_>) -> Self {
        let mut lowering = Self::with_parameters(routine, effects, known);
        lowering.other_variables(routine);
        lowering.ending = Ending::Steps;
        lowering
    }

    /// Lets the operation in steps refuse unless the condition holds.
    pub(super) fn require(&mut self, condition: Reg, reason: &str) {
        let (refusal, otherwise) = (self.refusals.len() as u16, self.refuses);
        self.asm.emit(Inst::Expect { condition, refusal, otherwise });
        self.refusals.push(Refusal { reason: reason.to_owned(), phase: Phase::Require });
    }

    /// Appends the end of the steps, reached without a `return`, and the target of refusals.
    pub(super) fn end_of_steps(&mut self) {
        self.asm.emit(Inst::Return { result: None });
        self.asm.bind(self.refuses);
        self.asm.emit(Inst::Refuse);
    }

    fn with_parameters(routine: Routine<'p>, effects: Effects, known: Known<'_>) -> Self {
        let mut asm = Assembler::knowing(known.texts);
        let mut lowering = Self {
            params: routine.params.len(),
            variables: Variables::of(&routine.body.block),
            refusals: Vec::new(),
            refuses: asm.label(),
            asm,
            names: Names::default(),
            liveness: Liveness { variables: &routine.body.variables },
            loops: Vec::new(),
            drains: 0,
            held: None,
            called: effects.ops.into_iter().collect(),
            calls_ops: Arc::clone(known.calls_ops),
            functions: effects.functions.into_iter().map(|number| number as usize).collect(),
            visited: Vec::new(),
            ending: Ending::Script,
        };
        let params = routine.params.iter().map(|param| lowering.asm.block(width(param.ty)));
        lowering.names.registers.extend(params);
        lowering
    }

    fn other_variables(&mut self, routine: Routine<'p>) {
        let others = routine.body.variables.iter().skip(routine.params.len());
        self.names.registers.extend(others.map(|other| self.asm.block(width(other.ty))));
    }

    /// Appends the end of a function, reached without a `return`.
    pub(super) fn end(&mut self) {
        self.asm.emit(Inst::ReturnValue { from: Reg(0), width: 0 });
    }

    /// Lowers the whole script.
    pub(super) fn body(&mut self, routine: Routine<'p>) {
        self.block(&routine.body.block, Some(&Exits::default()));
    }

    /// Lowers a block. `exits` is `None` inside a loop over elements, where no id may be reused.
    pub(super) fn block(&mut self, block: &[Statement], exits: Option<&Exits>) {
        let Some(exits) = exits else {
            return block.iter().for_each(|statement| self.statement(statement, None));
        };
        let before = self.liveness.before_each(block, exits);
        for (at, statement) in block.iter().enumerate() {
            if before[at].is_empty() && calls(statement) {
                self.asm.emit(Inst::Recycle);
            }
            let next = before.get(at + 1).unwrap_or(&exits.next);
            let exits = exits.going_on(next.clone());
            self.statement(statement, Some(&exits));
        }
    }

    fn statement(&mut self, statement: &Statement, exits: Option<&Exits>) {
        let outside = self.visited.len();
        if let StatementKind::For { variable, .. } | StatementKind::Drain { variable, .. } =
            &statement.kind
        {
            self.visited.push(*variable);
        }
        let mark = self.asm.mark();
        let span = statement.span;
        match &statement.kind {
            StatementKind::Set { variable, value } => match &value.kind {
                ExprKind::Invoke(function, args) => {
                    let holds = self.needs_ids(exits, Some(*variable));
                    let from = self.given(*function, args, value, holds);
                    let to = self.names.local(*variable);
                    copy(&mut self.asm, value.ty, to, from);
                }
                _ => self.set(*variable, value),
            },
            StatementKind::Call { function, args, result } => {
                let call = FunctionCall {
                    function: *function,
                    args,
                    to: self.asm.block(result.map_or(0, width)),
                    holds: self.needs_ids(exits, None),
                };
                self.call(call, span);
            }
            StatementKind::Write { target, attribute, value } => {
                self.write(target, *attribute, value, span)
            }
            StatementKind::Repeat { count, body } => self.repeat(count, body, span, exits),
            StatementKind::While { condition, body } => {
                self.repeat_while(condition, body, span, exits);
            }
            StatementKind::For { .. } => self.visit(statement),
            StatementKind::Drain { .. } => self.drain(statement, exits),
            StatementKind::If { condition, then, otherwise } => {
                let condition = self.value(condition);
                self.choose(condition, [then, otherwise], exits);
            }
            StatementKind::Apply { op, args, variable, then, otherwise } => {
                let (applied, from) = self.apply(*op, args, span);
                if let Some(variable) = variable {
                    // Where the operation has refused, the variable is not read.
                    let to = self.names.local(*variable);
                    self.asm.emit(Inst::Copy { to, from });
                }
                self.choose(applied, [then, otherwise], exits);
            }
            StatementKind::Print(pieces) => self.print(pieces),
            StatementKind::Assert { condition, reason } => self.assert(condition, reason, span),
            StatementKind::Require { condition, reason } => {
                let condition = self.value(condition);
                self.require(condition, reason);
            }
            // The operation just called has refused, though it must not.
            StatementKind::Refused { op } => self.trap_at(span, Inst::Refused { op: narrow(*op) }),
            StatementKind::KeepMesh { mesh } => self.trap_at(span, Inst::MeshKeep { mesh: *mesh }),
            StatementKind::AssertMesh { mesh, same, reason } => {
                self.assert_mesh(*mesh, *same, reason, span);
            }
            StatementKind::AssertRefuses { op, args, why, reason } => {
                self.assert_refuses(*op, args, [why.as_deref(), reason.as_deref()], span);
            }
            StatementKind::Break => self.jump(|around| around.end),
            StatementKind::Continue => self.jump(|around| around.again),
            StatementKind::Return(value) => self.leave(value.as_ref(), exits),
        }
        self.asm.release(mark);
        self.visited.truncate(outside);
    }

    /// The variables that hold the elements a condition depends on: those of the loops around it,
    /// and those that it reads; each with its name and its type.
    pub(super) fn whereabouts(&self, condition: &Expr) -> Vec<(u32, &'p str, Type)> {
        let mut numbers = self.visited.clone();
        // Variables of the condition itself, which may be past the elements that count.
        let mut own = Vec::new();
        condition.each(&mut |part| match &part.kind {
            ExprKind::Local(number) => numbers.push(*number),
            ExprKind::Fold(fold) => own.push(fold.variable),
            ExprKind::Let(variable, ..) => own.push(*variable),
            _ => {}
        });
        let stopped = stopped(condition);
        numbers.retain(|number| !own.contains(number) || stopped.contains(number));
        let mut known: Vec<(u32, &str, Type)> = Vec::new();
        for number in numbers {
            let variable = self.liveness.variables.get(number as usize);
            if let Some(variable) = variable.filter(|variable| variable.ty.is_element())
                && known.iter().all(|(other, ..)| *other != number)
            {
                known.push((number, variable.name.as_str(), variable.ty));
            }
        }
        known
    }

    /// The exits of the body of a loop whose own exits are `exits`.
    pub(super) fn exits_of_body(
        &self,
        conditions: &[&Expr],
        body: &[Statement],
        exits: Option<&Exits>,
    ) -> Option<Exits> {
        let exits = exits?;
        Some(exits.of_body(self.liveness.at_head(conditions, body, exits)))
    }

    /// Whether ids are still needed after a statement with these exits; the variable that it sets
    /// does not count.
    fn needs_ids(&self, exits: Option<&Exits>, set: Option<u32>) -> bool {
        exits.is_none_or(|exits| exits.next.iter().any(|needed| Some(*needed) != set))
    }

    /// The result of a function that is called for `value`; `holds` is that of [`FunctionCall`].
    fn given(&mut self, function: u32, args: &[Expr], value: &Expr, holds: bool) -> Reg {
        let to = self.asm.block(width(value.ty));
        self.call(FunctionCall { function, args, to, holds }, value.span);
        to
    }

    /// `return`, `return x`
    fn leave(&mut self, value: Option<&Expr>, exits: Option<&Exits>) {
        let given = value.map(|value| match &value.kind {
            ExprKind::Invoke(function, args) => {
                // Inside a loop over elements the ids stay needed, although this one is left: a
                // loop further out may still be running.
                (self.given(*function, args, value, exits.is_none()), width(value.ty))
            }
            _ => (self.value(value), width(value.ty)),
        });
        self.close_drains();
        let (from, width) = given.unwrap_or((Reg(0), 0));
        self.asm.emit(match self.ending {
            Ending::Function => Inst::ReturnValue { from, width },
            Ending::Script => Inst::Return { result: None },
            Ending::Steps => Inst::Return { result: given.map(|_| from) },
        });
    }

    pub(super) fn value(&mut self, value: &Expr) -> Reg {
        lower(&mut self.asm, &mut self.names, value)
    }

    pub(super) fn value_into(&mut self, value: &Expr, to: Reg) {
        lower_into(&mut self.asm, &mut self.names, value, to);
    }

    pub(super) fn trap_at(&mut self, span: Span, inst: Inst) {
        self.asm.trap_at(self.names.place(span), inst);
    }

    fn set(&mut self, variable: u32, value: &Expr) {
        let mark = self.asm.mark();
        // Not directly into the variable, since the value may read it.
        let from = self.value(value);
        let to = self.names.local(variable);
        copy(&mut self.asm, value.ty, to, from);
        self.asm.release(mark);
    }

    fn write(&mut self, target: &Expr, access: Access, value: &Expr, span: Span) {
        let element = self.value(target);
        let value = self.value(value);
        let vertex = element;
        let inst = match (access, self.held) {
            (Access::Position, Some(buffer)) => Inst::DeferPosition { buffer, vertex, value },
            (Access::Position, None) => Inst::StorePosition { vertex, value },
            (Access::Declared(number), Some(buffer)) => {
                Inst::DeferAttribute { buffer, attribute: narrow(number), element, value }
            }
            (Access::Declared(number), None) => {
                Inst::StoreAttribute { attribute: narrow(number), element, value }
            }
        };
        self.trap_at(span, inst);
    }

    fn choose(&mut self, condition: Reg, blocks: [&[Statement]; 2], exits: Option<&Exits>) {
        let end = self.asm.label();
        match blocks {
            [[], []] => {}
            [[], otherwise] => {
                self.asm.emit(Inst::JumpIf { condition, to: end });
                self.block(otherwise, exits);
            }
            [then, []] => {
                self.asm.emit(Inst::JumpUnless { condition, to: end });
                self.block(then, exits);
            }
            [then, otherwise] => {
                let second = self.asm.label();
                self.asm.emit(Inst::JumpUnless { condition, to: second });
                self.block(then, exits);
                self.asm.emit(Inst::Jump { to: end });
                self.asm.bind(second);
                self.block(otherwise, exits);
            }
        }
        self.asm.bind(end);
    }

    fn jump(&mut self, place: impl Fn(&Loop) -> Label) {
        // A resolved script has such statements only in loops.
        if let Some(to) = self.loops.last().map(place) {
            self.asm.emit(Inst::Jump { to });
        }
    }
}

/// The variables of the aggregates that have stopped at an element since a condition does not hold:
/// that of `all`, and of `any` behind `not`, from outside in.
fn stopped(condition: &Expr) -> Vec<u32> {
    let (mut at, mut holds) = (condition, false);
    let mut variables = Vec::new();
    loop {
        match &at.kind {
            ExprKind::Unary(Unary::Not, inner) => (at, holds) = (inner, !holds),
            ExprKind::Fold(fold) if fold.function.ends_early_at(holds) => {
                variables.push(fold.variable);
                at = &fold.body;
            }
            _ => return variables,
        }
    }
}
