//! A program: operations as diagrams, scripts as typed statements.

use std::sync::Arc;

use crate::diagram::{self, Access, Attribute, Collection, Expr, Param, Type};
use crate::source::Span;
use crate::syntax::tree::Digits;

/// Everything one file declares, as far as it could be understood.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// The attributes that elements have; an [`Access`] names one by its number.
    pub attributes: Arc<[Attribute]>,
    /// The operations; one that could not be resolved keeps its place, so that
    /// calls of it are understood.
    pub ops: Vec<Op>,
    /// The functions; one that could not be resolved keeps its place as well.
    pub functions: Vec<Function>,
    /// The scripts that could be resolved.
    pub scripts: Vec<Script>,
    /// All scripts as what can be called, by the numbers behind those of the functions: the place
    /// of each among the scripts, if it could be resolved.
    pub called_scripts: Vec<Option<usize>>,
    /// The tests that could be resolved.
    pub tests: Vec<Test>,
    /// The tests that could not be resolved: their names, and where these stand.
    pub unread_tests: Vec<(String, Span)>,
}

impl Program {
    /// The variables of all its code, with the parameters: of functions, of ops in steps, of
    /// scripts and of tests.
    pub fn variables(&self) -> impl Iterator<Item = &Variable> {
        let functions = self.functions.iter().filter_map(|of| of.body.as_ref());
        let steps = self.ops.iter().filter_map(|op| Some(&op.steps.as_ref()?.body));
        let bodies = functions.chain(steps).map(|body| &body.variables);
        let tests = self.tests.iter().map(|test| &test.script);
        let scripts = self.scripts.iter().chain(tests);
        let scripts = scripts.map(|script| &script.variables);
        bodies.chain(scripts).flatten()
    }
}

/// An operation, or what is known of one that could not be resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Op {
    /// Its name.
    pub name: String,
    /// The span of its name.
    pub span: Span,
    /// Its parameters. One whose type could not be understood counts as a real; there is
    /// no diagram then.
    pub params: Vec<Param>,
    /// The type of its result; `None` also if it could not be found out.
    pub result: Option<Type>,
    /// Its diagrams; `None` if they could not be resolved (a diagnostic says why), or if it is
    /// an op in steps.
    pub diagram: Option<diagram::Op>,
    /// A diagram for contradictions, where they could not be resolved, but what stands in each `before`
    /// could: the op that draws that on both sides. Whether it contradicts itself can be told
    /// without the rest.
    pub still: Option<Box<diagram::Op>>,
    /// The steps instead, if it is an op in steps that could be resolved.
    pub steps: Option<Steps>,
}

/// An op that calls others, all or nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    /// Its doc comment.
    pub docs: Vec<String>,
    /// The conditions that are tested before, in order.
    pub requires: Vec<diagram::Require>,
    /// The level of the meshes it is for, and that it keeps.
    pub level: diagram::Level,
    /// The statements. Parameters are its first variables.
    pub body: Body,
}

/// A function, or what is known of one that could not be resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// The span of its name.
    pub span: Span,
    /// Its doc comment.
    pub docs: Vec<String>,
    /// Its parameters: variables 0, 1, … of the function.
    pub params: Vec<Param>,
    /// The type of its value, if it gives one.
    pub result: Option<Type>,
    /// The statements; `None` if that could not be resolved (a diagnostic says why).
    pub body: Option<Body>,
}

/// The body of a function.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// All its variables, parameters first.
    pub variables: Vec<Variable>,
    /// Its statements. Every way through them ends with a `Return`, if it gives a value.
    pub block: Block,
}

/// A script.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    /// Its name.
    pub name: String,
    /// The span of its name.
    pub span: Span,
    /// Its doc comment.
    pub docs: Vec<String>,
    /// Its parameters: variables 0, 1, … of the script.
    pub params: Vec<Param>,
    /// All its variables, parameters first.
    pub variables: Vec<Variable>,
    /// Its kind.
    pub body: Block,
}

