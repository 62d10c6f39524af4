//! Drawn operations that note elements before they write to them.

use std::collections::BTreeSet;

use super::super::item::{Item, ItemBody};
use super::super::routine::{Field, Statement};
use super::super::term::Term;

/// A drawn operation that notes all elements that it writes to, except for new ones.
pub(super) fn journaled(mut item: Item) -> Item {
    if let ItemBody::Drawn(rules) = &mut item.body {
        for rule in rules {
            let mut new = BTreeSet::new();
            created(&rule.body, &mut new);
            rule.body = journaled_body(std::mem::take(&mut rule.body), &new);
        }
    }
    item
}

/// The names of new elements.
fn created(body: &[Statement], new: &mut BTreeSet<String>) {
    for statement in body {
        match statement {
            Statement::New { name, .. } => _ = new.insert(name.clone()),
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
            // The elements of a block are noted together, except for those that are only found
            // midway.
            if !written.is_empty() {
                out.push(Statement::Journal(std::mem::take(&mut written)));
            }
            if !is_settled(element) && !is_new(element, new) {
                out.push(Statement::Journal(vec![element.clone()]));
            }
        }
        if let Statement::Set { field: Field::Attribute(attribute), of: element, .. } = &statement
            && !is_new(element, new)
        {
            out.push(Statement::JournalAttribute {
                attribute: attribute.clone(),
                element: element.clone(),
            });
        }
        out.push(statement.with_bodies(|body| journaled_body(body, new)));
    }
    out
}

/// The element whose pointers, position or kind a statement writes.
fn target(statement: &Statement) -> Option<&Term> {
    match statement {
        Statement::Set { field: Field::Attribute(_), .. } => None,
        Statement::Set { of, .. } => Some(of),
        _ => None,
    }
}

/// True if the term is the same element before and after other pointers are set.
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
