//! Which types the names of a routine have.

use super::super::routine::Statement;
use super::super::term::Term;
use crate::diagram::{Kind, Type};

/// Tells the types of everything that is named.
pub(super) fn types(body: &[Statement], see: &mut dyn FnMut(Type)) {
    for statement in body {
        match statement {
            Statement::Bind { ty, value, .. } => {
                see(*ty);
                variables(value, see);
            }
            Statement::List { ty, .. } => see(*ty),
            Statement::BindList { ty, value, .. } => {
                see(*ty);
                variables(value, see);
            }
            Statement::Gather { ty, item, .. } => {
                see(*ty);
                variables(item, see);
            }
            Statement::Attempt { body, .. } | Statement::Walk { body, .. } => {
                see(Type::Halfedge);
                types(body, see);
            }
            Statement::When { body, .. }
            | Statement::IndexLoop { body, .. }
            | Statement::Preview { body, .. } => types(body, see),
            Statement::Refuse { when, .. } => variables(when, see),
            Statement::Action(action) => {
                action.types(see);
                action.terms(&mut |term| variables(term, see));
                action.bodies().iter().for_each(|body| types(body, see));
            }
            Statement::New { kind, .. } | Statement::NewEach { kind, .. } => see(match kind {
                Kind::Vertex => Type::Vertex,
                Kind::Halfedge => Type::Halfedge,
                Kind::Edge => Type::Edge,
                _ => Type::Face,
            }),
            _ => {}
        }
    }
}

/// Tells the types of the variables of aggregates.
fn variables(term: &Term, see: &mut dyn FnMut(Type)) {
    term.folds(&mut |fold| see(fold.variable.ty));
}
