//! The tokens of an item, and the place of each in the program.

use super::finding::Found;
use super::misspelt::is_misspelt;
use crate::source::Span;
use crate::syntax::token::{Token, TokenKind as T};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// A set of places in a program, as bits.
pub(super) type Places = u8;

/// Outside all items, or in the head of one.
pub(super) const HEAD: Places = 1;
/// Among the parts of an op or a rule.
pub(super) const PARTS: Places = 2;
/// In `before` or `after`.
pub(super) const DRAWING: Places = 4;
/// In a block of statements.
pub(super) const CODE: Places = 8;
/// Among the parameters of an item.
pub(super) const PARAMETERS: Places = 16;
/// Anywhere.
pub(super) const ANY: Places = HEAD | PARTS | DRAWING | CODE;

/// The tokens of an item, with the source text.
pub(super) struct Item<'t> {
    text: &'t str,
    pub tokens: Vec<Token>,
    vertices: HashSet<&'t str>,
    rims: HashSet<&'t str>,
    /// The variables that each block declares that is open where the item is read.
    blocks: Vec<Vec<&'t str>>,
    /// The number of visible variables of each name.
    visible: HashMap<&'t str, usize>,
}

impl<'t> Item<'t> {
    pub(super) fn new(text: &'t str, tokens: &[Token]) -> Self {
        let word = |token: &Token| text.get(token.span.range()).unwrap_or("");
        let arrows =
            tokens.windows(2).filter(|pair| matches!(pair[0].kind, T::Arrow | T::FatArrow));
        let targets = arrows.map(|pair| word(&pair[1]));
        let vertices = targets.chain(loop_beginnings(tokens).map(word)).collect();
        let rims = tokens.windows(2).filter(|pair| matches!(pair[0].kind, T::Hole | T::Loop));
        let rims = rims.map(|pair| word(&pair[1])).collect();
        let (blocks, visible) = (vec![Vec::new()], HashMap::new());
        Self { text, tokens: tokens.to_vec(), vertices, rims, blocks, visible }
    }

    pub(super) fn token(&self, at: usize) -> Option<&Token> {
        self.tokens.get(at)
    }

    pub(super) fn kind(&self, at: usize) -> Option<T> {
        self.token(at).map(|token| token.kind)
    }

