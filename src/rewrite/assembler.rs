//! The assembler of code: registers, labels, constants, trap places.
//!
//! The lowest free registers are allocated first, so that parameters that are allocated before
//! anything else are at the start of the window. Registers that are allocated after a [`Mark`] are
//! freed when the mark is released; constants are pooled, loaded once at the start of the code, and
//! never freed. Until [`Assembler::finish`] a [`Label`] is only a number; `finish` replaces it by
//! the index of an instruction.

use std::collections::HashMap;
use std::fmt;
use std::sync::Arc;

use super::{Code, Inst, Iterations, Label, Native, Part, Reg, Traps};

/// Whether an instruction changes no register that holds a member of a family, its index, or the
/// buffer.
fn keeps_members(inst: &Inst) -> bool {
    matches!(
        inst,
        // These write new registers.
        Inst::Member { .. }
            | Inst::Load { .. }
            | Inst::LoadHalfedge { .. }
            // These write no registers.
            | Inst::Store { .. }
            | Inst::StoreHalfedge { .. }
            | Inst::StoreHole { .. }
            | Inst::PreviewStore { .. }
            | Inst::PreviewStoreHalfedge { .. }
            | Inst::PreviewStoreHole { .. }
    )
}

/// Builds a [`Code`].
#[derive(Debug, Default)]
pub struct Assembler {
    insts: Vec<Inst>,
    traps: Traps,
    /// The instruction each label is bound to.
    labels: Vec<Option<u32>>,
    texts: Vec<String>,
    text_numbers: HashMap<String, u32>,
    /// In the order of first use; the map is an index of them.
    constants: Vec<(Reg, u64)>,
    constant_registers: HashMap<u64, Reg>,
    registers: Registers,
    buffers: u16,
    /// The members of families that have been loaded on every way to the next instruction, and
    /// their registers.
    members: Vec<((u16, Reg, i16), Reg)>,
    /// The loops that may be run by several threads.
    pub(super) spread: Vec<Iterations>,
    /// Whether an iteration that keeps values is being emitted.
    pub(super) is_in_values: bool,
    too_large: bool,
}

/// The error that code needs more registers, buffers, instructions or refusals than can be
/// numbered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge;

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("too large to compile: it needs too many registers or tests")
    }
}

impl std::error::Error for TooLarge {}

/// The allocated registers at some moment, to be restored later.
#[derive(Clone, Copy, Debug)]
pub struct Mark(usize);

impl Assembler {
    /// An assembler of empty code.
    pub fn new() -> Self {
        Self::default()
    }

    /// An assembler of empty code in which these texts have their places in the list as numbers.
    pub fn knowing(texts: &[String]) -> Self {
        let mut asm = Self::default();
        for text in texts {
            asm.text(text);
        }
        asm
    }

    /// Allocates a register.
    pub fn reg(&mut self) -> Reg {
        self.block(1)
    }

    /// Allocates three consecutive registers, for a vector.
    pub fn vec(&mut self) -> Reg {
        self.block(3)
    }

    /// Allocates consecutive registers. If `width` is 0, the result must not be used.
    pub fn block(&mut self, width: u16) -> Reg {
        let reg = self.or_too_large(|registers| registers.take(width));
        self.registers.live.push((reg, width));
        reg
    }

    fn or_too_large(&mut self, take: impl FnOnce(&mut Registers) -> Option<Reg>) -> Reg {
        let reg = take(&mut self.registers);
        self.too_large |= reg.is_none();
        reg.unwrap_or(Reg(0))
    }

    /// Marks the registers that are allocated now.
    pub fn mark(&self) -> Mark {
        Mark(self.registers.live.len())
    }

    /// Frees the registers that have been allocated since the mark. Marks are released in stack
    /// order.
    pub fn release(&mut self, mark: Mark) {
        self.registers.release(mark);
        self.members.clear();
    }

    /// Allocates a buffer, which is empty when the code starts.
    pub fn buffer(&mut self) -> u16 {
        let buffer = self.buffers;
        match buffer.checked_add(1) {
            Some(more) => self.buffers = more,
            None => self.too_large = true,
        }
        buffer
    }

    /// Creates a label that is not bound yet.
    pub fn label(&mut self) -> Label {
        self.labels.push(None);
        Label(self.labels.len() as u32 - 1)
    }

    /// Binds a label to the next instruction.
    pub fn bind(&mut self, label: Label) {
        let here = self.insts.len() as u32;
        self.members.clear();
        if let Some(place) = self.labels.get_mut(label.0 as usize) {
            debug_assert!(place.is_none(), "a label is bound once");
            *place = Some(here);
        }
    }

    /// Appends an instruction.
    pub fn emit(&mut self, inst: Inst) {
        if !keeps_members(&inst) {
            self.members.clear();
        }
        self.insts.push(inst);
    }

    /// A register that holds a member of a family, of which a buffer holds all; it must not be
    /// written.
    pub fn member(&mut self, buffer: u16, index: Reg, shift: i16) -> Reg {
        let wanted = (buffer, index, shift);
        let loaded = self.members.iter().find(|(member, _)| *member == wanted);
        if let Some(&(_, reg)) = loaded {
            return reg;
        }
        let to = self.reg();
        self.emit(Inst::Member { buffer, index, shift, to });
        self.members.push((wanted, to));
        to
    }

