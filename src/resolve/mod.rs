//! Tree to program: names, kinds, types.

mod program;

pub use program::{
    Block, Op as ResolvedOp, Print, Program, Script, Statement, StatementKind, Variable,
};
