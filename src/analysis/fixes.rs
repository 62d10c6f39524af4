//! What mends a diagnostic: the fixes that it carries, which are sure, and proposals for what
//! only a person can decide.

use std::ops::Range;

use super::action::{Action, Purpose, append, statement_span};
use super::demand::lacking;
use super::element::{Fate, element_of};
use super::names::{SymbolId, SymbolKind};
use super::side::subject;
use super::snapshot::Snapshot;
use crate::diagnostic::{Diagnostic, Edit};
use crate::diagram::Kind;
use crate::source::Span;
use crate::syntax::tree::{Arrow, Name, Rule, Side, Spoke, Statement};

/// What mends the diagnostics of a part of the text.
pub(super) fn mending(snapshot: &Snapshot, part: &Range<usize>) -> Vec<Action> {
    let touches = |span: Span| {
        span.file == snapshot.file()
            && span.touches(part.start.clamp(span.start as usize, span.end as usize))
            && span.start as usize <= part.end
            && part.start <= span.end as usize
    };
    let mut actions = Vec::new();
    for told in snapshot.diagnostics() {
        if !told.labels.iter().any(|label| touches(label.span)) {
            continue;
        }
        for fix in &told.fixes {
            actions.push(Action {
                title: fix.title.clone(),
                purpose: Purpose::Fix,
                edits: fix.edits.clone(),
                mends: Some(told.clone()),
            });
        }
        for (title, edits) in proposals(snapshot, &told) {
            actions.push(Action {
                title,
                purpose: Purpose::Proposal,
                edits,
                mends: Some(told.clone()),
            });
        }
    }
    actions
}

type Proposal = (String, Vec<Edit>);

fn proposals(snapshot: &Snapshot, told: &Diagnostic) -> Vec<Proposal> {
    if told.code == "property-not-kept" {
        return lacking(snapshot, told);
    }
    let Some((item, at, op)) = snapshot.rule_at(told.span().start as usize) else {
        return Vec::new();
    };
    let rule = &op.rules[at];
    let ends = |end: Option<&Side>| end.cloned();
    let Some(after) = ends(rule.after.as_ref()) else {
        return Vec::new();
    };
    match told.code {
        "unaccounted-name" | "missing-reassignment" => {
            let names = pointed_at(snapshot, told, rule);
            account_for(snapshot, rule, &after, &names)
        }
        "unknown-name" => {
            let unknown = snapshot.names().of_rule(item, at);
            let unknown: Vec<_> = unknown
                .filter(|(id, _)| fate(snapshot, *id, rule) == Some(Fate::Unknown))
                .map(|(id, symbol)| (id, symbol.name.clone()))
                .collect();
            list_as_new(snapshot, told, &after, &unknown)
        }
        "unused-new" | "listed-twice" | "already-drawn" | "new-and-erased" | "cannot-keep" => {
            unlist(snapshot, told.span(), rule)
        }
        _ => Vec::new(),
    }
}

fn fate(snapshot: &Snapshot, id: SymbolId, rule: &Rule) -> Option<Fate> {
    element_of(snapshot, id, rule).map(|element| element.fate)
}

/// The names that a diagnostic points at.
fn pointed_at(snapshot: &Snapshot, told: &Diagnostic, rule: &Rule) -> Vec<(SymbolId, String)> {
    let mut found: Vec<(SymbolId, String)> = Vec::new();
    let before = rule.before.as_ref().map(|side| side.span);
    for label in &told.labels {
        // A label may cover several names: `c | c'`.
        let inside = snapshot.names().mentions().iter().filter(|mention| {
            label.span.start <= mention.span.start
                && mention.span.end <= label.span.end
                && before.is_some_and(|side| side.touches(mention.span.start as usize))
        });
        for mention in inside {
            if found.iter().all(|(known, _)| *known != mention.symbol) {
                let name = snapshot.names().symbol(mention.symbol).name.clone();
                found.push((mention.symbol, name));
            }
        }
    }
    found
}

