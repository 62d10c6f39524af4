//! Meshes that are none: a message with the place, code 2, and nothing written.

use crate::bench::{Bench, SQUARE, example, flip};

const POINTS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n";

/// Neither `info` nor `run` nor `apply` takes it.
fn refuses(name: &str, bytes: impl AsRef<[u8]>, words: &str) {
    let bench = Bench::new();
    bench.write("m.obj", bytes);
    bench.write("out.obj", "old");
    let remesh = example("remesh.hedge");
    for arguments in [
        &["info", "m.obj"][..],
        &["run", &remesh, "m.obj", "-o", "out.obj"],
        &["apply", &flip(), "m.obj", "--at", "edge:1-2", "-o", "out.obj"],
    ] {
        let said = bench.fails(2, arguments, words);
        assert!(said.err.contains("m.obj"), "{name}: {said:?}");
        assert_eq!(said.out, "", "{name}");
    }
    assert_eq!(bench.read("out.obj"), "old", "{name}");
    assert_eq!(bench.files(), ["m.obj", "out.obj"], "{name}");
}

#[test]
fn no_surface() {
    for (name, faces, words) in [
        ("edge used thrice", "f 1 2 3\nf 2 1 4\nf 1 2 5\n", "m.obj:8: "),
        ("same direction twice", "f 1 2 3\nf 1 2 4\n", "m.obj:7: "),
        ("bow-tie", "f 1 2 3\nf 1 4 5\n", "pinched"),
        ("repeated corner", "f 1 2 2 3\n", "m.obj:6: "),
        ("two corners", "f 1 2\n", "m.obj:6: "),
        ("no such vertex", "f 1 2 9\n", "there is no vertex 9"),
        ("vertex 0", "f 0 1 2\n", "m.obj:6: "),
        ("words", "f a b c\n", "`a`"),
    ] {
        refuses(name, format!("{POINTS}{faces}"), words);
    }
}

#[test]
fn no_numbers() {
    for number in ["nan", "inf", "1e999", "x", ""] {
        refuses(number, format!("v 0 0 {number}\n{POINTS}f 2 3 4\n"), "m.obj:1: ");
    }
}

#[test]
fn no_mesh() {
    let noise = noise(5000);
    refuses("empty", "", "is it an OBJ file?");
    refuses("noise", &noise, "m.obj");
    refuses("binary", [&[0, 1, 2, 255, 254], SQUARE.as_bytes()].concat(), "m.obj");
    refuses("text", "once upon a time\n", "is it an OBJ file?");
    refuses("long line", "v ".repeat(1_000_000), "m.obj");
    let nothing = Bench::new();
    nothing.fails(2, &["info", "nothing.obj"], "nothing.obj");
    nothing.fails(2, &["info", "."], "`.` is a folder; a mesh is wanted here");
}

/// What a repair would make another mesh of is not to be repaired.
#[test]
fn indices_from_zero() {
    let bench = Bench::new();
    bench.write("zero.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 0 1 2\nf 0 2 3\n");
    let said = bench.run(&["info", "zero.obj"]);
    assert!(said.err.contains("count vertices from 0, and the format counts from 1"), "{said:?}");
    assert!(said.code == 2 && !said.err.contains("--repair"), "{said:?}");
}

/// Tables say that they are empty; a list of no polygons is probably something else.
#[test]
fn no_vertex() {
    let bench = Bench::new();
    bench.write("none.halfedges", "mesh mesh\n");
    bench.succeeds(&["info", "none.halfedges"]);
    for ending in ["off", "ply", "stl", "msh", "obj"] {
        let name = format!("none.{ending}");
        bench.succeeds(&["convert", "none.halfedges", &name]);
        bench.fails(2, &["info", &name], "there is no vertex in it");
    }
}

#[test]
fn a_file_cut_anywhere_is_a_smaller_mesh_or_a_message() {
    let bench = Bench::new();
    let bunny = std::fs::read(example("meshes/bunny.obj")).unwrap();
    let mut refused = 0;
    for end in (1..bunny.len()).step_by(bunny.len() / 40) {
        bench.write("cut.obj", &bunny[..end]);
        let said = bench.run(&["info", "cut.obj"]);
        match said.code {
            0 => assert!(said.out.contains("valid, of level"), "{end}: {said:?}"),
            2 => {
                assert!(said.err.starts_with("error: cut.obj:"), "{end}: {said:?}");
                refused += 1;
            }
            _ => panic!("{end}: {said:?}"),
        }
    }
    assert!(refused > 0);
}

/// Bytes without a pattern, the same every time.
pub fn noise(count: usize) -> Vec<u8> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 32) as u8
    };
    std::iter::repeat_with(next).take(count).collect()
}

