//! Pictures in which loops with paths meet, and the distances of vertices in all pictures.

use std::fs;

use hedgerow::diagram::Op;
use hedgerow::draw::draw_op;

use super::{folder, ops_of, overlap, shipped_ops};

/// The least distance between two vertices, and the greatest width of a drawing.
const APART: f64 = 90.0;
const WIDEST: f64 = 900.0;

fn loops() -> Vec<Op> {
    let text = fs::read_to_string(folder("tests/draw/loops.hedge")).expect("the operations");
    let ops = ops_of(&text);
    assert_eq!(ops.len(), 14);
    ops
}

/// The groups of the elements of a kind in an SVG, each with its id.
fn groups<'s>(svg: &'s str, kind: &str) -> Vec<(&'s str, &'s str)> {
    let groups = svg.split("<g id=\"").skip(1);
    let parts = groups.filter_map(|group| {
        let (id, rest) = group.split_once('"')?;
        let (title, shapes) = rest.split_once("</title>")?;
        title.contains(&format!("<title>{kind} ")).then_some((id, shapes))
    });
    parts.filter_map(|(id, shapes)| Some((id, shapes.split_once("</g>")?.0))).collect()
}

/// The side of a rule that an id belongs to.
fn side(id: &str) -> &str {
    let name =
        ["-before-", "-after-"].into_iter().find_map(|word| Some(id.find(word)? + word.len()));
    &id[..name.unwrap_or(0)]
}

/// The place where the dot of a vertex begins, which is beside its center.
fn dot(shapes: &str) -> Option<[f64; 2]> {
    let steps = shapes.split_once(" d=\"m")?.1;
    let steps = steps.split_once(|step: char| step.is_ascii_alphabetic())?.0;
    let minus = steps.replace('-', " -");
    let mut numbers = minus.split_ascii_whitespace().map(|number| number.parse().expect(steps));
    Some([numbers.next()?, numbers.next()?])
}

/// The distance of each pair of vertices on one side.
fn distances(svg: &str) -> Vec<(String, f64)> {
    let dots = groups(svg, "vertex").into_iter();
    let dots: Vec<_> = dots.filter_map(|(id, shapes)| Some((id, dot(shapes)?))).collect();
    let mut all = Vec::new();
    for (at, (a, from)) in dots.iter().enumerate() {
        for (b, to) in dots[..at].iter().filter(|(b, _)| side(a) == side(b)) {
            all.push((format!("{a} and {b}"), (from[0] - to[0]).hypot(from[1] - to[1])));
        }
    }
    all
}

/// The pairs of vertices of one side that lie too near to each other.
fn near(svg: &str) -> Vec<String> {
    let near = distances(svg).into_iter().filter(|(_, distance)| *distance < APART);
    near.map(|(pair, distance)| format!("{pair} are {distance:.0} apart")).collect()
}

#[test]
fn loops_that_meet_can_be_read() {
    for op in loops() {
        let (picture, name) = (draw_op(&op), &op.name);
        assert_eq!(picture.crossings(), 0, "{name}");
        let [width, _] = picture.size();
        // Two triangles that are joined stand side by side.
        let drawings = if name == "bridge" { 3.0 } else { 2.0 };
        assert!(width < drawings * WIDEST, "{name} is {width} wide");
        let svg = picture.svg();
        assert_eq!(near(&svg), Vec::<String>::new());
        // A loop that is turned inside out has no area.
        let loops = groups(&svg, "face");
        assert!(!loops.is_empty(), "{name}");
        for (id, shapes) in loops {
            // A hole is hatched.
            let area = ["fill-face", "stroke-muted"];
            assert!(area.iter().any(|class| shapes.contains(class)), "{id} has no area");
        }
        let texts = picture.texts();
        for (at, a) in texts.iter().enumerate() {
            let covered = texts[..at].iter().find(|b| overlap(a, b));
            assert_eq!(covered, None, "{name}: `{}` covers a text", a.text);
        }
    }
}

