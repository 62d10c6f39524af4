//! The workbench of a page: a program and a mesh, asked by messages.

use std::ops::ControlFlow;

use hedgerow::analysis::{Nowhere, Reader};
use hedgerow::play::{Host, Message, Workbench};
use serde_json::{Value, json};
use support::dice::Dice;

/// A page without files.
#[derive(Default)]
struct Page {
    looks: u64,
}

impl Host for Page {
    fn progress(&mut self, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        self.looks += 1;
        ControlFlow::Continue(())
    }

    fn reader(&self) -> Box<dyn Reader> {
        Box::new(Nowhere)
    }
}

fn ask_with(workbench: &mut Workbench, json: Value, bytes: &[u8]) -> Message {
    let question = Message { json, bytes: bytes.to_vec() };
    let question = Message::read(&question.write()).expect("what is written is read");
    workbench.answer(question, &mut Page::default())
}

fn ask(workbench: &mut Workbench, json: Value) -> Value {
    ask_with(workbench, json, &[]).json
}

const PROGRAM: &str = r#"
/// Turns an edge.
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  guard simple
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
  }
}
attr height: vertex real
script turn(times: int = 1) {
  repeat times { for e in edges { flip(e) } }
  update v in vertices { v.height = v.position.y }
  print "done"
}
"#;

fn with_program() -> Workbench {
    let mut workbench = Workbench::default();
    let answer =
        ask(&mut workbench, json!({ "ask": "program", "name": "p.hedge", "text": PROGRAM }));
    assert_eq!(answer["sound"], true);
    assert_eq!(answer["ops"][0]["name"], "flip");
    assert_eq!(answer["ops"][0]["parameters"], json!([["e", "edge", null]]));
    assert_eq!(answer["scripts"][0]["parameters"], json!([["times", "int", "1"]]));
    workbench
}

#[test]
fn an_operation_is_asked_applied_and_undone() {
    let mut workbench = with_program();
    let shape = ask(&mut workbench, json!({ "ask": "shape", "name": "octahedron" }));
    assert_eq!(shape["counts"], json!({ "vertices": 6, "edges": 12, "faces": 8, "holes": 0 }));
    let places = ask_with(&mut workbench, json!({ "ask": "places", "op": "flip" }), &[]);
    assert_eq!((&places.json["kind"], &places.json["applies"]), (&json!("edge"), &json!(12)));
    assert_eq!(places.bytes, [1; 12]);
    let at = json!({ "kind": "edge", "index": 3 });
    let names = ask(&mut workbench, json!({ "ask": "names", "op": "flip", "element": at }));
    let fate = |name: &str| {
        let names = names["names"].as_array().expect("there are names").iter();
        let mut found = names.filter(|it| it[0] == name);
        found.next().map(|it| (it[1]["kind"].clone(), it[2].clone()))
    };
    assert_eq!(fate("e"), Some((json!("edge"), json!("reassigned"))));
    assert_eq!(fate("v0"), Some((json!("vertex"), json!("kept"))));
    assert_eq!(names["names"].as_array().map(Vec::len), Some(13));
    let before = ask_with(&mut workbench, json!({ "ask": "view" }), &[]);
    let applied = ask(&mut workbench, json!({ "ask": "apply", "op": "flip", "element": at }));
    // The mesh that nobody chose is none to go back to.
    assert_eq!(applied["past"], json!([1, 0]));
    let refused = ask(&mut workbench, json!({ "ask": "apply", "op": "flip", "element": at }));
    assert!(refused["refused"].is_string() || refused["past"] == json!([2, 0]), "{refused}");
    ask(&mut workbench, json!({ "ask": "undo" }));
    if refused["refused"].is_null() {
        ask(&mut workbench, json!({ "ask": "undo" }));
    }
    let after = ask_with(&mut workbench, json!({ "ask": "view" }), &[]);
    assert_eq!(before.bytes, after.bytes);
    let redone = ask(&mut workbench, json!({ "ask": "redo" }));
    assert_ne!(redone["past"][0], json!(0));
    let changed = ask_with(&mut workbench, json!({ "ask": "view" }), &[]);
    assert_ne!(before.bytes, changed.bytes);
}

