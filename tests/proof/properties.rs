//! What operations keep: inferred for each, held against what `keeps` declares.

use hedgerow::analysis::{Analysis, RuleVerdict, verdicts};
use hedgerow::source::Sources;

fn analyse(text: &str) -> Analysis {
    let mut sources = Sources::new();
    let file = sources.add("test", text);
    Analysis::of(&sources, file)
}

fn verdict(text: &str) -> RuleVerdict {
    let analysis = analyse(text);
    assert!(analysis.is_sound(), "{:?}", analysis.diagnostics);
    verdicts(&analysis)[0].rules[0].clone()
}

const DISSOLVE: &str = "op dissolve(e: edge) KEEPS {
  before {
    face f0: v0 -a-> v1 =P=> v0
    face f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  after {
    face f0: v1 =P=> v0 =Q=> v1
    erase e a d f1
  }
}";

#[test]
fn a_flip_keeps_everything_but_walks_to_know_it() {
    let flip = verdict(include_str!("../../examples/flip.hedge"));
    assert_eq!(flip.keeps, ["triangles", "euler", "boundary", "surface", "simple"]);
    assert_eq!(flip.grows_with, ["the degree of `v2`"]);
    let degrees: Vec<_> = flip.degrees.iter().map(|(v, by)| format!("{v} {by}")).collect();
    assert_eq!(degrees, ["v0 -1", "v1 -1", "v2 +1", "v3 +1"]);
}

#[test]
fn degrees_of_names_that_may_be_one_are_said_to_vary() {
    let flip = verdict(
        "op flip(e: edge) {
           before {
             face f0: v0 -a-> v1 -b-> v2 =P=> v0
             face f1: v1 -d-> v0 -g-> v3 =Q=> v1
             edge e: a | d
           }
           alias v2 v3
           after {
             face f0: v3 -a-> v2 =P=> v0 -g-> v3
             face f1: v2 -d-> v3 =Q=> v1 -b-> v2
             edge e: a | d
           }
         }",
    );
    let degrees: Vec<_> = flip.degrees.iter().map(|(v, by)| format!("{v} {by}")).collect();
    let varies = ["v2 +1 where no names are one", "v3 +1 where no names are one"];
    assert_eq!(degrees, [["v0 -1", "v1 -1"], varies].concat());
    assert!(flip.sizes.is_empty(), "{:?}", flip.sizes);
}

#[test]
fn lengths_of_paths_follow_from_their_faces() {
    let dissolve = verdict(&DISSOLVE.replace("KEEPS", "keeps euler, boundary"));
    assert_eq!(dissolve.keeps, ["euler", "boundary"]);
    assert_eq!(dissolve.sizes["f0"], "-1 +Q");
    // Two triangles make a quad.
    let analysis = analyse(&DISSOLVE.replace("KEEPS", "keeps triangles"));
    let [problem] = analysis.diagnostics.as_slice() else {
        panic!("one diagnostic, not {:?}", analysis.diagnostics)
    };
    assert_eq!(problem.code, "property-not-kept");
    assert_eq!(problem.notes, ["`f0` would have 4 sides, if all faces have 3 before"]);
    assert!(analysis.plans[0].is_none(), "a broken claim does not run");
}

#[test]
fn time_that_grows_is_told() {
    let analysis = analyse(&DISSOLVE.replace("KEEPS", "keeps constant_time"));
    assert_eq!(analysis.diagnostics[0].notes, ["its time grows with the length of `Q`"]);
}

#[test]
fn a_hole_that_gains_a_vertex_does_not_keep_the_boundary() {
    let split = analyse(include_str!("../../examples/split.hedge"));
    let rules = &verdicts(&split)[0].rules;
    assert!(rules[0].keeps.contains(&"boundary"));
    assert!(!rules[1].keeps.contains(&"boundary"));
}

#[test]
fn unknown_properties_are_suggested() {
    let analysis = analyse(&DISSOLVE.replace("KEEPS", "keeps eular"));
    assert_eq!(analysis.diagnostics[0].code, "unknown-property");
    assert!(analysis.diagnostics[0].fixes.iter().any(|fix| fix.edits[0].text == "euler"));
}

#[test]
fn an_op_with_a_part_that_cannot_be_read_does_not_run() {
    let broken =
        DISSOLVE.replace("KEEPS", "").replace("  after {", "  require degree( > 2\n  after {");
    let analysis = analyse(&format!("{broken}\n{}", include_str!("../../examples/flip.hedge")));
    assert!(!analysis.is_sound());
    let dissolve = analysis.op("dissolve").expect("its name is known");
    assert!(analysis.plans[dissolve].is_none(), "its `require` is lost");
    let flip = analysis.op("flip").expect("the next op is untouched");
    assert!(analysis.plans[flip].is_some());
}

#[test]
fn a_loop_of_after_stays_what_before_draws() {
    let text = |before: &str, after: &str| {
        format!(
            "op bisect(e: edge) {{
               before {{
                 {before} f: v0 -a-> v1 =P=> v0
                 {before} g: v1 -d-> v0 =Q=> v1
                 edge e: a | d
               }}
               after {{
                 new m p q k
                 {after} f: v0 -a-> m -p-> v1 =P=> v0
                 {after} g: v1 -d-> m -q-> v0 =Q=> v1
                 edge e: a | q
                 edge k: p | d
                 m.position = midpoint(e)
               }}
             }}"
        )
    };
    let said = verdict(&text("face", "loop"));
    assert!(said.turned.is_empty(), "{:?}", said.turned);
    assert_eq!(said, verdict(&text("face", "face")));
    assert_eq!(verdict(&text("face", "hole")).turned.len(), 2);
}
