//! Signs and texts that are no words of the language, of which it is known what they mean
//! elsewhere: comments, texts in other quotes, numbers without a digit before the point.

use crate::source::Span;
use crate::syntax::token::TokenKind as T;

/// The replacement of a foreign sign.
pub(super) struct Sign {
    /// The token in its place, if any.
    pub kind: Option<T>,
    /// The message.
    pub says: String,
    /// The text in its place.
    pub fix: Option<(Span, String)>,
}

/// The replacement of a foreign sign of which the table knows nothing. `alone` says whether nothing
/// follows on its line.
pub(super) fn sign(written: &str, span: Span, alone: bool) -> Sign {
    let first = written.chars().next().unwrap_or('?');
    let whole = |text: String| Some((span, text));
    match first {
        '#' if written.starts_with("#include") => {
            let path = written.split(['"', '<', '>']).nth(1).unwrap_or("std/triangle.hedge");
            let ours = format!("use \"{path}\"");
            Sign {
                kind: None,
                says: format!("a file is used by its path: `{ours}`"),
                fix: whole(ours),
            }
        }
        '#' => Sign {
            kind: None,
            says: "a comment begins with `//`".to_owned(),
            fix: Some((Span { end: span.start + 1, ..span }, "//".to_owned())),
        },
        '/' => Sign {
            kind: None,
            says: "a comment begins with `//` and ends with its line".to_owned(),
            fix: if alone { whole(lines(written)) } else { whole(String::new()) },
        },
        '\'' | '\u{201C}' => {
            let inside: String = written.chars().skip(1).collect();
            let inside = inside.trim_end_matches(['\'', '\u{201D}']).replace('"', "\\\"");
            Sign {
                kind: Some(T::Text),
                says: "a text stands in double quotes".to_owned(),
                fix: whole(format!("\"{inside}\"")),
            }
        }
        '.' => Sign {
            kind: Some(T::Real),
            says: "a number has a digit before its point".to_owned(),
            fix: whole(format!("0{written}")),
        },
        _ => Sign { kind: None, says: format!("`{written}` means nothing here"), fix: None },
    }
}

/// A comment of several lines, as one of ours.
fn lines(written: &str) -> String {
    let inside = written.trim_start_matches("/*").trim_end_matches("*/");
    let lines = inside.lines().map(|line| line.trim().trim_start_matches(['*', '!']).trim());
    let lines = lines.filter(|line| !line.is_empty()).map(|line| format!("// {line}"));
    lines.collect::<Vec<_>>().join("\n")
}
