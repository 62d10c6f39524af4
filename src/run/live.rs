//! Liveness of the variables that hold elements.
//!
//! A variable is live at a point of the script if its value there may be read later on. Where no
//! variable that holds an element is live, the ids of erased elements can be reused. The sets are
//! computed backwards, from the variables live after a statement to those live before it. For a
//! loop one pass is enough, because what its body reads before setting it does not depend on what
//! follows.

use std::collections::BTreeSet;

use crate::diagram::{Expr, ExprKind};
use crate::resolve::{Statement, StatementKind, Variable};

/// The numbers of variables that hold elements.
pub type Live = BTreeSet<u32>;

/// The variables that are live after a statement, by the way in which it is left.
#[derive(Clone, Debug, Default)]
pub struct Exits {
    /// Continuing with the next statement.
    pub next: Live,
    /// Leaving the innermost loop.
    pub broken: Live,
    /// Continuing at the head of that loop.
    pub continued: Live,
}

impl Exits {
    /// The same exits with other variables live at the next statement.
    pub(super) fn going_on(&self, next: Live) -> Self {
        Self { next, ..self.clone() }
    }

    /// The exits of the body of a loop with these exits and these variables live at its head.
    pub(super) fn of_body(&self, head: Live) -> Self {
        Self { next: head.clone(), broken: self.next.clone(), continued: head }
    }
}

/// The analysis of live variables.
#[derive(Clone, Copy, Debug)]
pub struct Liveness<'p> {
    /// All variables of the script.
    pub variables: &'p [Variable],
}

impl Liveness<'_> {
    /// The variables that are live before each statement of a block.
    pub fn before_each(&self, block: &[Statement], exits: &Exits) -> Vec<Live> {
        let mut next = exits.next.clone();
        let mut before = Vec::new();
        for statement in block.iter().rev() {
            next = self.before(statement, &exits.going_on(next));
            before.push(next.clone());
        }
        before.reverse();
        before
    }

    /// The variables that are live at the head of a loop with this body, where its conditions, if
    /// any, are evaluated.
    pub(super) fn at_head(&self, conditions: &[&Expr], body: &[Statement], exits: &Exits) -> Live {
        let read = self.before_block(body, &Exits::default());
        self.reading(conditions.iter().copied(), union(read, &exits.next))
    }

    fn before_block(&self, block: &[Statement], exits: &Exits) -> Live {
        let mut next = exits.next.clone();
        for statement in block.iter().rev() {
            next = self.before(statement, &exits.going_on(next));
        }
        next
    }

    fn before(&self, statement: &Statement, exits: &Exits) -> Live {
        match &statement.kind {
            StatementKind::Set { variable, value } => {
                let live = without(exits.next.clone(), *variable);
                self.reading([value], live)
            }
            StatementKind::Repeat { count, body } => {
                self.reading([count], self.at_head(&[], body, exits))
            }
            StatementKind::While { condition, body } => self.at_head(&[condition], body, exits),
            StatementKind::For { variable, collection, filter, body, .. } => {
                let filter: Vec<&Expr> = filter.iter().collect();
                let live = self.at_head(&filter, body, exits);
                self.reading(collection.base(), without(live, *variable))
            }
            StatementKind::Drain { variable, collection, key, condition, body } => {
                let asked: Vec<&Expr> = condition.iter().chain([key]).collect();
                let live = self.at_head(&asked, body, exits);
                self.reading(collection.base(), without(live, *variable))
            }
            StatementKind::If { condition, then, otherwise } => {
                let live = self.before_block(then, exits);
                let live = union(live, &self.before_block(otherwise, exits));
                self.reading([condition], live)
            }
            StatementKind::Apply { args, variable, then, otherwise, .. } => {
                let mut live = self.before_block(then, exits);
                if let Some(variable) = variable {
                    live.remove(variable);
                }
                self.reading(args, union(live, &self.before_block(otherwise, exits)))
            }
            StatementKind::Refused { .. } => Live::new(),
            StatementKind::Break => exits.broken.clone(),
            StatementKind::Continue => exits.continued.clone(),
            StatementKind::Return(value) => self.reading(value, Live::new()),
            StatementKind::Write { .. }
            | StatementKind::AssertRefuses { .. }
            | StatementKind::Call { .. }
            | StatementKind::Print(_)
            | StatementKind::Assert { .. }
            | StatementKind::Require { .. }
            | StatementKind::KeepMesh { .. }
            | StatementKind::AssertMesh { .. } => {
                let mut live = exits.next.clone();
                statement.values(&mut |value| self.read(value, &mut live));
                live
            }
        }
    }

    fn reading<'e>(&self, values: impl IntoIterator<Item = &'e Expr>, mut live: Live) -> Live {
        for value in values {
            self.read(value, &mut live);
        }
        live
    }

    fn read(&self, value: &Expr, live: &mut Live) {
        match &value.kind {
            ExprKind::Local(variable) => {
                let known = self.variables.get(*variable as usize);
                if known.is_some_and(|known| known.ty.is_element()) {
                    live.insert(*variable);
                }
            }
            ExprKind::Fold(fold) => {
                // The variable of the aggregate does not exist outside.
                let inner = self.reading(fold.filter.iter().chain([&fold.body]), Live::new());
                live.extend(without(inner, fold.variable));
                if let Some(base) = fold.collection.base() {
                    self.read(base, live);
                }
            }
            ExprKind::Let(variable, value, body) => {
                let inner = self.reading([&**body], Live::new());
                live.extend(without(inner, *variable));
                self.read(value, live);
            }
            _ => value.parts(&mut |part| self.read(part, live)),
        }
    }
}

fn union(mut live: Live, more: &Live) -> Live {
    live.extend(more);
    live
}

fn without(mut live: Live, variable: u32) -> Live {
    live.remove(&variable);
    live
}

/// Whether a statement may call an operation, itself or through a function.
pub(super) fn calls(statement: &Statement) -> bool {
    let mut calls = false;
    statement.each(&mut |statement| {
        calls |= match &statement.kind {
            StatementKind::Apply { .. }
            | StatementKind::AssertRefuses { .. }
            | StatementKind::Call { .. } => true,
            StatementKind::Set { value, .. } | StatementKind::Return(Some(value)) => {
                matches!(value.kind, ExprKind::Invoke(..))
            }
            _ => false,
        };
    });
    calls
}
