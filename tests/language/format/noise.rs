//! Programs written badly, and programs someone is in the middle of typing: formatting keeps
//! every word and is done after once. ([`formatted`] answers with nothing else.)

use super::{all_edits, edited, formatted, line_edits, programs};
use hedgerow::source::FileId;
use hedgerow::syntax::parse;
use support::dice::Dice;

fn one<'t>(dice: &mut Dice, of: &[&'t str]) -> &'t str {
    of[dice.below(of.len())]
}

const SPACES: &[&str] = &[
    " ",
    " ",
    " ",
    " ",
    "  ",
    "\n",
    "\n",
    "\n\n",
    "\n\n\n\n",
    "\t",
    " \r\n",
    " // c\n",
    "\n// d\n",
    "\n\n/// e\n",
    "\n//f",
];

/// The same tokens with other white space and other comments between them. What stands side
/// by side stays so: a space would part `*` and `S` in a fan.
fn respaced(text: &str, dice: &mut Dice, every: usize) -> String {
    let parsed = parse(FileId(0), text);
    let mut out = String::new();
    let mut end = None;
    for token in &parsed.tokens {
        let range = token.span.range();
        match end {
            Some(end) if end == range.start => {}
            Some(_) if dice.below(every) > 0 => out.push(' '),
            _ => {
                out.push_str(one(dice, SPACES));
                if out.ends_with('f') {
                    out.push('\n');
                }
            }
        }
        out.push_str(&text[range.clone()]);
        end = Some(range.end);
    }
    out
}

/// The text with a token gone, doubled or exchanged for another.
fn mutated(text: &str, dice: &mut Dice) -> String {
    let tokens = parse(FileId(0), text).tokens;
    if tokens.is_empty() {
        return text.to_owned();
    }
    let at = tokens[dice.below(tokens.len())].span.range();
    let other = tokens[dice.below(tokens.len())].span.range();
    let (before, behind) = (&text[..at.start], &text[at.end..]);
    match dice.below(5) {
        0 => format!("{before}{behind}"),
        1 => format!("{before}{} {}{behind}", &text[at.clone()], &text[at.clone()]),
        2 => format!("{before}{}{behind}", &text[other]),
        3 => before.to_owned(),
        _ => format!("{before}{}{behind}", one(dice, &["§", "\"", "}", "{", "\u{a0}", " \u{b} "])),
    }
}

#[test]
fn badly_written_programs_keep_their_words() {
    let mut dice = Dice(0x2545_F491_4F6C_DD1D);
    let mut changed = 0;
    for program in programs::of_pages() {
        for every in [1, 3, 20] {
            let text = respaced(&program, &mut dice, every);
            let again = formatted(&text);
            assert_eq!(edited(&text, &all_edits(&text)), again);
            changed += usize::from(again != text);
        }
    }
    assert!(changed > 200, "only {changed} programs were changed");
}

#[test]
fn broken_programs_keep_their_words() {
    let mut dice = Dice(88_172_645_463_325_252);
    let programs = programs::of_pages();
    let mut broken = 0;
    for round in 0..2000 {
        let mut text = programs[round % programs.len()].clone();
        text.push_str(&programs[dice.below(programs.len())]);
        for _ in 0..=dice.below(3) {
            text = mutated(&text, &mut dice);
        }
        if dice.below(2) == 0 {
            text = respaced(&text, &mut dice, 5);
        }
        formatted(&text);
        broken += usize::from(!parse(FileId(0), &text).diagnostics.is_empty());
    }
    assert!(broken > 1000, "only {broken} texts were broken");
}

#[test]
fn some_lines_keep_the_words_of_all() {
    let mut dice = Dice(42);
    let mut changed = 0;
    for program in programs::of_pages() {
        let text = respaced(&program, &mut dice, 4);
        let lines = text.lines().count();
        let from = dice.below(lines);
        let some = line_edits(&text, from..from + 3);
        let all = all_edits(&text);
        // Of the last edit the indentation of the line behind the lines is left out.
        if let Some((last, before)) = some.split_last() {
            assert!(before.iter().all(|edit| all.contains(edit)));
            let mut whole = all.iter().filter(|whole| whole.range.start == last.range.start);
            assert!(whole.any(|whole| {
                let rest = whole.text.strip_prefix(&*last.text);
                let is_cut = |rest: &str| rest.starts_with('\n') && rest.trim().is_empty();
                whole == last || rest.is_some_and(is_cut)
            }));
        }
        let words = |text: &str| text.split_whitespace().collect::<String>();
        assert_eq!(words(&edited(&text, &some)), words(&text));
        changed += usize::from(some.len() < all.len() && !some.is_empty());
    }
    assert!(changed > 50, "only {changed} texts changed in part");
}

#[test]
fn a_long_file_takes_no_longer_than_it_is_long() {
    let program = "op o(e: edge) { before { edge e: a|b } after { edge e: b|a } }\n";
    let text = program.repeat(4000);
    assert_eq!(formatted(&text).lines().count(), 4000 * 5 - 1);
    formatted(&format!("{}{}", "§ ".repeat(20_000), text));
    let deep = format!("script s() {{ {} {} }}", "if a { ".repeat(200), "}".repeat(200));
    formatted(&deep);
    let chain = format!("script s() {{ let x = {}1{} }}", "(1 + ".repeat(90), ")".repeat(90));
    formatted(&chain);
}

/// Lists that are longer than a stack is deep.
#[test]
fn long_lists_are_laid_out() {
    let listed = |one: &dyn Fn(usize) -> String, between: &str| {
        (0..40_000).map(one).collect::<Vec<_>>().join(between)
    };
    let name = |at: usize| format!("a{at}");
    let names = listed(&name, ", ");
    let texts = [
        format!("fn f({}) -> int {{ 1 }}", listed(&|at| format!("a{at}: int"), ", ")),
        format!("script main() {{ f({names}) }}"),
        format!("script main() {{ print {names} }}"),
        format!("op o(e: edge) keeps {names} {{ before {{ }} after {{ }} }}"),
        format!("script main() {{ {} }}", listed(&|at| format!("print {at}"), "\n")),
        format!("script main() {{ print 1 {}\n }}", listed(&|at| format!("// {at}\n"), "")),
        format!("op o(e: edge) {{ alias {} before {{ }} after {{ }} }}", listed(&name, " ")),
        format!("op o(e: edge) {{ before {{ vertex v: {} }} after {{ }} }}", listed(&name, " ")),
    ];
    for text in texts {
        // Some of these are no programs, but all are answered.
        let _ = hedgerow::format::format(hedgerow::source::FileId(0), &text);
    }
}
