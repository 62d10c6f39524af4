//! Nothing may be nested so deeply that walking it overflows the stack.
//!
//! Two depths count. Whatever is made of an expression is as deep as its tree; chains
//! like `a + b + c` and `h.next.next` are deep on their left side only, and those are
//! walked here without recursion. Everything else recurses once a level.

use crate::diagnostic::Diagnostic;
use crate::syntax::tree::{Action, ActionKind, Block, Expr, ExprKind, Shown};

use super::report::Report;

/// How deep a tree may be in all.
const DEEPEST: u32 = 2000;
/// How often a tree may nest otherwise than on the left side of a chain.
const MOST_NESTED: u32 = 400;

/// Whether an expression can be walked; if not, the report says so.
pub(super) fn shallow_expr(expr: &Expr, report: &mut Report) -> bool {
    shallow(Node::Expr(expr), report)
}

/// Whether a block can be walked; if not, the report says so.
pub(super) fn shallow_block(block: &Block, report: &mut Report) -> bool {
    shallow(Node::Block(block), report)
}

/// A part of a block.
#[derive(Clone, Copy)]
pub(super) enum Node<'a> {
    /// An expression.
    Expr(&'a Expr),
    /// A block.
    Block(&'a Block),
}

/// Shows a block and all its parts, however deep, in no particular order.
pub(super) fn each_node<'a>(block: &'a Block, mut look: impl FnMut(Node<'a>)) {
    let mut open = vec![Node::Block(block)];
    while let Some(node) = open.pop() {
        look(node);
        match node {
            Node::Expr(expr) => {
                open.extend(left_side(expr).map(Node::Expr));
                push_others(expr, |inner| open.push(inner));
            }
            Node::Block(block) => {
                for action in &block.statements {
                    push_parts(action, |inner| open.push(inner));
                }
            }
        }
    }
}

fn shallow(root: Node, report: &mut Report) -> bool {
    let mut open = vec![(root, 0, 0)];
    while let Some((node, depth, nested)) = open.pop() {
        if depth > DEEPEST || nested > MOST_NESTED {
            report.add(too_deep(node));
            return false;
        }
        match node {
            Node::Expr(expr) => {
                if let Some(left) = left_side(expr) {
                    open.push((Node::Expr(left), depth + 1, nested));
                }
                push_others(expr, |inner| open.push((inner, depth + 1, nested + 1)));
            }
            Node::Block(block) => {
                for action in &block.statements {
                    push_parts(action, |inner| open.push((inner, depth + 1, nested + 1)));
                }
            }
        }
    }
    true
}

fn too_deep(node: Node) -> Diagnostic {
    match node {
        Node::Expr(expr) => Diagnostic::error(
            "expression-too-long",
            "this expression is too long to be understood as one",
            expr.span,
        )
        .note("give parts of it a name of their own with `let`"),
        Node::Block(block) => Diagnostic::error(
            "expression-too-long",
            "these blocks are nested too deeply",
            block.span,
        ),
    }
}

/// The part on which a chain grows.
pub(super) fn left_side(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Binary(_, left, _) | ExprKind::Field(left, _) => Some(left),
        _ => None,
    }
}

/// All parts but the left side.
fn push_others<'a>(expr: &'a Expr, mut push: impl FnMut(Node<'a>)) {
    match &expr.kind {
        ExprKind::Binary(_, _, right) => push(Node::Expr(right)),
        ExprKind::Call { args, .. } => args.iter().for_each(|arg| push(Node::Expr(arg))),
        ExprKind::Must(inner) | ExprKind::Unary(_, inner) => push(Node::Expr(inner)),
        ExprKind::If {
            condition,
            then,
            otherwise,
        } => {
            push(Node::Expr(condition));
            push(Node::Block(then));
            push(Node::Block(otherwise));
        }
        ExprKind::Aggregate {
            body,
            sequence,
            filter,
            ..
        } => {
            push(Node::Expr(body));
            push(Node::Expr(sequence));
            filter.iter().for_each(|filter| push(Node::Expr(filter)));
        }
        ExprKind::Field(..)
        | ExprKind::Bool(_)
        | ExprKind::Int(_)
        | ExprKind::Real(_)
        | ExprKind::Text(_)
        | ExprKind::Name(_)
        | ExprKind::Broken => {}
    }
}

fn push_parts<'a>(action: &'a Action, mut push: impl FnMut(Node<'a>)) {
    match &action.kind {
        ActionKind::Let { value, .. } => push(Node::Expr(value)),
        ActionKind::Assign { target, value } => {
            push(Node::Expr(target));
            push(Node::Expr(value));
        }
        ActionKind::Repeat { count: head, body }
        | ActionKind::While {
            condition: head,
            body,
        } => {
            push(Node::Expr(head));
            push(Node::Block(body));
        }
        ActionKind::For {
            sequence,
            filter,
            body,
            ..
        }
        | ActionKind::Update {
            sequence,
            filter,
            body,
            ..
        } => {
            push(Node::Expr(sequence));
            filter.iter().for_each(|filter| push(Node::Expr(filter)));
            push(Node::Block(body));
        }
        ActionKind::Drain {
            sequence,
            key,
            condition,
            body,
            ..
        } => {
            push(Node::Expr(sequence));
            push(Node::Expr(key));
            condition.iter().for_each(|inner| push(Node::Expr(inner)));
            push(Node::Block(body));
        }
        ActionKind::If {
            condition,
            then,
            otherwise,
            ..
        } => {
            push(Node::Expr(condition));
            push(Node::Block(then));
            otherwise.iter().for_each(|block| push(Node::Block(block)));
        }
        ActionKind::Print(values) => {
            let values = values.iter().flat_map(Shown::values);
            values.for_each(|value| push(Node::Expr(value)));
        }
        ActionKind::Assert { condition, .. } => push(Node::Expr(condition)),
        ActionKind::Return(value) => value.iter().for_each(|value| push(Node::Expr(value))),
        ActionKind::Block(block) => push(Node::Block(block)),
        ActionKind::Expr(expr) => push(Node::Expr(expr)),
        ActionKind::Break | ActionKind::Continue | ActionKind::Broken => {}
    }
}
