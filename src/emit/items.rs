//! The items that are emitted for some operations: these, and before them what they call.

use std::collections::{BTreeMap, BTreeSet};

use super::item::{Item, ItemBody, Need, Parameter, Signature, parameters};
use super::language::Language;
use super::names::{Names, free};
use super::routine::{Statement, without_unread};
use super::steps::{Writer, journaled};
use super::value::is_spelled;
use super::{NotEmitted, Selection, build};
use crate::check::Proved;
use crate::diagram::{Level, Param, Property};
use crate::lower::{AllEffects, Variables};
use crate::resolve::{Body, StatementKind, Steps};
use crate::source::Span;

/// Everything that is emitted.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::emit) struct Items {
    /// The items that are called, each after those that it calls.
    pub called: Vec<Item>,
    /// The operations that were selected.
    pub ops: Vec<Item>,
}

/// The items for the operations of a selection.
pub(in crate::emit) fn items<'s>(
    selection: &'s Selection<'s>,
    language: Language<'s>,
) -> Result<Items, NotEmitted> {
    let effects = AllEffects::of(selection.program, selection.proved);
    let (ops, functions) = called(selection, effects.ops.len(), language.reserved);
    let values = effects.functions.iter().zip(&selection.program.functions);
    let values = values.zip(&functions).map(|((effects, function), name)| {
        let computes = !effects.changes && !effects.refuses && function.result.is_some();
        computes.then(|| name.clone())
    });
    let values = values.collect();
    let lowered = lowered(selection, &effects);
    let source = Source { selection, language, values, lowered, ops, functions, effects };
    let mut builder = Builder { source: &source, is_done: BTreeMap::new(), called: Vec::new() };
    let mut ops = Vec::new();
    let known = |op: usize| selection.drawn(op).is_some() || selection.program.ops.len() > op;
    for op in selection.ops.iter().copied().filter(|&op| known(op)) {
        let item = source.op(op)?;
        for &need in &item.needs {
            builder.need(need, selection.program.ops.get(op).map(|op| op.span))?;
        }
        ops.push(item);
    }
    Ok(Items { called: builder.called, ops })
}

/// The levels that some step of the operations may lower.
fn lowered(selection: &Selection<'_>, effects: &AllEffects) -> Vec<Level> {
    let called = effects.called(selection.ops);
    let kept: Vec<_> =
        called.into_iter().filter_map(|op| selection.drawn(op)).map(Proved::keeps).collect();
    let is_lowered = |level: &Level| {
        *level > Level::Map && kept.iter().any(|kept| !kept.contains(&Property::Level(*level)))
    };
    Level::ALL.into_iter().filter(is_lowered).collect()
}

/// The names of the operations and of the functions; selected operations are named first.
fn called(
    selection: &Selection<'_>,
    count: usize,
    reserved: &[String],
) -> (Vec<String>, Vec<String>) {
    let mut taken = BTreeSet::new();
    // Files that do not see each other may use the same name.
    let mut free = |name: &str| free(name, reserved, &mut taken);
    let mut ops = vec![String::new(); count];
    for op in selection.ops.iter().copied().chain(0..count) {
        if op < count && ops[op].is_empty() {
            ops[op] = free(selection.name(op));
        }
    }
    let functions = selection.program.functions.iter();
    (ops, functions.map(|function| free(&function.name)).collect())
}

/// A selection that is emitted in a language, with the names of everything in code.
pub(in crate::emit) struct Source<'s> {
    pub selection: &'s Selection<'s>,
    pub language: Language<'s>,
    pub effects: AllEffects,
    pub ops: Vec<String>,
    pub functions: Vec<String>,
    /// The names of the functions that compute a value, by number.
    pub values: Vec<Option<String>>,
    /// The levels that some step may lower.
    lowered: Vec<Level>,
}

/// The collection of what is called.
struct Builder<'s> {
    source: &'s Source<'s>,
    /// The items that are begun, and whether they are done.
    is_done: BTreeMap<Need, bool>,
    called: Vec<Item>,
}

impl Builder<'_> {
    /// Adds a called item after those that it calls, unless it is there already.
    fn need(&mut self, need: Need, from: Option<Span>) -> Result<(), NotEmitted> {
        let Source { selection, language, .. } = self.source;
        match (self.is_done.get(&need), from, need) {
            // A mesh that undoes by itself needs no second form of a selected operation.
            (_, _, Need::Op(op)) if language.is_rust() && selection.ops.contains(&op) => {
                return Ok(());
            }
            (Some(false), Some(span), _) => {
                return Err(NotEmitted::new("functions that call each other in a circle", span));
            }
            (Some(_), ..) => return Ok(()),
            (None, ..) => self.is_done.insert(need, false),
        };
        let item = match need {
            Need::Function(number) => self.source.function(number)?,
            Need::Op(op) if language.is_rust() => self.source.op(op)?,
            Need::Op(op) => journaled(self.source.op(op)?, *language),
        };
        // A call of itself needs no forward declaration; a cycle of calls would.
        let span = self.source.span(need);
        for &other in item.needs.iter().filter(|&&other| other != need) {
            self.need(other, Some(span))?;
        }
        self.is_done.insert(need, true);
        self.called.push(item);
        Ok(())
    }
}

