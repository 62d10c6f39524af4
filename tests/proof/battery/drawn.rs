//! Ops drawn out of random maps: their `before` is a piece of a map, with all the loops, digons
//! and edges that end where they begin that people do not think of, and `after` the same piece
//! cut and glued anew.
//!
//! Halfedges of the map are named or hidden in paths and fans. A vertex that the piece meets in
//! several places has one name or several, which an `alias` then lets be one. What becomes of the
//! vertices and faces is read off the map that is cut and glued in the same way, so many of these
//! ops are right, at least on the map that they were drawn from.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use hedgerow::mesh::{HalfedgeId, Mesh};

use crate::battery::trial::Trial;
use support::reference::maps::random_map;
use support::reference::random::Random;

/// An op, and where it was drawn from.
pub struct Drawn {
    pub text: String,
    pub home: Trial,
}

/// An op drawn out of a random map; `None` where the dice make none.
pub fn drawn(random: &mut Random) -> Option<Drawn> {
    let mesh = random_map(2 + 2 * random.below(5), random);
    let mut piece = Piece::cut_out(mesh, random)?;
    piece.name_vertices(random);
    piece.list_spokes(random);
    let params = piece.params(random)?;
    let mut text = piece.before(&params, random);
    let changes = 1 + random.below(3);
    for _ in 0..changes {
        piece.change(random);
    }
    write!(text, "{}", piece.after(random)?).expect("a string");
    let places = vec![params.into_iter().map(|param| param.element).collect()];
    Some(Drawn { text, home: Trial { mesh: piece.mesh, places } })
}

/// A parameter: its name, its type, and what is given.
struct Param {
    name: String,
    ty: &'static str,
    element: u32,
}

/// A named halfedge, or a path, in a loop.
#[derive(Clone)]
struct Item {
    name: String,
    is_path: bool,
    /// The halfedges of the map; those that are new are numbered on.
    halves: Vec<usize>,
    /// The name of the vertex it leaves before; none if it is new.
    from: String,
    /// The vertex of the map that it leaves.
    vertex: u32,
    face: Option<u32>,
}

struct Piece {
    mesh: Mesh,
    items: Vec<Item>,
    /// By item, the one that follows; none if it is gone.
    next: Vec<Option<usize>>,
    /// Halfedges that are drawn only as twins.
    outer: Vec<usize>,
    /// The edges that are drawn, by name.
    edges: Vec<(String, [usize; 2])>,
    /// The names of each vertex of the map.
    vertices: BTreeMap<u32, Vec<String>>,
    /// The statements of vertices before, and of each halfedge in a fan the fan.
    stars: Vec<(u32, String)>,
    fans: BTreeMap<usize, String>,
    /// What the faces are called, and by what keyword.
    faces: BTreeMap<u32, (String, &'static str)>,
    gone: Vec<String>,
    count: usize,
}

fn id(half: usize) -> HalfedgeId {
    HalfedgeId(half as u32)
}

impl Piece {
    fn cut_out(mesh: Mesh, random: &mut Random) -> Option<Self> {
        let count = mesh.halfedge_count();
        let mut named: Vec<usize> = (0..count).collect();
        random.shuffle(&mut named);
        named.truncate(1 + random.below(count.min(6)));
        let mut faces = BTreeMap::new();
        for (at, &half) in named.iter().enumerate() {
            if at == 0 || !random.once_in(5) {
                let face = mesh.face(id(half));
                let keyword = match (random.once_in(3), mesh.is_hole(face)) {
                    (true, _) => "loop",
                    (false, true) => "hole",
                    (false, false) => "face",
                };
                faces.entry(face.0).or_insert((format!("f{}", face.0), keyword));
            }
        }
        let mut piece = Self {
            mesh,
            items: Vec::new(),
            next: Vec::new(),
            outer: Vec::new(),
            edges: Vec::new(),
            vertices: BTreeMap::new(),
            stars: Vec::new(),
            fans: BTreeMap::new(),
            faces,
            gone: Vec::new(),
            count,
        };
        let inner: Vec<usize> = named.iter().copied().filter(|&h| piece.is_inner(h)).collect();
        for face in piece.faces.keys().copied().collect::<Vec<_>>() {
            piece.draw_loop(face, &inner, random);
        }
        for &half in &inner {
            let twin = piece.mesh.twin(id(half)).index();
            let both = inner.contains(&twin);
            if (both && (half > twin || random.once_in(5))) || (!both && random.once_in(2)) {
                continue;
            }
            if !both {
                piece.outer.push(twin);
            }
            let edge = piece.mesh.edge(id(half)).0;
            piece.edges.push((format!("e{edge}"), [half, twin]));
        }
        Some(piece)
    }

