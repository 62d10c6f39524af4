//! `hedgerow std`

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::Path;

use super::arguments::StdArguments;
use super::failure::Failure;
use super::output::{print_line, table, wrapped};
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
        ([file], Some(_)) => print_line(file.text.trim_end()),
        (files, _) => {
            let listed: Vec<_> = files.iter().map(|file| list(*file)).collect();
            print_line(&listed.join("\n\n"));
        }
    }
    Ok(())
}

fn find(name: &str) -> Result<LibraryFile, Failure> {
    let target = library::target(name).filter(|_| name.ends_with(".target"));
    let of_file = library::file(name).or_else(|| library::file(&format!("std/{name}")));
    of_file.or(target).ok_or_else(|| {
        if let Some(file) = declared(name).first().map(|found| found.file) {
            return Failure::usage(format!(
                "`{name}` is declared in `{}`; `hedgerow explain {name}` tells about it",
                file.name
            ));
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
        return format!("{}\n{}", file.name, wrapped(&sentence(&lines), 0));
    }
    let (about, items) = items(file);
    let text = format!("{}\n{}\n{}", file.name, wrapped(&sentence(&about), 0), rows(items));
    text.trim_end().to_owned()
}

/// What each of the items does, a row each.
fn rows(items: Vec<Declared>) -> String {
    let row = |item: Declared| vec![format!("  {}", item.word), item.name, sentence(&item.docs)];
    table(&items.into_iter().map(row).collect::<Vec<_>>(), &[])
}

/// The comment of the library file with a name, and what its items do.
pub(super) fn file(name: &str) -> Option<String> {
    let file = library::file(name)?;
    let (about, items) = items(file);
    let about = about.join("\n").trim_end().to_owned();
    Some(format!("{}\n\n{about}\n\n{}", file.name, rows(items)))
}

/// A public item of the library.
pub(super) struct Declared {
    pub(super) file: LibraryFile,
    /// The keyword that declares it: `op`, `fn`, `script` or `attr`.
    pub(super) word: &'static str,
    name: String,
    /// Its declaration as it is written, without its body.
    head: String,
    docs: Vec<String>,
}

impl Declared {
    /// Its declaration, its comment, and where it is.
    pub(super) fn described(&self) -> String {
        let Self { file, head, docs, .. } = self;
        let docs: String = docs.iter().map(|line| format!("  {line}\n")).collect();
        let (name, short) = (file.name, file.short_name());
        let docs = docs.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
        format!("{head}\n{docs}\n  declared in `{name}`, which `hedgerow std {short}` prints")
    }
}

/// The public items of the library that have a name.
pub(super) fn declared(name: &str) -> Vec<Declared> {
    let items = library::files().flat_map(|file| items(file).1);
    items.filter(|item| item.name == name).collect()
}

/// The items of the library with a word in their name or in the first sentence of their comment, a
/// line each.
pub(super) fn mentioning(word: &str) -> Option<String> {
    let has_it = |text: &str| {
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        // "starts" is not about stars.
        words.any(|other| {
            let other = other.to_lowercase();
            let end = other.strip_prefix(word);
            end.is_some_and(|end| word.len() > 5 || ["", "s", "d", "ed", "ing"].contains(&end))
        })
    };
    let items = library::files().flat_map(|file| items(file).1);
    let rows = items.filter_map(|Declared { file, word: kind, name, docs, .. }| {
        let about = sentence(&docs);
        (has_it(&name) || has_it(&about))
            .then(|| vec![format!("  {kind}"), name, file.name.to_owned(), about])
    });
    let rows: Vec<_> = rows.collect();
    (!rows.is_empty()).then(|| table(&rows, &[]))
}

/// The comment at the head of a file, and its public items.
fn items(file: LibraryFile) -> (Vec<String>, Vec<Declared>) {
    let mut sources = Sources::new();
    let Tree { docs, items, .. } = parse(sources.add(file.name, file.text), file.text).tree;
    let public = items.into_iter().filter(|item| item.private_name().is_none());
    let declared = public.filter_map(|item| {
        let (word, name, docs, span) = match item {
            Item::Op(op) => ("op", op.name, op.docs, op.span),
            Item::Fn(function) => ("fn", function.name, function.docs, function.span),
            Item::Script(script) => ("script", script.name, script.docs, script.span),
            Item::Attr(attr) => ("attr", attr.name, attr.docs, attr.span),
            Item::Use(_) | Item::Test(_) | Item::Broken(_) => return None,
        };
        let head = sources.slice(span).split('{').next().unwrap_or_default();
        let head = head.split_whitespace().collect::<Vec<_>>().join(" ");
        Some(Declared { file, word, name: name.text, head, docs })
    });
    (docs, declared.collect())
}

/// The first sentence of a comment. The point behind an initial ends none.
fn sentence(docs: &[String]) -> String {
    let paragraph = docs.iter().map(|line| line.trim());
    let paragraph: Vec<_> = paragraph.take_while(|line| !line.is_empty()).collect();
    let text = paragraph.join(" ");
    let is_initial = |at: usize| {
        let mut before = text[..at].chars().rev();
        before.next().is_some_and(char::is_uppercase) && before.next().is_none_or(|c| c == ' ')
    };
    let end = text.match_indices(". ").find(|&(at, _)| !is_initial(at));
    end.map_or(text.as_str(), |(at, _)| &text[..=at]).to_owned()
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
        print_line(&format!("{} -> {}", file.name, place.display()));
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
