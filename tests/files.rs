//! Programs of several files: what is found, what is missing, and where it is told.
//!
//! In the pages, a line `//// name` begins another file, which the first may use.

mod pages;

use hedgerow::analysis::{Analysis, Reader, verdicts};
use hedgerow::diagnostic::{Diagnostic, Rendering, render};
use hedgerow::library;
use hedgerow::rewrite::Unwatched;
use hedgerow::run::test;
use hedgerow::source::Sources;

const PLAIN: Rendering = Rendering { colour: false, most: 20 };

/// Files in memory.
struct Pages<'p>(Vec<(&'p str, String)>);

impl Reader for Pages<'_> {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let found = self.0.iter().find(|(known, _)| *known == name);
        let found = found.map(|(_, text)| text.clone());
        found.ok_or_else(|| "there is no such file".to_owned())
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        self.0.iter().map(|(name, _)| (*name).to_owned()).collect()
    }
}

fn analysed(page: &str) -> (Sources, Analysis) {
    let mut files = page.split("//// ");
    let root = files.next().expect("a page has a text");
    let others = files.map(|file| {
        let (name, text) = file.split_once('\n').expect("a name, then a text");
        (name.trim(), text.to_owned())
    });
    let mut others = Pages(others.collect());
    let mut sources = Sources::new();
    let file = sources.add("page.hedge", root);
    let analysis = Analysis::with(&mut sources, file, &mut others);
    (sources, analysis)
}

#[test]
fn pages_hold() {
    let count = pages::check("files", |case| {
        let (sources, analysis) = analysed(case.input);
        match case.kind {
            "diagnostics" => render(&analysis.diagnostics, &sources, PLAIN),
            "items" => {
                let items = analysis.program.ops.iter().map(|op| (&op.name, op.span));
                let scripts = analysis.program.scripts.iter();
                let items = items.chain(scripts.map(|script| (&script.name, script.span)));
                let line = |(name, span): (&String, hedgerow::source::Span)| {
                    let home = sources.get(span.file).name();
                    let seen = analysis.seen.contains(&span.file);
                    format!("{home}: {name}{}\n", if seen { "" } else { ", not seen" })
                };
                items.map(line).collect()
            }
            // In a line each, for pages with many: what is told, and what is offered.
            "told" => {
                let line = |told: &Diagnostic| {
                    let (line, column) =
                        sources.get(told.span().file).line_column(told.span().start as usize);
                    let notes = told.notes.iter().map(|note| format!("  note: {note}\n"));
                    let fixes = told.fixes.iter().map(|fix| format!("  help: {}\n", fix.title));
                    let more: String = notes.chain(fixes).collect();
                    format!("{line}:{column} {}: {}\n{more}", told.code, told.message)
                };
                let count = analysis.diagnostics.len();
                assert_eq!(count, 1, "{}: one mistake, {count} errors", case.place);
                analysis.diagnostics.iter().map(line).collect()
            }
            kind => panic!("{}: what is `{kind}`?", case.place),
        }
    });
    assert!(count >= 10, "only {count} cases");
}

#[test]
fn the_library_is_proved() {
    let mut proved = 0;
    for file in library::files() {
        let mut sources = Sources::new();
        let root = sources.add(file.name, file.text);
        let analysis = Analysis::with(&mut sources, root, &mut Pages(Vec::new()));
        let told = render(&analysis.diagnostics, &sources, PLAIN);
        assert!(analysis.diagnostics.is_empty(), "{}:\n{told}", file.name);
        for verdict in verdicts(&analysis) {
            assert!(verdict.proved, "{} of {}", verdict.op, file.name);
            proved += 1;
        }
    }
    assert!(proved >= 3, "only {proved} ops");
}

#[test]
fn the_tests_of_the_library_pass() {
    let mut passed = 0;
    for file in library::files() {
        let mut sources = Sources::new();
        let root = sources.add(file.name, file.text);
        let analysis = Analysis::with(&mut sources, root, &mut Pages(Vec::new()));
        let (program, plans) = (&analysis.program, &analysis.plans);
        for number in 0..program.tests.len() {
            let mut load = |_: &str, _| Err("the library loads nothing".to_owned());
            if let Err(failed) = test(program, number, plans, 0, &mut load, &mut Unwatched) {
                panic!("{}", render(&[failed.diagnostic], &sources, PLAIN));
            }
            passed += 1;
        }
    }
    assert!(passed >= 6, "only {passed} tests");
}
