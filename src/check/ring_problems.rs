//! Problems of the rings of spokes of a case, in words.

use super::arrangement::{Arc, ArcContent};
use super::case::{Case, Step};
use super::chain::vertex_after;
use super::fan_repair::fan_names;
use super::joint::moved_alone;
use super::port::Port;
use super::problem::{Problem, Repair, enumerate};
use super::repairs::missing_edge;
use super::star_order::{Token, agrees};
use crate::diagnostic::{Diagnostic, all_of};
use crate::diagram::{Drawing, Kind, NameId, Spoke};
use crate::source::Span;

impl Case<'_> {
    /// Spokes outside the drawing that would still name an erased vertex.
    pub(super) fn stale_spokes(&self) -> Vec<Problem> {
        let rule = self.drawing.rule;
        let mut told = Vec::new();
        let mut problems = Vec::new();
        let mut fans = fan_names(rule);
        let arcs = self.cycles.iter().flatten().filter_map(|step| match step {
            Step::Arc(arc) => Some((self.label(arc.content, arc.vertex)?, arc.content)),
            Step::Port(Port::Out(path)) if rule.kind(*path) == Kind::Path => {
                let content = self.first_spokes.iter().find(|(name, _)| name == path)?.1;
                Some((self.first_spoke_label(*path)?, content))
            }
            Step::Port(_) => None,
        });
        for (vertex, content) in arcs {
            let Some(erased) = self.drawing.erased(vertex) else { continue };
            if told.contains(&vertex) {
                continue;
            }
            told.push(vertex);
            let text = rule.quoted(vertex);
            let word = &rule.name(vertex).text;
            let message = format!(
                "a spoke of {text} outside of the drawing would still start at {text}, which is erased"
            );
            let drawn = self
                .drawing
                .before
                .star(vertex)
                .map_or_else(|| self.drawing.before.mention(vertex), |star| Some(star.span));
            let mut diagnostic =
                Diagnostic::error("stale-vertex", message, erased).saying("erased here");
            if let Some(drawn) = drawn {
                diagnostic =
                    diagnostic.label(drawn, format!("{text} may have more spokes than are drawn"));
            }
            let spokes = rule
                .names_of(Kind::Halfedge)
                .filter(|&half| self.drawing.origin_before(half) == Some(vertex))
                .map(|half| rule.name(half).text.clone())
                .collect::<Vec<_>>()
                .join(" ");
            let advice = match content {
                ArcContent::Fan(fan) => format!(
                    "list {} in the vertex statement of the vertex that takes its spokes",
                    rule.quoted(fan)
                ),
                _ if self.drawing.before.star(vertex).is_some() => {
                    format!(
                        "name the fan `*` in the statement of {text}, and list it in `after` where its spokes go"
                    )
                }
                _ => {
                    let fan = fans.next().unwrap_or_default();
                    format!(
                        "carry its spokes off: draw `vertex {word}: {spokes} *{fan}` in `before` (counterclockwise), and list `*{fan}` in the vertex statement that takes them"
                    )
                }
            };
            problems.push(Problem {
                diagnostic: diagnostic.note(advice),
                repairs: vec![Repair::Take(vertex)],
            });
        }
        problems
    }

    /// A drawn halfedge that still starts at an erased vertex.
    pub(super) fn spoke_of_erased(&self, vertex: NameId, cycle: &[Step]) -> Problem {
        let rule = self.drawing.rule;
        let text = rule.quoted(vertex);
        let starts = |step: &Step| match step {
            Step::Port(Port::Out(item)) => Some(*item),
            Step::Port(Port::In(_)) | Step::Arc(_) => None,
        };
        let item = cycle.iter().find_map(starts);
        let spoke = item.map_or_else(|| "a spoke".to_owned(), |item| rule.quoted(item));
        let drawn = item.and_then(|item| self.drawing.after.mention(item));
        let message = format!("{spoke} would still start at {text}, which is erased");
        let mut diagnostic =
            Diagnostic::error("stale-vertex", message, drawn.unwrap_or(rule.after.span));
        if let Some(erased) = self.drawing.erased(vertex) {
            diagnostic = diagnostic.label(erased, format!("{text} is erased here"));
        }
        Problem {
            diagnostic: diagnostic.note(format!(
                "list {spoke} in the vertex statement of the vertex where it starts now"
            )),
            repairs: vec![Repair::Take(vertex)],
        }
    }

    /// An arc that loses an end.
    pub(super) fn cut_arc(&self, arc: Arc) -> Problem {
        let rule = self.drawing.rule;
        let text = rule.quoted(arc.vertex);
        let gone =
            [arc.from, arc.to].into_iter().find(|port| self.drawing.erased(port.item()).is_some());
        let port = gone.unwrap_or(arc.from);
        let item = rule.quoted(port.item());
        let span = self.drawing.before.mention(port.item()).unwrap_or(rule.before.span);
        let message = format!(
            "what lies around {text} outside of the drawing would lose its neighbor {item}"
        );
        Diagnostic::error("dangling-outside", message, span).into()
    }

    /// The words for a step of a cycle, and its place in the source.
    fn words(&self, step: Step, vertex: NameId) -> (String, Option<Span>) {
        let rule = self.drawing.rule;
        let text = rule.quoted(vertex);
        match step {
            Step::Port(port @ Port::Out(item)) => {
                let span = self.drawing.after.origin_mention(item).map(|mention| mention.span);
                let span = span.or_else(|| self.star_mention(item));
                let span = span.or_else(|| self.drawing.after.mention(item));
                let what = match rule.kind(item) {
                    Kind::Path if vertex_after(self.drawing, port) != Some(vertex) => {
                        format!("the first halfedge of {} starts at {text}", rule.quoted(item))
                    }
                    _ => format!("{} starts at {text}", rule.quoted(item)),
                };
                (what, span)
            }
            Step::Port(Port::In(item)) => {
                let span = self.drawing.after.target_mention(item).map(|mention| mention.span);
                let twin = || self.drawing.after.twin(item);
                let span = span.or_else(|| self.star_mention(twin()?));
                (
                    format!("{} ends at {text}", rule.quoted(item)),
                    span.or_else(|| self.drawing.after.mention(item)),
                )
            }
            Step::Arc(arc) => match arc.content {
                ArcContent::Fan(fan) => (
                    format!("the fan {} starts at {text}", rule.quoted(fan)),
                    self.drawing.after.mention(fan),
                ),
                _ => (
                    format!("the spokes of {text} outside of the drawing still start at {text}"),
                    self.drawing.before.mention(arc.vertex),
                ),
            },
        }
    }

    /// The place where the vertex statements of `after` say that a halfedge starts.
    fn star_mention(&self, half: NameId) -> Option<Span> {
        let star = self.drawing.after.star_of_spoke(half)?;
        let star = self.drawing.after.star(star)?;
        star.spokes.iter().find_map(|spoke| match spoke {
            Spoke::Halfedge(spoke) if spoke.name == half => Some(spoke.span),
            _ => None,
        })
    }

    /// One ring that carries two names.
    pub(super) fn two_labels(&self, first: (NameId, Step), second: (NameId, Step)) -> Problem {
        let rule = self.drawing.rule;
        let (one, one_span) = self.words(first.1, first.0);
        let (two, two_span) = self.words(second.1, second.0);
        let message = format!(
            "one ring of spokes would belong to both {} and {}",
            rule.quoted(first.0),
            rule.quoted(second.0)
        );
        let span = two_span.or(one_span).unwrap_or(rule.after.span);
        let mut diagnostic = Diagnostic::error("two-vertices-one-ring", message, span).saying(two);
        match one_span.filter(|&one_span| one_span != span) {
            Some(one_span) => diagnostic = diagnostic.label(one_span, one),
            None => diagnostic = diagnostic.note(one),
        }
        let reason = reversed_path(self.drawing).or_else(|| ran_elsewhere(self.drawing));
        diagnostic.notes.extend(reason);
        let erased = [first.0, second.0].into_iter();
        let erased = erased.filter(|&vertex| self.drawing.erased(vertex).is_some());
        Problem {
            diagnostic: diagnostic.note("going clockwise around a vertex, from a halfedge to `twin.next`, these come into one ring, so they start at one vertex"),
            repairs: erased.map(Repair::Take).collect(),
        }
    }

    /// A vertex without a ring.
    pub(super) fn without_spokes(&self, vertex: NameId) -> Problem {
        let text = self.drawing.rule.quoted(vertex);
        if let Some(star) = self.drawing.before.star(vertex)
            && !star.spokes.iter().any(|s| matches!(s, Spoke::Halfedge(_)))
        {
            let message = format!("the statement of {text} names no spoke");
            return Diagnostic::error("vertex-without-spokes", message, star.span)
                .note(format!(
                    "a fan runs from a spoke that stands in a loop, `loop f: {0} -h-> w => {0}` and \
                     `vertex {0}: h *S`, to the next; if no spoke changes, the loop alone is enough, \
                     and `keep f` in `after`",
                    self.drawing.rule.name(vertex).text
                ))
                .into();
        }
        let created = self.drawing.created(vertex);
        let message = format!("no spoke would start at {text}");
        let span = created
            .or_else(|| self.drawing.after.mention(vertex))
            .unwrap_or(self.drawing.rule.after.span);
        let diagnostic = Diagnostic::error("vertex-without-spokes", message, span);
        match created {
            Some(_) => diagnostic.note("draw it in the loops of `after`").into(),
            None => diagnostic
                .note(format!(
                    "all its spokes go elsewhere: `erase {}`",
                    self.drawing.rule.name(vertex).text
                ))
                .into(),
        }
    }

    /// Two rings that carry one name.
    pub(super) fn split(&self, vertex: NameId, first: usize, second: usize) -> Problem {
        let rule = self.drawing.rule;
        let text = rule.quoted(vertex);
        let ring = |cycle: &[Step]| {
            let drawn: Vec<_> = cycle
                .iter()
                .filter_map(|step| match step {
                    Step::Port(Port::Out(item)) => Some(rule.quoted(*item)),
                    _ => None,
                })
                .collect();
            let arcs = cycle
                .iter()
                .any(|step| matches!(step, Step::Arc(arc) if arc.content != ArcContent::Empty));
            let outside = arcs.then(|| "spokes outside of the drawing".to_string());
            all_of(drawn.into_iter().chain(outside))
        };
        let message = format!("{text} would split in two");
        let span = self.drawing.after.mention(vertex).unwrap_or(rule.after.span);
        let place = |cycle: &[Step]| {
            cycle.iter().find_map(|&step| match step {
                Step::Port(Port::Out(item)) => {
                    self.drawing.after.origin_mention(item).map(|mention| mention.span)
                }
                _ => None,
            })
        };
        let (one, two) = (&self.cycles[first], &self.cycles[second]);
        let mut diagnostic =
            Diagnostic::error("vertex-splits", message, place(two).unwrap_or(span))
                .saying(format!("a ring of spokes: {}", ring(two)));
        if let Some(place) = place(one) {
            diagnostic = diagnostic.label(place, format!("a ring of spokes: {}", ring(one)));
        } else {
            diagnostic = diagnostic.note(format!("another ring of spokes: {}", ring(one)));
        }
        diagnostic
            .note(format!("going clockwise around {text}, from a halfedge to `twin.next`, must meet all its spokes in one ring"))
            .into()
    }

    /// A cycle as a vertex statement lists it: counterclockwise, what has no name last.
    pub(super) fn ring(
        &self,
        cycle: &[Step],
        arc_token: impl Fn(Arc) -> Option<Token>,
    ) -> Vec<Token> {
        let rule = self.drawing.rule;
        let mut tokens = Vec::new();
        for step in cycle {
            let token = match step {
                Step::Port(Port::In(_)) => continue,
                Step::Port(Port::Out(item)) if rule.kind(*item) == Kind::Halfedge => {
                    Some(Token::Spoke(*item))
                }
                Step::Port(Port::Out(path)) => {
                    let mut spokes = self.first_spokes.iter();
                    match spokes.find(|(name, _)| name == path).map(|found| found.1) {
                        Some(ArcContent::Fan(fan)) => Some(Token::Fan(fan)),
                        // Another token stands for it.
                        Some(ArcContent::Empty | ArcContent::Spoke(_)) => None,
                        Some(ArcContent::Rest) | None => Some(Token::Rest),
                    }
                }
                Step::Arc(arc) => arc_token(*arc),
            };
            if let Some(token) = token.filter(|token| tokens.last() != Some(token)) {
                tokens.push(token);
            }
        }
        while tokens.len() > 1 && tokens.first() == tokens.last() {
            tokens.pop();
        }
        tokens.reverse(); // statements read counterclockwise
        if let Some(rest) = tokens.iter().rposition(|token| *token == Token::Rest) {
            tokens.rotate_left(rest + 1);
        }
        tokens
    }

    /// The token that a statement lists for an arc.
    pub(super) fn arc_token(&self, arc: Arc) -> Option<Token> {
        match arc.content {
            ArcContent::Fan(fan) => Some(Token::Fan(fan)),
            ArcContent::Rest => Some(Token::Rest),
            ArcContent::Empty | ArcContent::Spoke(_) => None,
        }
    }

    /// The problem of a vertex statement of `after` that is not the cycle, in order.
    pub(super) fn star_disagrees(&self, vertex: NameId, cycle: &[Step]) -> Option<Problem> {
        let star = self.drawing.after.star(vertex)?;
        let rule = self.drawing.rule;
        let tokens = self.ring(cycle, |arc| self.arc_token(arc));
        if agrees(&star.spokes, &tokens) {
            return None;
        }
        let ring = tokens.iter().map(|token| match token {
            Token::Spoke(name) => rule.name(*name).text.clone(),
            Token::Fan(name) => format!("*{}", rule.name(*name).text),
            Token::Rest => "*".into(),
        });
        let ring = ring.collect::<Vec<_>>().join(" ");
        let text = rule.quoted(vertex);
        let statement = format!("vertex {}: {ring}", rule.name(vertex).text);
        let message = format!("the vertex statement of {text} is not its ring of spokes");
        let span = if self.drawing.after.side().kept.iter().any(|kept| kept.name == vertex) {
            self.drawing.after.mention(vertex).unwrap_or(star.span)
        } else {
            star.span
        };
        Some(
            Diagnostic::error("star-order", message, span)
                .saying(format!("counterclockwise, the loops and edges of `after` give: {ring}"))
                .fix(format!("write `{statement}`"), span, statement)
                .into(),
        )
    }
}

