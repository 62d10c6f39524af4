//! The statements of steps and of functions.

use std::collections::BTreeSet;

use super::super::NotEmitted;
use super::super::action::{Action, Call, Called, Form, Place};
use super::super::build::Conventions;
use super::super::expression::{Expressions, around, is_spelled, is_surely_finite};
use super::super::names::Names;
use super::super::routine;
use super::super::term::{Parameter, Term};
use super::comments::comments;
use super::deeds::{AllDeeds, each, values};
use crate::diagram::{Access, Collection, Expr, ExprKind, Type};
use crate::resolve::{Block, Body, Program, Statement, StatementKind};
use crate::source::{Sources, Span};

/// What the statements stand in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// An operation.
    Steps,
    /// A function that has a value.
    Value,
    /// One that has none.
    Nothing,
}

/// What is known of the program.
#[derive(Clone, Copy)]
pub(super) struct Surroundings<'s> {
    pub program: &'s Program,
    pub sources: &'s Sources,
    pub deeds: &'s AllDeeds,
    /// What the operations are called in code.
    pub op_names: &'s [String],
    pub conventions: Conventions,
}

/// Writes the statements of one body.
pub(super) struct Writer<'s> {
    known: Surroundings<'s>,
    body: &'s Body,
    names: &'s mut Names,
    ending: Ending,
    /// The variables that there are so far, those that change, and those that are read.
    bound: BTreeSet<u32>,
    changing: BTreeSet<u32>,
    read: BTreeSet<u32>,
    /// The operations that are called.
    pub ops: BTreeSet<usize>,
    /// The functions that are called, and change the mesh.
    pub functions: BTreeSet<u32>,
}

impl<'s> Writer<'s> {
    /// For a body whose first variables are parameters, and named.
    pub fn new(
        known: Surroundings<'s>,
        body: &'s Body,
        params: usize,
        ending: Ending,
        names: &'s mut Names,
    ) -> Self {
        let (mut set, mut changing) = (BTreeSet::new(), BTreeSet::new());
        let mut read = BTreeSet::new();
        each(&body.block, &mut |statement| {
            if let StatementKind::Set { variable, .. }
            | StatementKind::IfApply {
                variable: Some(variable),
                ..
            } = statement.kind
                && !set.insert(variable)
            {
                changing.insert(variable);
            }
            values(statement, &mut |value| {
                value.each(&mut |part| {
                    if let ExprKind::Local(variable) = part.kind {
                        read.insert(variable);
                    }
                });
            });
        });
        Self {
            known,
            body,
            names,
            ending,
            bound: (0..params as u32).collect(),
            changing,
            read,
            ops: BTreeSet::new(),
            functions: BTreeSet::new(),
        }
    }

    /// All statements.
    pub fn write(&mut self) -> Result<Vec<routine::Statement>, NotEmitted> {
        let body = self.body;
        if let Some(variable) = body.variables.iter().find(|of| !is_spelled(of.ty)) {
            let what = format!("a variable of type `{}`", variable.ty.word());
            return Err(NotEmitted::new(what, variable.span));
        }
        let mut written = self.block(&body.block)?;
        let leaves = matches!(
            body.block.last(),
            Some(Statement {
                kind: StatementKind::Return(_),
                ..
            })
        );
        match self.ending {
            Ending::Steps if !leaves && !self.gives_back() => {
                written.push(routine::Statement::Return { result: None });
            }
            Ending::Nothing if !leaves => {
                written.push(routine::Statement::Action(Action::Leave));
            }
            _ => {}
        }
        Ok(written)
    }

    /// A value of the program, where nothing has been done yet.
    pub fn asked(&mut self, value: &Expr) -> Result<Term, NotEmitted> {
        self.term(value)
    }

    /// Whether a `return` gives something.
    fn gives_back(&self) -> bool {
        let mut gives = false;
        each(&self.body.block, &mut |statement| {
            gives |= matches!(statement.kind, StatementKind::Return(Some(_)));
        });
        gives
    }

