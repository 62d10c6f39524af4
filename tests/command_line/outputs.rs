//! Where results go: whole files or none.

use std::fs;

use crate::bench::{Bench, example, flip};

fn runs(output: &str) -> Vec<[String; 6]> {
    let words = |words: [&str; 6]| words.map(String::from);
    let remesh = example("remesh.hedge");
    let to = format!("-o{output}");
    vec![
        words(["run", &remesh, "square.obj", &to, "--set", "iterations=1"]),
        words(["apply", &flip(), "square.obj", &to, "--at", "edge:1-3"]),
    ]
}

fn fail(bench: &Bench, output: &str, words: &str) {
    let before = bench.files();
    for arguments in runs(output) {
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        let said = bench.fails(2, &arguments, words);
        assert!(said.err.contains(output), "{said:?}");
        assert_eq!(said.out, "", "nothing is done in vain");
    }
    assert_eq!(bench.files(), before);
}

#[test]
fn a_folder_that_does_not_exist() {
    let bench = Bench::with_square();
    fail(&bench, "nowhere/out.obj", "the folder `nowhere` does not exist");
}

#[test]
fn a_folder_instead_of_a_file() {
    let bench = Bench::with_square();
    fs::create_dir(bench.path("folder")).unwrap();
    fail(&bench, "folder", "this is a folder");
    fail(&bench, "folder/", "this is a folder");
    fail(&bench, "square.obj/out.obj", "does not exist");
}

#[cfg(target_os = "linux")]
#[test]
fn a_place_that_takes_nothing() {
    let bench = Bench::with_square();
    for arguments in runs("/dev/full") {
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        bench.fails(2, &arguments, "/dev/full");
    }
    for arguments in runs("/dev/null") {
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        assert_eq!(bench.run(&arguments).code, 0);
    }
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[cfg(unix)]
#[test]
fn a_folder_that_is_closed() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::with_square();
    let folder = bench.path("closed");
    fs::create_dir(&folder).unwrap();
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o555)).unwrap();
    // Whoever may write everywhere finds nothing closed.
    if fs::write(folder.join("probe"), "").is_err() {
        for arguments in runs("closed/out.obj") {
            let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
            bench.fails(2, &arguments, "closed/out.obj");
        }
    }
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o755)).unwrap();
}

#[test]
fn the_mesh_itself_may_be_written_over() {
    let bench = Bench::with_square();
    for arguments in runs("square.obj") {
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        assert_eq!(bench.run(&arguments).code, 0);
    }
    assert_eq!(bench.files(), ["square.obj"]);
    bench.succeeds(&["info", "square.obj"]);
}

#[test]
fn pictures_go_nowhere_either() {
    let bench = Bench::with_square();
    fs::create_dir(bench.path("folder.svg")).unwrap();
    for output in ["nowhere/p.svg", "folder.svg", "picture", "picture.obj"] {
        bench.fails(2, &["draw", &flip(), "-o", output], output);
        bench.fails(2, &["view", "square.obj", "-o", output], output);
    }
    for output in ["page.png", "page.SVG"] {
        let words = "a page is no picture: write -o page.html";
        bench.fails(2, &["draw", &flip(), "--html", "-o", output], words);
    }
    assert_eq!(bench.files(), ["folder.svg", "square.obj"]);
}
