//! The walk over a file that finds its names.

use std::collections::HashMap;

use super::symbol::{Mention, Names, Role, Symbol, SymbolId, SymbolKind};
use crate::diagram::Kind;
use crate::resolve::Fields;
use crate::source::Span;
use crate::syntax::tree::{self, Ident, Item};

/// The walk: what is found so far, and what is in scope.
pub(super) struct SymbolCollector<'f> {
    /// The meanings of words after dots, as far as they are known.
    fields: &'f Fields,
    found: Names,
    /// The attributes, which occur only after dots.
    attributes: Vec<SymbolId>,
    /// The indices of the rule, which occur only in subscripts.
    indices: HashMap<String, SymbolId>,
    /// The declarations around the place of the walk, the innermost last.
    scopes: Vec<HashMap<String, SymbolId>>,
    /// The numbers of these scopes.
    open: Vec<usize>,
    /// The number of scopes so far.
    count: usize,
    pub(super) item: Option<usize>,
    pub(super) rule: Option<usize>,
}

impl<'f> SymbolCollector<'f> {
    pub(super) fn new(fields: &'f Fields) -> Self {
        Self {
            fields,
            found: Names::default(),
            attributes: Vec::new(),
            indices: HashMap::new(),
            scopes: Vec::new(),
            open: Vec::new(),
            count: 0,
            item: None,
            rule: None,
        }
    }

    pub(super) fn into_names(self) -> Names {
        self.found
    }

    pub(super) fn file(&mut self, tree: &tree::File) {
        self.enter();
        for item in &tree.items {
            let (name, kind) = match item {
                Item::Op(op) => (&op.name, SymbolKind::Op),
                Item::Script(script) => (&script.name, SymbolKind::Script),
                Item::Fn(function) => (&function.name, SymbolKind::Function),
                Item::Attr(attr) => {
                    self.attribute(&attr.name);
                    continue;
                }
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
            self.forget_indices();
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

    pub(super) fn kind(&self, id: SymbolId) -> SymbolKind {
        self.found.symbols[id.0].kind
    }

    fn attribute(&mut self, name: &Ident) {
        let id = self.add(&name.text, SymbolKind::Attribute, Some(name.span));
        self.attributes.push(id);
        self.mention(name.span, id, Role::Declared);
    }

    /// Records the word after a dot, if it names an attribute. If that is not known, it is taken
    /// for the attribute of that name.
    pub(super) fn field(&mut self, name: &Ident) {
        let is_named = |id: &SymbolId| self.found.symbols[id.0].name == name.text;
        let found = match self.fields.get(&name.span).copied() {
            None => self.attributes.iter().copied().find(is_named),
            Some(None) => None,
            Some(declared) => {
                let is_meant = |id: &SymbolId| self.found.symbols[id.0].definition == declared;
                let known = self.attributes.iter().copied().find(is_meant);
                known.or_else(|| Some(self.attribute_elsewhere(name, declared)))
            }
        };
        if let Some(id) = found {
            self.mention(name.span, id, Role::Read);
        }
    }

    /// Adds an attribute that another file declares.
    fn attribute_elsewhere(&mut self, name: &Ident, declared: Option<Span>) -> SymbolId {
        let (item, rule) = (self.item.take(), self.rule.take());
        let id = self.add(&name.text, SymbolKind::Attribute, declared);
        (self.item, self.rule) = (item, rule);
        self.attributes.push(id);
        id
    }

    /// Records an index. A rule has one symbol for it, whichever of its statements names it.
    pub(super) fn index(&mut self, name: &Ident, role: Role) {
        if let Some(&known) = self.indices.get(&name.text) {
            return self.mention(name.span, known, role);
        }
        let id = self.add(&name.text, SymbolKind::Index, Some(name.span));
        self.indices.insert(name.text.clone(), id);
        self.mention(name.span, id, Role::Declared);
    }

    /// Forgets the indices of the previous rule.
    pub(super) fn forget_indices(&mut self) {
        self.indices.clear();
    }

    /// The item that a word names. Calls refer to items, even if a variable has the same name.
    pub(super) fn find_item(&self, word: &str) -> Option<SymbolId> {
        self.scopes.first()?.get(word).copied()
    }

    /// The innermost declaration of a word.
    pub(super) fn find(&self, word: &str) -> Option<SymbolId> {
        self.scopes.iter().rev().find_map(|scope| scope.get(word).copied())
    }

    pub(super) fn enter(&mut self) {
        self.scopes.push(HashMap::new());
        self.open.push(self.count);
        self.count += 1;
    }

    pub(super) fn leave(&mut self) {
        self.scopes.pop();
        self.open.pop();
    }

    /// Adds a name that is declared here.
    pub(super) fn declare(
        &mut self,
        name: &Ident,
        kind: SymbolKind,
        ty: Option<&Ident>,
    ) -> SymbolId {
        let id = self.bring(&name.text, kind, Some(name.span));
        self.found.symbols[id.0].ty = ty.map(|ty| ty.text.clone());
        self.mention(name.span, id, Role::Declared);
        id
    }

    /// Adds a name to the innermost scope.
    fn bring(&mut self, name: &str, kind: SymbolKind, definition: Option<Span>) -> SymbolId {
        let id = self.add(name, kind, definition);
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(name.to_owned(), id);
        }
        id
    }

    fn add(&mut self, name: &str, kind: SymbolKind, definition: Option<Span>) -> SymbolId {
        let id = SymbolId(self.found.symbols.len());
        self.found.symbols.push(Symbol {
            name: name.to_owned(),
            kind,
            definition,
            ty: None,
            item: self.item,
            rule: self.rule,
            scopes: self.open.clone(),
        });
        id
    }

    pub(super) fn mention(&mut self, span: Span, symbol: SymbolId, role: Role) {
        self.found.mentions.push(Mention { span, symbol, role });
    }

    /// Records a name of a drawing. The first statement that implies a kind determines its kind.
    pub(super) fn element(&mut self, name: &Ident, kind: Option<Kind>, role: Role) {
        let id = match self.find(&name.text) {
            Some(id) if matches!(self.kind(id), SymbolKind::Element(_) | SymbolKind::Parameter) => {
                id
            }
            _ => self.bring(&name.text, SymbolKind::Element(None), None),
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

    /// Makes the place where `new` lists a name its declaration.
    pub(super) fn made_here(&mut self, name: &Ident) {
        if let Some(id) = self.find(&name.text) {
            let symbol = &mut self.found.symbols[id.0];
            let is_first = symbol.rule.is_some() || self.rule == Some(0);
            if is_first && symbol.ty.is_none() && matches!(symbol.kind, SymbolKind::Element(_)) {
                symbol.definition = Some(name.span);
            }
        }
    }

    /// Records a word that is read or written, if it is declared; false if it is not.
    pub(super) fn read(&mut self, name: &Ident, role: Role) -> bool {
        let Some(id) = self.find(&name.text) else { return false };
        self.mention(name.span, id, role);
        true
    }

    /// Records a word that is called and is neither declared here nor part of the language.
    pub(super) fn elsewhere(&mut self, name: &Ident) {
        let (item, rule) = (self.item.take(), self.rule.take());
        let id = self.add(&name.text, SymbolKind::Elsewhere, None);
        if let Some(items) = self.scopes.first_mut() {
            items.insert(name.text.clone(), id);
        }
        (self.item, self.rule) = (item, rule);
        self.mention(name.name_span(), id, Role::Read);
    }
}
