//! `check --aliases`, as it is called.

use std::fs;
use std::process::Command;

#[test]
fn verdicts_are_printed_and_meshes_written() {
    let folder = tempfile::tempdir().unwrap();
    let program = folder.path().join("contract.hedge");
    fs::write(&program, include_str!("../../../examples/contract.hedge")).unwrap();
    let out = folder.path().join("out");
    let run = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hedgerow"));
        command.args(["check", "--aliases"]).args(more).arg(&program);
        let output = command.output().unwrap();
        assert!(output.status.success());
        String::from_utf8(output.stdout).unwrap()
    };
    let text = run(&["--witness", out.to_str().unwrap()]);
    assert!(text.contains("would break  f0 = f1"), "{text}");
    assert!(text.contains("is impossible  v0 = v1"), "{text}");
    let mut written: Vec<_> = fs::read_dir(&out)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    written.sort();
    let name = "contract-alias-breaks-1";
    assert!(written.contains(&format!("{name}.halfedges")), "{written:?}");
    assert!(written.contains(&format!("{name}.svg")), "{written:?}");
    let json: serde_json::Value = serde_json::from_str(&run(&["--format", "json"])).unwrap();
    let sets = json["files"][0]["aliases"][0]["sets"].as_array().unwrap();
    let faces = sets.iter().find(|set| set["names"][0][0] == "f0").unwrap();
    assert_eq!(faces["verdict"], "breaks");
}

#[test]
fn a_list_that_is_not_complete_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let run = |sides: usize, more: &[&str]| {
        let arrows: String = (0..sides).map(|at| format!("v{at} -h{at}-> ")).collect();
        let text = format!(
            "op look(h0: halfedge) {{ before {{ face f: {arrows}v{sides} =P=> v0 }} after {{ keep f }} }}"
        );
        let program = folder.path().join(format!("look{sides}.hedge"));
        fs::write(&program, text).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_hedgerow"));
        let output = command.args(["check", "--aliases"]).args(more).arg(&program);
        String::from_utf8(output.output().unwrap().stdout).unwrap()
    };
    for (sides, is_complete) in [(2, true), (5, false)] {
        let text = run(sides, &[]);
        assert_eq!(!text.contains("were not examined"), is_complete, "{text}");
        let json: serde_json::Value =
            serde_json::from_str(&run(sides, &["--format", "json"])).unwrap();
        assert_eq!(json["files"][0]["aliases"][0]["complete"], is_complete, "{json}");
    }
}
