//! Readers that go away, and colours.

use std::io::Read;
use std::process::Stdio;

use crate::bench::{Bench, example};

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let bench = Bench::with_square();
    let script = "script s() { repeat 20000 { print \"a line of some length\" } }";
    bench.write("s.hedge", script);
    bench.write("endless.hedge", "script s() { while true { print 1 } }");
    let flip = example("flip.hedge");
    let plan = format!("{flip}::flip");
    for arguments in [
        &["run", "s.hedge", "square.obj", "-o", "out.obj"][..],
        // Nothing else can come of it.
        &["run", "endless.hedge", "square.obj"],
        &["check", &flip],
        &["check", &flip, "--format", "json"],
        &["plan", &plan],
        &["info", "square.obj"],
        &["--help"],
    ] {
        let mut command = bench.command(arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut out = child.stdout.take().unwrap();
        let _ = out.read(&mut [0]);
        drop(out);
        let output = child.wait_with_output().unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {err}");
        assert_eq!(err, "", "{arguments:?}");
    }
    assert!(bench.has("out.obj"), "the result is written all the same");
}

#[cfg(target_os = "linux")]
#[test]
fn what_is_said_in_vain_is_a_failure() {
    let bench = Bench::with_square();
    let flip = example("flip.hedge");
    for arguments in [&["check", &flip][..], &["info", "square.obj"], &["std"], &["fmt", "-"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
        let mut command = bench.command(arguments);
        command.stdin(std::fs::File::open(&flip).unwrap());
        let output = command.stdout(full.unwrap()).output().unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {err}");
        assert!(err.contains("cannot write to standard output"), "{err}");
    }
}

#[test]
fn no_colours_but_on_a_terminal() {
    let bench = Bench::new();
    bench.write("bad.hedge", "op f(e: edge) { before { edge e: a | d } after { } }");
    for colour in [None, Some(""), Some("1")] {
        let mut command = bench.command(&["check", "bad.hedge"]);
        match colour {
            Some(value) => command.env("NO_COLOR", value),
            None => command.env_remove("NO_COLOR"),
        };
        let output = command.env("CLICOLOR_FORCE", "1").output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert!(err.contains("error[") && !err.contains('\u{1b}'), "{err}");
    }
}

/// What the program shows on a terminal of 70 columns, which `script` of util-linux makes, if
/// it has these words; `None` where there is no such program.
#[cfg(target_os = "linux")]
fn on_terminal(bench: &Bench, arguments: &str, [no_colour, words]: [&str; 2]) -> Option<String> {
    let program = env!("CARGO_BIN_EXE_hedgerow");
    let line = format!("stty rows 40 cols 70 && {program} {arguments}");
    let mut command = std::process::Command::new("script");
    command
        .args(["-qec", &line, "/dev/null"])
        .current_dir(bench.path(""))
        .env("NO_COLOR", no_colour)
        .stdin(Stdio::null());
    let shown = String::from_utf8_lossy(&command.output().ok()?.stdout).into_owned();
    shown.contains(words).then_some(shown)
}

/// Long lines of tables are wrapped on a terminal, and whole elsewhere.
#[cfg(target_os = "linux")]
#[test]
fn tables_fit_into_a_terminal() {
    let bench = Bench::new();
    let longest = |text: &str| text.lines().map(|line| line.trim_end().chars().count()).max();
    for command in ["std", "explain", "explain functions", "explain missing-reassignment"] {
        let arguments: Vec<_> = command.split(' ').collect();
        assert!(longest(&bench.succeeds(&arguments)) > Some(100), "{command}");
        if let Some(shown) = on_terminal(&bench, command, ["", "edge"]) {
            assert!(longest(&shown) <= Some(70), "{shown}");
        }
    }
}

/// On a terminal there are colours; not with `NO_COLOR`.
#[cfg(target_os = "linux")]
#[test]
fn colours_on_a_terminal() {
    let bench = Bench::new();
    bench.write("bad.hedge", "op f(e: edge) { before { edge e: a | d } after { } }");
    let shown = |no_colour| on_terminal(&bench, "check bad.hedge", [no_colour, "error["]);
    let (Some(with), Some(without)) = (shown(""), shown("1")) else {
        return; // no such program here
    };
    assert!(with.contains('\u{1b}'), "{with}");
    assert!(!without.contains('\u{1b}'), "{without}");
}

#[test]
fn meshes_come_from_standard_input() {
    let bench = Bench::with_square();
    for format in ["obj", "ply", "stl", "off", "msh", "halfedges"] {
        let name = format!("square.{format}");
        if format != "obj" {
            bench.succeeds(&["convert", "square.obj", &name]);
        }
        let bytes = std::fs::read(bench.path(&name)).unwrap();
        for arguments in [&["convert", "-", "-"][..], &["run", "std/triangulate", "-", "-o", "-"]] {
            let said = bench.fed(arguments, &bytes);
            assert_eq!(said.code, 0, "{format}: {said:?}");
            assert_eq!(said.out.matches("\nf ").count(), 2, "{format}: {said:?}");
        }
        let said = bench.fed(&["info", "-"], &bytes);
        assert!(said.code == 0 && said.out.contains("of level simple"), "{format}: {said:?}");
    }
    let said = bench.fed(&["info", "-"], b"f 1 2 3\n");
    assert!(said.code == 2 && said.err.contains("there is no vertex 3"), "{said:?}");
    let said = bench.fed(&["run", "std/triangulate", "-", "--reorder"], b"");
    assert!(said.code == 2 && said.err.contains("not for standard input"), "{said:?}");
}

#[test]
fn what_an_stl_file_loses_is_told() {
    let bench = Bench::new();
    let pinched = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 5 5 5\nf 1 2 3\nf 1 4 5\n";
    bench.write("pinched.obj", pinched);
    let said = bench.run(&["convert", "pinched.obj", "out.stl", "--repair"]);
    assert!(said.err.contains("1 vertex lies where another does"), "{said:?}");
    assert!(said.err.contains("1 vertex without a face is left out"), "{said:?}");
    let said = bench.run(&["convert", "pinched.obj", "out.ply", "--repair"]);
    assert!(said.code == 0 && !said.err.contains("vertex lies"), "{said:?}");
}
