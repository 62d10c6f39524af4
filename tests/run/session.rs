//! Programs as a library: sessions, what they answer, and what they leave as it was.

use std::ops::ControlFlow;

use hedgerow::mesh::{
    Dump, EdgeId, ElementKind, FaceId, HalfedgeId, Level, Mesh, Value, VertexId, identical, shape,
    validate, validate_level, write_dump,
};
use hedgerow::{
    Argument, Error, Op, Outcome, Program, Script, Session, Type, Unwatched, Verdict, Watch,
};

const OPS: &str = "
attr hits: edge int = 0
private attr seen: vertex int = 5
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  require not adjacent(v2, v3) else \"the edge is there\"
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
    e.hits = e.hits + 1
  }
}
op visit(v: vertex, most: int = 5) {
  before { face f: v -a-> w =P=> v }
  require v.seen <= most else \"it has been counted\"
  after {
    face f: v -a-> w =P=> v
    v.seen = v.seen + 1
  }
}
op divide(e: edge, by: int) {
  before {
    face f: v -a-> w =P=> v
    edge e: a | b
  }
  require 10 div by > 0 else \"it is too small\"
  after {
    face f: v -a-> w =P=> v
    edge e: a | b
    e.hits = 10 div by
  }
}
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
op twice(e: edge) {
  steps {
    must split(e)
    print \"one is done\"
    must flip(e)
  }
}
script all_flips(rounds: int = 1) {
  repeat rounds { for e in edges { flip(e) } }
}
script stops(at: int) {
  var done = 0
  for e in edges {
    flip(e)
    done = done + 1
    assert done < at else \"enough\"
  }
}
script says(what: int, how: vec3 = vec3(0, 0, 1)) { print what, how }
";

fn program() -> Program {
    Program::parse("ops.hedge", OPS).unwrap_or_else(|error| panic!("{error}"))
}

/// Everything of a mesh, with the order in which its free slots will be taken.
fn whole(mesh: &Mesh) -> String {
    let mut mesh = mesh.clone();
    let text = |mesh: &Mesh| {
        let meshes = vec![("mesh".into(), mesh.clone())];
        write_dump(&Dump { meshes, ..Dump::default() })
    };
    let before = text(&mesh);
    for _ in 0..20 {
        mesh.add_vertex();
        mesh.add_halfedge();
        mesh.add_edge();
        mesh.add_face();
    }
    before + &text(&mesh)
}

fn code(error: Error) -> &'static str {
    error.code()
}

#[test]
fn an_operation_is_applied_or_refused_with_a_reason() {
    let program = program();
    let flip = program.op("flip").unwrap();
    let mut session = Session::new(&program, shape::tetrahedron());
    let refused = session.apply(&flip, EdgeId(0)).unwrap();
    let reason = refused.reason().expect("all its vertices are adjacent");
    assert_eq!(&*reason.text, "the edge is there");
    assert_eq!(flip.reasons()[reason.number], reason.text);
    assert_eq!(session.why(&flip, EdgeId(0)).unwrap().as_ref(), Some(reason));

    let mut session = Session::new(&program, shape::octahedron());
    assert_eq!(session.apply(&flip, EdgeId(0)).unwrap(), Outcome::Applied(None));
    validate(session.mesh()).unwrap();
    let hits = session.mesh().find_column(ElementKind::Edge, "hits").expect("it came");
    assert_eq!(session.mesh().values::<i64>(hits).map(|hits| hits[0]), Some(1));

    let split = program.op("split").unwrap();
    let done = session.apply(&split, (EdgeId(3),)).unwrap();
    let made = done.result().expect("it returns a vertex");
    assert_eq!(made.kind, ElementKind::Vertex);
    assert!(session.is_alive(made) && session.created().contains(&made));
    assert_eq!((session.created().len(), session.erased().len()), (12, 0));
}

