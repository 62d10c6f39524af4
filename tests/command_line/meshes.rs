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
    nothing.fails(2, &["info", "."], ".: ");
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
