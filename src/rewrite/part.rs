//! Loops whose iterations can run on several threads.
//!
//! A loop over all elements of the mesh that only reads, and keeps its writes back to its end, can
//! be cut into parts: its code, copied on its own, runs over a range of slots. It may read what was
//! in the registers before the loop, and leaves nothing in them. The writes of the parts are done
//! in the order of the parts, and of several traps the first counts, so the result is that of one
//! thread.
//!
//! The values of an aggregate, the elements that pass the filter of a `parallel for` and the keys
//! of a drain are computed in the same way. Their iterations have separate code, which a single
//! thread never reaches: it only keeps values, which the statement then combines in their order. If
//! an iteration traps, one thread starts over.

use super::inst::group;
use super::memory::HELD_USUALLY;
use super::{Assembler, Code, Elements, Function, Inst, Label, Reg, Traps};

/// A loop of a code, on its own, over the elements in a range of slots.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    pub of: Elements,
    /// The number of loops around it.
    pub depth: u16,
    /// The registers of the first slot and of the end of the range.
    pub bounds: [Reg; 2],
    pub task: Task,
    /// The buffer of the writes that it keeps back, or of the values that all parts have kept.
    pub held: u16,
    /// The instructions, as of a function.
    pub code: Code,
}

/// The task of the parts of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// To keep back what an `update` writes, which is written when all parts are done.
    Update,
    /// To keep the values of an aggregate, which are put into a buffer when all parts are done.
    Aggregate,
    /// To keep the elements that pass the filter of a `parallel for`, which are put into a buffer
    /// when all parts are done.
    Filter,
    /// To keep elements of the innermost drain and their keys, which are set when all parts are
    /// done.
    Keys,
}

/// The registers and labels of a loop over all elements.
#[derive(Clone, Copy, Debug)]
pub struct Iterations {
    pub of: Elements,
    pub depth: u16,
    /// The register of the loop's variable.
    pub element: Reg,
    /// Registers that only the loop uses.
    pub index: Reg,
    pub total: Reg,
    /// A register that holds 1.
    pub one: Reg,
    pub task: Task,
    pub held: u16,
    /// The start of the next iteration, the first instruction of an iteration after its element is
    /// set, and the end of the loop.
    pub again: Label,
    pub first: Label,
    pub end: Label,
}

impl Assembler {
    /// Lets the iterations of the loop that follows run on several threads.
    pub fn spread(&mut self, iterations: Iterations) {
        // Further loops run on one thread.
        if let Ok(part) = u16::try_from(self.spread.len()) {
            self.emit(Inst::Spread { part, end: iterations.end });
            self.spread.push(iterations);
        }
    }

    /// Lets several threads compute values for all elements, in an iteration whose code is still to
    /// be appended; a single thread continues after this code. `None` inside such an iteration, and
    /// where there are no threads.
    pub fn spread_values(&mut self, of: Elements, element: Reg, task: Task) -> Option<Iterations> {
        if self.is_in_values || cfg!(not(all(feature = "native", feature = "threads"))) {
            return None;
        }
        let iterations = Iterations {
            of,
            depth: 0,
            element,
            index: self.reg(),
            total: self.reg(),
            one: self.constant_int(1),
            task,
            held: self.buffer(),
            again: self.label(),
            first: self.label(),
            end: self.label(),
        };
        self.spread(iterations);
        Some(iterations)
    }

    /// Begins an iteration that keeps values.
    pub fn begin_values(&mut self, iterations: Iterations) {
        self.is_in_values = true;
        self.bind(iterations.first);
    }

    /// Ends such an iteration. The code that follows runs when all threads are done.
    pub fn end_values(&mut self, iterations: Iterations) {
        self.is_in_values = false;
        self.bind(iterations.again);
        self.emit(Inst::Jump { to: iterations.again });
        self.bind(iterations.end);
    }
}

/// The number of instructions before those of an iteration.
const HEAD: u32 = 6;

