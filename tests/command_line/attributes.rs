//! Attributes in files: tables hold all of them, OBJ files what the format has a place for.

use crate::bench::{Bench, SQUARE};

const TWO: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.25 0.5\nvt 0.75 0.5\n\
    vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/2/1\n";

/// A program that uses attributes as `body` says.
fn run(bench: &Bench, body: &str, from: &str, to: &str) -> (String, String) {
    let program = format!(
        "use \"std/polygon.hedge\"\n\
         attr uv: halfedge vec2 = vec2(9, 9)\n\
         attr normal: vertex vec3 = vec3(0, 0, 0)\n\
         attr color: vertex vec3 = vec3(1, 1, 1)\n\
         attr crease: edge real = 0.5\n\
         attr part: face int = -1\n\
         private attr scratch: vertex mat4 = mat4(0)\n\
         script s() {{ {body} }}\n"
    );
    bench.write("s.hedge", program);
    let said = bench.run(&["run", "s.hedge", from, "-o", to]);
    assert_eq!(said.code, 0, "{said:?}");
    (said.out, said.err)
}

#[test]
fn corners_that_agree_are_written_as_vertices() {
    let bench = Bench::new();
    let uv = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    let agree = SQUARE.replace("f 1 2 3\nf 1 3 4", "f 1/1 2/2 3/3\nf 1/1 3/3 4/4");
    bench.write("agree.obj", format!("{uv}{agree}"));
    bench.write("seam.obj", format!("{uv}{}", agree.replace("1/1 3/3", "1/2 3/3")));
    let said = bench.run(&["convert", "agree.obj", "m.off"]);
    let told = "m.off: `uv` is written for each vertex, whose corners all have the same\n";
    assert_eq!((said.code, &*said.err), (0, told));
    assert!(bench.read("m.off").starts_with("STOFF\n4 2 5\n0 0 0 0 0\n1 0 0 1 0\n"));
    let said = bench.run(&["convert", "seam.obj", "m.off"]);
    assert!(said.err.contains("m.off cannot hold `uv` (halfedge vec2)"), "{said:?}");
}

#[test]
fn corners_of_obj_files_are_values() {
    let bench = Bench::new();
    bench.write("m.obj", TWO);
    let body = "for f in faces { for h in f.halfedges { h.uv = h.uv + vec2(1, 0) } }\n\
        print sum(dot(v.normal, v.normal) for v in vertices)";
    let (_, err) = run(&bench, body, "m.obj", "n.obj");
    // What is said besides, nothing is lost.
    assert_eq!(err, "");
    let written = bench.read("n.obj");
    let rows = "vt 1 0\nvt 1.25 0.5\nvt 1.75 0.5\nvn 0 0 1\n";
    let faces = "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/2/1\n";
    assert!(written.ends_with(&format!("{rows}{faces}")), "{written}");
    // What a program does not name stays as the file had it.
    run(&bench, "print count(edges)", "m.obj", "n.obj");
    assert_eq!(bench.read("n.obj"), TWO);
    let told = bench.succeeds(&["info", "m.obj"]);
    assert!(told.contains("  attributes            uv: halfedge vec2\n"), "{told}");
}

#[test]
fn values_of_vertices_stand_at_all_their_corners() {
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    let body = "for v in vertices { v.normal = vec3(0, 0, 1) v.color = v.position }";
    let (_, err) = run(&bench, body, "m.obj", "n.obj");
    assert_eq!(err, "");
    let written = bench.read("n.obj");
    assert!(written.contains("v 1 1 0 1 1 0\n"), "{written}");
    assert_eq!(written.matches("vn ").count(), 1, "{written}");
    // And come back from there.
    let body = "assert all(v.normal == vec3(0, 0, 1) and v.color == v.position for v in vertices)";
    run(&bench, body, "n.obj", "k.obj");
    assert_eq!(bench.read("k.obj"), written);
}

#[test]
fn what_a_file_cannot_hold_is_said_in_one_line() {
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    let body = "for e in edges { e.crease = 2 } for f in faces { f.part = f.part + 1 }";
    let (_, err) = run(&bench, body, "m.obj", "n.obj");
    let told = "warning: n.obj cannot hold `crease` (edge real), `part` (face int); \
        a .ply or .halfedges file can\n";
    assert_eq!(err, told);
    let (_, err) = run(&bench, body, "m.obj", "n.halfedges");
    assert_eq!(err, "");
    bench.write("g.obj", format!("g wing\n{SQUARE}"));
    let (_, err) = run(&bench, body, "g.obj", "n.halfedges");
    assert!(err.contains("cannot hold the groups of the mesh"), "{err}");
    bench.write("w.obj", format!("mtllib a.mtl\no body\ng wing\nusemtl red\ns 1\n{SQUARE}"));
    let (_, err) = run(&bench, "", "w.obj", "w.msh");
    assert!(err.contains("cannot hold the objects, materials and smoothing groups"), "{err}");
    let (_, err) = run(&bench, "", "w.obj", "w.off");
    assert!(err.contains("the objects, groups, materials and smoothing groups"), "{err}");
}

