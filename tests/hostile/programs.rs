//! Shipped programs, mutated and taken through check, fmt, emit and run: nothing panics, what is
//! formatted keeps its words, and what runs leaves a valid mesh. For longer, from another seed:
//!
//!     HEDGEROW_FUZZ=100000 HEDGEROW_SEED=7 cargo test --release --test hostile programs

use std::fs;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use hedgerow::analysis::{Analysis, Nowhere, verdicts};
use hedgerow::diagnostic::{Rendering, render};
use hedgerow::emit::{Selection, Style, cpp, rust};
use hedgerow::format::format;
use hedgerow::library;
use hedgerow::mesh::{shape, validate};
use hedgerow::rewrite::{Engine, Watch};
use hedgerow::run::{self, Conditions, prepare, test};
use hedgerow::source::{FileId, Sources};
use hedgerow::syntax::{TokenKind, parse};

use support::dice::Dice;

/// How many programs are tried when nobody says otherwise.
const ROUNDS: usize = 200;
/// The longest time that a script may run.
const LONGEST_RUN: Duration = Duration::from_millis(100);
/// What tests run under.
const CONDITIONS: Conditions = Conditions { seed: 0, memory: 1 << 30, engine: Engine::Native };

fn setting(name: &str, otherwise: usize) -> usize {
    std::env::var(name).map_or(otherwise, |value| value.parse().expect("a number"))
}

/// The items of each program that is shipped; with the first stands what the file uses.
fn shipped() -> Vec<Vec<String>> {
    let mut texts: Vec<String> = library::files().map(|file| file.text.to_owned()).collect();
    let mut paths: Vec<_> =
        fs::read_dir("examples").unwrap().map(|at| at.unwrap().path()).collect();
    paths.sort();
    paths.retain(|path| path.extension().is_some_and(|end| end == "hedge"));
    texts.extend(paths.iter().map(|path| fs::read_to_string(path).unwrap()));
    let items = texts.iter().map(|text| {
        let items = parse(FileId(0), text).tree.items;
        items.iter().map(|item| text[item.span().range()].to_owned()).collect()
    });
    items.collect()
}

/// The name of an item; none of a test or a `use`.
fn name(item: &str) -> Option<&str> {
    let is_word = |letter: char| letter.is_alphanumeric() || letter == '_';
    let item = item.strip_prefix("private ").unwrap_or(item);
    let (word, rest) = item.split_once(' ')?;
    let is_named = ["op", "fn", "script", "attr"].contains(&word);
    is_named.then(|| rest.split(|letter| !is_word(letter)).next()).flatten()
}

/// One item of a program, and all of it that its words may mean.
fn assembled(shipped: &[Vec<String>], dice: &mut Dice) -> String {
    let items = &shipped[dice.below(shipped.len())];
    let mut wanted: Vec<&String> = items.iter().filter(|item| item.starts_with("use ")).collect();
    let first = wanted.len();
    wanted.push(&items[dice.below(items.len())]);
    let mut at = first;
    while let Some(&item) = wanted.get(at) {
        let words: Vec<&str> =
            item.split(|letter: char| !letter.is_alphanumeric() && letter != '_').collect();
        for other in items {
            let is_meant = name(other).is_some_and(|name| words.contains(&name));
            if is_meant && !wanted.contains(&other) {
                wanted.push(other);
            }
        }
        at += 1;
    }
    wanted.into_iter().map(|item| format!("{item}\n")).collect()
}

