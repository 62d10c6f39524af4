//! Traversal of statements: their blocks and the values that they compute.

use super::program::{Block, Print, Statement, StatementKind};
use crate::diagram::Expr;

impl Statement {
    pub fn blocks(&self) -> impl Iterator<Item = &Block> {
        let (one, other) = match &self.kind {
            StatementKind::Repeat { body, .. }
            | StatementKind::While { body, .. }
            | StatementKind::For { body, .. }
            | StatementKind::Drain { body, .. } => (Some(body), None),
            StatementKind::If { then, otherwise, .. }
            | StatementKind::Apply { then, otherwise, .. } => (Some(then), Some(otherwise)),
            StatementKind::Set { .. }
            | StatementKind::Write { .. }
            | StatementKind::Print(_)
            | StatementKind::Assert { .. }
            | StatementKind::Require { .. }
            | StatementKind::Refused { .. }
            | StatementKind::KeepMesh { .. }
            | StatementKind::AssertMesh { .. }
            | StatementKind::AssertRefuses { .. }
            | StatementKind::Break
            | StatementKind::Continue
            | StatementKind::Return(_)
            | StatementKind::Call { .. } => (None, None),
        };
        one.into_iter().chain(other)
    }

    /// Calls `see` with this statement and all statements inside it.
    pub fn each<'s>(&'s self, see: &mut dyn FnMut(&'s Statement)) {
        see(self);
        self.blocks().flatten().for_each(|inner| inner.each(see));
    }

    /// Calls `see` with the values that it computes itself, not those of statements inside it.
    pub fn values<'s>(&'s self, see: &mut dyn FnMut(&'s Expr)) {
        match &self.kind {
            StatementKind::Set { value, .. } => see(value),
            StatementKind::Write { target, value, .. } => [target, value].into_iter().for_each(see),
            StatementKind::Repeat { count, .. } => see(count),
            StatementKind::While { condition, .. }
            | StatementKind::If { condition, .. }
            | StatementKind::Assert { condition, .. }
            | StatementKind::Require { condition, .. } => see(condition),
            StatementKind::For { collection, filter, .. } => {
                collection.base().into_iter().chain(filter).for_each(see);
            }
            StatementKind::Drain { collection, key, condition, .. } => {
                collection.base().into_iter().chain([key]).chain(condition).for_each(see);
            }
            StatementKind::Apply { args, .. }
            | StatementKind::AssertRefuses { args, .. }
            | StatementKind::Call { args, .. } => args.iter().for_each(see),
            StatementKind::Return(value) => value.iter().for_each(see),
            StatementKind::Print(pieces) => pieces.iter().for_each(|piece| match piece {
                Print::Text(_) => {}
                Print::Value(value, _) => see(value),
            }),
            StatementKind::Refused { .. }
            | StatementKind::KeepMesh { .. }
            | StatementKind::AssertMesh { .. }
            | StatementKind::Break
            | StatementKind::Continue => {}
        }
    }
}
