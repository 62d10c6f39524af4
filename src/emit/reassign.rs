//! Phase 3, reassign: every pointer that changes, halfedge by halfedge.
//!
//! Paths that change their loop and fans that change their vertex are walked first, while
//! `next` and `twin` are still what they were.

use super::build::Conventions;
use super::names::Names;
use super::routine::Statement;
use super::term::Term;
use super::walks::{fan_walk, path_walk};
use crate::check::{moved_fans, moved_paths};
use crate::diagram::{Drawing, Edge, Kind, Loop, LoopItem, LoopKind, NameId, Pointer};

/// The statements of the phase, but for the attributes.
pub(super) fn statements(
    drawing: &Drawing,
    names: &mut Names,
    conventions: Conventions<'_>,
) -> Vec<Statement> {
    let rule = drawing.rule;
    let mut walks = Vec::new();
    for path in moved_paths(drawing).filter(|&path| rule.is_first(path)) {
        let walk = names.for_each(rule.is_member(path), |names| path_walk(drawing, names, path));
        walks.extend(for_each(rule.is_member(path), names, walk.into_iter().collect()));
    }
    for fan in moved_fans(drawing).filter(|&fan| rule.is_first(fan)) {
        let walk = names.for_each(rule.is_member(fan), |names| fan_walk(drawing, names, fan));
        walks.extend(for_each(rule.is_member(fan), names, walk.into_iter().collect()));
    }
    let mut reassign = Reassign {
        drawing,
        names,
        conventions,
        sets: Vec::new(),
        runs: Vec::new(),
        first_runs: Vec::new(),
    };
    reassign.all();
    let Reassign { mut sets, runs, .. } = reassign;
    walks.extend(runs);
    // Halfedge by halfedge, then what points at them.
    sets.sort_by_key(|set| set.order);
    let (each, once): (Vec<_>, Vec<_>) = sets.into_iter().partition(|set| set.repeated);
    walks.extend(once.into_iter().map(|set| set.statement));
    let each = each.into_iter().map(|set| set.statement).collect();
    walks.extend(for_each(true, names, each));
    walks
}

/// Statements that are done for each index, as one.
fn for_each(repeated: bool, names: &Names, body: Vec<Statement>) -> Vec<Statement> {
    match repeated && !body.is_empty() {
        true => vec![Statement::IndexLoop { indices: names.indices(), body }],
        false => body,
    }
}

/// A pointer that is set, and where it stands in the code: by halfedge and pointer, those of
/// other elements last.
struct Set {
    order: (usize, usize),
    repeated: bool,
    statement: Statement,
}

/// The writer of the phase.
pub(super) struct Reassign<'d, 'n> {
    pub drawing: &'d Drawing<'d>,
    pub names: &'n mut Names,
    pub conventions: Conventions<'d>,
    sets: Vec<Set>,
    /// Loops of runs that may be empty.
    pub runs: Vec<Statement>,
    /// Of each such loop the first halfedge of a run that is not.
    pub first_runs: Vec<(NameId, Term)>,
}

impl Reassign<'_, '_> {
    fn all(&mut self) {
        let rule = self.drawing.rule;
        for orbit in &rule.after.loops {
            self.for_each(orbit.face.name, |this| match orbit.each {
                true => this.orbit_around(orbit),
                false => this.orbit(orbit),
            });
        }
        for edge in &rule.after.edges {
            self.for_each(edge.edge.name, |this| this.edge(edge));
        }
        for half in rule.names_of(Kind::Halfedge) {
            self.for_each(half, |this| this.outer(half));
        }
        for vertex in rule.names_of(Kind::Vertex) {
            self.for_each(vertex, |this| this.vertex(vertex));
        }
        for edge in &rule.after.edges {
            self.for_each(edge.edge.name, |this| this.edge_halfedge(edge));
        }
        for orbit in &rule.after.loops {
            self.for_each(orbit.face.name, |this| this.face(orbit));
        }
    }

    /// An element that keeps its halfedge. Where all is set, it is set to one that is drawn, else
    /// to what it is.
    fn kept(&mut self, element: NameId, pointer: Pointer, half: Option<Term>) {
        if self.conventions.exhaustive {
            let of = self.term(element);
            let value = half.unwrap_or_else(|| of.clone().follow(pointer));
            self.set_other(Statement::Set { pointer, of, value });
        }
    }

    /// Does something about a name: of a family once, for each index.
    fn for_each(&mut self, name: NameId, what: impl FnOnce(&mut Self)) {
        let rule = self.drawing.rule;
        if rule.is_first(name) {
            self.indexed(rule.is_member(name), what);
        }
    }

