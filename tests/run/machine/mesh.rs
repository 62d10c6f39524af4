//! Reading and writing a mesh.

use super::*;
use hedgerow::mesh::{ElementKind, HalfedgeId, VertexId, shape};

fn ask(question: Question, to: Reg, element: Reg) -> Inst {
    Inst::Ask { question, to, elements: [element; 2] }
}

#[test]
fn questions_about_a_cube() {
    let lines = printed(&mut shape::cube(), |asm| {
        let (zero, to) = (asm.constant_int(0), asm.vec());
        let [vertex, edge, face] = [zero; 3];
        let kind = ElementKind::Edge;
        for inst in [
            ask(Question::Degree, to, vertex),
            ask(Question::FaceSize, to, face),
            Inst::Count { kind, to },
            Inst::CountHoles { to },
            Inst::Capacity { kind, to },
            ask(Question::BoundaryVertex, to, vertex),
            ask(Question::BoundaryEdge, to, edge),
            ask(Question::LinkCondition, to, edge),
            Inst::LoadHole { to, face },
            Inst::Alive { kind, to, element: edge },
            ask(Question::Adjacent, to, vertex),
        ] {
            asm.emit(inst);
            print(asm, int, to);
        }
        for inst in [ask(Question::LengthEdge, to, edge), ask(Question::Area, to, face)] {
            asm.emit(inst);
            print(asm, real, to);
        }
        for inst in [
            ask(Question::NormalFace, to, face),
            ask(Question::CentroidFace, to, face),
            Inst::LoadPosition { to, vertex },
        ] {
            asm.emit(inst);
            print(asm, vector, to);
        }
        asm.emit(ask(Question::NormalVertex, to, vertex));
        asm.emit(Inst::LengthVec { to, from: to });
        asm.emit(Inst::RoundReal { to, from: to });
        print(asm, int, to);
    });
    let ints = ["3", "4", "12", "0", "12", "0", "0", "1", "0", "1", "0"];
    assert_eq!(lines[..11], ints);
    let rest = ["2", "4", "(0, 0, -1)", "(0, 0, -1)", "(-1, -1, -1)", "1"];
    assert_eq!(lines[11..], rest);
}

#[test]
fn loads_of_what_is_gone_trap() {
    let field = HalfedgeField::Next;
    let of = ElementField::Face;
    let kind = ElementKind::Vertex;
    let loads = |to: Reg, x: Reg| {
        [
            (Inst::Load { field, to, halfedge: x }, "halfedge"),
            (Inst::LoadHalfedge { of, to, element: x }, "face"),
            (Inst::LoadHole { to, face: x }, "face"),
            (Inst::LoadPosition { to, vertex: x }, "vertex"),
            (ask(Question::Degree, to, x), "vertex"),
            (ask(Question::FaceSize, to, x), "face"),
            (ask(Question::BoundaryEdge, to, x), "edge"),
            (ask(Question::BoundaryVertex, to, x), "vertex"),
            (ask(Question::Adjacent, to, x), "vertex"),
            (ask(Question::LinkCondition, to, x), "edge"),
            (ask(Question::LengthEdge, to, x), "edge"),
            (ask(Question::Area, to, x), "face"),
            (ask(Question::NormalFace, to, x), "face"),
            (ask(Question::NormalVertex, to, x), "vertex"),
            (ask(Question::CentroidFace, to, x), "face"),
            (Inst::Erase { kind, element: x }, "vertex"),
        ]
    };
    for at in 0..16 {
        for id in [1000, i64::from(u32::MAX - 1), i64::from(u32::MAX)] {
            let mut kind = "";
            let got = trap(&mut shape::cube(), |asm| {
                let (wild, to) = (asm.constant_int(id), asm.vec());
                let (inst, of) = loads(to, wild)[at];
                kind = of;
                asm.emit(inst);
            });
            let expected = match id == i64::from(u32::MAX) {
                true => format!("there is no {kind} here"),
                false => format!("the {kind} no longer exists"),
            };
            assert_eq!(got.to_string(), expected);
        }
    }
}

