//! Emitted code to be read: a few operations in both languages, as committed.

use std::fs;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::emit::{Selection, Style, cpp, rust};
use hedgerow::source::Sources;
use support::emission::subjects::folder;

/// An operation of each kind: without choices, with a fan and tests of its own, with a family,
/// with a guard, with attributes, and in steps.
const GOLDEN: [(&str, &str); 6] = [
    ("examples/flip.hedge", "flip"),
    ("examples/collapse.hedge", "collapse"),
    ("examples/families.hedge", "inset"),
    ("tests/emit/guards.hedge", "flip_simply"),
    ("tests/emit/attributes.hedge", "split_marked"),
    ("tests/emit/steps.hedge", "divide"),
];

#[test]
fn emitted_code_is_as_committed() {
    let update = std::env::var_os("UPDATE").is_some_and(|value| value == "1");
    let mut differing = Vec::new();
    for (path, name) in GOLDEN {
        let mut sources = Sources::new();
        let file = sources.add(path, fs::read_to_string(folder(path)).unwrap());
        let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
        let op = analysis.program.ops.iter().position(|op| op.name == name);
        let selection = Selection {
            program: &analysis.program,
            proved: &analysis.proved,
            sources: &sources,
            ops: &[op.unwrap_or_else(|| panic!("{path} has no `{name}`"))],
            exhaustive: false,
        };
        for (end, code) in [("cpp", cpp(&selection, &Style::default())), ("rs", rust(&selection))] {
            let code = code.expect("it can be emitted");
            let golden = folder("tests/emit/golden").join(format!("{name}.{end}"));
            if update {
                fs::write(golden, code).unwrap();
            } else if fs::read_to_string(&golden).ok().as_ref() != Some(&code) {
                differing.push(golden);
            }
        }
    }
    assert!(differing.is_empty(), "{differing:?}: UPDATE=1 writes them anew");
}
