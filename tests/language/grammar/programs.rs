//! Programs to read: those of this repository, and what becomes of them when someone types.

use hedgerow::source::FileId;
use hedgerow::syntax::{Token, TokenKind, parse};
use std::fs;
use std::path::{Path, PathBuf};
use support::dice::Dice;

fn files_below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_below(&path, found);
        } else {
            found.push(path);
        }
    }
}

/// The texts of the files below some folders that end in a way. What is written as in another
/// language, of which `elsewhere.md` and `students.md` are full, hedgerow tells where a grammar may read it.
fn texts(folders: &[&str], end: &str) -> Vec<String> {
    let mut files = Vec::new();
    for folder in folders {
        files_below(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), &mut files);
    }
    files.retain(|file| file.extension().is_some_and(|extension| extension == end));
    let foreign = ["files/elsewhere.md", "files/students.md"];
    files.retain(|file| !foreign.iter().any(|page| file.ends_with(page)));
    files.sort();
    let texts = files.iter().map(|file| fs::read_to_string(file).unwrap());
    texts.collect()
}

/// Whole files.
pub fn files() -> Vec<String> {
    texts(&["examples", "src/library", "tests"], "hedge")
}

/// The programs of the pages, whatever is wrong with them.
pub fn of_pages() -> Vec<String> {
    let mut programs = Vec::new();
    for page in texts(&["tests"], "md") {
        let fences = page.split("```hedge\n").skip(1);
        programs.extend(fences.filter_map(|rest| Some(rest.split_once("```")?.0.to_owned())));
    }
    programs
}

/// What the grammar is known to read otherwise. A keyword that touches a star: tree-sitter takes
/// it for the name of a fan. A keyword at the start of a line is no field of the value before. And a
/// word that begins items where any word may stand, as a field or a
/// type, as `private`, a name, or as `test`, a name before a text: if it looks like the start of an
/// item, hedgerow takes it for that, so that a file which someone is in the middle of typing falls
/// apart into the right items.
pub fn is_known_to_differ(text: &str) -> bool {
    use TokenKind as T;
    let tokens = parse(FileId(0), text).tokens;
    let begins = [T::Use, T::Private, T::Attr, T::Fn, T::Op, T::Script, T::Test];
    let before = |at: usize, back: usize| at.checked_sub(back).map(|at| tokens[at]);
    let leads = |token: Option<Token>| {
        let leads = |kind| matches!(kind, T::Dot | T::Colon | T::Arrow | T::Equals);
        token.is_some_and(|token| leads(token.kind))
    };
    tokens.iter().enumerate().any(|(at, token)| {
        let touches = before(at, 1)
            .is_some_and(|star| star.kind == T::Star && star.span.end == token.span.start);
        let begins_test = token.kind == T::Test
            && tokens.get(at + 1).is_some_and(|next| next.kind == T::Text)
            && is_in_braces(&tokens[..at]);
        let goes_on = before(at, 1).is_some_and(|point| {
            let between = point.span.end as usize..token.span.start as usize;
            point.kind == T::Dot && text[between].contains('\n')
        });
        begins_test
            || (touches || goes_on) && token.kind.is_keyword()
            || begins.contains(&token.kind) && (leads(before(at, 1)) || leads(before(at, 2)))
    })
}

/// Whether more braces are opened than closed.
fn is_in_braces(tokens: &[Token]) -> bool {
    let count = |kind| tokens.iter().filter(|token| token.kind == kind).count();
    count(TokenKind::LeftBrace) > count(TokenKind::RightBrace)
}

/// Whether hedgerow reads a text without a mistake in how it is written, or `None` if that is
/// a matter of size, which is beyond a grammar.
pub fn is_read(text: &str) -> Option<bool> {
    let told = parse(FileId(0), text).diagnostics;
    let of_size = ["number-too-large", "nesting-too-deep"];
    if told.iter().any(|found| of_size.contains(&found.code)) {
        return None;
    }
    Some(told.is_empty())
}

/// The text with a token gone, doubled, exchanged for another of the text or of the language,
/// or moved.
pub fn mutated(text: &str, dice: &mut Dice) -> String {
    let tokens = parse(FileId(0), text).tokens;
    if tokens.is_empty() {
        return text.to_owned();
    }
    let at = tokens[dice.below(tokens.len())].span.range();
    let other = &text[tokens[dice.below(tokens.len())].span.range()];
    let (before, same, behind) = (&text[..at.start], &text[at.clone()], &text[at.end..]);
    match dice.below(5) {
        0 => format!("{before} {behind}"),
        1 => format!("{before}{same} {same}{behind}"),
        2 => format!("{before}{other}{behind}"),
        3 => format!("{before}{other} {same}{behind}"),
        _ => {
            let words = TokenKind::KEYWORDS.len() + TokenKind::MARKS.len();
            let mut all = TokenKind::KEYWORDS.iter().chain(TokenKind::MARKS);
            let (word, _) = all.nth(dice.below(words)).unwrap();
            format!("{before} {word} {behind}")
        }
    }
}
