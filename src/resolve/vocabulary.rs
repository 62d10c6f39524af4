//! The words of the language that are not keywords, for completion and explanations.

use crate::diagnostic::one_of;
use crate::diagram::{Type, Wanted, overloads};

use super::builtin::{SHUFFLE, function_names};
use super::constructors::{constructed, ways};
use super::fields::{Field, fields_of};
use super::lookup::CONSTANTS;
use super::sequence_names::{WHOLE_MESH, fold_names, sequences_of};
use super::testing::CONSTRUCTORS;

/// A signature of a built-in function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// The names of the types of its parameters: `vertex`, `real`.
    pub takes: Vec<&'static str>,
    /// The type of its result; `None` for `shuffle` and the aggregates.
    pub gives: Option<Type>,
}

/// A word after a dot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FieldWord {
    pub name: &'static str,
    /// Its type; `None` if it is a sequence.
    pub ty: Option<Type>,
    /// True if it is stored with the element and can be assigned.
    pub is_attribute: bool,
}

/// True if a word is a function or an aggregate of the language.
pub fn is_function(word: &str) -> bool {
    function_words().any(|known| known == word)
}

/// The functions and aggregates of the language.
pub fn function_words() -> impl Iterator<Item = &'static str> {
    let twice = |word: &&str| overloads(word).is_empty();
    function_names().chain(fold_names().filter(twice))
}

/// The signatures of a built-in function; empty if there is no such function.
pub fn signatures(function: &str) -> Vec<Signature> {
    if let Some(ty) = constructed(function) {
        let ways = ways(ty).iter();
        return ways.map(|takes| Signature { takes: takes.to_vec(), gives: Some(ty) }).collect();
    }
    if function == SHUFFLE {
        return vec![Signature { takes: vec!["sequence"], gives: None }];
    }
    let mut ways: Vec<_> = overloads(function)
        .iter()
        .map(|way| Signature {
            takes: way.wanted.iter().map(|wanted| word(*wanted)).collect(),
            gives: Some(way.result),
        })
        .collect();
    let over = |takes| Signature { takes: vec![takes], gives: None };
    match function {
        "count" => ways.extend([over("sequence"), over("bool for x in sequence where condition")]),
        "any" | "all" => ways.push(over("bool for x in sequence where condition")),
        _ if fold_names().any(|fold| fold == function) => {
            ways.push(over("value for x in sequence where condition"));
        }
        _ => {}
    }
    ways
}

/// The ways to call a built-in function, for messages.
pub(super) fn called(function: &str) -> String {
    let ways = signatures(function).into_iter();
    let ways: Vec<_> = ways.map(|way| format!("`{function}({})`", way.takes.join(", "))).collect();
    one_of(&ways)
}

fn word(wanted: Wanted) -> &'static str {
    match wanted {
        Wanted::Is(ty) => ty.word(),
        Wanted::Point => "point",
    }
}

/// The fields and sequences of a value of this type.
pub fn fields(ty: Type) -> Vec<FieldWord> {
    let values = fields_of(ty).iter().map(|(name, field)| {
        let (Field::Pointer(_, ty) | Field::Attribute(_, ty) | Field::Part(_, ty)) = *field;
        FieldWord { name, ty: Some(ty), is_attribute: matches!(field, Field::Attribute(..)) }
    });
    let sequences =
        sequences_of(ty).iter().map(|name| FieldWord { name, ty: None, is_attribute: false });
    values.chain(sequences).collect()
}

/// The sequences of the whole mesh: `vertices`, `edges`, …
pub fn sequence_words() -> impl Iterator<Item = &'static str> {
    WHOLE_MESH.iter().map(|(word, _)| *word)
}

/// The functions that make the mesh of a test, each with whether it takes arguments.
pub fn mesh_words() -> impl Iterator<Item = (&'static str, bool)> {
    CONSTRUCTORS.iter().map(|(word, sizes)| (*word, !sizes.is_empty())).chain([("load", true)])
}

/// The words for the meshes of a test, and the constants.
pub fn mesh_and_constant_words() -> impl Iterator<Item = &'static str> {
    mesh_words().map(|(word, _)| word).chain(["refuses", "mesh"]).chain(constants())
}

/// The constants of the language.
pub fn constants() -> impl Iterator<Item = &'static str> {
    CONSTANTS.iter().map(|(word, _)| *word)
}

/// True if a word is a constant or `mesh`, unless something else has the name.
pub fn is_constant(word: &str) -> bool {
    word == "mesh" || CONSTANTS.iter().any(|(known, _)| *known == word)
}
