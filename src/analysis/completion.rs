//! What may come next at a cursor, the likeliest first.

use super::action::statement_span;
use super::element::{Fate, element_of};
use super::names::{Names, SideName, Symbol, SymbolId, SymbolKind};
use super::place::{Place, Start, Wanted, item_near, op_near, place, rule_near};
use super::side::{Sketch, subject};
use super::snapshot::Snapshot;
use super::words::meaning;
use crate::diagram::{Kind, Property, Type};
use crate::library;
use crate::resolve::{fields, function_words, sequence_words, signatures};
use crate::syntax::tree::{Item, Rule, Statement};

/// What a completion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Choice {
    Keyword,
    Type,
    Property,
    Element(Kind),
    Variable,
    Field,
    Function,
    Op,
    File,
}

/// Something that may come next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// The word.
    pub word: String,
    /// What it is.
    pub choice: Choice,
    /// What else is worth seeing beside it; may be empty.
    pub detail: String,
    /// What to write, with places to fill as `$1`, `${2:name}`; the word itself if `None`.
    pub snippet: Option<String>,
    /// The smaller, the likelier.
    pub rank: u8,
}

impl Completion {
    fn new(word: impl Into<String>, choice: Choice, rank: u8) -> Self {
        let word = word.into();
        Self {
            detail: meaning(&word).unwrap_or("").to_owned(),
            word,
            choice,
            snippet: None,
            rank,
        }
    }

    fn with(mut self, snippet: &str) -> Self {
        self.snippet = Some(snippet.to_owned());
        self
    }
}

/// What may come next at a byte.
pub fn completions(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let mut found = match place(snapshot, offset) {
        Place::Top => keywords(TOP),
        Place::Nowhere => Vec::new(),
        Place::Path => library::files()
            .map(|file| Completion::new(file.name, Choice::File, 0))
            .collect(),
        Place::Type => types(),
        Place::Property => Property::ALL
            .map(|property| Completion::new(property.word(), Choice::Property, 0))
            .to_vec(),
        Place::Level => ["surface", "simple"]
            .map(|level| Completion::new(level, Choice::Property, 0))
            .to_vec(),
        Place::Result => drawn(snapshot, offset),
        Place::OpBody => keywords(PARTS),
        Place::Side(side, wanted) => of_side(snapshot, offset, side, wanted),
        Place::Value(start) => values(snapshot, offset, start),
        Place::Field(chain) => of_chain(snapshot, offset, &chain),
    };
    found.sort_by(|left, right| (left.rank, &left.word).cmp(&(right.rank, &right.word)));
    found.dedup_by(|later, first| later.word == first.word);
    found
}

const TOP: &[(&str, &str)] = &[
    (
        "op",
        "op ${1:name}(${2:e}: ${3:edge}) {\n  before {\n    $0\n  }\n  after {\n  }\n}",
    ),
    ("script", "script ${1:name}(${2}) {\n  $0\n}"),
    (
        "fn",
        "fn ${1:name}(${2:e}: ${3:edge}) -> ${4:real} {\n  $0\n}",
    ),
    ("attr", "attr ${1:name}: ${2:vertex} ${3:real} = ${0:0}"),
    ("use", "use \"$0\""),
    ("test", "test \"${1:what holds}\" {\n  $0\n}"),
];

const PARTS: &[(&str, &str)] = &[
    ("before", "before {\n  $0\n}"),
    ("after", "after {\n  $0\n}"),
    ("require", "require ${1:condition} else \"${2:reason}\""),
    ("guard", "guard ${1|surface,simple|}"),
    ("alias", "alias ${1:v2} ${2:v3}"),
    (
        "rule",
        "rule ${1:name} {\n  before {\n    $0\n  }\n  after {\n  }\n}",
    ),
];

