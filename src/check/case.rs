//! One case of law 7: an arrangement of every vertex, carried over to `after`.

use std::borrow::Cow;

use super::arrangement::{Arc, ArcContent, Arrangement};
use super::chain::vertex_after;
use super::port::{Links, Port};
use super::problem::Problem;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId};

/// A step along a cycle of `after`.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    /// A port of the drawing.
    Port(Port),
    /// An arc outside the drawing.
    Arc(Arc),
}

/// One combination of arrangements, carried over to `after`.
pub(super) struct Case<'a> {
    pub drawing: &'a Drawing<'a>,
    /// For each path, where its first spoke lies.
    pub first_spokes: Vec<(NameId, ArcContent)>,
    /// The rings of spokes, clockwise.
    pub cycles: Vec<Vec<Step>>,
    /// An arc whose ends are not both free in `after`.
    pub cut: Option<Arc>,
}

impl<'a> Case<'a> {
    /// Joins the stated links of `after` with the arcs.
    pub fn new(drawing: &'a Drawing<'a>, after: &Links, ways: &[Cow<Arrangement>]) -> Self {
        let arcs: Vec<Arc> = ways.iter().flat_map(|way| way.arcs.iter().copied()).collect();
        let first_spokes = ways.iter().flat_map(|way| way.first_spokes.iter().copied()).collect();
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
        Self { drawing, first_spokes, cycles, cut }
    }

    /// The vertex that a piece belongs to after; `vertex` is the one it lies at before.
    pub(super) fn label(&self, content: ArcContent, vertex: NameId) -> Option<NameId> {
        match content {
            ArcContent::Fan(fan) => Some(self.drawing.after.star_of_spoke(fan).unwrap_or(vertex)),
            ArcContent::Rest => Some(vertex),
            ArcContent::Spoke(outer) => self.drawing.origin_after(outer),
            ArcContent::Empty => None,
        }
    }

    /// The vertex that the first spoke of a path belongs to, once fans have moved.
    pub(super) fn first_spoke_label(&self, path: NameId) -> Option<NameId> {
        let content = self.first_spokes.iter().find(|(name, _)| *name == path)?.1;
        self.label(content, self.drawing.origin_before(path)?)
    }

    pub fn problems(&self) -> Vec<Problem> {
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
            let of_vertex: Vec<_> = (0..labels.len()).filter(|&at| labels[at] == vertex).collect();
            let lives = self.drawing.survives(vertex) || self.drawing.created(vertex).is_some();
            match of_vertex.as_slice() {
                [] if lives => problems.push(self.without_spokes(vertex)),
                [] => {}
                [cycle, ..] if !lives => {
                    problems.push(self.spoke_of_erased(vertex, &self.cycles[*cycle]));
                }
                [cycle] => problems.extend(self.star_disagrees(vertex, &self.cycles[*cycle])),
                [first, second, ..] => problems.push(self.split(vertex, *first, *second)),
            }
        }
        problems
    }

    /// The vertex of each cycle, where it has one.
    pub fn labels(&self) -> Vec<Option<NameId>> {
        self.cycles.iter().map(|cycle| self.label_of(cycle).ok()).collect()
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
                Step::Arc(arc) => [self.label(arc.content, arc.vertex), None],
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
}
