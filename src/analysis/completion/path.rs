//! Completions in the quotes of a `use`.

use std::ops::Range;
use std::path::Path;

use super::choice::{Choice, Completion};
use crate::analysis::disk::is_program;
use crate::analysis::files::{Reader, name_of};
use crate::analysis::snapshot::Snapshot;
use crate::library;

/// The programs that a path may lead to: those of the folder that is written so far, and those of
/// the library.
pub(super) fn paths(
    snapshot: &Snapshot,
    offset: usize,
    written: Range<usize>,
    reader: &mut dyn Reader,
) -> Vec<Completion> {
    let path = |path: String, rank| Completion {
        replaced: Some(written.clone()),
        ..Completion::new(path, Choice::File, rank)
    };
    let start = snapshot.text().get(written.start..offset).unwrap_or_default();
    let folder = start.rfind('/').map_or("", |end| &start[..=end]);
    let mut found = Vec::new();
    for folder in folders(folder) {
        let beside = beside(snapshot, &folder, reader);
        found.extend(beside.into_iter().map(|program| path(program, 0)));
    }
    found.extend(library::files().map(|file| path(file.name.to_owned(), 1)));
    found
}

/// The folders to look in: the one that is written, and the one around it unless the path goes down.
fn folders(written: &str) -> Vec<String> {
    let mut folders = vec![written.to_owned()];
    if written.trim_start_matches("../").is_empty() {
        folders.push(format!("{written}../"));
    }
    folders
}

/// The paths of the other programs of a folder.
fn beside(snapshot: &Snapshot, folder: &str, reader: &mut dyn Reader) -> Vec<String> {
    let here = snapshot.sources().get(snapshot.file()).name();
    if folder.starts_with(library::FOLDER) {
        return Vec::new();
    }
    let known = reader.beside(&name_of(here, &format!("{folder}_.hedge"))).into_iter();
    let programs = known.filter(|name| name != here && is_program(Path::new(name)));
    programs.filter_map(|name| Some(format!("{folder}{}", name.rsplit('/').next()?))).collect()
}