/// Operations of the library, and meshes on which they are asked about.
fn everything() -> Vec<(Program, Vec<Op>)> {
    let files = ["triangle", "polygon", "map", "planar_triangle", "planar_quad", "subdivide"];
    let files = files.map(|file| Program::load(format!("std/{file}.hedge")).unwrap());
    let files = files.into_iter().chain([program()]);
    files
        .map(|program| {
            let ops = program.ops().collect();
            (program, ops)
        })
        .collect()
}

fn meshes() -> Vec<Mesh> {
    vec![
        shape::tetrahedron(),
        shape::cube(),
        shape::triangle_grid(3, 3),
        shape::grid(3, 2),
        shape::pillow(3),
        shape::tube(4, 1),
    ]
}

#[test]
fn a_question_leaves_no_trace_and_answers_what_happens() {
    let (mut asked, mut applied, mut refused) = (0, 0, 0);
    for (program, ops) in everything() {
        for mesh in meshes() {
            for op in &ops {
                let mut session = Session::new(&program, mesh.clone());
                // Brings the columns.
                let Ok(verdicts) = session.verdicts(op, ()) else {
                    continue;
                };
                let before = whole(session.mesh());
                let again = session.verdicts(op, ()).unwrap();
                assert_eq!(verdicts, again, "{op:?}");
                let mask = session.mask(op, ()).unwrap();
                assert_eq!(whole(session.mesh()), before, "{op:?} left a trace");
                for (id, verdict) in (0..).zip(&verdicts) {
                    asked += 1;
                    assert_eq!(mask[id as usize], *verdict == Verdict::Applies);
                    let kind = op.parameters()[0].ty;
                    let element = match kind {
                        "vertex" => VertexId(id).into(),
                        "halfedge" => HalfedgeId(id).into(),
                        "edge" => EdgeId(id).into(),
                        "face" => FaceId(id).into(),
                        other => panic!("{op:?} begins with {other}"),
                    };
                    let element: hedgerow::mesh::Element = element;
                    assert_eq!(session.can(op, element).unwrap(), mask[id as usize]);
                    let mut copy = session.copy();
                    match (copy.apply(op, element).unwrap(), verdict) {
                        (Outcome::Applied(_), Verdict::Applies) => {
                            applied += 1;
                            validate(copy.mesh()).unwrap();
                        }
                        (Outcome::Refused(reason), Verdict::Refuses(number)) => {
                            refused += 1;
                            assert_eq!(reason.number, *number, "{op:?}");
                            assert_eq!(whole(copy.mesh()), before, "{op:?} refused and wrote");
                        }
                        other => panic!("{op:?} at {element}: {other:?}"),
                    }
                }
            }
        }
    }
    assert!(asked > 3000 && applied > 500 && refused > 500, "{asked} {applied} {refused}");
}

