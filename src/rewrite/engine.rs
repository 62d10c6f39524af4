//! The ways to run code.

/// What runs code. The results are the same, bit for bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engine {
    /// The machine takes one instruction after the other, everywhere.
    Machine,
    /// Native code for operations, from when one has run so often that it pays to compile it; the
    /// machine until then, for scripts, within drains, and where native code is not available.
    #[default]
    Native,
    /// Native code for all that runs, from the first run on.
    NativeAtOnce,
}

/// The kind of code that runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(not(feature = "native"), expect(dead_code, reason = "only native code is told"))]
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
