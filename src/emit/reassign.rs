//! Phase 3, reassign: every pointer that changes, halfedge by halfedge.
//!
//! Paths that change their loop and fans that change their vertex are walked first, while `next`
//! and `twin` still have their old values.

use super::names::{IndexLoop, Names};
use super::routine::{Field, Statement};
use super::value::Term;
use super::walks::{fan_walk, path_walk};
use crate::diagram::{Drawing, Kind, NameId, Operand, Pointer, Reassignment, Type, Write};

/// The statements of the phase, except for the attributes; if `exhaustive`, pointers that do not
/// change are set, too.
pub(super) fn statements(drawing: &Drawing, names: &mut Names, exhaustive: bool) -> Vec<Statement> {
    let list = drawing.reassignments();
    let mut reassign = Reassign {
        drawing,
        names,
        exhaustive,
        walks: Vec::new(),
        links: Vec::new(),
        linked: Vec::new(),
        sets: Vec::new(),
    };
    for Reassignment { at_each_index, writes } in &list {
        reassign.names.is_indexed = *at_each_index;
        writes.iter().for_each(|write| reassign.write(write));
    }
    reassign.names.is_indexed = false;
    let Reassign { walks, links, mut sets, .. } = reassign;
    let mut statements = [walks, links].concat();
    // Halfedge by halfedge, then the other elements.
    sets.sort_by_key(|set| set.order);
    let (each, once): (Vec<_>, Vec<_>) = sets.into_iter().partition(|set| set.at_each_index);
    statements.extend(once.into_iter().map(|set| set.statement));
    if !each.is_empty() {
        let body = each.into_iter().map(|set| set.statement).collect();
        statements.push(names.language.index_loop(&names.indices, body));
    }
    statements
}

/// A pointer that is set, and its place in the code: by halfedge and pointer, other elements last.
struct Set {
    order: (usize, usize),
    at_each_index: bool,
    statement: Statement,
}

/// The writer of the phase.
struct Reassign<'d, 'n, 's> {
    drawing: &'d Drawing<'d>,
    names: &'n mut Names<'s>,
    exhaustive: bool,
    /// Walks along paths and fans.
    walks: Vec<Statement>,
    /// The linking of loops of paths that may be empty.
    links: Vec<Statement>,
    /// The first halfedge of the first nonempty path of each such loop.
    linked: Vec<(NameId, Term)>,
    sets: Vec<Set>,
}