#[test]
fn what_does_not_fit_is_an_error_and_the_mesh_is_as_it_was() {
    let program = program();
    let other = program.op("flip").unwrap();
    let alike = Program::parse("ops.hedge", OPS).unwrap();
    let [flip, divide, visit] = ["flip", "divide", "visit"].map(|op| alike.op(op).unwrap());
    let mut session = Session::new(&alike, shape::octahedron());
    let dead = EdgeId(1);
    session.mesh_mut().add_edge();
    session.mesh_mut().erase_edge(EdgeId(12));
    let before = whole(session.mesh());
    let wrong = [
        (code(session.apply(&flip, ()).unwrap_err()), "missing-argument"),
        (code(session.apply(&flip, EdgeId(12)).unwrap_err()), "wrong-argument"),
        (code(session.apply(&flip, EdgeId(99)).unwrap_err()), "wrong-argument"),
        (code(session.apply(&flip, EdgeId::NONE).unwrap_err()), "wrong-argument"),
        (code(session.apply(&flip, EdgeId(u32::MAX - 1)).unwrap_err()), "wrong-argument"),
        (code(session.apply(&flip, VertexId(0)).unwrap_err()), "wrong-argument"),
        (code(session.apply(&flip, 1.5).unwrap_err()), "wrong-argument"),
        (code(session.apply(&flip, (dead, dead)).unwrap_err()), "wrong-argument"),
        (code(session.apply(&flip, [("x", dead)]).unwrap_err()), "unknown-argument"),
        (code(session.apply(&flip, [("e", dead), ("e", dead)]).unwrap_err()), "repeated-argument"),
        (code(session.apply(&other, dead).unwrap_err()), "foreign-program"),
        (code(session.can(&other, dead).unwrap_err()), "foreign-program"),
        (code(session.mask(&other, ()).unwrap_err()), "foreign-program"),
        (code(session.mask(&flip, dead).unwrap_err()), "wrong-argument"),
        (code(session.apply(&divide, (dead, 0)).unwrap_err()), "division-by-zero"),
        (code(session.can(&divide, (dead, 0)).unwrap_err()), "division-by-zero"),
        (code(session.mask(&divide, [("by", 0)]).unwrap_err()), "division-by-zero"),
        (code(session.apply(&divide, (dead, "2")).unwrap_err()), "wrong-argument"),
        (code(session.apply(&visit, (VertexId(0), 1, 2)).unwrap_err()), "wrong-argument"),
        (code(program.op("flop").unwrap_err()), "unknown-op"),
        (code(program.op("all_flips").unwrap_err()), "unknown-op"),
        (code(program.script("flip").unwrap_err()), "unknown-script"),
        (code(Program::load("no/such.hedge").unwrap_err()), "missing-file"),
    ];
    for (got, wanted) in wrong {
        assert_eq!(got, wanted);
    }
    assert_eq!(session.mesh().find_column(ElementKind::Edge, "hits"), None);
    assert_eq!(whole(&session.copy_mesh()), before);
    let gone = session.apply(&flip, EdgeId(999_999)).unwrap_err();
    assert_eq!(gone.message(), "`e` is no edge of the mesh: 999999");
    let told = program.op("flop").unwrap_err().to_string();
    assert!(told.contains("did you mean `flip`?"), "{told}");
    // It goes on as if nothing had been.
    assert!(session.apply(&divide, (dead, 2)).unwrap().is_applied());
    assert!(session.apply(&flip, dead).unwrap().is_applied());
}

#[test]
fn numbers_that_are_none_are_not_taken() {
    let program = Program::load("std/triangle.hedge").unwrap();
    let split = program.op("split").unwrap();
    let mut session = Session::new(&program, shape::octahedron());
    for t in [f64::NAN, f64::INFINITY] {
        let error = session.apply(&split, (EdgeId(0), t)).unwrap_err();
        assert_eq!(error.code(), "wrong-argument");
    }
    // Nor are vectors of another length than their type has, or of a type that is none.
    let move_by =
        "script move(by: vec3) { print by } script at(e: edge) { print degree(e.halfedge.vertex) }";
    let move_by = Program::parse("move.hedge", move_by).unwrap();
    let mut moved = Session::new(&move_by, shape::octahedron());
    let script = |name: &str| move_by.script(name).unwrap();
    for count in [0, 1, 5] {
        let by = Argument::Reals(Type::Vec3, vec![1.0; count]);
        let error = moved.run(&script("move"), by).unwrap_err();
        let told = format!("the number of reals given for `by` is {count}");
        assert_eq!((error.code(), error.message()), ("wrong-argument", told.as_str()));
    }
    let edge = Argument::Reals(Type::Edge, vec![1e300]);
    assert_eq!(code(moved.run(&script("at"), edge).unwrap_err()), "wrong-argument");
    moved.run(&script("move"), [1.0; 3]).unwrap();
    // An int is a real, and what is not given has its default.
    assert!(session.apply(&split, EdgeId(0)).unwrap().is_applied());
    let halves = session.mesh().position(VertexId(6));
    let mut other = Session::new(&program, shape::octahedron());
    other.apply(&split, [("t", Argument::from(0.5)), ("e", EdgeId(0).into())]).unwrap();
    assert_eq!(other.mesh().position(VertexId(6)), halves);
    other.apply(&split, (EdgeId(1), 1)).unwrap();
    other.apply(&split, (EdgeId(2), 0.25_f32)).unwrap();
    assert_eq!(Argument::try_from(7_usize), Ok(Argument::Int(7)));
    assert!(Argument::try_from(u64::MAX).is_err());
}

