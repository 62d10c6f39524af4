//! Programs of several files, and the standard library.

use crate::bench::{Bench, TETRAHEDRON};

#[test]
fn a_used_file_lies_beside_the_one_that_uses_it() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("parts")).unwrap();
    bench.write("mesh.obj", TETRAHEDRON);
    bench.write("parts/first.hedge", "use \"second.hedge\"\n");
    bench.write(
        "parts/second.hedge",
        "use \"std/triangle.hedge\"\nscript go() { for e in edges { split(e) } }\n",
    );
    let run = |script| bench.run(&["run", script, "mesh.obj", "-o", "out.obj"]);
    let said = run("parts/first.hedge::go");
    assert_eq!((said.code, said.err.as_str()), (0, ""));
    assert!(said.out.contains("split        6        0"), "{said:?}");
    bench.fails(2, &["plan", "parts/first.hedge"], "no operation");

    bench.write("parts/third.hedge", "use \"secnd.hedge\"\n");
    bench.fails(1, &["check", "parts/third.hedge"], "`second.hedge`?");
}

#[test]
fn a_folder_may_have_the_name_of_the_library() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("std")).unwrap();
    bench.write("std/triangle.hedge", "use \"smooth.hedge\"\nscript go() { hello() }\n");
    bench.write("std/smooth.hedge", "script hello() { print \"hello\" }\n");
    bench.write("mesh.obj", TETRAHEDRON);
    for program in ["std/triangle.hedge::go", "./std/triangle.hedge::go"] {
        let said = bench.run(&["run", program, "mesh.obj"]);
        assert!(said.code == 0 && said.out.starts_with("hello"), "{said:?}");
    }
    bench.write("used.hedge", "use \"./std/smooth.hedge\"\nscript main() { hello() }\n");
    assert!(bench.run(&["run", "used.hedge", "mesh.obj"]).out.starts_with("hello"));
}

#[test]
fn tests_are_run_and_told() {
    let bench = Bench::new();
    let said = bench.run(&["test", "std/triangle.hedge"]);
    assert_eq!((said.code, said.err.as_str()), (0, ""), "{said:?}");
    assert!(said.out.contains("ok      a tetrahedron refuses every flip"));
    assert!(said.out.ends_with(" passed, 0 failed\n"), "{said:?}");

    bench.write("mesh.obj", TETRAHEDRON);
    bench.write(
        "bad.hedge",
        "use \"std/triangle.hedge\"
        test \"sums\" { print 7 assert 1 + 1 == 3 }
        test \"loads\" { mesh = load(\"mesh.obj\") assert mesh == load(\"mesh.obj\") }
        test \"keeps\" { mesh = cube() let start = mesh assert mesh != start }
        test \"reason\" { mesh = tetrahedron() for e in edges { assert refuses(flip(e), \"no\") } }
        test \"applies\" { mesh = octahedron() for e in edges { assert refuses(flip(e)) } }
        test \"must\" { mesh = tetrahedron() for e in edges { let m = must collapse(e) } }
        test \"said\" { mesh = octahedron() for e in edges { assert refuses(flip(e)) else \"no\" } }
        test \"start\" { mesh = cube() let start = mesh assert start != mesh }
        test \"missing\" { mesh = load(\"no.obj\") }
        test \"level\" { mesh = pillow(3) for e in edges { flip(e) } }",
    );
    let said = bench.fails(1, &["test", "bad.hedge"], "the left side is 2, the right side 3");
    assert!(said.out.ends_with("1 passed, 9 failed\n"), "{said:?}");
    for words in [
        "the mesh is the same",
        "the reason is: two edges would join `v2` and `v3`",
        "the operation was applied",
        "error[assertion-failed]: no\n",
        "`collapse` refused edge 0: ",
        "`no.obj` cannot be loaded",
        "is for meshes of level simple",
    ] {
        assert!(said.err.contains(words), "{words}: {said:?}");
    }
    assert!(said.out.contains("FAILED  sums\n          7\n"), "{said:?}");
    let json = bench.json(&["test", "bad.hedge", "--filter", "load"]);
    assert_eq!(json["passed"], 1);
    assert_eq!(json["files"][0]["tests"][0]["test"], "loads");
    bench.fails(2, &["test", "nothing.hedge"], "nothing.hedge");
}

#[test]
fn the_library_is_listed_printed_copied_and_run() {
    let bench = Bench::new();
    bench.write("mesh.obj", TETRAHEDRON);
    let list = bench.succeeds(&["std"]);
    assert!(list.contains("std/triangle.hedge\n"), "{list}");
    assert!(list.contains("op  flip"), "{list}");
    let text = bench.succeeds(&["std", "triangle"]);
    bench.succeeds(&["std", "std/triangle.hedge", "--copy", "mine"]);
    assert_eq!(bench.read("mine/triangle.hedge"), text);
    bench.succeeds(&["std", "triangle", "--copy", "own.hedge"]);
    assert_eq!(bench.read("own.hedge"), text);
    bench.fails(2, &["std", "triangle", "--copy", "own.hedge"], "already");
    bench.fails(2, &["std", "triangel"], "`std/triangle.hedge`");

    let split =
        ["apply", "std/triangle.hedge::split", "mesh.obj", "--at", "edge:1-2", "-o", "out.obj"];
    let said = bench.run(&split);
    assert_eq!((said.code, said.err.as_str()), (0, ""));
    bench.fails(2, &["plan", "std/triangle.hedge::flipp"], "did you mean `flip`?");
}

