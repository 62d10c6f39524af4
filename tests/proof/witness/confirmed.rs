//! Outcomes held against the reference, which shares no code with what found them.
//!
//! A counterexample must break when the reference rewrites it; where no mesh is said to match,
//! no random completion may; and where the result happens to be valid on small meshes, random
//! completions should not break either: those that do are counted.
//!
//! `HEDGEROW_MUTANTS` sets how many ops are looked at, `HEDGEROW_SEED` gives others.

use std::collections::BTreeMap;

use hedgerow::analysis::Analysis;
use hedgerow::check::{Counterexample, Outcome, examine};
use hedgerow::diagram::{Kind, Op, Rule};
use hedgerow::mesh::{Invalid, validate};
use hedgerow::source::Sources;

use crate::witness::mutants::examples;
use support::reference::completion::complete;
use support::reference::examples::alone;
use support::reference::matching::matches;
use support::reference::mutating::mutate;
use support::reference::printing::op_text;
use support::reference::random::Random;
use support::reference::rewriting::rewrite;

/// How many random completions an outcome is held against.
const COMPLETIONS: usize = 25;

#[test]
fn the_reference_confirms_what_was_found() {
    let count = number("HEDGEROW_MUTANTS").unwrap_or(1_500);
    let mut random = Random::new(number("HEDGEROW_SEED").unwrap_or(1) as u64);
    let bases = bases();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut not_tried: BTreeMap<&str, usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    let mut looked_at = 0;
    while looked_at < count {
        let mut op = random.pick(&bases).unwrap().clone();
        let changes = 1 + random.below(2);
        if (0..changes).any(|_| mutate(&mut op, &mut random).is_none()) {
            continue;
        }
        let text = op_text(&op, &op.rules[0]);
        let Some(op) = read_back(&text) else {
            continue;
        };
        looked_at += 1;
        let Err(rejection) = examine(&op) else {
            *counts.entry("proved").or_insert(0) += 1;
            continue;
        };
        let code = rejection.diagnostics[0].code;
        let rule = &op.rules[0];
        let word = match &rejection.outcomes[0] {
            Outcome::Breaks(example) => broken(rule, example),
            Outcome::NoMesh if completions(rule, &mut random).0 == 0 => "no mesh",
            Outcome::NoMesh => "no mesh, but there is one",
            Outcome::Valid(_) if completions(rule, &mut random).1 == 0 => "valid",
            Outcome::Valid(_) => "valid, but not everywhere",
            Outcome::NotTried => {
                *not_tried.entry(code).or_insert(0) += 1;
                "not tried"
            }
        };
        if word.contains(", but") {
            wrong.push(format!("{word}: {code}\n{text}"));
        }
        *counts.entry(word).or_insert(0) += 1;
    }
    println!("{counts:#?}\nnot tried: {not_tried:#?}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(counts["breaks"] > count / 4, "{counts:?}");
    let otherwise = counts.get(OTHERWISE).copied().unwrap_or(0);
    assert!(otherwise < count / 50, "{counts:?}");
}

pub fn number(variable: &str) -> Option<usize> {
    std::env::var(variable).ok()?.parse().ok()
}

/// Each rule of the examples by itself, without requirements.
pub fn bases() -> Vec<Op> {
    let mut bases = Vec::new();
    for op in examples() {
        for rule in &op.rules {
            bases.push(alone(&op, rule));
        }
    }
    bases
}

/// An op read back from its text, so that it is one that a person could have written.
pub fn read_back(text: &str) -> Option<Op> {
    let mut sources = Sources::new();
    let file = sources.add("mutant", text.to_owned());
    let mut analysis = Analysis::of(&sources, file);
    analysis.program.ops.pop()?.diagram
}

/// A counterexample at whose place the reference finds no match, or writes nothing: it lets no fan
/// hold a halfedge that is named, and no path that is next to another one be anything, and knows no
/// name that `after` alone has.
const OTHERWISE: &str = "breaks in another reading";

/// Whether the reference breaks the mesh of a counterexample at its match.
fn broken(rule: &Rule, example: &Counterexample) -> &'static str {
    let before = &example.before;
    let bound = rule.ids().filter_map(|name| {
        let run = matches!(rule.kind(name), Kind::Path | Kind::Fan);
        let new = rule.created.iter().any(|created| created.name == name);
        let text = &rule.name(name).text;
        let (_, elements) = example.names.iter().find(|(known, _)| known == text)?;
        let element = elements.first().filter(|_| !run && !new)?;
        Some((name, element.index))
    });
    let bound: Vec<_> = bound.collect();
    let found = matches(rule, before, &bound, 50);
    let results: Vec<_> = found.iter().filter_map(|at| rewrite(rule, before, at)).collect();
    if results.iter().any(|result| validate(&result.mesh).is_err()) {
        return "breaks";
    }
    match example.invalid {
        _ if results.is_empty() => OTHERWISE,
        // The reference gives a halfedge also to what `after` does not draw.
        Invalid::Dangling { pointer: "halfedge", .. } => "breaks, a stale `halfedge`",
        Invalid::ForeignHalfedge { .. } => "breaks, a stale `halfedge`",
        _ => "breaks, but not for the reference",
    }
}

/// How many random meshes match, and how many of these break.
fn completions(rule: &Rule, random: &mut Random) -> (usize, usize) {
    let (mut matched, mut broken) = (0, 0);
    for _ in 0..COMPLETIONS {
        let Some(completion) = complete(rule, random) else {
            continue;
        };
        let mesh = &completion.mesh;
        let bound = rule.params.iter().flatten();
        let bound = bound.filter_map(|name| Some((*name, completion.elements[name.index()]?)));
        let found = matches(rule, mesh, &bound.collect::<Vec<_>>(), 50);
        matched += usize::from(!found.is_empty());
        let mut results = found.iter().filter_map(|at| rewrite(rule, mesh, at));
        broken += usize::from(results.any(|result| validate(&result.mesh).is_err()));
    }
    (matched, broken)
}
