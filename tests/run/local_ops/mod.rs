//! Classic local operations at every element of small polygon meshes, against a table of
//! results and refusals.
//!
//! `tests/run/data/local_ops.json.gz` was made by an independent implementation, whose results a
//! validator checked; its `doc` key tells the format. Here the operations of
//! `std/polygon.hedge` must reproduce each case of theirs that is not ambiguous, whatever
//! halfedges the elements of the mesh name. Those are too many to try all choices together:
//! tried are all first halfedges, all second ones and so on, so that each choice of each element
//! is among them, and some random choices.

mod literal;

use std::collections::BTreeMap;
use std::path::Path;

use glam::DVec3;
use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::mesh::{
    EdgeId, FaceId, HalfedgeId, Level, Mesh, Polygons, VertexId, identical, validate_level,
};
use hedgerow::rewrite::{Machine, Outcome};
use hedgerow::source::Sources;
use serde_json::Value;

/// The names of the table, and ours.
const OPS: [(&str, &str); 12] = [
    ("flip_edge", "flip"),
    ("split_edge", "split"),
    ("collapse_edge", "collapse"),
    ("dissolve_edge", "dissolve_edge"),
    ("dissolve_vertex", "dissolve_vertex"),
    ("collapse_face", "collapse_face"),
    ("extrude_face", "extrude"),
    ("inset_vertex", "inset_vertex"),
    ("bevel_vertex", "bevel_vertex"),
    ("bevel_edge", "bevel_edge"),
    ("make_boundary", "open_face"),
    ("weld_edges", "weld"),
];

fn table() -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/run/data/local_ops.json.gz");
    let packed = std::fs::File::open(path).unwrap();
    serde_json::from_reader(flate2::read::GzDecoder::new(packed)).unwrap()
}

fn library() -> Analysis {
    let mut sources = Sources::new();
    let root = sources.add("root.hedge", "use \"std/polygon.hedge\"");
    let analysis = Analysis::with(&mut sources, root, &mut Nowhere);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    analysis
}

fn numbers(value: &Value) -> Vec<u32> {
    let numbers = value.as_array().unwrap().iter();
    numbers.map(|n| n.as_u64().unwrap() as u32).collect()
}

fn positions(value: &Value) -> Vec<DVec3> {
    let points = value["vertices"].as_array().unwrap().iter();
    let point = |p: &Value| {
        let [x, y, z] = [0, 1, 2].map(|at| p[at].as_f64().unwrap());
        DVec3::new(x, y, z)
    };
    points.map(point).collect()
}

fn mesh(value: &Value) -> Mesh {
    let polygons: Polygons = value["faces"].as_array().unwrap().iter().map(numbers).collect();
    Mesh::from_polygons(&positions(value), &polygons).unwrap()
}

/// The number of the element that a case names.
fn element(mesh: &Mesh, place: &Value) -> u64 {
    match place["kind"].as_str().unwrap() {
        "edge" => {
            let ends = numbers(&place["halfedge"]);
            let half = mesh.halfedge_between(VertexId(ends[0]), VertexId(ends[1]));
            u64::from(mesh.edge(half.unwrap()).0)
        }
        "vertex" => place["index"].as_u64().unwrap(),
        "face" => {
            let corners = numbers(&place["loop"]);
            let spokes = mesh.spokes(VertexId(corners[0]));
            let mut ahead = spokes.filter(|&half| mesh.target(half).0 == corners[1]);
            u64::from(mesh.face(ahead.next().unwrap()).0)
        }
        kind => panic!("no element is a {kind}"),
    }
}

/// Faces as cycles of positions, each from its least corner on, in order. Positions are
/// rounded, so that the order of sums does not show.
type Shape = Vec<Vec<[i64; 3]>>;

fn rounded(p: DVec3) -> [i64; 3] {
    p.to_array().map(|x| (x * 1e9).round() as i64)
}

fn canonical(mut cycles: Shape) -> Shape {
    for cycle in &mut cycles {
        let rotations = (0..cycle.len()).map(|turn| {
            let mut rotated = cycle.clone();
            rotated.rotate_left(turn);
            rotated
        });
        *cycle = rotations.min().unwrap_or_default();
    }
    cycles.sort_unstable();
    cycles
}

fn shape_of(mesh: &Mesh) -> (Vec<[i64; 3]>, Shape) {
    let mut points: Vec<_> = mesh.vertices().map(|v| rounded(mesh.position(v))).collect();
    points.sort_unstable();
    let corners = |face: FaceId| {
        let corners = mesh.face_vertices(face);
        corners.map(|v| rounded(mesh.position(v))).collect()
    };
    let faces = mesh.faces().filter(|&face| !mesh.is_hole(face));
    (points, canonical(faces.map(corners).collect()))
}

