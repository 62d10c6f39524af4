//! Lowering of the functions of a program to register code.
//!
//! All functions share one list of texts, and each calls the others by their numbers in the
//! program. A function that could not be resolved, or is too large, has no code: a call of it
//! traps.

use std::sync::Arc;

use super::lower::{Lowering, Routine};
use crate::compile::width;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, Type};
use crate::lower::Effects;
use crate::resolve::{self, Body, Program, Script, Statement, StatementKind, Variable};
use crate::rewrite::{self, Code};
use crate::source::Span;

/// The code of the functions of a program, and the operations that each of them may call.
#[derive(Clone, Debug, Default)]
pub struct Functions {
    /// The code, by number.
    pub code: Arc<[rewrite::Function]>,
    /// By number, the operations that each calls itself, with the place of the first call.
    pub(super) applies: Vec<Vec<(usize, Span)>>,
    /// By number, the functions that each calls itself.
    pub(super) calls: Vec<Vec<usize>>,
    /// By number, whether the code is missing.
    missing: Vec<bool>,
    calls_ops: Arc<[bool]>,
}

/// The facts about the functions of a program that are used where code that calls them is lowered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known<'k> {
    /// The texts that the code shares.
    pub(super) texts: &'k [String],
    /// By number, whether each function may call an operation.
    pub(super) calls_ops: &'k Arc<[bool]>,
}

impl Functions {
    /// Lowers all functions of a program, then the scripts that are called like functions.
    ///
    /// # Errors
    /// One diagnostic for each function that is too large; it has no code.
    pub fn of(program: &Program) -> (Self, Vec<Diagnostic>) {
        let mut all = Self { calls_ops: calls_ops(program), ..Self::default() };
        let mut code: Vec<rewrite::Function> = Vec::new();
        let mut diagnostics = Vec::new();
        let mut texts = Vec::new();
        let functions = program.functions.iter().map(lowered_function);
        let scripts = program.called_scripts.iter().map(|(_, _, at)| {
            at.and_then(|at| program.scripts.get(at)).map_or_else(Beginning::default, called_script)
        });
        for Beginning { name, span, params, lower } in functions.chain(scripts) {
            let mut lowered = rewrite::Function { name, params, ..rewrite::Function::default() };
            let (mut applies, mut calls) = (Vec::new(), Vec::new());
            let mut missing = true;
            if let Some(lower) = lower {
                let lowering = lower(Known { texts: &texts, calls_ops: &all.calls_ops });
                (applies, calls) = (lowering.called, lowering.functions);
                lowered.places = lowering.names.places;
                match lowering.asm.finish() {
                    Ok(finished) => {
                        texts.clone_from(&finished.texts);
                        lowered.code = finished;
                        missing = false;
                    }
                    Err(too_large) => {
                        let message = format!("`{}` is {too_large}", lowered.name);
                        diagnostics.push(Diagnostic::error("script-too-large", message, span));
                    }
                }
            }
            lowered.code.texts.clone_from(&texts);
            code.push(lowered);
            all.applies.push(applies);
            all.calls.push(calls);
            all.missing.push(missing);
        }
        all.code = code.into();
        (all, diagnostics)
    }

    /// The facts about the functions, for code that calls them.
    pub(super) fn known(&self) -> Known<'_> {
        // All functions share the texts.
        let texts = self.code.last().map_or(&[][..], |last| last.code.texts.as_slice());
        Known { texts, calls_ops: &self.calls_ops }
    }

    /// The given functions and those that they call, directly or indirectly; in order.
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

    /// The name of the first function without code that the expressions call, directly or
    /// indirectly.
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

    /// The first of the given functions that has no code.
    pub(super) fn first_missing(&self, reached: &[usize]) -> Option<usize> {
        reached.iter().copied().find(|&at| self.missing[at])
    }
}