#[test]
fn the_only_script_of_a_file_is_found() {
    let bench = Bench::new();
    bench.write("mesh.obj", TETRAHEDRON);
    bench.write("own.hedge", "script shuffled() { for e in shuffle(edges) { print e } }");
    let run = |seed: &str| bench.run(&["run", "own", "mesh.obj", "--seed", seed]).out;
    let lines = |said: String| said.lines().take(6).map(String::from).collect::<Vec<_>>();
    assert_eq!(lines(run("3")), lines(run("3")));
    assert_ne!(lines(run("3")), lines(run("4")));
    let said =
        bench.run(&["run", "std/remesh", "mesh.obj", "-o", "out.obj", "--set", "iterations=1"]);
    assert_eq!((said.code, said.err.as_str()), (0, ""), "{said:?}");
    let several = bench.fails(2, &["run", "std/smooth", "mesh.obj"], "which script?");
    for script in ["`laplacian`", "`taubin`", "`tangential`"] {
        assert!(several.err.contains(script), "{several:?}");
    }
    bench.write("test.hedge", "test \"three\" { assert random(1000) == random(7) }");
    bench.fails(1, &["test", "test.hedge", "--seed", "2"], "the left side is");
    bench.fails(2, &["run", "std/nothing", "mesh.obj"], "cannot read `std/nothing`");
}

#[test]
fn what_keeps_the_keys_of_a_drain_is_told() {
    let bench = Bench::new();
    bench.write("mesh.obj", TETRAHEDRON);
    let told = |arguments: &[&str]| bench.run(arguments).out;
    let simplify = ["run", "std/simplify.hedge", "mesh.obj", "--set", "faces_left=4", "-v"];
    let said = told(&simplify);
    let line = said.lines().find(|line| line.starts_with("std/simplify.hedge:")).unwrap();
    assert!(line.ends_with(":3: keys of `drain` are updated incrementally"), "{said}");
    assert!(told(&simplify).contains(" to compile native code)"), "{}", told(&simplify));
    bench.write(
        "own.hedge",
        "fn far(v: vertex) -> int { var n = 0  var h = v.halfedge  while n < 9 { n = n + 1  h = h.next.next.twin }  degree(h.vertex) }
         script main() {
           drain v in vertices by far(v) { if degree(v) > 99 { print v } }
           drain v in vertices by degree(v) + count(edges) { if degree(v) > 99 { print v } }
         }",
    );
    let said = told(&["run", "own.hedge", "mesh.obj", "--verbose", "--format", "json"]);
    let said: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert!(said["seconds"]["native"].is_f64(), "{said}");
    let whys = ["the key follows pointers without bound", "the key reads all of the mesh"];
    for (at, why) in whys.into_iter().enumerate() {
        assert_eq!(said["drains"][at]["keys"], "updated by noting what they read", "{said}");
        assert_eq!(said["drains"][at]["because"], why, "{said}");
    }
}

#[test]
fn scripts_of_the_library_say_what_they_want() {
    let bench = Bench::new();
    for (script, mesh, set, words) in [
        ("remesh::remesh", "tetrahedron()", "target=-1", "0 for the mean length"),
        ("remesh::remesh", "tetrahedron()", "target=1e-9", "more than a billion edges"),
        ("remesh::remesh", "tetrahedron()", "share=5", "0 <= share <= 1"),
        ("smooth::laplacian", "cube()", "factor=3", "0 <= factor <= 1"),
        ("smooth::tangential", "cube()", "factor=-1", "0 <= factor <= 1"),
        ("subdivide::linear", "cube()", "iterations=1", "`linear_quads` cuts any polygons"),
    ] {
        bench.fails(1, &["run", &format!("std/{script}"), mesh, "--set", set], words);
    }
    let stiff = ["run", "std/simplify", "octahedron()", "--set=ratio=1", "--set=stiffness=-1"];
    bench.fails(1, &stiff, "a stiffness of at least zero");
}

#[test]
fn functions_of_the_library_demand_triangles() {
    let bench = Bench::new();
    for (file, call) in [
        ("curvature", "set_curvatures()"),
        ("distance", "set_geodesic_distances()"),
        ("subdivide", "linear_once()"),
        ("subdivide", "loop_once()"),
        ("subdivide", "butterfly_once()"),
        ("subdivide", "sqrt3_once()"),
    ] {
        bench.write("go.hedge", format!("use \"std/{file}.hedge\"\nscript go() {{ {call} }}\n"));
        bench.fails(1, &["run", "go.hedge", "cube()"], "triangles");
    }
}
