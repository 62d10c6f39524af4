//! Expressions, from `or` down to names.
//!
//! The span of an expression in parentheses includes them; the tree does not record them otherwise.

use super::failure::{Failure, Mistake, Phrase};
use super::foreign_syntax;
use super::input::{Rule, Scene, slice};
use super::name::{ident, ident_here, int_here, name, name_here, qualified_name, text};
use super::recover;
use super::report;
use super::text::text_with_values;
use crate::source::Span;
use crate::syntax::token::TokenKind as T;
use crate::syntax::tree::{
    Action, ActionKind, Asking, BinaryOp, Block, Expr, ExprKind, Ident, Name, UnaryOp,
    split_qualified,
};
use chumsky::prelude::*;

/// An expression; `block` is the rule for the branches of `if`.
pub(super) fn expression<'t>(block: Rule<'t, Block>) -> Rule<'t, Expr> {
    recursive(|expression| {
        let expression = expression.boxed();
        // Entering a recursive rule grows the stack if necessary. The way from one value to the
        // next inside it needs more than is reserved at once, so an atom is a recursive rule as
        // well.
        let atom = recursive(|_| atom(expression.clone(), block)).boxed();
        operators(field(atom)).labelled(Phrase::Value).boxed()
    })
    .boxed()
}

fn operators<'t>(operand: Rule<'t, Expr>) -> Rule<'t, Expr> {
    let or = select! { T::Or => BinaryOp::Or };
    let and = select! { T::And => BinaryOp::And };
    let compare = select! {
        T::Equal => BinaryOp::Equal,
        T::NotEqual => BinaryOp::NotEqual,
        T::Less => BinaryOp::Less,
        T::LessEqual => BinaryOp::LessEqual,
        T::Greater => BinaryOp::Greater,
        T::GreaterEqual => BinaryOp::GreaterEqual,
    };
    let add = select! { T::Plus => BinaryOp::Add, T::Minus => BinaryOp::Subtract };
    let multiply = select! {
        T::Star => BinaryOp::Multiply,
        T::Slash => BinaryOp::Divide,
        T::Div => BinaryOp::Div,
        T::Mod => BinaryOp::Mod,
    };
    let negated = signed(T::Minus, UnaryOp::Negate, operand);
    let product = chain(negated, multiply.labelled(Phrase::Operator).boxed());
    let sum = chain(product, add.labelled(Phrase::Operator).boxed());
    let compared = chain(sum, compare.labelled(Phrase::Operator).boxed());
    let denied = signed(T::Not, UnaryOp::Not, compared);
    let both = chain(denied, and.labelled(Phrase::Operator).boxed());
    chain(both, or.labelled(Phrase::Operator).boxed())
}

/// Any number of signs before an operand.
fn signed<'t>(sign: T, op: UnaryOp, operand: Rule<'t, Expr>) -> Rule<'t, Expr> {
    just(sign)
        .repeated()
        .foldr_with(operand, move |_, value, scene: &mut Scene<'t, '_>| Expr {
            kind: ExprKind::Unary(op, Box::new(value)),
            span: scene.span(),
        })
        .labelled(Phrase::Value)
        .boxed()
}

/// Operands joined by operators of the same precedence, left-associative.
fn chain<'t>(operand: Rule<'t, Expr>, operator: Rule<'t, BinaryOp>) -> Rule<'t, Expr> {
    let missing = empty().map_with(|(), scene: &mut Scene<'t, '_>| broken_value(scene.span()));
    let right = operand.clone().recover_with(via_parser(missing));
    operand
        .foldl_with(operator.then(right).repeated(), |left, (op, right), scene| {
            if is_comparison(op) {
                comparison(left, op, right, scene)
            } else {
                binary(left, op, right)
            }
        })
        .boxed()
}

/// The value in place of one that could not be read.
pub(super) fn broken_value(span: Span) -> Expr {
    let kind = ExprKind::Broken;
    Expr { kind, span }
}

fn binary(left: Expr, op: BinaryOp, right: Expr) -> Expr {
    let span = left.span.to(right.span);
    Expr { kind: ExprKind::Binary(op, Box::new(left), Box::new(right)), span }
}