    pub fn indexed<T>(&mut self, repeated: bool, what: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.names.enter_index(repeated);
        let made = what(self);
        self.names.turn_back(outer);
        made
    }

    fn term(&self, name: NameId) -> Term {
        self.names.term(name)
    }

    pub fn is_path(&self, item: NameId) -> bool {
        self.drawing.rule.kind(item) == Kind::Path
    }

    /// `next` first, then `twin`, `vertex`, `edge`, `face`; of each halfedge together.
    fn set(&mut self, name: NameId, of: Term, pointer: Pointer, value: Term) {
        let rank = match pointer {
            Pointer::Next => 0,
            Pointer::Prev if !self.conventions.prev => return,
            Pointer::Prev => 1,
            Pointer::Twin => 2,
            Pointer::Vertex => 3,
            Pointer::Edge => 4,
            _ => 5,
        };
        let statement = Statement::Set { pointer, of, value };
        self.push((name.index(), rank), statement);
    }

    /// A pointer of another element than a halfedge.
    fn set_other(&mut self, statement: Statement) {
        self.push((usize::MAX, 0), statement);
    }

    fn push(&mut self, order: (usize, usize), statement: Statement) {
        self.sets.push(Set { order, repeated: self.names.is_indexed(), statement });
    }

    fn pointer(&mut self, half: NameId, pointer: Pointer, value: NameId, changed: bool) {
        if changed || self.conventions.exhaustive {
            self.set(half, self.term(half), pointer, self.term(value));
        }
    }

    /// The first halfedge from the item at `at` on: its own, or if that is an empty path,
    /// that of what follows.
    fn head(&self, items: &[NameId], at: usize) -> Term {
        self.end_of(items, at, 1, |item| self.term(item))
    }

    /// The last halfedge up to the item at `at`.
    fn tail(&self, items: &[NameId], at: usize) -> Term {
        self.end_of(items, at, items.len() - 1, |item| match self.is_path(item) {
            true => self.names.last(item),
            false => self.term(item),
        })
    }

    fn end_of(
        &self,
        items: &[NameId],
        at: usize,
        step: usize,
        end: impl Fn(NameId) -> Term,
    ) -> Term {
        let count = items.len();
        let places = (0..count).map(|turn| items[(at + turn * step) % count]);
        let mut ends = Vec::new();
        for item in places {
            let may_be_empty = self.is_path(item) && self.drawing.is_empty_somewhere(item);
            ends.push((end(item), may_be_empty.then(|| self.names.empty(item))));
            if !may_be_empty {
                break;
            }
        }
        let last = ends.pop().map(|(term, _)| term);
        let mut term = last.unwrap_or(Term::Bool(false));
        while let Some((here, empty)) = ends.pop() {
            term = match empty {
                Some(empty) => empty.then(term, here),
                None => here,
            };
        }
        term
    }

    fn orbit(&mut self, orbit: &Loop) {
        let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        for at in 0..items.len() {
            self.link(&items, at);
            self.lies_in(&orbit.items[at], orbit.face.name);
        }
    }

    /// `next` of what ends the item at `at`, `prev` of what begins the one behind it.
    pub fn link(&mut self, items: &[NameId], at: usize) {
        let after = (at + 1) % items.len();
        let (name, next) = (items[at], items[after]);
        let changed = self.drawing.before.item_after(name) != Some(next);
        if changed || self.conventions.exhaustive {
            let (tail, head) = (self.tail(items, at), self.head(items, after));
            self.set(name, tail.clone(), Pointer::Next, head.clone());
            self.set(next, head, Pointer::Prev, tail);
        }
    }

    /// The origin and the face of one item.
    pub fn lies_in(&mut self, item: &LoopItem, face: NameId) {
        let drawing = self.drawing;
        let (name, origin) = (item.item.name, item.from.name);
        if self.is_path(name) {
            return;
        }
        let moved = drawing.before.loop_origin(name) != Some(origin);
        self.pointer(name, Pointer::Vertex, origin, moved);
        let changed = drawing.before.face(name) != Some(face);
        self.pointer(name, Pointer::Face, face, changed);
    }

    fn edge(&mut self, statement: &Edge) {
        let drawing = self.drawing;
        let edge = statement.edge.name;
        let [left, right] = statement.halfedges.map(|half| half.name);
        for (half, twin) in [(left, right), (right, left)] {
            let new_twin = drawing.before.twin(half) != Some(twin);
            self.pointer(half, Pointer::Twin, twin, new_twin);
            let new_edge = drawing.before.edge(half) != Some(edge);
            self.pointer(half, Pointer::Edge, edge, new_edge);
        }
    }

