//! Phase 3, reassign: every pointer that changes, halfedge by halfedge.
//!
//! Paths that change their loop and fans that change their vertex are walked first, while
//! `next` and `twin` are still what they were.

use super::names::Names;
use super::routine::{Statement, Step, Term, Walk};
use crate::check::{moved_fans, moved_paths};
use crate::diagram::{Drawing, Edge, Kind, Loop, LoopKind, NameId, Pointer, Ref, Spoke};

/// The statements of the phase, but for the attributes.
pub(super) fn statements(drawing: &Drawing, names: &mut Names) -> Vec<Statement> {
    let mut walks = Vec::new();
    for path in moved_paths(drawing) {
        walks.extend(path_walk(drawing, names, path));
    }
    for fan in moved_fans(drawing) {
        walks.extend(fan_walk(drawing, names, fan));
    }
    let mut reassign = Reassign {
        drawing,
        names,
        halfedges: Vec::new(),
        others: Vec::new(),
    };
    reassign.all();
    let mut halfedges = reassign.halfedges;
    halfedges.sort_by_key(|set| (set.order, set.pointer));
    walks.extend(halfedges.into_iter().map(|set| set.statement));
    walks.extend(reassign.others);
    walks
}

/// The walk along a path, from its first halfedge to what follows it in `before`.
pub(super) fn along_path(
    drawing: &Drawing,
    names: &Names,
    path: NameId,
    halfedge: String,
) -> Option<Walk> {
    let next = drawing.before.item_after(path)?;
    Some(Walk {
        halfedge,
        step: Step::Next,
        from: Term::name(names.word(path)),
        until: Term::name(names.word(next)),
        around: next == path,
    })
}

fn path_walk(drawing: &Drawing, names: &mut Names, path: NameId) -> Option<Statement> {
    let face = drawing.after.face(path)?;
    let halfedge = names.fresh("h");
    names.release(&halfedge);
    let walk = along_path(drawing, names, path, halfedge.clone())?;
    Some(Statement::Walk {
        walk,
        body: vec![Statement::Set {
            pointer: Pointer::Face,
            of: Term::name(halfedge),
            value: Term::name(names.word(face)),
        }],
    })
}

/// The walk over the spokes of a fan, clockwise: from behind the spoke that follows it to the
/// spoke that precedes it.
pub(super) fn along_fan(
    drawing: &Drawing,
    names: &Names,
    fan: NameId,
    halfedge: String,
) -> Option<Walk> {
    let vertex = drawing.before.star_of_spoke(fan)?;
    let spokes = &drawing.before.star(vertex)?.spokes;
    let at = spokes
        .iter()
        .position(|spoke| matches!(spoke, Spoke::Fan(name) if name.name == fan))?;
    Some(along_spokes(drawing, names, vertex, (spokes, at), halfedge))
}

/// The walk over the run of spokes that stands at a place of a vertex statement.
pub(super) fn along_spokes(
    drawing: &Drawing,
    names: &Names,
    vertex: NameId,
    (spokes, at): (&[Spoke], usize),
    halfedge: String,
) -> Walk {
    let count = spokes.len();
    let half = |spoke: &Spoke| match spoke {
        Spoke::Halfedge(half) => Some(half.name),
        Spoke::Fan(_) | Spoke::Rest(_) => None,
    };
    let (before, after) = (
        half(&spokes[(at + count - 1) % count]),
        half(&spokes[(at + 1) % count]),
    );
    let step = Step::Clockwise;
    match (before, after) {
        (Some(before), Some(after)) => Walk {
            halfedge,
            step,
            from: match drawing.before.twin(after) {
                Some(twin) => Term::name(names.word(twin)).follow(Pointer::Next),
                None => Term::name(names.word(after))
                    .follow(Pointer::Twin)
                    .follow(Pointer::Next),
            },
            until: Term::name(names.word(before)),
            around: false,
        },
        // The fan is the whole star.
        _ => {
            let first = Term::name(names.word(vertex)).follow(Pointer::VertexHalfedge);
            Walk {
                halfedge,
                step,
                from: first.clone(),
                until: first,
                around: true,
            }
        }
    }
}

fn fan_walk(drawing: &Drawing, names: &mut Names, fan: NameId) -> Option<Statement> {
    let vertex = drawing.after.star_of_spoke(fan)?;
    let halfedge = names.fresh("h");
    names.release(&halfedge);
    let walk = along_fan(drawing, names, fan, halfedge.clone())?;
    Some(Statement::Walk {
        walk,
        body: vec![Statement::Set {
            pointer: Pointer::Vertex,
            of: Term::name(halfedge),
            value: Term::name(names.word(vertex)),
        }],
    })
}

/// A pointer of a halfedge that is set, and where it stands in the code.
struct Set {
    order: usize,
    pointer: usize,
    statement: Statement,
}

struct Reassign<'d, 'n> {
    drawing: &'d Drawing<'d>,
    names: &'n Names,
    halfedges: Vec<Set>,
    others: Vec<Statement>,
}

impl Reassign<'_, '_> {
    fn all(&mut self) {
        let rule = self.drawing.rule;
        for orbit in &rule.after.loops {
            self.orbit(orbit);
        }
        for edge in &rule.after.edges {
            self.edge(edge);
        }
        for half in rule.names_of(Kind::Halfedge) {
            self.outer_origin(half);
        }
        for vertex in rule.names_of(Kind::Vertex) {
            self.vertex(vertex);
        }
        for edge in &rule.after.edges {
            self.edge_halfedge(edge);
        }
        for orbit in &rule.after.loops {
            self.face(orbit);
        }
    }

