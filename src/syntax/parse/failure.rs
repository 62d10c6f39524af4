//! Parse failures, small enough to be constructed at every token.
//!
//! The parser constructs one for each alternative that it abandons, so the expected tokens are kept
//! as two bit sets. `report` produces words later, for the few failures that remain.

use super::input::Tokens;
use crate::source::Span;
use crate::syntax::token::TokenKind;
use chumsky::DefaultExpected;
use chumsky::error::{Error, LabelError};
use chumsky::util::MaybeRef;

/// A phrase for something expected other than a specific token, in the order of messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Phrase {
    Item,
    Part,
    Name,
    Type,
    Parameter,
    Arrow,
    Spoke,
    Halfedge,
    Vertex,
    Index,
    Value,
    DrawingStatement,
    Statement,
    Text,
    /// An operator; mentioned only if nothing else is expected.
    Operator,
    /// A subscript or a field after a name; mentioned only if nothing else is expected.
    Subscript,
}

impl Phrase {
    /// All, each with its words, one entry for each way to write it.
    const ALL: [(Self, &[&str]); 16] = [
        (Self::Item, &["`op`", "`script`", "`fn`", "`attr`", "`use`", "`test`"]),
        (Self::Part, &["`before`", "`require`", "`guard`", "`alias`", "`after`"]),
        (Self::Name, &["a name"]),
        (Self::Type, &["a type"]),
        (Self::Parameter, &["a parameter like `e: edge`"]),
        (Self::Arrow, &["`-h->`", "`=P=>`"]),
        (Self::Spoke, &["a spoke"]),
        (Self::Halfedge, &["a halfedge"]),
        (Self::Vertex, &["a vertex"]),
        (Self::Index, &["an index like `i+1`"]),
        (Self::Value, &["a value"]),
        (Self::DrawingStatement, &["a statement"]),
        (Self::Statement, &["a statement"]),
        (Self::Text, &["a text in quotes"]),
        (Self::Operator, &["an operator"]),
        (Self::Subscript, &["a subscript"]),
    ];

    /// True if it is mentioned only if nothing else is expected.
    pub(super) fn is_weak(self) -> bool {
        matches!(self, Self::Operator | Self::Subscript)
    }

    /// Its words, one entry for each way to write it.
    pub(super) fn words(self) -> &'static [&'static str] {
        Self::ALL[self as usize].1
    }
}

/// A set of tokens and phrases.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Wanted {
    tokens: u128,
    phrases: u32,
}

impl Wanted {
    fn add(&mut self, other: Self) {
        self.tokens |= other.tokens;
        self.phrases |= other.phrases;
    }

    fn phrase(phrase: Phrase) -> Self {
        let phrases = 1 << phrase as u32;
        Self { tokens: 0, phrases }
    }

    /// True if the set contains this token.
    pub(super) fn has(self, kind: TokenKind) -> bool {
        self.tokens >> kind as u32 & 1 == 1
    }

    /// The phrases, in order.
    pub(super) fn phrases(self) -> impl Iterator<Item = Phrase> {
        let all = Phrase::ALL.into_iter().map(|(phrase, _)| phrase);
        all.filter(move |&phrase| self.phrases >> phrase as u32 & 1 == 1)
    }

    /// The tokens of fixed spelling, in order.
    pub(super) fn tokens(self) -> impl Iterator<Item = TokenKind> {
        let kinds = TokenKind::KEYWORDS.iter().chain(TokenKind::MARKS).map(|&(_, kind)| kind);
        kinds.filter(move |&kind| self.has(kind))
    }
}

/// A mistake with its own message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mistake {
    /// `a < b < c`, with the span of `b`.
    ChainedComparison(Span),
    /// `before` or `after` twice in one rule, with the span of the first.
    TwiceDrawn(Span),
    /// A part in the wrong place, with the message.
    Misplaced(&'static str),
    /// `v[i](…)`: a function has no subscript.
    CalledFamily,
    /// A qualified name that is not called.
    QualifiedName,
    /// `"a {b}"` outside of `print`.
    ValuesInText,
    /// `{x:…}` with an unknown format.
    UnknownFormat,
    /// `elif` in place of `else if`.
    ElseIf,
    /// A parameter without a type.
    Untyped,
    /// The path of a `use` without quotes.
    BarePath,
    /// `edge e: a | null`: every halfedge has a twin.
    NoTwin,
    /// `rule` next to drawings that are in no rule.
    RuleAmongParts,
}

/// The reason why a rule failed.
#[derive(Clone, Debug)]
pub(super) struct Failure {
    /// The place.
    pub span: Span,
    /// The token there; `None` at the end of the item.
    pub found: Option<TokenKind>,
    /// The tokens and phrases that were expected there.
    pub wanted: Wanted,
    /// The span of the statement or header in which the failure occurred.
    pub context: Option<Span>,
    /// The mistake, if the failure is not just an unexpected token.
    pub mistake: Option<Mistake>,
}

impl Failure {
    /// A failure of unknown cause.
    pub(super) fn at(span: Span) -> Self {
        Self { span, found: None, wanted: Wanted::default(), context: None, mistake: None }
    }

    /// A mistake with its own message.
    pub(super) fn mistake(mistake: Mistake, span: Span) -> Self {
        let mistake = Some(mistake);
        Self { mistake, ..Self::at(span) }
    }
}

impl<'t> Error<'t, Tokens<'t>> for Failure {
    fn merge(mut self, other: Self) -> Self {
        self.wanted.add(other.wanted);
        self.context = self.context.or(other.context);
        self.mistake = self.mistake.or(other.mistake);
        self
    }
}

impl<'t> LabelError<'t, Tokens<'t>, DefaultExpected<'t, TokenKind>> for Failure {
    fn expected_found<E: IntoIterator<Item = DefaultExpected<'t, TokenKind>>>(
        expected: E,
        found: Option<MaybeRef<'t, TokenKind>>,
        span: Span,
    ) -> Self {
        let mut wanted = Wanted::default();
        for one in expected {
            if let DefaultExpected::Token(kind) = one {
                wanted.tokens |= 1 << *kind as u32;
            }
        }
        let found = found.map(|kind| *kind);
        Self { found, wanted, ..Self::at(span) }
    }
}

impl<'t> LabelError<'t, Tokens<'t>, Phrase> for Failure {
    fn expected_found<E: IntoIterator<Item = Phrase>>(
        expected: E,
        found: Option<MaybeRef<'t, TokenKind>>,
        span: Span,
    ) -> Self {
        let mut wanted = Wanted::default();
        for phrase in expected {
            wanted.add(Wanted::phrase(phrase));
        }
        let found = found.map(|kind| *kind);
        Self { found, wanted, ..Self::at(span) }
    }

    fn label_with(&mut self, label: Phrase) {
        self.wanted = Wanted::phrase(label);
    }

    fn in_context(&mut self, _label: Phrase, span: Span) {
        self.context = self.context.or(Some(span));
    }
}

/// Every token kind has a bit in [`Wanted`].
const _: () = assert!((TokenKind::Comment as u32) < u128::BITS);
