//! The statements of steps and of functions.

use std::collections::BTreeSet;

use super::super::NotEmitted;
use super::super::conventions::Conventions;
use super::super::expression::{Expressions, around, is_spelled, is_surely_finite};
use super::super::names::Names;
use super::super::routine::{Field, Form, Held, Statement, Target};
use super::super::term::{Parameter, Term};
use super::comments::comments;
use crate::diagram::{Access, Collection, Expr, ExprKind, Type};
use crate::lower::{AllEffects, Variables};
use crate::resolve::{Block, Body, Program, Statement as Step, StatementKind, Visit};
use crate::source::{Sources, Span};

/// The facts about the program.
#[derive(Clone, Copy)]
pub(super) struct Context<'s> {
    pub program: &'s Program,
    pub sources: &'s Sources,
    pub effects: &'s AllEffects,
    /// The names of the operations in code.
    pub op_names: &'s [String],
    pub conventions: Conventions<'s>,
    /// The names of the functions in code.
    pub function_names: &'s [String],
}

/// Writes the statements of one body.
pub(super) struct Writer<'s> {
    pub(super) context: Context<'s>,
    body: &'s Body,
    pub(super) names: &'s mut Names,
    /// True if it is that of a function, not of an operation.
    is_function: bool,
    /// The variables that are bound so far.
    bound: BTreeSet<u32>,
    pub(super) variables: Variables,
    /// The assignments that an `update` defers.
    held: Vec<(Access, Held)>,
    /// The operations that are called.
    pub ops: BTreeSet<usize>,
    /// The functions that are called, and change the mesh or may refuse.
    pub functions: BTreeSet<u32>,
}

impl<'s> Writer<'s> {
    /// A writer for a body whose first variables are parameters, which are named already.
    pub fn new(
        context: Context<'s>,
        body: &'s Body,
        params: usize,
        is_function: bool,
        names: &'s mut Names,
    ) -> Self {
        Self {
            context,
            body,
            names,
            is_function,
            bound: (0..params as u32).collect(),
            variables: Variables::of(&body.block),
            held: Vec::new(),
            ops: BTreeSet::new(),
            functions: BTreeSet::new(),
        }
    }

    /// Writes all statements.
    pub fn write(&mut self) -> Result<Vec<Statement>, NotEmitted> {
        let body = self.body;
        if let Some(variable) = body.variables.iter().find(|of| !is_spelled(of.ty)) {
            let what = format!("a variable of type `{}`", variable.ty.word());
            return Err(NotEmitted::new(what, variable.span));
        }
        let mut written = self.block(&body.block)?;
        let leaves = matches!(body.block.last(), Some(Step { kind: StatementKind::Return(_), .. }));
        if !leaves && !self.gives_back() {
            written.push(Statement::Return { value: None });
        }
        Ok(written)
    }

    /// True if a `return` gives a value.
    fn gives_back(&self) -> bool {
        let mut gives = false;
        let mut look = |statement: &Step| {
            gives |= matches!(statement.kind, StatementKind::Return(Some(_)));
        };
        self.body.block.iter().for_each(|statement| statement.each(&mut look));
        gives
    }

    /// Runs `write`; the words that it takes are free again afterwards.
    pub(super) fn scope<T>(&mut self, write: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.names.taken.clone();
        let written = write(self);
        self.names.taken = outer;
        written
    }

    pub(super) fn block(&mut self, block: &'s Block) -> Result<Vec<Statement>, NotEmitted> {
        self.scope(|this| {
            let mut written = Vec::new();
            for statement in block {
                let lines = comments(this.context.sources, statement.span);
                written.extend(lines.into_iter().map(Statement::Comment));
                this.statement(statement, &mut written)?;
            }
            Ok(written)
        })
    }

