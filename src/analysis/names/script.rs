//! The names of scripts, functions, tests and steps.

use super::symbol::{Role, SymbolKind};
use super::walk::SymbolCollector;
use crate::syntax::tree::{Action, ActionKind, Block, ExprKind, Param};

impl SymbolCollector<'_> {
    /// Collects the names of parameters, and of the body in their scope.
    pub(super) fn routine(&mut self, params: &[Param], body: &Block) {
        self.enter();
        for param in params {
            if let Some(default) = &param.default {
                self.value(default);
            }
            self.declare(&param.name.ident, SymbolKind::Parameter, Some(&param.ty));
        }
        self.block(body);
        self.leave();
    }

    /// Collects the names of a block, which is a scope of its own.
    pub(super) fn block(&mut self, block: &Block) {
        self.enter();
        for action in &block.statements {
            self.action(action);
        }
        self.leave();
    }

    fn action(&mut self, action: &Action) {
        match &action.kind {
            ActionKind::Let { name, ty, value, .. } => {
                self.value(value);
                self.declare(name, SymbolKind::Variable, ty.as_ref());
            }
            ActionKind::Assign { target, value } => {
                self.value(value);
                match &target.kind {
                    ExprKind::Name(name) => {
                        self.read(&name.ident, Role::Written);
                    }
                    _ => self.value(target),
                }
            }
            ActionKind::For { variable, sequence, filter, body, .. }
            | ActionKind::Update { variable, sequence, filter, body } => {
                self.sequence(sequence);
                self.enter();
                self.declare(variable, SymbolKind::Variable, None);
                filter.iter().for_each(|filter| self.value(filter));
                self.block(body);
                self.leave();
            }
            ActionKind::Drain { variable, sequence, key, condition, body } => {
                self.sequence(sequence);
                self.enter();
                self.declare(variable, SymbolKind::Variable, None);
                self.value(key);
                condition.iter().for_each(|condition| self.value(condition));
                self.block(body);
                self.leave();
            }
            ActionKind::If { binding, condition, then, otherwise } => {
                self.value(condition);
                self.enter();
                if let Some(binding) = binding {
                    self.declare(binding, SymbolKind::Variable, None);
                }
                self.block(then);
                self.leave();
                otherwise.iter().for_each(|block| self.block(block));
            }
            _ => action.each_part(&mut |part| self.part(part)),
        }
    }
}
