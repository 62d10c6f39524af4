//! Words of other languages and mesh libraries, and their equivalents here.
//!
//! A newcomer writes `h.opposite`, `len(faces)` or `float`. Such words are too far from ours to be
//! taken for misspellings, so they are listed in tables. About half of them have an equivalent
//! here, which is offered as a fix; for the others a sentence explains how it is done.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Overload, Type, Wanted, functions, overloads};
use crate::source::Span;
use crate::syntax::foreign_syntax::type_word;
use crate::syntax::tree::{self, Ident};

use super::lookup::CONSTANTS;
use super::suggestion::suggest;

/// The replacement of a foreign word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Here {
    /// The equivalent in this language.
    Written(&'static str),
    /// A sentence that explains how it is done.
    Said(&'static str),
}

use Here::{Said, Written};

const DECLARED: Here = Said("a variable begins with `let`, or with `var` if it changes");

/// The rows of foreign words, by kind of word; it says how.
const ROWS: &str = include_str!("foreign_words.txt");

/// The replacement of a word in the sections of a kind.
fn replacement(kind: &str, word: &str) -> Option<Here> {
    replacements(kind, word).next()
}

/// The replacements of a word in the sections of a kind, the usual one first.
fn replacements(kind: &str, word: &str) -> impl Iterator<Item = Here> {
    let sections = ROWS.split("\n[").filter_map(|section| section.split_once("]\n"));
    let of_kind = sections.filter(move |(kinds, _)| kinds.split(' ').any(|one| one == kind));
    of_kind.flat_map(|(_, rows)| rows.lines()).filter_map(move |row| {
        let said = row.split_once(": ").map(|(words, sentence)| (words, Said(sentence)));
        let written = || row.split_once(" -> ").map(|(words, ours)| (words, Written(ours)));
        let (words, here) = said.or_else(written)?;
        let is_one = |known: &str| known == word || word.len() > 2 && plain(known) == plain(word);
        words.split(' ').any(is_one).then_some(here)
    })
}

/// A word without its capitals and underscores: `isBoundary` is `is_boundary`.
fn plain(word: &str) -> String {
    word.replace('_', "").to_lowercase()
}

/// The replacement of a foreign field of a type.
pub(super) fn field(ty: Type, word: &str) -> Option<Here> {
    let are_parts = (2..=4).contains(&word.len()) && word.chars().all(|c| "xyzwrgba".contains(c));
    match ty {
        Type::Vec2 | Type::Vec3 | Type::Vec4 if are_parts => {
            Some(Said("parts of a vector are put together: `vec2(p.x, p.y)`"))
        }
        _ => replacement(ty.word(), word),
    }
}

/// True if other languages use the word for the number of sides of a face or of edges at a vertex.
pub(super) fn is_degree(ty: Type, word: &str) -> bool {
    match word {
        "n" | "degree" | "valence" | "valency" | "size" | "count" | "len" | "num_edges"
        | "n_edges" | "edge_count" | "num_halfedges" => matches!(ty, Type::Vertex | Type::Face),
        "sides" | "num_sides" | "n_sides" | "side_count" | "num_vertices" | "n_vertices"
        | "vertex_count" | "nverts" | "num_verts" | "length" | "arity" => ty == Type::Face,
        "num_neighbors" | "num_neighbours" => ty == Type::Vertex,
        _ => false,
    }
}

/// The replacement of a foreign function name.
pub(super) fn function(word: &str) -> Option<Here> {
    function_called(word, |_| true)
}

/// The same in a call, without the functions that do not fit it.
pub(super) fn function_called(word: &str, fits: impl Fn(&str) -> bool) -> Option<Here> {
    let is_meant = |here: &Here| !matches!(here, Written(ours) if !fits(ours));
    replacements("function", word).chain(of_values(word)).find(is_meant)
}

/// True if other languages have such a function of values.
pub(super) fn is_foreign(word: &str) -> bool {
    of_values(word).is_some()
}

/// The replacement of a measure, or of a function of numbers, vectors or matrices.
fn of_values(word: &str) -> Option<Here> {
    replacement("calculation", word).or_else(|| of_floats(word))
}

/// The function that C calls with an `f` behind its name: `sqrtf`.
fn of_floats(word: &str) -> Option<Here> {
    let name = word.strip_suffix('f')?;
    let ours = functions().find(|ours| *ours == name)?;
    let of_reals =
        |way: &Overload| way.wanted.iter().all(|wanted| *wanted == Wanted::Is(Type::Real));
    overloads(name).iter().all(of_reals).then_some(Written(ours))
}

/// The replacement of a foreign word used as a value or statement.
pub(super) fn name(word: &str) -> Option<Here> {
    replacement("value", word).or_else(|| declares(word).then_some(DECLARED))
}

/// True if other languages declare a variable with this word: `int x = 3`, `const x = 3`.
pub(super) fn declares(word: &str) -> bool {
    matches!(word, "const" | "auto" | "mut") || declared_type(word).is_some()
}

/// The type that such a word gives to a variable.
pub(super) fn declared_type(word: &str) -> Option<&'static str> {
    let mut ours = Type::ALL.into_iter().map(Type::word);
    type_word(word).or_else(|| ours.find(|ours| *ours == word))
}

/// The error with the fix for a call of a constant; any other call gives the error back.
pub(super) fn constant_called(
    error: Diagnostic,
    function: &Ident,
    args: &[tree::Expr],
    span: Span,
) -> Result<Diagnostic, Diagnostic> {
    let word = function.text.as_str();
    if !args.is_empty() || !CONSTANTS.iter().any(|(known, _)| *known == word) {
        return Err(error);
    }
    let error = error.saying(format!("`{word}` is a constant"));
    Ok(error.fix(format!("write `{word}`"), span, word))
}

/// Adds the replacement of the foreign `word` at `span` to `diagnostic`; if there is none, suggests
/// the closest of the `candidates`.
pub(super) fn tell<'a>(
    diagnostic: Diagnostic,
    (word, span): (&str, Span),
    here: Option<Here>,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Diagnostic {
    match here {
        Some(Written(ours)) => diagnostic.saying(format!("here it is written `{ours}`")).fix(
            format!("write `{ours}`"),
            span,
            ours,
        ),
        Some(Said(sentence)) => diagnostic.note(sentence),
        None => suggest(diagnostic, word, span, candidates),
    }
}
