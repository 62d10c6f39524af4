//! Equality of two meshes up to renumbering.
//!
//! That is: the elements of one mesh can be paired with those of the other such that every pointer,
//! the holes, and the positions (as far as asked) agree. Which of its halfedges an element stores
//! is not compared, nor are attribute columns.
//!
//! A connected map is rigid: the image of one halfedge determines those of all others. So for each
//! piece of one mesh, a seed is paired with each promising halfedge of the other in turn, and the
//! two are walked in step until they disagree. A halfedge is promising if it has the same *color*,
//! a hash of its surroundings (and of positions, if these must be equal) that does not depend on
//! the numbering; the seed has the rarest color.

use glam::DVec3;

use super::component::components;
use super::connectivity::Mesh;
use super::id::{ElementKind, HalfedgeId};
use super::level::scatter;

/// True if the meshes are the same up to renumbering, with equal positions.
pub fn equal_up_to_renumbering(a: &Mesh, b: &Mesh) -> bool {
    Comparison { a, b, positions: Positions::Equal }.holds()
}

/// As [`equal_up_to_renumbering`], but each coordinate may be off by `tolerance`. Where several
/// points are close enough, the first is taken.
pub fn same_up_to_renumbering(a: &Mesh, b: &Mesh, tolerance: f64) -> bool {
    Comparison { a, b, positions: Positions::Within(tolerance) }.holds()
}

/// True if the meshes are the same up to renumbering, wherever their vertices lie.
pub fn same_connectivity(a: &Mesh, b: &Mesh) -> bool {
    Comparison { a, b, positions: Positions::Anywhere }.holds()
}

#[derive(Clone, Copy)]
enum Positions {
    Equal,
    Within(f64),
    Anywhere,
}

impl Positions {
    fn agree(self, p: DVec3, q: DVec3) -> bool {
        match self {
            Self::Equal => p == q,
            Self::Within(tolerance) => (p - q).abs().max_element() <= tolerance,
            Self::Anywhere => true,
        }
    }
}

struct Comparison<'m> {
    a: &'m Mesh,
    b: &'m Mesh,
    positions: Positions,
}

/// A connected piece: its halfedges sorted by color, and a hash of all colors.
struct Piece {
    signature: u64,
    halfedges: Vec<(u64, HalfedgeId)>,
}

impl Comparison<'_> {
    fn holds(&self) -> bool {
        let count = |mesh: &Mesh, kind| mesh.count(kind);
        if ElementKind::ALL.iter().any(|&kind| count(self.a, kind) != count(self.b, kind))
            || self.a.hole_count() != self.b.hole_count()
            || !self.same_isolated_vertices()
        {
            return false;
        }
        let (ours, theirs) = (self.pieces(self.a), self.pieces(self.b));
        if !ours.iter().map(|p| p.signature).eq(theirs.iter().map(|p| p.signature)) {
            return false;
        }
        let mut pairing = Pairing::new(self);
        let mut used = vec![false; theirs.len()];
        // Equality is transitive (but for a tolerance), so a piece may take the first that matches.
        ours.iter().all(|piece| {
            let first = theirs.partition_point(|p| p.signature < piece.signature);
            let alike = theirs[first..].iter().take_while(|p| p.signature == piece.signature);
            let found = (first..)
                .zip(alike)
                .find(|(i, other)| !used[*i] && pairing.match_piece(piece, other));
            found.map(|(i, _)| used[i] = true).is_some()
        })
    }

    fn pieces(&self, mesh: &Mesh) -> Vec<Piece> {
        let colors = self.colors(mesh);
        let piece = |halfedges: Vec<HalfedgeId>| {
            let mut halfedges: Vec<_> =
                halfedges.into_iter().map(|h| (colors[h.index()], h)).collect();
            halfedges.sort_unstable();
            let hashes = halfedges.iter().map(|&(color, _)| scatter(color));
            Piece { signature: hashes.fold(0, u64::wrapping_add), halfedges }
        };
        let mut pieces: Vec<Piece> = components(mesh).into_iter().map(piece).collect();
        pieces.sort_by_key(|piece| piece.signature);
        pieces
    }

    /// Colors each halfedge by what surrounds it.
    fn colors(&self, mesh: &Mesh) -> Vec<u64> {
        // Distinct positions tell most halfedges apart at once.
        let rounds = if matches!(self.positions, Positions::Equal) { 2 } else { 10 };
        let start = |h: HalfedgeId| {
            let hole = u64::from(mesh.is_boundary_halfedge(h));
            let place = mesh.get_vertex(h).and_then(|v| mesh.get_position(v));
            match (self.positions, place) {
                // Adding zero makes -0 the same as 0.
                (Positions::Equal, Some(p)) => (p + DVec3::ZERO)
                    .to_array()
                    .iter()
                    .fold(hole, |hash, x| scatter(hash ^ x.to_bits())),
                _ => hole,
            }
        };
        let mut colors = vec![0; mesh.capacity(ElementKind::Halfedge)];
        mesh.halfedges().for_each(|h| colors[h.index()] = start(h));
        for _ in 0..rounds {
            let color = |h: HalfedgeId| colors.get(h.index()).copied().unwrap_or(1);
            let mut refined = vec![0; colors.len()];
            for h in mesh.halfedges() {
                let around = [h, mesh.next(h), mesh.prev(h), mesh.twin(h)];
                refined[h.index()] = around.iter().fold(0, |hash, &h| scatter(hash ^ color(h)));
            }
            colors = refined;
        }
        colors
    }

    fn same_isolated_vertices(&self) -> bool {
        let places = |mesh: &Mesh| {
            let isolated = mesh.vertices().filter(|&v| mesh.vertex_halfedge(v).is_none());
            let mut places: Vec<_> = isolated.map(|v| mesh.position(v) + DVec3::ZERO).collect();
            places.sort_by(|p, q| {
                p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(p.z.total_cmp(&q.z))
            });
            places
        };
        let (ours, theirs) = (places(self.a), places(self.b));
        if ours.len() != theirs.len() {
            return false;
        }
        let Positions::Within(tolerance) = self.positions else {
            return ours.iter().zip(&theirs).all(|(p, q)| self.positions.agree(*p, *q));
        };
        let mut used = vec![false; theirs.len()];
        ours.iter().all(|&p| {
            let first = theirs.partition_point(|q| q.x < p.x - tolerance);
            let near = theirs[first..].iter().take_while(|q| q.x <= p.x + tolerance);
            let mut found = (first..).zip(near);
            let found = found.find(|(i, q)| !used[*i] && self.positions.agree(p, **q));
            found.map(|(i, _)| used[i] = true).is_some()
        })
    }
}

