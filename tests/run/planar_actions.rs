//! The planar actions against a table of verdicts, meshes and scores.
//!
//! `tests/run/data/planar_actions.json.gz` was made by running a reference implementation; its
//! `doc` key tells the format. The plain actions must agree with it to the letter, asked by `can`
//! and done, the strict ones with what they promise. (It holds no row of quads that is taken out:
//! `cleanup` has its own tests in the library.) A score must always be what it means, the ideal degree minus
//! the degree, although the actions only add and subtract what their drawings change.

use std::collections::BTreeMap;
use std::path::Path;

use glam::DVec3;
use hedgerow::analysis::{Analysis, Nowhere, verdicts};
use hedgerow::diagram::Type;
use hedgerow::mesh::{
    ElementKind, FaceId, Level, Mesh, Polygons, Value, VertexId, identical, validate_level,
};
use hedgerow::rewrite::Unwatched;
use hedgerow::run::{Applied, apply, arguments, prepare, run};
use hedgerow::source::Sources;
use serde_json::Value as Json;

fn table() -> Json {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/run/data/planar_actions.json.gz");
    let packed = std::fs::File::open(path).unwrap();
    serde_json::from_reader(flate2::read::GzDecoder::new(packed)).unwrap()
}

/// A script that asks at each halfedge whether an action would be done there, and does none.
fn dry(actions: &[&str], kind: &str) -> String {
    let strict = actions.iter().map(|action| format!("strict_{action}"));
    let all: Vec<_> = actions.iter().map(|action| (*action).to_owned()).chain(strict).collect();
    let declared: String =
        all.iter().map(|action| format!("attr can_{action}: halfedge bool = false\n")).collect();
    let asked = all.iter().map(|action| {
        let is_of_edges = action.contains("flip") || kind == "tri" && action.contains("split");
        format!("    h.can_{action} = can {action}(h{})\n", if is_of_edges { ".edge" } else { "" })
    });
    let asked: String = asked.collect();
    format!("{declared}script ask() {{\n  for h in halfedges {{\n{asked}  }}\n}}\n")
}

/// The actions on meshes of one kind.
struct Board {
    analysis: Analysis,
}

impl Board {
    fn of(kind: &str) -> Self {
        let name = match kind {
            "tri" => "planar_triangle",
            _ => "planar_quad",
        };
        let mut sources = Sources::new();
        let actions: &[&str] = match kind {
            "tri" => &["flip", "split", "collapse"],
            _ => &["flip_cw", "flip_ccw", "split", "collapse"],
        };
        let text = format!("use \"std/{name}.hedge\"\n{}", dry(actions, kind));
        let root = sources.add("board.hedge", text);
        let analysis = Analysis::with(&mut sources, root, &mut Nowhere);
        assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
        Self { analysis }
    }

    /// Runs the script `measure`.
    fn measure(&self, mesh: &mut Mesh) {
        self.run("measure", mesh);
    }

    /// Whether each action would be done at a halfedge, asked of a mesh that stays as it is.
    fn ask(&self, mesh: &Mesh) -> Mesh {
        let mut asked = mesh.clone();
        self.run("ask", &mut asked);
        assert_eq!(faces(&asked), faces(mesh), "to ask changes nothing");
        let places = |mesh: &Mesh| mesh.vertices().map(|v| mesh.position(v)).collect::<Vec<_>>();
        assert_eq!(places(&asked), places(mesh), "to ask changes nothing");
        assert_eq!(ints(&asked, "score"), ints(mesh, "score"), "to ask changes nothing");
        asked
    }

    fn run(&self, script: &str, mesh: &mut Mesh) {
        let program = &self.analysis.program;
        let script = self.analysis.script(script).unwrap();
        let prepared = prepare(program, script, &self.analysis.plans).unwrap();
        run(&prepared, mesh, &[], &mut Unwatched).unwrap();
    }