#[test]
fn values_that_a_file_changes_are_told() {
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    bench.write(
        "a.hedge",
        "attr tag: halfedge int = 0
        attr mark: face int = 0
        attr big: face int = 0
        script holes() { for h in halfedges where boundary(h) { h.tag = 5 }
                         for f in holes { f.mark = 6 } }
        script large() { for f in faces { f.big = 9007199254740993 } }
        script near() { for f in faces { f.big = 9007199254740992 } }",
    );
    let err = |script: &str, file: &str| {
        let said = bench.run(&["run", &format!("a.hedge::{script}"), "m.obj", "-o", file]);
        assert_eq!(said.code, 0, "{said:?}");
        said.err
    };
    let told = err("holes", "n.ply");
    assert!(told.contains("4 values of `tag` (halfedge) on holes are not in it"), "{told}");
    assert!(told.contains("1 value of `mark` (face) on holes is not in it"), "{told}");
    assert!(err("large", "n.ply").contains("`big` (face) beyond 2^53 "));
    assert_eq!(err("near", "n.ply"), "");
    for script in ["holes", "large"] {
        assert_eq!(err(script, "n.halfedges"), "");
    }
    bench.write(
        "c.hedge",
        "attr color: vertex vec3 = vec3(0)
        script main() { for v in vertices { v.color = vec3(0, 2, 0.5) } }",
    );
    let told = bench.run(&["run", "c.hedge", "m.obj", "-o", "c.off"]).err;
    assert!(told.contains("4 values of `color` (vertex) with parts that are not from 0"), "{told}");
}

#[test]
fn tables_hold_all_attributes_after_erasing() {
    let bench = Bench::new();
    bench.write("m.obj", TWO);
    // Elements come and go first, so the tables have gaps.
    let body = "var first = true\n\
        for e in edges where first and not boundary(e) {\n\
          let v = must bisect(e)  must dissolve_vertex(v)  first = false\n\
        }\n\
        for e in edges { e.crease = length(e) / 3 }\n\
        for f in faces { f.part = 7 }\n\
        for v in vertices { v.scratch = mat4(2) v.normal = v.position / 3 }\n\
        for h in halfedges { h.uv = h.uv / 7 }";
    run(&bench, body, "m.obj", "a.halfedges");
    let tables = bench.read("a.halfedges");
    assert!(!tables.contains("scratch"), "{tables}");
    for told in ["face int", "edge real", "vertex vec3", "halfedge vec2"] {
        assert!(bench.succeeds(&["info", "a.halfedges"]).contains(told), "{told}");
    }
    let same = "assert all(e.crease == length(e) / 3 for e in edges)\n\
        assert all(f.part == 7 for f in faces)\n\
        assert all(v.normal == v.position / 3 for v in vertices)\n\
        print sum(h.uv for h in halfedges)";
    run(&bench, same, "a.halfedges", "b.halfedges");
    assert_eq!(bench.read("b.halfedges"), tables);
}

#[test]
fn places_in_tables_are_ids() {
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    run(&bench, "print 1", "m.obj", "m.halfedges");
    let op = "std/polygon.hedge::inset_vertex";
    let apply = |to| bench.succeeds(&["apply", op, "m.halfedges", "--at", "face:0", "-o", to]);
    assert!(apply("n.halfedges").contains("result   vertex:4\n"));
    assert!(apply("n.obj").contains("result   vertex:5\n"));
    bench.write("two.halfedges", "mesh a\nmesh b\n");
    let words = "a file with one `mesh` is wanted; this has 2";
    bench.fails(2, &["view", "two.halfedges", "-o", "x.svg"], words);
    bench.write("broken.halfedges", "mesh a\nvertex 0 halfedge 3 at 0 0 0\n");
    let words = "this is not a valid mesh";
    bench.fails(2, &["view", "broken.halfedges", "-o", "x.svg"], words);
}

