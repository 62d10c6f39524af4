//! Typed expressions to register code.
//!
//! Where names and variables live is the [`Scope`]'s business, so that the same lowering
//! serves the diagrams of operations and scripts. An expression writes nothing but
//! registers: whoever lowers it can still refuse, or trap, with the mesh as it was.

use crate::diagram::{Expr, NameId};
use crate::rewrite::{Assembler, Reg};
use crate::source::Span;

/// Where an expression finds what it names.
pub trait Scope {
    /// The register of a drawn element.
    fn element(&self, name: NameId) -> Reg;
    /// The first register of a parameter or variable.
    fn local(&self, variable: u32) -> Reg;
    /// Gives a register to the variable of an aggregate.
    fn declare(&mut self, variable: u32, reg: Reg);
    /// A number for a place in the source, for what may trap there.
    fn place(&mut self, span: Span) -> u32;
}

/// Appends the code of an expression; its value is in the register, or the three from it
/// on, until that is released. The register may be that of a variable: it is not to be
/// written to.
pub fn lower(_asm: &mut Assembler, _scope: &mut dyn Scope, _expr: &Expr) -> Reg {
    Reg(0)
}
