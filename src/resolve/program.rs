//! A program: operations as diagrams, scripts as typed statements.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use crate::diagram::{self, Access, Attribute, Collection, Expr, Param, Type};
use crate::source::{FileId, Span};
use crate::syntax::tree::{Digits, qualified};

/// Everything the files of a program declare, as far as it could be resolved.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// The qualifiers of the names that each file declares.
    pub qualifiers: HashMap<FileId, String>,
    /// The names of the private ops, functions and scripts, which only their own files see.
    pub private: HashSet<Span>,
    /// The attributes that elements have; an [`Access`] names one by its number.
    pub attributes: Arc<[Attribute]>,
    /// The operations. One that could not be resolved keeps its index, so that its calls can be
    /// resolved.
    pub ops: Vec<Op>,
    /// The functions. One that could not be resolved keeps its index as well.
    pub functions: Vec<Function>,
    /// The scripts that could be resolved.
    pub scripts: Vec<Script>,
    /// For each script, in the order of the numbers that follow those of the functions: its name
    /// and place, and its index in `scripts`, if it could be resolved.
    pub called_scripts: Vec<(String, Span, Option<usize>)>,
    /// The tests that could be resolved.
    pub tests: Vec<Test>,
    /// The tests that could not be resolved: name and span.
    pub unread_tests: Vec<(String, Span)>,
}

impl Program {
    /// The names of operations, qualified where two have the same.
    pub fn names_of_ops(&self, ops: impl IntoIterator<Item = usize>) -> Vec<String> {
        let ops: Vec<&Op> = ops.into_iter().filter_map(|op| self.ops.get(op)).collect();
        let name = |op: &&Op| {
            let is_like = |other: &&Op| other.name == op.name && other.span != op.span;
            match self.qualifiers.get(&op.span.file) {
                Some(file) if ops.iter().any(is_like) => qualified(file, &op.name),
                _ => op.name.clone(),
            }
        };
        ops.iter().map(name).collect()
    }

    /// The bodies of all functions, ops in steps, scripts and tests.
    fn bodies(&self) -> impl Iterator<Item = &Body> {
        let functions = self.functions.iter().filter_map(|of| of.body.as_ref());
        let steps = self.ops.iter().filter_map(|op| Some(&op.steps.as_ref()?.body));
        let tests = self.tests.iter().map(|test| &test.script);
        let scripts = self.scripts.iter().chain(tests).map(|script| &script.body);
        functions.chain(steps).chain(scripts)
    }

    /// The variables, parameters included, of all functions, ops in steps, scripts and tests.
    pub fn variables(&self) -> impl Iterator<Item = &Variable> {
        self.bodies().flat_map(|body| &body.variables)
    }

    /// All statements of functions, ops in steps, scripts and tests, those inside others, too.
    pub fn statements(&self) -> Vec<&Statement> {
        let mut all = Vec::new();
        for statement in self.bodies().flat_map(|body| &body.block) {
            statement.each(&mut |inner| all.push(inner));
        }
        all
    }
}

/// An operation, possibly only partly resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Op {
    pub name: String,
    /// The span of its name.
    pub span: Span,
    /// Its parameters. One of invalid type counts as a real; then there is no diagram.
    pub params: Vec<Param>,
    /// The type of its result; also `None` if the type is unknown.
    pub result: Option<Type>,
    /// Its diagram; `None` if it could not be resolved (a diagnostic says why) or if this is an op
    /// in steps.
    pub diagram: Option<diagram::Op>,
    /// A diagram for finding contradictions in `before` alone, if `diagram` is missing but every
    /// `before` could be resolved: the op that draws `before` on both sides.
    pub still: Option<Box<diagram::Op>>,
    /// The diagram whose only errors are loops that do not end where they begin; then there is no
    /// other.
    pub open: Option<Box<diagram::Op>>,
    /// The steps, if this is an op in steps that could be resolved.
    pub steps: Option<Steps>,
    /// True if it could not be read as it is written; then it cannot be proved.
    pub misread: bool,
}

/// An op that calls other ops as one transaction: all or nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    pub docs: Vec<String>,
    /// The conditions that are tested first, in order.
    pub requires: Vec<diagram::Require>,
    /// The level of mesh that it requires and keeps.
    pub level: diagram::Level,
    /// The properties that it claims to keep, with their places.
    pub keeps: Vec<(diagram::Property, Span)>,
    /// The statements. Parameters are its first variables.
    pub body: Body,
}

/// A function, possibly only partly resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    pub name: String,
    /// The span of its name.
    pub span: Span,
    pub docs: Vec<String>,
    /// Its parameters: variables 0, 1, … of the function.
    pub params: Vec<Param>,
    /// The type of its value, if it returns one.
    pub result: Option<Type>,
    /// The statements; `None` if they could not be resolved (a diagnostic says why).
    pub body: Option<Body>,
}