/// The pairs of elements of `a` and `b` so far.
struct Pairing<'c> {
    comparison: &'c Comparison<'c>,
    tables: [PairTable; 4],
}

/// The pairs of one kind, in both directions, and those made since the last attempt began.
struct PairTable {
    forth: Vec<u32>,
    back: Vec<u32>,
    trail: Vec<(u32, u32)>,
}

const UNPAIRED: u32 = u32::MAX;

impl PairTable {
    /// Pairs `x` with `y` if neither has another partner. `Some(true)` if that is new.
    fn pair(&mut self, x: u32, y: u32) -> Option<bool> {
        let (forth, back) = (&mut self.forth[x as usize], &mut self.back[y as usize]);
        match (*forth, *back) {
            (UNPAIRED, UNPAIRED) => {
                (*forth, *back) = (y, x);
                self.trail.push((x, y));
                Some(true)
            }
            (there, here) => (there == y && here == x).then_some(false),
        }
    }
}

impl<'c> Pairing<'c> {
    fn new(comparison: &'c Comparison<'c>) -> Self {
        let table = |kind| PairTable {
            forth: vec![UNPAIRED; comparison.a.capacity(kind)],
            back: vec![UNPAIRED; comparison.b.capacity(kind)],
            trail: Vec::new(),
        };
        Self { comparison, tables: ElementKind::ALL.map(table) }
    }

    /// Pairs all elements of one piece with all of another, or none.
    fn match_piece(&mut self, ours: &Piece, theirs: &Piece) -> bool {
        let rarest = ours.halfedges.chunk_by(|a, b| a.0 == b.0).min_by_key(|chunk| chunk.len());
        let Some(&[(color, seed), ..]) = rarest else { return true };
        let first = theirs.halfedges.partition_point(|&(other, _)| other < color);
        let alike = theirs.halfedges[first..].iter().take_while(|&&(other, _)| other == color);
        alike.into_iter().any(|&(_, candidate)| self.walk(seed, candidate))
    }

    /// Walks both meshes in step from a pair of halfedges. Undoes its pairs if they disagree.
    fn walk(&mut self, seed: HalfedgeId, candidate: HalfedgeId) -> bool {
        let mut open = vec![(seed, candidate)];
        let mut agrees = self.pair(ElementKind::Halfedge, seed.0, candidate.0).is_some();
        while let Some((x, y)) = open.pop().filter(|_| agrees) {
            let (p, q) = (self.comparison.a.halfedge(x), self.comparison.b.halfedge(y));
            for (x, y) in [(p.next, q.next), (p.prev, q.prev), (p.twin, q.twin)] {
                match self.pair(ElementKind::Halfedge, x.0, y.0) {
                    Some(true) => open.push((x, y)),
                    Some(false) => {}
                    None => agrees = false,
                }
            }
            agrees &= self.pair(ElementKind::Vertex, p.vertex.0, q.vertex.0).is_some()
                && self.pair(ElementKind::Edge, p.edge.0, q.edge.0).is_some()
                && self.pair(ElementKind::Face, p.face.0, q.face.0).is_some();
        }
        for table in &mut self.tables {
            for (x, y) in table.trail.drain(..).filter(|_| !agrees) {
                table.forth[x as usize] = UNPAIRED;
                table.back[y as usize] = UNPAIRED;
            }
        }
        agrees
    }

    /// As [`PairTable::pair`], for living elements that are alike; two ids that are not alive
    /// agree.
    fn pair(&mut self, kind: ElementKind, x: u32, y: u32) -> Option<bool> {
        let Comparison { a, b, positions } = *self.comparison;
        match (a.is_alive(kind, x), b.is_alive(kind, y)) {
            (true, true) => {}
            (false, false) => return Some(false),
            _ => return None,
        }
        let alike = match kind {
            ElementKind::Vertex => {
                let [v, w] = [x, y].map(super::VertexId);
                positions.agree(a.position(v), b.position(w))
            }
            ElementKind::Face => {
                let [f, g] = [x, y].map(super::FaceId);
                a.is_hole(f) == b.is_hole(g)
            }
            ElementKind::Halfedge | ElementKind::Edge => true,
        };
        if alike { self.tables[kind as usize].pair(x, y) } else { None }
    }
}
