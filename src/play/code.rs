//! Operations in another form: the assignments of their plans, C++ and Rust.

use serde_json::{Value, json};

use super::Message;
use super::ask::Language;
use crate::emit::{Selection, Style, cpp, rust};
use crate::rewrite::{Cell, Row};
use crate::session::Program;

/// An operation of a program, or all of the file.
pub(super) fn code(program: &Program, op: Option<&str>, language: Language) -> Message {
    let analysis = program.analysis();
    let ops = &analysis.program.ops;
    let own = |at: &usize| ops[*at].span.file == analysis.file;
    let ops: Vec<usize> = match op {
        Some(name) => analysis.op(name).into_iter().collect(),
        None => (0..ops.len()).filter(own).collect(),
    };
    if ops.is_empty() {
        return Message::error("there is no such operation");
    }
    if let Language::Plan = language {
        let rules = ops.iter().filter_map(|&op| analysis.plans[op].as_ref()).flat_map(|plan| {
            plan.stages.iter().map(|stage| {
                let phases = [
                    ("collect", &stage.collect),
                    ("allocate", &stage.allocate),
                    ("reassign", &stage.reassign),
                    ("erase", &stage.erase),
                ];
                let phases = phases.map(|(name, rows)| {
                    json!({ "phase": name, "rows": rows.iter().map(row).collect::<Vec<_>>() })
                });
                json!({ "op": plan.name, "rule": stage.rule, "phases": phases })
            })
        });
        return Message::of(json!({ "rules": rules.collect::<Vec<_>>() }));
    }
    let selection = Selection {
        program: &analysis.program,
        proved: &analysis.proved,
        sources: program.sources(),
        ops: &ops,
        exhaustive: false,
    };
    let text = match language {
        Language::Rust => rust(&selection),
        Language::Cpp | Language::Plan => cpp(&selection, &Style::default()),
    };
    match text {
        Ok(text) => Message::of(json!({ "text": text })),
        Err(failure) => Message::error(failure.diagnostic().message),
    }
}

/// A row of a plan; it is marked whether it is executed.
fn row(row: &Row) -> Value {
    let executed = row.executed;
    match &row.cell {
        Cell::Set { target, value } => json!([target, value, executed]),
        Cell::Test { claim, .. } => json!([claim, null, executed]),
        Cell::Note { text } => json!([text, null, executed]),
    }
}
