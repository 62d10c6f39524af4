//! Advice on invalid arguments: what was probably meant, in a line.
//!
//! Used only if the arguments could not be parsed. Advice replaces the message of the argument
//! parser, which is printed if there is none.

use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::library::declared;
use super::program::{self, is_mesh};
use crate::analysis::is_program;

/// The advice on an error in the arguments.
pub(super) fn advice(error: &clap::Error, words: &[String]) -> Option<String> {
    let invalid = |kind| match error.get(kind) {
        Some(ContextValue::String(word)) => Some(word.as_str()),
        _ => None,
    };
    match error.kind() {
        ErrorKind::InvalidSubcommand => no_command(invalid(ContextKind::InvalidSubcommand)?),
        ErrorKind::UnknownArgument => too_much(invalid(ContextKind::InvalidArg)?, words),
        ErrorKind::MissingRequiredArgument => too_little(words),
        _ => None,
    }
}

/// The words of the command line that are not options.
fn places(words: &[String]) -> Vec<&str> {
    words.iter().map(String::as_str).filter(|word| !word.starts_with('-')).collect()
}

/// Advice on a word that is not a command: a file, or an item of the library.
fn no_command(word: &str) -> Option<String> {
    if ["emit", "compile", "export", "generate"].contains(&word) {
        return Some(format!(
            "there is no command `{word}`: `hedgerow plan FILE::OP --as cpp -o OUT.hpp` writes an \
             operation as C++, `--as rust` as Rust"
        ));
    }
    let path = Path::new(word);
    if is_mesh(path) {
        return Some(format!(
            "`{word}` is a mesh, and no command: `hedgerow info {word}` describes it, `hedgerow run \
             FILE.hedge {word}` runs a script on it"
        ));
    }
    if is_program(path) || word.contains("::") {
        return Some(format!(
            "`{word}` is a program, and no command: `hedgerow check {word}` proves it, `hedgerow \
             run {word} MESH` runs a script of it"
        ));
    }
    declared(word).into_iter().find_map(|item| {
        let name = item.file.name.trim_end_matches(".hedge");
        Some(match item.word {
            "op" => format!(
                "`{word}` is an operation of the library, and no command: `hedgerow apply \
                 {name}::{word} MESH --at PLACE -o OUT` does it at a place"
            ),
            "script" => format!(
                "`{word}` is a script of the library, and no command: `hedgerow run {name}::{word} \
                 MESH -o OUT` runs it"
            ),
            _ => return None,
        })
    })
}

/// Advice on an unexpected word.
fn too_much(word: &str, words: &[String]) -> Option<String> {
    let command = words.first()?.as_str();
    let at = words.iter().position(|known| known == word || known.starts_with(&format!("{word}=")));
    let before = |back: usize| words.get(at?.checked_sub(back)?).map(String::as_str);
    if word == "--json" {
        return Some("an answer in JSON is asked for by `--format json`".to_owned());
    }
    if !matches!(command, "run" | "apply") {
        return None;
    }
    if let Some(advice) = several_settings(words) {
        return Some(advice);
    }
    if let (Some("--set"), Some(name)) = (before(2), before(1)) {
        return Some(match name.contains('=') {
            true => "write `--set NAME=VALUE` without spaces, a vector as x,y,z".to_owned(),
            false => format!("write `--set NAME=VALUE`: `--set {name}={word}`"),
        });
    }
    if let (Some("--at"), Some(kind)) = (before(2), before(1)) {
        return Some(format!("a place is one word: `--at {kind}:{word}`"));
    }
    if let Some(name) = word.strip_prefix("--") {
        return parameter(name, words);
    }
    let places = places(words);
    let [_, file, name, ..] = places.as_slice() else { return None };
    if !is_mesh(Path::new(name)) && !name.contains(['.', '/', '=']) && is_mesh(Path::new(word)) {
        let more = if command == "apply" { " --at PLACE -o OUT" } else { "" };
        let message = format!(
            "what is done stands behind its file: `hedgerow {command} {file}::{name} {word}{more}`"
        );
        return Some(message);
    }
    is_mesh(Path::new(word)).then(|| format!("where the result goes says `-o {word}`"))
}

/// Advice on several parameters after one `--set`.
fn several_settings(words: &[String]) -> Option<String> {
    let is_setting = |word: &&String| word.contains('=') && !word.starts_with('-');
    let sets = words.iter().enumerate().filter(|(_, word)| *word == "--set");
    let mut settings = sets.map(|(at, _)| words[at + 1..].iter().take_while(is_setting));
    let several: Vec<_> = settings.find(|settings| settings.clone().count() > 1)?.collect();
    let told: Vec<_> = several.iter().map(|setting| format!("--set {setting}")).collect();
    Some(format!("each parameter has its own `--set`: `{}`", told.join(" ")))
}

/// Advice on a parameter of the script or operation that is written like an option.
fn parameter(name: &str, words: &[String]) -> Option<String> {
    let program = program::read(program::part(places(words).get(1)?).0).ok()?.analysis.program;
    let name = name.split('=').next()?.replace('-', "_");
    let scripts = program.scripts.iter().flat_map(|script| &script.params);
    let of_scripts = scripts.map(|param| &param.name);
    let of_ops = program.ops.iter().flat_map(|op| &op.params).map(|param| &param.name);
    of_scripts.chain(of_ops).any(|known| *known == name).then(|| {
        format!("`{name}` is a parameter of the program: its value is given by `--set {name}=…`")
    })
}

/// Advice on a missing argument: a mesh without a program.
fn too_little(words: &[String]) -> Option<String> {
    let places = places(words);
    let [command @ ("run" | "apply"), only] = places.as_slice() else { return None };
    is_mesh(Path::new(only)).then(|| {
        format!(
            "`{only}` is a mesh, and the program stands before it: `hedgerow {command} FILE.hedge \
             {only}`, for example `hedgerow run std/remesh {only}`"
        )
    })
}
