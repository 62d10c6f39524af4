//! Law 6: ends agree.
//!
//! If `x | y` is an edge, each starts where the other ends. A spoke starts at its vertex. A
//! halfedge named in `before` never hides in a fan: if its vertex has a vertex statement, it is
//! listed there. A halfedge of `before` is in a loop, or is the twin of one that is. A new loop is
//! a `face` or a `hole`. Two fans, or two paths, do not touch in `before`: nothing would tell where
//! one ends and the other begins.

use std::collections::BTreeSet;

use super::pairing::pairing;
use super::problem::{Problem, Repair, enumerate};
use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::diagram::{Drawing, Edge, Kind, LoopKind, NameId, Ref, Rule, Side, Spoke, Star, View};
use crate::source::Span;

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let mut law = Law { drawing, problems: Vec::new(), misled: Vec::new() };
    law.halfedges_are_placed();
    law.edges_join_their_ends(&drawing.rule.before, &drawing.before, "before");
    law.edges_join_their_ends(&drawing.rule.after, &drawing.after, "after");
    law.spokes_start_at_their_vertex();
    law.no_named_halfedge_hides_in_a_fan();
    law.runs_have_borders();
    law.new_loops_are_faces_or_holes();
    law.problems
}

/// Tests the ends of neighboring spokes: of two in a row in a vertex statement, the second is the
/// twin of the halfedge before the first, so it ends where that starts. The law about vertices
/// looks at the spokes and not at these ends.
pub(super) fn neighbors_are_twins(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let before = &drawing.before;
    let mut problems = Vec::new();
    for star in rule.before.stars.iter().filter(|star| !star.each) {
        for [spoke, next] in star.neighbors() {
            let arrives = before.item_before(spoke.name);
            let is_half = |item: &NameId| rule.kind(*item) == Kind::Halfedge;
            let Some(arrives) = arrives.filter(is_half) else { continue };
            let ends = [before.target_mention(next.name), before.origin_mention(arrives)];
            let [Some(end), Some(start)] = ends else { continue };
            if end.name == start.name {
                continue;
            }
            let [vertex, leaves, comes] =
                [star.vertex.name, next.name, arrives].map(|name| rule.quoted(name));
            let message = format!(
                "no mesh matches: around {vertex} {leaves} is the twin of {comes}, but it ends \
                     at {}, and {comes} starts at {}",
                rule.quoted(end.name),
                rule.quoted(start.name),
            );
            problems.push(
                Diagnostic::error("impossible-drawing", message, next.span)
                    .saying(format!("listed after {}", rule.quoted(spoke.name)))
                    .label(end.span, format!("{leaves} ends here"))
                    .label(start.span, format!("{comes} starts here"))
                    .note(format!(
                        "counterclockwise the spoke after `{0}` is `{0}.prev.twin`",
                        rule.name(spoke.name).text
                    ))
                    .into(),
            );
        }
    }
    problems
}

struct Law<'a> {
    drawing: &'a Drawing<'a>,
    problems: Vec<Problem>,
    /// Vertices of `before` whose statements list spokes that do not start there.
    misled: Vec<NameId>,
}

