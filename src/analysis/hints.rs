//! Inlay hints: facts that are known but not written, to be shown between the words.

use super::side::Sketch;
use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::TokenKind;
use crate::syntax::tree::{Item, Op, Rule, Statement};

/// A known fact, and the place after which it is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The place.
    pub after: Span,
    /// The text of the hint.
    pub label: String,
    /// True if it is a type.
    pub is_type: bool,
    /// Its meaning, in a sentence.
    pub meaning: String,
}

/// The hints in a part of the text.
pub fn hints(snapshot: &Snapshot, part: std::ops::Range<usize>) -> Vec<Hint> {
    let mut hints = Vec::new();
    for item in snapshot.items() {
        let span = item.span();
        if span.end as usize >= part.start
            && span.start as usize <= part.end
            && let Item::Op(op) = item
        {
            op_hints(snapshot, op, &mut hints);
        }
    }
    variables(snapshot, &mut hints);
    hints.retain(|hint| (part.start..=part.end).contains(&(hint.after.end as usize)));
    hints.sort_by_key(|hint| hint.after.end);
    hints
}

fn op_hints(snapshot: &Snapshot, op: &Op, hints: &mut Vec<Hint>) {
    let resolved = snapshot.resolved(op);
    if let (Some(result), None, Some(at)) = (&op.result, &op.steps, resolved)
        && let Some(ty) = snapshot.program().ops[at].result
    {
        hints.push(Hint {
            after: result.span,
            label: format!(": {}", ty.word()),
            is_type: true,
            meaning: format!("the op returns {}", ty.a_word()),
        });
    }
    let verdict = snapshot.verdict(op);
    for (at, rule) in op.rules.iter().enumerate() {
        outer_ends(rule, hints);
        if let (Some(verdict), Some(after)) = (verdict.rules.get(at), &rule.after) {
            let changes: Vec<_> =
                verdict.degrees.iter().map(|(vertex, by)| format!("{vertex} {by}")).collect();
            if !changes.is_empty() {
                let keyword = after.span.start + "after".len() as u32;
                hints.push(Hint {
                    after: Span { end: keyword.min(after.span.end), ..after.span },
                    label: format!("degrees {}", changes.join(", ")),
                    is_type: false,
                    meaning: "how the degrees of the vertices change".into(),
                });
            }
        }
    }
}

/// Hints for the start and end of the outer halfedges of `before`.
fn outer_ends(rule: &Rule, hints: &mut Vec<Hint>) {
    let [before, _] = Sketch::of(rule);
    let statements = rule.before.iter().flat_map(|side| &side.statements);
    for statement in statements {
        let Statement::Edge { halfedges, .. } = statement else { continue };
        for (outer, twin) in [(0, 1), (1, 0)] {
            let name = &halfedges[outer];
            if before.place(&name.ident.text).is_some() {
                continue;
            }
            let Some(twin) = before.place(&halfedges[twin].ident.text) else { continue };
            let (from, to) = (twin.to.text(), twin.from.text());
            hints.push(Hint {
                after: name.span,
                label: format!("{from} → {to}"),
                is_type: false,
                meaning: format!("this outer halfedge starts at `{from}` and ends at `{to}`"),
            });
        }
    }
}

/// True if a name is declared by `let` or `var`: the type of a loop variable is obvious.
fn follows_let(snapshot: &Snapshot, name: Span) -> bool {
    let tokens = &snapshot.parsed().tokens;
    let at = tokens.partition_point(|token| token.span.start < name.start);
    let before = at.checked_sub(1).map(|at| tokens[at].kind);
    matches!(before, Some(TokenKind::Let | TokenKind::Var))
}

/// The types of variables that are declared without one.
fn variables(snapshot: &Snapshot, hints: &mut Vec<Hint>) {
    for variable in snapshot.program().variables().filter(|of| of.span.file == snapshot.file()) {
        let mention = snapshot.names().at(variable.span.start as usize);
        let symbol = mention.map(|mention| snapshot.names().symbol(mention.symbol));
        let is_bare = symbol
            .is_some_and(|symbol| symbol.definition == Some(variable.span) && symbol.ty.is_none());
        if is_bare && follows_let(snapshot, variable.span) {
            hints.push(Hint {
                after: variable.span,
                label: format!(": {}", variable.ty.word()),
                is_type: true,
                meaning: format!("`{}` is {}", variable.name, variable.ty.a_word()),
            });
        }
    }
}
