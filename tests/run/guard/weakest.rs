//! At every place of every small mesh of the level: refused exactly when the literal result
//! is not of the level.

use std::collections::BTreeMap;

use hedgerow::mesh::{HalfedgeId, Level, Mesh, identical, validate, validate_level};
use hedgerow::rewrite::{Machine, Outcome, Phase, Plan};

use support::guarded::{OPS, Op, try_compiled};
use support::meshes::{Dice, meshes, shuffle_pointers};

/// What was seen of an op at a level.
#[derive(Default)]
struct Tally {
    places: usize,
    applied: usize,
    refused: BTreeMap<String, usize>,
}

/// The two plans of an op, run side by side.
struct Pair<'o> {
    op: &'o Op,
    level: Level,
    guarded: Plan,
    bare: Plan,
    machine: Machine,
}

impl<'o> Pair<'o> {
    fn new(op: &'o Op, level: Level) -> Self {
        let (guarded, bare) = (op.guarded(level.name()), op.bare());
        Self { op, level, guarded, bare, machine: Machine::default() }
    }

    /// One place; the result, if the guard lets it pass.
    fn compare(&mut self, mesh: &Mesh, args: &[u64], tally: &mut Tally) -> Option<Mesh> {
        let (mut literal, mut careful) = (mesh.clone(), mesh.clone());
        let matched = self.machine.apply(&mut literal, &self.bare, args).unwrap();
        let outcome = self.machine.apply(&mut careful, &self.guarded, args).unwrap();
        let name = self.op.name;
        if matches!(matched, Outcome::Refused { .. }) {
            assert!(matches!(outcome, Outcome::Refused { .. }), "{name}");
            return None;
        }
        validate(&literal).unwrap();
        let verdict = validate_level(&literal, self.level);
        tally.places += 1;
        match outcome {
            Outcome::Applied { .. } => {
                if let Err(why) = verdict {
                    panic!("{name} {}: let pass, but {why}\n{}", self.level, dump(mesh, args));
                }
                assert!(identical(&literal, &careful), "{name}");
                tally.applied += 1;
                Some(careful)
            }
            Outcome::Refused { reason } => {
                let reason = &self.guarded.refusals[usize::from(reason.unwrap())];
                assert_eq!(reason.phase, Phase::Guard);
                assert!(
                    verdict.is_err(),
                    "{name} {}: refused for nothing: {}\n{}",
                    self.level,
                    reason.reason,
                    dump(mesh, args)
                );
                assert!(identical(mesh, &careful), "{name} wrote before it refused");
                *tally.refused.entry(reason.reason.clone()).or_default() += 1;
                None
            }
        }
    }

    fn arguments(&self, mesh: &Mesh) -> Vec<Vec<u64>> {
        let all: Vec<HalfedgeId> = mesh.halfedges().collect();
        let mut arguments = Vec::new();
        for a in &all {
            match self.op.two {
                false => arguments.push(vec![u64::from(a.0)]),
                true => arguments.extend(
                    all.iter()
                        .filter(|b| {
                            mesh.face(**b) == mesh.face(*a) || mesh.vertex(**b) == mesh.vertex(*a)
                        })
                        .map(|b| vec![u64::from(a.0), u64::from(b.0)]),
                ),
            }
        }
        arguments
    }
}

fn dump(mesh: &Mesh, args: &[u64]) -> String {
    let mut text = format!("at {args:?}\n");
    for face in mesh.faces() {
        let corners: Vec<_> = mesh.face_halfedges(face).map(|h| (h.0, mesh.vertex(h).0)).collect();
        text += &format!("{} hole {}: {corners:?}\n", face, mesh.is_hole(face));
    }
    text
}

/// Everywhere on the meshes, and on those that a few random steps lead to.
fn battle(level: Level) {
    let mut dice = Dice(7 + level as u64);
    let mut pairs: Vec<Pair> = OPS.iter().map(|op| Pair::new(op, level)).collect();
    let mut tallies: Vec<Tally> = OPS.iter().map(|_| Tally::default()).collect();
    for mut mesh in meshes(level, &mut dice) {
        for round in 0..4 {
            shuffle_pointers(&mut mesh, &mut dice);
            let mut results = Vec::new();
            for (pair, tally) in pairs.iter_mut().zip(&mut tallies) {
                let mut results_of_op = Vec::new();
                for args in pair.arguments(&mesh) {
                    results_of_op.extend(pair.compare(&mesh, &args, tally));
                }
                if !results_of_op.is_empty() {
                    let pick = dice.below(results_of_op.len());
                    results.push(results_of_op.swap_remove(pick));
                }
            }
            // Onwards from one of the results, but not to meshes that are large.
            results.retain(|result| result.halfedge_count() < 80);
            if results.is_empty() || round == 3 {
                break;
            }
            let pick = dice.below(results.len());
            mesh = results.swap_remove(pick);
        }
    }
    for (op, tally) in OPS.iter().zip(&tallies) {
        println!("{level} {}: {} places, {} applied", op.name, tally.places, tally.applied);
        for (reason, times) in &tally.refused {
            println!("    {times:6} {reason}");
        }
        assert!(tally.places > 100, "{}: only {} places", op.name, tally.places);
        assert!(tally.applied > 0, "{} was never applied", op.name);
    }
    let guards = pairs.iter().zip(&tallies);
    for (pair, tally) in guards {
        for refusal in &pair.guarded.refusals {
            if refusal.phase == Phase::Guard && !tally.refused.contains_key(&refusal.reason) {
                println!("never: {level} {}: {}", pair.op.name, refusal.reason);
            }
        }
    }
}

