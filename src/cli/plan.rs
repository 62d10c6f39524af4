//! `hedgerow plan`

use std::mem::discriminant;

use super::arguments::PlanArguments;
use super::failure::Failure;
use super::output::{complain_of, say, table};
use super::program::{self, Program};
use crate::mesh::Level;
use crate::rewrite::{Cell, Plan, Row, Stage, Steps};

/// Shows an operation as pointer assignments, in four phases.
pub(super) fn plan(arguments: &PlanArguments) -> Result<(), Failure> {
    let (path, name) = program::part(&arguments.op);
    let program = program::read(path)?;
    let op = program::find_op(&program, name)?;
    let Some(plan) = &program.analysis.plans[op] else {
        complain_of(&program.analysis.diagnostics, &program.sources);
        return Err(Failure::NotProved);
    };
    match &plan.steps {
        Some(steps) => say(&show_steps(plan, steps, &program)),
        None => say(&show(plan)),
    }
    Ok(())
}

/// What an op in steps calls, and when it refuses.
fn show_steps(plan: &Plan, steps: &Steps, program: &Program) -> String {
    let ops = &program.analysis.program.ops;
    let calls = steps.calls.iter();
    let calls = calls.filter_map(|&(op, _)| Some(ops.get(usize::from(op))?.name.as_str()));
    let calls = calls.collect::<Vec<_>>().join(", ");
    let end = match plan.level {
        Level::Map => String::new(),
        level => format!(", or the mesh is not of level {level} in the end"),
    };
    let name = &plan.name;
    format!(
        "{name} is done in steps: {calls}\nif one of them must be done and refuses{end}, all is undone"
    )
}

/// The four phases of every rule.
pub(super) fn show(plan: &Plan) -> String {
    let stages = plan
        .stages
        .iter()
        .map(|stage| show_stage(&plan.name, stage));
    let mut text = stages.collect::<Vec<_>>().join("\n\n");
    if plan
        .stages
        .iter()
        .any(|stage| stage.reassign.iter().any(|row| !row.executed))
    {
        text.push_str("\n\n· provably unchanged: not executed");
    }
    text
}

fn show_stage(name: &str, stage: &Stage) -> String {
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
        let blocks = rows.chunk_by(alike).map(|rows| {
            let rows: Vec<_> = rows.iter().map(cells).collect();
            table(&rows, &[])
        });
        format!("{phase}\n{}", blocks.collect::<Vec<_>>().join("\n"))
    });
    format!("{title}\n\n{}", phases.join("\n\n"))
}

fn cells(row: &Row) -> Vec<String> {
    let mark = if row.executed { "   " } else { " · " };
    match &row.cell {
        Cell::Set { target, value } => vec![format!("{mark}{target}"), format!("= {value}")],
        Cell::Test { claim, reason } => vec![
            format!("{mark}test {claim}"),
            format!("else refuse: {reason}"),
        ],
        Cell::Note(note) => vec![format!("{mark}{note}")],
    }
}
