//! Scope: what the lowering of an expression needs to know of its surroundings.

use crate::diagram::{NameId, Type};
use crate::rewrite::{Assembler, Inst, Reg};
use crate::source::Span;

/// The scope in which an expression finds what it names.
pub trait Scope {
    /// The register of a drawn element.
    fn element(&self, name: NameId) -> Reg;
    /// The first register of a parameter or variable.
    fn local(&self, variable: u32) -> Reg;
    /// Gives a register to the variable of an aggregate.
    fn declare(&mut self, variable: u32, reg: Reg);
    /// The number of a place in the source, for instructions that may trap there.
    fn place(&mut self, span: Span) -> u32;
    /// Whether the expression is in a statement; several threads may then compute its values for
    /// all elements.
    fn is_of_statements(&self) -> bool {
        false
    }
}

/// The number of registers of a value.
pub fn width(ty: Type) -> u16 {
    let size = u16::from(ty.size());
    if ty.is_matrix() { size * size } else { size }
}

/// Copies a value of a type.
pub fn copy(asm: &mut Assembler, ty: Type, to: Reg, from: Reg) {
    asm.emit(match width(ty) {
        1 => Inst::Copy { to, from },
        3 => Inst::CopyVec { to, from },
        // No value is as wide as 256.
        width => Inst::CopyWide { to, from, width: width as u8 },
    });
}
