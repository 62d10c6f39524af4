//! Law 7: vertices stay orbits.
//!
//! The arcs outside of the drawing keep their ends, so the orbits of `after` are the stated
//! links of `after` joined with the same arcs. For every arrangement of the arcs, every cycle
//! must carry one label, no two the same, every surviving or new vertex one, an erased vertex
//! none; and a vertex statement of `after` must be the cycle, in order.

use super::arrangement::{Arc, Arrangement, Lies, arrangements};
use super::chain::{Corner, corners, vertex_after};
use super::port::{Links, Port};
use super::problem::{Problem, enumerate};
use super::star_order::{Token, agrees};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId};
use crate::source::Span;

/// How many combinations of arrangements are looked at before the checker gives up.
const MOST: usize = 100_000;

/// Tests the law; the number of cases looked at, or what is wrong.
pub(super) fn test(drawing: &Drawing) -> Result<usize, Vec<Problem>> {
    let links = Links::of(drawing.rule, &drawing.rule.before);
    let after = Links::of(drawing.rule, &drawing.rule.after);
    let corners = corners(drawing, &links);
    let mut ways = Vec::new();
    for corner in &corners {
        let unchanged = is_unchanged(drawing, corner, &after);
        let mut found =
            arrangements(drawing, corner).ok_or_else(|| vec![too_many(drawing, corner)])?;
        if found.is_empty() {
            return Err(vec![impossible(drawing, corner)]);
        }
        if unchanged {
            // Its orbit stays what it is, however its arcs run: one way stands for all.
            found.truncate(1);
        }
        ways.push(found);
    }
    let cases = ways
        .iter()
        .try_fold(1_usize, |product, found| product.checked_mul(found.len()));
    let Some(cases) = cases.filter(|&cases| cases <= MOST) else {
        let widest = corners.iter().max_by_key(|corner| corner.chains.len());
        return Err(widest
            .map(|corner| too_many(drawing, corner))
            .into_iter()
            .collect());
    };
    let mut pick = vec![0; ways.len()];
    loop {
        let combination: Vec<_> = pick
            .iter()
            .zip(&ways)
            .map(|(&at, found)| &found[at])
            .collect();
        let case = Case::new(drawing, &after, &combination);
        let problems = case.problems();
        if !problems.is_empty() {
            return Err(problems);
        }
        // The next combination, counting up.
        let Some(digit) = (0..pick.len()).find(|&digit| pick[digit] + 1 < ways[digit].len()) else {
            return Ok(cases);
        };
        pick[digit] += 1;
        pick[..digit].fill(0);
    }
}

/// Whether every link and label at a vertex is after what it was before, and no statement of
/// `after` says anything about the order of its spokes.
fn is_unchanged(drawing: &Drawing, corner: &Corner, after: &Links) -> bool {
    let vertex = corner.vertex;
    let same_chain = |ports: &[Port], closed: bool| {
        let count = ports.len();
        let links = (0..count).all(|at| {
            let next = if at + 1 < count || closed {
                Some(ports[(at + 1) % count])
            } else {
                None
            };
            after.next(ports[at]) == next
        });
        let entry_free = closed || !after.is_reached(ports[0]);
        links
            && entry_free
            && ports
                .iter()
                .all(|&port| vertex_after(drawing, port) == Some(vertex))
    };
    let fans_stay = drawing.before.star(vertex).is_none() && drawing.after.star(vertex).is_none();
    let gains = after.ports.iter().any(|&port| {
        let drawn = corner
            .chains
            .iter()
            .any(|chain| chain.ports.contains(&port));
        !drawn && vertex_after(drawing, port) == Some(vertex)
    });
    fans_stay
        && !gains
        && corner
            .chains
            .iter()
            .all(|chain| same_chain(&chain.ports, chain.closed))
}

fn too_many(drawing: &Drawing, corner: &Corner) -> Problem {
    let text = drawing.rule.quoted(corner.vertex);
    let count = corner.chains.len();
    let message = format!("too many ways for the spokes of {text} to lie: the checker gives up");
    let span = drawing
        .before
        .mention(corner.vertex)
        .unwrap_or(drawing.rule.before.span);
    Diagnostic::error("too-many-cases", message, span)
        .saying(format!(
            "the drawing leaves {count} pieces of its star in any order"
        ))
        .note(format!(
            "a vertex statement fixes their order: `vertex {}: …`",
            drawing.rule.name(corner.vertex).text
        ))
        .into()
}

