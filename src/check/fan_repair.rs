//! Spokes of erased vertices: the vertex statements of the vertices that take them.
//!
//! The rings of spokes after follow from the loops and edges alone. So if an erased vertex has
//! spokes left, the ring that they join, and the one other vertex that it belongs to, can be read
//! off.

use super::arrangement::{ArcContent, agreeing, arrangements};
use super::case::{Case, Step};
use super::chain::{Chain, Corner, corners, vertex_after};
use super::port::{Links, Port};
use super::star_order::Token;
use super::vertices_are_orbits::settled;
use super::{ends_agree, next_is_permutation, twin_is_involution};
use crate::diagram::{Drawing, Kind, Name, NameId, Ref, Role, Rule, Spoke, Star};

/// Statements that move the spokes of an erased vertex to another vertex.
pub(super) struct Taken {
    /// The vertex that takes them, and its ring after.
    pub after: Star,
    /// The statement of the erased vertex that names its other spokes, if it has none.
    pub before: Option<Star>,
    /// The fan that this statement introduces: the next name of the rule.
    pub fan: Option<Name>,
}

impl Taken {
    /// Finds the vertex that takes the spokes of an erased one; `None` if that is not certain.
    pub fn of(rule: &Rule, erased: NameId) -> Option<Self> {
        let drawing = Drawing::new(rule);
        if rule.cycle.is_some() || !is_in_order(&drawing) {
            return None;
        }
        let corners = corners(&drawing, &Links::of(rule, &rule.before));
        let after = Links::of(rule, &rule.after);
        let ways = corners.iter().map(|corner| {
            let settled = settled(&drawing, corner, &after);
            let mut found = arrangements(&drawing, corner, &settled)?.into_iter();
            // Where there is a choice, nothing is certain.
            found.next().filter(|_| found.next().is_none())
        });
        let ways = ways.collect::<Option<Vec<_>>>()?;
        let combination = agreeing(rule, ways.iter())?;
        let case = Case::new(&drawing, &after, &combination);
        let (cycle, taker) = ring_that_takes(&case, erased)?;

        let span = rule.after.span;
        let is_stated = drawing.before.star(erased).is_some();
        let fan = NameId(rule.names.len() as u32);
        let before = match is_stated {
            true => None,
            false => {
                let corner = corners.iter().find(|corner| corner.vertex == erased)?;
                Some(statement(rule, corner, fan)?)
            }
        };
        let ring = case.ring(cycle, |arc| match arc.content {
            ArcContent::Rest if arc.vertex == erased && !is_stated => Some(Token::Fan(fan)),
            // A fan without a name cannot be moved.
            ArcContent::Rest if arc.vertex == erased => None,
            _ => case.arc_token(arc),
        });
        let spokes = ring.into_iter().map(|token| match token {
            Token::Spoke(name) => Spoke::Halfedge(Ref::plain(name, span)),
            Token::Fan(name) => Spoke::Fan(Ref::plain(name, span)),
            Token::Rest => Spoke::Rest(span),
        });
        Some(Self {
            after: Star {
                vertex: Ref::plain(taker, span),
                spokes: spokes.collect(),
                each: false,
                span,
            },
            fan: before.is_some().then(|| new_fan(rule)),
            before,
        })
    }
}

/// True if loops, edges and ends are consistent, so that rings can be followed.
fn is_in_order(drawing: &Drawing) -> bool {
    next_is_permutation::test(drawing).is_empty()
        && twin_is_involution::test(drawing).is_empty()
        && ends_agree::test(drawing).is_empty()
}

/// The only ring with a piece that still belongs to the erased vertex, and the only other vertex
/// that the ring belongs to.
fn ring_that_takes<'c>(case: &'c Case, erased: NameId) -> Option<(&'c [Step], NameId)> {
    let labels = |cycle: &[Step]| -> Vec<NameId> {
        let label = |step: &Step| match *step {
            Step::Port(port) => vertex_after(case.drawing, port),
            Step::Arc(arc) => case.label(arc.content, arc.vertex),
        };
        cycle.iter().filter_map(label).collect()
    };
    let cycles = case.cycles.iter().map(Vec::as_slice);
    let mut left = cycles.filter(|cycle| labels(cycle).contains(&erased));
    let (cycle, None) = (left.next()?, left.next()) else { return None };
    let mut others = labels(cycle);
    others.retain(|&label| case.drawing.erased(label).is_none());
    others.dedup();
    match others.as_slice() {
        &[taker] => Some((cycle, taker)),
        _ => None,
    }
}

/// `vertex v1: d h' *S b`: the drawn spokes of a vertex, and a fan for all others.
fn statement(rule: &Rule, corner: &Corner, fan: NameId) -> Option<Star> {
    let [Chain { ports, closed: false }] = corner.chains.as_slice() else { return None };
    let span = rule.before.span;
    let mut spokes = Vec::new();
    // Ports run clockwise, statements counterclockwise.
    for port in ports.iter().rev() {
        match port {
            Port::Out(item) if rule.kind(*item) != Kind::Halfedge => return None,
            Port::Out(item) => spokes.push(Spoke::Halfedge(Ref::plain(*item, span))),
            Port::In(_) => {}
        }
    }
    spokes.push(Spoke::Fan(Ref::plain(fan, span)));
    Some(Star { vertex: Ref::plain(corner.vertex, span), spokes, each: false, span })
}

/// Names for fans that the rule does not have.
pub(super) fn fan_names(rule: &Rule) -> impl Iterator<Item = String> {
    let numbered = (1..).map(|number| format!("S{number}"));
    let words = std::iter::once("S".to_owned()).chain(numbered);
    words.filter(|word| rule.names.iter().all(|name| name.text != *word))
}

/// A fan with a name that the rule does not have.
fn new_fan(rule: &Rule) -> Name {
    Name {
        text: fan_names(rule).next().unwrap_or_default(),
        kind: Kind::Fan,
        named: true,
        role: Role::Single,
        span: rule.before.span,
    }
}