impl Reassign<'_, '_, '_> {
    fn write(&mut self, write: &Write) {
        let (exhaustive, language) = (self.exhaustive, self.names.language);
        match write {
            Write::Halfedge { pointer, of, value, changes } if *changes || exhaustive => {
                let set = Statement::set(*pointer, self.operand(of), self.operand(value));
                self.set(*pointer, of.name(), set);
            }
            Write::AsItWas { pointer, of } if exhaustive => {
                let term = self.names.term(*of);
                let value = language.follow(*pointer, &term);
                self.set(*pointer, *of, Statement::set(*pointer, term, value));
            }
            Write::Anchor { pointer, of, value, keeps } if !keeps || exhaustive => {
                let element = self.names.term(*of);
                let value = match value {
                    // One that is kept is set to a named halfedge, or else to its current value.
                    Some(Operand::Named(half)) => self.names.term(*half),
                    Some(Operand::FirstOfSome(path)) if !keeps => {
                        return self.anchor_of_some(*pointer, *of, *path);
                    }
                    Some(value) if !keeps => self.operand(value),
                    _ => language.follow(*pointer, &element),
                };
                self.set(*pointer, *of, Statement::set(*pointer, element, value));
            }
            Write::FaceAlong { path, changes: true, .. } => {
                let walk = path_walk(self.drawing, self.names, *path);
                self.walk(walk);
            }
            Write::VertexAround { fan, changes: true, .. } => {
                let walk = fan_walk(self.drawing, self.names, *fan);
                self.walk(walk);
            }
            Write::Hole { face, is_hole, changes: true } => {
                let (of, value) = (self.names.term(*face), Term::bool(*is_hole));
                let set = Statement::Set { field: Field::Hole, of, value };
                self.set(Pointer::FaceHalfedge, *face, set);
            }
            Write::LinkPaths { face, period } => {
                let first = self.link_paths(period);
                self.linked.push((*face, first));
            }
            _ => {}
        }
    }

    fn walk(&mut self, walk: Option<Statement>) {
        let each = self.names.is_indexed;
        self.walks.extend(walk.map(|walk| self.names.repeated(each, walk)));
    }

    /// Adds a statement that sets a pointer of a named element. Halfedges come first, in order, then
    /// vertices, edges and faces.
    fn set(&mut self, pointer: Pointer, of: NameId, statement: Statement) {
        use Pointer::*;
        let order = [Next, Prev, Twin, Vertex, Edge, Face, VertexHalfedge, EdgeHalfedge];
        let rank = order.iter().position(|known| *known == pointer).unwrap_or(order.len());
        let of = if rank < 6 { of.index() } else { usize::MAX };
        if pointer != Prev || self.names.language.has_prev() {
            let at_each_index = self.names.is_indexed;
            self.sets.push(Set { order: (of, rank), at_each_index, statement });
        }
    }

    fn operand(&self, operand: &Operand) -> Term {
        match operand {
            Operand::Named(name) | Operand::FirstOfSome(name) => self.names.term(*name),
            Operand::First(items) => self.there(items, |item| self.names.term(item)),
            Operand::Last(items) => self.there(items, |item| match self.drawing.rule.kind(item) {
                Kind::Path => self.names.last(item),
                _ => self.names.term(item),
            }),
            Operand::FirstLinked { face, path } => {
                let linked = self.linked.iter().find(|(of, _)| of == face);
                linked.map_or_else(|| self.names.term(*path), |(_, first)| first.clone())
            }
        }
    }

    /// The end of the first item that is not empty.
    fn there(&self, items: &[NameId], end: impl Fn(NameId) -> Term) -> Term {
        let language = self.names.language;
        let (last, others) = items.split_last().expect("an operand has items");
        others.iter().rev().fold(end(*last), |term, &item| {
            language.choice(&self.names.empty(item), [term, end(item)])
        })
    }

    /// Sets the halfedge of an element to that of a nonempty member of a family of paths.
    fn anchor_of_some(&mut self, pointer: Pointer, of: NameId, path: NameId) {
        let element = self.names.term(of);
        self.names.is_indexed = true;
        let body = vec![Statement::set(pointer, element, self.names.term(path))];
        let condition = self.names.empty(path).not();
        self.set(pointer, of, self.names.language.choose(&condition, body, Vec::new()));
        self.names.is_indexed = false;
    }

    /// Links the nonempty paths of a loop, and returns the first halfedge of the first of them.
    fn link_paths(&mut self, period: &[NameId]) -> Term {
        let language = self.names.language;
        let [firsts, lasts] = ["firsts", "lasts"].map(|wanted| self.names.fresh(wanted));
        for name in [&firsts, &lasts] {
            self.links.push(language.list(Type::Halfedge, name, &[]));
        }
        self.names.is_indexed = true;
        let pushed = period.iter().map(|&path| {
            let (first, last) = (self.names.term(path), self.names.last(path));
            let push = vec![language.push(&firsts, &first), language.push(&lasts, &last)];
            language.choose(&self.names.empty(path).not(), push, Vec::new())
        });
        let body = pushed.collect();
        self.names.is_indexed = false;
        self.links.push(language.index_loop(&self.names.indices, body));
        // From here on an index counts the nonempty paths.
        let index = self.names.indices.index.clone();
        let indices = IndexLoop { index, size: self.names.fresh("runs") };
        let member = |list, shift| Term::member(list, Some(&indices.index), shift, &indices.size);
        let (last, first) = (member(&lasts, 0), member(&firsts, 1));
        let mut body = vec![Statement::set(Pointer::Next, last.clone(), first.clone())];
        if language.has_prev() {
            body.push(Statement::set(Pointer::Prev, first, last));
        }
        self.links.push(language.size(&indices.size, &firsts));
        self.links.push(language.index_loop(&indices, body));
        Term::member(&firsts, None, 0, &indices.size)
    }
}