#[test]
fn a_chosen_element_is_for_the_parameter_that_is_not_given() {
    let text = "op move(v: vertex, w: vertex) {
      before { face f: v -a-> w =P=> v }
      after { face f: v -a-> w =P=> v  v.position = w.position }
    }";
    let mut workbench = Workbench::default();
    let program = json!({ "ask": "program", "name": "p.hedge", "text": text });
    assert_eq!(ask(&mut workbench, program)["sound"], true);
    ask(&mut workbench, json!({ "ask": "shape", "name": "octahedron" }));
    let given = json!({ "v": 1 });
    let asked = json!({ "ask": "places", "op": "move", "given": given });
    let places = ask_with(&mut workbench, asked, &[]);
    let index = places.bytes.iter().position(|&applies| applies == 1).expect("a neighbor");
    let at = json!({ "kind": "vertex", "index": index });
    let asked = json!({ "ask": "apply", "op": "move", "element": at, "given": given });
    assert_eq!(ask(&mut workbench, asked)["past"], json!([1, 0]));
}

#[test]
fn a_refusal_says_why_and_where() {
    let mut workbench = with_program();
    ask(&mut workbench, json!({ "ask": "shape", "name": "tetrahedron" }));
    let at = json!({ "kind": "edge", "index": 0 });
    let names = ask(&mut workbench, json!({ "ask": "names", "op": "flip", "element": at }));
    assert!(names["refused"].as_str().is_some_and(|why| !why.is_empty()), "{names}");
    assert_eq!(names["at"]["kind"], "edge");
    let places = ask(&mut workbench, json!({ "ask": "places", "op": "flip" }));
    assert_eq!((&places["applies"], &places["asked"]), (&json!(0), &json!(6)));
}

#[test]
fn a_script_runs_and_is_stepped_through() {
    let mut workbench = with_program();
    ask(&mut workbench, json!({ "ask": "shape", "name": "icosphere" }));
    let start = ask_with(&mut workbench, json!({ "ask": "view" }), &[]);
    let ran =
        ask(&mut workbench, json!({ "ask": "run", "script": "turn", "given": { "times": 2 } }));
    let total = ran["total"].as_u64().expect("it has applied some");
    assert!(total > 100, "{ran}");
    assert_eq!(ran["printed"], json!(["done"]));
    assert_eq!(ran["ops"][0]["applied"], ran["total"]);
    let view = json!({ "ask": "view", "attribute": "vertex.height" });
    let end = ask_with(&mut workbench, view.clone(), &[]);
    assert_eq!(end.json["coloured"], "vertex");
    assert!(end.json["legend"]["range"].is_array(), "{}", end.json);
    // Each step differs from the one before, and the last is the end of the script.
    let mut seen = vec![start.bytes.clone()];
    for to in 1..=5 {
        let answer = ask(&mut workbench, json!({ "ask": "seek", "to": to }));
        assert_eq!((&answer["at"], &answer["failed"]), (&json!(to), &Value::Null));
        let now = ask_with(&mut workbench, json!({ "ask": "view" }), &[]).bytes;
        assert_ne!(seen.last(), Some(&now));
        seen.push(now);
    }
    ask(&mut workbench, json!({ "ask": "seek", "to": 2 }));
    assert_eq!(ask_with(&mut workbench, json!({ "ask": "view" }), &[]).bytes, seen[2]);
    ask(&mut workbench, json!({ "ask": "seek", "to": 0 }));
    assert_eq!(ask_with(&mut workbench, json!({ "ask": "view" }), &[]).bytes, start.bytes);
    ask(&mut workbench, json!({ "ask": "seek", "to": total }));
    assert_eq!(ask_with(&mut workbench, view, &[]).bytes, end.bytes);
    ask(&mut workbench, json!({ "ask": "undo" }));
    assert_eq!(ask_with(&mut workbench, json!({ "ask": "view" }), &[]).bytes, start.bytes);
}

