//! Functions called from outside, several programs on one mesh, and programs as texts.

use std::collections::BTreeSet;

use hedgerow::mesh::{EdgeId, ElementKind, FaceId, VertexId, identical, shape};
use hedgerow::{Argument, Outcome, Program, Session, Unwatched, Values};

const FUNCTIONS: &str = "
use \"std/triangle.hedge\"
private attr seen: vertex int = 3
/// How much longer an edge is.
fn excess(e: edge, than: real = 1) -> real { length(e) - than }
fn ends(e: edge) -> vec3 { e.halfedge.target.position - e.halfedge.vertex.position }
fn far(v: vertex) -> vertex { v.halfedge.target }
fn busy(v: vertex) -> bool { degree(v) > 4 and v.seen == 3 }
fn name(f: face) -> text { if degree(f) == 3 { \"triangle\" } else { \"polygon\" } }
fn allowed(e: edge) -> bool { can flip(e) }
fn why_not(e: edge) -> text { why flip(e) }
fn total(scale: real) -> real { scale * sum(length(e) for e in edges) }
fn split_all(most: int) -> int {
  var done = 0
  for e in edges { if done < most { if split(e) { done = done + 1 } } }
  return done
}
fn same(f: face, a: text) -> text { if a == \"triangle\" { name(f) } else { a } }
fn greet() { print \"hello\" }
fn bad(e: edge) -> int { 1 div 0 }
script spend() { for v in vertices { v.seen = 4 } }
";

fn values(session: &mut Session, name: &str) -> Result<Values, hedgerow::Error> {
    let function = session.program().function(name).unwrap();
    session.values(&function, (), &mut Unwatched)
}

#[test]
fn functions_have_values_everywhere() {
    let program = Program::parse("functions.hedge", FUNCTIONS).unwrap();
    let mut session = Session::new(&program, shape::icosahedron());
    let length = session.mesh().length(EdgeId(0));
    let Values::Real(all) = values(&mut session, "excess").unwrap() else { panic!() };
    assert!(all.len() == 30 && all.iter().all(|&one| (one - (length - 1.0)).abs() < 1e-9));
    let Values::Reals(3, all) = values(&mut session, "ends").unwrap() else { panic!() };
    assert!(
        all.chunks(3)
            .all(|v| ((v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt() - length).abs() < 1e-9)
    );
    assert_eq!(values(&mut session, "busy").unwrap(), Values::Bool(vec![true; 12]));
    assert_eq!(values(&mut session, "allowed").unwrap(), Values::Bool(vec![true; 30]));
    assert_eq!(values(&mut session, "name").unwrap(), Values::Text(vec!["triangle".into(); 20]));
    assert_eq!(values(&mut session, "why_not").unwrap(), Values::Text(vec![String::new(); 30]));
    let Values::Element(ElementKind::Vertex, far) = values(&mut session, "far").unwrap() else {
        panic!()
    };
    assert!(far.iter().enumerate().all(|(v, far)| far.is_some_and(|far| far as usize != v)));

    let op = program.op("collapse").unwrap();
    session.apply(&op, EdgeId(7)).unwrap();
    let Values::Element(_, far) = values(&mut session, "far").unwrap() else { panic!() };
    assert_eq!(far.iter().filter(|far| far.is_none()).count(), 1);
    assert_eq!(values(&mut session, "bad").unwrap_err().code(), "division-by-zero");
    assert_eq!(values(&mut session, "total").unwrap_err().code(), "wrong-argument");
}

#[test]
fn functions_are_called_at_one_place() {
    let program = Program::parse("functions.hedge", FUNCTIONS).unwrap();
    let mut session = Session::new(&program, shape::icosahedron());
    let length = session.mesh().length(EdgeId(0));
    let function = |name: &str| program.function(name).unwrap();
    assert_eq!(function("excess").docs(), [" How much longer an edge is."].map(str::trim_start));
    assert_eq!((function("excess").result(), function("greet").result()), (Some("real"), None));
    let value = session.call(&function("excess"), (EdgeId(3), 0.0)).unwrap();
    assert_eq!(value, Some(Argument::Real(length)));
    let Some(Argument::Real(total)) = session.call(&function("total"), 2.0).unwrap() else {
        panic!()
    };
    assert!((total - 60.0 * length).abs() < 1e-9);
    assert_eq!(session.call(&function("greet"), ()).unwrap(), None);
    assert_eq!(session.call(&function("name"), FaceId(3)).unwrap(), Some("triangle".into()));
    assert!(!function("excess").changes().unwrap() && function("split_all").changes().unwrap());
    let flip = program.op("flip").unwrap();
    let mask = session.keep_mask(&flip, ()).unwrap();
    assert_eq!(session.call(&function("split_all"), 3).unwrap(), Some(Argument::Int(3)));
    assert_eq!(session.mesh().vertex_count(), 15);
    assert_eq!(session.kept_mask(mask).unwrap().to_vec(), session.mask(&flip, ()).unwrap());
    let error = session.call(&function("excess"), (EdgeId(900), 0.0)).unwrap_err();
    assert_eq!(error.code(), "wrong-argument");
    let error = program.function("exces").unwrap_err();
    assert_eq!(
        (error.code(), error.message()),
        ("unknown-function", "the program has no function `exces`; did you mean `excess`?")
    );
}

#[test]
fn texts_that_are_given_come_back() {
    let program = Program::parse("functions.hedge", FUNCTIONS).unwrap();
    let mut session = Session::new(&program, shape::tetrahedron());
    let same = program.function("same").unwrap();
    for text in ["hello", "", "triangle"] {
        let value = session.call(&same, (FaceId(1), text)).unwrap();
        assert_eq!(value, Some(Argument::from(text)));
        let all = session.values(&same, [("a", text)], &mut Unwatched).unwrap();
        assert_eq!(all, Values::Text(vec![text.into(); 4]));
    }
}

#[test]
fn a_question_gives_no_id_out_again() {
    let program = Program::parse("functions.hedge", FUNCTIONS).unwrap();
    let mut session = Session::new(&program, shape::icosphere(1));
    let collapse = program.op("collapse").unwrap();
    assert!(session.apply(&collapse, EdgeId(2)).unwrap().is_applied());
    let gone = session.erased().to_vec();
    values(&mut session, "allowed").unwrap();
    session.call(&program.function("excess").unwrap(), EdgeId(40)).unwrap();
    let split = program.op("split").unwrap();
    session.apply(&split, EdgeId(40)).unwrap();
    assert!(session.created().iter().all(|one| !gone.contains(one)));
}

#[test]
fn several_programs_work_on_a_mesh() {
    let one = Program::parse("one.hedge", FUNCTIONS).unwrap();
    let other = "private attr seen: vertex real = 0.5
        attr heat: vertex real = 1
        op warm(v: vertex) {
          before { face f: v -a-> w =P=> v }
          after { face f: v -a-> w =P=> v  v.heat = v.heat + v.seen }
        }";
    let other = Program::parse("other.hedge", other).unwrap();
    let mut session = Session::new(&one, shape::icosahedron());
    let warm = other.op("warm").unwrap();
    let spend = one.script("spend").unwrap();
    let mark = session.mark();
    let start = session.copy_mesh();
    for turn in 1..4 {
        session.use_program(&one);
        session.run(&spend, ()).unwrap();
        assert_eq!(values(&mut session, "busy").unwrap(), Values::Bool(vec![true; 12]));
        assert_eq!(session.apply(&warm, VertexId(0)).unwrap_err().code(), "foreign-program");
        session.use_program(&other);
        assert!(session.apply(&warm, VertexId(0)).unwrap().is_applied());
        let heat = session.mesh().find_column(ElementKind::Vertex, "heat").unwrap();
        assert_eq!(session.mesh().values::<f64>(heat).unwrap()[0], 1.0 + 0.5 * f64::from(turn));
    }
    let names: BTreeSet<_> = session
        .copy_mesh()
        .columns(ElementKind::Vertex)
        .map(|(_, column)| column.name().to_owned())
        .collect();
    assert_eq!(names.into_iter().collect::<Vec<_>>(), ["heat"]);
    session.undo(mark).unwrap();
    assert!(identical(&start, &session.copy_mesh()));
    session.use_program(&one);
    assert_eq!(values(&mut session, "busy").unwrap(), Values::Bool(vec![true; 12]));
}

#[test]
fn seeds_give_the_same_numbers() {
    let program = Program::parse("p", "fn chance() -> real { random() }").unwrap();
    let chance = program.function("chance").unwrap();
    let mut session = Session::new(&program, shape::cube());
    let mut three = |seed: u64| {
        session.seed(seed);
        [(); 3].map(|()| session.call(&chance, ()).unwrap())
    };
    let (first, other, again) = (three(7), three(8), three(7));
    assert!(first == again && first != other && first[0] != first[1]);
}

#[test]
fn a_program_goes_to_texts_and_back() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("ops.hedge"),
        "use \"std/triangle.hedge\"\nuse \"mine.hedge\"\nscript go() { print \"{twice(3)}\" }",
    )
    .unwrap();
    std::fs::write(folder.path().join("mine.hedge"), "fn twice(n: int) -> int { 2 * n }").unwrap();
    let program = Program::load(folder.path().join("ops.hedge")).unwrap();
    let texts = program.texts();
    assert_eq!(texts.len(), 2);
    drop(folder);
    let back = Program::from_texts(&texts).unwrap();
    assert_eq!(back.texts(), texts);
    assert!(back.op("flip").is_ok() && back.function("twice").is_ok() && back.script("go").is_ok());
    assert_eq!(Program::from_texts(&[]).unwrap_err().code(), "missing-file");
    // What is not among the texts is not looked for on the disk.
    let lost = [("lost.hedge".to_owned(), "use \"/etc/hostname\"".to_owned())];
    assert!(Program::from_texts(&lost).unwrap_err().to_string().contains("no such file"));
}

#[test]
fn an_own_item_hides_one_of_the_same_name() {
    let texts = [
        (
            "own.hedge",
            "use \"std/triangle.hedge\"\nuse \"parts.hedge\"\n\
             fn digit() -> int { 1 }\n\
             fn both() -> int { 10 * digit() + that_of_parts() }\n\
             op flip(e: edge) {\n  require length(e) < 0 else \"mine\"\n  steps { must split(e) }\n}",
        ),
        ("parts.hedge", "fn digit() -> int { 2 }\nfn that_of_parts() -> int { digit() }"),
    ];
    let program =
        Program::from_texts(&texts.map(|(name, text)| (name.into(), text.into()))).unwrap();
    let mut session = Session::new(&program, shape::tetrahedron());
    let both = program.function("both").unwrap();
    assert_eq!(session.call(&both, ()).unwrap(), Some(Argument::Int(12)));
    let flip = program.op("flip").unwrap();
    let edge = session.mesh().edges().next().unwrap();
    match session.apply(&flip, edge).unwrap() {
        Outcome::Refused(reason) => assert_eq!(reason.to_string(), "mine"),
        Outcome::Applied(_) => panic!("the flip of the library was applied"),
    }
}