#[test]
fn a_result_is_an_id_of_its_kind() {
    let program = Program::load("std/triangle.hedge").unwrap();
    let mut session = Session::new(&program, shape::octahedron());
    let new = session.apply(&program.op("split").unwrap(), EdgeId(0)).unwrap().result().unwrap();
    assert_eq!(VertexId::try_from(new), Ok(VertexId(6)));
    let error = FaceId::try_from(new).unwrap_err();
    assert_eq!(error.to_string(), "vertex 6 is not of kind face");
}

#[test]
fn a_session_knows_the_level_of_its_mesh() {
    let program = Program::load("std/triangle.hedge").unwrap();
    let [flip, collapse] = ["flip", "collapse"].map(|op| program.op(op).unwrap());
    assert_eq!(collapse.level(), Level::Simple);
    let mut session = Session::new(&program, shape::pillow(3));
    let before = whole(session.mesh());
    for _ in 0..2 {
        let error = session.apply(&collapse, EdgeId(0)).unwrap_err();
        assert_eq!(error.code(), "below-level");
        assert!(error.to_string().contains("have the same corners"), "{error}");
    }
    assert_eq!(whole(session.mesh()), before);
    // By hand it becomes a simple one.
    *session.mesh_mut() = shape::icosahedron();
    let mut applied = 0;
    for edge in 0..30 {
        if session.is_alive(EdgeId(edge)) {
            applied += usize::from(session.apply(&collapse, EdgeId(edge)).unwrap().is_applied());
            session.apply(&flip, EdgeId(29)).ok();
            validate_level(session.mesh(), Level::Simple).unwrap();
        }
    }
    assert!(applied > 3, "{applied}");
    assert!(session.apply(&flip, EdgeId(0)).is_err(), "an erased edge is an error");
}

#[test]
fn undoing_is_bit_for_bit() {
    let program = program();
    let [flip, split] = ["flip", "split"].map(|op| program.op(op).unwrap());
    let mut session = Session::new(&program, shape::octahedron());
    let before = whole(session.mesh());
    let outer = session.mark();
    session.apply(&split, EdgeId(0)).unwrap();
    let between = whole(session.mesh());
    let inner = session.mark();
    // Columns come, values are written at once, columns go.
    session.apply(&flip, EdgeId(1)).unwrap();
    let mesh = session.mesh_mut();
    let column = mesh.add_column(ElementKind::Face, "kind", Value::Int(1)).unwrap();
    mesh.values_mut::<i64>(column).unwrap()[0] = 7;
    session.run(&program.script("all_flips").unwrap(), ()).unwrap();
    session.mesh_mut().remove_column(column);
    session.undo(inner).unwrap();
    assert_eq!(whole(session.mesh()), between);
    session.apply(&flip, EdgeId(2)).unwrap();
    session.undo(outer).unwrap();
    assert_eq!(whole(session.mesh()), before);
    for ended in [inner, outer] {
        assert_eq!(code(session.undo(ended).unwrap_err()), "unknown-mark");
        assert_eq!(code(session.keep(ended).unwrap_err()), "unknown-mark");
    }
    // An outer mark ends those within; what is kept stays.
    let outer = session.mark();
    let inner = session.mark();
    session.apply(&flip, EdgeId(2)).unwrap();
    let after = whole(session.mesh());
    session.keep(outer).unwrap();
    assert!(session.undo(inner).is_err());
    assert_eq!(whole(session.mesh()), after);
}