#[test]
fn walks_end_on_a_broken_mesh() {
    let mut mesh = shape::tetrahedron();
    // 0 -> 1 -> 2 -> 1 -> ... never comes back to 0.
    mesh.set_next(HalfedgeId(0), HalfedgeId(1));
    mesh.set_next(HalfedgeId(1), HalfedgeId(2));
    mesh.set_next(HalfedgeId(2), HalfedgeId(1));
    let walk = Walk::Loop;
    let got = trap(&mut mesh, |asm| {
        let (from, buffer) = (asm.constant_int(0), asm.buffer());
        asm.emit(Inst::Collect { walk, buffer, from, until: from, whole: true });
    });
    assert_eq!(got, Message::Endless);
    let got = trap(&mut mesh, |asm| {
        let (from, goal, to) = (asm.constant_int(0), asm.constant_int(9), asm.reg());
        asm.emit(Inst::Meets { walk, to, from, goal, stop: from });
    });
    assert_eq!(got, Message::Endless);
}

#[test]
fn collecting_and_meeting() {
    let lines = printed(&mut shape::cube(), |asm| {
        let (zero, buffer) = (asm.constant_int(0), asm.buffer());
        let (from, last, to) = (asm.reg(), asm.reg(), asm.reg());
        let of = ElementField::Face;
        asm.emit(Inst::LoadHalfedge { of, to: from, element: zero });
        let field = HalfedgeField::Prev;
        asm.emit(Inst::Load { field, to: last, halfedge: from });
        for (walk, until, whole) in [
            (Walk::Loop, last, false),
            (Walk::Loop, from, false),
            (Walk::Loop, from, true),
            (Walk::Star, from, true),
        ] {
            asm.emit(Inst::BufferClear { buffer });
            asm.emit(Inst::Collect { walk, buffer, from, until, whole });
            asm.emit(Inst::BufferLength { buffer, to });
            print(asm, int, to);
        }
        for (goal, stop) in [(from, from), (last, from), (last, last)] {
            let walk = Walk::Loop;
            asm.emit(Inst::Meets { walk, to, from, goal, stop });
            print(asm, truth, to);
        }
    });
    assert_eq!(lines, ["3", "0", "4", "3", "true", "true", "false"]);
}

#[test]
fn buffers() {
    let lines = printed(&mut shape::single_polygon(3), |asm| {
        let (zero, buffer, to) = (asm.constant_int(0), asm.buffer(), asm.reg());
        let index = copy(asm, zero);
        asm.emit(Inst::BufferLiving { of: Elements::Faces, buffer });
        asm.emit(Inst::BufferLiving { of: Elements::Holes, buffer });
        let seven = asm.constant_int(7);
        asm.emit(Inst::BufferPush { buffer, from: seven });
        let (head, otherwise) = (asm.label(), asm.label());
        asm.bind(head);
        asm.emit(Inst::BufferNext { buffer, index, to, otherwise });
        print(asm, int, to);
        asm.emit(Inst::Jump { to: head });
        asm.bind(otherwise);
        asm.emit(Inst::BufferGet { buffer, to, index: zero });
        print(asm, int, to);
    });
    assert_eq!(lines, ["0", "1", "7", "0"]);
    let got = trap(&mut Mesh::default(), |asm| {
        let (buffer, to, index) = (asm.buffer(), asm.reg(), asm.constant_int(-1));
        asm.emit(Inst::BufferGet { buffer, to, index });
    });
    assert_eq!(got, Message::OutOfRange);
}

#[test]
fn living_elements_are_found_from_anywhere() {
    let mut mesh = shape::cube();
    mesh.erase_vertex(VertexId(3));
    let lines = printed(&mut mesh, |asm| {
        let (of, three, done) = (Elements::Vertices, asm.constant_int(3), asm.label());
        let element = copy(asm, three);
        asm.emit(Inst::JumpUnlessLiving { of: Elements::Faces, element, to: done });
        asm.emit(Inst::NextLiving { of, element, otherwise: done });
        print(asm, int, element);
        let huge = asm.constant_int(-1);
        asm.emit(Inst::Copy { to: element, from: huge });
        asm.emit(Inst::NextLiving { of, element, otherwise: done });
        print(asm, int, element);
        asm.bind(done);
    });
    assert_eq!(lines, ["4"]);
}

