//! Statements of scripts, functions and tests, and their blocks.

use super::drawing::mark;
use super::expression::{broken_value, expression, sequence};
use super::failure::Phrase;
use super::foreign_syntax;
use super::input::{Rule, Scene};
use super::name::{ident, plain_text, type_word};
use super::recover;
use super::text::text_with_values;
use crate::syntax::token::TokenKind as T;
use crate::syntax::tree::{Action, ActionKind, Block, Expr, Ident, Shown};
use chumsky::prelude::*;

/// The two mutually recursive rules.
#[derive(Clone)]
pub(super) struct Code<'t> {
    pub block: Rule<'t, Block>,
    pub expression: Rule<'t, Expr>,
}

/// The rules for blocks and for expressions, which contain each other.
pub(super) fn code<'t>() -> Code<'t> {
    let block = recursive(|block| {
        let expression = expression(block.clone().boxed());
        braces(action(&Code { block: block.boxed(), expression }))
    });
    let block = block.boxed();
    Code { expression: expression(block.clone()), block }
}

/// `{ … }`; if the closing brace is missing, the end of the item closes the block.
fn braces<'t>(action: Rule<'t, Action>) -> Rule<'t, Block> {
    let broken = recover::skip(recover::follows_action)
        .map(|span| Action { kind: ActionKind::Broken, span });
    let statements = just(T::RightBrace)
        .not()
        .ignore_then(action.recover_with(via_parser(broken)))
        .repeated()
        .collect();
    just(T::LeftBrace)
        .ignore_then(statements)
        .then_ignore(mark(T::RightBrace))
        .map_with(|statements, scene| Block { statements, span: scene.span() })
        .boxed()
}

fn action<'t>(code: &Code<'t>) -> Rule<'t, Action> {
    let Code { block, expression } = code;
    let jump = select! { T::Break => ActionKind::Break, T::Continue => ActionKind::Continue };
    let shown = text_with_values(expression.clone())
        .map_with(|pieces, scene: &mut Scene<'t, '_>| Shown::Text(pieces, scene.span()))
        .or(expression.clone().map(Shown::Value));
    let values = shown.separated_by(just(T::Comma)).at_least(1).collect();
    let print = just(T::Print).ignore_then(values).map(ActionKind::Print);
    let back = just(T::Return).ignore_then(expression.clone().or_not()).map(ActionKind::Return);
    choice((
        binding(expression),
        choice((counted(code), visit(code), repeated_while(code), drain(code))),
        conditional(code),
        print,
        demand(expression),
        back,
        jump,
        block.clone().map(ActionKind::Block),
        value_or_assignment(expression),
    ))
    .map_with(|kind, scene| Action { kind, span: scene.span() })
    .labelled(Phrase::Statement)
    .as_context()
    .boxed()
}

/// A value in the head of a statement; if it cannot be read, the block after it still is.
fn head<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, Expr> {
    let broken = recover::header().map(broken_value);
    expression.clone().recover_with(via_parser(broken)).boxed()
}

/// A value at the end of a statement; if it cannot be read, the statement is kept.
fn tail<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, Expr> {
    let broken = recover::skip_from_first(recover::follows_action).map(broken_value);
    expression.clone().recover_with(via_parser(broken)).boxed()
}

/// `let x = …`, `var x: real = …`
fn binding<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, ActionKind> {
    let mutable = select! { T::Let => false, T::Var => true };
    let ty = just(T::Colon).ignore_then(type_word());
    mutable
        .then(ident())
        .then(ty.or_not())
        .then_ignore(just(T::Equals))
        .then(tail(expression))
        .map(|(((mutable, name), ty), value)| ActionKind::Let { mutable, name, ty, value })
        .boxed()
}

/// `repeat n { … }`
fn counted<'t>(code: &Code<'t>) -> Rule<'t, ActionKind> {
    just(T::Repeat)
        .ignore_then(head(&code.expression))
        .then(code.block.clone())
        .map(|(count, body)| ActionKind::Repeat { count, body })
        .boxed()
}

