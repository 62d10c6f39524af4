//! Law 7 for rules with families, for cycles of every size.
//!
//! The ports of `after` form a graph over the cycle: a link leads from a port at one index to a
//! port at another, so it carries an offset (the voltage of a voltage graph). Along a ring of
//! spokes of the rule, unrolled far enough, the offsets add up:
//!
//! * net 0: the ring closes at the index where it began. There is one such ring per index, so all
//!   of it must belong to one member of a family.
//! * net 1 or -1: the ring runs through every index. There is one, whatever the size, and it must
//!   belong to a single vertex.
//! * any other net offset: the ring falls apart into several, depending on the size.
//!
//! That each ring carries one label, and each vertex has one ring, is then tested on the large
//! cycle; since links, arcs and labels are given by offsets alone, it holds on every cycle.
//!
//! Outside the drawing, each vertex has its own way for its arcs to run, and so has each member of
//! a family. The cases that are checked take the same way at every index. They stand for all others
//! as long as no ring depends on the ways of two members of one family: a ring that meets only one
//! index is the same whatever the others do, and the drawing alone says which ports belong to which
//! vertex.
//!
//! A single vertex with spokes of families, but without a statement that gives their order, has too
//! many ways to check. There the rewrite may only lead each chain from its own entry to its own
//! exit: then the order does not matter.

use std::borrow::Cow;

use super::arrangement::{Arc, ArcContent, Arrangement, agreeing, arrangements};
use super::broken::Broken;
use super::case::{Case, Step};
use super::chain::{Chain, Corner, corners, vertex_after};
use super::port::{Links, Port};
use super::problem::Problem;
use super::vertices_are_orbits::{
    MOST_SHOWN, RingCase, Rings, combinations, gains, impossible, settled, too_many,
};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, NameId, Rule};

/// The greatest number of combinations of ways that are examined.
const MOST: usize = 1_000;

/// The ways of the arcs at one vertex, or at each member of a family.
struct Ways {
    corner: Corner,
    found: Vec<Arrangement>,
    unchanged: bool,
    /// True if the order of the chains is not known, and must not matter.
    loose: bool,
}

/// Tests the law on a rule that is unrolled far enough.
pub(super) fn test(drawing: &Drawing) -> Result<Rings, Broken> {
    let rule = drawing.rule;
    let links = Links::of(rule, &rule.before);
    let after = Links::of(rule, &rule.after);
    let mut all = Vec::new();
    for corner in corners(drawing, &links) {
        if rule.is_first(corner.vertex) {
            all.push(ways(drawing, corner, &after)?);
        }
    }
    let found: Vec<&[Arrangement]> = all.iter().map(|ways| ways.found.as_slice()).collect();
    let Some((cases, combinations)) = combinations(&found, MOST) else {
        let widest = all.iter().max_by_key(|ways| ways.found.len());
        let told = widest.map(|ways| too_many(drawing, &ways.corner));
        return Err(told.into_iter().collect::<Vec<_>>().into());
    };
    let mut shown = Vec::new();
    for picked in combinations {
        let picked = all.iter().zip(picked);
        let uniform = picked.flat_map(|(ways, way)| everywhere(rule, ways.corner.vertex, way));
        let uniform: Vec<_> = uniform.collect();
        let Some(uniform) = agreeing_everywhere(rule, &uniform, &all) else { continue };
        let case = Case::new(drawing, &after, &uniform);
        let problems = case.problems();
        if !problems.is_empty() {
            let arcs = uniform.iter().flat_map(|way| way.arcs.iter().copied());
            return Err(Broken { problems, arcs: Some(arcs.collect()), outcome: None });
        }
        let walk = RingWalk {
            drawing,
            after: &after,
            arcs: uniform.iter().flat_map(|way| way.arcs.iter().copied()).collect(),
            ways: &all,
        };
        let problems = walk.problems();
        if !problems.is_empty() {
            return Err(problems.into());
        }
        if shown.len() < MOST_SHOWN {
            shown.push(RingCase { rings: at_index_0(rule, &case) });
        }
    }
    let counted =
        all.into_iter().map(|ways| (ways.corner, (!ways.unchanged).then_some(ways.found.len())));
    Ok(Rings { corners: counted.collect(), cases, shown })
}

/// The ring at index 0 of each family, and the rings of single vertices.
fn at_index_0(rule: &Rule, case: &Case) -> Vec<(Option<NameId>, Vec<Step>)> {
    let rings = case.labels().into_iter().zip(case.cycles.clone());
    let first = |label: Option<NameId>| label.is_none_or(|vertex| rule.is_first(vertex));
    rings.filter(|(label, _)| first(*label)).collect()
}

