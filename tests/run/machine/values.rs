//! What instructions compute.

use super::*;

#[test]
fn an_instruction_is_small() {
    assert!(size_of::<Inst>() <= 16);
}

/// The instruction of this name on two registers.
macro_rules! two {
    ($name:ident) => {
        |to, left, right| Inst::$name { to, left, right }
    };
}

/// The instruction of this name on one register.
macro_rules! one {
    ($name:ident) => {
        |to, from, _| Inst::$name { to, from }
    };
}

type Operator = fn(Reg, Reg, Reg) -> Inst;

#[test]
fn ints() {
    let cases: [(Operator, i64, i64, i64); 17] = [
        (two!(AddInt), 7, -9, -2),
        (two!(SubInt), 7, -9, 16),
        (two!(MulInt), 7, -9, -63),
        (two!(DivInt), -7, 2, -4),
        (two!(ModInt), -7, 2, 1),
        (two!(MinInt), -7, 2, -7),
        (two!(MaxInt), -7, 2, 2),
        (two!(LessInt), 2, 2, 0),
        (two!(LessEqualInt), 2, 2, 1),
        (two!(Equal), 2, 2, 1),
        (two!(Equal), 2, 3, 0),
        (two!(And), 1, 0, 0),
        (two!(Or), 1, 0, 1),
        (one!(Not), 1, 0, 0),
        (one!(NegInt), 7, 0, -7),
        (one!(AbsInt), -7, 0, 7),
        (one!(Copy), -7, 0, -7),
    ];
    for (inst, left, right, expected) in cases {
        let lines = printed(&mut Mesh::default(), |asm| {
            let (left, right) = (asm.constant_int(left), asm.constant_int(right));
            let to = asm.reg();
            asm.emit(inst(to, left, right));
            print(asm, int, to);
        });
        assert_eq!(lines, [expected.to_string()]);
    }
}

#[test]
fn ints_that_do_not_fit_trap() {
    let cases: [(Operator, Message); 7] = [
        (two!(AddInt), Message::IntOverflow),
        (two!(MulInt), Message::IntOverflow),
        (|to, _, right| Inst::SubInt { to, left: to, right }, Message::IntOverflow),
        (one!(NegInt), Message::IntOverflow),
        (one!(AbsInt), Message::IntOverflow),
        (|to, left, _| Inst::DivInt { to, left, right: to }, Message::DivisionByZero),
        (|to, left, _| Inst::ModInt { to, left, right: to }, Message::DivisionByZero),
    ];
    for (inst, message) in cases {
        let got = trap(&mut Mesh::default(), |asm| {
            let (least, zero) = (asm.constant_int(i64::MIN), asm.constant_int(0));
            let to = copy(asm, zero);
            asm.emit(inst(to, least, least));
        });
        assert_eq!(got, message);
    }
    for (number, message) in [
        (f64::NAN, Message::RoundsNaN),
        (f64::INFINITY, Message::IntOverflow),
        (-1e300, Message::IntOverflow),
    ] {
        let got = trap(&mut Mesh::default(), |asm| {
            let (from, to) = (asm.constant_real(number), asm.reg());
            asm.emit(Inst::RoundReal { to, from });
        });
        assert_eq!(got, message);
    }
}

