//! Small changes to the ops of the examples: whatever is rejected breaks a mesh, or says why
//! not.

use std::collections::BTreeMap;
use std::fs;

use hedgerow::analysis::Analysis;
use hedgerow::check::{Outcome, examine, try_out};
use hedgerow::diagram::{Kind, LoopKind, NameId, Op, Ref, Rule, Side, Spoke};
use hedgerow::mesh::validate;
use hedgerow::source::Sources;

use support::reference::examples;

/// Codes of drawings that are not in order though the rewrite may do no harm: what they say of
/// a path, a fan or a star is wrong, but nothing is written where they say it; or what they
/// leave out had the right value already.
const MAY_BE_HARMLESS: [&str; 7] = [
    "ends-disagree",
    "erased-and-drawn",
    "hidden-spoke",
    "missing-reassignment",
    "star-order",
    "two-vertices-one-ring",
    "unaccounted-name",
];

#[test]
fn what_is_rejected_breaks_a_mesh() {
    let mut counts: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut total = BTreeMap::new();
    for op in examples() {
        for mutant in mutants(&op) {
            let Err(rejection) = examine(&mutant) else {
                let outcomes = try_out(&mutant);
                let valid = |outcome: &Outcome| matches!(outcome, Outcome::Valid(1..));
                assert!(outcomes.iter().all(valid), "{outcomes:#?}");
                *total.entry("proved").or_insert(0) += 1;
                continue;
            };
            let outcome = &rejection.outcomes[0];
            let code = match outcome {
                Outcome::Breaks(example) => example.code,
                _ => rejection.diagnostics[0].code,
            };
            let word = match outcome {
                Outcome::Breaks(example) => {
                    assert_eq!(validate(&example.before), Ok(()));
                    assert_eq!(validate(&example.after), Err(example.invalid.clone()));
                    "breaks"
                }
                // Sound, but not what was meant.
                Outcome::Valid(_) if code == "empty-fan" => "empty",
                Outcome::Valid(tried) => {
                    assert!(*tried > 0);
                    assert!(MAY_BE_HARMLESS.contains(&code), "{code}");
                    "valid"
                }
                Outcome::NoMesh => "no mesh",
                Outcome::NotTried => {
                    assert!(matches!(code, "unknown-name" | "unreachable-name"), "{code}");
                    "not tried"
                }
            };
            *counts.entry((code, word)).or_insert(0) += 1;
            *total.entry(word).or_insert(0) += 1;
        }
    }
    for ((code, word), count) in &counts {
        println!("{code:24} {word:10} {count:6}");
    }
    println!("{total:?}");
    assert!(total["breaks"] > 1_300, "{total:?}");
    assert!(total["valid"] < total["breaks"] / 10, "{total:?}");
    assert!(total["proved"] > 200, "{total:?}");
}

/// The ops of the examples.
pub fn examples() -> Vec<Op> {
    let mut ops = Vec::new();
    for path in examples::examples() {
        let mut sources = Sources::new();
        let file = sources.add("example", fs::read_to_string(&path).unwrap());
        let analysis = Analysis::of(&sources, file);
        let diagrams = analysis.program.ops.into_iter().filter_map(|op| op.diagram);
        ops.extend(diagrams.filter(|op| !op.rules.iter().any(Rule::has_families)));
    }
    ops
}

/// The op with one rule left, which has one small change.
fn mutants(op: &Op) -> Vec<Op> {
    let mut mutants = Vec::new();
    for rule in &op.rules {
        let mut add = |change: &dyn Fn(&mut Rule)| {
            let mut changed = rule.clone();
            change(&mut changed);
            mutants.push(Op { rules: vec![changed], ..op.clone() });
        };
        missing(rule, &mut add);
        exchanged(rule, &mut add);
        relabelled(rule, &mut add);
    }
    mutants
}

type Add<'a> = &'a mut dyn FnMut(&dyn Fn(&mut Rule));

