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

/// The file may be written, but no other one can be made beside it.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_new_file() {
    let bench = Bench::with_square();
    fail(&bench, "/proc/self/comm", "can be made in the folder `/proc/self`");
}

#[cfg(unix)]
#[test]
fn a_file_that_is_protected_stays_as_it_is() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::with_square();
    bench.write("kept.obj", "# mine\n");
    let kept = bench.path("kept.obj");
    std::os::unix::fs::symlink("kept.obj", bench.path("link.obj")).unwrap();
    bench.write("kept.hedge", "script   s() { }\n");
    for name in ["kept.obj", "kept.hedge"] {
        fs::set_permissions(bench.path(name), fs::Permissions::from_mode(0o444)).unwrap();
    }
    fail(&bench, "kept.obj", "the file is read-only");
    fail(&bench, "link.obj", "the file is read-only");
    bench.fails(2, &["fmt", "kept.hedge"], "the file is read-only");
    assert_eq!(bench.read("kept.obj"), "# mine\n");
    assert_eq!(bench.read("kept.hedge"), "script   s() { }\n");
    assert_eq!(fs::metadata(kept).unwrap().permissions().mode() & 0o777, 0o444);
}

/// `fsync` is asked for before the new file takes the name of the old one.
#[cfg(target_os = "linux")]
#[test]
fn what_is_written_is_on_the_disk_before_it_has_its_name() {
    let bench = Bench::with_square();
    bench.write(
        "watch.c",
        "#define _GNU_SOURCE\n#include <dlfcn.h>\n#include <stdio.h>\n#include <sys/stat.h>\n\
         int fsync(int file) {\n\
         struct stat new, old; FILE *told = fopen(\"synced\", \"a\"); fstat(file, &new);\n\
         fprintf(told, \"%ld %d\\n\", (long)new.st_size, stat(\"out.obj\", &old));\n\
         fclose(told); return 0; }\n",
    );
    let built = std::process::Command::new("cc")
        .args(["-shared", "-fPIC", "-o", "watch.so", "watch.c"])
        .current_dir(bench.path(""))
        .status();
    assert!(built.is_ok_and(|built| built.success()), "a C compiler is there, as for emitted code");
    let arguments = runs("out.obj").remove(1);
    let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
    let mut command = bench.command(&arguments);
    let output = command.env("LD_PRELOAD", bench.path("watch.so")).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let size = bench.read("out.obj").len();
    assert_eq!(bench.read("synced"), format!("{size} -1\n"), "all of it, when no name was there");
}

#[cfg(target_os = "linux")]
#[test]
fn standard_output_may_be_a_pipe() {
    let bench = Bench::with_square();
    for arguments in runs("/dev/stdout") {
        let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
        let said = bench.run(&arguments);
        assert_eq!(said.code, 0, "{said:?}");
        let of_mesh = |line: &str| matches!(line.get(..2), Some("v " | "f "));
        assert!(said.out.lines().all(of_mesh), "reports go elsewhere: {said:?}");
        assert!(said.out.lines().filter(|line| line.starts_with("f ")).count() >= 2, "{said:?}");
    }
    assert_eq!(bench.files(), ["square.obj"]);
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
        let words = "a page is not a picture: write -o page.html";
        bench.fails(2, &["draw", &flip(), "--html", "-o", output], words);
    }
    assert_eq!(bench.files(), ["folder.svg", "square.obj"]);
}

#[test]
fn a_dash_is_standard_output() {
    let bench = Bench::with_square();
    let apply = ["apply", &flip(), "square.obj", "--at", "edge:1-3", "-o", "-"];
    let said = bench.run(&apply);
    assert_eq!(said.code, 0, "{said:?}");
    assert!(said.out.starts_with("v ") && said.out.contains("\nf "), "{said:?}");
    assert!(said.err.contains("applied flip"), "{said:?}");
    let drawn = bench.run(&["draw", &flip(), "-o", "-"]);
    assert!(drawn.out.starts_with("<svg"), "{drawn:?}");
    assert_eq!(bench.files(), ["square.obj"], "no file has this name");
}

#[cfg(unix)]
#[test]
fn no_source_of_the_program_is_replaced() {
    let bench = Bench::with_square();
    let part = fs::read_to_string(example("flip.hedge")).unwrap();
    let program = "use \"part.hedge\"\nscript none() { }\n";
    bench.write("part.hedge", &part);
    bench.write("main.hedge", program);
    std::os::unix::fs::symlink("main.hedge", bench.path("link.obj")).unwrap();
    std::os::unix::fs::symlink("main.hedge", bench.path("link.svg")).unwrap();
    fs::hard_link(bench.path("part.hedge"), bench.path("hard.svg")).unwrap();
    for words in [
        "plan main.hedge::flip -o main.hedge",
        "plan main.hedge::flip --as cpp -o ./part.hedge",
        "draw main.hedge::flip --as text -o main.hedge",
        "draw main.hedge::flip --as svg -o part.hedge",
        "draw main.hedge --html -o main.hedge",
        "draw main.hedge::flip -o hard.svg",
        "run main.hedge square.obj -o link.obj",
        "run main.hedge square.obj --picture link.svg",
        "apply main.hedge::flip square.obj --at edge:1-3 -o link.obj",
    ] {
        let arguments: Vec<_> = words.split(' ').collect();
        bench.fails(2, &arguments, "this is a source of the program");
    }
    assert_eq!((bench.read("main.hedge").as_str(), bench.read("part.hedge")), (program, part));
    bench.succeeds(&["plan", "main.hedge::flip", "--as", "cpp", "-o", "flip.hpp"]);
}

#[test]
fn an_encoding_that_a_format_does_not_have() {
    let bench = Bench::with_square();
    for output in ["out.stl", "out.obj", "-"] {
        let arguments = ["convert", "square.obj", output, "--encoding", "big-endian"];
        bench.fails(2, &arguments, "`--encoding big-endian` is for .ply alone");
    }
    let binary = ["convert", "square.obj", "out.off", "--encoding", "binary"];
    bench.fails(2, &binary, "`--encoding binary` is for .ply and .stl");
    let version = ["convert", "square.obj", "out.ply", "--msh", "2.2"];
    bench.fails(2, &version, "`--msh` is for .msh alone");
    bench.succeeds(&["convert", "square.obj", "out.ply", "--encoding", "big-endian"]);
    assert_eq!(bench.files(), ["out.ply", "square.obj"]);
}
