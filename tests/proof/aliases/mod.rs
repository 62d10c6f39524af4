//! Names that are one: what `check --aliases` says is held against small meshes, and an op with
//! `alias` must do there what the literal rewrite does.
//!
//! The reference shares nothing with the checker; it matches by trying everything, with names
//! as one wherever they may be.

mod applied;
mod closed;
mod commands;
mod verdicts;

use hedgerow::analysis::Analysis;
use hedgerow::diagram::{Kind, NameId, Op, Rule};
use hedgerow::mesh::Mesh;
use hedgerow::source::Sources;

use support::reference::examples::elements;
use support::reference::maps::random_map;
use support::reference::matching::Match;
use support::reference::random::Random;

/// The rules that are looked at, each as an op of its own that requires nothing.
fn rules() -> Vec<(Sources, Op)> {
    let texts = [
        include_str!("ops.hedge"),
        include_str!("../../../examples/flip.hedge"),
        include_str!("../../../examples/contract.hedge"),
        include_str!("../../../examples/collapse.hedge"),
        include_str!("../../../examples/dissolve.hedge"),
    ];
    let mut all = Vec::new();
    for text in texts {
        let mut sources = Sources::new();
        let file = sources.add("ops", text);
        let analysis = Analysis::of(&sources, file);
        let told = analysis.diagnostics.iter().map(|told| &told.message);
        assert!(analysis.is_sound(), "{:?}", told.collect::<Vec<_>>());
        let ops = analysis.program.ops.into_iter();
        for op in ops.filter_map(|op| op.diagram) {
            for rule in &op.rules {
                let mut alone = op.clone();
                let mut rule = rule.clone();
                rule.requires.clear();
                rule.result = None;
                alone.keeps.clear();
                alone.result = None;
                let params = 0..op.params.len();
                let kept: Vec<_> = params.filter(|&at| op.params[at].ty.is_element()).collect();
                alone.params = kept.iter().map(|&at| op.params[at].clone()).collect();
                rule.params = kept.iter().map(|&at| rule.params[at]).collect();
                alone.rules = vec![rule];
                all.push((sources.clone(), alone));
            }
        }
    }
    all
}

/// Small random maps, many of them degenerate: loops of one halfedge, edges that end where they
/// begin.
fn maps(count: usize, seed: u64) -> Vec<Mesh> {
    let mut random = Random::new(seed);
    let map = |_| random_map(2 + 2 * random.below(6), &mut random);
    (0..count).map(map).collect()
}

/// All choices of the arguments.
fn places(op: &Op, mesh: &Mesh) -> Vec<Vec<u32>> {
    let mut places = vec![Vec::new()];
    for param in &op.params {
        let choices = elements(mesh, param.ty);
        let longer = places.iter().flat_map(|place: &Vec<u32>| {
            let with = |&choice: &u32| [place.as_slice(), &[choice]].concat();
            choices.iter().map(with).collect::<Vec<_>>()
        });
        places = longer.collect();
    }
    places
}

/// The names that are one in a match, set by set, without edges.
fn one_in(rule: &Rule, at: &Match) -> Vec<Vec<NameId>> {
    let mut classes: Vec<Vec<NameId>> = Vec::new();
    for kind in [Kind::Vertex, Kind::Halfedge, Kind::Face] {
        let names: Vec<_> = rule.names_of(kind).collect();
        for (place, &name) in names.iter().enumerate() {
            let Some(element) = at.elements[name.index()] else {
                continue;
            };
            let is_it = |other: &&NameId| at.elements[other.index()] == Some(element);
            if names[..place].iter().any(|other| is_it(&other)) {
                continue;
            }
            let class: Vec<_> = names.iter().filter(is_it).copied().collect();
            if class.len() > 1 {
                classes.push(class);
            }
        }
    }
    classes.sort_unstable();
    classes
}

/// `v0 = v2, a = b`
fn words(rule: &Rule, classes: &[Vec<NameId>]) -> String {
    let word = |name: &NameId| rule.name(*name).text.clone();
    let class = |class: &Vec<NameId>| class.iter().map(word).collect::<Vec<_>>().join(" = ");
    classes.iter().map(class).collect::<Vec<_>>().join(", ")
}
