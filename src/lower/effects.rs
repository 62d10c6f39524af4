//! Effects of the operations and functions of a program on the mesh, direct or through what they
//! call.

use std::collections::{BTreeMap, BTreeSet};

use crate::check::Proved;
use crate::diagram::{Access, Expr, ExprKind, Kind, LoopKind, Type};
use crate::resolve::{Program, Statement, StatementKind, Steps};
use crate::source::Span;

/// The effects of an operation or function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// True if it writes to the mesh.
    pub changes: bool,
    /// True if it may stop before its end, so that its changes have to be undone.
    pub refuses: bool,
    /// The kinds of elements that it may erase, by the words of their types; a face that becomes a
    /// hole counts as erased.
    pub erases: BTreeSet<&'static str>,
    /// The attributes that it reads or writes.
    pub attributes: BTreeSet<u32>,
    /// The operations that it calls or asks about, each with the first place where it does.
    pub ops: BTreeMap<usize, Span>,
    /// Those that it calls.
    pub calls: BTreeSet<usize>,
    /// The functions that it calls.
    pub functions: BTreeSet<u32>,
}

/// The effects of all operations and functions of a program, with those of what they call.
#[derive(Debug, Default)]
pub struct AllEffects {
    pub ops: Vec<Effects>,
    pub functions: Vec<Effects>,
}

impl AllEffects {
    /// The effects of all parts of a program; `proved` holds, by number, the proofs of the drawn
    /// operations.
    pub fn of(program: &Program, proved: &[Option<Proved>]) -> Self {
        let mut all = Self::default();
        for op in 0..program.ops.len().max(proved.len()) {
            let steps = program.ops.get(op).and_then(|op| op.steps.as_ref());
            all.ops.push(match steps {
                Some(steps) => Effects::of_steps(steps),
                None => proved[op].as_ref().map_or_else(Effects::default, |proved| {
                    let erased = proved.op().rules.iter().flat_map(|rule| {
                        let erased = rule.erased.iter();
                        erased.map(|erased| rule.kind(erased.name))
                    });
                    let turned = proved.proofs().iter().flat_map(|proof| &proof.facts().turned);
                    let opened = turned.filter(|turned| turned.to == LoopKind::Hole);
                    let erases = erased.chain(opened.map(|_| Kind::Face)).map(Kind::word);
                    Effects { changes: true, erases: erases.collect(), ..Effects::default() }
                }),
            });
        }
        for function in &program.functions {
            let body = function.body.as_ref();
            all.functions.push(body.map(|body| Effects::of_block(&body.block)).unwrap_or_default());
        }
        while all.spread() {}
        all
    }

    /// Passes the effects of what is called on to the callers; returns whether anything changed.
    fn spread(&mut self) -> bool {
        let mut changed = false;
        for at in 0..self.ops.len() + self.functions.len() {
            let functions = at.checked_sub(self.ops.len());
            let mut effects = match functions {
                Some(at) => self.functions[at].clone(),
                None => self.ops[at].clone(),
            };
            for op in effects.calls.clone() {
                if let Some(called) = self.ops.get(op) {
                    effects.changes = true;
                    effects.erases.extend(&called.erases);
                }
            }
            for function in effects.functions.clone() {
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

    /// The operations that the steps of some call, directly or not.
    pub fn called(&self, ops: &[usize]) -> BTreeSet<usize> {
        let (mut called, mut seen) = (BTreeSet::new(), BTreeSet::new());
        let mut open: Vec<_> = ops.iter().filter_map(|&op| self.ops.get(op)).collect();
        while let Some(effects) = open.pop() {
            let ops = effects.calls.iter().filter(|op| called.insert(**op));
            open.extend(ops.filter_map(|&op| self.ops.get(op)));
            let functions = effects.functions.iter().filter(|function| seen.insert(**function));
            open.extend(functions.filter_map(|&function| self.function(function)));
        }
        called
    }

    pub fn function(&self, number: u32) -> Option<&Effects> {
        self.functions.get(number as usize)
    }

    /// True if statements may erase elements of a type.
    pub fn erases(&self, block: &[Statement], ty: Type) -> bool {
        let effects = Effects::of_block(block);
        let ops = effects.calls.iter().filter_map(|&op| self.ops.get(op));
        let functions = effects.functions.iter().filter_map(|&function| self.function(function));
        ops.chain(functions).any(|called| called.erases.contains(ty.word()))
    }
}

impl Effects {
    /// The effects of statements, without those of what they call.
    pub fn of_block(block: &[Statement]) -> Self {
        let mut effects = Self::default();
        block.iter().for_each(|one| one.each(&mut |statement| effects.note(statement)));
        effects
    }

    /// The effects of an operation in steps, without those of what it calls.
    pub fn of_steps(steps: &Steps) -> Self {
        let mut effects = Self::of_block(&steps.body.block);
        steps.requires.iter().for_each(|require| effects.see(&require.condition));
        effects
    }

    /// Whether statements with these effects may call an operation; `functions` tells, by number,
    /// whether each function may.
    pub fn calls_ops(&self, functions: &[bool]) -> bool {
        let is_calling = |&function: &u32| functions.get(function as usize).is_none_or(|one| *one);
        !self.calls.is_empty() || self.functions.iter().any(is_calling)
    }

    fn note(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Write { attribute, .. } => {
                self.changes = true;
                match attribute {
                    // A position that is not finite is refused.
                    Access::Position => self.refuses = true,
                    Access::Declared(number) => _ = self.attributes.insert(*number),
                }
            }
            StatementKind::Apply { op, .. } | StatementKind::AssertRefuses { op, .. } => {
                self.ops.entry(*op).or_insert(statement.span);
                self.calls.insert(*op);
            }
            StatementKind::Call { function, .. } => _ = self.functions.insert(*function),
            StatementKind::Refused { .. } | StatementKind::Require { .. } => self.refuses = true,
            _ => {}
        }
        statement.values(&mut |value| self.see(value));
    }

    /// Adds the effects of a value.
    pub fn see(&mut self, value: &Expr) {
        value.each(&mut |part| match &part.kind {
            ExprKind::Try(op, _) => _ = self.ops.entry(*op as usize).or_insert(part.span),
            ExprKind::Invoke(function, _) => _ = self.functions.insert(*function),
            ExprKind::Read(Access::Declared(number), _) => _ = self.attributes.insert(*number),
            _ => {}
        });
    }
}