impl Law<'_> {
    fn tell(&mut self, diagnostic: Diagnostic) {
        self.problems.push(diagnostic.into());
    }

    fn halfedges_are_placed(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let mut told = Vec::new();
        for name in rule.names_of(Kind::Halfedge) {
            let Some(span) = drawing.before.mention(name) else { continue };
            let placed = |half| drawing.before.loop_of_item(half).is_some();
            // Of two twins, the first is reported for both.
            if drawing.before.twin(name).is_some_and(|twin| told.contains(&twin)) {
                continue;
            }
            if placed(name) || drawing.before.twin(name).is_some_and(placed) {
                continue;
            }
            told.push(name);
            let apart = apart_from_their_stars(rule, name);
            if let [first, ..] = apart.as_slice() {
                self.tell(no_name_of_a_fan(&rule.name(name).text, *first, &apart));
                continue;
            }
            let text = rule.quoted(name);
            let message =
                format!("{text} stands in no loop of `before`, and is no twin of one that does");
            let word = &rule.name(name).text;
            let index = word.find('[').map_or("", |at| &word[at..]);
            let origin = drawing.origin_before(name).map(|origin| rule.name(origin).text.clone());
            let origin = origin.unwrap_or_else(|| format!("{}{index}", rule.free_name("v")));
            let [face, target] = ["f", "w"].map(|letter| rule.free_name(letter) + index);
            let mut how = format!(
                "draw its loop, for example `loop {face}: {origin} -{word}-> {target} => {origin}`"
            );
            if index.is_empty() && drawing.before.twin(name).is_none() {
                let edge = rule.free_name("e");
                how += &format!(", or its twin in a loop and `edge {edge}: {word}' | {word}`");
            }
            let how = format!("{how}; in `after` list `keep {face}`");
            self.tell(Diagnostic::error("unplaced-halfedge", message, span).note(how));
        }
    }

    fn edges_join_their_ends(&mut self, side: &Side, view: &View, word: &str) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let (mut wrong, mut is_turned) = (Vec::new(), true);
        for edge in &side.edges {
            let [left, right] = edge.halfedges;
            for (ends, starts) in [(left, right), (right, left)] {
                let end = view.target_mention(ends.name);
                let start = view.origin_mention(starts.name);
                let (Some(end), Some(start)) = (end, start) else { continue };
                if end.name == start.name {
                    continue;
                }
                let message = format!(
                    "{} and {} cannot be twins in `{word}`: {} ends at {}, but {} starts at {}",
                    rule.quoted(left.name),
                    rule.quoted(right.name),
                    rule.quoted(ends.name),
                    rule.quoted(end.name),
                    rule.quoted(starts.name),
                    rule.quoted(start.name),
                );
                let mut diagnostic = Diagnostic::error("ends-disagree", message, edge.span)
                    .saying("paired here")
                    .label(end.span, format!("{} ends here", rule.quoted(ends.name)))
                    .label(start.span, format!("{} starts here", rule.quoted(starts.name)));
                let back = [left, right].map(|half| runs_back(drawing, view, half.name));
                let back = back.into_iter().flatten().next();
                let alike = run_alike(drawing, view, edge).filter(|_| back.is_none());
                is_turned &= alike.is_some();
                diagnostic.notes.extend(back.or(alike));
                wrong.push((edge, diagnostic));
                break;
            }
        }
        let turned = if is_turned { Some(view) } else { None };
        self.tell_of_edges(wrong, turned);
    }

    /// Reports all edges whose halfedges are not twins at once: what is swapped in one is swapped
    /// in another. If a loop may be drawn the wrong way round, in the view, that is a repair.
    fn tell_of_edges(&mut self, wrong: Vec<(&Edge, Diagnostic)>, turned: Option<&View>) {
        if self.drawing.rule.cycle.is_some() {
            wrong.into_iter().for_each(|(_, diagnostic)| self.tell(diagnostic));
            return;
        }
        let halves: Vec<_> = wrong.iter().flat_map(|(edge, _)| edge.halfedges).collect();
        let halves: Vec<_> = halves.iter().map(|half| half.name).collect();
        let mut repairs: Vec<_> = pairing(self.drawing).into_iter().collect();
        if let Some(view) = turned {
            let loops = halves.iter().filter_map(|&half| view.loop_of_item(half));
            let mut loops: Vec<_> = loops.map(|orbit| orbit.span).collect();
            loops.sort_unstable();
            loops.dedup();
            repairs.extend(loops.into_iter().map(Repair::Turn));
        }
        let mut wrong = wrong.into_iter();
        let Some((_, mut diagnostic)) = wrong.next() else { return };
        for (edge, _) in wrong {
            diagnostic = diagnostic.label(edge.span, "nor can these");
        }
        self.problems.push(Problem { diagnostic, repairs });
    }

    fn spokes_start_at_their_vertex(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        for (side, view, word) in
            [(&rule.before, &drawing.before, "before"), (&rule.after, &drawing.after, "after")]
        {
            let mut listed: Vec<Option<Ref>> = vec![None; rule.names.len()];
            for star in &side.stars {
                let mut wrong = Vec::new();
                for spoke in &star.spokes {
                    let (Spoke::Halfedge(spoke) | Spoke::Fan(spoke)) = *spoke else { continue };
                    let text = rule.quoted(spoke.name);
                    if let Some(first) = listed[spoke.name.index()] {
                        let message =
                            format!("{text} is listed twice in the vertex statements of `{word}`");
                        self.tell(
                            Diagnostic::error("spoke-twice", message, spoke.span)
                                .saying("here again")
                                .label(first.span, "here"),
                        );
                        continue;
                    }
                    listed[spoke.name.index()] = Some(spoke);
                    // The origin of the halfedge according to its loop, or to the loop of its twin.
                    let says = view
                        .origin_mention(spoke.name)
                        .or_else(|| view.target_mention(view.twin(spoke.name)?));
                    let Some(says) = says.filter(|says| says.name != star.vertex.name) else {
                        continue;
                    };
                    let vertex = rule.quoted(star.vertex.name);
                    let message = format!(
                        "{text} is listed as a spoke of {vertex}, but starts at {}",
                        rule.quoted(says.name)
                    );
                    let diagnostic = Diagnostic::error("ends-disagree", message, spoke.span)
                        .saying(format!("listed at {vertex} here"))
                        .label(says.span, format!("starts at {} here", rule.quoted(says.name)));
                    wrong.push((spoke, diagnostic));
                }
                if word == "before" && !wrong.is_empty() {
                    self.misled.push(star.vertex.name);
                }
                self.tell_of_spokes(star, wrong);
            }
        }
    }

    /// Reports all spokes that are listed at a vertex and do not start there.
    fn tell_of_spokes(&mut self, star: &Star, wrong: Vec<(Ref, Diagnostic)>) {
        let rule = self.drawing.rule;
        let names: Vec<_> = wrong.iter().map(|(spoke, _)| spoke.name).collect();
        if names.len() < 2 || rule.cycle.is_some() {
            wrong.into_iter().for_each(|(_, diagnostic)| self.tell(diagnostic));
            return;
        }
        let (list, vertex) = (enumerate(rule, &names), rule.quoted(star.vertex.name));
        let message = format!("{list} are listed as spokes of {vertex}, but start elsewhere");
        let mut diagnostic = Diagnostic::error("ends-disagree", message, star.span)
            .saying(format!("listed at {vertex} here"))
            .note("the spokes of a vertex are the halfedges that start there, counterclockwise");
        for (_, other) in wrong {
            diagnostic.labels.extend(other.labels.into_iter().skip(1));
        }
        self.tell(diagnostic);
    }

    fn no_named_halfedge_hides_in_a_fan(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        for star in &rule.before.stars {
            for name in rule.names_of(Kind::Halfedge) {
                let here = drawing.origin_before(name) == Some(star.vertex.name);
                let is_told = self.misled.contains(&star.vertex.name);
                if !here || is_told || drawing.before.star_of_spoke(name).is_some() {
                    continue;
                }
                let text = rule.quoted(name);
                let vertex = rule.quoted(star.vertex.name);
                let message =
                    format!("{text} starts at {vertex}, but the vertex statement does not list it");
                let drawn = drawing.before.mention(name).expect("it has an origin before");
                let mut diagnostic = Diagnostic::error("hidden-spoke", message, star.span)
                    .saying(format!("{text} is missing among the spokes"))
                    .label(drawn, "drawn here")
                    .note("a named halfedge never lies in a fan: moving the fan would relabel it twice");
                if let Some((after, word)) = self.place_of_spoke(star.spokes.as_slice(), name) {
                    diagnostic = diagnostic.fix(
                        format!("list {text} behind `{word}`"),
                        after.span.after(),
                        format!(" {}", rule.name(name).text),
                    );
                }
                self.tell(diagnostic);
            }
        }
    }

    /// The listed spoke that `name` surely follows, counterclockwise: `x` with `x.prev.twin` drawn
    /// as `name`.
    fn place_of_spoke(&self, spokes: &[Spoke], name: NameId) -> Option<(Ref, String)> {
        let view = &self.drawing.before;
        // Where one is listed twice, it may stand for this one.
        let mut listed = BTreeSet::new();
        if !spokes.iter().filter_map(Spoke::halfedge).all(|half| listed.insert(half)) {
            return None;
        }
        spokes.iter().find_map(|spoke| match spoke {
            Spoke::Halfedge(listed) if view.spoke_behind(listed.name) == Some(name) => {
                Some((*listed, self.drawing.rule.name(listed.name).text.clone()))
            }
            _ => None,
        })
    }

    fn runs_have_borders(&mut self) {
        let rule = self.drawing.rule;
        for orbit in &rule.before.loops {
            let count = orbit.items.len();
            for (at, item) in orbit.items.iter().enumerate() {
                let next = orbit.items[(at + 1) % count].item;
                let paths = [item.item, next].iter().all(|item| rule.kind(item.name) == Kind::Path);
                if paths && count > 1 {
                    let message = format!(
                        "nothing says where {} ends and {} begins",
                        rule.quoted(item.item.name),
                        rule.quoted(next.name)
                    );
                    self.tell(
                        Diagnostic::error("adjacent-runs", message, next.span)
                            .label(item.item.span, "")
                            .note("put a halfedge between two paths of `before`"),
                    );
                }
            }
        }
        for star in &rule.before.stars {
            let count = star.spokes.len();
            let is_fan = |at: usize| !matches!(star.spokes[at % count], Spoke::Halfedge(_));
            if count > 1 && (0..count).any(|at| is_fan(at) && is_fan(at + 1)) {
                let vertex = rule.quoted(star.vertex.name);
                let message =
                    format!("nothing says where one fan of {vertex} ends and the next begins");
                self.tell(
                    Diagnostic::error("adjacent-runs", message, star.span)
                        .note("put a spoke between two fans of `before`"),
                );
            }
        }
    }

    fn new_loops_are_faces_or_holes(&mut self) {
        let rule = self.drawing.rule;
        for orbit in &rule.after.loops {
            if orbit.kind == LoopKind::Any && self.drawing.created(orbit.face.name).is_some() {
                let text = rule.quoted(orbit.face.name);
                let message = format!("the new {text} must be a face or a hole");
                let keyword = Span { end: orbit.span.start + 4, ..orbit.span };
                self.tell(
                    Diagnostic::error("new-loop-kind", message, keyword)
                        .saying("`loop` means either")
                        .note("write `face` or `hole`"),
                );
            }
        }
    }
}

