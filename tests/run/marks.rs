//! Marks: whose they are, and what does not come back.

use hedgerow::mesh::{ElementKind, Mesh, VertexId, identical, shape};
use hedgerow::{Error, Program, Session};

fn program(text: &str) -> Program {
    Program::parse("marks.hedge", text).unwrap()
}

fn columns(mesh: &Mesh) -> Vec<String> {
    mesh.columns(ElementKind::Vertex).map(|(_, column)| column.name().to_owned()).collect()
}

#[test]
fn a_mark_belongs_to_its_session() {
    let program = program("script nothing() { }");
    let mut sessions = [(); 2].map(|()| Session::new(&program, shape::cube()));
    let marks = sessions.each_mut().map(Session::mark);
    let [one, other] = &mut sessions;
    other.mesh_mut().set_position(VertexId(0), [9.0; 3].into());
    let before = other.copy_mesh();
    assert_eq!(other.undo(marks[0]).unwrap_err().code(), "unknown-mark");
    assert_eq!(one.keep(marks[1]).unwrap_err().code(), "unknown-mark");
    assert!(identical(other.mesh(), &before));
    other.undo(marks[1]).unwrap();
    assert!(identical(other.mesh(), &shape::cube()));
}

#[test]
fn scratch_of_another_program_does_not_come_back() {
    let [one, other] = ["real", "int"].map(|ty| {
        program(&format!(
            "private attr x: vertex {ty} = 1 script go() {{ for v in vertices {{ v.x = 2 }} }}"
        ))
    });
    let go = |session: &mut Session, program: &Program| {
        session.use_program(program);
        session.run(&program.script("go").unwrap(), ()).unwrap();
    };
    let mut session = Session::new(&one, shape::cube());
    go(&mut session, &one);
    let outer = session.mark();
    let inner = session.mark();
    go(&mut session, &other);
    session.undo(inner).unwrap();
    go(&mut session, &other);
    session.undo(outer).unwrap();
    assert_eq!(columns(session.mesh()), [""; 0]);
    go(&mut session, &other);
    go(&mut session, &one);
    assert_eq!(columns(&session.into_mesh()), [""; 0]);
}

#[test]
fn another_mesh_in_the_place_of_the_marked_one_ends_the_marks() {
    let program = program("script nothing() { }");
    let mut session = Session::new(&program, shape::cube());
    let mut marked = Session::new(&program, shape::octahedron());
    let _open = marked.mark();
    // Also a mesh on which another session has a mark is not the one that is meant.
    for other in [shape::octahedron(), marked.mesh().clone()] {
        let [outer, inner] = [(); 2].map(|()| session.mark());
        *session.mesh_mut() = other.clone();
        let own = session.mark();
        session.mesh_mut().set_position(VertexId(0), [9.0; 3].into());
        session.undo(own).unwrap();
        for mark in [inner, outer] {
            assert_eq!(session.undo(mark).unwrap_err().code(), "unknown-mark");
        }
        assert!(identical(session.mesh(), &other));
    }
    let failed = session.attempt(|session| -> Result<(), Error> {
        *session.mesh_mut() = shape::tetrahedron();
        program.op("missing").map(drop)
    });
    assert_eq!(failed.unwrap_err().code(), "unknown-op");
    assert!(identical(session.mesh(), &shape::tetrahedron()));
    // Changes by hand are undone, and so is a copy that is put back.
    let mark = session.mark();
    let copy = session.mesh().clone();
    session.mesh_mut().set_position(VertexId(0), [9.0; 3].into());
    *session.mesh_mut() = copy;
    session.undo(mark).unwrap();
    assert!(identical(session.mesh(), &shape::tetrahedron()));
}
