//! Law 7: vertices stay orbits.
//!
//! The arcs outside the drawing keep their ends, so the orbits of `after` are the stated links of
//! `after` joined with the same arcs. For every arrangement of the arcs, every cycle must carry one
//! label, no two cycles the same, every surviving or new vertex must have one, an erased vertex
//! none; and a vertex statement of `after` must be the cycle, in order.

use super::arrangement::{Arrangement, agreeing, arrangements};
use super::broken::Broken;
use super::case::{Case, Step};
use super::chain::{Chain, Corner, corners, vertex_after};
use super::port::{Links, Port};
use super::problem::{Problem, enumerate};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId, Spoke, Star};

/// The greatest number of combinations of arrangements before the checker gives up.
const MOST: usize = 100_000;

/// The greatest number of cases that are kept to be shown.
pub(super) const MOST_SHOWN: usize = 12;

/// The rings that the proof of the law has examined.
#[derive(Clone, Debug)]
pub(super) struct Rings {
    /// The chains of each vertex before, with the number of ways that its arcs can run, or
    /// `None` if one stands for all because nothing changes.
    pub corners: Vec<(Corner, Option<usize>)>,
    /// The number of cases.
    pub cases: usize,
    /// The first of them.
    pub shown: Vec<RingCase>,
}

/// The rings of spokes after, in one case, clockwise.
#[derive(Clone, Debug)]
pub(super) struct RingCase {
    /// The rings, each with its vertex.
    pub rings: Vec<(Option<NameId>, Vec<Step>)>,
}

/// Tests the law: the rings examined, or what is wrong.
pub(super) fn test(drawing: &Drawing) -> Result<Rings, Broken> {
    let links = Links::of(drawing.rule, &drawing.rule.before);
    let after = Links::of(drawing.rule, &drawing.rule.after);
    let corners = corners(drawing, &links);
    let mut ways = Vec::new();
    let mut counted = Vec::new();
    for corner in &corners {
        let settled = settled(drawing, corner, &after);
        let unchanged = settled.len() == corner.chains.len() && !gains(drawing, corner, &after);
        let found = arrangements(drawing, corner, &settled)
            .ok_or_else(|| vec![too_many(drawing, corner)])?;
        if found.is_empty() {
            return Err(vec![impossible(drawing, corner)].into());
        }
        counted.push((corner.clone(), (!unchanged).then_some(found.len())));
        ways.push(found);
    }
    let ways: Vec<&[Arrangement]> = ways.iter().map(Vec::as_slice).collect();
    let Some((_, combinations)) = combinations(&ways, MOST) else {
        let widest = corners.iter().max_by_key(|corner| corner.chains.len());
        let widest = widest.map(|corner| too_many(drawing, corner));
        return Err(widest.into_iter().collect::<Vec<_>>().into());
    };
    let mut rings = Rings { corners: counted, cases: 0, shown: Vec::new() };
    for picked in combinations {
        let Some(combination) = agreeing(drawing.rule, picked.into_iter()) else { continue };
        let case = Case::new(drawing, &after, &combination);
        let problems = case.problems();
        if !problems.is_empty() {
            let arcs = combination.iter().flat_map(|way| way.arcs.iter().copied());
            return Err(Broken { problems, arcs: Some(arcs.collect()), outcome: None });
        }
        rings.cases += 1;
        if rings.shown.len() < MOST_SHOWN {
            rings.shown.push(RingCase {
                rings: case.labels().into_iter().zip(case.cycles.clone()).collect(),
            });
        }
    }
    let stated = |corner: &&Corner| drawing.before.star(corner.vertex).is_some();
    match corners.iter().find(stated) {
        // Only vertex statements can contradict each other.
        Some(corner) if rings.cases == 0 => Err(vec![impossible(drawing, corner)].into()),
        _ => Ok(rings),
    }
}