    pub(super) fn statement(
        &mut self,
        statement: &'s Step,
        out: &mut Vec<Statement>,
    ) -> Result<(), NotEmitted> {
        let span = statement.span;
        let action = match &statement.kind {
            StatementKind::Set { variable, value } => return self.set(*variable, value, out),
            StatementKind::Write { target, attribute, value } => {
                return self.put(target, *attribute, value, out);
            }
            StatementKind::Repeat { count, body } => {
                let count = self.term(count)?;
                self.scope(|this| {
                    let index = this.names.fresh("i");
                    Ok(Statement::Repeat { index, count, body: this.block(body)? })
                })?
            }
            StatementKind::While { condition, body } => {
                Statement::While { condition: self.term(condition)?, body: self.block(body)? }
            }
            StatementKind::For { variable, collection, filter, body, visit, parallel: false }
                if *visit != Visit::Shuffled =>
            {
                let action = self.scope(|this| {
                    if *visit == Visit::Update {
                        this.held = this.written_in(body);
                    }
                    this.visit((*variable, collection), filter.as_ref(), body, span)
                })?;
                let held = std::mem::take(&mut self.held).into_iter().map(|(_, held)| held);
                match visit {
                    Visit::Update => {
                        Statement::Update { visit: Box::new(action), held: held.collect() }
                    }
                    _ => action,
                }
            }
            StatementKind::If { condition, then, otherwise }
                if self.is_function
                    && let (Some(then), Some(other)) =
                        (self.value(then), self.value(otherwise)) =>
            {
                let kind = ExprKind::If(
                    Box::new(condition.clone()),
                    Box::new(then.clone()),
                    Box::new(other.clone()),
                );
                let chosen = Expr { ty: then.ty, span, kind };
                return self.leave(Some(&chosen), out);
            }
            StatementKind::If { condition, then, otherwise } => Statement::Choose {
                condition: self.term(condition)?,
                then: self.block(then)?,
                otherwise: self.block(otherwise)?,
            },
            StatementKind::Apply { op, args, variable, then, otherwise } => {
                let call = self.operation(*op, args, out)?;
                return self.apply(call, *variable, [then, otherwise], out);
            }
            StatementKind::Require { condition, reason } => {
                out.push(Statement::Refuse {
                    when: self.term(condition)?.not(),
                    reason: reason.clone(),
                });
                return Ok(());
            }
            StatementKind::Break => Statement::Break,
            StatementKind::Continue => Statement::Continue,
            StatementKind::Return(value) => return self.leave(value.as_ref(), out),
            StatementKind::Call { function, args, .. }
                if (*function as usize) < self.context.program.functions.len() =>
            {
                let effects = self.context.effects.function(*function);
                // A call without effects is omitted, since its value is not used.
                if !effects.is_some_and(|effects| effects.changes || effects.refuses) {
                    return Ok(());
                }
                let call = self.function(*function, args, out)?;
                Statement::MustCall { call, place: None }
            }
            kind => return Err(NotEmitted::new(not_emitted(kind), span)),
        };
        out.push(action);
        Ok(())
    }

