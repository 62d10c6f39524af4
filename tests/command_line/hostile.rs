//! Programs and files that would do harm: fill the memory, or speak to the terminal.

use hedgerow::cli::memory;

use crate::bench::Bench;

const GROW: &str = "
private attr big: halfedge mat4 = mat4(0)
op split(e: edge) -> m {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    face f0: v0 -a-> m -p-> v2 -c-> v0
    face f2: m -q-> v1 -b-> v2 -r-> m
    face f1: v1 -d-> m -s-> v3 -h-> v1
    face f3: m -t-> v0 -g-> v3 -u-> m
    edge e: a | t
    edge e1: q | d
    edge e2: p | r
    edge e3: s | u
    new m p q r s t u f2 f3 e1 e2 e3
    m.position = (v0.position + v1.position) / 2
  }
}
op many(e: edge) {
  steps {
    while true { must split(e) }
  }
}
script grow() { while true { for e in edges { split(e) } } }
script steps() { for e in edges { many(e) } }
script wide() { while true { for h in halfedges { h.big = mat4(1) } for e in edges { split(e) } } }
";

#[test]
fn who_creates_without_end_is_stopped_at_the_limit() {
    let bench = Bench::with_square();
    bench.write("grow.hedge", GROW);
    for script in ["grow", "steps", "wide"] {
        let script = format!("grow.hedge::{script}");
        let run = ["run", &script, "square.obj", "-o", "out.obj", "--memory", "3M"];
        let said = bench.fails(1, &run, "error[no-room]: there is no room for more in 3 MiB");
        assert!(said.err.contains("grow.hedge:"), "it says where: {said:?}");
    }
    assert_eq!(bench.files(), ["grow.hedge", "square.obj"]);
    let run = ["run", "grow.hedge::grow", "square.obj", "--memory", "much"];
    bench.fails(2, &run, "`much` is not a size");
}

#[test]
fn keys_and_tests_keep_to_the_limit() {
    let bench = Bench::with_square();
    bench.write(
        "keys.hedge",
        "fn move(h: halfedge) { h.vertex.position = vec3(0) }
fn keyed() { drain h in halfedges by length(h) while count(vertices) < 0 { move(h) } }
test \"keys\" { mesh = grid(40, 40)  keyed() }
test \"none\" {
  mesh = grid(40, 40)
  repeat 10 { for v in vertices { v.position = v.position * 1.0 } }
}
",
    );
    let said = bench.run(&["test", "keys.hedge", "--memory", "400K"]);
    assert!(said.out.contains("1 passed, 1 failed"), "{said:?}");
    assert!(said.err.contains("error[no-room]: there is no room for more in 400 KiB"), "{said:?}");
    assert!(said.out.contains("ok      none"), "the mesh itself has room: {said:?}");
    assert!(bench.succeeds(&["test", "keys.hedge", "--memory", "4M"]).contains("2 passed"));
}

#[test]
fn nothing_speaks_to_the_terminal() {
    let bench = Bench::with_square();
    let evil = "\u{1b}]0;owned\u{7}\u{9b}2J\u{202e}";
    let op = "
op refuse(v: vertex) {
  before { face f: v -a-> w =P=> v }
  require degree(v) < 0 else \"REASON\"
  after { face f: v -a-> w =P=> v }
}
script s() {
  print \"REASON\"
  for v in vertices { refuse(v) }
  assert count(vertices) < 0 else \"REASON\"
}
script t() {
  for v in vertices { refuse(v) }
}
";
    bench.write("e.hedge", op.replace("REASON", evil));
    let named = format!("{evil}.obj");
    bench.write(&named, format!("{}\nw{evil} 1\n", bench.read("square.obj")));
    bench.write("broken.hedge", format!("op {evil} use \"{evil}\" // {evil}"));
    let mut said = Vec::new();
    for arguments in [
        &["run", "e.hedge::s", "square.obj"][..],
        &["run", "e.hedge::t", "square.obj"],
        &["apply", "e.hedge::refuse", "square.obj", "-o", "out.obj", "--at", "vertex:1"],
        &["run", "e.hedge::t", &named, "-o", "out.obj"],
        &["run", &named, "square.obj"],
        &["info", &named],
        &["info", &format!("no{evil}")],
        &["check", "broken.hedge"],
        &["check", &format!("no{evil}.hedge")],
        &["plan", "e.hedge::refuse"],
    ] {
        let output = bench.command(arguments).output().unwrap();
        let text = [output.stdout, output.stderr].concat();
        let text = String::from_utf8(text).expect("what is said is UTF-8");
        let raw = |c: char| (c.is_control() && c != '\n') || ('\u{202a}'..='\u{202e}').contains(&c);
        assert!(!text.contains(raw), "{arguments:?}: {text:?}");
        said.push(text);
    }
    let all = said.concat();
    assert!(all.matches("]0;owned").count() > 8, "what is harmless of it is shown: {all}");
    // For programs it is exact.
    let json = bench.json(&["run", "e.hedge::t", "square.obj"]);
    assert_eq!(json["ops"][0]["reasons"][0]["reason"], evil);
}

#[test]
fn sizes() {
    assert_eq!(memory::read("4G"), Ok(4 << 30));
    assert_eq!(memory::read("1.5 MiB"), Ok(3 << 19));
    assert_eq!(memory::read("2000000"), Ok(2_000_000));
    assert!(memory::read("4").unwrap_err().contains("as `4G`"));
    for wrong in ["", "G", "much", "-1G", "0", "nan", "1000"] {
        assert!(memory::read(wrong).is_err(), "{wrong}");
    }
    assert!(memory::usual() > 1 << 24);
}
