//! The statements of one side: loops, edges and stars with their names resolved.

use std::collections::{HashMap, HashSet};

use crate::diagnostic::Diagnostic;
use crate::diagram::{Edge, Kind, Loop, LoopItem, LoopKind, NameId, Ref, Role, Side, Spoke, Star};
use crate::source::Span;
use crate::syntax::tree::{self, Arrow, LoopKeyword, Statement};

use super::fields::is_pointer;
use super::lists::{mention, restate};
use super::mention::{drawn_parts, path_of};
use super::names::Names;
use super::report::Report;

/// The state while one side of a rule is resolved.
pub(super) struct Drawing<'a> {
    names: &'a Names,
    report: &'a mut Report,
    side: Side,
    /// The span of the statement of each face, edge and vertex.
    stated: HashMap<NameId, Span>,
    /// True if the statement after the current one could not be read.
    breaks_off: bool,
    /// The items missing from the loops of `after`; empty for `before`.
    lacking: Vec<Lacking>,
}

/// A halfedge or path that is in a loop of `before`, or new, and in no loop of `after`.
struct Lacking {
    item: NameId,
    /// The vertices at its ends in `before`; `None` if it is new.
    ends: Option<[NameId; 2]>,
}

/// True if the statement after this one could not be read: it may belong to this one.
fn breaks_off(side: &tree::Side, at: usize) -> bool {
    matches!(side.statements.get(at + 1), Some(Statement::Broken(_)))
}

/// Resolves the drawing `before`.
pub(super) fn draw_before(side: &tree::Side, names: &Names, report: &mut Report) -> Side {
    let mut drawing = Drawing::new(side, names, report);
    for (at, statement) in side.statements.iter().enumerate() {
        drawing.breaks_off = breaks_off(side, at);
        if !drawing.orbit(statement) {
            drawing.only_in_after(statement);
        }
    }
    drawing.side
}

/// Resolves the drawing `after`; `keep` restates what `before` states.
pub(super) fn draw_after(
    side: &tree::Side,
    before: &Side,
    names: &Names,
    report: &mut Report,
) -> Side {
    let mut drawing = Drawing::new(side, names, report);
    drawing.lacking = lacking(side, before, names);
    for (at, statement) in side.statements.iter().enumerate() {
        drawing.breaks_off = breaks_off(side, at);
        if !drawing.orbit(statement)
            && let Statement::Keep(kept, span) = statement
        {
            drawing.side.keeps.push(*span);
            for name in kept {
                drawing.keep(name, before);
            }
        }
    }
    for l in &mut drawing.side.loops {
        missing_path(l, names, drawing.report);
        // A `loop` stays what it was.
        let before = before.loops.iter().find(|other| other.face.name == l.face.name);
        if let Some(before) = before.filter(|_| l.kind == LoopKind::Any) {
            l.kind = before.kind;
        }
    }
    drawing.side
}

/// The named items of `before` and new halfedges that no loop of `after` contains and that are not
/// erased.
fn lacking(side: &tree::Side, before: &Side, names: &Names) -> Vec<Lacking> {
    let mut held: HashSet<NameId> = HashSet::new();
    let mut created = Vec::new();
    for statement in &side.statements {
        let listed: Vec<&tree::Name> = match statement {
            Statement::Loop(_) => drawn_parts(statement).collect(),
            Statement::Erase(listed, _) => listed.iter().collect(),
            Statement::Keep(kept, _) => {
                let kept: Vec<_> =
                    kept.iter().filter_map(|name| names.find(&name.ident.text)).collect();
                let loops = before.loops.iter().filter(|l| kept.contains(&l.face.name));
                held.extend(loops.flat_map(|l| &l.items).map(|item| item.item.name));
                continue;
            }
            Statement::New(listed, _) => {
                created.extend(listed.iter().filter_map(|name| names.find(&name.ident.text)));
                continue;
            }
            _ => continue,
        };
        held.extend(listed.iter().filter_map(|name| names.find(&name.ident.text)));
    }
    let mut lacking = Vec::new();
    for l in &before.loops {
        for (at, item) in l.items.iter().enumerate() {
            let to = l.items.get(at + 1).map_or(l.end, |next| next.from);
            let ends = Some([item.from.name, to.name]);
            lacking.push(Lacking { item: item.item.name, ends });
        }
    }
    let halfedges = created.into_iter().filter(|&name| names.get(name).kind == Kind::Halfedge);
    lacking.extend(halfedges.map(|item| Lacking { item, ends: None }));
    lacking.retain(|one| names.get(one.item).named && !held.contains(&one.item));
    lacking
}

