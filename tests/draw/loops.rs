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

/// The pairs of vertices of one side that lie too near to each other.
fn near(svg: &str) -> Vec<String> {
    let dots = groups(svg, "vertex").into_iter();
    let dots: Vec<_> = dots.filter_map(|(id, shapes)| Some((id, dot(shapes)?))).collect();
    let mut near = Vec::new();
    for (at, (a, from)) in dots.iter().enumerate() {
        for (b, to) in dots[..at].iter().filter(|(b, _)| side(a) == side(b)) {
            let distance = (from[0] - to[0]).hypot(from[1] - to[1]);
            if distance < APART {
                near.push(format!("{a} lies {distance:.0} from {b}"));
            }
        }
    }
    near
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