#[test]
fn a_default_that_used_files_need_is_asked_for_once() {
    let bench = Bench::new();
    let program = "use \"std/polygon.hedge\"\nattr w: vertex vec3\nscript s() { }\n";
    bench.write("s.hedge", program);
    let said = bench.run(&["check", "s.hedge"]);
    assert_eq!((said.code, said.err.matches("error[").count()), (1, 1), "{said:?}");
    let way_out = "write `attr w: vertex vec3 = vec3(0)`";
    assert!(said.err.contains(way_out), "{}", said.err);
    bench.write("s.hedge", program.replace("attr w: vertex vec3", "attr w: vertex vec3 = vec3(0)"));
    bench.succeeds(&["check", "s.hedge"]);
}

#[test]
fn new_corners_have_the_values_of_their_vertices_in_every_format() {
    let bench = Bench::new();
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.1\nvt 0.9 0.1\nvt 0.9 0.9\n\
                  vt 0.1 0.9\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n";
    bench.write("m.obj", square);
    bench
        .write("t.obj", square.replace("vn 0 0 1\n", "").replace("/1 ", " ").replace("/1\n", "\n"));
    bench.succeeds(&["convert", "t.obj", "t.ply"]);
    for (from, normals) in [("m.obj", vec!["0 0 1"]), ("t.ply", vec![])] {
        for to in ["n.obj", "n.ply", "n.halfedges"] {
            let run = ["run", "std/triangulate.hedge::triangulate", from, "-o", to];
            bench.succeeds(&run);
            bench.succeeds(&["convert", to, "o.obj"]);
            let text = bench.read("o.obj");
            let rows = |keyword: &str| -> Vec<&str> {
                text.lines().filter_map(|line| line.strip_prefix(keyword)).collect()
            };
            let (places, textures) = (rows("v "), rows("vt "));
            let mut corners = 0;
            for face in rows("f ") {
                for corner in face.split(' ') {
                    let numbers: Vec<usize> =
                        corner.split('/').map(|number| number.parse().unwrap()).collect();
                    let near = |at: &str| if at == "0" { "0.1" } else { "0.9" };
                    let place: Vec<&str> = places[numbers[0] - 1].split(' ').collect();
                    let wanted = format!("{} {}", near(place[0]), near(place[1]));
                    assert_eq!(textures[numbers[1] - 1], wanted, "{from} to {to}: {text}");
                    corners += 1;
                }
            }
            assert_eq!((corners, rows("vn ")), (6, normals.clone()), "{from} to {to}: {text}");
        }
    }
}

#[test]
fn what_of_a_file_is_lost_is_told() {
    let bench = Bench::new();
    bench.write("m.obj", TWO.replace("f 1/1/1 2/2/1", "l 1 2\np 3\nf 1/1/1 2/2/1"));
    let split = ["apply", "std/triangle.hedge::split", "m.obj", "--at", "edge:1-3"];
    let said = bench.run(&[split.as_slice(), &["-o", "n.obj"]].concat());
    assert_eq!(said.code, 0, "{said:?}");
    for words in [
        "4 faces with new corners have no texture coordinates (`vt`) any more\n",
        "4 faces with new corners have no normals (`vn`) any more\n",
        "lines (`l`), points (`p`), first in line ",
    ] {
        assert!(said.err.contains(words), "{}", said.err);
    }
    let said = bench.run(&[split.as_slice(), &["-o", "n.ply"]].concat());
    for words in [
        "4 faces with new corners have no texture coordinates any more\n",
        "4 faces with new corners have no normals any more\n",
    ] {
        assert!(said.err.contains(words), "{}", said.err);
    }
    let said = bench.run(&[split.as_slice(), &["-o", "n.halfedges"]].concat());
    for words in [
        "4 faces with new corners have no texture coordinates any more: they are zero there\n",
        "4 faces with new corners have no normals any more: they are zero there\n",
    ] {
        assert!(said.err.contains(words), "{}", said.err);
    }
    assert!(bench.read("n.obj").ends_with("f 3 5 2\nf 1 5 4\nf 5 3 4\nf 5 1 2\n"));
    // A file whose corners have none has none to lose.
    bench.write("m.obj", SQUARE);
    let said = bench.run(&[split.as_slice(), &["-o", "n.obj"]].concat());
    assert_eq!((said.code, said.err.contains("warning")), (0, false), "{said:?}");
}