#[test]
fn writes_are_tested() {
    let cases = |good: Reg, wild: Reg| {
        let (edge, next) = (HalfedgeField::Edge, HalfedgeField::Next);
        let of = ElementField::Edge;
        let hole = true;
        [
            (
                Inst::Store { field: edge, halfedge: good, value: wild },
                "a pointer would lead to no edge",
            ),
            (
                Inst::StoreHalfedge { of, element: good, value: wild },
                "a pointer would lead to no halfedge",
            ),
            (Inst::StoreHole { face: wild, hole }, "the face no longer exists"),
            (
                Inst::Store { field: next, halfedge: wild, value: good },
                "the halfedge no longer exists",
            ),
            (Inst::StorePosition { vertex: wild, value: good }, "the vertex no longer exists"),
        ]
    };
    for at in 0..5 {
        let mut message = "";
        let got = trap(&mut shape::cube(), |asm| {
            let (good, wild) = (asm.constant_int(0), asm.constant_int(-2));
            let (inst, expected) = cases(good, wild)[at];
            message = expected;
            asm.emit(inst);
        });
        assert_eq!(got.to_string(), message);
    }
    let got = trap(&mut shape::cube(), |asm| {
        let (vertex, value) = (asm.constant_int(0), vec3(asm, [0.0, f64::NAN, 0.0]));
        asm.emit(Inst::StorePosition { vertex, value });
    });
    assert_eq!(got, Message::NotFinite);
}

#[test]
fn what_is_created_is_remembered_and_what_is_erased_recycled() {
    let code = code(0, |asm| {
        let to = asm.reg();
        let kind = ElementKind::Vertex;
        asm.emit(Inst::New { kind: ElementKind::Face, to });
        asm.emit(Inst::StoreHole { face: to, hole: true });
        asm.emit(Inst::New { kind: ElementKind::Edge, to });
        asm.emit(Inst::New { kind: ElementKind::Halfedge, to });
        asm.emit(Inst::New { kind, to });
        asm.emit(Inst::Erase { kind, element: to });
        asm.emit(Inst::New { kind, to });
        asm.emit(Inst::Erase { kind, element: to });
        asm.emit(Inst::Recycle);
        asm.emit(Inst::New { kind, to });
    });
    let mut mesh = Mesh::default();
    let mut machine = Machine::default();
    machine.remember_created();
    machine.run(&mut mesh, &code, &[], &mut Unwatched).unwrap();
    use ElementKind::*;
    let created = [(Face, 0), (Edge, 0), (Halfedge, 0), (Vertex, 0), (Vertex, 1), (Vertex, 1)];
    assert_eq!(machine.created(), created);
    assert_eq!((mesh.hole_count(), mesh.vertex_count()), (1, 1));
    let nothing = Code::default();
    machine.run(&mut mesh, &nothing, &[], &mut Unwatched).unwrap();
    assert_eq!(machine.created(), []);
}

#[test]
fn whole_buffers_are_written() {
    let mut mesh = shape::cube();
    printed(&mut mesh, |asm| {
        let (buffer, from, value) = (asm.buffer(), asm.constant_int(0), asm.constant_int(5));
        let (walk, field) = (Walk::Loop, HalfedgeField::Face);
        asm.emit(Inst::Collect { walk, buffer, from, until: from, whole: true });
        asm.emit(Inst::StoreAll { field, buffer, value });
    });
    let moved = mesh.halfedges().filter(|&h| mesh.face(h).0 == 5);
    assert_eq!(moved.count(), 8);
}

#[test]
fn held_positions_are_written_at_the_end_and_the_last_one_stays() {
    let mut mesh = shape::cube();
    let old = [0, 1].map(|id| mesh.position(VertexId(id)));
    printed(&mut mesh, |asm| {
        let (buffer, value, other) = (asm.buffer(), asm.vec(), asm.vec());
        let [zero, one, gone] = [0, 1, 2].map(|id| asm.constant_int(id));
        asm.emit(Inst::LoadPosition { to: value, vertex: one });
        asm.emit(Inst::DeferPosition { buffer, vertex: zero, value });
        asm.emit(Inst::LoadPosition { to: other, vertex: zero });
        asm.emit(Inst::DeferPosition { buffer, vertex: one, value: other });
        asm.emit(Inst::DeferPosition { buffer, vertex: gone, value: other });
        asm.emit(Inst::Erase { kind: ElementKind::Vertex, element: gone });
        asm.emit(Inst::DeferPosition { buffer, vertex: zero, value: other });
        asm.emit(Inst::DeferPosition { buffer, vertex: zero, value });
        asm.emit(Inst::WriteDeferred { buffer });
    });
    assert_eq!([1, 0].map(|id| mesh.position(VertexId(id))), old);
}
