//! The names of expressions, and the indices of families.

use super::symbol::{Role, SymbolId, SymbolKind};
use super::walk::SymbolCollector;
use crate::resolve::is_function;
use crate::syntax::Part;
use crate::syntax::tree::{Expr, ExprKind, Ident, Name};

impl SymbolCollector {
    /// True if a name is that of an attribute.
    pub(super) fn is_attribute(&self, id: SymbolId) -> bool {
        self.kind(id) == SymbolKind::Attribute
    }

    /// All names of an expression.
    pub(super) fn value(&mut self, value: &Expr) {
        match &value.kind {
            ExprKind::Name(name) => {
                self.read(&name.ident, Role::Read);
                self.subscript(name);
            }
            ExprKind::Field(base, field) => {
                self.value(base);
                self.field(field);
            }
            ExprKind::Call { function, args } => {
                self.called(function);
                args.iter().for_each(|arg| self.value(arg));
            }
            ExprKind::Aggregate { function, body, variable, sequence, filter } => {
                self.called(function);
                self.value(sequence);
                self.enter();
                self.declare(variable, SymbolKind::Variable, None);
                self.value(body);
                filter.iter().for_each(|filter| self.value(filter));
                self.leave();
            }
            _ => value.each_part(&mut |part| self.part(part)),
        }
    }

    /// All names of a value, or of a block.
    pub(super) fn part(&mut self, part: Part) {
        match part {
            Part::Expr(value) => self.value(value),
            Part::Block(block) => self.block(block),
        }
    }

    fn called(&mut self, function: &Ident) {
        let declared = self.find_item(&function.text);
        match declared {
            Some(id) => self.mention(function.span, id, Role::Read),
            None if is_function(&function.text) => {}
            None => self.elsewhere(function),
        }
    }

    /// The index in a subscript; one that is not declared by `each` belongs to the statement.
    pub(super) fn subscript(&mut self, name: &Name) {
        let variable = name.index.as_ref().and_then(|at| at.variable.as_ref());
        let Some(variable) = variable else { return };
        match self.find(&variable.text) {
            Some(id) if self.kind(id) == SymbolKind::Index => {
                self.mention(variable.span, id, Role::Read);
            }
            _ => {
                self.declare_index(variable);
            }
        }
    }

    /// The index that `each` declares.
    pub(super) fn index(&mut self, each: Option<&Ident>) {
        if let Some(each) = each {
            self.declare_index(each);
        }
    }
}