    /// The value of a block that only computes one.
    fn value<'b>(&self, block: &'b Block) -> Option<&'b Expr> {
        match block.as_slice() {
            [Step { kind: StatementKind::Return(Some(value)), .. }] => {
                self.changing_call(value).is_none().then_some(value)
            }
            _ => None,
        }
    }

    /// The term of a value, after binding the parts of it that have the same value each time.
    fn computed(&mut self, value: &Expr, out: &mut Vec<Statement>) -> Result<Term, NotEmitted> {
        let value = Expressions { names: self.names }.once(value, false, None, out)?;
        self.term(&value)
    }

    pub(super) fn term(&mut self, value: &Expr) -> Result<Term, NotEmitted> {
        Expressions { names: self.names }.term(value)
    }

    /// Names a variable.
    pub(super) fn bind(&mut self, variable: u32) -> Parameter {
        let known = self.body.variables.get(variable as usize);
        let wanted = known.map_or("x", |variable| variable.name.as_str());
        self.bound.insert(variable);
        let name = self.names.bind(variable, wanted);
        Parameter::new(name, known.map_or(Type::Int, |variable| variable.ty))
    }

    /// The target for the value of a variable; `None` if it is never read.
    pub(super) fn place(&mut self, variable: u32) -> Option<Target> {
        if !self.variables.reads(variable) {
            return None;
        }
        if self.bound.contains(&variable) {
            let known = self.body.variables.get(variable as usize)?;
            let (name, ty) = (self.names.local(variable).to_string(), known.ty);
            let form = Form::Known;
            return Some(Target { name, ty, form });
        }
        let Parameter { name, ty, .. } = self.bind(variable);
        let form = match self.variables.sets(variable) {
            0 | 1 => Form::Fixed,
            _ => Form::Changing,
        };
        Some(Target { name, ty, form })
    }

    fn set(
        &mut self,
        variable: u32,
        value: &Expr,
        out: &mut Vec<Statement>,
    ) -> Result<(), NotEmitted> {
        if let Some((function, args)) = self.changing_call(value) {
            let call = self.function(function, args, out)?;
            let place = self.place(variable);
            out.push(Statement::MustCall { call, place });
            return Ok(());
        }
        // Computed first, since the value cannot refer to a new variable.
        let value = self.computed(value, out)?;
        let place = self.place(variable);
        out.extend(place.map(|place| Statement::Variable { place, value }));
        Ok(())
    }

    /// The attributes that the statements of an `update` write to, with names for the lists of the
    /// deferred writes.
    fn written_in(&mut self, body: &Block) -> Vec<(Access, Held)> {
        let mut held: Vec<(Access, Held)> = Vec::new();
        let mut note = |statement: &Step| {
            let StatementKind::Write { target, attribute: access, value } = &statement.kind else {
                return;
            };
            if held.iter().any(|(known, _)| known == access) {
                return;
            }
            let attribute = match access {
                Access::Position => None,
                Access::Declared(number) => self.names.attribute(*number),
            };
            let word = attribute.as_ref().map_or("position", |it| &it.declared);
            let written = Held {
                list: self.names.fresh(&format!("{}s", word.replace('\'', "_"))),
                element: target.ty,
                ty: value.ty,
                attribute,
            };
            held.push((*access, written));
        };
        body.iter().for_each(|statement| statement.each(&mut note));
        held
    }

    fn put(
        &mut self,
        target: &Expr,
        attribute: Access,
        value: &Expr,
        out: &mut Vec<Statement>,
    ) -> Result<(), NotEmitted> {
        let is_finite = is_surely_finite(value, f64::INFINITY);
        let (ty, span) = (value.ty, value.span);
        let (target_ty, element) = (target.ty, self.term(target)?);
        let value = self.term(value)?;
        if let Some((_, held)) = self.held.iter().find(|(of, _)| *of == attribute) {
            let list = held.list.clone();
            out.push(Statement::Defer { list, element, value });
            return Ok(());
        }
        match attribute {
            Access::Position => out.push(Statement::Move { vertex: element, value, is_finite }),
            Access::Declared(number) => {
                let attribute = self.names.attribute(number);
                let attribute = attribute.ok_or_else(|| NotEmitted::new("an attribute", span))?;
                let (element, value) = self.scope(|this| {
                    let element = this.settled(element, target_ty, target_ty.word(), out);
                    (element, this.settled(value, ty, &attribute.name, out))
                });
                if !self.context.conventions.undoes {
                    out.push(Statement::JournalAttribute {
                        attribute: attribute.clone(),
                        element: element.clone(),
                    });
                }
                let field = Field::Attribute(attribute);
                out.push(Statement::Set { field, of: element, value });
            }
        }
        Ok(())
    }

    fn visit(
        &mut self,
        (variable, collection): (u32, &'s Collection),
        filter: Option<&'s Expr>,
        body: &'s Block,
        span: Span,
    ) -> Result<Statement, NotEmitted> {
        let (around, element) = around(collection).ok_or_else(|| {
            NotEmitted::new(super::super::expression::collection_words(collection), span)
        })?;
        let element = self.term(element)?;
        let may_go = self.context.effects.erases(body, collection.element());
        self.scope(|this| {
            Ok(Statement::For {
                variable: this.bind(variable),
                around,
                element,
                may_go,
                filter: filter.map(|filter| this.term(filter)).transpose()?,
                body: this.block(body)?,
            })
        })
    }

    fn leave(&mut self, value: Option<&Expr>, out: &mut Vec<Statement>) -> Result<(), NotEmitted> {
        let value = match value {
            None => None,
            Some(value) => Some(match self.changing_call(value) {
                None => self.computed(value, out)?,
                Some((function, args)) => {
                    let call = self.function(function, args, out)?;
                    let name = self.names.fresh("result");
                    let given = Term::name(&name);
                    let place = Some(Target { name, ty: value.ty, form: Form::Fixed });
                    out.push(Statement::MustCall { call, place });
                    given
                }
            }),
        };
        out.push(Statement::Return { value });
        Ok(())
    }
}

/// What a statement is that is not emitted.
fn not_emitted(kind: &StatementKind) -> &'static str {
    match kind {
        StatementKind::For { visit: Visit::Shuffled, .. } => "a random order",
        StatementKind::For { .. } => "`parallel for`",
        StatementKind::Call { .. } => "the call of a script",
        StatementKind::Drain { .. } => "a `drain`",
        StatementKind::Print(_) => "a `print`",
        StatementKind::Assert { .. } => "an `assert`",
        _ => "a statement of a test",
    }
}
