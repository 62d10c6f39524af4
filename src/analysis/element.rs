//! An element of a drawing: its pointers before and after, and its fate.

use super::names::{List, Role, SymbolId, SymbolKind};
use super::side::{ElementRef, Sketch};
use super::snapshot::Snapshot;
use crate::diagram::Kind;
use crate::source::Span;
use crate::syntax::tree::{Item, Rule};

/// The fate of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fate {
    /// It is the same on both sides.
    Kept,
    /// It is on both sides, with different pointers.
    Moved,
    /// It is created.
    New,
    Erased,
    /// It is drawn in `before`; `after` does not account for it.
    Forgotten,
    /// It is drawn in `after`; it is neither drawn in `before` nor listed as new.
    Unknown,
}

impl Fate {
    pub fn word(self) -> &'static str {
        match self {
            Fate::Kept => "kept",
            Fate::Moved => "moved",
            Fate::New => "new",
            Fate::Erased => "erased",
            Fate::Forgotten => "not accounted for in `after`",
            Fate::Unknown => "neither in `before` nor in `new`",
        }
    }
}

/// A pointer, or another property, on both sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pointer {
    /// The word of the pointer: `next`, `twin`, …
    pub name: &'static str,
    /// Its value before, as it is written.
    pub before: String,
    /// Its value after.
    pub after: String,
}

/// An element of a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    pub name: String,
    pub kind: Kind,
    /// True if it is a halfedge known only as the twin of one that is drawn.
    pub is_outer: bool,
    pub fate: Fate,
    pub pointers: Vec<Pointer>,
    /// The rule, where it has a name.
    pub rule: Option<String>,
}

/// The value of a pointer that leads out of the drawing.
const OUTSIDE: &str = "outside";
const NOTHING: &str = "";

/// The element of a name, in the rule that covers `offset`; for a parameter in the head of the op,
/// in the first rule that draws it.
pub fn element(snapshot: &Snapshot, symbol: SymbolId, offset: usize) -> Option<Element> {
    let rule = match snapshot.rule_at(offset) {
        Some((item, rule, op)) => {
            let own = snapshot.names().symbol(symbol);
            (own.item == Some(item) && own.rule.is_none_or(|of| of == rule))
                .then_some(&op.rules[rule])?
        }
        None => first_rule(snapshot, symbol)?,
    };
    element_of(snapshot, symbol, rule)
}

fn first_rule(snapshot: &Snapshot, symbol: SymbolId) -> Option<&Rule> {
    let item = snapshot.names().symbol(symbol).item?;
    let Item::Op(op) = &snapshot.items()[item] else { return None };
    let word = &snapshot.names().symbol(symbol).name;
    let draws = |rule: &&Rule| Sketch::of(rule).iter().any(|side| side.draws(word));
    op.rules.iter().find(draws)
}

/// The element of a name, in one rule.
pub fn element_of(snapshot: &Snapshot, symbol: SymbolId, rule: &Rule) -> Option<Element> {
    let own = snapshot.names().symbol(symbol);
    let SymbolKind::Element(Some(kind)) = own.kind else { return None };
    let sides = Sketch::of(rule);
    let [before, after] = &sides;
    let word = own.name.as_str();
    let pointers = pointers(kind, word, &sides);
    let fate = match listed(snapshot, symbol, rule.span) {
        (true, _) => Fate::New,
        (_, true) => Fate::Erased,
        _ => match (before.draws(word), after.draws(word)) {
            (true, false) => Fate::Forgotten,
            (false, true) => Fate::Unknown,
            (false, false) => return None,
            // The spokes of a vertex are not part of it.
            _ if kind == Kind::Vertex => Fate::Kept,
            _ if pointers.iter().all(|pointer| pointer.before == pointer.after) => Fate::Kept,
            _ => Fate::Moved,
        },
    };
    let pointers = pointers.into_iter().map(|mut pointer| {
        match fate {
            Fate::New => pointer.before = NOTHING.into(),
            Fate::Erased => pointer.after = NOTHING.into(),
            _ => {}
        }
        pointer
    });
    Some(Element {
        name: own.name.clone(),
        kind,
        is_outer: kind == Kind::Halfedge && before.draws(word) && before.place(word).is_none(),
        fate,
        pointers: pointers.collect(),
        rule: rule.name.as_ref().map(|name| name.text.clone()),
    })
}

/// Whether a rule lists a name in `new`, and whether in `erase`.
pub fn listed(snapshot: &Snapshot, symbol: SymbolId, rule: Span) -> (bool, bool) {
    let mentions = || {
        snapshot
            .names()
            .mentions_of(symbol)
            .filter(|mention| rule.touches(mention.span.start as usize))
    };
    let is_in = |list| mentions().any(|mention| mention.role == Role::Listed(list));
    (is_in(List::New), is_in(List::Erase))
}