    fn block(&mut self, block: &'s Block) -> Result<Vec<routine::Statement>, NotEmitted> {
        let outer = self.names.mark();
        let mut written = Vec::new();
        for statement in block {
            let lines = comments(self.known.sources, statement.span);
            written.extend(lines.into_iter().map(routine::Statement::Comment));
            self.statement(statement, &mut written)?;
        }
        self.names.back_to(outer);
        Ok(written)
    }

    fn statement(
        &mut self,
        statement: &'s Statement,
        out: &mut Vec<routine::Statement>,
    ) -> Result<(), NotEmitted> {
        let span = statement.span;
        let action = match &statement.kind {
            StatementKind::Set { variable, value } => return self.set(*variable, value, out),
            StatementKind::Write {
                target,
                attribute,
                value,
            } => return self.put(target, *attribute, value, out),
            StatementKind::Repeat { count, body } => {
                let count = self.term(count)?;
                let outer = self.names.mark();
                let index = self.names.fresh("i");
                let body = self.block(body)?;
                self.names.back_to(outer);
                Action::Repeat { index, count, body }
            }
            StatementKind::While { condition, body } => Action::While {
                condition: self.term(condition)?,
                body: self.block(body)?,
            },
            StatementKind::For {
                variable,
                collection,
                filter,
                body,
            } => self.visit((*variable, collection), filter.as_ref(), body, span)?,
            StatementKind::If {
                condition,
                then,
                otherwise,
            } => Action::Choose {
                condition: self.term(condition)?,
                then: self.block(then)?,
                otherwise: self.block(otherwise)?,
            },
            StatementKind::Apply { op, args, must } => {
                let call = self.operation(*op, args, out)?;
                match must {
                    true => Action::Must { call, place: None },
                    false => Action::May { call },
                }
            }
            StatementKind::IfApply {
                op,
                args,
                variable,
                then,
                otherwise,
            } => {
                let call = self.operation(*op, args, out)?;
                if let [only] = otherwise.as_slice()
                    && matches!(only.kind, StatementKind::Refused { .. })
                    && then.is_empty()
                {
                    let place = variable.and_then(|variable| self.place(variable));
                    Action::Must { call, place }
                } else {
                    let outer = self.names.mark();
                    let place = variable
                        .filter(|variable| self.read.contains(variable))
                        .map(|variable| self.bind(variable));
                    let then = self.block(then)?;
                    self.names.back_to(outer);
                    Action::Apply {
                        call,
                        place,
                        then,
                        otherwise: self.block(otherwise)?,
                    }
                }
            }
            StatementKind::Require { condition, reason } => {
                out.push(routine::Statement::Refuse {
                    when: self.term(condition)?.not(),
                    reason: reason.clone(),
                });
                return Ok(());
            }
            StatementKind::Break => Action::Break,
            StatementKind::Continue => Action::Continue,
            StatementKind::Return(value) => return self.leave(value.as_ref(), out),
            StatementKind::Call { function, args, .. } => {
                let deeds = self.known.deeds.function(*function);
                // What changes nothing has been called for nothing.
                if !deeds.is_some_and(|deeds| deeds.changes || deeds.refuses) {
                    return Ok(());
                }
                let call = self.function(*function, args, out)?;
                Action::Must { call, place: None }
            }
            StatementKind::Update { .. } => return Err(NotEmitted::new("an `update`", span)),
            StatementKind::Drain { .. } => return Err(NotEmitted::new("a `drain`", span)),
            StatementKind::Print(_) => return Err(NotEmitted::new("a `print`", span)),
            StatementKind::Assert { .. } => return Err(NotEmitted::new("an `assert`", span)),
            StatementKind::Refused { .. }
            | StatementKind::KeepMesh { .. }
            | StatementKind::AssertMesh { .. }
            | StatementKind::AssertRefuses { .. } => {
                return Err(NotEmitted::new("a statement of a test", span));
            }
        };
        out.push(routine::Statement::Action(action));
        Ok(())
    }

