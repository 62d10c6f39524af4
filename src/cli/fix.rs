//! `hedgerow check --fix`: applies the certain fixes to a file.
//!
//! A fix may reveal further errors, so the text is analyzed again after each round. Nothing is
//! written before the last round. If a fix only makes the text longer, and its error comes back
//! each time, none of its kind is written.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use super::failure::Failure;
use super::files;
use super::output::complain;
use super::program::{self, Program};
use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::source::{FileId, Source};

/// The most rounds.
const MOST_ROUNDS: usize = 64;

/// The most rounds in which the fix of one error makes the text longer.
const MOST_IN_VAIN: usize = 16;

/// The code and the message of an error.
type Kind = (&'static str, String);

/// A fix that is applied.
struct Applied {
    kind: Kind,
    line: usize,
    title: String,
}

/// Reads a program, applies the certain fixes to its file, and prints them. Files that it uses stay
/// as they are.
pub(super) fn mended(path: &Path) -> Result<Program, Failure> {
    let mut first = program::read(path)?;
    if !path.exists() {
        let shown = path.display();
        return Err(Failure::usage(format!(
            "`{shown}` is a file of the library, and stays as it is"
        )));
    }
    let source = first.sources.get(first.analysis.file);
    let (name, text) = (source.name().to_owned(), source.text().to_owned());
    let mut vain = HashSet::new();
    let (program, applied) = loop {
        match rounds(first, &vain) {
            Ok(mended) => break mended,
            Err(kind) => vain.insert(kind),
        };
        first = Program::of(name.clone(), text.clone());
    };
    for Applied { line, title, .. } in &applied {
        complain(&format!("{name}:{line}: {title}"));
    }
    let done = applied.len();
    if done > 0 {
        let text = program.sources.get(program.analysis.file).text();
        files::write(path, text.as_bytes())?;
        let fixes = if done == 1 { "fix" } else { "fixes" };
        complain(&format!("{}: {done} {fixes} written", path.display()));
    } else if !program.analysis.is_sound() {
        complain(&format!("{}: no error has a certain fix", path.display()));
    }
    Ok(program)
}

/// All rounds of fixes, except those of errors that are fixed in vain; the kind of another such
/// error if there is one.
fn rounds(mut program: Program, vain: &HashSet<Kind>) -> Result<(Program, Vec<Applied>), Kind> {
    let mut seen = HashSet::new();
    let mut longer: HashMap<Kind, usize> = HashMap::new();
    let mut all = Vec::new();
    for _ in 0..MOST_ROUNDS {
        let source = program.sources.get(program.analysis.file);
        if !seen.insert(source.text().to_owned()) {
            break;
        }
        let told = program.analysis.diagnostics.iter();
        let told = told.filter(|told| !vain.contains(&kind(told)));
        let Some((text, applied)) = round(source, program.analysis.file, told) else {
            break;
        };
        let grows = text.len() > source.text().len();
        let kinds: HashSet<&Kind> = applied.iter().map(|applied| &applied.kind).collect();
        for kind in kinds.into_iter().filter(|_| grows) {
            let count = longer.entry(kind.clone()).or_default();
            *count += 1;
            if *count > MOST_IN_VAIN {
                return Err(kind.clone());
            }
        }
        all.extend(applied);
        program = Program::of(source.name().to_owned(), text);
    }
    Ok((program, all))
}

fn kind(told: &Diagnostic) -> Kind {
    (told.code, told.message.clone())
}

/// The text with the fixes of diagnostics that have exactly one, as far as they do not overlap;
/// `None` if there is none.
fn round<'d>(
    source: &Source,
    file: FileId,
    told: impl Iterator<Item = &'d Diagnostic>,
) -> Option<(String, Vec<Applied>)> {
    let mut edits: Vec<&Edit> = Vec::new();
    let mut applied = Vec::new();
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
        applied.push(Applied { kind: kind(diagnostic), line, title: fix.title.clone() });
    }
    if applied.is_empty() {
        return None;
    }
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let mut text = source.text().to_owned();
    for edit in edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.text);
    }
    Some((text, applied))
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