    /// Applies an action at the edge from one vertex to another.
    fn act(&self, mesh: &mut Mesh, op: &str, [from, to]: [u32; 2]) -> Applied {
        let program = &self.analysis.program;
        let number = self.analysis.op(op).unwrap_or_else(|| panic!("no {op}"));
        let halfedge = mesh.halfedge_between(VertexId(from), VertexId(to)).unwrap();
        let parameter = &program.ops[number].params[0];
        let at = match parameter.ty {
            Type::Halfedge => halfedge.0,
            _ => {
                let edge = mesh.edge(halfedge);
                mesh.set_edge_halfedge(edge, halfedge);
                edge.0
            }
        };
        let texts = [(parameter.name.clone(), at.to_string())];
        let arguments = arguments(program, number, &texts).unwrap();
        let plans = &self.analysis.plans;
        let applied = apply(program, number, plans, mesh, &arguments).unwrap();
        mesh.recycle();
        applied
    }
}

fn numbers(value: &Json) -> Vec<u32> {
    let numbers = value.as_array().unwrap().iter();
    numbers.map(|n| n.as_u64().unwrap() as u32).collect()
}

fn mesh(value: &Json) -> Mesh {
    let nodes = value["nodes"].as_array().unwrap().iter();
    let positions: Vec<_> = nodes.map(|node| position(node).unwrap()).collect();
    let faces = value["faces"].as_array().unwrap().iter();
    let polygons: Polygons = faces.map(numbers).collect();
    Mesh::from_polygons(&positions, &polygons).unwrap()
}

fn position(node: &Json) -> Option<DVec3> {
    let [x, y] = [node.get(0)?, node.get(1)?].map(|c| c.as_f64().unwrap());
    Some(DVec3::new(x, y, 0.0))
}

fn ints(mesh: &Mesh, name: &str) -> BTreeMap<u32, i64> {
    let column = mesh.find_column(ElementKind::Vertex, name).unwrap();
    let value = |v: VertexId| match mesh.value(column, v.0) {
        Some(Value::Int(value)) => (v.0, value),
        other => panic!("{other:?}"),
    };
    mesh.vertices().map(value).collect()
}

/// What `ask` has noted of an action.
fn would_be_done(asked: &Mesh, action: &str, [from, to]: [u32; 2]) -> bool {
    let column = asked.find_column(ElementKind::Halfedge, &format!("can_{action}")).unwrap();
    let halfedge = asked.halfedge_between(VertexId(from), VertexId(to)).unwrap();
    match asked.value(column, halfedge.0) {
        Some(Value::Bool(is_done)) => is_done,
        other => panic!("{other:?}"),
    }
}

/// Faces as cycles from their least corner on, in order.
fn canonical(mut faces: Vec<Vec<u32>>) -> Vec<Vec<u32>> {
    for face in &mut faces {
        let least = (0..face.len()).min_by_key(|&at| face[at]).unwrap();
        face.rotate_left(least);
    }
    faces.sort_unstable();
    faces
}

fn faces(mesh: &Mesh) -> Vec<Vec<u32>> {
    let real = mesh.faces().filter(|&face| !mesh.is_hole(face));
    let corners = |face: FaceId| mesh.face_vertices(face).map(|v| v.0).collect();
    canonical(real.map(corners).collect())
}

/// Positions to the last digits, faces and scores are those of the table.
fn expect(mesh: &Mesh, after: &Json, scores: &Json, case: &str) {
    let nodes = after["nodes"].as_array().unwrap();
    let living = nodes.iter().enumerate().filter_map(|(at, node)| {
        let place = position(node)?;
        Some((at as u32, place))
    });
    let living: BTreeMap<u32, DVec3> = living.collect();
    let ours: Vec<u32> = mesh.vertices().map(|v| v.0).collect();
    assert!(living.keys().eq(&ours), "{case}: other nodes");
    for (&node, &place) in &living {
        let off = mesh.position(VertexId(node)).distance(place);
        assert!(off < 1e-10, "{case}: node {node} is off by {off}");
    }
    let theirs = after["faces"].as_array().unwrap().iter();
    let theirs = canonical(theirs.map(numbers).collect());
    assert_eq!(faces(mesh), theirs, "{case}");
    for (node, score) in ints(mesh, "score") {
        let wanted = scores[node as usize].as_i64();
        assert_eq!(Some(score), wanted, "{case}: the score of node {node}");
    }
}