impl<'s> Source<'s> {
    /// The level that a step requires of the mesh, if some step may lower that.
    pub fn level_to_expect(&self, op: usize) -> Option<Level> {
        let level = match self.selection.steps(op) {
            Some(steps) => steps.level,
            None => self.selection.drawn(op)?.op().level(),
        };
        self.lowered.contains(&level).then_some(level)
    }

    fn span(&self, need: Need) -> Span {
        match need {
            Need::Function(number) => self.selection.program.functions[number as usize].span,
            Need::Op(op) => self.selection.program.ops[op].span,
        }
    }

    fn op(&'s self, op: usize) -> Result<Item, NotEmitted> {
        if let Some(steps) = self.selection.steps(op) {
            return self.steps(op, steps);
        }
        let Some(proved) = self.selection.drawn(op) else {
            let span = self.span(Need::Op(op));
            let what = format!("`{}`, which is not proved,", self.selection.name(op));
            return Err(NotEmitted::new(what, span));
        };
        build::routine(self, &self.ops[op], proved)
    }

    /// The attributes that called functions look at.
    pub fn seen_by(&self, needs: &BTreeSet<Need>) -> BTreeSet<u32> {
        let effects = needs.iter().filter_map(|need| match need {
            Need::Function(number) => self.effects.function(*number),
            Need::Op(_) => None,
        });
        effects.flat_map(|effects| effects.attributes.iter().copied()).collect()
    }

    /// An operation in steps, or a function, and what it calls: its signature, which has no
    /// parameters yet, and its body. The statements begin with the columns of attributes, and with
    /// the tests before anything is done.
    fn body(
        &'s self,
        mut signature: Signature,
        (body, params): (&'s Body, &[Param]),
        steps: Option<&Steps>,
    ) -> Result<Item, NotEmitted> {
        let mut names = Names::of_body(self, body, params.len(), steps.is_none());
        signature.params = parameters(params, &mut names)?;
        let mut writer = Writer {
            source: self,
            body,
            names,
            out: Vec::new(),
            is_function: steps.is_none(),
            bound: (0..params.len() as u32).collect(),
            variables: Variables::of(&body.block),
            held: Vec::new(),
        };
        let mut first = Vec::new();
        for require in steps.iter().flat_map(|steps| &steps.requires) {
            let when = writer.names.value(&require.condition)?.not();
            first.push(Statement::Refuse { when, reason: require.reason.clone() });
        }
        if let Some(variable) = body.variables.iter().find(|of| !is_spelled(of.ty)) {
            let what = format!("a variable of type `{}`", variable.ty.word());
            return Err(NotEmitted::new(what, variable.span));
        }
        let mut written = writer.block(&body.block)?;
        let leaves =
            matches!(body.block.last().map(|last| &last.kind), Some(StatementKind::Return(_)));
        if signature.result.is_none() && !leaves {
            written.push(Statement::Return { value: None });
        }
        let names = writer.names;
        // The caller of a function has looked for all of them.
        let seen = steps.map(|_| self.seen_by(&names.needs)).unwrap_or_default();
        first.splice(0..0, names.columns(&seen, steps.is_none()));
        let attributes = names.used_attributes();
        let body = match steps {
            Some(&Steps { level, .. }) => {
                ItemBody::Steps { requires: first, level, steps: without_unread(written, false) }
            }
            None => ItemBody::Function([first, written].concat()),
        };
        Ok(Item { signature, attributes, needs: names.needs, body })
    }

    fn steps(&'s self, op: usize, steps: &'s Steps) -> Result<Item, NotEmitted> {
        let resolved = &self.selection.program.ops[op];
        let mut docs = steps.docs.clone();
        if !docs.is_empty() {
            docs.push(String::new());
        }
        docs.push("All or nothing: if a step refuses, what was done is undone.".into());
        let signature = Signature::new(&self.ops[op], &resolved.name, &docs, resolved.result);
        let mut item = self.body(signature, (&steps.body, &resolved.params), Some(steps))?;
        let erases = |param: &Parameter| self.effects.ops[op].erases.contains(param.ty.word());
        let outlives = |param: &&Parameter| param.ty.is_element() && !erases(param);
        item.signature.given = item.signature.params.iter().find(outlives).cloned();
        Ok(item)
    }

    fn function(&'s self, number: u32) -> Result<Item, NotEmitted> {
        let function = &self.selection.program.functions[number as usize];
        let effects = &self.effects.functions[number as usize];
        let mut types = function.params.iter().map(|param| param.ty).chain(function.result);
        if let Some(ty) = types.find(|ty| !is_spelled(*ty)) {
            let what = format!("a function that takes or gives a `{}`", ty.word());
            return Err(NotEmitted::new(what, function.span));
        }
        let Some(body) = &function.body else {
            return Err(NotEmitted::new("this function", function.span));
        };
        let name = &self.functions[number as usize];
        let mut signature = Signature::new(name, &function.name, &function.docs, function.result);
        (signature.changes, signature.refuses) = (effects.changes, effects.refuses);
        self.body(signature, (body, &function.params), None)
    }
}