/// A comparison of a comparison is a mistake unless it is in parentheses.
fn comparison(left: Expr, op: BinaryOp, right: Expr, scene: &mut Scene) -> Expr {
    if right.kind != ExprKind::Broken
        && let ExprKind::Binary(inner, first, middle) = &left.kind
        && is_comparison(*inner)
        && first.span.start == left.span.start
    {
        let span = left.span.to(right.span);
        scene.emit(Failure::mistake(Mistake::ChainedComparison(middle.span), span));
    }
    binary(left, op, right)
}

fn is_comparison(op: BinaryOp) -> bool {
    use BinaryOp::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
    matches!(op, Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual)
}

/// `x.edge.face`
fn field<'t>(value: Rule<'t, Expr>) -> Rule<'t, Expr> {
    let dot = just(T::Dot).labelled(Phrase::Operator);
    // A keyword at the start of a line begins the next statement.
    let name = select! { kind if T::is_wordlike(kind) => kind };
    let name = name.try_map_with(|kind: T, scene| match kind.is_keyword() && begins_line(scene) {
        true => Err(Failure { found: Some(kind), ..Failure::at(scene.span()) }),
        false => Ok(ident_here(scene)),
    });
    let name = name.labelled(Phrase::Name);
    value
        .foldl(dot.ignore_then(name).repeated(), |value, field| {
            let span = value.span.to(field.span);
            let kind = ExprKind::Field(Box::new(value), field);
            Expr { kind, span }
        })
        .boxed()
}

fn atom<'t>(expression: Rule<'t, Expr>, block: Rule<'t, Block>) -> Rule<'t, Expr> {
    let literal = select! { T::True => ExprKind::Bool(true), T::False => ExprKind::Bool(false) };
    let int = select! { T::Int => () }.map_with(|(), scene| ExprKind::Int(int_here(scene)));
    let real = select! { T::Real => () }.map_with(|(), scene| {
        let value = slice(scene).parse().ok().filter(|value: &f64| value.is_finite());
        ExprKind::Real(value.unwrap_or(f64::MAX))
    });
    let misplaced = text_with_values(expression.clone()).validate(|_, scene, emitter| {
        let mistake = Mistake::ValuesInText;
        emitter.emit(Failure::mistake(mistake, scene.span()));
        ExprKind::Broken
    });
    let text = text().map(|(text, _)| ExprKind::Text(text)).or(misplaced).boxed();
    let inside = expression.clone().map(|inner| inner.kind).then_ignore(recover::right_paren());
    let broken = recover::parentheses().map(|_| ExprKind::Broken);
    let parenthesised = just(T::LeftParen).ignore_then(inside.recover_with(via_parser(broken)));
    let call = call(expression.clone());
    let must =
        just(T::Must).ignore_then(called(call.clone())).map(|call| ExprKind::Must(Box::new(call)));
    let asking = select! { T::Can => Asking::Can, T::Why => Asking::Why };
    let asked = asking
        .then(called(call.clone()))
        .map(|(asking, call)| ExprKind::Asked(asking, Box::new(call)));
    let calls = choice((call, must, asked));
    choice((calls, int, real, literal, parenthesised, text, branches(expression, block)))
        .map_with(|kind, scene| Expr { kind, span: scene.span() })
        .boxed()
}

fn called<'t>(call: Rule<'t, ExprKind>) -> Rule<'t, Expr> {
    call.map_with(|kind, scene| Expr { kind, span: scene.span() }).boxed()
}

/// The arguments between the parentheses of a call.
struct Arguments {
    values: Vec<Expr>,
    each: Option<Each>,
}

/// `for e in edges where c`
struct Each {
    variable: Ident,
    sequence: Expr,
    filter: Option<Expr>,
}

