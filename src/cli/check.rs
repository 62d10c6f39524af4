//! `hedgerow check`

use std::collections::BTreeMap;

use serde::Serialize;

use super::arguments::{CheckArguments, Format};
use super::failure::Failure;
use super::output::{eprint_diagnostics, print_json, print_line, table_rows, wrapped};
use super::witness::Witnesses;
use super::{fix, program};
use crate::analysis::{
    Analysis, GuardVerdict, ProvedStatement, RuleAliases, RuleArgument, RuleVerdict, Verdict,
    aliases, verdicts, why_proved,
};
use crate::diagnostic::{Diagnostic, Edit, Fix, Label, Severity, counted};
use crate::source::{Sources, Span};

/// Proves the operations of files, or says why they break a mesh.
pub(super) fn check(arguments: &CheckArguments) -> Result<(), Failure> {
    let mut sound = true;
    let mut unreadable = None;
    let mut files = Vec::new();
    let mut witnesses = Witnesses::default();
    for path in &arguments.files {
        let program = if arguments.fix { fix::mended(path) } else { program::read(path) };
        let program = match program {
            Ok(program) => program,
            Err(failure) => {
                // The other files are still worth a look.
                failure.tell();
                files.push(FileReport {
                    file: path.display().to_string(),
                    ops: Vec::new(),
                    aliases: None,
                    diagnostics: Vec::new(),
                    error: failure.reason().map(str::to_owned),
                });
                unreadable = Some(failure);
                continue;
            }
        };
        sound &= program.analysis.is_sound();
        let verdicts = verdicts(&program.analysis);
        let aliases = if arguments.aliases { aliases(&program.analysis) } else { Vec::new() };
        if let Some(folder) = &arguments.witness {
            witnesses.write(folder, &program.analysis.counterexamples)?;
            for set in aliases.iter().flat_map(|rule| &rule.sets) {
                witnesses.write(folder, set.example.as_slice())?;
            }
        }
        match arguments.format {
            Format::Human => {
                eprint_diagnostics(&program.analysis.diagnostics, &program.sources);
                let file = path.display().to_string();
                if !verdicts.is_empty() {
                    print_line(&show(&file, &verdicts, arguments.verbose));
                } else if program.analysis.is_sound() {
                    print_line(&format!("{file}: {}", without_ops(&program.analysis)));
                }
                if arguments.explain {
                    for argument in why_proved(&program.analysis) {
                        print_line(&explained(&argument));
                    }
                }
                for rule in &aliases {
                    print_line(&super::aliases::show(rule));
                }
            }
            Format::Json => files.push(FileReport {
                file: path.display().to_string(),
                ops: verdicts,
                aliases: arguments.aliases.then_some(aliases),
                diagnostics: reports(&program.analysis.diagnostics, &program.sources),
                error: None,
            }),
        }
    }
    if arguments.format == Format::Json {
        print_json(&Report { proved: sound && unreadable.is_none(), files })?;
    }
    match unreadable {
        Some(failure) => Err(Failure::Silent(failure.exit_code())),
        None if sound => Ok(()),
        None => Err(Failure::NotProved),
    }
}

/// The contents of a file without operations: `2 scripts, 1 test, no operations`.
fn without_ops(analysis: &Analysis) -> String {
    let Analysis { program, file, .. } = analysis;
    let scripts = program.scripts.iter().map(|script| ("script", script.span));
    let functions = program.functions.iter().map(|function| ("function", function.span));
    let tests = program.tests.iter().map(|test| ("test", test.script.span));
    let own: Vec<_> =
        scripts.chain(functions).chain(tests).filter(|it| it.1.file == *file).collect();
    let parts = ["script", "function", "test"].map(|kind| {
        match own.iter().filter(|(known, _)| *known == kind).count() {
            0 => String::new(),
            count => counted(count, kind, &format!("{kind}s")) + ", ",
        }
    });
    parts.concat() + "no operations"
}

fn show(file: &str, verdicts: &[Verdict], verbose: bool) -> String {
    let mut rows = Vec::new();
    let mut below = Vec::new();
    for verdict in verdicts {
        if !verdict.proved {
            let mut row = vec!["  not proved".to_string(), verdict.op.clone()];
            row.extend(verdict.lacks.iter().map(|lacks| depends(lacks)));
            rows.push(row);
            below.push(Vec::new());
        }
        if let Some(steps) = &verdict.steps {
            let calls = match steps.calls.as_slice() {
                [] => "in steps".to_string(),
                calls => format!("in steps: {}", calls.join(", ")),
            };
            rows.push(vec!["  proved".into(), verdict.op.clone(), calls]);
            below.push(Vec::new());
        }
        for rule in &verdict.rules {
            let label = rule.rule.as_ref();
            let name = label.map_or(verdict.op.clone(), |label| format!("{} {label}", verdict.op));
            let mut row = vec!["  proved".into(), name];
            row.extend(show_rule(rule));
            rows.push(row);
            let turned = rule.turned.iter().map(|turned| line(6, &format!("note: {turned}")));
            let only = rule.keeps_only.iter().map(|only| line(6, &only.words()));
            let more = if verbose { details(rule) } else { Vec::new() };
            below.push(turned.chain(only).chain(more).collect());
        }
    }
    let lines = table_rows(&rows, &[]).into_iter().zip(below);
    let lines = lines.flat_map(|(row, below)| std::iter::once(row).chain(below));
    std::iter::once(file.to_string()).chain(lines).collect::<Vec<_>>().join("\n")
}

/// An indented text, in as many lines as the terminal wants.
fn line(indent: usize, text: &str) -> String {
    format!("{}{}", " ".repeat(indent), wrapped(text, indent + 2))
}