#[test]
fn every_state_of_a_run_is_had_whether_its_history_fits_into_memory_or_not() {
    let program = "use \"std/triangle.hedge\"\n\
        attr age: edge int = 0\n\
        script churn() {\n\
          repeat 2 {\n\
            for e in shuffle(edges) where length(e) > 0.3 { if split(e) { } else { flip(e) } }\n\
            for e in edges { e.age = e.age + 1 if length(e) < 0.2 { collapse(e) } }\n\
            for v in vertices { v.position = 1.01 * v.position }\n\
          }\n\
        }\n";
    let program = json!({ "ask": "program", "name": "p.hedge", "text": program });
    let view = json!({ "ask": "view", "attribute": "edge.age" });
    let mut told: Vec<Vec<Message>> = Vec::new();
    // All of it, some of it, and not even one step.
    for bytes in [usize::MAX, 100_000, 0] {
        let mut workbench = Workbench::default();
        workbench.limit_history(bytes);
        assert_eq!(ask(&mut workbench, program.clone())["sound"], true);
        ask(&mut workbench, json!({ "ask": "shape", "name": "icosphere" }));
        let run = json!({ "ask": "run", "script": "churn" });
        // The second run goes on where the first ended.
        ask(&mut workbench, run.clone());
        let start = ask_with(&mut workbench, view.clone(), &[]);
        let ran = ask(&mut workbench, run);
        let total = ran["total"].as_u64().expect("it has applied some");
        assert!(total > 300 && ran["failed"].is_null(), "{ran}");
        let end = ask_with(&mut workbench, view.clone(), &[]);
        let mut dice = Dice(3);
        let mut at = total;
        let mut seen = vec![start.clone(), end.clone()];
        for step in 0..40 {
            at = match step % 4 {
                0 => dice.below(total as usize + 1) as u64,
                1 => at.saturating_sub(1),
                2 => (at + 2).min(total),
                _ => [0, total][step / 4 % 2],
            };
            let answer = ask(&mut workbench, json!({ "ask": "seek", "to": at }));
            assert_eq!((&answer["at"], &answer["total"]), (&json!(at), &json!(total)), "{answer}");
            let now = ask_with(&mut workbench, view.clone(), &[]);
            for (place, known) in [(0, &start), (total, &end)] {
                assert!(at != place || now.bytes == known.bytes, "{at} of {total}");
            }
            seen.push(now);
        }
        told.push(seen);
    }
    for others in &told[1..] {
        for (at, (one, other)) in told[0].iter().zip(others).enumerate() {
            assert_eq!(one.json, other.json, "{at}");
            assert_eq!(one.bytes, other.bytes, "{at}");
        }
    }
}

#[test]
fn arrays_say_what_the_mesh_is() {
    let mut workbench = Workbench::default();
    for (name, triangles) in [("cube", 12), ("grid", 72), ("icosphere", 320)] {
        ask(&mut workbench, json!({ "ask": "shape", "name": name }));
        let view = ask_with(&mut workbench, json!({ "ask": "view" }), &[]);
        let arrays = view.json["arrays"].as_array().expect("there are arrays");
        let length = |name: &str| {
            let found = arrays.iter().find(|array| array["name"] == name);
            found.and_then(|array| array["length"].as_u64()).expect("it is there")
        };
        let all: u64 = arrays.iter().filter_map(|array| array["length"].as_u64()).sum();
        assert_eq!(view.bytes.len() as u64, 4 * all);
        assert_eq!(length("triangles"), 3 * triangles, "{name}");
        assert_eq!(length("faces"), triangles);
        assert_eq!(length("edges"), length("halfedges"));
        assert_eq!(json!(length("edgeIds")), view.json["counts"]["edges"]);
    }
}