    fn term(&self, name: NameId) -> Term {
        Term::name(self.names.word(name))
    }

    fn is_path(&self, item: NameId) -> bool {
        self.drawing.rule.kind(item) == Kind::Path
    }

    /// `next` first, then `twin`, `vertex`, `edge`, `face`; of each halfedge together.
    fn set(&mut self, name: NameId, of: Term, pointer: Pointer, value: Term) {
        let rank = match pointer {
            Pointer::Next => 0,
            Pointer::Prev => 1,
            Pointer::Twin => 2,
            Pointer::Vertex => 3,
            Pointer::Edge => 4,
            _ => 5,
        };
        self.halfedges.push(Set {
            order: name.index(),
            pointer: rank,
            statement: Statement::Set { pointer, of, value },
        });
    }

    fn pointer(&mut self, half: NameId, pointer: Pointer, value: NameId, changed: bool) {
        if changed {
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
        self.end_of(items, at, items.len() - 1, |item| {
            match self.is_path(item) {
                true => Term::name(self.names.last(item)),
                false => self.term(item),
            }
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
            ends.push((
                end(item),
                may_be_empty.then(|| Term::name(self.names.empty(item))),
            ));
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
        let drawing = self.drawing;
        let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        let count = items.len();
        for (at, item) in orbit.items.iter().enumerate() {
            let (name, next) = (item.item.name, items[(at + 1) % count]);
            if drawing.before.item_after(name) != Some(next) {
                let (tail, head) = (self.tail(&items, at), self.head(&items, (at + 1) % count));
                self.set(name, tail.clone(), Pointer::Next, head.clone());
                self.set(next, head, Pointer::Prev, tail);
            }
            if self.is_path(name) {
                continue;
            }
            let (origin, face) = (item.from.name, orbit.face.name);
            let moved = drawing.before.loop_origin(name) != Some(origin);
            self.pointer(name, Pointer::Vertex, origin, moved);
            let changed = drawing.before.face(name) != Some(face);
            self.pointer(name, Pointer::Face, face, changed);
        }
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

    /// Outer halfedges start where their vertex statement, or their drawn twin, says.
    fn outer_origin(&mut self, half: NameId) {
        let drawing = self.drawing;
        if !drawing.is_outer(half) || drawing.after.mention(half).is_none() {
            return;
        }
        if let Some(origin) = drawing.origin_after(half) {
            let changed = drawing.origin_before(half) != Some(origin);
            self.pointer(half, Pointer::Vertex, origin, changed);
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
        if !keeps {
            self.others.push(Statement::Set {
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
        if !keeps {
            let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
            self.others.push(Statement::Set {
                pointer: Pointer::FaceHalfedge,
                of: self.term(face),
                value: self.head(&items, 0),
            });
        }
        let same_kind = before.map_or(orbit.kind == LoopKind::Face, |before| {
            before.kind == orbit.kind
        });
        if orbit.kind != LoopKind::Any && !same_kind {
            self.others.push(Statement::SetHole {
                face: self.term(face),
                hole: orbit.kind == LoopKind::Hole,
            });
        }
    }

    /// A vertex keeps its halfedge as long as none of its spokes has left.
    fn vertex(&mut self, vertex: NameId) {
        let drawing = self.drawing;
        let drawn = drawing.after.mention(vertex).is_some();
        if !drawn || drawing.erased(vertex).is_some() || self.keeps_its_spokes(vertex) {
            return;
        }
        if let Some(value) = self.spoke_of(vertex) {
            self.others.push(Statement::Set {
                pointer: Pointer::VertexHalfedge,
                of: self.term(vertex),
                value,
            });
        }
    }

    fn keeps_its_spokes(&self, vertex: NameId) -> bool {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let items = rule
            .names_of(Kind::Halfedge)
            .chain(rule.names_of(Kind::Path));
        let stays = |item: NameId| {
            drawing.erased(item).is_none() && drawing.origin_after(item) == Some(vertex)
        };
        let mut spokes = items.filter(|&item| {
            drawing.before.mention(item).is_some() && drawing.origin_before(item) == Some(vertex)
        });
        let mut fans = rule
            .names_of(Kind::Fan)
            .filter(|&fan| drawing.before.star_of_spoke(fan) == Some(vertex));
        drawing.survives(vertex)
            && spokes.all(stays)
            && fans.all(|fan| drawing.after.star_of_spoke(fan) == Some(vertex))
    }

    /// A halfedge that starts at the vertex after: a named spoke, the one listed first; else
    /// the first of a path.
    fn spoke_of(&self, vertex: NameId) -> Option<Term> {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let listed = drawing.after.star(vertex).and_then(|star| {
            star.spokes.iter().find_map(|spoke| match spoke {
                Spoke::Halfedge(Ref { name, .. }) => Some(*name),
                Spoke::Fan(_) | Spoke::Rest(_) => None,
            })
        });
        let starts = |item: &NameId| {
            let drawn = drawing.after.loop_of_item(*item).is_some()
                || drawing.after.pairing(*item).is_some();
            drawn && drawing.origin_after(*item) == Some(vertex)
        };
        if let Some(half) = listed.or_else(|| rule.names_of(Kind::Halfedge).find(starts)) {
            return Some(self.term(half));
        }
        let mut paths: Vec<_> = rule.names_of(Kind::Path).filter(starts).collect();
        paths.sort_by_key(|&path| drawing.is_empty_somewhere(path));
        if !paths.is_empty() {
            paths.extend(drawing.paths_where_one(vertex));
        }
        (!paths.is_empty()).then(|| self.head(&paths, 0))
    }
}
