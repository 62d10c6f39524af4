//! Functions of the program that operations ask, as functions of their own.

use std::collections::BTreeSet;

use super::NotEmitted;
use super::expression::{Expressions, is_spelled};
use super::names::Names;
use super::routine::{Helper, Statement};
use super::term::Parameter;
use crate::diagram::{Callee, Expr, ExprKind};

/// The functions that some call, and those that these call, each behind those it calls.
pub(super) fn helpers(
    calls: &BTreeSet<u32>,
    functions: &[Option<Callee>],
) -> Result<Vec<Helper>, NotEmitted> {
    let mut all = All {
        functions,
        begun: BTreeSet::new(),
        done: Vec::new(),
    };
    for &number in calls {
        all.add(number)?;
    }
    Ok(all.done)
}

struct All<'f> {
    functions: &'f [Option<Callee>],
    begun: BTreeSet<u32>,
    done: Vec<Helper>,
}

impl All<'_> {
    fn add(&mut self, number: u32) -> Result<(), NotEmitted> {
        let known = self.functions.get(number as usize);
        // One that calls itself needs no declaration before; those in a circle would.
        let Some(callee) = known.and_then(Option::as_ref) else {
            return Ok(());
        };
        if !self.begun.insert(number) {
            return Ok(());
        }
        let mut names = Names::of_function(callee, self.functions);
        let body = Expressions { names: &mut names }.block(callee)?;
        for called in names.take_calls() {
            if called != number && self.begun.contains(&called) && !self.is_done(called) {
                let what = "functions that call each other in a circle";
                return Err(NotEmitted::new(what, callee.value.span));
            }
            self.add(called)?;
        }
        let params = callee.params.iter().zip(names.params());
        self.done.push(Helper {
            name: callee.name.clone(),
            docs: callee.docs.clone(),
            params: params
                .map(|(&ty, name)| Parameter {
                    name: name.clone(),
                    ty,
                })
                .collect(),
            result: callee.result,
            body,
        });
        Ok(())
    }

    fn is_done(&self, number: u32) -> bool {
        let known = self.functions.get(number as usize);
        let name = known.and_then(Option::as_ref).map(|callee| &callee.name);
        self.done.iter().any(|helper| Some(&helper.name) == name)
    }
}

impl Expressions<'_> {
    /// What a function does.
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
                let (ty, value) = (bound.ty, self.term(bound)?);
                let wanted = callee.variables.get(*number as usize);
                let name = self.names.bind(*number, wanted.map_or("x", String::as_str));
                body.push(Statement::Bind { ty, name, value });
                self.tail(rest, callee, body)
            }
            ExprKind::If(condition, then, otherwise) if has_let(then) || has_let(otherwise) => {
                let condition = self.term(condition)?;
                let mut inner = Vec::new();
                self.tail(then, callee, &mut inner)?;
                body.push(Statement::When {
                    condition,
                    body: inner,
                });
                self.tail(otherwise, callee, body)
            }
            _ => {
                let value = self.term(value)?;
                body.push(Statement::Give(value));
                Ok(())
            }
        }
    }
}

/// Whether the value of a block binds names.
fn has_let(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Let(..) => true,
        ExprKind::If(_, then, otherwise) => has_let(then) || has_let(otherwise),
        _ => false,
    }
}
