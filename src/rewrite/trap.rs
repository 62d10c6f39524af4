//! Reasons why a run could not go on, and the places.
//!
//! A trap names places by number; whoever made the code knows the spans. It is not a
//! refusal: that is an answer, and the run goes on.

use std::fmt;

use crate::mesh::{ElementKind, Level};

/// A run that could not go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trap {
    /// The reason.
    pub message: Message,
    /// The places: the innermost call first.
    pub trace: Vec<Site>,
}

/// A place in one call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Site {
    /// The number of the operation that ran; `None` for the code run at the top.
    pub op: Option<u16>,
    /// The number of the function that ran, in that code; `None` for the code itself.
    pub function: Option<u16>,
    /// The place of the instruction, if it has one.
    pub place: Option<u32>,
}

/// The reason why a run could not go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Message {
    /// The element has been erased, or never was.
    Gone(ElementKind),
    /// There is none: what an isolated vertex answers when asked for its halfedge.
    Missing(ElementKind),
    /// An int is divided by zero.
    DivisionByZero,
    /// An int is out of range.
    IntOverflow,
    /// A random int is wanted from 0 up to no more than 0.
    NothingToChoose,
    /// What has no nearest int is rounded.
    RoundsNaN,
    /// A position would get a component that is no number.
    NotFinite,
    /// The key of a drained element is not a number.
    KeyNotANumber,
    /// All ids of a kind are in use.
    NoRoom(ElementKind),
    /// The mesh and the lists would take more memory than so many bytes.
    NoMemory(usize),
    /// A pointer would be set to what is no element.
    WildPointer(ElementKind),
    /// A list has no such entry.
    OutOfRange,
    /// A walk does not come to its end: only a broken mesh does this.
    Endless,
    /// The words of the program itself.
    Said(String),
    /// An assertion does not hold.
    Asserted {
        /// The words of the program.
        said: String,
        /// The values that were compared, in words; perhaps nothing.
        values: String,
    },
    /// An op refused that must not.
    Refused {
        /// Its name.
        op: String,
        /// Its reason.
        reason: String,
    },
    /// An op with a guard is called on a mesh that is not of its level.
    BelowLevel {
        /// Its name.
        op: String,
        /// The level.
        level: Level,
        /// The fault of the mesh.
        why: String,
        /// The op applied last that may have made it so.
        after: Option<String>,
    },
    /// An op without a plan is called.
    Unproved,
    /// Calls are nested too deeply.
    TooDeep,
    /// The watcher said so.
    Interrupted,
    /// The code names a buffer or text that it does not have.
    Malformed,
}

/// The reason why an instruction could not be taken. Instructions tell it on every way, so it is
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
            Message::Said(text) | Message::Asserted { said: text, .. } => f.write_str(text),
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
        self.message.fmt(f)
    }
}

impl std::error::Error for Trap {}
