//! Laws 1 and 2: every name, and every pointer of every name, is accounted for.
//!
//! Law 1: each name of `before` is drawn in `after` or erased, never both; each name of
//! `after` is drawn in `before` or new. Law 2: a halfedge whose loop (so `next`, `vertex`
//! and `face`) or edge (so `twin` and `edge`) is stated in `before` has it stated again in
//! `after`, or is erased; a new halfedge has both.
//!
//! The two are told together, one diagnostic for each orbit that is missing: a person
//! forgets a statement, not a pointer.

use super::problem::{Problem, Remedy, enumerate, is_or_are, join};
use super::stale::Stale;
use super::unknown_names::Unknown;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId};
use crate::source::Span;

/// Tests the laws.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let unknown = Unknown::find(drawing);
    let mut problems: Vec<Problem> = Vec::new();
    problems.extend(unknown.problems);
    let mut law = Law {
        drawing,
        explained: unknown.meant,
        problems,
    };
    law.erased_and_drawn();
    law.loops();
    law.edges();
    law.other_names();
    law.new_halfedges();
    law.problems
}

/// The keyword `after`, to point at a place where something is missing.
pub(super) fn after_keyword(drawing: &Drawing) -> Span {
    let span = drawing.rule.after.span;
    Span {
        end: (span.start + "after".len() as u32).min(span.end),
        ..span
    }
}

