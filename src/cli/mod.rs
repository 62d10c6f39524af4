//! The command line: runs commands and prints their results.
//!
//! Only the command line and the language server use the standard streams. Results go to standard
//! output, messages about them to standard error. Exit codes: 0 all is well; 1 something is not
//! proved or not formatted, or a script failed; 2 bad usage or a file that cannot be read or
//! written; 3 the operation was refused; 130 interrupted.

mod advice;
mod aliases;
mod apply;
mod arguments;
mod check;
mod completions;
mod convert;
mod counts;
mod draw;
mod explain;
mod failure;
mod files;
mod fix;
mod fmt;
mod info;
mod interrupt;
mod learn;
mod library;
mod lsp;
pub mod memory;
mod meshes;
mod option_groups;
mod output;
mod place;
mod plan;
mod play;
mod program;
mod progress;
mod run;
mod script;
mod test;
mod view;
mod witness;

use std::process::ExitCode;

use clap::Parser;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use arguments::{Arguments, Command};
use failure::Failure;

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(mut error) => {
            let words = std::env::args_os().skip(1);
            let words: Vec<_> = words.map(|word| word.to_string_lossy().into_owned()).collect();
            if error.kind() == ErrorKind::DisplayHelp
                && let Some(script) = script::asked(words.iter().cloned())
            {
                return ended(script::help(&script));
            }
            let wants_json = words.iter().any(|word| word == "--format=json")
                || words.windows(2).any(|words| words == ["--format", "json"]);
            if let Some(advice) = advice::advice(&error, &words) {
                return ended_as(wants_json, Err(Failure::usage(advice)));
            }
            suggest_set(&mut error);
            // Help and version are not failures.
            if !error.use_stderr() {
                output::print_line(error.to_string().trim_end());
                return ended(Ok(()));
            }
            let _ = error.print();
            let text = error.to_string();
            let ends = ["\n\nUsage:", "\n\nFor more information"].map(|end| text.find(end));
            let why = &text[..ends.into_iter().flatten().min().unwrap_or(text.len())];
            let failure = Failure::usage(why.strip_prefix("error: ").unwrap_or(why));
            let told = if wants_json { failure.tell_json() } else { Ok(()) };
            return ended(told.and(Err(Failure::Silent(2.into()))));
        }
    };
    if let Some(threads) = arguments.command.threads() {
        threads.set();
    }
    let answers_json = arguments.command.answers_json();
    let done = match arguments.command {
        Command::Check(arguments) => check::check(&arguments),
        Command::Plan(arguments) => plan::plan(&arguments),
        Command::Convert(arguments) => convert::convert(&arguments),
        Command::Info(arguments) => info::info(&arguments),
        Command::Explain(arguments) => explain::explain(&arguments),
        Command::Apply(arguments) => apply::apply(&arguments),
        Command::Run(arguments) => run::run(&arguments),
        Command::Draw(arguments) => draw::draw(&arguments),
        Command::View(arguments) => view::view(&arguments),
        Command::Lsp(arguments) => lsp::lsp(&arguments),
        Command::Fmt(arguments) => fmt::fmt(&arguments),
        Command::Test(arguments) => test::test(&arguments),
        Command::Play(arguments) => play::play(&arguments),
        Command::Learn(arguments) => learn::learn(&arguments),
        Command::Std(arguments) => library::std(&arguments),
        Command::Completions(arguments) => completions::completions(&arguments),
    };
    ended_as(answers_json, done)
}

/// Suggests `--set` for an unexpected argument of the form `NAME=VALUE`.
fn suggest_set(error: &mut clap::Error) {
    let word = match (error.kind(), error.get(ContextKind::InvalidArg)) {
        (ErrorKind::UnknownArgument, Some(ContextValue::String(word))) => word.clone(),
        _ => return,
    };
    if word.contains('=') && !word.starts_with('-') {
        let tip = format!("values are given by '--set {word}'");
        let tip = ContextValue::StyledStrs(vec![tip.into()]);
        error.insert(ContextKind::Suggested, tip);
    }
}

/// The exit code of a command; prints its failure, and also in JSON if that is wanted.
fn ended_as(wants_json: bool, done: Result<(), Failure>) -> ExitCode {
    ended(match done {
        Err(failure) if wants_json => failure.tell_json().and(Err(failure)),
        done => done,
    })
}

/// The exit code of a command; prints its failure.
fn ended(done: Result<(), Failure>) -> ExitCode {
    match done.and_then(|()| output::check_stdout()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.tell();
            failure.exit_code()
        }
    }
}