fn pointers(kind: Kind, word: &str, sides: &[Sketch; 2]) -> Vec<Pointer> {
    let both = |name, value: &dyn Fn(&Sketch) -> String| Pointer {
        name,
        before: value(&sides[0]),
        after: value(&sides[1]),
    };
    match kind {
        Kind::Halfedge => halfedge(word, sides),
        Kind::Path => vec![
            both("loop", &|side| in_loop(side, word, |drawn| &drawn.face)),
            both("starts at", &|side| in_loop(side, word, |drawn| &drawn.from)),
            both("ends at", &|side| in_loop(side, word, |drawn| &drawn.to)),
        ],
        Kind::Fan => vec![both("vertex", &|side| text(side.star_of(word)))],
        Kind::Edge => vec![
            both("halfedges", &|side| twins(side, word)),
            both("ends", &|side| ends(side, sides, word)),
        ],
        Kind::Face => vec![both("loop", &|side| around(side, word))],
        Kind::Vertex => vec![
            both("spokes", &|side| star(side, word)),
            both("leaving", &|side| leaving(side, word)),
        ],
    }
}

fn text(place: Option<ElementRef>) -> String {
    place.map_or(NOTHING.into(), |place| place.text())
}

fn in_loop(side: &Sketch, word: &str, part: impl Fn(&super::side::Drawn) -> &ElementRef) -> String {
    side.place(word).map_or(NOTHING.into(), |drawn| part(&drawn).text())
}

fn halfedge(word: &str, sides: &[Sketch; 2]) -> Vec<Pointer> {
    let [before, _] = sides;
    // A pointer that a side does not set keeps its value; that of an outer halfedge leads outside.
    let stays = |value: String, was: &dyn Fn(&Sketch) -> String, side: &Sketch| {
        if !value.is_empty() || !side.draws(word) {
            return value;
        }
        match was(before) {
            was if was.is_empty() => OUTSIDE.into(),
            was => was,
        }
    };
    type Value<'a> = &'a dyn Fn(&Sketch) -> String;
    let pointer = |name, value: Value| Pointer {
        name,
        before: stays(value(before), value, before),
        after: stays(value(&sides[1]), value, &sides[1]),
    };
    let run = |place: &ElementRef| match place.word.as_str() {
        "" => "the path".to_owned(),
        _ => place.text(),
    };
    let looped = |side: &Sketch, part: &dyn Fn(&super::side::Drawn) -> ElementRef| {
        side.place(word).map_or(NOTHING.into(), |drawn| run(&part(&drawn)))
    };
    vec![
        pointer("next", &|side| looped(side, &|drawn| drawn.next.clone())),
        pointer("prev", &|side| looped(side, &|drawn| drawn.prev.clone())),
        pointer("twin", &|side| text(side.pair(word).map(|(_, twin)| twin))),
        pointer("vertex", &|side| text(side.origin(word))),
        pointer("edge", &|side| text(side.pair(word).map(|(edge, _)| edge))),
        pointer("face", &|side| looped(side, &|drawn| drawn.face.clone())),
    ]
}

fn twins(side: &Sketch, word: &str) -> String {
    let pair = side.pairs.iter().find(|pair| pair.edge.word == word);
    pair.map_or(NOTHING.into(), |pair| {
        let [left, right] = &pair.halfedges;
        format!("{} | {}", left.text(), right.text())
    })
}

fn ends(side: &Sketch, sides: &[Sketch; 2], word: &str) -> String {
    let Some(pair) = side.pairs.iter().find(|pair| pair.edge.word == word) else {
        return NOTHING.into();
    };
    let origin = |halfedge: &ElementRef| {
        let own = side.origin(&halfedge.word);
        text(own.or_else(|| sides[0].origin(&halfedge.word)))
    };
    let [left, right] = pair.halfedges.each_ref().map(origin);
    if left.is_empty() && right.is_empty() {
        return NOTHING.into();
    }
    let shown = |end: String| if end.is_empty() { OUTSIDE.into() } else { end };
    format!("{} {}", shown(left), shown(right))
}

/// The loop of a face, starting at the halfedge whose name sorts first, so that the same cycle
/// always reads the same.
fn around(side: &Sketch, word: &str) -> String {
    let mut items: Vec<_> = side.drawn.iter().filter(|drawn| drawn.face.word == word).collect();
    if items.is_empty() {
        return NOTHING.into();
    }
    let first =
        (0..items.len()).min_by_key(|&at| (items[at].item.word.is_empty(), items[at].item.text()));
    items.rotate_left(first.unwrap_or(0));
    let each = items.iter().map(|drawn| match drawn.item.word.as_str() {
        "" => format!("{} =>", drawn.from.text()),
        _ => format!("{} {}", drawn.from.text(), drawn.item.text()),
    });
    each.collect::<Vec<_>>().join(" ")
}

fn star(side: &Sketch, word: &str) -> String {
    let star = side.stars.iter().find(|star| star.vertex.word == word);
    star.map_or(NOTHING.into(), |star| star.text.clone())
}

/// The drawn halfedges and paths that leave a vertex.
fn leaving(side: &Sketch, word: &str) -> String {
    let own = side.drawn.iter().filter(|drawn| drawn.from.word == word);
    let mut names: Vec<_> =
        own.filter(|drawn| !drawn.item.word.is_empty()).map(|drawn| drawn.item.text()).collect();
    names.sort();
    names.join(" ")
}
