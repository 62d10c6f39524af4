//! Laws 1 and 2: every name, and every pointer of every name, is accounted for.
//!
//! Law 1: each name of `before` is drawn in `after` or erased, never both; each name of
//! `after` is drawn in `before` or new. Law 2: a halfedge whose loop (so `next`, `vertex`
//! and `face`) or edge (so `twin` and `edge`) is stated in `before` has it stated again in
//! `after`, or is erased; a new halfedge has both.
//!
//! Both are reported together, one diagnostic for each missing orbit: a person forgets a statement,
//! not a pointer.

use std::collections::BTreeSet;

use super::forgotten::{as_a_hole, is_forgotten};
use super::outside::{beside, twin_beside};
use super::pairing::{free_edges, lost_loops, missing_loops, pairing, unpaired};
use super::problem::{Problem, Repair, enumerate, is_or_are, keyword};
use super::repairs::insertions;
use super::stale::Stale;
use super::unknown_names::Unknown;
use crate::diagnostic::{Diagnostic, all_of};
use crate::diagram::{Drawing, Edge, Kind, Loop, NameId, Ref};
use crate::source::Span;

/// Tests the laws.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    if let Some(empty) = draws_nothing(drawing) {
        return vec![empty.into()];
    }
    let unknown = Unknown::find(drawing);
    let mut problems: Vec<Problem> = Vec::new();
    problems.extend(unknown.problems);
    let mut law = Law { drawing, explained: unknown.meant, placed: Vec::new(), problems };
    law.erased_and_drawn();
    law.loops();
    law.edges();
    law.other_names();
    law.new_halfedges();
    one_for_another(law.problems)
}

/// An unknown name is often written for a forgotten one: if there is exactly one of each, they are
/// reported together.
fn one_for_another(problems: Vec<Problem>) -> Vec<Problem> {
    let is_one = |problem: &Problem, code| problem.diagnostic.code == code;
    match problems.as_slice() {
        [unknown, missing]
            if is_one(unknown, "unknown-name") && is_one(missing, "missing-reassignment") =>
        {
            let mut told = unknown.clone();
            let message = missing.diagnostic.message.clone();
            told.diagnostic = told.diagnostic.label(missing.diagnostic.span(), "forgotten");
            told.diagnostic.notes.insert(0, message);
            vec![told]
        }
        _ => problems,
    }
}

/// The message about an `after` that says nothing of what `before` draws.
fn draws_nothing(drawing: &Drawing) -> Option<Diagnostic> {
    let (rule, after) = (drawing.rule, &drawing.rule.after);
    let is_empty = after.loops.is_empty() && after.edges.is_empty() && after.stars.is_empty();
    let drawn = rule.before.loops.first()?;
    let is_silent = is_empty && rule.created.is_empty() && rule.erased.is_empty();
    (is_silent && after.kept.is_empty()).then(|| {
        let message = "`after` says nothing of what `before` draws";
        let edges = rule.before.edges.iter().map(|edge| edge.edge.name);
        let faces = rule.before.loops.iter().map(|orbit| orbit.face.name);
        let named = faces.chain(edges).filter(|&name| rule.name(name).named && rule.is_first(name));
        let words: Vec<_> = named.map(|name| rule.name(name).text.as_str()).collect();
        let keep = if words.is_empty() { "f0 e".to_owned() } else { words.join(" ") };
        Diagnostic::error("unaccounted-name", message, after_keyword(drawing))
            .saying("nothing is drawn here")
            .label(drawn.span, "what is drawn here is drawn again there, or erased")
            .note(format!(
                "`after` is all that is there then: what stays as it is is listed, `keep {keep}`"
            ))
    })
}

/// The keyword `after`, to point at a place where something is missing.
pub(super) fn after_keyword(drawing: &Drawing) -> Span {
    keyword(&drawing.rule.after, "after")
}

struct Law<'a> {
    drawing: &'a Drawing<'a>,
    /// Names that need no further report.
    explained: Vec<NameId>,
    /// New halfedges whose loop needs no further report.
    placed: Vec<NameId>,
    problems: Vec<Problem>,
}

