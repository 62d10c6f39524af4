//! Phase 1, collect: names are bound by following pointers, and what is drawn is tested.

use super::conventions::Conventions;
use super::names::Names;
use super::routine::{Statement, type_of};
use super::term::Term;
use crate::check::matching::{Bound, Claim, Source};
use crate::diagram::{Drawing, LoopKind, NameId, Pointer, Type};
use crate::lower::{self, Begin, EmptyPath, Step, Walk};

/// Emits the statements of matching.
pub(super) struct Matching<'d, 'n> {
    pub drawing: &'d Drawing<'d>,
    pub conventions: Conventions<'d>,
    pub names: &'n mut Names,
}

impl Matching<'_, '_> {
    /// Binds names, in order.
    pub fn steps(&mut self, steps: &[Step]) -> Vec<Statement> {
        let mut body = Vec::new();
        for step in steps {
            match step {
                Step::Given(_) => {}
                Step::Begin(begin) => self.begin(begin, &mut body),
                Step::Walk(walk) => self.walk(walk, &mut body),
                Step::Bind { bound, source, at_each_index } => {
                    body.push(self.bind(*bound, *source, *at_each_index));
                }
            }
        }
        body
    }

    /// Binds the halfedge to begin with, where no other has to be tried.
    fn begin(&mut self, begin: &Begin, body: &mut Vec<Statement>) {
        let element = self.term(begin.element);
        if let (Some(reason), true) = (&begin.isolated, self.conventions.isolated_vertices) {
            let when = Term::call("IsIsolated", vec![element.clone()]);
            body.push(self.names.refusal(when, false, reason));
        }
        let (name, value) = (self.names.begin(begin.halfedge), element.follow(begin.first));
        body.push(self.names.bound(Type::Halfedge, name, value, false));
    }

    fn bind(&mut self, bound: Bound, source: Source, member: bool) -> Statement {
        let value = self.indexed(member, |this| this.source(source));
        let word = match bound {
            Bound::Element(name) | Bound::First(name) => self.names.word(name),
            Bound::Last(path) => self.names.last_word(path),
        };
        self.names.bound(self.ty(bound), word.to_string(), value, member)
    }

    /// Makes a term; if `member`, the term for each index.
    fn indexed(&mut self, member: bool, make: impl FnOnce(&Matching) -> Term) -> Term {
        let (drawing, conventions) = (self.drawing, self.conventions);
        self.names.for_each(member, |names| make(&Matching { drawing, conventions, names }))
    }

    /// Walks an orbit once around and distributes its halfedges among the families of a period.
    fn walk(&mut self, walk: &Walk, body: &mut Vec<Statement>) {
        let ty = Type::Halfedge;
        let function = match walk.around_vertex {
            true => "SpokesFrom",
            false => "LoopFrom",
        };
        let from = Term::name(self.names.begin(walk.families[0].0));
        let mut all = Term::call(function, vec![from]);
        let period = walk.families.len() as i64;
        if let Some(test) = &walk.is_whole {
            let name = self.names.fresh("all");
            let value = std::mem::replace(&mut all, Term::name(&name));
            body.push(Statement::Bind { ty, name, value, is_list: true });
            let groups = vec![all.clone(), Term::Int(period)];
            let rest = Term::call("Remainder", groups);
            let when = rest.equals(Term::Int(0)).not();
            body.push(self.names.refusal(when, false, &test.refusal));
        }
        for (place, &(half, turn)) in (0..).zip(&walk.families) {
            let mut value = all.clone();
            if period > 1 {
                let dealt = vec![value, Term::Int(place), Term::Int(period)];
                value = Term::call("Every", dealt);
            }
            if turn != 0 {
                value = Term::call("Rotated", vec![value, Term::Int(turn)]);
            }
            let name = self.names.word(half).to_string();
            body.push(Statement::Bind { ty, name: name.clone(), value, is_list: true });
            let size = self.names.indices.size.clone();
            if place > 0 {
                continue;
            }
            body.push(match &walk.fits {
                Some(test) => {
                    let length = Term::call("Length", vec![Term::name(name)]);
                    let when = length.equals(Term::name(size)).not();
                    self.names.refusal(when, false, &test.refusal)
                }
                None => Statement::Size { name: size, list: name },
            });
        }
    }

    /// Binds whether paths are empty, and emits the tests.
    pub fn empty_paths_and_tests(&mut self, matching: &lower::Matching) -> Vec<Statement> {
        let mut body = Vec::new();
        for &EmptyPath { path, next, at_each_index } in &matching.empty_paths {
            let value = self.indexed(at_each_index, |this| this.term(path).is(this.term(next)));
            let name = self.names.empty_word(path).to_string();
            body.push(self.names.bound(Type::Bool, name, value, at_each_index));
        }
        for test in &matching.tests {
            let holds = match &test.condition {
                Claim::Begins(name) => Term::name(self.names.begin(*name)).is(self.term(*name)),
                Claim::NotAllEmptyAround(paths) => {
                    let some = self.indexed(true, |this| this.are_empty(paths).not());
                    some.for_some(self.names.indices.clone())
                }
                Claim::AllDistinct(names) => self.all_distinct(names, &mut body),
                Claim::AroundInOrder { along_loop, halfedges } => {
                    self.around_in_order(*along_loop, halfedges, &mut body)
                }
                claim => {
                    let each = test.at_each_index;
                    let when = self.indexed(each, |this| this.claim(claim).not());
                    body.push(self.names.refusal(when, each, &test.refusal));
                    continue;
                }
            };
            body.push(self.names.refusal(holds.not(), false, &test.refusal));
        }
        body
    }

    /// A list of elements: those that are no members, then the members index by index.
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
        body.push(Statement::IndexLoop { indices: self.names.indices.clone(), body: pushes });
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
        Term::call("AllDiffer", vec![all])
    }

    fn around_in_order(
        &mut self,
        along_loop: bool,
        halfedges: &[NameId],
        body: &mut Vec<Statement>,
    ) -> Term {
        let function = match along_loop {
            true => "AllInOrderAlongLoop",
            false => "AllInOrderAroundVertex",
        };
        let all = self.listed(Type::Halfedge, halfedges, body);
        Term::call(function, vec![all])
    }

    fn ty(&self, bound: Bound) -> Type {
        match bound {
            Bound::First(_) | Bound::Last(_) => Type::Halfedge,
            Bound::Element(name) => type_of(self.drawing.rule.kind(name)),
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
        let follow = |term: Term, pointer: &Pointer| term.follow(*pointer);
        source.pointers().iter().fold(self.bound(source.from()), follow)
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
                    true => "InOrderAlongLoop",
                    false => "InOrderAroundVertex",
                };
                let terms = halfedges.iter().map(|half| self.term(*half));
                Term::call(function, terms.collect())
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
