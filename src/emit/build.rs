//! A proved operation to a routine: its four phases, rule by rule.

use std::collections::BTreeSet;

use super::NotEmitted;
use super::action::Action;
use super::conventions::Conventions;
use super::expression::{Expressions, is_spelled, is_surely_finite, parameters};
use super::guard;
use super::matching::Matching;
use super::names::Names;
use super::reassign;
use super::routine::{Alternative, Routine, Statement, without_unread};
use super::term::{Function, Parameter, Term};
use crate::check::matching::Step;
use crate::check::{Proof, Proved};
use crate::diagram::{Access, Binary, Drawing, Kind, Rule, Type};
use crate::lower::Guard;

/// The routine of a proved operation, and the functions that it calls; of those, the attributes
/// that they look at are told by number.
pub(super) fn routine(
    proved: &Proved,
    functions: &[Option<String>],
    conventions: Conventions<'_>,
    looks: &dyn Fn(u32) -> BTreeSet<u32>,
) -> Result<(Routine, BTreeSet<u32>), NotEmitted> {
    let op = proved.op();
    if let Some(param) = op.params.iter().find(|param| !is_spelled(param.ty)) {
        let what = format!("a parameter of type `{}`", param.ty.word());
        return Err(NotEmitted::new(what, param.span));
    }
    let mut all_calls = BTreeSet::new();
    let mut params = Vec::new();
    let mut rules = Vec::new();
    for (rule, proof) in op.rules.iter().zip(proved.proofs()) {
        let rule = proof.drawn(rule);
        let mut names = Names::new(op, rule, functions, conventions.kept);
        params = parameters(&op.params, &mut names)?;
        let mut body = alternative(rule, proof, conventions, &mut names)?;
        let calls = names.take_calls();
        if conventions.columns {
            let seen = calls.iter().flat_map(|&call| looks(call));
            body.splice(0..0, columns(&names, seen.collect()));
        }
        all_calls.extend(calls);
        rules.push(Alternative { label: rule.label.clone(), body: without_unread(body) });
    }
    let outlives = |&(at, param): &(usize, &Parameter)| {
        let erased = |rule: &Rule| {
            let name = rule.params.get(at).copied().flatten();
            name.is_none_or(|name| rule.erased.iter().any(|erased| erased.name == name))
        };
        param.ty.is_element() && !op.rules.iter().any(erased)
    };
    let given = params.iter().enumerate().find(outlives).map(|(_, param)| param.clone());
    let routine = Routine {
        name: op.name.clone(),
        declared: op.name.clone(),
        given,
        docs: op.docs.clone(),
        params,
        result: op.result,
        rules,
    };
    Ok((routine, all_calls))
}

/// Finds the columns of the attributes that are used, and makes sure of those that the functions
/// look at that are called.
pub(super) fn columns(names: &Names, seen: BTreeSet<u32>) -> Vec<Statement> {
    let used = names.used_attributes().cloned().map(Statement::Column);
    let seen = seen.into_iter().filter_map(|it| names.unused_attribute(it));
    let asked = seen.map(|attribute| Statement::Action(Action::Ask(attribute.clone())));
    used.chain(asked).collect()
}

fn alternative(
    rule: &Rule,
    proof: &Proof,
    conventions: Conventions<'_>,
    names: &mut Names,
) -> Result<Vec<Statement>, NotEmitted> {
    let drawing = Drawing::new(rule);
    let mut rest = phases(&drawing, proof, conventions, names)?;
    // From the last attempt outwards: each holds all that comes after it.
    let attempts: Vec<_> = proof
        .matching()
        .iter()
        .enumerate()
        .filter(|(_, step)| is_tried(step))
        .map(|(at, _)| at)
        .collect();
    let walked_first = proof.matching().iter().find_map(|step| match step {
        Step::Walk { orbit, .. } => Some(*orbit),
        _ => None,
    });
    let mut matching = Matching { drawing: &drawing, conventions, names };
    let mut end = proof.matching().len();
    for &at in attempts.iter().rev() {
        let Step::Attempt { element, halfedge, .. } = proof.matching()[at] else {
            continue;
        };
        let mut body = matching.steps(&proof.matching()[at + 1..end], walked_first);
        body.extend(rest);
        rest = vec![Statement::Attempt {
            kind: rule.kind(element),
            element: matching.names.word(element).into(),
            halfedge: matching.names.begin(halfedge),
            body,
        }];
        end = at;
    }
    let mut body = matching.steps(&proof.matching()[..end], walked_first);
    body.extend(rest);
    Ok(body)
}

/// True if several halfedges are tried.
fn is_tried(step: &Step) -> bool {
    matches!(step, Step::Attempt { tries, .. } if *tries != Some(1))
}

