//! The walk over a file that finds its names.

use std::collections::HashMap;

use super::symbol::{Mention, Names, Role, Symbol, SymbolId, SymbolKind};
use crate::diagram::Kind;
use crate::source::Span;
use crate::syntax::tree::{self, Ident, Item};

/// The walk: what is found so far, and what is in scope.
#[derive(Default)]
pub(super) struct SymbolCollector {
    found: Names,
    /// The declarations around the place of the walk, the innermost last.
    scopes: Vec<HashMap<String, SymbolId>>,
    pub(super) item: Option<usize>,
    pub(super) rule: Option<usize>,
}

impl SymbolCollector {
    pub(super) fn into_names(self) -> Names {
        self.found
    }

    pub(super) fn file(&mut self, tree: &tree::File) {
        self.scopes.push(HashMap::new());
        for item in &tree.items {
            let (name, kind) = match item {
                Item::Op(op) => (&op.name, SymbolKind::Op),
                Item::Script(script) => (&script.name, SymbolKind::Script),
                Item::Fn(function) => (&function.name, SymbolKind::Function),
                Item::Attr(attr) => (&attr.name, SymbolKind::Attribute),
                Item::Use(_) | Item::Test(_) | Item::Broken(_) => continue,
            };
            let known = self.find(&name.text);
            match known {
                Some(first) => self.mention(name.span, first, Role::Declared),
                None => {
                    self.declare(name, kind, None);
                }
            }
        }
        for (at, item) in tree.items.iter().enumerate() {
            self.item = Some(at);
            match item {
                Item::Op(op) => self.op(op),
                Item::Script(script) => self.routine(&script.params, &script.body),
                Item::Fn(function) => self.routine(&function.params, &function.body),
                Item::Test(test) => self.routine(&[], &test.body),
                Item::Attr(attr) => attr.default.iter().for_each(|value| self.value(value)),
                Item::Use(_) | Item::Broken(_) => {}
            }
        }
    }

    /// The element or run that a name stands for.
    pub(super) fn kind(&self, id: SymbolId) -> SymbolKind {
        self.found.symbols[id.0].kind
    }

    /// A scope for the index of one statement.
    pub(super) fn enter_index(&mut self) {
        self.enter();
    }

    /// Leaves the scope of a statement: its elements belong to the rule, the index goes.
    pub(super) fn leave_index(&mut self) {
        let Some(inner) = self.scopes.pop() else {
            return;
        };
        if let Some(rule) = self.scopes.last_mut() {
            let symbols = &self.found.symbols;
            let stays = |id: &SymbolId| symbols[id.0].kind != SymbolKind::Index;
            rule.extend(inner.into_iter().filter(|(_, id)| stays(id)));
        }
    }

    /// The index of a family.
    pub(super) fn declare_index(&mut self, name: &Ident) {
        self.declare(name, SymbolKind::Index, None);
    }

    /// The item of a word: calls mean items, whatever variables are called.
    pub(super) fn find_item(&self, word: &str) -> Option<SymbolId> {
        self.scopes.first()?.get(word).copied()
    }

    /// The innermost declaration of a word.
    pub(super) fn find(&self, word: &str) -> Option<SymbolId> {
        self.scopes.iter().rev().find_map(|scope| scope.get(word).copied())
    }

    pub(super) fn enter(&mut self) {
        self.scopes.push(HashMap::new());
    }

    pub(super) fn leave(&mut self) {
        self.scopes.pop();
    }

    /// A new name, declared here.
    pub(super) fn declare(
        &mut self,
        name: &Ident,
        kind: SymbolKind,
        ty: Option<&Ident>,
    ) -> SymbolId {
        let id = self.add(&name.text, kind, Some(name.span));
        self.found.symbols[id.0].ty = ty.map(|ty| ty.text.clone());
        self.mention(name.span, id, Role::Declared);
        id
    }

    /// A new name in the innermost scope.
    fn add(&mut self, name: &str, kind: SymbolKind, definition: Option<Span>) -> SymbolId {
        let id = SymbolId(self.found.symbols.len());
        self.found.symbols.push(Symbol {
            name: name.to_owned(),
            kind,
            definition,
            ty: None,
            item: self.item,
            rule: self.rule,
        });
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(name.to_owned(), id);
        }
        id
    }

    pub(super) fn mention(&mut self, span: Span, symbol: SymbolId, role: Role) {
        self.found.mentions.push(Mention { span, symbol, role });
    }

    /// A name of a drawing; the first place that gives it a kind does.
    pub(super) fn element(&mut self, name: &Ident, kind: Option<Kind>, role: Role) {
        let id = match self.find(&name.text) {
            Some(id) if self.is_drawable(id) => id,
            _ => self.add(&name.text, SymbolKind::Element(None), None),
        };
        let symbol = &mut self.found.symbols[id.0];
        if symbol.kind == SymbolKind::Element(None) {
            symbol.kind = SymbolKind::Element(kind);
        }
        if role != Role::Returned {
            symbol.definition.get_or_insert(name.span);
        }
        self.mention(name.span, id, role);
    }

    fn is_drawable(&self, id: SymbolId) -> bool {
        let kind = self.kind(id);
        matches!(kind, SymbolKind::Element(_) | SymbolKind::Parameter)
    }

    /// The place that makes a name counts as its declaration.
    pub(super) fn made_here(&mut self, name: &Ident) {
        if let Some(id) = self.find(&name.text) {
            let symbol = &mut self.found.symbols[id.0];
            let is_first = symbol.rule.is_some() || self.rule == Some(0);
            if is_first && symbol.ty.is_none() && matches!(symbol.kind, SymbolKind::Element(_)) {
                symbol.definition = Some(name.span);
            }
        }
    }

    /// A word that is read or called, if it is declared.
    pub(super) fn read(&mut self, name: &Ident, role: Role) -> bool {
        let Some(id) = self.find(&name.text) else {
            return false;
        };
        self.mention(name.span, id, role);
        true
    }

    /// A word that is called, and neither declared here nor part of the language.
    pub(super) fn elsewhere(&mut self, name: &Ident) {
        let (item, rule) = (self.item.take(), self.rule.take());
        let innermost = self.scopes.split_off(1.min(self.scopes.len()));
        let id = self.add(&name.text, SymbolKind::Elsewhere, None);
        self.scopes.extend(innermost);
        (self.item, self.rule) = (item, rule);
        self.mention(name.span, id, Role::Read);
    }
}
