//! The register code, the plan of an operation, and the machine that runs both.
//!
//! A proved operation and a script lower to the same flat [`Code`]: typed registers,
//! explicit loads and stores on the mesh's arrays, jumps, no closures. The
//! [`Machine`](machine) runs it on a mesh; native code can be made from it later.

mod assembler;
mod code;
mod plan;

pub use assembler::{Assembler, Mark, TooLarge};
pub use code::{Code, ElementField, Elements, HalfedgeField, Inst, Label, Math, Reg, Traps, Walk};
pub use plan::{Cell, Phase, Plan, Refusal, Row, Stage};
