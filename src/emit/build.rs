//! A proved operation to a routine: its four phases, rule by rule.

use super::NotEmitted;
use super::expression::{Expressions, is_spelled, is_surely_finite};
use super::guard;
use super::matching::Matching;
use super::names::Names;
use super::reassign;
use super::routine::{Alternative, Parameter, Routine, Statement, Term, without_unread};
use crate::check::matching::Step;
use crate::check::{Proof, Proved};
use crate::diagram::{Access, Binary, Drawing, Kind, Pointer, Rule, Type};

/// Which pointers of a halfedge the mesh stores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pointers {
    /// `prev` too.
    WithPrev,
    /// Who wants `prev` walks.
    WithoutPrev,
}

/// The routine of a proved operation.
pub(super) fn routine(proved: &Proved, pointers: Pointers) -> Result<Routine, NotEmitted> {
    let op = proved.op();
    if let Some(param) = op.params.iter().find(|param| !is_spelled(param.ty)) {
        let what = format!("a parameter of type `{}`", param.ty.word());
        return Err(NotEmitted::new(what, param.span));
    }
    if let Some(rule) = op.rules.iter().find(|rule| rule.has_families()) {
        return Err(NotEmitted::new("a drawing with `each`", rule.span));
    }
    let mut params = Vec::new();
    let mut rules = Vec::new();
    for (rule, proof) in op.rules.iter().zip(proved.proofs()) {
        let mut names = Names::new(op, rule);
        let body = alternative(rule, proof, pointers, &mut names)?;
        rules.push(Alternative {
            label: rule.label.clone(),
            body: without_unread(body),
        });
        params = op
            .params
            .iter()
            .zip(names.params())
            .map(|(param, name)| Parameter {
                name: name.clone(),
                ty: param.ty,
            })
            .collect();
    }
    Ok(Routine {
        name: op.name.clone(),
        docs: op.docs.clone(),
        params,
        result: op.result,
        rules,
    })
}

fn alternative(
    rule: &Rule,
    proof: &Proof,
    pointers: Pointers,
    names: &mut Names,
) -> Result<Vec<Statement>, NotEmitted> {
    let drawing = Drawing::new(rule);
    let mut rest = phases(&drawing, proof, pointers, names)?;
    // From the last attempt outwards: each holds all that comes after it.
    let attempts: Vec<_> = proof
        .matching()
        .iter()
        .enumerate()
        .filter(|(_, step)| matches!(step, Step::Attempt { .. }))
        .map(|(at, _)| at)
        .collect();
    let matching = Matching {
        drawing: &drawing,
        names,
    };
    let mut end = proof.matching().len();
    for &at in attempts.iter().rev() {
        let Step::Attempt {
            element, halfedge, ..
        } = proof.matching()[at]
        else {
            continue;
        };
        let mut body = matching.steps(&proof.matching()[at + 1..end]);
        body.extend(rest);
        rest = vec![Statement::Attempt {
            kind: rule.kind(element),
            element: names.word(element).into(),
            halfedge: names.word(halfedge).into(),
            body,
        }];
        end = at;
    }
    let mut body = matching.steps(&proof.matching()[..end]);
    body.extend(rest);
    Ok(body)
}

/// Everything that comes after matching: the questions, and phases 2 to 4.
fn phases(
    drawing: &Drawing,
    proof: &Proof,
    pointers: Pointers,
    names: &mut Names,
) -> Result<Vec<Statement>, NotEmitted> {
    let rule = drawing.rule;
    let mut body = Matching { drawing, names }.distinct_and_paths(proof.matching());
    for require in &rule.requires {
        let condition = Expressions { names }.term(&require.condition)?;
        let mut parts = Vec::new();
        conjuncts(condition, &mut parts);
        body.extend(parts.into_iter().map(|part| Statement::Refuse {
            when: part.not(),
            reason: require.reason.clone(),
        }));
    }
    body.extend(guard::tests(drawing, proof.guard(), names)?);
    let values = values(drawing, names, &mut body)?;
    if !rule.created.is_empty() {
        body.push(Statement::Blank);
        body.push(Statement::Comment("2. Allocate what is new.".into()));
    }
    for created in &rule.created {
        body.push(Statement::New {
            kind: rule.kind(created.name),
            name: names.word(created.name).into(),
        });
    }
    let mut sets = reassign::statements(drawing, names);
    sets.retain(|set| {
        let is_prev = matches!(
            set,
            Statement::Set {
                pointer: Pointer::Prev,
                ..
            }
        );
        pointers == Pointers::WithPrev || !is_prev
    });
    for (target, value) in values {
        sets.push(Statement::SetPosition {
            vertex: target,
            value,
        });
    }
    if !sets.is_empty() {
        body.push(Statement::Blank);
        body.push(Statement::Comment(
            "3. Reassign every pointer that changes.".into(),
        ));
        body.extend(sets);
    }
    let erased: Vec<_> = rule
        .erased
        .iter()
        .filter(|erased| !matches!(rule.kind(erased.name), Kind::Path | Kind::Fan))
        .collect();
    if !erased.is_empty() {
        body.push(Statement::Blank);
        body.push(Statement::Comment("4. Erase what is gone.".into()));
    }
    for erased in erased {
        body.push(Statement::Erase {
            kind: rule.kind(erased.name),
            name: names.word(erased.name).into(),
        });
    }
    body.push(Statement::Return {
        result: rule
            .result
            .map(|result| Term::name(names.word(result.name))),
    });
    Ok(body)
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

/// Evaluates the right-hand sides, on the mesh as it was: where each goes, and its name.
fn values(
    drawing: &Drawing,
    names: &mut Names,
    body: &mut Vec<Statement>,
) -> Result<Vec<(Term, Term)>, NotEmitted> {
    let mut values = Vec::new();
    for assignment in &drawing.rule.assignments {
        if assignment.attribute != Access::Position {
            let word = drawing.rule.attribute(assignment.attribute);
            let what = format!("the attribute `{word}`");
            return Err(NotEmitted::new(what, assignment.span));
        }
        let target = names.word(assignment.target.name).to_string();
        let name = names.fresh(&format!("{}_position", target.trim_end_matches('_')));
        let value = Expressions { names }.term(&assignment.value)?;
        let may_fail = !is_surely_finite(&assignment.value);
        body.push(Statement::Bind {
            ty: Type::Vec3,
            name: name.clone(),
            value,
        });
        if may_fail {
            let text = &drawing.rule.name(assignment.target.name).text;
            body.push(Statement::Refuse {
                when: Term::Call(super::routine::Function::IsFinite, vec![Term::name(&name)]).not(),
                reason: format!("the new position of `{text}` is not finite"),
            });
        }
        values.push((Term::name(target), Term::name(name)));
    }
    Ok(values)
}
