//! Calls in steps: of operations, and of functions that change the mesh.

use super::super::NotEmitted;
use super::super::routine::{Call, Called, Statement};
use super::super::term::{Function, Term};
use super::body::Writer;
use crate::diagram::{Expr, ExprKind, Param, Type};
use crate::resolve::{Block, Statement as Step, StatementKind};

impl<'s> Writer<'s> {
    /// The call of a function that changes the mesh or may refuse, if the value is one.
    pub(super) fn changing_call<'e>(&self, value: &'e Expr) -> Option<(u32, &'e [Expr])> {
        match &value.kind {
            ExprKind::Invoke(function, args) => {
                let effects = self.context.effects.function(*function)?;
                (effects.changes || effects.refuses).then_some((*function, args))
            }
            _ => None,
        }
    }

    /// A value that can be passed beside the mesh in a call: where the mesh is borrowed, a value
    /// that reads it is bound to a name before.
    pub(super) fn settled(
        &mut self,
        value: Term,
        ty: Type,
        wanted: &str,
        out: &mut Vec<Statement>,
    ) -> Term {
        if !self.context.conventions.undoes || is_plain(&value) {
            return value;
        }
        let name = self.names.fresh(wanted);
        let bound = Term::name(&name);
        out.push(Statement::Bind { ty, name, value, is_list: false });
        bound
    }

    fn arguments(
        &mut self,
        args: &[Expr],
        params: &[Param],
        out: &mut Vec<Statement>,
    ) -> Result<Vec<Term>, NotEmitted> {
        self.scope(|this| {
            let settled = |(arg, param): (&Expr, &Param)| {
                let term = this.term(arg)?;
                Ok(this.settled(term, arg.ty, &param.name, out))
            };
            args.iter().zip(params).map(settled).collect()
        })
    }

    pub(super) fn operation(
        &mut self,
        op: usize,
        args: &[Expr],
        out: &mut Vec<Statement>,
    ) -> Result<Call, NotEmitted> {
        self.ops.insert(op);
        let called = &self.context.program.ops[op];
        let name = self.context.op_names[op].clone();
        let of = if called.result.is_some() { Called::Operation } else { Called::Plain };
        Ok(Call { name, args: self.arguments(args, &called.params, out)?, of })
    }

    /// Calls an operation, and goes on as the program does if it applied, or if it refused.
    pub(super) fn apply(
        &mut self,
        call: Call,
        variable: Option<u32>,
        [then, otherwise]: [&'s Block; 2],
        out: &mut Vec<Statement>,
    ) -> Result<(), NotEmitted> {
        match (then.as_slice(), otherwise.as_slice()) {
            (_, [Step { kind: StatementKind::Refused { .. }, .. }]) => {
                let place = variable.and_then(|variable| self.place(variable));
                out.push(Statement::MustCall { call, place });
                then.iter().try_for_each(|statement| self.statement(statement, out))?;
            }
            _ => {
                let read = variable.filter(|&variable| self.variables.reads(variable));
                let (place, then) = self.scope(|this| {
                    let place = read.map(|variable| this.bind(variable));
                    Ok((place, this.block(then)?))
                })?;
                let otherwise = self.block(otherwise)?;
                out.push(Statement::Apply { call, place, then, otherwise });
            }
        }
        Ok(())
    }

    pub(super) fn function(
        &mut self,
        function: u32,
        args: &[Expr],
        out: &mut Vec<Statement>,
    ) -> Result<Call, NotEmitted> {
        self.functions.insert(function);
        let called = &self.context.program.functions[function as usize];
        let name = self.context.function_names[function as usize].clone();
        let refuses = self.context.effects.function(function).is_some_and(|of| of.refuses);
        let of = if refuses { Called::Refusing } else { Called::Sure };
        Ok(Call { name, args: self.arguments(args, &called.params, out)?, of })
    }
}

/// True if a value does not read the mesh.
fn is_plain(term: &Term) -> bool {
    match term {
        Term::Name(_) | Term::Bool(_) | Term::Int(_) | Term::Real(_) => true,
        Term::Unary(_, of) => is_plain(of),
        Term::Binary(_, left, right) => is_plain(left) && is_plain(right),
        Term::Call(Function::Of(..), args) => args.iter().all(is_plain),
        _ => false,
    }
}
