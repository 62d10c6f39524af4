//! Side effects of functions, determined before any function is resolved.
//!
//! An op may call a function only if it changes nothing, prints nothing, does not look at the whole
//! mesh, asks no op and draws no random number. A function has its own effects and those of the
//! functions that it calls; both are read off the tree.

use crate::diagram::Type;
use crate::source::Span;
use crate::syntax::Part;
use crate::syntax::tree::{self, Action, ActionKind, ExprKind, Item};

use super::builtin::SHUFFLE;
use super::declared::{Declared, What};
use super::fields::fields_of;
use super::sequence_names::WHOLE_MESH;
use super::signature::Effects;
use super::unit::Unit;

/// The effects of a function, from its tree.
#[derive(Clone, Debug, Default)]
pub(super) struct TreeEffects {
    pub(super) effects: Effects,
    /// The functions that it calls, by number.
    pub(super) calls: Vec<usize>,
    /// True if it calls or asks an op, itself or through other functions.
    pub(super) calls_ops: bool,
    /// The calls of ops that are only asked (`can`, `why`).
    asked: Vec<Span>,
}

/// The effects of all functions of a program, by number.
pub(super) fn all_effects(units: &[Unit], declared: &[Declared]) -> Vec<TreeEffects> {
    let mut all = Vec::new();
    for (unit, declared) in units.iter().zip(declared) {
        for item in &unit.tree.items {
            if let Item::Fn(function) = item {
                all.push(own_effects(Part::Block(&function.body), declared));
            }
        }
    }
    let mut changed = true;
    while changed {
        changed = false;
        for at in 0..all.len() {
            let mut found = std::mem::take(&mut all[at]);
            for called in found.calls.iter().filter_map(|&called| all.get(called)) {
                changed |= found.effects.take_in(called.effects);
                changed |= called.calls_ops && !found.calls_ops;
                found.calls_ops |= called.calls_ops;
            }
            all[at] = found;
        }
    }
    all
}

/// The effects of an expression, with those of the functions that it calls.
pub(super) fn effects_of(expr: &tree::Expr, declared: &Declared) -> Effects {
    let mut effects = own_effects(Part::Expr(expr), declared).effects;
    Part::Expr(expr).each_within(|part| {
        if let Part::Expr(tree::Expr { kind: ExprKind::Call { function, .. }, .. }) = part
            && let Some(called) = declared.function(&function.text)
        {
            effects.take_in(called.effects);
        }
    });
    effects
}

fn own_effects(part: Part, declared: &Declared) -> TreeEffects {
    let mut found = TreeEffects::default();
    part.each_within(|part| match part {
        Part::Expr(expr) => found.of_expr(expr, declared),
        Part::Block(block) => {
            for action in &block.statements {
                found.of_action(action, declared);
            }
        }
    });
    found
}

impl TreeEffects {
    fn of_expr(&mut self, expr: &tree::Expr, declared: &Declared) {
        match &expr.kind {
            ExprKind::Asked(_, call) => {
                self.calls_ops = true;
                self.asked.push(call.span);
                self.effects.asks.get_or_insert(expr.span);
            }
            ExprKind::Call { .. } if self.asked.contains(&expr.span) => {}
            ExprKind::Call { function, args } => {
                match declared.called(&function.text).map(|n| (n.what, n.number)) {
                    Some((What::Script, _)) => {
                        self.calls_ops = true;
                        self.effects.take_in(Effects::all(expr.span));
                    }
                    Some((What::Op, _)) => {
                        self.calls_ops = true;
                        self.effects.changes.get_or_insert(expr.span);
                    }
                    Some((What::Function, number)) => self.calls.push(number),
                    None if matches!(function.text.as_str(), "random" | SHUFFLE) => {
                        self.effects.draws.get_or_insert(expr.span);
                        args.iter().for_each(|arg| self.of_sequence(arg));
                    }
                    None if function.text == "print" => {
                        self.effects.prints.get_or_insert(expr.span);
                    }
                    None => args.iter().for_each(|arg| self.of_sequence(arg)),
                }
            }
            ExprKind::Aggregate { sequence, .. } => self.of_sequence(sequence),
            _ => {}
        }
    }

    fn of_action(&mut self, action: &Action, declared: &Declared) {
        match &action.kind {
            ActionKind::Assign { target, .. } if !is_of_variable(target, declared) => {
                self.effects.changes.get_or_insert(action.span);
            }
            ActionKind::For { sequence, .. }
            | ActionKind::Update { sequence, .. }
            | ActionKind::Drain { sequence, .. } => self.of_sequence(sequence),
            ActionKind::Print(_) => {
                self.effects.prints.get_or_insert(action.span);
            }
            _ => {}
        }
    }

    fn of_sequence(&mut self, sequence: &tree::Expr) {
        let word = sequence.plain_name().map(|name| name.text.as_str());
        if WHOLE_MESH.iter().any(|(known, _)| Some(*known) == word) {
            self.effects.looks.get_or_insert(sequence.span);
        }
    }
}

/// Whether what is assigned is a variable or a component of one: `p`, `p.x`, `m.x.y`.
fn is_of_variable(target: &tree::Expr, declared: &Declared) -> bool {
    match &target.kind {
        ExprKind::Field(base, field) => {
            let word = field.text.as_str();
            let is_component = fields_of(Type::Mat4).iter().any(|(known, _)| *known == word);
            is_component && declared.element_with(word).is_none() && is_of_variable(base, declared)
        }
        _ => true,
    }
}
