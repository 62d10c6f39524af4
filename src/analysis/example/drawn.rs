//! A patch of a mesh, before and after, as a rule.

use glam::DVec3;

use super::patch::Patch;
use super::trial::Trial;
use crate::diagram::{
    Access, Assignment, Builtin, Edge, Example, Expr, ExprKind, Kind, Loop, LoopItem, LoopKind,
    Name, NameId, Ref, Role, Rule, Side, Type,
};
use crate::mesh::{Element, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};
use crate::resolve::{Block, ResolvedOp, StatementKind, Steps};
use crate::source::Span;

/// Positions closer to each other than this are the same.
const SAME: f64 = 1e-9;

/// The rule that shows an example. Elements have the names that the op gives to its parameters and
/// its result; others have none.
pub(super) fn rule(op: &ResolvedOp, trial: &Trial, patch: &Patch) -> Rule {
    let mut writer = Writer { trial, patch, names: Vec::new(), known: Vec::new() };
    let before = writer.side(&trial.before, Moment::Before);
    let after = writer.side(&trial.after, Moment::After);
    let params: Vec<_> =
        trial.place.iter().map(|of| of.and_then(|of| writer.find(of, Moment::Before))).collect();
    for (param, name) in op.params.iter().zip(&params) {
        if let Some(name) = name {
            writer.call(*name, param.name.clone());
        }
    }
    let result = trial.result.and_then(|of| writer.find(of, Moment::After));
    if let (Some(name), Some(word)) = (result, word_of_result(op)) {
        writer.call(name, word);
    }
    let listed = |is_there: &dyn Fn(&Side, NameId) -> bool| {
        let all = (0..writer.names.len() as u32).map(NameId);
        all.filter(|&name| is_there(&before, name) != is_there(&after, name)).collect::<Vec<_>>()
    };
    let only = listed(&|side, name| stands(side, name));
    let (created, erased): (Vec<_>, Vec<_>) =
        only.into_iter().partition(|&name| stands(&after, name));
    let assignments = writer.positions(&before);
    let places = writer.places();
    Rule {
        example: Some(Example { mesh: trial.on, places }),
        names: writer.names,
        params,
        result: result.map(Ref::unwritten),
        before,
        after,
        created: created.into_iter().map(Ref::unwritten).collect(),
        erased: erased.into_iter().map(Ref::unwritten).collect(),
        assignments,
        ..Rule::default()
    }
}

/// True if a side draws a name.
fn stands(side: &Side, name: NameId) -> bool {
    let is = |mention: &Ref| mention.name == name;
    let in_loops = side.loops.iter().any(|orbit| {
        let mut items = orbit.items.iter();
        is(&orbit.face) || items.any(|item| is(&item.from) || is(&item.item))
    });
    in_loops || side.edges.iter().any(|edge| is(&edge.edge))
}

/// The name that the steps give to what they return, or a letter for it.
fn word_of_result(op: &ResolvedOp) -> Option<String> {
    let letter = &op.result?.word()[..1];
    let steps = op.steps.as_ref();
    let word = steps.and_then(|steps| returned(steps, &steps.body.block));
    Some(word.unwrap_or_else(|| letter.to_owned()))
}

/// The variable that a block returns.
fn returned(steps: &Steps, block: &Block) -> Option<String> {
    block.iter().rev().find_map(|statement| match &statement.kind {
        StatementKind::Return(Some(value)) => match value.kind {
            ExprKind::Local(variable) => {
                let variable = steps.body.variables.get(variable as usize);
                variable.map(|variable| variable.name.clone())
            }
            _ => None,
        },
        StatementKind::If { then, otherwise, .. }
        | StatementKind::Apply { then, otherwise, .. } => {
            returned(steps, otherwise).or_else(|| returned(steps, then))
        }
        _ => None,
    })
}

/// A mesh element that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Thing {
    /// An element; a new one may reuse the index of an erased one.
    Element { of: Element, is_new: bool },
    /// The part of a hole that is not drawn, by its first halfedge.
    Path(HalfedgeId),
}

