//! Phase 1, collect: names are bound by following pointers, and what is drawn is tested.

use super::conventions::Conventions;
use super::names::Names;
use super::routine::Statement;
use super::term::{Function, Term};
use crate::check::matching::{Bound, Claim, Source, Step};
use crate::compile::why_refused;
use crate::diagram::{Drawing, Kind, LoopKind, NameId, Pointer, Type};

/// Writes what matching does.
pub(super) struct Matching<'d, 'n> {
    pub drawing: &'d Drawing<'d>,
    pub conventions: Conventions<'d>,
    pub names: &'n mut Names,
}

impl Matching<'_, '_> {
    /// Binds names, in order. The tests come when all are bound, but for those that tell how
    /// long families are: as long as the orbit that is walked first, maybe in earlier steps.
    pub fn steps(&mut self, steps: &[Step], walked_first: Option<NameId>) -> Vec<Statement> {
        let mut body = Vec::new();
        for step in steps {
            match step {
                Step::Bind { name, source } => body.push(self.bind(*name, *source)),
                Step::Walk { orbit, halfedges } => {
                    self.walk(*orbit, halfedges, walked_first == Some(*orbit), &mut body);
                }
                Step::Attempt { element, halfedge, tries: Some(1) } => {
                    self.begin(*element, *halfedge, &mut body)
                }
                Step::Parameter { .. } | Step::Attempt { .. } | Step::Test(_) => {}
            }
        }
        body
    }

    /// The halfedge to begin with, where further ones would match alike.
    fn begin(&mut self, element: NameId, halfedge: NameId, body: &mut Vec<Statement>) {
        let rule = self.drawing.rule;
        let pointer = match rule.kind(element) {
            Kind::Vertex => Pointer::VertexHalfedge,
            Kind::Edge => Pointer::EdgeHalfedge,
            _ => Pointer::FaceHalfedge,
        };
        if pointer == Pointer::VertexHalfedge && self.conventions.isolated_vertices {
            body.push(Statement::Refuse {
                when: Term::Call(Function::IsIsolated, vec![self.term(element)]),
                reason: format!("{} is isolated: no halfedge starts there", rule.quoted(element)),
            });
        }
        body.push(Statement::Bind {
            ty: Type::Halfedge,
            name: self.names.begin(halfedge),
            value: self.term(element).follow(pointer),
        });
    }

    fn bind(&mut self, bound: Bound, source: Source) -> Statement {
        let member = self.drawing.rule.is_member(bound.name());
        let value = self.indexed(member, |this| this.source(source));
        let word = match bound {
            Bound::Element(name) | Bound::First(name) => self.names.word(name),
            Bound::Last(path) => self.names.last_word(path),
        };
        self.named(self.ty(bound), word.to_string(), value, member)
    }

    /// A name for a value, or for those of each index.
    fn named(&self, ty: Type, name: String, value: Term, member: bool) -> Statement {
        match member {
            true => Statement::Gather { ty, name, indices: self.names.indices(), item: value },
            false => Statement::Bind { ty, name, value },
        }
    }

    /// Makes a term; of members, what stands for each index.
    fn indexed(&mut self, member: bool, make: impl FnOnce(&Matching) -> Term) -> Term {
        let (drawing, conventions) = (self.drawing, self.conventions);
        self.names.for_each(member, |names| make(&Matching { drawing, conventions, names }))
    }

