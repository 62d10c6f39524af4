//! Drawn operations that note what they write to, before they do.

use std::collections::BTreeSet;

use super::super::routine::{Alternative, Routine, Statement};
use super::super::term::Term;

/// A drawn operation that notes all elements that it writes to; what is new needs none.
pub(super) fn journaled(routine: Routine) -> Routine {
    let rules = routine.rules.into_iter().map(|rule| {
        let mut new = BTreeSet::new();
        created(&rule.body, &mut new);
        Alternative { body: journaled_body(rule.body, &new), ..rule }
    });
    Routine { rules: rules.collect(), ..routine }
}

/// The names of what is new.
fn created(body: &[Statement], new: &mut BTreeSet<String>) {
    for statement in body {
        match statement {
            Statement::New { name, .. } | Statement::NewEach { name, .. } => {
                new.insert(name.clone());
            }
            Statement::Attempt { body, .. } => created(body, new),
            _ => {}
        }
    }
}

fn journaled_body(body: Vec<Statement>, new: &BTreeSet<String>) -> Vec<Statement> {
    let mut written: Vec<Term> = Vec::new();
    for statement in &body {
        if let Some(element) = target(statement).filter(|element| is_settled(element))
            && !is_new(element, new)
            && !written.contains(element)
        {
            written.push(element.clone());
        }
    }
    let mut out = Vec::new();
    for statement in body {
        if let Some(element) = target(&statement) {
            // All of a block are noted at once, but those that are only found on the way.
            if !written.is_empty() {
                out.push(Statement::Keep(std::mem::take(&mut written)));
            }
            if !is_settled(element) && !is_new(element, new) {
                out.push(Statement::Keep(vec![element.clone()]));
            }
        }
        if let Statement::SetAttribute { attribute, element, .. } = &statement
            && !is_new(element, new)
        {
            out.push(Statement::KeepAttribute {
                attribute: attribute.clone(),
                element: element.clone(),
            });
        }
        out.push(statement.with_bodies(|body| journaled_body(body, new)));
    }
    out
}

/// The element whose pointers, place or kind a statement writes.
fn target(statement: &Statement) -> Option<&Term> {
    match statement {
        Statement::Set { of, .. } => Some(of),
        Statement::SetHole { face, .. } => Some(face),
        Statement::SetPosition { vertex, .. } => Some(vertex),
        _ => None,
    }
}

/// True if it is the same before and after other pointers were set.
fn is_settled(element: &Term) -> bool {
    matches!(element, Term::Name(_) | Term::Member { .. })
}

fn is_new(element: &Term, new: &BTreeSet<String>) -> bool {
    match element {
        Term::Name(name) => new.contains(name),
        Term::Member { list, .. } => new.contains(list),
        _ => false,
    }
}
