//! `hedgerow fmt`

use std::io::{Read, stdin};
use std::path::Path;

use super::arguments::FmtArguments;
use super::failure::Failure;
use super::output::{eprint_diagnostics, eprint_line, write_stdout};
use super::program::expect_program;
use crate::analysis::{program_text, read_program};
use crate::format::{Formatted, format};
use crate::mesh::{FileReason, replace_file};
use crate::source::Sources;

/// The name of a file that comes from standard input.
const STANDARD_INPUT: &str = "<stdin>";

/// Formats files where they are, or standard input to standard output.
pub(super) fn fmt(arguments: &FmtArguments) -> Result<(), Failure> {
    let mut well = true;
    let mut stopped = None;
    for path in &arguments.files {
        let done = if path.as_os_str() == "-" {
            from_standard_input(arguments.check)
        } else {
            in_place(path, arguments.check)
        };
        // A file that cannot be read does not keep the others from being formatted.
        match done {
            Ok(fine) => well &= fine,
            Err(failure) => {
                failure.tell();
                stopped = Some(failure.exit_code());
            }
        }
    }
    match stopped {
        Some(code) => Err(Failure::Silent(code)),
        None if well => Ok(()),
        None => Err(Failure::NotProved),
    }
}

fn from_standard_input(check: bool) -> Result<bool, Failure> {
    let mut bytes = Vec::new();
    let read = stdin().read_to_end(&mut bytes);
    let text = read
        .map_err(|error| error.to_string())
        .and_then(|_| program_text(bytes))
        .map_err(|why| Failure::usage(format!("cannot read `{STANDARD_INPUT}`: {why}")))?;
    let formatted = formatted(&text, STANDARD_INPUT)?;
    if check {
        return Ok(is_as_it_should(&text, &formatted, STANDARD_INPUT));
    }
    write_stdout(formatted.text.as_bytes())?;
    Ok(formatted.diagnostics.is_empty())
}

fn in_place(path: &Path, check: bool) -> Result<bool, Failure> {
    expect_program(path)?;
    let shown = path.display().to_string();
    let text = read_program(path)
        .map_err(|why| Failure::usage(format!("cannot read `{shown}`: {why}")))?;
    let formatted = formatted(&text, &shown)?;
    if check {
        return Ok(is_as_it_should(&text, &formatted, &shown));
    }
    if formatted.text != text {
        replace(path, &formatted.text)
            .map_err(|error| Failure::usage(format!("cannot write `{shown}`: {error}")))?;
    }
    Ok(formatted.diagnostics.is_empty())
}

/// Formats a text, and prints its diagnostics.
fn formatted(text: &str, name: &str) -> Result<Formatted, Failure> {
    let mut sources = Sources::new();
    let formatted = format(sources.add(name, text), text).map_err(|refusal| {
        Failure::usage(format!(
            "`{name}` is left as it is: {refusal} (a mistake of hedgerow; please report it)"
        ))
    })?;
    eprint_diagnostics(&formatted.diagnostics, &sources);
    Ok(formatted)
}

fn is_as_it_should(text: &str, formatted: &Formatted, name: &str) -> bool {
    let same = formatted.text == text;
    if !same {
        eprint_line(&format!("`{name}` is not formatted"));
    }
    same && formatted.diagnostics.is_empty()
}

/// Replaces a file by a text, completely or not at all; its permissions stay.
fn replace(path: &Path, text: &str) -> Result<(), FileReason> {
    replace_file(path, |output| output.write_all(text.as_bytes()).map_err(FileReason::Io))
}
