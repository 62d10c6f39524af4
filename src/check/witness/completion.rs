//! Every mesh of a given size in which a drawing lies.
//!
//! Such a mesh has the halfedges that are drawn and those on the paths, their twins, and some edges
//! besides. First each halfedge without a twin is paired with another one of these, or with a fresh
//! one; then each without a `next` gets one at the vertex where it ends. Vertices without a name
//! become one where links bring them together, vertices with different names never do. Nothing is
//! left out, so what is found first, going from size to size, is smallest.
//!
//! A search for polygon meshes discards others early: those where a loop has fewer than three sides
//! or meets a vertex twice, or a vertex has a single spoke.

use std::ops::ControlFlow;

use super::search::Shown;
use super::sketch::{HalfedgeRole, Shape, Sketch, VertexRole};
use crate::diagram::{Drawing, Kind, NameId};
use crate::mesh::Level;

/// The reason why an enumeration ends early.
pub(super) enum End {
    /// One was found.
    Found(Box<Shown>),
    /// There are too many.
    TooMany,
}

type Flow = ControlFlow<End>;

/// All meshes in which a drawing lies.
pub(super) struct Completions<'a> {
    pub drawing: &'a Drawing<'a>,
    /// True if two fans lie side by side with nothing between them: either may have all the spokes.
    pub ambiguous: bool,
    /// The level that the meshes must have.
    pub level: Level,
    /// The number of links that may still be tried.
    pub steps: usize,
    /// Called for each mesh; a result ends the enumeration.
    pub visit: &'a mut dyn FnMut(Sketch) -> Option<Shown>,
}