    fn is_inner(&self, half: usize) -> bool {
        self.faces.contains_key(&self.mesh.face(id(half)).0)
    }

    /// A loop: the halfedges with names, and paths of those between.
    fn draw_loop(&mut self, face: u32, inner: &[usize], random: &mut Random) {
        let start = self.mesh.face_halfedge(hedgerow::mesh::FaceId(face));
        let mut cycle: Vec<usize> = self.mesh.loop_from(start).map(|h| h.index()).collect();
        let first = cycle.iter().position(|half| inner.contains(half)).unwrap_or(0);
        cycle.rotate_left(first);
        let begin = self.items.len();
        for (at, &half) in cycle.iter().enumerate() {
            let is_named = inner.contains(&half);
            let follows_path = self.items.len() > begin && self.items[self.items.len() - 1].is_path;
            let empty_path = is_named && at > 0 && !follows_path && random.once_in(5);
            if empty_path {
                self.add_path(Vec::new(), half, face);
            }
            match (is_named, follows_path) {
                (true, _) => self.items.push(Item {
                    name: format!("h{half}"),
                    is_path: false,
                    halves: vec![half],
                    from: String::new(),
                    vertex: self.mesh.vertex(id(half)).0,
                    face: Some(face),
                }),
                (false, true) => {
                    let last = self.items.len() - 1;
                    self.items[last].halves.push(half);
                }
                (false, false) => self.add_path(vec![half], half, face),
            }
        }
        let last = &self.items[self.items.len() - 1];
        if !last.is_path && random.once_in(5) {
            self.add_path(Vec::new(), cycle[0], face);
        }
        let end = self.items.len();
        for at in begin..end {
            self.next.push(Some(if at + 1 == end { begin } else { at + 1 }));
        }
    }

    fn add_path(&mut self, halves: Vec<usize>, begins: usize, face: u32) {
        self.items.push(Item {
            name: format!("P{}", self.items.len()),
            is_path: true,
            halves,
            from: String::new(),
            vertex: self.mesh.vertex(id(begins)).0,
            face: Some(face),
        });
    }

    fn item_of(&self, half: usize) -> Option<usize> {
        self.items.iter().position(|item| !item.is_path && item.halves == [half])
    }

    /// One name for a vertex wherever the statements meet in it, or several that may be one.
    fn name_vertices(&mut self, random: &mut Random) {
        // Corners that an edge statement makes one.
        let mut class: Vec<usize> = (0..self.items.len()).collect();
        for (_, [left, right]) in &self.edges {
            for (half, twin) in [(left, right), (right, left)] {
                let (Some(half), Some(twin)) = (self.item_of(*half), self.item_of(*twin)) else {
                    continue;
                };
                let target = self.next[half].expect("nothing is gone yet");
                let (from, to) = (class[target], class[twin]);
                class.iter_mut().filter(|class| **class == from).for_each(|class| *class = to);
            }
        }
        let mut names: BTreeMap<usize, String> = BTreeMap::new();
        for (at, &class) in class.iter().enumerate() {
            let vertex = self.items[at].vertex;
            let known = self.vertices.entry(vertex).or_default();
            let name = names.entry(class).or_insert_with(|| {
                if !known.is_empty() && random.once_in(2) {
                    return known[random.below(known.len())].clone();
                }
                let letters = ["", "b", "c", "d", "e", "g", "k", "l", "m", "n"];
                known.push(format!("v{vertex}{}", letters[known.len().min(9)]));
                known[known.len() - 1].clone()
            });
            self.items[at].from = name.clone();
        }
    }

