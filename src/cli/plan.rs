//! `hedgerow plan`

use std::collections::BTreeSet;
use std::mem::discriminant;
use std::path::Path;

use serde::Serialize;

use super::arguments::{PlanArguments, Shown};
use super::failure::Failure;
use super::files;
use super::output::{eprint_diagnostics, eprint_line, print_line, print_line_exactly, table};
use super::program::{self, Program};
use crate::analysis::{Analysis, read_program};
use crate::diagnostic::{Diagnostic, quoted};
use crate::emit::{NotEmitted, Selection, Style, cpp, rust};
use crate::library;
use crate::mesh::Level;
use crate::resolve::Script;
use crate::rewrite::{Cell, Plan, Refusal, Row, Stage, Steps};
use crate::run::prepare;

/// Shows operations as pointer assignments: as a table, as data, or as code.
pub(super) fn plan(arguments: &PlanArguments) -> Result<(), Failure> {
    let style = style(arguments)?;
    let (path, name) = program::part(&arguments.op);
    let program = program::read(path)?;
    program.expect_apart(&arguments.output)?;
    let mut ops: Vec<_> = match name {
        Some(_) => vec![program::find_op(&program, name)?],
        // A table of everything would be too long to read.
        None if arguments.shown == Shown::Table => vec![program::find_op(&program, None)?],
        None => all(&program, &style),
    };
    if ops.is_empty() {
        program::find_op(&program, None)?;
    }
    expect_named(arguments, &program, &ops)?;
    let places: Vec<_> = ops.iter().map(|&op| program.analysis.program.ops[op].span).collect();
    // What is emitted of a whole file lacks nothing without a word.
    let is_whole = name.is_some() || arguments.shown == Shown::Table || {
        let (told, _) = program.analysis.concerning(&places, &program.sources);
        !told.iter().any(Diagnostic::is_error)
    };
    let plans = ops.iter().map(|&op| program.analysis.plans[op].as_ref());
    let Some(plans) = plans.collect::<Option<Vec<_>>>().filter(|_| is_whole) else {
        program.complain_about(&places);
        return Err(Failure::NotProved);
    };
    let emit = |ops: &[usize]| {
        let selection = Selection {
            program: &program.analysis.program,
            proved: &program.analysis.proved,
            sources: &program.sources,
            ops,
            exhaustive: arguments.exhaustive,
        };
        if arguments.shown == Shown::Rust { rust(&selection) } else { cpp(&selection, &style) }
    };
    let text = match arguments.shown {
        Shown::Table => tables(&plans, &program, arguments.exhaustive),
        Shown::Json => data(&program, &ops, &plans, arguments.exhaustive)?,
        Shown::Cpp | Shown::Rust => {
            if name.is_none() {
                leave_out(&program, &mut ops, |op| emit(&[op]).err());
                for (_, script) in own_scripts(&program) {
                    let name = &script.name;
                    eprint_line(&format!("left out: `{name}`, since only operations are emitted"));
                }
            }
            emitted(&program, emit(&ops))?
        }
    };
    match &arguments.output {
        Some(output) => files::write(output, text.as_bytes()),
        None => {
            match arguments.shown {
                Shown::Json => print_line_exactly(text.trim_end()),
                Shown::Table | Shown::Cpp | Shown::Rust => print_line(text.trim_end()),
            }
            Ok(())
        }
    }
}

/// The style of C++: that of the target, then the `--style` options.
fn style(arguments: &PlanArguments) -> Result<Style, Failure> {
    let mut style = Style::default();
    if arguments.shown != Shown::Cpp && (arguments.target.is_some() || !arguments.style.is_empty())
    {
        return Err(Failure::usage("a style or a target is for C++: write --as cpp"));
    }
    if let Some(target) = &arguments.target {
        let path = Path::new(target);
        let text = match library::target(target).filter(|_| !path.exists()) {
            Some(known) => known.text.to_string(),
            None => read_program(path).map_err(|why| {
                let names: Vec<_> = library::targets().map(|known| known.short_name()).collect();
                Failure::usage(format!(
                    "cannot read `{target}`: {why}; a target is a file of styles, or {}; a mesh class \
                     that stores halfedges in pairs, as CGAL, OpenMesh, pmp and geometry-central \
                     do, can be none",
                    names.join(", ")
                ))
            })?,
        };
        style
            .set_lines(&text)
            .map_err(|(line, why)| Failure::usage(format!("{target}:{line}: {why}")))?;
    }
    for text in &arguments.style {
        style.set(text).map_err(Failure::usage)?;
    }
    style.check().map_err(Failure::usage)?;
    Ok(style)
}