/// Reports an unnamed path in a loop without one in `before`: it stands for that path.
fn missing_path(l: &Loop, names: &Names, report: &mut Report) {
    let unnamed = |item: &&LoopItem| !names.get(item.item.name).named;
    let Some(item) = l.items.iter().find(unnamed) else { return };
    if !names.readable(item.item.name) {
        let face = &names.get(l.face.name).text;
        let message = format!("the loop of `{face}` has no path without a name in `before`");
        let error = Diagnostic::error("unknown-path", message, item.item.span)
            .note("a path without a name is the one of the same loop; give it a name to move it");
        report.add(error);
    }
}

impl<'a> Drawing<'a> {
    fn new(side: &tree::Side, names: &'a Names, report: &'a mut Report) -> Self {
        Self {
            names,
            report,
            side: Side { span: side.span, ..Side::default() },
            stated: HashMap::new(),
            breaks_off: false,
            lacking: Vec::new(),
        }
    }

    /// Resolves a statement of an orbit; `false` if it is another kind of statement.
    fn orbit(&mut self, statement: &Statement) -> bool {
        // Names without a number and incomplete statements have been reported before.
        let drawn = match statement {
            Statement::Loop(l) => self.face(l),
            Statement::Edge { name, halfedges, span } => self.edge(name, halfedges, *span),
            Statement::Vertex(star) => self.star(star),
            Statement::Broken(_) => None,
            Statement::New(..)
            | Statement::Erase(..)
            | Statement::Keep(..)
            | Statement::Assign { .. } => return false,
        };
        if drawn.is_none() {
            self.report.fail();
        }
        true
    }

    fn only_in_after(&mut self, statement: &Statement) {
        let (what, span) = match statement {
            Statement::New(_, span) => ("`new`", *span),
            Statement::Erase(_, span) => ("`erase`", *span),
            Statement::Keep(_, span) => ("`keep`", *span),
            Statement::Assign { attribute, span, .. } if is_pointer(&attribute.text) => {
                let message = "pointers are not assigned: `before` draws what they are";
                self.report.add(Diagnostic::error("not-in-before", message, *span));
                return;
            }
            Statement::Assign { span, .. } => ("an assignment", *span),
            _ => return,
        };
        let message = format!("{what} stands in `after`, not in `before`");
        self.report.add(Diagnostic::error("not-in-before", message, span));
    }

    pub(super) fn refer(&self, name: &tree::Name) -> Option<Ref> {
        let id = self.names.find(&name.ident.text)?;
        Some(mention(id, name))
    }

    /// Records where an element is stated, and reports a second statement.
    pub(super) fn state(&mut self, what: Ref, span: Span) {
        let Some(first) = self.stated.insert(what.name, span) else { return };
        if self.names.is_suppressed(what.name) {
            return self.report.fail();
        }
        let name = self.names.get(what.name);
        let message = format!("the {} `{}` is stated twice", name.kind.word(), name.text);
        let error = Diagnostic::error("stated-twice", message, span)
            .saying("stated again")
            .label(first, "stated first");
        self.report.add(error);
    }

    fn face(&mut self, l: &tree::Loop) -> Option<()> {
        let face = self.refer(&l.name)?;
        self.state(face, l.span);
        let word = &l.name.ident.text;
        let mut items = Vec::new();
        let mut unnamed: Option<Span> = None;
        for item in &l.items {
            let from = self.refer(&item.from)?;
            let item = match &item.arrow {
                Arrow::Halfedge(name) | Arrow::Path(Some(name)) => self.refer(name)?,
                Arrow::Path(None) => {
                    if let Some(first) = unnamed.replace(item.span) {
                        let message = format!("the loop of `{word}` has two paths without a name");
                        let error = Diagnostic::error("two-unnamed-paths", message, item.span)
                            .label(first, "the first is here")
                            .note("give one of them a name: `=P=>`");
                        self.report.add(error);
                    }
                    let path = self.names.find(&path_of(word))?;
                    let shift = self.refer(&l.name)?.shift;
                    Ref { name: path, shift, span: item.span }
                }
            };
            items.push(LoopItem { from, item });
        }
        // The parser accepts no loop without a halfedge and an end.
        let first = items.first()?.from;
        let end = match (&l.end, &l.each) {
            (Some(end), _) => self.refer(end)?,
            (None, Some(_)) => first,
            (None, None) => return None,
        };
        if (end.name, end.shift) != (first.name, first.shift) {
            self.open_loop(word, l, [end.name, first.name]);
        }
        self.side.loops.push(Loop {
            kind: match l.keyword {
                LoopKeyword::Face => LoopKind::Face,
                LoopKeyword::Hole => LoopKind::Hole,
                LoopKeyword::Loop => LoopKind::Any,
            },
            face,
            items,
            each: l.each.is_some(),
            end,
            span: l.span,
        });
        Some(())
    }