    /// Statements of some vertices: all their spokes, with fans of those without a name.
    fn list_spokes(&mut self, random: &mut Random) {
        for (vertex, names) in self.vertices.clone() {
            if names.len() > 1 || !random.once_in(3) {
                continue;
            }
            let ring = self.mesh.spokes(hedgerow::mesh::VertexId(vertex));
            let mut ring: Vec<_> = ring.map(|h| h.index()).collect();
            let Some(first) = ring.iter().position(|&half| self.is_named(half)) else {
                continue;
            };
            ring.rotate_left(first);
            let mut words: Vec<String> = Vec::new();
            let mut fan = None;
            for half in ring {
                if self.is_named(half) {
                    fan = None;
                    words.push(format!("h{half}"));
                    continue;
                }
                let name = fan.get_or_insert_with(|| format!("S{half}")).clone();
                if !self.fans.values().any(|known| *known == name) {
                    words.push(format!("*{name}"));
                }
                self.fans.insert(half, name);
            }
            self.stars.push((vertex, words.join(" ")));
        }
    }

    fn is_named(&self, half: usize) -> bool {
        half >= self.count || self.outer.contains(&half) || self.item_of(half).is_some()
    }

    /// A halfedge of each part that pointers hold together, or what it is of.
    fn params(&self, random: &mut Random) -> Option<Vec<Param>> {
        let mut part: Vec<usize> = (0..self.count).collect();
        let mut join = |x: usize, y: usize| {
            let (from, to) = (part[x], part[y]);
            part.iter_mut().filter(|part| **part == from).for_each(|part| *part = to);
        };
        for (at, item) in self.items.iter().enumerate() {
            let next = &self.items[self.next[at]?];
            if !item.is_path && !next.is_path {
                join(item.halves[0], next.halves[0]);
            }
        }
        self.edges.iter().for_each(|(_, [left, right])| join(*left, *right));
        let mut begun: Vec<usize> = Vec::new();
        let mut params: Vec<Param> = Vec::new();
        for item in self.items.iter().filter(|item| !item.is_path) {
            let half = item.halves[0];
            if begun.contains(&part[half]) {
                continue;
            }
            begun.push(part[half]);
            let edge = self.edges.iter().find(|(_, halves)| halves.contains(&half));
            let mut param = Param { name: item.name.clone(), ty: "halfedge", element: half as u32 };
            let face = self.mesh.face(id(half)).0;
            match (random.below(6), edge) {
                (0, Some((name, _))) => {
                    let element = self.mesh.edge(id(half)).0;
                    param = Param { name: name.clone(), ty: "edge", element };
                }
                (1, _) => {
                    let name = self.faces[&face].0.clone();
                    param = Param { name, ty: "face", element: face };
                }
                (2, _) => {
                    let name = item.from.clone();
                    param = Param { name, ty: "vertex", element: item.vertex };
                }
                _ => {}
            }
            if params.iter().any(|known| known.name == param.name) {
                param = Param { name: item.name.clone(), ty: "halfedge", element: half as u32 };
            }
            params.push(param);
        }
        (1..=3).contains(&params.len()).then_some(params)
    }

