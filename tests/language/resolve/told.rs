//! Diagnostics as plain text, to compare.

use hedgerow::diagnostic::{Diagnostic, Severity};
use hedgerow::resolve::{Resolved, resolve};
use hedgerow::source::Sources;
use hedgerow::syntax::parse;

/// Resolves a text that parses.
pub fn resolved(text: &str) -> (Resolved, Sources) {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let parsed = parse(file, text);
    assert_eq!(parsed.diagnostics, [], "the text parses:\n{text}");
    (resolve(&parsed.tree), sources)
}

/// What is said about a text, one diagnostic after the other:
///
/// ```text
/// code: message
///   at LINE:COLUMN `text of the primary place`: what is said there
///   and LINE:COLUMN `text of a further place`: what is said there
///   note: …
///   fix: title: LINE:COLUMN `old` -> `new`
/// ```
pub fn told(text: &str) -> String {
    let (resolved, sources) = resolved(text);
    let mut told = String::new();
    for diagnostic in &resolved.diagnostics {
        tell(diagnostic, &sources, &mut told);
    }
    told
}

fn tell(diagnostic: &Diagnostic, sources: &Sources, told: &mut String) {
    let warning = match diagnostic.severity {
        Severity::Warning => "warning ",
        Severity::Error => "",
    };
    let place = |span: hedgerow::source::Span| {
        let (line, column) = sources.get(span.file).line_column(span.start as usize);
        let text: Vec<&str> = sources.slice(span).split_whitespace().collect();
        format!("{line}:{column} `{}`", text.join(" "))
    };
    *told += &format!("{warning}{}: {}\n", diagnostic.code, diagnostic.message);
    for (number, label) in diagnostic.labels.iter().enumerate() {
        let word = if number == 0 { "at" } else { "and" };
        let text = match label.text.as_str() {
            "" => String::new(),
            text => format!(": {text}"),
        };
        *told += &format!("  {word} {}{text}\n", place(label.span));
    }
    for note in &diagnostic.notes {
        *told += &format!("  note: {note}\n");
    }
    for fix in &diagnostic.fixes {
        *told += &format!("  fix: {}", fix.title);
        for edit in &fix.edits {
            *told += &format!(": {} -> `{}`", place(edit.span), edit.text);
        }
        *told += "\n";
    }
}