struct Law<'a> {
    drawing: &'a Drawing<'a>,
    /// Names about which enough has been said.
    explained: Vec<NameId>,
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
            let Some(erased) = self.drawing.erased(name).filter(|_| run) else {
                continue;
            };
            let text = self.drawing.rule.quoted(name);
            let kind = self.drawing.rule.kind(name).word();
            let message = format!("the {kind} {text} cannot be erased: nobody knows what is in it");
            let problem = Diagnostic::error("erased-run", message, erased)
                .note("only what is drawn one by one can be erased");
            self.problems.push(problem.into());
            self.explained.push(name);
        }
    }

    fn names(&self) -> impl Iterator<Item = NameId> + use<> {
        (0..self.drawing.rule.names.len() as u32).map(NameId)
    }

    fn is_open(&self, name: NameId) -> bool {
        self.drawing.survives(name) && !self.explained.contains(&name)
    }

    /// Halfedges and paths that stand in a loop before, and in none after.
    fn loops(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        for orbit in &rule.before.loops {
            let missing: Vec<_> = orbit
                .items
                .iter()
                .map(|item| item.item)
                .filter(|item| self.is_open(item.name))
                .filter(|item| drawing.after.loop_of_item(item.name).is_none())
                .collect();
            if missing.is_empty() {
                continue;
            }
            let names: Vec<_> = missing.iter().map(|item| item.name).collect();
            let face = orbit.face.name;
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
            let mut diagnostic =
                Diagnostic::error("missing-reassignment", message, missing[0].span)
                    .saying(format!("drawn in the loop of {} here", rule.quoted(face)));
            for item in &missing[1..] {
                diagnostic = diagnostic.label(item.span, "");
            }
            diagnostic = match drawing.erased(face) {
                Some(span) => {
                    diagnostic.label(span, format!("{} is erased here", rule.quoted(face)))
                }
                None => {
                    diagnostic.label(after_keyword(drawing), format!("no loop here holds {list}"))
                }
            };
            let stale = Stale::of_loop(drawing, &names);
            diagnostic = diagnostic.note(stale.sentence());
            let mut remedies = vec![Remedy::Erase(names.clone()), Remedy::Keep(face)];
            if drawing.after.mention(face).is_none() && drawing.erased(face).is_none() {
                remedies.push(Remedy::Erase(names.iter().copied().chain([face]).collect()));
                self.explained.push(face);
            }
            self.explained.extend(
                names
                    .iter()
                    .filter(|&&name| drawing.after.pairing(name).is_none()),
            );
            self.problems.push(Problem {
                diagnostic,
                remedies,
            });
        }
    }

    /// Halfedges that are paired before, and not after.
    fn edges(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        for edge in &rule.before.edges {
            let missing: Vec<_> = edge
                .halfedges
                .iter()
                .copied()
                .filter(|half| self.is_open(half.name))
                .filter(|half| drawing.after.pairing(half.name).is_none())
                .collect();
            if missing.is_empty() {
                continue;
            }
            let names: Vec<_> = missing.iter().map(|half| half.name).collect();
            let twins = join(
                names
                    .iter()
                    .map(|&name| format!("`{}.twin`", rule.name(name).text)),
            );
            let message = format!("{twins} {} not reassigned", is_or_are(names.len()));
            let list = enumerate(rule, &names);
            let drawn = missing.iter().map(|half| half.span).reduce(Span::to);
            let drawn = drawn.unwrap_or(edge.span);
            let diagnostic = Diagnostic::error("missing-reassignment", message, drawn)
                .saying(format!(
                    "the edge {} is drawn here",
                    rule.quoted(edge.edge.name)
                ))
                .label(
                    after_keyword(drawing),
                    format!("no edge statement here names {list}"),
                )
                .note(Stale::of_edge(drawing, &names).sentence());
            let mut remedies = self.pairings(&names, edge.edge.name);
            remedies.push(Remedy::Erase(names.clone()));
            self.explained
                .extend(names.iter().filter(|&&name| drawing.is_outer(name)));
            if drawing.after.mention(edge.edge.name).is_none() {
                self.explained.push(edge.edge.name);
            }
            // The other half of the edge that is missing is told with it.
            for remedy in &remedies {
                if let Remedy::Pair { halfedges, .. } = remedy {
                    self.explained
                        .extend(halfedges.iter().filter(|half| !names.contains(half)));
                }
            }
            self.problems.push(Problem {
                diagnostic,
                remedies,
            });
        }
    }

    /// The statements that would pair what is left over: the edge as it was, or, where just
    /// two halfedges are left over, the two under each edge name that is free.
    fn pairings(&self, names: &[NameId], edge: NameId) -> Vec<Remedy> {
        let drawing = self.drawing;
        let free =
            |edge: NameId| drawing.after.mention(edge).is_none() && drawing.erased(edge).is_none();
        let mut remedies = Vec::new();
        if names.len() == 2 && free(edge) {
            remedies.push(Remedy::Keep(edge));
        }
        let left: Vec<_> = drawing
            .rule
            .names_of(Kind::Halfedge)
            .filter(|&half| drawing.after.pairing(half).is_none() && drawing.erased(half).is_none())
            .filter(|&half| {
                drawing.created(half).is_some() || drawing.before.pairing(half).is_some()
            })
            .collect();
        if let [left, right] = left[..] {
            let kept = |other: NameId| other == edge && !remedies.is_empty();
            let edges = drawing.rule.names_of(Kind::Edge);
            let pairs = edges
                .filter(|&edge| free(edge) && !kept(edge))
                .map(|edge| Remedy::Pair {
                    edge,
                    halfedges: [left, right],
                });
            let pairs: Vec<_> = pairs.collect();
            remedies.extend(pairs);
        }
        remedies
    }

    /// Vertices, edges, faces and fans that are drawn before, and nowhere after.
    fn other_names(&mut self) {
        let drawing = self.drawing;
        let rule = drawing.rule;
        for name in self.names() {
            if !self.is_open(name) || drawing.after.mention(name).is_some() {
                continue;
            }
            let kind = rule.kind(name);
            if kind == Kind::Halfedge && drawing.before.loop_of_item(name).is_some() {
                continue; // told by its loop
            }
            let span = drawing
                .before
                .mention(name)
                .expect("a surviving name is drawn before");
            let text = rule.quoted(name);
            let message = match kind {
                Kind::Fan => format!("the fan {text} is drawn before, and lies nowhere after"),
                _ => format!("{text} is drawn before, but neither drawn after nor erased"),
            };
            let diagnostic = Diagnostic::error("unaccounted-name", message, span)
                .saying(format!("{} that `after` forgets", kind.a_word()))
                .label(
                    after_keyword(drawing),
                    format!("{text} stands nowhere here"),
                );
            let diagnostic = match kind {
                Kind::Fan => diagnostic
                    .note("list it in the vertex statement of the vertex that takes its spokes"),
                Kind::Vertex | Kind::Edge | Kind::Face => diagnostic.note(format!(
                    "draw {text} in `after`, or write `keep {0}` or `erase {0}`",
                    rule.name(name).text
                )),
                Kind::Halfedge | Kind::Path => diagnostic,
            };
            let remedies = match kind {
                Kind::Vertex | Kind::Edge | Kind::Face => {
                    vec![Remedy::Keep(name), Remedy::Erase(vec![name])]
                }
                Kind::Halfedge | Kind::Path | Kind::Fan => Vec::new(),
            };
            self.problems.push(Problem {
                diagnostic,
                remedies,
            });
        }
    }

    /// New halfedges without a loop or an edge, and other new names that stand nowhere.
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
            if drawing.after.loop_of_item(name).is_none() {
                let pointers = format!("`{word}.next`, `{word}.vertex` and `{word}.face`");
                self.problems
                    .push(lacks("loop of `after`", pointers).into());
            }
            if drawing.after.pairing(name).is_none() && !self.explained.contains(&name) {
                let diagnostic = lacks(
                    "edge of `after`",
                    format!("`{word}.twin` and `{word}.edge`"),
                );
                let remedies = self.pairings(&[], name);
                for remedy in &remedies {
                    if let Remedy::Pair { halfedges, .. } = remedy {
                        self.explained.extend(halfedges);
                    }
                }
                self.problems.push(Problem {
                    diagnostic,
                    remedies,
                });
            }
        }
    }
}
