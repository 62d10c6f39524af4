//! The register code, the plan of an operation, and the machine that runs both.
//!
//! A proved operation and a script lower to the same flat [`Code`]: typed registers,
//! explicit loads and stores on the mesh's arrays, jumps, no closures. An [`Assembler`]
//! writes it; a [`Machine`] runs it on a mesh; native code can be made from it later.

mod code;
mod inst;
mod operand;
mod question;

mod function;
mod plan;
mod steps;

mod assembler;

mod machine;

mod call;
mod dispatch;
mod window;

mod access;
mod arithmetic;
mod around;
mod attempt;
mod attribute;
mod chance;
mod drain;
mod known;
mod memory;
mod notes;
mod observe;
mod preview;
mod print;
mod queue;
mod readers;
mod wide;

mod trap;
mod watch;

pub use assembler::{Assembler, Mark, TooLarge};
pub use call::Outcome;
pub use code::{Code, Label, Reg, Traps};
pub use function::Function;
pub use inst::Inst;
pub use machine::{Count, Machine};
pub use operand::{
    ElementField, Elements, Foreseen, HalfedgeField, Math, Room, Span, Triangles, Walk,
};
pub use plan::{Cell, Phase, Plan, Plans, Refusal, Row, Stage};
pub use print::{ElementText, RealDigits, RealText, VectorText, WideText};
pub use question::Question;
pub use steps::{BELOW, Steps};
pub use trap::{Message, Site, Trap};
pub use watch::{Unwatched, Watch};
pub use wide::{Lanes, Matrix};

use call::Call;
