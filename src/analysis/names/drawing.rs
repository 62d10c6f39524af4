//! The names of an op: parameters, the result, and what its rules draw or its steps do.

use super::symbol::{List, Role, SideName, SymbolKind};
use super::walk::SymbolCollector;
use crate::diagram::Kind;
use crate::syntax::tree::{Arrow, Condition, Name, Op, Param, Rule, Side, Spoke, Statement};

/// The kind of element that the name of a type stands for.
fn element_kind(ty: &str) -> Option<Kind> {
    let kinds = [Kind::Vertex, Kind::Halfedge, Kind::Edge, Kind::Face];
    kinds.into_iter().find(|kind| kind.word() == ty)
}

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
        let kind = match element_kind(&param.ty.text) {
            Some(kind) => SymbolKind::Element(Some(kind)),
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
            Statement::Loop(orbit) => {
                self.each(orbit.each.as_ref());
                self.name(&orbit.name, Some(Kind::Face), drawn);
                for item in &orbit.items {
                    self.name(&item.from, Some(Kind::Vertex), drawn);
                    match &item.arrow {
                        Arrow::Halfedge(name) => self.name(name, Some(Kind::Halfedge), drawn),
                        Arrow::Path(Some(name)) => self.name(name, Some(Kind::Path), drawn),
                        Arrow::Path(None) => {}
                    }
                }
                if let Some(end) = &orbit.end {
                    self.name(end, Some(Kind::Vertex), drawn);
                }
            }
            Statement::Edge { name, halfedges, .. } => {
                self.name(name, Some(Kind::Edge), drawn);
                for halfedge in halfedges {
                    self.name(halfedge, Some(Kind::Halfedge), drawn);
                }
            }
            Statement::Vertex(star) => {
                self.each(star.each.as_ref());
                self.name(&star.name, Some(Kind::Vertex), drawn);
                for spoke in &star.spokes {
                    match spoke {
                        Spoke::Halfedge(name) => self.name(name, Some(Kind::Halfedge), drawn),
                        Spoke::Fan(Some(name), _) => self.name(name, Some(Kind::Fan), drawn),
                        Spoke::Fan(None, _) => {}
                    }
                }
            }
            Statement::New(names, _) => self.list(names, List::New),
            Statement::Erase(names, _) => self.list(names, List::Erase),
            Statement::Keep(names, _) => self.list(names, List::Keep),
            Statement::Assign { .. } | Statement::Broken(_) => {}
        }
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
