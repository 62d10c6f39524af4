//! The guard: what the level asks of the result, asked of the mesh before anything is written.
//!
//! Each statement that the checker left to test speaks of one orbit of `after`. That orbit is
//! made of what is drawn and of pieces of orbits of `before`; so it can be looked at by walking
//! those pieces ([`result`]) and reading each pointer as it will be. Here each statement becomes
//! such a walk and a test. Where that cannot be told before the operation runs, the tests look at
//! a [`preview`] instead.

mod corners;
mod preview;
mod result;

use super::conventions::Conventions;
use super::names::Names;
use super::routine::{HalfedgeWalk, Statement};
use super::term::{Function, Term};
use crate::check::guard::{Obligation, Statement as Asked};
use crate::diagram::{Binary, Builtin, Drawing, Loop, LoopKind, NameId, Type};
use result::{FutureElement, Outcome, Untold};

/// The tests of a guard, in order.
pub(super) fn tests(
    drawing: &Drawing,
    guard: &[Obligation],
    names: &mut Names,
    conventions: Conventions<'_>,
) -> Vec<Statement> {
    if !guard.iter().any(Obligation::is_test) {
        return Vec::new();
    }
    // Name by name the result is told as if all names were known and distinct.
    let is_plain = drawing.rule.size().is_none() && drawing.rule.aliases.is_empty();
    let mut tried = names.clone();
    if is_plain && let Ok(body) = by_walks(drawing, guard, &mut tried) {
        *names = tried;
        return body;
    }
    preview::tests(drawing, guard, names, conventions)
}

fn by_walks(
    drawing: &Drawing,
    guard: &[Obligation],
    names: &mut Names,
) -> Result<Vec<Statement>, Untold> {
    let mut tests =
        Tests { result: Outcome::new(drawing, names), drawing, names, body: Vec::new() };
    for obligation in guard.iter().filter(|obligation| obligation.is_test()) {
        let reason = obligation.statement.refusal(drawing.rule);
        tests.test(&obligation.statement, reason)?;
    }
    let mut body = tests.result.lists(tests.names);
    body.append(&mut tests.body);
    Ok(body)
}

/// Writes tests.
struct Tests<'d, 'n> {
    result: Outcome<'d>,
    drawing: &'d Drawing<'d>,
    names: &'n mut Names,
    body: Vec<Statement>,
}

impl Tests<'_, '_> {
    fn test(&mut self, asked: &Asked, reason: String) -> Result<(), Untold> {
        let when = match asked {
            Asked::ThreeSides(face) => self.too_few_sides(*face),
            Asked::TwoSpokes(vertex) => self.too_few_spokes(*vertex),
            Asked::OneHole { vertex, .. } => self.more_holes(*vertex)?,
            Asked::OneHoleAlong(path) => self.more_holes_along(*path)?,
            Asked::MeetsOnce(face) => self.meets_twice(*face)?,
            Asked::CornerOnce { face, vertex } => self.corner_twice(*face, *vertex)?,
            Asked::FacesDiffer { vertex, .. } => self.face_twice(*vertex)?,
            Asked::NeighborsDiffer { vertex, .. } => self.neighbor_twice(*vertex)?,
            Asked::SingleEdge { ends, .. } => self.other_edge(*ends)?,
            Asked::CornersDiffer(vertex) => self.same_corners_around(*vertex)?,
            Asked::CornersOwn { face, vertex } => self.same_corners_as(*face, *vertex)?,
        };
        self.body.push(Statement::Refuse { when, reason });
        Ok(())
    }

    fn term(&self, name: NameId) -> Term {
        self.names.term(name)
    }

    /// The same, of what is there before anything is allocated.
    fn old_term(&self, name: NameId) -> Option<Term> {
        (!self.result.is_new(name)).then(|| self.term(name))
    }

    fn orbit(&self, face: NameId) -> Option<&Loop> {
        self.drawing.after.loop_of_face(face)
    }

    /// `count < least`
    fn fewer(count: Term, least: i64) -> Term {
        Term::Binary(Binary::LessInt, Box::new(count), Box::new(Term::Int(least)))
    }

    fn more_than_one(count: &str) -> Term {
        Term::Binary(Binary::LessInt, Box::new(Term::Int(1)), Box::new(Term::name(count)))
    }

