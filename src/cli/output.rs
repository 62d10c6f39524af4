//! Standard output and standard error. A closed pipe is not a failure; a full disk is one, which is
//! reported when the command ends.

use std::io::{self, IsTerminal, Write, stderr, stdout};
use std::path::Path;
use std::process::exit;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use console::{Term, strip_ansi_codes};
use pretty::{DocAllocator, DocBuilder, RcAllocator};
use serde::Serialize;

use super::failure::Failure;
use super::interrupt;
use crate::diagnostic::{Diagnostic, Rendering, render, shown};
use crate::source::Sources;

/// The number of diagnostics that are printed at most.
const MOST_DIAGNOSTICS: usize = 50;

/// The first error in writing to standard output.
static LOST: Mutex<Option<io::Error>> = Mutex::new(None);

static ENDS_WHEN_CLOSED: AtomicBool = AtomicBool::new(false);

/// Prints a text to standard output, with a line end, and with control characters replaced.
pub(super) fn print_line(text: &str) {
    print_line_exactly(&shown(text));
}

/// As [`print_line`], for data: nothing is replaced.
pub(super) fn print_line_exactly(text: &str) {
    let Err(error) = writeln!(stdout().lock(), "{text}") else { return };
    if error.kind() != io::ErrorKind::BrokenPipe {
        if let Ok(mut lost) = LOST.lock() {
            lost.get_or_insert(error);
        }
    } else if ENDS_WHEN_CLOSED.load(Relaxed) {
        exit(0);
    }
}

/// From now on the process ends when it prints to a closed pipe: nothing else comes out of it.
pub(super) fn end_when_closed() {
    ENDS_WHEN_CLOSED.store(true, Relaxed);
}

/// True if a path is standard output: `-o -`, or a name of the system for it.
pub(super) fn is_standard(path: &Path) -> bool {
    let names = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
    names.into_iter().any(|name| path == Path::new(name))
}

/// Prints data as JSON to standard error, if standard output takes the result itself.
pub(super) fn eprint_json(data: &impl Serialize) -> Result<(), Failure> {
    eprint_line(&serde_json::to_string_pretty(data).map_err(Failure::usage)?);
    Ok(())
}

