//! `new`, `erase` and `keep`: lists of names that are drawn elsewhere.

use std::collections::HashMap;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Kind, NameId, Ref, Side, Spoke};
use crate::source::Span;
use crate::syntax::tree::{self, Statement};

use super::mention::mentions;
use super::names::Names;
use super::report::Report;
use super::suggestion::suggest;
use super::unused::Unused;

/// The lists of `after`.
#[derive(Debug, Default)]
pub(super) struct Lists {
    /// The names of `new`.
    pub(super) created: Vec<Ref>,
    /// The names of `erase`.
    pub(super) erased: Vec<Ref>,
}

/// Reads the lists of `after`, whose two sides are drawn.
pub(super) fn read_lists(
    after: &tree::Side,
    [drawn_before, drawn_after]: [&Side; 2],
    names: &Names,
    report: &mut Report,
) -> Lists {
    let mut reader = Reader {
        names,
        after,
        before: drawn_before,
        report,
        listed: HashMap::new(),
        unused: Vec::new(),
    };
    let mut lists = Lists::default();
    for statement in &after.statements {
        match statement {
            Statement::New(listed, _) => {
                lists.created.extend(listed.iter().filter_map(|name| reader.new_name(name)));
            }
            Statement::Erase(listed, _) => {
                lists.erased.extend(listed.iter().filter_map(|name| reader.erased(name)));
            }
            Statement::Keep(listed, _) => listed.iter().for_each(|name| reader.kept(name)),
            _ => {}
        }
    }
    let Reader { unused, report, .. } = reader;
    let drawn = [drawn_before, drawn_after];
    let unused = Unused { listed: unused, created: &lists.created, written: after, drawn };
    unused.report(names, report);
    let created: HashMap<NameId, Span> = lists.created.iter().map(|r| (r.name, r.span)).collect();
    for erased in &lists.erased {
        if let Some(span) = created.get(&erased.name) {
            let word = &names.get(erased.name).text;
            let message = format!("`{word}` is both in `new` and in `erase`");
            let error = Diagnostic::error("new-and-erased", message, erased.span)
                .label(*span, "it is created here");
            report.add(error);
        }
    }
    lists
}

struct Reader<'a> {
    names: &'a Names,
    after: &'a tree::Side,
    before: &'a Side,
    report: &'a mut Report,
    listed: HashMap<(&'static str, &'a str), Span>,
    /// The names listed in `new` that no statement draws.
    unused: Vec<&'a tree::Name>,
}

impl<'a> Reader<'a> {
    /// True if a name occurs in a list for the first time; reports a repetition.
    fn first(&mut self, list: &'static str, name: &'a tree::Name) -> bool {
        let key = (list, name.ident.text.as_str());
        let Some(first) = self.listed.get(&key) else {
            self.listed.insert(key, name.span);
            return true;
        };
        let message = format!("`{}` is listed twice in `{list}`", name.ident.text);
        let error =
            Diagnostic::error("listed-twice", message, name.span).label(*first, "listed first");
        self.report.add(error);
        false
    }

    fn new_name(&mut self, name: &'a tree::Name) -> Option<Ref> {
        let word = &name.ident.text;
        if !self.first("new", name) {
            return None;
        }
        if let Some(given) = self.names.parameter(word) {
            // A parameter drawn as another kind is reported where it is drawn.
            if self.names.find(word).is_none() && self.is_drawn(word) {
                return self.report.fail_silently();
            }
            let message =
                format!("`{word}` is listed in `new`, but it is a parameter; rename one of them");
            let error = Diagnostic::error("already-drawn", message, name.span);
            return self.report.reject(error.label(given, "the parameter"));
        }
        let Some(id) = self.names.find(word) else {
            self.unused.push(name);
            return None;
        };
        let known = self.names.get(id);
        if self.names.readable(id) {
            let message = format!("`{word}` is listed in `new`, but it is there before");
            let error = Diagnostic::error("already-drawn", message, name.span);
            return self.report.reject(error.label(known.span, "it is drawn here"));
        }
        if !self.names.in_after(id) {
            self.unused.push(name);
            return None;
        }
        if known.kind.element_type().is_none() {
            let message = format!(
                "`{word}` is {}; `new` names vertices, halfedges, edges and faces",
                known.kind.a_word()
            );
            return self.report.reject(Diagnostic::error("not-an-element", message, name.span));
        }
        Some(mention(id, name))
    }

