//! The argument of a proof in words, law by law.
//!
//! A port is written `In(x)` where `x` arrives, and `x` where it leaves; `>` leads clockwise from
//! one port to the next. What lies outside the drawing is in parentheses.

use super::arrangement::{Arc, ArcContent};
use super::case::Step;
use super::chain::Chain;
use super::port::Port;
use super::vertices_are_orbits::{RingCase, Rings};
use crate::diagram::{Drawing, Edge, Kind, Loop, NameId, Ref, Rule, Side};

/// The argument for one law.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Argument {
    pub law: &'static str,
    /// The reasons why it holds, one per line.
    pub lines: Vec<String>,
}

/// The argument for a rule that is proved.
pub(super) fn argument(rule: &Rule, rings: &Rings) -> Vec<Argument> {
    let drawing = Drawing::new(rule);
    let words = Words { rule };
    let laws = [
        law("every name is accounted for", words.names(&drawing)),
        law("next is a permutation", words.loops(&rule.after)),
        law("twin is a pairing", words.twins(&drawing)),
        law("nothing outside dangles", words.erased(&drawing)),
        law("ends agree", words.ends(&drawing)),
        law("vertices are orbits", words.rings(rings)),
        law("what is new is placed", words.placed()),
    ];
    let told = |argument: &Argument| !argument.lines.is_empty();
    laws.into_iter().filter(told).collect()
}

fn law(law: &'static str, lines: Vec<String>) -> Argument {
    Argument { law, lines }
}

struct Words<'a> {
    rule: &'a Rule,
}

