//! Register code as the code of a function of Cranelift's.
//!
//! A register is a variable: of 64 bits, or a real where it holds nothing else. What an instruction
//! does in a few steps is spelled here; where it turns out to trap, and for all others, the machine
//! takes the instruction, with the registers that it uses in the window of the call.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::types::{F64, I8, I32, I64};
use cranelift_codegen::ir::{
    AbiParam, AliasRegion, AliasRegionData, Block, InstBuilder, MemFlagsData, SigRef, Signature,
    StackSlotData, StackSlotKind, Type, Value,
};
use cranelift_codegen::isa::CallConv;
use cranelift_frontend::{FunctionBuilder, Variable};

use super::context::{Context, noted};
use super::facts::{Fact, KnownAt, Walk, ends, targets};
use super::liveness::Liveness;
use super::operands::{Class, Operand, Surroundings, Use};
use super::{Variant, stubs};
use crate::rewrite::engine::Way;
use crate::rewrite::{Code, Inst, Label, Phase, Refusal, Reg};

/// The answers of native code.
pub(super) const APPLIED: i64 = 0;
pub(super) const REFUSED: i64 = 1;
pub(super) const TRAPPED: i64 = 2;

/// A code and what it means by its numbers.
#[derive(Clone, Copy)]
pub(super) struct Text<'a> {
    pub(super) code: &'a Code,
    pub(super) refusals: &'a [Refusal],
    pub(super) way: Way,
    pub(super) surroundings: Surroundings<'a>,
}

/// The parts of memory that never overlap.
#[derive(Clone, Copy, Debug)]
pub(super) enum Region {
    Context,
    Window,
    Next,
    Prev,
    Twin,
    Vertex,
    Edge,
    Face,
    OfVertex,
    OfEdge,
    OfFace,
    Hole,
    Position,
    Holes,
    Turns,
    Columns,
    Values,
}

pub(super) struct Translator<'a, 'f> {
    pub(super) b: FunctionBuilder<'f>,
    pub(super) text: Text<'a>,
    variant: Variant,
    conv: CallConv,
    context: Value,
    variables: Vec<Option<Variable>>,
    is_real: Vec<bool>,
    blocks: Vec<Option<Block>>,
    known: Walk,
    /// The instruction that is spelled.
    pub(super) at: usize,
    /// The number of those behind it that have been spelled with it.
    pub(super) skip: usize,
    /// Where it traps, if it may.
    fault: Option<Block>,
    /// All such blocks, each with its instruction.
    faults: Vec<(Block, usize)>,
    /// Where native code is left by a trap.
    leave: Block,
    /// By drain, the registers that its paths may read.
    live_at_drains: Vec<(usize, Vec<Reg>)>,
}