    fn tally(&mut self, wanted: &str, ty: Type, value: Term) -> String {
        let name = self.names.fresh(wanted);
        self.body.push(Statement::Tally { ty, name: name.clone(), value });
        name
    }

    fn list(&mut self, wanted: &str, ty: Type, items: Vec<Term>) -> String {
        let name = self.names.fresh(wanted);
        self.body.push(Statement::List { ty, name: name.clone(), items });
        name
    }

    /// A walk along the halfedges of a path but the first: those that start inside of it.
    fn inside(
        &mut self,
        path: NameId,
        body: impl FnOnce(&Self, Term) -> Result<Vec<Statement>, Untold>,
    ) -> Result<Vec<Statement>, Untold> {
        let halfedge = self.names.fresh("h");
        let Some(walk) = super::walks::along_path(self.drawing, self.names, path, halfedge.clone())
        else {
            return Ok(Vec::new());
        };
        let h = Term::name(&halfedge);
        let body = body(self, h.clone())?;
        self.names.release(&halfedge);
        let condition = h.differs_from(self.term(path));
        Ok(vec![Statement::Walk { walk, body: vec![Statement::only_where(condition, body)] }])
    }

    /// The statements for each spoke of a vertex of `after` that is not drawn.
    fn spokes(
        &mut self,
        vertex: NameId,
        body: impl Fn(&Self, Term) -> Result<Vec<Statement>, Untold>,
    ) -> Result<Vec<Statement>, Untold> {
        let mut walks = Vec::new();
        for piece in self.result.pieces(vertex) {
            let halfedge = self.names.fresh("h");
            let walk = piece.walk(self.drawing, self.names, halfedge.clone());
            let h = Term::name(&halfedge);
            let inner = body(self, h.clone())?;
            self.names.release(&halfedge);
            let drawn = match &piece {
                result::Piece::Star(source) => self.result.spokes_before(*source),
                result::Piece::Run { .. } => Vec::new(),
            };
            let other = drawn.into_iter().map(|half| h.clone().differs_from(self.term(half)));
            let inner = match other.reduce(Term::and) {
                Some(condition) => vec![Statement::only_where(condition, inner)],
                None => inner,
            };
            walks.push(Statement::Walk { walk, body: inner });
        }
        Ok(walks)
    }

    fn too_few_sides(&mut self, face: NameId) -> Term {
        let Some(orbit) = self.orbit(face) else {
            return Term::Bool(false);
        };
        let mut sides = 0;
        let mut sizes: Option<Vec<(NameId, i64)>> = Some(Vec::new());
        let mut paths = Vec::new();
        for item in &orbit.items {
            if !self.result.is_path(item.item.name) {
                sides += 1;
                continue;
            }
            paths.push(item.item.name);
            // The only path of its loop before: the rest of a face of known size.
            let before = self.drawing.before.loop_of_item(item.item.name);
            let alone = before.filter(|before| {
                let others = before.items.iter();
                others.filter(|item| self.result.is_path(item.item.name)).count() == 1
            });
            match (alone, &mut sizes) {
                (Some(before), Some(sizes)) => {
                    sizes.push((before.face.name, before.items.len() as i64 - 1));
                }
                _ => sizes = None,
            }
        }
        match sizes {
            Some(sizes) => {
                let drawn: i64 = sizes.iter().map(|(_, drawn)| drawn).sum();
                let size = |(face, _): &(NameId, i64)| {
                    Term::Call(Function::Builtin(Builtin::DegreeFace), vec![self.term(*face)])
                };
                let total = sizes.iter().map(size).reduce(plus);
                match total {
                    Some(total) => Self::fewer(total, 3 - sides + drawn),
                    None => Term::Bool(sides < 3),
                }
            }
            None => {
                let count = self.tally("sides", Type::Int, Term::Int(sides));
                for path in paths {
                    let halfedge = self.names.fresh("h");
                    let walk = super::walks::along_path(self.drawing, self.names, path, halfedge);
                    let body = vec![Statement::Raise { name: count.clone() }];
                    let walk = walk.map(|walk| Statement::Walk { walk, body });
                    self.body.extend(walk);
                }
                Self::fewer(Term::name(count), 3)
            }
        }
    }