/// The ways of one vertex.
fn ways(drawing: &Drawing, corner: Corner, after: &Links) -> Result<Ways, Broken> {
    let rule = drawing.rule;
    let still = settled(drawing, &corner, after);
    let unchanged = still.len() == corner.chains.len() && !gains(drawing, &corner, after);
    let has_members = corner
        .chains
        .iter()
        .any(|chain| chain.ports.iter().any(|port| rule.is_member(port.item())));
    let open = corner.chains.iter().all(|chain| !chain.closed);
    let loose = !rule.is_member(corner.vertex)
        && has_members
        && open
        && corner.chains.len() > 1
        && drawing.before.star(corner.vertex).is_none();
    if loose {
        return Ok(Ways { found: vec![in_any_order(&corner)], corner, unchanged, loose });
    }
    let Some(found) = arrangements(drawing, &corner, &still) else {
        return Err(vec![too_many(drawing, &corner)].into());
    };
    if found.is_empty() {
        return Err(vec![impossible(drawing, &corner)].into());
    }
    // Every index has a choice of its own, so uniform choices do not cover all cases.
    if found.len() > 1 && has_members && !rule.is_member(corner.vertex) {
        let text = rule.quoted(corner.vertex);
        let message = format!("the pieces of the star of {text} can lie in several ways");
        let span = drawing.before.mention(corner.vertex);
        let problem = Diagnostic::error("not-uniform", message, span.unwrap_or(rule.before.span))
            .note("list a spoke of each of them in its vertex statement");
        return Err(vec![problem.into()].into());
    }
    Ok(Ways { corner, found, unchanged, loose })
}

/// An arrangement of chains whose order is unknown.
fn in_any_order(corner: &Corner) -> Arrangement {
    let count = corner.chains.len();
    let arc = |at: usize| Arc {
        from: corner.chains[at].exit(),
        to: corner.chains[(at + 1) % count].entry(),
        vertex: corner.vertex,
        content: ArcContent::Rest,
    };
    let firsts = |chain: &Chain| {
        let paths = chain.ports.iter().filter_map(|port| port.leaving());
        paths.map(|path| (path, ArcContent::Rest)).collect::<Vec<_>>()
    };
    Arrangement {
        arcs: (0..count).map(arc).collect(),
        first_spokes: corner.chains.iter().flat_map(firsts).collect(),
        empty_paths: Vec::new(),
        stands_for_others: true,
    }
}

/// A uniform case, unless the ways contradict each other. Where members of a family have a choice,
/// a case that contradicts itself can stand for one that does not: then it is checked all the same.
fn agreeing_everywhere<'a>(
    rule: &Rule,
    uniform: &'a [Arrangement],
    all: &[Ways],
) -> Option<Vec<Cow<'a, Arrangement>>> {
    let mut chosen = all.iter().filter(|ways| ways.found.len() > 1);
    let has_choice = chosen.any(|ways| rule.is_member(ways.corner.vertex));
    let as_it_is = || uniform.iter().map(Cow::Borrowed).collect();
    agreeing(rule, uniform.iter()).or_else(|| has_choice.then(as_it_is))
}

/// The same way at every member of the family.
fn everywhere(rule: &Rule, vertex: NameId, way: &Arrangement) -> Vec<Arrangement> {
    let turns = if rule.is_member(vertex) { rule.size().unwrap_or(1) } else { 1 };
    let turns = (0..i64::from(turns)).map(|by| {
        let name = |name: NameId| rule.turned(name, by);
        let port = |port: Port| match port {
            Port::Out(item) => Port::Out(name(item)),
            Port::In(item) => Port::In(name(item)),
        };
        let content = |content: ArcContent| match content {
            ArcContent::Fan(fan) => ArcContent::Fan(name(fan)),
            ArcContent::Spoke(half) => ArcContent::Spoke(name(half)),
            content => content,
        };
        let arcs = way.arcs.iter().map(|arc| Arc {
            from: port(arc.from),
            to: port(arc.to),
            vertex: name(arc.vertex),
            content: content(arc.content),
        });
        let firsts = way.first_spokes.iter();
        Arrangement {
            arcs: arcs.collect(),
            first_spokes: firsts.map(|&(path, at)| (name(path), content(at))).collect(),
            empty_paths: way.empty_paths.iter().map(|&path| name(path)).collect(),
            stands_for_others: way.stands_for_others,
        }
    });
    turns.collect()
}

/// A place on a ring: a port at an index that is not reduced modulo the size.
#[derive(Clone, Copy)]
struct Spot {
    /// The port at index 0.
    port: Port,
    at: i64,
}

/// The rings of one case, with their offsets.
struct RingWalk<'a> {
    drawing: &'a Drawing<'a>,
    after: &'a Links,
    arcs: Vec<Arc>,
    ways: &'a [Ways],
}

/// The record of a walk around one ring.
#[derive(Default)]
struct Met {
    /// The vertices that ports belong to, each with its index.
    labels: Vec<(NameId, i64)>,
    /// The members of families whose way it depends on.
    ways: Vec<(NameId, i64)>,
    /// The number of times it passed pieces of unknown order.
    loose: usize,
}