/// `x`, `v[i+1]`, `f(x, y)`, `mean(length(e) for e in edges)`
fn call<'t>(expression: Rule<'t, Expr>) -> Rule<'t, ExprKind> {
    let filter = just(T::Where).ignore_then(expression.clone());
    let each = just(T::For)
        .ignore_then(ident())
        .then_ignore(just(T::In))
        .then(sequence(&expression))
        .then(filter.or_not())
        .map(|((variable, sequence), filter)| Each { variable, sequence, filter });
    let rest = just(T::Comma)
        .ignore_then(expression.clone())
        .repeated()
        .collect::<Vec<_>>()
        .then_ignore(just(T::Comma).or_not());
    let after_first = each.map(|each| (Vec::new(), Some(each))).or(rest.map(|rest| (rest, None)));
    let inside = expression
        .then(after_first)
        .map(|(first, (rest, each))| Arguments {
            values: std::iter::once(first).chain(rest).collect(),
            each,
        })
        .or_not()
        .map(|arguments| arguments.unwrap_or(Arguments { values: Vec::new(), each: None }))
        .then_ignore(recover::right_paren());
    let broken = recover::parentheses()
        .map(|span| Arguments { values: vec![broken_value(span)], each: None });
    // A parenthesis at the start of a line begins the next statement.
    let open = just(T::LeftParen).try_map_with(|_, scene| match begins_line(scene) {
        true => Err(Failure::at(scene.span())),
        false => Ok(()),
    });
    let open = open.labelled(Phrase::Operator).boxed();
    let hole = select! { T::Hole => () }.map_with(|(), scene| name_here(scene));
    let callee = hole.then_ignore(open.clone().rewind()).or(qualified_name()).or(name()).boxed();
    let inside = inside.recover_with(via_parser(broken)).boxed();
    let arguments = open.ignore_then(inside).boxed();
    callee
        .then(arguments.or_not())
        .validate(|(name, arguments), _, emitter| {
            let Some(arguments) = arguments else {
                if split_qualified(&name.ident.text).0.is_some() {
                    emitter.emit(Failure::mistake(Mistake::QualifiedName, name.span));
                }
                return ExprKind::Name(name);
            };
            if let Some(index) = &name.index {
                emitter.emit(Failure::mistake(Mistake::CalledFamily, index.span));
            }
            called_with(name, arguments)
        })
        .boxed()
}

/// `xs`, `0..n`
pub(super) fn sequence<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, Expr> {
    let end = just(T::DotDot).ignore_then(expression.clone());
    expression
        .clone()
        .then(end.or_not())
        .map(|(first, end)| match end {
            Some(end) => {
                let span = Span { end: end.span.end, ..first.span };
                Expr { kind: ExprKind::Range(Box::new(first), Box::new(end)), span }
            }
            None => first,
        })
        .boxed()
}

/// True if a token is the first on its line.
fn begins_line(scene: &mut Scene) -> bool {
    report::begins_line(scene.state().0, scene.span())
}

fn called_with(name: Name, mut arguments: Arguments) -> ExprKind {
    let function = name.ident;
    match (arguments.each, arguments.values.pop()) {
        (Some(each), Some(body)) => ExprKind::Aggregate {
            function,
            body: Box::new(body),
            variable: each.variable,
            sequence: Box::new(each.sequence),
            filter: each.filter.map(Box::new),
        },
        (_, last) => {
            arguments.values.extend(last);
            let args = arguments.values;
            ExprKind::Call { function, args }
        }
    }
}

/// `if c { x } else { y }`; `else if` becomes a block with that `if` alone.
fn branches<'t>(expression: Rule<'t, Expr>, block: Rule<'t, Block>) -> Rule<'t, ExprKind> {
    let behind_if = recursive(|behind_if| {
        let chained = just(T::If).ignored().boxed();
        let [chained, contracted] = [chained, foreign_syntax::else_if()].map(|word| {
            let chained = word.ignore_then(behind_if.clone());
            chained.map_with(|kind, scene: &mut Scene<'t, '_>| {
                let span: Span = scene.span();
                let kind = ActionKind::Expr(Expr { kind, span });
                let statements = vec![Action { kind, span }];
                Block { statements, span }
            })
        });
        let otherwise = just(T::Else).ignore_then(block.clone().or(chained));
        expression.then(block).then(otherwise.or(contracted)).map(
            |((condition, then), otherwise)| ExprKind::If {
                condition: Box::new(condition),
                then: Box::new(then),
                otherwise: Box::new(otherwise),
            },
        )
    });
    just(T::If).ignore_then(behind_if).boxed()
}
