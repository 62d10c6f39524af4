//! Masks that are kept are those that would be asked anew, whatever happens in between.

use hedgerow::mesh::{Element, ElementKind, FaceId, Mesh, Value, VertexId, identical, shape};
use hedgerow::{Argument, KeptMask, Op, Program, Session, Verdict};
use support::dice::Dice;

/// Operations that read what others write: attributes, sums that may be too large, positions, holes,
/// the pointers of halfedges, steps.
const OPS: &str = "
use \"std/triangle.hedge\"
attr heat: vertex real = 0
attr mark: halfedge bool = false
op warm(v: vertex, by: real = 1) {
  before { face f: v -a-> w =P=> v }
  require v.heat <= 3 else \"it is hot\"
  after {
    face f: v -a-> w =P=> v
    v.heat = v.heat + by
  }
}
op tag(h: halfedge) {
  before { loop f: v -h-> w =P=> v }
  require not h.mark and h.twin.mark == h.next.mark else \"it is tagged\"
  after {
    loop f: v -h-> w =P=> v
    h.mark = true
  }
}
attr many: vertex int = 0
op count_up(v: vertex) {
  before { face f: v -a-> w =P=> v }
  after {
    face f: v -a-> w =P=> v
    v.many = v.many + 1
  }
}
// What cannot be counted up is an error, wherever it is asked.
op fill(v: vertex) {
  before { face f: v -a-> w =P=> v }
  require v.many < 3 or v.many > 9 else \"it is counted\"
  after {
    face f: v -a-> w =P=> v
    v.many = if v.many > 9 { 0 } else { 9223372036854775807 }
  }
}
op lift(f: face) {
  before { face f: v0 -a-> v1 -b-> v2 -c-> v0 }
  require area(f) < 0.6 and degree(v0) > 3 else \"it is large\"
  after {
    face f: v0 -a-> v1 -b-> v2 -c-> v0
    v0.position = v0.position + vec3(0, 0, 0.1)
  }
}
op split_and_flip(e: edge) {
  steps {
    let h = e.halfedge
    let around = h.next.edge
    must split(e)
    if flip(around) { }
  }
}
fn gain(e: edge) -> int { degree(e.halfedge.vertex) - degree(e.halfedge.target) }
script smooth() { for v in vertices { v.position = 0.9 * v.position } }
script look() { print count(faces) }
";

struct Wanderer {
    session: Session,
    ops: Vec<Op>,
    kept: Vec<(Op, KeptMask)>,
    dice: Dice,
    applied: usize,
}

impl Wanderer {
    fn new(program: &Program, mesh: Mesh, seed: u64) -> Self {
        let mut session = Session::new(program, mesh);
        // Those that want no more than an element.
        let needs = |op: &Op| op.parameters().iter().filter(|it| it.default.is_none()).count();
        let is_element =
            |op: &Op| ElementKind::ALL.map(ElementKind::name).contains(&op.parameters()[0].ty);
        let ops: Vec<Op> = program.ops().filter(|op| needs(op) == 1 && is_element(op)).collect();
        let keep = |op: &Op| (op.clone(), session.keep_mask(op, ()).unwrap());
        let kept = ops.iter().map(keep).collect();
        Self { session, ops, kept, dice: Dice(seed), applied: 0 }
    }

    fn compare(&mut self, after: &str) {
        for (op, mask) in &self.kept {
            let anew = self.session.verdicts(op, ());
            let kept = self.session.kept_verdicts(*mask);
            let (anew, kept) = match (anew, kept) {
                (Ok(anew), Ok(kept)) => (anew, kept),
                (anew, kept) => {
                    let codes = (anew.unwrap_err().code(), kept.unwrap_err().code());
                    assert_eq!(codes.0, codes.1, "{} after {after}", op.name());
                    continue;
                }
            };
            let differs = anew.iter().zip(kept).position(|(a, b)| a != b);
            assert_eq!(kept, anew, "{} after {after}, first at {differs:?}", op.name());
            let can: Vec<bool> = anew.iter().map(|&one| one == Verdict::Applies).collect();
            assert_eq!(self.session.kept_mask(*mask).unwrap(), can);
            let places: Vec<usize> = (0..can.len()).filter(|&at| can[at]).collect();
            assert_eq!(self.session.kept_count(*mask).unwrap(), places.len());
            let middle = self.session.pick_kept(*mask, 0.5).unwrap();
            assert_eq!(middle, places.get(places.len() / 2).copied());
        }
    }

