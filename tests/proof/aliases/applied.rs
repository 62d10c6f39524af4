//! Ops with `alias`, applied by the machine where names are one.

use std::sync::Arc;

use hedgerow::check::{Verdict, check, identifications};
use hedgerow::compile::compile;
use hedgerow::diagram::{Alias, NameId, Op, Ref};
use hedgerow::mesh::{Level, Mesh, validate, validate_level};
use hedgerow::rewrite::{Machine, Outcome, Plan};

use crate::aliases::{maps, one_in, places, rules, words};
use support::meshes::{Dice, meshes};
use support::reference::matching::{bound_by, matches_where};
use support::reference::printing::mesh_text;
use support::reference::rewriting::rewrite;
use support::reference::same::{identical, same_result};

/// How many matches are looked at in one place.
const MOST: usize = 60;

#[test]
fn an_op_with_alias_does_what_the_drawing_says() {
    let mut counts = Counts::default();
    let meshes = maps(40, 11);
    for (sources, op) in rules() {
        let mut op = op;
        op.rules[0].guard = None;
        for with in with_aliases(&op, 6) {
            let rule = &with.rules[0];
            let Ok(proved) = check(&with) else {
                counts.rejected += 1;
                continue;
            };
            let plan = compile(&proved, &sources, &Arc::default()).expect("a small op");
            counts.proved += 1;
            for mesh in &meshes {
                for place in places(&with, mesh) {
                    let found = apply(&with, &plan, mesh, &place, Level::Map);
                    counts.applied += usize::from(found == Found::Applied);
                    counts.one += usize::from(found == Found::AppliedWhereOne);
                }
            }
            assert!(!rule.aliases.is_empty());
        }
    }
    println!("{counts:?}");
    assert!(counts.proved > 30 && counts.one > 500, "{counts:?}");
}

#[test]
fn a_guard_is_weakest_where_names_are_one() {
    let mut counts = Counts::default();
    let level = Level::Surface;
    let mut meshes = meshes(level, &mut Dice(23));
    meshes.retain(|mesh| mesh.halfedge_count() <= 14);
    for (sources, op) in rules() {
        let mut op = op;
        let span = op.rules[0].after.span;
        op.rules[0].guard = Some((level, span));
        for with in with_aliases(&op, 4) {
            let Ok(proved) = check(&with) else { continue };
            let plan = compile(&proved, &sources, &Arc::default()).expect("a small op");
            counts.proved += 1;
            for mesh in &meshes {
                for place in places(&with, mesh) {
                    let found = apply(&with, &plan, mesh, &place, level);
                    counts.applied += usize::from(found == Found::Applied);
                    counts.one += usize::from(found == Found::AppliedWhereOne);
                    counts.refused += usize::from(found == Found::Refused);
                }
            }
        }
    }
    println!("{} meshes, {counts:?}", meshes.len());
    assert!(counts.applied > 50 && counts.refused > 20, "{counts:?}");
}

#[derive(Debug, Default)]
struct Counts {
    proved: usize,
    rejected: usize,
    applied: usize,
    /// Applied where names are one.
    one: usize,
    refused: usize,
}

#[derive(PartialEq, Eq)]
enum Found {
    Nothing,
    Applied,
    AppliedWhereOne,
    Refused,
}

/// The op with `alias`es, for each set of names of a verdict that is fine.
fn with_aliases(op: &Op, most: usize) -> Vec<Op> {
    let found = identifications(op, &op.rules[0]).0;
    let fine = found.iter().filter(|one| matches!(one.verdict, Verdict::Fine));
    fine.take(most).map(|one| with_alias(op, &one.names)).collect()
}

/// The op with one `alias` for each class of names.
pub fn with_alias(op: &Op, classes: &[Vec<NameId>]) -> Op {
    let span = op.rules[0].after.span;
    let mut with = op.clone();
    let alias = |class: &Vec<_>| Alias {
        names: class.iter().map(|&name| Ref::plain(name, span)).collect(),
        span,
    };
    with.rules[0].aliases = classes.iter().map(alias).collect();
    with
}

fn apply(op: &Op, plan: &Plan, mesh: &Mesh, place: &[u32], level: Level) -> Found {
    let rule = &op.rules[0];
    let may_be_one = |left, right| rule.may_be_one(left, right);
    let found = matches_where(rule, mesh, &bound_by(rule, place), MOST, &may_be_one);
    let literal: Vec<_> = found
        .iter()
        .map(|at| rewrite(rule, mesh, at).expect("all names are bound"))
        .filter(|result| level == Level::Map || validate_level(&result.mesh, level).is_ok())
        .collect();
    let mut result = mesh.clone();
    let slots: Vec<_> = place.iter().map(|&element| u64::from(element)).collect();
    let outcome = Machine::default().apply(&mut result, plan, &slots);
    let told = || {
        let aliases = rule.aliases.iter().map(|alias| {
            let names = alias.names.iter().map(|name| name.name);
            names.collect::<Vec<_>>()
        });
        let aliases = words(rule, &aliases.collect::<Vec<_>>());
        format!("{} with {aliases} at {place:?} of\n{}", op.name, mesh_text(mesh))
    };
    match outcome.expect("nothing traps") {
        Outcome::Applied { .. } => {
            assert_eq!(validate(&result), Ok(()), "{}", told());
            let agrees = |literal: &support::reference::rewriting::Rewritten| {
                same_result(mesh, &result, &literal.mesh)
            };
            let agreed = literal.iter().any(agrees) || found.len() == MOST;
            assert!(agreed, "{} it makes\n{}", told(), mesh_text(&result));
            let one = found.iter().any(|at| !one_in(rule, at).is_empty());
            if one { Found::AppliedWhereOne } else { Found::Applied }
        }
        Outcome::Refused { .. } => {
            assert!(identical(mesh, &result));
            assert!(literal.is_empty(), "refused: {}", told());
            if found.is_empty() { Found::Nothing } else { Found::Refused }
        }
    }
}
