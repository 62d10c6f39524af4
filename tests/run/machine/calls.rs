//! Code that calls, prints, is watched, or is malformed.

use super::operations::flip;
use super::*;
use hedgerow::mesh::{ElementKind, shape, validate};
use std::ops::ControlFlow;

/// Applies op 0 to every edge.
fn apply_to_all() -> Code {
    code(0, |asm| {
        let (buffer, args) = (asm.buffer(), asm.reg());
        let (applied, result) = (asm.reg(), asm.reg());
        let (head, done) = (asm.label(), asm.label());
        let (of, zero) = (Elements::Edges, asm.constant_int(0));
        asm.emit(Inst::BufferLiving { of, buffer });
        let index = copy(asm, zero);
        asm.bind(head);
        asm.emit(Inst::BufferNext { buffer, index, to: args, otherwise: done });
        asm.emit(Inst::JumpUnlessLiving { of, element: args, to: head });
        asm.emit(Inst::Iteration { depth: 0, done: index, total: index });
        asm.trap_at(3, Inst::Apply { op: 0, args, applied, result });
        asm.emit(Inst::JumpIf { condition: applied, to: head });
        asm.emit(Inst::Jump { to: head });
        asm.bind(done);
    })
}

/// Why applying a plan to every edge of a cube traps, and where.
fn trap_in(plan: Option<Plan>) -> Trap {
    let plans = Plans::from([plan]);
    let mut machine = Machine::new(&plans);
    let run = machine.run(&mut shape::cube(), &apply_to_all(), &[], &mut Unwatched);
    run.unwrap_err()
}

#[test]
fn calls_are_counted() {
    let plans = Plans::from([Some(flip())]);
    let mut machine = Machine::new(&plans);
    let mut mesh = shape::triangle_grid(5, 5);
    machine.run(&mut mesh, &apply_to_all(), &[], &mut Unwatched).unwrap();
    let count = &machine.counts()[0];
    assert!(count.applied > 10, "{count:?}");
    assert_eq!(count.refused.len(), 3);
    let refused: u64 = count.refused.iter().sum();
    assert_eq!(count.applied + refused, mesh.edge_count() as u64);
    validate(&mesh).unwrap();
}

#[test]
fn calls_trap_with_a_trace() {
    let outer = Site { op: None, function: None, place: Some(3) };
    let trap = trap_in(None);
    assert_eq!(trap.message, Message::Unproved);
    assert_eq!(trap.trace, [outer]);

    let code = code(1, |asm| {
        let text = asm.text("so it is");
        asm.trap_at(8, Inst::Fail { text, around: None });
    });
    let trap = trap_in(Some(plan("fails", &[1], &[], code)));
    assert_eq!(trap.to_string(), "so it is");
    let inner = Site { op: Some(0), function: None, place: Some(8) };
    assert_eq!(trap.trace, [inner, outer]);
}

#[test]
fn calls_without_end_trap() {
    let trap = trap_in(Some(plan("endless", &[1], &[], apply_to_all())));
    assert_eq!(trap.message, Message::TooDeep);
}

#[test]
fn an_op_that_must_not_refuse_traps_with_its_reason() {
    let plans = Plans::from([Some(flip())]);
    let code = code(1, |asm| {
        let (args, applied, result) = (Reg(0), asm.reg(), asm.reg());
        asm.emit(Inst::Apply { op: 0, args, applied, result });
        asm.emit(Inst::Refused { op: 0 });
    });
    let mut machine = Machine::new(&plans);
    let run = machine.run(&mut shape::tetrahedron(), &code, &[2], &mut Unwatched);
    let message = "`flip` refused: the edge is already there";
    assert_eq!(run.unwrap_err().to_string(), message);
}

struct Impatient(Vec<(u16, u64, Option<u64>)>);

impl Watch for Impatient {
    fn iteration(&mut self, depth: u16, done: u64, total: Option<u64>) -> ControlFlow<()> {
        self.0.push((depth, done, total));
        match self.0.len() {
            0..4 => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        }
    }

    fn tick(&mut self) -> ControlFlow<()> {
        ControlFlow::Break(())
    }
}

#[test]
fn the_watcher_sees_all_loops_and_interrupts() {
    let mut watch = Impatient(Vec::new());
    let code = code(0, |asm| {
        let [zero, one, none] = [0, 1, -1].map(|n| asm.constant_int(n));
        let (done, head) = (copy(asm, zero), asm.label());
        asm.bind(head);
        asm.emit(Inst::Iteration { depth: 0, done, total: none });
        asm.emit(Inst::Iteration { depth: 1, done: one, total: one });
        asm.emit(Inst::AddInt { to: done, left: done, right: one });
        asm.emit(Inst::Jump { to: head });
    });
    let run = Machine::default().run(&mut Mesh::default(), &code, &[], &mut watch);
    assert_eq!(run.unwrap_err().message, Message::Interrupted);
    let inner = (1, 1, Some(1));
    assert_eq!(watch.0, [(0, 127, None), inner, (0, 255, None), inner]);

    let code = super::code(0, |asm| {
        let to = asm.label();
        asm.bind(to);
        asm.emit(Inst::Tick);
        asm.emit(Inst::Jump { to });
    });
    let run = Machine::default().run(&mut Mesh::default(), &code, &[], &mut watch);
    assert_eq!(run.unwrap_err().message, Message::Interrupted);
}