    /// Applies an operation somewhere, most often where it can be.
    fn act(&mut self) -> String {
        let op = self.ops[self.dice.below(self.ops.len())].clone();
        let kind = match op.parameters()[0].ty {
            "vertex" => ElementKind::Vertex,
            "edge" => ElementKind::Edge,
            "face" => ElementKind::Face,
            _ => ElementKind::Halfedge,
        };
        let Ok(can) = self.session.mask(&op, ()) else {
            return String::new();
        };
        let places: Vec<usize> = (0..can.len()).filter(|&at| can[at]).collect();
        let number = match places.as_slice() {
            [] => self.dice.below(can.len()),
            places => places[self.dice.below(places.len())],
        };
        let element = Element { kind, index: number as u32 };
        if self.session.is_alive(element) {
            let outcome = self.session.apply(&op, element).unwrap();
            self.applied += usize::from(outcome.is_applied());
        }
        format!("{} at {element}", op.name())
    }
}

#[test]
fn a_kept_mask_is_what_would_be_asked_anew() {
    let program = Program::parse("masks.hedge", OPS).unwrap();
    let meshes = [shape::icosphere(1), shape::triangle_grid(4, 3), shape::triangle_torus(4, 3)];
    for (at, mesh) in meshes.into_iter().enumerate() {
        let mut wanderer = Wanderer::new(&program, mesh, 5 + at as u64);
        let mut marks = Vec::new();
        for step in 0..90 {
            let done = match wanderer.dice.below(20) {
                0 => {
                    wanderer.session.recycle();
                    "recycling".to_owned()
                }
                1 => {
                    marks.push((wanderer.session.mark(), wanderer.session.copy_mesh()));
                    "a mark".to_owned()
                }
                2 if !marks.is_empty() => {
                    let at = wanderer.dice.below(marks.len());
                    let (mark, before) = marks.drain(at..).next().unwrap();
                    wanderer.session.undo(mark).unwrap();
                    assert!(identical(&before, &wanderer.session.copy_mesh()));
                    "undoing".to_owned()
                }
                3 if !marks.is_empty() => {
                    let at = wanderer.dice.below(marks.len());
                    let (mark, _) = marks.drain(at..).next().unwrap();
                    wanderer.session.keep(mark).unwrap();
                    "keeping".to_owned()
                }
                4 => {
                    let program = wanderer.session.program().clone();
                    let name = ["smooth", "look"][wanderer.dice.below(2)];
                    wanderer.session.run(&program.script(name).unwrap(), ()).unwrap();
                    name.to_owned()
                }
                5 => {
                    let mesh = wanderer.session.mesh_mut();
                    let first = mesh.vertices().next().unwrap();
                    let there = mesh.position(first);
                    mesh.set_position(first, 0.5 * there);
                    "a change by hand".to_owned()
                }
                _ => wanderer.act(),
            };
            // Several changes may come before the mask is wanted.
            if step % 3 != 1 {
                wanderer.compare(&done);
            }
        }
        wanderer.compare("all");
        assert!(wanderer.applied > 45, "{}", wanderer.applied);
    }
}

