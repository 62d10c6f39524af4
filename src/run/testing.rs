//! Tests: scripts that run on meshes of their own, and the statements that only tests have.

use super::function::Functions;
use super::lower::Lowering;
use super::prepare::{Prepared, prepare_script};
use super::report::{Failure, Report, failure, run_with};
use crate::compile::{Scope, narrow};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Binary, Expr, ExprKind, Unary};
use crate::mesh::{Mesh, MeshFile, shape};
use crate::resolve::{Digits, Program, TestMesh};
use crate::rewrite::{Engine, Inst, Plans, Watch};
use crate::source::Span;

/// Loads the file of a mesh for a test, by its path as written in the test.
pub type Load<'l> = dyn FnMut(&str, Span) -> Result<MeshFile, String> + 'l;

/// The conditions of a test.
#[derive(Clone, Copy, Debug)]
pub struct Conditions {
    /// The seed of its random numbers.
    pub seed: u64,
    /// The memory limit, in bytes.
    pub memory: usize,
    /// The engine that runs it.
    pub engine: Engine,
}

/// Seed 0, no memory limit, and native code where it pays.
impl Default for Conditions {
    fn default() -> Self {
        Self { seed: 0, memory: usize::MAX, engine: Engine::default() }
    }
}

/// Runs a test of a program, by its number.
///
/// # Errors
/// The test fails; or it cannot be run, because a mesh cannot be loaded or an operation is not
/// proved.
pub fn test(
    program: &Program,
    test: usize,
    plans: &Plans,
    conditions: Conditions,
    load: &mut Load,
    watch: &mut dyn Watch,
) -> Result<Report, Box<Failure>> {
    let Some(test) = program.tests.get(test) else {
        let message = "there is no such test";
        return Err(failure(Diagnostic::error("unknown-script", message, Span::default())));
    };
    let (functions, mut too_large) = Functions::of(program);
    if let Some(error) = too_large.pop() {
        return Err(failure(error));
    }
    let prepared = prepare_script(program, &test.script, plans, functions);
    let prepared = prepared.map_err(|mut errors| failure(errors.remove(0)))?;
    let mut prepared = prepared.with_seed(conditions.seed);
    prepared.limit_memory(conditions.memory);
    prepared.use_engine(conditions.engine);
    let meshes = std::iter::once(&test.begin).chain(&test.meshes);
    let made = meshes.map(|mesh| make(mesh, &prepared, load).map_err(failure));
    let mut made = made.collect::<Result<Vec<_>, _>>()?;
    let mut mesh = made.remove(0);
    run_with(&prepared, &mut mesh, &[], made, watch)
}

fn make(mesh: &TestMesh, prepared: &Prepared, load: &mut Load) -> Result<Mesh, Diagnostic> {
    match mesh {
        TestMesh::Empty => Ok(Mesh::default()),
        TestMesh::Made { constructor, sizes } => Ok(constructed(constructor, sizes)),
        TestMesh::Loaded { path, span } => {
            let mut obj = load(path, *span).map_err(|why| {
                let message = format!("`{path}` cannot be loaded: {why}");
                Diagnostic::error("test-mesh", message, *span)
            })?;
            for attribute in prepared.attributes() {
                obj.bring(attribute);
            }
            Ok(obj.mesh)
        }
    }
}

/// The mesh of a constructor, whose sizes have been checked.
pub fn constructed(constructor: &str, sizes: &[u32]) -> Mesh {
    match (constructor, sizes) {
        ("tetrahedron", []) => shape::tetrahedron(),
        ("cube", []) => shape::cube(),
        ("octahedron", []) => shape::octahedron(),
        ("icosahedron", []) => shape::icosahedron(),
        ("icosphere", &[k]) => shape::icosphere(k),
        ("grid", &[n, m]) => shape::grid(n, m),
        ("triangle_grid", &[n, m]) => shape::triangle_grid(n, m),
        ("torus", &[n, m]) => shape::torus(n, m),
        ("triangle_torus", &[n, m]) => shape::triangle_torus(n, m),
        ("cylinder", &[n, m]) => shape::tube(n, m),
        ("disk", &[n]) => shape::fan(n),
        ("polygon", &[n]) => shape::single_polygon(n),
        ("pillow", &[n]) => shape::pillow(n),
        _ => Mesh::default(),
    }
}

