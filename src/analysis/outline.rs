//! The outline of a text: its items and their parts.

use super::side::subject;
use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::tree::{Ident, Item, Op, Rule, Side, Statement};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryKind {
    Op,
    Rule,
    /// `before` or `after`.
    Side,
    Statement,
    Script,
    Function,
    Attribute,
    Test,
}

/// An entry of the outline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    pub name: String,
    /// A detail that is worth seeing beside it; may be empty.
    pub detail: String,
    pub kind: EntryKind,
    pub span: Span,
    pub name_span: Span,
    pub children: Vec<Entry>,
}

/// The largest number of statements that an outline shows.
const MOST_STATEMENTS: usize = 10_000;

/// The outline of a text. If the text has too many statements, they are left out.
pub fn outline(snapshot: &Snapshot) -> Vec<Entry> {
    let items = snapshot.items().iter();
    let rules = items.clone().filter_map(Item::op).flat_map(|op| &op.rules);
    let sides = rules.flat_map(|rule| [&rule.before, &rule.after]).flatten();
    let statements: usize = sides.map(|side| side.statements.len()).sum();
    let with_statements = statements <= MOST_STATEMENTS;
    items.filter_map(|item| item_entry(snapshot, item, with_statements)).collect()
}

fn item_entry(snapshot: &Snapshot, item: &Item, with_statements: bool) -> Option<Entry> {
    let named = |name: &Ident, kind, span| Entry {
        name: name.text.clone(),
        detail: String::new(),
        kind,
        span,
        name_span: name.span,
        children: Vec::new(),
    };
    Some(match item {
        Item::Op(op) => Entry {
            detail: parameters(snapshot, op),
            children: rules(op, with_statements),
            ..named(&op.name, EntryKind::Op, op.span)
        },
        Item::Script(script) => named(&script.name, EntryKind::Script, script.span),
        Item::Fn(function) => named(&function.name, EntryKind::Function, function.span),
        Item::Attr(attr) => named(&attr.name, EntryKind::Attribute, attr.span),
        Item::Test(test) => Entry {
            name: test.name.clone(),
            detail: "test".into(),
            kind: EntryKind::Test,
            span: test.span,
            name_span: Span { end: test.body.span.start.max(test.span.start), ..test.span },
            children: Vec::new(),
        },
        Item::Use(_) | Item::Broken(_) => return None,
    })
}

/// The parameters and the result of an op, as they are written.
fn parameters(snapshot: &Snapshot, op: &Op) -> String {
    let head = super::hover::head(snapshot, op);
    head.split_once('(').map_or(String::new(), |(_, rest)| format!("({rest}"))
}

fn rules(op: &Op, with_statements: bool) -> Vec<Entry> {
    let rules = op.rules.iter().map(|rule| match &rule.name {
        None => sides(rule, with_statements),
        Some(name) => vec![Entry {
            name: name.text.clone(),
            detail: "rule".into(),
            kind: EntryKind::Rule,
            span: rule.span,
            name_span: name.span,
            children: sides(rule, with_statements),
        }],
    });
    rules.flatten().collect()
}

fn sides(rule: &Rule, with_statements: bool) -> Vec<Entry> {
    let side = |side: &Option<Side>, name: &str| {
        let side = side.as_ref()?;
        let end = side.span.start + name.len() as u32;
        Some(Entry {
            name: name.to_owned(),
            detail: String::new(),
            kind: EntryKind::Side,
            span: side.span,
            name_span: Span { end: end.min(side.span.end), ..side.span },
            children: match with_statements {
                true => side.statements.iter().filter_map(statement).collect(),
                false => Vec::new(),
            },
        })
    };
    let both = [side(&rule.before, "before"), side(&rule.after, "after")];
    both.into_iter().flatten().collect()
}

fn statement(statement: &Statement) -> Option<Entry> {
    let name = subject(statement)?;
    let (word, span) = match statement {
        Statement::Loop(orbit) => ("loop", orbit.span),
        Statement::Edge { span, .. } => ("edge", *span),
        Statement::Vertex(star) => ("vertex", star.span),
        _ => return None,
    };
    // Where its first word is missing, a statement begins with its name.
    let span = Span { start: span.start.min(name.ident.span.start), ..span };
    Some(Entry {
        name: name.ident.text.clone(),
        detail: word.to_owned(),
        kind: EntryKind::Statement,
        span,
        name_span: name.ident.span,
        children: Vec::new(),
    })
}

/// The parts of a text that can be folded away, each with whether it is a comment.
pub fn folds(snapshot: &Snapshot) -> Vec<(Span, bool)> {
    let mut folds = Vec::new();
    for item in snapshot.items() {
        if !matches!(item, Item::Broken(_) | Item::Use(_) | Item::Attr(_)) {
            folds.push((item.span(), false));
        }
        if let Item::Op(op) = item {
            for rule in &op.rules {
                if rule.name.is_some() {
                    folds.push((rule.span, false));
                }
                let sides = rule.before.iter().chain(&rule.after);
                folds.extend(sides.map(|side| (side.span, false)));
            }
        }
    }
    for block in super::spans::blocks(snapshot.items()) {
        folds.push((block, false));
    }
    folds.extend(comments(snapshot).into_iter().map(|span| (span, true)));
    folds.sort();
    folds.dedup_by_key(|(span, _)| *span);
    folds
}

/// Runs of comments on lines that follow each other.
fn comments(snapshot: &Snapshot) -> Vec<Span> {
    let mut runs: Vec<Span> = Vec::new();
    let text = snapshot.text();
    for comment in &snapshot.parsed().comments {
        if let Some(run) = runs.last_mut() {
            let between = text.get(run.end as usize..comment.span.start as usize);
            let between = between.unwrap_or("x");
            if between.trim().is_empty() && between.matches('\n').count() == 1 {
                *run = run.to(comment.span);
                continue;
            }
        }
        runs.push(comment.span);
    }
    runs.retain(|run| text.get(run.range()).is_some_and(|text| text.contains('\n')));
    runs
}
