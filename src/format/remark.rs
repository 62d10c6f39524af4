//! Alignment of comments at the ends of consecutive lines.

use super::printer::{Lines, width_of};

/// Aligns the comments at the ends of consecutive lines with the same indentation.
pub(super) fn align(lines: &mut Lines) {
    let mut from = 0;
    while from < lines.len() {
        let Some((indent, _)) = parts(&lines[from]) else {
            from += 1;
            continue;
        };
        let follows = lines[from..].iter();
        let same = |line: &&String| parts(line).is_some_and(|(other, _)| other == indent);
        let to = from + follows.take_while(same).count();
        pad(&mut lines[from..to]);
        from = to;
    }
}

fn pad(lines: &mut [String]) {
    let code = |line: &String| parts(line).map_or(0, |(_, at)| at);
    let width = |line: &String| width_of(line[..code(line)].trim_end());
    let widest = lines.iter().map(width).max().unwrap_or(0);
    for line in lines {
        let (before, comment) = line.split_at(code(line));
        let before = before.trim_end();
        let gap = " ".repeat(widest - width_of(before) + 2);
        *line = format!("{before}{gap}{comment}");
    }
}

/// The indentation of a line and the start of its comment, if there is one after something else.
fn parts(line: &str) -> Option<(usize, usize)> {
    let indent = line.len() - line.trim_start().len();
    let mut quoted = false;
    let mut bytes = line.bytes().enumerate().skip(indent);
    let rest = |at: usize| &line.as_bytes()[at..];
    while let Some((at, byte)) = bytes.next() {
        match byte {
            b'"' => quoted = !quoted,
            b'\\' if quoted => {
                bytes.next();
            }
            b'/' if !quoted && rest(at).starts_with(b"//") => {
                return (at > indent).then_some((indent, at));
            }
            _ => {}
        }
    }
    None
}
