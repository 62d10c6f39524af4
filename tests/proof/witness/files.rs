//! What `check --witness` writes, and `info` reads.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use hedgerow::mesh::{read_dump, read_mesh, same_connectivity, validate};

fn hedgerow(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_hedgerow"));
    command.args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

const FLIP: &str = "
op flip(e: edge) {
  rule inner {
    before {
      face f0: v0 -a-> v1 -b-> v2 -c-> v0
      face f1: v1 -d-> v0 -g-> v3 -h-> v1
      edge e: a | d
    }
    after {
      face f0: v2 -a-> v3 -c-> v0 -g-> v2
      face f1: v3 -d-> v2 -h-> v1 -b-> v3
      edge e: a | d
    }
  }
}

op contract(e: edge) -> v0 {
  before {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  after {
    loop f0: v0 =P=> v0
    loop f1: v0 =Q=> v0
    erase v1 e a d
  }
}
";

#[test]
fn counterexamples_are_written_and_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let program = folder.path().join("broken.hedge");
    fs::write(&program, FLIP).unwrap();
    let witness = folder.path().join("deep/witness");
    let (program, shown) = (program.to_str().unwrap(), witness.to_str().unwrap());
    let output = hedgerow(&["check", program, "--witness", shown]);
    assert_eq!(output.status.code(), Some(1));
    let name = "flip-inner-two-vertices-one-ring-1";
    let expected = [
        "contract-stale-vertex-1.halfedges".to_owned(),
        "contract-stale-vertex-1.svg".to_owned(),
        format!("{name}.halfedges"),
        format!("{name}.obj"),
        format!("{name}.svg"),
    ];
    assert_eq!(names(&witness), expected);

    let path = witness.join(&expected[2]);
    let dump = read_dump(&fs::read_to_string(&path).unwrap()).unwrap();
    let [(_, before), (_, after)] = dump.meshes.as_slice() else {
        panic!("before and after");
    };
    assert_eq!(validate(before), Ok(()));
    assert!(validate(after).is_err());
    assert!(dump.names.iter().any(|(name, of)| name == "a" && of.len() == 1));
    let obj = read_mesh(&witness.join(&expected[3]), None).unwrap();
    assert!(same_connectivity(&obj.mesh, before));

    let output = hedgerow(&["info", path.to_str().unwrap()]);
    let told = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(told.contains("valid, of level simple"), "{told}");
    assert!(told.contains("broken: halfedge"), "{told}");
    let output = hedgerow(&["info", "--format", "json", path.to_str().unwrap()]);
    assert!(text(&output.stdout).contains("\"after\": {"));
}

#[test]
fn nothing_is_written_when_all_is_proved() {
    let folder = tempfile::tempdir().unwrap();
    let witness = folder.path().join("witness");
    let program = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/flip.hedge");
    let output = hedgerow(&["check", program, "--witness", witness.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0));
    assert!(!witness.exists());
}

#[test]
fn a_broken_dump_is_refused_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.halfedges");
    fs::write(&path, "mesh before\nvertex 0\n").unwrap();
    let output = hedgerow(&["info", path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("line 2: expected `vertex ID halfedge ID at X Y Z`"));
}
