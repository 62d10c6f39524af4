//! `hedgerow std`

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::Path;

use super::advice::of_library;
use super::arguments::StdArguments;
use super::failure::Failure;
use super::output::{say, table};
use crate::diagnostic::quoted;
use crate::library::{self, LibraryFile};
use crate::source::Sources;
use crate::syntax::parse;
use crate::syntax::tree::{File as Tree, Item};

/// Lists the standard library, prints a file of it, or copies it out.
pub(super) fn std(arguments: &StdArguments) -> Result<(), Failure> {
    let found = match &arguments.name {
        Some(name) => vec![find(name)?],
        None => library::files().chain(library::targets()).collect(),
    };
    if let Some(to) = &arguments.copy {
        return copy(&found, to, arguments.name.is_some());
    }
    match (found.as_slice(), &arguments.name) {
        ([file], Some(_)) => say(file.text.trim_end()),
        (files, _) => {
            let listed: Vec<_> = files.iter().map(|file| list(*file)).collect();
            say(&listed.join("\n\n"));
        }
    }
    Ok(())
}

fn find(name: &str) -> Result<LibraryFile, Failure> {
    let target = library::target(name).filter(|_| name.ends_with(".target"));
    let of_file = library::file(name).or_else(|| library::file(&format!("std/{name}")));
    of_file.or(target).ok_or_else(|| {
        if let Some((file, _)) = of_library(name) {
            return Failure::usage(format!("`{name}` is declared in `{}`", file.name));
        }
        let names = quoted(library::files().chain(library::targets()).map(|file| file.name));
        Failure::usage(format!("the library has no `{name}`; it has {names}"))
    })
}

/// A file in a few lines: what it is for, and what each of its items does.
fn list(file: LibraryFile) -> String {
    if file.name.ends_with(".target") {
        let lines = file.text.lines().map_while(|line| line.strip_prefix("//"));
        let lines: Vec<_> = lines.map(String::from).collect();
        return format!("{}\n{}", file.name, sentence(&lines));
    }
    let mut sources = Sources::new();
    let parsed = parse(sources.add(file.name, file.text), file.text);
    let Tree { docs, items, .. } = &parsed.tree;
    let mut rows = Vec::new();
    for item in items.iter().filter(|item| item.private_name().is_none()) {
        let (word, name, docs) = match item {
            Item::Op(op) => ("op", &op.name, &op.docs),
            Item::Fn(function) => ("fn", &function.name, &function.docs),
            Item::Script(script) => ("script", &script.name, &script.docs),
            Item::Attr(attr) => ("attr", &attr.name, &attr.docs),
            Item::Use(_) | Item::Test(_) | Item::Broken(_) => continue,
        };
        let row = [format!("  {word}"), name.text.clone(), sentence(docs)];
        rows.push(row.to_vec());
    }
    let text = format!("{}\n{}\n{}", file.name, sentence(docs), table(&rows, &[]));
    text.trim_end().to_owned()
}

/// The first sentence of a comment.
fn sentence(docs: &[String]) -> String {
    let paragraph = docs.iter().map(|line| line.trim());
    let paragraph: Vec<_> = paragraph.take_while(|line| !line.is_empty()).collect();
    let text = paragraph.join(" ");
    match text.split_once(". ") {
        Some((first, _)) => format!("{first}."),
        None => text,
    }
}

/// Copies files to a folder; a single one also to a file.
fn copy(files: &[LibraryFile], to: &Path, single: bool) -> Result<(), Failure> {
    let is_file = single && to.extension().is_some_and(|end| end == "hedge");
    if !is_file && to.is_file() {
        let shown = to.display();
        return Err(Failure::usage(format!("`{shown}` is a file; a folder is wanted")));
    }
    for file in files {
        let short = file.name.rsplit('/').next().unwrap_or(file.name);
        let place = if is_file { to.to_owned() } else { to.join(short) };
        let failed = |error: std::io::Error| {
            let shown = place.display();
            Failure::usage(match error.kind() {
                ErrorKind::AlreadyExists => format!("`{shown}` is there already, and stays"),
                _ => format!("cannot write `{shown}`: {error}"),
            })
        };
        if !is_file {
            std::fs::create_dir_all(to).map_err(failed)?;
        }
        write_new(&place, file.text).map_err(failed)?;
        say(&format!("{} -> {}", file.name, place.display()));
    }
    Ok(())
}

/// Writes a file that does not exist yet, completely or not at all.
fn write_new(place: &Path, text: &str) -> std::io::Result<()> {
    let mut file = File::create_new(place)?;
    let written = file.write_all(text.as_bytes());
    if written.is_err() {
        // The incomplete file is of no use; the error of writing it is returned.
        let _ = std::fs::remove_file(place);
    }
    written
}
