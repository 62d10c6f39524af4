//! Instructions that compute with registers alone.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::types::{F64, I64};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value};

use super::stubs;
use super::translate::Translator;
use crate::rewrite::arithmetic::LARGEST_KEY;
use crate::rewrite::vectors::Lanes;
use crate::rewrite::{Inst, Math, Reg};

impl Translator<'_, '_> {
    /// Translates an instruction that computes with registers alone; false if it is another one, or
    /// is left to the machine.
    pub(super) fn value(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::Const { to, bits } => {
                let value = self.b.ins().iconst(I64, bits as i64);
                self.set_whole(to, value);
            }
            Inst::Copy { to, from } => self.copy(to, from, 1),
            Inst::CopyVec { to, from } => self.copy(to, from, 3),
            Inst::CopyWide { to, from, width } => self.copy(to, from, u16::from(width)),
            Inst::Select { to, condition, then, otherwise } => {
                let condition = self.whole(condition);
                let (then, otherwise) = (self.whole(then), self.whole(otherwise));
                let value = self.b.ins().select(condition, then, otherwise);
                self.set_whole(to, value);
            }
            Inst::Not { to, from } => {
                let from = self.whole(from);
                let value = self.b.ins().icmp_imm_u(IntCC::Equal, from, 0);
                self.set_truth(to, value);
            }
            Inst::And { to, left, right } => {
                let [left, right] = [left, right].map(|reg| self.truth(reg));
                let value = self.b.ins().band(left, right);
                self.set_truth(to, value);
            }
            Inst::Or { to, left, right } => {
                let (left, right) = (self.whole(left), self.whole(right));
                let either = self.b.ins().bor(left, right);
                let value = self.b.ins().icmp_imm_u(IntCC::NotEqual, either, 0);
                self.set_truth(to, value);
            }
            Inst::Equal { to, left, right } => {
                let value = self.compare(IntCC::Equal, left, right);
                self.set_truth(to, value);
            }
            Inst::LessInt { to, left, right } => {
                let value = self.compare(IntCC::SignedLessThan, left, right);
                self.set_truth(to, value);
            }
            Inst::LessEqualInt { to, left, right } => {
                let value = self.compare(IntCC::SignedLessThanOrEqual, left, right);
                self.set_truth(to, value);
            }
            Inst::AddInt { to, left, right }
            | Inst::SubInt { to, left, right }
            | Inst::MulInt { to, left, right } => {
                let (left, right) = (self.whole(left), self.whole(right));
                let ins = self.b.ins();
                let (value, overflow) = match inst {
                    Inst::AddInt { .. } => ins.sadd_overflow(left, right),
                    Inst::SubInt { .. } => ins.ssub_overflow(left, right),
                    _ => ins.smul_overflow(left, right),
                };
                self.set_unless(to, value, overflow);
            }
            Inst::DivInt { to, left, right } | Inst::ModInt { to, left, right } => {
                self.divide(inst, matches!(inst, Inst::ModInt { .. }), to, [left, right]);
            }
            Inst::NegInt { to, from } => {
                let from = self.whole(from);
                let zero = self.b.ins().iconst(I64, 0);
                let (value, overflow) = self.b.ins().ssub_overflow(zero, from);
                self.set_unless(to, value, overflow);
            }
            Inst::AbsInt { to, from } => {
                let from = self.whole(from);
                let overflow = self.b.ins().icmp_imm_s(IntCC::Equal, from, i64::MIN);
                let value = self.b.ins().iabs(from);
                self.set_unless(to, value, overflow);
            }
            Inst::MinInt { to, left, right } | Inst::MaxInt { to, left, right } => {
                let (left, right) = (self.whole(left), self.whole(right));
                let value = match inst {
                    Inst::MinInt { .. } => self.b.ins().smin(left, right),
                    _ => self.b.ins().smax(left, right),
                };
                self.set_whole(to, value);
            }
            Inst::IntToReal { to, from } | Inst::IntToKey { to, from } => {
                let from = self.whole(from);
                if matches!(inst, Inst::IntToKey { .. }) {
                    let above_least = self.b.ins().iadd_imm_s(from, LARGEST_KEY);
                    let most = 2 * LARGEST_KEY;
                    let is_exact =
                        self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, above_least, most);
                    self.or_fault(is_exact);
                }
                let value = self.b.ins().fcvt_from_sint(F64, from);
                self.set_real(to, value);
            }
            Inst::AddReal { to, left, right } => self.each(to, left, right, Lanes::Add, 1),
            Inst::SubReal { to, left, right } => self.each(to, left, right, Lanes::Subtract, 1),
            Inst::MulReal { to, left, right } => self.each(to, left, right, Lanes::Multiply, 1),
            Inst::DivReal { to, left, right } => self.by_real(to, left, right, Lanes::Divide, 1),
            Inst::MinReal { to, left, right } => self.function(stubs::min, to, left, right),
            Inst::MaxReal { to, left, right } => self.function(stubs::max, to, left, right),
            Inst::PowReal { to, left, right } => self.function(stubs::pow, to, left, right),
            Inst::Atan2Real { to, left, right } => self.function(stubs::atan2, to, left, right),
            Inst::LessReal { to, left, right } => {
                self.compare_reals(FloatCC::LessThan, to, left, right);
            }
            Inst::LessEqualReal { to, left, right } => {
                self.compare_reals(FloatCC::LessThanOrEqual, to, left, right);
            }
            Inst::EqualReal { to, left, right } => {
                self.compare_reals(FloatCC::Equal, to, left, right);
            }
            Inst::MathReal { math, to, from } => {
                let from = self.real(from);
                let value = match math {
                    Math::Sqrt => self.b.ins().sqrt(from),
                    Math::Abs => self.b.ins().fabs(from),
                    Math::Negate => self.b.ins().fneg(from),
                    math => self.call_real(stubs::function(math) as *const () as usize, &[from]),
                };
                self.set_real(to, value);
            }
            Inst::AddVec { to, left, right } => self.each(to, left, right, Lanes::Add, 3),
            Inst::SubVec { to, left, right } => self.each(to, left, right, Lanes::Subtract, 3),
            Inst::MulVec { to, left, right } => self.each(to, left, right, Lanes::Multiply, 3),
            Inst::NegVec { to, from } => {
                let values = self.vector(from).map(|part| self.b.ins().fneg(part));
                self.set_vector(to, values);
            }
            Inst::ScaleVec { to, left, right } => self.by_real(to, left, right, Lanes::Scale, 3),
            Inst::DivVec { to, left, right } => self.by_real(to, left, right, Lanes::Divide, 3),
            Inst::MixVec { to, left, right, t } => {
                let (left, right, t) = (self.vector(left), self.vector(right), self.real(t));
                let one = self.b.ins().f64const(1.0);
                let rest = self.b.ins().fsub(one, t);
                let values = [0, 1, 2].map(|part| {
                    let from = self.b.ins().fmul(left[part], rest);
                    let to = self.b.ins().fmul(right[part], t);
                    self.b.ins().fadd(from, to)
                });
                self.set_vector(to, values);
            }
            Inst::EqualVec { to, left, right } => {
                let (left, right) = (self.vector(left), self.vector(right));
                let [x, y, z] = [0, 1, 2]
                    .map(|part| self.b.ins().fcmp(FloatCC::Equal, left[part], right[part]));
                let xy = self.b.ins().band(x, y);
                let value = self.b.ins().band(xy, z);
                self.set_truth(to, value);
            }
            Inst::Dot { to, left, right } => {
                let (left, right) = (self.vector(left), self.vector(right));
                let value = self.dot(left, right);
                self.set_real(to, value);
            }
            Inst::Cross { to, left, right } => {
                let (left, right) = (self.vector(left), self.vector(right));
                let values = self.cross(left, right);
                self.set_vector(to, values);
            }
            Inst::LengthVec { to, from } => {
                let vector = self.vector(from);
                let square = self.dot(vector, vector);
                let value = self.b.ins().sqrt(square);
                self.set_real(to, value);
            }
            Inst::Normalize { to, from } => {
                let vector = self.vector(from);
                let values = self.by_stub(stubs::normalize as *const () as usize, vector);
                self.set_vector(to, values);
            }
            Inst::Balance { to, from } => {
                let vector = self.vector(from);
                let values = self.balanced(vector);
                self.set_vector(to, values);
            }
            Inst::Wide { operation, width, to, left, right } => {
                // If operands overlap, the components have to be computed in order.
                let apart = |from: Reg, width: u16| from == to || from.0.abs_diff(to.0) >= width;
                let width = u16::from(width);
                match operation {
                    Lanes::Add | Lanes::Subtract | Lanes::Multiply
                        if apart(left, width) && apart(right, width) =>
                    {
                        self.each(to, left, right, operation, width);
                    }
                    Lanes::Scale | Lanes::Divide
                        if apart(left, width)
                            && !(to.0..to.0.saturating_add(width)).contains(&right.0) =>
                    {
                        self.by_real(to, left, right, operation, width);
                    }
                    Lanes::Dot => {
                        let (left, right) = (self.reals(left, width), self.reals(right, width));
                        let sum = self.sum_of_products(left.into_iter().zip(right));
                        self.set_real(to, sum);
                    }
                    _ => self.compute(inst),
                }
            }
            Inst::Matrix { operation, size, to, left, right } => {
                match self.matrix(operation, u16::from(size), left, right) {
                    Some(values) => {
                        for (part, value) in (0..).zip(values) {
                            self.set_real(Reg(to.0.wrapping_add(part)), value);
                        }
                    }
                    None => self.compute(inst),
                }
            }
            _ => return false,
        }
        true
    }

    /// The vector that a stub makes of another.
    fn by_stub(&mut self, stub: usize, vector: [Value; 3]) -> [Value; 3] {
        let (place, flags) = (self.place_of_vector(), MemFlagsData::trusted());
        for (at, part) in (0..).zip(vector) {
            self.b.ins().store(flags, part, place, at * 8);
        }
        let signature = self.signature(&[I64], &[]);
        self.call(stub, signature, &[place]);
        [0, 8, 16].map(|at| self.b.ins().load(F64, flags, place, at))
    }

    /// The vector times a power of two, as [`balance`](crate::rewrite::arithmetic::balance) does: its
    /// largest component tells the power by its exponent. A stub takes over if the power or its
    /// inverse is no normal number.
    fn balanced(&mut self, vector: [Value; 3]) -> [Value; 3] {
        const SIGN: i64 = i64::MIN;
        const EXPONENT: i64 = f64::INFINITY.to_bits() as i64;
        const LEAST: i64 = f64::MIN_POSITIVE.to_bits() as i64;
        let parts = [(); 3].map(|()| self.b.declare_var(F64));
        let bits = vector.map(|part| self.b.ins().bitcast(I64, MemFlagsData::new(), part));
        let [x, y, z] = bits.map(|bits| self.b.ins().band_imm_s(bits, !SIGN));
        let largest = [y, z].into_iter().fold(x, |most, other| {
            let is_more = self.b.ins().icmp(IntCC::UnsignedGreaterThan, other, most);
            self.b.ins().select(is_more, other, most)
        });
        let power = self.b.ins().band_imm_s(largest, EXPONENT);
        let [usual, other, on] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(other);
        let above = self.b.ins().iadd_imm_s(power, -LEAST);
        let most = EXPONENT - 2 * LEAST;
        let is_usual = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, above, most);
        self.b.ins().brif(is_usual, usual, &[], other, &[]);

        self.b.switch_to_block(usual);
        // The exponents of a power and its inverse add up to that of 1, twice.
        let one = self.b.ins().iconst(I64, 2 * 1.0f64.to_bits() as i64);
        let inverse = self.b.ins().isub(one, power);
        let inverse = self.b.ins().bitcast(F64, MemFlagsData::new(), inverse);
        for (var, part) in parts.into_iter().zip(vector) {
            let value = self.b.ins().fmul(part, inverse);
            self.b.def_var(var, value);
        }
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(other);
        let values = self.by_stub(stubs::balance as *const () as usize, vector);
        for (var, value) in parts.into_iter().zip(values) {
            self.b.def_var(var, value);
        }
        self.join(on);
        parts.map(|part| self.b.use_var(part))
    }

    pub(super) fn reals(&mut self, from: Reg, count: u16) -> Vec<Value> {
        (0..count).map(|part| self.real(Reg(from.0.wrapping_add(part)))).collect()
    }

    /// Lets a stub compute with vectors and matrices in the window.
    fn compute(&mut self, inst: &Inst) {
        self.execute_by(stubs::compute as *const () as usize, inst);
    }

    pub(super) fn truth(&mut self, reg: Reg) -> Value {
        let bits = self.whole(reg);
        self.b.ins().icmp_imm_u(IntCC::NotEqual, bits, 0)
    }

    fn copy(&mut self, to: Reg, from: Reg, width: u16) {
        let part = |reg: Reg, part: u16| Reg(reg.0.wrapping_add(part));
        let values: Vec<Value> = (0..width).map(|at| self.whole(part(from, at))).collect();
        for (at, value) in (0..width).zip(values) {
            self.set_whole(part(to, at), value);
        }
    }

    fn set_unless(&mut self, to: Reg, value: Value, overflow: Value) {
        let fits = self.b.ins().icmp_imm_u(IntCC::Equal, overflow, 0);
        self.or_fault(fits);
        self.set_whole(to, value);
    }

    /// The quotient, or the rest, of ints, as [`divide`](crate::rewrite::arithmetic::divide) and
    /// [`modulo`](crate::rewrite::arithmetic::modulo) compute it. The machine divides by what is
    /// not positive.
    fn divide(&mut self, inst: &Inst, gives_rest: bool, to: Reg, [left, right]: [Reg; 2]) {
        let (dividend, divisor) = (self.whole(left), self.whole(right));
        let [usual, other, on] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(other);
        let is_positive = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThan, divisor, 0);
        self.b.ins().brif(is_positive, usual, &[], other, &[]);

        self.b.switch_to_block(usual);
        let rest = self.b.ins().srem(dividend, divisor);
        let is_below = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, rest, 0);
        let value = if gives_rest {
            let above = self.b.ins().iadd(rest, divisor);
            self.b.ins().select(is_below, above, rest)
        } else {
            // Rounded towards minus infinity.
            let quotient = self.b.ins().sdiv(dividend, divisor);
            let lower = self.b.ins().iadd_imm_s(quotient, -1);
            self.b.ins().select(is_below, lower, quotient)
        };
        self.set_whole(to, value);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(other);
        self.step(inst);
        self.join(on);
    }

    fn function(&mut self, stub: extern "C" fn(f64, f64) -> f64, to: Reg, left: Reg, right: Reg) {
        let (left, right) = (self.real(left), self.real(right));
        let value = self.call_real(stub as *const () as usize, &[left, right]);
        self.set_real(to, value);
    }

    fn compare_reals(&mut self, how: FloatCC, to: Reg, left: Reg, right: Reg) {
        let (left, right) = (self.real(left), self.real(right));
        let value = self.b.ins().fcmp(how, left, right);
        self.set_truth(to, value);
    }

    fn by_real(&mut self, to: Reg, left: Reg, right: Reg, operation: Lanes, width: u16) {
        let (left, right) = (self.reals(left, width), self.real(right));
        for (at, part) in (0..).zip(left) {
            let value = match operation {
                Lanes::Divide => self.b.ins().fdiv(part, right),
                _ => self.b.ins().fmul(part, right),
            };
            self.set_real(Reg(to.0.wrapping_add(at)), value);
        }
    }

    fn each(&mut self, to: Reg, left: Reg, right: Reg, operation: Lanes, width: u16) {
        let part = |reg: Reg, part: u16| Reg(reg.0.wrapping_add(part));
        let pairs: Vec<[Value; 2]> =
            (0..width).map(|at| [self.real(part(left, at)), self.real(part(right, at))]).collect();
        for (at, [left, right]) in (0..width).zip(pairs) {
            let value = match operation {
                Lanes::Subtract => self.b.ins().fsub(left, right),
                Lanes::Multiply => self.b.ins().fmul(left, right),
                _ => self.b.ins().fadd(left, right),
            };
            self.set_real(part(to, at), value);
        }
    }
}
