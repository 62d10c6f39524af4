//! The guard: tests of the result before it is written.
//!
//! The pointers of phase 3 that a test reads are noted on a preview of the mesh, and each test
//! looks at one orbit of the preview, as the machine does.

use super::build::{Writer, allocation};
use super::reassign;
use super::routine::{Block, Field, Statement, without_unread};
use super::value::{Precedence, Term};
use crate::diagram::Kind;
use crate::lower::{GuardTest, Operation, PreviewReads, Question, StarWalk};

impl Writer<'_, '_> {
    /// Makes the tests of a guard, in order; if any of them reads a preview, all are in one block
    /// with it.
    pub fn guard(&mut self, operation: &Operation) {
        // Names declared within the block are free again after it.
        let outer = self.names.clone();
        let preview = self.names.fresh("preview");
        let before = std::mem::take(&mut self.body);
        operation.guard.tests.iter().for_each(|test| self.test(test, &preview));
        let mut tests = std::mem::replace(&mut self.body, before);
        if let Some(reads) = operation.guard.reads {
            let mut body = allocation(&operation.created, &self.names);
            body.extend(reassign::statements(self.drawing, &mut self.names, false));
            body.retain_mut(|statement| is_read(statement, reads));
            body.extend(tests);
            tests = vec![Statement::Preview { preview, body: without_unread(body, true) }];
        }
        self.body.extend(tests);
        self.names = outer;
    }

    fn test(&mut self, test: &GuardTest, preview: &str) {
        let repeated = match test.question {
            Question::OneHoleAlong(path) => self.drawing.rule.is_member(path),
            _ => test.at_each_index,
        };
        let breaks = self.for_each(repeated, |this| this.breaks(test.question, preview));
        self.refuse(breaks, repeated, &test.refusal);
    }

    /// The condition that the result violates the test.
    fn breaks(&self, question: Question, preview: &str) -> Term {
        let (word, elements) = match question {
            Question::NotAdjacent(ends) => {
                let ends = ends.map(|end| self.names.term(end));
                return self.names.language.call("Adjacent", &ends);
            }
            Question::Holds { condition, of, at } => (condition.word(), [Some(of), at]),
            Question::OneHoleAlong(path) => {
                let next = self.drawing.before.item_after(path).unwrap_or(path);
                ("one_hole_along", [Some(path), Some(next)])
            }
        };
        let terms = elements.into_iter().flatten().map(|name| self.names.term(name));
        let terms: Vec<_> = terms.collect();
        let args: Vec<_> = terms.iter().map(|term| term.text.as_str()).collect();
        let asked = format!("{preview}.{word}({})", args.join(", "));
        let breaks = Term::of(asked, Precedence::Whole, &terms).not();
        match question {
            // An empty path would look like a loop.
            Question::OneHoleAlong(path) if self.drawing.is_empty_somewhere(path) => {
                self.names.empty(path).not().and(breaks)
            }
            _ => breaks,
        }
    }
}

/// True if a test reads something that a statement writes; what no test reads is removed from it.
fn is_read(statement: &mut Statement, reads: PreviewReads) -> bool {
    match statement {
        Statement::New { kind: Kind::Edge, .. } => false,
        Statement::Set { field: Field::Pointer(pointer), .. } => {
            reads.reads(*pointer, StarWalk::Clockwise)
        }
        Statement::Set { field: Field::Hole, .. } => reads.reads_holes(),
        Statement::Block(Block { body, .. }) => {
            body.retain_mut(|inner| is_read(inner, reads));
            !body.is_empty()
        }
        _ => true,
    }
}
