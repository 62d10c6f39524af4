//! Unrolling of families in the text of an op.
//!
//! The input is the output of [`op_text`](super::printing::op_text), one statement per line. It
//! only assumes that a subscript is the index plus a constant: `h[i+1]` becomes `h_2` where the
//! index is 1, on cycles that are long enough.

use regex::{Captures, Regex};

/// The text of an op for cycles of one size.
pub fn unrolled(text: &str, size: i64) -> String {
    let member = Regex::new(r"\[[a-z]([+-]\d+)?\]").expect("a pattern");
    let each = Regex::new(r"each [a-z] \{(.*)\}").expect("a pattern");
    let at = |text: &str, index: i64| {
        let around = |found: &Captures| {
            let shift =
                found.get(1).map_or(0, |shift| shift.as_str().parse::<i64>().expect("a number"));
            format!("_{}", (index + shift).rem_euclid(size))
        };
        member.replace_all(text, around).into_owned()
    };
    let everywhere = |text: &str| -> String { (0..size).map(|index| at(text, index)).collect() };
    let mut written = String::new();
    for line in text.lines() {
        let words = line.trim_start();
        let line = format!("{line}\n");
        if let Some(period) = each.captures(&line) {
            let whole = everywhere(&period[1]);
            // A loop ends at the vertex where it began.
            let end = match words.starts_with("vertex") {
                true => "",
                false => whole.split_whitespace().next().unwrap_or_default(),
            };
            let start = line.split("each").next().unwrap_or_default();
            written.push_str(&format!("{start}{whole}{end}\n"));
        } else if words.starts_with("new ") || words.starts_with("erase ") {
            let names = line.split_inclusive(' ').map(|name| match member.is_match(name) {
                true => everywhere(&format!("{} ", name.trim_end())),
                false => name.trim_end().to_owned() + " ",
            });
            written.extend(names);
            written.push('\n');
        } else if member.is_match(&line) {
            written.push_str(&everywhere(&line));
        } else {
            written.push_str(&line.replace("[0]", "_0"));
        }
    }
    written
}
