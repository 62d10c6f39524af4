//! Operations whose result can be written down from the list of loops alone, on random polygon
//! meshes: the literal result is made here, with lists, and the library has to reach the same.
//!
//! An operation must be refused exactly where its literal result is no polygon mesh, or where
//! its documentation says so.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;
use hedgerow::mesh::{
    EdgeId, FaceId, HalfedgeId, Level, Mesh, VertexId, identical, shape, validate_level,
};
use hedgerow::rewrite::{Machine, Outcome};

use super::{canonical, library, rounded};
use support::reference::random::Random;

/// A mesh as its loops of halfedges, each with whether it is a hole.
#[derive(Clone)]
struct Loops {
    loops: Vec<(bool, Vec<u32>)>,
    twin: BTreeMap<u32, u32>,
    start: BTreeMap<u32, u32>,
    positions: BTreeMap<u32, DVec3>,
}

impl Loops {
    fn of(mesh: &Mesh) -> Self {
        let around = |f: FaceId| mesh.face_halfedges(f).map(|h| h.0).collect();
        Self {
            loops: mesh.faces().map(|f| (mesh.is_hole(f), around(f))).collect(),
            twin: mesh.halfedges().map(|h| (h.0, mesh.twin(h).0)).collect(),
            start: mesh.halfedges().map(|h| (h.0, mesh.vertex(h).0)).collect(),
            positions: mesh.vertices().map(|v| (v.0, mesh.position(v))).collect(),
        }
    }

    /// The loop of a halfedge, and its place there.
    fn place(&self, h: u32) -> (usize, usize) {
        let mut all = self.loops.iter().enumerate();
        let found = all.find_map(|(at, (_, of))| Some((at, of.iter().position(|&o| o == h)?)));
        found.expect("each halfedge lies in a loop")
    }

    /// A loop, from one of its halfedges on.
    fn from(&self, h: u32) -> Vec<u32> {
        let (of, at) = self.place(h);
        let mut turned = self.loops[of].1.clone();
        turned.rotate_left(at);
        turned
    }

    fn is_hole(&self, h: u32) -> bool {
        self.loops[self.place(h).0].0
    }

    fn spokes(&self, v: u32) -> Vec<u32> {
        let starts = self.start.iter().filter(|(_, start)| **start == v);
        starts.map(|(h, _)| *h).collect()
    }

    /// Takes edges out: at each, one goes on behind its twin. The loops that they were in become
    /// others, holes if `hole`; fails if there are several in the end.
    fn without(&mut self, edges: &BTreeSet<u32>, hole: bool) -> Result<(), ()> {
        let touched: BTreeSet<usize> = edges.iter().map(|&h| self.place(h).0).collect();
        let mut next = BTreeMap::new();
        for (_, of) in &self.loops {
            for (at, &h) in of.iter().enumerate() {
                next.insert(h, of[(at + 1) % of.len()]);
            }
        }
        let mut left: BTreeSet<u32> = touched
            .iter()
            .flat_map(|&at| self.loops[at].1.iter().copied())
            .filter(|h| !edges.contains(h))
            .collect();
        let mut made = Vec::new();
        while let Some(&first) = left.iter().next() {
            let (mut of, mut h) = (Vec::new(), first);
            while left.remove(&h) {
                of.push(h);
                h = next[&h];
                while edges.contains(&h) {
                    h = next[&self.twin[&h]];
                }
            }
            made.push((hole, of));
        }
        let mut at = 0;
        self.loops.retain(|_| {
            at += 1;
            !touched.contains(&(at - 1))
        });
        self.twin.retain(|h, _| !edges.contains(h));
        self.start.retain(|h, _| !edges.contains(h));
        let count = made.len();
        self.loops.extend(made);
        if count > 1 { Err(()) } else { Ok(()) }
    }

    /// Whether this is a polygon mesh.
    fn is_surface(&self) -> bool {
        let corners = |of: &[u32]| of.iter().map(|h| self.start[h]).collect::<Vec<_>>();
        let loops_are = self.loops.iter().all(|(hole, of)| {
            let corners = corners(of);
            let distinct: BTreeSet<_> = corners.iter().collect();
            distinct.len() == corners.len() && (*hole || of.len() > 2)
        });
        let edges_are = self.twin.iter().all(|(&h, &t)| !(self.is_hole(h) && self.is_hole(t)));
        let vertices: BTreeSet<u32> = self.start.values().copied().collect();
        let vertices_are = vertices.into_iter().all(|v| {
            let spokes = self.spokes(v);
            let holes = spokes.iter().filter(|&&h| self.is_hole(h)).count();
            spokes.len() > 1 && holes < 2
        });
        loops_are && edges_are && vertices_are
    }

