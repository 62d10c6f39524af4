//! Families, unrolled to one size.
//!
//! A family is one element, or run, per index of a cycle. A statement with a free index holds for
//! all of it, and `each` repeats its period once per index:
//!
//! ```text
//!   face f: each i { v[i] -h[i]-> }        face f: v[0] -h[0]-> v[1] -h[1]-> v[2] -h[2]-> v[0]
//!   edge e[i]: h[i] | k[i+1]               edge e[0]: h[0] | k[1]   edge e[1]: h[1] | k[2]   …
//! ```
//!
//! On a cycle of `n` a rule with families means exactly the same as the rule unrolled to `n`, which
//! has no families.

use std::borrow::Cow;

use super::expression::Expr;
use super::{
    Assignment, Cycle, Edge, ExprKind, Loop, LoopItem, NameId, Ref, Require, Role, Rule, Side,
    Spoke, Star,
};

/// The naming of the members of families.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// By their numbers: `h[0]`, `h[1]`, `h[2]`.
    Numbers,
    /// Relative to index 0: `h[i]`, `h[i+1]`, `h[i-1]`.
    Relative,
}

/// A rule with families, unrolled to one without.
#[derive(Clone, Debug, PartialEq)]
pub struct Unrolled {
    /// The rule; its cycle has the size.
    pub rule: Rule,
    /// The first name here of each name of the rule with families.
    first: Vec<u32>,
    size: u32,
}

impl Unrolled {
    /// Unrolls a rule for cycles of `size`, which is 1 or more. A rule without families is
    /// unchanged.
    pub fn new(rule: &Rule, size: u32, naming: Naming) -> Self {
        let size = size.max(1);
        let mut first = Vec::new();
        let mut names = Vec::new();
        for (at, name) in rule.names.iter().enumerate() {
            first.push(names.len() as u32);
            if name.role != Role::Family {
                names.push(name.clone());
                continue;
            }
            for index in 0..size {
                let mut member = name.clone();
                member.role = Role::Member { family: NameId(at as u32), index };
                let letter = rule.cycle.as_ref().map_or("i", |cycle| &cycle.letter);
                member.text = called(name, subscript(index, size, naming, letter));
                names.push(member);
            }
        }
        let cycle = rule
            .cycle
            .as_ref()
            .map(|cycle| Cycle { letter: cycle.letter.clone(), size: Some(size) });
        let mut unrolled = Self { rule: Rule { names, cycle, ..rule.clone() }, first, size };
        let whole = Writer { source: rule, unrolled: &unrolled };
        let written = whole.rule();
        unrolled.rule = written;
        unrolled
    }

    /// The name here of a name of the rule with families; of a family, the member at `index` modulo
    /// the size.
    pub fn member(&self, name: NameId, index: i64) -> NameId {
        let first = self.first[name.index()];
        match self.rule.names.get(first as usize).map(|name| name.role) {
            Some(Role::Member { .. }) => {
                let around = index.rem_euclid(i64::from(self.size)) as u32;
                NameId(first + around)
            }
            _ => NameId(first),
        }
    }

    /// The name, in the rule with families, of a name here.
    pub fn source(&self, name: NameId) -> NameId {
        match self.rule.name(name).role {
            Role::Member { family, .. } => family,
            Role::Single | Role::Family => {
                let at = self.first.partition_point(|&first| first < name.0);
                NameId(at as u32)
            }
        }
    }

    /// The size it was unrolled to.
    pub fn size(&self) -> u32 {
        self.size
    }
}

/// The subscript between the brackets.
fn subscript(index: u32, size: u32, naming: Naming, letter: &str) -> String {
    match naming {
        Naming::Numbers => index.to_string(),
        Naming::Relative if index == 0 => letter.to_owned(),
        Naming::Relative if index <= size / 2 => format!("{letter}+{index}"),
        Naming::Relative => format!("{letter}-{}", size - index),
    }
}

/// The name of a member; if it has no name, the description with the subscript inside.
fn called(family: &super::Name, subscript: String) -> String {
    match family.text.strip_suffix('`') {
        Some(text) if !family.named => format!("{text}[{subscript}]`"),
        _ => format!("{}[{subscript}]", family.text),
    }
}

/// The number of members of each family that are drawn in pictures.
const DRAWN: u32 = 4;

impl Rule {
    /// The rule as pictures show it: a family as a few members, named relative to the index.
    pub fn to_draw(&self) -> Cow<'_, Rule> {
        match self.has_families() {
            true => Cow::Owned(Unrolled::new(self, DRAWN, Naming::Relative).rule),
            false => Cow::Borrowed(self),
        }
    }
}

/// Unrolls the statements.
struct Writer<'a> {
    source: &'a Rule,
    unrolled: &'a Unrolled,
}

