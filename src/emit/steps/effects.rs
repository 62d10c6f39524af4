//! Effects of the operations and functions of a program on the mesh, by themselves or through
//! others.

use std::collections::BTreeSet;

use super::super::selection::Selection;
use crate::diagram::{Access, Expr, ExprKind, Kind, Type};
use crate::resolve::{Block, Statement, StatementKind};

/// The effects of an operation or function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Effects {
    /// True if it writes to the mesh.
    pub changes: bool,
    /// True if it may stop before its end, and what was done is to be undone.
    pub refuses: bool,
    /// The kinds of elements that it may erase, by their types' words.
    pub erases: BTreeSet<&'static str>,
    /// The attributes that it reads or writes.
    pub attributes: BTreeSet<u32>,
    /// The operations that it calls.
    pub ops: BTreeSet<usize>,
    /// The functions that it calls.
    pub functions: BTreeSet<u32>,
}

/// The effects of all operations and functions of a program.
#[derive(Debug, Default)]
pub(super) struct AllEffects {
    pub ops: Vec<Effects>,
    pub functions: Vec<Effects>,
}

impl AllEffects {
    /// Finds out what everything does.
    pub fn of(selection: &Selection<'_>) -> Self {
        let program = selection.program;
        let mut all = Self::default();
        let count = program.ops.len().max(selection.proved.len());
        for op in 0..count {
            all.ops.push(match selection.steps(op) {
                Some(steps) => {
                    let mut effects = Effects::of_block(&steps.body.block);
                    let asked = steps.requires.iter().map(|require| &require.condition);
                    asked.for_each(|condition| effects.see(condition));
                    effects
                }
                None => selection.drawn(op).map_or_else(Effects::default, |proved| {
                    let rules = proved.op().rules.iter();
                    let erased = rules.flat_map(|rule| {
                        let erased = rule.erased.iter();
                        erased.map(|erased| rule.kind(erased.name))
                    });
                    Effects {
                        changes: true,
                        erases: erased.map(Kind::word).collect(),
                        ..Effects::default()
                    }
                }),
            });
        }
        for function in &program.functions {
            let block = function.body.as_ref().map(|body| &body.block);
            all.functions.push(block.map_or_else(Effects::default, Effects::of_block));
        }
        while all.spread() {}
        all
    }

    /// Hands on what is done by what is called; tells whether that was something new.
    fn spread(&mut self) -> bool {
        let mut changed = false;
        for at in 0..self.ops.len() + self.functions.len() {
            let functions = at.checked_sub(self.ops.len());
            let mut effects = match functions {
                Some(at) => self.functions[at].clone(),
                None => self.ops[at].clone(),
            };
            for &op in &effects.ops.clone() {
                if let Some(called) = self.ops.get(op) {
                    effects.changes = true;
                    effects.erases.extend(&called.erases);
                }
            }
            for &function in &effects.functions.clone() {
                if let Some(called) = self.functions.get(function as usize) {
                    effects.changes |= called.changes;
                    effects.refuses |= called.refuses;
                    effects.erases.extend(&called.erases);
                    effects.attributes.extend(&called.attributes);
                }
            }
            let known = match functions {
                Some(at) => &mut self.functions[at],
                None => &mut self.ops[at],
            };
            changed |= *known != effects;
            *known = effects;
        }
        changed
    }

    /// The effects of a function.
    pub fn function(&self, number: u32) -> Option<&Effects> {
        self.functions.get(number as usize)
    }

    /// True if statements may erase elements of a type.
    pub fn erases(&self, block: &Block, ty: Type) -> bool {
        let effects = Effects::of_block(block);
        let ops = effects.ops.iter().filter_map(|&op| self.ops.get(op));
        let functions = effects.functions.iter();
        let functions = functions.filter_map(|&function| self.function(function));
        ops.chain(functions).any(|called| called.erases.contains(ty.word()))
    }
}

impl Effects {
    /// The effects of statements by themselves.
    fn of_block(block: &Block) -> Self {
        let mut effects = Self::default();
        block.iter().for_each(|one| one.each(&mut |statement| effects.note(statement)));
        effects
    }

    fn note(&mut self, statement: &Statement) {
        statement.values(&mut |value| self.see(value));
        match &statement.kind {
            StatementKind::Write { attribute, .. } => {
                self.changes = true;
                match attribute {
                    // One that is not finite is refused.
                    Access::Position => self.refuses = true,
                    Access::Declared(number) => _ = self.attributes.insert(*number),
                }
            }
            StatementKind::Apply { op, must, .. } => {
                self.ops.insert(*op);
                self.refuses |= must;
            }
            StatementKind::IfApply { op, .. } => _ = self.ops.insert(*op),
            StatementKind::Call { function, .. } => _ = self.functions.insert(*function),
            StatementKind::Refused { .. } | StatementKind::Require { .. } => self.refuses = true,
            _ => {}
        }
    }

    fn see(&mut self, value: &Expr) {
        value.each(&mut |part| match &part.kind {
            ExprKind::Invoke(function, _) => _ = self.functions.insert(*function),
            ExprKind::Read(Access::Declared(number), _) => _ = self.attributes.insert(*number),
            _ => {}
        });
    }
}