const DRAWINGS: &[(&str, &str)] = &[
    (
        "face",
        "face ${1:f}: ${2:v0} -${3:a}-> ${4:v1} -${5:b}-> ${6:v2} -${7:c}-> ${2:v0}",
    ),
    (
        "hole",
        "hole ${1:f}: ${2:v0} -${3:a}-> ${4:v1} =${5:P}=> ${2:v0}",
    ),
    (
        "loop",
        "loop ${1:f}: ${2:v0} -${3:a}-> ${4:v1} =${5:P}=> ${2:v0}",
    ),
    ("edge", "edge ${1:e}: ${2:a} | ${3:d}"),
    ("vertex", "vertex ${1:v}: ${2:a} *${3:S}"),
];

const LISTS: &[(&str, &str)] = &[
    ("new", "new $0"),
    ("erase", "erase $0"),
    ("keep", "keep $0"),
];

const ACTIONS: &[(&str, &str)] = &[
    ("let", "let ${1:x} = $0"),
    ("var", "var ${1:x} = $0"),
    (
        "for",
        "for ${1:e} in ${2:edges} where ${3:condition} { $0 }",
    ),
    ("repeat", "repeat ${1:5} {\n  $0\n}"),
    ("while", "while ${1:condition} {\n  $0\n}"),
    (
        "update",
        "update ${1:v} in ${2:vertices} { ${1:v}.position = $0 }",
    ),
    (
        "drain",
        "drain ${1:e} in ${2:edges} by ${3:key} while ${4:condition} { $0 }",
    ),
    ("if", "if ${1:condition} { $0 }"),
    ("print", "print $0"),
    ("assert", "assert ${1:condition} else \"${2:reason}\""),
    ("must", "must $0"),
    ("return", "return"),
    ("break", "break"),
    ("continue", "continue"),
];

fn keywords(words: &[(&str, &str)]) -> Vec<Completion> {
    let words = words.iter();
    words
        .map(|(word, snippet)| Completion::new(*word, Choice::Keyword, 5).with(snippet))
        .collect()
}

fn types() -> Vec<Completion> {
    let words = [
        "edge", "face", "halfedge", "vertex", "bool", "int", "real", "vec2", "vec3", "mat3",
        "mat4", "text",
    ];
    words
        .map(|word| Completion::new(word, Choice::Type, 0))
        .to_vec()
}

/// The names that an op may return.
fn drawn(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let Some((item, _)) = op_near(snapshot, offset) else {
        return Vec::new();
    };
    let symbols = snapshot.names().symbols();
    let own = symbols.filter(|(_, symbol)| symbol.item == Some(item));
    own.filter_map(|(_, symbol)| match symbol.kind {
        SymbolKind::Element(Some(kind)) if !matches!(kind, Kind::Path | Kind::Fan) => {
            Some(named(symbol, kind, 0))
        }
        _ => None,
    })
    .collect()
}

fn named(symbol: &Symbol, kind: Kind, rank: u8) -> Completion {
    Completion {
        detail: kind.word().to_owned(),
        ..Completion::new(symbol.name.clone(), Choice::Element(kind), rank)
    }
}

