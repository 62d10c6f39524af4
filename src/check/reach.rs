//! Finds the order in which a rule is matched, or the names that no pointer reaches.
//!
//! In an unrolled rule, the members of a family are bound together: a step for the member at index
//! 0 stands for every index.

use super::chain::{Corner, corners};
use super::matching::{Bound, Claim, Source, Step, Way};
use super::pointer::{Pointer, pointers};
use super::port::{Links, Port};
use super::problem::{Problem, enumerate};
use super::start::{example, undrawn};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId, Op, Spoke};

/// The steps that bind every name of `before`, and test the rest of what it claims.
///
/// `same` lists pairs of names that only a test keeps apart.
pub(super) fn matching(
    op: &Op,
    drawing: &Drawing,
    same: &[[NameId; 2]],
) -> Result<Vec<Step>, Vec<Problem>> {
    let links = Links::of(drawing.rule, &drawing.rule.before);
    let corners = corners(drawing, &links);
    let mut reach = Reach {
        drawing,
        corners: &corners,
        pointers: pointers(drawing),
        bound: vec![false; drawing.rule.names.len()],
        begun: Vec::new(),
        same: same.to_vec(),
        steps: Vec::new(),
    };
    reach.parameters(op)?;
    reach.everything_is_bound(op)?;
    reach.paths();
    reach.claims();
    Ok(reach.steps)
}

/// The names that are bound, and the steps so far.
pub(super) struct Reach<'a> {
    pub drawing: &'a Drawing<'a>,
    pub corners: &'a [Corner],
    pub pointers: Vec<Pointer>,
    pub steps: Vec<Step>,
    /// Pairs of names that only a test keeps apart.
    pub same: Vec<[NameId; 2]>,
    /// Families of halfedges of which the member at index 0 is known.
    pub begun: Vec<NameId>,
    /// For each name, whether it is bound; for a family, at its first member.
    bound: Vec<bool>,
}

