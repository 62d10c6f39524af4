//! Items: the top level of a file.

use super::action::{Code, code};
use super::drawing::{mark, side};
use super::failure::{Failure, Mistake, Phrase};
use super::foreign_syntax;
use super::input::{Rule, Scene, slice};
use super::name::{ident, name, plain_text, text, type_word};
use super::recover;
use crate::source::Span;
use crate::syntax::token::TokenKind as T;
use crate::syntax::tree::{
    Attr, Block, Condition, Expr, Fn, Ident, Item, Name, Op, Param, Rule as Alternative, Script,
    Side, Steps, Test, Use,
};
use chumsky::input::Emitter;
use chumsky::prelude::*;

/// An item, up to where the next one begins. Doc comments are added later.
pub(super) fn item<'t>() -> Rule<'t, Item> {
    let code = code();
    let item = choice((
        op(&code).map(Item::Op),
        script(&code).map(Item::Script),
        function(&code).map(Item::Fn),
        test(&code).map(Item::Test),
        attr(&code).map(Item::Attr),
        file_use().map(Item::Use),
    ));
    let item = item.labelled(Phrase::Item).as_context();
    let rest = recover::rest().repeated().at_least(1);
    let leftover = end().recover_with(via_parser(rest));
    item.recover_with(via_parser(recover::rest().map(Item::Broken))).then_ignore(leftover).boxed()
}

/// `use "path"`
fn file_use<'t>() -> Rule<'t, Use> {
    just(T::Use)
        .ignore_then(text().or(foreign_syntax::bare_path()))
        .map_with(|(path, path_span), scene| Use { path, path_span, span: scene.span() })
        .boxed()
}

/// `private`, before an item that is for its own file.
fn private<'t>() -> Rule<'t, bool> {
    just(T::Private).or_not().map(|word| word.is_some()).boxed()
}

/// `private attr name: vertex real = 0`
fn attr<'t>(code: &Code<'t>) -> Rule<'t, Attr> {
    let default = just(T::Equals).ignore_then(code.expression.clone());
    private()
        .then_ignore(just(T::Attr))
        .then(ident())
        .then_ignore(just(T::Colon))
        .then(type_word())
        .then(type_word())
        .then(default.or_not())
        .map_with(|((((private, name), kind), ty), default), scene| Attr {
            docs: Vec::new(),
            private,
            name,
            kind,
            ty,
            default,
            span: scene.span(),
        })
        .boxed()
}

/// `(e: edge, t: real = 0.5)`; a parameter that cannot be read is dropped.
fn params<'t>(code: &Code<'t>) -> Rule<'t, Vec<Param>> {
    let default = just(T::Equals).ignore_then(code.expression.clone());
    let ty = just(T::Colon).ignore_then(type_word());
    let param = name()
        .then(ty.or(foreign_syntax::no_type()))
        .then(default.or_not())
        .validate(|((name, ty), default), scene, emitter| {
            if ty.text.is_empty() {
                emitter.emit(Failure::mistake(Mistake::Untyped, name.span));
            }
            Param { name, ty, default, span: scene.span() }
        })
        .labelled(Phrase::Parameter);
    let end = just(T::RightParen);
    let param =
        end.not().ignore_then(param.recover_with(via_parser(recover::entry().map_with(unread))));
    param
        .separated_by(just(T::Comma))
        .allow_trailing()
        .collect::<Vec<_>>()
        .delimited_by(just(T::LeftParen), mark(T::RightParen))
        .recover_with(via_parser(recover::item_head().map(|_| Vec::new())))
        .boxed()
}

/// A parameter that cannot be read: calls have an argument for it, of any type.
fn unread(span: Span, scene: &mut Scene) -> Param {
    let name = Name { ident: Ident { text: slice(scene).to_string(), span }, index: None, span };
    Param { name, ty: Ident { text: String::new(), span }, default: None, span }
}

/// `-> real`
fn result<'t>(word: Rule<'t, Ident>) -> Rule<'t, Option<Ident>> {
    let word = word.map(Some).recover_with(via_parser(empty().map(|()| None)));
    just(T::Arrow).ignore_then(word).or_not().map(Option::flatten).boxed()
}

/// The block of an item, skipping anything before it that cannot be read.
fn body<'t>(code: &Code<'t>) -> Rule<'t, Block> {
    let later = recover::to_braces().ignore_then(code.block.clone());
    code.block.clone().recover_with(via_parser(later)).boxed()
}