/// The operations of whole files: guards, families, attempts at each corner, steps, expressions.
#[test]
fn masks_of_the_library_are_kept() {
    let triangles = || vec![shape::triangle_grid(4, 4), shape::triangle_torus(4, 4)];
    let quads = || vec![shape::grid(4, 4), shape::torus(4, 5)];
    let files = [
        ("std/planar_triangle.hedge", triangles()),
        ("std/planar_cleanup.hedge", quads()),
        ("std/polygon.hedge", vec![shape::cube(), shape::grid(3, 3)]),
        ("std/map.hedge", vec![shape::cube(), shape::grid(2, 3)]),
        ("std/triangle.hedge", triangles()),
        ("examples/families.hedge", vec![shape::cube(), shape::icosphere(1)]),
        ("examples/collapse.hedge", vec![shape::icosphere(1), shape::grid(3, 3)]),
        ("examples/dissolve.hedge", vec![shape::grid(4, 4)]),
    ];
    for (at, (file, meshes)) in files.into_iter().enumerate() {
        let program = Program::load(file).unwrap();
        for (turn, mesh) in meshes.into_iter().enumerate() {
            let mut wanderer = Wanderer::new(&program, mesh, (7 * at + turn) as u64);
            for step in 0..60 {
                // What is tried is undone.
                let mark = (step % 5 == 0).then(|| wanderer.session.mark());
                let done = wanderer.act();
                if step % 3 != 1 {
                    wanderer.compare(&done);
                }
                if let Some(mark) = mark {
                    wanderer.act();
                    wanderer.session.undo(mark).unwrap();
                    wanderer.compare("undoing");
                }
            }
            assert!(wanderer.applied > 8, "{file}: {}", wanderer.applied);
        }
    }
}

#[test]
fn masks_have_arguments_and_end() {
    let program = Program::parse("masks.hedge", OPS).unwrap();
    let mut session = Session::new(&program, shape::icosphere(0));
    let warm = program.op("warm").unwrap();
    let mask = session.keep_mask(&warm, [("by", Argument::Real(2.0))]).unwrap();
    assert_eq!(session.kept_mask(mask).unwrap(), vec![true; 12]);
    for _ in 0..2 {
        let vertex = VertexId(4);
        assert!(session.apply(&warm, (vertex, 2.0)).unwrap().is_applied());
    }
    assert_eq!(session.kept_mask(mask).unwrap().iter().filter(|&&can| !can).count(), 1);
    session.set_attribute(ElementKind::Vertex, "heat", heat(vec![9.0; 12])).unwrap();
    assert_eq!(session.kept_mask(mask).unwrap(), vec![false; 12]);
    // Another session has another first mask.
    let mut other = Session::new(&program, shape::icosphere(0));
    other.keep_mask(&warm, [("by", Argument::Real(2.0))]).unwrap();
    assert_eq!(other.kept_mask(mask).unwrap_err().code(), "unknown-mask");
    assert_eq!(other.kept_verdicts(mask).unwrap_err().code(), "unknown-mask");
    session.drop_mask(mask);
    assert_eq!(session.kept_mask(mask).unwrap_err().code(), "unknown-mask");
    assert_eq!(session.keep_mask(&warm, VertexId(1)).unwrap_err().code(), "wrong-argument");
}

fn heat(values: Vec<f64>) -> hedgerow::mesh::ColumnData {
    hedgerow::mesh::ColumnData::Real(values)
}

#[test]
fn attributes_come_as_arrays() {
    let program = Program::parse("masks.hedge", OPS).unwrap();
    let mut session = Session::new(&program, shape::icosphere(0));
    let code = |error: hedgerow::Error| error.code();
    let vertex = ElementKind::Vertex;
    assert_eq!(
        code(session.set_attribute(vertex, "heat", heat(vec![1.0])).unwrap_err()),
        "wrong-argument"
    );
    session.set_attribute(vertex, "heat", heat(vec![1.0; 12])).unwrap();
    let ints = hedgerow::mesh::ColumnData::Int(vec![1; 12]);
    assert_eq!(
        code(session.set_attribute(vertex, "heat", ints).unwrap_err()),
        "attribute-conflict"
    );
    let column = session.mesh().find_column(vertex, "heat").unwrap();
    assert_eq!(session.mesh().value(column, 3), Some(Value::Real(1.0)));
    let mark = session.mark();
    session.set_attribute(vertex, "heat", heat(vec![2.0; 12])).unwrap();
    assert!(session.remove_attribute(vertex, "heat") && !session.remove_attribute(vertex, "heat"));
    session.undo(mark).unwrap();
    let column = session.mesh().find_column(vertex, "heat").unwrap();
    assert_eq!(session.mesh().value(column, 3), Some(Value::Real(1.0)));
    let mut places = session.mesh().positions().to_vec();
    places[2].x = f64::NAN;
    assert_eq!(code(session.set_positions(&places).unwrap_err()), "wrong-argument");
    places[2].x = 5.0;
    session.set_positions(&places).unwrap();
    assert_eq!(session.mesh().positions()[2].x, 5.0);
}

