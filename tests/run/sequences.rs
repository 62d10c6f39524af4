//! Scripts of the library one after the other, in any order, on meshes of many kinds: each runs
//! to its end, and a simple mesh stays one.
//!
//! `SEQUENCES=60` runs so many instead of a few; `SEQUENCES_FROM=12` begins with that one.

use std::path::Path;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::mesh::{Level, Mesh, read_mesh, shape, validate, validate_level};
use hedgerow::rewrite::Engine;
use hedgerow::run::prepare;
use hedgerow::source::Sources;
use support::dice::Dice;
use support::engines::run_on_both;

const USES: &str = r#"
use "std/remesh.hedge"
use "std/simplify.hedge"
use "std/subdivide.hedge"
use "std/components.hedge"
use "std/smooth.hedge"
use "std/triangulate.hedge"
use "std/repair.hedge"
"#;

/// What keeps a mesh of triangles one, and wants one.
const OF_TRIANGLES: [&str; 16] = [
    "linear(1)",
    "loop_subdivide(1)",
    "loop_subdivide(1, true)",
    "loop_subdivide(1, false, 0.6)",
    "remesh(0, 2, 4/3, 4/5, 1, 1, 0.6)",
    "loop_once()\n  simplify_to(200, 1)",
    "remesh(0, 1, 1.5, 0.7, 2, 0.5)",
    "simplify_by(0.4)",
    "sqrt3(1)",
    "butterfly(1)",
    "remesh(0, 2)",
    "simplify(max(count(faces) div 2, 60))",
    "simplify(40, 0.5)",
    "let shortest = mean(length(e) for e in edges) / 3\n  collapse_short(shortest)",
    "let lowest = mean(length(e) for e in edges) / 10\n  flip_caps(lowest)",
    "fill_holes(8)",
];

/// What takes any polygons, and leaves them.
const OF_POLYGONS: [&str; 5] =
    ["laplacian(1)", "taubin(2)", "tangential(1)", "laplacian(2, 0.3)", "components()"];

/// What makes other polygons of any polygons.
const TO_POLYGONS: [&str; 5] =
    ["catmull_clark(1)", "catmull_clark(1, 0.6)", "linear_quads(1)", "doo_sabin(1)", "midedge(1)"];

fn load(name: &str) -> Mesh {
    let path = format!("{}/examples/meshes/{name}.obj", env!("CARGO_MANIFEST_DIR"));
    read_mesh(Path::new(&path), None).unwrap().mesh
}

fn begin(dice: &mut Dice, long: bool) -> (String, Mesh) {
    let made = match dice.below(if long { 16 } else { 13 }) {
        0 => ("cube", shape::cube()),
        1 => ("tetrahedron", shape::tetrahedron()),
        2 => ("grid", shape::grid(4, 3)),
        3 => ("triangle grid", shape::triangle_grid(5, 4)),
        4 => ("torus", shape::torus(6, 5)),
        5 => ("triangle torus", shape::triangle_torus(7, 4)),
        6 => ("tube", shape::tube(6, 3)),
        7 => ("disk", shape::fan(7)),
        8 => ("polygon", shape::single_polygon(9)),
        9 => ("icosphere", shape::icosphere(1)),
        10 => ("octahedron", shape::octahedron()),
        11 => ("pillow", shape::pillow(5)),
        12 => ("slim tube", shape::tube(3, 2)),
        13 => ("bunny", load("bunny")),
        14 => ("teapot", load("teapot")),
        _ => ("large torus", shape::torus(30, 20)),
    };
    (made.0.to_owned(), made.1)
}

fn all_triangles(mesh: &Mesh) -> bool {
    mesh.faces().filter(|&f| !mesh.is_hole(f)).all(|f| mesh.face_size(f) == 3)
}

/// The statements of a sequence.
fn sequence(dice: &mut Dice, mut triangles: bool) -> String {
    let mut statements = Vec::new();
    for _ in 0..3 + dice.below(4) {
        let statement = match dice.below(10) {
            0..6 => {
                if !triangles {
                    statements.push("triangulate()".to_owned());
                    triangles = true;
                }
                OF_TRIANGLES[dice.below(OF_TRIANGLES.len())]
            }
            6 | 7 => OF_POLYGONS[dice.below(OF_POLYGONS.len())],
            8 => {
                triangles = false;
                TO_POLYGONS[dice.below(TO_POLYGONS.len())]
            }
            _ => {
                triangles = true;
                "triangulate()"
            }
        };
        // A name of its own for each variable.
        statements.push(format!("if true {{ {statement} }}"));
        // Large meshes take long and show nothing more.
        let small = match triangles {
            true => "if count(faces) > 6000 { simplify(1500) }",
            false => "if count(faces) > 6000 { triangulate() simplify(1500) catmull_clark() }",
        };
        statements.push(small.to_owned());
    }
    statements.join("\n  ")
}

#[test]
fn every_sequence_of_library_scripts_runs() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let long = number("SEQUENCES").is_some();
    let count = number("SEQUENCES").unwrap_or(14);
    let from = number("SEQUENCES_FROM").unwrap_or(0);
    let mut failed = Vec::new();
    for seed in from..from + count {
        let mut dice = Dice(seed * 7919 + 1);
        (0..5).for_each(|_| _ = dice.below(7));
        let (name, mut mesh) = begin(&mut dice, long);
        let statements = sequence(&mut dice, all_triangles(&mesh));
        let text = format!("{USES}\nscript main() {{\n  {statements}\n}}");
        let mut sources = Sources::new();
        let file = sources.add("sequence.hedge", text);
        let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
        assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
        let was_simple = validate_level(&mesh, Level::Simple).is_ok();
        let script = analysis.script("main").unwrap();
        let prepared = prepare(&analysis.program, script, &analysis.plans).unwrap();
        let engine = if seed % 4 == 0 { Engine::NativeAtOnce } else { Engine::Native };
        let (done, _) = run_on_both(&prepared, &mut mesh, &[], engine);
        if let Err(failure) = done {
            let said = &failure.diagnostic;
            failed
                .push(format!("{seed}: {name}: {} {:?}\n  {statements}", said.message, said.notes));
            continue;
        }
        validate(&mesh).unwrap();
        if was_simple && let Err(below) = validate_level(&mesh, Level::Simple) {
            failed.push(format!("{seed}: {name}: not simple any more: {below}\n  {statements}"));
        }
    }
    assert!(failed.is_empty(), "{} of {count}:\n{}", failed.len(), failed.join("\n"));
}
