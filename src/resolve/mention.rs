//! Every mention of a name in a drawing, in the order of the text.
//!
//! A mention in a statement gives the name its kind; one in a list does not. An unnamed path is
//! mentioned under a name derived from its loop.

use std::borrow::Cow;

use crate::diagram::Kind;
use crate::source::Span;
use crate::syntax::tree::{Arrow, Index, Name, Side, Spoke, Statement};

/// One mention.
#[derive(Clone, Debug)]
pub(super) struct Mention<'a> {
    /// The word, or the description of an unnamed path.
    pub(super) text: Cow<'a, str>,
    /// The kind that its place gives it; `None` in a list.
    pub(super) kind: Option<Kind>,
    /// Its subscript; an unnamed path has that of its loop.
    pub(super) index: Option<&'a Index>,
    /// Its place in the source.
    pub(super) span: Span,
}

impl Mention<'_> {
    /// True if the name is written in the program.
    pub(super) fn is_named(&self) -> bool {
        matches!(self.text, Cow::Borrowed(_))
    }
}

/// The internal name of the one unnamed path that the loop of a face may have. No name of the
/// language looks like it.
pub(super) fn path_of(face: &str) -> String {
    format!("the path of `{face}`")
}

/// All mentions of `side`.
pub(super) fn mentions(side: &Side) -> Vec<Mention<'_>> {
    let mut mentions = Vec::new();
    for statement in &side.statements {
        push_mentions(statement, &mut mentions);
    }
    mentions
}

fn push_mentions<'a>(statement: &'a Statement, mentions: &mut Vec<Mention<'a>>) {
    let mut push = |name: &'a Name, kind: Option<Kind>| {
        mentions.push(Mention {
            text: Cow::Borrowed(&name.ident.text),
            kind,
            index: name.index.as_ref(),
            span: name.span,
        });
    };
    drawn_names(statement).for_each(|(name, kind)| push(name, Some(kind)));
    match statement {
        Statement::Loop(l) => {
            let unnamed = l.items.iter().filter(|i| i.arrow == Arrow::Path(None));
            mentions.extend(unnamed.map(|item| Mention {
                text: Cow::Owned(path_of(&l.name.ident.text)),
                kind: Some(Kind::Path),
                index: l.name.index.as_ref(),
                span: item.span,
            }));
        }
        Statement::New(names, _) | Statement::Erase(names, _) | Statement::Keep(names, _) => {
            names.iter().for_each(|name| push(name, None));
        }
        // An assignment reads and writes what is drawn; it draws nothing.
        _ => {}
    }
}

/// The halfedges, paths and fans with names that a statement lists, in the order of the text.
pub fn drawn_parts(statement: &Statement) -> impl Iterator<Item = &Name> {
    let lists = |kind| matches!(kind, Kind::Halfedge | Kind::Path | Kind::Fan);
    drawn_names(statement).filter(move |(_, kind)| lists(*kind)).map(|(name, _)| name)
}

/// The names that a statement draws, in the order of the text, with the kinds that their places
/// give them.
pub fn drawn_names(statement: &Statement) -> impl Iterator<Item = (&Name, Kind)> {
    let mut names = Vec::new();
    match statement {
        Statement::Loop(orbit) => {
            names.push((&orbit.name, Kind::Face));
            for item in &orbit.items {
                names.push((&item.from, Kind::Vertex));
                match &item.arrow {
                    Arrow::Halfedge(name) => names.push((name, Kind::Halfedge)),
                    Arrow::Path(name) => names.extend(name.iter().map(|name| (name, Kind::Path))),
                }
            }
            names.extend(orbit.end.iter().map(|name| (name, Kind::Vertex)));
        }
        Statement::Edge { name, halfedges, .. } => {
            names.push((name, Kind::Edge));
            names.extend(halfedges.iter().map(|name| (name, Kind::Halfedge)));
        }
        Statement::Vertex(star) => {
            names.push((&star.name, Kind::Vertex));
            for spoke in &star.spokes {
                match spoke {
                    Spoke::Halfedge(name) => names.push((name, Kind::Halfedge)),
                    Spoke::Fan(name, _) => names.extend(name.iter().map(|name| (name, Kind::Fan))),
                }
            }
        }
        _ => {}
    }
    names.into_iter()
}
