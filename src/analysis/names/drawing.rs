//! The names of an op: parameters, the result, and what its rules draw or its steps do.

use super::symbol::{List, Role, SideName, SymbolKind};
use super::walk::SymbolCollector;
use crate::diagram::Kind;
use crate::mesh::ElementKind;
use crate::resolve::drawn_names;
use crate::syntax::tree::{Condition, Name, Op, Param, Rule, Side, Statement};

impl SymbolCollector<'_> {
    pub(super) fn op(&mut self, op: &Op) {
        self.enter();
        for param in &op.params {
            self.param(param);
        }
        if let Some(result) = op.result.as_ref().filter(|_| op.steps.is_none()) {
            // Its kind follows from the rules.
            self.element(result, None, Role::Returned);
        }
        for (at, rule) in op.rules.iter().enumerate() {
            self.rule = Some(at);
            self.rule(rule);
            self.rule = None;
        }
        if let Some(steps) = &op.steps {
            self.conditions(&steps.conditions);
            self.block(&steps.body);
        }
        self.leave();
    }

    fn conditions(&mut self, conditions: &[Condition]) {
        for condition in conditions {
            match condition {
                Condition::Require { condition, .. } => self.value(condition),
                Condition::Alias { names, .. } => self.list(names, List::Alias),
                Condition::Guard { .. } => {}
            }
        }
    }

    fn param(&mut self, param: &Param) {
        if let Some(default) = &param.default {
            self.value(default);
        }
        let kind = match ElementKind::named(&param.ty.text) {
            Some(kind) => SymbolKind::Element(Some(kind.into())),
            None => SymbolKind::Parameter,
        };
        self.declare(&param.name.ident, kind, Some(&param.ty));
    }

    fn rule(&mut self, rule: &Rule) {
        self.enter();
        self.forget_indices();
        if let Some(name) = &rule.name {
            self.declare(name, SymbolKind::Rule, None);
        }
        // A rule may have the same name as one of its elements.
        self.enter();
        if let Some(before) = &rule.before {
            self.side(before, SideName::Before);
        }
        if let Some(after) = &rule.after {
            self.side(after, SideName::After);
        }
        self.conditions(&rule.conditions);
        for side in rule.before.iter().chain(&rule.after) {
            self.assignments(side);
        }
        self.leave();
        self.leave();
    }

    fn side(&mut self, side: &Side, which: SideName) {
        for statement in &side.statements {
            self.statement(statement, which);
        }
        for statement in &side.statements {
            if let Statement::New(names, _) = statement {
                names.iter().for_each(|name| self.made_here(&name.ident));
            }
        }
    }

    fn statement(&mut self, statement: &Statement, side: SideName) {
        let drawn = Role::Drawn(side);
        match statement {
            Statement::Loop(orbit) => self.each(orbit.each.as_ref()),
            Statement::Vertex(star) => self.each(star.each.as_ref()),
            Statement::New(names, _) => self.list(names, List::New),
            Statement::Erase(names, _) => self.list(names, List::Erase),
            Statement::Keep(names, _) => self.list(names, List::Keep),
            Statement::Edge { .. } | Statement::Assign { .. } | Statement::Broken(_) => {}
        }
        drawn_names(statement).for_each(|(name, kind)| self.name(name, Some(kind), drawn));
    }

    fn list(&mut self, names: &[Name], list: List) {
        for name in names {
            self.name(name, None, Role::Listed(list));
        }
    }

    fn name(&mut self, name: &Name, kind: Option<Kind>, role: Role) {
        self.element(&name.ident, kind, role);
        self.subscript(name);
    }

    fn assignments(&mut self, side: &Side) {
        for statement in &side.statements {
            if let Statement::Assign { target, attribute, value, .. } = statement {
                self.name(target, None, Role::Written);
                self.field(attribute);
                self.value(value);
            }
        }
    }
}
