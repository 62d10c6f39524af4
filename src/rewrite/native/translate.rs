//! Translation of register code to a Cranelift function.
//!
//! A register is a variable: a real if it holds only reals, else 64 bits. Instructions that take a
//! few steps are translated here; if one turns out to trap, and for all others, the machine
//! executes the instruction, with the registers that it uses in the window of the call.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{Block, InstBuilder, Value};
use cranelift_codegen::isa::CallConv;
use cranelift_frontend::{FunctionBuilder, Switch, Variable};

use super::Variant;
use super::compile::entries;
use super::context::{Context, noted};
use super::facts::{Facts, KnownAt, Walk, ends, jumps, targets};
use super::guards::{Guard, Set};
use super::inline::{Continuation, Inlined};
use super::liveness::Liveness;
use super::operands::{Environment, Use};
use super::registers::reals;
use crate::rewrite::engine::CodeKind;
use crate::rewrite::{Code, Inst, Label, Phase, Refusal, Reg};

/// The answers of native code.
pub(super) const APPLIED: i64 = 0;
pub(super) const REFUSED: i64 = 1;
pub(super) const TRAPPED: i64 = 2;

/// A unit of compilation: a code and the items that it refers to by number.
#[derive(Clone, Copy)]
pub(super) struct Unit<'a> {
    pub(super) code: &'a Code,
    pub(super) refusals: &'a [Refusal],
    pub(super) kind: CodeKind,
    /// The number of the function.
    pub(super) function: Option<u16>,
    pub(super) environment: Environment<'a>,
}

/// The parts of memory, which never overlap.
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
    FaceStates,
    Position,
    Holes,
    Progress,
    Holding,
    Columns,
    Values,
    Lists,
    Slots,
    Entries,
    Counts,
    Neighbors,
}

pub(super) struct Translator<'a, 'f> {
    pub(super) b: FunctionBuilder<'f>,
    pub(super) unit: Unit<'a>,
    pub(super) variant: Variant,
    pub(super) conv: CallConv,
    pub(super) context: Value,
    pub(super) variables: Vec<Option<Variable>>,
    pub(super) is_real: Vec<bool>,
    pub(super) blocks: Vec<Option<Block>>,
    pub(super) known: Walk,
    /// Whether tables may move while the code runs.
    pub(super) may_add: bool,
    /// The current instruction.
    pub(super) at: usize,
    /// The number of the next instructions that have been translated with it.
    pub(super) skip: usize,
    /// The block to which it jumps if it traps, if it may trap.
    pub(super) fault: Option<Block>,
    /// All such blocks, each with its instruction and the values to restore.
    pub(super) faults: Vec<(Block, usize, Vec<Set>)>,
    /// The parts of the code that look ahead.
    pub(super) guards: Vec<Guard>,
    /// The values that have been set in the current guard.
    pub(super) set: Vec<Set>,
    /// The block that leaves native code by a trap.
    pub(super) leave: Block,
    /// Whether the values of the registers are left in the window at the end.
    pub(super) keeps_window: bool,
    /// By drain, the registers that its paths may read.
    pub(super) live_at_drains: Vec<(usize, Vec<Reg>)>,
    /// The place to which the current function returns, if it is inlined.
    pub(super) continuation: Option<Continuation>,
    pub(super) inlined: Inlined,
}

