//! Counterexamples: a small mesh and match on which a rejected rule breaks.
//!
//! The drawing of `before` is laid down as a [`sketch`], its [`outside`] is closed in one of the
//! possible ways, and the result is a [`place`]: a valid mesh with the match in it. There the
//! rewrite is carried out, [`literal`]ly, and the verdict of `validate` on the outcome is put into
//! [`words`]. The [`search`] goes from small to large; every [`completion`] of the drawing that is
//! smaller than what it finds is examined, too.
//!
//! A counterexample is never part of a proof: it shows people, and the tests, that breaking a law
//! has consequences.

mod completion;
mod counterexample;
mod drawn;
mod layout;
mod literal;
mod outside;
mod place;
mod search;
mod sketch;
mod words;

use super::alias::Quotient;
use super::arrangement::Arc;
use super::broken::Broken;
use super::problem::Problem;
use crate::diagram::{Drawing, NameId, Op, Rule};
use crate::mesh::{Element, Level};
pub use counterexample::{Counterexample, Outcome};
use search::{Found, Shown, search, search_where_one};
use words::Words;

/// Codes of problems that do not concern the mesh: there is nothing to carry out.
const BESIDE_THE_MESH: [&str; 7] = [
    "alias-always",
    "alias-impossible",
    "alias-incomplete",
    "unknown-name",
    "unreachable-name",
    "missing-attribute",
    "property-not-kept",
];

/// Carries the rules of an op out on small meshes, whether they are proved or not.
pub fn try_out(op: &Op) -> Vec<Outcome> {
    let outcome = |rule: &Rule| {
        let drawing = Drawing::new(rule);
        outcome(&op.name, &drawing, search(&drawing, None), "")
    };
    op.rules.iter().map(outcome).collect()
}

/// Carries a rule out where some of its names are one.
pub(super) fn find_where_one(
    op: &Op,
    rule: &Rule,
    quotient: &Quotient,
    arcs: Option<&[Arc]>,
    code: &'static str,
) -> Outcome {
    let drawing = Drawing::new(rule);
    let found = search_where_one(&drawing, quotient, arcs);
    outcome(&op.name, &drawing, found, code)
}

/// Carries a rejected rule out, and notes the outcome at the first of its problems about the mesh.
pub(super) fn find(op: &Op, rule: &Rule, broken: &mut Broken) -> Outcome {
    let drawing = Drawing::new(rule);
    let about_mesh = |problem: &&mut Problem| !BESIDE_THE_MESH.contains(&problem.diagnostic.code);
    let Some(problem) = broken.problems.iter_mut().find(about_mesh) else {
        return Outcome::NotTried;
    };
    let diagnostic = &mut problem.diagnostic;
    if diagnostic.code == "impossible-drawing" {
        return Outcome::NoMesh;
    }
    let outcome = match broken.outcome.take() {
        Some(outcome) => outcome,
        None => {
            let mut found = search(&drawing, broken.arcs.as_deref());
            if let (Found::Breaks(shown), false) = (&mut found, rule.aliases.is_empty()) {
                // Where names are one, a smaller mesh may break.
                shown.smallest_of = None;
            }
            outcome(&op.name, &drawing, found, diagnostic.code)
        }
    };
    diagnostic.notes.extend(note(&outcome).filter(|note| !diagnostic.notes.contains(note)));
    let breaks = matches!(outcome, Outcome::Breaks(_));
    if breaks && !rule.requires.is_empty() {
        let note = "whether this mesh passes each `require` is not looked at: the proof does not rely on them";
        diagnostic.notes.push(note.into());
    }
    outcome
}

fn outcome(op: &str, drawing: &Drawing, found: Found, code: &'static str) -> Outcome {
    match found {
        Found::Breaks(shown) => {
            Outcome::Breaks(Box::new(counterexample(op, drawing, *shown, code)))
        }
        Found::Valid(tried) => Outcome::Valid(tried),
        Found::NoPlace => Outcome::NoMesh,
        Found::Unclear => Outcome::NotTried,
    }
}

/// The note about an outcome.
fn note(outcome: &Outcome) -> Option<String> {
    match outcome {
        Outcome::Breaks(example) => {
            let mesh = match example.smallest_of {
                Some(Level::Map) => "the smallest mesh that breaks".into(),
                Some(level) => format!("the smallest `{level}` mesh that breaks"),
                None => "a small mesh".into(),
            };
            let size = words::size(&example.before);
            Some(format!("carried out literally on {mesh} ({size}): {}", example.verdict))
        }
        Outcome::Valid(tried) => {
            let meshes = match tried {
                1 => "the one small mesh".into(),
                tried => format!("all {tried} small meshes"),
            };
            Some(format!(
                "carried out literally, the result happens to be valid on {meshes} tried; it is the drawing that is not in order"
            ))
        }
        Outcome::NoMesh => Some("no mesh matches `before`: it contradicts itself".into()),
        Outcome::NotTried => None,
    }
}

fn counterexample(op: &str, drawing: &Drawing, shown: Shown, code: &'static str) -> Counterexample {
    let Shown { place, carried, invalid, smallest_of } = shown;
    let words = Words { drawing, place: &place, carried: &carried };
    let verdict = words.verdict(&invalid);
    let rule = drawing.rule;
    let mut names = Vec::new();
    for index in 0..rule.names.len() {
        let name = NameId(index as u32);
        let element = carried.elements[index];
        let elements: Vec<Element> = match rule.kind(name).element_kind() {
            Some(kind) => element.into_iter().map(|index| Element { kind, index }).collect(),
            None => place.runs[index].iter().map(|&half| half.into()).collect(),
        };
        if rule.name(name).named {
            names.push((rule.name(name).text.clone(), elements));
        }
    }
    Counterexample {
        op: op.into(),
        rule: rule.label.clone(),
        code,
        before: place.mesh,
        after: carried.mesh,
        names,
        invalid,
        verdict,
        smallest_of,
    }
}