    /// Faces and holes as cycles of positions.
    fn shape(&self) -> [Vec<Vec<[i64; 3]>>; 2] {
        [false, true].map(|wanted| {
            let of_sort = self.loops.iter().filter(|(hole, _)| *hole == wanted);
            let point = |h: &u32| rounded(self.positions[&self.start[h]]);
            canonical(of_sort.map(|(_, of)| of.iter().map(point).collect()).collect())
        })
    }
}

/// What comes of an operation: `Err` where it is refused.
type Done = Result<Loops, ()>;

fn bisect(mut mesh: Loops, h: u32) -> Done {
    let t = mesh.twin[&h];
    let fresh = mesh.twin.keys().max().expect("there is an edge") + 1;
    let middle = mesh.positions.keys().max().expect("there is a vertex") + 1;
    let ends = [h, t].map(|h| mesh.positions[&mesh.start[&h]]);
    mesh.positions.insert(middle, (ends[0] + ends[1]) / 2.0);
    for (old, new) in [(h, fresh), (t, fresh + 1)] {
        let (of, at) = mesh.place(old);
        mesh.loops[of].1.insert(at + 1, new);
        mesh.start.insert(new, middle);
    }
    for [a, b] in [[h, fresh + 1], [t, fresh]] {
        mesh.twin.insert(a, b);
        mesh.twin.insert(b, a);
    }
    Ok(mesh)
}

fn connect(mut mesh: Loops, a: u32, b: u32) -> Done {
    let ((of, _), (other, _)) = (mesh.place(a), mesh.place(b));
    let from_a = mesh.from(a);
    let apart = from_a.iter().position(|&h| h == b).unwrap_or(0);
    if of != other || mesh.loops[of].0 || apart < 2 || apart + 2 > from_a.len() {
        return Err(());
    }
    let fresh = mesh.twin.keys().max().expect("there is an edge") + 1;
    let (near, far) = from_a.split_at(apart);
    let (mut near, mut far) = (near.to_vec(), far.to_vec());
    near.push(fresh);
    far.push(fresh + 1);
    mesh.start.insert(fresh, mesh.start[&b]);
    mesh.start.insert(fresh + 1, mesh.start[&a]);
    mesh.twin.insert(fresh, fresh + 1);
    mesh.twin.insert(fresh + 1, fresh);
    mesh.loops[of].1 = near;
    mesh.loops.push((false, far));
    Ok(mesh)
}

fn dissolve_edge(mut mesh: Loops, h: u32) -> Done {
    let both = [h, mesh.twin[&h]];
    if mesh.place(both[0]).0 == mesh.place(both[1]).0 {
        return Err(());
    }
    let hole = both.iter().any(|&h| mesh.is_hole(h));
    mesh.without(&both.into(), hole)?;
    Ok(mesh)
}

fn dissolve_vertex(mut mesh: Loops, v: u32) -> Done {
    let spokes = mesh.spokes(v);
    let is_border = |h: u32| mesh.is_hole(h) || mesh.is_hole(mesh.twin[&h]);
    let border = spokes.iter().any(|&h| is_border(h));
    let inner: Vec<u32> = spokes.iter().copied().filter(|&h| !is_border(h)).collect();
    if border && inner.is_empty() {
        return Err(());
    }
    let both = inner.iter().flat_map(|&h| [h, mesh.twin[&h]]).collect();
    mesh.without(&both, false)?;
    if !border {
        return Ok(mesh);
    }
    // Of the two edges that are left at it one goes on to the end of the other.
    for h in mesh.spokes(v) {
        let before = *mesh.from(h).last().expect("a loop has sides");
        let (of, at) = mesh.place(h);
        mesh.loops[of].1.remove(at);
        if mesh.loops[of].1.len() < 3 {
            return Err(());
        }
        let across = mesh.twin[&h];
        mesh.twin.remove(&h);
        mesh.start.remove(&h);
        mesh.twin.insert(before, across);
    }
    // Each of the four halfedges has lost its twin; those that are left make an edge.
    let left: BTreeSet<u32> = mesh.twin.keys().copied().collect();
    let alone: Vec<u32> = left
        .iter()
        .copied()
        .filter(|h| !left.contains(&mesh.twin[h]) || mesh.twin[&mesh.twin[h]] != *h)
        .collect();
    if let [a, b] = alone[..] {
        mesh.twin.insert(a, b);
        mesh.twin.insert(b, a);
    }
    Ok(mesh)
}

