//! The guard: tests of the result before it is written.
//!
//! The pointers of phase 3 that a test reads are noted on a preview of the mesh, and each test
//! looks at one orbit of the preview, as the machine does.

use super::build::allocation;
use super::conventions::Conventions;
use super::names::Names;
use super::reassign;
use super::routine::{Field, Statement, without_unread};
use super::term::{Function, Term};
use crate::diagram::{Builtin, Drawing, Kind};
use crate::lower::{GuardTest, Operation, PreviewReads, Question, StarWalk};

/// The tests of a guard, in order; if any of them reads a preview, all are in one block with it.
pub(super) fn tests(
    drawing: &Drawing,
    operation: &Operation,
    names: &Names,
    conventions: Conventions<'_>,
) -> Vec<Statement> {
    // Names declared within the block are free again after it.
    let names = &mut names.clone();
    let name = names.fresh("preview");
    let mut tests = Tests { drawing, names, preview: name.clone(), body: Vec::new() };
    operation.guard.tests.iter().for_each(|test| tests.test(test));
    let tests = tests.body;
    let Some(reads) = operation.guard.reads else {
        return tests;
    };
    let changes = Conventions { exhaustive: false, ..conventions };
    let mut body = allocation(&operation.created, names);
    body.extend(reassign::statements(drawing, names, changes));
    let noted = body.into_iter().filter_map(|statement| noted(statement, reads));
    let body = without_unread(noted.chain(tests).collect(), |statement| match statement {
        Statement::New { name, .. } | Statement::Size { name, .. } => Some(name),
        _ => None,
    });
    vec![Statement::Preview { preview: name, body }]
}

/// The part of a statement that a test reads.
fn noted(statement: Statement, reads: PreviewReads) -> Option<Statement> {
    let noted_of = |body: Vec<Statement>| -> Option<Vec<_>> {
        let body: Vec<_> = body.into_iter().filter_map(|it| noted(it, reads)).collect();
        (!body.is_empty()).then_some(body)
    };
    Some(match statement {
        Statement::New { kind: Kind::Edge, .. } => return None,
        Statement::Set { field: Field::Pointer(pointer), .. }
            if !reads.reads(pointer, StarWalk::Clockwise) =>
        {
            return None;
        }
        Statement::Set { field: Field::Hole, .. } if !reads.reads_holes() => return None,
        Statement::IndexLoop { indices, body } => {
            Statement::IndexLoop { indices, body: noted_of(body)? }
        }
        Statement::Choose { condition, then, .. } => Statement::when(condition, noted_of(then)?),
        Statement::Walk { walk, body } => Statement::Walk { walk, body: noted_of(body)? },
        statement => statement,
    })
}

/// The writer of the tests.
struct Tests<'d, 'n> {
    drawing: &'d Drawing<'d>,
    names: &'n mut Names,
    preview: String,
    body: Vec<Statement>,
}

impl Tests<'_, '_> {
    fn test(&mut self, test: &GuardTest) {
        let repeated = match test.question {
            Question::OneHoleAlong(path) => self.drawing.rule.is_member(path),
            _ => test.at_each_index,
        };
        let outer = self.names.is_indexed;
        self.names.is_indexed |= repeated;
        let breaks = self.breaks(test.question);
        self.names.is_indexed = outer;
        self.body.push(self.names.refusal(breaks, repeated, &test.refusal));
    }

    /// The condition that the result violates the test.
    fn breaks(&self, question: Question) -> Term {
        let (word, elements) = match question {
            Question::NotAdjacent(ends) => {
                let ends = ends.map(|end| self.names.term(end)).into();
                return Term::Call(Function::Builtin(Builtin::Adjacent), ends);
            }
            Question::Holds { condition, of, at } => {
                (condition.word(), std::iter::once(of).chain(at).collect())
            }
            Question::OneHoleAlong(path) => {
                let next = self.drawing.before.item_after(path).unwrap_or(path);
                ("one_hole_along", vec![path, next])
            }
        };
        let elements: Vec<_> = elements.into_iter().map(|name| self.names.term(name)).collect();
        let args = std::iter::once(Term::name(&self.preview)).chain(elements).collect();
        let breaks = Term::Call(Function::OfPreview(word), args).not();
        match question {
            // An empty path would look like a loop.
            Question::OneHoleAlong(path) if self.drawing.is_empty_somewhere(path) => {
                self.names.empty(path).not().and(breaks)
            }
            _ => breaks,
        }
    }
}
