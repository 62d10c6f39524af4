//! Calls in steps: of operations, and of functions that change the mesh.

use super::super::NotEmitted;
use super::super::routine;
use super::super::term::Term;
use super::super::whole::{Call, Called};
use super::body::Writer;
use crate::diagram::{Expr, ExprKind, Type};

impl Writer<'_> {
    /// A value that is the call of a function that changes the mesh.
    pub(super) fn changing_call<'e>(&self, value: &'e Expr) -> Option<(u32, &'e [Expr])> {
        match &value.kind {
            ExprKind::Invoke(function, args) => {
                let effects = self.known.effects.function(*function)?;
                (effects.changes || effects.refuses).then_some((*function, args))
            }
            _ => None,
        }
    }

    /// A value that can stand beside the mesh in a call: where that is borrowed, what looks at
    /// it gets a name before.
    pub(super) fn settled(
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

    pub(super) fn operation(
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

    pub(super) fn function(
        &mut self,
        function: u32,
        args: &[Expr],
        out: &mut Vec<routine::Statement>,
    ) -> Result<Call, NotEmitted> {
        self.functions.insert(function);
        let called = &self.known.program.functions[function as usize];
        let wanted = called.params.iter().map(|param| param.name.as_str());
        let effects = self.known.effects.function(function);
        Ok(Call {
            name: self.known.function_names[function as usize].clone(),
            args: self.arguments(args, wanted, out)?,
            of: match effects.is_some_and(|effects| effects.refuses) {
                true => Called::Refusing,
                false => Called::Sure,
            },
        })
    }
}

/// True if a value does not look at the mesh.
fn is_plain(term: &Term) -> bool {
    match term {
        Term::Name(_) | Term::Bool(_) | Term::Int(_) | Term::Real(_) => true,
        Term::Component(_, of) | Term::Unary(_, of) => is_plain(of),
        Term::Binary(_, left, right) => is_plain(left) && is_plain(right),
        Term::Vector(parts) => parts.iter().all(is_plain),
        _ => false,
    }
}
