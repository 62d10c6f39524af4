//! All functions of a program, and the order in which they are resolved.
//!
//! The result type of a function may be omitted; then its body is resolved before the functions
//! that call it. Functions that call each other in a cycle without a written result type return
//! nothing.

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use crate::diagnostic::Diagnostic;
use crate::syntax::tree::{self, Item};

use super::declared::Declared;
use super::effects::{TreeEffects, all_effects};
use super::program::Function;
use super::report::Report;
use super::routine::{resolve_function, script_signature, written_signature};
use super::signature::{FunctionSignature, Signature, Value};
use super::unit::Unit;

/// The functions of a program, by number.
pub(super) struct Functions<'t> {
    /// The declarations of each file, updated as functions are resolved.
    pub(super) declared: Vec<Declared>,
    items: Vec<Pending<'t>>,
    diagnostics: Vec<Diagnostic>,
}

/// A function that is being resolved.
struct Pending<'t> {
    tree: &'t tree::Fn,
    /// True if it could not be read as it is written.
    misread: bool,
    /// The index of its file.
    home: usize,
    found: TreeEffects,
    signature: Rc<FunctionSignature>,
    report: Option<Report>,
    resolved: Option<Function>,
}

impl<'t> Functions<'t> {
    /// Reads the signatures, as far as they are written.
    pub(super) fn of(units: &[Unit<'t>], mut declared: Vec<Declared>) -> Self {
        let mut found = all_effects(units, &declared).into_iter();
        let mut items = Vec::new();
        for (home, unit) in units.iter().enumerate() {
            for item in &unit.tree.items {
                let Item::Fn(tree) = item else { continue };
                let found = found.next().unwrap_or_default();
                let mut report = Report::default();
                let signature =
                    written_signature(tree, found.effects, &declared[home], &mut report);
                items.push(Pending {
                    tree,
                    misread: unit.tree.is_misread(tree.span),
                    home,
                    found,
                    signature: Rc::new(signature),
                    report: Some(report),
                    resolved: None,
                });
            }
        }
        for item in &items {
            declared.iter_mut().for_each(|file| file.learn(&item.signature));
        }
        for item in units.iter().flat_map(|unit| &unit.tree.items) {
            if let Item::Script(script) = item {
                let signature = Rc::new(script_signature(script));
                declared.iter_mut().for_each(|file| file.learn(&signature));
            }
        }
        Self { declared, items, diagnostics: Vec::new() }
    }

    /// Resolves the bodies of the wanted functions, each after those whose result type it needs.
    pub(super) fn resolve(&mut self, ops: &[Signature], wanted: impl Fn(&TreeEffects) -> bool) {
        let mut left: Vec<usize> =
            (0..self.items.len()).filter(|&at| wanted(&self.items[at].found)).collect();
        while !left.is_empty() {
            let mut ready = left.clone();
            ready.retain(|&at| !self.waits(at));
            // None is ready: some call each other in a cycle.
            let cycles = ready.is_empty();
            if cycles {
                ready = self.cycle(&left);
                for &at in &ready {
                    self.give(at, Value::Nothing);
                }
            }
            let before = self.diagnostics.len();
            for &at in &ready {
                self.resolve_one(at, ops, cycles);
            }
            let mut told = self.diagnostics.split_off(before);
            if told.iter().any(|told| told.code == "needs-result-type") {
                // A function with such an error gives a value of some type.
                told.retain(|told| told.code != "returns-nothing");
                ready.iter().for_each(|&at| self.set(at, Value::Nothing, Value::Unknown));
            }
            self.diagnostics.extend(told);
            left.retain(|at| !ready.contains(at));
        }
    }

    /// The functions, among those that are left, that call each other in one cycle.
    fn cycle(&self, left: &[usize]) -> Vec<usize> {
        let calls = |at| self.open_calls(at).collect();
        let mut all = left.iter().map(|&at| (at, reached(at, calls)));
        let Some((first, called)) = all.find(|(at, called)| called.contains(at)) else {
            return left.to_vec();
        };
        let mut callers: HashMap<usize, Vec<usize>> = HashMap::new();
        for &at in &called {
            self.open_calls(at).for_each(|called| callers.entry(called).or_default().push(at));
        }
        let calling = reached(first, |at| callers.get(&at).cloned().unwrap_or_default());
        let is_in_it = |at: &usize| called.contains(at) && calling.contains(at);
        left.iter().copied().filter(is_in_it).collect()
    }

    /// The functions that a function calls and whose result type is not known yet.
    fn open_calls(&self, at: usize) -> impl Iterator<Item = usize> {
        let calls = self.items[at].found.calls.iter().copied();
        calls.filter(|&called| self.items[called].signature.result == Value::Open)
    }

    /// True if a function calls one whose result type is not known yet.
    fn waits(&self, at: usize) -> bool {
        self.open_calls(at).next().is_some()
    }

    fn resolve_one(&mut self, at: usize, ops: &[Signature], cycles: bool) {
        let item = &mut self.items[at];
        let mut report = item.report.take().unwrap_or_default();
        let open = item.tree.result.is_none();
        let (value, mut resolved) = resolve_function(
            item.tree,
            &item.signature,
            ops,
            cycles && open,
            &self.declared[item.home],
            &mut report,
        );
        resolved.body = resolved.body.filter(|_| !item.misread);
        item.resolved = Some(resolved);
        self.diagnostics.extend(report.into_diagnostics());
        self.give(at, value);
    }

    /// Sets the result of a function if it is still open.
    fn give(&mut self, at: usize, value: Value) {
        self.set(at, Value::Open, value);
    }

    /// Sets the result of a function if it is the one before.
    fn set(&mut self, at: usize, before: Value, value: Value) {
        let item = &mut self.items[at];
        if item.signature.result != before {
            return;
        }
        item.signature = Rc::new(FunctionSignature {
            result: value,
            ..FunctionSignature::clone(&item.signature)
        });
        let signature = Rc::clone(&item.signature);
        self.declared.iter_mut().for_each(|file| file.learn(&signature));
    }

    pub(super) fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.diagnostics)
    }

    /// All functions, once each of them has been resolved.
    pub(super) fn into_resolved(self) -> Vec<Function> {
        self.items.into_iter().filter_map(|item| item.resolved).collect()
    }
}

/// What can be reached from a place in one step or more.
fn reached(start: usize, steps: impl Fn(usize) -> Vec<usize>) -> BTreeSet<usize> {
    let (mut all, mut open) = (BTreeSet::new(), vec![start]);
    while let Some(next) = open.pop() {
        open.extend(steps(next).into_iter().filter(|&step| all.insert(step)));
    }
    all
}