#[test]
fn surface_guards_are_weakest() {
    battle(Level::Surface);
}

#[test]
fn simple_guards_are_weakest() {
    battle(Level::Simple);
}

/// The ops with other kinds of loops: every way for few loops, some ways for many.
fn variants(op: &Op, dice: &mut Dice) -> Vec<String> {
    const KINDS: [&str; 3] = ["face ", "hole ", "loop "];
    let places: Vec<usize> = (0..op.text.len())
        .filter(|&at| KINDS.iter().any(|kind| op.text[at..].starts_with(kind)))
        .collect();
    let ways = 3_usize.pow(places.len() as u32);
    let mut texts = Vec::new();
    for turn in 0..ways.min(96) {
        let mut way = if ways > 96 { dice.below(ways) } else { turn };
        let mut text = op.text.to_owned();
        for &at in &places {
            text.replace_range(at..at + 5, KINDS[way % 3]);
            way /= 3;
        }
        texts.push(text);
    }
    texts.sort_unstable();
    texts.dedup();
    texts
}

/// A text with a value that some vertices refuse.
fn with_value(text: &str) -> String {
    let end = text.rfind('}').and_then(|end| text[..end].rfind('}')).unwrap();
    format!("{}v0.position = v0.position / v0.position.x }} }}", &text[..end])
}

/// An op that begins at an edge tries both halfedges, or one where both would be refused alike: it
/// does what the op that begins at a halfedge does at the first of them that is not refused.
#[test]
fn an_edge_is_refused_exactly_if_both_halfedges_are() {
    let mut dice = Dice(5);
    let mut done = BTreeMap::<&str, [usize; 2]>::new();
    for level in [Level::Surface, Level::Simple] {
        let meshes = meshes(level, &mut dice);
        let begins = |op: &&Op| !op.two && op.text.contains("edge e: a | ");
        for op in OPS.iter().filter(begins) {
            let mut texts = variants(op, &mut dice);
            while texts.len() > 8 {
                texts.swap_remove(dice.below(texts.len()));
            }
            texts.push(op.text.to_owned());
            let texts = texts.iter().flat_map(|text| [text.clone(), with_value(text)]);
            for text in texts.map(|text| text.replace("GUARD", &format!("guard {level}"))) {
                let of_edge = text.replace("(a: halfedge)", "(e: edge)");
                let plans = [text, of_edge].map(|text| try_compiled(&text));
                let [Some(of_halfedge), Some(of_edge)] = plans else {
                    continue;
                };
                for _ in 0..12 {
                    let mut mesh = meshes[dice.below(meshes.len())].clone();
                    shuffle_pointers(&mut mesh, &mut dice);
                    let apply = |plan: &Plan, id: u32| {
                        let mut result = mesh.clone();
                        let done = Machine::default().apply(&mut result, plan, &[u64::from(id)]);
                        matches!(done.unwrap(), Outcome::Applied { .. }).then_some(result)
                    };
                    for edge in mesh.edges() {
                        let half = mesh.edge_halfedge(edge);
                        let halves = [half, mesh.twin(half)];
                        let wanted = halves.iter().find_map(|half| apply(&of_halfedge, half.0));
                        let got = apply(&of_edge, edge.0);
                        assert_eq!(got.is_some(), wanted.is_some(), "{level} {} {edge}", op.name);
                        let pair = got.as_ref().zip(wanted.as_ref());
                        assert!(pair.is_none_or(|(got, wanted)| identical(got, wanted)));
                        done.entry(op.name).or_default()[usize::from(got.is_some())] += 1;
                    }
                }
            }
        }
    }
    println!("{done:?}");
    assert!(done.len() > 6 && done.values().all(|[refused, applied]| refused.min(applied) > &20));
}

#[test]
fn guards_are_weakest_whatever_the_kinds_of_loops() {
    let mut dice = Dice(99);
    let (mut kept, mut total) = (0, Tally::default());
    for level in [Level::Surface, Level::Simple] {
        let meshes = meshes(level, &mut dice);
        for op in OPS {
            for text in variants(op, &mut dice) {
                let with = |guard: &str| try_compiled(&text.replace("GUARD", guard));
                let (Some(bare), Some(guarded)) = (with(""), with(&format!("guard {level}")))
                else {
                    continue;
                };
                kept += 1;
                let mut pair = Pair { op, level, guarded, bare, machine: Machine::default() };
                for _ in 0..24 {
                    let mesh = &meshes[dice.below(meshes.len())];
                    for args in pair.arguments(mesh) {
                        pair.compare(mesh, &args, &mut total);
                    }
                }
            }
        }
    }
    let refused: usize = total.refused.values().sum();
    println!(
        "{kept} variants: {} places, {} applied, {refused} refused",
        total.places, total.applied
    );
    assert!(kept > 100 && total.applied > 20_000 && refused > 5_000);
}