/// The positions of a view, and its frame.
fn seen(workbench: &mut Workbench) -> (Vec<f32>, Value) {
    let view = ask_with(workbench, json!({ "ask": "view" }), &[]);
    let first = &view.json["arrays"][0];
    assert_eq!(first["name"], "positions");
    let length = first["length"].as_u64().unwrap() as usize;
    let (numbers, _) = view.bytes.as_chunks::<4>();
    let numbers = numbers.iter().take(length).map(|&bytes| f32::from_le_bytes(bytes));
    (numbers.collect(), view.json["frame"].clone())
}

#[test]
fn meshes_of_any_size_are_seen_alike() {
    let mut workbench = with_program();
    let names = |workbench: &mut Workbench| {
        let at = json!({ "kind": "edge", "index": 0 });
        ask(workbench, json!({ "ask": "names", "op": "flip", "element": at }))
    };
    let mut looks = Vec::new();
    for (size, away) in
        [("1", 0.0), ("1e308", 0.0), ("1e160", 0.0), ("1e-30", 0.0), ("1e-320", 0.0), ("1", 1e6)]
    {
        let size: f64 = size.parse().unwrap();
        let corner = |at: [f64; 3]| {
            let [x, y, z] = at.map(|part| part * size + away);
            format!("v {x:e} {y:e} {z:e}\n")
        };
        let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
        let text = corners.map(corner).concat() + "f 1 2 3\nf 1 3 4\n";
        let mesh = json!({ "ask": "mesh", "name": "m.obj" });
        assert_eq!(ask_with(&mut workbench, mesh, text.as_bytes()).json["counts"]["faces"], 2);
        let (positions, _) = seen(&mut workbench);
        looks.push((positions, names(&mut workbench)));
    }
    let near = |one: f32, other: f32| (one - other).abs() < 1e-3;
    for (positions, names) in &looks {
        assert!(
            positions.iter().zip(&looks[0].0).all(|(&one, &other)| near(one, other)),
            "{looks:?}"
        );
        let at = names.pointer("/at/at/0").unwrap_or(&names["names"][0][1]["at"][0]);
        assert!(at.as_f64().is_some_and(|at| at.abs() <= 2.0), "{names}");
    }
}

#[test]
fn a_mesh_that_changes_is_seen_to_grow_as_long_as_it_can_be_shown() {
    let mut workbench = Workbench::default();
    let text = "script grow(by: real) { update v in vertices { v.position = by * v.position } }";
    let program = json!({ "ask": "program", "name": "p.hedge", "text": text });
    assert_eq!(ask(&mut workbench, program)["sound"], true);
    let (small, frame) = seen(&mut workbench);
    let grow = |by: f64| json!({ "ask": "run", "script": "grow", "given": { "by": by } });
    assert!(ask(&mut workbench, grow(2.0))["failed"].is_null());
    let (large, same) = seen(&mut workbench);
    assert_eq!((large[0], &same), (2.0 * small[0], &frame));
    ask(&mut workbench, grow(1e9));
    let (huge, other) = seen(&mut workbench);
    assert_ne!(other, frame);
    assert!(huge.iter().all(|part| part.abs() < 2.0));
}

#[test]
fn a_run_that_needs_too_much_memory_fails_and_what_is_there_stays() {
    let mut workbench = Workbench::default();
    workbench.limit_memory(1 << 20);
    let text = "use \"std/subdivide.hedge\" script grow() { loop_subdivide(9) }";
    let program = json!({ "ask": "program", "name": "p.hedge", "text": text });
    assert_eq!(ask(&mut workbench, program)["sound"], true);
    let run = json!({ "ask": "run", "script": "grow" });
    for _ in 0..2 {
        let failed = ask(&mut workbench, run.clone());
        assert!(failed["failed"].as_str().is_some_and(|why| why.contains("memory")), "{failed}");
        let counts = ask(&mut workbench, json!({ "ask": "undo" }))["counts"].clone();
        assert_eq!(counts["vertices"], 162);
    }
}

