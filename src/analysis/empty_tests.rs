//! Tests that assert nothing: their loops visit the elements of an empty mesh.

use crate::diagnostic::Diagnostic;
use crate::resolve::{Program, StatementKind, TestMesh};

/// A warning for each test that begins with no mesh, at its first loop over one.
pub(super) fn empty_tests(program: &Program) -> Vec<Diagnostic> {
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