impl Lowering<'_> {
    /// `assert c`; the message shows both sides of a comparison that does not hold, and the
    /// elements that the condition depends on.
    pub(super) fn assert(&mut self, condition: &Expr, reason: &str, span: Span) {
        let mark = self.asm.mark();
        let test = self.value(condition);
        let to = self.asm.label();
        self.asm.emit(Inst::JumpIf { condition: test, to });
        if let Some(mut sides) = sides(condition) {
            // `a > b` is computed as `b < a`.
            sides.sort_by_key(|side| side.span.start);
            let [left, right] = sides;
            self.show("the left side is ", left);
            self.show(", the right side ", right);
        }
        let mut before = if sides(condition).is_some() { ", where " } else { "where " };
        for (variable, name, ty) in self.whereabouts(condition) {
            self.print_text(&format!("{before}`{name}` is "));
            let from = self.names.local(variable);
            self.asm.emit(super::print::print_value(ty, from, Digits::All));
            before = ", ";
        }
        self.fail(reason, span);
        self.asm.bind(to);
        self.asm.release(mark);
    }

    /// `assert mesh == cube()`
    pub(super) fn assert_mesh(&mut self, mesh: u16, same: bool, reason: &str, span: Span) {
        let to = self.asm.reg();
        self.trap_at(span, Inst::MeshSame { mesh, to });
        let fine = self.asm.label();
        self.asm.emit(match same {
            true => Inst::JumpIf { condition: to, to: fine },
            false => Inst::JumpUnless { condition: to, to: fine },
        });
        if same {
            self.asm.emit(Inst::PrintDifference { mesh });
        }
        self.fail(reason, span);
        self.asm.bind(fine);
    }

    /// `assert refuses(flip(e), "the edge is there") else "…"`: the reason for which the operation
    /// must refuse, and the message if it does not.
    pub(super) fn assert_refuses(
        &mut self,
        op: usize,
        args: &[Expr],
        [why, reason]: [Option<&str>; 2],
        span: Span,
    ) {
        let (applied, _) = self.apply(op, args, span);
        let (refused, fine) = (self.asm.label(), self.asm.label());
        self.asm.emit(Inst::JumpUnless { condition: applied, to: refused });
        self.fail(reason.unwrap_or("the operation was applied"), span);
        self.asm.bind(refused);
        if let Some(why) = why {
            let (to, text) = (self.asm.reg(), self.asm.text(why));
            let op = narrow(op);
            self.asm.emit(Inst::RefusedFor { op, text, to });
            self.asm.emit(Inst::JumpIf { condition: to, to: fine });
            self.print_text("the reason is: ");
            self.asm.emit(Inst::PrintReason { op });
            self.fail(reason.unwrap_or("the operation was refused for another reason"), span);
        }
        self.asm.bind(fine);
    }

    fn show(&mut self, text: &str, value: &Expr) {
        self.print_text(text);
        let mark = self.asm.mark();
        let from = self.value(value);
        self.asm.emit(super::print::print_value(value.ty, from, Digits::All));
        self.asm.release(mark);
    }

    fn fail(&mut self, reason: &str, span: Span) {
        let text = self.asm.text(reason);
        let place = self.names.place(span);
        self.asm.trap_at(place, Inst::FailShowing { text });
    }
}

/// The sides of a comparison.
fn sides(condition: &Expr) -> Option<[&Expr; 2]> {
    match &condition.kind {
        ExprKind::Unary(Unary::Not, inner) => sides(inner),
        ExprKind::Binary(operator, left, right) => match operator {
            Binary::And | Binary::Or | Binary::EqualBool => None,
            _ => Some([left, right]),
        },
        _ => None,
    }
}