/// By number, whether each function, or script that is called like one, may call an operation,
/// itself or through others.
fn calls_ops(program: &Program) -> Arc<[bool]> {
    let functions = program.functions.iter();
    let bodies = functions.map(|function| function.body.as_ref());
    let scripts = program.called_scripts.iter();
    let scripts = scripts.map(|(_, _, at)| Some(&program.scripts.get((*at)?)?.body));
    let effects = bodies.chain(scripts).map(|body| Some(Effects::of_block(&body?.block)));
    let effects: Vec<_> = effects.collect();
    let calls = |effects: &Option<Effects>, known: &[bool]| {
        effects.as_ref().is_none_or(|effects| effects.calls_ops(known))
    };
    let mut known = vec![false; effects.len()];
    loop {
        let now: Vec<bool> = effects.iter().map(|effects| calls(effects, &known)).collect();
        if now == known {
            return now.into();
        }
        known = now;
    }
}

/// A script that has the parameters of a function, calls the function with them, and keeps its
/// value in the variable after them.
pub(super) fn calling(function: &resolve::Function, number: usize) -> Script {
    let variable =
        |(name, ty, span): (&str, Type, Span)| Variable { name: name.to_owned(), ty, span };
    let params = function.params.iter().map(|param| (param.name.as_str(), param.ty, param.span));
    let value = function.result.map(|ty| ("value", ty, function.span));
    let args = (0..).zip(&function.params).map(|(at, param)| Expr {
        ty: param.ty,
        kind: ExprKind::Local(at),
        span: param.span,
    });
    let (span, function_number, args) = (function.span, number as u32, args.collect());
    let kind = match function.result {
        Some(ty) => StatementKind::Set {
            variable: function.params.len() as u32,
            value: Expr { ty, kind: ExprKind::Invoke(function_number, args), span },
        },
        None => StatementKind::Call { function: function_number, args, result: None },
    };
    Script {
        name: function.name.clone(),
        span,
        docs: function.docs.clone(),
        params: function.params.clone(),
        body: Body {
            variables: params.chain(value).map(variable).collect(),
            block: vec![Statement { kind, span }],
        },
    }
}

/// Lowers a function.
type Lower<'p> = Box<dyn Fn(Known<'_>) -> Lowering<'p> + 'p>;

/// A function that is to be lowered, or a script that is called like one.
#[derive(Default)]
struct Beginning<'p> {
    name: String,
    span: Span,
    params: u16,
    /// `None` if it could not be resolved.
    lower: Option<Lower<'p>>,
}

fn lowered_function<'p>(function: &'p resolve::Function) -> Beginning<'p> {
    let params = function.params.iter().map(|param| width(param.ty));
    Beginning {
        name: function.name.clone(),
        span: function.span,
        params: params.fold(0, u16::saturating_add),
        lower: function.body.as_ref().map(|body| {
            let routine = Routine { params: &function.params, body };
            let lower: Lower<'p> = Box::new(move |known: Known<'_>| {
                let mut lowering = Lowering::of_function(routine, known);
                lowering.body(routine);
                lowering.end();
                lowering
            });
            lower
        }),
    }
}

fn called_script(script: &Script) -> Beginning<'_> {
    // After the parameters there is, for each of them, whether it is given.
    let params = script.params.iter().map(|param| width(param.ty).saturating_add(1));
    Beginning {
        name: script.name.clone(),
        span: script.span,
        params: params.fold(0, u16::saturating_add),
        lower: Some(Box::new(|known| {
            let mut lowering = Lowering::of_called_script(routine(script), known);
            lowering.body(routine(script));
            lowering.end();
            lowering
        })),
    }
}

/// The code of a script with the functions that it calls.
pub(super) fn with_functions(code: Code, functions: &Functions) -> Code {
    Code { functions: Arc::clone(&functions.code), ..code }
}

/// A script as a routine.
pub(super) fn routine(script: &Script) -> Routine<'_> {
    Routine { params: &script.params, body: &script.body }
}
