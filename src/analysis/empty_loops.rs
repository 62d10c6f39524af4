//! Loops that visit nothing: over a mesh that is empty, or over `faces` that are holes.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Binary, Builtin, Elements, Expr, ExprKind};
use crate::resolve::{Program, StatementKind, TestMesh};

/// A warning for each loop that visits nothing.
pub(super) fn empty_loops(program: &Program) -> Vec<Diagnostic> {
    [empty_tests(program), faces_that_are_holes(program)].concat()
}

/// A warning for each test that begins with no mesh, at its first loop over one.
fn empty_tests(program: &Program) -> Vec<Diagnostic> {
    let empty = program.tests.iter().filter(|test| test.begin == TestMesh::Empty);
    let loops = empty.filter_map(|test| {
        test.script.body.block.iter().find(|statement| match &statement.kind {
            StatementKind::For { collection, .. } | StatementKind::Drain { collection, .. } => {
                collection.all().is_some()
            }
            _ => false,
        })
    });
    let warnings = loops.map(|statement| {
        let message = "the test begins with an empty mesh: this loop visits nothing";
        Diagnostic::warning("empty-test", message, statement.span)
            .note("a test makes its mesh first: `mesh = grid(3, 3)`")
    });
    warnings.collect()
}

/// A warning for each loop over the holes among `faces`, which have none.
fn faces_that_are_holes(program: &Program) -> Vec<Diagnostic> {
    let loops = program.statements().into_iter().filter_map(|statement| match &statement.kind {
        StatementKind::For { variable, collection, filter: Some(filter), .. }
            if collection.all() == Some(Elements::Faces) =>
        {
            asks_for_a_hole(filter, *variable)
        }
        _ => None,
    });
    let warnings = loops.map(|asked| {
        let message = "this loop visits nothing: no face among `faces` is a hole";
        Diagnostic::warning("empty-loop", message, asked.span)
            .note("the holes of the mesh are `holes`: `for f in holes { … }`")
    });
    warnings.collect()
}

/// The part of a condition that holds for a hole alone.
fn asks_for_a_hole(condition: &Expr, face: u32) -> Option<&Expr> {
    match &condition.kind {
        ExprKind::Binary(Binary::And, left, right) => {
            asks_for_a_hole(left, face).or_else(|| asks_for_a_hole(right, face))
        }
        ExprKind::Call(Builtin::IsHole, of) => {
            of.iter().all(|of| of.kind == ExprKind::Local(face)).then_some(condition)
        }
        _ => None,
    }
}
