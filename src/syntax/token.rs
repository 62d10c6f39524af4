//! The tokens of the language, recognized by one automaton.
//!
//! Keywords are looked up after a word has been recognized, and what directly follows a number is
//! recognized on its own: an automaton for all of this would have five times as many states, each
//! of which takes time to compile.
//!
//! A [`Token`] is a kind and a span; its text is read from the source when it is needed. Keywords
//! are not names, but the parser accepts some of them where no statement can begin: after a dot, as
//! a type, and, for the few that are [soft](TokenKind::is_soft), as any name.

use crate::source::Span;
use logos::{Lexer, Logos};
use std::fmt;

/// A token and its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    pub kind: TokenKind,
    pub span: Span,
}

/// Declares the token kinds: keywords, marks of fixed spelling, and the rest.
macro_rules! token_kinds {
    (
        keywords { $($word:literal $keyword:ident)* }
        marks { $($mark:literal $name:ident)* }
    ) => {
        #[derive(Logos, Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[logos(skip r"[ \t\r\n\x0C\u{FEFF}]+")]
        #[repr(u8)]
        pub enum TokenKind {
            $($keyword,)*
            $(#[token($mark)] $name,)*
            /// A name, perhaps with primes.
            #[regex(r"[\p{XID_Start}_]\p{XID_Continue}*'*", TokenKind::of_word)]
            Word,
            /// `12`
            #[regex(r"[0-9]+", |lexer| number(lexer, TokenKind::Int))]
            Int,
            /// `0.5`, `1e-3`
            #[regex(
                r"[0-9]+\.[0-9]+([eE][+-]?[0-9]+)?|[0-9]+[eE][+-]?[0-9]+",
                |lexer| number(lexer, TokenKind::Real)
            )]
            Real,
            /// A number directly followed by a name, `2x`, or by a point too many: `5.`, `1.2.3`.
            BadNumber,
            /// A sign, comment, text or number in foreign syntax; no rule of the grammar accepts
            /// it.
            #[regex(r"[;!%^?&~`∧∨¬≤≥≠×·⋅÷∗−–—─→⟶➔⇒…∈\u{A0}\u{2007}\u{202F}\u{3000}]|&&", priority = 1)]
            #[regex(r"#[^\n]*", allow_greedy = true)]
            #[regex(r"/\*([^*]|\*+[^*/])*\*+/")]
            #[regex(r"'[^'\r\n]*'")]
            #[regex(r"'", quote)]
            #[regex(r"“[^”\r\n]*”")]
            #[regex(r"`[^`\r\n]*`")]
            #[regex(r"\.[0-9]+")]
            Foreign,
            /// `"text"`
            #[regex(r#""([^"\\\r\n]|\\[^\r\n])*""#)]
            Text,
            /// A text up to its first value: `"mean {`. The automaton recognizes whole texts only;
            /// the lexer cuts those with embedded values.
            TextHead,
            /// The text between two values of a text: `:.3} and {`.
            TextMiddle,
            /// The text after the last value of a text: `}."`.
            TextTail,
            /// A text whose line ends before its closing quote.
            #[regex(r#""([^"\\\r\n]|\\[^\r\n])*\\?"#)]
            OpenText,
            /// `// …`, `/// …`, `//! …`; never reaches the parser.
            #[regex(r"//[^\n]*", allow_greedy = true)]
            Comment,
        }

        impl TokenKind {
            /// Every keyword with its spelling, in the order of the reference.
            pub const KEYWORDS: &[(&str, Self)] = &[$(($word, Self::$keyword)),*];

            /// The tokens of fixed spelling that are not words.
            pub const MARKS: &[(&str, Self)] = &[$(($mark, Self::$name)),*];

            /// The keyword that is recognized, or a name.
            fn of_word(lexer: &mut Lexer<'_, Self>) -> Self {
                match lexer.slice() {
                    $($word => Self::$keyword,)*
                    _ => Self::Word,
                }
            }

            /// The spelling, where there is only one.
            pub fn spelling(self) -> Option<&'static str> {
                match self {
                    $(Self::$keyword => Some($word),)*
                    $(Self::$name => Some($mark),)*
                    _ => None,
                }
            }

            /// True if it is a keyword.
            pub fn is_keyword(self) -> bool {
                matches!(self, $(Self::$keyword)|*)
            }
        }
    };
}

