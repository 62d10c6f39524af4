//! Translation of a proved operation to a routine: its four phases, rule by rule.

use std::collections::BTreeSet;

use super::NotEmitted;
use super::conventions::Conventions;
use super::expression::{Expressions, ORDINARY, is_surely_finite, parameters};
use super::guard;
use super::item::{Alternative, Item, ItemBody, Signature};
use super::matching::Matching;
use super::matrix::finite;
use super::names::Names;
use super::reassign;
use super::routine::{Field, Statement, without_unread};
use super::term::{Parameter, Term};
use crate::check::{Proof, Proved};
use crate::diagram::{Access, Binary, Drawing, Rule, Type};
use crate::lower::{Condition, Element, Operation, Step, Tries, Value};

/// A proved operation as a routine, and the functions that it calls; `looks` gives the attributes
/// that a function looks at.
pub(super) fn routine(
    proved: &Proved,
    functions: &[Option<String>],
    conventions: Conventions<'_>,
    looks: &dyn Fn(u32) -> BTreeSet<u32>,
) -> Result<(Item, BTreeSet<u32>), NotEmitted> {
    let op = proved.op();
    let mut all_calls = BTreeSet::new();
    let mut params = Vec::new();
    let mut rules = Vec::new();
    for (rule, proof) in op.rules.iter().zip(proved.proofs()) {
        let rule = proof.drawn(rule);
        let mut names = Names::new(op, rule, functions, conventions.reserved);
        params = parameters(&op.params, &mut names)?;
        let mut body = alternative(rule, proof, conventions, &mut names)?;
        let calls = names.take_calls();
        if conventions.columns {
            let seen = calls.iter().flat_map(|&call| looks(call));
            body.splice(0..0, names.columns(&seen.collect()));
        }
        all_calls.extend(calls);
        rules.push(Alternative {
            label: rule.label.clone(),
            body: without_unread(body, Statement::bound),
        });
    }
    let outlives = |&(at, param): &(usize, &Parameter)| {
        let erased = |rule: &Rule| {
            let name = rule.params.get(at).copied().flatten();
            name.is_none_or(|name| rule.erased.iter().any(|erased| erased.name == name))
        };
        param.ty.is_element() && !op.rules.iter().any(erased)
    };
    let given = params.iter().enumerate().find(outlives).map(|(_, param)| param.clone());
    let signature = Signature {
        name: op.name.clone(),
        declared: op.name.clone(),
        given,
        docs: op.docs.clone(),
        params,
        result: op.result,
    };
    Ok((Item { signature, body: ItemBody::Drawn(rules) }, all_calls))
}

fn alternative(
    rule: &Rule,
    proof: &Proof,
    conventions: Conventions<'_>,
    names: &mut Names,
) -> Result<Vec<Statement>, NotEmitted> {
    let drawing = Drawing::new(rule);
    let operation = Operation::new(&drawing, proof);
    let mut rest = phases(&drawing, &operation, conventions, names)?;
    let steps = &operation.matching.steps;
    let mut matching = Matching { drawing: &drawing, conventions, names };
    // From the last attempt outwards: each contains everything after it.
    let mut end = steps.len();
    for (at, step) in steps.iter().enumerate().rev() {
        let Step::Begin(begin) = step else {
            continue;
        };
        let is_tried_once = match begin.tries {
            Tries::Some(1) => true,
            Tries::AllForValues => operation.values.iter().all(|set| refusal(set).is_none()),
            Tries::All | Tries::Some(_) => false,
        };
        if is_tried_once {
            continue;
        }
        let mut body = matching.steps(&steps[at + 1..end]);
        body.extend(rest);
        rest = vec![Statement::Attempt {
            kind: rule.kind(begin.element),
            element: matching.names.word(begin.element).into(),
            halfedge: matching.names.begin(begin.halfedge),
            body,
        }];
        end = at;
    }
    let mut body = matching.steps(&steps[..end]);
    body.extend(rest);
    Ok(body)
}