/// The number of combinations of one of each of these ways, and the combinations; `None` if there
/// are more than `most`.
pub(super) fn combinations<'w>(
    ways: &'w [&'w [Arrangement]],
    most: usize,
) -> Option<(usize, impl Iterator<Item = Vec<&'w Arrangement>>)> {
    let count = ways.iter().try_fold(1_usize, |count, found| count.checked_mul(found.len()));
    let count = count.filter(|&count| count <= most)?;
    let combination = move |mut number: usize| {
        let pick = |found: &&'w [Arrangement]| {
            let way = &found[number % found.len()];
            number /= found.len();
            way
        };
        ways.iter().map(pick).collect()
    };
    Some((count, (0..count).map(combination)))
}

/// The chains of a vertex that pass through the rewrite unchanged: each of their links and labels
/// is the same before and after, and no statement says anything about the order of its spokes.
pub(super) fn settled(drawing: &Drawing, corner: &Corner, after: &Links) -> Vec<usize> {
    if [&drawing.before, &drawing.after].iter().any(|view| view.star(corner.vertex).is_some()) {
        return Vec::new();
    }
    let is_settled = |chain: &Chain| {
        let links = (0..chain.ports.len()).all(|at| {
            let next = match chain.ports.get(at + 1) {
                Some(&next) => Some(next),
                None => chain.closed.then_some(chain.entry()),
            };
            after.next(chain.ports[at]) == next
        });
        let stays = |&port: &Port| vertex_after(drawing, port) == Some(corner.vertex);
        let entry_free = chain.closed || !after.is_reached(chain.entry());
        links && entry_free && chain.ports.iter().all(stays)
    };
    let chains = corner.chains.iter().enumerate();
    chains.filter_map(|(at, chain)| is_settled(chain).then_some(at)).collect()
}

/// True if `after` draws something at a vertex that was not drawn there before.
pub(super) fn gains(drawing: &Drawing, corner: &Corner, after: &Links) -> bool {
    let drawn = |port: &Port| corner.chains.iter().any(|chain| chain.ports.contains(port));
    let at_vertex = |&port: &Port| vertex_after(drawing, port) == Some(corner.vertex);
    after.ports.iter().any(|port| !drawn(port) && at_vertex(port))
}

pub(super) fn too_many(drawing: &Drawing, corner: &Corner) -> Problem {
    let text = drawing.rule.quoted(corner.vertex);
    let count = corner.chains.len();
    let message = format!("too many ways for the spokes of {text} to lie: the checker gives up");
    let span = drawing.before.mention(corner.vertex).unwrap_or(drawing.rule.before.span);
    Diagnostic::error("too-many-cases", message, span)
        .saying(format!("the drawing leaves {count} pieces of its star in any order"))
        .note(format!(
            "a vertex statement fixes their order: `vertex {}: …`",
            drawing.rule.name(corner.vertex).text
        ))
        .into()
}

pub(super) fn impossible(drawing: &Drawing, corner: &Corner) -> Problem {
    let text = drawing.rule.quoted(corner.vertex);
    if let Some(star) = drawing.before.star(corner.vertex) {
        let diagnostic = out_of_order(drawing, star).unwrap_or_else(|| {
            let message = format!(
                "no mesh matches: the vertex statement of {text} contradicts the loops and edges"
            );
            // A letter that is not a name of the rule.
            let is_free = |letter: &&str| drawing.rule.free_name(letter) == *letter;
            let spoke = ["h", "s", "x", "y", "z"].into_iter().find(is_free).unwrap_or("h");
            let error = Diagnostic::error("impossible-drawing", message, star.span)
                .saying("these spokes, counterclockwise")
                .note(format!(
                    "counterclockwise around {text} the spoke after `{spoke}` is \
                     `{spoke}.prev.twin`"
                ));
            let is_whole = star.spokes.iter().all(|spoke| spoke.halfedge().is_some());
            error.when(is_whole, |error| error.note("spokes that are not drawn are a fan, `*`"))
        });
        let diagnostic = diagnostic.with(in_order(drawing, corner, star), |told, statement| {
            told.fix(format!("write `{statement}`"), star.span, statement)
        });
        return diagnostic.into();
    }
    let closed = corner.chains.iter().find(|chain| chain.closed);
    let spokes = closed.map(|chain| spokes_of(drawing, &chain.ports)).unwrap_or_default();
    let other = corner.chains.iter().find(|chain| !chain.closed || Some(*chain) != closed);
    let item = other.map_or(corner.chains[0].entry().item(), |chain| chain.entry().item());
    let message = format!(
        "no mesh matches: the spokes of {text} close around {}, and leave no room for {}",
        enumerate(drawing.rule, &spokes),
        drawing.rule.quoted(item)
    );
    let span = drawing.before.mention(item).unwrap_or(drawing.rule.before.span);
    Diagnostic::error("impossible-drawing", message, span).into()
}

