//! Programs of several files: what is found, what is missing, and where it is told.
//!
//! In the pages, a line `//// name` begins another file, which the first may use.

use std::fs;
use std::path::Path;

use hedgerow::analysis::{Analysis, Reader, verdicts};
use hedgerow::diagnostic::{Diagnostic, Rendering, render};
use hedgerow::library;
use hedgerow::rewrite::Unwatched;
use hedgerow::run::{Conditions, test};
use hedgerow::source::Sources;

const PLAIN: Rendering = Rendering { colour: false, most: 20 };

/// The rounds in which fixes are applied.
const MOST_ROUNDS: usize = 4;

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
    let count = support::pages::check("language/files", |case| {
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
            // The text after its fixes, as often as new ones come to light.
            "mended" => {
                let mut text = case.input.to_owned();
                for _ in 0..MOST_ROUNDS {
                    text = after_fixes(&text).unwrap_or(text);
                }
                text
            }
            kind => panic!("{}: what is `{kind}`?", case.place),
        }
    });
    assert!(count >= 10, "only {count} cases");
}

/// The inputs of a page, each with the heading above it.
fn inputs(page: &str) -> Vec<(String, String)> {
    let mut heading = "";
    let mut found = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(words) = line.strip_prefix("## ") {
            heading = words;
        }
        if line == "```hedge" {
            let inside = lines.by_ref().take_while(|line| *line != "```");
            found.push((heading.to_owned(), inside.map(|line| format!("{line}\n")).collect()));
        }
    }
    found
}

/// The text with all fixes of its errors applied; none if there are none.
fn after_fixes(text: &str) -> Option<String> {
    let (_, analysis) = analysed(text);
    let errors = analysis.diagnostics.iter().filter(|told| told.is_error());
    let mut edits: Vec<_> =
        errors.flat_map(|told| &told.fixes).flat_map(|fix| &fix.edits).collect();
    edits.sort_by_key(|edit| std::cmp::Reverse((edit.span.start, edit.span.end)));
    let mut mended = text.to_owned();
    for edit in &edits {
        mended.replace_range(edit.span.range(), &edit.text);
    }
    (!edits.is_empty()).then_some(mended)
}

/// What is left to tell when all fixes of a text are applied, as often as new ones come to light;
/// nothing if there is an error without one.
fn left_after_fixes(text: &str) -> (usize, Vec<String>) {
    let mut text = text.to_owned();
    let mut applied = 0;
    let (_, analysis) = analysed(&text);
    if analysis.diagnostics.iter().any(|told| told.is_error() && told.fixes.is_empty()) {
        return (0, Vec::new());
    }
    for _ in 0..MOST_ROUNDS {
        let (_, analysis) = analysed(&text);
        let errors = analysis.diagnostics.iter().filter(|told| told.is_error());
        let Some(mended) = after_fixes(&text) else {
            let left = errors.map(|told| format!("{}: {}", told.code, told.message));
            return (applied, left.collect());
        };
        applied += errors.filter(|told| !told.fixes.is_empty()).count();
        text = mended;
    }
    (applied, vec!["fixes without an end".to_owned()])
}

/// Where every error has a fix, nothing is left to mend.
#[test]
fn every_fix_leaves_a_sound_file() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let mut applied = 0;
    let mut broken = Vec::new();
    for page in [
        "language/files/certain.md",
        "language/files/courses.md",
        "language/files/elsewhere.md",
        "language/files/newcomers.md",
        "language/files/students.md",
        "proof/laws/slips.md",
    ] {
        let text = fs::read_to_string(folder.join(page)).expect("a page");
        for (heading, input) in inputs(&text) {
            let (fixes, left) = left_after_fixes(&input);
            applied += fixes;
            if fixes > 0 && !left.is_empty() {
                broken.push(format!("{page}, {heading}: {left:?}"));
            }
        }
    }
    println!("{applied} fixes, {} with more to mend", broken.len());
    assert!(broken.is_empty(), "{}", broken.join("\n"));
    assert!(applied > 150, "only {applied} fixes");
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
        let conditions = Conditions::default();
        for number in 0..program.tests.len() {
            let mut load = |_: &str, _| Err("the library loads nothing".to_owned());
            if let Err(failed) = test(program, number, plans, conditions, &mut load, &mut Unwatched)
            {
                panic!("{}", render(&[failed.diagnostic], &sources, PLAIN));
            }
            passed += 1;
        }
    }
    assert!(passed >= 6, "only {passed} tests");
}