/// A path that `after` draws from its end to its start, in words.
fn reversed_path(drawing: &Drawing) -> Option<String> {
    let rule = drawing.rule;
    let mut reversed = rule.names_of(Kind::Path).filter_map(|path| {
        let [before, after] = [&drawing.before, &drawing.after].map(|view| view.loop_ends(path));
        let [from, to] = before?;
        (from != to && after? == [to, from]).then_some((path, from, to))
    });
    let (path, from, to) = reversed.next()?;
    let [path, from, to] = [path, from, to].map(|name| rule.name(name).text.as_str());
    Some(format!(
        "`{path}` leads from `{from}` to `{to}`, and no operation turns its halfedges around: write \
         `{from} ={path}=> {to}`"
    ))
}

/// Halfedges that change their ends while their twins outside stay where they are, in words.
fn ran_elsewhere(drawing: &Drawing) -> Option<String> {
    let rule = drawing.rule;
    let moved = moved_alone(drawing);
    let &half = moved.first()?;
    let text = rule.quoted(half);
    let ends = [&drawing.before, &drawing.after].map(|view| {
        let [from, to] = view.loop_ends(half)?.map(|end| rule.quoted(end));
        Some(format!("from {from} to {to}"))
    });
    let [Some(before), Some(after)] = ends else { return None };
    let mut told = format!(
        "{text} ran {before}, and runs {after}; its twin, which is not drawn, stays where it was"
    );
    if let [_, others @ ..] = moved.as_slice()
        && !others.is_empty()
    {
        told.push_str(&format!("; likewise {}", enumerate(rule, others)));
    }
    let edge = missing_edge(drawing, half);
    told.push_str(&format!(
        "; to move it, draw `{edge}` in `before`, and pair both anew in `after`"
    ));
    Some(told)
}
