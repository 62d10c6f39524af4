//! Soundness of rewritten ops: as sound as before.
//!
//! A change that is offered for an op in order must leave it so. That is not argued but tried: the
//! op is read and proved as it would be, among all that it can name, which is what the file uses,
//! its attributes and its functions; its other ops cost nothing.

use std::ops::Range;

use super::files::Reader;
use super::snapshot::Snapshot;
use crate::diagnostic::Edit;
use crate::source::Sources;
use crate::syntax::tree::{Item, Op};

/// The files that a snapshot has read.
struct Known<'s>(&'s Sources);

impl Reader for Known<'_> {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let file = self.0.find(name).ok_or("it has not been read")?;
        Ok(self.0.get(file).text().to_owned())
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }
}

/// True if edits inside of an op or right behind it leave it sound, if it is.
pub(super) fn stays_sound(snapshot: &Snapshot, op: &Op, edits: &[Edit]) -> bool {
    let whole = op.span.range();
    let Some(rewritten) = applied(snapshot.text(), whole.clone(), edits) else {
        return false;
    };
    let mut context = String::new();
    for item in snapshot.items() {
        if matches!(item, Item::Use(_) | Item::Attr(_) | Item::Fn(_)) {
            context.push_str(snapshot.sources().slice(item.span()));
            context.push('\n');
        }
    }
    let is_sound = |op: &str| {
        let text = format!("{context}{op}");
        let name = snapshot.sources().get(snapshot.file()).name();
        let alone = Snapshot::new(name, &text, &mut Known(snapshot.sources()));
        let own = alone.program().ops.iter().enumerate();
        let own = own.filter(|(_, op)| op.span.file == alone.file());
        let told = alone.told().chain(own.flat_map(|(at, _)| &alone.examined(at).diagnostics));
        let mut errors = told.filter(|told| told.is_error() && told.span().file == alone.file());
        !errors.any(|told| told.span().end as usize > context.len())
    };
    is_sound(&rewritten) || !is_sound(&snapshot.text()[whole])
}

/// A part of a text, after edits; `None` if one lies elsewhere.
fn applied(text: &str, part: Range<usize>, edits: &[Edit]) -> Option<String> {
    let mut edits: Vec<_> = edits.iter().map(|edit| (edit.span.range(), &edit.text)).collect();
    edits.sort_by_key(|(range, _)| range.start);
    let mut out = String::new();
    let mut at = part.start;
    for (range, new) in edits {
        if range.start < at || range.end > part.end {
            return None;
        }
        out.push_str(&text[at..range.start]);
        out.push_str(new);
        at = range.end;
    }
    out.push_str(&text[at..part.end]);
    Some(out)
}