/// The reason why an operation without errors is not proved.
pub(super) fn depends(lacks: &str) -> String {
    match lacks.contains(' ') {
        true => format!("depends on {lacks}"),
        false => format!("depends on `{lacks}`, which has an error"),
    }
}

/// The properties that a rule keeps, and how degrees and sizes change, on lines of their own.
fn details(rule: &RuleVerdict) -> Vec<String> {
    let changes = |changes: &BTreeMap<String, String>| {
        let changes = changes.iter().map(|(element, change)| format!("{element} {change}"));
        changes.collect::<Vec<_>>().join(", ")
    };
    let lines = [
        ("keeps", rule.keeps.join(", ")),
        ("degrees", changes(&rule.degrees)),
        ("sides", changes(&rule.sizes)),
    ];
    let told = lines.into_iter().filter(|(_, text)| !text.is_empty());
    let told = told.map(|(what, text)| line(6, &format!("{what}: {text}")));
    told.chain(rule.guard.iter().flat_map(guard)).collect()
}

/// The tests of a guard, and the statements that need none.
fn guard(guard: &GuardVerdict) -> Vec<String> {
    let tests = guard.tests.iter().map(|claim| line(8, &format!("tested: {claim}")));
    let proved = guard.proved.iter();
    let proved = proved.map(|proved| {
        let ProvedStatement { statement, because } = proved;
        line(8, &format!("proved: {statement}: {because}"))
    });
    let title = format!("      guard {}, after it:", guard.level);
    std::iter::once(title).chain(tests).chain(proved).collect()
}

/// The verdict on a rule, in three parts.
pub(super) fn show_rule(rule: &RuleVerdict) -> [String; 3] {
    [counted(rule.cases, "case", "cases"), change(rule), cost(rule)]
}

fn explained(argument: &RuleArgument) -> String {
    let rule = argument.rule.iter().map(|rule| format!(", rule {rule}"));
    let mut lines = vec![format!("\n{}{}", argument.op, rule.collect::<String>())];
    for law in &argument.laws {
        lines.push(format!("  {}", law.law));
        lines.extend(law.lines.iter().map(|text| line(4, text)));
    }
    lines.join("\n")
}

fn change(rule: &RuleVerdict) -> String {
    let signed = |count: i64, per_index: i64| {
        let parts = [(per_index, "n"), (count, "")].map(|(times, of)| match times {
            0 => String::new(),
            1 if !of.is_empty() => format!("+{of}"),
            -1 if !of.is_empty() => format!("-{of}"),
            times => format!("{times:+}{of}"),
        });
        match parts.concat() {
            none if none.is_empty() => "±0".to_string(),
            parts => parts,
        }
    };
    // With families `n` stands for the size of the cycle.
    let counts = rule.counts().into_iter();
    let counts = counts.map(|(name, by, per_index)| format!("{name} {}", signed(by, per_index)));
    counts.collect::<Vec<_>>().join("  ")
}

fn cost(rule: &RuleVerdict) -> String {
    if rule.constant_time {
        "constant time".into()
    } else {
        format!("grows with {}", rule.grows_with.join(", "))
    }
}

#[derive(Serialize)]
struct Report {
    proved: bool,
    files: Vec<FileReport>,
}

#[derive(Serialize)]
struct FileReport {
    file: String,
    ops: Vec<Verdict>,
    #[serde(skip_serializing_if = "Option::is_none")]
    aliases: Option<Vec<RuleAliases>>,
    diagnostics: Vec<DiagnosticReport>,
    /// The reason why it cannot be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
}

/// A diagnostic as data; lines and columns are 1-based, columns count characters.
#[derive(Debug, Serialize)]
pub(super) struct DiagnosticReport {
    severity: &'static str,
    code: &'static str,
    pub message: String,
    labels: Vec<LabelReport>,
    notes: Vec<String>,
    fixes: Vec<FixReport>,
}

impl DiagnosticReport {
    pub fn is_error(&self) -> bool {
        self.severity == "error"
    }
}

#[derive(Debug, Serialize)]
struct LabelReport {
    #[serde(flatten)]
    place: Location,
    text: String,
}

#[derive(Debug, Serialize)]
struct FixReport {
    title: String,
    edits: Vec<EditReport>,
}

#[derive(Debug, Serialize)]
struct EditReport {
    #[serde(flatten)]
    place: Location,
    text: String,
}

#[derive(Debug, Serialize)]
struct Location {
    file: String,
    line: usize,
    column: usize,
    end_line: usize,
    end_column: usize,
}

pub(super) fn reports(told: &[Diagnostic], sources: &Sources) -> Vec<DiagnosticReport> {
    told.iter().map(|diagnostic| report(diagnostic, sources)).collect()
}

pub(super) fn report(diagnostic: &Diagnostic, sources: &Sources) -> DiagnosticReport {
    let place = |span: Span| {
        let source = sources.get(span.file);
        let (line, column) = source.line_column(span.start as usize);
        let (end_line, end_column) = source.line_column(span.end as usize);
        Location { file: source.name().to_owned(), line, column, end_line, end_column }
    };
    let label = |label: &Label| LabelReport { place: place(label.span), text: label.text.clone() };
    let edit = |edit: &Edit| EditReport { place: place(edit.span), text: edit.text.clone() };
    let fix = |fix: &Fix| FixReport {
        title: fix.title.clone(),
        edits: fix.edits.iter().map(edit).collect(),
    };
    DiagnosticReport {
        severity: match diagnostic.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        },
        code: diagnostic.code,
        message: diagnostic.message.clone(),
        labels: diagnostic.labels.iter().map(label).collect(),
        notes: diagnostic.notes.clone(),
        fixes: diagnostic.fixes.iter().map(fix).collect(),
    }
}