#[test]
fn no_two_vertices_are_near() {
    let mut seen = 0;
    for (stem, op) in shipped_ops() {
        let svg = draw_op(&op).svg();
        seen += groups(&svg, "vertex").iter().filter(|(_, shapes)| dot(shapes).is_some()).count();
        assert_eq!(near(&svg), Vec::<String>::new(), "{stem}");
    }
    assert!(seen > 300, "only {seen} vertices");
}

/// Siblings have places of their own: spurs, edges from a vertex to itself, a hole in a face.
#[test]
fn what_hangs_at_a_vertex_lies_apart() {
    let ops = ops_of(
        "op spurs(e: edge) {
          before {
            face f: v0 -a-> v1 -b-> v0 -c-> v2 -d-> v0 -s-> v3 -t-> v0 =P=> v0
            edge e: a | b
            edge g: c | d
            edge h: s | t
          }
          after {
            face f: v0 =P=> v0
            erase e g h a b c d s t v1 v2 v3
          }
        }
        op monogons(e: edge) {
          before {
            face f: v -a-> v -b-> v =P=> v
            face g: v -a'-> v
            face h: v -b'-> v
            edge e: a | a'
            edge k: b | b'
          }
          after {
            face f: v =P=> v
            erase a b a' b' g h e k
          }
        }
        op tree(f: face, a: halfedge) {
          before {
            face f: v0 -a-> v1 -b-> v2 -c-> v3 -d-> v0
          }
          after {
            new m n o p0 q0 e0 p1 q1 e1 p2 q2 e2
            face f: v0 -p0-> m -p1-> n -q1-> m -p2-> o -q2-> m -q0-> v0 -a-> v1 -b-> v2 -c-> v3 -d-> v0
            edge e0: p0 | q0
            edge e1: p1 | q1
            edge e2: p2 | q2
            m.position = v0.position
            n.position = v1.position
            o.position = v1.position
          }
        }
        op hole_in_a_face(h: halfedge) {
          before {
            face f: v0 -h-> v1 -b-> v2 -c-> v0 -p-> w0 -x-> w1 -y-> w2 -z-> w0 -q-> v0
            edge e: p | q
          }
          after {
            face f: v0 -h-> v1 -p-> w0 -x-> w1 -y-> w2 -z-> w0 -q-> v1 -b-> v2 -c-> v0
            edge e: p | q
          }
        }",
    );
    assert_eq!(ops.len(), 4);
    for op in ops {
        let picture = draw_op(&op);
        assert_eq!(picture.crossings(), 0, "{}", op.name);
        let svg = picture.svg();
        for (pair, distance) in distances(&svg) {
            assert!(distance > 40.0, "{pair} are {distance:.0} apart");
        }
        let faces: Vec<_> = groups(&svg, "face").into_iter().map(|(_, shapes)| shapes).collect();
        let same = |at: usize| faces[..at].contains(&faces[at]);
        assert!(!(0..faces.len()).any(same), "{}: two faces in one place", op.name);
    }
}

#[test]
fn no_vertex_moves_onto_another() {
    let ops = ops_of(
        "op corner(f: face, a: halfedge) {
          before { face f: v0 -a-> v1 -b-> v2 -c-> v3 -d-> v0 }
          after {
            keep f
            v1.position = v0.position
          }
        }
        op chain(e: edge) {
          before {
            face f: v0 -a-> v1 -b-> v2 -y-> v1 -d-> v0 =P=> v0
            edge e: a | d
            edge k: b | y
          }
          after {
            keep f e k
            v2.position = v1.position
          }
        }",
    );
    for op in ops {
        assert_eq!(near(&draw_op(&op).svg()), Vec::<String>::new(), "{}", op.name);
    }
}

