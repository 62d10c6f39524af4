//! Phase 1, collect: names are bound by following pointers, and what is drawn is tested.

use super::names::Names;
use super::routine::{Function, Statement, Term};
use crate::check::matching::{Bound, Claim, Source, Step};
use crate::compile::why_refused;
use crate::diagram::{Drawing, Kind, LoopKind, NameId, Pointer, Type};

/// Writes what matching does.
pub(super) struct Matching<'d, 'n> {
    pub drawing: &'d Drawing<'d>,
    pub names: &'n Names,
}

impl Matching<'_, '_> {
    /// Binds names, in order. The tests come when all are bound.
    pub fn steps(&self, steps: &[Step]) -> Vec<Statement> {
        let binds = steps.iter().filter_map(|step| match step {
            Step::Bind { name, source } => Some(Statement::Bind {
                ty: self.ty(*name),
                name: self.bound_word(*name).into(),
                value: self.source(*source),
            }),
            // A drawing with `each` is not emitted.
            Step::Walk { .. } => None,
            Step::Parameter { .. } | Step::Attempt { .. } | Step::Test(_) => None,
        });
        binds.collect()
    }

    /// Whether paths are empty, and the tests.
    pub fn distinct_and_paths(&self, steps: &[Step]) -> Vec<Statement> {
        let drawing = self.drawing;
        let mut body = Vec::new();
        for path in drawing.rule.names_of(Kind::Path) {
            if drawing.before.mention(path).is_some() && drawing.is_empty_somewhere(path) {
                let Some(next) = drawing.before.item_after(path) else {
                    continue;
                };
                body.push(Statement::Bind {
                    ty: Type::Bool,
                    name: self.names.empty(path).into(),
                    value: self.term(path).is(self.term(next)),
                });
            }
        }
        for step in steps {
            if let Step::Test(claim) = step {
                body.push(Statement::Refuse {
                    when: self.claim(claim).not(),
                    reason: why_refused(drawing, claim),
                });
            }
        }
        body
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

    fn bound_word(&self, bound: Bound) -> &str {
        match bound {
            Bound::Element(name) | Bound::First(name) => self.names.word(name),
            Bound::Last(path) => self.names.last(path),
        }
    }

    fn bound(&self, bound: Bound) -> Term {
        Term::name(self.bound_word(bound))
    }

    fn term(&self, name: NameId) -> Term {
        Term::name(self.names.word(name))
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
            // Those of a drawing with `each`, which is not emitted.
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
            Claim::InOrder {
                along_loop,
                halfedges,
            } => {
                let function = match along_loop {
                    true => Function::InOrderAlongLoop,
                    false => Function::InOrderAroundVertex,
                };
                let terms = halfedges.iter().map(|half| self.term(*half));
                Term::Call(function, terms.collect())
            }
            Claim::NotAllEmpty(paths) => {
                let mut empty =
                    paths
                        .iter()
                        .map(|&path| match self.drawing.is_empty_somewhere(path) {
                            true => Term::name(self.names.empty(path)),
                            false => Term::Bool(false),
                        });
                let first = empty.next().unwrap_or(Term::Bool(false));
                empty.fold(first, Term::and).not()
            }
        }
    }
}
