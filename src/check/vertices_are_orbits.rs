//! Law 7: vertices stay orbits.
//!
//! The arcs outside of the drawing keep their ends, so the orbits of `after` are the stated
//! links of `after` joined with the same arcs. For every arrangement of the arcs, every cycle
//! must carry one label, no two the same, every surviving or new vertex one, an erased vertex
//! none; and a vertex statement of `after` must be the cycle, in order.

use super::arrangement::arrangements;
use super::case::{Case, Step};
use super::chain::{Corner, corners, vertex_after};
use super::port::{Links, Port};
use super::problem::{Problem, enumerate};
use super::proved::Broken;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId};

/// How many combinations of arrangements are looked at before the checker gives up.
const MOST: usize = 100_000;

/// How many cases are kept to be shown.
pub(super) const MOST_SHOWN: usize = 12;

/// What the proof of the law has looked at.
#[derive(Clone, Debug)]
pub(super) struct Rings {
    /// The chains of each vertex before, with the number of ways that its arcs can run, or
    /// `None` if one stands for all because nothing changes.
    pub corners: Vec<(Corner, Option<usize>)>,
    /// How many cases there are.
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

/// Tests the law; what was looked at, or what is wrong.
pub(super) fn test(drawing: &Drawing) -> Result<Rings, Broken> {
    let links = Links::of(drawing.rule, &drawing.rule.before);
    let after = Links::of(drawing.rule, &drawing.rule.after);
    let corners = corners(drawing, &links);
    let mut ways = Vec::new();
    let mut counted = Vec::new();
    for corner in &corners {
        let unchanged = is_unchanged(drawing, corner, &after);
        let mut found =
            arrangements(drawing, corner).ok_or_else(|| vec![too_many(drawing, corner)])?;
        if found.is_empty() {
            return Err(vec![impossible(drawing, corner)].into());
        }
        if unchanged {
            // Its orbit stays what it is, however its arcs run: one way stands for all.
            found.truncate(1);
        }
        counted.push((corner.clone(), (!unchanged).then_some(found.len())));
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
            .collect::<Vec<_>>()
            .into());
    };
    let mut shown = Vec::new();
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
            let arcs = combination.iter().flat_map(|way| way.arcs.iter().copied());
            return Err(Broken {
                problems,
                arcs: Some(arcs.collect()),
            });
        }
        if shown.len() < MOST_SHOWN {
            shown.push(RingCase {
                rings: case.labels().into_iter().zip(case.cycles.clone()).collect(),
            });
        }
        // The next combination, counting up.
        let Some(digit) = (0..pick.len()).find(|&digit| pick[digit] + 1 < ways[digit].len()) else {
            return Ok(Rings {
                corners: counted,
                cases,
                shown,
            });
        };
        pick[digit] += 1;
        pick[..digit].fill(0);
    }
}

/// Whether every link and label at a vertex is after what it was before, and no statement of
/// `after` says anything about the order of its spokes.
pub(super) fn is_unchanged(drawing: &Drawing, corner: &Corner, after: &Links) -> bool {
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

pub(super) fn too_many(drawing: &Drawing, corner: &Corner) -> Problem {
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

pub(super) fn impossible(drawing: &Drawing, corner: &Corner) -> Problem {
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
