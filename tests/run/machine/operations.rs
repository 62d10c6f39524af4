//! Whole operations, applied or refused.

use super::*;
use hedgerow::mesh::{EdgeId, ElementKind, shape, validate};

/// ```text
///        v2                 v2
///      c/  \b             c/| \b
///     v0 -e- v1    ->    v0 e  v1
///      g\  /h             g\| /h
///        v3                 v3
/// ```
pub fn flip() -> Plan {
    let code = code(1, |asm| {
        let refuse = asm.label();
        write_flip(asm, refuse);
        asm.bind(refuse);
        asm.emit(Inst::Refuse);
    });
    let refusals = [
        ("a face is not a triangle", Phase::Match),
        ("a face is a hole", Phase::Match),
        ("the edge is already there", Phase::Require),
    ];
    plan("flip", &[1], &refusals, code)
}

fn write_flip(asm: &mut Assembler, otherwise: Label) {
    use HalfedgeField::*;
    let load = |asm: &mut Assembler, field, halfedge| {
        let to = asm.reg();
        asm.emit(Inst::Load { field, to, halfedge });
        to
    };
    let (e, a) = (Reg(0), asm.reg());
    let of = ElementField::Edge;
    asm.trap_at(7, Inst::LoadHalfedge { of, to: a, element: e });
    let b = load(asm, Next, a);
    let c = load(asm, Next, b);
    let d = load(asm, Twin, a);
    let g = load(asm, Next, d);
    let h = load(asm, Next, g);
    let (f0, f1) = (load(asm, Face, a), load(asm, Face, d));
    let [v0, v1, v2, v3] = [a, d, c, h].map(|h| load(asm, Vertex, h));
    for (last, right) in [(c, a), (h, d)] {
        let left = load(asm, Next, last);
        asm.emit(Inst::ExpectEqual { left, right, refusal: 0, otherwise });
    }
    let condition = asm.reg();
    let not = Inst::Not { to: condition, from: condition };
    for face in [f0, f1] {
        asm.emit(Inst::LoadHole { to: condition, face });
        asm.emit(not);
        asm.emit(Inst::Expect { condition, refusal: 1, otherwise });
    }
    asm.emit(Inst::Ask { question: Question::Adjacent, to: condition, elements: [v2, v3] });
    asm.emit(not);
    asm.emit(Inst::Expect { condition, refusal: 2, otherwise });
    let store = |asm: &mut Assembler, field, halfedge, value| {
        asm.emit(Inst::Store { field, halfedge, value });
    };
    for [first, second, third, face] in [[a, c, g, f0], [d, h, b, f1]] {
        for (one, two) in [(first, second), (second, third), (third, first)] {
            store(asm, Next, one, two);
            store(asm, Prev, two, one);
            store(asm, Face, one, face);
        }
        let of = ElementField::Face;
        asm.emit(Inst::StoreHalfedge { of, element: face, value: first });
    }
    store(asm, Vertex, a, v3);
    store(asm, Vertex, d, v2);
    let of = ElementField::Vertex;
    for (element, value) in [(v0, g), (v1, b), (v2, c), (v3, h)] {
        asm.emit(Inst::StoreHalfedge { of, element, value });
    }
    asm.emit(Inst::Return { result: Some(e) });
}

#[test]
fn a_flip_applies_inside_a_grid_and_is_refused_elsewhere() {
    let flip = flip();
    let mut mesh = shape::triangle_grid(4, 3);
    let mut machine = Machine::default();
    let mut applied = 0;
    for edge in 0..mesh.capacity(ElementKind::Edge) as u32 {
        let before = format!("{mesh:?}");
        let outcome = machine.apply(&mut mesh, &flip, &[u64::from(edge)]).unwrap();
        validate(&mesh).unwrap();
        match outcome {
            Outcome::Applied { result } => {
                assert_eq!(result, Some(edge));
                assert!(!mesh.is_boundary_edge(EdgeId(edge)));
                applied += 1;
            }
            Outcome::Refused { reason } => {
                assert!(reason.is_some());
                assert_eq!(before, format!("{mesh:?}"));
            }
        }
    }
    assert!(applied >= 10, "{applied}");
    let mut tetrahedron = shape::tetrahedron();
    for edge in 0..6 {
        let outcome = machine.apply(&mut tetrahedron, &flip, &[edge]);
        assert_eq!(outcome, Ok(Outcome::Refused { reason: Some(2) }));
    }
}

#[test]
fn dead_and_wild_arguments_trap() {
    let flip = flip();
    let mut mesh = shape::octahedron();
    let before = format!("{mesh:?}");
    let mut machine = Machine::default();
    for (id, message) in [
        (99, "edge 99 no longer exists"),
        (u64::from(u32::MAX), "there is no edge here"),
        (u64::from(u32::MAX - 1), "edge 4294967294 no longer exists"),
    ] {
        let trap = machine.apply(&mut mesh, &flip, &[id]).unwrap_err();
        assert_eq!(trap.to_string(), message);
        let place = Some(7);
        assert_eq!(trap.trace, [Site { op: None, function: None, place }]);
    }
    assert_eq!(before, format!("{mesh:?}"));
}

#[test]
fn the_refusal_of_the_furthest_attempt_counts_and_of_equals_the_first() {
    let refusals =
        [("a", Phase::Match), ("b", Phase::Guard), ("c", Phase::Require), ("d", Phase::Guard)];
    let code = code(0, |asm| {
        let condition = asm.constant_bool(false);
        for refusal in 0..4 {
            let otherwise = asm.label();
            asm.emit(Inst::Expect { condition, refusal, otherwise });
            asm.bind(otherwise);
        }
        asm.emit(Inst::Refuse);
    });
    let plan = plan("never", &[], &refusals, code);
    let outcome = Machine::default().apply(&mut Mesh::default(), &plan, &[]);
    assert_eq!(outcome, Ok(Outcome::Refused { reason: Some(1) }));
}

#[test]
fn room_finite_positions_and_distinct_elements_are_expected() {
    let refusals = [("no room", Phase::Evaluate), ("not finite", Phase::Evaluate)];
    let code = code(3, |asm| {
        let otherwise = asm.label();
        let room = Room { vertices: 1, halfedges: 6, edges: 3, faces: 2 };
        asm.emit(Inst::ExpectRoom { room, refusal: 0, otherwise });
        asm.emit(Inst::ExpectFinite { vector: Reg(0), refusal: 1, otherwise });
        let (left, right) = (Reg(0), Reg(1));
        asm.emit(Inst::ExpectDistinct { left, right, refusal: 0, otherwise });
        asm.emit(Inst::Return { result: None });
        asm.bind(otherwise);
        asm.emit(Inst::Refuse);
    });
    let plan = plan("place", &[3], &refusals, code);
    let mut machine = Machine::default();
    let mut at = |position: [f64; 3]| {
        let args = position.map(f64::to_bits);
        machine.apply(&mut Mesh::default(), &plan, &args).unwrap()
    };
    let refused = |reason| Outcome::Refused { reason: Some(reason) };
    assert_eq!(at([0.0, 1.0, 2.0]), Outcome::Applied { result: None });
    assert_eq!(at([0.0, 1.0, f64::INFINITY]), refused(1));
    assert_eq!(at([1.0, 1.0, 2.0]), refused(0));
}