    fn term(&mut self, value: &Expr) -> Result<Term, NotEmitted> {
        Expressions { names: self.names }.term(value)
    }

    /// Names a variable.
    fn bind(&mut self, variable: u32) -> Parameter {
        let known = self.body.variables.get(variable as usize);
        let wanted = known.map_or("x", |variable| variable.name.as_str());
        self.bound.insert(variable);
        let name = self.names.bind(variable, wanted);
        Parameter::new(name, known.map_or(Type::Int, |variable| variable.ty))
    }

    /// Where the value of a variable goes; none for one that nobody reads.
    fn place(&mut self, variable: u32) -> Option<Place> {
        if !self.read.contains(&variable) {
            return None;
        }
        if self.bound.contains(&variable) {
            let known = self.body.variables.get(variable as usize)?;
            let (name, ty) = (self.names.local(variable).to_string(), known.ty);
            let form = Form::Known;
            return Some(Place { name, ty, form });
        }
        let Parameter { name, ty, .. } = self.bind(variable);
        let form = match self.changing.contains(&variable) {
            true => Form::Changing,
            false => Form::Fixed,
        };
        Some(Place { name, ty, form })
    }

    fn set(
        &mut self,
        variable: u32,
        value: &Expr,
        out: &mut Vec<routine::Statement>,
    ) -> Result<(), NotEmitted> {
        if let Some((function, args)) = self.deed(value) {
            let call = self.function(function, args, out)?;
            let place = self.place(variable);
            out.push(routine::Statement::Action(Action::Must { call, place }));
            return Ok(());
        }
        // The value knows nothing of a variable that is new.
        let value = self.term(value)?;
        match self.place(variable) {
            None => {}
            Some(Place {
                name,
                form: Form::Known,
                ..
            }) => out.push(routine::Statement::Change { name, value }),
            Some(place) => {
                out.push(routine::Statement::Action(Action::Variable {
                    place,
                    value,
                }));
            }
        }
        Ok(())
    }