token_kinds! {
    keywords {
        "use" Use "private" Private "attr" Attr "fn" Fn "op" Op "script" Script "test" Test
        "keeps" Keeps "rule" Rule "before" Before "require" Require "guard" Guard "alias" Alias
        "after" After
        "steps" Steps
        "face" Face "hole" Hole "loop" Loop "edge" Edge "vertex" Vertex
        "each" Each "new" New "keep" Keep "erase" Erase
        "let" Let "var" Var "if" If "else" Else "repeat" Repeat "parallel" Parallel "for" For "in" In
        "where" Where "while" While "drain" Drain "by" By "update" Update
        "must" Must "can" Can "why" Why "print" Print "assert" Assert
        "return" Return "break" Break "continue" Continue
        "and" And "or" Or "not" Not "div" Div "mod" Mod "true" True "false" False
    }
    marks {
        "{" LeftBrace "}" RightBrace "(" LeftParen ")" RightParen "[" LeftBracket "]" RightBracket
        ":" Colon "::" DoubleColon "," Comma "." Dot ".." DotDot "|" Bar
        "->" Arrow "=>" FatArrow "=" Equals
        "+" Plus "-" Minus "*" Star "/" Slash
        "==" Equal "!=" NotEqual "<" Less "<=" LessEqual ">" Greater ">=" GreaterEqual
    }
}

/// A number of the given kind, unless it is directly followed by a word or a point too many.
fn number(lexer: &mut Lexer<'_, TokenKind>, kind: TokenKind) -> TokenKind {
    if takes_word(lexer) || takes_point(lexer) { TokenKind::BadNumber } else { kind }
}

/// Lengthens a number by a point that directly follows, with the digits and points behind it; but
/// not by the points of a range, or the point before a field.
fn takes_point(lexer: &mut Lexer<'_, TokenKind>) -> bool {
    let Some(behind) = lexer.remainder().strip_prefix('.') else { return false };
    if behind.starts_with(|c: char| c == '.' || c == '_' || c.is_alphabetic()) {
        return false;
    }
    let digits = behind.len() - behind.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    lexer.bump(1 + digits);
    true
}

/// A word in foreign syntax, of which the quote is recognized.
fn quote(lexer: &mut Lexer<'_, TokenKind>) -> Result<TokenKind, ()> {
    if takes_word(lexer) { Ok(TokenKind::Foreign) } else { Err(()) }
}

/// Lengthens a token by the word that directly follows, if there is one.
fn takes_word(lexer: &mut Lexer<'_, TokenKind>) -> bool {
    let following = lexer.remainder();
    if !following.starts_with(|c: char| c.is_alphabetic() || c == '_') {
        return false;
    }
    let mut word = TokenKind::lexer(following);
    let is_word = word.next().is_some_and(|kind| kind.is_ok_and(TokenKind::is_wordlike));
    if is_word {
        lexer.bump(word.slice().len());
    }
    is_word
}

impl TokenKind {
    /// True if it is spelled like a name: a name or any keyword.
    pub fn is_wordlike(self) -> bool {
        self == Self::Word || self.is_keyword()
    }

    /// True if it is a keyword that may also be a name, since it is special in one place only:
    /// `test` before a text, `private` before an item, `by` after a sequence, `steps` in an op,
    /// `parallel` before `for`.
    pub fn is_soft(self) -> bool {
        matches!(self, Self::Test | Self::Private | Self::By | Self::Steps | Self::Parallel)
    }

    /// True if it can be used as a name.
    pub fn is_name(self) -> bool {
        self == Self::Word || self.is_soft()
    }

    /// True if it is an operator that compares two values.
    pub fn is_comparison(self) -> bool {
        use TokenKind::*;
        matches!(self, Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual)
    }

    /// True if it is an operator between two values.
    pub fn is_binary(self) -> bool {
        use TokenKind::*;
        self.is_comparison() || matches!(self, Plus | Minus | Star | Slash | Div | Mod | And | Or)
    }

    /// True if a statement of a drawing begins with it.
    pub fn begins_drawing_statement(self) -> bool {
        use TokenKind::*;
        matches!(self, Face | Hole | Loop | Edge | Vertex | New | Keep | Erase)
    }
}

impl fmt::Display for TokenKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word => f.write_str("a name"),
            Self::Int => f.write_str("an int"),
            Self::Real => f.write_str("a real"),
            Self::BadNumber => f.write_str("a number"),
            Self::Text | Self::OpenText => f.write_str("a text in quotes"),
            Self::TextHead => f.write_str("a text with values in it"),
            Self::TextMiddle | Self::TextTail => f.write_str("the end of a value in a text"),
            Self::Foreign => f.write_str("a sign of another language"),
            Self::Comment => f.write_str("a comment"),
            fixed => write!(f, "`{}`", fixed.spelling().unwrap_or_default()),
        }
    }
}