impl<'a, 'f> Translator<'a, 'f> {
    /// Spells a whole code.
    pub(super) fn translate(
        mut b: FunctionBuilder<'f>,
        text: Text<'a>,
        variant: Variant,
        conv: CallConv,
    ) -> FunctionBuilder<'f> {
        let insts = &text.code.insts;
        let registers = usize::from(text.code.registers);
        let entry = b.create_block();
        b.append_block_params_for_function_params(entry);
        b.switch_to_block(entry);
        let context = b.block_params(entry)[0];
        let is_target = targets(insts);
        let blocks = is_target.iter().map(|&is| is.then(|| b.create_block())).collect();
        let leave = b.create_block();
        b.set_cold_block(leave);
        let mut liveness = Liveness::of(insts, registers, &text.surroundings);
        let drains = insts.iter().enumerate();
        let drains = drains.filter(|(_, inst)| matches!(inst, Inst::DrainStale { .. }));
        let drains: Vec<usize> = drains.map(|(at, _)| at).collect();
        let live_at_drains = drains.into_iter().map(|at| (at, liveness.behind(at))).collect();
        let mut this = Self {
            b,
            text,
            variant,
            conv,
            context,
            variables: vec![None; registers],
            is_real: reals(insts, registers, &text.surroundings),
            blocks,
            known: Walk::new(registers),
            at: 0,
            skip: 0,
            fault: None,
            faults: Vec::new(),
            leave,
            live_at_drains,
        };
        // A script leaves what its registers hold in the window, changed or not.
        let first = match text.way {
            Way::Script => (0..text.code.registers).map(Reg).collect(),
            _ => liveness.at_start(),
        };
        first.into_iter().for_each(|reg| this.reload(reg));
        let known_at = KnownAt::of(insts, registers, &text.surroundings);
        let mut reached = true;
        for (at, inst) in insts.iter().enumerate() {
            if let Some(block) = this.blocks[at] {
                if reached {
                    this.b.ins().jump(block, &[]);
                }
                this.b.switch_to_block(block);
                this.known.enter(&known_at, at);
                reached = true;
            }
            if !reached {
                continue;
            }
            if this.skip > 0 {
                this.skip -= 1;
                this.known.pass(inst, &text.surroundings);
                continue;
            }
            (this.at, this.fault) = (at, None);
            reached = this.inst(inst) && !ends(inst);
            this.known.pass(inst, &text.surroundings);
        }
        if let Some(block) = this.blocks[insts.len()] {
            if reached {
                this.b.ins().jump(block, &[]);
            }
            this.b.switch_to_block(block);
            reached = true;
        }
        if reached {
            this.end(None);
        }
        this.write_faults();
        this.b.seal_all_blocks();
        this.b
    }

    /// The blocks of what traps: the machine takes the instruction and says why.
    fn write_faults(&mut self) {
        for (block, at) in std::mem::take(&mut self.faults) {
            self.b.switch_to_block(block);
            let inst = self.text.code.insts[at];
            self.spill_operands(&inst);
            let number = self.b.ins().iconst(I64, at as i64);
            let signature = self.signature(&[I64, I64], &[]);
            let context = self.context;
            self.call(stubs::fault as *const () as usize, signature, &[context, number]);
            let leave = self.leave;
            self.b.ins().jump(leave, &[]);
        }
        let leave = self.leave;
        self.b.switch_to_block(leave);
        let answer = self.b.ins().iconst(I64, TRAPPED);
        self.b.ins().return_(&[answer]);
    }

    /// Spells an instruction; false if nothing follows it.
    fn inst(&mut self, inst: &Inst) -> bool {
        if inst.is_observed_write() {
            match self.variant {
                Variant::Plain => {}
                Variant::Careful => {
                    self.steps();
                    return true;
                }
                Variant::Dry => {
                    self.end(None);
                    return false;
                }
            }
        }
        match *inst {
            Inst::Return { result } => {
                let result = if self.variant == Variant::Dry { None } else { result };
                self.end(result);
                return false;
            }
            Inst::Give { from, width } => {
                self.spill_operands(inst);
                let place = offset_of!(Context, given) as i32;
                let given = i64::from(from.0) | i64::from(width) << 16;
                let given = self.b.ins().iconst(I32, given);
                let flags = self.flags(Region::Context);
                self.b.ins().store(flags, given, self.context, place);
                self.end(None);
            }
            Inst::Call { .. } => {
                self.spill_operands(inst);
                let number = self.b.ins().iconst(I64, self.at as i64);
                let done = self.call_stub(stubs::call as *const () as usize, &[number]);
                let failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, done, 0);
                self.leave_if(failed);
                self.reload_written(inst);
            }
            Inst::Refuse => {
                let answer = self.b.ins().iconst(I64, REFUSED);
                self.b.ins().return_(&[answer]);
            }
            Inst::Jump { to } => {
                let to = self.block(to);
                self.b.ins().jump(to, &[]);
            }
            Inst::JumpIf { condition, to } => {
                let condition = self.whole(condition);
                self.jump_if(condition, to);
            }
            Inst::JumpUnless { condition, to } => {
                let condition = self.whole(condition);
                let condition = self.b.ins().icmp_imm_u(IntCC::Equal, condition, 0);
                self.jump_if(condition, to);
            }
            Inst::JumpEqual { left, right, to } => {
                let condition = self.compare(IntCC::Equal, left, right);
                self.jump_if(condition, to);
            }
            Inst::JumpUnequal { left, right, to } => {
                let condition = self.compare(IntCC::NotEqual, left, right);
                self.jump_if(condition, to);
            }
            Inst::ExpectEqual { left, right, refusal, otherwise } => {
                let condition = self.compare(IntCC::Equal, left, right);
                self.expect(condition, refusal, otherwise);
            }
            Inst::ExpectDistinct { left, right, refusal, otherwise } => {
                let condition = self.compare(IntCC::NotEqual, left, right);
                self.expect(condition, refusal, otherwise);
            }
            Inst::Expect { condition, refusal, otherwise } => {
                let condition = self.whole(condition);
                self.expect(condition, refusal, otherwise);
            }
            Inst::ExpectFinite { vector, refusal, otherwise } => {
                let condition = self.is_finite(vector);
                self.expect(condition, refusal, otherwise);
            }
            _ => {
                if !self.value(inst) && !self.access(inst) {
                    self.step(inst);
                }
            }
        }
        true
    }

    pub(super) fn block(&mut self, to: Label) -> Block {
        let at = (to.0 as usize).min(self.text.code.insts.len());
        // Every target has one.
        self.blocks[at].unwrap_or(self.leave)
    }

    fn jump_if(&mut self, condition: Value, to: Label) {
        let (to, on) = (self.block(to), self.b.create_block());
        self.b.ins().brif(condition, to, &[], on, &[]);
        self.b.switch_to_block(on);
    }

    /// Goes on if a condition holds, else notes the refusal and jumps.
    pub(super) fn expect(&mut self, condition: Value, refusal: u16, otherwise: Label) {
        let (on, off) = (self.b.create_block(), self.b.create_block());
        self.b.ins().brif(condition, on, &[], off, &[]);
        self.b.switch_to_block(off);
        let reason = self.text.refusals.get(usize::from(refusal));
        let phase = reason.map_or(Phase::Match, |reason| reason.phase);
        let now = i64::from(noted(Some((phase, refusal))));
        let now = self.b.ins().iconst(I32, now);
        let place = offset_of!(Context, noted) as i32;
        let flags = self.flags(Region::Context);
        let before = self.b.ins().load(I32, flags, self.context, place);
        // One of a later phase is greater, whatever the reason.
        let whole_phase = self.b.ins().bor_imm_u(before, 0xffff);
        let is_later = self.b.ins().icmp(IntCC::UnsignedLessThan, whole_phase, now);
        let counts = self.b.ins().select(is_later, now, before);
        self.b.ins().store(flags, counts, self.context, place);
        let otherwise = self.block(otherwise);
        self.b.ins().jump(otherwise, &[]);
        self.b.switch_to_block(on);
    }

    /// Ends the code.
    fn end(&mut self, result: Option<Reg>) {
        if let Some(result) = result {
            let element = self.id(result);
            let flags = self.flags(Region::Context);
            let place = offset_of!(Context, result) as i32;
            self.b.ins().store(flags, element, self.context, place);
        }
        if self.text.way == Way::Script {
            let used = (0..).zip(&self.variables).filter(|(_, variable)| variable.is_some());
            let used: Vec<Reg> = used.map(|(at, _)| Reg(at)).collect();
            used.into_iter().for_each(|reg| self.spill(reg));
        }
        let answer = self.b.ins().iconst(I64, APPLIED);
        self.b.ins().return_(&[answer]);
    }

    /// Goes on if a condition holds; else the machine takes the instruction, which traps.
    pub(super) fn or_fault(&mut self, condition: Value) {
        let fault = match self.fault {
            Some(fault) => fault,
            None => {
                let fault = self.b.create_block();
                self.b.set_cold_block(fault);
                self.faults.push((fault, self.at));
                *self.fault.insert(fault)
            }
        };
        let on = self.b.create_block();
        self.b.ins().brif(condition, on, &[], fault, &[]);
        self.b.switch_to_block(on);
    }

    /// Lets the machine take the instruction.
    pub(super) fn step(&mut self, inst: &Inst) {
        self.spill_operands(inst);
        if let Inst::DrainStale { .. } = inst {
            let all = self.live_at_drains.iter().find(|(at, _)| *at == self.at);
            let all = all.map_or_else(Vec::new, |(_, all)| all.clone());
            all.into_iter().for_each(|reg| self.spill(reg));
        }
        let number = self.b.ins().iconst(I64, (self.at | 1 << 32) as i64);
        let on = self.call_stub(stubs::step as *const () as usize, &[number]);
        let failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, on, 0);
        self.leave_if(failed);
        self.reload_written(inst);
        let mut jump = *inst;
        if let Some(&mut to) = jump.target_mut() {
            let elsewhere = self.b.ins().icmp_imm_s(IntCC::NotEqual, on, self.at as i64 + 1);
            self.jump_if(elsewhere, to);
        } else if ends(inst) {
            // What ends the code by a trap has been left before.
            let leave = self.leave;
            self.b.ins().jump(leave, &[]);
        }
    }

    /// Lets the machine take this write and those that follow it at once.
    fn steps(&mut self) {
        let (first, code) = (self.at, self.text.code);
        let end = self.end_of_run(Inst::is_observed_write);
        let all = &code.insts[first..end];
        all.iter().for_each(|inst| self.spill_operands(inst));
        let span = self.b.ins().iconst(I64, (first | (end - first) << 32) as i64);
        let on = self.call_stub(stubs::step as *const () as usize, &[span]);
        let failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, on, 0);
        self.leave_if(failed);
        all.iter().for_each(|inst| self.reload_written(inst));
        self.skip = end - first - 1;
    }

    /// The end of the instructions of a sort from this one on, none of which but the first is
    /// jumped to.
    pub(super) fn end_of_run(&self, is_one: impl Fn(&Inst) -> bool) -> usize {
        let first = self.at;
        let insts = self.text.code.insts.iter().enumerate().skip(first);
        let mut run = insts
            .take_while(|&(at, inst)| is_one(inst) && (at == first || self.blocks[at].is_none()));
        run.by_ref().last().map_or(first, |(at, _)| at + 1)
    }

    pub(super) fn leave_if(&mut self, condition: Value) {
        let (leave, on) = (self.leave, self.b.create_block());
        self.b.ins().brif(condition, leave, &[], on, &[]);
        self.b.switch_to_block(on);
    }

    pub(super) fn spill_operands(&mut self, inst: &Inst) {
        let mut read: Vec<Operand> = Vec::new();
        self.text.surroundings.each_operand(inst, |operand| {
            if operand.used != Use::Write {
                read.push(operand);
            }
        });
        read.into_iter().flat_map(Operand::registers).for_each(|reg| self.spill(reg));
    }

    pub(super) fn reload_written(&mut self, inst: &Inst) {
        let mut written = Vec::new();
        self.text.surroundings.each_operand(inst, |operand| {
            if operand.used != Use::Read {
                written.extend(operand.registers());
            }
        });
        written.into_iter().for_each(|reg| self.reload(reg));
    }

    /// Writes a register to the window.
    fn spill(&mut self, reg: Reg) {
        let window = self.field(offset_of!(Context, window));
        let flags = self.flags(Region::Window);
        let variable = self.variable(reg);
        let value = self.b.use_var(variable);
        self.b.ins().store(flags, value, window, i32::from(reg.0) * 8);
    }

    /// Reads a register from the window.
    fn reload(&mut self, reg: Reg) {
        let window = self.field(offset_of!(Context, window));
        let flags = self.flags(Region::Window);
        let ty = if self.is_real(reg) { F64 } else { I64 };
        let value = self.b.ins().load(ty, flags, window, i32::from(reg.0) * 8);
        let variable = self.variable(reg);
        self.b.def_var(variable, value);
    }
}