/// A collapse joins the stars of two vertices, of which it draws one only in part. Whether the joined
/// vertex would lie at one hole is read far from what is drawn: at the end of paths that begin with
/// pointers that the operation would set.
#[test]
fn what_is_written_around_stars_that_would_be_joined_is_asked_again() {
    let program = "use \"std/triangle.hedge\"\n\
        op pierce(f: face) {\n\
          before { face f: v -h-> w =P=> v }\n\
          after { hole f: v -h-> w =P=> v }\n\
        }\n";
    let program = Program::parse("masks.hedge", program).unwrap();
    let [collapse, pierce] = ["collapse", "pierce"].map(|name| program.op(name).unwrap());
    for mesh in [shape::triangle_grid(7, 7), shape::triangle_torus(7, 7)] {
        let is_inside = |&v: &VertexId| mesh.spokes(v).all(|h| !mesh.is_hole(mesh.face(h)));
        let depth = |v| mesh.spokes(v).filter(|&h| is_inside(&mesh.target(h))).count();
        let edge = mesh.edges().find(|&e| {
            let h = mesh.edge_halfedge(e);
            depth(mesh.vertex(h)) == 6 && depth(mesh.target(h)) == 6
        });
        let edge = edge.expect("an edge inside");
        let h = mesh.edge_halfedge(edge);
        let faces = |v| mesh.spokes(v).map(|h| mesh.face(h)).collect::<Vec<FaceId>>();
        let [here, there] = [mesh.vertex(h), mesh.target(h)].map(faces);
        let only = |these: &[FaceId], others: &[FaceId]| -> Vec<FaceId> {
            these.iter().copied().filter(|face| !others.contains(face)).collect()
        };
        let [here, there] = [only(&here, &there), only(&there, &here)];
        assert_eq!((here.len(), there.len()), (4, 4));
        // Those that do not touch each other.
        let corners = |face| mesh.face_vertices(face).collect::<Vec<VertexId>>();
        let apart = |[a, b]: &[FaceId; 2]| !corners(*a).iter().any(|v| corners(*b).contains(v));
        let pairs = here.iter().flat_map(|&a| there.iter().flat_map(move |&b| [[a, b], [b, a]]));
        let pairs: Vec<[FaceId; 2]> = pairs.filter(apart).collect();
        let mut refused = 0;
        for &pair in &pairs {
            let mut session = Session::new(&program, mesh.clone());
            let mask = session.keep_mask(&collapse, ()).unwrap();
            for (holes, face) in (1..).zip(pair) {
                assert!(session.apply(&pierce, face).unwrap().is_applied());
                let anew = session.verdicts(&collapse, ()).unwrap();
                assert_eq!(session.kept_verdicts(mask).unwrap(), anew, "{edge:?} {pair:?}");
                refused += usize::from(holes == 2 && anew[edge.index()] != Verdict::Applies);
            }
        }
        // With a hole at each of its ends, the edge must not be collapsed.
        assert!(pairs.len() > 8 && refused == pairs.len(), "{refused} of {}", pairs.len());
    }
}