/// The places of a halfedge right behind fans without a name, each with the star, if `before` has
/// one: the name may be that of the fan.
fn apart_from_their_stars(rule: &Rule, name: NameId) -> Vec<[Span; 2]> {
    let places = |side: &Side| {
        let pairs = side.stars.iter().flat_map(|star| star.spokes.windows(2));
        let apart = pairs.filter_map(|pair| match pair {
            [Spoke::Rest(star), Spoke::Halfedge(half)] if half.name == name => {
                Some([*star, half.span])
            }
            _ => None,
        });
        apart.collect::<Vec<_>>()
    };
    let before = places(&rule.before);
    if before.is_empty() { before } else { [before, places(&rule.after)].concat() }
}

/// The error about `* S` where `*S` is meant.
fn no_name_of_a_fan(word: &str, [star, half]: [Span; 2], all: &[[Span; 2]]) -> Diagnostic {
    let message = format!("`{word}` stands apart from the star: a halfedge, which no loop draws");
    let joined = |[star, half]: &[Span; 2]| Edit {
        span: Span { start: star.end, end: half.start, ..*star },
        text: String::new(),
    };
    let title = format!("write `*{word}`");
    let fix = Fix { title, edits: all.iter().map(joined).collect() };
    let mut diagnostic = Diagnostic::error("unplaced-halfedge", message, star.to(half))
        .note(format!("the name of a fan touches its star: `*{word}`"));
    diagnostic.fixes.push(fix);
    diagnostic
}