impl Completions<'_> {
    /// Visits all meshes with `size` halfedges.
    pub fn of_size(&mut self, size: usize) -> Flow {
        let drawing = self.drawing;
        let drawn = |kind: Kind| {
            let names = drawing.rule.names_of(kind);
            names.filter(|&name| drawing.before.mention(name).is_some()).collect::<Vec<_>>()
        };
        let paths = drawn(Kind::Path);
        let (outer, inner): (Vec<_>, Vec<_>) =
            drawn(Kind::Halfedge).into_iter().partition(|&half| drawing.is_outer(half));
        // All the outer ones may lie on paths.
        let Some(room) = size.checked_sub(inner.len()) else { return Flow::Continue(()) };
        let lengths = vec![0; drawing.rule.names.len()];
        self.lengths(&paths, &outer, Shape { lengths, ..Shape::default() }, room, size)
    }

    fn lengths(
        &mut self,
        paths: &[NameId],
        outer: &[NameId],
        mut shape: Shape,
        room: usize,
        size: usize,
    ) -> Flow {
        let Some((&path, others)) = paths.split_first() else {
            return self.on_paths(outer, shape, size);
        };
        self.step()?;
        let least = |path| usize::from(!self.drawing.may_be_empty(path));
        let for_others = others.iter().map(|&path| least(path)).sum();
        let Some(room) = room.checked_sub(for_others) else { return Flow::Continue(()) };
        for length in least(path)..=room {
            shape.lengths[path.index()] = length;
            self.lengths(others, outer, shape.clone(), room - length + for_others, size)?;
        }
        Flow::Continue(())
    }

    fn on_paths(&mut self, outer: &[NameId], shape: Shape, size: usize) -> Flow {
        self.step()?;
        let Some((&half, others)) = outer.split_first() else {
            for late in [false, true] {
                let shape = Shape { late, ..shape.clone() };
                let Some(sketch) = Sketch::open(self.drawing, &shape) else { break };
                if let Some(room) = size.checked_sub(sketch.halves.len()) {
                    self.twins(sketch, room)?;
                }
                if !self.ambiguous {
                    break;
                }
            }
            return Flow::Continue(());
        };
        self.on_paths(others, shape.clone(), size)?;
        for path in self.drawing.rule.names_of(Kind::Path) {
            for place in 0..shape.lengths[path.index()] {
                if shape.on_path.iter().any(|known| (known.1, known.2) == (path, place)) {
                    continue;
                }
                let mut shape = shape.clone();
                shape.on_path.push((half, path, place));
                self.on_paths(others, shape, size)?;
            }
        }
        Flow::Continue(())
    }

    /// Gives each halfedge a twin; the room that is left is for further edges.
    fn twins(&mut self, sketch: Sketch, room: usize) -> Flow {
        self.step()?;
        let single = |half: &usize| sketch.halves[*half].twin.is_none();
        let Some(half) = (0..sketch.halves.len()).find(single) else {
            let mut sketch = sketch;
            for _ in 0..room / 2 {
                let here = sketch.add_vertex(VertexRole::Loose);
                let spoke = sketch.add(HalfedgeRole::Further(here), here);
                sketch.fresh_twin(spoke);
            }
            return if room.is_multiple_of(2) { self.nexts(sketch) } else { Flow::Continue(()) };
        };
        for other in (half + 1..sketch.halves.len()).filter(single) {
            let mut paired = sketch.clone();
            if paired.pair(half, other).is_some() && self.may_be(&paired) {
                self.twins(paired, room)?;
            }
        }
        if room > 0 {
            let mut fresh = sketch;
            fresh.fresh_twin(half);
            self.twins(fresh, room - 1)?;
        }
        Flow::Continue(())
    }

    /// Gives each halfedge a `next`.
    fn nexts(&mut self, sketch: Sketch) -> Flow {
        self.step()?;
        let count = sketch.halves.len();
        let Some(arrives) = (0..count).find(|&half| sketch.halves[half].next.is_none()) else {
            return self.lone_vertices(sketch, 0);
        };
        for leaves in (0..count).filter(|&half| sketch.halves[half].prev.is_none()) {
            let mut linked = sketch.clone();
            let twin = linked.halves[arrives].twin.expect("twins come first");
            let [end, start] = [linked.halves[twin].origin, linked.halves[leaves].origin];
            if linked.unify(end, start).is_none() {
                continue;
            }
            linked.link(arrives, leaves);
            if linked.is_one_fan(leaves) && self.may_be(&linked) {
                self.nexts(linked)?;
            }
        }
        Flow::Continue(())
    }

    /// A named vertex of which no spoke is drawn may be any vertex without a name.
    fn lone_vertices(&mut self, sketch: Sketch, from: usize) -> Flow {
        let starts = |vertex: usize| sketch.halves.iter().any(|half| half.origin == vertex);
        let named = |vertex: usize| matches!(sketch.vertices[vertex], VertexRole::Named(_));
        let count = sketch.vertices.len();
        let Some(lone) = (from..count).find(|&vertex| named(vertex) && !starts(vertex)) else {
            return self.visit(sketch);
        };
        for vertex in (0..count).filter(|&vertex| !named(vertex) && starts(vertex)) {
            let mut placed = sketch.clone();
            if placed.unify(lone, vertex).is_some() {
                self.lone_vertices(placed, lone + 1)?;
            }
        }
        self.lone_vertices(sketch, lone + 1)
    }

    fn visit(&mut self, mut sketch: Sketch) -> Flow {
        self.step()?;
        sketch.compact();
        match (self.visit)(sketch) {
            Some(shown) => Flow::Break(End::Found(Box::new(shown))),
            None => Flow::Continue(()),
        }
    }

    fn step(&mut self) -> Flow {
        let Some(left) = self.steps.checked_sub(1) else { return Flow::Break(End::TooMany) };
        self.steps = left;
        Flow::Continue(())
    }

    /// True if a mesh of the wanted level can result from a sketch.
    fn may_be(&self, sketch: &Sketch) -> bool {
        self.level == Level::Map || sketch.may_be_polygons()
    }
}

impl Sketch {
    /// True unless the fan of a spoke is closed without all the spokes of its vertex.
    fn is_one_fan(&self, spoke: usize) -> bool {
        let vertex = self.halves[spoke].origin;
        let spokes = self.halves.iter().filter(|half| half.origin == vertex).count();
        self.closed_fan(spoke).is_none_or(|fan| fan == spokes)
    }

    /// The number of spokes around the vertex of one, if they close.
    fn closed_fan(&self, spoke: usize) -> Option<usize> {
        let mut at = spoke;
        for count in 1..=self.halves.len() {
            at = self.halves[self.halves[at].twin?].next?;
            if at == spoke {
                return Some(count);
            }
        }
        None
    }

    fn may_be_polygons(&self) -> bool {
        (0..self.halves.len()).all(|half| {
            let mut met = vec![self.halves[half].origin];
            let mut at = half;
            while let Some(next) = self.halves[at].next {
                if next == half {
                    return met.len() > 2 && self.closed_fan(half) != Some(1);
                }
                let origin = self.halves[next].origin;
                if met.contains(&origin) {
                    return false;
                }
                met.push(origin);
                at = next;
            }
            self.closed_fan(half) != Some(1)
        })
    }
}