    fn open_loop(&mut self, face: &str, l: &tree::Loop, gap: [NameId; 2]) {
        if self.breaks_off {
            self.report.fail();
            return;
        }
        let ([first, ..], Some(end)) = (l.items.as_slice(), &l.end) else { return };
        // Subscripts at the corners of a single loop have been reported.
        if l.name.index.is_none() && l.each.is_none() && first.from.index.is_some() {
            self.report.fail();
            return;
        }
        let [begins, ends] = [&first.from, end].map(ToString::to_string);
        let message = format!("the loop of `{face}` begins at `{begins}`, but ends at `{ends}`");
        let error = Diagnostic::error("open-loop", message, end.span)
            .saying("it ends here")
            .label(first.from.span, "it begins here");
        if let Some(item) = self.lacks(gap) {
            let name = self.names.get(item);
            let word = match (name.role, self.names.cycle()) {
                (Role::Family, Some(cycle)) => format!("{}[{}]", name.text, cycle.letter),
                _ => name.text.clone(),
            };
            let arrow = match name.kind {
                Kind::Path => format!("={word}=>"),
                _ => format!("-{word}->"),
            };
            let rest = format!(" {arrow} {begins}");
            self.report.add(error.label(name.span, "in no loop of `after`").fix(
                format!("go on with `{}`", rest.trim()),
                end.span.after(),
                rest,
            ));
            return;
        }
        // An end that is written nowhere else is a slip if the other end is, and so is one that the
        // last item both leaves and leads to. Otherwise the loop may be meant to go on.
        let stands_alone = |name: &tree::Name| {
            self.names.find(&name.ident.text).is_none_or(|id| self.names.is_alone(id))
        };
        let alone = [&first.from, end].map(stands_alone);
        let last = l.items.last();
        let runs_back = last.is_some_and(|last| last.from.to_string() == ends);
        self.report.add(match alone {
            [true, false] if !runs_back => {
                error.fix(format!("begin at `{ends}`"), first.from.span, ends)
            }
            _ if runs_back || alone == [false, true] => {
                error.fix(format!("end at `{begins}`"), end.span, begins)
            }
            _ => error.note(format!(
                "a loop ends where it begins: go on to `{begins}`, with a halfedge `-h-> {begins}` or a path `=P=> {begins}`"
            )),
        });
    }

    /// The item that closes a gap in a loop, if it is certain: the only missing item with these
    /// ends, or the only missing item at all if its ends are not known.
    fn lacks(&self, gap: [NameId; 2]) -> Option<NameId> {
        let fitting: Vec<_> = self.lacking.iter().filter(|one| one.ends == Some(gap)).collect();
        match (fitting.as_slice(), self.lacking.as_slice()) {
            ([one], _) => Some(one.item),
            ([], [one]) if one.ends.is_none() => Some(one.item),
            _ => None,
        }
    }

    fn edge(&mut self, name: &tree::Name, halfedges: &[tree::Name; 2], span: Span) -> Option<()> {
        let edge = self.refer(name)?;
        self.state(edge, span);
        let [first, second] = halfedges;
        let halfedges = [self.refer(first)?, self.refer(second)?];
        self.side.edges.push(Edge { edge, halfedges, span });
        Some(())
    }

    fn star(&mut self, star: &tree::Star) -> Option<()> {
        let vertex = self.refer(&star.name)?;
        self.state(vertex, star.span);
        let mut spokes = Vec::new();
        for spoke in &star.spokes {
            spokes.push(match spoke {
                tree::Spoke::Halfedge(name) => Spoke::Halfedge(self.refer(name)?),
                tree::Spoke::Fan(Some(name), _) => Spoke::Fan(self.refer(name)?),
                tree::Spoke::Fan(None, span) => Spoke::Rest(*span),
            });
        }
        if spokes.is_empty() {
            // The parser accepts no vertex without spokes either.
            return None;
        }
        self.side.stars.push(Star { vertex, spokes, each: star.each.is_some(), span: star.span });
        Some(())
    }

    /// `keep x`: restates what `before` states of `x`.
    fn keep(&mut self, name: &tree::Name, before: &Side) {
        let Some(kept) = self.refer(name) else {
            // The lists report names that are drawn nowhere.
            return;
        };
        if self.side.kept.iter().any(|first| first.name == kept.name) {
            return;
        }
        let restated = restate(kept, before, &mut self.side);
        if restated {
            self.state(kept, kept.span);
        }
        self.side.kept.push(kept);
    }
}
