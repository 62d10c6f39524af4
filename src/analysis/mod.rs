//! Analysis of programs for editors and commands; all results are plain data.
//!
//! [`Analysis`] takes a text through all stages: tree, program, proofs, plans, and the diagnostics
//! of each. Parts in order are analyzed however broken the rest is.

mod action;
mod actions;
mod aliases;
mod always_refused;
mod argument;
mod before;
mod being_declared;
mod broken_dependencies;
mod completion;
mod cursor_context;
mod dangling_twins;
mod dependencies;
mod disk;
mod drawing_context;
mod edits;
pub mod element;
mod empty_loops;
mod endless_loops;
mod examined;
mod example;
mod file_moves;
mod files;
mod fixes;
mod following_words;
mod foreign;
mod hidden_guards;
mod hints;
mod hover;
mod invert;
mod kept_comments;
mod lenses;
mod library_hints;
mod links;
mod loop_heads;
mod missing_conditions;
pub mod names;
mod no_change;
mod occurrences;
mod op_context;
mod open_loops;
mod outline;
mod parse_cache;
mod program;
mod proposal;
mod reading;
mod refactor;
mod rename;
pub mod side;
mod signature;
mod snapshot;
mod snapshot_cache;
mod soundness;
mod spans;
mod tokens;
mod types;
mod unused;
mod verdict;
mod words;

pub use crate::check::{Argument, Counterexample, Proved};
pub use action::{Action, Purpose};
pub use actions::actions;
pub use aliases::{NamesAsOne, RuleAliases, aliases};
pub use argument::{RuleArgument, why_proved};
pub use completion::{Choice, Completion, completions};
pub use cursor_context::letters_before;
pub use disk::{Disk, expect_regular, is_program, program_text, read_program};
pub use examined::Examined;
pub use example::{NoExample, example};
pub use file_moves::edits_for_moves;
pub use files::{Nowhere, Reader, meant};
pub use hints::{Hint, hints};
pub use hover::{Card, Hover, OpCard, head, hover, op_card, op_here, op_named};
pub use lenses::{Lens, Offer, lenses};
pub use links::{Link, links};
pub use occurrences::{
    Shared, a_word, definition, mentions_of_shared, occurrences, shared, used_path,
};
pub use outline::{Entry, EntryKind, folds, outline};
pub use program::Analysis;
pub use rename::{rename, rename_shared, renameable, stays_the_same};
pub use signature::{Call, signature};
pub use snapshot::Snapshot;
pub use spans::around;
pub use tokens::{Class, Coloured, Marks, tokens};
pub use unused::{Unused, unused};
pub use verdict::{
    GuardVerdict, KeepsOnly, ProvedStatement, RuleVerdict, StepsVerdict, Verdict, verdict, verdicts,
};
pub use words::{MEANINGS, Word, functions, meaning, word};