#[test]
fn repair_makes_a_mesh_and_says_how() {
    let bench = Bench::new();
    bench.write("s.hedge", "script s() { print \"{count(faces)} faces\" }\n");
    // Three triangles at an edge, and one with a vertex twice.
    let fins = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 0\n\
        f 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 3 4\n";
    bench.write("fins.obj", fins);
    let run = ["run", "s.hedge", "fins.obj", "-o", "out.obj"];
    let said = bench.fails(2, &run, "2 faults keep its faces from being a mesh");
    assert!(said.err.contains("1 edge of three faces or more: line 9,"), "{}", said.err);
    assert!(said.err.contains("`--repair`"), "{}", said.err);
    assert!(!bench.has("out.obj"));
    let said = bench.run(&[&run[..], &["--repair"]].concat());
    assert!(said.out.starts_with("3 faces\n"), "{said:?}");
    let told = "fins.obj: repaired: dropped 2 repeated corners";
    let told = told.replace("2 repeated corners", "1 repeated corner, dropped 1 degenerate face");
    let told = format!("{told}, cut 1 edge of three faces or more, split off 4 vertices\n");
    assert_eq!(said.err, told);
    // What is written is a mesh, and says so as data.
    let said = bench.succeeds(&["info", "out.obj", "--repair", "--format", "json"]);
    assert!(said.contains("\"crowded_edges\": 0"), "{said}");
    let said = bench.run(&["info", "fins.obj", "--merge", "1e-6", "--format", "json"]);
    assert!(said.out.contains("\"merged_vertices\": 1"), "{said:?}");
    let said = bench.run(&["view", "fins.obj", "--repair", "-o", "fins.png"]);
    assert!(said.code == 0 && said.err.starts_with("fins.obj: repaired: "), "{said:?}");
    bench.fails(2, &["info", "fins.obj", "--merge=-1"], "a distance is a number from 0 on");
    // Tables and shapes have no polygons to make new ones of.
    bench.succeeds(&["convert", "out.obj", "out.halfedges"]);
    for arguments in [&["convert", "out.halfedges", "o.ply"][..], &["info", "out.halfedges"]] {
        let merging = [arguments, &["--merge", "1"]].concat();
        bench.fails(2, &merging, "the vertices of halfedge tables are not merged");
    }
    let shape = ["info", "tetrahedron()", "--merge", "1"];
    bench.fails(2, &shape, "`--merge` is for files, and not for shapes");
    let arguments =
        ["apply", "std/polygon.hedge::inset_vertex", "fins.obj", "--repair", "--at", "face:2"];
    let said = bench.run(&[&arguments[..], &["-o", "p.ply", "--format", "json"]].concat());
    assert!(said.out.contains("\"split_vertices\": 4"), "{said:?}");
}

#[test]
fn damaged_places_are_passed_over_on_demand() {
    let bench = Bench::new();
    bench.write("d.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2");
    let told = "d.off:8: the file ends where a vertex of a face should stand; `--repair` ";
    bench.fails(2, &["info", "d.off"], told);
    let said = bench.run(&["info", "d.off", "--repair", "--format", "json"]);
    assert!(said.out.contains("\"damaged_places\": 1"), "{said:?}");
    let told = "d.off: repaired: passed over 1 damaged place of the file (line 8: the file ends \
        where a vertex of a face should stand)\n";
    assert_eq!(said.err, told);
}

