//! Scripts that would not end are stopped by Ctrl-C, and leave nothing behind.

#![cfg(unix)]

use std::collections::BTreeSet;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Instant;

use crate::bench::{Bench, SQUARE};

/// Runs a command until it prints a line, interrupts it, and gives its code and what it
/// complained of.
fn interrupted(bench: &Bench, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = bench.command(arguments);
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    out.read_line(&mut line).unwrap();
    assert_eq!(line, "begun\n");
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status().unwrap();
    assert!(sent.success());
    let said = child.wait_with_output().unwrap();
    let err = String::from_utf8(said.stderr).unwrap();
    (said.status.code(), err)
}

#[test]
fn an_endless_script_leaves_no_file() {
    let loops = [
        "var n = 0 while true { n = n + 1 }",
        "var n = 0 while true { n = n + count(boundary(e) for e in edges) }",
    ];
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    let mut count = 0;
    for endless in loops {
        let script = format!("script s() {{ print \"begun\" {endless} }}");
        bench.write("s.hedge", script);
        bench.write("old.obj", "old");
        for to in ["new.obj", "old.obj", "new.halfedges"] {
            let (code, err) = interrupted(&bench, &["run", "s.hedge", "m.obj", "-o", to]);
            assert_eq!(code, Some(130), "{err}");
            assert!(err.contains("error[interrupted]"), "{err}");
            count += 1;
        }
        assert_eq!(bench.read("old.obj"), "old");
        assert_eq!(bench.files(), ["m.obj", "old.obj", "s.hedge"]);
    }
    assert_eq!(count, 6);
}

#[test]
fn what_was_done_until_then_is_told() {
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    let flips = "use \"std/triangle.hedge\" script s() { for e in edges { flip(e) }";
    bench.write(
        "endless.hedge",
        format!("{flips} print \"begun\" var n = 0 while true {{ n = n + 1 }} }}"),
    );
    let (code, endless) = interrupted(&bench, &["run", "endless.hedge", "m.obj"]);
    assert_eq!(code, Some(130), "{endless}");
    bench.write("fails.hedge", format!("{flips} assert count(faces) < 0 }}"));
    let fails = bench.run(&["run", "fails.hedge", "m.obj"]).err;
    for told in [endless, fails] {
        let table = told.split_once("until it stopped:\n").unwrap().1;
        assert!(table.starts_with("op    applied  refused\nflip"), "{told}");
        assert!(table.find("error[") > table.find("hole"), "{told}");
    }
}

#[test]
fn what_refuses_without_end_is_told() {
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    let script = "use \"std/triangle.hedge\"
op wait(e: edge) { steps { while count(faces) > 0 { flip(e) } } }
script s() { print \"begun\" for e in edges where boundary(e) { wait(e) } }";
    bench.write("s.hedge", script);
    for engine in ["native", "machine"] {
        let (_, err) = interrupted(&bench, &["run", "s.hedge", "m.obj", "--engine", engine]);
        assert!(err.contains("note: `flip` was the last to refuse: "), "{err}");
    }
}

#[test]
fn nothing_is_written_once_it_is_interrupted() {
    let bench = Bench::new();
    // Whatever moment the signal comes at, the file is the old one or the whole new one.
    let arguments = ["convert", "icosphere(7)", "new.ply", "--encoding", "ascii"];
    let started = Instant::now();
    bench.succeeds(&arguments);
    let time = started.elapsed();
    let whole = bench.read("new.ply");
    let mut codes = BTreeSet::new();
    for step in 0..16 {
        bench.write("new.ply", "old");
        let mut command = bench.command(&arguments);
        let child = command.stderr(Stdio::piped()).spawn().unwrap();
        sleep(time * step / 8);
        let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).output().unwrap();
        let said = child.wait_with_output().unwrap();
        let written = bench.read("new.ply");
        assert!(written == "old" || written == whole, "a part is written");
        assert_eq!(bench.files(), ["new.ply"], "{said:?}");
        let was_stopped = written == "old";
        assert_eq!(said.status.code() == Some(0), !was_stopped, "{said:?}, {sent:?}");
        codes.insert(said.status.code());
    }
    assert!(codes.len() > 1, "it was never stopped, or always: {codes:?}");
}

#[test]
fn a_pipe_without_a_reader_is_left_at_once() {
    let bench = Bench::new();
    bench.write("m.obj", SQUARE);
    bench.write("s.hedge", "script s() { print \"begun\" }");
    // More than a pipe holds, whose reader does not read.
    let mut command = bench.command(&["convert", "icosphere(6)", "-"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    out.read_line(&mut String::new()).unwrap();
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    for pipe in ["p.obj", "p.halfedges"] {
        let made = Command::new("mkfifo").arg(bench.path(pipe)).status();
        assert!(made.unwrap().success());
        let (code, err) = interrupted(&bench, &["run", "s.hedge", "m.obj", "-o", pipe]);
        assert_eq!(code, Some(130), "{err}");
    }
}
