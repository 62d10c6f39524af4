//! The items that are emitted for some operations: these, and before them what they call.

use std::collections::BTreeSet;

use super::super::NotEmitted;
use super::super::build;
use super::super::conventions::Conventions;
use super::super::expression::{is_spelled, parameters};
use super::super::item::{Item, ItemBody, Signature};
use super::super::names::{Names, free, invoked};
use super::super::routine::{Statement, without_unread};
use super::super::selection::Selection;
use super::super::term::Parameter;
use super::body::{Context, Writer};
use super::journal::journaled;
use crate::diagram::{Param, Require};
use crate::lower::AllEffects;
use crate::resolve::{Body, Steps};
use crate::source::Span;

/// Everything that is emitted.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::emit) struct Items {
    /// The items that are called, each after those that it calls, and with the name of its file.
    pub called: Vec<(String, Item)>,
    /// The operations that were selected.
    pub ops: Vec<Item>,
}

/// The items for the operations of a selection.
pub(in crate::emit) fn items(
    selection: &Selection<'_>,
    conventions: Conventions<'_>,
) -> Result<Items, NotEmitted> {
    let effects = AllEffects::of(selection.program, selection.proved);
    let (op_names, function_names) = called(selection, effects.ops.len(), conventions.reserved);
    let values = effects.functions.iter().zip(&selection.program.functions);
    let values = values.zip(&function_names).map(|((effects, function), name)| {
        let computes = !effects.changes && !effects.refuses && function.result.is_some();
        computes.then(|| name.clone())
    });
    let mut builder = Builder {
        selection,
        conventions,
        values: values.collect(),
        op_names,
        function_names,
        effects,
        begun: BTreeSet::new(),
        done: BTreeSet::new(),
        called: Vec::new(),
    };
    let mut ops = Vec::new();
    let known = |op: usize| selection.drawn(op).is_some() || selection.program.ops.len() > op;
    for op in selection.ops.iter().copied().filter(|&op| known(op)) {
        let (item, needs) = builder.op(op)?;
        for need in needs {
            builder.need(need, selection.program.ops.get(op).map(|op| op.span))?;
        }
        ops.push(item);
    }
    Ok(Items { called: builder.called, ops })
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

/// A called function or operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Need {
    Function(u32),
    Op(usize),
}

struct Builder<'s> {
    selection: &'s Selection<'s>,
    conventions: Conventions<'s>,
    effects: AllEffects,
    /// The names of the functions that compute a value, by number.
    values: Vec<Option<String>>,
    op_names: Vec<String>,
    function_names: Vec<String>,
    begun: BTreeSet<Need>,
    done: BTreeSet<Need>,
    called: Vec<(String, Item)>,
}