fn impossible(drawing: &Drawing, corner: &Corner) -> Problem {
    let text = drawing.rule.quoted(corner.vertex);
    if let Some(star) = drawing.before.star(corner.vertex) {
        let message = format!(
            "no mesh matches: the vertex statement of {text} contradicts the loops and edges"
        );
        return Diagnostic::error("impossible-drawing", message, star.span)
            .saying("these spokes, counterclockwise")
            .note(format!(
                "counterclockwise around {text} the spoke after `h` is `h.prev.twin`"
            ))
            .into();
    }
    let closed = corner.chains.iter().find(|chain| chain.closed);
    let spokes = closed
        .map(|chain| spokes_of(drawing, &chain.ports))
        .unwrap_or_default();
    let other = corner
        .chains
        .iter()
        .find(|chain| !chain.closed || Some(*chain) != closed);
    let item = other.map_or(corner.chains[0].entry().item(), |chain| {
        chain.entry().item()
    });
    let message = format!(
        "no mesh matches: the spokes of {text} close around {}, and leave no room for {}",
        enumerate(drawing.rule, &spokes),
        drawing.rule.quoted(item)
    );
    let span = drawing
        .before
        .mention(item)
        .unwrap_or(drawing.rule.before.span);
    Diagnostic::error("impossible-drawing", message, span).into()
}

fn spokes_of(drawing: &Drawing, ports: &[Port]) -> Vec<NameId> {
    let named = |port: &Port| match port {
        Port::Out(item) if drawing.rule.kind(*item) == Kind::Halfedge => Some(*item),
        _ => None,
    };
    ports.iter().filter_map(named).collect()
}

/// A step along a cycle of `after`.
#[derive(Clone, Copy, Debug)]
enum Step {
    Port(Port),
    Arc(Arc),
}

/// One combination of arrangements, carried over to `after`.
struct Case<'a> {
    drawing: &'a Drawing<'a>,
    /// For each path the fan its first spoke lies in, and the vertex it starts at before.
    first_spokes: Vec<(NameId, Lies)>,
    cycles: Vec<Vec<Step>>,
    /// An arc whose end the drawing of `after` has taken away.
    cut: Option<Arc>,
}

impl<'a> Case<'a> {
    fn new(drawing: &'a Drawing<'a>, after: &Links, ways: &[&Arrangement]) -> Self {
        let arcs: Vec<Arc> = ways
            .iter()
            .flat_map(|way| way.arcs.iter().copied())
            .collect();
        let first_spokes = ways
            .iter()
            .flat_map(|way| way.first_spokes.iter().copied())
            .collect();
        let drawn = |port: &Port| after.ports.contains(port);
        let keeps = |arc: &Arc| {
            drawn(&arc.from)
                && drawn(&arc.to)
                && after.next(arc.from).is_none()
                && !after.is_reached(arc.to)
        };
        let cut = arcs.iter().copied().find(|arc| !keeps(arc));
        let mut cycles = Vec::new();
        let mut seen: Vec<Port> = Vec::new();
        for &start in &after.ports {
            let mut cycle = Vec::new();
            let mut at = start;
            while !seen.contains(&at) {
                seen.push(at);
                cycle.push(Step::Port(at));
                at = match after.next(at) {
                    Some(next) => next,
                    None => match arcs.iter().find(|arc| arc.from == at) {
                        Some(&arc) => {
                            cycle.push(Step::Arc(arc));
                            arc.to
                        }
                        None => break,
                    },
                };
            }
            if !cycle.is_empty() {
                cycles.push(cycle);
            }
        }
        Self {
            drawing,
            first_spokes,
            cycles,
            cut,
        }
    }

    /// The vertex that takes what lies in a fan, or stays with `vertex`.
    fn label(&self, lies: Lies, vertex: NameId) -> Option<NameId> {
        match lies {
            Lies::Fan(fan) => Some(self.drawing.after.star_of_spoke(fan).unwrap_or(vertex)),
            Lies::Rest => Some(vertex),
            Lies::Empty => None,
        }
    }

    /// What the first spoke of a path says its vertex is, once fans have moved.
    fn first_spoke_label(&self, path: NameId) -> Option<NameId> {
        let lies = self.first_spokes.iter().find(|(name, _)| *name == path)?.1;
        self.label(lies, self.drawing.origin_before(path)?)
    }