    fn before(&self, params: &[Param], random: &mut Random) -> String {
        let params: Vec<_> = params.iter().map(|it| format!("{}: {}", it.name, it.ty)).collect();
        let mut text = format!("op drawn({}) {{\n  before {{\n", params.join(", "));
        for (face, (name, keyword)) in &self.faces {
            let of = self.items.iter().filter(|item| item.face == Some(*face));
            let words: Vec<_> = of.map(|item| words(&item.from, item)).collect();
            let end = self.items.iter().find(|item| item.face == Some(*face));
            let end = &end.expect("a loop has items").from;
            writeln!(text, "    {keyword} {name}: {}{end}", words.concat()).expect("a string");
        }
        for (name, [left, right]) in &self.edges {
            writeln!(text, "    edge {name}: h{left} | h{right}").expect("a string");
        }
        for (vertex, spokes) in &self.stars {
            let name = &self.vertices[vertex][0];
            writeln!(text, "    vertex {name}: {spokes}").expect("a string");
        }
        text.push_str("  }\n");
        for names in self.vertices.values().filter(|names| names.len() > 1) {
            // Now and then not all of them: then it is not proved, or refused elsewhere.
            let some = if random.once_in(8) { 2 } else { names.len() };
            writeln!(text, "  alias {}", names[..some].join(" ")).expect("a string");
        }
        text
    }

    /// Cuts and glues: exchanges what follows two items, exchanges twins, lets an edge go, adds
    /// one, or splits one.
    fn change(&mut self, random: &mut Random) {
        let alive: Vec<_> = (0..self.items.len()).filter(|&at| self.next[at].is_some()).collect();
        let Some(&one) = random.pick(&alive) else { return };
        let Some(&other) = random.pick(&alive) else { return };
        let drawn = |piece: &Self, edge: usize| {
            let [left, right] = piece.edges[edge].1;
            Some([piece.item_of(left)?, piece.item_of(right)?])
        };
        let edge = (!self.edges.is_empty()).then(|| random.below(self.edges.len()));
        match (random.below(8), edge) {
            (0 | 1, _) => self.next.swap(one, other),
            (2, Some(edge)) => {
                let with = random.below(self.edges.len());
                let kept = self.edges[edge].1[0];
                let side = random.below(2);
                if with != edge {
                    self.edges[edge].1[0] = self.edges[with].1[side];
                    self.edges[with].1[side] = kept;
                }
            }
            (3..=5, Some(edge)) => {
                let Some(items) = drawn(self, edge) else { return };
                if self.items.iter().filter(|item| !item.is_path).count() < 3 {
                    return;
                }
                for item in items {
                    let prev = self.next.iter().position(|&next| next == Some(item));
                    let (Some(prev), next) = (prev, self.next[item]) else { return };
                    self.next[prev] = next;
                    self.next[item] = None;
                    self.gone.push(self.items[item].name.clone());
                }
                self.gone.push(self.edges.remove(edge).0);
            }
            (6, _) => {
                let [x, y] = [self.add(), self.add()];
                self.insert(x, one);
                self.insert(y, other);
                let halves = [x, y].map(|item| self.items[item].halves[0]);
                self.edges.push((format!("k{}", self.items.len()), halves));
            }
            (7, Some(edge)) => {
                let Some([left, right]) = drawn(self, edge) else { return };
                let [x, y] = [self.add(), self.add()];
                self.insert(x, left);
                self.insert(y, right);
                let [x, y] = [x, y].map(|item| self.items[item].halves[0]);
                let old = self.edges[edge].1[1];
                self.edges[edge].1[1] = y;
                self.edges.push((format!("k{}", self.items.len()), [x, old]));
            }
            _ => {}
        }
    }

    /// A new halfedge.
    fn add(&mut self) -> usize {
        let new = self.items.iter().filter(|item| item.face.is_none()).count();
        let half = self.count + new;
        self.items.push(Item {
            name: format!("h{half}"),
            is_path: false,
            halves: vec![half],
            from: String::new(),
            vertex: u32::MAX,
            face: None,
        });
        self.next.push(None);
        self.items.len() - 1
    }

    fn insert(&mut self, item: usize, behind: usize) {
        self.next[item] = self.next[behind];
        self.next[behind] = Some(item);
    }