    /// The text of a token.
    pub(super) fn word(&self, at: usize) -> &'t str {
        let token = self.tokens.get(at);
        // An inserted token differs from the text at its span.
        if let Some(spelling) = token.and_then(|token| token.kind.spelling()) {
            return spelling;
        }
        token.and_then(|token| self.text.get(token.span.range())).unwrap_or("")
    }

    /// The text from one token to another.
    pub(super) fn slice(&self, range: Range<usize>) -> &'t str {
        let (Some(first), Some(last)) =
            (self.tokens.get(range.start), range.end.checked_sub(1).and_then(|at| self.token(at)))
        else {
            return "";
        };
        self.text.get(first.span.start as usize..last.span.end as usize).unwrap_or("")
    }

    /// True if this name stands for a vertex in a loop somewhere in the item.
    pub(super) fn is_vertex(&self, word: &str) -> bool {
        self.vertices.contains(word)
    }

    /// True if a statement `hole` or `loop` has this name somewhere in the item, or it does not begin
    /// as those of faces do.
    pub(super) fn is_rim(&self, word: &str) -> bool {
        self.rims.contains(word) || !word.starts_with(['f', 'F'])
    }

    /// True if the name at a token, where the item is read, is that of a variable that a block around
    /// has declared.
    pub(super) fn is_variable(&self, at: usize) -> bool {
        self.visible.get(self.word(at)).is_some_and(|&count| count > 0)
    }

    /// Reads past a token.
    pub(super) fn pass(&mut self, at: usize) {
        let is_bound = at.checked_sub(1).and_then(|before| self.kind(before)) == Some(T::If);
        match self.kind(at) {
            Some(T::LeftBrace) => self.blocks.push(Vec::new()),
            Some(T::RightBrace) => {
                for name in self.blocks.pop().unwrap_or_default() {
                    self.visible.entry(name).and_modify(|count| *count -= 1);
                }
            }
            Some(T::Let | T::Var) if !is_bound => {
                let name = self.word(at + 1);
                if let Some(block) = self.blocks.last_mut() {
                    block.push(name);
                    *self.visible.entry(name).or_default() += 1;
                }
            }
            _ => {}
        }
    }

    /// The end of the name that begins at a token, if there is one.
    pub(super) fn name_end(&self, at: usize) -> Option<usize> {
        const LONGEST_SUBSCRIPT: usize = 5;
        self.kind(at).filter(|kind| kind.is_name())?;
        if self.kind(at + 1) == Some(T::LeftBracket) && self.touches(at + 1) {
            let mut inside = at + 2..at + 2 + LONGEST_SUBSCRIPT;
            return inside
                .find(|&at| self.kind(at) == Some(T::RightBracket))
                .map(|closing| closing + 1);
        }
        Some(at + 1)
    }

    fn between(&self, at: usize) -> &str {
        let before = at.checked_sub(1).and_then(|before| self.token(before));
        let (Some(before), Some(here)) = (before, self.token(at)) else { return "\n" };
        self.text.get(before.span.end as usize..here.span.start as usize).unwrap_or("")
    }

    /// True if nothing separates a token from the previous one.
    pub(super) fn touches(&self, at: usize) -> bool {
        at > 0 && at < self.tokens.len() && self.between(at).is_empty()
    }

    /// The whole `/* … */` comment of which the token is the first line.
    pub(super) fn comment(&self, at: usize) -> Option<(Span, &'t str)> {
        let span = self.token(at)?.span;
        let rest = self.text.get(span.start as usize..)?;
        let end = rest.strip_prefix("/*")?.find("*/")? + 4;
        Some((Span { end: span.start + end as u32, ..span }, rest.get(..end)?))
    }

    /// The text before and after a place.
    pub(super) fn around(&self, start: u32, end: u32) -> (&'t str, &'t str) {
        let before = self.text.get(..start as usize);
        (before.unwrap_or(""), self.text.get(end as usize..).unwrap_or(""))
    }

    /// True if a line ends before a token.
    pub(super) fn ends_line(&self, at: usize) -> bool {
        at >= self.tokens.len()
            || self.between(at).contains(['\n', ';'])
            || self.kind(at) == Some(T::RightBrace)
            || self.word(at) == ";"
    }

    /// True if a token is the first behind the end of a line of text, or there is none.
    pub(super) fn ends_text_line(&self, at: usize) -> bool {
        at >= self.tokens.len() || self.between(at).contains('\n')
    }

    /// True if a step by one begins at a token: `--n`, `++n`.
    pub(super) fn is_step(&self, at: usize) -> bool {
        matches!(self.word(at), "-" | "+")
            && self.word(at) == self.word(at + 1)
            && [at + 1, at + 2].iter().all(|&at| self.touches(at))
    }

    /// True if a comment of other languages begins at a token: `-- text`.
    pub(super) fn begins_comment(&self, at: usize) -> bool {
        [at, at + 1].map(|at| self.word(at)) == ["-", "-"]
            && self.touches(at + 1)
            && !self.touches(at + 2)
    }

    /// The finding that a token is the misspelling of a keyword.
    pub(super) fn misspelt(&self, at: usize, meant: T) -> Option<Found> {
        Some(is_misspelt(self.text, *self.token(at)?, meant))
    }

    /// True if a keyword begins another statement of a drawing on the line of the one before.
    pub(super) fn begins_drawing_statement(&self, at: usize) -> bool {
        let before = at.checked_sub(1).and_then(|before| self.kind(before));
        self.kind(at).is_some_and(T::begins_drawing_statement)
            && before.is_some_and(|before| {
                !goes_on(before) && before != T::DotDot && !before.begins_drawing_statement()
            })
    }

    /// True if a statement can begin at a token outside parentheses.
    fn begins_statement(&self, at: usize) -> bool {
        let Some(before) = at.checked_sub(1) else { return true };
        match self.kind(before) {
            Some(T::LeftBrace | T::RightBrace) => true,
            Some(before) if goes_on(before) => false,
            _ => self.between(at).contains(['\n', ';']) || self.word(before) == ";",
        }
    }
}

