//! Tests: the mesh that a test starts with, and the statements that only tests have.
//!
//! ```text
//! test "a flip there and back" {
//!   mesh = octahedron()
//!   let start = mesh
//!   …
//!   assert mesh == start
//! }
//! ```

use crate::diagnostic::{Diagnostic, quoted};
use crate::source::Span;
use crate::syntax::tree::{self, Action, ActionKind, BinaryOp, ExprKind, Ident};

use super::declared::{Declared, duplicate};
use super::depth::shallow_block;
use super::foreign_words::Here;
use super::program::{Body, Script, StatementKind, Test, TestMesh};
use super::report::Report;
use super::script::Scripting;
use super::signature::Signature;
use super::suggestion::suggest;
use super::test_meshes::Meshes;
use super::words::arguments;

/// The constructors of meshes: the name, and the minimum of each size.
pub(super) const CONSTRUCTORS: [(&str, &[i64]); 13] = [
    ("tetrahedron", &[]),
    ("cube", &[]),
    ("octahedron", &[]),
    ("icosahedron", &[]),
    ("icosphere", &[0]),
    ("grid", &[1, 1]),
    ("triangle_grid", &[1, 1]),
    ("torus", &[3, 3]),
    ("triangle_torus", &[3, 3]),
    ("cylinder", &[3, 1]),
    ("disk", &[3]),
    ("polygon", &[3]),
    ("pillow", &[3]),
];

/// True if the word is the name of a shape, as `cube`.
pub fn is_shape(word: &str) -> bool {
    CONSTRUCTORS.iter().any(|(known, _)| *known == word)
}

/// The message about a mesh constructor that is called outside of a test.
pub(super) fn mesh_maker(word: &str) -> Option<Here> {
    let makes = word == "load" || is_shape(word);
    makes.then_some(Here::Said(
        "a mesh is made at the beginning of a test, `mesh = cube()`; a script has the mesh it is \
         run on",
    ))
}

/// The maximum size, and the maximum number of subdivisions of an icosphere.
const MOST: i64 = 1000;
const MOST_SPLIT: i64 = 8;

/// Resolves a test; `None` if the report has an error.
pub(super) fn resolve_test(
    test: &tree::Test,
    ops: &[Signature],
    declared: &Declared,
    report: &mut Report,
) -> Option<Test> {
    if !shallow_block(&test.body, report) {
        return None;
    }
    let mut scripting = Scripting::beginning(&[], ops, declared, report);
    scripting.testing = Some(Meshes::default());
    let mut body = Vec::new();
    let statements = test.body.statements.as_slice();
    let (begin, rest) = match statements.split_first() {
        Some((first, rest)) if let Some(value) = begins(first) => (scripting.mesh(value), rest),
        _ => (Some(TestMesh::Empty), statements),
    };
    scripting.actions(rest, &mut body);
    let meshes = scripting.testing.take().unwrap_or_default().all;
    let scopes = scripting.typing.scopes;
    declared.meet_variables(&scopes);
    if report.failed() {
        return None;
    }
    let span = Span { end: test.body.span.start.max(test.span.start), ..test.span };
    Some(Test {
        begin: begin?,
        meshes,
        script: Script {
            name: test.name.clone(),
            span,
            docs: Vec::new(),
            params: Vec::new(),
            body: Body { variables: scopes.into_variables()?, block: body },
        },
    })
}

/// The right-hand side of `mesh = …`.
fn begins(action: &Action) -> Option<&tree::Expr> {
    match &action.kind {
        ActionKind::Assign { target, value } if is_mesh(target) => Some(value),
        _ => None,
    }
}

fn is_mesh(expr: &tree::Expr) -> bool {
    matches!(&expr.kind, ExprKind::Name(name) if name.index.is_none() && name.ident.text == "mesh")
}

