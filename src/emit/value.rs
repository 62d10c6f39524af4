//! The functions of a program as values, for code that is emitted.

use crate::diagram::{Callee, Expr, ExprKind};

use crate::resolve::{Function, Program, Statement, StatementKind};

/// The greatest number of statements that the value of a function may repeat.
const MOST: usize = 64;

/// For each function of a program its value; none for one that loops, changes or prints.
pub(super) fn callees(program: &Program) -> Vec<Option<Callee>> {
    program.functions.iter().map(callee).collect()
}

fn callee(function: &Function) -> Option<Callee> {
    let body = function.body.as_ref()?;
    let variables = body.variables.iter();
    Some(Callee {
        name: function.name.clone(),
        docs: function.docs.clone(),
        params: function.params.iter().map(|param| param.ty).collect(),
        variables: variables.map(|variable| variable.name.clone()).collect(),
        result: function.result?,
        value: value(&mut body.block.iter(), &mut { MOST })?,
    })
}

/// The value that some statements return: what comes behind an `if` belongs to both its ways.
fn value(rest: &mut dyn Iterator<Item = &Statement>, open: &mut usize) -> Option<Expr> {
    let statement = rest.next()?;
    *open = open.checked_sub(1)?;
    match &statement.kind {
        StatementKind::Return(value) => value.clone(),
        StatementKind::Set { variable, value: set } => {
            let rest = value(rest, open)?;
            Some(Expr {
                ty: rest.ty,
                span: statement.span,
                kind: ExprKind::Let(*variable, Box::new(set.clone()), Box::new(rest)),
            })
        }
        StatementKind::If { condition, then, otherwise } => {
            let rest: Vec<_> = rest.collect();
            let mut way = |block: &[Statement]| {
                let mut all = block.iter().chain(rest.iter().copied());
                value(&mut all, open)
            };
            let (then, otherwise) = (way(then)?, way(otherwise)?);
            Some(Expr {
                ty: then.ty,
                span: statement.span,
                kind: ExprKind::If(
                    Box::new(condition.clone()),
                    Box::new(then),
                    Box::new(otherwise),
                ),
            })
        }
        _ => None,
    }
}
