//! Pictures of counterexamples: they show what is broken as it is.

use hedgerow::analysis::Analysis;
use hedgerow::diagram::Op;
use hedgerow::draw::{draw_op, fates};
use hedgerow::source::Sources;

use super::check_apart;

/// The first counterexample of a program, as an operation.
fn counterexample(program: &str) -> Op {
    let mut sources = Sources::new();
    let file = sources.add("broken.hedge".to_string(), program.to_string());
    Analysis::of(&sources, file).counterexamples[0].drawn()
}

/// A flip of an edge between two triangles, with what it draws after.
fn flip(after: &str) -> String {
    format!(
        "op flip(e: edge) {{
          before {{
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e: a | d
          }}
          after {{ {after} }}
        }}"
    )
}

/// Checks what becomes of names in the first counterexample of a program, and what its picture says.
fn check(program: &str, fates_of: &[(&str, &str)], verdict: &str, tell: &[&str]) {
    let op = counterexample(program);
    let rule = fates(&op.rules[0]);
    for (name, fate) in fates_of {
        assert_eq!(rule.get(name), Some(fate), "{name}: {rule:?}");
    }
    let picture = draw_op(&op);
    let texts = picture.texts();
    for told in tell.iter().chain([&verdict]) {
        assert!(texts.iter().any(|text| text.text == *told), "`{told}` is not in the picture");
    }
    check_apart(texts, verdict);
    // What is broken is seen best where it was whole: a vertex has its name at one height.
    let heights = texts.iter().filter(|text| text.text == "v0").map(|text| text.from[1]);
    let [before, after] = heights.collect::<Vec<_>>()[..] else {
        panic!("v0 does not stand on both sides: {texts:?}");
    };
    assert!((before - after).abs() < 2.0, "v0 moves from {before} to {after}");
}

#[test]
fn halfedges_that_were_forgotten_are_kept() {
    let program = flip(
        "face f0: v3 -a-> v2 -c-> v0 -g-> v3 \
         edge e: a | d",
    );
    let fates = [
        ("a", "reassigned"),
        ("b", "kept"),
        ("c", "reassigned"),
        ("d", "kept"),
        ("g", "reassigned"),
        ("h", "kept"),
    ];
    check(&program, &fates, "b.next is c, but c.prev is a", &["hole 2", "f0", "f1"]);
}

#[test]
fn what_points_at_an_erased_halfedge_is_kept() {
    let program = "
        op erase_face(f: face) {
          before { face f: v0 -a-> v1 -b-> v2 -x-> v0 }
          after { erase f a b x }
        }";
    let fates = [("a", "erased"), ("f", "erased"), ("3", "kept"), ("v0", "kept")];
    check(program, &fates, "the twin of the undrawn twin of a is a, which is erased", &["hole 1"]);
}

#[test]
fn what_a_new_halfedge_lacks_is_told() {
    let program = "
        op split(e: edge) -> m {
          before {
            loop f0: v0 -a-> v1 =P=> v0
            loop f1: v1 -d-> v0 =Q=> v1
            edge e: a | d
          }
          after {
            new m p q
            loop f0: v0 -a-> m -p-> v1 =P=> v0
            loop f1: v1 -d-> m -q-> v0 =Q=> v1
            edge e: a | q
            m.position = (v0.position + v1.position) / 2
          }
        }";
    check(program, &[("p", "new"), ("m", "new"), ("a", "reassigned")], "p.twin is not set", &["m"]);
}

/// The loops on both sides of what was one edge do not cover each other.
#[test]
fn an_edge_that_comes_apart_leaves_its_loops_whole() {
    let program = "
        op flip(e: edge) {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e:  a | d
            edge eb: b | b'
            edge ec: c | c'
            edge eg: g | g'
            edge eh: h | h'
          }
          after {
            face f0: v3 -a-> v2 -b-> v0 -c-> v3
            face f1: v2 -d-> v3 -g-> v1 -h-> v2
            edge e:  a | d
            edge eb: h | b'
            edge ec: b | c'
            edge eh: g | h'
          }
        }";
    let picture = draw_op(&counterexample(program));
    assert_eq!(picture.crossings(), 0);
    // Those of `after` come last.
    let texts = picture.texts();
    let at = |name: &str| texts.iter().rfind(|text| text.text == name).map(|text| text.from[0]);
    let [outer, inner, a] = ["g'", "c", "a"].map(|name| at(name).expect("a name of `after`"));
    assert!(outer < inner && inner < a, "{outer}, {inner}, {a}");
}

/// The names of faces whose loops do not close in the picture stand at their own halfedges.
#[test]
fn faces_that_come_apart_have_their_names_inside() {
    let program = "
        op split(e: edge) -> m {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e: a | d
          }
          after {
            new m p q r s t u e1 e2 e3 f2 f3
            face f0: v0 -a-> m -p-> v2 -c-> v0
            face f2: m -q-> v1 -b-> v2 -r-> m
            face f1: v1 -d-> m -s-> v3 -h-> v1
            face f3: m -t-> v0 -g-> v3 -u-> m
            edge e: a | d
            edge e1: q | t
            edge e2: p | r
            edge e3: s | u
            m.position = midpoint(e)
          }
        }";
    let picture = draw_op(&counterexample(program));
    let texts = picture.texts();
    let at = |name: &str| {
        let text = texts.iter().rfind(|text| text.text == name);
        text.map(|text| text.from).unwrap_or_else(|| panic!("`{name}` is not in the picture"))
    };
    let [f0, f1, f2, f3] = ["f0", "f1", "f2", "f3"].map(at);
    let (left, right, top, bottom) = (at("v0")[0], at("v1")[0], at("v2")[1], at("v3")[1]);
    let middle = [(left + right) / 2.0, (top + bottom) / 2.0];
    let within = |[x, y]: [f64; 2], is_left: bool, is_above: bool| {
        let across = if is_left { left..middle[0] } else { middle[0]..right };
        let down = if is_above { top..middle[1] } else { middle[1]..bottom };
        across.contains(&x) && down.contains(&y)
    };
    assert!(within(f0, true, true) && within(f2, false, true), "{f0:?} {f2:?}");
    assert!(within(f3, true, false) && within(f1, false, false), "{f3:?} {f1:?}");
}

/// Where `next` leads from one face into another, both have their halfedges and their names.
#[test]
fn faces_that_run_into_each_other_are_both_named() {
    let program = flip(
        "face f0: v3 -a-> v2 -b-> v0 -g-> v3 \
         face f1: v2 -d-> v3 -h-> v1 -b-> v2 \
         edge e: a | d",
    );
    let picture = draw_op(&counterexample(&program));
    for face in ["f0", "f1"] {
        let many = picture.texts().iter().filter(|text| text.text == face).count();
        assert_eq!(many, 2, "{face}");
    }
}
