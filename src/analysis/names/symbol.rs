//! A name, its mentions, and how to find them.

use super::walk::SymbolCollector;
use crate::diagram::Kind;
use crate::resolve::Fields;
use crate::source::Span;
use crate::syntax::tree;

/// A name, by its index in [`Names::symbols`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SymbolId(pub usize);

/// The kind of thing that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    Op,
    Rule,
    Script,
    Function,
    Attribute,
    /// A name of a drawing; its kind if a statement gives it one.
    Element(Option<Kind>),
    /// A parameter that is a value.
    Parameter,
    /// The index of a family.
    Index,
    /// A variable of a block or an aggregate.
    Variable,
    /// Something called that neither this file nor the language declares.
    Elsewhere,
}

/// A name.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    /// The word.
    pub name: String,
    pub kind: SymbolKind,
    /// The place of its declaration; for a name of a drawing, where it is first drawn or made.
    pub definition: Option<Span>,
    /// The type it is declared with, as written.
    pub ty: Option<String>,
    /// The item it belongs to, by its index in the file; `None` for the items themselves.
    pub item: Option<usize>,
    /// The rule of the op it belongs to, if only to one.
    pub rule: Option<usize>,
    /// The numbers of the scopes that it is declared in, the innermost last.
    pub(super) scopes: Vec<usize>,
}

impl Symbol {
    /// True if both are in scope somewhere, so that they should not have the same name.
    pub fn meets(&self, other: &Self) -> bool {
        if self.item.is_none() || other.item.is_none() {
            // Attributes occur only after dots.
            let is_attribute = |symbol: &Self| symbol.kind == SymbolKind::Attribute;
            let is_item = self.item.is_none() && other.item.is_none();
            return is_item && !is_attribute(self) && !is_attribute(other);
        }
        let sees = |inner: &Self, outer: &Self| {
            outer.scopes.last().is_some_and(|scope| inner.scopes.contains(scope))
        };
        sees(self, other) || sees(other, self)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SideName {
    /// `before`
    Before,
    /// `after`
    After,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum List {
    /// `new`
    New,
    /// `erase`
    Erase,
    /// `keep`
    Keep,
    /// `alias`
    Alias,
}

/// The role of a mention of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    Declared,
    Drawn(SideName),
    Listed(List),
    Returned,
    /// It is assigned to.
    Written,
    /// It is read, or called.
    Read,
}

/// One place that mentions a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mention {
    /// The word.
    pub span: Span,
    pub symbol: SymbolId,
    pub role: Role,
}

/// All names of a file.
#[derive(Clone, Debug, Default)]
pub struct Names {
    pub(super) symbols: Vec<Symbol>,
    pub(super) mentions: Vec<Mention>,
    /// The mentions of each symbol, by their indices.
    of_symbol: Vec<Vec<usize>>,
}

impl Names {
    /// Collects the names of a tree; `fields` are the known meanings of the words after its dots.
    pub fn of(tree: &tree::File, fields: &Fields) -> Self {
        let mut walk = SymbolCollector::new(fields);
        walk.file(tree);
        let mut names = walk.into_names();
        names.mentions.sort_by_key(|mention| mention.span);
        names.of_symbol = vec![Vec::new(); names.symbols.len()];
        for (at, mention) in names.mentions.iter().enumerate() {
            names.of_symbol[mention.symbol.0].push(at);
        }
        names
    }

    pub fn symbol(&self, id: SymbolId) -> &Symbol {
        &self.symbols[id.0]
    }

    /// All names, in the order in which they are met.
    pub fn symbols(&self) -> impl Iterator<Item = (SymbolId, &Symbol)> {
        self.symbols.iter().enumerate().map(|(at, symbol)| (SymbolId(at), symbol))
    }

    /// All mentions, in the order of the text.
    pub fn mentions(&self) -> &[Mention] {
        &self.mentions
    }

    /// The mention at a byte: the one that covers it, else the one that ends there.
    pub fn at(&self, offset: usize) -> Option<Mention> {
        let after = self.mentions.partition_point(|mention| mention.span.start as usize <= offset);
        let last = self.mentions[..after].last()?;
        last.span.touches(offset).then_some(*last)
    }

    /// The mentions of one name, in the order of the text.
    pub fn mentions_of(&self, symbol: SymbolId) -> impl Iterator<Item = &Mention> {
        self.of_symbol[symbol.0].iter().map(|&at| &self.mentions[at])
    }

    /// The names that belong to a rule of an item: its own, and those of its op.
    pub fn of_rule(&self, item: usize, rule: usize) -> impl Iterator<Item = (SymbolId, &Symbol)> {
        self.symbols().filter(move |(_, symbol)| {
            symbol.item == Some(item) && symbol.rule.is_none_or(|of| of == rule)
        })
    }
}
