//! Functions of the program that operations ask, as functions of their own.

use std::collections::BTreeSet;

use super::NotEmitted;
use super::expression::{Expressions, is_spelled};
use super::names::Names;
use super::routine::{Helper, Statement};
use super::term::Parameter;
use crate::diagram::{Callee, Expr, ExprKind};

/// A function that computes a value, and the functions that it calls.
pub(super) fn helper(
    (callee, name): (&Callee, &str),
    functions: &[Option<String>],
    kept: &[String],
) -> Result<(Helper, BTreeSet<u32>), NotEmitted> {
    let mut names = Names::of_function(callee, functions, kept);
    let body = Expressions { names: &mut names }.block(callee)?;
    let params = callee.params.iter().zip(names.params());
    let helper = Helper {
        name: name.to_string(),
        docs: callee.docs.clone(),
        params: params.map(|(&ty, name)| Parameter::new(name.clone(), ty)).collect(),
        result: Some(callee.result),
        changes: false,
        refuses: false,
        body,
    };
    Ok((helper, names.take_calls()))
}

impl Expressions<'_> {
    /// The statements of a function.
    fn block(&mut self, callee: &Callee) -> Result<Vec<Statement>, NotEmitted> {
        let mut types = callee.params.iter().chain([&callee.result]);
        if let Some(ty) = types.find(|ty| !is_spelled(**ty)) {
            let what = format!("a function that takes or gives a `{}`", ty.word());
            return Err(NotEmitted::new(what, callee.value.span));
        }
        let mut body = Vec::new();
        self.tail(&callee.value, callee, &mut body)?;
        Ok(body)
    }

    fn tail(
        &mut self,
        value: &Expr,
        callee: &Callee,
        body: &mut Vec<Statement>,
    ) -> Result<(), NotEmitted> {
        match &value.kind {
            ExprKind::Let(number, bound, rest) => {
                let bound = self.once(bound, false, None, body)?;
                let (ty, value) = (bound.ty, self.term(&bound)?);
                let wanted = callee.variables.get(*number as usize);
                let name = self.names.bind(*number, wanted.map_or("x", String::as_str));
                body.push(Statement::Bind { ty, name, value });
                self.tail(rest, callee, body)
            }
            ExprKind::If(condition, then, otherwise) if has_let(then) || has_let(otherwise) => {
                let condition = self.term(condition)?;
                let mut inner = Vec::new();
                self.tail(then, callee, &mut inner)?;
                body.push(Statement::When { condition, body: inner });
                self.tail(otherwise, callee, body)
            }
            _ => {
                let value = self.once(value, false, None, body)?;
                let value = self.term(&value)?;
                body.push(Statement::Give(value));
                Ok(())
            }
        }
    }
}

/// True if the value of a block binds names.
fn has_let(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Let(..) => true,
        ExprKind::If(_, then, otherwise) => has_let(then) || has_let(otherwise),
        _ => false,
    }
}