impl<'a, 'f> Translator<'a, 'f> {
    /// Translates a whole code.
    pub(super) fn translate(
        mut b: FunctionBuilder<'f>,
        unit: Unit<'a>,
        variant: Variant,
        conv: CallConv,
    ) -> FunctionBuilder<'f> {
        let insts = &unit.code.insts;
        let registers = usize::from(unit.code.registers);
        let entry = b.create_block();
        b.append_block_params_for_function_params(entry);
        b.switch_to_block(entry);
        let (context, start) = (b.block_params(entry)[0], b.block_params(entry)[1]);
        let is_target = targets(unit.code);
        let blocks = is_target.iter().map(|&is| is.then(|| b.create_block())).collect();
        let leave = b.create_block();
        b.set_cold_block(leave);
        let mut liveness = Liveness::of(unit.code, registers, &unit.environment);
        let drains = insts.iter().enumerate();
        let drains = drains.filter(|(_, inst)| matches!(inst, Inst::DrainStale { .. }));
        let drains: Vec<usize> = drains.map(|(at, _)| at).collect();
        let live_at_drains = drains.into_iter().map(|at| (at, liveness.behind(at))).collect();
        let loops = insts.iter().any(|inst| matches!(inst, Inst::Iteration { .. }));
        let mut this = Self {
            b,
            unit,
            variant,
            conv,
            context,
            variables: vec![None; registers],
            is_real: reals(insts, registers, &unit.environment),
            blocks,
            known: Walk::new(registers),
            may_add: unit.environment.may_add(unit.code),
            at: 0,
            skip: 0,
            fault: None,
            faults: Vec::new(),
            guards: Guard::all(unit.code),
            set: Vec::new(),
            leave,
            keeps_window: unit.kind == CodeKind::Script && !loops,
            live_at_drains,
            continuation: None,
            inlined: Inlined::default(),
        };
        let known_at = KnownAt::of(unit.code, &Facts::none(registers), &unit.environment);
        this.constants();
        this.begin(start, &liveness);
        this.rest(&known_at);
        this.faults();
        this.b.switch_to_block(this.leave);
        let answer = this.b.ins().iconst(I64, TRAPPED);
        this.b.ins().return_(&[answer]);
        this.b.seal_all_blocks();
        this.b
    }

    /// Translates the code of a function whose registers hold its arguments.
    pub(super) fn body(&mut self, known_at: &KnownAt) {
        self.constants();
        self.rest(known_at);
    }

    /// Translates the constants of the code, which hold at all entries.
    fn constants(&mut self) {
        let Unit { code, environment, .. } = self.unit;
        for inst in &code.insts[..code.constants.min(code.insts.len())] {
            self.value(inst);
            self.known.pass(inst, &environment);
        }
    }

    /// Translates the code after the constants.
    fn rest(&mut self, known_at: &KnownAt) {
        let Unit { code, environment, .. } = self.unit;
        let insts = &code.insts;
        let mut last_jump = vec![0; insts.len() + 1];
        for (from, to) in jumps(code) {
            let last = &mut last_jump[to.min(insts.len())];
            *last = from.max(*last);
        }
        let mut reached = true;
        for (at, inst) in insts.iter().enumerate().skip(code.constants.min(insts.len())) {
            if let Some(block) = self.blocks[at] {
                if reached {
                    self.b.ins().jump(block, &[]);
                }
                if last_jump[at] < at {
                    self.go_on(block)
                } else {
                    self.b.switch_to_block(block)
                }
                self.known.enter(known_at, at);
                reached = true;
            }
            if !reached {
                continue;
            }
            if self.skip > 0 {
                self.skip -= 1;
                self.known.pass(inst, &environment);
                continue;
            }
            (self.at, self.fault) = (at, None);
            if !self.guards.iter().any(|guard| guard.contains(at)) {
                self.set.clear();
            }
            reached = self.inst(inst) && !ends(inst);
            self.known.pass(inst, &environment);
        }
        if let Some(block) = self.blocks[insts.len()] {
            if reached {
                self.b.ins().jump(block, &[]);
            }
            self.go_on(block);
            reached = true;
        }
        if reached {
            self.end(None);
        }
    }

    /// Begins at the entry that `start` tells: at the beginning, or at the iteration of a loop,
    /// with the registers loaded from the window.
    fn begin(&mut self, start: Value, liveness: &Liveness<'_>) {
        // A script leaves all its registers in the window, changed or not.
        let first = if self.keeps_window { liveness.all() } else { liveness.at(0) };
        let entries = entries(self.unit.code);
        if !entries.is_empty() {
            let (begin, elsewhere) = (self.b.create_block(), self.b.create_block());
            self.b.set_cold_block(elsewhere);
            self.b.ins().brif(start, elsewhere, &[], begin, &[]);
            self.b.switch_to_block(elsewhere);
            let mut switch = Switch::new();
            let blocks: Vec<Block> = entries.iter().map(|_| self.b.create_block()).collect();
            for (number, block) in (1..).zip(&blocks) {
                self.b.set_cold_block(*block);
                switch.set_entry(number, *block);
            }
            switch.emit(&mut self.b, start, begin);
            for (at, block) in entries.into_iter().zip(blocks) {
                self.b.switch_to_block(block);
                liveness.at(at as usize).into_iter().for_each(|reg| self.reload(reg));
                let to = self.block(Label(at));
                self.b.ins().jump(to, &[]);
            }
            self.b.switch_to_block(begin);
        }
        self.begin_lists();
        first.into_iter().for_each(|reg| self.reload(reg));
    }

    /// Translates an instruction; false if the code does not continue after it.
    fn inst(&mut self, inst: &Inst) -> bool {
        if self.variant == Variant::Dry && inst.is_observed_write() {
            self.end(None);
            return false;
        }
        match *inst {
            Inst::Return { result } => {
                let result = if self.variant == Variant::Dry { None } else { result };
                self.end(result);
                return false;
            }
            Inst::ReturnValue { from, width } => {
                if !self.give_back(from) {
                    self.give(from, width);
                }
                self.end(None);
            }
            Inst::Call { function, args, to, holds } => {
                self.call_function(inst, function, [args, to], holds);
            }
            Inst::Spread { part, .. } => {
                let Unit { code, environment, .. } = self.unit;
                let Some(Some(part)) = code.parts.get(usize::from(part)) else { return true };
                // A part reads the registers that it needs from the window.
                let mut read = vec![false; self.variables.len()];
                for inst in &part.code.insts {
                    environment.each_operand(inst, &mut |operand| {
                        for reg in operand.registers().filter(|_| operand.used != Use::Write) {
                            if let Some(read) = read.get_mut(usize::from(reg.0)) {
                                *read = true;
                            }
                        }
                    });
                }
                let read = (0..).zip(read).filter(|&(_, read)| read).map(|(at, _)| Reg(at));
                let known = |reg: &Reg| self.variables[usize::from(reg.0)].is_some();
                let read: Vec<Reg> = read.filter(known).collect();
                read.into_iter().for_each(|reg| self.spill(reg));
                self.step(inst);
            }
            Inst::Apply { op, args, applied, result } => {
                self.apply(inst, op, args, [applied, result]);
            }
            Inst::Try { op, args, to, why: false } => self.ask_op(inst, op, args, to),
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
                let is_spelled = self.value(inst)
                    || self.neighbors(inst)
                    || self.access(inst)
                    || self.write(inst)
                    || self.list(inst)
                    || self.family(inst)
                    || self.guard(inst);
                if !is_spelled {
                    self.steps(inst);
                }
            }
        }
        true
    }

    pub(super) fn block(&mut self, to: Label) -> Block {
        let at = (to.0 as usize).min(self.unit.code.insts.len());
        // Every target of a jump has a block.
        self.blocks[at].unwrap_or(self.leave)
    }

    /// Goes on in a block to which no more jumps will follow. So it is sealed, and the values of
    /// variables that all jumps agree about are known in it.
    pub(super) fn go_on(&mut self, block: Block) {
        self.b.seal_block(block);
        self.b.switch_to_block(block);
    }

    /// Jumps to a block that other jumps lead to, and goes on there.
    pub(super) fn join(&mut self, on: Block) {
        self.b.ins().jump(on, &[]);
        self.go_on(on);
    }

    pub(super) fn jump_if(&mut self, condition: Value, to: Label) {
        let (to, on) = (self.block(to), self.b.create_block());
        self.b.ins().brif(condition, to, &[], on, &[]);
        self.go_on(on);
    }

    /// Continues if a condition holds, else notes the refusal and jumps.
    pub(super) fn expect(&mut self, condition: Value, refusal: u16, otherwise: Label) {
        let (on, off) = (self.b.create_block(), self.b.create_block());
        self.b.ins().brif(condition, on, &[], off, &[]);
        self.b.switch_to_block(off);
        let reason = self.unit.refusals.get(usize::from(refusal));
        let phase = reason.map_or(Phase::Match, |reason| reason.phase);
        let now = i64::from(noted(Some((phase, refusal))));
        let now = self.b.ins().iconst(I32, now);
        let place = offset_of!(Context, noted);
        let before = self.load(I32, Region::Context, self.context, place);
        // A refusal of a later phase is greater, whatever the reason.
        let whole_phase = self.b.ins().bor_imm_u(before, 0xffff);
        let is_later = self.b.ins().icmp(IntCC::UnsignedLessThan, whole_phase, now);
        let counts = self.b.ins().select(is_later, now, before);
        self.store(Region::Context, counts, self.context, place);
        let otherwise = self.block(otherwise);
        self.b.ins().jump(otherwise, &[]);
        self.go_on(on);
    }

    /// Ends the code.
    fn end(&mut self, result: Option<Reg>) {
        if self.go_back() {
            return;
        }
        if let Some(result) = result {
            let element = self.id(result);
            self.store(Region::Context, element, self.context, offset_of!(Context, result));
        }
        if self.keeps_window {
            let used = (0..).zip(&self.variables).filter(|(_, variable)| variable.is_some());
            let used: Vec<Reg> = used.map(|(at, _)| Reg(at)).collect();
            used.into_iter().for_each(|reg| self.spill(reg));
        }
        let answer = self.b.ins().iconst(I64, APPLIED);
        self.b.ins().return_(&[answer]);
    }
}
