//! The declarations that the words of an op refer to: the attributes and functions that it names,
//! and those that their declarations name in turn.
//!
//! A proof stays valid as long as the text of the op and these declarations stay the same, whatever
//! else changes in the file or in those that it uses.

use std::collections::{BTreeSet, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};

use crate::resolve::Program;
use crate::source::{FileId, Sources, Span};
use crate::syntax::tree::{self, Item};
use crate::syntax::{Parsed, Token, TokenKind};

/// The declarations of a program that an op can name.
#[derive(Debug, Default)]
pub(super) struct Meanings<'p> {
    /// The declarations of each name; several files may declare the same name.
    named: HashMap<&'p str, Vec<usize>>,
    declarations: Vec<Declaration<'p>>,
    /// The attributes without a default: new elements need a value of each.
    wanted: Vec<usize>,
}

#[derive(Debug)]
struct Declaration<'p> {
    file: Read<'p>,
    span: Span,
    /// Its index among the attributes, or among the functions, of the program.
    number: usize,
}

/// A file with its text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Read<'p> {
    pub text: &'p str,
    pub parsed: &'p Parsed,
}

impl<'p> Read<'p> {
    pub(super) fn of(sources: &'p Sources, file: FileId, parsed: &'p Parsed) -> Self {
        Self { text: sources.get(file).text(), parsed }
    }

    fn tokens(self, span: Span) -> impl Iterator<Item = &'p Token> {
        let tokens = &self.parsed.tokens;
        let first = tokens.partition_point(|token| token.span.start < span.start);
        tokens[first..].iter().take_while(move |token| token.span.end <= span.end)
    }

    /// The words in a span, including those in texts, which may name the values shown there.
    fn words(self, span: Span) -> impl Iterator<Item = &'p str> {
        self.tokens(span).flat_map(move |token| {
            let said = self.text.get(token.span.range()).unwrap_or("");
            let is_text = token.kind == TokenKind::Text;
            said.split(move |letter: char| is_text && !(letter.is_alphanumeric() || letter == '_'))
        })
    }
}

impl<'p> Meanings<'p> {
    /// The declarations of the files of a program.
    pub(super) fn of(program: &Program, files: impl Iterator<Item = Read<'p>>) -> Self {
        let attributes = program.attributes.iter().map(|attribute| attribute.span);
        let functions = program.functions.iter().map(|function| function.span);
        let numbers: HashMap<Span, usize> = attributes
            .enumerate()
            .chain(functions.enumerate())
            .map(|(number, span)| (span, number))
            .collect();
        let mut meanings = Self::default();
        for file in files {
            for item in &file.parsed.tree.items {
                let (name, lacks_default) = match item {
                    Item::Attr(tree::Attr { name, default, .. }) => (name, default.is_none()),
                    Item::Fn(function) => (&function.name, false),
                    _ => continue,
                };
                let Some(&number) = numbers.get(&name.span) else { continue };
                let at = meanings.declarations.len();
                meanings.declarations.push(Declaration { file, span: item.span(), number });
                meanings.named.entry(&name.text).or_default().push(at);
                if lacks_default {
                    meanings.wanted.push(at);
                }
            }
        }
        meanings
    }

    /// A hash of the declarations that the words in a span refer to, directly or through others.
    pub(super) fn fingerprint(&self, file: Read<'p>, span: Span) -> u64 {
        let mut reached: BTreeSet<usize> = self.wanted.iter().copied().collect();
        let mut open: Vec<usize> = self.wanted.clone();
        let mut meet = |file: Read<'p>, span: Span, open: &mut Vec<usize>| {
            let meant = file.words(span).filter_map(|word| self.named.get(word));
            open.extend(meant.flatten().filter(|&&at| reached.insert(at)));
        };
        meet(file, span, &mut open);
        while let Some(at) = open.pop() {
            let declaration = &self.declarations[at];
            meet(declaration.file, declaration.span, &mut open);
        }
        let mut hasher = DefaultHasher::new();
        for declaration in reached.iter().map(|&at| &self.declarations[at]) {
            declaration.number.hash(&mut hasher);
            declaration.file.text.get(declaration.span.range()).hash(&mut hasher);
        }
        hasher.finish()
    }
}