#[test]
fn code_counterexamples_and_files() {
    let mut workbench = with_program();
    for (language, word) in [("cpp", "twin"), ("rust", "pub fn")] {
        let code =
            ask(&mut workbench, json!({ "ask": "code", "op": "flip", "language": language }));
        assert!(code["text"].as_str().is_some_and(|text| text.contains(word)), "{code}");
    }
    let plan = ask(&mut workbench, json!({ "ask": "code", "op": "flip", "language": "plan" }));
    assert_eq!(plan["rules"][0]["phases"][2]["phase"], "reassign");
    let none = ask(&mut workbench, json!({ "ask": "counterexamples" }));
    assert_eq!(none["examples"], json!([]));
    // Broken: the last sound program stays.
    let text = PROGRAM
        .replace("face f1: v2 -d-> v3 -h-> v1 -b-> v2", "face f1: v2 -d-> v3 -b-> v1 -h-> v2");
    let broken = ask(&mut workbench, json!({ "ask": "program", "name": "p.hedge", "text": text }));
    assert_eq!((&broken["sound"], &broken["ops"][0]["name"]), (&json!(false), &json!("flip")));
    let examples = ask_with(&mut workbench, json!({ "ask": "counterexamples" }), &[]);
    let example = &examples.json["examples"][0];
    assert!(example["svg"].as_str().is_some_and(|svg| svg.starts_with("<svg")), "{example}");
    assert!(example["names"].as_array().is_some_and(|names| names.len() > 8));
    let saved = ask_with(&mut workbench, json!({ "ask": "save", "name": "m.obj" }), &[]);
    let text = String::from_utf8(saved.bytes.clone()).expect("it is text");
    assert_eq!(text.lines().filter(|line| line.starts_with("f ")).count(), 320);
    let opened = ask_with(&mut workbench, json!({ "ask": "mesh", "name": "m.obj" }), &saved.bytes);
    assert_eq!(opened.json["counts"]["faces"], 320);
    let bow = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n";
    let refused = ask_with(&mut workbench, json!({ "ask": "mesh", "name": "b.obj" }), bow);
    assert_eq!(refused.json["mendable"], true);
    let question = json!({ "ask": "mesh", "name": "b.obj", "repair": true });
    let mended = ask_with(&mut workbench, question, bow);
    assert_eq!(mended.json["repaired"], json!(["split off 1 vertex"]));
}

#[test]
fn what_breaks_a_mesh_is_shown_as_pointers() {
    let mut workbench = with_program();
    let broken = PROGRAM.replace("-h-> v1 -b-> v2", "-h-> v2");
    let told = ask(&mut workbench, json!({ "ask": "program", "name": "a.hedge", "text": broken }));
    assert_eq!((&told["sound"], &told["breaks"]), (&json!(false), &json!(1)), "{told}");
    let found = ask(&mut workbench, json!({ "ask": "counterexamples" }));
    let example = &found["examples"][0];
    let pointers = example["broken"].as_array().expect("there are pointers");
    assert!(!pointers.is_empty(), "{example}");
    for pointer in pointers {
        let said = pointer["pointer"].as_str().expect("it has a name");
        assert!(example["verdict"].as_str().is_some_and(|it| it.contains(said)), "{example}");
        assert!(pointer["from"]["at"].is_array() && pointer["to"]["at"].is_array());
    }
    // As it was before while it is broken; nothing of another program.
    let program = |text: &str, name: &str| json!({ "ask": "program", "name": name, "text": text });
    assert_eq!(ask(&mut workbench, program(PROGRAM, "a.hedge"))["ops"][0]["name"], "flip");
    assert_eq!(ask(&mut workbench, program("op", "a.hedge"))["ops"][0]["name"], "flip");
    assert_eq!(ask(&mut workbench, program("op", "b.hedge"))["ops"], json!([]));
    assert_eq!(ask(&mut workbench, program(PROGRAM, "b.hedge"))["breaks"], 0);
    let absent = ask(&mut workbench, json!({ "ask": "mesh", "name": "a.obj", "of_host": true }));
    assert!(absent["error"].as_str().is_some_and(|it| it.contains("no files")), "{absent}");
}