/// `private fn name(…) -> type { … }`
fn function<'t>(code: &Code<'t>) -> Rule<'t, Fn> {
    private()
        .then_ignore(just(T::Fn))
        .then(ident())
        .then(params(code))
        .then(result(type_word()))
        .then(body(code))
        .map_with(|((((private, name), params), result), body), scene| Fn {
            docs: Vec::new(),
            private,
            name,
            params,
            result,
            body,
            span: scene.span(),
        })
        .boxed()
}

/// `private script name(…) { … }`
fn script<'t>(code: &Code<'t>) -> Rule<'t, Script> {
    private()
        .then_ignore(just(T::Script))
        .then(ident())
        .then(params(code))
        .then(body(code))
        .map_with(|(((private, name), params), body), scene| Script {
            docs: Vec::new(),
            private,
            name,
            params,
            body,
            span: scene.span(),
        })
        .boxed()
}

/// `test "…" { … }`
fn test<'t>(code: &Code<'t>) -> Rule<'t, Test> {
    just(T::Test)
        .ignore_then(text())
        .then(code.block.clone())
        .map_with(|((name, name_span), body), scene| {
            let span = scene.span();
            Test { name, name_span, body, span }
        })
        .boxed()
}

/// `private op name(…) -> result keeps … { … }`
fn op<'t>(code: &Code<'t>) -> Rule<'t, Op> {
    let levels = ident().separated_by(just(T::Comma)).at_least(1).collect();
    let levels = levels.recover_with(via_parser(empty().map(|()| Vec::new())));
    let keeps = just(T::Keeps)
        .ignore_then(levels)
        .or_not()
        .map(|keeps: Option<Vec<Ident>>| keeps.unwrap_or_default());
    private()
        .then_ignore(just(T::Op))
        .then(ident())
        .then(params(code))
        .then(result(returned()))
        .then(keeps)
        .then(rules(code))
        .map_with(|(((((private, name), params), result), keeps), (rules, steps)), scene| Op {
            docs: Vec::new(),
            private,
            name,
            params,
            result,
            keeps,
            rules,
            steps,
            span: scene.span(),
        })
        .boxed()
}

/// The result of an op: a name, or the kind of an element.
fn returned<'t>() -> Rule<'t, Ident> {
    let kind = select! { kind @ (T::Vertex | T::Edge | T::Face) => kind };
    ident().or(kind.rewind().ignore_then(type_word())).boxed()
}

/// A part between the braces of an op.
enum Part {
    Before(Side),
    Condition(Condition),
    After(Side),
    Steps(Block, Span),
    Rule(Alternative),
    Broken,
}

/// The braces of an op: its parts, its rules or its steps. A closing brace followed by another part
/// does not close the op.
fn rules<'t>(code: &Code<'t>) -> Rule<'t, (Vec<Alternative>, Option<Steps>)> {
    let expression = &code.expression;
    let steps = just(T::Steps)
        .ignore_then(code.block.clone())
        .map_with(|body, scene| Part::Steps(body, scene.span()));
    let rule = just(T::Rule)
        .ignore_then(ident())
        .then(parts(part(expression), just(T::RightBrace).boxed()))
        .validate(|(name, parts), scene, emitter| {
            let mut rule = assembled(parts, scene.span(), emitter).alone;
            rule.name = Some(name);
            rule
        });
    let part = choice((part(expression), rule.map(Part::Rule), steps)).boxed();
    let another = select! { kind if recover::begins_part(kind) => () };
    let stray = just(T::RightBrace).then(another).rewind();
    let end = just(T::RightBrace).and_is(stray.not()).boxed();
    parts(part, end)
        .validate(|parts, scene, emitter| {
            let Assembled { alone, mut rules, steps } = assembled(parts, scene.span(), emitter);
            if let Some((body, span)) = steps {
                if alone.before.is_some() || alone.after.is_some() || !rules.is_empty() {
                    emitter.emit(Failure::mistake(
                        Mistake::Misplaced("an op in steps draws nothing itself"),
                        span,
                    ));
                }
                let conditions = alone.conditions;
                return (Vec::new(), Some(Steps { conditions, body }));
            }
            if rules.is_empty() {
                rules.push(alone);
            } else if alone.before.is_some() || alone.after.is_some() {
                let span = alone.before.or(alone.after).map_or(alone.span, |side| side.span);
                emitter.emit(Failure::mistake(Mistake::RuleAmongParts, span));
            } else {
                for condition in &alone.conditions {
                    let place = "among rules a condition stands in each that asks it";
                    let mistake = Mistake::Misplaced(place);
                    emitter.emit(Failure::mistake(mistake, condition.span()));
                }
            }
            (rules, None)
        })
        .boxed()
}

