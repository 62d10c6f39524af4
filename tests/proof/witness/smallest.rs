//! "The smallest mesh that breaks", held against all meshes that are smaller.
//!
//! The reference matches and rewrites on every map of up to four edges, connected or not. None
//! may break that has fewer halfedges than the one that is shown.
//!
//! `HEDGEROW_MUTANTS` sets how many ops are looked at, `HEDGEROW_SEED` gives others.

use std::collections::{BTreeMap, HashSet};

use hedgerow::check::{Outcome, examine};
use hedgerow::diagram::{Kind, LoopKind, Op, Rule};
use hedgerow::mesh::{Level, Mesh, validate, validate_level};

use crate::witness::confirmed::{bases, number, read_back};
use support::reference::maps::mesh_of;
use support::reference::matching::matches;
use support::reference::mutating::mutate;
use support::reference::printing::op_text;
use support::reference::random::Random;
use support::reference::rewriting::rewrite;

/// Ops with paths and fans, which fit into few halfedges.
const OPS: &str = "
op flip_any(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 =P=> v0
    face f1: v1 -d-> v0 -g-> v3 =Q=> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 =P=> v0 -g-> v3
    face f1: v2 -d-> v3 =Q=> v1 -b-> v2
    edge e: a | d
  }
}
op contract(e: edge) -> v0 {
  before {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
    vertex v1: d *S
  }
  after {
    loop f0: v0 =P=> v0
    loop f1: v0 =Q=> v0
    vertex v0: * *S
    erase v1 e a d
  }
}
op dissolve(e: edge) {
  before {
    face f0: v0 -a-> v1 =P=> v0
    face f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  after {
    face f0: v0 =Q=> v1 =P=> v0
    erase e a d f1
  }
}
op spoke(h: halfedge) {
  before { loop f: u -h-> v =P=> u }
  after {
    new m p q e
    loop f: u -h-> v -p-> m -q-> v =P=> u
    edge e: p | q
    m.position = u.position
  }
}
";

#[test]
fn no_smaller_mesh_breaks() {
    let count = number("HEDGEROW_MUTANTS").unwrap_or(150);
    let mut random = Random::new(number("HEDGEROW_SEED").unwrap_or(1) as u64);
    let mut small: Vec<Op> = bases();
    small.retain(|op| names(&op.rules[0], Kind::Halfedge) < 5);
    for text in OPS.split("\nop ").skip(1) {
        let op = read_back(&format!("op {text}")).expect("an op");
        assert!(examine(&op).is_ok(), "{text}");
        small.extend([op.clone(), op.clone(), op]);
    }
    let maps = maps(8);
    assert!(maps.len() > 150, "{} maps", maps.len());
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    let mut looked_at = 0;
    while looked_at < count {
        let mut op = random.pick(&small).unwrap().clone();
        if (0..1 + random.below(2)).any(|_| mutate(&mut op, &mut random).is_none()) {
            continue;
        }
        let text = op_text(&op, &op.rules[0]);
        let Some(op) = read_back(&text) else {
            continue;
        };
        let rule = &op.rules[0];
        if !rule.aliases.is_empty() {
            // Where names are one, a smaller mesh may break, and none is called smallest.
            continue;
        }
        let Err(rejection) = examine(&op) else {
            continue;
        };
        let Outcome::Breaks(example) = &rejection.outcomes[0] else {
            continue;
        };
        looked_at += 1;
        let size = example.before.halfedge_count();
        *counts.entry(format!("{:?} {size}", example.smallest_of)).or_insert(0) += 1;
        let Some(level) = example.smallest_of else {
            continue;
        };
        assert_eq!(validate_level(&example.before, level), Ok(()), "{text}");
        let smaller = maps.iter().filter(|map| map.halfedge_count() < size);
        let smaller = smaller.flat_map(|map| with_holes(map, rule, level));
        let of_level = |mesh: &Mesh| validate_level(mesh, level).is_ok();
        let broken = smaller.filter(of_level).find(|mesh| breaks(rule, mesh));
        if let Some(mesh) = broken {
            let found = mesh.halfedge_count();
            wrong.push(format!("{level} {size}, but {found}: {mesh:?}\n{text}"));
        }
    }
    println!("{counts:#?}");
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    let unknown: usize =
        counts.iter().filter(|(word, _)| word.starts_with("None")).map(|(_, count)| count).sum();
    assert!(unknown * 10 < count, "{counts:?}");
}

fn names(rule: &Rule, kind: Kind) -> usize {
    rule.names_of(kind).count()
}

fn breaks(rule: &Rule, mesh: &Mesh) -> bool {
    let found = matches(rule, mesh, &[], 400);
    found.iter().filter_map(|at| rewrite(rule, mesh, at)).any(|it| validate(&it.mesh).is_err())
}

/// A map whose loops are faces, and where it matters, all ways in which some are holes.
fn with_holes(map: &Mesh, rule: &Rule, level: Level) -> Vec<Mesh> {
    let draws_holes = rule.before.loops.iter().any(|orbit| orbit.kind == LoopKind::Hole);
    let draws_holes = draws_holes || level > Level::Map;
    let faces: Vec<_> = map.faces().collect();
    let ways = if draws_holes { 1 << faces.len() } else { 1_usize };
    let way = |way: usize| {
        let mut mesh = map.clone();
        for (at, &face) in faces.iter().enumerate() {
            mesh.set_hole(face, way >> at & 1 == 1);
        }
        mesh
    };
    (0..ways).map(way).collect()
}

/// All maps of up to so many halfedges, each once, without holes.
fn maps(most: usize) -> Vec<Mesh> {
    let mut maps = Vec::new();
    for count in (2..=most).step_by(2) {
        let renumberings: Vec<_> =
            orders(count).into_iter().filter(|order| keeps_twins(order)).collect();
        let mut seen: HashSet<Vec<usize>> = HashSet::new();
        for next in orders(count) {
            if seen.contains(&next) {
                continue;
            }
            for order in &renumberings {
                let mut same = vec![0; count];
                (0..count).for_each(|half| same[order[half]] = order[next[half]]);
                seen.insert(same);
            }
            let twin: Vec<_> = (0..count).map(|half| half ^ 1).collect();
            maps.push(mesh_of(&next, &twin, &mut |_| false));
        }
    }
    maps
}

fn keeps_twins(order: &[usize]) -> bool {
    (0..order.len()).all(|half| order[half ^ 1] == order[half] ^ 1)
}

/// All orders of so many numbers.
fn orders(count: usize) -> Vec<Vec<usize>> {
    let mut orders = vec![Vec::new()];
    for number in 0..count {
        let longer = orders.into_iter().flat_map(|order: Vec<usize>| {
            (0..=order.len()).map(move |at| {
                let mut order = order.clone();
                order.insert(at, number);
                order
            })
        });
        orders = longer.collect();
    }
    orders
}
