//! The ways to run code.

/// The way in which code is run. The results are the same, bit for bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engine {
    /// The machine interprets all code.
    Machine,
    /// Operations, functions and scripts are compiled to native code once they have run so often,
    /// or their loops have taken so many iterations, that it pays; native code can take over in the
    /// middle of a loop. The machine runs the code before that, drains whose keys are tracked by
    /// noting their reads, and everything where native code is not available.
    #[default]
    Native,
    /// All code is compiled to native code at its first run.
    NativeAtOnce,
}

/// The kind of code that runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CodeKind {
    /// A script, which leaves its registers in its window.
    Script,
    Function,
    /// An operation, all or nothing.
    Whole,
    /// An operation, up to its first write.
    Dry,
}