/// Restates what `before` says of names, keeps them, or erases them.
fn account_for(
    snapshot: &Snapshot,
    rule: &Rule,
    after: &Side,
    names: &[(SymbolId, String)],
) -> Vec<Proposal> {
    let mut proposals = Vec::new();
    let statements = rule.before.iter().flat_map(|side| &side.statements);
    for statement in statements.filter(|statement| subject(statement).is_some()) {
        let draws = |name: &String| mentions(statement).any(|drawn| drawn == name);
        let is_stated = |name: &Name| {
            let stated = after.statements.iter().filter_map(subject);
            stated
                .into_iter()
                .any(|known| known.ident.text == name.ident.text)
        };
        let Some(of) = subject(statement).filter(|of| !is_stated(of)) else {
            continue;
        };
        if names.iter().any(|(_, name)| draws(name)) {
            let text = snapshot
                .sources()
                .slice(statement_span(statement))
                .to_owned();
            let title = format!("restate `{text}` in `after`");
            proposals.push((title, vec![append(snapshot, after, &[text])]));
            let keep = format!("keep {}", of.ident.text);
            let title = format!("insert `{keep}`");
            proposals.push((title, vec![append(snapshot, after, &[keep])]));
        }
    }
    let forgotten: Vec<&str> = names
        .iter()
        .filter(|(id, _)| {
            let kind = snapshot.names().symbol(*id).kind;
            let is_run = matches!(kind, SymbolKind::Element(Some(Kind::Path | Kind::Fan)));
            !is_run && fate(snapshot, *id, rule) == Some(Fate::Forgotten)
        })
        .map(|(_, name)| name.as_str())
        .collect();
    if !forgotten.is_empty() {
        let list = forgotten.join(" ");
        let title = format!("erase `{}`", forgotten.join("`, `"));
        proposals.push((title, vec![add_to_list(snapshot, after, "erase", &list)]));
    }
    proposals
}

/// The words that a statement draws.
fn mentions(statement: &Statement) -> impl Iterator<Item = &String> {
    let mut words: Vec<&String> = subject(statement)
        .map(|name| &name.ident.text)
        .into_iter()
        .collect();
    match statement {
        Statement::Loop(orbit) => {
            for item in &orbit.items {
                if let Arrow::Halfedge(name) | Arrow::Path(Some(name)) = &item.arrow {
                    words.push(&name.ident.text);
                }
            }
        }
        Statement::Edge { halfedges, .. } => {
            words.extend(halfedges.iter().map(|half| &half.ident.text));
        }
        Statement::Vertex(star) => {
            for spoke in &star.spokes {
                if let Spoke::Halfedge(name) | Spoke::Fan(Some(name), _) = spoke {
                    words.push(&name.ident.text);
                }
            }
        }
        _ => {}
    }
    words.into_iter()
}

/// Lists names in `new`: the one that is told of, and all at once.
fn list_as_new(
    snapshot: &Snapshot,
    told: &Diagnostic,
    after: &Side,
    unknown: &[(SymbolId, String)],
) -> Vec<Proposal> {
    let mention = snapshot.names().at(told.span().start as usize);
    let Some(mention) = mention else {
        return Vec::new();
    };
    let own = unknown.iter().find(|(id, _)| *id == mention.symbol);
    let mut proposals = Vec::new();
    if let Some((_, name)) = own {
        let edit = add_to_list(snapshot, after, "new", name);
        proposals.push((format!("list `{name}` in `new`"), vec![edit]));
        if unknown.len() > 1 {
            let names: Vec<_> = unknown.iter().map(|(_, name)| name.as_str()).collect();
            let title = format!("list `{}` in `new`", names.join("`, `"));
            let edit = add_to_list(snapshot, after, "new", &names.join(" "));
            proposals.push((title, vec![edit]));
        }
    }
    proposals
}

/// Writes names at the end of a list of a side, or begins one.
fn add_to_list(snapshot: &Snapshot, after: &Side, list: &str, names: &str) -> Edit {
    let last = after.statements.iter().rev().find_map(|statement| {
        let (listed, is) = match statement {
            Statement::New(listed, _) => (listed, "new"),
            Statement::Erase(listed, _) => (listed, "erase"),
            _ => return None,
        };
        (is == list).then(|| listed.last()).flatten()
    });
    if let Some(last) = last {
        return Edit {
            span: last.span.after(),
            text: format!(" {names}"),
        };
    }
    let statement = format!("{list} {names}");
    match after.statements.first() {
        // What is new stands first.
        Some(first) if list == "new" => {
            let place = statement_span(first);
            let indentation = super::action::indentation(snapshot, place);
            Edit {
                span: place.before(),
                text: format!("{statement}\n{indentation}"),
            }
        }
        _ => append(snapshot, after, &[statement]),
    }
}

/// Takes a name out of a list; of a list that has no other, all.
fn unlist(snapshot: &Snapshot, place: Span, rule: &Rule) -> Vec<Proposal> {
    let sides = rule.before.iter().chain(&rule.after);
    let found = sides
        .flat_map(|side| &side.statements)
        .find_map(|statement| {
            let (Statement::New(names, span)
            | Statement::Erase(names, span)
            | Statement::Keep(names, span)) = statement
            else {
                return None;
            };
            let name = names.iter().find(|name| name.span == place)?;
            Some((names.len(), *span, name))
        });
    let Some((count, whole, name)) = found else {
        return Vec::new();
    };
    let gone = if count == 1 { whole } else { name.span };
    let before = &snapshot.text()[..gone.start as usize];
    let start = before.trim_end_matches([' ', '\t']).len();
    let edit = Edit {
        span: Span::new(gone.file, start, gone.end as usize),
        text: String::new(),
    };
    vec![(
        format!("remove `{}` from the list", name.ident.text),
        vec![edit],
    )]
}
