//! `hedgerow run FILE::SCRIPT --help`: what a script does, and what it can be told.

use clap::CommandFactory;

use super::arguments::Arguments;
use super::failure::Failure;
use super::output::{complain_of, say, table};
use super::program::{self, Program};
use crate::resolve::Script;

/// Says what a script does, or all scripts of a file if none is named; without a file, what
/// `run` does.
pub(super) fn help(script: Option<&str>) -> Result<(), Failure> {
    let Some(script) = script else {
        let mut command = Arguments::command();
        if let Some(run) = command.find_subcommand_mut("run") {
            say(run.render_help().to_string().trim_end());
        }
        return Ok(());
    };
    let (path, name) = program::part(script);
    let program = program::read(path)?;
    complain_of(&program.analysis.diagnostics, &program.sources);
    let scripts = &program.analysis.program.scripts;
    let own = scripts
        .iter()
        .filter(|script| script.span.file == program.analysis.file);
    let told: Vec<&Script> = match name {
        None if own.clone().count() > 1 => own.collect(),
        name => vec![&scripts[program::find_script(&program, name)?]],
    };
    let told = told.into_iter().map(|script| about(&program, script));
    say(&told.collect::<Vec<_>>().join("\n\n"));
    Ok(())
}

fn about(program: &Program, script: &Script) -> String {
    let file = program.sources.get(script.span.file).name();
    let mut text = String::new();
    for line in &script.docs {
        text.push_str(&format!("{line}\n"));
    }
    if !script.docs.is_empty() {
        text.push('\n');
    }
    let name = &script.name;
    text.push_str(&format!(
        "Usage: hedgerow run {file}::{name} MESH -o FILE [--set NAME=VALUE]...\n"
    ));
    if script.params.is_empty() {
        text.push_str("\nIt has no parameters.\n");
    } else {
        text.push_str("\nParameters:\n");
        let rows = script.params.iter().map(|param| {
            let default = match &param.default {
                Some(default) => format!("if not given: {}", program.sources.slice(default.span)),
                None => "has to be given".to_owned(),
            };
            let name = format!("  {}", param.name);
            vec![name, param.ty.word().to_owned(), default]
        });
        text.push_str(&table(&rows.collect::<Vec<_>>(), &[]));
        text.push('\n');
    }
    text.push_str("\nOther options: hedgerow run --help");
    text
}
