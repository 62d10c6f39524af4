//! `hedgerow fmt`: files where they are, standard input to standard output.

use std::io::Write;
use std::process::Stdio;

use crate::bench::Bench;

const MESSY: &str = "attr  x:vertex real\n";
const TIDY: &str = "attr x: vertex real\n";
const BROKEN: &str = "attr  x:vertex real\nop f( {}\n";

fn through(bench: &Bench, arguments: &[&str], text: &[u8]) -> (Option<i32>, String, String) {
    let mut child = bench
        .command(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(text).unwrap();
    let output = child.wait_with_output().unwrap();
    let said = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), said(output.stdout), said(output.stderr))
}

#[test]
fn files_are_formatted_where_they_are() {
    let bench = Bench::new();
    bench.write("a.hedge", MESSY);
    bench.write("b.hedge", TIDY);
    assert_eq!(bench.succeeds(&["fmt", "a.hedge", "b.hedge"]), "");
    assert_eq!(bench.read("a.hedge"), TIDY);
    assert_eq!(bench.read("b.hedge"), TIDY);
    assert_eq!(bench.files().len(), 2);
}

#[test]
fn a_check_changes_nothing() {
    let bench = Bench::new();
    bench.write("a.hedge", MESSY);
    bench.write("b.hedge", TIDY);
    let said = bench.fails(1, &["fmt", "--check", "a.hedge", "b.hedge"], "a.hedge");
    assert_eq!(said.err, "`a.hedge` is not formatted\n");
    assert_eq!(bench.read("a.hedge"), MESSY);
    assert_eq!(bench.succeeds(&["fmt", "--check", "b.hedge"]), "");
}

#[test]
fn standard_input_goes_to_standard_output() {
    let bench = Bench::new();
    let answer = through(&bench, &["fmt", "-"], MESSY.as_bytes());
    assert_eq!(answer, (Some(0), TIDY.into(), String::new()));
    let (code, out, err) = through(&bench, &["fmt", "-", "--check"], MESSY.as_bytes());
    assert_eq!((code, out.as_str()), (Some(1), ""));
    assert_eq!(err, "`<stdin>` is not formatted\n");
    let (code, out, err) = through(&bench, &["fmt", "-"], b"\xff");
    assert_eq!((code, out.as_str()), (Some(2), ""));
    assert!(err.contains("not UTF-8"), "{err}");
}

#[test]
fn what_is_broken_is_told_and_stays() {
    let bench = Bench::new();
    bench.write("a.hedge", BROKEN);
    bench.fails(1, &["fmt", "a.hedge"], "syntax-error");
    assert_eq!(bench.read("a.hedge"), format!("{TIDY}op f( {{}}\n"));
}

#[test]
fn one_file_that_is_missing_keeps_no_other_from_being_formatted() {
    let bench = Bench::new();
    bench.write("b.hedge", MESSY);
    bench.fails(2, &["fmt", "a.hedge", "b.hedge"], "cannot read `a.hedge`");
    assert_eq!(bench.read("b.hedge"), TIDY);
    bench.fails(2, &["fmt"], "--help");
}

#[cfg(unix)]
#[test]
fn a_link_and_the_permissions_of_a_file_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let bench = Bench::new();
    bench.write("a.hedge", MESSY);
    let mode = std::fs::Permissions::from_mode(0o640);
    std::fs::set_permissions(bench.path("a.hedge"), mode).unwrap();
    symlink("a.hedge", bench.path("b.hedge")).unwrap();
    bench.succeeds(&["fmt", "b.hedge"]);
    assert_eq!(bench.read("a.hedge"), TIDY);
    assert!(bench.path("b.hedge").is_symlink());
    let mode = std::fs::metadata(bench.path("a.hedge")).unwrap().permissions();
    assert_eq!(mode.mode() & 0o777, 0o640);
}
