//! `hedgerow draw`

use std::borrow::Cow;
use std::path::Path;

use super::arguments::{DrawArguments, Drawn};
use super::check::show_rule;
use super::failure::Failure;
use super::files::write;
use super::meshes::expect_place;
use super::output::{columns, eprint_line, is_standard, print_line};
use super::plan::show as show_plan;
use super::program::{self, Program};
use crate::analysis::{Analysis, Verdict, example, verdicts};
use crate::diagnostic::{Diagnostic, Severity, quoted};
use crate::diagram::Op;
use crate::draw::{COLUMNS, Picture, Section, draw_op, draw_sheet, page, text_op};
use crate::run::{Functions, calls_of_steps};

/// The number of pixels per unit of a diagram.
const PIXELS: f64 = 2.0;

/// True if a name is that of a picture.
fn is_picture(path: &Path) -> bool {
    let end = path.extension().map(|end| end.to_ascii_lowercase());
    end.is_some_and(|end| end == "png" || end == "svg")
}

/// True if the file itself declares operations.
fn has_own_ops(program: &Program) -> bool {
    let analysis = &program.analysis;
    analysis.program.ops.iter().any(|op| analysis.is_own(op.span))
}

/// Draws an operation, before and after, or all of a file on one page.
pub(super) fn draw(arguments: &DrawArguments) -> Result<(), Failure> {
    let (path, name) = program::part(&arguments.op);
    let program = program::read(path)?;
    program.expect_apart(&arguments.output)?;
    if arguments.html {
        let output = arguments.output.as_deref();
        if let Some(picture) = output.filter(|output| is_picture(output)) {
            let other = picture.with_extension("html");
            return Err(Failure::usage(format!(
                "{}: a page is not a picture: write -o {}",
                picture.display(),
                other.display()
            )));
        }
        let text = page(&path.display().to_string(), &sections(&program, name)?);
        return match &arguments.output {
            Some(output) => write(output, text.as_bytes()),
            None => {
                print_line(&text);
                Ok(())
            }
        };
    }
    let op = program::find_op(&program, name).map_err(|failure| match failure {
        Failure::Usage(message) if name.is_none() && has_own_ops(&program) => {
            Failure::Usage(format!("{message}, or `--html` for one page of all"))
        }
        failure => failure,
    })?;
    let diagram = &*diagram(&program, op)?;
    let note = not_proved(&program.analysis, op);
    let columns = columns().filter(|_| arguments.output.is_none()).unwrap_or(COLUMNS);
    let text = || {
        text_op(diagram, columns)
            + &note.iter().map(|note| format!("\n{note}\n")).collect::<String>()
    };
    let sheet = || {
        let mut sheet = draw_sheet(diagram);
        note.iter().for_each(|note| sheet.add_note(note));
        sheet
    };
    match (arguments.drawn, &arguments.output) {
        (Some(Drawn::Text), Some(output)) => write(output, text().as_bytes()),
        (Some(Drawn::Text), None) => {
            print_line(text().trim_end());
            Ok(())
        }
        (Some(Drawn::Svg), None) => {
            print_line(sheet().svg().trim_end());
            Ok(())
        }
        (Some(Drawn::Svg), Some(output)) => write(output, sheet().svg().as_bytes()),
        (None, Some(output)) => write_picture(&sheet(), output, PIXELS),
        (None, None) => Err(Failure::usage(
            "where should the picture go? write -o OUT.svg, -o OUT.png, or --as text",
        )),
    }
}

/// The reason why an operation is not proved, in a line.
fn not_proved(analysis: &Analysis, op: usize) -> Option<String> {
    if analysis.plans[op].is_some() {
        return None;
    }
    let reasons = failures(analysis, op).into_iter().skip(1);
    let mut reasons = reasons.map(|reason| reason.trim_start_matches("error: ").to_owned());
    Some(match (reasons.next(), reasons.count()) {
        (None, _) => "not proved".to_owned(),
        (Some(first), 0) => format!("not proved: {first}"),
        (Some(first), more) => format!("not proved: {first}, and {more} more"),
    })
}

fn diagram(program: &Program, op: usize) -> Result<Cow<'_, Op>, Failure> {
    let analysis = &program.analysis;
    if analysis.plans[op].is_none() && analysis.program.ops[op].diagram.is_some() {
        let name = &analysis.program.ops[op].name;
        let file = program.sources.get(analysis.file).name();
        eprint_line(&format!("warning: `{name}` is not proved; `hedgerow check {file}` tells why"));
    }
    let (resolved, plan) = (&analysis.program.ops[op], &analysis.plans[op]);
    let not_understood = || {
        program.complain_about(&[resolved.span]);
        Failure::NotProved
    };
    match (&resolved.diagram, plan) {
        (Some(diagram), _) => Ok(Cow::Borrowed(diagram)),
        (None, None) => Err(not_understood()),
        (None, Some(_)) => {
            let example = example(&analysis.program, op, &analysis.plans);
            Ok(Cow::Owned(example.map_err(|none| Failure::usage(none.to_string()))?))
        }
    }
}

