//! The names of expressions and sequences, and the indices of families.

use super::symbol::{Role, SymbolKind};
use super::walk::SymbolCollector;
use crate::resolve::{is_function, sequence_words};
use crate::syntax::Part;
use crate::syntax::tree::{Expr, ExprKind, Ident, Name};

impl SymbolCollector<'_> {
    /// Collects all names of an expression.
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
                match function.text.as_str() {
                    "count" | "shuffle" => args.iter().for_each(|arg| self.sequence(arg)),
                    _ => args.iter().for_each(|arg| self.value(arg)),
                }
            }
            ExprKind::Aggregate { function, body, variable, sequence, filter } => {
                self.called(function);
                self.sequence(sequence);
                self.enter();
                self.declare(variable, SymbolKind::Variable, None);
                self.value(body);
                filter.iter().for_each(|filter| self.value(filter));
                self.leave();
            }
            _ => value.each_part(&mut |part| self.part(part)),
        }
    }

    /// Collects all names of a value, or of a block.
    pub(super) fn part(&mut self, part: Part) {
        match part {
            Part::Expr(value) => self.value(value),
            Part::Block(block) => self.block(block),
        }
    }

    fn called(&mut self, function: &Ident) {
        let declared = self.find_item(&function.text);
        match declared {
            Some(id) => self.mention(function.name_span(), id, Role::Read),
            None if is_function(&function.text) => {}
            None => self.elsewhere(function),
        }
    }

    /// Collects the index in a subscript.
    pub(super) fn subscript(&mut self, name: &Name) {
        if let Some(variable) = name.index.as_ref().and_then(|at| at.variable.as_ref()) {
            self.index(variable, Role::Read);
        }
    }

    /// Collects the index that `each` declares.
    pub(super) fn each(&mut self, each: Option<&Ident>) {
        if let Some(each) = each {
            self.index(each, Role::Declared);
        }
    }

    /// Collects all names of a sequence. A word for a sequence of the whole mesh always means that,
    /// even if something else has the same name.
    pub(super) fn sequence(&mut self, sequence: &Expr) {
        match &sequence.kind {
            ExprKind::Name(name) if sequence_words().any(|word| word == name.ident.text) => {}
            _ => self.value(sequence),
        }
    }
}
