//! Finds the order in which a rule is matched, or the names that no pointer reaches.

use super::chain::{Corner, corners};
use super::matching::{Bound, Claim, Source, Step};
use super::port::{Links, Port};
use super::problem::{Problem, enumerate};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId, Op, Spoke};

/// The steps that bind every name of `before`, and test the rest of what it claims.
pub(super) fn matching(op: &Op, drawing: &Drawing) -> Result<Vec<Step>, Vec<Problem>> {
    let links = Links::of(drawing.rule, &drawing.rule.before);
    let corners = corners(drawing, &links);
    let mut reach = Reach {
        drawing,
        corners: &corners,
        pointers: pointers(drawing),
        bound: vec![false; drawing.rule.names.len()],
        steps: Vec::new(),
    };
    reach.parameters(op)?;
    reach.everything_is_bound(op)?;
    reach.paths();
    reach.claims();
    Ok(reach.steps)
}

/// A pointer that the drawing states between two named halfedges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pointer {
    pub from: NameId,
    pub to: NameId,
    leads: Leads,
    /// Whether a name is bound by it.
    pub used: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Leads {
    Next,
    Twin,
    Counterclockwise,
}

impl Pointer {
    /// From the first to the second.
    pub fn forward(self) -> Source {
        let from = Bound::Element(self.from);
        match self.leads {
            Leads::Next => Source::Next(from),
            Leads::Twin => Source::Twin(from),
            Leads::Counterclockwise => Source::Counterclockwise(from),
        }
    }

    fn backward(self) -> Source {
        let to = Bound::Element(self.to);
        match self.leads {
            Leads::Next => Source::Prev(to),
            Leads::Twin => Source::Twin(to),
            Leads::Counterclockwise => Source::Clockwise(to),
        }
    }
}

/// What the drawing says of halfedge after halfedge: `next` in loops, `twin` in edges,
/// and the next spoke in vertex statements where the loops and edges do not imply it.
fn pointers(drawing: &Drawing) -> Vec<Pointer> {
    let rule = drawing.rule;
    let view = &drawing.before;
    let is_halfedge = |name: NameId| rule.kind(name) == Kind::Halfedge;
    let mut pointers = Vec::new();
    for orbit in &rule.before.loops {
        for (at, item) in orbit.items.iter().enumerate() {
            let (from, to) = (
                item.item.name,
                orbit.items[(at + 1) % orbit.items.len()].item.name,
            );
            if is_halfedge(from) && is_halfedge(to) {
                pointers.push(Pointer {
                    from,
                    to,
                    leads: Leads::Next,
                    used: false,
                });
            }
        }
    }
    for edge in &rule.before.edges {
        let [from, to] = edge.halfedges.map(|half| half.name);
        pointers.push(Pointer {
            from,
            to,
            leads: Leads::Twin,
            used: false,
        });
    }
    for star in &rule.before.stars {
        for (at, spoke) in star.spokes.iter().enumerate() {
            let next = &star.spokes[(at + 1) % star.spokes.len()];
            let (Spoke::Halfedge(from), Spoke::Halfedge(to)) = (spoke, next) else {
                continue;
            };
            let (from, to) = (from.name, to.name);
            let implied = view
                .item_before(from)
                .is_some_and(|prev| is_halfedge(prev) && view.twin(prev) == Some(to));
            if !implied {
                pointers.push(Pointer {
                    from,
                    to,
                    leads: Leads::Counterclockwise,
                    used: false,
                });
            }
        }
    }
    pointers
}

/// What is bound, and the steps so far.
pub(super) struct Reach<'a> {
    pub drawing: &'a Drawing<'a>,
    pub corners: &'a [Corner],
    pub pointers: Vec<Pointer>,
    pub steps: Vec<Step>,
    bound: Vec<bool>,
}