    /// True if a statement of `after` draws a name.
    fn is_drawn(&self, word: &str) -> bool {
        mentions(self.after).iter().any(|mention| mention.kind.is_some() && mention.text == word)
    }

    fn erased(&mut self, name: &'a tree::Name) -> Option<Ref> {
        if !self.first("erase", name) {
            return None;
        }
        let id = self.drawn("erase", name)?;
        Some(mention(id, name))
    }

    fn kept(&mut self, name: &'a tree::Name) {
        if !self.first("keep", name) {
            return;
        }
        let Some(id) = self.drawn("keep", name) else { return };
        if self.names.is_suppressed(id) {
            return self.report.fail();
        }
        let word = &name.ident.text;
        let kind = self.names.get(id).kind;
        let error = if !matches!(kind, Kind::Vertex | Kind::Edge | Kind::Face) {
            let message =
                format!("`{word}` is {}; `keep` names vertices, edges and faces", kind.a_word());
            let note = "a halfedge stays where its face and its edge are kept";
            if self.report.says(note) {
                return self.report.fail();
            }
            let error = Diagnostic::error("cannot-keep", message, name.span);
            if kind == Kind::Halfedge { error.note(note) } else { error }
        } else if !self.names.readable(id) || (kind != Kind::Vertex && !self.stated(id)) {
            let message = format!("`before` says nothing of `{word}` that could be kept");
            Diagnostic::error("cannot-keep", message, name.span)
        } else {
            return;
        };
        self.report.add(error);
    }

    /// True if `before` states this edge or face.
    fn stated(&self, id: NameId) -> bool {
        let edge = self.before.edges.iter().any(|edge| edge.edge.name == id);
        edge || self.before.loops.iter().any(|l| l.face.name == id)
    }

    /// The number of a listed name; reports a name that is drawn nowhere.
    fn drawn(&mut self, list: &str, name: &tree::Name) -> Option<NameId> {
        let word = &name.ident.text;
        let found = self.names.find(word);
        if found.is_none() {
            let message = format!("`{word}` is listed in `{list}` but drawn nowhere");
            let error = Diagnostic::error("unknown-name", message, name.span);
            self.report.add(suggest(error, word, name.span, self.names.words()));
        }
        found
    }
}

/// A reference to a name, with the offset of its subscript.
pub(super) fn mention(id: NameId, name: &tree::Name) -> Ref {
    let offset = name.index.as_ref().map_or(0, |index| index.offset);
    Ref {
        name: id,
        // A subscript that is too wide has been rejected.
        shift: i32::try_from(offset).unwrap_or(0),
        span: name.span,
    }
}

/// Repeats in `after` what `before` states of a name, as if it were written where the
/// name is kept; `false` if it states nothing.
pub(super) fn restate(kept: Ref, before: &Side, after: &mut Side) -> bool {
    let mut stated = Side::default();
    let is = |subject: Ref| subject.name == kept.name;
    stated.loops.extend(before.loops.iter().find(|orbit| is(orbit.face)).cloned());
    stated.edges.extend(before.edges.iter().find(|edge| is(edge.edge)).cloned());
    stated.stars.extend(before.stars.iter().find(|star| is(star.vertex)).cloned());
    stated.mentions_mut().for_each(|mention| mention.span = kept.span);
    for orbit in &mut stated.loops {
        (orbit.face, orbit.span) = (kept, kept.span);
    }
    for edge in &mut stated.edges {
        (edge.edge, edge.span) = (kept, kept.span);
    }
    for star in &mut stated.stars {
        (star.vertex, star.span) = (kept, kept.span);
        for spoke in &mut star.spokes {
            if let Spoke::Rest(span) = spoke {
                *span = kept.span;
            }
        }
    }
    let states = stated.mentions().next().is_some();
    after.loops.append(&mut stated.loops);
    after.edges.append(&mut stated.edges);
    after.stars.append(&mut stated.stars);
    states
}
