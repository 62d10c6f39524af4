//! Where an op draws a family, which is not understood yet.

use crate::source::Span;
use crate::syntax::tree::{Arrow, Name, Op, Side, Spoke, Statement};

/// The first `each` or subscript of an op.
pub(super) fn first_family(op: &Op) -> Option<Span> {
    let param = op.params.iter().find_map(|param| subscript(&param.name));
    param.or_else(|| {
        op.rules.iter().find_map(|rule| {
            let sides = [&rule.before, &rule.after];
            sides.into_iter().flatten().find_map(in_side)
        })
    })
}

fn in_side(side: &Side) -> Option<Span> {
    side.statements.iter().find_map(in_statement)
}

fn subscript(name: &Name) -> Option<Span> {
    name.index.as_ref().map(|_| name.span)
}

fn in_statement(statement: &Statement) -> Option<Span> {
    match statement {
        Statement::Loop(l) => subscript(&l.name)
            .or_else(|| l.each.as_ref().map(|each| each.span))
            .or_else(|| {
                l.items.iter().find_map(|item| {
                    subscript(&item.from).or_else(|| match &item.arrow {
                        Arrow::Halfedge(name) | Arrow::Path(Some(name)) => subscript(name),
                        Arrow::Path(None) => None,
                    })
                })
            })
            .or_else(|| l.end.as_ref().and_then(subscript)),
        Statement::Edge {
            name, halfedges, ..
        } => subscript(name).or_else(|| halfedges.iter().find_map(subscript)),
        Statement::Vertex(star) => subscript(&star.name)
            .or_else(|| star.each.as_ref().map(|each| each.span))
            .or_else(|| {
                star.spokes.iter().find_map(|spoke| match spoke {
                    Spoke::Halfedge(name) | Spoke::Fan(Some(name), _) => subscript(name),
                    Spoke::Fan(None, _) => None,
                })
            }),
        Statement::New(names, _) | Statement::Erase(names, _) | Statement::Keep(names, _) => {
            names.iter().find_map(subscript)
        }
        Statement::Assign { target, .. } => subscript(target),
        Statement::Broken(_) => None,
    }
}