/// A note for two halves of an edge that run from the same vertex to the same vertex in two loops.
fn run_alike(drawing: &Drawing, view: &View, edge: &Edge) -> Option<String> {
    let rule = drawing.rule;
    let [left, right] = edge.halfedge_names();
    let [one, other] = [left, right].map(|half| view.loop_of_item(half).map(|orbit| orbit.span));
    if view.loop_ends(left)? != view.loop_ends(right)? || one == other {
        return None;
    }
    let [left, right] = [left, right].map(|half| rule.quoted(half));
    Some(format!(
        "{left} and {right} run the same way, but twins run in opposite ways; every loop is drawn \
         counterclockwise, and perhaps the loop of one of them is drawn the other way round"
    ))
}

/// The only halfedge of a side that runs between the ends of another in reverse, in words.
fn runs_back(drawing: &Drawing, view: &View, half: NameId) -> Option<String> {
    let rule = drawing.rule;
    let [from, to] = view.loop_ends(half)?;
    let halves = rule.names_of(Kind::Halfedge);
    let mut back = halves.filter(|&of| of != half && view.loop_ends(of) == Some([to, from]));
    let (Some(twin), None) = (back.next(), back.next()) else { return None };
    let [half, twin, from, to] = [half, twin, from, to].map(|name| rule.quoted(name));
    Some(format!("{half} runs from {from} to {to}; what runs from {to} to {from} is {twin}"))
}
