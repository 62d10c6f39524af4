//! Semantic tokens: the class of each word of a text, to colour it.

use std::collections::HashSet;

use super::element::listed;
use super::names::{Mention, Role, SymbolKind};
use super::side::Sketch;
use super::snapshot::Snapshot;
use crate::diagram::Kind;
use crate::resolve::is_function;
use crate::source::Span;
use crate::syntax::tree::{ActionKind, Block, Item};
use crate::syntax::{CommentKind, Part, TokenKind};

/// The class of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    Keyword,
    Type,
    Op,
    Script,
    Function,
    Attribute,
    Rule,
    Element(Option<Kind>),
    Parameter,
    Index,
    Variable,
    Field,
    Property,
    Number,
    Text,
    Comment,
    Operator,
}

/// The modifiers of a word.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// It declares its name.
    pub declares: bool,
    /// It is part of the language.
    pub is_built_in: bool,
    /// It documents something.
    pub documents: bool,
    /// It is made by the op.
    pub is_new: bool,
    /// It is erased by the op.
    pub is_erased: bool,
    /// It is known only as a twin.
    pub is_outer: bool,
}

/// A word with its class and modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coloured {
    /// The word. Only a text that is not closed or a comment with a lone `\r` may span lines.
    pub span: Span,
    pub class: Class,
    /// Its modifiers.
    pub marks: Marks,
}

/// All words of a text, in order.
pub fn tokens(snapshot: &Snapshot) -> Vec<Coloured> {
    let types = type_spans(snapshot);
    let properties = property_spans(snapshot);
    let mut rules = Rules { snapshot, known: None };
    let mut coloured = Vec::new();
    let mut last = None;
    for token in &snapshot.parsed().tokens {
        let after_dot = last == Some(TokenKind::Dot);
        last = Some(token.kind);
        let plain = |class| Some((class, Marks::default()));
        let mention = snapshot
            .names()
            .at(token.span.start as usize)
            .filter(|mention| mention.span == token.span);
        let found = if types.contains(&token.span) {
            plain(Class::Type)
        } else if properties.contains(&token.span) {
            plain(Class::Property)
        } else if let Some(mention) = mention {
            Some(rules.named(mention))
        } else if token.kind.is_wordlike() && after_dot {
            plain(Class::Field)
        } else if token.kind.is_keyword() {
            plain(Class::Keyword)
        } else {
            match token.kind {
                TokenKind::Word if is_function(snapshot.sources().slice(token.span)) => {
                    Some((Class::Function, Marks { is_built_in: true, ..Marks::default() }))
                }
                TokenKind::Word => plain(Class::Variable),
                TokenKind::Int | TokenKind::Real | TokenKind::BadNumber => plain(Class::Number),
                TokenKind::Text
                | TokenKind::TextHead
                | TokenKind::TextMiddle
                | TokenKind::TextTail
                | TokenKind::OpenText => plain(Class::Text),
                TokenKind::Arrow | TokenKind::FatArrow | TokenKind::Bar | TokenKind::Star => {
                    plain(Class::Operator)
                }
                _ => None,
            }
        };
        coloured.extend(found.map(|(class, marks)| Coloured { span: token.span, class, marks }));
    }
    let comments = snapshot.parsed().comments.iter().map(|comment| Coloured {
        span: comment.span,
        class: Class::Comment,
        marks: Marks { documents: comment.kind != CommentKind::Plain, ..Marks::default() },
    });
    coloured.extend(comments);
    coloured.sort_by_key(|token| token.span);
    coloured
}

/// The rule around the current mention, read once.
struct Rules<'s> {
    snapshot: &'s Snapshot,
    known: Option<(Span, Sketch)>,
}

impl Rules<'_> {
    fn named(&mut self, mention: Mention) -> (Class, Marks) {
        let symbol = self.snapshot.names().symbol(mention.symbol);
        let mut marks =
            Marks { declares: symbol.definition == Some(mention.span), ..Marks::default() };
        let class = match symbol.kind {
            SymbolKind::Op => Class::Op,
            SymbolKind::Rule => Class::Rule,
            SymbolKind::Script => Class::Script,
            SymbolKind::Function | SymbolKind::Elsewhere => Class::Function,
            SymbolKind::Attribute => Class::Attribute,
            SymbolKind::Parameter => Class::Parameter,
            SymbolKind::Index => Class::Index,
            SymbolKind::Variable => Class::Variable,
            SymbolKind::Element(kind) => {
                self.element(mention, kind, &mut marks);
                match (mention.role, &symbol.ty) {
                    (Role::Declared, Some(_)) => Class::Parameter,
                    _ => Class::Element(kind),
                }
            }
        };
        (class, marks)
    }

    fn element(&mut self, mention: Mention, kind: Option<Kind>, marks: &mut Marks) {
        let snapshot = self.snapshot;
        let Some((rule, before)) = self.rule(mention.span) else { return };
        let word = &snapshot.names().symbol(mention.symbol).name;
        marks.is_outer = kind == Some(Kind::Halfedge)
            && before.pair(word).is_some()
            && before.place(word).is_none();
        (marks.is_new, marks.is_erased) = listed(snapshot, mention.symbol, rule);
    }

    /// The rule around a mention, and its side before.
    fn rule(&mut self, at: Span) -> Option<(Span, &Sketch)> {
        let offset = at.start as usize;
        let is_known = self.known.as_ref().is_some_and(|(span, _)| span.touches(offset));
        if !is_known {
            let (_, rule, op) = self.snapshot.rule_at(offset)?;
            let rule = &op.rules[rule];
            let [before, _] = Sketch::of(rule);
            self.known = Some((rule.span, before));
        }
        self.known.as_ref().map(|(span, before)| (*span, before))
    }
}

/// The places where a type is written.
fn type_spans(snapshot: &Snapshot) -> HashSet<Span> {
    let mut spans = HashSet::new();
    for item in snapshot.items() {
        let (params, body): (&[_], Option<&Block>) = match item {
            Item::Op(op) => {
                let result = op.result.as_ref().filter(|_| op.steps.is_some());
                spans.extend(result.map(|result| result.span));
                (&op.params, op.steps.as_ref().map(|steps| &steps.body))
            }
            Item::Script(script) => (&script.params, Some(&script.body)),
            Item::Fn(function) => {
                spans.extend(function.result.as_ref().map(|result| result.span));
                (&function.params, Some(&function.body))
            }
            Item::Test(test) => (&[], Some(&test.body)),
            Item::Attr(attr) => {
                spans.extend([attr.kind.span, attr.ty.span]);
                (&[], None)
            }
            Item::Use(_) | Item::Broken(_) => (&[], None),
        };
        spans.extend(params.iter().map(|param| param.ty.span));
        body.into_iter().for_each(|body| declared_types(body, &mut spans));
    }
    spans
}

/// The types that `let` and `var` declare, at any depth.
fn declared_types(block: &Block, spans: &mut HashSet<Span>) {
    Part::Block(block).each_within(|part| {
        let Part::Block(block) = part else { return };
        for action in &block.statements {
            if let ActionKind::Let { ty: Some(ty), .. } = &action.kind {
                spans.insert(ty.span);
            }
        }
    });
}

/// The places where `keeps` names a property.
fn property_spans(snapshot: &Snapshot) -> HashSet<Span> {
    let ops = snapshot.items().iter().filter_map(Item::op);
    ops.flat_map(|op| &op.keeps).map(|property| property.span).collect()
}