impl Writer<'_> {
    fn rule(&self) -> Rule {
        let source = self.source;
        let lists = |refs: &[Ref]| refs.iter().flat_map(|r| self.turns(*r)).collect();
        let params = source.params.iter();
        let requires = source.requires.iter().flat_map(|r| self.require(r));
        let assignments = source.assignments.iter().flat_map(|a| self.assignment(a));
        Rule {
            params: params.map(|param| param.map(|name| self.unrolled.member(name, 0))).collect(),
            result: source.result.map(|result| self.at(result, 0)),
            before: self.side(&source.before),
            requires: requires.collect(),
            after: self.side(&source.after),
            created: lists(&source.created),
            erased: lists(&source.erased),
            assignments: assignments.collect(),
            ..self.unrolled.rule.clone()
        }
    }

    fn is_family(&self, name: NameId) -> bool {
        self.source.name(name).role == Role::Family
    }

    /// The indices that a statement about a name holds for.
    fn indices(&self, subject: Ref) -> std::ops::Range<u32> {
        if self.is_family(subject.name) { 0..self.unrolled.size } else { 0..1 }
    }

    fn at(&self, mention: Ref, index: u32) -> Ref {
        let index = i64::from(index) + i64::from(mention.shift);
        Ref { name: self.unrolled.member(mention.name, index), shift: 0, span: mention.span }
    }

    fn turns(&self, mention: Ref) -> impl Iterator<Item = Ref> + '_ {
        self.indices(mention).map(move |index| self.at(mention, index))
    }

    fn side(&self, side: &Side) -> Side {
        let loops = side
            .loops
            .iter()
            .flat_map(|orbit| self.indices(orbit.face).map(move |index| self.orbit(orbit, index)));
        let edges = side.edges.iter().flat_map(|edge| {
            let indices = self.indices(edge.edge);
            indices.map(move |index| Edge {
                edge: self.at(edge.edge, index),
                halfedges: edge.halfedges.map(|half| self.at(half, index)),
                span: edge.span,
            })
        });
        let stars = side
            .stars
            .iter()
            .flat_map(|star| self.indices(star.vertex).map(move |index| self.star(star, index)));
        Side {
            loops: loops.collect(),
            edges: edges.collect(),
            stars: stars.collect(),
            kept: side.kept.iter().flat_map(|kept| self.turns(*kept)).collect(),
            keeps: side.keeps.clone(),
            span: side.span,
        }
    }

    fn orbit(&self, orbit: &Loop, index: u32) -> Loop {
        let periods = if orbit.each { 0..self.unrolled.size } else { index..index + 1 };
        let items = periods.flat_map(|index| {
            orbit.items.iter().map(move |item| LoopItem {
                from: self.at(item.from, index),
                item: self.at(item.item, index),
            })
        });
        Loop {
            kind: orbit.kind,
            face: self.at(orbit.face, index),
            items: items.collect(),
            each: orbit.each,
            end: self.at(orbit.end, index),
            span: orbit.span,
        }
    }

    fn star(&self, star: &Star, index: u32) -> Star {
        let periods = if star.each { 0..self.unrolled.size } else { index..index + 1 };
        let spokes = periods.flat_map(|index| {
            star.spokes.iter().map(move |spoke| match spoke {
                Spoke::Halfedge(half) => Spoke::Halfedge(self.at(*half, index)),
                Spoke::Fan(fan) => Spoke::Fan(self.at(*fan, index)),
                Spoke::Rest(span) => Spoke::Rest(*span),
            })
        });
        Star {
            vertex: self.at(star.vertex, index),
            spokes: spokes.collect(),
            each: star.each,
            span: star.span,
        }
    }

    fn require(&self, require: &Require) -> Vec<Require> {
        let free = require.condition.has_members();
        let indices = if free { 0..self.unrolled.size } else { 0..1 };
        indices
            .map(|index| Require {
                condition: self.expression(&require.condition, index),
                index: free.then_some(index),
                ..require.clone()
            })
            .collect()
    }

    fn assignment(&self, assignment: &Assignment) -> Vec<Assignment> {
        self.indices(assignment.target)
            .map(|index| Assignment {
                target: self.at(assignment.target, index),
                value: self.expression(&assignment.value, index),
                ..assignment.clone()
            })
            .collect()
    }

    fn expression(&self, expr: &Expr, index: u32) -> Expr {
        let mut expr = expr.clone();
        expr.visit_mut(&mut |kind| {
            *kind = match *kind {
                ExprKind::Element(name) => ExprKind::Element(self.unrolled.member(name, 0)),
                ExprKind::Member(name, shift) => {
                    let index = i64::from(index) + i64::from(shift);
                    ExprKind::Element(self.unrolled.member(name, index))
                }
                _ => return,
            }
        });
        expr
    }
}