#[test]
fn whatever_is_asked_there_is_an_answer() {
    let mut workbench = with_program();
    ask(&mut workbench, json!({ "ask": "shape", "name": "cube" }));
    let mut dice = Dice(11);
    let words = [
        "ask", "program", "shape", "mesh", "view", "places", "names", "apply", "run", "seek",
        "undo", "redo", "save", "code", "judge", "library", "flip", "turn", "cube", "m.obj",
        "x.ply", "03_flip", "op", "script", "element", "given", "to", "name", "text", "kind",
        "edge", "face", "vertex", "index", "language", "cpp", "lesson", "times", "e", "", "é",
    ];
    let mut errors = 0;
    for _ in 0..4000 {
        let json = value(&mut dice, &words, 0);
        let bytes: Vec<u8> = (0..dice.below(40)).map(|_| dice.below(256) as u8).collect();
        let answer = ask_with(&mut workbench, json, &bytes);
        errors += usize::from(answer.json.get("error").is_some());
    }
    assert!((100..4000).contains(&errors), "{errors}");
    for short in [&b""[..], &[1, 0], &[9, 0, 0, 0, b'{'], &[2, 0, 0, 0, b'{', b'{']] {
        assert!(Message::read(short).is_err());
    }
}

/// Random JSON, most of it almost a question.
fn value(dice: &mut Dice, words: &[&str], depth: usize) -> Value {
    let word = |dice: &mut Dice| words[dice.below(words.len())];
    match dice.below(if depth == 0 { 2 } else { 9 }) {
        0 | 1 => {
            let mut object = serde_json::Map::new();
            if depth == 0 {
                object.insert("ask".into(), json!(words[1 + dice.below(15)]));
            }
            let fields: &[(&str, &str)] = match object.get("ask").and_then(Value::as_str) {
                Some("shape" | "save" | "mesh") => &[("name", "word")],
                Some("places") => &[("op", "word")],
                Some("names" | "apply") => &[("op", "flip"), ("element", "element")],
                Some("run") => &[("script", "turn"), ("given", "given")],
                Some("seek") => &[("to", "number")],
                Some("code") => &[("op", "word"), ("language", "cpp")],
                _ => &[],
            };
            for &(name, kind) in fields {
                let field = match kind {
                    "element" => {
                        let kind = ["vertex", "edge", "face", "halfedge"][dice.below(4)];
                        json!({ "kind": kind, "index": dice.below(40) })
                    }
                    "number" => json!(dice.below(50)),
                    "given" => json!({ "times": dice.below(3) }),
                    "word" => json!(word(dice)),
                    kind => json!(kind),
                };
                if dice.below(12) > 0 {
                    object.insert(name.into(), field);
                }
            }
            for _ in 0..dice.below(3) * usize::from(dice.below(4) == 0) {
                let name = word(dice).to_owned();
                object.insert(name, value(dice, words, depth + 1));
            }
            Value::Object(object)
        }
        2 => json!(word(dice)),
        3 => json!(dice.below(5)),
        4 => json!(-1.5e300),
        5 => Value::Null,
        6 => json!(true),
        7 if depth < 4 => (0..dice.below(4)).map(|_| value(dice, words, depth + 1)).collect(),
        _ => json!(u64::MAX),
    }
}