impl Scripting<'_> {
    /// A statement that only tests have; `None` if this is another statement.
    pub(super) fn testing_action(&mut self, action: &Action) -> Option<Option<StatementKind>> {
        self.testing.as_ref()?;
        match &action.kind {
            ActionKind::Assign { target, .. } if is_mesh(target) => {
                let message = "`mesh = …` stands once, at the beginning of the test";
                self.typing.report.add(Diagnostic::error("test-mesh", message, action.span));
                Some(None)
            }
            ActionKind::Let { mutable, name, ty, value } if is_mesh(value) => {
                Some(self.kept(name, *mutable || ty.is_some(), action.span))
            }
            ActionKind::Let { name, .. } => {
                if let Some((first, _)) = self.kept_as(&name.text) {
                    let error = duplicate("a mesh", name, first.span);
                    self.typing.report.add(error);
                }
                None
            }
            ActionKind::Assert { condition, reason } => {
                let reason = reason.as_ref().map(|(text, _)| text.as_str());
                match &condition.kind {
                    ExprKind::Binary(op @ (BinaryOp::Equal | BinaryOp::NotEqual), left, right)
                        if is_mesh(left) || is_mesh(right) =>
                    {
                        let same = *op == BinaryOp::Equal;
                        Some(self.compared(if is_mesh(left) { right } else { left }, same, reason))
                    }
                    ExprKind::Binary(BinaryOp::Equal | BinaryOp::NotEqual, left, right)
                        if self.is_kept(left) || self.is_kept(right) =>
                    {
                        let message = "a mesh that was kept is compared with `mesh` as it is now";
                        let error = Diagnostic::error("test-mesh", message, condition.span);
                        Some(self.typing.report.reject(error))
                    }
                    ExprKind::Call { function, args } if function.text == "refuses" => {
                        Some(self.refuses(args, reason, condition.span))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// `let start = mesh`; `may_differ` if it is a `var` or has a type.
    fn kept(&mut self, name: &Ident, may_differ: bool, span: Span) -> Option<StatementKind> {
        if may_differ {
            let whole = format!("let {} = mesh", name.text);
            let message = format!("a mesh is kept by `{whole}`");
            let error = Diagnostic::error("test-mesh", message, span);
            self.typing.report.add(error.fix(format!("write `{whole}`"), span, whole));
        }
        let first = match self.kept_as(&name.text) {
            Some((first, _)) => Some(("a mesh", first.span)),
            None => {
                self.typing.scopes.find_here(&name.text).map(|local| ("a variable", local.span))
            }
        };
        if let Some((what, first)) = first {
            return self.typing.report.reject(duplicate(what, name, first));
        }
        let meshes = self.testing.as_mut()?;
        let mesh = meshes.add(TestMesh::Empty);
        meshes.kept.push((name.clone(), mesh));
        Some(StatementKind::KeepMesh { mesh })
    }

    /// The visible kept mesh of this name.
    fn kept_as(&self, name: &str) -> Option<&(Ident, u16)> {
        self.testing.as_ref()?.kept.iter().find(|(known, _)| known.text == name)
    }

    fn is_kept(&self, expr: &tree::Expr) -> bool {
        matches!(&expr.kind, ExprKind::Name(name) if self.kept_as(&name.ident.text).is_some())
    }

    /// `assert mesh == …`
    fn compared(
        &mut self,
        other: &tree::Expr,
        same: bool,
        reason: Option<&str>,
    ) -> Option<StatementKind> {
        let known = match &other.kind {
            ExprKind::Name(name) => self.kept_as(&name.ident.text).map(|(_, mesh)| *mesh),
            _ => None,
        };
        let mesh = match known {
            Some(mesh) => mesh,
            None => {
                let mesh = self.mesh(other)?;
                self.testing.as_mut()?.add(mesh)
            }
        };
        let reason = reason.unwrap_or(match same {
            true => "the mesh is another",
            false => "the mesh is the same",
        });
        Some(StatementKind::AssertMesh { mesh, same, reason: reason.to_owned() })
    }

    /// `assert refuses(flip(e), "the edge is there")`
    fn refuses(
        &mut self,
        args: &[tree::Expr],
        reason: Option<&str>,
        span: Span,
    ) -> Option<StatementKind> {
        let (call, why) = match args {
            [call] => (call, None),
            [call, why] => match &why.kind {
                ExprKind::Text(text) => (call, Some(text.clone())),
                _ => return self.wrong_refuses(why.span),
            },
            _ => return self.wrong_refuses(span),
        };
        let ExprKind::Call { function, args } = &call.kind else {
            return self.wrong_refuses(call.span);
        };
        let (op, args) = self.typing.application(function, args, call.span)?;
        let reason = reason.map(str::to_owned);
        Some(StatementKind::AssertRefuses { op, args, why, reason })
    }

    fn wrong_refuses<T>(&mut self, span: Span) -> Option<T> {
        let message = "`refuses` wants the call of an op, and perhaps the reason as a text";
        self.typing.report.reject(Diagnostic::error("not-an-op", message, span))
    }

    /// A mesh from a constructor: `cube()`, `load("cube.obj")`.
    fn mesh(&mut self, expr: &tree::Expr) -> Option<TestMesh> {
        let ExprKind::Call { function, args } = &expr.kind else {
            let message = "a mesh is made here, as by `cube()`, or loaded: `load(\"cube.obj\")`";
            return self.typing.report.reject(Diagnostic::error("test-mesh", message, expr.span));
        };
        let word = function.text.as_str();
        if word == "load" {
            return match args.as_slice() {
                [tree::Expr { kind: ExprKind::Text(path), span }] => {
                    Some(TestMesh::Loaded { path: path.clone(), span: *span })
                }
                _ => {
                    let message = "`load` wants the path of a mesh as a text";
                    self.typing.report.reject(Diagnostic::error("test-mesh", message, expr.span))
                }
            };
        }
        let Some((_, least)) = CONSTRUCTORS.iter().find(|(known, _)| *known == word) else {
            let message = format!("nothing makes a mesh under the name `{word}`");
            let error = Diagnostic::error("test-mesh", message, function.span);
            let known = CONSTRUCTORS.map(|(known, _)| known);
            let error = suggest(error, word, function.span, known);
            let note = format!("there are {} and `load`", quoted(known));
            return self.typing.report.reject(error.note(note));
        };
        if least.len() != args.len() {
            let message = format!("`{word}` takes {}", arguments(least.len()));
            return self.typing.report.reject(Diagnostic::error("wrong-count", message, expr.span));
        }
        let sizes: Vec<_> = least.iter().map(i64::to_string).collect();
        let example = format!("{word}({})", sizes.join(", "));
        let most = if word == "icosphere" { MOST_SPLIT } else { MOST };
        let mut sizes = Vec::new();
        for (arg, &least) in args.iter().zip(*least) {
            match arg.kind {
                ExprKind::Int(size) if (least..=most).contains(&size) => sizes.push(size as u32),
                _ => {
                    let is_literal = matches!(arg.kind, ExprKind::Int(_) | ExprKind::Unary(..));
                    let message = match is_literal {
                        true => format!("`{word}` wants a number from {least} to {most} here"),
                        false => format!("`{word}` wants a number in digits here, as `{example}`"),
                    };
                    let error = Diagnostic::error("test-mesh", message, arg.span);
                    return self.typing.report.reject(error);
                }
            }
        }
        Some(TestMesh::Made { constructor: word.to_owned(), sizes })
    }
}

impl Meshes {
    /// Adds a mesh and returns its number.
    fn add(&mut self, mesh: TestMesh) -> u16 {
        self.all.push(mesh);
        u16::try_from(self.all.len() - 1).unwrap_or(u16::MAX)
    }
}