    /// Walks an orbit once around and deals its halfedges out to the families of a period.
    fn walk(
        &mut self,
        orbit: NameId,
        halfedges: &[NameId],
        is_first: bool,
        body: &mut Vec<Statement>,
    ) {
        let rule = self.drawing.rule;
        let ty = Type::Halfedge;
        let (function, what) = match rule.kind(orbit) {
            Kind::Vertex => (Function::SpokesFrom, "spokes"),
            _ => (Function::LoopFrom, "sides"),
        };
        let from = Term::name(self.names.begin(halfedges[0]));
        let mut all = Term::Call(function, vec![from]);
        let period = halfedges.len() as i64;
        if period > 1 {
            let name = self.names.fresh("all");
            let value = std::mem::replace(&mut all, Term::name(&name));
            body.push(Statement::BindList { ty, name, value });
            let groups = vec![all.clone(), Term::Int(period)];
            let rest = Term::Call(Function::Remainder, groups);
            body.push(Statement::Refuse {
                when: rest.equals(Term::Int(0)).not(),
                reason: format!(
                    "the number of {what} of {} is no multiple of {period}",
                    rule.quoted(orbit)
                ),
            });
        }
        for (place, &half) in (0..).zip(halfedges) {
            let mut value = all.clone();
            if period > 1 {
                let dealt = vec![value, Term::Int(place), Term::Int(period)];
                value = Term::Call(Function::Every, dealt);
            }
            let turn = rule.offset(half);
            if turn != 0 {
                value = Term::Call(Function::Turned, vec![value, Term::Int(turn)]);
            }
            let name = self.names.word(half).to_string();
            body.push(Statement::BindList { ty, name: name.clone(), value });
            let size = self.names.indices().size;
            if place > 0 {
                continue;
            }
            if !is_first {
                let length = Term::Call(Function::Length, vec![Term::name(name)]);
                body.push(Statement::Refuse {
                    when: length.equals(Term::name(size)).not(),
                    reason: format!(
                        "{} is longer, or shorter, than the families before",
                        rule.quoted(orbit)
                    ),
                });
            } else {
                body.push(Statement::Size { name: size, list: name });
            }
        }
    }

    /// The emptiness of paths, and the tests.
    pub fn distinct_and_paths(&mut self, steps: &[Step]) -> Vec<Statement> {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let mut body = Vec::new();
        for path in rule.names_of(Kind::Path).filter(|&path| rule.is_first(path)) {
            if drawing.before.mention(path).is_some() && drawing.is_empty_somewhere(path) {
                let Some(next) = drawing.before.item_after(path) else {
                    continue;
                };
                let member = rule.is_member(path);
                let value = self.indexed(member, |this| this.term(path).is(this.term(next)));
                let name = self.names.empty_word(path).to_string();
                body.push(self.named(Type::Bool, name, value, member));
            }
        }
        for step in steps {
            if let Step::Test(claim) = step {
                let holds = match claim {
                    Claim::Begins(name) => Term::name(self.names.begin(*name)).is(self.term(*name)),
                    Claim::NotAllEmptyAround(paths) => {
                        let some = self.indexed(true, |this| this.are_empty(paths).not());
                        some.for_some(self.names.indices())
                    }
                    Claim::AllDistinct(names) => self.all_distinct(names, &mut body),
                    Claim::AroundInOrder { along_loop, halfedges } => {
                        self.around_in_order(*along_loop, halfedges, &mut body)
                    }
                    claim => {
                        let repeated = claim.is_repeated(rule);
                        let when = self.indexed(repeated, |this| this.claim(claim).not());
                        match repeated {
                            true => when.for_some(self.names.indices()).not(),
                            false => when.not(),
                        }
                    }
                };
                body.push(Statement::Refuse {
                    when: holds.not(),
                    reason: why_refused(drawing, claim),
                });
            }
        }
        body
    }

    /// A list of what stands at each index, index by index.
    fn listed(&mut self, ty: Type, members: &[NameId], body: &mut Vec<Statement>) -> Term {
        let list = self.names.fresh("all");
        let rule = self.drawing.rule;
        let (each, once): (Vec<_>, Vec<_>) =
            members.iter().partition(|&&name| rule.is_member(name));
        body.push(Statement::List {
            ty,
            name: list.clone(),
            items: once.into_iter().map(|&name| self.term(name)).collect(),
        });
        let pushes = self.names.for_each(true, |names| {
            let push =
                |&&name: &&NameId| Statement::Push { list: list.clone(), item: names.term(name) };
            each.iter().map(push).collect()
        });
        body.push(Statement::IndexLoop { indices: self.names.indices(), body: pushes });
        Term::name(list)
    }

    fn all_distinct(&mut self, names: &[NameId], body: &mut Vec<Statement>) -> Term {
        let all = match names {
            [family] if self.drawing.rule.is_member(*family) => {
                Term::name(self.names.word(*family))
            }
            _ => {
                let ty =
                    names.first().map_or(Type::Halfedge, |&name| self.ty(Bound::Element(name)));
                self.listed(ty, names, body)
            }
        };
        Term::Call(Function::AllDiffer, vec![all])
    }

