//! An operation as data: the orbits of its two sides, its conditions and its assignments.
//!
//! Names are resolved: each has one [`Kind`] and an index, and every mention of it is a [`Ref`]
//! with its place. Paths and fans without a name are given one. Whether the drawing makes sense is
//! decided by [`check`](crate::check).

mod builtin;
mod drawing;
mod expression;
mod inherit;
mod member;
mod op;
mod reassign;
mod spokes;
mod unroll;
mod visit;

pub use builtin::{Builtin, Extent, Overload, Wanted, functions, overloads};
pub use drawing::{Drawing, View};
pub use expression::{
    Access, Around, Attribute, Binary, Collection, Expr, ExprKind, Fold, FoldFunction, Pointer,
    Type, Unary,
};
pub use op::{
    Alias, Assignment, Broken, Cycle, Edge, Example, Kind, Loop, LoopItem, LoopKind, Name, NameId,
    Op, Param, Property, Ref, Require, Role, Rule, Side, Spoke, Star, free_name,
};
pub use reassign::{Operand, Reassignment, Write};
pub use unroll::{Naming, Unrolled};

pub use crate::mesh::{Elements, Level};
