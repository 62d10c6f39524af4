//! Changes that fix a diagnostic: the fixes that it carries, which are certain, and proposals for
//! what only the user can decide.

use std::ops::Range;

use super::action::{Action, Purpose};
use super::dangling_twins::draw_twins;
use super::edits::{append, indentation};
use super::element::{Fate, element_of};
use super::missing_conditions::lacking;
use super::names::SymbolId;
use super::proposal::{Proposal, kind_of, written};
use super::side::{draws_erased, subject};
use super::snapshot::Snapshot;
use super::soundness::{removes, resolves};
use crate::diagnostic::{Diagnostic, Edit};
use crate::diagram::Kind;
use crate::resolve::drawn_parts;
use crate::source::Span;
use crate::syntax::tree::{Item, Name, Rule, Side};

/// The changes that fix the diagnostics of a part of the text.
pub(super) fn mending(snapshot: &Snapshot, part: &Range<usize>) -> Vec<Action> {
    let touches = |span: Span| {
        span.file == snapshot.file()
            && span.touches(part.start.clamp(span.start as usize, span.end as usize))
            && span.start as usize <= part.end
            && part.start <= span.end as usize
    };
    let mut actions = Vec::new();
    for item in snapshot.items() {
        if let Item::Op(op) = item
            && touches(op.span)
            && let Some(at) = snapshot.resolved(op)
        {
            snapshot.examined(at);
        }
    }
    for told in snapshot.diagnostics_so_far() {
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
        for (title, edits) in proposals(snapshot, &told, part) {
            let mends = accounts(snapshot, &told, &edits).then(|| told.clone());
            // Beside a fix that is certain, what leaves errors only misleads.
            if mends.is_none() && !told.fixes.is_empty() {
                continue;
            }
            actions.push(Action { title, purpose: Purpose::Proposal, edits, mends });
        }
    }
    actions
}

/// True if a proposal accounts for all that a diagnostic misses; of one about something else, it is
/// known.
fn accounts(snapshot: &Snapshot, told: &Diagnostic, edits: &[Edit]) -> bool {
    if !MISSED.contains(&told.code) {
        return true;
    }
    let op = snapshot.op_at(told.span().start as usize);
    op.is_some_and(|(_, op)| resolves(snapshot, op, edits, told.code))
}

/// The codes of errors about names that `after` misses.
const MISSED: [&str; 2] = ["unaccounted-name", "missing-reassignment"];

fn proposals(snapshot: &Snapshot, told: &Diagnostic, part: &Range<usize>) -> Vec<Proposal> {
    if told.code == "property-not-kept" {
        return lacking(snapshot, told);
    }
    let Some((item, at, op)) = snapshot.rule_at(told.span().start as usize) else {
        return Vec::new();
    };
    let rule = &op.rules[at];
    let ends = |end: Option<&Side>| end.cloned();
    let Some(after) = ends(rule.after.as_ref()) else { return Vec::new() };
    match told.code {
        code if MISSED.contains(&code) => {
            let names = pointed_at(snapshot, told, rule);
            account_for(snapshot, rule, &after, &names)
        }
        "unknown-name" => {
            let unknown = snapshot.names().of_rule(item, at);
            let mut unknown: Vec<_> = unknown
                .filter(|(id, _)| fate(snapshot, *id, rule) == Some(Fate::Unknown))
                .filter(|(id, _)| !is_run(kind_of(snapshot, *id)))
                .map(|(id, _)| (id, written(snapshot, id)))
                .collect();
            let order = [Kind::Vertex, Kind::Halfedge, Kind::Edge, Kind::Face];
            unknown.sort_by_key(|(id, _)| {
                let kind = kind_of(snapshot, *id);
                order.iter().position(|&known| Some(known) == kind)
            });
            let mut listed = list_as_new(snapshot, part.start, &after, &unknown);
            listed.retain(|(_, edits)| removes(snapshot, op, edits, told));
            listed
        }
        "unused-new" | "listed-twice" | "already-drawn" | "new-and-erased" | "cannot-keep" => {
            unlist(snapshot, told.span(), rule)
        }
        "open-loop" => close(snapshot, told),
        "dangling-outside" | "twin-not-drawn" => draw_twins(snapshot, told, rule),
        _ => Vec::new(),
    }
}

/// Proposals that close a loop: by ending it where it begins, or by continuing it to there.
fn close(snapshot: &Snapshot, told: &Diagnostic) -> Vec<Proposal> {
    let [end, begin, ..] = told.labels.as_slice() else { return Vec::new() };
    let first = snapshot.sources().slice(begin.span);
    let edit = |span: Span, text: String| vec![Edit { span, text }];
    let go_on = |arrow: &str| {
        let title = format!("go on with `{arrow} {first}`");
        (title, edit(end.span.after(), format!(" {arrow} {first}")))
    };
    vec![
        go_on("=P=>"),
        go_on("-h->"),
        (format!("end at `{first}`"), edit(end.span, first.to_owned())),
    ]
}

/// True for paths and fans, which are neither made nor erased by name.
fn is_run(kind: Option<Kind>) -> bool {
    matches!(kind, Some(Kind::Path | Kind::Fan))
}

fn fate(snapshot: &Snapshot, id: SymbolId, rule: &Rule) -> Option<Fate> {
    element_of(snapshot, id, rule).map(|element| element.fate)
}