impl Part {
    /// The loop on its own; `None` if it does more than read and keep back. Its labels are places
    /// of instructions in the code.
    pub(super) fn of(iterations: Iterations, code: &Code) -> Option<Self> {
        let Iterations { of, depth, element, index, total, one, task, held, again, first, end } =
            iterations;
        let constants = code.constants as u32;
        let (first, behind) = (first.0, end.0);
        let iteration = code.insts.get(first as usize..behind as usize)?;
        let start = constants + HEAD;
        let last = Label(start + (behind - first));
        let again_here = Label(constants + 1);
        let mut insts = code.insts[..code.constants].to_vec();
        insts.extend([
            Inst::Jump { to: Label(constants + 2) },
            Inst::AddInt { to: element, left: element, right: one },
            Inst::LessInt { to: index, left: element, right: total },
            Inst::JumpUnless { condition: index, to: last },
            Inst::JumpUnlessLiving { of, element, to: again_here },
            Inst::Tick,
        ]);
        for inst in iteration {
            let mut inst = *inst;
            let keeps_here = match inst {
                Inst::DeferPosition { buffer, .. } | Inst::DeferAttribute { buffer, .. } => {
                    buffer == held
                }
                _ => true,
            };
            if !inst.is_for_parts() || !keeps_here || matches!(inst, Inst::ReturnValue { .. }) {
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
        insts.push(Inst::ReturnValue { from: Reg(0), width: 0 });
        // The instruction before the iteration calls the watcher, as `Tick` does above.
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
        Some(Self { of, depth, bounds: [element, total], task, held, code })
    }

    /// The number of slots that an iteration keeps; for an `update`, the usual number.
    pub(super) fn keeps(&self) -> usize {
        let slots = self.code.insts.iter().map(|inst| match (self.task, inst) {
            (Task::Update, Inst::DeferPosition { .. } | Inst::DeferAttribute { .. }) => {
                HELD_USUALLY
            }
            (Task::Aggregate | Task::Filter | Task::Keys, Inst::Keep { .. }) => 1,
            _ => 0,
        });
        slots.sum()
    }

    /// The attributes of the loop's own element that an `update` writes, `None` for its position;
    /// nothing if it writes to other elements.
    pub(super) fn own_writes(&self) -> Option<Vec<Option<u16>>> {
        let mut writes = Vec::new();
        for inst in &self.code.insts {
            let (element, attribute) = match *inst {
                Inst::DeferPosition { vertex, .. } => (vertex, None),
                Inst::DeferAttribute { attribute, element, .. } => (element, Some(attribute)),
                _ => continue,
            };
            if element != self.bounds[0] {
                return None;
            }
            if !writes.contains(&attribute) {
                writes.push(attribute);
            }
        }
        Some(writes)
    }

    /// Whether an iteration takes longer than combining its value with others.
    pub(super) fn is_costly(&self) -> bool {
        let is_costly = |inst: &Inst| {
            matches!(
                inst,
                Inst::Ask { .. }
                    | Inst::Call { .. }
                    | Inst::WalkBegin { .. }
                    | Inst::NeighborsBegin { .. }
                    | Inst::Matrix { .. }
            )
        };
        self.task != Task::Aggregate || self.code.insts.iter().any(is_costly)
    }

    /// Whether the functions that it may call, out of these, also only read.
    pub fn reads_only(&self, functions: &[Function]) -> bool {
        self.code.with_called_of(functions).into_iter().all(|code| {
            code.insts.iter().all(|inst| {
                let keeps =
                    matches!(inst, Inst::DeferPosition { .. } | Inst::DeferAttribute { .. });
                inst.is_for_parts() && (!keeps || std::ptr::eq(code, &self.code))
            })
        })
    }
}

impl Inst {
    /// Whether it changes nothing that another thread sees: values, loads and questions, jumps,
    /// lists, calls of functions, and writes that are kept back.
    fn is_for_parts(&self) -> bool {
        #[rustfmt::skip]
        let is = matches!(
            self,
            group!(computes) | Inst::Const { .. } | Inst::Copy { .. } | Inst::Select { .. }
            | Inst::Load { .. } | Inst::LoadHalfedge { .. } | Inst::LoadHole { .. }
            | Inst::LoadPosition { .. } | Inst::LoadAttribute { .. } | Inst::Capacity { .. }
            | Inst::NextLiving { .. } | Inst::JumpUnlessLiving { .. } | Inst::Alive { .. }
            | Inst::Ask { .. } | Inst::Count { .. } | Inst::CountHoles { .. }
            | Inst::WalkBegin { .. } | Inst::WalkNext { .. } | Inst::Collect { .. }
            | Inst::NeighborsBegin { .. } | Inst::NeighborsNext { .. }
            | Inst::CollectEars { .. } | Inst::Meets { .. } | Inst::MeetsAll { .. }
            | Inst::NextIndex { .. } | Inst::Member { .. } | Inst::BufferClear { .. }
            | Inst::BufferPush { .. } | Inst::BufferLength { .. } | Inst::BufferGet { .. }
            | Inst::BufferGetWide { .. } | Inst::BufferNext { .. } | Inst::BufferLiving { .. }
            | Inst::BufferAppend { .. } | Inst::DeferPosition { .. } | Inst::DeferAttribute { .. }
            | Inst::Call { .. } | Inst::ReturnValue { .. } | Inst::Iteration { .. } | Inst::Tick
            | Inst::Fail { .. }
            | Inst::BufferFree { .. } | Inst::Keep { .. }
            // These do nothing in a part: its loops are not spread again, and no id is recycled.
            | Inst::Spread { .. } | Inst::Recycle
        );
        is
    }
}
