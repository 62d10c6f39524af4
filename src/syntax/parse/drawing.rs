//! One side of an op: the statements of a drawing.

use super::expression::broken_value;
use super::failure::{Failure, Mistake, Phrase};
use super::foreign_syntax;
use super::input::{Extra, Rule, Scene, Tokens};
use super::name::{ident, listed_name, name, word};
use super::recover;
use crate::source::Span;
use crate::syntax::token::TokenKind as T;
use crate::syntax::tree::{
    Arrow, Expr, Ident, Loop, LoopItem, LoopKeyword, Name, Side, Spoke, Star, Statement,
};
use chumsky::prelude::*;

/// `before { … }` or `after { … }`
pub(super) fn side<'t>(keyword: T, expression: Rule<'t, Expr>) -> Rule<'t, Side> {
    let end = select! { T::RightBrace => (), kind if recover::begins_part(kind) => () };
    let broken = recover::skip(recover::follows_drawing_statement).map(Statement::Broken);
    let statement = statement(expression).recover_with(via_parser(broken));
    let statements = end.not().ignore_then(statement).repeated().collect::<Vec<_>>();
    just(keyword)
        .ignore_then(mark(T::LeftBrace))
        .ignore_then(statements)
        .then_ignore(mark(T::RightBrace))
        .map_with(|statements, scene| Side { statements, span: scene.span() })
        .boxed()
}

/// A token; if it is missing, that is reported and parsing continues.
pub(super) fn mark<'t>(kind: T) -> Rule<'t, ()> {
    just(kind).ignored().recover_with(via_parser(empty())).boxed()
}

fn statement<'t>(expression: Rule<'t, Expr>) -> Rule<'t, Statement> {
    choice((
        loop_statement().map(Statement::Loop),
        edge_statement(),
        star_statement().map(Statement::Vertex),
        names(T::New).map(|(names, span)| Statement::New(names, span)),
        names(T::Keep).map(|(names, span)| Statement::Keep(names, span)),
        names(T::Erase).map(|(names, span)| Statement::Erase(names, span)),
        assignment(expression),
    ))
    .labelled(Phrase::DrawingStatement)
    .as_context()
    .boxed()
}

/// `face f0: v0 -a-> v1 =P=> v0`
fn loop_statement<'t>() -> Rule<'t, Loop> {
    let keyword = select! {
        T::Face => LoopKeyword::Face,
        T::Hole => LoopKeyword::Hole,
        T::Loop => LoopKeyword::Loop,
    };
    let items = || loop_item().repeated().at_least(1).collect::<Vec<_>>();
    let period = each(items()).map(|(variable, items)| (Some(variable), items, None));
    let vertex = name().labelled(Phrase::Vertex);
    let run = vertex.then(followed_vertices()).map(|(first, rest)| {
        let (items, end) = chain(first, rest);
        (None, items, Some(end))
    });
    keyword
        .then(name())
        .then_ignore(just(T::Colon))
        .then(period.or(run))
        .map_with(|((keyword, name), (each, items, end)), scene| Loop {
            keyword,
            name,
            each,
            items,
            end,
            span: scene.span(),
        })
        .boxed()
}

type Followed = ((Arrow, Span), Name);

fn followed_vertices<'t>() -> Rule<'t, Vec<Followed>> {
    arrow().then(name().labelled(Phrase::Vertex)).repeated().at_least(1).collect().boxed()
}

/// Pairs each arrow with the vertex that it leaves; returns the last vertex separately.
fn chain(first: Name, rest: Vec<Followed>) -> (Vec<LoopItem>, Name) {
    let mut items = Vec::with_capacity(rest.len());
    let mut from = first;
    for ((arrow, span), next) in rest {
        items.push(LoopItem { from, arrow, span });
        from = next;
    }
    (items, from)
}

/// `v[i] -h[i]->`
fn loop_item<'t>() -> Rule<'t, LoopItem> {
    name()
        .labelled(Phrase::Vertex)
        .then(arrow())
        .map(|(from, (arrow, span))| LoopItem { from, arrow, span })
        .boxed()
}