/// The error about a listed spoke that the loops and edges put after another one than the statement
/// does.
fn out_of_order(drawing: &Drawing, star: &Star) -> Option<Diagnostic> {
    let Drawing { rule, before, .. } = drawing;
    if star.each {
        return None;
    }
    let is_half = |item: &NameId| rule.kind(*item) == Kind::Halfedge;
    star.neighbors().find_map(|[spoke, next]| {
        let behind = before.spoke_behind(spoke.name).filter(|&behind| behind != next.name);
        let ahead = || before.spoke_ahead(next.name).filter(is_half);
        let (first, second) = match behind {
            Some(behind) => (spoke.name, behind),
            None => (ahead().filter(|&ahead| ahead != spoke.name)?, next.name),
        };
        let word = &rule.name(first).text;
        let message = format!(
            "no mesh matches: counterclockwise around {} the spoke after `{word}` is {}",
            rule.quoted(star.vertex.name),
            rule.quoted(second)
        );
        let error = Diagnostic::error("impossible-drawing", message, next.span)
            .saying(format!("listed after {}", rule.quoted(spoke.name)));
        Some(error.note(format!("{} is `{word}.prev.twin`", rule.quoted(second))))
    })
}

/// The statement with its spokes in the order that the loops and edges give, if they are one chain
/// of listed halfedges and the statement has at most one fan.
fn in_order(drawing: &Drawing, corner: &Corner, star: &Star) -> Option<String> {
    let [chain] = corner.chains.as_slice() else { return None };
    let rule = drawing.rule;
    let mut fans = star.spokes.iter().filter_map(|spoke| match spoke {
        Spoke::Fan(fan) => Some(format!("*{}", rule.name(fan.name).text)),
        Spoke::Rest(_) => Some("*".to_owned()),
        Spoke::Halfedge(_) => None,
    });
    let (fan, None) = (fans.next(), fans.next()) else { return None };
    if rule.cycle.is_some() || chain.closed != fan.is_none() {
        return None;
    }
    // Ports run clockwise, statements counterclockwise.
    let drawn: Vec<_> = chain.ports.iter().rev().filter_map(|port| port.leaving()).collect();
    let is_listed = |half: &NameId| star.spokes.iter().any(|spoke| spoke.halfedge() == Some(*half));
    if !drawn.iter().all(is_listed) {
        return None;
    }
    let words: Vec<_> = drawn.iter().map(|&half| rule.name(half).text.clone()).chain(fan).collect();
    let vertex = &rule.name(corner.vertex).text;
    Some(format!("vertex {vertex}: {}", words.join(" ")))
}

/// The halfedges that leave by some ports.
pub(super) fn spokes_of(drawing: &Drawing, ports: &[Port]) -> Vec<NameId> {
    let is_halfedge = |item: &NameId| drawing.rule.kind(*item) == Kind::Halfedge;
    ports.iter().filter_map(|port| port.leaving()).filter(is_halfedge).collect()
}
