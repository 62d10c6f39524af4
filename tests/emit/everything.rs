//! Every operation that is proved can be emitted, whatever file it stands in.

use std::fs;
use std::path::PathBuf;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::diagram::{functions, overloads};
use hedgerow::emit::{Selection, Style, cpp, rust};
use hedgerow::source::Sources;

use support::emission::subjects::folder;
use support::reference::examples::examples;

/// The examples, the library, and what other tests try.
fn paths() -> Vec<PathBuf> {
    let mut paths = examples();
    let library = fs::read_dir(folder("src/library/std")).unwrap();
    paths.extend(library.map(|entry| entry.unwrap().path()));
    let others = [
        "tests/proof/aliases/ops.hedge",
        "tests/proof/battery/more.hedge",
        "tests/proof/battery/odd.hedge",
        "tests/emit/guards.hedge",
        "tests/proof/families/more.hedge",
    ];
    paths.extend(others.map(folder));
    paths.sort();
    paths
}

#[test]
fn every_proved_operation_is_emitted() {
    let (mut emitted, mut refused) = (0, Vec::new());
    for path in paths() {
        let mut sources = Sources::new();
        let file = sources.add(path.to_string_lossy(), fs::read_to_string(&path).unwrap());
        let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
        for (at, op) in analysis.program.ops.iter().enumerate() {
            let is_known = analysis.proved[at].is_some() || op.steps.is_some();
            if op.span.file != file || !is_known {
                continue;
            }
            let selection = Selection {
                program: &analysis.program,
                proved: &analysis.proved,
                sources: &sources,
                ops: &[at],
                exhaustive: false,
            };
            let made = [cpp(&selection, &Style::default()), rust(&selection)];
            for failure in made.into_iter().filter_map(Result::err) {
                refused.push(format!("{}::{}: {}", path.display(), op.name, failure.what));
            }
            emitted += 1;
        }
    }
    assert_eq!(refused, Vec::<String>::new());
    assert!(emitted > 100, "only {emitted} operations");
}

#[test]
fn every_builtin_has_a_spelling() {
    let table = include_str!("../../src/emit/value/spellings.txt");
    let names: Vec<_> = table.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let ways = functions().flat_map(overloads);
    for builtin in ways.map(|way| way.builtin).filter(|builtin| !builtin.is_random()) {
        let name = format!("{builtin:?}");
        let of = format!("of.{name}");
        assert!(names.contains(&name.as_str()) || names.contains(&of.as_str()), "{name}");
    }
}