    fn problems(&self) -> Vec<Problem> {
        if let Some(arc) = self.cut {
            return vec![self.cut_arc(arc)];
        }
        let stale = self.stale_spokes();
        if !stale.is_empty() {
            return stale;
        }
        let mut labels = Vec::new();
        for cycle in &self.cycles {
            match self.label_of(cycle) {
                Ok(label) => labels.push(label),
                Err(problem) => return vec![*problem],
            }
        }
        let mut problems = Vec::new();
        for vertex in self.drawing.rule.names_of(Kind::Vertex) {
            let of_vertex: Vec<_> = (0..labels.len())
                .filter(|&at| labels[at] == vertex)
                .collect();
            let lives = self.drawing.survives(vertex) || self.drawing.created(vertex).is_some();
            match of_vertex.as_slice() {
                [] if lives => problems.push(self.without_spokes(vertex)),
                [] => {}
                [cycle] => problems.extend(self.star_disagrees(vertex, &self.cycles[*cycle])),
                [first, second, ..] => problems.push(self.split(vertex, *first, *second)),
            }
        }
        problems
    }

    /// Spokes outside of the drawing that would still name an erased vertex.
    fn stale_spokes(&self) -> Vec<Problem> {
        let rule = self.drawing.rule;
        let mut told = Vec::new();
        let mut problems = Vec::new();
        let arcs = self.cycles.iter().flatten().filter_map(|step| match step {
            Step::Arc(arc) => Some((self.label(arc.lies, arc.vertex)?, arc.lies)),
            Step::Port(Port::Out(path)) if rule.kind(*path) == Kind::Path => {
                let lies = self.first_spokes.iter().find(|(name, _)| name == path)?.1;
                Some((self.first_spoke_label(*path)?, lies))
            }
            Step::Port(_) => None,
        });
        for (vertex, lies) in arcs {
            let Some(erased) = self.drawing.erased(vertex) else {
                continue;
            };
            if told.contains(&vertex) {
                continue;
            }
            told.push(vertex);
            let text = rule.quoted(vertex);
            let word = &rule.name(vertex).text;
            let message = format!(
                "a spoke of {text} outside of the drawing would still start at {text}, which is erased"
            );
            let drawn = self.drawing.before.star(vertex).map_or_else(
                || self.drawing.before.mention(vertex),
                |star| Some(star.span),
            );
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
            let advice = match lies {
                Lies::Fan(fan) => format!(
                    "list {} in the vertex statement of the vertex that takes its spokes",
                    rule.quoted(fan)
                ),
                _ if self.drawing.before.star(vertex).is_some() => {
                    format!(
                        "name the fan `*` in the statement of {text}, and list it in `after` where its spokes go"
                    )
                }
                _ => format!(
                    "carry its spokes off: draw `vertex {word}: {spokes} *S` in `before` (counterclockwise), and list `*S` in the vertex statement that takes them"
                ),
            };
            problems.push(diagnostic.note(advice).into());
        }
        problems
    }

    fn cut_arc(&self, arc: Arc) -> Problem {
        let rule = self.drawing.rule;
        let text = rule.quoted(arc.vertex);
        let gone = [arc.from, arc.to]
            .into_iter()
            .find(|port| self.drawing.erased(port.item()).is_some());
        let port = gone.unwrap_or(arc.from);
        let item = rule.quoted(port.item());
        let span = self
            .drawing
            .before
            .mention(port.item())
            .unwrap_or(rule.before.span);
        let message = format!(
            "what lies around {text} outside of the drawing would lose its neighbour {item}"
        );
        Diagnostic::error("dangling-outside", message, span).into()
    }

    /// The one vertex a cycle belongs to.
    fn label_of(&self, cycle: &[Step]) -> Result<NameId, Box<Problem>> {
        let mut label: Option<(NameId, Step)> = None;
        for &step in cycle {
            let says = match step {
                Step::Port(port) => [
                    vertex_after(self.drawing, port),
                    match port {
                        Port::Out(path) if self.drawing.rule.kind(path) == Kind::Path => {
                            self.first_spoke_label(path)
                        }
                        _ => None,
                    },
                ],
                Step::Arc(arc) => [self.label(arc.lies, arc.vertex), None],
            };
            for vertex in says.into_iter().flatten() {
                match label {
                    None => label = Some((vertex, step)),
                    Some((known, _)) if known == vertex => {}
                    Some((known, other)) => {
                        return Err(Box::new(self.two_labels((known, other), (vertex, step))));
                    }
                }
            }
        }
        // Ports without a stated vertex do not occur: every drawn item has ends.
        label.map(|(vertex, _)| vertex).ok_or_else(|| {
            Box::new(
                Diagnostic::error(
                    "vertex-splits",
                    "a ring of spokes would belong to no vertex",
                    self.drawing.rule.after.span,
                )
                .into(),
            )
        })
    }