fn part<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, Part> {
    choice((
        side(T::Before, expression.clone()).map(Part::Before),
        condition(expression).map(Part::Condition),
        side(T::After, expression.clone()).map(Part::After),
    ))
    .labelled(Phrase::Part)
    .as_context()
    .boxed()
}

/// Parts in braces, up to a closing brace that matches `end`.
fn parts<'t>(part: Rule<'t, Part>, end: Rule<'t, T>) -> Rule<'t, Vec<Part>> {
    let open = just(T::LeftBrace).ignored();
    let later = recover::to_braces().ignore_then(open.or_not().ignored());
    let open = open.recover_with(via_parser(later));
    let broken = recover::part().map(|_| Part::Broken);
    let parts = end.not().ignore_then(part.recover_with(via_parser(broken))).repeated().collect();
    open.ignore_then(parts).then_ignore(mark(T::RightBrace)).boxed()
}

/// `require CONDITION else "REASON"`, `guard LEVEL` or `alias v2 v3`
fn condition<'t>(expression: &Rule<'t, Expr>) -> Rule<'t, Condition> {
    let require = just(T::Require)
        .ignore_then(expression.clone())
        .then(just(T::Else).ignore_then(plain_text()).or_not())
        .map_with(|(condition, reason), scene: &mut Scene<'t, '_>| Condition::Require {
            condition,
            reason,
            span: scene.span(),
        });
    let guard = just(T::Guard)
        .ignore_then(ident())
        .map_with(|level, scene| Condition::Guard { level, span: scene.span() });
    let alias = just(T::Alias)
        .ignore_then(name())
        .then(just(T::Comma).or_not().ignore_then(name()).repeated().at_least(1).collect())
        .map(|(first, mut names): (Name, Vec<Name>)| {
            names.insert(0, first);
            names
        })
        .map_with(|names, scene| Condition::Alias { names, span: scene.span() });
    choice((require, guard, alias)).boxed()
}

/// The place of a condition of an op.
const BETWEEN: &str = "a condition stands between `before` and `after`";

/// The parts of an op, sorted.
struct Assembled {
    /// The parts outside rules, as a rule without a name.
    alone: Alternative,
    /// The rules.
    rules: Vec<Alternative>,
    /// The steps and their span.
    steps: Option<(Block, Span)>,
}

fn assembled(parts: Vec<Part>, span: Span, emitter: &mut Emitter<Failure>) -> Assembled {
    let mut alone =
        Alternative { name: None, before: None, conditions: Vec::new(), after: None, span };
    let mut rules = Vec::new();
    let mut steps: Option<(Block, Span)> = None;
    let mut behind = Vec::new();
    let mut wrong = |mistake, span| emitter.emit(Failure::mistake(mistake, span));
    for part in parts {
        match part {
            Part::Before(side) => {
                if let Some(first) = &alone.before {
                    wrong(Mistake::TwiceDrawn(first.span), side.span);
                    continue;
                }
                if alone.after.is_some() {
                    wrong(Mistake::Misplaced("`before` comes first"), side.span);
                    behind.clear();
                } else if let Some(first) = alone.conditions.first() {
                    wrong(Mistake::Misplaced(BETWEEN), first.span());
                }
                alone.before = Some(side);
            }
            Part::Condition(condition) => {
                let span = condition.span();
                if steps.is_some() {
                    wrong(Mistake::Misplaced("a condition stands before `steps`"), span);
                }
                if alone.after.is_some() {
                    behind.push(span);
                }
                alone.conditions.push(condition);
            }
            Part::After(side) => {
                if let Some(first) = &alone.after {
                    wrong(Mistake::TwiceDrawn(first.span), side.span);
                    continue;
                }
                alone.after = Some(side);
            }
            Part::Steps(body, span) => match &steps {
                Some((_, first)) => wrong(Mistake::TwiceDrawn(*first), span),
                None => steps = Some((body, span)),
            },
            Part::Rule(rule) => rules.push(rule),
            Part::Broken => {}
        }
    }
    if let Some(first) = behind.first() {
        wrong(Mistake::Misplaced(BETWEEN), *first);
    }
    Assembled { alone, rules, steps }
}