/// Writes a result to standard output, as it is; Ctrl-C ends the process then, since a pipe may
/// block until it is read.
pub(super) fn write_stdout(bytes: &[u8]) -> Result<(), Failure> {
    interrupt::end_at_once();
    let mut out = stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::usage(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Fails if some output could not be written.
pub(super) fn check_stdout() -> Result<(), Failure> {
    let lost = LOST.lock().ok().and_then(|mut lost| lost.take());
    lost.map_or(Ok(()), |error| {
        Err(Failure::usage(format!("cannot write to standard output: {error}")))
    })
}

/// Prints data as JSON to standard output.
pub(super) fn print_json(data: &impl Serialize) -> Result<(), Failure> {
    print_line_exactly(&serde_json::to_string_pretty(data).map_err(Failure::usage)?);
    Ok(())
}

/// Prints a text to standard error, with a line end, and with control characters replaced.
pub(super) fn eprint_line(text: &str) {
    let _ = writeln!(stderr().lock(), "{}", shown(text));
}

/// Prints a text of one line behind some words to standard error, in lines that fit into the
/// terminal; a longer one as it is.
pub(super) fn eprint_wrapped(words: &str, text: &str) {
    let columns = columns_of(&Term::stderr()).filter(|_| !text.contains('\n'));
    eprint_line(&format!("{words}{}", fitted(text, words.len(), columns)));
}

/// Prints diagnostics to standard error, with notes that fit into the terminal.
pub(super) fn eprint_diagnostics(diagnostics: &[Diagnostic], sources: &Sources) {
    let is_set = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty());
    let is_plain =
        is_set("NO_COLOR").is_some() || is_set("TERM").is_some_and(|term| term == "dumb");
    let colour = stderr().is_terminal() && !is_plain;
    let text = render(diagnostics, sources, Rendering { colour, most: MOST_DIAGNOSTICS });
    let mut out = stderr().lock();
    let Some(columns) = columns_of(&Term::stderr()) else {
        let _ = write!(out, "{text}");
        return;
    };
    for line in text.lines() {
        let is_note = NOTES.iter().any(|head| strip_ansi_codes(line).starts_with(head));
        let _ = match line.split_once(": ").filter(|_| is_note) {
            Some((head, rest)) => {
                writeln!(out, "{head}: {}", fitted(rest, NOTES[0].len(), Some(columns)))
            }
            None => writeln!(out, "{line}"),
        };
    }
}

/// What begins the lines that a diagnostic adds below the text, of one length.
const NOTES: [&str; 2] = ["  note: ", "  help: "];

/// The number of columns of standard output, if it is a terminal.
pub(super) fn columns() -> Option<usize> {
    columns_of(&Term::stdout())
}

fn columns_of(term: &Term) -> Option<usize> {
    term.size_checked().map(|(_, columns)| usize::from(columns))
}

/// A text behind `before` columns, in lines that fit into the terminal, if it is printed to one that
/// is not narrow.
pub(super) fn wrapped(text: &str, before: usize) -> String {
    fitted(text, before, columns())
}

/// A text behind `before` columns, in lines that fit into some columns, if they are not few.
fn fitted(text: &str, before: usize, columns: Option<usize>) -> String {
    match columns.and_then(|columns| columns.checked_sub(before)) {
        Some(room @ 20..) => {
            let lines: DocBuilder<_, ()> = RcAllocator.reflow(text);
            lines.pretty(room).to_string().replace('\n', &format!("\n{}", " ".repeat(before)))
        }
        _ => text.to_owned(),
    }
}

/// The line around code.
const FENCE: &str = "```";

/// A text in which paragraphs and items of lists that are too wide for the terminal are wrapped, if
/// it is printed to one; code and tables stay as they are.
pub(super) fn prose(text: &str) -> String {
    let Some(columns) = columns() else { return text.to_owned() };
    let is_prose = |words: &str| {
        !words.is_empty() && !words.starts_with(['|', '#']) && !words.starts_with(FENCE)
    };
    let is_item = |words: &str| words.starts_with("- ") || words.starts_with("* ");
    let (mut is_code, mut out) = (false, Vec::new());
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        let words = line.trim_start();
        let indent = line.len() - words.len();
        is_code ^= words.starts_with(FENCE);
        if is_code || !is_prose(words) {
            out.push(line.to_owned());
            continue;
        }
        // The lines of a paragraph are indented alike, those of an item more than its first.
        let inside = indent + if is_item(words) { 2 } else { 0 };
        let mut all = vec![line];
        while let Some(next) = lines.next_if(|next| {
            let words = next.trim_start();
            is_prose(words) && !is_item(words) && next.len() - words.len() == inside
        }) {
            all.push(next);
        }
        let fits = |line: &&str| line.chars().count() <= columns;
        if all.iter().all(fits) {
            out.extend(all.into_iter().map(str::to_owned));
            continue;
        }
        let paragraph = all.iter().map(|line| line.trim()).collect::<Vec<_>>().join(" ");
        out.push(" ".repeat(indent) + &wrapped(&paragraph, inside));
    }
    out.join("\n")
}

/// Columns of text, each as wide as its widest cell; those marked in `right` are aligned right. Long
/// texts in the last one are wrapped.
pub(super) fn table(rows: &[Vec<String>], right: &[bool]) -> String {
    table_rows(rows, right).join("\n")
}

/// The rows of a [`table`], each of which may have several lines.
pub(super) fn table_rows(rows: &[Vec<String>], right: &[bool]) -> Vec<String> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter()
            .filter_map(|row| row.get(column))
            .map(|cell| cell.chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<_> = (0..columns).map(width).collect();
    let line = |row: &Vec<String>| {
        let cell = |(column, cell): (usize, &String)| {
            let is_right = right.get(column) == Some(&true);
            if column > 0 && column + 1 == columns && !is_right {
                let before = widths[..column].iter().map(|width| width + 2).sum();
                // Beside a wide column there may be too little room: below it there is more.
                let is_below =
                    |columns| before > columns / 2 && before + cell.chars().count() > columns;
                return match self::columns().is_some_and(is_below) {
                    true => format!("\n    {}", wrapped(cell, 4)),
                    false => wrapped(cell, before),
                };
            }
            let gap = " ".repeat(widths[column] - cell.chars().count());
            if is_right { format!("{gap}{cell}") } else { format!("{cell}{gap}") }
        };
        let cells = row.iter().enumerate().map(cell).collect::<Vec<_>>().join("  ");
        cells.lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
    };
    rows.iter().map(line).collect()
}
