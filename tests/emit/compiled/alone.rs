//! Each operation emitted alone, without what others of its file bring along.
//!
//! A compiler takes half a second for each, so every day a few others are tried, in turn:
//! `HEDGEROW_ALONE=all` tries all, `HEDGEROW_ALONE=NAME` those whose names begin so.

use std::fs;
use std::time::{SystemTime, UNIX_EPOCH};

use hedgerow::emit::{Style, cpp};
use tempfile::TempDir;

use crate::compiled::compiler::{compile, folder, has_compiler};
use crate::cpp::{accessors, declared};
use support::emission::subjects::{Emission, emissions};

/// How many are tried in a day.
const DAILY: usize = 4;

#[test]
fn an_operation_compiles_without_the_others() {
    if !has_compiler() {
        return;
    }
    let emissions = emissions();
    let ops = |emission: &Emission| emission.ops.clone().into_iter().zip(0..);
    let all = emissions.iter().flat_map(|emission| ops(emission).map(move |op| (emission, op)));
    let mut all: Vec<_> = all.map(|(emission, (op, at))| (emission, op, at)).collect();
    assert!(all.len() > 90, "only {} operations", all.len());
    match std::env::var("HEDGEROW_ALONE").as_deref() {
        Ok("all") => {}
        Ok(name) => all.retain(|(emission, _, at)| emission.subjects[*at].name.starts_with(name)),
        Err(_) => {
            let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap();
            let day = (since.as_secs() / (24 * 60 * 60)) as usize;
            let first = day * DAILY % all.len();
            all.rotate_left(first);
            all.truncate(DAILY);
        }
    }
    assert!(!all.is_empty(), "no operation is called so");
    let bench = TempDir::new().unwrap();
    let write = |name: &str, text: &str| fs::write(bench.path().join(name), text).unwrap();
    let styles =
        [(Style::default(), "fields.h", "-std=c++17"), (accessors(), "accessors.h", "-std=c++20")];
    let each = all.into_iter().flat_map(|tried| styles.iter().map(move |style| (tried, style)));
    for ((emission, op, at), (style, header, standard)) in each {
        println!("{} with {header}", emission.subjects[at].name);
        let code = cpp(&emission.of(&[op]), style).unwrap();
        write("mesh.h", &fs::read_to_string(folder("tests/emit").join(header)).unwrap());
        write("declared.h", &declared(&code));
        write("alone.cpp", &format!("#include \"mesh.h\"\n{code}"));
        let args = [standard, "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-pedantic"];
        compile(bench.path(), "g++", &[&args[..], &["alone.cpp"]].concat());
    }
}