/// Everything that comes after matching: the questions, and phases 2 to 4.
fn phases(
    drawing: &Drawing,
    proof: &Proof,
    conventions: Conventions<'_>,
    names: &mut Names,
) -> Result<Vec<Statement>, NotEmitted> {
    let rule = drawing.rule;
    let mut body = Matching { drawing, conventions, names }.distinct_and_paths(proof.matching());
    for require in &rule.requires {
        let repeated = match require.index {
            None => false,
            Some(0) => true,
            // What holds at index 0 is asked at every index.
            Some(_) => continue,
        };
        let condition =
            Expressions { names }.once(&require.condition, repeated, Some(rule), &mut body)?;
        let ask = |names: &mut Names| Expressions { names }.term(&condition);
        let condition = names.for_each(repeated, ask)?;
        if repeated {
            body.push(Statement::Refuse {
                when: condition.not().for_some(names.indices()),
                reason: require.reason.clone(),
            });
            continue;
        }
        let mut parts = Vec::new();
        conjuncts(condition, &mut parts);
        body.extend(
            parts
                .into_iter()
                .map(|part| Statement::Refuse { when: part.not(), reason: require.reason.clone() }),
        );
    }
    body.extend(guard::tests(drawing, &Guard::new(drawing, proof.guard()), names, conventions));
    let values = values(drawing, names, &mut body)?;
    if !rule.created.is_empty() {
        body.push(Statement::Blank);
        body.push(Statement::Comment("2. Allocate what is new.".into()));
    }
    body.extend(allocation(rule, names));
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
    let erased: Vec<_> = rule
        .erased
        .iter()
        .map(|erased| erased.name)
        .filter(|&erased| rule.is_first(erased))
        .filter(|&erased| !matches!(rule.kind(erased), Kind::Path | Kind::Fan))
        .collect();
    if !erased.is_empty() {
        body.push(Statement::Blank);
        body.push(Statement::Comment("4. Erase what is gone.".into()));
    }
    for erased in erased {
        let member = rule.is_member(erased);
        let erase = Statement::Erase {
            kind: rule.kind(erased),
            element: names.for_each(member, |names| names.term(erased)),
        };
        body.push(match member {
            true => Statement::IndexLoop { indices: names.indices(), body: vec![erase] },
            false => erase,
        });
    }
    body.push(Statement::Return { result: rule.result.map(|result| names.term(result.name)) });
    Ok(body)
}

/// The statements that allocate everything new; a family at its first member.
pub(super) fn allocation(rule: &Rule, names: &Names) -> Vec<Statement> {
    let created = rule.created.iter().map(|created| created.name);
    let created = created.filter(|&created| rule.is_first(created));
    let allocate = |created| {
        let (kind, name) = (rule.kind(created), names.word(created).to_string());
        match rule.is_member(created) {
            true => {
                let indices = names.indices();
                Statement::NewEach { kind, name, indices }
            }
            false => Statement::New { kind, name },
        }
    };
    created.map(allocate).collect()
}

/// The conditions that an `and` joins; they are asked one by one, in the same order.
fn conjuncts(term: Term, parts: &mut Vec<Term>) {
    match term {
        Term::Binary(Binary::And, left, right) => {
            conjuncts(*left, parts);
            conjuncts(*right, parts);
        }
        term => parts.push(term),
    }
}

/// Evaluates the right-hand sides, on the mesh as it was; what sets them.
fn values(
    drawing: &Drawing,
    names: &mut Names,
    body: &mut Vec<Statement>,
) -> Result<Vec<Statement>, NotEmitted> {
    let rule = drawing.rule;
    let mut sets = Vec::new();
    for assignment in &rule.assignments {
        let target = assignment.target.name;
        let attribute = match assignment.attribute {
            Access::Position => None,
            Access::Declared(number) => names.attribute(number),
        };
        if !rule.is_first(target) {
            continue;
        }
        let member = rule.is_member(target);
        let word = names.word(target).trim_end_matches('_').to_string();
        let called = attribute.as_ref().map_or("position", |it| &it.name);
        let name = names.fresh(&format!("{word}_{called}"));
        let value = Expressions { names }.once(&assignment.value, member, Some(rule), body)?;
        let evaluate = |names: &mut Names| Expressions { names }.term(&value);
        let value = names.for_each(member, evaluate)?;
        let ty = attribute.as_ref().map_or(Type::Vec3, |it| it.ty);
        let indices = names.indices();
        let bound = name.clone();
        body.push(match member {
            true => Statement::Gather { ty, name: bound, indices: indices.clone(), item: value },
            false => Statement::Bind { ty, name: bound, value },
        });
        let (element, value) = names.for_each(member, |names| {
            let value = match member {
                true => names.member(&name, 0),
                false => Term::name(&name),
            };
            (names.term(target), value)
        });
        if attribute.is_none() && !is_surely_finite(&assignment.value) {
            let infinite = Term::Call(Function::IsFinite, vec![value.clone()]).not();
            let text = &rule.name(target).text;
            body.push(Statement::Refuse {
                when: match member {
                    true => infinite.for_some(indices.clone()),
                    false => infinite,
                },
                reason: format!("the new position of `{text}` is not finite"),
            });
        }
        let set = match attribute {
            None => Statement::SetPosition { vertex: element, value },
            Some(attribute) => Statement::SetAttribute { attribute, element, value },
        };
        sets.push(match member {
            true => Statement::IndexLoop { indices, body: vec![set] },
            false => set,
        });
    }
    Ok(sets)
}