impl Reach<'_> {
    fn is_bound(&self, name: NameId) -> bool {
        self.bound[name.index()]
    }

    fn bind(&mut self, name: NameId, source: Source) {
        self.bound[name.index()] = true;
        self.steps.push(Step::Bind {
            name: Bound::Element(name),
            source,
        });
    }

    /// Halfedge parameters first, then the others, each followed by all that it reaches.
    fn parameters(&mut self, op: &Op) -> Result<(), Vec<Problem>> {
        let rule = self.drawing.rule;
        let mut others = Vec::new();
        for (parameter, name) in rule.params.iter().enumerate() {
            let Some(name) = *name else { continue };
            self.steps.push(Step::Parameter { parameter, name });
            self.bound[name.index()] = true;
            if rule.kind(name) != Kind::Halfedge {
                others.push((parameter, name));
            }
        }
        self.follow();
        for (parameter, name) in others {
            if let Some(claim) = self.known_element(name) {
                self.steps.push(Step::Test(claim));
            } else if let Some(halfedge) = self.anchor(name) {
                self.bound[halfedge.index()] = true;
                self.steps.push(Step::Attempt {
                    element: name,
                    halfedge,
                });
                self.follow();
            } else if !self.is_whole_path(name) {
                let text = rule.quoted(name);
                let kind = rule.kind(name);
                let message = format!("`before` draws no halfedge of the parameter {text}");
                let word = &rule.name(name).text;
                let example = match kind {
                    Kind::Edge => format!("edge {word}: a | b"),
                    Kind::Vertex => format!("vertex {word}: a *S"),
                    _ => format!("face {word}: v0 -a-> v1 =P=> v0"),
                };
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
            if !moved {
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

    /// A bound halfedge that leads to an edge, vertex or face, and how.
    fn source_of(&self, element: NameId) -> Option<(NameId, Source)> {
        let rule = self.drawing.rule;
        let view = &self.drawing.before;
        let bound = |half: &NameId| self.is_bound(*half);
        match rule.kind(element) {
            Kind::Edge => {
                let halves = view.edge_statement(element)?.halfedges;
                let half = halves.map(|half| half.name).into_iter().find(bound)?;
                Some((half, Source::Edge(Bound::Element(half))))
            }
            Kind::Face => {
                let items = &view.loop_of_face(element)?.items;
                let halfedges = items.iter().map(|item| item.item.name);
                let half = halfedges
                    .filter(|&item| rule.kind(item) == Kind::Halfedge)
                    .find(bound)?;
                Some((half, Source::Face(Bound::Element(half))))
            }
            Kind::Vertex => {
                let corner = self
                    .corners
                    .iter()
                    .find(|corner| corner.vertex == element)?;
                corner
                    .chains
                    .iter()
                    .find_map(|chain| self.vertex_source(&chain.ports))
            }
            Kind::Halfedge | Kind::Path | Kind::Fan => None,
        }
    }

    /// How a chain leads to its vertex.
    pub fn vertex_source(&self, ports: &[Port]) -> Option<(NameId, Source)> {
        let usable =
            |item: NameId| self.drawing.rule.kind(item) == Kind::Halfedge && self.is_bound(item);
        let out = ports.iter().find_map(|port| match port {
            Port::Out(item) if usable(*item) => {
                Some((*item, Source::Origin(Bound::Element(*item))))
            }
            _ => None,
        });
        out.or_else(|| {
            ports.iter().find_map(|port| match port {
                Port::In(item) if usable(*item) => {
                    Some((*item, Source::Target(Bound::Element(*item))))
                }
                _ => None,
            })
        })
    }

    /// The halfedge with which a parameter begins.
    fn anchor(&self, element: NameId) -> Option<NameId> {
        let rule = self.drawing.rule;
        let view = &self.drawing.before;
        match rule.kind(element) {
            Kind::Edge => view
                .edge_statement(element)
                .map(|edge| edge.halfedges[0].name),
            Kind::Face => {
                let items = &view.loop_of_face(element)?.items;
                items
                    .iter()
                    .map(|item| item.item.name)
                    .find(|&item| rule.kind(item) == Kind::Halfedge)
            }
            Kind::Vertex => {
                let listed = view.star(element).and_then(|star| {
                    star.spokes.iter().find_map(|spoke| match spoke {
                        Spoke::Halfedge(half) => Some(half.name),
                        Spoke::Fan(_) | Spoke::Rest(_) => None,
                    })
                });
                let starts = || {
                    let starts = |half: &NameId| self.drawing.origin_before(*half) == Some(element);
                    rule.names_of(Kind::Halfedge).find(starts)
                };
                listed.or_else(starts)
            }
            Kind::Halfedge | Kind::Path | Kind::Fan => None,
        }
    }

    fn is_whole_path(&self, face: NameId) -> bool {
        let rule = self.drawing.rule;
        rule.kind(face) == Kind::Face
            && self.drawing.before.loop_of_face(face).is_some_and(|orbit| {
                matches!(orbit.items.as_slice(), [item] if rule.kind(item.item.name) == Kind::Path)
            })
    }

    /// Binds edges, faces and vertices, and tells the names that cannot be bound.
    fn everything_is_bound(&mut self, op: &Op) -> Result<(), Vec<Problem>> {
        let rule = self.drawing.rule;
        let view = &self.drawing.before;
        let lost: Vec<_> = rule
            .names_of(Kind::Halfedge)
            .filter(|&half| view.mention(half).is_some() && !self.is_bound(half))
            .collect();
        if !lost.is_empty() {
            return Err(vec![self.unreachable(op, &lost)]);
        }
        for element in (0..rule.names.len() as u32).map(NameId) {
            if view.mention(element).is_none() || self.is_bound(element) {
                continue;
            }
            if let Some((_, source)) = self.source_of(element) {
                self.bind(element, source);
            }
        }
        // The vertex and the ends of a loop that is one path.
        for orbit in &rule.before.loops {
            let ([item], face) = (orbit.items.as_slice(), orbit.face.name) else {
                continue;
            };
            if rule.kind(item.item.name) != Kind::Path {
                continue;
            }
            let path = item.item.name;
            if !self.is_bound(face) {
                return Err(vec![self.unreachable(op, &[face])]);
            }
            let first = Bound::First(path);
            self.steps.push(Step::Bind {
                name: first,
                source: Source::FaceHalfedge(face),
            });
            self.steps.push(Step::Bind {
                name: Bound::Last(path),
                source: Source::Prev(first),
            });
            let vertex = item.from.name;
            let source = Source::Origin(first);
            if self.is_bound(vertex) {
                self.steps
                    .push(Step::Test(Claim::Leads(source, Bound::Element(vertex))));
            } else {
                self.bind(vertex, source);
            }
        }
        let lost: Vec<_> = (0..rule.names.len() as u32)
            .map(NameId)
            .filter(|&name| matches!(rule.kind(name), Kind::Vertex | Kind::Edge | Kind::Face))
            .filter(|&name| view.mention(name).is_some() && !self.is_bound(name))
            .collect();
        if lost.is_empty() {
            Ok(())
        } else {
            Err(vec![self.unreachable(op, &lost)])
        }
    }

    fn unreachable(&self, op: &Op, lost: &[NameId]) -> Problem {
        let rule = self.drawing.rule;
        let list = enumerate(rule, lost);
        let be = super::problem::is_or_are(lost.len());
        let message = format!(
            "{list} {be} not reachable from the parameters of `{}`",
            op.name
        );
        let name = lost[0];
        let span = self
            .drawing
            .before
            .mention(name)
            .unwrap_or(rule.before.span);
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
                format!(
                    "an edge statement would bind it: `edge E: h | {word}`, with `h` a halfedge that is reached"
                )
            }
            Kind::Halfedge => format!(
                "a loop that holds {0}, or a twin of it, together with a halfedge that is reached would bind it",
                rule.quoted(name)
            ),
            Kind::Face => format!(
                "a loop that holds a halfedge that is reached would bind {}",
                rule.quoted(name)
            ),
            Kind::Vertex => format!(
                "a loop that runs through {} would bind it",
                rule.quoted(name)
            ),
            _ => format!("an edge statement would bind it: `edge {word}: h | h'`"),
        };
        diagnostic
            .note(statement)
            .note("matching follows `next`, `prev`, `twin` and `edge`, `face`, `vertex`, but never searches along a path or a fan; else make it a parameter")
            .into()
    }

    /// The ends of the paths.
    fn paths(&mut self) {
        let rule = self.drawing.rule;
        for orbit in rule
            .before
            .loops
            .iter()
            .filter(|orbit| orbit.items.len() > 1)
        {
            let count = orbit.items.len();
            for (at, item) in orbit.items.iter().enumerate() {
                let path = item.item.name;
                if rule.kind(path) != Kind::Path {
                    continue;
                }
                let before = orbit.items[(at + count - 1) % count].item.name;
                let after = orbit.items[(at + 1) % count].item.name;
                self.steps.push(Step::Bind {
                    name: Bound::First(path),
                    source: Source::Next(Bound::Element(before)),
                });
                self.steps.push(Step::Bind {
                    name: Bound::Last(path),
                    source: Source::Prev(Bound::Element(after)),
                });
            }
        }
    }
}