#[test]
fn reals() {
    let cases: [(Operator, f64, f64, &str); 11] = [
        (two!(AddReal), 0.5, 2.0, "2.5"),
        (two!(SubReal), 0.5, 2.0, "-1.5"),
        (two!(MulReal), 0.5, 2.0, "1"),
        (two!(DivReal), 0.5, 2.0, "0.25"),
        (two!(DivReal), 1.0, 0.0, "inf"),
        (two!(MinReal), 0.5, 2.0, "0.5"),
        (two!(MaxReal), 0.5, 2.0, "2"),
        (two!(PowReal), 0.5, 2.0, "0.25"),
        (two!(Atan2Real), 0.0, 2.0, "0"),
        (one!(Copy), 1e300, 0.0, "1e300"),
        (
            |to, left, right| Inst::Select { to, condition: left, then: right, otherwise: left },
            0.0,
            1.5,
            "0",
        ),
    ];
    for (inst, left, right, expected) in cases {
        let lines = printed(&mut Mesh::default(), |asm| {
            let (left, right) = (asm.constant_real(left), asm.constant_real(right));
            let to = asm.reg();
            asm.emit(inst(to, left, right));
            print(asm, real, to);
        });
        assert_eq!(lines, [expected]);
    }
    let tests: [(Operator, &str); 3] =
        [(two!(LessReal), "true"), (two!(LessEqualReal), "true"), (two!(EqualReal), "false")];
    for (inst, expected) in tests {
        let lines = printed(&mut Mesh::default(), |asm| {
            let (left, right) = (asm.constant_real(0.5), asm.constant_real(2.0));
            let to = asm.reg();
            asm.emit(inst(to, left, right));
            print(asm, truth, to);
        });
        assert_eq!(lines, [expected]);
    }
}

#[test]
fn every_function_of_a_real() {
    use Math::*;
    let x: f64 = 0.3;
    let all = [
        (Sqrt, x.sqrt()),
        (Sin, x.sin()),
        (Cos, x.cos()),
        (Tan, x.tan()),
        (Asin, x.asin()),
        (Acos, x.acos()),
        (Exp, x.exp()),
        (Log, x.ln()),
        (Floor, 0.0),
        (Ceil, 1.0),
        (Abs, x),
        (Negate, -x),
    ];
    for (math, expected) in all {
        let lines = printed(&mut Mesh::default(), |asm| {
            let (from, to) = (asm.constant_real(x), asm.reg());
            asm.emit(Inst::MathReal { math, to, from });
            print(asm, real, to);
        });
        assert_eq!(lines, [RealText(expected, RealDigits::All).to_string()]);
    }
}

#[test]
fn vectors() {
    let cases: [(Operator, &str); 8] = [
        (one!(CopyVec), "(1, 2, 2)"),
        (two!(AddVec), "(1, 2, 6)"),
        (two!(SubVec), "(1, 2, -2)"),
        (two!(MulVec), "(0, 0, 8)"),
        (one!(NegVec), "(-1, -2, -2)"),
        (two!(Cross), "(8, -4, 0)"),
        (|to, _, from| Inst::Normalize { to, from }, "(0, 0, 1)"),
        (|to, left, right| Inst::MixVec { to, left, right, t: right.part(3) }, "(0.5, 1, 3)"),
    ];
    // Behind `right` stands one half.
    let operands = |asm: &mut Assembler| {
        let (left, right) = (vec3(asm, [1.0, 2.0, 2.0]), asm.block(4));
        for (offset, part) in [0.0, 0.0, 4.0, 0.5].into_iter().enumerate() {
            let (to, from) = (right.part(offset as u16), asm.constant_real(part));
            asm.emit(Inst::Copy { to, from });
        }
        (left, right, asm.vec())
    };
    for (inst, expected) in cases {
        let lines = printed(&mut Mesh::default(), |asm| {
            let (left, right, to) = operands(asm);
            asm.emit(inst(to, left, right));
            print(asm, vector, to);
        });
        assert_eq!(lines, [expected]);
    }
    let lines = printed(&mut Mesh::default(), |asm| {
        let (left, right, to) = operands(asm);
        let half = right.part(3);
        asm.emit(Inst::ScaleVec { to, left, right: half });
        print(asm, vector, to);
        asm.emit(Inst::DivVec { to, left, right: half });
        print(asm, vector, to);
        asm.emit(Inst::Dot { to, left, right });
        print(asm, real, to);
        asm.emit(Inst::LengthVec { to, from: left });
        print(asm, real, to);
        asm.emit(Inst::EqualVec { to, left, right });
        print(asm, truth, to);
    });
    assert_eq!(lines, ["(0.5, 1, 1)", "(2, 4, 4)", "8", "3", "false"]);
}