impl Reach<'_> {
    /// True if a name, or the family that it is a member of, is bound.
    pub fn is_bound(&self, name: NameId) -> bool {
        self.bound[self.drawing.rule.first_member(name).index()]
    }

    /// Marks a name, or the family that it is a member of, as bound.
    pub fn now_bound(&mut self, name: NameId) {
        let first = self.drawing.rule.first_member(name);
        self.bound[first.index()] = true;
        if self.begun.contains(&first) {
            self.steps.push(Step::Test(Claim::Begins(first)));
        }
    }

    /// Binds a name, or all members of its family.
    fn bind(&mut self, name: NameId, source: Source) {
        let rule = self.drawing.rule;
        let source = source.turned(rule, -i64::from(rule.index(name)));
        self.steps.push(Step::Bind { name: Bound::Element(rule.first_member(name)), source });
        self.now_bound(name);
    }

    /// Binds a halfedge that a parameter gives, or that an attempt begins with.
    fn begin(&mut self, halfedge: NameId) {
        match self.drawing.rule.is_member(halfedge) {
            true => self.begun.push(halfedge),
            false => self.bound[halfedge.index()] = true,
        }
    }

    /// Binds the parameters, halfedges first, each followed by all that it reaches.
    fn parameters(&mut self, op: &Op) -> Result<(), Vec<Problem>> {
        let rule = self.drawing.rule;
        let mut others = Vec::new();
        for (parameter, name) in rule.params.iter().enumerate() {
            let Some(name) = *name else { continue };
            self.steps.push(Step::Parameter { parameter, name });
            self.begin(name);
            if rule.kind(name) != Kind::Halfedge {
                others.push((parameter, name));
            }
        }
        self.follow();
        for (parameter, name) in others {
            if let Some(claim) = self.known_element(name) {
                self.steps.push(Step::Test(claim));
            } else if let Some(halfedge) = self.anchor(name) {
                self.steps.push(Step::Attempt { element: name, halfedge, tries: self.tries(name) });
                self.begin(halfedge);
                self.follow();
            } else if let Some(path) = self.whole_path(name) {
                let tries = self.is_alike_around().then_some(1);
                self.steps.push(Step::Attempt { element: name, halfedge: path, tries });
            } else {
                let text = rule.quoted(name);
                let kind = rule.kind(name);
                let message = format!("`before` draws no halfedge of the parameter {text}");
                let example = example(&rule.name(name).text, op.params[parameter].ty);
                let span = op.params[parameter].span;
                return Err(vec![
                    Diagnostic::error("unreachable-name", message, span)
                        .saying(format!("{} that nothing is drawn at", kind.a_word()))
                        .note(format!("a statement binds it: `{example}`"))
                        .into(),
                ]);
            }
        }
        Ok(())
    }

    /// Binds all halfedges that pointers lead to.
    fn follow(&mut self) {
        loop {
            let mut moved = false;
            for at in 0..self.pointers.len() {
                let pointer = self.pointers[at];
                let (from, to) = (self.is_bound(pointer.from), self.is_bound(pointer.to));
                if pointer.used || from == to {
                    continue;
                }
                self.pointers[at].used = true;
                moved = true;
                if from {
                    self.bind(pointer.to, pointer.forward());
                } else {
                    self.bind(pointer.from, pointer.backward());
                }
            }
            if !moved && !self.walk() {
                return;
            }
        }
    }

    /// A claim that ties an edge, vertex or face to a halfedge that is bound already.
    fn known_element(&self, element: NameId) -> Option<Claim> {
        let (halfedge, source) = self.source_of(element)?;
        debug_assert!(self.is_bound(halfedge));
        Some(Claim::Leads(source, Bound::Element(element)))
    }

    /// A bound halfedge that leads to an edge, vertex or face, and the pointer.
    fn source_of(&self, element: NameId) -> Option<(NameId, Source)> {
        let rule = self.drawing.rule;
        let view = &self.drawing.before;
        let bound = |half: &NameId| self.is_bound(*half);
        match rule.kind(element) {
            Kind::Edge => {
                let halves = view.edge_statement(element)?.halfedge_names();
                let half = halves.into_iter().find(bound)?;
                Some((half, Way::Edge.of(Bound::Element(half))))
            }
            Kind::Face => {
                let mut items = view.loop_of_face(element)?.item_names();
                let half = items.find(|item| rule.kind(*item) == Kind::Halfedge && bound(item))?;
                Some((half, Way::Face.of(Bound::Element(half))))
            }
            Kind::Vertex => {
                let corner = self.corners.iter().find(|corner| corner.vertex == element)?;
                corner.chains.iter().find_map(|chain| self.vertex_source(&chain.ports))
            }
            Kind::Halfedge | Kind::Path | Kind::Fan => None,
        }
    }

    /// A bound halfedge of a chain that leads to its vertex, and the pointer.
    pub fn vertex_source(&self, ports: &[Port]) -> Option<(NameId, Source)> {
        let usable =
            |item: NameId| self.drawing.rule.kind(item) == Kind::Halfedge && self.is_bound(item);
        let mut usable = ports.iter().copied().filter(|port| usable(port.item()));
        let port =
            usable.clone().find(|port| port.leaving().is_some()).or_else(|| usable.next())?;
        let halfedge = Bound::Element(port.item());
        let source = match port {
            Port::Out(_) => Way::Origin.of(halfedge),
            Port::In(_) => Way::Target.of(halfedge),
        };
        Some((port.item(), source))
    }

    /// The halfedge with which a parameter begins.
    fn anchor(&self, element: NameId) -> Option<NameId> {
        let rule = self.drawing.rule;
        let view = &self.drawing.before;
        match rule.kind(element) {
            Kind::Edge => view.edge_statement(element).map(|edge| edge.halfedges[0].name),
            Kind::Face => {
                let mut items = view.loop_of_face(element)?.item_names();
                items.find(|&item| rule.kind(item) == Kind::Halfedge && rule.is_first(item))
            }
            Kind::Vertex => {
                let listed = view.star(element).and_then(|star| {
                    star.spokes.iter().filter_map(Spoke::halfedge).find(|&half| rule.is_first(half))
                });
                let starts = || {
                    let starts = |half: &NameId| {
                        rule.is_first(*half) && self.drawing.origin_before(*half) == Some(element)
                    };
                    rule.names_of(Kind::Halfedge).find(starts)
                };
                listed.or_else(starts)
            }
            Kind::Halfedge | Kind::Path | Kind::Fan => None,
        }
    }

    /// The path that is all of the loop of a face.
    fn whole_path(&self, face: NameId) -> Option<NameId> {
        let rule = self.drawing.rule;
        if rule.kind(face) != Kind::Face {
            return None;
        }
        match self.drawing.before.loop_of_face(face)?.items.as_slice() {
            [item] if rule.kind(item.item.name) == Kind::Path => Some(item.item.name),
            _ => None,
        }
    }

    /// True if a loop that is one path matches alike wherever it begins: nothing depends on its
    /// vertex.
    fn is_alike_around(&self) -> bool {
        let rule = self.drawing.rule;
        let asks = !rule.requires.is_empty() || rule.guard.is_some();
        !asks && rule.assignments.is_empty() && rule.before.loops.len() == 1
    }

    /// Binds edges, faces and vertices, or reports the names that cannot be bound.
    fn everything_is_bound(&mut self, op: &Op) -> Result<(), Vec<Problem>> {
        let rule = self.drawing.rule;
        let view = &self.drawing.before;
        let lost: Vec<_> = rule
            .names_of(Kind::Halfedge)
            .filter(|&half| view.mention(half).is_some() && !self.is_bound(half))
            .filter(|&half| rule.is_first(half))
            .collect();
        if !lost.is_empty() {
            return Err(vec![self.unreachable(op, &lost)]);
        }
        for element in rule.ids() {
            if view.mention(element).is_none() || self.is_bound(element) || !rule.is_first(element)
            {
                continue;
            }
            if let Some((_, source)) = self.source_of(element) {
                self.bind(element, source);
            }
        }
        // The vertex and the ends of a loop that is one path.
        for orbit in &rule.before.loops {
            let ([item], face) = (orbit.items.as_slice(), orbit.face.name) else { continue };
            if rule.kind(item.item.name) != Kind::Path || !rule.is_first(face) {
                continue;
            }
            let path = item.item.name;
            if !self.is_bound(face) {
                return Err(vec![self.unreachable(op, &[face])]);
            }
            let first = Bound::First(path);
            self.steps.push(Step::Bind { name: Bound::Last(path), source: Way::Prev.of(first) });
            let vertex = item.from.name;
            let source = Way::Origin.of(first);
            if self.is_bound(vertex) {
                self.steps.push(Step::Test(Claim::Leads(source, Bound::Element(vertex))));
            } else {
                self.bind(vertex, source);
            }
        }
        let lost: Vec<_> = rule
            .ids()
            .filter(|&name| matches!(rule.kind(name), Kind::Vertex | Kind::Edge | Kind::Face))
            .filter(|&name| view.mention(name).is_some() && !self.is_bound(name))
            .filter(|&name| rule.is_first(name))
            .collect();
        if lost.is_empty() { Ok(()) } else { Err(vec![self.unreachable(op, &lost)]) }
    }

    /// A halfedge that is reached and may be the twin of one that is not: neither has one, and each
    /// starts where the other ends.
    fn twin_to_be(&self, half: NameId) -> Option<NameId> {
        let (rule, view) = (self.drawing.rule, &self.drawing.before);
        let [from, to] = view.loop_ends(half)?;
        let mut halves = rule.names_of(Kind::Halfedge);
        halves.find(|&other| {
            self.is_bound(other)
                && view.pairing(other).is_none()
                && view.loop_ends(other) == Some([to, from])
        })
    }

    fn unreachable(&self, op: &Op, lost: &[NameId]) -> Problem {
        let rule = self.drawing.rule;
        let list = enumerate(rule, lost);
        let be = super::problem::is_or_are(lost.len());
        let message = format!("{list} {be} not reachable from the parameters of `{}`", op.name);
        let name = lost[0];
        let span = self.drawing.before.mention(name).unwrap_or(rule.before.span);
        let mut diagnostic =
            Diagnostic::error("unreachable-name", message, span).saying("no pointer leads here");
        for &other in lost.iter().skip(1).take(3) {
            if let Some(span) = self.drawing.before.mention(other) {
                diagnostic = diagnostic.label(span, "");
            }
        }
        let word = &rule.name(name).text;
        let statement = match rule.kind(name) {
            Kind::Halfedge if self.drawing.before.pairing(name).is_none() => {
                match self.twin_to_be(name) {
                    Some(twin) => {
                        let twin = &rule.name(twin).text;
                        format!("an edge statement would bind it: `edge E: {twin} | {word}`")
                    }
                    None => format!(
                        "a parameter would bind it, `{word}: halfedge`, or an edge statement with \
                         a halfedge that is reached and drawn in no other"
                    ),
                }
            }
            Kind::Halfedge => format!(
                "a loop that holds {0}, or a twin of it, together with a halfedge that is reached would bind it",
                rule.quoted(name)
            ),
            Kind::Face => format!(
                "a loop that holds a halfedge that is reached would bind {}",
                rule.quoted(name)
            ),
            Kind::Vertex => format!("a loop that runs through {} would bind it", rule.quoted(name)),
            _ => format!("an edge statement would bind it: `edge {word}: h | h'`"),
        };
        // A note about a missing parameter helps more.
        let statement = undrawn(op, self.drawing).unwrap_or(statement);
        diagnostic
            .note(statement)
            .note("matching follows `next`, `prev`, `twin` and `edge`, `face`, `vertex`, but never searches along a path or a fan; else make it a parameter")
            .into()
    }

    /// Binds the ends of the paths.
    fn paths(&mut self) {
        let rule = self.drawing.rule;
        for orbit in rule.before.loops.iter().filter(|orbit| orbit.items.len() > 1) {
            let count = orbit.items.len();
            for (at, item) in orbit.items.iter().enumerate() {
                let path = item.item.name;
                if rule.kind(path) != Kind::Path || !rule.is_first(path) {
                    continue;
                }
                let before = orbit.items[(at + count - 1) % count].item.name;
                let after = orbit.items[(at + 1) % count].item.name;
                self.steps.push(Step::Bind {
                    name: Bound::First(path),
                    source: Way::Next.of(Bound::Element(before)),
                });
                self.steps.push(Step::Bind {
                    name: Bound::Last(path),
                    source: Way::Prev.of(Bound::Element(after)),
                });
            }
        }
    }
}