    /// Outer halfedges start where their vertex statement, or their drawn twin, says, and stay in
    /// their loop.
    fn outer(&mut self, half: NameId) {
        let drawing = self.drawing;
        if !drawing.is_outer(half) || drawing.after.mention(half).is_none() {
            return;
        }
        if let Some(origin) = drawing.origin_after(half) {
            let changed = drawing.origin_before(half) != Some(origin);
            self.pointer(half, Pointer::Vertex, origin, changed);
        }
        if self.conventions.exhaustive {
            for pointer in [Pointer::Next, Pointer::Prev, Pointer::Face] {
                let of = self.term(half);
                self.set(half, of.clone(), pointer, of.follow(pointer));
            }
        }
    }

    /// An edge keeps its halfedge as long as both of its halfedges stay.
    fn edge_halfedge(&mut self, statement: &Edge) {
        let after = statement.halfedges.map(|half| half.name);
        let before = self.drawing.before.edge_statement(statement.edge.name);
        let keeps = before.is_some_and(|before| {
            let mut halves = before.halfedges.iter();
            halves.all(|half| after.contains(&half.name))
        });
        if !keeps || self.conventions.exhaustive {
            self.set_other(Statement::Set {
                pointer: Pointer::EdgeHalfedge,
                of: self.term(statement.edge.name),
                value: self.term(after[0]),
            });
        }
    }

    /// A face keeps its halfedge as long as nothing has left its loop.
    fn face(&mut self, orbit: &Loop) {
        let drawing = self.drawing;
        let face = orbit.face.name;
        let before = drawing.before.loop_of_face(face);
        let keeps = before.is_some_and(|before| {
            let mut items = before.items.iter();
            items.all(|item| drawing.after.face(item.item.name) == Some(face))
        });
        let first = orbit.items[0].item.name;
        if keeps {
            let half = (!self.is_path(first)).then(|| self.term(first));
            self.kept(face, Pointer::FaceHalfedge, half);
        } else {
            let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
            self.set_other(Statement::Set {
                pointer: Pointer::FaceHalfedge,
                of: self.term(face),
                value: match self.first_runs.iter().find(|(of, _)| *of == face) {
                    Some((_, first)) => first.clone(),
                    None => self.head(&items, 0),
                },
            });
        }
        let same_kind =
            before.map_or(orbit.kind == LoopKind::Face, |before| before.kind == orbit.kind);
        if orbit.kind != LoopKind::Any && !same_kind {
            self.set_other(Statement::SetHole {
                face: self.term(face),
                hole: orbit.kind == LoopKind::Hole,
            });
        }
    }

    /// A vertex keeps its halfedge as long as none of its spokes has left.
    fn vertex(&mut self, vertex: NameId) {
        let drawing = self.drawing;
        let drawn = drawing.after.mention(vertex).is_some();
        if !drawn || drawing.erased(vertex).is_some() {
            return;
        }
        if drawing.keeps_its_spokes(vertex) {
            let half = drawing.spoke_after(vertex).map(|half| self.term(half));
            return self.kept(vertex, Pointer::VertexHalfedge, half);
        }
        let Some((value, run)) = self.spoke_of(vertex) else {
            return;
        };
        let set = Statement::Set { pointer: Pointer::VertexHalfedge, of: self.term(vertex), value };
        match run {
            None => self.set_other(set),
            // One of the runs is not empty.
            Some(path) => self.indexed(true, |this| {
                let condition = this.names.empty(path).not();
                let body = vec![set];
                this.set_other(Statement::When { condition, body });
            }),
        }
    }

    /// A halfedge that starts at the vertex after: a named one, else the first of a path. Of a
    /// family of runs that may be empty it is that at each index, and the family is told too.
    fn spoke_of(&mut self, vertex: NameId) -> Option<(Term, Option<NameId>)> {
        let drawing = self.drawing;
        let rule = drawing.rule;
        if let Some(half) = drawing.spoke_after(vertex) {
            return Some((self.term(half), None));
        }
        let path = drawing.path_after(vertex)?;
        let certain = !drawing.is_empty_somewhere(path);
        if rule.is_member(path) && !certain && !rule.is_member(vertex) {
            return Some((self.indexed(true, |this| this.term(path)), Some(path)));
        }
        Some((self.head(&drawing.heads_after(path), 0), None))
    }
}