/// Each score is what it means, and their sum is as it was.
fn scores_hold(mesh: &Mesh, sum: i64, case: &str) {
    let ideal = ints(mesh, "ideal");
    let scores = ints(mesh, "score");
    for (&v, score) in &scores {
        let degree = mesh.degree(VertexId(v)) as i64;
        assert_eq!(*score, ideal[&v] - degree, "{case}: node {v}");
    }
    assert_eq!(scores.values().sum::<i64>(), sum, "{case}");
}

fn pair(value: &Json) -> [u32; 2] {
    numbers(value).try_into().unwrap()
}

fn correct_scores(value: &Json) -> &Json {
    match value.get("recomputed_scores") {
        Some(scores) => scores,
        None => &value["stored_scores"],
    }
}

#[test]
fn single_actions_agree() {
    let table = table();
    let boards = ["tri", "quad"].map(|kind| (kind, Board::of(kind)));
    let boards = BTreeMap::from(boards);
    let meshes: Vec<(&str, Mesh)> = table["meshes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|value| {
            let kind = value["kind"].as_str().unwrap();
            let mut mesh = mesh(value);
            boards[kind].measure(&mut mesh);
            for (name, wanted) in [("ideal", &value["ideal"]), ("score", &value["scores"])] {
                let ours: Vec<_> = ints(&mesh, name).into_values().map(Json::from).collect();
                assert_eq!(&Json::Array(ours), wanted, "{name} of a {kind} mesh");
            }
            (kind, mesh)
        })
        .collect();
    let asked: Vec<Mesh> = meshes.iter().map(|(kind, mesh)| boards[kind].ask(mesh)).collect();
    let mut counts: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    let mut strict_counts = counts.clone();
    for case in table["cases"].as_array().unwrap() {
        let result = case["result"].as_str().unwrap();
        let defects = case.get("defects").and_then(Json::as_array);
        if result == "exception" || defects.is_some_and(|defects| !defects.is_empty()) {
            continue;
        }
        let number = case["mesh"].as_u64().unwrap() as usize;
        let (kind, original) = &meshes[number];
        let board = &boards[kind];
        let op = case["op"].as_str().unwrap();
        let at = pair(&case["edge"]);
        let name = format!("mesh {number}: {op} {at:?}");
        let sum = ints(original, "score").values().sum();

        let dry = |action: &str| would_be_done(&asked[number], action, at);
        assert_eq!(dry(op), result == "done", "{name}: asked");

        let mut mesh = original.clone();
        let applied = board.act(&mut mesh, op, at);
        match &applied {
            Applied::Refused(reason) => assert_eq!(result, "refused", "{name}: {reason}"),
            Applied::Done { .. } => {
                assert_eq!(result, "done", "{name}");
                expect(&mesh, &case["after"], correct_scores(case), &name);
                scores_hold(&mesh, sum, &name);
                validate_level(&mesh, Level::Surface).unwrap();
            }
        }
        let count = counts.entry(format!("{kind} {op}")).or_default();
        count[usize::from(result == "refused")] += 1;

        // The strict action does the same or nothing, and never raises a degree above ten.
        let mut strict = original.clone();
        let strictly = board.act(&mut strict, &format!("strict_{op}"), at);
        let is_done = matches!(strictly, Applied::Done { .. });
        assert_eq!(dry(&format!("strict_{op}")), is_done, "{name}: asked strictly");
        let count = strict_counts.entry(format!("{kind} {op}")).or_default();
        match strictly {
            Applied::Done { .. } => {
                count[0] += 1;
                scores_hold(&strict, sum, &name);
                validate_level(&strict, Level::Simple).unwrap();
                if matches!(applied, Applied::Done { .. }) {
                    assert!(identical(&mesh, &strict), "{name}");
                }
                for v in strict.vertices() {
                    let before = match original.vertex_alive(v) {
                        true => original.degree(v),
                        false => 0,
                    };
                    assert!(strict.degree(v) <= before.max(10), "{name}");
                }
            }
            Applied::Refused(_) => count[1] += 1,
        }
    }
    println!("plain {counts:#?}\nstrict {strict_counts:#?}");
    assert_eq!(counts.len(), 7);
    let total: usize = counts.values().flatten().sum();
    assert_eq!(total, 1412);
    assert!(strict_counts.values().all(|[done, _]| *done >= 80));
}

