//! Tree to program: names, kinds, types.
//!
//! [`resolve`] determines for every name of a drawing what kind of element it stands for, for every
//! expression its type, for every call its op or function. The result is a [`Program`]:
//! [diagrams](crate::diagram) for the checker, scripts for the machine. It assumes nothing of the
//! tree, which may be broken anywhere, and leaves it to the checker whether a drawing makes sense.
//!
//! An item with an error is dropped, and only that item.
//!
//! A program is one file or several. The declarations of a file are visible in it and in the files
//! that use it directly, but not beyond them.

mod program;
mod visit;

mod file;
mod unit;

mod declared;
mod depth;
mod foreign_words;
mod range;
mod report;
mod suggestion;
mod words;

mod attribute;
mod attribute_head;
mod condition;
mod drawing;
mod family;
mod lists;
mod mention;
mod names;
mod op;
mod parameter;
mod property;
mod rule;
mod unused;

mod builtin;
mod constructors;
mod field;
mod fields;
mod lookup;
mod neighbor;
mod operator;
mod overloads;
mod scopes;
mod sequence;
mod sequence_names;
mod type_name;
mod typed;
mod typing;
mod vocabulary;

mod effects;
mod function_call;
mod functions;
mod return_value;
mod returns;
mod routine;
mod signature;

mod asking;
mod assignment;
mod op_call;
mod script;
mod statement;
mod steps;
mod test_meshes;
mod testing;

pub use crate::syntax::tree::Digits;
pub use file::{Fields, Resolved, Types, resolve, resolve_all};
pub use mention::{drawn_names, drawn_parts};
pub use program::{
    Block, Body, Function, Op as ResolvedOp, Print, Program, Script, Statement, StatementKind,
    Steps, Test, TestMesh, Variable, Visit,
};
pub use suggestion::closest;
pub use testing::is_shape;
pub use unit::{Unit, qualifier};
pub use vocabulary::{
    FieldWord, Signature, constants, fields, function_words, is_constant, is_function,
    mesh_and_constant_words, mesh_words, sequence_words, signatures,
};