/// The names that follow the colon of a loop: a loop consists of vertices, with arrows between them
/// or without.
fn loop_beginnings(tokens: &[Token]) -> impl Iterator<Item = &Token> {
    let is_loop = |tokens: &[Token]| {
        let [kind, name, colon] = [0, 1, 2].map(|at| tokens[at].kind);
        matches!(kind, T::Face | T::Hole | T::Loop) && name.is_name() && colon == T::Colon
    };
    let begins = (3..=tokens.len()).filter(move |&at| is_loop(&tokens[at - 3..at]));
    begins.flat_map(|at| {
        let listed = |token: &&Token| token.kind.is_name() || token.kind == T::Comma;
        tokens[at..].iter().take_while(listed).filter(|token| token.kind.is_name())
    })
}

/// True if a statement certainly continues after a token.
pub(super) fn goes_on(kind: T) -> bool {
    use T::{Bar, Colon, Comma, Dot, DoubleColon, Equals, LeftParen, Not, Star};
    // A star ends the spokes of a vertex.
    let is_operator = kind.is_binary() && kind != Star;
    is_operator
        || matches!(kind, Comma | Equals | Not | Bar | Colon | DoubleColon | Dot | LeftParen)
}

/// The brackets that are open at a token.
pub(super) struct Braces {
    open: Vec<Places>,
    /// The number of open parentheses outside all braces, then inside each open brace.
    parentheses: Vec<usize>,
    /// The last keyword that determines what the next brace opens.
    word: Option<T>,
}

impl Braces {
    pub(super) fn new() -> Self {
        Self { open: Vec::new(), parentheses: vec![0], word: None }
    }

    /// The current place.
    pub(super) fn place(&self) -> Places {
        self.open.last().copied().unwrap_or(HEAD)
    }

    /// The current place, with that of parameters if one can begin behind a token.
    pub(super) fn places(&self, item: &Item, at: usize) -> Places {
        let declares = |kind| matches!(kind, Some(T::Op | T::Fn | T::Script));
        let is_head = self.open.is_empty() && declares(self.word);
        let begins = match item.kind(at) {
            Some(T::LeftParen) => at.checked_sub(2).is_some_and(|at| declares(item.kind(at))),
            _ => self.parentheses == [1],
        };
        self.place() | if is_head && begins { PARAMETERS } else { 0 }
    }

    /// True if a statement can begin at a token.
    pub(super) fn begins(&self, item: &Item, at: usize) -> bool {
        let begins = item.begins_statement(at)
            || self.place() == DRAWING && item.begins_drawing_statement(at);
        self.parentheses.last() == Some(&0) && begins
    }

    fn close(&mut self) {
        if self.open.pop().is_some() {
            self.parentheses.pop();
        }
    }

    /// Advances past a token.
    pub(super) fn pass(&mut self, kind: T) {
        match kind {
            T::Op
            | T::Script
            | T::Fn
            | T::Test
            | T::Before
            | T::After
            | T::Steps
            | T::Rule
            | T::Each
            | T::If
            | T::Else => {
                // A drawing ends where a part begins, even if its brace is not closed.
                while self.place() == DRAWING && matches!(kind, T::Before | T::After | T::Rule) {
                    self.close();
                }
                self.word = Some(kind);
            }
            T::LeftBrace => {
                self.open.push(match (self.place(), self.word) {
                    (HEAD, Some(T::Op)) | (PARTS, Some(T::Rule)) => PARTS,
                    (PARTS, Some(T::Before | T::After)) | (DRAWING, Some(T::Each)) => DRAWING,
                    _ => CODE,
                });
                self.word = None;
                self.parentheses.push(0);
            }
            T::RightBrace => {
                self.close();
                self.word = None;
            }
            T::LeftParen => {
                if let Some(open) = self.parentheses.last_mut() {
                    *open += 1;
                }
            }
            T::RightParen => {
                if let Some(open) = self.parentheses.last_mut() {
                    *open = open.saturating_sub(1);
                }
            }
            _ => {}
        }
    }
}
