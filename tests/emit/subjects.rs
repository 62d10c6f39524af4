//! The operations that are emitted: the examples, and others that guard and compute more.

use std::fs;
use std::path::{Path, PathBuf};

use hedgerow::analysis::{Analysis, Nowhere, Proved, callees};
use hedgerow::diagram::Callee;
use hedgerow::emit::{Style, cpp};
use hedgerow::rewrite::Plan;
use hedgerow::source::Sources;

use crate::examples::examples;
use crate::ops::OPS;

/// What is refused, and why.
const NOT_EMITTED: [&str; 0] = [];

/// An operation: its proof, from which code is emitted, and its plan, which the machine runs.
pub struct Subject {
    pub name: String,
    pub proved: Proved,
    pub plan: Plan,
    /// The functions of its program.
    pub functions: Vec<Option<Callee>>,
}

/// The functions that the operations call: those of the one program that has any.
pub fn functions(subjects: &[Subject]) -> Vec<Option<Callee>> {
    let mut all = subjects.iter().map(|subject| &subject.functions);
    all.find(|functions| !functions.is_empty())
        .cloned()
        .unwrap_or_default()
}

pub fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// All operations, each under a name of its own.
pub fn subjects() -> Vec<Subject> {
    let mut texts = Vec::new();
    let mut paths = examples();
    paths.push(folder("src/library/std/polygon.hedge"));
    paths.push(folder("tests/emit/attributes.hedge"));
    paths.push(folder("tests/emit/guards.hedge"));
    paths.push(folder("tests/emit/values.hedge"));
    paths.push(folder("tests/families/more.hedge"));
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
    let mut subjects = Vec::new();
    for (stem, text) in texts {
        for name in op_names(&text) {
            let renamed = format!("{stem}_{name}");
            // Where it is declared, and where other items call it.
            let text = text.replace(&format!(" {name}("), &format!(" {renamed}("));
            let text = text.replace(&format!("({name}("), &format!("({renamed}("));
            subjects.extend(subject(&text, &renamed));
        }
    }
    // What cannot be emitted is said by name.
    let emits = |subject: &Subject| cpp(&[&subject.proved], &subject.functions, &Style::default());
    let (emitted, others): (Vec<_>, Vec<_>) = subjects
        .into_iter()
        .partition(|subject| emits(subject).is_ok());
    let others: Vec<_> = others
        .iter()
        .map(|other| format!("{}: {}", other.name, emits(other).unwrap_err().what))
        .collect();
    assert_eq!(others, NOT_EMITTED);
    assert!(emitted.len() > 40, "only {} operations", emitted.len());
    emitted
}

fn op_names(text: &str) -> Vec<String> {
    let starts = text.lines().filter_map(|line| line.strip_prefix("op "));
    let names = starts.filter_map(|line| line.split('(').next());
    names.map(str::to_string).collect()
}

/// The op of that name; scripts of the text may call another one that is gone.
fn subject(text: &str, name: &str) -> Option<Subject> {
    let text = text.split("\nscript ").next()?;
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    assert!(analysis.is_sound(), "{name}: {:?}", analysis.diagnostics);
    let at = analysis.op(name)?;
    Some(Subject {
        name: name.to_string(),
        proved: analysis.proved[at].clone()?,
        plan: analysis.plans[at].clone()?,
        functions: callees(&analysis.program),
    })
}