    fn too_few_spokes(&mut self, vertex: NameId) -> Term {
        let drawn = self.result.spokes_after(vertex).len() as i64;
        let pieces = self.result.pieces(vertex);
        let mut hidden = 0;
        let mut degrees = Vec::new();
        for piece in &pieces {
            if let result::Piece::Star(source) = piece {
                hidden += self.result.spokes_before(*source).len() as i64;
                let degree = Function::Builtin(Builtin::DegreeVertex);
                degrees.push(Term::Call(degree, vec![self.term(*source)]));
            }
        }
        if degrees.len() == pieces.len() {
            return match degrees.into_iter().reduce(plus) {
                Some(total) => Self::fewer(total, 2 - drawn + hidden),
                None => Term::Bool(drawn < 2),
            };
        }
        let count = self.tally("spokes", Type::Int, Term::Int(drawn));
        let raise = |_: &Self, _: Term| Ok(vec![Statement::Raise { name: count.clone() }]);
        if let Ok(walks) = self.spokes(vertex, raise) {
            self.body.extend(walks);
        }
        Self::fewer(Term::name(count), 2)
    }

    fn more_holes(&mut self, vertex: NameId) -> Result<Term, Untold> {
        let mut sure = 0;
        let mut asked = Vec::new();
        for spoke in self.result.spokes_after(vertex) {
            match self.drawing.after.loop_of_item(spoke) {
                Some(orbit) if orbit.kind == LoopKind::Hole => sure += 1,
                Some(orbit) if orbit.kind == LoopKind::Face => {}
                Some(orbit) => asked.push(self.term(orbit.face.name).hole()),
                None => asked.push(self.result.hole(self.names, self.term(spoke))),
            }
        }
        let count = self.tally("holes", Type::Int, Term::Int(sure));
        let raise = || Statement::Raise { name: count.clone() };
        for condition in asked {
            let body = vec![raise()];
            self.body.push(Statement::When { condition, body });
        }
        let walks = self.spokes(vertex, |tests, h| {
            let condition = tests.result.hole(tests.names, h);
            Ok(vec![Statement::When { condition, body: vec![raise()] }])
        })?;
        self.body.extend(walks);
        Ok(Self::more_than_one(&count))
    }

    fn more_holes_along(&mut self, path: NameId) -> Result<Term, Untold> {
        let pinched = self.tally("pinched", Type::Bool, Term::Bool(false));
        let holes = self.names.fresh("holes");
        let spoke = self.names.fresh("s");
        let condition = self.result.hole(self.names, Term::name(&spoke));
        let walk = self.inside(path, |_, h| {
            Ok(vec![
                Statement::Tally { ty: Type::Int, name: holes.clone(), value: Term::Int(0) },
                Statement::Walk {
                    walk: HalfedgeWalk {
                        halfedge: spoke.clone(),
                        step: super::routine::Step::Clockwise,
                        from: h.clone(),
                        until: h,
                        around: true,
                    },
                    body: vec![Statement::When {
                        condition,
                        body: vec![Statement::Raise { name: holes.clone() }],
                    }],
                },
                Statement::When {
                    condition: Self::more_than_one(&holes),
                    body: vec![Statement::Change {
                        name: pinched.clone(),
                        value: Term::Bool(true),
                    }],
                },
            ])
        })?;
        self.body.extend(walk);
        Ok(Term::name(pinched))
    }

    fn face_twice(&mut self, vertex: NameId) -> Result<Term, Untold> {
        let mut drawn = Vec::new();
        let mut told = Vec::new();
        for spoke in self.result.spokes_after(vertex) {
            match self.drawing.after.face(spoke) {
                Some(face) => drawn.push(face),
                None => told.push(self.result.face(self.names, self.term(spoke))),
            }
        }
        let tell = |tests: &Self, h| tests.result.face(tests.names, h);
        self.any_twice(vertex, ("faces", Type::Face), drawn, told, tell)
    }