    /// The loops after, as items.
    fn cycles(&self) -> Vec<Vec<usize>> {
        let mut seen = vec![false; self.items.len()];
        let mut cycles = Vec::new();
        for start in 0..self.items.len() {
            if seen[start] || self.next[start].is_none() {
                continue;
            }
            let mut cycle = Vec::new();
            let mut at = start;
            while !seen[at] {
                seen[at] = true;
                cycle.push(at);
                at = self.next[at].unwrap_or(start);
            }
            cycles.push(cycle);
        }
        cycles
    }

    /// `next` and `twin` of the map that is cut and glued; none for what is gone.
    fn glued(&self, cycles: &[Vec<usize>]) -> Option<[Vec<Option<usize>>; 2]> {
        let old = |to: HalfedgeId| Some(to.index());
        let new = self.items.iter().filter(|item| item.face.is_none()).count();
        let mut next: Vec<_> = (0..self.count).map(|h| old(self.mesh.next(id(h)))).collect();
        let mut twin: Vec<_> = (0..self.count).map(|h| old(self.mesh.twin(id(h)))).collect();
        next.resize(self.count + new, None);
        twin.resize(self.count + new, None);
        for (at, item) in self.items.iter().enumerate().filter(|(at, _)| self.next[*at].is_none()) {
            debug_assert!(!self.items[at].is_path);
            (next[item.halves[0]], twin[item.halves[0]]) = (None, None);
        }
        for cycle in cycles {
            let halves: Vec<_> =
                cycle.iter().flat_map(|&item| self.items[item].halves.iter().copied()).collect();
            if halves.is_empty() {
                return None;
            }
            for (at, &half) in halves.iter().enumerate() {
                next[half] = Some(halves[(at + 1) % halves.len()]);
            }
        }
        for (_, [left, right]) in &self.edges {
            (twin[*left], twin[*right]) = (Some(*right), Some(*left));
        }
        Some([next, twin])
    }

