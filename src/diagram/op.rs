//! Operations, rules, sides and the three kinds of orbit.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::{Attribute, Expr, Level, Type};
use crate::mesh::ElementKind;
use crate::source::Span;

/// The kind of element or run that a name of a diagram stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    Vertex,
    Halfedge,
    Edge,
    /// A face, a hole, or either.
    Face,
    /// A run of zero or more halfedges of a loop.
    Path,
    /// A run of zero or more spokes of a vertex.
    Fan,
}

impl Kind {
    /// The word for it.
    pub fn word(self) -> &'static str {
        without_article(self.a_word())
    }

    /// The word with its article.
    pub fn a_word(self) -> &'static str {
        match self {
            Kind::Vertex => "a vertex",
            Kind::Halfedge => "a halfedge",
            Kind::Edge => "an edge",
            Kind::Face => "a face",
            Kind::Path => "a path",
            Kind::Fan => "a fan",
        }
    }

    /// The word for several.
    pub fn plural(self) -> String {
        match self {
            Kind::Vertex => "vertices".to_owned(),
            Kind::Path | Kind::Fan | Kind::Halfedge | Kind::Edge | Kind::Face => {
                format!("{}s", self.word())
            }
        }
    }

    /// The kind of element; `None` for a run.
    pub fn element_kind(self) -> Option<ElementKind> {
        match self {
            Kind::Vertex => Some(ElementKind::Vertex),
            Kind::Halfedge => Some(ElementKind::Halfedge),
            Kind::Edge => Some(ElementKind::Edge),
            Kind::Face => Some(ElementKind::Face),
            Kind::Path | Kind::Fan => None,
        }
    }

    /// The type of an element of the kind; `None` for a run.
    pub fn element_type(self) -> Option<Type> {
        self.element_kind().map(Type::from)
    }
}

impl From<ElementKind> for Kind {
    fn from(kind: ElementKind) -> Self {
        match kind {
            ElementKind::Vertex => Kind::Vertex,
            ElementKind::Halfedge => Kind::Halfedge,
            ElementKind::Edge => Kind::Edge,
            ElementKind::Face => Kind::Face,
        }
    }
}

/// A name of a rule, by its index in [`Rule::names`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NameId(pub u32);

impl NameId {
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A name of a rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The word, or a description if there is no name: "the path of `f0`".
    pub text: String,
    pub kind: Kind,
    /// True if the author gave the name.
    pub named: bool,
    /// Whether it is one element or run, or one for each index.
    pub role: Role,
    /// The place where it is first mentioned.
    pub span: Span,
}

pub(super) fn without_article(a_word: &'static str) -> &'static str {
    a_word.split_once(' ').map_or(a_word, |(_, word)| word)
}

/// The number of elements or runs that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    Single,
    /// One for each index: `h[i]`.
    Family,
    /// In an unrolled rule, the member of a family at an index.
    Member {
        /// The family, by its number in the rule with families.
        family: NameId,
        index: u32,
    },
}

/// A letter, or if that is taken, the letter with the first number that makes it free.
pub fn free_name(letter: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let numbered = (0..).map(|number: usize| format!("{letter}{number}"));
    let mut words = std::iter::once(letter.to_owned()).chain(numbered);
    words.find(|word| !is_taken(word)).unwrap_or_else(|| letter.to_owned())
}

impl Name {
    /// The name in backticks, or the description.
    pub fn quoted(&self) -> String {
        if self.named { format!("`{}`", self.text) } else { self.text.clone() }
    }
}

/// One mention of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ref {
    pub name: NameId,
    /// The summand of the subscript: 1 in `h[i+1]`. Zero where there is none.
    pub shift: i32,
    pub span: Span,
}

impl Ref {
    /// A mention without a subscript.
    pub fn plain(name: NameId, span: Span) -> Self {
        Self { name, shift: 0, span }
    }

    /// A mention that stands in no source.
    pub fn unwritten(name: NameId) -> Self {
        Self::plain(name, Span::default())
    }
}

/// An operation: alternatives over the same parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Op {
    pub name: String,
    pub name_span: Span,
    pub docs: Vec<String>,
    pub params: Vec<Param>,
    pub result: Option<Type>,
    /// The properties it claims to keep, and where.
    pub keeps: Vec<(Property, Span)>,
    /// The alternatives, tried in order.
    pub rules: Vec<Rule>,
    pub span: Span,
}

impl Op {
    /// The level of the meshes that it is for: the highest that a rule guards.
    pub fn level(&self) -> Level {
        let guards = self.rules.iter().filter_map(|rule| rule.guard);
        guards.map(|(level, _)| level).max().unwrap_or(Level::Map)
    }
}