    fn neighbor_twice(&mut self, vertex: NameId) -> Result<Term, Untold> {
        let mut drawn = Vec::new();
        let mut told = Vec::new();
        for spoke in self.result.spokes_after(vertex) {
            match self.drawing.target_after(spoke) {
                Some(end) => drawn.push(end),
                None => told.push(self.result.end(self.names, self.term(spoke))),
            }
        }
        let tell = |tests: &Self, h| tests.result.end(tests.names, h);
        self.any_twice(vertex, ("neighbors", Type::Vertex), drawn, told, tell)
    }

    /// The test that two spokes of a vertex have the same: those that are drawn, as told of drawn
    /// spokes, and as told of the others. What is there already is listed, what is new counted.
    fn any_twice(
        &mut self,
        vertex: NameId,
        (wanted, ty): (&str, Type),
        drawn: Vec<NameId>,
        told: Vec<FutureElement>,
        tell: impl Fn(&Self, Term) -> FutureElement,
    ) -> Result<Term, Untold> {
        let (new, old): (Vec<_>, Vec<_>) =
            drawn.into_iter().partition(|&name| self.result.is_new(name));
        if has_repetition(&new) {
            return Ok(Term::Bool(true));
        }
        let mut items: Vec<_> = old.into_iter().map(|name| self.term(name)).collect();
        let mut later = Vec::new();
        for told in told {
            match told.new.is_empty() {
                true => items.push(told.other),
                false => later.push(told),
            }
        }
        let list = self.list(wanted, ty, items);
        let mut counts: Vec<(NameId, String)> = Vec::new();
        let probe = tell(self, Term::name(&list));
        let all = later.iter().chain([&probe]).flat_map(|told| &told.new);
        let mut all: Vec<_> = all.map(|(_, name)| *name).collect();
        all.sort_unstable();
        all.dedup();
        for name in all {
            let count = i64::from(new.contains(&name));
            let count = self.tally("count", Type::Int, Term::Int(count));
            counts.push((name, count));
        }
        for told in later {
            let body = note(told, &list, &counts);
            self.body.extend(body);
        }
        let walks = self.spokes(vertex, |tests, h| Ok(note(tell(tests, h), &list, &counts)))?;
        self.body.extend(walks);
        let twice = Term::Call(Function::AllDiffer, vec![Term::name(list)]).not();
        let counts = counts.iter().map(|(_, count)| Self::more_than_one(count));
        Ok(counts.fold(twice, Term::or))
    }

    fn other_edge(&mut self, [from, to]: [NameId; 2]) -> Result<Term, Untold> {
        let mut drawn = 0;
        for spoke in self.result.spokes_after(from) {
            drawn += i64::from(self.drawing.target_after(spoke) == Some(to));
        }
        if drawn > 1 {
            return Ok(Term::Bool(true));
        }
        if drawn == 1 && self.result.is_only_undrawn(from, to) {
            let adjacent = Function::Builtin(Builtin::Adjacent);
            return Ok(Term::Call(adjacent, vec![self.term(from), self.term(to)]));
        }
        let count = self.tally("edges", Type::Int, Term::Int(drawn));
        let walks = self.spokes(from, |tests, h| {
            let end = tests.result.end(tests.names, h);
            let condition = end.is(to, tests.old_term(to));
            Ok(vec![Statement::When {
                condition,
                body: vec![Statement::Raise { name: count.clone() }],
            }])
        })?;
        self.body.extend(walks);
        Ok(Self::more_than_one(&count))
    }
}

/// Lists what a halfedge will have, or counts it if it is new.
fn note(told: FutureElement, list: &str, counts: &[(NameId, String)]) -> Vec<Statement> {
    let push = Statement::Push { list: list.to_string(), item: told.other.clone() };
    let mut body = match told.is_known() {
        Some(condition) => vec![Statement::only_where(condition, vec![push])],
        None => vec![push],
    };
    for (condition, name) in told.new {
        if let Some((_, count)) = counts.iter().find(|(of, _)| *of == name) {
            body.push(Statement::When {
                condition,
                body: vec![Statement::Raise { name: count.clone() }],
            });
        }
    }
    body
}

fn plus(left: Term, right: Term) -> Term {
    Term::Binary(Binary::AddInt, Box::new(left), Box::new(right))
}

fn has_repetition(names: &[NameId]) -> bool {
    (1..names.len()).any(|at| names[..at].contains(&names[at]))
}