    fn after(&self, random: &mut Random) -> Option<String> {
        let cycles = self.cycles();
        let [next, twin] = self.glued(&cycles)?;
        let total = next.len();
        let mut prev = vec![None; total];
        for half in 0..total {
            if let Some(next) = next[half] {
                prev[next] = Some(half);
            }
        }
        // The rings of spokes, counterclockwise.
        let mut ring_of: Vec<Option<usize>> = vec![None; total];
        let mut rings: Vec<Vec<usize>> = Vec::new();
        for start in 0..total {
            if next[start].is_none() || ring_of[start].is_some() {
                continue;
            }
            let mut ring = Vec::new();
            let mut at = start;
            while ring_of[at].is_none() {
                ring_of[at] = Some(rings.len());
                ring.push(at);
                at = twin[prev[at]?]?;
            }
            rings.push(ring);
        }
        // Each vertex goes to the first ring in which one of its spokes lies.
        let old = |half: usize| (half < self.count).then(|| self.mesh.vertex(id(half)).0);
        let mut owner: Vec<Option<u32>> = vec![None; rings.len()];
        for (at, ring) in rings.iter().enumerate() {
            let mut olds = ring.iter().filter_map(|&half| old(half));
            owner[at] = olds.find(|vertex| !owner.contains(&Some(*vertex)));
        }
        let mut created: Vec<String> = Vec::new();
        let mut used: Vec<String> = Vec::new();
        let mut name_at = |ring: usize, item: Option<&Item>| {
            let name = match owner[ring] {
                None => format!("n{ring}"),
                Some(vertex) => match item {
                    Some(item) if item.vertex == vertex => item.from.clone(),
                    _ => self.vertices.get(&vertex).map(|names| names[0].clone())?,
                },
            };
            used.push(name.clone());
            Some(name)
        };
        let mut text = String::new();
        let mut faces: Vec<u32> = Vec::new();
        for cycle in &cycles {
            let of_items = cycle.iter().filter_map(|&item| self.items[item].face);
            let face = of_items.into_iter().find(|face| !faces.contains(face));
            let (name, keyword) = match face {
                Some(face) => {
                    faces.push(face);
                    self.faces[&face].clone()
                }
                None => {
                    let name = format!("g{}", created.len());
                    created.push(name.clone());
                    (name, if random.once_in(3) { "hole" } else { "face" })
                }
            };
            // An item starts where the first halfedge from it on does.
            let first = |at: usize| {
                let rest = (0..cycle.len()).map(|turn| cycle[(at + turn) % cycle.len()]);
                rest.flat_map(|item| self.items[item].halves.first().copied()).next()
            };
            let mut origins = Vec::new();
            for (at, &item) in cycle.iter().enumerate() {
                origins.push(name_at(ring_of[first(at)?]?, Some(&self.items[item]))?);
            }
            let items = cycle.iter().zip(&origins);
            let items: String = items.map(|(&at, from)| words(from, &self.items[at])).collect();
            writeln!(text, "    {keyword} {name}: {items}{}", origins[0]).expect("a string");
        }
        for (name, [left, right]) in &self.edges {
            writeln!(text, "    edge {name}: h{left} | h{right}").expect("a string");
        }
        for (at, ring) in rings.iter().enumerate() {
            let in_fan = ring.iter().any(|half| self.fans.contains_key(half));
            let named = ring.iter().position(|&half| self.is_named(half));
            let Some(first) = named else { continue };
            if !(in_fan || owner[at].is_none() && random.once_in(3)) {
                continue;
            }
            let mut spokes: Vec<String> = Vec::new();
            for turn in 0..ring.len() {
                let half = ring[(first + turn) % ring.len()];
                let word = match (self.is_named(half), self.fans.get(&half)) {
                    (true, _) => format!("h{half}"),
                    (false, Some(fan)) => format!("*{fan}"),
                    (false, None) => "*".into(),
                };
                if word.starts_with('h') || spokes.last() != Some(&word) {
                    spokes.push(word);
                }
            }
            let Some(name) = name_at(at, None) else { continue };
            writeln!(text, "    vertex {name}: {}", spokes.join(" ")).expect("a string");
        }
        let mut erased = self.gone.clone();
        let names = self.vertices.values().flatten();
        erased.extend(names.filter(|name| !used.contains(name)).cloned());
        let lost = self.faces.iter().filter(|(face, _)| !faces.contains(face));
        erased.extend(lost.map(|(_, (name, _))| name.clone()));
        // What was made and let go again was never there.
        erased.retain(|name| !name.starts_with('k'));
        let new = self.items.iter().zip(&self.next);
        let new = new.filter(|(item, next)| item.face.is_none() && next.is_some());
        created.extend(new.map(|(item, _)| item.name.clone()));
        let is_new = |name: &&String| name.starts_with('k');
        created.extend(self.edges.iter().map(|(name, _)| name).filter(is_new).cloned());
        let mut vertices: Vec<_> = used.into_iter().filter(|name| name.starts_with('n')).collect();
        vertices.sort();
        vertices.dedup();
        let some = self.vertices.values().flatten().next()?;
        for vertex in &vertices {
            writeln!(text, "    {vertex}.position = {some}.position").expect("a string");
        }
        created.extend(vertices);
        let halves: Vec<_> = self.items.iter().filter(|item| item.face.is_none()).collect();
        erased.retain(|name| halves.iter().all(|item| item.name != *name));
        let list = |word: &str, names: &[String]| match names.is_empty() {
            true => String::new(),
            false => format!("    {word} {}\n", names.join(" ")),
        };
        let (created, erased) = (list("new", &created), list("erase", &erased));
        Some(format!("  after {{\n{created}{text}{erased}  }}\n}}\n"))
    }
}

/// `v0 -h3-> `
fn words(from: &str, item: &Item) -> String {
    let bar = if item.is_path { '=' } else { '-' };
    format!("{from} {bar}{}{bar}> ", item.name)
}
