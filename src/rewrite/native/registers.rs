//! Registers as variables: their values, and moving them to and from the window.

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::types::{F64, I64};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Opcode, Type, Value, ValueDef};
use cranelift_frontend::Variable;

use std::mem::offset_of;

use super::context::Context;
use super::facts::Fact;
use super::operands::{Class, Environment, Use};
use super::translate::{Region, Translator};
use crate::rewrite::{Inst, Reg};

impl Translator<'_, '_> {
    pub(super) fn spill_operands(&mut self, inst: &Inst) {
        self.registers(inst, |used| used != Use::Write).into_iter().for_each(|reg| self.spill(reg));
    }

    /// Writes the registers that an instruction only reads to the window.
    pub(super) fn spill_read(&mut self, inst: &Inst) {
        self.registers(inst, |used| used == Use::Read).into_iter().for_each(|reg| self.spill(reg));
    }

    pub(super) fn reload_written(&mut self, inst: &Inst) {
        self.registers(inst, |used| used != Use::Read).into_iter().for_each(|reg| self.reload(reg));
    }

    /// The registers that an instruction uses in some ways.
    fn registers(&self, inst: &Inst, is_one: impl Fn(Use) -> bool) -> Vec<Reg> {
        let mut all = Vec::new();
        self.unit.environment.each_operand(inst, &mut |operand| {
            if is_one(operand.used) {
                all.extend(operand.registers());
            }
        });
        all
    }

    /// Writes a register to the window.
    pub(super) fn spill(&mut self, reg: Reg) {
        let window = self.field(offset_of!(Context, window));
        let variable = self.variable(reg);
        let value = self.b.use_var(variable);
        self.store(Region::Window, value, window, usize::from(reg.0) * 8);
    }

    /// Reads a register from the window.
    pub(super) fn reload(&mut self, reg: Reg) {
        let window = self.field(offset_of!(Context, window));
        let ty = if self.is_real(reg) { F64 } else { I64 };
        let value = self.load(ty, Region::Window, window, usize::from(reg.0) * 8);
        let variable = self.variable(reg);
        self.b.def_var(variable, value);
    }

    pub(super) fn is_real(&self, reg: Reg) -> bool {
        self.is_real.get(usize::from(reg.0)) == Some(&true)
    }

    pub(super) fn variable(&mut self, reg: Reg) -> Variable {
        let at = usize::from(reg.0);
        if self.variables.len() <= at {
            self.variables.resize(at + 1, None);
        }
        match self.variables[at] {
            Some(variable) => variable,
            None => {
                let ty = if self.is_real(reg) { F64 } else { I64 };
                let variable = self.b.declare_var(ty);
                *self.variables[at].insert(variable)
            }
        }
    }

    /// The bits of a register.
    pub(super) fn whole(&mut self, reg: Reg) -> Value {
        let variable = self.variable(reg);
        let value = self.b.use_var(variable);
        self.cast(I64, value)
    }

    pub(super) fn real(&mut self, reg: Reg) -> Value {
        let variable = self.variable(reg);
        let value = self.b.use_var(variable);
        self.cast(F64, value)
    }

    pub(super) fn set_whole(&mut self, reg: Reg, value: Value) {
        let ty = if self.is_real(reg) { F64 } else { I64 };
        let value = self.cast(ty, value);
        let variable = self.variable(reg);
        self.b.def_var(variable, value);
    }

    pub(super) fn set_real(&mut self, reg: Reg, value: Value) {
        self.set_whole(reg, value);
    }

    /// The bits of a value as a value of a type. A cast undoes a cast: Cranelift would move the
    /// bits there and back.
    fn cast(&mut self, ty: Type, value: Value) -> Value {
        let dfg = &self.b.func.dfg;
        if dfg.value_type(value) == ty {
            return value;
        }
        if let ValueDef::Result(inst, _) = dfg.value_def(dfg.resolve_aliases(value))
            && dfg.insts[inst].opcode() == Opcode::Bitcast
            && let [before] = *dfg.inst_args(inst)
            && dfg.value_type(before) == ty
        {
            return before;
        }
        self.b.ins().bitcast(ty, MemFlagsData::new(), value)
    }

    /// Sets a bool from the result of a comparison.
    pub(super) fn set_truth(&mut self, reg: Reg, value: Value) {
        let value = self.b.ins().uextend(I64, value);
        self.set_whole(reg, value);
    }

    pub(super) fn vector(&mut self, reg: Reg) -> [Value; 3] {
        [0, 1, 2].map(|part| self.real(Reg(reg.0.wrapping_add(part))))
    }

    pub(super) fn set_vector(&mut self, reg: Reg, values: [Value; 3]) {
        for (part, value) in (0..).zip(values) {
            self.set_real(Reg(reg.0.wrapping_add(part)), value);
        }
    }

    /// The number of an element.
    pub(super) fn id(&mut self, reg: Reg) -> Value {
        let bits = self.whole(reg);
        if self.fact(reg).is_clean() { bits } else { self.b.ins().band_imm_u(bits, 0xffff_ffff) }
    }

    /// The facts about the element in a register.
    pub(super) fn fact(&self, reg: Reg) -> Fact {
        self.known.facts.as_ref().map_or_else(Fact::default, |facts| facts.of(reg))
    }

    pub(super) fn compare(&mut self, how: IntCC, left: Reg, right: Reg) -> Value {
        let (left, right) = (self.whole(left), self.whole(right));
        self.b.ins().icmp(how, left, right)
    }

    /// Whether all components of a vector are finite.
    pub(super) fn is_finite(&mut self, vector: Reg) -> Value {
        let infinity = self.b.ins().f64const(f64::INFINITY);
        let [x, y, z] = self.vector(vector).map(|part| {
            let size = self.b.ins().fabs(part);
            self.b.ins().fcmp(FloatCC::LessThan, size, infinity)
        });
        let xy = self.b.ins().band(x, y);
        self.b.ins().band(xy, z)
    }
}

/// By number, whether a register holds only reals.
pub(super) fn reals(insts: &[Inst], registers: usize, environment: &Environment) -> Vec<bool> {
    let mut votes = vec![(false, false); registers];
    for inst in insts {
        environment.each_operand(inst, &mut |operand| {
            for reg in operand.registers() {
                if let Some((real, whole)) = votes.get_mut(usize::from(reg.0)) {
                    *real |= operand.class == Class::Real;
                    *whole |= operand.class == Class::Whole;
                }
            }
        });
    }
    votes.into_iter().map(|(real, whole)| real && !whole).collect()
}