/// What a drawing goes on with: names of the kind that fits, those still unaccounted for
/// first, and statements where one may begin.
fn of_side(snapshot: &Snapshot, offset: usize, side: SideName, wanted: Wanted) -> Vec<Completion> {
    let mut found = Vec::new();
    let begins = matches!(
        wanted,
        Wanted::Statement | Wanted::Spoke | Wanted::New | Wanted::Erase | Wanted::Keep
    );
    if begins {
        found.extend(keywords(DRAWINGS));
        if side == SideName::After {
            found.extend(keywords(LISTS));
        }
    }
    let Some((item, at, rule)) = rule_near(snapshot, offset) else {
        return found;
    };
    let sides = Sketch::of(rule);
    if wanted == Wanted::Statement && side == SideName::After {
        found.extend(open_statements(snapshot, rule, &sides[1]));
    }
    for (id, symbol) in snapshot.names().of_rule(item, at) {
        let SymbolKind::Element(Some(kind)) = symbol.kind else {
            continue;
        };
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

/// The statements of `before` about which `after` says nothing yet, to be written again.
fn open_statements(snapshot: &Snapshot, rule: &Rule, after: &Sketch) -> Vec<Completion> {
    let lists = rule.after.iter().flat_map(|side| &side.statements);
    let erased: Vec<&str> = lists
        .filter_map(|statement| match statement {
            Statement::Erase(names, _) => Some(names),
            _ => None,
        })
        .flatten()
        .map(|name| name.ident.text.as_str())
        .collect();
    let statements = rule.before.iter().flat_map(|side| &side.statements);
    let open = statements.filter_map(|statement| {
        let name = &subject(statement)?.ident.text;
        if after.is_subject(name) || erased.contains(&name.as_str()) {
            return None;
        }
        let text = snapshot.sources().slice(statement_span(statement));
        let (head, _) = text.split_once(':')?;
        Some(Completion {
            detail: format!("as in `before`: {text}"),
            ..Completion::new(head.trim_end(), Choice::Keyword, 0).with(text)
        })
    });
    open.collect()
}

/// How likely a name comes next: 0 if the statement accounts for it and nothing does yet.
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
        (Wanted::LoopVertex, Kind::Vertex) => Some(open(!is_after || !own.draws(word))),
        (Wanted::LoopHalfedge, Kind::Halfedge) => {
            let was_outer = before.draws(word) && before.place(word).is_none();
            Some(if was_outer {
                3
            } else {
                open(own.place(word).is_none())
            })
        }
        (Wanted::Path, Kind::Path) => Some(open(own.place(word).is_none())),
        (Wanted::EdgeHalfedge, Kind::Halfedge) => {
            // In `after` those come first that had a twin, or are new.
            let is_due = !is_after || before.pair(word).is_some() || !before.draws(word);
            Some(open(is_due && own.pair(word).is_none()))
        }
        (Wanted::Spoke, Kind::Halfedge) | (Wanted::Fan, Kind::Fan) => {
            Some(open(own.star_of(word).is_none()))
        }
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

/// What a value goes on with.
fn values(snapshot: &Snapshot, offset: usize, start: Start) -> Vec<Completion> {
    let mut found = Vec::new();
    if start == Start::Statement {
        found.extend(keywords(ACTIONS));
    }
    let sequence_rank = if start == Start::Sequence { 0 } else { 4 };
    let sequences = sequence_words();
    found.extend(sequences.map(|word| Completion::new(word, Choice::Variable, sequence_rank)));
    found.extend(variables(snapshot, offset));
    for word in function_words() {
        let forms = signatures(word);
        let detail = forms.first().map_or(String::new(), |way| {
            let gives = way.gives.map(|ty| format!(" -> {}", ty.word()));
            format!("({}){}", way.takes.join(", "), gives.unwrap_or_default())
        });
        let snippet = format!("{word}($1)");
        found.push(Completion {
            detail,
            ..Completion::new(word, Choice::Function, 3).with(&snippet)
        });
    }
    for (_, symbol) in snapshot.names().symbols() {
        let choice = match symbol.kind {
            SymbolKind::Op => Choice::Op,
            SymbolKind::Function => Choice::Function,
            _ => continue,
        };
        let snippet = format!("{}($1)", symbol.name);
        found.push(Completion::new(symbol.name.clone(), choice, 2).with(&snippet));
    }
    for word in ["if", "true", "false", "not", "pi"] {
        found.push(Completion::new(word, Choice::Keyword, 6));
    }
    found
}

/// The variables and parameters of the item around a byte; in an op also what it draws.
fn variables(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let names = snapshot.names();
    let Some((item, node)) = item_near(snapshot, offset) else {
        return Vec::new();
    };
    let is_op = matches!(node, Item::Op(_));
    let rule = rule_near(snapshot, offset).map(|(_, rule, _)| rule);
    let before = |symbol: &Symbol| {
        symbol
            .definition
            .is_some_and(|place| (place.end as usize) < offset)
    };
    let own = names.symbols().filter(|(_, symbol)| {
        symbol.item == Some(item) && (symbol.rule.is_none() || symbol.rule == rule)
    });
    own.filter_map(|(id, symbol)| match symbol.kind {
        SymbolKind::Element(Some(kind)) if is_op && !matches!(kind, Kind::Path | Kind::Fan) => {
            Some(named(symbol, kind, 1))
        }
        SymbolKind::Parameter => Some(variable(snapshot, id, symbol)),
        SymbolKind::Variable if before(symbol) => Some(variable(snapshot, id, symbol)),
        _ => None,
    })
    .collect()
}

fn variable(snapshot: &Snapshot, id: SymbolId, symbol: &Symbol) -> Completion {
    let ty = type_of(snapshot, id).map_or("", Type::word);
    Completion {
        detail: ty.to_owned(),
        ..Completion::new(symbol.name.clone(), Choice::Variable, 1)
    }
}

/// What may stand behind the dot of a chain.
fn of_chain(snapshot: &Snapshot, offset: usize, chain: &[String]) -> Vec<Completion> {
    let Some(ty) = chain_type(snapshot, offset, chain) else {
        return Vec::new();
    };
    let field = |name: &str, ty: Option<Type>, rank| Completion {
        detail: ty.map_or("sequence", Type::word).to_owned(),
        ..Completion::new(name, Choice::Field, rank)
    };
    let mut found: Vec<_> = fields(ty)
        .into_iter()
        .map(|known| field(known.name, known.ty, u8::from(!known.is_attribute)))
        .collect();
    for item in snapshot.items() {
        if let Item::Attr(attr) = item
            && attr.kind.text == ty.word()
        {
            let word = attr.name.text.clone();
            found.push(Completion {
                detail: attr.ty.text.clone(),
                ..Completion::new(word, Choice::Field, 0)
            });
        }
    }
    found
}

fn chain_type(snapshot: &Snapshot, offset: usize, chain: &[String]) -> Option<Type> {
    let (first, rest) = chain.split_first()?;
    let (item, _) = item_near(snapshot, offset)?;
    let names: &Names = snapshot.names();
    // Of several variables of a name, the last before the cursor is the likeliest.
    let symbol = names
        .symbols()
        .filter(|(_, symbol)| {
            let is_before = symbol
                .definition
                .is_none_or(|place| (place.start as usize) < offset);
            symbol.name == *first && symbol.item == Some(item) && is_before
        })
        .last();
    let mut ty = type_of(snapshot, symbol?.0)?;
    for word in rest {
        let known = fields(ty).into_iter().find(|field| field.name == word)?;
        ty = known.ty?;
    }
    Some(ty)
}

/// The type of what a name stands for, as far as it is known.
pub fn type_of(snapshot: &Snapshot, id: SymbolId) -> Option<Type> {
    let symbol = snapshot.names().symbol(id);
    let named = |word: &str| Type::ALL.into_iter().find(|ty| ty.word() == word);
    if let Some(ty) = &symbol.ty {
        return named(ty);
    }
    if let SymbolKind::Element(Some(kind)) = symbol.kind {
        return named(kind.word());
    }
    let place = symbol.definition?;
    for script in &snapshot.program().scripts {
        if let Some(known) = script.variables.iter().find(|known| known.span == place) {
            return Some(known.ty);
        }
    }
    // `for e in edges`: also where the script cannot be read.
    let tokens = &snapshot.parsed().tokens;
    let at = tokens.iter().position(|token| token.span == place)?;
    let sequence = tokens.get(at + 2..)?;
    let words = sequence
        .iter()
        .map(|token| snapshot.sources().slice(token.span));
    words
        .zip(sequence)
        .take_while(|(_, token)| {
            token.kind.is_wordlike() || token.kind == crate::syntax::TokenKind::Dot
        })
        .map(|(word, _)| word)
        .filter(|word| *word != ".")
        .find_map(|word| match word {
            "vertices" | "neighbors" => Some(Type::Vertex),
            "halfedges" => Some(Type::Halfedge),
            "edges" => Some(Type::Edge),
            "faces" | "holes" => Some(Type::Face),
            _ => None,
        })
}
