//! Completions in a drawing.

use super::choice::{Choice, Completion};
use super::words::{DRAWINGS, LISTS, PERIOD, keywords, kinds};
use crate::analysis::cursor_context::{op_near, rule_near};
use crate::analysis::drawing_context::Wanted;
use crate::analysis::element::{Fate, element_of};
use crate::analysis::names::{SideName, Symbol, SymbolId, SymbolKind};
use crate::analysis::side::{Sketch, left_open};
use crate::analysis::snapshot::Snapshot;
use crate::diagram::Kind;
use crate::syntax::tree::Rule;

/// The results of an op: a name that it draws or, in steps, the kind of an element.
pub(super) fn results(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let op = op_near(snapshot, offset).map(|(_, op)| op);
    let is_drawn = op.is_some_and(|op| op.rules.iter().any(|rule| rule.before.is_some()));
    if is_drawn { drawn(snapshot, offset) } else { kinds() }
}

/// The names that an op may return.
fn drawn(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let Some((item, _)) = op_near(snapshot, offset) else { return Vec::new() };
    let own = snapshot.names().symbols().filter(|(_, symbol)| symbol.item == Some(item));
    own.filter_map(|(_, symbol)| match symbol.kind {
        SymbolKind::Element(Some(kind)) if !matches!(kind, Kind::Path | Kind::Fan) => {
            Some(named(symbol, kind, 0))
        }
        _ => None,
    })
    .collect()
}

/// The names that an `alias` may list, vertices first.
pub(super) fn can_be_one(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let Some((item, at, rule)) = rule_near(snapshot, offset) else { return Vec::new() };
    let [before, _] = Sketch::of(rule);
    let own = snapshot.names().of_rule(item, at);
    let drawn = own.filter(|(_, symbol)| before.draws(&symbol.name));
    drawn
        .filter_map(|(_, symbol)| match symbol.kind {
            SymbolKind::Element(Some(kind @ Kind::Vertex)) => Some(named(symbol, kind, 0)),
            SymbolKind::Element(Some(kind @ (Kind::Halfedge | Kind::Face))) => {
                Some(named(symbol, kind, 1))
            }
            _ => None,
        })
        .collect()
}

/// The subscripts of a family, by the letter of its index.
pub(super) fn indices(letter: &str) -> Vec<Completion> {
    let near = ["", "+1", "-1"].into_iter().zip(0..);
    near.map(|(step, rank)| Completion::new(format!("{letter}{step}"), Choice::Variable, rank))
        .collect()
}

/// An element by its name.
pub(super) fn named(symbol: &Symbol, kind: Kind, rank: u8) -> Completion {
    Completion {
        detail: kind.word().to_owned(),
        ..Completion::new(symbol.name.clone(), Choice::Element(kind), rank)
    }
}

/// Completions in a drawing: names of the kind that fits, those still unaccounted for first, and
/// statements where one may begin.
pub(super) fn of_side(
    snapshot: &Snapshot,
    offset: usize,
    side: SideName,
    wanted: Wanted,
) -> Vec<Completion> {
    let mut found = Vec::new();
    let begins = matches!(
        wanted,
        Wanted::Statement | Wanted::NextSpoke | Wanted::New | Wanted::Erase | Wanted::Keep
    );
    if begins {
        found.extend(keywords(DRAWINGS));
        if side == SideName::After {
            found.extend(keywords(LISTS));
        }
    }
    if matches!(wanted, Wanted::FirstVertex | Wanted::FirstSpoke) {
        found.extend(keywords(PERIOD));
    }
    let Some((item, at, rule)) = rule_near(snapshot, offset) else { return found };
    let sides = Sketch::of(rule);
    if wanted == Wanted::Statement && side == SideName::After {
        found.extend(open_statements(snapshot, rule));
    }
    for (id, symbol) in snapshot.names().of_rule(item, at) {
        let SymbolKind::Element(Some(kind)) = symbol.kind else { continue };
        if wanted == Wanted::Statement {
            if side == SideName::After && kind == Kind::Vertex {
                let snippet = format!("{}.position = $0", symbol.name);
                let word = format!("{}.position", symbol.name);
                found.push(Completion::new(word, Choice::Field, 6).with(&snippet));
            }
            continue;
        }
        if let Some(rank) = rank(snapshot, (id, symbol, kind), rule, &sides, (side, wanted)) {
            found.push(named(symbol, kind, rank));
        }
    }
    found
}

/// Completions that restate the statements of `before` that `after` does not mention yet.
fn open_statements(snapshot: &Snapshot, rule: &Rule) -> Vec<Completion> {
    let open = left_open(rule).filter_map(|statement| {
        let text = snapshot.sources().slice(statement.span());
        let (head, _) = text.split_once(':')?;
        Some(Completion {
            detail: format!("as in `before`: {text}"),
            ..Completion::new(head.trim_end(), Choice::Keyword, 0).with(text)
        })
    });
    open.collect()
}

/// The rank of a name as a completion: 0 if the statement would account for it and none does yet.
fn rank(
    snapshot: &Snapshot,
    (id, symbol, kind): (SymbolId, &Symbol, Kind),
    rule: &Rule,
    sides: &[Sketch; 2],
    (side, wanted): (SideName, Wanted),
) -> Option<u8> {
    let [before, after] = sides;
    let word = symbol.name.as_str();
    let fate = || element_of(snapshot, id, rule).map(|element| element.fate);
    let is_after = side == SideName::After;
    let own = if is_after { after } else { before };
    let open = |is_open: bool| u8::from(!is_open);
    match (wanted, kind) {
        (Wanted::Face, Kind::Face) => Some(open(own.drawn.iter().all(|d| d.face.word != word))),
        (Wanted::Edge, Kind::Edge) => Some(open(own.pairs.iter().all(|p| p.edge.word != word))),
        (Wanted::StarVertex, Kind::Vertex) => {
            Some(open(own.stars.iter().all(|s| s.vertex.word != word)))
        }
        (Wanted::FirstVertex | Wanted::LoopVertex, Kind::Vertex) => {
            Some(open(!is_after || !own.draws(word)))
        }
        (Wanted::LoopHalfedge, Kind::Halfedge) => {
            let was_outer = before.draws(word) && before.place(word).is_none();
            Some(if was_outer { 3 } else { open(own.place(word).is_none()) })
        }
        (Wanted::Path, Kind::Path) => Some(open(own.place(word).is_none())),
        (Wanted::EdgeHalfedge, Kind::Halfedge) => {
            // In `after`, halfedges that had a twin or are new come first.
            let is_due = !is_after || before.pair(word).is_some() || !before.draws(word);
            Some(open(is_due && own.pair(word).is_none()))
        }
        (Wanted::FirstSpoke | Wanted::Spoke | Wanted::NextSpoke, Kind::Halfedge)
        | (Wanted::Fan, Kind::Fan) => Some(open(own.star_of(word).is_none())),
        (Wanted::New, _) => (fate() == Some(Fate::Unknown)).then_some(0),
        (Wanted::Erase, kind) if !matches!(kind, Kind::Path | Kind::Fan) => match fate() {
            Some(Fate::Forgotten) => Some(0),
            Some(Fate::Kept | Fate::Moved) => Some(7),
            _ => None,
        },
        (Wanted::Keep, kind) if before.is_subject(word) => match (fate(), kind) {
            (Some(Fate::Forgotten), _) => Some(0),
            (Some(Fate::Moved), Kind::Vertex | Kind::Edge | Kind::Face) => Some(7),
            _ => None,
        },
        _ => None,
    }
}