#[test]
fn a_failing_script_is_all_or_nothing_within_an_attempt() {
    let program = program();
    let stops = program.script("stops").unwrap();
    let mut session = Session::new(&program, shape::icosahedron());
    session.run(&stops, 1000).unwrap();
    let before = whole(session.mesh());
    let error = session.attempt(|session| session.run(&stops, 8)).unwrap_err();
    assert_eq!((error.code(), error.message()), ("assertion-failed", "enough"));
    assert!(error.report().is_some_and(|report| report.ops[0].applied > 0));
    assert_eq!(whole(session.mesh()), before);
    // Without one it has done what it did.
    session.run(&stops, 8).unwrap_err();
    validate(session.mesh()).unwrap();
    assert_ne!(whole(session.mesh()), before);

    let before = whole(session.mesh());
    let panicked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
        session.attempt(|session| -> Result<(), Error> {
            session.run(&program.script("all_flips")?, 3)?;
            panic!("whoever calls it is at fault")
        })
    }));
    assert!(panicked.is_err());
    assert_eq!(whole(session.mesh()), before);
    assert!(session.run(&stops, 1000).is_ok());
}

#[test]
fn steps_are_asked_and_say_nothing() {
    struct Lines(Vec<String>);
    impl Watch for Lines {
        fn print(&mut self, line: &str) {
            self.0.push(line.to_owned());
        }
    }
    let program = program();
    let says = program.script("says").unwrap();
    let mut session = Session::new(&program, shape::octahedron());
    let mut lines = Lines(Vec::new());
    let twice = program.op("twice").unwrap();
    assert!(session.mask(&twice, ()).unwrap().iter().all(|can| *can));
    session.run_watched(&says, (7, [1.0, 2.0, 3.0]), &mut lines).unwrap();
    session.run_watched(&says, [("what", 8)], &mut lines).unwrap();
    assert_eq!(lines.0, ["7 (1, 2, 3)", "8 (0, 0, 1)"]);
}

#[test]
fn scratch_has_its_default_at_each_call() {
    let program = program();
    let visit = program.op("visit").unwrap();
    let mut session = Session::new(&program, shape::cube());
    for _ in 0..3 {
        assert!(session.apply(&visit, VertexId(0)).unwrap().is_applied());
        assert!(!session.apply(&visit, (VertexId(0), 4)).unwrap().is_applied());
    }
    let mesh = session.into_mesh();
    assert_eq!(mesh.columns(ElementKind::Vertex).count(), 0);
}

#[test]
fn ids_are_given_again_when_nobody_has_them() {
    let program = Program::load("std/triangle.hedge").unwrap();
    let [split, collapse] = ["split", "collapse"].map(|op| program.op(op).unwrap());
    let rounds = |recycles: bool| {
        let mut session = Session::new(&program, shape::icosahedron());
        for _ in 0..50 {
            session.apply(&split, EdgeId(0)).unwrap();
            let new = session.created().iter().rev().find(|new| {
                new.kind == ElementKind::Edge && session.clone().can(&collapse, **new).unwrap()
            });
            let new = *new.expect("what was split can be collapsed");
            assert!(session.apply(&collapse, new).unwrap().is_applied());
            assert!(session.erased().iter().all(|element| !session.is_alive(*element)));
            if recycles {
                session.recycle();
            }
        }
        validate(session.mesh()).unwrap();
        session.mesh().capacity(ElementKind::Halfedge)
    };
    assert!(rounds(true) < 100);
    assert!(rounds(false) > 300);
}

#[test]
fn an_element_that_a_script_is_given_keeps_its_id() {
    let text = "use \"std/triangle.hedge\"
        script s(a: vertex) {
          for e in edges { collapse(e) }
          for e in edges { split(e) }
          a.position = 2 * a.position
        }
        script called(a: vertex) { s(a) }";
    let program = Program::parse("given.hedge", text).unwrap();
    let mut outcomes = [0; 2];
    for name in ["s", "called"] {
        let script = program.script(name).unwrap();
        for vertex in (0..42).map(VertexId) {
            let mut session = Session::new(&program, shape::icosphere(1));
            match session.run(&script, [("a", vertex)]) {
                Ok(_) => outcomes[0] += 1,
                Err(error) => {
                    assert_eq!(error.code(), "element-gone");
                    outcomes[1] += 1;
                }
            }
        }
        let mut session = Session::new(&program, shape::icosphere(1));
        assert_eq!(
            session.run(&script, [("a", VertexId(42))]).unwrap_err().code(),
            "wrong-argument"
        );
        assert_eq!(session.run(&script, [("a", EdgeId(0))]).unwrap_err().code(), "wrong-argument");
        assert_eq!(session.run(&script, ()).unwrap_err().code(), "missing-argument");
    }
    assert!(outcomes.iter().all(|&times| times > 4), "{outcomes:?}");
}

