//! `hedgerow completions`

use clap::CommandFactory;
use clap_complete::generate;

use super::arguments::{Arguments, CompletionsArguments};
use super::failure::Failure;
use super::output::print_line_exactly;

/// Prints a script that completes commands, options and files in a shell.
pub(super) fn completions(arguments: &CompletionsArguments) -> Result<(), Failure> {
    let mut script = Vec::new();
    generate(arguments.shell, &mut Arguments::command(), "hedgerow", &mut script);
    print_line_exactly(String::from_utf8_lossy(&script).trim_end());
    Ok(())
}
