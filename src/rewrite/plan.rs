//! A compiled operation: its code, and the same as a table for people to read.

use std::sync::Arc;

use serde::Serialize;

use super::{Code, Reg, Steps};
use crate::mesh::{ElementKind, Level};
use crate::source::Span;

/// The plans of the operations of a program, by number; `None` stands for one that has not been
/// proved.
pub type Plans = Arc<[Option<Plan>]>;

/// A compiled operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The name of the operation.
    pub name: String,
    /// The widths of the parameters in slots: 1, or 3 for a vector. The window begins with the
    /// parameters, in order.
    pub params: Vec<u16>,
    /// The kind of the first parameter, if it is an element.
    pub of: Option<ElementKind>,
    /// The kind of the result.
    pub result: Option<ElementKind>,
    /// The level that its guard requires of a mesh.
    pub level: Level,
    /// The levels above `Map` that the operation keeps.
    pub keeps: Vec<Level>,
    /// The code: match, allocate, reassign, erase; all or nothing.
    pub code: Code,
    /// The places in the source where the code can trap, by the numbers in [`Code::traps`].
    pub places: Vec<Span>,
    /// The reasons why it can refuse, by number.
    pub refusals: Vec<Refusal>,
    /// Each alternative in four phases, as tables; empty for an op in steps.
    pub stages: Vec<Stage>,
    /// By alternative, the registers and buffers of its names when it has matched; empty for an op
    /// in steps.
    pub matched: Vec<Matched>,
    /// The steps of an op in steps, which calls others, all or nothing.
    pub steps: Option<Steps>,
}

/// The names of an alternative that has matched, before anything is written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Matched {
    /// The first instruction after the matching.
    pub from: u32,
    /// The elements that are named in `before`.
    pub names: Vec<(String, ElementKind, Holder)>,
}

/// The place of the element of a name, or of the elements of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holder {
    /// In a register.
    Reg(Reg),
    /// In a buffer, one for each index.
    Buffer(u16),
}

impl Plan {
    /// The highest level that a mesh of the given level is known to have after the op.
    pub fn level_after(&self, level: Level) -> Level {
        self.keeps.iter().filter(|&&kept| kept <= level).copied().max().unwrap_or(Level::Map)
    }
}

/// The reason why an op can refuse.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize)]
pub struct Refusal {
    /// The reason as text: "`f0` is a hole".
    pub reason: String,
    /// The phase that the attempt reached; of several attempts the one that came furthest is
    /// reported, and the first of equals.
    pub phase: Phase,
}

/// The phase that an attempt reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Phase {
    /// The diagram does not match.
    Match,
    /// A `require` does not hold.
    Require,
    /// A guard does not hold.
    Guard,
    /// There is no room, or a new position is not finite.
    Evaluate,
}

/// One alternative in four phases.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Stage {
    /// The name of the alternative.
    pub rule: Option<String>,
    /// 1. Collect: a line per load or test.
    pub collect: Vec<Row>,
    /// 2. Allocate.
    pub allocate: Vec<Row>,
    /// 3. Reassign: every pointer of every named element.
    pub reassign: Vec<Row>,
    /// 4. Erase.
    pub erase: Vec<Row>,
}

/// A line of the table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Row {
    /// The parts: `a.next`, `=`, `c`.
    #[serde(flatten)]
    pub cell: Cell,
    /// Whether the code does this; a store that provably changes nothing is left out.
    pub executed: bool,
}

/// A cell of a line.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Cell {
    /// `target = value`
    Set {
        /// `a.next`, or a name that is bound.
        target: String,
        /// `c`, or an expression.
        value: String,
    },
    /// A test that must hold, and the reason if it does not.
    Test {
        /// "`b.next` is `c`".
        claim: String,
        /// The refusal.
        reason: String,
    },
    /// Anything else, in words.
    Note {
        /// The words.
        text: String,
    },
}

impl Cell {
    /// The text for the value of a pointer that is kept, whatever it is.
    pub const AS_IT_WAS: &'static str = "as it was";
}