/// `-a->`, `=P=>` or `=>`
fn arrow<'t>() -> Rule<'t, (Arrow, Span)> {
    let halfedge = just(T::Minus)
        .ignore_then(name().labelled(Phrase::Halfedge))
        .then_ignore(just(T::Arrow))
        .map(Arrow::Halfedge);
    let path = just(T::Equals)
        .ignore_then(name())
        .then_ignore(just(T::FatArrow))
        .map(|name| Arrow::Path(Some(name)));
    let unnamed = just(T::FatArrow).to(Arrow::Path(None));
    choice((halfedge, path, unnamed))
        .labelled(Phrase::Arrow)
        .map_with(|arrow, scene: &mut Scene<'t, '_>| (arrow, scene.span()))
        .boxed()
}

/// `each i { … }`
fn each<'t, O: 't>(period: impl Parser<'t, Tokens<'t>, O, Extra<'t>> + 't) -> Rule<'t, (Ident, O)> {
    just(T::Each)
        .ignore_then(ident())
        .then(period.delimited_by(just(T::LeftBrace), just(T::RightBrace)))
        .boxed()
}

/// `edge e: a | d`
fn edge_statement<'t>() -> Rule<'t, Statement> {
    let halfedge = || name().labelled(Phrase::Halfedge);
    just(T::Edge)
        .ignore_then(name())
        .then_ignore(just(T::Colon))
        .then(halfedge())
        .then_ignore(just(T::Bar))
        .then(halfedge())
        .validate(|((name, one), other), scene, emitter| {
            for halfedge in [&one, &other] {
                if foreign_syntax::is_nothing(&halfedge.ident.text) {
                    emitter.emit(Failure::mistake(Mistake::NoTwin, halfedge.span));
                }
            }
            Statement::Edge { name, halfedges: [one, other], span: scene.span() }
        })
        .boxed()
}

/// `vertex v: a b *S` or `vertex v: each i { h[i] }`
fn star_statement<'t>() -> Rule<'t, Star> {
    let next = || just(T::Comma).or_not().ignore_then(spoke()).repeated().collect::<Vec<_>>();
    let spokes = || {
        spoke().then(next()).map(|(first, mut spokes)| {
            spokes.insert(0, first);
            spokes
        })
    };
    let period = each(spokes()).map(|(variable, spokes)| (Some(variable), spokes));
    let run = spokes().map(|spokes| (None, spokes));
    just(T::Vertex)
        .ignore_then(name())
        .then_ignore(just(T::Colon))
        .then(period.or(run))
        .map_with(|(name, (each, spokes)), scene| Star { name, each, spokes, span: scene.span() })
        .boxed()
}

/// A halfedge, `*S`, or `*`; a fan has a name only if the name touches the asterisk.
fn spoke<'t>() -> Rule<'t, Spoke> {
    let named = just(T::Star)
        .map_with(|_, scene: &mut Scene<'t, '_>| scene.span())
        .then(name())
        .filter(|(star, name)| star.end == name.span.start)
        .map(|(star, name)| Spoke::Fan(Some(name.clone()), star.to(name.span)));
    let unnamed = just(T::Star).map_with(|_, scene| Spoke::Fan(None, scene.span()));
    choice((listed_name().map(Spoke::Halfedge), named, unnamed)).labelled(Phrase::Spoke).boxed()
}

/// `new m p q`, also `new m, p, q`
fn names<'t>(keyword: T) -> Rule<'t, (Vec<Name>, Span)> {
    let name = listed_name().boxed();
    let next = just(T::Comma).or_not().ignore_then(name.clone());
    let list = name.then(next.repeated().collect::<Vec<_>>()).map(|(first, mut list)| {
        list.insert(0, first);
        list
    });
    just(keyword).ignore_then(list).map_with(|names, scene| (names, scene.span())).boxed()
}

/// `v.position = …`
fn assignment<'t>(expression: Rule<'t, Expr>) -> Rule<'t, Statement> {
    let broken = recover::skip_from_first(recover::follows_drawing_statement).map(broken_value);
    recover::assignment_ahead()
        .ignore_then(name())
        .then_ignore(just(T::Dot))
        .then(word())
        .then_ignore(just(T::Equals))
        .then(expression.recover_with(via_parser(broken)))
        .map_with(|((target, attribute), value), scene| Statement::Assign {
            target,
            attribute,
            value,
            span: scene.span(),
        })
        .boxed()
}