    /// The number of the next instruction.
    pub fn next_inst(&self) -> u32 {
        self.insts.len() as u32
    }

    /// Appends an instruction that can trap, with the number of its place in the source.
    pub fn trap_at(&mut self, place: u32, inst: Inst) {
        self.traps.push((self.insts.len() as u32, place));
        self.emit(inst);
    }

    /// A register that holds an int.
    pub fn constant_int(&mut self, value: i64) -> Reg {
        self.constant_bits(value as u64)
    }

    /// A register that holds a real.
    pub fn constant_real(&mut self, value: f64) -> Reg {
        self.constant_bits(value.to_bits())
    }

    /// A register that holds a bool.
    pub fn constant_bool(&mut self, value: bool) -> Reg {
        self.constant_bits(u64::from(value))
    }

    /// A register that holds "no element", of any kind.
    pub fn none(&mut self) -> Reg {
        self.constant_bits(u64::from(u32::MAX))
    }

    /// A register that holds a text.
    pub fn constant_text(&mut self, text: &str) -> Reg {
        let number = self.text(text);
        self.constant_bits(u64::from(number))
    }

    /// A register that holds these bits; it must not be written.
    pub fn constant_bits(&mut self, bits: u64) -> Reg {
        if let Some(&reg) = self.constant_registers.get(&bits) {
            return reg;
        }
        let reg = self.or_too_large(|registers| registers.take_fresh());
        self.constants.push((reg, bits));
        self.constant_registers.insert(bits, reg);
        reg
    }

    /// The number of a text; equal texts have the same number.
    pub fn text(&mut self, text: &str) -> u32 {
        if let Some(&number) = self.text_numbers.get(text) {
            return number;
        }
        let number = self.texts.len() as u32;
        self.texts.push(text.to_owned());
        self.text_numbers.insert(text.to_owned(), number);
        number
    }

    /// Finishes the code. A label that was never bound leads to its end.
    pub fn finish(self) -> Result<Code, TooLarge> {
        let prologue = self.constants.len();
        let length = prologue + self.insts.len();
        if self.too_large || u32::try_from(length).is_err() {
            return Err(TooLarge);
        }
        let shift = prologue as u32;
        let consts = self.constants.iter();
        let mut insts: Vec<Inst> =
            consts.map(|&(to, bits)| Inst::Const { to, bits }).chain(self.insts).collect();
        let place = |label: Label| {
            let bound = self.labels.get(label.0 as usize).copied().flatten();
            Label(bound.map_or(length as u32, |at| at + shift))
        };
        for label in insts.iter_mut().filter_map(Inst::target_mut) {
            *label = place(*label);
        }
        let spread = self.spread.iter().map(|iterations| {
            let [again, first, end] =
                [iterations.again, iterations.first, iterations.end].map(place);
            Iterations { again, first, end, ..*iterations }
        });
        let spread: Vec<Iterations> = spread.collect();
        let traps = self.traps.iter().map(|&(at, place)| (at + shift, place));
        let mut code = Code {
            insts,
            constants: prologue,
            registers: self.registers.most,
            buffers: self.buffers,
            traps: traps.collect(),
            texts: self.texts,
            functions: Arc::default(),
            parts: Vec::new(),
            native: Native::default(),
        };
        code.parts = spread.into_iter().map(|iterations| Part::of(iterations, &code)).collect();
        Ok(code)
    }
}

/// The register allocator.
#[derive(Debug, Default)]
struct Registers {
    taken: Vec<bool>,
    /// No register with a lower number is free.
    first_free: usize,
    /// One more than the highest register ever allocated.
    most: u16,
    /// The registers that a release frees, in the order of allocation.
    live: Vec<(Reg, u16)>,
}

impl Registers {
    /// A register that has never been allocated: a constant is loaded at the start of the code, and
    /// a register that is free now may be used by code that is already emitted.
    fn take_fresh(&mut self) -> Option<Reg> {
        let most = self.most.checked_add(1)?;
        let start = usize::from(self.most);
        self.taken.resize(self.taken.len().max(start + 1), false);
        self.taken[start] = true;
        let reg = Reg(self.most);
        self.most = most;
        Some(reg)
    }

    fn take(&mut self, width: u16) -> Option<Reg> {
        let mut start = self.first_free;
        let mut end = start;
        while end < start + usize::from(width) {
            if self.taken.get(end).copied().unwrap_or(false) {
                start = end + 1;
            }
            end += 1;
        }
        let most = u16::try_from(end).ok()?;
        if self.taken.len() < end {
            self.taken.resize(end, false);
        }
        self.taken[start..end].fill(true);
        if start == self.first_free {
            self.first_free = end;
        }
        self.most = self.most.max(most);
        Some(Reg(u16::try_from(start).ok()?))
    }

    fn release(&mut self, mark: Mark) {
        while self.live.len() > mark.0 {
            let Some((reg, width)) = self.live.pop() else { return };
            let start = usize::from(reg.0);
            let end = start + usize::from(width);
            if let Some(slots) = self.taken.get_mut(start..end) {
                slots.fill(false);
                self.first_free = self.first_free.min(start);
            }
        }
    }
}
