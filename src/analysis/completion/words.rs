//! The words of the language that begin something, each with a snippet.

use super::choice::{Choice, Completion};
use crate::diagram::Type;

/// The beginnings of items.
pub(super) const TOP: &[(&str, &str)] = &[
    ("op", "op ${1:name}(${2:e}: ${3:edge}) {\n  before {\n    $0\n  }\n  after {\n  }\n}"),
    ("script", "script ${1:name}(${2}) {\n  $0\n}"),
    ("private", "private $0"),
    ("fn", "fn ${1:name}(${2:e}: ${3:edge}) -> ${4:real} {\n  $0\n}"),
    ("attr", "attr ${1:name}: ${2:vertex} ${3:real} = ${0:0}"),
    ("use", "use \"$0\""),
    ("test", "test \"${1:what holds}\" {\n  $0\n}"),
];

/// The beginnings of the parts of an op.
pub(super) const PARTS: &[(&str, &str)] = &[
    ("before", "before {\n  $0\n}"),
    ("after", "after {\n  $0\n}"),
    REQUIRE,
    ("guard", "guard ${1|surface,simple|}"),
    ("alias", "alias ${1:v2} ${2:v3}"),
    ("rule", "rule ${1:name} {\n  before {\n    $0\n  }\n  after {\n  }\n}"),
    ("steps", "steps {\n  $0\n}"),
];

/// A condition of an op, and a step.
pub(super) const REQUIRE: (&str, &str) = ("require", "require ${1:condition} else \"${2:reason}\"");

/// The beginnings of the statements of a drawing.
pub(super) const DRAWINGS: &[(&str, &str)] = &[
    ("face", "face ${1:f}: ${2:v0} -${3:a}-> ${4:v1} -${5:b}-> ${6:v2} -${7:c}-> ${2:v0}"),
    ("hole", "hole ${1:f}: ${2:v0} -${3:a}-> ${4:v1} =${5:P}=> ${2:v0}"),
    ("loop", "loop ${1:f}: ${2:v0} -${3:a}-> ${4:v1} =${5:P}=> ${2:v0}"),
    ("edge", "edge ${1:e}: ${2:a} | ${3:d}"),
    ("vertex", "vertex ${1:v}: ${2:a} *${3:S}"),
];

/// The beginnings of the lists of names in `after`.
pub(super) const LISTS: &[(&str, &str)] =
    &[("new", "new $0"), ("erase", "erase $0"), ("keep", "keep $0")];

/// The beginning of a statement that repeats a period.
pub(super) const PERIOD: &[(&str, &str)] = &[("each", "each ${1:i} { $0 }")];

/// The beginnings of the statements of a script.
pub(super) const ACTIONS: &[(&str, &str)] = &[
    ("let", "let ${1:x} = $0"),
    ("var", "var ${1:x} = $0"),
    ("for", "for ${1:e} in ${2:edges} where ${3:condition} { $0 }"),
    ("parallel", "parallel for ${1:e} in ${2:edges} where ${3:condition} { $0 }"),
    ("repeat", "repeat ${1:5} {\n  $0\n}"),
    ("while", "while ${1:condition} {\n  $0\n}"),
    ("update", "update ${1:v} in ${2:vertices} { ${1:v}.position = $0 }"),
    ("drain", "drain ${1:e} in ${2:edges} by ${3:key} while ${4:condition} { $0 }"),
    ("if", "if ${1:condition} { $0 }"),
    ("print", "print $0"),
    ("assert", "assert ${1:condition} else \"${2:reason}\""),
    ("must", "must $0"),
    ("return", "return"),
    ("break", "break"),
    ("continue", "continue"),
];

/// Keywords with their snippets.
pub(super) fn keywords(words: &[(&str, &str)]) -> Vec<Completion> {
    let words = words.iter();
    words.map(|(word, snippet)| Completion::new(*word, Choice::Keyword, 5).with(snippet)).collect()
}

/// The types of values and elements.
pub(super) fn types() -> Vec<Completion> {
    Type::ALL.map(|ty| Completion::new(ty.word(), Choice::Type, 0)).to_vec()
}

/// The types of elements.
pub(super) fn kinds() -> Vec<Completion> {
    KINDS.map(|word| Completion::new(word, Choice::Type, 0)).to_vec()
}

/// The types of values that are no elements.
pub(super) fn value_types() -> Vec<Completion> {
    let mut found = types();
    found.retain(|ty| !KINDS.contains(&ty.word.as_str()));
    found
}

/// The words of the types of elements.
const KINDS: [&str; 4] = ["edge", "face", "halfedge", "vertex"];