/// Asks in all ways, of an operation and of a function that reads `label`.
fn ask_of_labels(session: &mut Session, program: &Program) {
    let (new_label, told) = (program.op("new_label").unwrap(), program.function("told").unwrap());
    session.use_program(program);
    let applies = |session: &mut Session| session.can(&new_label, FaceId(0)).unwrap();
    assert!(applies(session) && applies(session));
    assert_eq!(session.why(&new_label, FaceId(0)).unwrap(), None);
    assert!(session.matched(&new_label, FaceId(0)).unwrap().is_ok());
    let mask = session.mask(&new_label, ()).unwrap();
    assert!(mask.iter().all(|&can| can));
    let kept = session.keep_mask(&new_label, ()).unwrap();
    assert_eq!(session.kept_mask(kept).unwrap(), mask);
    session.call(&told, FaceId(0)).unwrap();
    session.values(&told, (), &mut hedgerow::Unwatched).unwrap();
    session.run(&program.script("say").unwrap(), ()).unwrap();
}

#[test]
fn asking_leaves_the_mesh_as_it_was() {
    // Whether `new_label` applies is told by a face that it makes itself.
    let labels = |default: i64| {
        let text = format!(
            "use \"std/polygon.hedge\"
            attr label: face int = {default}
            fn told(f: face) -> int {{ f.label }}
            script say() {{ for f in faces {{ print f.label }} }}
            op new_label(f: face) {{
              steps {{
                let v = must inset_vertex(f)
                require any(g.label == {default} for g in v.faces)
              }}
            }}
            op relabel(f: face) {{
              before {{ face f: v -a-> w =P=> v }}
              after {{
                face f: v -a-> w =P=> v
                f.label = f.label + 1
              }}
            }}"
        );
        Program::parse("labels.hedge", &text).unwrap()
    };
    let (seven, nine) = (labels(7), labels(9));
    let label = |session: &Session, face: u32| {
        let column = session.mesh().find_column(ElementKind::Face, "label")?;
        session.mesh().value(column, face)
    };
    // There is no such attribute before, in between, and after.
    let mut session = Session::new(&seven, shape::cube());
    ask_of_labels(&mut session, &seven);
    ask_of_labels(&mut session, &nine);
    let mark = session.mark();
    ask_of_labels(&mut session, &seven);
    session.undo(mark).unwrap();
    assert!(identical(&session.copy_mesh(), &shape::cube()));
    assert_eq!(session.mesh().public_columns().count(), 0);
    // What changes the mesh brings it, and kept masks follow.
    session.use_program(&seven);
    let told = seven.function("told").unwrap();
    assert_eq!(session.call(&told, FaceId(0)).unwrap(), Some(Argument::Int(7)));
    session.use_program(&nine);
    assert!(session.apply(&nine.op("relabel").unwrap(), FaceId(0)).unwrap().is_applied());
    assert_eq!([0, 1].map(|face| label(&session, face)), [10, 9].map(|n| Some(Value::Int(n))));
    session.use_program(&seven);
    assert_eq!(session.call(&told, FaceId(0)).unwrap(), Some(Argument::Int(10)));
    // The default stays what it was.
    let before = session.copy_mesh();
    ask_of_labels(&mut session, &seven);
    assert!(identical(&session.copy_mesh(), &before));
    let column = session.mesh().find_column(ElementKind::Face, "label").unwrap();
    assert_eq!(session.mesh().column(column).unwrap().default_value(), Value::Int(9));
    // Values that are set by hand take the place of those that were asked about.
    session.remove_attribute(ElementKind::Face, "label");
    ask_of_labels(&mut session, &seven);
    let values = hedgerow::mesh::ColumnData::Int(vec![3; 6]);
    session.set_attribute(ElementKind::Face, "label", values).unwrap();
    assert_eq!(session.call(&told, FaceId(0)).unwrap(), Some(Argument::Int(3)));
    ask_of_labels(&mut session, &nine);
    assert_eq!(label(&session, 5), Some(Value::Int(3)));
}