/// The names of `before` that a diagnostic points at.
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

/// Proposals that account for names: by restating what `before` says of them, or by keeping or
/// erasing them.
fn account_for(
    snapshot: &Snapshot,
    rule: &Rule,
    after: &Side,
    names: &[(SymbolId, String)],
) -> Vec<Proposal> {
    let mut proposals = Vec::new();
    let statements = rule.before.iter().flat_map(|side| &side.statements);
    for statement in statements.filter(|statement| !draws_erased(statement, after)) {
        let is_stated = |name: &Name| {
            let stated = after.statements.iter().filter_map(subject);
            stated.into_iter().any(|known| known.ident.text == name.ident.text)
        };
        let Some(of) = subject(statement).filter(|of| !is_stated(of)) else { continue };
        let mut drawn = drawn_parts(statement).chain([of]);
        if drawn.any(|drawn| names.iter().any(|(_, name)| *name == drawn.ident.text)) {
            let text = snapshot.sources().slice(statement.span()).to_owned();
            let title = format!("restate `{text}` in `after`");
            proposals.push((title, vec![append(snapshot, after, &[text])]));
            let keep = format!("keep {of}");
            let title = format!("insert `{keep}`");
            proposals.push((title, vec![append(snapshot, after, &[keep])]));
        }
    }
    proposals.extend(list_forgotten(snapshot, rule, after, names));
    proposals
}

/// Proposals that list forgotten names in `keep`, if they are vertices without a statement of their
/// own, or in `erase`.
fn list_forgotten(
    snapshot: &Snapshot,
    rule: &Rule,
    after: &Side,
    names: &[(SymbolId, String)],
) -> Vec<Proposal> {
    let is_stated = |name: &str| {
        let mut subjects = rule.before.iter().flat_map(|side| &side.statements).filter_map(subject);
        subjects.any(|subject| subject.ident.text == name)
    };
    let mut kept = Vec::new();
    let mut erased = Vec::new();
    for (id, name) in names {
        if fate(snapshot, *id, rule) != Some(Fate::Forgotten) {
            continue;
        }
        let kind = kind_of(snapshot, *id);
        if kind == Some(Kind::Vertex) && !is_stated(name) {
            kept.push(written(snapshot, *id));
        }
        if !is_run(kind) {
            erased.push(written(snapshot, *id));
        }
    }
    let mut proposals = Vec::new();
    if !kept.is_empty() {
        let words = kept.join(" ");
        let edit = add_to_list(snapshot, after, "keep", &words);
        proposals.push((format!("insert `keep {words}`"), vec![edit]));
    }
    if !erased.is_empty() {
        let title = format!("erase `{}`", erased.join("`, `"));
        let edit = add_to_list(snapshot, after, "erase", &erased.join(" "));
        proposals.push((title, vec![edit]));
    }
    proposals
}

/// Proposals that list names in `new`: the one at a place, and all at once.
fn list_as_new(
    snapshot: &Snapshot,
    place: usize,
    after: &Side,
    unknown: &[(SymbolId, String)],
) -> Vec<Proposal> {
    let listed = |names: &[&str]| {
        let title = format!("list `{}` in `new`", names.join("`, `"));
        let edit = add_to_list(snapshot, after, "new", &names.join(" "));
        (title, vec![edit])
    };
    let here = snapshot.names().at(place).map(|mention| mention.symbol);
    let own = unknown.iter().find(|(id, _)| Some(*id) == here);
    let mut proposals: Vec<_> = own.iter().map(|(_, name)| listed(&[name])).collect();
    if unknown.len() > 1 {
        let names: Vec<_> = unknown.iter().map(|(_, name)| name.as_str()).collect();
        proposals.push(listed(&names));
    }
    proposals
}

/// The edit that appends names to a list of a side, or begins one.
fn add_to_list(snapshot: &Snapshot, after: &Side, list: &str, names: &str) -> Edit {
    let last =
        after.statements.iter().rev().find_map(|statement| {
            statement.listed().filter(|(keyword, _)| *keyword == list)?.1.last()
        });
    if let Some(last) = last {
        return Edit { span: last.span.after(), text: format!(" {names}") };
    }
    let statement = format!("{list} {names}");
    match after.statements.first() {
        // `new` comes first.
        Some(first) if list == "new" => {
            let place = first.span();
            let indentation = indentation(snapshot, place);
            Edit { span: place.before(), text: format!("{statement}\n{indentation}") }
        }
        _ => append(snapshot, after, &[statement]),
    }
}

/// Removes a name from a list; the whole list if it has no other name.
fn unlist(snapshot: &Snapshot, place: Span, rule: &Rule) -> Vec<Proposal> {
    let sides = rule.before.iter().chain(&rule.after);
    let found = sides.flat_map(|side| &side.statements).find_map(|statement| {
        let (_, names) = statement.listed()?;
        let name = names.iter().find(|name| name.span == place)?;
        Some((names.len(), statement.span(), name))
    });
    let Some((count, whole, name)) = found else { return Vec::new() };
    let gone = if count == 1 { whole } else { name.span };
    let before = &snapshot.text()[..gone.start as usize];
    let start = before.trim_end_matches([' ', '\t']).len();
    let edit = Edit { span: Span::new(gone.file, start, gone.end as usize), text: String::new() };
    vec![(format!("remove `{}` from the list", name.ident.text), vec![edit])]
}