/// A triangle with a triangle at each side is a hexagon, whatever the op is called with.
#[test]
fn a_regular_figure_remains_regular() {
    let ops = ops_of(
        "op merge(f: face, a: halfedge) {
          before {
            face f: v0 -a-> v1 -b-> v2 -c-> v0
            face f0: v1 -a'-> v0 -x-> w0 -y-> v1
            face f1: v2 -b'-> v1 -p-> w1 -q-> v2
            face f2: v0 -c'-> v2 -r-> w2 -s-> v0
            edge ea: a | a'
            edge eb: b | b'
            edge ec: c | c'
          }
          after {
            face f: v0 -x-> w0 -y-> v1 -p-> w1 -q-> v2 -r-> w2 -s-> v0
            erase f0 f1 f2 a b c a' b' c' ea eb ec
          }
        }",
    );
    let distances = distances(&draw_op(&ops[0]).svg());
    let of = |stem: &str| {
        let pairs = distances.iter().filter(|(pair, _)| pair.matches(stem).count() == 2);
        pairs.map(|(_, distance)| *distance).collect::<Vec<_>>()
    };
    for around in [of("before-v"), of("before-w")] {
        assert_eq!(around.len(), 3);
        assert!(around.iter().all(|far| (far - around[0]).abs() < 1.0), "{around:?}");
    }
}

#[test]
fn between_two_edges_remains_room_for_a_face() {
    let ops = ops_of(
        "op zip(e: edge) {
          before {
            face f: v0 -a-> v1 -b-> v0
            face g: v1 -a'-> v0 -p-> w -q-> v1
            face h: v0 -b'-> v1 -r-> u -s-> v0
            edge e: a | a'
            edge k: b | b'
          }
          after {
            face g: v1 -a'-> v0 -p-> w -q-> v1
            face h: v0 -b'-> v1 -r-> u -s-> v0
            edge e: a' | b'
            erase f a b k
          }
        }",
    );
    let picture = draw_op(&ops[0]);
    let texts = picture.texts();
    let height = |name: &str| texts.iter().find(|text| text.text == name).map(|text| text.from[1]);
    let apart = height("e").zip(height("k")).map(|(e, k)| (e - k).abs());
    assert!(apart.is_some_and(|apart| apart > 80.0), "{apart:?}");
}

/// A name beside a slanted arrow lies on one side of it.
#[test]
fn long_names_do_not_cover_their_own_arrows() {
    let ops = ops_of(
        "op turn(e: edge) {
          before {
            face upper: start -along_edge-> end -right_to_top-> top -top_to_left-> start
            face lower: end -back_along-> start -left_to_low-> low -low_to_right-> end
            edge e: along_edge | back_along
          }
          after {
            face upper: low -along_edge-> top -top_to_left-> start -left_to_low-> low
            face lower: top -back_along-> low -low_to_right-> end -right_to_top-> top
            edge e: along_edge | back_along
          }
        }",
    );
    let picture = draw_op(&ops[0]);
    let svg = picture.svg();
    let dots = groups(&svg, "vertex");
    let dot = |name: &str| {
        let mut found = dots.iter().filter(|(id, _)| id.ends_with(&format!("before-{name}")));
        found.find_map(|(_, shapes)| dot(shapes)).expect("a vertex")
    };
    for (name, from, to) in [
        ("right_to_top", "end", "top"),
        ("top_to_left", "top", "start"),
        ("left_to_low", "start", "low"),
        ("low_to_right", "low", "end"),
    ] {
        let ([ax, ay], [bx, by]) = (dot(from), dot(to));
        let mut texts = picture.texts().iter();
        let text = texts.find(|text| text.text == name).expect("a name");
        let corners = [text.from, [text.to[0], text.from[1]], text.to, [text.from[0], text.to[1]]];
        let side = |[x, y]: [f64; 2]| (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0;
        assert!(corners.iter().all(|&at| side(at) == side(corners[0])), "{name}: {text:?}");
    }
}