fn expected(value: &Value) -> (Vec<[i64; 3]>, Shape) {
    let positions: Vec<_> = positions(value).into_iter().map(rounded).collect();
    let faces = value["faces"].as_array().unwrap().iter();
    let corners = |face: &Value| {
        let corners = numbers(face);
        corners.iter().map(|&v| positions[v as usize]).collect()
    };
    let shape = canonical(faces.map(corners).collect());
    let mut points = positions;
    points.sort_unstable();
    (points, shape)
}

/// The halfedges that each element may name.
fn choices(mesh: &Mesh) -> Vec<(Element, Vec<HalfedgeId>)> {
    let vertices = mesh.vertices().map(|v| (Element::Vertex(v), mesh.spokes(v).collect()));
    let edges = mesh.edges().map(|e| {
        let h = mesh.edge_halfedge(e);
        (Element::Edge(e), vec![h, mesh.twin(h)])
    });
    let faces = mesh.faces().map(|f| (Element::Face(f), mesh.face_halfedges(f).collect()));
    vertices.chain(edges).chain(faces).collect()
}

#[derive(Clone, Copy)]
enum Element {
    Vertex(VertexId),
    Edge(EdgeId),
    Face(FaceId),
}

fn name(mesh: &mut Mesh, element: Element, halfedge: HalfedgeId) {
    match element {
        Element::Vertex(v) => mesh.set_vertex_halfedge(v, halfedge),
        Element::Edge(e) => mesh.set_edge_halfedge(e, halfedge),
        Element::Face(f) => mesh.set_face_halfedge(f, halfedge),
    }
}

/// The mesh with its elements naming other halfedges.
fn turned(mesh: &Mesh) -> Vec<Mesh> {
    let choices = choices(mesh);
    let mut meshes = Vec::new();
    let most = choices.iter().map(|(_, halfedges)| halfedges.len()).max();
    for turn in 0..most.unwrap_or_default() {
        let mut other = mesh.clone();
        for (element, halfedges) in choices.iter().filter(|(_, all)| !all.is_empty()) {
            name(&mut other, *element, halfedges[turn % halfedges.len()]);
        }
        meshes.push(other);
    }
    let mut state = 1_u64;
    for _ in 0..16 {
        let mut other = mesh.clone();
        for (element, halfedges) in &choices {
            // Knuth's linear congruential generator (MMIX).
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            if !halfedges.is_empty() {
                let pick = (state >> 33) as usize % halfedges.len();
                name(&mut other, *element, halfedges[pick]);
            }
        }
        meshes.push(other);
    }
    meshes
}

#[test]
fn every_case_is_reproduced_whatever_the_elements_name() {
    let table = table();
    let library = library();
    let mut machine = Machine::new(&library.plans);
    machine.trust_level(Level::Surface);
    let mut counts: BTreeMap<&str, [usize; 4]> = BTreeMap::new();
    for case in table["cases"].as_array().unwrap() {
        let Some((_, ours)) = OPS.iter().find(|(theirs, _)| case["op"] == *theirs) else {
            continue;
        };
        let count = counts.entry(ours).or_default();
        if !case["ambiguous"].is_null() {
            count[2] += 1;
            continue;
        }
        let original = mesh(&table["meshes"][case["mesh"].as_str().unwrap()]);
        let elements = case["element"].as_array().unwrap().iter();
        let mut places: Vec<_> = elements.map(|place| element(&original, place)).collect();
        let plan = library.plans[library.op(ours).unwrap()].as_ref().unwrap();
        // All other parameters are reals, and zero by default.
        places.resize(plan.params.len(), 0);
        for before in &turned(&original) {
            let mut mesh = before.clone();
            let outcome = machine.apply(&mut mesh, plan, &places).unwrap();
            count[3] += 1;
            let expect = &case["expect"];
            match outcome {
                Outcome::Refused { reason } => {
                    let reason = &plan.refusals[usize::from(reason.unwrap())].reason;
                    assert_eq!(expect, "refuse", "{}: refused: {reason}", case["name"]);
                    assert!(identical(&mesh, before), "{}", case["name"]);
                }
                Outcome::Applied { result } => {
                    assert_ne!(expect, "refuse", "{}: {}", case["name"], case["why"]);
                    validate_level(&mesh, Level::Surface).unwrap();
                    assert_eq!(shape_of(&mesh), expected(expect), "{}", case["name"]);
                    if *ours == "split" {
                        let ends = numbers(&case["element"][0]["halfedge"]);
                        let spoke = mesh.vertex_halfedge(VertexId(result.unwrap()));
                        let target = mesh.target(spoke).0;
                        assert!(ends.contains(&target), "{}: runs aside", case["name"]);
                    }
                }
            }
        }
        count[usize::from(case["expect"] == "refuse")] += 1;
    }
    for (op, [done, refused, ambiguous, runs]) in &counts {
        println!("{op}: {done} done, {refused} refused, {ambiguous} ambiguous, {runs} runs");
        assert!(done + refused >= 50, "{op}: few cases");
        assert!(*runs > 1_000, "{op}: few runs");
    }
    assert_eq!(counts.len(), OPS.len());
}