/// `while c { … }`
fn repeated_while<'t>(code: &Code<'t>) -> Rule<'t, ActionKind> {
    just(T::While)
        .ignore_then(head(&code.expression))
        .then(code.block.clone())
        .map(|(condition, body)| ActionKind::While { condition, body })
        .boxed()
}

/// `x in xs`, where `sequence` reads what is behind `in`.
fn source<'t>(sequence: &Rule<'t, Expr>) -> Rule<'t, (Ident, Expr)> {
    ident().then_ignore(just(T::In)).then(head(sequence)).boxed()
}

/// `for x in xs where c { … }`, `for i in 0..n { … }`, `parallel for x in xs where c { … }`,
/// `update x in xs where c { … }`
fn visit<'t>(code: &Code<'t>) -> Rule<'t, ActionKind> {
    let parallel = just(T::Parallel).then(just(T::For));
    let parallel = parallel.map_with(|_, scene: &mut Scene<'t, '_>| Some(scene.span()));
    let word = parallel.or(just(T::For).to(None)).map(|parallel| (false, parallel));
    let word = word.or(just(T::Update).to((true, None)));
    let filter = just(T::Where).ignore_then(head(&code.expression));
    word.then(source(&sequence(&code.expression)))
        .then(filter.or_not())
        .then(code.block.clone())
        .map(|((((update, parallel), (variable, sequence)), filter), body)| {
            if update {
                ActionKind::Update { variable, sequence, filter, body }
            } else {
                ActionKind::For { parallel, variable, sequence, filter, body }
            }
        })
        .boxed()
}

/// `drain x in xs by key while c { … }`
fn drain<'t>(code: &Code<'t>) -> Rule<'t, ActionKind> {
    let condition = just(T::While).ignore_then(head(&code.expression));
    just(T::Drain)
        .ignore_then(source(&code.expression))
        .then_ignore(just(T::By))
        .then(head(&code.expression))
        .then(condition.or_not())
        .then(code.block.clone())
        .map(|((((variable, sequence), key), condition), body)| ActionKind::Drain {
            variable,
            sequence,
            key,
            condition,
            body,
        })
        .boxed()
}

/// `if c { … } else { … }`, `if let m = split(e) { … }`; `else if` becomes a block with that `if`.
fn conditional<'t>(code: &Code<'t>) -> Rule<'t, ActionKind> {
    let binding = just(T::Let).ignore_then(ident()).then_ignore(just(T::Equals));
    let behind_if = recursive(|behind_if| {
        let chained = just(T::If).ignored().boxed();
        let [chained, contracted] = [chained, foreign_syntax::else_if()].map(|word| {
            let chained = word.ignore_then(behind_if.clone());
            chained.map_with(|kind, scene: &mut Scene<'t, '_>| {
                let span = scene.span();
                let statements = vec![Action { kind, span }];
                Block { statements, span }
            })
        });
        let otherwise = just(T::Else).ignore_then(code.block.clone().or(chained)).or(contracted);
        binding
            .or_not()
            .then(head(&code.expression))
            .then(code.block.clone())
            .then(otherwise.or_not())
            .map(|(((binding, condition), then), otherwise)| ActionKind::If {
                binding,
                condition,
                then,
                otherwise,
            })
    });
    just(T::If).ignore_then(behind_if).boxed()
}

/// `assert c else "…"`, `require c else "…"`
fn demand<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, ActionKind> {
    let requires = select! { T::Assert => false, T::Require => true };
    requires
        .then(expression.clone())
        .then(just(T::Else).ignore_then(plain_text()).or_not())
        .map(|((requires, condition), reason)| match requires {
            true => ActionKind::Require { condition, reason },
            false => ActionKind::Assert { condition, reason },
        })
        .boxed()
}

/// A call or the value of a block; followed by `=`, an assignment.
fn value_or_assignment<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, ActionKind> {
    let assigned = just(T::Equals).labelled(Phrase::Operator).ignore_then(tail(expression));
    expression
        .clone()
        .then(assigned.or_not())
        .map(|(target, value)| match value {
            Some(value) => ActionKind::Assign { target, value },
            None => ActionKind::Expr(target),
        })
        .boxed()
}
