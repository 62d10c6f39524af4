//! The functions of a program, in register code.
//!
//! All know the same texts, and each names the others by their numbers in the program. One that
//! could not be resolved, or is too large, has no code: to call it traps.

use std::sync::Arc;

use super::live::Exits;
use super::lower::{Lowering, Routine};
use crate::compile::width;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind};
use crate::resolve::{Program, Script};
use crate::rewrite::{self, Code};
use crate::source::Span;

/// What functions are in code, and which operations each of them may call.
#[derive(Clone, Debug, Default)]
pub struct Functions {
    /// Their code, by number.
    pub code: Arc<[rewrite::Function]>,
    /// By number the operations that each calls itself, with the first call.
    pub(super) applies: Vec<Vec<(usize, Span)>>,
    /// By number the functions that each calls itself.
    pub(super) calls: Vec<Vec<usize>>,
    /// By number the numbers of the places where each asserts something, in order.
    pub(super) assertions: Vec<Vec<u32>>,
    /// By number whether the code is missing.
    missing: Vec<bool>,
}

impl Functions {
    /// Lowers all functions of a program.
    ///
    /// # Errors
    /// One diagnostic for each function that is too large; it has no code.
    pub fn of(program: &Program) -> (Self, Vec<Diagnostic>) {
        let mut functions = Self::default();
        let mut code: Vec<rewrite::Function> = Vec::new();
        let mut diagnostics = Vec::new();
        let mut texts = Vec::new();
        for function in &program.functions {
            let params = function.params.iter().map(|param| width(param.ty));
            let mut lowered = rewrite::Function {
                name: function.name.clone(),
                params: params.fold(0, u16::saturating_add),
                ..rewrite::Function::default()
            };
            let (mut applies, mut calls) = (Vec::new(), Vec::new());
            let (mut assertions, mut missing) = (Vec::new(), true);
            if let Some(body) = &function.body {
                let routine = Routine {
                    params: &function.params,
                    variables: &body.variables,
                    block: &body.block,
                };
                let mut lowering = Lowering::of_function(routine, &texts);
                lowering.block(&body.block, Some(&Exits::default()));
                lowering.end();
                (applies, calls) = (lowering.called, lowering.functions);
                assertions = lowering.assertions;
                lowered.places = lowering.names.places;
                match lowering.asm.finish() {
                    Ok(finished) => {
                        texts.clone_from(&finished.texts);
                        lowered.code = finished;
                        missing = false;
                    }
                    Err(too_large) => {
                        let message = format!("`{}` is {too_large}", function.name);
                        let code = "script-too-large";
                        diagnostics.push(Diagnostic::error(code, message, function.span));
                    }
                }
            }
            lowered.code.texts.clone_from(&texts);
            code.push(lowered);
            functions.applies.push(applies);
            functions.calls.push(calls);
            functions.assertions.push(assertions);
            functions.missing.push(missing);
        }
        functions.code = code.into();
        (functions, diagnostics)
    }

    /// The texts that all of them know.
    pub(super) fn texts(&self) -> &[String] {
        let last = self.code.last();
        last.map_or(&[], |last| last.code.texts.as_slice())
    }

    /// The functions that some call, directly or through others; in order.
    pub(super) fn reached(&self, from: &[usize]) -> Vec<usize> {
        let mut seen = vec![false; self.calls.len()];
        let mut open = from.to_vec();
        while let Some(at) = open.pop() {
            if let Some(seen) = seen.get_mut(at)
                && !*seen
            {
                *seen = true;
                open.extend(&self.calls[at]);
            }
        }
        (0..seen.len()).filter(|&at| seen[at]).collect()
    }

    /// The name of the first function without code that an expression needs, directly or through
    /// others.
    pub fn lacking<'e>(&self, exprs: impl IntoIterator<Item = &'e Expr>) -> Option<&str> {
        let mut called = Vec::new();
        for expr in exprs {
            expr.each(&mut |part| {
                if let ExprKind::Invoke(function, _) = part.kind {
                    called.push(function as usize);
                }
            });
        }
        let missing = self.first_missing(&self.reached(&called))?;
        self.code.get(missing).map(|function| function.name.as_str())
    }

    /// Of those the first that has no code.
    pub(super) fn first_missing(&self, reached: &[usize]) -> Option<usize> {
        reached.iter().copied().find(|&at| self.missing[at])
    }
}

/// The code of a script with the functions that it calls.
pub(super) fn with_functions(code: Code, functions: &Functions) -> Code {
    Code { functions: Arc::clone(&functions.code), ..code }
}

/// A script as a routine.
pub(super) fn routine(script: &Script) -> Routine<'_> {
    Routine { params: &script.params, variables: &script.variables, block: &script.body }
}