fn open_face(mut mesh: Loops, h: u32) -> Done {
    let (of, _) = mesh.place(h);
    if mesh.loops[of].0 {
        return Err(());
    }
    mesh.loops[of].0 = true;
    let around = mesh.loops[of].1.clone();
    if around.iter().all(|h| mesh.is_hole(mesh.twin[h])) {
        return Err(());
    }
    let go = around.iter().filter(|h| mesh.is_hole(mesh.twin[h]));
    let both: BTreeSet<u32> = go.flat_map(|&h| [h, mesh.twin[&h]]).collect();
    // Several loops may be left here: the face lay at several holes, or parts the mesh.
    let _ = mesh.without(&both, true);
    Ok(mesh)
}

const OPS: [&str; 5] = ["bisect", "connect", "dissolve_edge", "dissolve_vertex", "open_face"];

fn literal(op: &str, mesh: Loops, [h, other]: [u32; 2]) -> Done {
    let done = match op {
        "bisect" => bisect(mesh, h),
        "connect" => connect(mesh, h, other),
        "dissolve_edge" => dissolve_edge(mesh, h),
        "dissolve_vertex" => {
            let v = mesh.start[&h];
            dissolve_vertex(mesh, v)
        }
        _ => open_face(mesh, h),
    };
    done.and_then(|mesh| mesh.is_surface().then_some(mesh).ok_or(()))
}

/// The same meshes with every vertex a little aside, so that positions tell them apart.
fn begin(random: &mut Random) -> Mesh {
    let mut mesh = match random.below(6) {
        0 => shape::cube(),
        1 => shape::octahedron(),
        2 => shape::grid(3, 3),
        3 => shape::torus(3, 4),
        4 => shape::tube(4, 2),
        _ => shape::single_polygon(6),
    };
    let all: Vec<_> = mesh.vertices().collect();
    for v in all {
        let aside = [0; 3].map(|_| random.below(1 << 20) as f64 / f64::from(1 << 24));
        mesh.set_position(v, mesh.position(v) + DVec3::from(aside));
    }
    mesh
}

#[test]
fn the_library_does_what_the_lists_say() {
    const RUNS: usize = 150;
    const STEPS: usize = 30;
    let library = library();
    let plans = OPS.map(|op| library.plans[library.op(op).unwrap()].as_ref().unwrap());
    let mut machine = Machine::new(&library.plans);
    machine.trust_level(Level::Surface);
    let mut random = Random::new(4);
    let mut counts = [[0_usize; 2]; OPS.len()];
    for run in 0..RUNS {
        let mut mesh = begin(&mut random);
        for step in 0..STEPS {
            let halfedges: Vec<_> = mesh.halfedges().collect();
            let (Some(&h), Some(&far)) = (random.pick(&halfedges), random.pick(&halfedges)) else {
                break;
            };
            // Corners of one face, mostly.
            let around: Vec<_> = mesh.loop_from(h).collect();
            let other = match random.once_in(8) {
                true => far,
                false => *random.pick(&around).unwrap(),
            };
            let which = random.below(OPS.len());
            let (op, plan) = (OPS[which], plans[which]);
            let (VertexId(v), EdgeId(e), FaceId(f)) = (mesh.vertex(h), mesh.edge(h), mesh.face(h));
            let places = match op {
                "connect" => vec![u64::from(h.0), u64::from(other.0)],
                "dissolve_vertex" => vec![u64::from(v)],
                "open_face" => vec![u64::from(f)],
                _ => vec![u64::from(e)],
            };
            let HalfedgeId(a) = h;
            let expected = literal(op, Loops::of(&mesh), [a, other.0]);
            let before = mesh.clone();
            let outcome = machine.apply(&mut mesh, plan, &places).unwrap();
            let at = format!("run {run}, step {step}: {op} at {places:?}");
            match (outcome, expected) {
                (Outcome::Applied { .. }, Ok(expected)) => {
                    validate_level(&mesh, Level::Surface).unwrap();
                    assert_eq!(Loops::of(&mesh).shape(), expected.shape(), "{at}");
                    counts[which][0] += 1;
                }
                (Outcome::Refused { .. }, Err(())) => {
                    assert!(identical(&mesh, &before), "{at}");
                    counts[which][1] += 1;
                }
                (Outcome::Applied { .. }, Err(())) => panic!("{at}: should be refused"),
                (Outcome::Refused { reason }, Ok(_)) => {
                    let why = &plan.refusals[usize::from(reason.unwrap())].reason;
                    panic!("{at}: refused: {why}\n{:?}", Loops::of(&before).shape());
                }
            }
        }
    }
    for (op, [done, refused]) in OPS.iter().zip(counts) {
        println!("{op}: {done} done, {refused} refused");
        assert!(done > 100, "{op}: {done} done");
        assert!(refused > 50 || *op == "bisect", "{op}: {refused} refused");
    }
}
