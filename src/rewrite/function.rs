//! A function of the program: code that is called from other code.
//!
//! All functions of a program stand in one list, which every code that calls one has at hand;
//! they name each other by number. A function has registers of its own, the parameters first,
//! and what its caller has in its registers it never sees.

use super::Code;
use crate::source::Span;

/// A function of the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// The number of slots of its parameters.
    pub params: u16,
    /// Its code, which ends with [`Give`](super::Inst::Give). The functions that it calls are
    /// those of the code at the top.
    pub code: Code,
    /// The places in the source where the code can trap, by the numbers in [`Code::traps`].
    pub places: Vec<Span>,
}
