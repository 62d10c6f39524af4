//! A routine: pointer code before it has its place in a text.
//!
//! Statements whose text depends on where they stand keep their parts until they are printed: how
//! a refusal leaves, and whether the mesh itself, a preview or a journal is written to. All others
//! are [text](super::statement).

use std::collections::BTreeSet;

use super::names::{Attribute, IndexLoop};
use super::value::{Precedence, Term};
use crate::diagram::{Kind, Pointer};

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// A comment.
    Comment(String),
    /// An empty line.
    Blank,
    /// Lines, and the names in them; `bound` is the name of a value or list that they only bind.
    Lines { text: String, names: BTreeSet<String>, bound: Option<String> },
    /// A loop or a branch.
    Block(Block),
    /// A refusal if a condition holds.
    Refuse { when: Term, reason: String },
    /// A refusal in a block with this head and end.
    RefuseIn { head: Term, reason: String, end: &'static str },
    /// The allocation of an element, or of one for each index.
    New { kind: Kind, name: String, indices: Option<IndexLoop> },
    /// `of.field = value`
    Set { field: Field, of: Term, value: Term },
    /// The erasure of an element.
    Erase { kind: Kind, element: Term },
    /// The return from a function, or from an operation that has applied.
    Return { value: Option<Term> },
    /// A preview of the mesh, and a block whose allocations and writes are noted on it.
    Preview { preview: String, body: Vec<Statement> },
}

/// A head and the statements that it holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Block {
    pub form: Form,
    /// A line before it; may be empty.
    pub first: String,
    pub head: Term,
    pub body: Vec<Statement>,
    /// A line after the statements; may be empty.
    pub last: String,
    /// The statements of `else`.
    pub otherwise: Vec<Statement>,
}

/// The form of a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Form {
    #[default]
    Plain,
    /// A branch that can follow an `else`.
    Branch,
    /// Attempts with the halfedges of an element in turn; a refusal in the body continues with the
    /// next one.
    Attempt,
}

/// A value of an element that is set.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Field {
    Pointer(Pointer),
    /// Whether a face is a hole.
    Hole,
    Position,
    Attribute(Attribute),
}

impl Statement {
    /// Lines in which the names of some terms occur.
    pub fn lines<'t>(text: String, terms: impl IntoIterator<Item = &'t Term>) -> Self {
        Self::Lines { text, names: Term::of("", Precedence::Whole, terms).names, bound: None }
    }

    /// Lines that only bind a name.
    pub fn binding<'t>(
        name: &str,
        text: String,
        terms: impl IntoIterator<Item = &'t Term>,
    ) -> Self {
        let names = Term::of("", Precedence::Whole, terms).names;
        Self::Lines { text, names, bound: Some(name.to_string()) }
    }

    /// `of.pointer = value`
    pub fn set(pointer: Pointer, of: Term, value: Term) -> Self {
        Self::Set { field: Field::Pointer(pointer), of, value }
    }

    /// A loop.
    pub fn block(head: Term, body: Vec<Self>) -> Self {
        Self::Block(Block { head, body, ..Block::default() })
    }

    /// Adds every name that it reads, bodies included.
    pub fn names(&self, names: &mut BTreeSet<String>) {
        let mut see = |term: &Term| names.extend(term.names.iter().cloned());
        match self {
            Self::Comment(_) | Self::Blank | Self::New { indices: None, .. } => {}
            Self::Lines { names: read, .. } => names.extend(read.iter().cloned()),
            Self::Refuse { when: term, .. }
            | Self::RefuseIn { head: term, .. }
            | Self::Erase { element: term, .. } => see(term),
            Self::Return { value } => value.iter().for_each(see),
            Self::Set { of, value, .. } => [of, value].into_iter().for_each(see),
            Self::New { indices: Some(indices), .. } => _ = names.insert(indices.size.clone()),
            Self::Block(Block { head, body, otherwise, .. }) => {
                see(head);
                body.iter().chain(otherwise).for_each(|inner| inner.names(names));
            }
            Self::Preview { body, .. } => body.iter().for_each(|inner| inner.names(names)),
        }
    }
}

/// The names that statements read.
pub(super) fn names_of<'b>(body: impl IntoIterator<Item = &'b Statement>) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    body.into_iter().for_each(|statement| statement.names(&mut names));
    names
}

/// Removes bindings of names that are never read: a binding has no other effect. On a preview,
/// `is_preview`, new elements have none either.
pub(super) fn without_unread(body: Vec<Statement>, is_preview: bool) -> Vec<Statement> {
    let mut read = BTreeSet::new();
    let mut kept = Vec::new();
    for mut statement in body.into_iter().rev() {
        let bound = match &statement {
            Statement::Lines { bound, .. } => bound.as_ref(),
            Statement::New { name, .. } if is_preview => Some(name),
            _ => None,
        };
        if bound.is_some_and(|name| !read.contains(name)) {
            continue;
        }
        if let Statement::Block(Block { form: Form::Attempt, body, .. }) = &mut statement {
            *body = without_unread(std::mem::take(body), is_preview);
        }
        statement.names(&mut read);
        kept.push(statement);
    }
    kept.reverse();
    kept
}