/// A test.
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// The mesh that it begins with.
    pub begin: TestMesh,
    /// The meshes that its statements name by number.
    pub meshes: Vec<TestMesh>,
    /// The statements: a script without parameters, named as the test is.
    pub script: Script,
}

/// A mesh of a test.
#[derive(Clone, Debug, PartialEq)]
pub enum TestMesh {
    /// One without elements: nothing has been kept there yet.
    Empty,
    /// `grid(3, 4)`; the sizes are such as the constructor can take.
    Made { constructor: String, sizes: Vec<u32> },
    /// `load("cube.obj")`
    Loaded { path: String, span: Span },
}

/// A variable of a script.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// The place of its declaration.
    pub span: Span,
}

/// Statements in order.
pub type Block = Vec<Statement>;

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Its kind.
    pub kind: StatementKind,
    /// Its place in the source.
    pub span: Span,
}

/// The kind of a statement. Variables are numbers into [`Script::variables`].
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `let x = …`, `var x = …`, `x = …`
    Set { variable: u32, value: Expr },
    /// `v.position = …` outside of `update`: at once.
    Write { target: Expr, attribute: Access, value: Expr },
    /// `repeat n { … }`
    Repeat { count: Expr, body: Block },
    /// `while c { … }`
    While { condition: Expr, body: Block },
    /// `for x in xs where c { … }`, `update x in xs where c { … }`: elements that exist when the
    /// loop starts and still exist when their turn comes.
    For { variable: u32, collection: Collection, filter: Option<Expr>, body: Block, visit: Visit },
    /// `drain x in xs by key while c { … }`: the element with the least key first, and keys
    /// kept current. The condition, too, may name the element.
    Drain { variable: u32, collection: Collection, key: Expr, condition: Option<Expr>, body: Block },
    /// `if c { … } else { … }`
    If { condition: Expr, then: Block, otherwise: Block },
    /// The call of an op, with an argument for each parameter; defaults are filled in, and
    /// refusals are counted. `if let m = split(e) { … } else { … }`; without a variable,
    /// `if split(e) { … }`. The variable is set before `then` and keeps its value after the
    /// statement, so `let m = must split(e)` is this with an empty `then` and, as `otherwise`,
    /// [`StatementKind::Refused`]. Of `split(e)` as a statement both are empty.
    Apply { op: usize, args: Vec<Expr>, variable: Option<u32>, then: Block, otherwise: Block },
    /// `print a, b`
    Print(Vec<Print>),
    /// `assert c else "…"`
    Assert { condition: Expr, reason: String },
    /// `require c else "…"`, in the steps of an op: it refuses unless the condition holds
    Require { condition: Expr, reason: String },
    /// The op called last has refused, and must not: the script stops with its reason
    Refused { op: usize },
    /// `let start = mesh`, in tests
    KeepMesh { mesh: u16 },
    /// `assert mesh == start`, `assert mesh != cube()`, in tests
    AssertMesh { mesh: u16, same: bool, reason: String },
    /// `assert refuses(flip(e), "…")`, in tests
    AssertRefuses { op: usize, args: Vec<Expr>, reason: Option<String> },
    /// `break`, of the innermost loop
    Break,
    /// `continue`, with the innermost loop
    Continue,
    /// `return`, `return x`: of the function or script
    Return(Option<Expr>),
    /// The call of a function as a statement, with an argument for each parameter. Its value,
    /// of this type, is dropped.
    Call { function: u32, args: Vec<Expr>, result: Option<Type> },
}

/// The way in which a loop visits elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visit {
    /// `for x in xs`
    InOrder,
    /// `for x in shuffle(xs)`
    Shuffled,
    /// `update x in xs`: a `Write` in the body is kept back to the end. The body only computes,
    /// writes and chooses.
    Update,
}

/// A piece of what `print` prints, one behind the other.
#[derive(Clone, Debug, PartialEq)]
pub enum Print {
    /// A text.
    Text(String),
    /// A value.
    Value(Expr, Digits),
}