/// Refuses a `--style function.OP=NAME` for an operation that is not emitted.
fn expect_named(
    arguments: &PlanArguments,
    program: &Program,
    ops: &[usize],
) -> Result<(), Failure> {
    let ops = ops.iter().map(|&op| program.analysis.program.ops[op].name.as_str());
    let named = arguments.style.iter().filter_map(|text| text.strip_prefix("function."));
    for (op, _) in named.filter_map(|rest| rest.split_once('=')) {
        if !ops.clone().any(|emitted| emitted == op) {
            let ops = quoted(ops);
            return Err(Failure::usage(format!("no operation `{op}` is emitted; there is {ops}")));
        }
    }
    Ok(())
}

/// All ops of a file; if it has none, those that its scripts call, or else those of the files that
/// it uses. Of these a target that names ops selects the named ones.
fn all(program: &Program, style: &Style) -> Vec<usize> {
    let ops = &program.analysis.program.ops;
    let wanted = |at: &usize| !style.names_functions() || style.function(&ops[*at].name).is_some();
    let found: Vec<_> = (0..ops.len()).filter(|&op| is_own(program, op)).collect();
    if !found.is_empty() {
        return found;
    }
    let Analysis { program: known, plans, .. } = &program.analysis;
    let called = own_scripts(program).filter_map(|(script, _)| prepare(known, script, plans).ok());
    let called: BTreeSet<usize> = called.flat_map(|script| script.called().to_vec()).collect();
    let of_use = |at: &usize| called.is_empty() || called.contains(at);
    (0..ops.len()).filter(of_use).filter(wanted).collect()
}

fn is_own(program: &Program, op: usize) -> bool {
    program.analysis.is_own(program.analysis.program.ops[op].span)
}

/// The scripts of the file itself, with their numbers.
fn own_scripts(program: &Program) -> impl Iterator<Item = (usize, &Script)> {
    let analysis = &program.analysis;
    analysis.program.scripts.iter().enumerate().filter(|(_, script)| analysis.is_own(script.span))
}

/// The names of the ops that steps call.
fn called<'p>(steps: &Steps, program: &'p Program) -> Vec<&'p str> {
    let ops = &program.analysis.program.ops;
    let calls = steps.calls.iter();
    calls.filter_map(|&(op, _)| Some(ops.get(usize::from(op))?.name.as_str())).collect()
}

/// The calls of an op in steps, and when it refuses.
fn show_steps(plan: &Plan, steps: &Steps, program: &Program) -> String {
    let calls = called(steps, program);
    let end = match plan.level {
        Level::Map => String::new(),
        level => format!(", or the mesh is not of level {level} in the end"),
    };
    let name = &plan.name;
    if calls.is_empty() {
        return format!("{name} is done in steps, and calls no operation");
    }
    let calls = calls.join(", ");
    format!(
        "{name} is done in steps: {calls}\n\
         if one of them must be done and refuses{end}, all is undone"
    )
}

fn tables(plans: &[&Plan], program: &Program, exhaustive: bool) -> String {
    let shown = |plan: &&Plan| show(plan, program, exhaustive);
    plans.iter().map(shown).collect::<Vec<_>>().join("\n\n\n") + "\n"
}

/// Leaves out the ops that cannot be emitted, with a message, if others can.
fn leave_out(
    program: &Program,
    ops: &mut Vec<usize>,
    refused: impl Fn(usize) -> Option<NotEmitted>,
) {
    let refused: Vec<_> = ops.iter().map(|&op| refused(op)).collect();
    if refused.iter().all(Option::is_some) {
        return;
    }
    let mut refused = refused.into_iter();
    ops.retain(|&op| match refused.next().flatten() {
        Some(NotEmitted { what, .. }) => {
            let name = &program.analysis.program.ops[op].name;
            eprint_line(&format!("left out: `{name}`, since {what} cannot be emitted"));
            false
        }
        None => true,
    });
}

/// Emitted code; or what cannot be emitted, with its place.
fn emitted(program: &Program, text: Result<String, NotEmitted>) -> Result<String, Failure> {
    text.map_err(|failure| {
        eprint_diagnostics(&[failure.diagnostic()], &program.sources);
        Failure::Silent(1.into())
    })
}

