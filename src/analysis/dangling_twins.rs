//! Proposals that draw the outside twins that a rule would leave dangling.

use super::edits::append;
use super::names::SymbolId;
use super::proposal::{Proposal, kind_of, written};
use super::snapshot::Snapshot;
use crate::diagnostic::Diagnostic;
use crate::diagram::Kind;
use crate::source::Span;
use crate::syntax::tree::{Rule, Side, Statement};

/// Proposals of edge statements in `before` for halfedges that are reported to lack a twin there:
/// for this one alone, and for all of the rule.
pub(super) fn draw_twins(snapshot: &Snapshot, told: &Diagnostic, rule: &Rule) -> Vec<Proposal> {
    let Some(before) = &rule.before else { return Vec::new() };
    let lacking = |span: Span| -> Option<SymbolId> {
        let at = span.start as usize;
        let id = snapshot.names().at(at).filter(|_| rule.span.touches(at))?.symbol;
        let is_half = kind_of(snapshot, id) == Some(Kind::Halfedge);
        let word = &snapshot.names().symbol(id).name;
        (is_half && !is_paired(before, word)).then_some(id)
    };
    let Some(this) = lacking(told.span()) else { return Vec::new() };
    let alike = snapshot.diagnostics_so_far();
    let alike = alike.iter().filter(|other| other.code == told.code);
    let mut all: Vec<SymbolId> = Vec::new();
    for id in alike.flat_map(|other| &other.labels).filter_map(|label| lacking(label.span)) {
        if !all.contains(&id) {
            all.push(id);
        }
    }
    let mut wanted = vec![vec![this]];
    if all.len() > 1 {
        wanted.insert(0, all);
    }
    let propose = |halves: Vec<SymbolId>| {
        let words: Vec<_> = halves.iter().map(|&id| written(snapshot, id)).collect();
        let statements: Vec<_> = halves.iter().map(|&id| statement(snapshot, rule, id)).collect();
        let twins = if words.len() == 1 { "twin" } else { "twins" };
        let title = format!("draw the {twins} of `{}` in `before`", words.join("`, `"));
        (title, vec![append(snapshot, before, &statements)])
    };
    wanted.into_iter().map(propose).collect()
}

/// True if an edge statement names a halfedge.
fn is_paired(side: &Side, word: &str) -> bool {
    side.statements.iter().any(|statement| match statement {
        Statement::Edge { halfedges, .. } => halfedges.iter().any(|half| half.ident.text == word),
        _ => false,
    })
}

/// `edge eb: b | b'`, with names that the rule does not have.
fn statement(snapshot: &Snapshot, rule: &Rule, half: SymbolId) -> String {
    let symbol = snapshot.names().symbol(half);
    let text = snapshot.sources().slice(rule.span);
    let is_taken = |name: &str| {
        let letter = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
        text.split(|c| !letter(c)).any(|word| word == name)
    };
    let free = |mut name: String| {
        while is_taken(&name) {
            name.push('\'');
        }
        name
    };
    let edge = free(format!("e{}", symbol.name));
    let twin = free(format!("{}'", symbol.name));
    let half = written(snapshot, half);
    let index = half.strip_prefix(symbol.name.as_str()).unwrap_or("");
    format!("edge {edge}{index}: {half} | {twin}{index}")
}