impl Words<'_> {
    fn word(&self, name: NameId) -> &str {
        &self.rule.name(name).text
    }

    fn list(&self, names: impl Iterator<Item = NameId>) -> String {
        names.map(|name| self.word(name)).collect::<Vec<_>>().join(" ")
    }

    fn names(&self, drawing: &Drawing) -> Vec<String> {
        let named = |name: &NameId| self.rule.name(*name).named;
        let all = || self.rule.ids().filter(|&name| self.rule.is_first(name));
        let stay = all().filter(|&name| drawing.survives(name)).filter(named);
        let first = |name: &NameId| self.rule.is_first(*name);
        let refs = |refs: &[Ref]| {
            let names = refs.iter().map(|mention| mention.name);
            self.list(names.filter(first))
        };
        let lines = [
            ("drawn before and after:", self.list(stay)),
            ("new:", refs(&self.rule.created)),
            ("erased:", refs(&self.rule.erased)),
        ];
        let told = lines.into_iter().filter(|(_, names)| !names.is_empty());
        told.map(|(what, names)| format!("{what} {names}")).collect()
    }

    fn loops(&self, side: &Side) -> Vec<String> {
        let line = |orbit: &Loop| {
            let items = orbit.items.iter().map(|item| self.word(item.item.name));
            let period = match orbit.each {
                true => orbit.items.len() / self.rule.size().unwrap_or(1) as usize,
                false => orbit.items.len(),
            };
            let mut items: Vec<_> = items.take(period).collect();
            if orbit.each {
                items.push("and so on, around");
            }
            format!("{}: {}", self.word(orbit.face.name), items.join(" > "))
        };
        let loops = side.loops.iter().filter(|orbit| self.rule.is_first(orbit.face.name));
        let mut lines: Vec<_> = loops.map(line).collect();
        if !lines.is_empty() {
            lines.push("each item stands once".into());
        }
        lines
    }

    fn twins(&self, drawing: &Drawing) -> Vec<String> {
        let line = |edge: &Edge| {
            let [left, right] = edge.halfedges.map(|half| self.word(half.name));
            format!("{}: {left} | {right}", self.word(edge.edge.name))
        };
        let edges = self.rule.after.edges.iter().filter(|edge| self.rule.is_first(edge.edge.name));
        let mut lines: Vec<_> = edges.map(line).collect();
        let alone = self.rule.names_of(Kind::Halfedge).filter(|&half| {
            self.rule.is_first(half)
                && drawing.survives(half)
                && drawing.before.pairing(half).is_none()
                && drawing.after.pairing(half).is_none()
        });
        let alone = self.list(alone);
        if !alone.is_empty() {
            lines.push(format!("twins outside stay: {alone}"));
        }
        lines
    }

    fn erased(&self, drawing: &Drawing) -> Vec<String> {
        let halves = self.rule.erased.iter().map(|erased| erased.name);
        let halves = halves.filter(|&name| self.rule.kind(name) == Kind::Halfedge);
        let halves: Vec<_> = halves.collect();
        if halves.is_empty() {
            return vec!["no halfedge is erased".into()];
        }
        debug_assert!(halves.iter().all(|&half| drawing.before.pairing(half).is_some()));
        let halves = halves.into_iter().filter(|&half| self.rule.is_first(half));
        let list = self.list(halves);
        vec![format!("the loop and the twin of each erased halfedge are drawn: {list}")]
    }

    fn ends(&self, drawing: &Drawing) -> Vec<String> {
        let ends = |half: NameId| {
            let [from, to] = [drawing.origin_after(half)?, drawing.target_after(half)?];
            let [half, from, to] = [half, from, to].map(|name| self.word(name));
            Some(format!("{half} from {from} to {to}"))
        };
        let line = |edge: &Edge| {
            let [left, right] = edge.halfedges.map(|half| ends(half.name));
            Some(format!("{}: {}, {}", self.word(edge.edge.name), left?, right?))
        };
        let edges = self.rule.after.edges.iter().filter(|edge| self.rule.is_first(edge.edge.name));
        edges.filter_map(line).collect()
    }

    fn placed(&self) -> Vec<String> {
        let created = self.rule.created.iter().map(|created| created.name);
        let vertices = created.filter(|&name| self.rule.kind(name) == Kind::Vertex);
        let vertices = vertices.filter(|&name| self.rule.is_first(name));
        let line = |vertex| format!("{}.position is set", self.word(vertex));
        vertices.map(line).collect()
    }

    fn rings(&self, rings: &Rings) -> Vec<String> {
        let mut lines = vec![
            "`h` is where a halfedge leaves the vertex, `In(h)` where it arrives, `>` leads clockwise"
                .into(),
            "an arc is a run of spokes that are not drawn".into(),
            "before:".into(),
        ];
        for (corner, ways) in &rings.corners {
            let vertex = self.word(corner.vertex);
            let chains = corner.chains.iter();
            let chains = self.one_turn(chains.map(|chain| self.chain(chain)).collect());
            let closed = corner.chains.iter().any(|chain| chain.closed);
            let arcs = match (closed, corner.chains.len()) {
                (true, _) => "closed".into(),
                (false, 1) => "then one arc outside".into(),
                (false, count) => format!("with {count} arcs outside"),
            };
            let ways = match ways {
                None => ", which stays as it is".into(),
                Some(1) => String::new(),
                Some(ways) => format!(", in {ways} ways"),
            };
            lines.push(format!("  {vertex}: {}, {arcs}{ways}", chains.join(" and ")));
        }
        for (at, case) in rings.shown.iter().enumerate() {
            lines.push(match rings.cases {
                1 => "after:".into(),
                cases => format!("after, case {} of {cases}:", at + 1),
            });
            lines.extend(self.case(case));
        }
        if rings.cases > rings.shown.len() {
            let more = rings.cases - rings.shown.len();
            lines.push(format!("and so in {more} more cases"));
        }
        lines
    }

    fn case(&self, case: &RingCase) -> Vec<String> {
        let ring = |(label, steps): &(Option<NameId>, Vec<Step>)| {
            let steps = steps.iter().filter_map(|&step| match step {
                Step::Port(port) => Some(self.port(port)),
                Step::Arc(arc) => self.arc(arc),
            });
            let steps = self.one_turn(steps.collect());
            let label = label.map_or("nothing", |label| self.word(label));
            format!("  {label}: {}", steps.join(" > "))
        };
        case.rings.iter().map(ring).collect()
    }

    fn chain(&self, chain: &Chain) -> String {
        let ports = chain.ports.iter().map(|&port| self.port(port));
        self.one_turn(ports.collect()).join(" > ")
    }

    /// The first part of a list that repeats for every index.
    fn one_turn(&self, mut parts: Vec<String>) -> Vec<String> {
        let size = self.rule.size().unwrap_or(1) as usize;
        if size > 1 && parts.len() >= size && parts.len().is_multiple_of(size) {
            parts.truncate((parts.len() / size).max(2));
            parts.push("and so on, around".into());
        }
        parts
    }

    fn port(&self, port: Port) -> String {
        match port {
            Port::Out(item) => self.word(item).into(),
            Port::In(item) => format!("In({})", self.word(item)),
        }
    }

    /// The spokes of an arc in words; `None` if it is known to hold no spoke.
    fn arc(&self, arc: Arc) -> Option<String> {
        match arc.content {
            ArcContent::Empty | ArcContent::Spoke(_) => None,
            ArcContent::Fan(fan) => Some(format!("(*{})", self.word(fan))),
            ArcContent::Rest => Some(format!("(outside, at {})", self.word(arc.vertex))),
        }
    }
}
