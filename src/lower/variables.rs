//! Variables of statements: which are read, and how often each is set.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagram::{Expr, ExprKind};
use crate::resolve::{Statement, StatementKind};

/// The use that statements make of variables, by their numbers.
#[derive(Clone, Debug, Default)]
pub struct Variables {
    read: BTreeSet<u32>,
    /// The number of statements that set each; a loop sets its own variable.
    sets: BTreeMap<u32, u32>,
}

impl Variables {
    pub fn of(block: &[Statement]) -> Self {
        let mut all = Self::default();
        let mut note = |statement: &Statement| {
            statement.values(&mut |value| all.see(value));
            if let StatementKind::Set { variable, .. }
            | StatementKind::For { variable, .. }
            | StatementKind::Drain { variable, .. }
            | StatementKind::Apply { variable: Some(variable), .. } = statement.kind
            {
                *all.sets.entry(variable).or_default() += 1;
            }
        };
        block.iter().for_each(|statement| statement.each(&mut note));
        all
    }

    fn see(&mut self, value: &Expr) {
        value.each(&mut |part| {
            if let ExprKind::Local(variable) = part.kind {
                self.read.insert(variable);
            }
        });
    }

    /// True if a variable is read.
    pub fn reads(&self, variable: u32) -> bool {
        self.read.contains(&variable)
    }

    /// The number of statements that set a variable.
    pub fn sets(&self, variable: u32) -> u32 {
        self.sets.get(&variable).copied().unwrap_or(0)
    }

    /// True if the variables that a part of these statements sets are set nowhere else, and none is
    /// a parameter; parameters have the first numbers.
    pub fn stay_within(&self, part: &[Statement], params: usize) -> bool {
        let here = Self::of(part).sets;
        here.iter().all(|(&at, &count)| at as usize >= params && count == self.sets(at))
    }
}