impl RingWalk<'_> {
    fn rule(&self) -> &Rule {
        self.drawing.rule
    }

    fn problems(&self) -> Vec<Problem> {
        let rule = self.rule();
        let mut seen: Vec<Port> = Vec::new();
        let mut problems = Vec::new();
        for &start in &self.after.ports {
            if !rule.is_first(start.item()) || seen.contains(&start) {
                continue;
            }
            let mut met = Met::default();
            let mut spot = Spot { port: start, at: 0 };
            let net = loop {
                seen.push(spot.port);
                self.note(spot, &mut met);
                let Some(next) = self.step(spot, &mut met) else { break None };
                spot = next;
                if spot.port == start {
                    break Some(spot.at);
                }
                if seen.contains(&spot.port) {
                    break None;
                }
            };
            problems.extend(self.judge(start, net, &met));
        }
        problems
    }

    /// The next place, one link or arc further.
    fn step(&self, spot: Spot, met: &mut Met) -> Option<Spot> {
        let rule = self.rule();
        let to = match self.after.next(spot.port) {
            Some(next) => next,
            None => {
                let arc = self.arcs.iter().find(|arc| arc.from == spot.port)?;
                let vertex = arc.vertex;
                match self.ways_of(vertex) {
                    Some(ways) if ways.loose => {
                        met.loose += 1;
                        let leaves = |chain: &&Chain| chain.exit() == spot.port;
                        ways.corner.chains.iter().find(leaves)?.entry()
                    }
                    Some(ways) => {
                        self.depend(ways, vertex, spot.at, met);
                        arc.to
                    }
                    None => arc.to,
                }
            }
        };
        let by = rule.offset(to.item());
        let first = rule.first_member(to.item());
        let port = match to {
            Port::Out(_) => Port::Out(first),
            Port::In(_) => Port::In(first),
        };
        Some(Spot { port, at: spot.at + by })
    }

    fn ways_of(&self, vertex: NameId) -> Option<&Ways> {
        let first = self.rule().first_member(vertex);
        self.ways.iter().find(|ways| ways.corner.vertex == first)
    }

    /// Notes that the ring depends on the way of a vertex, if it has several.
    fn depend(&self, ways: &Ways, vertex: NameId, at: i64, met: &mut Met) {
        let rule = self.rule();
        let member = (rule.first_member(vertex), at + rule.offset(vertex));
        if ways.found.len() > 1 && rule.is_member(vertex) && !met.ways.contains(&member) {
            met.ways.push(member);
        }
    }

    /// Notes the vertex of a port, and the way that it depends on.
    fn note(&self, spot: Spot, met: &mut Met) {
        let rule = self.rule();
        if let Some(vertex) = vertex_after(self.drawing, spot.port) {
            met.labels.push((rule.first_member(vertex), spot.at + rule.offset(vertex)));
        }
        // The fan of the first spoke of a path depends on the way of its vertex.
        if let Port::Out(item) = spot.port
            && rule.kind(item) == crate::diagram::Kind::Path
            && let Some(vertex) = self.drawing.origin_before(item)
            && let Some(ways) = self.ways_of(vertex)
        {
            self.depend(ways, vertex, spot.at, met);
        }
    }

    /// The problem of a ring.
    fn judge(&self, start: Port, net: Option<i64>, met: &Met) -> Option<Problem> {
        let rule = self.rule();
        let member = rule.is_member(start.item());
        let Some(net) = net else {
            return Some(self.not_uniform(start, "a ring of spokes does not close".into()));
        };
        let first = met.labels.first();
        let one = |label: &(NameId, i64)| {
            let Some(first) = first else { return false };
            label.0 == first.0 && (label.1 == first.1 || !rule.is_member(label.0))
        };
        let of_member = first.is_some_and(|(label, _)| rule.is_member(*label));
        if met.loose > 0 {
            let alone = met.loose == 1 && net == 0 && met.labels.iter().all(one) && !of_member;
            return (!alone).then(|| {
                self.not_uniform(
                    start,
                    "nothing says in which order these spokes lie, and here it matters".into(),
                )
            });
        }
        let mut indices = met.ways.clone();
        indices.sort_unstable();
        if indices.windows(2).any(|pair| pair[0].0 == pair[1].0) {
            let text = "a ring of spokes depends on how several members of a family lie";
            return Some(self.not_uniform(start, text.into()));
        }
        let right = match (member, net) {
            (false, 0) => !of_member,
            (true, 0) => of_member && met.labels.iter().all(one),
            (true, 1 | -1) => !of_member && met.labels.iter().all(one),
            _ => false,
        };
        (!right).then(|| {
            let text = match net {
                -1..=1 => "a ring of spokes belongs to different vertices on cycles of different sizes".into(),
                net => format!(
                    "a ring of spokes comes back {} indices further: on a cycle of {} it is several",
                    net.abs(),
                    net.abs()
                ),
            };
            self.not_uniform(start, text)
        })
    }

    fn not_uniform(&self, start: Port, text: String) -> Problem {
        let rule = self.rule();
        let item = start.item();
        let span = self.drawing.after.mention(item);
        Diagnostic::error("not-uniform", text, span.unwrap_or(rule.after.span))
            .saying(format!("the ring through {}", rule.quoted(item)))
            .note("an op with families is proved for cycles of every size at once")
            .into()
    }
}
