//! Tests that compare the corners of faces.

use super::super::routine::{HalfedgeWalk, Statement, Step};
use super::super::term::{Function, Term};
use super::{Tests, Untold, has_repetition};
use crate::diagram::{Loop, LoopKind, NameId, Pointer, Type};

/// The corners of a loop of `after`: a list of those that there are, and the new ones.
struct Corners {
    face: NameId,
    kind: LoopKind,
    list: String,
    new: Vec<NameId>,
    /// The drawn ones, if there are no others.
    all_drawn: Option<Vec<NameId>>,
}

/// A face that is not drawn, and the list of its corners.
struct Undrawn {
    face: String,
    corners: String,
}

impl Tests<'_, '_> {
    /// Lists the corners of a loop of `after`.
    fn corners(&mut self, orbit: &Loop) -> Result<Corners, Untold> {
        let (mut sure, mut new, mut drawn, mut later) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut paths = Vec::new();
        for item in &orbit.items {
            let (from, path) = (item.from.name, item.item.name);
            drawn.push(from);
            let is_path = self.result.is_path(path);
            if is_path {
                paths.push(path);
            }
            if self.result.is_new(from) {
                new.push(from);
            } else if is_path && self.drawing.is_empty_somewhere(path) {
                later.push((from, path));
            } else {
                sure.push(self.term(from));
            }
        }
        let list = self.list("corners", Type::Vertex, sure);
        for (from, path) in later {
            let condition = self.names.empty(path).not();
            let item = self.term(from);
            let list = list.clone();
            let body = vec![Statement::Push { list, item }];
            self.body.push(Statement::When { condition, body });
        }
        for &path in &paths {
            let list = list.clone();
            let walk = self.inside(path, |tests, h| {
                let item = tests.result.known_origin(tests.names, h)?;
                Ok(vec![Statement::Push { list, item }])
            })?;
            self.body.extend(walk);
        }
        new.sort_unstable();
        Ok(Corners {
            face: orbit.face.name,
            kind: orbit.kind,
            list,
            new,
            all_drawn: paths.is_empty().then_some(drawn),
        })
    }

    pub(super) fn meets_twice(&mut self, face: NameId) -> Result<Term, Untold> {
        let Some(orbit) = self.drawing.after.loop_of_face(face) else {
            return Ok(Term::Bool(false));
        };
        let corners = self.corners(orbit)?;
        if has_repetition(&corners.new) {
            return Ok(Term::Bool(true));
        }
        Ok(Term::Call(Function::AllDiffer, vec![Term::name(corners.list)]).not())
    }

    pub(super) fn corner_twice(&mut self, face: NameId, vertex: NameId) -> Result<Term, Untold> {
        let Some(orbit) = self.drawing.after.loop_of_face(face) else {
            return Ok(Term::Bool(false));
        };
        let mut sure = 0;
        let mut later = Vec::new();
        let mut paths = Vec::new();
        for item in &orbit.items {
            let (from, path) = (item.from.name, item.item.name);
            let is_path = self.result.is_path(path);
            if is_path {
                paths.push(path);
            }
            match from == vertex {
                true if is_path && self.drawing.is_empty_somewhere(path) => later.push(path),
                true => sure += 1,
                false => {}
            }
        }
        if self.result.is_new(vertex) && self.result.pieces(vertex).is_empty() {
            // No undrawn spoke goes there.
            paths.clear();
        }
        if sure == 1 && later.is_empty() {
            let found = self.tally("meets", Type::Bool, Term::Bool(false));
            let change = Statement::Change { name: found.clone(), value: Term::Bool(true) };
            self.where_paths_meet(&paths, vertex, &change)?;
            return Ok(Term::name(found));
        }
        let count = self.tally("corners", Type::Int, Term::Int(sure));
        let raise = Statement::Raise { name: count.clone() };
        for path in later {
            let condition = self.names.empty(path).not();
            let body = vec![raise.clone()];
            self.body.push(Statement::When { condition, body });
        }
        self.where_paths_meet(&paths, vertex, &raise)?;
        Ok(Self::more_than_one(&count))
    }

    fn where_paths_meet(
        &mut self,
        paths: &[NameId],
        vertex: NameId,
        then: &Statement,
    ) -> Result<(), Untold> {
        for &path in paths {
            let walk = self.inside(path, |tests, h| {
                let origin = tests.result.origin(tests.names, h);
                Ok(vec![Statement::When {
                    condition: origin.is(vertex, tests.old_term(vertex)),
                    body: vec![then.clone()],
                }])
            })?;
            self.body.extend(walk);
        }
        Ok(())
    }

    /// The test that two faces around a vertex have the same corners.
    pub(super) fn same_corners_around(&mut self, vertex: NameId) -> Result<Term, Untold> {
        let same = self.tally("same", Type::Bool, Term::Bool(false));
        let mut drawn = Vec::new();
        for orbit in &self.drawing.rule.after.loops {
            if orbit.kind != LoopKind::Hole {
                drawn.push(self.corners(orbit)?);
            }
        }
        for at in 1..drawn.len() {
            for other in 0..at {
                self.compare_drawn(&drawn[other], &drawn[at], Some(vertex), &same);
            }
        }
        let around = self.undrawn_faces(vertex, &drawn, &same, true)?;
        self.body.extend(around);
        Ok(Term::name(same))
    }