#[test]
fn a_repair_is_advised_where_it_helps() {
    let bench = Bench::new();
    bench.write("comma.obj", "v 0,0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    bench.write("comma.stl", "solid\nvertex 0 0,5 0\n");
    bench.write("comma.off", "OFF\n3 1 0\n0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for (file, line) in [("comma.obj", 1), ("comma.stl", 2), ("comma.off", 3)] {
        let said =
            bench.fails(2, &["info", file], "is not a number; numbers are written with a point");
        assert!(said.err.contains(&format!("{file}:{line}: ")), "{}", said.err);
        assert!(!said.err.contains("--repair"), "{}", said.err);
    }
}

#[test]
fn vertices_that_nearly_coincide_can_be_merged() {
    let bench = Bench::new();
    bench.write("s.hedge", "script s() { print count(vertices) }\n");
    let loops = ["0 0 0 1 0 0 1 1 0", "0 0 0 1.0000001 1 0 0 1 0"].map(|numbers| {
        let numbers: Vec<_> = numbers.split(' ').collect();
        let vertices = numbers.chunks(3).map(|it| format!("vertex {}\n", it.join(" ")));
        format!(
            "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n",
            vertices.collect::<String>()
        )
    });
    bench.write("near.stl", format!("solid\n{}endsolid\n", loops.concat()));
    let run = ["run", "s.hedge", "near.stl"];
    let said = bench.fails(2, &run, "the surface is pinched there");
    assert!(said.err.contains("`--repair`") && said.err.contains("`--merge DISTANCE`"), "{said:?}");
    let said = bench.run(&[&run[..], &["--merge", "1e-6"]].concat());
    assert!(said.out.starts_with("4\n"), "{said:?}");
}

#[test]
fn vertices_without_coordinates_are_dropped() {
    let bench = Bench::new();
    bench.write("nan.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv nan 0 0\nl 1 2\nf 1 2 3\n");
    bench.write("s.hedge", "script s() { }");
    let said = bench.run(&["run", "s.hedge", "nan.obj", "--repair", "-o", "n.obj"]);
    assert!(said.err.contains("dropped 1 vertex without coordinates"), "{}", said.err);
    assert!(said.err.contains("lines (`l`), first in line 5, cannot be kept"), "{}", said.err);
}

#[test]
fn every_line_of_an_obj_file_is_kept_or_told() {
    let bench = Bench::new();
    bench.write("s.hedge", "script s() { }\n");
    let run = ["run", "s.hedge", "m.obj", "-o", "n.obj"];
    // A name that ends in a backslash, a weight, a colour with a fourth number.
    bench.write("m.obj", "v 0 0 0 0.5\nv 1 0 0\nv 0 1 0\ng foo\\ # remark\nf 1 2 3\n");
    let said = bench.run(&run);
    assert!(said.err.is_empty(), "{}", said.err);
    let written = "v 0 0 0 0.5\nv 1 0 0\nv 0 1 0\ng foo\\ #\nf 1 2 3\n";
    assert_eq!(bench.read("n.obj"), written);
    bench.succeeds(&["run", "s.hedge", "n.obj", "-o", "m.obj"]);
    assert_eq!(bench.read("m.obj"), written);
    bench.write(
        "m.obj",
        "v 0 0 0 1 0 0 0.5\nv 1 0 0\nv 0 1 0 1 1 1 1\n%x\nvt 0 0 0 0\nv 9 9 9 1 1\nf 1 2 3\n",
    );
    let said = bench.run(&run);
    assert!(bench.read("n.obj").starts_with("v 0 0 0 1 0 0 0.5\nv 1 0 0 1 1 1 1\n"));
    for told in [
        "`%x`, first in line 4, cannot be kept",
        "1 vertex with 5 numbers, or more than 7, first in line 6",
        "1 `vt` with more than three numbers, first in line 5",
        "2 vertices without a colour, which are white now",
    ] {
        assert!(said.err.contains(told), "{}", said.err);
    }
}

#[test]
fn elements_are_reordered_and_written_as_they_were() {
    let bench = Bench::new();
    let bunny = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/meshes/bunny.obj");
    bench.write("none.hedge", "script none() { print count(vertices) }");
    bench.write("first.hedge", "script first() { for v in vertices { print v.position break } }");
    let printed = ["none.obj", "reordered.obj"].map(|out| {
        let more: &[&str] = if out == "none.obj" { &[] } else { &["--reorder"] };
        bench.succeeds(&[&["run", "none.hedge", bunny, "-o", out], more].concat());
        bench.succeeds(&[&["run", "first.hedge", bunny, "-o", "m.obj"], more].concat())
    });
    assert_eq!(bench.read("none.obj"), bench.read("reordered.obj"));
    let first = printed.map(|lines| lines.lines().next().map(str::to_owned));
    assert_ne!(first[0], first[1], "they have another order");
    bench.succeeds(&["run", "none.hedge", bunny, "-o", "m.halfedges"]);
    let words = "`--reorder` is for files of polygons";
    bench.fails(2, &["run", "none.hedge", "m.halfedges", "--reorder"], words);
}

/// What was read is known to be a surface, and not asked again: two triangles back to back are one,
/// but not a simple one; tables may be less.
#[test]
fn the_level_of_what_was_read_is_known() {
    let bench = Bench::new();
    bench.write("pillow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
    bench.write(
        "map.hedge",
        "use \"std/map.hedge\" script main() { for e in edges { contract(e) } }",
    );
    let flip = "use \"std/triangle.hedge\" script main() { for e in edges { flip(e) } }";
    bench.write("flip.hedge", flip);
    let words = "face 0 and face 1 have the same corners";
    bench.fails(1, &["run", "flip.hedge", "pillow.obj"], words);
    bench.succeeds(&["run", "map.hedge", "pillow.obj", "-o", "less.halfedges"]);
    bench.fails(1, &["run", "flip.hedge", "less.halfedges"], "is for meshes of level simple");
}