#[test]
fn new_corners_have_what_the_file_has_beside_them() {
    let bench = Bench::new();
    let faces = |command: &[&str], mesh: &str| {
        bench.write("m.obj", mesh);
        let said = bench.run(&[command, &["-o", "n.obj"]].concat());
        assert_eq!(said.code, 0, "{said:?}");
        let written = bench.read("n.obj");
        let faces: Vec<_> = written.lines().filter_map(|line| line.strip_prefix("f ")).collect();
        (faces.join(", "), said.err.matches("any more").count())
    };
    let flip = ["apply", "std/triangle.hedge::flip", "m.obj", "--at", "edge:1-3"];
    let both = ("4/2/1 2/2/1 3/3/1, 2/2/1 4/2/1 1/1/1".to_owned(), 0);
    assert_eq!(faces(&flip, TWO), both);
    // Rows of the same values are no seam; others are, and so is a corner without a row.
    let doubled = TWO.replace("vn 0", "vt 0.75 0.5\nvn 0").replace(" 3/3/1 4", " 3/4/1 4");
    let (written, warnings) = faces(&flip, &doubled);
    assert_eq!((written.replace("3/4/1", "3/3/1"), warnings), both);
    let seam = TWO.replace(" 3/3/1 4", " 3/1/1 4");
    assert_eq!(faces(&flip, &seam), ("4//1 2//1 3//1, 2//1 4//1 1//1".to_owned(), 1));
    // The corners of a polygon are those of its triangles, whatever others have there.
    let quads = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n\
        vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\nf 2/1 5/2 6/3 3/4\n";
    let (faces, warnings) = faces(&["run", "std/triangulate", "m.obj"], quads);
    assert_eq!(warnings, 0);
    let corners = |face: &str| face.split(' ').map(str::to_owned).collect::<Vec<_>>();
    let first = ["1/1", "2/2", "3/3", "4/4"];
    let second = ["2/1", "5/2", "6/3", "3/4"];
    let triangles: Vec<_> = faces.split(", ").map(corners).collect();
    assert_eq!(triangles.len(), 4, "{faces}");
    for triangle in &triangles {
        let is_of = |quad: [&str; 4]| triangle.iter().all(|corner| quad.contains(&&**corner));
        assert!(is_of(first) || is_of(second), "{faces}");
    }
}

#[test]
fn values_that_are_not_those_of_their_corners_are_counted() {
    let bench = Bench::new();
    bench.write("m.obj", TWO);
    // A halfedge takes its value along to its new corner, and a new one has the default.
    let named = "print sum(dot(h.uv, h.uv) for h in halfedges) \
        + sum(dot(v.normal, v.normal) for v in vertices)";
    let flip = format!("for e in edges where not boundary(e) {{ must flip(e) }} {named}");
    let (_, err) = run(&bench, &flip, "m.obj", "n.obj");
    let told = "warning: n.obj: `uv` is wrong on 2 of 2 faces: 2 corners have kept the value of a \
        place left; operations have to set it at new corners\n";
    assert_eq!(err, told);
    let split = format!("for e in edges where not boundary(e) {{ must split(e) }} {named}");
    let (_, err) = run(&bench, &split, "m.obj", "n.obj");
    assert!(err.contains("`uv` is wrong on 4 of 4 faces: 6 new corners have the default"), "{err}");
    assert!(err.contains("`normal` is wrong on 4 of 4 faces: 4 new corners have the"), "{err}");
    // What is set is right.
    let set = format!("{flip} for h in halfedges {{ h.uv = vec2(1, 2) }}");
    let (_, err) = run(&bench, &set, "m.obj", "n.obj");
    assert_eq!(err, "");
    // A file without texture coordinates has none to spoil.
    bench.write("m.obj", SQUARE);
    let (_, err) = run(&bench, "for f in faces { inset_vertex(f) }", "m.obj", "n.obj");
    assert_eq!(err, "");
    bench.write("m.obj", TWO);
    let op = "op turn(e: edge) {\n  before {\n    face f0: v0 -a-> v1 -b-> v2 -c-> v0\n    \
        face f1: v1 -d-> v0 -g-> v3 -h-> v1\n    edge e: a | d\n  }\n  after {\n    \
        face f0: v3 -a-> v2 -c-> v0 -g-> v3\n    face f1: v2 -d-> v3 -h-> v1 -b-> v2\n    \
        edge e: a | d\n    a.uv = h.uv\n    d.uv = c.uv\n  }\n}\n";
    bench.write("turn.hedge", format!("attr uv: halfedge vec2\n{op}"));
    let turn = ["apply", "turn.hedge::turn", "m.obj", "--at", "edge:1-3", "-o", "n.obj"];
    let said = bench.run(&turn);
    assert_eq!(said.code, 0, "{said:?}");
    assert!(!said.err.contains("`uv`"), "{}", said.err);
}
