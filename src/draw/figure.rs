//! A rule as figures: nodes to place, strands between them, loops along the strands.
//!
//! A strand is an edge, with one halfedge or two, or a path. A path bends at three nodes of its
//! own, an edge from a vertex to itself at two; edges between the same two vertices bend at one
//! each. The nodes of both sides share one numbering, so that what is on both sides has one place.
//! A drawing may be malformed: of a name that occurs twice the first occurrence counts, and an end
//! without a known vertex is a loose node.

use super::split_vertices;
use crate::diagram::{Drawing, Kind, LoopKind, NameId, View};

/// The kind of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Node {
    Vertex(NameId),
    /// A bend of a strand.
    Bend,
    /// An end without a known vertex.
    Loose,
}

/// A direction along a strand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dart {
    pub strand: usize,
    pub forward: bool,
}

impl Dart {
    /// The number of the dart; its twin differs in the last bit.
    pub fn index(self) -> usize {
        2 * self.strand + usize::from(!self.forward)
    }

    /// The dart with the given number.
    pub fn of(index: usize) -> Self {
        Self { strand: index / 2, forward: index.is_multiple_of(2) }
    }
}

/// An edge or a path.
#[derive(Clone, Debug)]
pub(super) struct Strand {
    /// The edge, if it has a name.
    pub edge: Option<NameId>,
    /// The halfedge or path that runs along it, and the one that runs back.
    pub items: [Option<NameId>; 2],
    /// Its nodes, from end to end.
    pub nodes: Vec<usize>,
    /// True if it is a path.
    pub is_path: bool,
}

impl Strand {
    /// Its two ends.
    pub fn ends(&self) -> [usize; 2] {
        [self.nodes[0], self.nodes[self.nodes.len() - 1]]
    }

    /// The name that identifies it on both sides.
    fn key(&self) -> Option<NameId> {
        self.edge.or(self.items[0])
    }
}

/// A loop along strands.
#[derive(Clone, Debug)]
pub(super) struct Orbit {
    pub face: NameId,
    pub kind: LoopKind,
    pub darts: Vec<Dart>,
}

/// One side of a rule.
#[derive(Clone, Debug, Default)]
pub(super) struct Side {
    pub strands: Vec<Strand>,
    pub loops: Vec<Orbit>,
    /// The vertices that are drawn.
    pub shown: Vec<NameId>,
    /// The first dart of each name.
    pub darts: Vec<Option<Dart>>,
}

impl Side {
    /// The nodes from the start of a dart to its end.
    pub fn nodes(&self, dart: Dart) -> Vec<usize> {
        let mut nodes = self.strands[dart.strand].nodes.clone();
        if !dart.forward {
            nodes.reverse();
        }
        nodes
    }

    /// The nodes around a loop, each strand without its last node.
    pub fn around(&self, darts: &[Dart]) -> Vec<usize> {
        let mut nodes = Vec::new();
        for &dart in darts {
            let along = self.nodes(dart);
            nodes.extend(&along[..along.len() - 1]);
        }
        nodes
    }

    /// True if each dart of a loop begins where the one before it ends: not always, if a mesh is
    /// broken.
    pub fn is_closed(&self, darts: &[Dart]) -> bool {
        let ends = |dart: &Dart| {
            let [from, to] = self.strands[dart.strand].ends();
            if dart.forward { [from, to] } else { [to, from] }
        };
        let next = darts.iter().cycle().skip(1);
        darts.iter().zip(next).all(|(dart, next)| ends(dart)[1] == ends(next)[0])
    }

    /// The loop that each dart lies in.
    pub fn loop_of(&self) -> Vec<Option<usize>> {
        let mut of = vec![None; 2 * self.strands.len()];
        for (at, orbit) in self.loops.iter().enumerate() {
            for dart in &orbit.darts {
                of[dart.index()].get_or_insert(at);
            }
        }
        of
    }
}

/// Both sides of a rule.
#[derive(Clone, Debug)]
pub(super) struct Figure<'a> {
    pub drawing: Drawing<'a>,
    pub nodes: Vec<Node>,
    pub before: Side,
    pub after: Side,
    /// The first node of each vertex.
    vertex: Vec<Option<usize>>,
}

impl<'a> Figure<'a> {
    /// Reads a rule.
    pub fn new(drawing: Drawing<'a>) -> Self {
        let mut figure = Self {
            nodes: Vec::new(),
            before: Side::default(),
            after: Side::default(),
            vertex: vec![None; drawing.rule.names.len()],
            drawing,
        };
        for name in figure.drawing.rule.names_of(Kind::Vertex) {
            figure.vertex[name.index()] = Some(figure.nodes.len());
            figure.nodes.push(Node::Vertex(name));
        }
        let mut before = figure.read(None);
        let copies = split_vertices::split(&mut figure, &mut before);
        figure.bend(&mut before, None);
        let mut after = figure.read(Some(&before));
        split_vertices::follow(&figure, &mut after, &copies);
        figure.bend(&mut after, Some(&before));
        figure.before = before;
        figure.after = after;
        figure
    }

    /// True if a loop of `before` runs around the same nodes in `after`.
    pub fn stays(&self, orbit: &Orbit) -> bool {
        let nodes = self.before.around(&orbit.darts);
        let mut later = self.after.loops.iter();
        later.any(|other| other.face == orbit.face && self.after.around(&other.darts) == nodes)
    }

