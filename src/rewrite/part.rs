//! Loops whose turns several threads can take.
//!
//! A loop over all elements of the mesh that only reads, and keeps what it writes back to its end,
//! can be cut: its code, by itself, goes over a range of slots. It may use what was in the registers
//! before the loop, and leaves nothing in them. What the parts keep back is written in their order,
//! and of several traps the first counts; so the result is that of one thread.

use super::inst::computation;
use super::{Assembler, Code, Elements, Function, Inst, Label, Reg, Traps};

/// The loop of a code, by itself, over the elements in a range of slots.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The elements.
    pub of: Elements,
    /// How deep it lies within other loops.
    pub depth: u16,
    /// The register of the first slot, and that of the one behind the last.
    pub bounds: [Reg; 2],
    /// The buffer in which it keeps back what it writes.
    pub held: u16,
    /// Its instructions, as those of a function.
    pub code: Code,
}

/// The registers and labels of a loop over all elements.
#[derive(Clone, Copy, Debug)]
pub struct Turns {
    pub of: Elements,
    pub depth: u16,
    /// The variable.
    pub element: Reg,
    /// Registers that the loop alone uses.
    pub index: Reg,
    pub total: Reg,
    /// A register that holds 1.
    pub one: Reg,
    pub held: u16,
    /// The first instruction of a turn, which gets the element, and the one behind the loop.
    pub again: Label,
    pub end: Label,
}

impl Assembler {
    /// Lets several threads take the turns of the loop that follows.
    pub fn spread(&mut self, turns: Turns) {
        // Of more than these, one thread does it.
        if let Ok(part) = u16::try_from(self.spread.len()) {
            self.emit(Inst::Spread { part, end: turns.end });
            self.spread.push(turns);
        }
    }
}

/// The instructions before those of a turn.
const HEAD: u32 = 6;

impl Part {
    /// The loop by itself; `None` if it does more than read and keep back. Its labels are the
    /// places of instructions in the code.
    pub(super) fn of(turns: Turns, code: &Code) -> Option<Self> {
        let Turns { of, depth, element, index, total, one, held, again, end } = turns;
        let constants = code.constants as u32;
        // The turn itself, behind what gets its element and shows how far the loop is.
        let (first, behind) = (again.0 + 2, end.0);
        let turn = code.insts.get(first as usize..behind as usize)?;
        let start = constants + HEAD;
        let last = Label(start + (behind - first));
        let again_here = Label(constants + 1);
        let mut insts = code.insts[..code.constants].to_vec();
        insts.extend([
            Inst::Jump { to: Label(constants + 2) },
            Inst::AddInt { to: element, left: element, right: one },
            Inst::NextLiving { of, element, otherwise: last },
            Inst::LessInt { to: index, left: element, right: total },
            Inst::JumpUnless { condition: index, to: last },
            Inst::Tick,
        ]);
        for inst in turn {
            let mut inst = *inst;
            let keeps_here = match inst {
                Inst::HoldPosition { buffer, .. } | Inst::HoldAttribute { buffer, .. } => {
                    buffer == held
                }
                _ => true,
            };
            if !inst.is_for_parts() || !keeps_here || matches!(inst, Inst::Give { .. }) {
                return None;
            }
            if let Some(to) = inst.target_mut() {
                *to = match to.0 {
                    at if at == again.0 => again_here,
                    at if (first..behind).contains(&at) => Label(at - first + start),
                    _ => return None,
                };
            }
            insts.push(inst);
        }
        insts.push(Inst::Give { from: Reg(0), width: 0 });
        let in_turn = |&&(at, _): &&(u32, u32)| (first - 1..behind).contains(&at);
        let traps: Traps =
            code.traps.iter().filter(in_turn).map(|&(at, why)| (at + start - first, why)).collect();
        let code = Code {
            insts,
            constants: code.constants,
            registers: code.registers,
            buffers: code.buffers,
            traps,
            ..Code::default()
        };
        Some(Self { of, depth, bounds: [element, total], held, code })
    }

    /// True if the functions that it calls read only, too.
    #[cfg_attr(not(all(feature = "native", feature = "threads")), expect(dead_code))]
    pub(super) fn calls_readers(&self, functions: &[Function]) -> bool {
        let mut seen = vec![false; functions.len()];
        let mut open = vec![&self.code];
        while let Some(code) = open.pop() {
            for inst in &code.insts {
                let is_kept =
                    matches!(inst, Inst::HoldPosition { .. } | Inst::HoldAttribute { .. });
                if !inst.is_for_parts() || (is_kept && !std::ptr::eq(code, &self.code)) {
                    return false;
                }
                let Inst::Call { function, .. } = inst else { continue };
                match (functions.get(usize::from(*function)), seen.get_mut(usize::from(*function)))
                {
                    (Some(called), Some(seen)) => {
                        if !std::mem::replace(seen, true) {
                            open.push(&called.code);
                        }
                    }
                    _ => return false,
                }
            }
        }
        true
    }
}

impl Inst {
    /// True for what changes nothing that another thread sees: values, loads and questions, jumps,
    /// lists, calls of functions, and writes that are kept back.
    fn is_for_parts(&self) -> bool {
        #[rustfmt::skip]
        let is = matches!(
            self,
            computation!() | Inst::Const { .. } | Inst::Copy { .. } | Inst::Select { .. }
            | Inst::Load { .. } | Inst::LoadHalfedge { .. } | Inst::LoadHole { .. }
            | Inst::LoadPosition { .. } | Inst::LoadAttribute { .. } | Inst::Capacity { .. }
            | Inst::NextLiving { .. } | Inst::JumpUnlessLiving { .. } | Inst::Alive { .. }
            | Inst::Ask { .. } | Inst::Count { .. } | Inst::CountHoles { .. }
            | Inst::WalkBegin { .. } | Inst::WalkNext { .. } | Inst::Collect { .. }
            | Inst::CollectEars { .. } | Inst::Meets { .. } | Inst::MeetsAll { .. }
            | Inst::NextIndex { .. } | Inst::Member { .. } | Inst::BufferClear { .. }
            | Inst::BufferPush { .. } | Inst::BufferLength { .. } | Inst::BufferGet { .. }
            | Inst::BufferGetWide { .. } | Inst::BufferNext { .. } | Inst::BufferLiving { .. }
            | Inst::BufferAppend { .. } | Inst::HoldPosition { .. } | Inst::HoldAttribute { .. }
            | Inst::Call { .. } | Inst::Give { .. } | Inst::Turn { .. } | Inst::Tick
            | Inst::Fail { .. }
        );
        is
    }
}
