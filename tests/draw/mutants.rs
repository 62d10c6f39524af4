//! Whatever is drawn, proved or not, there is a picture, and nothing panics.

use hedgerow::diagram::{NameId, Op, Ref, Rule, Side, Spoke};
use hedgerow::draw::{COLUMNS, draw_op, text_op};

use super::{check_apart, example_ops, ops_of};
use support::dice::Dice;

/// A name of the same kind, so that the diagram is still one the resolver could make.
fn another(rule: &Rule, of: Ref, dice: &mut Dice) -> Ref {
    let names: Vec<NameId> = rule.names_of(rule.kind(of.name)).collect();
    let name = names[dice.below(names.len())];
    Ref { name, ..of }
}

fn mutate(rule: &mut Rule, dice: &mut Dice) {
    let names = rule.clone();
    let is_before = dice.below(2) == 0;
    let side: &mut Side = if is_before { &mut rule.before } else { &mut rule.after };
    let (loops, edges, stars) = (side.loops.len(), side.edges.len(), side.stars.len());
    match dice.below(9) {
        0 if loops > 0 => drop(side.loops.remove(dice.below(loops))),
        1 if edges > 0 => drop(side.edges.remove(dice.below(edges))),
        2 if stars > 0 => drop(side.stars.remove(dice.below(stars))),
        3 if loops > 0 => {
            let orbit = &mut side.loops[dice.below(loops)];
            let at = dice.below(orbit.items.len());
            orbit.items[at].from = another(&names, orbit.items[at].from, dice);
        }
        4 if loops > 0 => {
            let orbit = &mut side.loops[dice.below(loops)];
            let at = dice.below(orbit.items.len());
            orbit.items[at].item = another(&names, orbit.items[at].item, dice);
        }
        5 if edges > 0 => {
            let edge = &mut side.edges[dice.below(edges)];
            edge.halfedges[0] = another(&names, edge.halfedges[0], dice);
        }
        6 if stars > 0 => {
            let star = &mut side.stars[dice.below(stars)];
            star.vertex = another(&names, star.vertex, dice);
            star.spokes.rotate_left(1);
            if let Some(Spoke::Halfedge(spoke)) = star.spokes.first_mut() {
                *spoke = another(&names, *spoke, dice);
            }
        }
        7 if loops > 0 => {
            let orbit = &mut side.loops[dice.below(loops)];
            if orbit.items.len() > 1 {
                orbit.items.remove(dice.below(orbit.items.len()));
            }
        }
        _ => {
            rule.created.truncate(dice.below(4));
            rule.erased.truncate(dice.below(4));
        }
    }
}

#[test]
fn every_mutant_has_a_picture() {
    let mut dice = Dice(20_260_729);
    let mut drawn = 0;
    let ops: Vec<Op> = example_ops().into_iter().map(|(_, op)| op).collect();
    for round in 0..180 {
        let mut op = ops[round % ops.len()].clone();
        for rule in &mut op.rules {
            for _ in 0..1 + round % 5 {
                mutate(rule, &mut dice);
            }
        }
        let picture = draw_op(&op);
        let [width, height] = picture.size();
        // Families are drawn as four of each.
        let families = op.rules.iter().any(Rule::has_families);
        let widest = if families { 80_000.0 } else { 20_000.0 };
        assert!(width.is_finite() && height.is_finite() && width < widest);
        assert!(!picture.svg().contains("NaN"));
        assert!(!text_op(&op, COLUMNS).is_empty());
        drawn += 1;
    }
    assert_eq!(drawn, 180);
}

#[test]
fn odd_patterns_have_pictures() {
    let text = "
        op lens(a: halfedge) {
          before { face f: u -a-> w -b-> u }
          after { face f: u -a-> w -b-> u }
        }
        op at_one_vertex(a: halfedge) {
          before { face f: u -a-> u }
          after { face f: u -a-> u }
        }
        op bow(a: halfedge) {
          before {
            face f: u -a-> v -b-> w -c-> u
            face g: u -d-> x -e-> y -k-> u
          }
          after {
            face f: u -a-> v -b-> w -c-> u
            face g: u -d-> x -e-> y -k-> u
          }
        }
        op apart(a: halfedge, d: halfedge) {
          before {
            face f: u -a-> v -b-> w -c-> u
            hole g: x -d-> y -e-> z -k-> x
          }
          after {
            face f: u -a-> v -b-> w -c-> u
            hole g: x -d-> y -e-> z -k-> x
          }
        }
        op pillow(e: edge) {
          before {
            face f: u -a-> v -b-> w -c-> u
            hole g: v -d-> u -x-> w -y-> v
            edge e: a | d   edge e1: b | y   edge e2: c | x
          }
          after {
            face f: u -a-> v -b-> w -c-> u
            hole g: v -d-> u -x-> w -y-> v
            edge e: a | d   edge e1: b | y   edge e2: c | x
          }
        }
        op star(v: vertex) { before { vertex v: a *S b *T } after { vertex v: a *S b *T } }
        op accents(é: halfedge) {
          before { face ñ: u -é-> u }
          after { face ñ: u -é-> u }
        }
        op nothing(v: vertex) { before { } after { } }
    ";
    let ops = ops_of(text);
    assert!(ops.len() >= 8, "only {} operations were read", ops.len());
    for op in ops {
        let picture = draw_op(&op);
        assert!(picture.size().iter().all(|side| side.is_finite()), "{}", op.name);
        assert!(!picture.svg().contains("NaN"), "{}", op.name);
        check_apart(picture.texts(), &op.name);
        if let Some(folder) = std::env::var_os("PICTURES") {
            let path = std::path::Path::new(&folder).join(format!("odd-{}.png", op.name));
            std::fs::write(path, picture.png(2.0).expect("small enough")).expect("a folder");
        }
        assert!(!text_op(&op, COLUMNS).is_empty());
    }
}
