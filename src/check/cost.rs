//! Cost: the quantities that the time of a rule grows with, in words.
//!
//! A drawing has a fixed size. Time grows with what is walked and not drawn: orbits that are walked
//! to find a place or to test an order, paths and fans whose pointers are rewritten, tests of a
//! guard, and what the expressions of the rule compute from the mesh. A function of the program may
//! do anything, so a call of one counts as a walk.

use std::collections::BTreeSet;

use super::guard::Obligation;
use super::matching::{Claim, Step};
use crate::diagram::{
    Around, Builtin, Collection, Drawing, Expr, ExprKind, Extent, Kind, LoopItem, NameId, Ref,
    Spoke, Type,
};

/// The quantities that the time grows with; empty if it is constant.
pub(super) fn grows_with(
    drawing: &Drawing,
    matching: &[Step],
    guard: &[Obligation],
) -> Vec<String> {
    let rule = drawing.rule;
    let cost = Cost { drawing };
    let mut grows: Vec<String> = matching.iter().filter_map(|step| cost.of_step(step)).collect();
    let first = |run: &NameId| rule.is_first(*run);
    let paths = drawing.moved_paths().filter(first);
    grows.extend(paths.map(|path| format!("the length of {}", rule.quoted(path))));
    let fans = drawing.moved_fans().filter(first);
    grows.extend(fans.map(|fan| format!("the size of {}", rule.quoted(fan))));
    let tests = guard.iter().filter(|obligation| obligation.is_test());
    grows.extend(tests.filter_map(|test| test.statement.grows_with(rule)));
    // Conditions repeated at every index count once.
    let requires = rule.requires.iter();
    let requires = requires.filter(|require| require.index.is_none_or(|index| index == 0));
    let assigned = rule.assignments.iter();
    let assigned = assigned.filter(|assignment| rule.is_first(assignment.target.name));
    let asked = requires.map(|require| &require.condition);
    for expr in asked.chain(assigned.map(|assignment| &assignment.value)) {
        expr.each(&mut |part| grows.extend(cost.of_expression(part)));
    }
    let mut seen = BTreeSet::new();
    grows.retain(|item| seen.insert(item.clone()));
    grows
}

struct Cost<'a> {
    drawing: &'a Drawing<'a>,
}

impl Cost<'_> {
    fn of_step(&self, step: &Step) -> Option<String> {
        let rule = self.drawing.rule;
        match step {
            Step::Attempt { element, tries: None, .. } | Step::Walk { orbit: element, .. } => {
                match rule.kind(*element) {
                    Kind::Vertex => Some(format!("the degree of {}", rule.quoted(*element))),
                    Kind::Face => Some(format!("the size of {}", rule.quoted(*element))),
                    _ => None,
                }
            }
            Step::Test(Claim::InOrder { along_loop, halfedges: [from, ..] }) => {
                if *along_loop {
                    let face = self.drawing.before.face(*from)?;
                    Some(format!("the size of {}", rule.quoted(face)))
                } else {
                    let vertex = self.drawing.origin_before(*from)?;
                    Some(format!("the degree of {}", rule.quoted(vertex)))
                }
            }
            _ => None,
        }
    }

    /// The walk that a part of an expression makes.
    fn of_expression(&self, expr: &Expr) -> Option<String> {
        match &expr.kind {
            ExprKind::Call(builtin, args) => self.of_call(*builtin, args),
            ExprKind::Fold(fold) => self.of_collection(&fold.collection),
            ExprKind::Invoke(..) => Some("what a function does".into()),
            _ => None,
        }
    }

    fn of_call(&self, builtin: Builtin, args: &[Expr]) -> Option<String> {
        let of = args.first()?;
        match builtin.extent() {
            Extent::Bounded => None,
            Extent::Orbit => self.around(of),
            Extent::Ends => {
                let edge = self.words(of, "an edge");
                Some(format!("the degrees of the ends of {edge}"))
            }
            Extent::Sides => {
                let edge = self.words(of, "an edge");
                let drawn = |name| self.has_whole_sides(name);
                (!is_drawn(of, drawn)).then(|| format!("the sizes of the faces at {edge}"))
            }
        }
    }

    fn of_collection(&self, collection: &Collection) -> Option<String> {
        match collection {
            Collection::All(_) => Some("the whole mesh".into()),
            Collection::Around(Around::EdgeVertices | Around::EdgeFaces, _) => None,
            Collection::Around(_, base) => self.around(base),
        }
    }

    /// The length of the orbit of a vertex or face, unless all of it is drawn.
    fn around(&self, element: &Expr) -> Option<String> {
        let (is_drawn, quantity, otherwise) = match element.ty {
            Type::Vertex => (is_drawn(element, |v| self.is_whole_star(v)), "degree", "a vertex"),
            _ => (is_drawn(element, |f| self.is_whole_loop(f)), "size", "a face"),
        };
        (!is_drawn).then(|| format!("the {quantity} of {}", self.words(element, otherwise)))
    }

    fn is_whole_star(&self, vertex: NameId) -> bool {
        let halfedge = |spoke: &Spoke| matches!(spoke, Spoke::Halfedge(_));
        let star = self.drawing.before.star(vertex);
        star.is_some_and(|star| star.spokes.iter().all(halfedge))
    }

    fn is_whole_loop(&self, face: NameId) -> bool {
        let rule = self.drawing.rule;
        let halfedge = |item: &LoopItem| rule.kind(item.item.name) == Kind::Halfedge;
        let orbit = self.drawing.before.loop_of_face(face);
        orbit.is_some_and(|orbit| orbit.items.iter().all(halfedge))
    }

    fn has_whole_sides(&self, edge: NameId) -> bool {
        let view = &self.drawing.before;
        let is_whole =
            |half: &Ref| view.face(half.name).is_some_and(|face| self.is_whole_loop(face));
        view.edge_statement(edge).is_some_and(|edge| edge.halfedges.iter().all(is_whole))
    }

    /// The name of an element, or what it is.
    fn words(&self, element: &Expr, otherwise: &str) -> String {
        match element.kind {
            ExprKind::Element(name) => self.drawing.rule.quoted(name),
            _ => otherwise.into(),
        }
    }
}

fn is_drawn(element: &Expr, is_whole: impl Fn(NameId) -> bool) -> bool {
    matches!(element.kind, ExprKind::Element(name) if is_whole(name))
}