/// The statements after matching: the conditions, and phases 2 to 4.
fn phases(
    drawing: &Drawing,
    operation: &Operation,
    conventions: Conventions<'_>,
    names: &mut Names,
) -> Result<Vec<Statement>, NotEmitted> {
    let rule = drawing.rule;
    let mut body =
        Matching { drawing, conventions, names }.empty_paths_and_tests(&operation.matching);
    for &Condition { condition, at_each_index, refusal } in &operation.requires {
        let condition =
            Expressions { names }.once(condition, at_each_index, Some(rule), &mut body)?;
        let ask = |names: &mut Names| Expressions { names }.term(&condition);
        let condition = names.for_each(at_each_index, ask)?;
        let mut parts = Vec::new();
        match at_each_index {
            true => parts.push(condition),
            false => conjuncts(condition, &mut parts),
        }
        let parts = parts.into_iter();
        body.extend(parts.map(|part| names.refusal(part.not(), at_each_index, refusal)));
    }
    body.extend(guard::tests(drawing, operation, names, conventions));
    let values = values(rule, &operation.values, names, &mut body)?;
    if !operation.created.is_empty() {
        body.push(Statement::Blank);
        body.push(Statement::Comment("2. Allocate what is new.".into()));
    }
    body.extend(allocation(&operation.created, names));
    let mut sets = reassign::statements(drawing, names, conventions);
    sets.extend(values);
    if !sets.is_empty() {
        body.push(Statement::Blank);
        let which = match conventions.exhaustive {
            true => "3. Reassign every pointer, whether it changes or not.",
            false => "3. Reassign every pointer that changes.",
        };
        body.push(Statement::Comment(which.into()));
        body.extend(sets);
    }
    if !operation.erased.is_empty() {
        body.push(Statement::Blank);
        body.push(Statement::Comment("4. Erase what is gone.".into()));
    }
    for &Element { name, kind, at_each_index } in &operation.erased {
        let element = names.for_each(at_each_index, |names| names.term(name));
        let erase = Statement::Erase { kind, element };
        body.push(names.repeated(at_each_index, erase));
    }
    body.push(Statement::Return { value: operation.result.map(|name| names.term(name)) });
    Ok(body)
}

/// The statements that allocate everything new; a family is given by its first member.
pub(super) fn allocation(created: &[Element], names: &Names) -> Vec<Statement> {
    let allocate = |&Element { name, kind, at_each_index }: &Element| {
        let indices = at_each_index.then(|| names.indices.clone());
        Statement::New { kind, name: names.word(name).to_string(), indices }
    };
    created.iter().map(allocate).collect()
}

/// The conditions that an `and` joins; they are tested one by one, in the same order.
fn conjuncts(term: Term, parts: &mut Vec<Term>) {
    match term {
        Term::Binary(Binary::And, left, right) => {
            conjuncts(*left, parts);
            conjuncts(*right, parts);
        }
        term => parts.push(term),
    }
}

/// The reason to refuse a new position, if it may be infinite.
fn refusal<'v>(assigned: &'v Value) -> Option<&'v String> {
    assigned.infinite.as_ref().filter(|_| !is_surely_finite(assigned.value, ORDINARY))
}

/// Evaluates the right-hand sides on the mesh before any change, and returns the statements that
/// assign them.
fn values(
    rule: &Rule,
    values: &[Value],
    names: &mut Names,
    body: &mut Vec<Statement>,
) -> Result<Vec<Statement>, NotEmitted> {
    let mut sets = Vec::new();
    for assigned in values {
        let Value { element, attribute, value: expr, at_each_index: member, .. } = assigned;
        let attribute = match attribute {
            Access::Position => None,
            Access::Declared(number) => names.attribute(*number),
        };
        let word = names.word(*element).trim_end_matches('_').to_string();
        let called = attribute.as_ref().map_or("position", |it| &it.name);
        let name = names.fresh(&format!("{word}_{called}"));
        let value = Expressions { names }.once(expr, *member, Some(rule), body)?;
        let value = names.for_each(*member, |names| Expressions { names }.term(&value))?;
        let ty = attribute.as_ref().map_or(Type::Vec3, |it| it.ty);
        body.push(names.bound(ty, name.clone(), value, *member));
        let (element, value) = names.for_each(*member, |names| {
            let value = match member {
                true => names.member(&name, 0),
                false => Term::name(&name),
            };
            (names.term(*element), value)
        });
        if let Some(reason) = refusal(assigned) {
            let infinite = finite(value.clone()).not();
            body.push(names.refusal(infinite, *member, reason));
        }
        let field = attribute.map_or(Field::Position, Field::Attribute);
        let set = Statement::Set { field, of: element, value };
        sets.push(names.repeated(*member, set));
    }
    Ok(sets)
}
