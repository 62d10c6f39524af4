//! `hedgerow check --fix`: applies the certain fixes to a file.
//!
//! A fix may reveal further errors, so the text is analyzed again after each round. Nothing is
//! written before the last round. If a fix only makes the text longer, and its error comes back
//! each time, none of its kind is written; and none is written in an op that is left with errors, and
//! not with fewer than before.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use super::failure::Failure;
use super::files;
use super::output::eprint_line;
use super::program::{self, Program};
use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::source::{FileId, Source, Span};

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
    /// The op that it is in, if that could be read.
    op: Option<String>,
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
    let mut ineffective = HashSet::new();
    let mut harmful = HashSet::new();
    let before = errors_of_ops(&first);
    let (program, applied) = loop {
        match rounds(first, &ineffective, &harmful) {
            Ok((mended, applied)) => {
                let after = errors_of_ops(&mended);
                let worse = no_better(&before, &after).into_iter().filter(|op| {
                    applied.iter().filter_map(|fix| fix.op.as_ref()).any(|one| one == op)
                });
                let known = harmful.len();
                harmful.extend(worse);
                if harmful.len() == known {
                    break (mended, applied);
                }
            }
            Err(kind) => {
                ineffective.insert(kind);
            }
        }
        first = Program::of(name.clone(), text.clone());
    };
    for Applied { line, title, .. } in &applied {
        eprint_line(&format!("{name}:{line}: {title}"));
    }
    let done = applied.len();
    if done > 0 {
        let text = program.sources.get(program.analysis.file).text();
        files::write(path, text.as_bytes())?;
        let fixes = if done == 1 { "fix" } else { "fixes" };
        eprint_line(&format!("{}: {done} {fixes} written", path.display()));
    } else if !program.analysis.is_sound() {
        let told = program.analysis.diagnostics.iter();
        let has_fix = told.filter(|told| told.is_error()).any(|told| told.fixes.len() == 1);
        eprint_line(&match has_fix {
            true => format!("{}: no fix is certain to leave fewer errors", path.display()),
            false => format!("{}: no error has a certain fix", path.display()),
        });
    }
    Ok(program)
}

/// Whether ops are misread, which hides errors and so counts more, and the numbers of their errors, by
/// their names.
type OpErrors = HashMap<String, (bool, usize)>;

/// The errors in the ops whose drawings can be read. That new elements lack attributes does not
/// count: only the author knows their values.
fn errors_of_ops(program: &Program) -> OpErrors {
    let analysis = &program.analysis;
    let errors = analysis.diagnostics.iter().filter(|told| told.is_error());
    let errors: Vec<_> = errors.filter(|told| told.code != "missing-attribute").collect();
    let count = |span: Span| errors.iter().filter(|told| contains(span, told.span())).count();
    let drawn =
        analysis.program.ops.iter().filter_map(|op| Some((op.diagram.as_ref()?, op.misread)));
    drawn.map(|(op, misread)| (op.name.clone(), (misread, count(op.span)))).collect()
}

/// The ops that have errors, and not fewer than before.
fn no_better(before: &OpErrors, after: &OpErrors) -> Vec<String> {
    let worse = after.iter().filter(|(op, errors)| {
        errors.1 > 0 && before.get(*op).is_some_and(|before| before <= *errors)
    });
    worse.map(|(op, _)| op.clone()).collect()
}

fn contains(outer: Span, inner: Span) -> bool {
    outer.file == inner.file && outer.start <= inner.start && inner.end <= outer.end
}

/// All rounds of fixes, except those of errors that are fixed in vain, or in ops that they would
/// leave no better; the kind of another error that is fixed in vain if there is one.
fn rounds(
    mut program: Program,
    ineffective: &HashSet<Kind>,
    harmful: &HashSet<String>,
) -> Result<(Program, Vec<Applied>), Kind> {
    let mut seen = HashSet::new();
    let mut longer: HashMap<Kind, usize> = HashMap::new();
    let mut all = Vec::new();
    for _ in 0..MOST_ROUNDS {
        let source = program.sources.get(program.analysis.file);
        if !seen.insert(source.text().to_owned()) {
            break;
        }
        let told = program.analysis.diagnostics.iter();
        let told = told.filter(|told| !ineffective.contains(&kind(told)));
        let told = told.map(|told| (told, op_of(&program, told)));
        let told = told.filter(|(_, op)| op.as_ref().is_none_or(|op| !harmful.contains(op)));
        let Some((text, applied)) = round(source, program.analysis.file, told) else { break };
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

/// The op that an error is in, if its drawing can be read.
fn op_of(program: &Program, told: &Diagnostic) -> Option<String> {
    let mut ops = program.analysis.program.ops.iter().filter_map(|op| op.diagram.as_ref());
    ops.find(|op| contains(op.span, told.span())).map(|op| op.name.clone())
}

fn kind(told: &Diagnostic) -> Kind {
    (told.code, told.message.clone())
}

/// The text with the fixes of diagnostics that have exactly one, as far as they do not overlap;
/// `None` if there is none.
fn round<'d>(
    source: &Source,
    file: FileId,
    told: impl Iterator<Item = (&'d Diagnostic, Option<String>)>,
) -> Option<(String, Vec<Applied>)> {
    let mut edits: Vec<&Edit> = Vec::new();
    let mut applied = Vec::new();
    for (diagnostic, op) in told {
        // Between several, the user has to choose.
        let [fix] = diagnostic.fixes.as_slice() else { continue };
        if !fits(fix, (source, file), &edits) {
            continue;
        }
        edits.extend(&fix.edits);
        let place = fix.edits.first().map_or(diagnostic.span(), |edit| edit.span);
        let (line, _) = source.line_column(place.start as usize);
        applied.push(Applied { kind: kind(diagnostic), line, title: fix.title.clone(), op });
    }
    if applied.is_empty() {
        return None;
    }
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let mut text = source.text().to_owned();
    // New lines end as those of the file.
    let ends_in_crlf = text.contains("\r\n");
    for edit in edits.iter().rev() {
        match ends_in_crlf && !edit.text.contains('\r') {
            true => text.replace_range(edit.span.range(), &edit.text.replace('\n', "\r\n")),
            false => text.replace_range(edit.span.range(), &edit.text),
        }
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
