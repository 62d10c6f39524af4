//! The ways to run code.

/// What runs code. The results are the same, bit for bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engine {
    /// The machine takes one instruction after the other, everywhere.
    Machine,
    /// Native code for operations, functions and scripts, from when one has run so often, or its
    /// loops have taken so many turns, that it pays to compile it: it goes on in the middle of the
    /// loop. The machine until then, for drains whose keys are found by what they have read, and
    /// where native code is not available.
    #[default]
    Native,
    /// Native code for all that runs, from the first run on.
    NativeAtOnce,
}

/// The kind of code that runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// A script, which leaves its registers in its window.
    Script,
    /// A function.
    Function,
    /// An operation, whole or not at all.
    Whole,
    /// An operation, up to its first write.
    Dry,
}