    /// What a step of a cycle is, in words, and where it says so.
    fn words(&self, step: Step, vertex: NameId) -> (String, Option<Span>) {
        let rule = self.drawing.rule;
        let text = rule.quoted(vertex);
        match step {
            Step::Port(port @ Port::Out(item)) => {
                let span = self
                    .drawing
                    .after
                    .origin_mention(item)
                    .map(|mention| mention.span);
                let span = span.or_else(|| self.drawing.after.mention(item));
                let what = match rule.kind(item) {
                    Kind::Path if vertex_after(self.drawing, port) != Some(vertex) => {
                        format!(
                            "the first halfedge of {} starts at {text}",
                            rule.quoted(item)
                        )
                    }
                    _ => format!("{} starts at {text}", rule.quoted(item)),
                };
                (what, span)
            }
            Step::Port(Port::In(item)) => {
                let span = self
                    .drawing
                    .after
                    .target_mention(item)
                    .map(|mention| mention.span);
                (
                    format!("{} ends at {text}", rule.quoted(item)),
                    span.or_else(|| self.drawing.after.mention(item)),
                )
            }
            Step::Arc(arc) => match arc.lies {
                Lies::Fan(fan) => (
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

    fn two_labels(&self, first: (NameId, Step), second: (NameId, Step)) -> Problem {
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
        diagnostic
            .note("going clockwise around a vertex, from a halfedge to `twin.next`, these come into one cycle, so they start at one vertex")
            .into()
    }

    fn without_spokes(&self, vertex: NameId) -> Problem {
        let text = self.drawing.rule.quoted(vertex);
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

    fn split(&self, vertex: NameId, first: usize, second: usize) -> Problem {
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
                .any(|step| matches!(step, Step::Arc(arc) if arc.lies != Lies::Empty));
            let outside = arcs.then(|| "spokes outside of the drawing".to_string());
            super::problem::join(drawn.into_iter().chain(outside))
        };
        let message = format!("{text} would split in two");
        let span = self
            .drawing
            .after
            .mention(vertex)
            .unwrap_or(rule.after.span);
        let place = |cycle: &[Step]| {
            cycle.iter().find_map(|&step| match step {
                Step::Port(Port::Out(item)) => self
                    .drawing
                    .after
                    .origin_mention(item)
                    .map(|mention| mention.span),
                _ => None,
            })
        };
        let (one, two) = (&self.cycles[first], &self.cycles[second]);
        let mut diagnostic =
            Diagnostic::error("vertex-splits", message, place(two).unwrap_or(span))
                .saying(format!("one ring of spokes: {}", ring(two)));
        if let Some(place) = place(one) {
            diagnostic = diagnostic.label(place, format!("another: {}", ring(one)));
        } else {
            diagnostic = diagnostic.note(format!("another ring: {}", ring(one)));
        }
        diagnostic
            .note(format!("going clockwise around {text}, from a halfedge to `twin.next`, must meet all its spokes in one cycle"))
            .into()
    }

    /// Whether the vertex statement of `after` is the cycle, in order.
    fn star_disagrees(&self, vertex: NameId, cycle: &[Step]) -> Option<Problem> {
        let star = self.drawing.after.star(vertex)?;
        let rule = self.drawing.rule;
        let mut tokens = Vec::new();
        for step in cycle {
            let token = match step {
                Step::Port(Port::In(_)) => continue,
                Step::Port(Port::Out(item)) if rule.kind(*item) == Kind::Halfedge => {
                    Token::Spoke(*item)
                }
                Step::Port(Port::Out(path)) => {
                    match self
                        .first_spokes
                        .iter()
                        .find(|(name, _)| name == path)
                        .map(|(_, lies)| *lies)
                    {
                        Some(Lies::Fan(fan)) => Token::Fan(fan),
                        Some(Lies::Empty) => continue,
                        Some(Lies::Rest) | None => Token::Rest,
                    }
                }
                Step::Arc(arc) => match arc.lies {
                    Lies::Fan(fan) => Token::Fan(fan),
                    Lies::Rest => Token::Rest,
                    Lies::Empty => continue,
                },
            };
            if tokens.last() != Some(&token) {
                tokens.push(token);
            }
        }
        while tokens.len() > 1 && tokens.first() == tokens.last() {
            tokens.pop();
        }
        tokens.reverse(); // statements read counterclockwise
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
        let span = if self
            .drawing
            .after
            .side()
            .kept
            .iter()
            .any(|kept| kept.name == vertex)
        {
            self.drawing.after.mention(vertex).unwrap_or(star.span)
        } else {
            star.span
        };
        Some(
            Diagnostic::error("star-order", message, span)
                .saying(format!(
                    "counterclockwise, the loops and edges of `after` give: {ring}"
                ))
                .fix(format!("write `{statement}`"), span, statement)
                .into(),
        )
    }
}