/// Registers.
impl Translator<'_, '_> {
    fn is_real(&self, reg: Reg) -> bool {
        self.is_real.get(usize::from(reg.0)) == Some(&true)
    }

    fn variable(&mut self, reg: Reg) -> Variable {
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
        match self.is_real(reg) {
            true => self.b.ins().bitcast(I64, MemFlagsData::new(), value),
            false => value,
        }
    }

    pub(super) fn real(&mut self, reg: Reg) -> Value {
        let variable = self.variable(reg);
        let value = self.b.use_var(variable);
        match self.is_real(reg) {
            true => value,
            false => self.b.ins().bitcast(F64, MemFlagsData::new(), value),
        }
    }

    pub(super) fn set_whole(&mut self, reg: Reg, value: Value) {
        let value = match self.is_real(reg) {
            true => self.b.ins().bitcast(F64, MemFlagsData::new(), value),
            false => value,
        };
        let variable = self.variable(reg);
        self.b.def_var(variable, value);
    }

    pub(super) fn set_real(&mut self, reg: Reg, value: Value) {
        let value = match self.is_real(reg) {
            true => value,
            false => self.b.ins().bitcast(I64, MemFlagsData::new(), value),
        };
        let variable = self.variable(reg);
        self.b.def_var(variable, value);
    }