#[test]
fn the_watcher_is_called_after_a_face_with_many_diagonals() {
    for (sides, is_called) in [(1_000, false), (1_010, true)] {
        let code = code(1, |asm| {
            let buffer = asm.buffer();
            asm.emit(Inst::CollectEars { triangles: Triangles::BestShape, buffer, face: Reg(0) });
        });
        let mut watch = Impatient(Vec::new());
        let run =
            Machine::default().run(&mut shape::single_polygon(sides), &code, &[0], &mut watch);
        assert_eq!(run.is_err(), is_called);
    }
}

#[test]
fn lines_are_put_together() {
    let lines = printed(&mut shape::cube(), |asm| {
        let (two, yes) = (asm.constant_int(2), asm.constant_bool(true));
        let (of, space, kind) = (asm.constant_text("of"), asm.text(" "), ElementKind::Vertex);
        let to = asm.reg();
        asm.emit(Inst::IntToReal { to, from: two });
        for inst in [
            Inst::PrintElement { kind, from: two },
            Inst::PrintText { text: space },
            Inst::PrintTextOf { from: of },
            truth(yes),
            real(to),
            Inst::PrintEnd,
            Inst::PrintEnd,
        ] {
            asm.emit(inst);
        }
    });
    assert_eq!(lines, ["vertex 2 oftrue2", ""]);
}

#[test]
fn jumps() {
    let lines = printed(&mut Mesh::default(), |asm| {
        let (left, right) = (asm.constant_int(1), asm.constant_int(2));
        let (condition, no) = (left, asm.constant_int(0));
        let to = Label(0);
        for (mut inst, jumps) in [
            (Inst::JumpIf { condition, to }, true),
            (Inst::JumpIf { condition: no, to }, false),
            (Inst::JumpUnless { condition, to }, false),
            (Inst::JumpUnless { condition: no, to }, true),
            (Inst::JumpEqual { left, right, to }, false),
            (Inst::JumpEqual { left, right: left, to }, true),
            (Inst::JumpUnequal { left, right, to }, true),
            (Inst::JumpUnequal { left, right: left, to }, false),
        ] {
            let (over, from) = (asm.label(), asm.constant_bool(jumps));
            *inst.target_mut().unwrap() = over;
            asm.emit(truth(from));
            asm.emit(inst);
            asm.emit(int(no));
            asm.bind(over);
        }
        asm.emit(Inst::PrintEnd);
    });
    assert_eq!(lines, ["truefalse0false0truefalse0truetruefalse0"]);
}

#[test]
fn malformed_code_does_not_panic() {
    let last = Reg(u16::MAX);
    let insts = [
        Inst::BufferClear { buffer: 9 },
        Inst::PrintText { text: 9 },
        Inst::Fail { text: 9, around: None },
        Inst::Refused { op: 9 },
        Inst::Apply { op: 9, args: last, applied: last, result: last },
    ];
    let run = |inst| {
        let insts = vec![inst];
        let code = Code { insts, ..Code::default() };
        Machine::default().run(&mut Mesh::default(), &code, &[1; 70_000], &mut Unwatched)
    };
    for inst in insts {
        assert!(run(inst).is_err(), "{inst:?}");
    }
    for inst in
        [Inst::Jump { to: Label(u32::MAX) }, Inst::CopyVec { to: last, from: Reg(u16::MAX - 1) }]
    {
        assert_eq!(run(inst), Ok(Outcome::Applied { result: None }));
    }
}

/// No test but a measure:
/// `cargo test --release --test run machine -- --ignored --nocapture`.
#[test]
#[ignore = "measures"]
fn time_per_instruction() {
    const ITERATIONS: i64 = 20_000_000;
    let code = code(0, |asm| {
        let [zero, one, end] = [0, 1, ITERATIONS].map(|n| asm.constant_int(n));
        let (sum, index) = (copy(asm, zero), copy(asm, zero));
        let (square, condition, head) = (asm.reg(), asm.reg(), asm.label());
        asm.bind(head);
        asm.emit(Inst::IntToReal { to: square, from: index });
        asm.emit(Inst::MulReal { to: square, left: square, right: square });
        asm.emit(Inst::AddReal { to: sum, left: sum, right: square });
        asm.emit(Inst::AddInt { to: index, left: index, right: one });
        asm.emit(Inst::LessInt { to: condition, left: index, right: end });
        asm.emit(Inst::JumpIf { condition, to: head });
    });
    let start = std::time::Instant::now();
    let run = Machine::default().run(&mut Mesh::default(), &code, &[], &mut Unwatched);
    run.unwrap();
    let each = start.elapsed().as_nanos() as f64 / (6 * ITERATIONS) as f64;
    println!("{each:.2} ns an instruction");

    let plans = Plans::from([Some(flip())]);
    let mut mesh = shape::triangle_torus(300, 300);
    let mut machine = Machine::new(&plans);
    let code = apply_to_all();
    let start = std::time::Instant::now();
    for _ in 0..4 {
        machine.run(&mut mesh, &code, &[], &mut Unwatched).unwrap();
    }
    let calls = 4 * mesh.edge_count();
    let each = start.elapsed().as_nanos() as f64 / calls as f64;
    let length = plans[0].as_ref().map_or(0, |plan| plan.code.insts.len());
    println!("{each:.0} ns a call of a flip of {length} instructions");
    println!("{:?}", machine.counts());
}