    /// The test that another face around a vertex has the corners of a face.
    pub(super) fn same_corners_as(&mut self, face: NameId, vertex: NameId) -> Result<Term, Untold> {
        let same = self.tally("same", Type::Bool, Term::Bool(false));
        let mut own = None;
        let mut others = Vec::new();
        for orbit in &self.drawing.rule.after.loops {
            if orbit.face.name == face {
                own = Some(self.corners(orbit)?);
            } else if orbit.kind != LoopKind::Hole {
                others.push(orbit);
            }
        }
        let Some(own) = own else {
            return Ok(Term::Bool(false));
        };
        for orbit in others {
            let other = self.corners(orbit)?;
            self.compare_drawn(&own, &other, None, &same);
        }
        if own.new.is_empty() {
            let own = [own];
            let around = self.undrawn_faces(vertex, &own, &same, false)?;
            self.body.extend(around);
        }
        let hole = matches!(self.drawing.after.loop_of_face(face), Some(orbit) if orbit.kind == LoopKind::Any);
        let found = Term::name(same);
        Ok(match hole {
            true => self.term(face).hole().not().and(found),
            false => found,
        })
    }

    /// Notes if two loops of `after` have the same corners, with `vertex` among them.
    fn compare_drawn(&mut self, one: &Corners, two: &Corners, vertex: Option<NameId>, same: &str) {
        if one.new != two.new {
            return;
        }
        if let (Some(left), Some(right)) = (&one.all_drawn, &two.all_drawn) {
            let within =
                |some: &[NameId], all: &[NameId]| some.iter().all(|name| all.contains(name));
            if !within(left, right) || !within(right, left) {
                return;
            }
        }
        let lists = vec![Term::name(&one.list), Term::name(&two.list)];
        let mut condition = Term::Call(Function::SameElements, lists);
        if let Some(vertex) = vertex.filter(|vertex| !self.result.is_new(*vertex)) {
            let holds = vec![Term::name(&one.list), self.term(vertex)];
            condition = Term::Call(Function::Holds, holds).and(condition);
        }
        for corners in [one, two] {
            if corners.kind == LoopKind::Any {
                condition = self.term(corners.face).hole().not().and(condition);
            }
        }
        self.body.push(Statement::When { condition, body: vec![found(same)] });
    }

    /// Looks at the undrawn faces around a vertex: compares each with the drawn ones, and with
    /// each other if that is asked.
    fn undrawn_faces(
        &mut self,
        vertex: NameId,
        drawn: &[Corners],
        same: &str,
        each_other: bool,
    ) -> Result<Vec<Statement>, Untold> {
        let list = self.list("faces", Type::Face, Vec::new());
        let note = |tests: &Self, h: Term| Statement::When {
            condition: tests.is_undrawn_face(h.clone()),
            body: vec![Statement::Push { list: list.clone(), item: h.follow(Pointer::Face) }],
        };
        let mut body = self.spokes(vertex, |tests, h| Ok(vec![note(tests, h)]))?;
        for spoke in self.result.spokes_after(vertex) {
            if self.drawing.after.loop_of_item(spoke).is_none() {
                body.push(note(self, self.term(spoke)));
            }
        }
        let (one, mut each) = self.corners_of_undrawn()?;
        for corners in drawn.iter().filter(|corners| corners.new.is_empty()) {
            let lists = vec![Term::name(&one.corners), Term::name(&corners.list)];
            let mut condition = Term::Call(Function::SameElements, lists);
            if corners.kind == LoopKind::Any {
                condition = self.term(corners.face).hole().not().and(condition);
            }
            let body = vec![found(same)];
            each.push(Statement::When { condition, body });
        }
        if each_other {
            let (other, mut inner) = self.corners_of_undrawn()?;
            let lists = vec![Term::name(&one.corners), Term::name(&other.corners)];
            inner.push(Statement::When {
                condition: Term::Call(Function::SameElements, lists),
                body: vec![found(same)],
            });
            each.push(Statement::Each {
                item: other.face.clone(),
                list: list.clone(),
                body: vec![Statement::When {
                    condition: Term::name(other.face).differs_from(Term::name(&one.face)),
                    body: inner,
                }],
            });
        }
        if !drawn.iter().any(|corners| corners.new.is_empty()) && !each_other {
            return Ok(Vec::new());
        }
        body.push(Statement::Each { item: one.face, list, body: each });
        Ok(body)
    }

    /// Lists the corners of a face that is not drawn.
    fn corners_of_undrawn(&mut self) -> Result<(Undrawn, Vec<Statement>), Untold> {
        let undrawn = Undrawn { face: self.names.fresh("f"), corners: self.names.fresh("corners") };
        let halfedge = self.names.fresh("h");
        let item = self.result.known_origin(self.names, Term::name(&halfedge))?;
        let first = Term::name(&undrawn.face).follow(Pointer::FaceHalfedge);
        let body = vec![
            Statement::List { ty: Type::Vertex, name: undrawn.corners.clone(), items: Vec::new() },
            Statement::Walk {
                walk: HalfedgeWalk {
                    halfedge,
                    step: Step::Next,
                    from: first.clone(),
                    until: first,
                    around: true,
                },
                body: vec![Statement::Push { list: undrawn.corners.clone(), item }],
            },
        ];
        Ok((undrawn, body))
    }

    /// The test that the face of a halfedge is no hole and not drawn.
    fn is_undrawn_face(&self, h: Term) -> Term {
        let face = h.follow(Pointer::Face);
        let drawn = self.drawing.rule.before.loops.iter();
        let other = drawn.map(|orbit| face.clone().differs_from(self.term(orbit.face.name)));
        other.fold(face.clone().hole().not(), Term::and)
    }
}

fn found(name: &str) -> Statement {
    Statement::Change { name: name.to_string(), value: Term::Bool(true) }
}