/// The body of a function, script or op in steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// All its variables, parameters first.
    pub variables: Vec<Variable>,
    /// Its statements. If it returns a value, every path through them ends with a `Return`.
    pub block: Block,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    pub name: String,
    /// The span of its name.
    pub span: Span,
    pub docs: Vec<String>,
    /// Its parameters: variables 0, 1, … of the script.
    pub params: Vec<Param>,
    pub body: Body,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// The mesh that it starts with.
    pub begin: TestMesh,
    /// The meshes that its statements name by number.
    pub meshes: Vec<TestMesh>,
    /// The statements: a script without parameters, named as the test is.
    pub script: Script,
}

#[derive(Clone, Debug, PartialEq)]
pub enum TestMesh {
    /// An empty mesh: nothing has been kept there yet.
    Empty,
    /// `grid(3, 4)`; the sizes are in the range that the constructor accepts.
    Made { constructor: String, sizes: Vec<u32> },
    /// `load("cube.obj")`
    Loaded { path: String, span: Span },
}

/// A variable of a script.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    pub name: String,
    pub ty: Type,
    /// The place of its declaration.
    pub span: Span,
}

/// Statements in order.
pub type Block = Vec<Statement>;

#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    pub kind: StatementKind,
    pub span: Span,
}

/// The kind of a statement. Variables are numbers into [`Body::variables`].
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `let x = …`, `var x = …`, `x = …`
    Set { variable: u32, value: Expr },
    /// `v.position = …`; takes effect at once, except in `update`.
    Write { target: Expr, attribute: Access, value: Expr },
    /// `repeat n { … }`
    Repeat { count: Expr, body: Block },
    /// `while c { … }`
    While { condition: Expr, body: Block },
    /// `for x in xs where c { … }`, `update x in xs where c { … }`: visits the elements that exist
    /// when the loop starts and still exist when their turn comes. In a `parallel for`, which has
    /// a filter, only those that also pass the filter when the loop starts.
    For {
        variable: u32,
        collection: Collection,
        filter: Option<Expr>,
        body: Block,
        visit: Visit,
        parallel: bool,
    },
    /// `drain x in xs by key while c { … }`: takes the element with the least key first and keeps
    /// keys up to date. The condition may refer to the element too.
    Drain { variable: u32, collection: Collection, key: Expr, condition: Option<Expr>, body: Block },
    /// `if c { … } else { … }`
    If { condition: Expr, then: Block, otherwise: Block },
    /// A call of an op, with an argument for each parameter: defaults are filled in. Refusals are
    /// counted. `if let m = split(e) { … } else { … }`; without a variable, `if split(e) { … }`.
    /// The variable is set before `then` and keeps its value after the statement, so
    /// `let m = must split(e)` has an empty `then` and [`StatementKind::Refused`] as `otherwise`.
    /// For the statement `split(e)` both are empty.
    Apply { op: usize, args: Vec<Expr>, variable: Option<u32>, then: Block, otherwise: Block },
    /// `print a, b`
    Print(Vec<Print>),
    /// `assert c else "…"`
    Assert { condition: Expr, reason: String },
    /// `require c else "…"`, in the steps of an op: the op refuses unless the condition holds.
    Require { condition: Expr, reason: String },
    /// The op called last, under `must`, has refused: the script stops with its reason.
    Refused { op: usize },
    /// `let start = mesh`, in tests
    KeepMesh { mesh: u16 },
    /// `assert mesh == start`, `assert mesh != cube()`, in tests
    AssertMesh { mesh: u16, same: bool, reason: String },
    /// `assert refuses(flip(e), "…")`, in tests
    AssertRefuses { op: usize, args: Vec<Expr>, why: Option<String>, reason: Option<String> },
    /// `break`, out of the innermost loop.
    Break,
    /// `continue`, with the next iteration of the innermost loop.
    Continue,
    /// `return`, `return x`, from the function or script.
    Return(Option<Expr>),
    /// A call of a function as a statement, with an argument for each parameter. Its value, of type
    /// `result`, is dropped.
    Call { function: u32, args: Vec<Expr>, result: Option<Type> },
}

/// The way in which a loop visits elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visit {
    /// `for x in xs`
    InOrder,
    /// `for x in shuffle(xs)`
    Shuffled,
    /// `update x in xs`: the `Write`s of the body are deferred to the end. The body only computes,
    /// writes and branches.
    Update,
}

/// A piece of the output of `print`; pieces are printed one after the other.
#[derive(Clone, Debug, PartialEq)]
pub enum Print {
    Text(String),
    Value(Expr, Digits),
}