impl Law<'_> {
    fn erased_and_drawn(&mut self) {
        for name in self.names() {
            let (Some(erased), Some(drawn)) =
                (self.drawing.erased(name), self.drawing.after.mention(name))
            else {
                continue;
            };
            // That a run cannot be erased at all is reported below.
            if matches!(self.drawing.rule.kind(name), Kind::Path | Kind::Fan) {
                continue;
            }
            let text = self.drawing.rule.quoted(name);
            let message = format!("{text} is erased, and drawn in `after` as well");
            let problem = Diagnostic::error("erased-and-drawn", message, drawn)
                .saying("drawn here")
                .label(erased, "erased here");
            self.problems.push(problem.into());
            self.explained.push(name);
        }
        for name in self.names() {
            let run = matches!(self.drawing.rule.kind(name), Kind::Path | Kind::Fan);
            let Some(erased) = self.drawing.erased(name).filter(|_| run) else { continue };
            let text = self.drawing.rule.quoted(name);
            let kind = self.drawing.rule.kind(name);
            let what = kind.word();
            let message = format!("the {what} {text} cannot be erased: nobody knows what is in it");
            let mut problem = Diagnostic::error("erased-run", message, erased)
                .note(match kind {
                    Kind::Fan => "its spokes go on at another vertex: list the fan in the statement of that vertex in `after`",
                    _ => "it goes on in another loop: draw it there in `after`; only what is drawn one by one can be erased",
                });
            let orbit = self.drawing.before.loop_of_item(name);
            problem.notes.extend(orbit.and_then(|orbit| as_a_hole(self.drawing, orbit)));
            self.problems.push(problem.into());
            self.explained.push(name);
        }
    }

    fn names(&self) -> impl Iterator<Item = NameId> + use<> {
        self.drawing.rule.ids()
    }

    fn is_open(&self, name: NameId) -> bool {
        self.drawing.survives(name) && !self.explained.contains(&name)
    }

    /// Reports halfedges and paths that are in a loop before, and in none after. If exactly one
    /// loop has no statement after, they belong there, whatever loops they come from, and are
    /// reported together.
    fn loops(&mut self) {
        let drawing = self.drawing;
        let missing = |orbit: &Loop| -> Vec<Ref> {
            let items = orbit.items.iter().map(|item| item.item);
            let open = items.filter(|item| self.is_open(item.name));
            open.filter(|item| drawing.after.loop_of_item(item.name).is_none()).collect()
        };
        let orbits = drawing.rule.before.loops.iter();
        let orbits: Vec<_> = orbits
            .map(|orbit| (orbit, missing(orbit)))
            .filter(|(_, missing)| !missing.is_empty())
            .collect();
        match lost_loops(drawing).count() {
            1 if !orbits.is_empty() && drawing.rule.cycle.is_none() => {
                self.loop_is_missing(&orbits);
                self.would_stand_there(&orbits);
            }
            // The two sides of an edge that is erased are forgotten together.
            _ if drawing.rule.cycle.is_none()
                && orbits.len() > 1
                && self.are_of_erased_edges(&orbits) =>
            {
                self.loop_is_missing(&orbits);
            }
            _ => {
                for orbit in &orbits {
                    self.loop_is_missing(std::slice::from_ref(orbit));
                }
            }
        }
    }

    /// True if all these halfedges belong to edges that are erased.
    fn are_of_erased_edges(&self, orbits: &[(&Loop, Vec<Ref>)]) -> bool {
        let drawing = self.drawing;
        let mut missing = orbits.iter().flat_map(|(_, missing)| missing);
        missing.all(|half| {
            let edge = drawing.before.pairing(half.name);
            edge.is_some_and(|edge| drawing.erased(edge.edge.name).is_some())
        })
    }

    /// Marks what the missing loop would draw, besides its former items, as explained.
    fn would_stand_there(&mut self, orbits: &[(&Loop, Vec<Ref>)]) {
        let drawing = self.drawing;
        for item in orbits.iter().flat_map(|(_, missing)| missing) {
            let ends = [drawing.before.loop_origin(item.name), drawing.target_before(item.name)];
            let undrawn = |vertex: &NameId| drawing.after.mention(*vertex).is_none();
            self.explained.extend(ends.into_iter().flatten().filter(undrawn));
        }
        for created in &drawing.rule.created {
            let is_halfedge = drawing.rule.kind(created.name) == Kind::Halfedge;
            if !is_halfedge || drawing.after.loop_of_item(created.name).is_some() {
                continue;
            }
            self.placed.push(created.name);
            if let Some(told) = self.problems.pop() {
                let text = drawing.rule.quoted(created.name);
                let text = format!("no loop of `after` holds {text}, either");
                let diagnostic = told.diagnostic.label(created.span, text);
                self.problems.push(Problem { diagnostic, ..told });
            }
        }
    }

    /// Reports items of some loops of `before` that are in no loop after.
    fn loop_is_missing(&mut self, orbits: &[(&Loop, Vec<Ref>)]) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let names_of = |orbits: &[(&Loop, Vec<Ref>)]| -> Vec<NameId> {
            orbits.iter().flat_map(|(_, missing)| missing).map(|item| item.name).collect()
        };
        let open = names_of(orbits);
        // In an unrolled rule, the first member is reported for its family.
        let mut orbits = orbits.to_vec();
        for (_, items) in &mut orbits {
            let mut written = BTreeSet::new();
            items.retain(|item| written.insert(item.span));
        }
        let names = names_of(&orbits);
        let list = enumerate(rule, &names);
        let message = if names.len() == 1 && drawing.after.mention(names[0]).is_none() {
            format!("{list} is neither reassigned nor erased")
        } else {
            format!(
                "{list} {} not reassigned: no loop of `after` holds {}",
                is_or_are(names.len()),
                if names.len() == 1 { "it" } else { "them" }
            )
        };
        let place =
            |orbit: &Loop| format!("drawn in the loop of {} here", rule.quoted(orbit.face.name));
        let (first, items) = &orbits[0];
        let mut diagnostic =
            Diagnostic::error("missing-reassignment", message, items[0].span).saying(place(first));
        for item in &items[1..] {
            diagnostic = diagnostic.label(item.span, "");
        }
        for (orbit, items) in &orbits[1..] {
            diagnostic = diagnostic.label(items[0].span, place(orbit));
            for item in &items[1..] {
                diagnostic = diagnostic.label(item.span, "");
            }
        }
        let face = first.face.name;
        diagnostic = match drawing.erased(face) {
            Some(span) if orbits.len() == 1 => {
                diagnostic.label(span, format!("{} is erased here", rule.quoted(face)))
            }
            _ => diagnostic.label(after_keyword(drawing), format!("no loop here holds {list}")),
        };
        diagnostic = diagnostic.note(Stale::of_loop(drawing, &names).sentence());
        diagnostic.notes.extend(as_a_hole(drawing, first));
        let mut repairs = vec![Repair::Erase(names.clone())];
        if let Some([draw]) = missing_loops(drawing).as_deref() {
            repairs.push(draw.clone());
        }
        if orbits.len() == 1 {
            repairs.push(Repair::Keep(vec![face]));
        }
        if let &[item] = names.as_slice() {
            repairs.extend(insertions(drawing, item));
        }
        for (orbit, _) in &orbits {
            let face = orbit.face.name;
            if drawing.after.mention(face).is_none() && drawing.erased(face).is_none() {
                repairs.push(Repair::Erase(names.iter().copied().chain([face]).collect()));
                self.explained.push(face);
            }
        }
        self.explained.extend(open.iter().filter(|&&name| drawing.after.pairing(name).is_none()));
        self.problems.push(Problem { diagnostic, repairs });
    }

    /// Reports halfedges that are paired before, and not after.
    fn edges(&mut self) {
        let drawing = self.drawing;
        let missing = |edge: &Edge| {
            let open = edge.halfedges.iter().copied().filter(|half| self.is_open(half.name));
            open.filter(|half| drawing.after.pairing(half.name).is_none()).collect::<Vec<_>>()
        };
        let edges = drawing.rule.before.edges.iter();
        let edges: Vec<_> = edges
            .map(|edge| (edge, missing(edge)))
            .filter(|(_, missing)| !missing.is_empty())
            .collect();
        // Two halfedges that are left over belong together, whatever edges they come from.
        match edges.as_slice() {
            [(_, one), (_, two)]
                if one.len() == 1 && two.len() == 1 && unpaired(self.drawing).len() == 2 =>
            {
                self.edge_is_missing(&edges);
            }
            edges => {
                for edge in edges {
                    self.edge_is_missing(std::slice::from_ref(edge));
                }
            }
        }
    }

    /// Reports that the halfedges of some edges of `before` are not paired after.
    fn edge_is_missing(&mut self, edges: &[(&Edge, Vec<Ref>)]) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let names = edges.iter().flat_map(|(_, missing)| missing);
        let names: Vec<_> = names.map(|half| half.name).collect();
        let twins = all_of(names.iter().map(|&name| format!("`{}.twin`", rule.name(name).text)));
        let message = format!("{twins} {} not reassigned", is_or_are(names.len()));
        let place = |(edge, missing): &(&Edge, Vec<Ref>)| {
            let drawn = missing.iter().map(|half| half.span).reduce(Span::to);
            let text = format!("the edge {} is drawn here", rule.quoted(edge.edge.name));
            (drawn.unwrap_or(edge.span), text)
        };
        let (first, text) = place(&edges[0]);
        let mut diagnostic = Diagnostic::error("missing-reassignment", message, first).saying(text);
        for edge in &edges[1..] {
            let (span, text) = place(edge);
            diagnostic = diagnostic.label(span, text);
        }
        diagnostic = diagnostic
            .label(
                after_keyword(drawing),
                format!("no edge statement here names {}", enumerate(rule, &names)),
            )
            .note(Stale::of_edge(drawing, &names).sentence());
        let whole = match edges {
            [(edge, missing)] if missing.len() == 2 => Some(edge.edge.name),
            _ => None,
        };
        let mut repairs = self.pairings(whole);
        if let [Repair::Keep(_), ..] = repairs.as_slice() {
            let rule =
                "what `before` draws is drawn again in `after`, even where it stays as it is";
            diagnostic = diagnostic.note(rule);
        }
        repairs.push(Repair::Erase(names.clone()));
        self.explained.extend(names.iter().filter(|&&name| drawing.is_outer(name)));
        for (edge, _) in edges {
            if drawing.after.mention(edge.edge.name).is_none() {
                self.explained.push(edge.edge.name);
            }
        }
        // The other half of the missing edge is reported with it.
        for repair in &repairs {
            if let Repair::Pair(edges) = repair {
                let halves = edges.iter().flat_map(|(_, halves)| halves);
                self.explained.extend(halves.filter(|half| !names.contains(half)));
            }
        }
        self.problems.push(Problem { diagnostic, repairs });
    }

    /// The repairs that pair unpaired halfedges: the edge as it was, if both of its halfedges are
    /// unpaired, or by their ends, or, if exactly two halfedges are unpaired, those two.
    fn pairings(&self, whole: Option<NameId>) -> Vec<Repair> {
        let drawing = self.drawing;
        let free: Vec<_> = free_edges(drawing).collect();
        let kept = whole.filter(|edge| free.contains(edge));
        let mut repairs: Vec<_> = kept.map(|edge| Repair::Keep(vec![edge])).into_iter().collect();
        if let [left, right] = unpaired(self.drawing)[..] {
            let own = [left, right].map(|half| drawing.before.edge(half));
            let is_own = |edge: &&NameId| own.contains(&Some(**edge));
            let own: Vec<_> = free.iter().filter(is_own).copied().collect();
            let edges = if own.is_empty() { free } else { own };
            let edges = edges.into_iter().filter(|&edge| kept != Some(edge));
            repairs.extend(edges.map(|edge| Repair::Pair(vec![(edge, [left, right])])));
        }
        repairs
    }

    /// Reports vertices, edges, faces and fans that are drawn before, and nowhere after; those of
    /// one kind together.
    fn other_names(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let forgotten = |name: &NameId| {
            self.is_open(*name)
                && drawing.after.mention(*name).is_none()
                // Halfedges and paths are reported with their loops.
                && drawing.before.loop_of_item(*name).is_none()
        };
        let forgotten: Vec<_> = self.names().filter(forgotten).collect();
        let mut told: Vec<Kind> = Vec::new();
        for &name in &forgotten {
            let kind = rule.kind(name);
            let alike: Vec<_> = match kind {
                // In an unrolled rule, the first member is reported for its family.
                _ if rule.cycle.is_some() => vec![name],
                Kind::Vertex | Kind::Edge | Kind::Face if told.contains(&kind) => continue,
                Kind::Vertex | Kind::Edge | Kind::Face => {
                    forgotten.iter().copied().filter(|&other| rule.kind(other) == kind).collect()
                }
                Kind::Halfedge | Kind::Path | Kind::Fan => vec![name],
            };
            told.push(kind);
            self.problems.push(is_forgotten(drawing, kind, &alike));
        }
    }

    /// Reports new halfedges without a loop or an edge.
    fn new_halfedges(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        for created in &rule.created {
            let name = created.name;
            if rule.kind(name) != Kind::Halfedge {
                continue;
            }
            let text = rule.quoted(name);
            let word = &rule.name(name).text;
            let lacks = |what: &str, pointers: String| {
                let message = format!("the new halfedge {text} stands in no {what}");
                Diagnostic::error("missing-reassignment", message, created.span)
                    .saying(format!("{pointers} would be unset"))
            };
            if drawing.after.loop_of_item(name).is_none() && !self.placed.contains(&name) {
                let pointers = format!("`{word}.next`, `{word}.vertex` and `{word}.face`");
                let mut diagnostic = lacks("loop of `after`", pointers);
                diagnostic.notes.extend(beside(drawing, name));
                self.problems.push(diagnostic.into());
            }
            if drawing.after.pairing(name).is_none() && !self.explained.contains(&name) {
                if self.all_unpaired(name, created.span) {
                    continue;
                }
                let mut diagnostic =
                    lacks("edge of `after`", format!("`{word}.twin` and `{word}.edge`"));
                let repairs = self.pairings(None);
                if repairs.is_empty() {
                    diagnostic.notes.extend(twin_beside(drawing, name));
                }
                for repair in &repairs {
                    if let Repair::Pair(edges) = repair {
                        self.explained.extend(edges.iter().flat_map(|(_, halves)| halves));
                    }
                }
                self.problems.push(Problem { diagnostic, repairs });
            }
        }
    }
}

