//! A guard that is asked on a preview: where the pieces of the result are too many to tell.
//!
//! Around families, where names may be one, and where a vertex parts whose faces are compared,
//! which case a halfedge belongs to is known only while the operation runs. There the pointers
//! of phase 3 are noted on a preview of the mesh first, and each test looks at one orbit of what
//! there would be, as the machine does.

use super::super::build::allocation;
use super::super::conventions::Conventions;
use super::super::names::Names;
use super::super::reassign;
use super::super::routine::Statement;
use super::super::term::{Function, Term};
use super::super::walks::along_path;
use crate::check::guard::{Obligation, Statement as Asked};
use crate::diagram::{Drawing, Kind, NameId, Pointer, Type};

/// The tests of a guard, in order, as a block with a preview of its own.
pub(super) fn tests(
    drawing: &Drawing,
    guard: &[Obligation],
    names: &Names,
    conventions: Conventions<'_>,
) -> Vec<Statement> {
    // What is named within the block is free again behind it.
    let names = &mut names.clone();
    let rule = drawing.rule;
    let name = names.fresh("preview");
    let mut body = allocation(rule, names);
    let changes = Conventions { exhaustive: false, ..conventions };
    body.extend(reassign::statements(drawing, names, changes));
    let mut preview = Preview {
        drawing,
        names,
        name: name.clone(),
        body: body.into_iter().filter_map(seen).collect(),
    };
    for obligation in guard.iter().filter(|obligation| obligation.is_test()) {
        preview.test(&obligation.statement);
    }
    let body = preview.body;
    vec![Statement::Foresee { preview: name, body }]
}

/// The part of a statement that any test looks at: edges and `prev` are followed by none.
fn seen(statement: Statement) -> Option<Statement> {
    let seen_of = |body: Vec<Statement>| -> Option<Vec<_>> {
        let body: Vec<_> = body.into_iter().filter_map(seen).collect();
        (!body.is_empty()).then_some(body)
    };
    Some(match statement {
        Statement::New { kind, .. } | Statement::NewEach { kind, .. } if kind == Kind::Edge => {
            return None;
        }
        Statement::Set {
            pointer: Pointer::Edge | Pointer::EdgeHalfedge | Pointer::Prev, ..
        } => return None,
        Statement::IndexLoop { indices, body } => {
            Statement::IndexLoop { indices, body: seen_of(body)? }
        }
        Statement::When { condition, body } => Statement::When { condition, body: seen_of(body)? },
        Statement::Walk { walk, body } => Statement::Walk { walk, body: seen_of(body)? },
        statement => statement,
    })
}

/// Writes tests.
struct Preview<'d, 'n> {
    drawing: &'d Drawing<'d>,
    names: &'n mut Names,
    name: String,
    body: Vec<Statement>,
}

impl Preview<'_, '_> {
    fn test(&mut self, asked: &Asked) {
        let rule = self.drawing.rule;
        let reason = asked.refusal(rule);
        let when = match asked {
            Asked::OneHoleAlong(path) => self.pinched_along(*path),
            Asked::ThreeSides(face) => self.breaks(asked, "three_sides", &[*face]),
            Asked::MeetsOnce(face) => self.breaks(asked, "meets_once", &[*face]),
            Asked::CornerOnce { face, vertex } => {
                self.breaks(asked, "corner_once", &[*face, *vertex])
            }
            Asked::FacesDiffer { vertex, .. } => self.breaks(asked, "faces_differ", &[*vertex]),
            Asked::TwoSpokes(vertex) => self.breaks(asked, "two_spokes", &[*vertex]),
            Asked::OneHole { vertex, .. } => self.breaks(asked, "one_hole", &[*vertex]),
            Asked::NeighborsDiffer { vertex, .. } => {
                self.breaks(asked, "neighbors_differ", &[*vertex])
            }
            Asked::SingleEdge { halfedge, .. } => self.breaks(asked, "single_edge", &[*halfedge]),
            Asked::CornersDiffer(vertex) => self.breaks(asked, "corners_differ", &[*vertex]),
            Asked::CornersOwn { face, vertex } => {
                self.breaks(asked, "corners_own", &[*face, *vertex])
            }
        };
        self.body.push(Statement::Refuse { when, reason });
    }

    /// The condition that something asked of these elements would not hold; of a family, for some
    /// index.
    fn breaks(&mut self, asked: &Asked, question: &'static str, of: &[NameId]) -> Term {
        let repeated = asked.is_repeated(self.drawing.rule);
        let preview = Term::name(&self.name);
        let holds = self.names.for_each(repeated, |names| {
            let of = of.iter().map(|&name| names.term(name));
            Term::Call(Function::Foreseen(question), std::iter::once(preview).chain(of).collect())
        });
        match repeated {
            true => holds.not().for_some(self.names.indices()),
            false => holds.not(),
        }
    }

    /// The condition that some vertex along a path would have corners in two holes.
    fn pinched_along(&mut self, path: NameId) -> Term {
        let pinched = self.names.fresh("pinched");
        self.body.push(Statement::Tally {
            ty: Type::Bool,
            name: pinched.clone(),
            value: Term::Bool(false),
        });
        let halfedge = self.names.fresh("h");
        let repeated = self.drawing.rule.is_member(path);
        let walk = self
            .names
            .for_each(repeated, |names| along_path(self.drawing, names, path, halfedge.clone()));
        self.names.release(&halfedge);
        let preview = || Term::name(&self.name);
        let origin =
            Term::Call(Function::Foreseen("vertex"), vec![preview(), Term::name(&halfedge)]);
        let one_hole = Term::Call(Function::Foreseen("one_hole"), vec![preview(), origin]);
        let walk = walk.map(|walk| Statement::Walk {
            walk,
            body: vec![Statement::When {
                condition: one_hole.not(),
                body: vec![Statement::Change { name: pinched.clone(), value: Term::Bool(true) }],
            }],
        });
        self.body.extend(match repeated {
            true => Some(Statement::IndexLoop {
                indices: self.names.indices(),
                body: walk.into_iter().collect(),
            }),
            false => walk,
        });
        Term::name(pinched)
    }
}
