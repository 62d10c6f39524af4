//! Trees of any depth are refused, never walked to the end of the stack.

use hedgerow::resolve::{Resolved, resolve};
use hedgerow::source::Span;
use hedgerow::syntax::tree::{
    Action, ActionKind, BinaryOp, Block, Expr, ExprKind, File, Ident, Item, Name, Script, Shown,
    UnaryOp,
};

fn ident(text: &str) -> Ident {
    Ident { text: text.to_owned(), span: Span::default() }
}

fn expr(kind: ExprKind) -> Expr {
    let span = Span::default();
    Expr { kind, span }
}

fn block(kinds: Vec<ActionKind>) -> Block {
    let span = Span::default();
    let action = |kind| Action { kind, span };
    Block { statements: kinds.into_iter().map(action).collect(), span }
}

fn declare(value: Expr) -> ActionKind {
    ActionKind::Let { mutable: false, name: ident("x"), ty: None, value }
}

/// Resolves a script of one statement, on a stack of 2 MB.
fn resolve_statement(kind: impl FnOnce() -> ActionKind + Send + 'static) -> Resolved {
    let work = move || {
        let script = Script {
            docs: Vec::new(),
            private: false,
            name: ident("s"),
            params: Vec::new(),
            body: block(vec![kind()]),
            span: Span::default(),
        };
        let tree =
            File { docs: Vec::new(), items: vec![Item::Script(script)], misread: Vec::new() };
        let resolved = resolve(&tree);
        // The tree's own destructor recurses; that is the tree's business.
        std::mem::forget(tree);
        resolved
    };
    let thread = std::thread::Builder::new().stack_size(2 << 20).spawn(work);
    thread.unwrap().join().unwrap()
}

fn codes(resolved: &Resolved) -> Vec<&'static str> {
    resolved.diagnostics.iter().map(|d| d.code).collect()
}

fn sum(terms: usize) -> Expr {
    let one = || expr(ExprKind::Int(1));
    let add = |left, _| {
        let [left, right] = [left, one()].map(Box::new);
        expr(ExprKind::Binary(BinaryOp::Add, left, right))
    };
    (1..terms).fold(one(), add)
}

fn nots(depth: usize) -> Expr {
    let not = |inner, _| expr(ExprKind::Unary(UnaryOp::Not, Box::new(inner)));
    (0..depth).fold(expr(ExprKind::Bool(true)), not)
}

fn calls(depth: usize) -> Expr {
    let call = |inner, _| expr(ExprKind::Call { function: ident("abs"), args: vec![inner] });
    (0..depth).fold(expr(ExprKind::Int(1)), call)
}

fn counts(depth: usize) -> Expr {
    let body = |inner, _| {
        expr(ExprKind::Aggregate {
            function: ident("sum"),
            body: Box::new(inner),
            variable: ident("v"),
            sequence: Box::new(expr(ExprKind::Name(Name {
                ident: ident("vertices"),
                index: None,
                span: Span::default(),
            }))),
            filter: None,
        })
    };
    (0..depth).fold(expr(ExprKind::Int(1)), body)
}

fn choices(depth: usize) -> Expr {
    let value = |value| Box::new(block(vec![ActionKind::Expr(value)]));
    let choice = |inner, _| {
        expr(ExprKind::If {
            condition: Box::new(expr(ExprKind::Bool(true))),
            then: value(inner),
            otherwise: value(expr(ExprKind::Int(2))),
        })
    };
    (0..depth).fold(expr(ExprKind::Int(1)), choice)
}

fn ifs(depth: usize) -> ActionKind {
    let nest = |inner, _| ActionKind::If {
        binding: None,
        condition: expr(ExprKind::Bool(true)),
        then: block(vec![inner]),
        otherwise: None,
    };
    (0..depth).fold(ActionKind::Print(vec![Shown::Value(expr(ExprKind::Int(1)))]), nest)
}

#[test]
fn a_long_sum_is_understood() {
    let resolved = resolve_statement(|| declare(sum(2000)));
    assert_eq!(codes(&resolved), [""; 0]);
    assert_eq!(resolved.program.scripts.len(), 1);
}

#[test]
fn a_sum_without_end_is_refused() {
    let resolved = resolve_statement(|| declare(sum(100_000)));
    assert_eq!(codes(&resolved), ["expression-too-long"]);
    assert!(resolved.program.scripts.is_empty());
}

#[test]
fn what_is_nested_as_deeply_as_allowed_fits_the_stack() {
    for make in [nots, calls, counts] {
        let resolved = resolve_statement(move || declare(make(398)));
        assert_eq!(codes(&resolved), [""; 0]);
    }
    assert_eq!(codes(&resolve_statement(|| declare(choices(198)))), [""; 0]);
    assert_eq!(codes(&resolve_statement(|| ifs(398))), [""; 0]);
}

#[test]
fn what_is_nested_too_deeply_is_refused() {
    for make in [nots, calls, counts, choices] {
        let resolved = resolve_statement(move || declare(make(50_000)));
        assert_eq!(codes(&resolved), ["expression-too-long"]);
    }
    let resolved = resolve_statement(|| ifs(50_000));
    assert_eq!(codes(&resolved), ["expression-too-long"]);
}