/// Something that an operation can keep, besides validity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Property {
    /// Every face stays a triangle, if all were.
    Triangles,
    /// Every face stays a quad, if all were.
    Quads,
    /// V - E + F stays the same, with holes among the faces.
    Euler,
    /// The holes keep their number, and each its vertices.
    Boundary,
    /// The time does not grow with the mesh.
    ConstantTime,
    /// A mesh of the level stays one. Every mesh stays a map.
    Level(Level),
}

impl Property {
    /// All properties, except that every mesh stays a map.
    pub const ALL: [Property; 7] = [
        Property::Triangles,
        Property::Quads,
        Property::Euler,
        Property::Boundary,
        Property::ConstantTime,
        Property::Level(Level::Surface),
        Property::Level(Level::Simple),
    ];

    pub fn level(self) -> Option<Level> {
        match self {
            Self::Level(level) => Some(level),
            _ => None,
        }
    }

    /// The word for it after `keeps`.
    pub fn word(self) -> &'static str {
        match self {
            Property::Triangles => "triangles",
            Property::Quads => "quads",
            Property::Euler => "euler",
            Property::Boundary => "boundary",
            Property::ConstantTime => "constant_time",
            Property::Level(level) => level.name(),
        }
    }
}

/// A parameter of an operation or script.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    pub name: String,
    /// The span of its name.
    pub span: Span,
    pub ty: Type,
    /// Its default, which refers to nothing but earlier parameters.
    pub default: Option<Expr>,
}

/// One alternative.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rule {
    pub label: Option<String>,
    /// The mesh of the example, if this is not a rule of a program but an example of an op.
    pub example: Option<Example>,
    /// The way in which it breaks a mesh, if this is not a rule of a program but a counterexample.
    pub broken: Option<Broken>,
    /// All its names, in order of first mention: elements, paths and fans.
    pub names: Vec<Name>,
    /// The index of its families, if it has any.
    pub cycle: Option<Cycle>,
    /// For each parameter of the op, the name it binds; `None` for a value, or for an element this
    /// rule does not draw. A family is bound at index 0.
    pub params: Vec<Option<NameId>>,
    pub result: Option<Ref>,
    pub before: Side,
    pub requires: Vec<Require>,
    /// The level that the mesh has, and must have again afterwards.
    pub guard: Option<(Level, Span)>,
    /// Names that may stand for one element.
    pub aliases: Vec<Alias>,
    pub after: Side,
    pub created: Vec<Ref>,
    pub erased: Vec<Ref>,
    pub assignments: Vec<Assignment>,
    /// All attributes that the program declares, by number.
    pub attributes: Arc<[Attribute]>,
    pub span: Span,
}

impl Rule {
    /// The word for an attribute.
    pub fn attribute(&self, access: super::Access) -> &str {
        match access {
            super::Access::Position => "position",
            super::Access::Declared(number) => {
                self.attributes.get(number as usize).map_or("", |attribute| &attribute.name)
            }
        }
    }

    pub fn name(&self, id: NameId) -> &Name {
        &self.names[id.index()]
    }

    /// A name that is not used here.
    pub fn free_name(&self, letter: &str) -> String {
        free_name(letter, |wanted| {
            self.names.iter().any(|name| name.text.split('[').next() == Some(wanted))
        })
    }

    /// The word of a name in backticks, or its description.
    pub fn quoted(&self, id: NameId) -> String {
        self.name(id).quoted()
    }

    pub fn kind(&self, id: NameId) -> Kind {
        self.name(id).kind
    }

    /// True if an `alias` lets two names stand for one element.
    pub fn may_be_one(&self, left: NameId, right: NameId) -> bool {
        let lists = |alias: &Alias, name: NameId| alias.names.iter().any(|of| of.name == name);
        self.aliases.iter().any(|alias| lists(alias, left) && lists(alias, right))
    }

    pub fn ids(&self) -> impl Iterator<Item = NameId> + use<> {
        (0..self.names.len() as u32).map(NameId)
    }

    pub fn names_of(&self, kind: Kind) -> impl Iterator<Item = NameId> + '_ {
        self.ids().filter(move |&id| self.kind(id) == kind)
    }
}

/// The mesh of an example of an op.
#[derive(Clone, Debug, PartialEq)]
pub struct Example {
    /// The name of the mesh: "a cube".
    pub mesh: &'static str,
    /// The positions of the vertices before and after, by name, if the mesh is flat and no two of
    /// them coincide; y points up.
    pub places: [Vec<Option<[f64; 2]>>; 2],
}

