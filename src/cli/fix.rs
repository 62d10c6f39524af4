//! `hedgerow check --fix`: applies the certain fixes to a file.
//!
//! A fix may reveal further errors, so the text is analyzed again after each round. Nothing is
//! written before the last round.

use std::collections::HashSet;
use std::path::Path;

use super::failure::Failure;
use super::files;
use super::output::complain;
use super::program::{self, Program};
use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::source::{FileId, Source};

/// The most rounds.
const MOST_ROUNDS: usize = 64;

/// Reads a program, applies the certain fixes to its file, and prints them. Files that it uses stay
/// as they are.
pub(super) fn mended(path: &Path) -> Result<Program, Failure> {
    let mut program = program::read(path)?;
    if !path.exists() {
        let shown = path.display();
        return Err(Failure::usage(format!(
            "`{shown}` is a file of the library, and stays as it is"
        )));
    }
    let mut seen = HashSet::new();
    let mut done = 0;
    for _ in 0..MOST_ROUNDS {
        let source = program.sources.get(program.analysis.file);
        if !seen.insert(source.text().to_owned()) {
            break;
        }
        let told = &program.analysis.diagnostics;
        let Some((text, titles)) = round(source, program.analysis.file, told) else {
            break;
        };
        for (line, title) in &titles {
            complain(&format!("{}:{line}: {title}", source.name()));
        }
        done += titles.len();
        program = Program::of(source.name().to_owned(), text);
    }
    if done > 0 {
        let text = program.sources.get(program.analysis.file).text();
        files::write(path, text.as_bytes())?;
        let fixes = if done == 1 { "fix" } else { "fixes" };
        complain(&format!("{}: {done} {fixes} written", path.display()));
    }
    Ok(program)
}

/// The text with the fixes of diagnostics that have exactly one, as far as they do not overlap, and
/// the line and the title of each; `None` if there is none.
fn round(
    source: &Source,
    file: FileId,
    told: &[Diagnostic],
) -> Option<(String, Vec<(usize, String)>)> {
    let mut edits: Vec<&Edit> = Vec::new();
    let mut titles = Vec::new();
    for diagnostic in told {
        // Between several, the user has to choose.
        let [fix] = diagnostic.fixes.as_slice() else {
            continue;
        };
        if !fits(fix, (source, file), &edits) {
            continue;
        }
        edits.extend(&fix.edits);
        let (line, _) = source.line_column(diagnostic.span().start as usize);
        titles.push((line, fix.title.clone()));
    }
    if titles.is_empty() {
        return None;
    }
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let mut text = source.text().to_owned();
    for edit in edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.text);
    }
    Some((text, titles))
}

/// True if a fix lies in the file, and apart from all other edits.
fn fits(fix: &Fix, (source, file): (&Source, FileId), others: &[&Edit]) -> bool {
    fix.edits.iter().all(|edit| {
        let inside = edit.span.file == file && source.text().get(edit.span.range()).is_some();
        inside
            && others
                .iter()
                .all(|other| edit.span.end < other.span.start || other.span.end < edit.span.start)
    })
}
