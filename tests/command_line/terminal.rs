//! What is printed to a terminal: lines that fit into it, with every word that a file would have.

use std::fs::File;
use std::io::Read;
use std::process::Stdio;

use nix::pty::{Winsize, openpty};
use regex::Regex;

use crate::bench::{Bench, example};

/// What a command prints to a terminal of some columns, both streams together.
fn in_terminal(bench: &Bench, columns: u16, arguments: &[&str], kind: &str) -> String {
    let size = Winsize { ws_row: 40, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 };
    let ends = openpty(&size, None).unwrap();
    let mut command = bench.command(arguments);
    command.env("TERM", kind).env_remove("NO_COLOR").stdin(Stdio::null());
    command.stdout(ends.slave.try_clone().unwrap()).stderr(ends.slave);
    let mut child = command.spawn().unwrap();
    // From now on only the child holds that end.
    drop(command);
    let mut printed = Vec::new();
    // A terminal without another end is an error on Linux, and at its end elsewhere.
    let _ = File::from(ends.master).read_to_end(&mut printed);
    child.wait().unwrap();
    String::from_utf8(printed).unwrap().replace("\r\n", "\n")
}

/// What a command prints to files.
fn in_files(bench: &Bench, arguments: &[&str]) -> String {
    let output = bench.command(arguments).output().unwrap();
    String::from_utf8([output.stderr, output.stdout].concat()).unwrap()
}

fn without_colours(text: &str) -> String {
    Regex::new("\u{1b}\\[[0-9;]*[A-Za-z]").unwrap().replace_all(text, "").into_owned()
}

/// The words of a text, however it is broken into lines.
fn words(text: &str) -> Vec<&str> {
    text.split_whitespace().collect()
}

/// Whether a line is of the drawing of a mistake, or its head.
fn is_drawn(line: &str) -> bool {
    line.contains(['│', '╭', '╯']) || line.starts_with("error[") || line.starts_with("warning[")
}

#[test]
fn all_is_printed_in_lines_that_fit() {
    let bench = Bench::with_square();
    bench.write("bad.hedge", "op f(e: edge) { before { edge e: a | d } after { } }");
    bench.write("quad.hedge", "op f(h: halfedge) { before { v0 -h-> v1 -b-> v2 } after { } }");
    let flip = example("flip.hedge");
    let mut wide = 0;
    for arguments in [
        &["explain"][..],
        &["explain", "functions"],
        &["explain", "std"],
        &["explain", "flip_edge"],
        &["explain", "missing-reassignment"],
        &["explain", "no-such-word"],
        &["std"],
        &["check", &flip],
        &["check", &flip, "--explain", "--verbose"],
        &["check", "bad.hedge"],
        &["check", "quad.hedge"],
        &["info", "square.obj"],
        &["apply", "bad.hedge::g", "square.obj", "--at", "e1", "-o", "out.obj"],
    ] {
        let whole = in_files(&bench, arguments);
        for columns in [40, 60, 80, 120] {
            let printed = without_colours(&in_terminal(&bench, columns, arguments, "xterm"));
            assert_eq!(words(&printed), words(&whole), "{arguments:?} in {columns} columns");
            let mut is_code = false;
            for line in printed.lines() {
                is_code ^= line.trim_start().starts_with("```");
                // Signatures and the columns of a table are not broken.
                let is_whole = columns < 60 || is_code || is_drawn(line);
                let fits = line.chars().count() <= columns.into();
                assert!(is_whole || fits, "{arguments:?} in {columns} columns: {line}");
            }
            wide += whole.lines().filter(|line| line.chars().count() > columns.into()).count();
        }
    }
    assert!(wide > 100, "of the lines only {wide} were to be broken");
}

#[test]
fn colours_are_for_terminals_that_have_them() {
    let bench = Bench::new();
    bench.write("bad.hedge", "op f(e: edge) { before { edge e: a | d } after { } }");
    let check = ["check", "bad.hedge"];
    let printed = in_terminal(&bench, 80, &check, "xterm");
    assert!(printed.contains("\u{1b}[31merror"), "{printed}");
    // What stands beside a mistake has the colour of the terminal, dark or light.
    assert!(printed.contains("\u{1b}[39m") && !printed.contains("\u{1b}[38;5;249m"), "{printed}");
    assert_eq!(without_colours(&printed), in_terminal(&bench, 80, &check, "dumb"));
}