    /// A bool, from what Cranelift compares.
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
        match self.fact(reg).is_clean() {
            true => bits,
            false => self.b.ins().band_imm_u(bits, 0xffff_ffff),
        }
    }

    /// What is known of the element in a register.
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

/// Memory and calls.
impl Translator<'_, '_> {
    pub(super) fn flags(&mut self, region: Region) -> MemFlagsData {
        let data = AliasRegionData { user_id: region as u32, description: "".into() };
        let region: AliasRegion = self.b.func.dfg.alias_regions.insert(data);
        MemFlagsData::trusted().with_alias_region(Some(region))
    }

    /// A field of the context.
    pub(super) fn field(&mut self, offset: usize) -> Value {
        let flags = self.flags(Region::Context);
        self.b.ins().load(I64, flags, self.context, offset as i32)
    }

    pub(super) fn signature(&mut self, params: &[Type], returns: &[Type]) -> SigRef {
        let mut signature = Signature::new(self.conv);
        signature.params.extend(params.iter().map(|&ty| AbiParam::new(ty)));
        signature.returns.extend(returns.iter().map(|&ty| AbiParam::new(ty)));
        self.b.import_signature(signature)
    }

    pub(super) fn call(&mut self, stub: usize, signature: SigRef, args: &[Value]) -> Vec<Value> {
        let stub = self.b.ins().iconst(I64, stub as i64);
        let call = self.b.ins().call_indirect(signature, stub, args);
        self.b.inst_results(call).to_vec()
    }