#[test]
fn a_script_can_be_stopped_and_the_session_goes_on() {
    struct Impatient;
    impl Watch for Impatient {
        fn iteration(&mut self, _: u16, _: u64, _: Option<u64>) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }
    let program = program();
    let flips = program.script("all_flips").unwrap();
    let mut session = Session::new(&program, shape::triangle_torus(20, 20));
    let error = session.run_watched(&flips, 100, &mut Impatient).unwrap_err();
    assert_eq!(error.code(), "interrupted");
    validate(session.mesh()).unwrap();
    let report = session.run_watched(&flips, [("rounds", 2)], &mut Unwatched).unwrap();
    let flip = &report.ops[0];
    let refused: u64 = flip.refused.iter().map(|(_, times)| times).sum();
    assert_eq!((flip.name.as_str(), flip.applied + refused), ("flip", 2 * 1200));
}

#[test]
fn operations_and_questions_can_be_stopped() {
    struct Stop(bool);
    impl Watch for Stop {
        fn iteration(&mut self, _: u16, _: u64, _: Option<u64>) -> ControlFlow<()> {
            self.tick()
        }
        fn tick(&mut self) -> ControlFlow<()> {
            match self.0 {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        }
    }
    let text = "op endless(e: edge) { steps { var n = 0 while n == 0 { n = n * 2 } } }
op short(e: edge, times: int = endless_number(1)) { steps { for f in faces { } } }
fn endless_number(n: int) -> int { var m = n while m != 0 { m = m * 1 } return m }";
    let program = Program::parse("endless", text).unwrap();
    let [endless, short] = ["endless", "short"].map(|name| program.op(name).unwrap());
    let mut session = Session::new(&program, shape::octahedron());
    session.watch(Stop(true));
    let before = whole(session.mesh());
    for op in [&endless, &short] {
        let stopped = [
            session.apply(op, EdgeId(1)).map(drop),
            session.can(op, EdgeId(1)).map(drop),
            session.why(op, EdgeId(1)).map(drop),
            session.mask(op, ()).map(drop),
            session.verdicts(op, ()).map(drop),
            session.keep_mask(op, ()).map(drop),
        ];
        stopped.into_iter().for_each(|one| assert_eq!(code(one.unwrap_err()), "interrupted"));
        assert_eq!(whole(session.mesh()), before);
    }
    session.watch(Stop(false));
    assert!(session.apply(&short, (EdgeId(1), 2)).unwrap().is_applied());
    // Many short questions are stopped between two of them.
    let program = self::program();
    let op = program.op("flip").unwrap();
    let mut session = Session::new(&program, shape::triangle_torus(20, 20));
    let mask = session.keep_mask(&op, ()).unwrap();
    let can = session.kept_mask(mask).unwrap().to_vec();
    session.watch(Stop(true));
    assert_eq!(code(session.mask(&op, ()).unwrap_err()), "interrupted");
    assert_eq!(code(session.keep_mask(&op, ()).unwrap_err()), "interrupted");
    session.watch(Stop(false));
    assert_eq!(session.kept_mask(mask).unwrap(), can);
}

#[test]
fn copies_and_threads() {
    fn goes_anywhere<T: Send + Sync>() {}
    goes_anywhere::<(Program, Op, Script, Error)>();
    fn moves<T: Send>() {}
    moves::<Session>();
    let program = program();
    let flip = program.op("flip").unwrap();
    let mut session = Session::new(&program, shape::octahedron());
    let mark = session.mark();
    session.apply(&flip, EdgeId(0)).unwrap();
    let mut copy = session.copy();
    assert!(identical(copy.mesh(), session.mesh()));
    assert_eq!(code(copy.undo(mark).unwrap_err()), "unknown-mark");
    let worker = std::thread::spawn(move || {
        assert!(copy.apply(&flip, EdgeId(0)).unwrap().is_applied());
        copy.into_mesh()
    });
    let changed = worker.join().unwrap();
    assert!(!identical(&changed, session.mesh()));
    session.undo(mark).unwrap();
}

#[test]
fn settings_hold_for_all_programs_of_a_session() {
    let text = format!(
        "{OPS}
        fn chance() -> real {{ random() }}
        script refine() {{ repeat 9 {{ for e in edges {{ split(e) }} }} }}"
    );
    let [one, two, three] = ["a", "b", "c"].map(|name| Program::parse(name, &text).unwrap());
    let mut session = Session::new(&one, shape::octahedron());
    session.use_program(&two);
    session.use_program(&one);
    session.seed(7);
    session.limit_memory(100_000);
    let mut numbers = Vec::new();
    for program in [&one, &two, &three] {
        session.use_program(program);
        numbers.push(session.call(&program.function("chance").unwrap(), ()).unwrap());
        let full = session.run(&program.script("refine").unwrap(), ());
        assert_eq!(code(full.unwrap_err()), "no-room");
    }
    assert!(numbers.iter().all(|number| *number == numbers[0]), "{numbers:?}");
}

#[test]
fn a_kept_mask_of_another_program_leaves_the_current_one() {
    let programs = ["a", "b"].map(|name| Program::parse(name, OPS).unwrap());
    let [first, second] = programs.each_ref().map(|program| program.op("flip").unwrap());
    let mut session = Session::new(&programs[0], shape::octahedron());
    let mask = session.keep_mask(&first, ()).unwrap();
    session.use_program(&programs[1]);
    session.apply(&second, EdgeId(0)).unwrap();
    let kept = session.kept_mask(mask).unwrap().to_vec();
    // The operations of the second program can still be called.
    assert_eq!(session.mask(&second, ()).unwrap(), kept);
    session.apply(&second, EdgeId(1)).unwrap();
    let kept = session.kept_mask(mask).unwrap().to_vec();
    assert_eq!(session.mask(&second, ()).unwrap(), kept);
}

#[test]
fn what_is_wrong_with_a_program_is_told_with_its_places() {
    let error = Program::parse("wrong.hedge", "op flip(e: edge) {\n  before { edge x: a | b }\n}")
        .unwrap_err();
    assert!(!error.diagnostics().is_empty());
    assert!(error.to_string().contains("wrong.hedge:"), "{error}");
    let program = program();
    let parameters: Vec<_> = program
        .script("says")
        .unwrap()
        .parameters()
        .iter()
        .map(|p| (p.name.to_owned(), p.ty, p.default.map(str::to_owned)))
        .collect();
    assert_eq!(parameters[0], ("what".to_owned(), "int", None));
    assert_eq!(parameters[1], ("how".to_owned(), "vec3", Some("vec3(0, 0, 1)".to_owned())));
    let names: Vec<_> = program.ops().map(|op| op.name().to_owned()).collect();
    assert_eq!(names, ["flip", "visit", "divide", "split", "twice"]);
}

#[test]
fn qualified_names_tell_items_of_two_files_apart() {
    let text = "use \"std/triangle.hedge\"
use \"std/polygon.hedge\"
op both(e: edge) { guard simple steps { must triangle::flip(e) must polygon::flip(e) } }";
    let program = Program::parse("mine.hedge", text).unwrap();
    let docs = ["triangle::flip", "polygon::flip", "mine::both"].map(|name| {
        let op = program.op(name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(op.name(), name.split("::").last().unwrap());
        op.docs().to_owned()
    });
    assert_ne!(docs[0], docs[1]);
    for name in ["mine::flip", "nothing::flip", "triangle::nothing", "::flip"] {
        assert!(program.op(name).is_err(), "{name}");
    }
}
