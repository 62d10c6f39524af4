//! Traps: the reasons why a run could not continue, and where.
//!
//! A trap refers to places by number; the compiler of the code has their spans. A trap is not a
//! refusal: a refusal is an answer, and the run continues.

use std::fmt;

use crate::mesh::{Element, ElementKind, Level};

/// The end of a run that could not continue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trap {
    /// The reason.
    pub message: Message,
    /// The call stack, the innermost call first.
    pub trace: Vec<Site>,
    /// The kind and number of the element that the failed instruction was about, if that is known.
    pub about: Option<(ElementKind, u32)>,
}

/// A place in one call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Site {
    /// The number of the operation that ran; `None` for the code run at the top.
    pub op: Option<u16>,
    /// The number of the function that ran, in that code; `None` for the code itself.
    pub function: Option<u16>,
    /// The number of the instruction's place in the source, if it has one.
    pub place: Option<u32>,
}

/// The reason why a run could not continue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Message {
    /// The element has been erased, or never was.
    Gone(ElementKind),
    /// There is no element, as for the halfedge of an isolated vertex.
    Missing(ElementKind),
    /// An int is divided by zero.
    DivisionByZero,
    /// An int is out of range.
    IntOverflow,
    /// The bound of a random int is not positive.
    NothingToChoose,
    /// NaN is rounded to an int.
    RoundsNaN,
    /// A position would get a component that is not finite.
    NotFinite,
    /// The key of an element of a drain is NaN.
    KeyNotANumber,
    /// The key of an element of a drain is an int that reals do not tell apart from others.
    KeyTooLarge,
    /// All ids of a kind are in use.
    NoRoom(ElementKind),
    /// The mesh and the lists would take more memory than this limit in bytes.
    NoMemory(usize),
    /// A pointer would be set to a number that is not an element.
    WildPointer(ElementKind),
    /// A list has no such entry.
    OutOfRange,
    /// A walk does not end, which happens on a broken mesh only.
    Endless,
    /// A failure in words: there is nothing to take the mean, the minimum or the maximum of.
    Failed(String),
    /// An assertion does not hold.
    Asserted {
        /// The program's text.
        message: String,
        /// The values that were compared, as text; may be empty.
        values: String,
    },
    /// An op refused although the script said `must`.
    Refused {
        /// The name of the op.
        op: String,
        /// The reason of the refusal.
        reason: String,
    },
    /// An op with a guard is called on a mesh that is not of its level.
    BelowLevel {
        /// The name of the op.
        op: String,
        /// The level that the op expects.
        level: Level,
        /// The way in which the mesh violates the level.
        why: String,
        /// The op applied last that may have lowered the level.
        after: Option<String>,
    },
    /// An op without a plan is called.
    Unproved,
    /// Calls are nested too deeply.
    TooDeep,
    /// The watcher interrupted the run.
    Interrupted,
    /// The code refers to a buffer, text or other item that it does not have.
    Malformed,
}

/// The reason why an instruction failed. Every instruction returns it in its result, so it is
/// small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    Gone(ElementKind),
    Missing(ElementKind),
    DivisionByZero,
    IntOverflow,
    RoundsNaN,
    NotFinite,
    NoRoom(ElementKind),
    WildPointer(ElementKind),
    OutOfRange,
    Endless,
    Malformed,
}

impl From<Fault> for Message {
    #[cold]
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::Gone(kind) => Self::Gone(kind),
            Fault::Missing(kind) => Self::Missing(kind),
            Fault::DivisionByZero => Self::DivisionByZero,
            Fault::IntOverflow => Self::IntOverflow,
            Fault::RoundsNaN => Self::RoundsNaN,
            Fault::NotFinite => Self::NotFinite,
            Fault::NoRoom(kind) => Self::NoRoom(kind),
            Fault::WildPointer(kind) => Self::WildPointer(kind),
            Fault::OutOfRange => Self::OutOfRange,
            Fault::Endless => Self::Endless,
            Fault::Malformed => Self::Malformed,
        }
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Message::Gone(kind) => write!(f, "the {kind} no longer exists"),
            Message::Missing(kind) => write!(f, "there is no {kind} here"),
            Message::DivisionByZero => f.write_str("division by zero"),
            Message::IntOverflow => f.write_str("the number is too large for an int"),
            Message::NothingToChoose => f.write_str("`random(n)` wants an `n` of 1 or more"),
            Message::RoundsNaN => f.write_str("what is rounded is not a number"),
            Message::NotFinite => f.write_str("the new position is not finite"),
            Message::KeyNotANumber => f.write_str("the key of an element is not a number"),
            Message::KeyTooLarge => f.write_str(
                "an int as a key lies beyond 2^53, and its order among others is not certain",
            ),
            Message::NoRoom(kind) => write!(f, "there is no room for another {kind}"),
            Message::NoMemory(usize::MAX) => f.write_str("there is no memory for more"),
            Message::NoMemory(limit) => {
                let (unit, name) = match *limit < 1 << 20 {
                    true => (1_u64 << 10, "KiB"),
                    false => (1 << 20, "MiB"),
                };
                let limit = *limit as f64 / unit as f64;
                write!(f, "there is no room for more in {limit:.0} {name} of memory")
            }
            Message::WildPointer(kind) => write!(f, "a pointer would lead to no {kind}"),
            Message::OutOfRange => f.write_str("the index is out of range"),
            Message::Endless => f.write_str("the mesh is broken: a walk does not end"),
            Message::Failed(text) | Message::Asserted { message: text, .. } => f.write_str(text),
            Message::Refused { op, reason } => write!(f, "`{op}` refused: {reason}"),
            Message::BelowLevel { op, level, after: None, .. } => {
                write!(f, "`{op}` is for meshes of level {level}, and this one is not")
            }
            Message::BelowLevel { op, level, after: Some(after), .. } => write!(
                f,
                "`{op}` is for meshes of level {level}, and after `{after}` this one is not"
            ),
            Message::Unproved => f.write_str("the operation has not been proved"),
            Message::TooDeep => f.write_str("calls are nested too deeply"),
            Message::Interrupted => f.write_str("interrupted"),
            Message::Malformed => f.write_str("the code is malformed"),
        }
    }
}

impl fmt::Display for Trap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(element) = self.about.map(|(kind, index)| Element { kind, index }) else {
            return self.message.fmt(f);
        };
        match &self.message {
            Message::Gone(kind) if *kind == element.kind => write!(f, "{element} no longer exists"),
            Message::NotFinite => write!(f, "the new position of {element} is not finite"),
            Message::KeyNotANumber => write!(f, "the key of {element} is not a number"),
            Message::Refused { op, reason } => write!(f, "`{op}` refused {element}: {reason}"),
            message => message.fmt(f),
        }
    }
}

impl std::error::Error for Trap {}
