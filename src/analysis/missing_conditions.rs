//! The `require` that a rule needs to keep the level that its op declares.
//!
//! Nothing is guessed: a condition is offered only if the checker no longer raises the diagnostic
//! for a copy of the op that requires it.

use super::edits::indentation;
use super::snapshot::Snapshot;
use crate::check::check;
use crate::diagnostic::{Diagnostic, Edit};
use crate::diagram::{
    self, Builtin, Drawing, Expr, ExprKind, Kind, NameId, Require, Rule, Type, Unary,
};
use crate::source::Span;
use crate::syntax::tree;

/// The most conditions that are tried: each costs a proof.
const MOST_TRIED: usize = 12;

/// A condition that a rule may require, in the diagram and as it is written.
struct Demand {
    condition: Expr,
    text: String,
    /// The reason that a refusal gives.
    reason: String,
}

/// Proposals of conditions that fix a diagnostic about `keeps`, each with the edits that insert it.
pub(super) fn lacking(snapshot: &Snapshot, told: &Diagnostic) -> Vec<(String, Vec<Edit>)> {
    let Some((_, op)) = snapshot.op_at(told.span().start as usize) else { return Vec::new() };
    let known = snapshot.resolved(op).map(|at| &snapshot.program().ops[at]);
    let Some(diagram) = known.and_then(|known| known.diagram.as_ref()) else { return Vec::new() };
    let mut found = Vec::new();
    let mut left = MOST_TRIED;
    for (at, (rule, written)) in diagram.rules.iter().zip(&op.rules).enumerate() {
        let mut demands = demands(rule);
        demands.truncate(left);
        left -= demands.len();
        for demand in demands {
            if mends(diagram, at, &demand, told) {
                let title = format!("insert `require {}`", demand.text);
                found.extend(
                    written_before_after(snapshot, written, &demand)
                        .map(|edit| (title, vec![edit])),
                );
            }
        }
    }
    found
}

fn mends(op: &diagram::Op, rule: usize, demand: &Demand, told: &Diagnostic) -> bool {
    let mut asking = op.clone();
    asking.rules[rule].requires.push(Require {
        condition: demand.condition.clone(),
        reason: String::new(),
        index: None,
        span: told.span(),
    });
    let is_same = |other: &Diagnostic| other.code == told.code && other.message == told.message;
    match check(&asking) {
        Ok(_) => true,
        Err(wrong) => !wrong.iter().any(is_same),
    }
}

/// The conditions that could be required: that the ends of an edge of `after` are not adjacent yet,
/// and the link condition of an edge that is erased.
fn demands(rule: &Rule) -> Vec<Demand> {
    let drawing = Drawing::new(rule);
    let mut demands = Vec::new();
    for edge in rule.names_of(Kind::Edge) {
        if drawing.erased(edge).is_some() {
            demands.push(link_condition(rule, edge));
            continue;
        }
        let Some(drawn) = drawing.after.edge_statement(edge) else { continue };
        let ends = drawn.halfedges.each_ref().map(|half| drawing.origin_after(half.name));
        if let [Some(one), Some(other)] = ends
            && one != other
            && [one, other].into_iter().all(|end| drawing.survives(end))
        {
            demands.push(not_adjacent(rule, one, other));
        }
    }
    demands
}

fn element(rule: &Rule, name: NameId, ty: Type) -> Expr {
    Expr { ty, kind: ExprKind::Element(name), span: rule.span }
}

fn link_condition(rule: &Rule, edge: NameId) -> Demand {
    let of = &rule.name(edge).text;
    Demand {
        condition: Expr {
            ty: Type::Bool,
            kind: ExprKind::Call(Builtin::LinkCondition, vec![element(rule, edge, Type::Edge)]),
            span: rule.span,
        },
        text: format!("link_condition({of})"),
        reason: format!("the link condition of {of} does not hold"),
    }
}

fn not_adjacent(rule: &Rule, one: NameId, other: NameId) -> Demand {
    let vertices = [one, other].map(|end| element(rule, end, Type::Vertex));
    let adjacent = Expr {
        ty: Type::Bool,
        kind: ExprKind::Call(Builtin::Adjacent, vertices.to_vec()),
        span: rule.span,
    };
    let [one, other] = [one, other].map(|end| &rule.name(end).text);
    Demand {
        condition: Expr {
            ty: Type::Bool,
            kind: ExprKind::Unary(Unary::Not, Box::new(adjacent)),
            span: rule.span,
        },
        text: format!("not adjacent({one}, {other})"),
        reason: format!("the edge {one} {other} is already there"),
    }
}

/// The edit that inserts a `require` on a line before `after`.
fn written_before_after(snapshot: &Snapshot, rule: &tree::Rule, demand: &Demand) -> Option<Edit> {
    let place: Span = rule.after.as_ref()?.span;
    let indentation = indentation(snapshot, place);
    Some(Edit {
        span: place.before(),
        text: format!("require {} else \"{}\"\n{indentation}", demand.text, demand.reason),
    })
}
