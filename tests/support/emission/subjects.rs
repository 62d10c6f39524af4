//! The operations that are emitted: the examples, and others that guard and compute more.

use std::fs;
use std::path::{Path, PathBuf};

use hedgerow::analysis::{Analysis, Nowhere, Proved};
use hedgerow::diagram::{Attribute, Param, Type};
use hedgerow::emit::{Selection, Style, cpp};
use hedgerow::resolve::Program;
use hedgerow::rewrite::{Plan, Plans};
use hedgerow::source::Sources;

use crate::guarded::OPS;
use crate::reference::examples::examples;

/// The operations that cannot be emitted, with the reasons.
const NOT_EMITTED: [&str; 0] = [];

/// An operation as the machine runs it.
pub struct Subject {
    pub name: String,
    pub params: Vec<Param>,
    pub result: Option<Type>,
    /// The attributes of its program.
    pub attributes: Vec<Attribute>,
    pub plan: Plan,
    /// The plans of its program, which steps call.
    pub plans: Plans,
}

/// Operations that are emitted together.
pub struct Emission {
    /// The name of the group.
    pub name: String,
    pub program: Program,
    pub proved: Vec<Option<Proved>>,
    pub sources: Sources,
    pub ops: Vec<usize>,
    pub subjects: Vec<Subject>,
}

impl Emission {
    /// The selection of all its operations.
    pub fn selection(&self) -> Selection<'_> {
        self.of(&self.ops)
    }

    /// The selection of some operations.
    pub fn of<'e>(&'e self, ops: &'e [usize]) -> Selection<'e> {
        Selection {
            program: &self.program,
            proved: &self.proved,
            sources: &self.sources,
            ops,
            exhaustive: false,
        }
    }

    /// The reason why an operation cannot be emitted, if there is one.
    fn refuses(&self, op: usize) -> Option<String> {
        let refused = cpp(&self.of(&[op]), &Style::default()).err()?;
        Some(refused.what)
    }
}

/// A path of the repository.
pub fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// All operations, each with a unique name: first the drawn ones, then those in steps, file by
/// file.
pub fn emissions() -> Vec<Emission> {
    let mut all = vec![drawn()];
    for path in ["src/library/std/polygon.hedge", "tests/emit/steps.hedge"] {
        all.push(in_steps(path));
    }
    all
}

/// All drawn operations, with the functions of `values.hedge`: those of others call none.
fn drawn() -> Emission {
    let mut texts = Vec::new();
    let mut paths = examples();
    paths.push(folder("src/library/std/polygon.hedge"));
    paths.push(folder("tests/emit/attributes.hedge"));
    paths.push(folder("tests/emit/guards.hedge"));
    paths.push(folder("tests/emit/values.hedge"));
    paths.push(folder("tests/proof/families/more.hedge"));
    for path in paths {
        let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
        texts.push((stem, fs::read_to_string(path).unwrap()));
    }
    for op in OPS {
        for level in ["surface", "simple"] {
            let text = op.text.replace("GUARD", &format!("guard {level}"));
            texts.push((level.to_string(), text));
        }
    }
    let mut all = Emission {
        name: "drawn".into(),
        program: Program::default(),
        proved: Vec::new(),
        sources: Sources::new(),
        ops: Vec::new(),
        subjects: Vec::new(),
    };
    for (stem, text) in texts {
        for name in op_names(&text) {
            let renamed = format!("{stem}_{name}");
            let Some((subject, proved, program, sources)) =
                subject(&renaming(&text, &stem, &name), &renamed)
            else {
                continue;
            };
            if stem == "values" && all.program.functions.is_empty() {
                all.program.functions = program.functions;
                all.sources = sources;
            }
            all.proved.push(Some(proved));
            all.subjects.push(subject);
        }
    }
    // Operations that cannot be emitted are listed by name.
    let mut others = Vec::new();
    for (op, subject) in all.subjects.iter().enumerate() {
        match all.refuses(op) {
            None => all.ops.push(op),
            Some(what) => others.push(format!("{}: {what}", subject.name)),
        }
    }
    assert_eq!(others, NOT_EMITTED);
    let mut at = 0;
    all.subjects.retain(|_| {
        at += 1;
        all.ops.contains(&(at - 1))
    });
    assert!(all.ops.len() > 40, "only {} operations", all.ops.len());
    all
}

/// The operations in steps of a file, and the drawn operations next to them.
fn in_steps(path: &str) -> Emission {
    let stem = Path::new(path).file_stem().unwrap().to_string_lossy();
    let mut text = fs::read_to_string(folder(path)).unwrap();
    for name in op_names(&text) {
        text = renaming(&text, &stem, &name);
    }
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    assert!(analysis.is_sound(), "{:?}", analysis.diagnostics);
    let plans = Plans::clone(&analysis.plans);
    let (mut ops, mut subjects) = (Vec::new(), Vec::new());
    for (at, op) in analysis.program.ops.iter().enumerate() {
        if op.span.file != file || op.steps.is_none() {
            continue;
        }
        ops.push(at);
        subjects.push(Subject {
            name: op.name.clone(),
            params: op.params.clone(),
            result: op.result,
            attributes: analysis.program.attributes.to_vec(),
            plan: plans[at].clone().expect("a sound op has a plan"),
            plans: Plans::clone(&plans),
        });
    }
    assert!(!ops.is_empty(), "{path} has no steps");
    Emission {
        name: format!("{stem}_in_steps"),
        program: analysis.program,
        proved: analysis.proved,
        sources,
        ops,
        subjects,
    }
}

/// The text with an operation prefixed by the stem of its file, where it is declared and called.
fn renaming(text: &str, stem: &str, name: &str) -> String {
    let renamed = format!("{stem}_{name}");
    let text = text.replace(&format!(" {name}("), &format!(" {renamed}("));
    text.replace(&format!("({name}("), &format!("({renamed}("))
}

fn op_names(text: &str) -> Vec<String> {
    let starts = text.lines().filter_map(|line| line.strip_prefix("op "));
    let names = starts.filter_map(|line| line.split('(').next());
    names.map(str::to_string).collect()
}

/// The drawn op of that name, without the scripts of the text, which may call ops that were
/// renamed.
fn subject(text: &str, name: &str) -> Option<(Subject, Proved, Program, Sources)> {
    let text = text.split("\nscript ").next()?;
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    assert!(analysis.is_sound(), "{name}: {:?}", analysis.diagnostics);
    let at = analysis.op(name)?;
    let proved = analysis.proved[at].clone()?;
    let op = proved.op();
    let attributes = op.rules.first().map(|rule| rule.attributes.to_vec());
    let subject = Subject {
        name: name.to_string(),
        params: op.params.clone(),
        result: op.result,
        attributes: attributes.unwrap_or_default(),
        plan: analysis.plans[at].clone()?,
        plans: Plans::default(),
    };
    Some((subject, proved, analysis.program, sources))
}
