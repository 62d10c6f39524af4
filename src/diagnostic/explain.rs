//! Explanations of diagnostic codes, for `hedgerow explain`: one text that is shown, printed and
//! tested.

/// All sections, one for each code.
const TEXT: &str = include_str!("explained.md");

/// The explanation of a code: the requirement, why it matters, a program that violates it, and the
/// correction.
pub fn explain(code: &str) -> Option<&'static str> {
    sections().find(|(known, _)| *known == code).map(|(_, text)| text)
}

/// All codes with an explanation, each with its first line (the requirement), in the order of the
/// text.
pub fn explained() -> impl Iterator<Item = (&'static str, &'static str)> {
    sections().map(|(code, text)| (code, text.lines().next().unwrap_or("")))
}

fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    let sections = TEXT.split("\n## ").skip(1);
    sections.filter_map(|section| {
        let (code, text) = section.split_once('\n')?;
        Some((code, text.trim()))
    })
}