/// A side of the drawing.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Moment {
    Before,
    After,
}

/// Writes both sides, with one name for each thing.
struct Writer<'t> {
    trial: &'t Trial,
    patch: &'t Patch,
    names: Vec<Name>,
    /// For each name what it stands for.
    known: Vec<Thing>,
}

impl Writer<'_> {
    fn thing(&self, of: Element, when: Moment) -> Thing {
        let is_new = when == Moment::After && self.trial.created.contains(&of);
        Thing::Element { of, is_new }
    }

    fn find(&self, of: Element, when: Moment) -> Option<NameId> {
        let thing = self.thing(of, when);
        let at = self.known.iter().position(|known| *known == thing);
        at.map(|at| NameId(at as u32))
    }

    fn put(&mut self, thing: Thing) -> Ref {
        let known = self.known.iter().position(|known| *known == thing);
        let at = known.unwrap_or_else(|| {
            let (kind, letter, number) = match thing {
                Thing::Path(first) => (Kind::Path, "P", first.0),
                Thing::Element { of, .. } => (of.kind.into(), &of.kind.name()[..1], of.index),
            };
            self.names.push(Name {
                text: format!("{letter}{number}"),
                kind,
                named: false,
                role: Role::Single,
                span: Span::default(),
            });
            self.known.push(thing);
            self.known.len() - 1
        });
        Ref::unwritten(NameId(at as u32))
    }

    /// Gives a name a word if it has none, with primes if the word is taken.
    fn call(&mut self, name: NameId, mut word: String) {
        while self.names.iter().any(|of| of.named && of.text == word) {
            word.push('\'');
        }
        let name = &mut self.names[name.index()];
        if !name.named {
            (name.text, name.named) = (word, true);
        }
    }

    fn side(&mut self, mesh: &Mesh, when: Moment) -> Side {
        let mut side = Side::default();
        let loops = &self.patch.loops[when as usize];
        for &face in loops {
            side.loops.push(self.orbit(mesh, face, when));
        }
        let drawn =
            |h: HalfedgeId| !self.patch.hidden.contains(&h) && loops.contains(&mesh.face(h));
        let pairs = loops.iter().flat_map(|&f| mesh.face_halfedges(f)).map(|h| (h, mesh.twin(h)));
        let pairs = pairs.filter(|&(h, twin)| h < twin && drawn(h) && drawn(twin));
        for (h, twin) in pairs.collect::<Vec<_>>() {
            let mut put = |of: Element| self.put(self.thing(of, when));
            side.edges.push(Edge {
                edge: put(mesh.edge(h).into()),
                halfedges: [put(h.into()), put(twin.into())],
                span: Span::default(),
            });
        }
        side
    }

    fn orbit(&mut self, mesh: &Mesh, face: FaceId, when: Moment) -> Loop {
        let hidden = &self.patch.hidden;
        let mut around: Vec<_> = mesh.face_halfedges(face).collect();
        // Starts after a drawn halfedge, so that a path is not cut in two.
        let drawn = around.iter().rposition(|h| !hidden.contains(h));
        around.rotate_left(drawn.map_or(0, |drawn| (drawn + 1) % mesh.face_size(face)));
        let mut items: Vec<LoopItem> = Vec::new();
        let mut is_on_path = false;
        for h in around {
            let is_hidden = hidden.contains(&h);
            if !(is_hidden && is_on_path) {
                let from = self.thing(mesh.vertex(h).into(), when);
                let item = if is_hidden { Thing::Path(h) } else { self.thing(h.into(), when) };
                items.push(LoopItem { from: self.put(from), item: self.put(item) });
            }
            is_on_path = is_hidden;
        }
        Loop {
            kind: if mesh.is_hole(face) { LoopKind::Hole } else { LoopKind::Face },
            face: self.put(self.thing(face.into(), when)),
            end: items[0].from,
            items,
            each: false,
            span: Span::default(),
        }
    }

    /// The positions of the vertices, if all are in the plane, nothing is hidden and no two
    /// coincide.
    fn places(&self) -> [Vec<Option<[f64; 2]>>; 2] {
        let Trial { before, after, .. } = self.trial;
        let is_flat = |mesh: &Mesh| mesh.vertices().all(|v| mesh.position(v).z == 0.0);
        if !self.patch.is_spread
            || !self.patch.hidden.is_empty()
            || !is_flat(before)
            || !is_flat(after)
        {
            return [Vec::new(), Vec::new()];
        }
        let side = |mesh: &Mesh, when: Moment| {
            let place = |thing: &Thing| match *thing {
                Thing::Element { of, is_new } if of.kind == ElementKind::Vertex => {
                    let v = VertexId(of.index);
                    let lives = mesh.vertex_alive(v) && (when == Moment::After || !is_new);
                    lives.then(|| mesh.position(v).truncate().to_array())
                }
                _ => None,
            };
            self.known.iter().map(place).collect()
        };
        [side(before, Moment::Before), side(after, Moment::After)]
    }

    /// Assignments of the positions of vertices that are new or have moved.
    fn positions(&self, before: &Side) -> Vec<Assignment> {
        let Trial { before: was, after, .. } = self.trial;
        let set = self.known.iter().enumerate().filter_map(|(at, thing)| {
            let Thing::Element { of, is_new } = *thing else { return None };
            let v = VertexId(of.index);
            let lives = of.kind == ElementKind::Vertex && after.vertex_alive(v);
            let to = lives.then(|| after.position(v))?;
            let is_set = is_new || (was.vertex_alive(v) && was.position(v) != to);
            is_set.then(|| Assignment {
                target: Ref::unwritten(NameId(at as u32)),
                attribute: Access::Position,
                value: self.position(before, to),
                span: Span::default(),
            })
        });
        set.collect()
    }

    /// A position as an expression over `before`: the middle of a face or a point of an edge, if it
    /// is one, else its coordinates.
    fn position(&self, before: &Side, to: DVec3) -> Expr {
        let was = &self.trial.before;
        let place = |name: NameId| match self.known.get(name.index()) {
            Some(Thing::Element { of, is_new: false }) => was.get_position(VertexId(of.index)),
            _ => None,
        };
        let middle = before.loops.iter().find(|orbit| {
            let places = orbit.items.iter().map(|item| place(item.from.name));
            let places: Vec<_> = places.flatten().collect();
            let middle = places.iter().sum::<DVec3>() / places.len().max(1) as f64;
            (middle - to).length() < SAME
        });
        if let Some(orbit) = middle {
            let face = value(Type::Face, ExprKind::Element(orbit.face.name));
            return value(Type::Vec3, ExprKind::Call(Builtin::CentroidFace, vec![face]));
        }
        let items = before.loops.iter().flat_map(|orbit| {
            let ends = orbit.items.iter().skip(1).map(|item| item.from);
            orbit.items.iter().zip(ends.chain([orbit.end]))
        });
        for (item, end) in items {
            let ends = [item.from.name, end.name];
            let [Some(a), Some(b)] = ends.map(place) else { continue };
            let way = b - a;
            let share = (to - a).dot(way) / way.length_squared();
            if (0.0..=1.0).contains(&share) && (a + way * share - to).length() < SAME {
                let position = |name| {
                    let vertex = value(Type::Vertex, ExprKind::Element(name));
                    let read = ExprKind::Read(Access::Position, Box::new(vertex));
                    value(Type::Vec3, read)
                };
                let [a, b] = ends.map(position);
                let share = value(Type::Real, ExprKind::Real(share));
                let mix = ExprKind::Call(Builtin::MixVector, vec![a, b, share]);
                return value(Type::Vec3, mix);
            }
        }
        let parts = to.to_array().map(|part| value(Type::Real, ExprKind::Real(part)));
        value(Type::Vec3, ExprKind::Vector(parts.to_vec()))
    }
}

fn value(ty: Type, kind: ExprKind) -> Expr {
    let span = Span::default();
    Expr { ty, kind, span }
}
