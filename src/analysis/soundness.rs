//! A check that rewritten ops are as sound as before.
//!
//! A change that is offered for a sound op must leave it sound. This is not deduced but tried: the
//! changed op is parsed and proved together with what it can name, which is what the file uses, its
//! attributes and its functions; the other ops of the file are left out to save time.

use std::collections::HashMap;

use super::files::Reader;
use super::snapshot::Snapshot;
use crate::diagnostic::{Diagnostic, Edit, applied};
use crate::source::Sources;
use crate::syntax::tree::{Item, Op};

/// The files that a snapshot has read, some of them with other texts.
pub(super) struct Known<'s> {
    /// The files.
    pub sources: &'s Sources,
    /// The other texts, by the names of the files.
    pub texts: &'s HashMap<String, String>,
}

impl Reader for Known<'_> {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let known = self.sources.find(name).map(|file| self.sources.get(file).text());
        let text = self.texts.get(name).map(String::as_str).or(known);
        Ok(text.ok_or("it has not been read")?.to_owned())
    }

    fn identity(&mut self, name: &str) -> String {
        let known = self.sources.find(name).map(|file| self.sources.get(file).name());
        known.unwrap_or(name).to_owned()
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }
}

/// True if edits inside an op or right after it leave it sound, or if it is not sound anyway.
pub(super) fn stays_sound(snapshot: &Snapshot, op: &Op, edits: &[Edit]) -> bool {
    let whole = op.span.range();
    let Some((rewritten, _)) = applied(snapshot.text(), whole.clone(), edits) else { return false };
    let is_sound = |op: &str| errors(snapshot, op).is_empty();
    is_sound(&rewritten) || !is_sound(&snapshot.text()[whole])
}

/// True if edits inside an op that has errors leave none of a code, and bring none of other codes.
pub(super) fn resolves(snapshot: &Snapshot, op: &Op, edits: &[Edit], code: &str) -> bool {
    let rewritten = applied(snapshot.text(), op.span.range(), edits);
    let Some((rewritten, _)) = rewritten else { return false };
    let known = snapshot.diagnostics_so_far();
    let is_known =
        |left: &Diagnostic| known.iter().any(|told| told.is_error() && told.code == left.code);
    errors(snapshot, &rewritten).iter().all(|left| left.code != code && is_known(left))
}

/// True if edits inside an op leave no error of the same code and words as one of it.
pub(super) fn removes(snapshot: &Snapshot, op: &Op, edits: &[Edit], error: &Diagnostic) -> bool {
    let rewritten = applied(snapshot.text(), op.span.range(), edits);
    let Some((rewritten, _)) = rewritten else { return false };
    let is_same = |left: &Diagnostic| left.code == error.code && left.message == error.message;
    !errors(snapshot, &rewritten).iter().any(is_same)
}

/// The errors of an op with another text.
fn errors(snapshot: &Snapshot, op: &str) -> Vec<Diagnostic> {
    let mut context = String::new();
    for item in snapshot.items() {
        if matches!(item, Item::Use(_) | Item::Attr(_) | Item::Fn(_)) {
            context.push_str(snapshot.sources().slice(item.span()));
            context.push('\n');
        }
    }
    let text = format!("{context}{op}");
    let name = snapshot.sources().get(snapshot.file()).name();
    let mut known = Known { sources: snapshot.sources(), texts: &HashMap::new() };
    let alone = Snapshot::new(name, &text, &mut known);
    let own = alone.program().ops.iter().enumerate();
    let own = own.filter(|(_, op)| op.span.file == alone.file());
    let told = alone.told().chain(own.flat_map(|(at, _)| &alone.examined(at).diagnostics));
    let errors = told.filter(|told| told.is_error() && told.span().file == alone.file());
    let own = errors.filter(|told| told.span().end as usize > context.len());
    own.cloned().collect()
}
