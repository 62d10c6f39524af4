//! An HTML page for a whole file: each operation with its picture, its doc comment, what was proved
//! about it, and its plan.

use std::fmt::Write;

use super::shape::Picture;
use super::svg::escaped;

/// An operation on a page.
#[derive(Clone, Debug, Default)]
pub struct Section {
    pub name: String,
    pub docs: Vec<String>,
    /// Its picture, if its diagrams can be read.
    pub picture: Option<Picture>,
    /// The paragraphs of the verdict.
    pub verdict: Vec<String>,
    /// The table of its plan, if it is proved.
    pub plan: Option<String>,
}

const STYLE: &str = "\
:root { color-scheme: light dark; --ink: #22262c; --paper: #fff; --soft: #f4f6f9; --muted: #66707c }
@media (prefers-color-scheme: dark) { :root { --ink: #d9dee5; --paper: #15181d; --soft: #20252d; --muted: #8d97a3 } }
body { margin: 2rem auto; max-width: 62rem; padding: 0 1rem; background: var(--paper); color: var(--ink); font: 17px/1.5 Georgia, 'Times New Roman', serif }
section { margin: 3rem 0; border-top: 1px solid var(--soft) }
h1, h2, code, pre { font-family: ui-monospace, Consolas, monospace }
h1 { font-size: 1.3rem; overflow-wrap: anywhere } h2 { font-size: 1.1rem }
svg { display: block; max-width: 100%; height: auto; margin: 1rem auto }
pre { background: var(--soft); padding: .8rem 1rem; overflow-x: auto; font-size: 13px; line-height: 1.4; border-radius: 6px }
.verdict { color: var(--muted); margin: .3rem 0 }
summary { cursor: pointer; color: var(--muted) }
";

/// Writes the page of a file.
pub fn page(title: &str, sections: &[Section]) -> String {
    let title = escaped(title);
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    );
    for section in sections {
        let name = escaped(&section.name);
        let _ = writeln!(text, "<section id=\"{name}\">\n<h2>{name}</h2>");
        write_docs(&mut text, &section.docs);
        if let Some(picture) = &section.picture {
            text.push_str(&picture.svg());
        }
        for line in &section.verdict {
            let _ = writeln!(text, "<p class=\"verdict\">{}</p>", code(line));
        }
        if let Some(plan) = &section.plan {
            let plan = escaped(plan);
            let _ =
                writeln!(text, "<details><summary>plan</summary>\n<pre>{plan}</pre>\n</details>");
        }
        text.push_str("</section>\n");
    }
    text.push_str("</body>\n</html>\n");
    text
}

/// Writes a doc comment: paragraphs, and fenced blocks verbatim.
fn write_docs(text: &mut String, docs: &[String]) {
    let mut paragraph = String::new();
    let mut fenced = false;
    let end = |text: &mut String, paragraph: &mut String| {
        if !paragraph.is_empty() {
            let _ = writeln!(text, "<p>{}</p>", code(paragraph.trim_end()));
            paragraph.clear();
        }
    };
    for line in docs {
        let line = line.strip_prefix(' ').unwrap_or(line);
        if line.trim_start().starts_with("```") {
            end(text, &mut paragraph);
            text.push_str(if fenced { "</pre>\n" } else { "<pre>" });
            fenced = !fenced;
        } else if fenced {
            let _ = writeln!(text, "{}", escaped(line));
        } else if line.trim().is_empty() {
            end(text, &mut paragraph);
        } else {
            paragraph.push_str(line);
            paragraph.push('\n');
        }
    }
    end(text, &mut paragraph);
    if fenced {
        text.push_str("</pre>\n");
    }
}

/// A line with its names in backticks set as code.
fn code(line: &str) -> String {
    let mut text = String::new();
    for (at, part) in line.split('`').enumerate() {
        let part = escaped(part);
        if at.is_multiple_of(2) {
            text.push_str(&part);
        } else {
            let _ = write!(text, "<code>{part}</code>");
        }
    }
    text
}