impl Builder<'_> {
    /// Adds a called item after those that it calls, unless it is there already.
    fn need(&mut self, need: Need, from: Option<Span>) -> Result<(), NotEmitted> {
        // A mesh that undoes by itself needs no second form of a selected operation.
        if let Need::Op(op) = need
            && self.conventions.undoes
            && self.selection.ops.contains(&op)
        {
            return Ok(());
        }
        if !self.begun.insert(need) {
            return match (self.done.contains(&need), from) {
                (false, Some(span)) => {
                    let what = "functions that call each other in a circle";
                    Err(NotEmitted::new(what, span))
                }
                _ => Ok(()),
            };
        }
        let (item, needs) = match need {
            Need::Function(number) => self.function(number)?,
            Need::Op(op) => {
                let (item, needs) = self.op(op)?;
                match self.conventions.undoes {
                    true => (item, needs),
                    false => (journaled(item), needs),
                }
            }
        };
        // A call of itself needs no forward declaration; a cycle of calls would.
        for other in needs.into_iter().filter(|&other| other != need) {
            self.need(other, Some(self.span(need)))?;
        }
        self.done.insert(need);
        let home = self.selection.sources.get(self.span(need).file).name();
        self.called.push((home.to_string(), item));
        Ok(())
    }

    fn span(&self, need: Need) -> Span {
        match need {
            Need::Function(number) => self.selection.program.functions[number as usize].span,
            Need::Op(op) => self.selection.program.ops[op].span,
        }
    }

    fn op(&self, op: usize) -> Result<(Item, Vec<Need>), NotEmitted> {
        if let Some(steps) = self.selection.steps(op) {
            return self.steps(op, steps);
        }
        let Some(proved) = self.selection.drawn(op) else {
            let span = self.span(Need::Op(op));
            let what = format!("`{}`, which is not proved,", self.selection.name(op));
            return Err(NotEmitted::new(what, span));
        };
        let looks = |function| {
            let effects = self.effects.function(function);
            effects.map_or_else(BTreeSet::new, |effects| effects.attributes.clone())
        };
        let (mut item, calls) = build::routine(proved, &self.values, self.conventions, &looks)?;
        item.signature.name = self.op_names[op].clone();
        let needs = calls.into_iter().map(Need::Function).collect();
        Ok((item, needs))
    }

    fn context(&self) -> Context<'_> {
        Context {
            program: self.selection.program,
            sources: self.selection.sources,
            effects: &self.effects,
            op_names: &self.op_names,
            function_names: &self.function_names,
            conventions: self.conventions,
        }
    }

    /// Names for a body, in which no variable shadows what is called.
    fn names(&self, body: &Body, params: &[Param]) -> Names {
        let functions = self.function_names.iter().map(|name| invoked(name));
        let taken = match self.conventions.undoes {
            true => self.op_names.iter().cloned().chain(functions).collect(),
            // Calls are qualified with a namespace.
            false => Vec::new(),
        };
        Names::of_body(
            &body.variables,
            params.len(),
            &self.values,
            &self.selection.program.attributes,
            (self.conventions.reserved, taken.into_iter()),
        )
    }

    /// The parameters and statements of a body, and what it calls. The statements begin with the
    /// columns of attributes, and with the tests before anything is done.
    fn body(
        &self,
        (body, params, requires): (&Body, &[Param], Option<&[Require]>),
    ) -> Result<Written, NotEmitted> {
        let mut names = self.names(body, params);
        let params = parameters(params, &mut names)?;
        let is_function = requires.is_none();
        let mut writer = Writer::new(self.context(), body, params.len(), is_function, &mut names);
        let mut first = Vec::new();
        for require in requires.unwrap_or_default() {
            let when = writer.term(&require.condition)?.not();
            first.push(Statement::Refuse { when, reason: require.reason.clone() });
        }
        let body = writer.write()?;
        let (ops, functions) = (writer.ops, writer.functions.into_iter());
        let functions = functions.chain(names.take_calls());
        let functions: Vec<_> = functions.collect();
        if self.conventions.columns {
            let seen = functions.iter().filter_map(|number| self.effects.function(*number));
            // The caller of a function has looked for all of them.
            let seen = seen.filter(|_| !is_function).flat_map(|effects| &effects.attributes);
            first.splice(0..0, names.columns(&seen.copied().collect()));
        }
        let needs = functions.into_iter().map(Need::Function);
        let needs = needs.chain(ops.into_iter().map(Need::Op)).collect();
        Ok(Written { params, first, body, needs })
    }

    fn steps(&self, op: usize, steps: &Steps) -> Result<(Item, Vec<Need>), NotEmitted> {
        let resolved = &self.selection.program.ops[op];
        let Written { params, first, body, needs } =
            self.body((&steps.body, &resolved.params, Some(&steps.requires)))?;
        let erases = |param: &Parameter| self.effects.ops[op].erases.contains(param.ty.word());
        let outlives = |param: &&Parameter| param.ty.is_element() && !erases(param);
        let signature = Signature {
            name: self.op_names[op].clone(),
            declared: resolved.name.clone(),
            given: params.iter().find(outlives).cloned(),
            docs: all_or_nothing(&steps.docs),
            params,
            result: resolved.result,
        };
        let (level, steps) = (steps.level, without_unread(body, Statement::bound));
        Ok((Item { signature, body: ItemBody::Steps { requires: first, level, steps } }, needs))
    }

    fn function(&self, number: u32) -> Result<(Item, Vec<Need>), NotEmitted> {
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
        let Written { params, first, body, needs } = self.body((body, &function.params, None))?;
        let signature = Signature {
            name: self.function_names[number as usize].clone(),
            declared: function.name.clone(),
            docs: function.docs.clone(),
            params,
            result: function.result,
            given: None,
        };
        let (changes, refuses) = (effects.changes, effects.refuses);
        let body = [first, body].concat();
        Ok((Item { signature, body: ItemBody::Function { changes, refuses, body } }, needs))
    }
}

/// What is written for a body.
struct Written {
    params: Vec<Parameter>,
    first: Vec<Statement>,
    body: Vec<Statement>,
    needs: Vec<Need>,
}

/// The doc comment of an operation in steps, with a sentence that applies to all of them.
fn all_or_nothing(docs: &[String]) -> Vec<String> {
    let mut docs = docs.to_vec();
    if !docs.is_empty() {
        docs.push(String::new());
    }
    docs.push("All or nothing: if a step refuses, what was done is undone.".into());
    docs
}