impl Law<'_> {
    /// Reports all new halfedges without an edge together, if there are several and no edge name is
    /// free for them; returns whether it did.
    fn all_unpaired(&mut self, first: NameId, span: Span) -> bool {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let is_open =
            |half: &NameId| drawing.created(*half).is_some() && !self.explained.contains(half);
        let open: Vec<_> = unpaired(self.drawing).into_iter().filter(is_open).collect();
        // In an unrolled rule, the first member is reported for its family.
        let told: Vec<_> = open.iter().copied().filter(|&half| rule.is_first(half)).collect();
        if told.len() < 2 || !self.pairings(None).is_empty() {
            return false;
        }
        let list = enumerate(rule, &told);
        let message = format!("the new halfedges {list} stand in no edge of `after`");
        let word = &rule.name(first).text;
        let mut diagnostic = Diagnostic::error("missing-reassignment", message, span)
            .saying(format!("`{word}.twin` and `{word}.edge` would be unset"));
        for other in told.iter().filter(|&&other| other != first) {
            if let Some(listed) = drawing.created(*other) {
                diagnostic = diagnostic.label(listed, "");
            }
        }
        let repairs = pairing(drawing).into_iter().collect();
        self.explained.extend(open);
        self.problems.push(Problem { diagnostic, repairs });
        true
    }
}