    /// All nodes of a vertex.
    pub fn nodes_of(&self, name: NameId) -> impl Iterator<Item = usize> {
        let nodes = self.nodes.iter().enumerate();
        nodes.filter_map(move |(at, node)| (*node == Node::Vertex(name)).then_some(at))
    }

    /// The first node of a vertex.
    pub fn vertex(&self, name: NameId) -> Option<usize> {
        self.vertex[name.index()]
    }

    fn node(&mut self, vertex: Option<NameId>) -> usize {
        match vertex.and_then(|vertex| self.vertex[vertex.index()]) {
            Some(node) => node,
            None => self.add(Node::Loose),
        }
    }

    fn add(&mut self, node: Node) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn read(&mut self, earlier: Option<&Side>) -> Side {
        let drawing = self.drawing.clone();
        let is_after = earlier.is_some();
        let view = if is_after { &drawing.after } else { &drawing.before };
        let origin = |item| match is_after {
            true => drawing.origin_after(item),
            false => drawing.origin_before(item),
        };
        let target = |item| match is_after {
            true => drawing.target_after(item),
            false => drawing.target_before(item),
        };
        let mut side = Side { darts: vec![None; drawing.rule.names.len()], ..Side::default() };
        for edge in &view.side().edges {
            let [along, back] = edge.halfedges.map(|halfedge| halfedge.name);
            if along == back || [along, back].iter().any(|item| side.darts[item.index()].is_some())
            {
                continue;
            }
            let from = self.node(origin(along).or_else(|| target(back)));
            let to = self.node(origin(back).or_else(|| target(along)));
            self.add_strand(&mut side, Some(edge.edge.name), [Some(along), Some(back)], [from, to]);
        }
        for item in view.side().loops.iter().flat_map(|orbit| &orbit.items) {
            let item = item.item.name;
            if side.darts[item.index()].is_none() {
                let from = self.node(view.loop_origin(item));
                let to = self.node(view.loop_target(item));
                self.add_strand(&mut side, None, [Some(item), None], [from, to]);
            }
        }
        self.add_stubs(&mut side, view, earlier);
        for orbit in &view.side().loops {
            let darts = orbit.items.iter();
            side.loops.push(Orbit {
                face: orbit.face.name,
                kind: orbit.kind,
                darts: darts.filter_map(|item| side.darts[item.item.name.index()]).collect(),
            });
        }
        for name in drawing.rule.names_of(Kind::Vertex) {
            let ends_something = side.strands.iter().any(|strand| {
                strand.ends().map(|end| self.nodes[end]).contains(&Node::Vertex(name))
            });
            if ends_something || view.mention(name).is_some() {
                side.shown.push(name);
            }
        }
        side
    }

    /// Adds the halfedges that only a vertex statement lists.
    fn add_stubs(&mut self, side: &mut Side, view: &View, earlier: Option<&Side>) {
        for star in &view.side().stars {
            for spoke in &star.spokes {
                let crate::diagram::Spoke::Halfedge(spoke) = spoke else { continue };
                if side.darts[spoke.name.index()].is_none() {
                    let known = earlier.and_then(|earlier| {
                        let dart = earlier.darts[spoke.name.index()]?;
                        let end = *earlier.nodes(dart).last()?;
                        (self.nodes[end] == Node::Loose).then_some(end)
                    });
                    let end = known.unwrap_or_else(|| self.add(Node::Loose));
                    let ends = [self.node(Some(star.vertex.name)), end];
                    self.add_strand(side, None, [Some(spoke.name), None], ends);
                }
            }
        }
    }

    fn add_strand(
        &mut self,
        side: &mut Side,
        edge: Option<NameId>,
        items: [Option<NameId>; 2],
        ends: [usize; 2],
    ) {
        let strand = side.strands.len();
        for (item, forward) in items.into_iter().zip([true, false]) {
            if let Some(item) = item {
                side.darts[item.index()].get_or_insert(Dart { strand, forward });
            }
        }
        let is_path = items[0].is_some_and(|item| self.drawing.rule.kind(item) == Kind::Path);
        side.strands.push(Strand { edge, items, nodes: ends.to_vec(), is_path });
    }

    /// Adds the nodes at which strands bend: those of `earlier` for unchanged strands, else new
    /// ones.
    fn bend(&mut self, side: &mut Side, earlier: Option<&Side>) {
        let joins = |ends: [usize; 2]| {
            move |other: &&Strand| !other.is_path && sorted(other.ends()) == sorted(ends)
        };
        let strands = side.strands.iter();
        let parallel = |strand: &Strand| strands.clone().filter(joins(strand.ends())).count();
        let parallel: Vec<_> = side.strands.iter().map(parallel).collect();
        for (strand, parallel) in side.strands.iter_mut().zip(parallel) {
            let [from, to] = strand.ends();
            let known = earlier.and_then(|earlier| {
                earlier.strands.iter().find(|other| {
                    let same = other.items == strand.items && other.key() == strand.key();
                    same && other.ends() == strand.ends()
                })
            });
            let bends = match known {
                Some(known) => known.nodes[1..known.nodes.len() - 1].to_vec(),
                None => {
                    let count = match () {
                        () if strand.is_path => 3,
                        () if from == to => 2,
                        () if parallel > 1 => 1,
                        () => 0,
                    };
                    (0..count).map(|_| self.add(Node::Bend)).collect()
                }
            };
            strand.nodes = [vec![from], bends, vec![to]].concat();
        }
    }
}

fn sorted(mut ends: [usize; 2]) -> [usize; 2] {
    ends.sort_unstable();
    ends
}
