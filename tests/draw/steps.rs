//! Operations in steps, shown by example.

use std::fs;
use std::sync::LazyLock;

use hedgerow::analysis::{Analysis, NoExample, Nowhere, example};
use hedgerow::diagram::Op;
use hedgerow::draw::{COLUMNS, draw_op, text_op};
use hedgerow::source::Sources;

use super::folder;

/// For each operation in steps of a text its name and the examples.
fn examples_of(text: &str) -> Vec<(String, Result<Op, NoExample>)> {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    let ops = analysis.program.ops.iter().enumerate();
    let ops = ops.filter(|(_, op)| op.steps.is_some() && op.span.file == file);
    let shown = ops.map(|(at, op)| {
        let shown = example(&analysis.program, at, &analysis.plans);
        (op.name.clone(), shown)
    });
    shown.collect()
}

/// Those of the standard library, each with the stem of its file.
pub fn shipped() -> Vec<(String, Op)> {
    static SHOWN: LazyLock<Vec<(String, Op)>> = LazyLock::new(show_shipped);
    SHOWN.clone()
}

fn show_shipped() -> Vec<(String, Op)> {
    let text = fs::read_to_string(folder("src/library/std/polygon.hedge")).expect("a library");
    let shown = examples_of(&text).into_iter();
    let shown = shown.filter_map(|(name, shown)| match shown {
        Ok(shown) => Some(("polygon".to_owned(), shown)),
        // No small mesh has two holes that lie in one picture.
        Err(none) if name == "bridge" => {
            assert!(none.to_string().contains("two holes are needed"), "{none}");
            None
        }
        Err(none) => panic!("{name}: {none}"),
    });
    shown.collect()
}

#[test]
fn shipped_ones_are_shown_inside_and_at_the_boundary() {
    let mut seen = 0;
    for (_, op) in shipped() {
        let meshes = op.rules.iter().filter_map(|rule| rule.example.as_ref());
        let meshes: Vec<_> = meshes.map(|example| example.mesh).collect();
        assert_eq!(meshes, ["a cube", "a grid"], "{}", op.name);
        seen += 1;
    }
    assert_eq!(seen, 6);
}

#[test]
fn odd_ones_are_shown_or_it_is_said_why_not() {
    let text = fs::read_to_string(folder("tests/draw/odd.hedge")).expect("odd ones");
    let mut told = Vec::new();
    for (name, shown) in examples_of(&text) {
        let line = match shown {
            Err(none) => none.to_string(),
            Ok(op) => {
                let picture = draw_op(&op);
                assert_eq!(picture.crossings(), 0, "{name}");
                assert!(text_op(&op, COLUMNS).contains("for example on"), "{name}");
                let of = |rule: &hedgerow::diagram::Rule| {
                    let named = rule.names.iter().filter(|name| name.named);
                    let named: Vec<_> = named.map(|name| name.text.as_str()).collect();
                    let mesh = rule.example.as_ref().map_or("nothing", |of| of.mesh);
                    format!("{} on {mesh}", named.join(" "))
                };
                let rules: Vec<_> = op.rules.iter().map(of).collect();
                format!("`{name}`: {}", rules.join(", "))
            }
        };
        told.push(line);
    }
    let (shows, none) = ("shows what it does", "is done in steps, and none of");
    let expected = [
        format!(
            "`never` {none} 187 tries on small meshes {shows}: mostly it was refused (the vertex is too plain)"
        ),
        "`triangles_only`: v f on an octahedron".to_owned(),
        "`two_corners`: a b on a cube, a b on a grid".to_owned(),
        "`number`: v on a cube, v on a grid".to_owned(),
        format!(
            "`endless` {none} 16 tries on small meshes {shows}: mostly it did not come to an end"
        ),
        format!(
            "`growing` {none} 16 tries on small meshes {shows}: mostly it did not come to an end"
        ),
        format!(
            "`failing` {none} 187 tries on small meshes {shows}: mostly it failed (division by zero)"
        ),
        format!("`idle` {none} 187 tries on small meshes {shows}: it changed nothing"),
        "`at_hole`: e m on a grid".to_owned(),
        "`same_name`: f on a cube, f on a grid".to_owned(),
        format!("`nowhere` {none} 38 tries on small meshes {shows}: it changed nothing"),
    ];
    assert_eq!(told, expected);
}

#[test]
fn an_example_is_the_same_every_time() {
    let twice = [shipped(), show_shipped()];
    let drawn = twice.map(|ops| ops.iter().map(|(_, op)| draw_op(op).svg()).collect::<Vec<_>>());
    assert_eq!(drawn[0], drawn[1]);
}
