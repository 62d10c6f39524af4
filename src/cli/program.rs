//! Programs from files.

use std::path::Path;

use super::failure::Failure;
use super::output::complain_of;
use crate::analysis::Analysis;
use crate::source::Sources;

/// A program as read from a file.
pub(super) struct Program {
    pub sources: Sources,
    pub analysis: Analysis,
}

/// Reads a program. What is wrong inside it is in its diagnostics.
pub(super) fn read(path: &Path) -> Result<Program, Failure> {
    let shown = path.display();
    let bytes = std::fs::read(path)
        .map_err(|error| Failure::usage(format!("cannot read `{shown}`: {error}")))?;
    let text = as_text(bytes, &shown.to_string())?;
    let mut sources = Sources::new();
    let file = sources.add(shown.to_string(), text);
    let analysis = Analysis::of(&sources, file);
    Ok(Program { sources, analysis })
}

/// The bytes of a file as text.
pub(super) fn as_text(bytes: Vec<u8>, shown: &str) -> Result<String, Failure> {
    let text = String::from_utf8(bytes).map_err(|error| {
        let line = error.as_bytes()[..error.utf8_error().valid_up_to()]
            .iter()
            .filter(|&&byte| byte == b'\n')
            .count()
            + 1;
        Failure::usage(format!("`{shown}` is not UTF-8 text: see line {line}"))
    })?;
    if u32::try_from(text.len()).is_err() {
        return Err(Failure::usage(format!("`{shown}` is larger than 4 GiB")));
    }
    Ok(text)
}

/// Reads a program that is wanted whole: says what is wrong, and stops there.
pub(super) fn read_sound(path: &Path) -> Result<Program, Failure> {
    let program = read(path)?;
    complain_of(&program.analysis.diagnostics, &program.sources);
    if program.analysis.is_sound() {
        Ok(program)
    } else {
        Err(Failure::NotProved)
    }
}

/// Parts `FILE::NAME`.
pub(super) fn part(text: &str) -> (&Path, Option<&str>) {
    match text.rsplit_once("::") {
        Some((file, name)) => (Path::new(file), Some(name)),
        None => (Path::new(text), None),
    }
}

/// The index of the op that `FILE::OP` names; without a name, the only one.
pub(super) fn find_op(program: &Program, name: Option<&str>) -> Result<usize, Failure> {
    let names: Vec<_> = program
        .analysis
        .program
        .ops
        .iter()
        .map(|op| op.name.as_str())
        .collect();
    find("operation", &names, name)
}

/// The index of the script that `FILE::SCRIPT` names; without a name, the only one.
pub(super) fn find_script(program: &Program, name: Option<&str>) -> Result<usize, Failure> {
    let names: Vec<_> = program
        .analysis
        .program
        .scripts
        .iter()
        .map(|script| script.name.as_str())
        .collect();
    find("script", &names, name)
}

fn find(what: &str, names: &[&str], name: Option<&str>) -> Result<usize, Failure> {
    let list = || {
        names
            .iter()
            .map(|name| format!("`{name}`"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    match (name, names) {
        (_, []) => Err(Failure::usage(format!("the file has no {what}"))),
        (None, [_]) => Ok(0),
        (None, _) => Err(Failure::usage(format!(
            "which {what}? write FILE::NAME with one of {}",
            list()
        ))),
        (Some(name), _) => names
            .iter()
            .position(|known| *known == name)
            .ok_or_else(|| {
                Failure::usage(format!(
                    "the file has no {what} `{name}`; it has {}",
                    list()
                ))
            }),
    }
}

/// Parts every `NAME=VALUE` of `--set`.
pub(super) fn settings(texts: &[String]) -> Result<Vec<(String, String)>, Failure> {
    let part = |text: &String| match text.split_once('=') {
        Some((name, value)) => Ok((name.to_string(), value.to_string())),
        None => Err(Failure::usage(format!(
            "`{text}` is no setting: write NAME=VALUE"
        ))),
    };
    texts.iter().map(part).collect()
}
