//! Conditions that no place fulfils where the drawing holds.

use crate::diagnostic::Diagnostic;
use crate::diagram::{
    self, Binary, Builtin, Drawing, Expr, ExprKind, Loop, LoopKind, NameId, Pointer, Unary,
};

/// A warning for each `require` of an op that contradicts `before`, so that every place is refused.
pub(super) fn always_refused(op: &diagram::Op) -> Vec<Diagnostic> {
    let warnings = op.rules.iter().flat_map(|rule| {
        let drawing = Drawing::new(rule);
        rule.requires.iter().filter_map(move |require| {
            let Said { holds: false, because } = said(&require.condition, &drawing)? else {
                return None;
            };
            let message = format!("this `require` refuses every place: {because}");
            let span = require.condition.span;
            Some(Diagnostic::warning("always-refused", message, span))
        })
    });
    warnings.collect()
}

/// What a drawing says about a condition.
struct Said {
    holds: bool,
    because: String,
}

/// What `before` says about a condition; `None` if it depends on the place.
fn said(condition: &Expr, drawing: &Drawing) -> Option<Said> {
    match &condition.kind {
        ExprKind::Unary(Unary::Not, inner) => {
            let inner = said(inner, drawing)?;
            Some(Said { holds: !inner.holds, ..inner })
        }
        ExprKind::Binary(joined @ (Binary::And | Binary::Or), left, right) => {
            // One side decides alone, or both agree.
            let decides = |side: &Said| side.holds == (*joined == Binary::Or);
            match (said(left, drawing), said(right, drawing)) {
                (Some(side), _) | (_, Some(side)) if decides(&side) => Some(side),
                (Some(_), Some(side)) => Some(side),
                _ => None,
            }
        }
        ExprKind::Call(builtin, args) => {
            let [of] = args.as_slice() else { return None };
            match builtin {
                Builtin::IsHole => kind_of(loop_of(of, drawing)?, drawing),
                Builtin::BoundaryHalfedge => {
                    kind_of(drawing.before.loop_of_item(halfedge(of, drawing)?)?, drawing)
                }
                Builtin::BoundaryEdge => beside(element(of)?, drawing),
                Builtin::BoundaryVertex => around(element(of)?, drawing),
                _ => None,
            }
        }
        _ => None,
    }
}

fn element(expr: &Expr) -> Option<NameId> {
    match expr.kind {
        ExprKind::Element(name) => Some(name),
        _ => None,
    }
}

/// The drawn halfedge that an expression stands for.
fn halfedge(expr: &Expr, drawing: &Drawing) -> Option<NameId> {
    match &expr.kind {
        ExprKind::Element(name) => Some(*name),
        ExprKind::Follow(Pointer::Twin, of) => drawing.before.twin(halfedge(of, drawing)?),
        _ => None,
    }
}

/// The loop that a face or hole in an expression is drawn as.
fn loop_of<'d>(expr: &Expr, drawing: &Drawing<'d>) -> Option<&'d Loop> {
    match &expr.kind {
        ExprKind::Element(name) => drawing.before.loop_of_face(*name),
        ExprKind::Follow(Pointer::Face, of) => drawing.before.loop_of_item(halfedge(of, drawing)?),
        _ => None,
    }
}

/// Whether a loop is a hole.
fn kind_of(drawn: &Loop, drawing: &Drawing) -> Option<Said> {
    let name = drawing.rule.quoted(drawn.face.name);
    match drawn.kind {
        LoopKind::Face => Some(Said { holds: false, because: format!("{name} is a face") }),
        LoopKind::Hole => Some(Said { holds: true, because: format!("{name} is a hole") }),
        LoopKind::Any => None,
    }
}

/// Whether a hole lies beside an edge.
fn beside(edge: NameId, drawing: &Drawing) -> Option<Said> {
    let name = drawing.rule.quoted(edge);
    let halves = drawing.before.edge_statement(edge)?.halfedge_names();
    let sides = halves.map(|half| drawing.before.loop_of_item(half));
    let hole = sides.iter().flatten().find(|drawn| drawn.kind == LoopKind::Hole);
    if let Some(hole) = hole {
        let hole = drawing.rule.quoted(hole.face.name);
        return Some(Said { holds: true, because: format!("the hole {hole} lies beside {name}") });
    }
    let is_face = |side: &Option<&Loop>| side.is_some_and(|drawn| drawn.kind == LoopKind::Face);
    let because = || format!("faces lie on both sides of {name}");
    sides.iter().all(is_face).then(|| Said { holds: false, because: because() })
}

/// Whether a hole lies around a vertex; what is not drawn there may be one.
fn around(vertex: NameId, drawing: &Drawing) -> Option<Said> {
    let side = drawing.before.side();
    let meets = |drawn: &&Loop| drawn.items.iter().any(|item| item.from.name == vertex);
    let hole = side.loops.iter().filter(|drawn| drawn.kind == LoopKind::Hole).find(meets)?;
    let [hole, name] = [hole.face.name, vertex].map(|name| drawing.rule.quoted(name));
    Some(Said { holds: true, because: format!("the hole {hole} meets {name}") })
}