    /// Calls a stub of the context and of whole numbers, which answers with one.
    pub(super) fn call_stub(&mut self, stub: usize, args: &[Value]) -> Value {
        let params = vec![I64; args.len() + 1];
        let signature = self.signature(&params, &[I64]);
        let mut all = vec![self.context];
        all.extend_from_slice(args);
        self.call(stub, signature, &all)[0]
    }

    /// Calls a function of reals.
    pub(super) fn call_real(&mut self, stub: usize, args: &[Value]) -> Value {
        let params = vec![F64; args.len()];
        let signature = self.signature(&params, &[F64]);
        self.call(stub, signature, args)[0]
    }

    /// Three reals in the frame: their address.
    pub(super) fn place_of_vector(&mut self) -> Value {
        let slot = StackSlotData::new(StackSlotKind::ExplicitSlot, 24, 3);
        let slot = self.b.create_sized_stack_slot(slot);
        self.b.ins().stack_addr(I64, slot, 0)
    }

    pub(super) fn byte(&mut self, flags: MemFlagsData, address: Value, offset: usize) -> Value {
        let byte = self.b.ins().load(I8, flags, address, offset as i32);
        self.b.ins().uextend(I64, byte)
    }
}

/// By number whether a register holds nothing but reals.
fn reals(insts: &[Inst], registers: usize, surroundings: &Surroundings) -> Vec<bool> {
    let mut votes = vec![(false, false); registers];
    for inst in insts {
        surroundings.each_operand(inst, |operand| {
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