/// Plans as data, in the form that the reference documents.
fn data(
    program: &Program,
    ops: &[usize],
    plans: &[&Plan],
    exhaustive: bool,
) -> Result<String, Failure> {
    let plans = ops.iter().zip(plans).map(|(&op, plan)| {
        let op = &program.analysis.program.ops[op];
        let params =
            op.params.iter().map(|param| ParamData { name: &param.name, kind: param.ty.word() });
        PlanData {
            op: &plan.name,
            params: params.collect(),
            result: plan.result.map(|kind| kind.name()),
            level: plan.level.name(),
            calls: plan.steps.as_ref().map(|steps| called(steps, program)),
            rules: plan.stages.iter().map(|stage| shown(stage, exhaustive)).collect(),
            refusals: &plan.refusals,
        }
    });
    let plans = Plans { plans: plans.collect() };
    serde_json::to_string_pretty(&plans).map(|text| text + "\n").map_err(Failure::usage)
}

#[derive(Serialize)]
struct Plans<'a> {
    plans: Vec<PlanData<'a>>,
}

#[derive(Serialize)]
struct PlanData<'a> {
    op: &'a str,
    params: Vec<ParamData<'a>>,
    result: Option<&'static str>,
    level: &'static str,
    calls: Option<Vec<&'a str>>,
    rules: Vec<Stage>,
    refusals: &'a [Refusal],
}

#[derive(Serialize)]
struct ParamData<'a> {
    name: &'a str,
    #[serde(rename = "type")]
    kind: &'static str,
}

/// A rule with the rows that are shown.
fn shown(stage: &Stage, exhaustive: bool) -> Stage {
    let mut stage = stage.clone();
    for rows in [&mut stage.collect, &mut stage.allocate, &mut stage.reassign, &mut stage.erase] {
        rows.retain(|row| exhaustive || !is_outside(row));
    }
    stage
}

/// The four phases of every rule, or the calls of an op in steps.
pub(super) fn show(plan: &Plan, program: &Program, exhaustive: bool) -> String {
    if let Some(steps) = &plan.steps {
        return show_steps(plan, steps, program);
    }
    let stages = plan.stages.iter().map(|stage| show_stage(&plan.name, stage, exhaustive));
    let mut text = stages.collect::<Vec<_>>().join("\n\n");
    if plan.stages.iter().any(|stage| stage.reassign.iter().any(|row| !row.executed)) {
        text.push_str("\n\n· unchanged: not executed");
    }
    text
}

/// True if a row is about a pointer that leads out of the drawing, and is kept.
fn is_outside(row: &Row) -> bool {
    match &row.cell {
        Cell::Set { target, value } => value == Cell::AS_IT_WAS && !target.ends_with(".halfedge"),
        _ => false,
    }
}

fn show_stage(name: &str, stage: &Stage, exhaustive: bool) -> String {
    let title = match &stage.rule {
        Some(rule) => format!("{name}, rule {rule}"),
        None => name.to_string(),
    };
    let phases = [
        ("1. collect", &stage.collect),
        ("2. allocate", &stage.allocate),
        ("3. reassign", &stage.reassign),
        ("4. erase", &stage.erase),
    ];
    let phases = phases.map(|(phase, rows)| {
        if rows.is_empty() {
            return format!("{phase}\n   nothing");
        }
        let alike = |one: &Row, two: &Row| discriminant(&one.cell) == discriminant(&two.cell);
        let rows: Vec<_> = rows.iter().filter(|row| exhaustive || !is_outside(row)).collect();
        let blocks = rows.chunk_by(|one, two| alike(one, two)).map(|rows| {
            let rows: Vec<_> = rows.iter().map(|row| cells(row)).collect();
            table(&rows, &[])
        });
        format!("{phase}\n{}", blocks.collect::<Vec<_>>().join("\n"))
    });
    format!("{title}\n\n{}", phases.join("\n\n"))
}

fn cells(row: &Row) -> Vec<String> {
    let mark = if row.executed { "   " } else { " · " };
    match &row.cell {
        Cell::Set { target, value } if value == Cell::AS_IT_WAS => {
            vec![format!("{mark}{target}"), value.clone()]
        }
        Cell::Set { target, value } => vec![format!("{mark}{target}"), format!("= {value}")],
        Cell::Test { claim, reason } => {
            vec![format!("{mark}test {claim}"), format!("else refuse: {reason}")]
        }
        Cell::Note { text } => vec![format!("{mark}{text}")],
    }
}
