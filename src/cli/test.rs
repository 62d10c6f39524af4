//! `hedgerow test`

use std::ops::ControlFlow;
use std::path::Path;

use serde::Serialize;

use super::arguments::{Format, TestArguments};
use super::check::{DiagnosticReport, report, reports};
use super::failure::Failure;
use super::option_groups::RepairArguments;
use super::output::{eprint_diagnostics, eprint_line, print_json, print_line};
use super::program::{self, Program};
use super::{interrupt, memory, meshes};
use crate::analysis::{Analysis, expect_regular};
use crate::diagnostic::Diagnostic;
use crate::mesh::MeshFile;
use crate::rewrite::Watch;
use crate::run::{self, Conditions};
use crate::source::Span;

/// The largest mesh that a program loads, in bytes: 1 GiB.
const LARGEST_MESH: u64 = 1 << 30;

/// Runs the tests of files, and prints which fail.
pub(super) fn test(arguments: &TestArguments) -> Result<(), Failure> {
    interrupt::listen();
    let mut files = Vec::new();
    let mut unreadable = None;
    for path in &arguments.files {
        match program::read(path) {
            Ok(program) => files.push(run_file(&program, path, arguments)),
            Err(failure) => {
                // The other files are still worth a run.
                failure.tell();
                files.push(FileReport::unreadable(path, &failure));
                unreadable = Some(failure.exit_code());
            }
        }
    }
    let all = || files.iter().flat_map(|file| &file.tests);
    let failed = all().filter(|test| !test.passed).count();
    let passed = all().count() - failed;
    let sound = files.iter().all(|file| file.sound);
    match arguments.format {
        Format::Json => print_json(&Summary { passed, failed, files })?,
        Format::Human => {
            let mut told = format!("{passed} passed, {failed} failed");
            let broken: usize = files.iter().map(|file| file.broken.len()).sum();
            if broken > 0 {
                told.push_str(&format!(", {broken} not run"));
            }
            print_line(&told);
            if passed + failed + broken == 0 && unreadable.is_none() {
                eprint_line(&match &arguments.filter {
                    Some(filter) if arguments.exact => {
                        format!("warning: no test is called `{filter}`")
                    }
                    Some(filter) => format!("warning: no test has `{filter}` in its name"),
                    None => "warning: there is no `test`".to_owned(),
                });
            }
        }
    }
    match unreadable {
        _ if interrupt::is_asked() => Err(Failure::Silent(interrupt::CODE.into())),
        Some(code) => Err(Failure::Silent(code)),
        None if failed > 0 || !sound => Err(Failure::NotProved),
        None => Ok(()),
    }
}

fn run_file(program: &Program, path: &Path, arguments: &TestArguments) -> FileReport {
    let is_human = arguments.format == Format::Human;
    let analysis = &program.analysis;
    let memory = arguments.memory.unwrap_or_else(memory::usual);
    let conditions = Conditions { seed: arguments.seed, memory, engine: arguments.engine.get() };
    let mut tests = Vec::new();
    let shown = path.display().to_string();
    // Without a filter the whole file is asked for.
    let told = match &arguments.filter {
        Some(_) if is_human => program.complain_about(&wanted(analysis, arguments)),
        Some(_) => analysis.concerning(&wanted(analysis, arguments), &program.sources).0,
        None => {
            if is_human {
                eprint_diagnostics(&analysis.diagnostics, &program.sources);
            }
            analysis.diagnostics.clone()
        }
    };
    if is_human {
        print_line(&shown);
    }
    let own = analysis.program.tests.iter().enumerate();
    for (number, test) in own.filter(|(_, test)| analysis.is_own(test.script.span)) {
        let name = test.script.name.clone();
        if interrupt::is_asked() || !arguments.wants(&name) {
            continue;
        }
        let mut printed = Lines::default();
        let mut load = |path: &str, span: Span| load(program, path, span);
        let (resolved, plans) = (&analysis.program, &analysis.plans);
        let done = run::test(resolved, number, plans, conditions, &mut load, &mut printed);
        let failed = done.err().map(|failure| failure.diagnostic);
        if is_human {
            let word = if failed.is_some() { "FAILED" } else { "ok" };
            print_line(&format!("  {word:6}  {name}"));
            if let Some(failed) = &failed {
                printed.0.iter().for_each(|line| print_line(&format!("          {line}")));
                eprint_diagnostics(std::slice::from_ref(failed), &program.sources);
            }
        }
        let source = program.sources.get(test.script.span.file);
        tests.push(TestReport {
            test: name,
            passed: failed.is_none(),
            line: source.line_column(test.script.span.start as usize).0,
            printed: printed.0,
            failure: failed.map(|failed| report(&failed, &program.sources)),
        });
    }
    let unread = analysis.program.unread_tests.iter();
    let own = unread.filter(|(name, span)| analysis.is_own(*span) && arguments.wants(name));
    let broken: Vec<_> = own.map(|(name, _)| name.clone()).collect();
    if is_human {
        broken.iter().for_each(|name| print_line(&format!("  broken  {name}")));
    }
    FileReport {
        file: shown,
        broken,
        sound: !told.iter().any(Diagnostic::is_error),
        diagnostics: reports(&told, &program.sources),
        tests,
        error: None,
    }
}

/// The places of the tests that are asked for, of those with errors too.
fn wanted(analysis: &Analysis, arguments: &TestArguments) -> Vec<Span> {
    let read = analysis.program.tests.iter().map(|test| (&test.script.name, test.script.span));
    let unread = analysis.program.unread_tests.iter().map(|(name, span)| (name, *span));
    let wanted = |(name, span): &(&String, Span)| analysis.is_own(*span) && arguments.wants(name);
    read.chain(unread).filter(wanted).map(|(_, span)| span).collect()
}

/// Reads the mesh of a path, relative to the folder of the file that names it.
fn load(program: &Program, path: &str, span: Span) -> Result<MeshFile, String> {
    let home = Path::new(program.sources.get(span.file).name());
    let path = home.parent().unwrap_or(Path::new("")).join(path);
    expect_regular(&path, LARGEST_MESH).map_err(|why| format!("{}: {why}", path.display()))?;
    let read = meshes::read(&path, &RepairArguments::default());
    read.map_err(|failure| failure.reason().unwrap_or_default().to_owned())
}

/// The lines that a test prints, which are shown only if it fails.
#[derive(Default)]
struct Lines(Vec<String>);

impl Watch for Lines {
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        interrupt::unless_asked()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        interrupt::unless_asked()
    }

    fn print(&mut self, line: &str) {
        self.0.push(line.to_owned());
    }
}

#[derive(Serialize)]
struct Summary {
    passed: usize,
    failed: usize,
    files: Vec<FileReport>,
}

#[derive(Serialize)]
struct FileReport {
    file: String,
    sound: bool,
    /// Tests that are not run, because something is wrong in them.
    broken: Vec<String>,
    diagnostics: Vec<DiagnosticReport>,
    tests: Vec<TestReport>,
    /// The reason why it cannot be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
}

impl FileReport {
    fn unreadable(path: &Path, failure: &Failure) -> Self {
        Self {
            file: path.display().to_string(),
            sound: false,
            broken: Vec::new(),
            diagnostics: Vec::new(),
            tests: Vec::new(),
            error: failure.reason().map(str::to_owned),
        }
    }
}

#[derive(Serialize)]
struct TestReport {
    test: String,
    passed: bool,
    line: usize,
    printed: Vec<String>,
    failure: Option<DiagnosticReport>,
}
