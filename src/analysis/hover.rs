//! Hovers: information about the place under a cursor.

use std::rc::Rc;

use super::NoExample;
use super::element::{Element, element};
use super::files::touches;
use super::names::{Mention, SymbolId, SymbolKind};
use super::snapshot::Snapshot;
use super::types::type_of;
use super::verdict::Verdict;
use super::words::{Word, word};
use crate::diagram;
use crate::source::Span;
use crate::syntax::TokenKind;
use crate::syntax::tree::{self, Item};

/// A card of information, and the part of the text it is about.
#[derive(Clone, Debug)]
pub struct Hover {
    /// The part of the text.
    pub span: Span,
    /// The information.
    pub card: Card,
}

/// The information about a place.
#[derive(Clone, Debug)]
pub enum Card {
    /// About an op.
    Op(OpCard),
    /// About an element of a drawing.
    Element(Element),
    /// About something else that is declared.
    Declared {
        /// Its head, as it is written.
        head: String,
        /// Its doc comment, a line each.
        docs: Vec<String>,
    },
    /// About a word of the language.
    Word(Word),
}

impl Card {
    /// The doc comment of what is declared, a line each.
    pub fn docs_mut(&mut self) -> Option<&mut Vec<String>> {
        match self {
            Self::Op(op) => Some(&mut op.docs),
            Self::Declared { docs, .. } => Some(docs),
            Self::Element(_) | Self::Word(_) => None,
        }
    }
}

/// An op, in short.
#[derive(Clone, Debug)]
pub struct OpCard {
    /// Its head, as it is written.
    pub head: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// Its diagram, if it could be read in this text or an earlier one; for an op in steps,
    /// examples.
    pub diagram: Option<Rc<diagram::Op>>,
    /// The reason why a proved op in steps has no example.
    pub no_example: Option<NoExample>,
    /// True if the diagram is that of this text; else it is the last one that could be read.
    pub is_current: bool,
    /// The verdict of the proof.
    pub verdict: Verdict,
    /// The errors, a line each.
    pub wrong: Vec<String>,
}

/// The hover at a byte.
pub fn hover(snapshot: &Snapshot, offset: usize) -> Option<Hover> {
    if let Some(mention) = snapshot.names().at(offset)
        && let Some(card) = of_mention(snapshot, mention, offset)
    {
        return Some(Hover { span: mention.span, card });
    }
    let tokens = &snapshot.parsed().tokens;
    let after = tokens.partition_point(|token| token.span.start as usize <= offset);
    let token = tokens[..after].last().filter(|token| token.span.touches(offset))?;
    let opens_op = matches!(
        token.kind,
        TokenKind::Op | TokenKind::Before | TokenKind::After | TokenKind::Rule
    );
    if opens_op && let Some((_, op)) = snapshot.op_at(offset) {
        return Some(Hover { span: token.span, card: Card::Op(op_card(snapshot, op)) });
    }
    let card = Card::Word(word(snapshot.sources().slice(token.span))?);
    let span = token.span;
    Some(Hover { span, card })
}

/// The op whose picture is shown for a byte: the op around it, or the one that is named there.
pub fn op_here(snapshot: &Snapshot, offset: usize) -> Option<&tree::Op> {
    if let Some((_, op)) = snapshot.op_at(offset) {
        return Some(op);
    }
    let mention = snapshot.names().at(offset)?;
    op_named(snapshot, &snapshot.names().symbol(mention.symbol).name)
}

/// The first op of a name, here or in a file that is used.
pub fn op_named<'s>(snapshot: &'s Snapshot, name: &str) -> Option<&'s tree::Op> {
    let (mut items, name) = snapshot.items_for(name);
    items.find_map(|item| match item {
        Item::Op(op) if op.name.text == name => Some(op),
        _ => None,
    })
}

fn of_mention(snapshot: &Snapshot, mention: Mention, offset: usize) -> Option<Card> {
    let symbol = snapshot.names().symbol(mention.symbol);
    match symbol.kind {
        SymbolKind::Op => Some(Card::Op(op_card(snapshot, op_named(snapshot, &symbol.name)?))),
        SymbolKind::Element(_) => {
            let found = element(snapshot, mention.symbol, offset);
            found.map(Card::Element).or_else(|| Some(declared(snapshot, mention.symbol)))
        }
        SymbolKind::Script | SymbolKind::Function | SymbolKind::Attribute => {
            item_card(snapshot, &symbol.name)
        }
        SymbolKind::Rule => {
            let (_, op) = snapshot.op_at(offset)?;
            Some(Card::Op(op_card(snapshot, op)))
        }
        SymbolKind::Parameter | SymbolKind::Index | SymbolKind::Variable => {
            Some(declared(snapshot, mention.symbol))
        }
        SymbolKind::Elsewhere => match op_named(snapshot, &symbol.name) {
            Some(op) => Some(Card::Op(op_card(snapshot, op))),
            None => item_card(snapshot, &symbol.name),
        },
    }
}

fn declared(snapshot: &Snapshot, id: SymbolId) -> Card {
    let symbol = snapshot.names().symbol(id);
    let known = || type_of(snapshot, id).map(|ty| ty.word().to_owned());
    let head = match symbol.ty.clone().or_else(known) {
        Some(ty) => format!("{}: {ty}", symbol.name),
        None => symbol.name.clone(),
    };
    let docs = vec![super::occurrences::a_word(symbol).to_owned()];
    Card::Declared { head, docs }
}

fn item_card(snapshot: &Snapshot, name: &str) -> Option<Card> {
    let (mut items, name) = snapshot.items_for(name);
    let (start, end, docs) = items.find_map(|item| match item {
        Item::Script(script) if script.name.text == name => {
            Some((script.span, script.body.span.start, &script.docs))
        }
        Item::Fn(function) if function.name.text == name => {
            Some((function.span, function.body.span.start, &function.docs))
        }
        Item::Attr(attr) if attr.name.text == name => Some((attr.span, attr.span.end, &attr.docs)),
        _ => None,
    })?;
    let span = Span { end: end.max(start.start), ..start };
    Some(Card::Declared {
        head: snapshot.sources().slice(span).trim_end().to_owned(),
        docs: docs.clone(),
    })
}

/// The information about an op.
pub fn op_card(snapshot: &Snapshot, op: &tree::Op) -> OpCard {
    let verdict = snapshot.verdict(op);
    let wrong = snapshot.diagnostics_so_far();
    let wrong = wrong.iter().filter(|told| told.is_error() && touches(op.span, told.span()));
    let (example, no_example) = match snapshot.example(op) {
        Some(Ok(example)) => (Some(example), None),
        Some(Err(none)) => (None, Some(none)),
        None => (None, None),
    };
    OpCard {
        head: head(snapshot, op),
        docs: op.docs.clone(),
        is_current: example.is_some() || snapshot.is_readable(op),
        diagram: example.or_else(|| snapshot.readable(op)),
        no_example,
        verdict,
        wrong: wrong.map(|told| told.message.clone()).collect(),
    }
}

/// The head of an op, up to its brace, on one line.
pub fn head(snapshot: &Snapshot, op: &tree::Op) -> String {
    let whole = snapshot.sources().slice(op.span);
    let head = whole.split('{').next().unwrap_or(whole).trim_end();
    head.split_whitespace().collect::<Vec<_>>().join(" ")
}