fn sections(program: &Program, name: Option<&str>) -> Result<Vec<Section>, Failure> {
    let only = match name {
        Some(_) => Some(program::find_op(program, name)?),
        None => None,
    };
    let analysis = &program.analysis;
    let ops = analysis.program.ops.iter().zip(verdicts(analysis));
    let ops = ops.zip(analysis.plans.iter()).enumerate();
    let ops = ops.filter(|(at, _)| only.is_none_or(|only| only == *at));
    let sections = ops.map(|(at, ((op, verdict), plan))| {
        let steps = op.steps.as_ref().filter(|_| plan.is_some());
        let shown = steps.map(|_| example(&analysis.program, at, &analysis.plans));
        let mut told = match verdict.proved {
            true => vec![show_verdict(&verdict)],
            false => failures(analysis, at),
        };
        let mut picture = op.diagram.as_ref().map(draw_op);
        match shown {
            Some(Ok(example)) => picture = Some(draw_op(&example)),
            Some(Err(none)) => told.push(none.to_string()),
            None => {}
        }
        Section {
            name: op.name.clone(),
            docs: match (&op.diagram, &op.steps) {
                (Some(op), _) => op.docs.clone(),
                (None, Some(steps)) => steps.docs.clone(),
                (None, None) => Vec::new(),
            },
            picture,
            verdict: told,
            plan: plan.as_ref().map(|plan| show_plan(plan, program, false)),
        }
    });
    Ok(sections.collect())
}

/// The errors of an operation: those between its name and the next one.
fn errors(analysis: &Analysis, op: usize) -> impl Iterator<Item = &Diagnostic> {
    let name = analysis.program.ops[op].span;
    let ops = analysis.program.ops.iter().map(|op| op.span);
    let ops = ops.filter(|other| other.file == name.file && other.start > name.start);
    let end = ops.map(|op| op.start).min();
    analysis.diagnostics.iter().filter(move |diagnostic| {
        diagnostic.severity == Severity::Error
            && diagnostic.labels.first().is_some_and(|label| {
                let at = label.span.start;
                label.span.file == name.file && name.start <= at && end.is_none_or(|end| at < end)
            })
    })
}

/// The reasons why an operation is not proved: its errors, and what it calls that is not proved.
fn failures(analysis: &Analysis, op: usize) -> Vec<String> {
    let errors = errors(analysis, op).map(|error| format!("error: {}", error.message));
    let mut lines = vec!["not proved".to_string()];
    lines.extend(errors);
    lines.extend(unproved_steps(analysis, op));
    // Each rule may be wrong in the same way.
    lines.dedup();
    lines
}

/// The calls of an operation in steps that are not proved, a line each.
fn unproved_steps(analysis: &Analysis, op: usize) -> Vec<String> {
    let (functions, _) = Functions::of(&analysis.program);
    let calls = calls_of_steps(&analysis.program, &functions);
    let called = calls.get(&op).into_iter().flatten();
    let unproved = called.filter(|&&other| other != op && analysis.plans[other].is_none());
    let names = unproved.map(|&other| &analysis.program.ops[other].name);
    names.map(|name| format!("it calls `{name}`, which is not proved")).collect()
}

fn show_verdict(verdict: &Verdict) -> String {
    if let Some(steps) = &verdict.steps {
        return match quoted(&steps.calls).as_str() {
            "" => "proved, in steps".to_owned(),
            calls => format!("proved, in steps: {calls}"),
        };
    }
    let rules = verdict.rules.iter().map(|rule| {
        let name = rule.rule.as_ref().map(|rule| format!("{rule}: "));
        format!("{}{}", name.unwrap_or_default(), show_rule(rule).join(", "))
    });
    format!("proved: {}", rules.collect::<Vec<_>>().join("; "))
}

/// Checks that a picture can be written to a path, before it is computed.
pub(super) fn expect_picture(path: &Path) -> Result<(), Failure> {
    match path.extension().and_then(|extension| extension.to_str()) {
        _ if is_standard(path) => Ok(()),
        Some("svg" | "png") => expect_place(path),
        _ => Err(no_kind(path)),
    }
}

fn no_kind(path: &Path) -> Failure {
    Failure::usage(format!(
        "cannot tell what `{}` is to be: its name ends in neither .svg nor .png",
        path.display()
    ))
}

/// Writes a picture in the format that the extension of the path says.
pub(super) fn write_picture(picture: &Picture, path: &Path, pixels: f64) -> Result<(), Failure> {
    let extension = path.extension().and_then(|extension| extension.to_str());
    match extension {
        // Standard output has no extension: it gets SVG.
        Some("svg") => write(path, picture.svg().as_bytes()),
        None if is_standard(path) => write(path, picture.svg().as_bytes()),
        Some("png") => write(path, &picture.png(pixels).map_err(Failure::usage)?),
        _ => Err(no_kind(path)),
    }
}
