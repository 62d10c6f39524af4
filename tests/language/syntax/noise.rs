//! Noise: texts that someone is in the middle of typing, and texts nobody ever typed.

use hedgerow::diagnostic::{Rendering, render};
use hedgerow::source::{FileId, Sources};
use hedgerow::syntax::tree::{Item, Op};
use hedgerow::syntax::{Parsed, TokenKind, parse};
use support::dice::Dice;

const PAGES: [&str; 2] = [include_str!("drawings.md"), include_str!("scripts.md")];

/// The inputs of the pages that are to be read without a mistake.
fn inputs() -> Vec<&'static str> {
    let fences = PAGES.iter().flat_map(|page| page.split("```hedge\n").skip(1));
    fences.map(|rest| rest.split("```").next().unwrap()).collect()
}

const UNTOUCHED: &str = "
/// Stands for itself.
op untouched(e: edge) {
  before { edge e: a | b }
  after { edge e: b | a }
}
";

fn parsed(text: &str) -> Parsed {
    let mut sources = Sources::new();
    let file = sources.add("noise.hedge", text);
    let parsed = parse(file, text);
    let how = Rendering { colour: true, most: 5 };
    render(&parsed.diagnostics, &sources, how);
    parsed
}

fn untouched(parsed: &Parsed) -> Option<&Op> {
    parsed.tree.items.iter().find_map(|item| match item {
        Item::Op(op) if op.name.text == "untouched" => Some(op),
        _ => None,
    })
}

/// One change to a text: a token gone, a token twice, a byte made noise, the end cut off.
fn mutate(text: &str, dice: &mut Dice) -> String {
    let tokens = parse(FileId(0), text).tokens;
    let token = tokens.get(dice.below(tokens.len())).map(|token| token.span.range());
    let at = text.floor_char_boundary(dice.below(text.len()));
    match (dice.below(5), token) {
        (0, Some(token)) => format!("{}{}", &text[..token.start], &text[token.end..]),
        (1, Some(token)) => {
            let other = dice.below(TokenKind::MARKS.len() + TokenKind::KEYWORDS.len());
            let mut all = TokenKind::MARKS.iter().chain(TokenKind::KEYWORDS);
            let (word, _) = all.nth(other).unwrap();
            format!("{} {word} {}", &text[..token.start], &text[token.end..])
        }
        (2, _) => text[..at].to_owned(),
        (3, _) => {
            let noise = ["{", "}", "(", ")", "\"", "§", "\0", "\r", "9e999", "//", "'", "\\"];
            format!("{}{}{}", &text[..at], noise[dice.below(noise.len())], &text[at..])
        }
        (_, Some(token)) => {
            let twice = &text[token.clone()];
            format!("{} {twice} {}", &text[..token.end], &text[token.end..])
        }
        (_, None) => text.to_owned(),
    }
}

#[test]
fn what_is_written_well_is_read_without_a_word() {
    for input in inputs() {
        assert_eq!(parsed(input).diagnostics, [], "{input}");
    }
}

#[test]
fn a_broken_item_never_hides_the_next() {
    let inputs = inputs();
    assert!(inputs.len() >= 10, "only {} inputs", inputs.len());
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let mut broken = 0;
    for round in 0..3000 {
        let mut text = inputs[round % inputs.len()].to_owned();
        for _ in 0..=dice.below(3) {
            text = mutate(&text, &mut dice);
        }
        text.push_str(UNTOUCHED);
        let parsed = parsed(&text);
        broken += usize::from(!parsed.diagnostics.is_empty());
        let op = untouched(&parsed).unwrap_or_else(|| panic!("the op after this is gone:\n{text}"));
        assert_eq!(op.docs.last().unwrap(), "Stands for itself.", "{text}");
        let rule = &op.rules[0];
        let sides = [&rule.before, &rule.after].map(|side| side.as_ref().unwrap());
        assert!(sides.iter().all(|side| side.statements.len() == 1), "{text}");
    }
    assert!(broken > 1000, "only {broken} texts were broken");
}

#[test]
fn garbage_is_read_without_harm() {
    let mut dice = Dice(7);
    let words: Vec<&str> = TokenKind::MARKS
        .iter()
        .chain(TokenKind::KEYWORDS)
        .map(|&(word, _)| word)
        .chain(["a", "b'", "1", "2.5", "\"t\"", "\n", "§", "\"", "//", "é", "𝄞"])
        .collect();
    for _ in 0..400 {
        let length = dice.below(300);
        let text: Vec<&str> = (0..length).map(|_| words[dice.below(words.len())]).collect();
        parsed(&text.join(" "));
        parsed(&format!("script s() {{ {}", text.join(" ")));
        parsed(&format!("op o(e: edge) {{ before {{ {}", text.join(" ")));
        let bytes: Vec<u8> = (0..length).map(|_| dice.below(256) as u8).collect();
        parsed(&String::from_utf8_lossy(&bytes));
    }
}

#[test]
fn depth_is_bounded_however_it_is_made() {
    let deep = |start: &str, step: &str, end: &str| {
        let text = format!("{start}{}{end}{UNTOUCHED}", step.repeat(20_000));
        let parsed = parsed(&text);
        let codes: Vec<_> = parsed.diagnostics.iter().map(|found| found.code).collect();
        assert_eq!(codes, ["nesting-too-deep"], "{start}{step}…{end}");
        assert!(untouched(&parsed).is_some(), "{start}{step}…{end}");
    };
    for step in ["(", "- ", "not ", "f(", "must ", "1 + ", "if a {", "if a { 1 } else "] {
        deep("script s() { let x = ", step, "");
    }
    deep("script s() { if a { }", " else if a { }", " }");
    deep("script s() { x", ".next", " }");
    deep("op o(e: edge) { before ", "{ ", "");
    deep("", "{ ", "");
}

#[test]
fn as_deep_as_allowed_is_read() {
    for (open, close) in [("(", ")"), ("f(", ")"), ("if a { ", " } else { 2 }")] {
        let (open, close) = (open.repeat(100), close.repeat(100));
        let text = format!("script s() {{ let x = {open}1{close} }}");
        assert_eq!(parsed(&text).diagnostics, []);
    }
    let sum = format!("script s() {{ let x = 1{} }}", " + 1".repeat(200));
    assert_eq!(parsed(&sum).diagnostics, []);
    let many = format!("script s() {{ {} }}", "x = a + b - c f(x).y ".repeat(5000));
    assert_eq!(parsed(&many).diagnostics, []);
    let polygon = format!("op o(f: face) {{ before {{ face f: v {} }} }}", "-h-> v ".repeat(5000));
    assert_eq!(parsed(&polygon).diagnostics, []);
}
