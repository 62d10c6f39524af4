//! Foreign signs and literals whose meaning is known: comments, texts in other quotes, numbers
//! without a digit before the point.

use super::place::{DRAWING, Places};
use crate::source::Span;
use crate::syntax::is_name;
use crate::syntax::token::TokenKind as T;

/// The replacement of a foreign sign.
pub(super) struct Sign {
    /// The token that replaces it, if any.
    pub kind: Option<T>,
    /// The message.
    pub says: String,
    /// The text that replaces it, and its span.
    pub fix: Option<(Span, String)>,
}

/// The surroundings of a foreign sign.
pub(super) struct Around<'t> {
    /// The text before it on its line.
    pub before: &'t str,
    /// The text behind it on its line.
    pub behind: &'t str,
    /// True if an item begins behind it.
    pub at_item: bool,
    /// Its place in the program.
    pub place: Places,
}

/// The replacement of a foreign sign that the table does not list.
pub(super) fn sign(written: &str, span: Span, around: Around) -> Sign {
    let first = written.chars().next().unwrap_or('?');
    let whole = |text: String| Some((span, text));
    match first {
        '#' if written.starts_with("#include") => {
            let mut parts = written.splitn(3, ['"', '<', '>']).skip(1);
            let (path, rest) = (parts.next(), parts.next().unwrap_or(""));
            let ours = format!("use \"{}\"", path.unwrap_or("std/triangle.hedge"));
            let replaced = Span { end: span.end - rest.len() as u32, ..span };
            Sign {
                kind: None,
                says: format!("a file is used by its path: `{ours}`"),
                fix: path.map(|_| (replaced, ours)),
            }
        }
        '#' => Sign {
            kind: None,
            says: "a comment begins with `//`".to_owned(),
            fix: may_end(&around).then(|| (Span { end: span.start + 1, ..span }, "//".to_owned())),
        },
        '/' => Sign {
            kind: None,
            says: "a comment begins with `//` and ends with its line".to_owned(),
            fix: Some(comment(written, span, &around)),
        },
        '\'' if is_at_no_name(written, &around) => Sign {
            kind: keyword(written),
            says: format!("`{written}` means nothing here"),
            fix: None,
        },
        '\'' if around.place == DRAWING || !written[1..].ends_with('\'') => {
            let name = written.trim_matches('\'');
            Sign {
                kind: Some(T::Word),
                says: format!("a prime stands behind its name: `{name}'`"),
                fix: whole(format!("{name}'")),
            }
        }
        '\'' | '\u{201C}' => {
            let inside: String = written.chars().skip(1).collect();
            let inside = inside.trim_end_matches(['\'', '\u{201D}']).replace('"', "\\\"");
            Sign {
                kind: Some(T::Text),
                says: "a text stands in double quotes".to_owned(),
                fix: whole(format!("\"{inside}\"")),
            }
        }
        '.' => match misplaced_point(around.before) {
            // What is left is most likely what was meant.
            Some(says) => Sign { kind: None, says: says.to_owned(), fix: None },
            None => Sign {
                kind: Some(T::Real),
                says: "a number has a digit before its point".to_owned(),
                fix: whole(format!("0{written}")),
            },
        },
        '`' if written.len() > 1 => Sign {
            kind: Some(T::Text),
            says: "a text stands in double quotes, a value in it in braces: `\"n={x}\"`".to_owned(),
            fix: template(written.trim_matches('`')).and_then(whole),
        },
        '\u{A0}' | '\u{2007}' | '\u{202F}' | '\u{3000}' => Sign {
            kind: None,
            says: format!("this is not a plain space but U+{:04X}", u32::from(first)),
            fix: whole(" ".to_owned()),
        },
        _ => Sign { kind: None, says: format!("`{written}` means nothing here"), fix: None },
    }
}

/// True if what a prime is attached to in front can be no name.
fn is_at_no_name(written: &str, around: &Around) -> bool {
    let is_drawn = around.place == DRAWING;
    keyword(written).is_some() || is_drawn && !is_name(written.trim_matches('\''))
}

/// The keyword to which a prime is attached in front.
fn keyword(written: &str) -> Option<T> {
    let word = written.strip_prefix('\'')?;
    T::KEYWORDS.iter().find(|(keyword, _)| *keyword == word).map(|&(_, kind)| kind)
}

/// The message on a point with digits behind it that touches what stands before it on its line.
fn misplaced_point(before: &str) -> Option<&'static str> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    match before.chars().next_back()? {
        '.' => Some("a range has two points: `0..n`, from 0 up to, but without, n"),
        c if is_part(c) || matches!(c, ')' | ']' | '\'') => {
            Some("a component is `.x`, `.y` or `.z`; a name has no point in it")
        }
        _ => None,
    }
}

/// The text in double quotes that a template means; `None` if a value in it has quotes.
fn template(inside: &str) -> Option<String> {
    let mut parts = inside.split("${");
    let plain = |text: &str| text.replace('"', "\\\"").replace('{', "\\{").replace('}', "\\}");
    let mut text = plain(parts.next()?);
    for part in parts {
        let (value, rest) = part.split_once('}')?;
        if value.contains(['"', '{']) {
            return None;
        }
        text.push_str(&format!("{{{value}}}{}", plain(rest)));
    }
    Some(format!("\"{text}\""))
}

/// A `/* … */` comment rewritten with `//`; if something follows on its line, it moves to a line
/// of its own before.
fn comment(written: &str, span: Span, around: &Around) -> (Span, String) {
    let Around { before, behind, .. } = around;
    let marks = match written.starts_with("/**") && around.at_item && before.trim().is_empty() {
        true => "///",
        false => "//",
    };
    let indent = &before[..before.len() - before.trim_start().len()];
    let end = format!("\n{indent}");
    let inside = written.trim_start_matches("/*").trim_end_matches("*/");
    let lines = inside.lines().map(|line| line.trim().trim_start_matches(['*', '!']).trim());
    let lines = lines.filter(|line| !line.is_empty()).map(|line| format!("{marks} {line}"));
    let lines = lines.collect::<Vec<_>>().join(&end);
    let rest = behind.trim_start();
    if rest.is_empty() {
        return (span, lines);
    }
    let kept = before.trim();
    let blank = if kept.is_empty() { "" } else { " " };
    let (start, blanks) =
        ((before.len() - indent.len()) as u32, (behind.len() - rest.len()) as u32);
    let moved = Span { start: span.start - start, end: span.end + blanks, ..span };
    (moved, format!("{lines}{end}{kept}{blank}"))
}

/// True if a comment may follow what stands before it on its line: nothing, or what can be the end
/// of a statement. Elsewhere it would hide what is missing.
fn may_end(around: &Around) -> bool {
    let before = around.before.trim_end();
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'');
    let word = before.rsplit(|c| !is_part(c)).next().unwrap_or("");
    let is_open = T::KEYWORDS.iter().any(|&(keyword, kind)| {
        keyword == word && !matches!(kind, T::True | T::False | T::Break | T::Continue)
    });
    let edge = before.rsplit_once("edge ").filter(|_| around.place == DRAWING);
    let is_half = edge.is_some_and(|(_, last)| !last.contains('|'));
    let ends = before.is_empty()
        || before.ends_with(is_part)
        || before.ends_with(['}', '{', ')', ']', '"', '*', ';']);
    ends && !is_open && !is_half
}
