//! Explanations of codes, for `hedgerow explain`: one text, shown, printed and tested.

/// All sections, a code each.
const TEXT: &str = include_str!("explained.md");

/// The explanation of a code: the law, why it matters, a program that breaks it, what mends it.
pub fn explain(code: &str) -> Option<&'static str> {
    sections().find(|(known, _)| *known == code).map(|(_, text)| text)
}

/// All codes that are explained, with the law of each, in the order of the text.
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