/// A text with one thing changed: a token, a letter, or a part that is gone or doubled.
fn mutated(text: &str, dice: &mut Dice) -> String {
    let tokens = parse(FileId(0), text).tokens;
    if tokens.is_empty() {
        return text.to_owned();
    }
    let mut range = || tokens[dice.below(tokens.len())].span.range();
    let (at, other) = (range(), range());
    let (before, same, behind) = (&text[..at.start], &text[at.clone()], &text[at.end..]);
    let part = &text[at.start.min(other.start)..at.end.max(other.end)];
    match dice.below(8) {
        0 => format!("{before}{behind}"),
        1 => format!("{before}{same} {same}{behind}"),
        2 | 3 => format!("{before}{}{behind}", &text[other]),
        4 => {
            let words = TokenKind::KEYWORDS.len() + TokenKind::MARKS.len();
            let mut all = TokenKind::KEYWORDS.iter().chain(TokenKind::MARKS);
            let (word, _) = all.nth(dice.below(words)).unwrap();
            format!("{before}{word}{behind}")
        }
        5 if part.len() < 400 => text.replacen(part, &format!("{part}\n{part}"), 1),
        6 if part.len() < 400 => text.replacen(part, "", 1),
        _ => {
            let odd = [
                "0",
                "-1",
                "99999999999",
                "1e308",
                "𝄞",
                "\u{0}",
                "\"",
                "{",
                "}",
                "'",
                "[i+1]",
                "é",
            ];
            format!("{before}{}{behind}", odd[dice.below(odd.len())])
        }
    }
}

/// Somebody who has no time.
struct Hasty(Instant);

impl Hasty {
    fn new() -> Self {
        Self(Instant::now())
    }

    fn look(&self) -> ControlFlow<()> {
        match self.0.elapsed() > LONGEST_RUN {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }
}

impl Watch for Hasty {
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        self.look()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.look()
    }
}

/// What came of some texts.
#[derive(Debug, Default)]
struct Count {
    sound: usize,
    broken: usize,
    emitted: usize,
    ran: usize,
}

fn take_through(text: &str, count: &mut Count) {
    let formatted = format(FileId(0), text).unwrap_or_else(|refusal| panic!("{refusal}\n{text}"));
    let again = format(FileId(0), &formatted.text).map(|again| again.text);
    assert_eq!(again.as_ref(), Ok(&formatted.text), "{text}");

    let mut sources = Sources::new();
    let file = sources.add("fuzz.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    render(&analysis.diagnostics, &sources, Rendering { colour: false, most: 20 });
    verdicts(&analysis);
    match analysis.is_sound() {
        true => count.sound += 1,
        false => count.broken += 1,
    }
    let program = &analysis.program;
    for (at, op) in program.ops.iter().enumerate() {
        if op.span.file != file || analysis.plans[at].is_none() {
            continue;
        }
        let proved = &analysis.proved;
        let selection =
            Selection { program, proved, sources: &sources, ops: &[at], exhaustive: false };
        let _ = cpp(&selection, &Style::default());
        let _ = rust(&selection);
        count.emitted += 1;
    }
    for number in (0..program.scripts.len()).filter(|&at| program.scripts[at].span.file == file) {
        let Ok(prepared) = prepare(program, number, &analysis.plans) else { continue };
        let Ok(arguments) = prepared.arguments(&[]) else { continue };
        let mut mesh = shape::icosahedron();
        let _ = run::run(&prepared, &mut mesh, &arguments, &mut Hasty::new());
        validate(&mesh).unwrap_or_else(|law| panic!("{law}\n{text}"));
        count.ran += 1;
    }
    let own = |at: &usize| program.tests[*at].script.span.file == file;
    for number in (0..program.tests.len()).filter(own) {
        let load: &mut run::Load = &mut |_, _| Err("nothing is loaded here".to_owned());
        let _ = test(program, number, &analysis.plans, CONDITIONS, load, &mut Hasty::new());
        count.ran += 1;
    }
}

#[test]
fn programs_are_taken_all_the_way() {
    let rounds = setting("HEDGEROW_FUZZ", ROUNDS);
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15 ^ setting("HEDGEROW_SEED", 0) as u64);
    let shipped = shipped();
    let mut count = Count::default();
    for _ in 0..rounds {
        let mut text = assembled(&shipped, &mut dice);
        for _ in 0..dice.below(3) {
            text = mutated(&text, &mut dice);
        }
        take_through(&text, &mut count);
    }
    println!("{count:?}");
    assert!(count.sound * 10 > rounds && count.broken * 4 > rounds, "{count:?}");
    assert!(count.emitted * 4 > rounds && count.ran * 50 > rounds, "{count:?}");
}