    fn around_in_order(
        &mut self,
        along_loop: bool,
        halfedges: &[NameId],
        body: &mut Vec<Statement>,
    ) -> Term {
        let function = match along_loop {
            true => Function::AllInOrderAlongLoop,
            false => Function::AllInOrderAroundVertex,
        };
        let all = self.listed(Type::Halfedge, halfedges, body);
        Term::Call(function, vec![all])
    }

    fn ty(&self, bound: Bound) -> Type {
        match bound {
            Bound::First(_) | Bound::Last(_) => Type::Halfedge,
            Bound::Element(name) => match self.drawing.rule.kind(name) {
                Kind::Vertex => Type::Vertex,
                Kind::Edge => Type::Edge,
                Kind::Face => Type::Face,
                Kind::Halfedge | Kind::Path | Kind::Fan => Type::Halfedge,
            },
        }
    }

    fn bound(&self, bound: Bound) -> Term {
        match bound {
            Bound::Element(name) | Bound::First(name) => self.names.term(name),
            Bound::Last(path) => self.names.last(path),
        }
    }

    fn term(&self, name: NameId) -> Term {
        self.names.term(name)
    }

    fn source(&self, source: Source) -> Term {
        let (from, pointers): (Bound, &[Pointer]) = match source {
            Source::Next(from) => (from, &[Pointer::Next]),
            Source::Prev(from) => (from, &[Pointer::Prev]),
            Source::Twin(from) => (from, &[Pointer::Twin]),
            Source::Origin(from) => (from, &[Pointer::Vertex]),
            Source::Target(from) => (from, &[Pointer::Next, Pointer::Vertex]),
            Source::Edge(from) => (from, &[Pointer::Edge]),
            Source::Face(from) => (from, &[Pointer::Face]),
            Source::Counterclockwise(from) => (from, &[Pointer::Prev, Pointer::Twin]),
            Source::Clockwise(from) => (from, &[Pointer::Twin, Pointer::Next]),
            Source::FaceHalfedge(face) => (Bound::Element(face), &[Pointer::FaceHalfedge]),
        };
        let follow = |term: Term, pointer: &Pointer| term.follow(*pointer);
        pointers.iter().fold(self.bound(from), follow)
    }

    fn claim(&self, claim: &Claim) -> Term {
        match claim {
            // These have statements of their own.
            Claim::Begins(_)
            | Claim::AllDistinct(_)
            | Claim::AroundInOrder { .. }
            | Claim::NotAllEmptyAround(_) => Term::Bool(true),
            // The same, without `prev`.
            Claim::Leads(Source::Prev(from), to) => {
                self.source(Source::Next(*to)).is(self.bound(*from))
            }
            Claim::Leads(Source::Counterclockwise(from), to) => {
                self.source(Source::Clockwise(*to)).is(self.bound(*from))
            }
            Claim::Leads(source, to) => self.source(*source).is(self.bound(*to)),
            Claim::Distinct(left, right) => self.term(*left).differs_from(self.term(*right)),
            Claim::Kind(face, LoopKind::Hole) => self.term(*face).hole(),
            Claim::Kind(face, _) => self.term(*face).hole().not(),
            Claim::InOrder { along_loop, halfedges } => {
                let function = match along_loop {
                    true => Function::InOrderAlongLoop,
                    false => Function::InOrderAroundVertex,
                };
                let terms = halfedges.iter().map(|half| self.term(*half));
                Term::Call(function, terms.collect())
            }
            Claim::NotAllEmpty(paths) => self.are_empty(paths).not(),
            Claim::Listed { halfedge, vertices: [origin, vertex], spokes } => {
                let apart = self.term(*origin).differs_from(self.term(*vertex));
                let listed = spokes.iter().map(|&spoke| self.term(*halfedge).is(self.term(spoke)));
                listed.fold(apart, Term::or)
            }
        }
    }
    /// The condition that all of these paths are empty.
    fn are_empty(&self, paths: &[NameId]) -> Term {
        let empty = |&path: &NameId| match self.drawing.is_empty_somewhere(path) {
            true => self.names.empty(path),
            false => Term::Bool(false),
        };
        let all = paths.iter().map(empty).reduce(Term::and);
        all.unwrap_or(Term::Bool(false))
    }
}
