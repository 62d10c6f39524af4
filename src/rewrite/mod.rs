//! The register code, the plan of an operation, and the machine that runs both.
//!
//! A proved operation and a script lower to the same flat [`Code`]: typed registers, explicit loads
//! and stores on the mesh's arrays, jumps, no closures. An [`Assembler`] builds it; a [`Machine`]
//! runs it on a mesh, as native code where possible ([`Engine`]).

mod code;
mod inst;
mod operand;
mod question;

mod function;
mod part;
mod plan;
mod steps;

mod assembler;

mod engine;
mod machine;
#[cfg_attr(not(feature = "native"), path = "without_native.rs")]
mod native;

mod call;
mod dispatch;
mod window;

mod about;
mod access;
pub mod arithmetic;
mod asked;
mod attempt;
mod attribute;
mod bounded;
pub mod distinct;
mod drain;
mod drain_tables;
pub mod families;
mod key_paths;
mod known_level;
mod list;
mod lookahead;
mod memory;
mod mesh_reads;
mod neighbors;
mod observe;
mod paths;
pub mod preview;
mod print;
pub mod queue;
pub mod random;
pub mod readers;
mod reads;
mod reads_ahead;
mod spread;
mod stale;
pub mod vectors;

mod trap;
mod watch;

pub use crate::mesh::Elements;
pub use asked::Asked;
pub use assembler::{Assembler, Mark, TooLarge};
pub use bounded::Bounded;
pub use call::Outcome;
pub use code::{Code, Label, Reg, Traps};
pub use engine::Engine;
pub use function::Function;
pub use inst::Inst;
pub use key_paths::drains;
pub use machine::{Count, Machine, NamedElements};
pub use native::Native;
pub use operand::{ElementField, HalfedgeField, Math, Room, Span, Triangles, Walk};
pub use part::{Iterations, Part, Task};
pub use paths::Unbounded;
pub use plan::{Cell, Holder, Matched, Phase, Plan, Plans, Refusal, Row, Stage};
pub use print::{RealDigits, RealText, WideText};
pub use question::Question;
pub use steps::{BELOW, Steps};
pub use trap::{Fault, Message, Site, Trap};
pub use vectors::{Lanes, Matrix};
pub use watch::{StopAfter, Unwatched, Watch};

use call::Call;
use list::List;
