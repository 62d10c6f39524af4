//! `hedgerow run FILE::SCRIPT --help`: what a script does, and its parameters.

use super::failure::Failure;
use super::output::{eprint_diagnostics, print_line, table};
use super::program::{self, Program};
use crate::resolve::Script;

/// The script that the arguments of this process ask help about, if they do: the first word after
/// `run` that is not an option.
pub(super) fn asked(mut arguments: impl Iterator<Item = String>) -> Option<String> {
    let command = arguments.find(|argument| !argument.starts_with('-'));
    command.filter(|command| command == "run")?;
    let mut rest = arguments.take_while(|argument| argument != "--help" && argument != "-h");
    rest.find(|argument| !argument.starts_with('-'))
}

/// Prints what a script does, or all scripts of a file if none is named.
pub(super) fn help(script: &str) -> Result<(), Failure> {
    let (path, name) = program::part(script);
    let program = program::read(path)?;
    eprint_diagnostics(&program.analysis.diagnostics, &program.sources);
    let scripts = &program.analysis.program.scripts;
    let own = scripts.iter().filter(|script| program.analysis.is_own(script.span));
    let told: Vec<&Script> = match name {
        None if own.clone().count() > 1 => own.collect(),
        name => vec![&scripts[program::find_script(&program, name)?]],
    };
    print_line(
        &told.into_iter().map(|script| about(&program, script)).collect::<Vec<_>>().join("\n\n"),
    );
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
        "Usage: hedgerow run {file}::{name} MESH [-o FILE] [--set NAME=VALUE]...\n"
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
