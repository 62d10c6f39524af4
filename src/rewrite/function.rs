//! A function of the program: code that is called from other code.
//!
//! All functions of a program are in one list, which every code that calls one refers to; they call
//! each other by number. A function has a window of its own, the parameters first, and does not see
//! the registers of its caller.

use super::Code;
use crate::source::Span;

/// A function of the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Function {
    /// The name of the function.
    pub name: String,
    /// The number of slots of its parameters.
    pub params: u16,
    /// The code, which ends with [`ReturnValue`](super::Inst::ReturnValue). The functions that it
    /// calls are those of the script or operation.
    pub code: Code,
    /// The places in the source where the code can trap, by the numbers in [`Code::traps`].
    pub places: Vec<Span>,
}
