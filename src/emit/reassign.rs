//! Phase 3, reassign: every pointer that changes, halfedge by halfedge.
//!
//! Paths that change their loop and fans that change their vertex are walked first, while `next`
//! and `twin` still have their old values.

use super::conventions::Conventions;
use super::names::Names;
use super::routine::{Field, Statement};
use super::term::{IndexLoop, Term};
use super::walks::{fan_walk, path_walk};
use crate::diagram::{Drawing, Kind, NameId, Operand, Pointer, Type, Write};

/// The statements of the phase, except for the attributes.
pub(super) fn statements(
    drawing: &Drawing,
    names: &mut Names,
    conventions: Conventions<'_>,
) -> Vec<Statement> {
    let list = drawing.reassignments();
    let mut reassign = Reassign {
        drawing,
        names,
        conventions,
        walks: Vec::new(),
        links: Vec::new(),
        linked: Vec::new(),
        sets: Vec::new(),
    };
    for reassignment in &list {
        reassign.indexed(reassignment.at_each_index, |this| {
            reassignment.writes.iter().for_each(|write| this.write(write));
        });
    }
    let indices = reassign.names.indices.clone();
    let Reassign { walks, links, mut sets, .. } = reassign;
    let mut statements = walks;
    statements.extend(links);
    // Halfedge by halfedge, then the other elements.
    sets.sort_by_key(|set| set.order);
    let (each, once): (Vec<_>, Vec<_>) = sets.into_iter().partition(|set| set.at_each_index);
    statements.extend(once.into_iter().map(|set| set.statement));
    if !each.is_empty() {
        let body = each.into_iter().map(|set| set.statement).collect();
        statements.push(Statement::IndexLoop { indices, body });
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
struct Reassign<'d, 'n> {
    drawing: &'d Drawing<'d>,
    names: &'n mut Names,
    conventions: Conventions<'d>,
    /// Walks along paths and fans.
    walks: Vec<Statement>,
    /// The linking of loops of paths that may be empty.
    links: Vec<Statement>,
    /// The first halfedge of the first nonempty path of each such loop.
    linked: Vec<(NameId, Term)>,
    sets: Vec<Set>,
}

impl Reassign<'_, '_> {
    /// Runs `what`, inside of the repetition for each index if `at_each_index`.
    fn indexed<T>(&mut self, at_each_index: bool, what: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.names.is_indexed;
        self.names.is_indexed |= at_each_index;
        let made = what(self);
        self.names.is_indexed = outer;
        made
    }

    fn write(&mut self, write: &Write) {
        let exhaustive = self.conventions.exhaustive;
        match write {
            Write::Halfedge { pointer, of, value, changes } if *changes || exhaustive => {
                self.halfedge(*pointer, of.name(), self.operand(of), self.operand(value));
            }
            Write::AsItWas { pointer, of } if exhaustive => {
                let term = self.names.term(*of);
                self.halfedge(*pointer, *of, term.clone(), term.follow(*pointer));
            }
            Write::Anchor { pointer, of, value, keeps } if !keeps || exhaustive => {
                let element = self.names.term(*of);
                let value = match value {
                    // One that is kept is set to a named halfedge, or else to its current value.
                    Some(Operand::Named(half)) => self.names.term(*half),
                    Some(Operand::FirstOfSome(path)) if !keeps => {
                        return self.anchor_of_some(*pointer, element, *path);
                    }
                    Some(value) if !keeps => self.operand(value),
                    _ => element.clone().follow(*pointer),
                };
                self.other(*pointer, Statement::set(*pointer, element, value));
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
                let face = self.names.term(*face);
                let value = Term::Bool(*is_hole);
                let set = Statement::Set { field: Field::Hole, of: face, value };
                self.other(Pointer::FaceHalfedge, set);
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

    /// Sets a pointer of a named halfedge: of each `next` first, then `prev`, `twin`, `vertex`,
    /// `edge`, `face`.
    fn halfedge(&mut self, pointer: Pointer, name: NameId, of: Term, value: Term) {
        let rank = match pointer {
            Pointer::Prev if !self.conventions.prev => return,
            Pointer::Next => 0,
            Pointer::Prev => 1,
            Pointer::Twin => 2,
            Pointer::Vertex => 3,
            Pointer::Edge => 4,
            _ => 5,
        };
        self.push((name.index(), rank), Statement::set(pointer, of, value));
    }

    /// Writes to an element other than a halfedge: vertices first, then edges, then faces.
    fn other(&mut self, pointer: Pointer, statement: Statement) {
        let rank = match pointer {
            Pointer::VertexHalfedge => 0,
            Pointer::EdgeHalfedge => 1,
            _ => 2,
        };
        self.push((usize::MAX, rank), statement);
    }

    fn push(&mut self, order: (usize, usize), statement: Statement) {
        self.sets.push(Set { order, at_each_index: self.names.is_indexed, statement });
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
        let (last, others) = items.split_last().expect("an operand has items");
        others
            .iter()
            .rev()
            .fold(end(*last), |term, &item| self.names.empty(item).then(term, end(item)))
    }

    /// Sets the halfedge of an element to that of a nonempty member of a family of paths.
    fn anchor_of_some(&mut self, pointer: Pointer, of: Term, path: NameId) {
        self.indexed(true, |this| {
            let condition = this.names.empty(path).not();
            let body = vec![Statement::set(pointer, of, this.names.term(path))];
            this.other(pointer, Statement::when(condition, body));
        });
    }

    /// Links the nonempty paths of a loop, and returns the first halfedge of the first of them.
    fn link_paths(&mut self, period: &[NameId]) -> Term {
        let [firsts, lasts] = ["firsts", "lasts"].map(|wanted| self.names.fresh(wanted));
        for name in [&firsts, &lasts] {
            self.links.push(Statement::List {
                ty: Type::Halfedge,
                name: name.clone(),
                items: Vec::new(),
            });
        }
        let body = self.indexed(true, |this| {
            let pushed = period.iter().map(|&path| {
                let ends = [(&firsts, this.names.term(path)), (&lasts, this.names.last(path))];
                let push =
                    |(list, item): (&String, _)| Statement::Push { list: list.clone(), item };
                Statement::when(this.names.empty(path).not(), ends.map(push).to_vec())
            });
            pushed.collect()
        });
        let indices = self.names.indices.clone();
        self.links.push(Statement::IndexLoop { indices: indices.clone(), body });
        // From here on an index counts the nonempty paths.
        let indices = IndexLoop { index: indices.index, size: self.names.fresh("runs") };
        let member = |list: &String, shift| Term::Member {
            list: list.clone(),
            index: Some(indices.index.clone()),
            shift,
            size: indices.size.clone(),
        };
        let (last, first) = (member(&lasts, 0), member(&firsts, 1));
        let mut body = vec![Statement::set(Pointer::Next, last.clone(), first.clone())];
        if self.conventions.prev {
            body.push(Statement::set(Pointer::Prev, first, last));
        }
        let size = indices.size.clone();
        self.links.push(Statement::Size { name: size.clone(), list: firsts.clone() });
        self.links.push(Statement::IndexLoop { indices, body });
        Term::Member { list: firsts, index: None, shift: 0, size }
    }
}
