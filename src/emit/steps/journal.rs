//! Drawn operations that note elements before they write to them.

use std::collections::BTreeSet;

use super::super::item::{Item, ItemBody};
use super::super::language::Language;
use super::super::routine::{Block, Field, Statement};
use super::super::value::Term;

/// A drawn operation that notes all elements that it writes to, except for new ones.
pub(in crate::emit) fn journaled(mut item: Item, language: Language<'_>) -> Item {
    if let ItemBody::Drawn(rules) = &mut item.body {
        for rule in rules {
            let body = std::mem::take(&mut rule.body);
            rule.body = Notes { language, new: BTreeSet::new() }.body(body);
        }
    }
    item
}

/// The notes of writes to elements that are not new.
struct Notes<'s> {
    language: Language<'s>,
    /// The names of new elements.
    new: BTreeSet<String>,
}

impl Notes<'_> {
    fn body(&mut self, body: Vec<Statement>) -> Vec<Statement> {
        self.new.extend(body.iter().filter_map(|statement| match statement {
            Statement::New { name, .. } => Some(name.clone()),
            _ => None,
        }));
        let mut written: Vec<Term> = Vec::new();
        for element in body.iter().filter_map(written_by) {
            // One that is computed may be another after the writes before it.
            if element.root.is_some() && !self.is_new(element) && !written.contains(element) {
                written.push(element.clone());
            }
        }
        let mut out = Vec::new();
        for mut statement in body {
            if let Some(element) = written_by(&statement) {
                // The elements of a block are noted together, except for those that are only found
                // midway.
                if !written.is_empty() {
                    out.push(self.language.keep(&std::mem::take(&mut written)));
                }
                if element.root.is_none() {
                    out.push(self.language.keep(std::slice::from_ref(element)));
                }
            }
            match &mut statement {
                Statement::Set { field: Field::Attribute(attribute), of, .. }
                    if !self.is_new(of) =>
                {
                    let kept = self.language.keep_attribute(attribute, of);
                    out.push(Statement::lines(kept, [&*of]));
                }
                Statement::Block(Block { body, .. }) => *body = self.body(std::mem::take(body)),
                _ => {}
            }
            out.push(statement);
        }
        out
    }

    fn is_new(&self, element: &Term) -> bool {
        element.root.as_ref().is_some_and(|root| self.new.contains(root))
    }
}

/// The element whose pointers, position or kind a statement writes.
fn written_by(statement: &Statement) -> Option<&Term> {
    match statement {
        Statement::Set { field, of, .. } if !matches!(field, Field::Attribute(_)) => Some(of),
        _ => None,
    }
}