fn missing(rule: &Rule, add: Add) {
    for at in 0..rule.after.loops.len() {
        add(&|rule| _ = rule.after.loops.remove(at));
    }
    for at in 0..rule.after.edges.len() {
        add(&|rule| _ = rule.after.edges.remove(at));
    }
    for at in 0..rule.after.stars.len() {
        add(&|rule| _ = rule.after.stars.remove(at));
    }
    for at in 0..rule.before.stars.len() {
        add(&|rule| _ = rule.before.stars.remove(at));
    }
    for at in 0..rule.before.edges.len() {
        add(&|rule| _ = rule.before.edges.remove(at));
    }
    for at in 0..rule.erased.len() {
        add(&|rule| _ = rule.erased.remove(at));
    }
    for index in 0..rule.names.len() {
        let (name, span) = (NameId(index as u32), rule.after.span);
        if rule.kind(name) != Kind::Path && rule.kind(name) != Kind::Fan {
            add(&|rule| rule.erased.push(Ref::plain(name, span)));
        }
    }
}

/// Every mention of an item in the loops and edges of a side.
fn items(side: &mut Side) -> Vec<&mut NameId> {
    let loops = side.loops.iter_mut().flat_map(|orbit| &mut orbit.items);
    let edges = side.edges.iter_mut().flat_map(|edge| &mut edge.halfedges);
    loops.map(|item| &mut item.item.name).chain(edges.map(|half| &mut half.name)).collect()
}

fn exchanged(rule: &Rule, add: Add) {
    for side in [0, 1] {
        let pick = |rule: &mut Rule, change: &dyn Fn(&mut Side)| match side {
            0 => change(&mut rule.before),
            _ => change(&mut rule.after),
        };
        let mut copy = rule.clone();
        let count = items(if side == 0 { &mut copy.before } else { &mut copy.after }).len();
        for left in 0..count {
            for right in left + 1..count {
                add(&|rule| {
                    pick(rule, &|side| {
                        let mut items = items(side);
                        let (a, b) = (*items[left], *items[right]);
                        (*items[left], *items[right]) = (b, a);
                    });
                });
            }
        }
        let stars = [&rule.before, &rule.after][side].stars.len();
        for star in 0..stars {
            let spokes = [&rule.before, &rule.after][side].stars[star].spokes.len();
            for left in 0..spokes {
                for right in left + 1..spokes {
                    add(&|rule| pick(rule, &|side| side.stars[star].spokes.swap(left, right)));
                }
                add(&|rule| {
                    pick(rule, &|side| _ = side.stars[star].spokes.remove(left));
                });
                for other in 0..stars {
                    if other != star {
                        add(&|rule| {
                            pick(rule, &|side| {
                                let spoke: Spoke = side.stars[star].spokes.remove(left);
                                side.stars[other].spokes.push(spoke);
                            });
                        });
                    }
                }
            }
        }
    }
}

fn relabelled(rule: &Rule, add: Add) {
    let vertices: Vec<_> = rule.names_of(Kind::Vertex).collect();
    for orbit in 0..rule.after.loops.len() {
        for place in 0..rule.after.loops[orbit].items.len() {
            for &vertex in &vertices {
                if rule.after.loops[orbit].items[place].from.name == vertex {
                    continue;
                }
                add(&|rule| {
                    let orbit = &mut rule.after.loops[orbit];
                    orbit.items[place].from.name = vertex;
                    if place == 0 {
                        orbit.end.name = vertex;
                    }
                });
            }
        }
        add(&|rule| {
            let orbit = &mut rule.after.loops[orbit];
            orbit.kind = match orbit.kind {
                LoopKind::Face => LoopKind::Hole,
                LoopKind::Hole | LoopKind::Any => LoopKind::Face,
            };
        });
    }
    for star in 0..rule.after.stars.len() {
        for &vertex in &vertices {
            add(&|rule| rule.after.stars[star].vertex.name = vertex);
        }
    }
}