/// What is known of a counterexample beyond its drawing: loops and edges that are broken cannot be
/// drawn whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// The reason why the mesh after is not valid, in words.
    pub verdict: String,
    /// The halfedges whose pointers are the same before and after.
    pub unchanged: Vec<NameId>,
}

/// `alias v2 v3`: any two of these names may stand for one element.
#[derive(Clone, Debug, PartialEq)]
pub struct Alias {
    /// The names, all of one kind.
    pub names: Vec<Ref>,
    pub span: Span,
}

/// The index of a rule with families: it runs around a cycle of any size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cycle {
    /// Its letter: `i`.
    pub letter: String,
    /// The size that the rule was unrolled to, if it was.
    pub size: Option<u32>,
}

/// One drawing: orbits of each kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Side {
    /// Cycles of `next`.
    pub loops: Vec<Loop>,
    /// Pairs of `twin`s.
    pub edges: Vec<Edge>,
    /// Cycles of spokes.
    pub stars: Vec<Star>,
    /// Names that `keep` mentions; their statements are among the others.
    pub kept: Vec<Ref>,
    /// The whole `keep` statements.
    pub keeps: Vec<Span>,
    /// From the keyword to the closing brace.
    pub span: Span,
}

/// The loops that a statement stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LoopKind {
    /// An interior face.
    Face,
    /// A boundary loop.
    Hole,
    /// Either.
    Any,
}

/// A cycle of `next`.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    pub kind: LoopKind,
    pub face: Ref,
    /// Its halfedges and paths, in order; the last ends at the origin of the first. With `each` one
    /// period of them, or in an unrolled rule all of them.
    pub items: Vec<LoopItem>,
    /// True if it is drawn with `each`.
    pub each: bool,
    /// The vertex written at the end; in a valid drawing, the origin of the first item.
    pub end: Ref,
    pub span: Span,
}

impl Loop {
    /// The vertices that its items leave, in order.
    pub(crate) fn corners(&self) -> impl Iterator<Item = NameId> + Clone {
        self.items.iter().map(|item| item.from.name)
    }

    /// A vertex that several items leave, if there is one.
    pub(crate) fn corner_met_twice(&self) -> Option<NameId> {
        let mut met = BTreeSet::new();
        let twice = self.items.iter().find(|item| !met.insert((item.from.name, item.from.shift)));
        twice.map(|item| item.from.name)
    }

    /// The names of its halfedges and paths, in order.
    pub(crate) fn item_names(&self) -> impl Iterator<Item = NameId> + Clone {
        self.items.iter().map(|item| item.item.name)
    }
}

/// A halfedge or path in a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopItem {
    /// The vertex it leaves.
    pub from: Ref,
    pub item: Ref,
}

/// A pair of `twin`s.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    pub edge: Ref,
    pub halfedges: [Ref; 2],
    pub span: Span,
}

impl Edge {
    pub(crate) fn halfedge_names(&self) -> [NameId; 2] {
        self.halfedges.map(|half| half.name)
    }
}

/// A cycle of spokes, counterclockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Star {
    pub vertex: Ref,
    /// Its spokes; with `each` one period of them, or in an unrolled rule all of them.
    pub spokes: Vec<Spoke>,
    /// True if it is drawn with `each`.
    pub each: bool,
    pub span: Span,
}

impl Star {
    /// The halfedges among its spokes that follow each other, counterclockwise.
    pub(crate) fn neighbors(&self) -> impl Iterator<Item = [Ref; 2]> {
        let following = self.spokes.iter().cycle().skip(1);
        self.spokes.iter().zip(following).filter_map(|pair| match pair {
            (Spoke::Halfedge(spoke), Spoke::Halfedge(next)) => Some([*spoke, *next]),
            _ => None,
        })
    }
}

/// A spoke or a run of spokes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spoke {
    Halfedge(Ref),
    /// `*S`, the fan `S`.
    Fan(Ref),
    /// `*`, a fan without a name.
    Rest(Span),
}

impl Spoke {
    pub fn halfedge(&self) -> Option<NameId> {
        match self {
            Spoke::Halfedge(half) => Some(half.name),
            Spoke::Fan(_) | Spoke::Rest(_) => None,
        }
    }
}

/// `require … else "…"`
#[derive(Clone, Debug, PartialEq)]
pub struct Require {
    /// The condition; its names are those of the rule.
    pub condition: Expr,
    pub reason: String,
    /// In an unrolled rule, the value of the free index.
    pub index: Option<u32>,
    pub span: Span,
}

/// `v.position = …`
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    pub target: Ref,
    pub attribute: super::Access,
    /// The value, of the attribute's type.
    pub value: Expr,
    pub span: Span,
}