#[test]
fn sequences_agree() {
    let table = table();
    let board = Board::of("tri");
    let (mut steps, mut ends) = (0, 0);
    for (number, sequence) in table["sequences"].as_array().unwrap().iter().enumerate() {
        assert_eq!(sequence["kind"], "tri");
        let mut mesh = mesh(sequence);
        board.measure(&mut mesh);
        let sum = ints(&mesh, "score").values().sum();
        for step in sequence["steps"].as_array().unwrap() {
            let op = step[0].as_str().unwrap();
            let at = [&step[1], &step[2]].map(|end| end.as_u64().unwrap() as u32);
            let name = format!("sequence {number}: {op} {at:?}");
            let applied = board.act(&mut mesh, op, at);
            let done = matches!(applied, Applied::Done { .. });
            assert_eq!(done, step[3] == "done", "{name}: {applied:?}");
            scores_hold(&mesh, sum, &name);
            steps += 1;
        }
        let after = &sequence["final"];
        let name = format!("sequence {number}");
        expect(&mesh, after, correct_scores(after), &name);
        ends += 1;
    }
    assert_eq!((steps, ends), (800, 20));
}

/// What `X.score = X.score + 1` adds, by action and vertex, as far as it is a number.
fn declared(text: &str) -> BTreeMap<(String, String), i64> {
    let mut op = String::new();
    let mut added = BTreeMap::new();
    for line in text.lines().map(str::trim) {
        if let Some(rest) = line.strip_prefix("op ") {
            op = rest.split('(').next().unwrap().to_owned();
        }
        let Some((target, value)) = line.split_once('=') else {
            continue;
        };
        let Some(vertex) = target.trim().strip_suffix(".score") else {
            continue;
        };
        let Some(change) = value.trim().strip_prefix(&format!("{vertex}.score ")) else {
            continue;
        };
        if let Ok(change) = change.replace(' ', "").parse::<i64>() {
            added.insert((op.clone(), vertex.to_owned()), change);
        }
    }
    added
}

#[test]
fn scores_change_as_the_drawings_say() {
    let mut compared = 0;
    for name in ["std/planar_triangle.hedge", "std/planar_quad.hedge"] {
        let file = hedgerow::library::file(name).unwrap();
        let mut sources = Sources::new();
        let root = sources.add(name, file.text);
        let analysis = Analysis::with(&mut sources, root, &mut Nowhere);
        let added = declared(file.text);
        for verdict in verdicts(&analysis) {
            for (vertex, change) in &verdict.rules[0].degrees {
                // A degree that grows with a fan is compared where the actions are run.
                let Ok(change) = change.parse::<i64>() else {
                    continue;
                };
                let score = added.get(&(verdict.op.clone(), vertex.clone()));
                assert_eq!(score, Some(&-change), "{}: {vertex}", verdict.op);
                compared += 1;
            }
        }
    }
    assert!(compared >= 30, "only {compared} degrees");
}