    /// A value that is the call of a function that changes the mesh.
    fn deed<'e>(&self, value: &'e Expr) -> Option<(u32, &'e [Expr])> {
        match &value.kind {
            ExprKind::Invoke(function, args) => {
                let deeds = self.known.deeds.function(*function)?;
                (deeds.changes || deeds.refuses).then_some((*function, args))
            }
            _ => None,
        }
    }

    fn put(
        &mut self,
        target: &Expr,
        attribute: Access,
        value: &Expr,
        out: &mut Vec<routine::Statement>,
    ) -> Result<(), NotEmitted> {
        let is_finite = is_surely_finite(value);
        let (ty, span) = (value.ty, value.span);
        let (target_ty, element) = (target.ty, self.term(target)?);
        let value = self.term(value)?;
        match attribute {
            Access::Position => out.push(routine::Statement::Action(Action::Move {
                vertex: element,
                value,
                is_finite,
            })),
            Access::Declared(number) => {
                let attribute = self.names.attribute(number);
                let attribute = attribute.ok_or_else(|| NotEmitted::new("an attribute", span))?;
                let outer = self.names.mark();
                let element = self.settled(element, target_ty, target_ty.word(), out);
                let name = attribute.name.clone();
                let value = self.settled(value, ty, &name, out);
                self.names.back_to(outer);
                if !self.known.conventions.undoes {
                    out.push(routine::Statement::Action(Action::KeepAttribute {
                        attribute: attribute.clone(),
                        element: element.clone(),
                    }));
                }
                out.push(routine::Statement::SetAttribute {
                    attribute,
                    element,
                    value,
                });
            }
        }
        Ok(())
    }

    /// A value that can stand beside the mesh in a call: where that is borrowed, what looks at
    /// it gets a name before.
    fn settled(
        &mut self,
        value: Term,
        ty: Type,
        wanted: &str,
        out: &mut Vec<routine::Statement>,
    ) -> Term {
        if !self.known.conventions.undoes || is_plain(&value) {
            return value;
        }
        let name = self.names.fresh(wanted);
        let bound = Term::name(&name);
        out.push(routine::Statement::Bind { ty, name, value });
        bound
    }

    fn arguments<'n>(
        &mut self,
        args: &[Expr],
        wanted: impl Iterator<Item = &'n str>,
        out: &mut Vec<routine::Statement>,
    ) -> Result<Vec<Term>, NotEmitted> {
        let outer = self.names.mark();
        let mut terms = Vec::new();
        for (arg, wanted) in args.iter().zip(wanted) {
            let term = self.term(arg)?;
            terms.push(self.settled(term, arg.ty, wanted, out));
        }
        self.names.back_to(outer);
        Ok(terms)
    }

    fn operation(
        &mut self,
        op: usize,
        args: &[Expr],
        out: &mut Vec<routine::Statement>,
    ) -> Result<Call, NotEmitted> {
        self.ops.insert(op);
        let called = &self.known.program.ops[op];
        let wanted = called.params.iter().map(|param| param.name.as_str());
        Ok(Call {
            name: self.known.op_names[op].clone(),
            args: self.arguments(args, wanted, out)?,
            of: match called.result {
                Some(_) => Called::Operation,
                None => Called::Plain,
            },
        })
    }

    fn function(
        &mut self,
        function: u32,
        args: &[Expr],
        out: &mut Vec<routine::Statement>,
    ) -> Result<Call, NotEmitted> {
        self.functions.insert(function);
        let called = &self.known.program.functions[function as usize];
        let wanted = called.params.iter().map(|param| param.name.as_str());
        let deeds = self.known.deeds.function(function);
        Ok(Call {
            name: called.name.clone(),
            args: self.arguments(args, wanted, out)?,
            of: match deeds.is_some_and(|deeds| deeds.refuses) {
                true => Called::Refusing,
                false => Called::Sure,
            },
        })
    }

    fn visit(
        &mut self,
        (variable, collection): (u32, &'s Collection),
        filter: Option<&'s Expr>,
        body: &'s Block,
        span: Span,
    ) -> Result<Action, NotEmitted> {
        let (around, element) = around(collection)
            .ok_or_else(|| NotEmitted::new("a sequence of the whole mesh", span))?;
        let element = self.term(element)?;
        let outer = self.names.mark();
        let may_go = self.known.deeds.erases(body, collection.element());
        let action = Action::For {
            variable: self.bind(variable),
            around,
            element,
            may_go,
            filter: filter.map(|filter| self.term(filter)).transpose()?,
            body: self.block(body)?,
        };
        self.names.back_to(outer);
        Ok(action)
    }

    fn leave(
        &mut self,
        value: Option<&Expr>,
        out: &mut Vec<routine::Statement>,
    ) -> Result<(), NotEmitted> {
        let value = match value {
            None => None,
            Some(value) => Some(match self.deed(value) {
                None => self.term(value)?,
                Some((function, args)) => {
                    let call = self.function(function, args, out)?;
                    let name = self.names.fresh("result");
                    let given = Term::name(&name);
                    let place = Some(Place {
                        name,
                        ty: value.ty,
                        form: Form::Fixed,
                    });
                    out.push(routine::Statement::Action(Action::Must { call, place }));
                    given
                }
            }),
        };
        out.push(match (self.ending, value) {
            (Ending::Steps, result) => routine::Statement::Return { result },
            (_, Some(value)) => routine::Statement::Give(value),
            (_, None) => routine::Statement::Action(Action::Leave),
        });
        Ok(())
    }
}

/// Whether a value does not look at the mesh.
fn is_plain(term: &Term) -> bool {
    match term {
        Term::Name(_) | Term::Bool(_) | Term::Int(_) | Term::Real(_) => true,
        Term::Component(_, of) | Term::Unary(_, of) => is_plain(of),
        Term::Binary(_, left, right) => is_plain(left) && is_plain(right),
        Term::Vector(parts) => parts.iter().all(is_plain),
        _ => false,
    }
}
