//! Random keys of `drain`, under random writes, against all keys computed anew in each turn.
//!
//! A key goes along pointers, around orbits and through functions, reads attributes of all kinds
//! and asks questions; what the body writes is chosen as freely. If a key that changed were not
//! computed anew, elements would come in another order.

use super::drain::{Drained, forget_keys};
use super::*;
use hedgerow::mesh::{ElementKind, identical, shape};
use support::dice::Dice;

const PROGRAMS: u64 = 150;

const FUNCTIONS: &str = "
attr visits: edge int = 0
attr heat: vertex real = 1
attr way: vertex vec3 = vec3(0, 0, 0)
attr form: vertex mat3 = mat3(1)
attr tint: face vec2 = vec2(0, 1)
attr mark: halfedge bool = false

op open(f: face) {
  before { face f: v =P=> v }
  after  { hole f: v =P=> v }
}
op open_apart(f: face) {
  guard surface
  steps { must open(f) }
}
op turn(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
  }
}
op turn_simply(e: edge) {
  guard simple
  steps { must turn(e) }
}

fn around(v: vertex) -> real { sum(w.heat + 0.25 * degree(w) for w in v.neighbors) }
fn behind(h: halfedge) -> halfedge {
  var at = h.next
  if at.mark { at = at.twin.next } else { at = at.prev.twin }
  return at
}
fn hottest(f: face) -> vertex { argmax(v.heat for v in f.vertices) }
fn bend(e: edge) -> real { if boundary(e) { 0 } else { dihedral_angle(e) } }
fn walked(h: halfedge) -> real {
  var at = h
  var steps = 0.0
  while steps < 4 and not at.mark { at = at.next.twin  steps = steps + 1 }
  return steps + at.vertex.heat
}
fn down(v: vertex, n: int) -> real {
  if n == 0 { return v.heat }
  return v.heat + 0.5 * down(v.halfedge.target, n - 1)
}
";

/// Writes keys and bodies.
struct Writer(Dice);

use ElementKind::{Edge, Face, Halfedge, Vertex};

impl Writer {
    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.0.below(of.len())]
    }

    /// An element of a kind, up to four pointers away from another.
    fn element(&mut self, from: (&str, ElementKind), wanted: ElementKind) -> String {
        let (mut text, mut kind) = (from.0.to_owned(), from.1);
        let more = self.0.below(3);
        let mut steps = 0;
        while kind != wanted || steps < more {
            let pointer = match kind {
                Halfedge if steps >= more => match wanted {
                    Vertex => self.one(&["vertex", "target"]),
                    Edge => "edge",
                    _ => "face",
                },
                Halfedge => self.one(&["next", "prev", "twin", "twin", "vertex", "target", "edge"]),
                _ => "halfedge",
            };
            kind = match pointer {
                "vertex" | "target" => Vertex,
                "edge" => Edge,
                "face" => Face,
                _ => Halfedge,
            };
            text = format!("{text}.{pointer}");
            steps += 1;
        }
        text
    }

    /// What is read of an element, as a real.
    fn leaf(&mut self, from: (&str, ElementKind)) -> String {
        let kind = self.one(&ElementKind::ALL);
        let at = self.element(from, kind);
        let other = self.element(from, Vertex);
        match (kind, self.0.below(9)) {
            (Vertex, 0) => format!("{at}.position.x"),
            (Vertex, 1) => format!("{at}.heat"),
            (Vertex, 2) => format!("dot({at}.way, {at}.position)"),
            (Vertex, 3) => format!("({at}.form * vec3(1, 2, 3)).y"),
            (Vertex, 4) => format!("normal({at}).z"),
            (Vertex, 5) => format!("distance({at}, {other})"),
            (Vertex, 6) => format!("(if boundary({at}) {{ 3 }} else {{ 4 }})"),
            (Vertex, 7) => format!("(if adjacent({at}, {other}) {{ 0.5 }} else {{ 2 }})"),
            (Vertex, _) => format!("0.5 * degree({at})"),
            (Edge, 0 | 1) => format!("0.125 * {at}.visits"),
            (Edge, 2) => format!("bend({at})"),
            (Edge, 3) => format!("(if boundary({at}) {{ 1 }} else {{ length({at}) }})"),
            (Edge, 4) => format!("(if link_condition({at}) {{ 1 }} else {{ 2 }})"),
            (Edge, 5) => format!("(if star_shaped({at}) {{ 1 }} else {{ 2 }})"),
            (Edge, _) => format!("length({at})"),
            (Face, 0) => format!("area({at})"),
            (Face, 1) => format!("centroid({at}).y"),
            (Face, 2) => format!("normal({at}).x"),
            (Face, 3) => format!("{at}.tint.x"),
            (Face, 4) => format!("hottest({at}).heat"),
            (Face, _) => format!("0.25 * degree({at})"),
            (Halfedge, 0) => format!("angle({at})"),
            (Halfedge, 1 | 2) => format!("(if {at}.mark {{ 1 }} else {{ 0 }})"),
            (Halfedge, 3) => format!("length(behind({at}))"),
            (Halfedge, 4) if self.0.below(4) == 0 => format!("walked({at})"),
            (Halfedge, _) => format!("length({at})"),
        }
    }

    /// A real made of what lies around an element.
    fn value(&mut self, from: (&str, ElementKind), depth: usize) -> String {
        if depth == 0 {
            return self.leaf(from);
        }
        match self.0.below(8) {
            0 => {
                let v = self.element(from, Vertex);
                match self.0.below(3) {
                    0 => format!("down({v}, 2)"),
                    _ => format!("around({v})"),
                }
            }
            1 => {
                let [left, right] = [(); 2].map(|()| self.value(from, depth - 1));
                format!("({left} - 2 * {right})")
            }
            2 => {
                let [asked, then, otherwise] = [(); 3].map(|()| self.value(from, depth - 1));
                format!("(if {asked} < 1 {{ {then} }} else {{ {otherwise} }})")
            }
            3 | 4 => self.leaf(from),
            _ => self.aggregate(from, depth),
        }
    }

    fn aggregate(&mut self, from: (&str, ElementKind), depth: usize) -> String {
        let (around, sequence, each) = self.one(&[
            (Vertex, "halfedges", Halfedge),
            (Vertex, "edges", Edge),
            (Vertex, "faces", Face),
            (Vertex, "neighbors", Vertex),
            (Face, "halfedges", Halfedge),
            (Face, "vertices", Vertex),
            (Face, "edges", Edge),
            (Edge, "vertices", Vertex),
            (Edge, "faces", Face),
        ]);
        let base = self.element(from, around);
        let variable = self.one(&["p", "q"]);
        let variable = format!("{variable}{depth}");
        let body = self.value((&variable, each), depth - 1);
        let filter = match self.0.below(3) {
            0 => format!(" where {} < 2", self.leaf((&variable, each))),
            _ => String::new(),
        };
        match self.0.below(4) {
            0 => format!("0.5 * count({body} > 1 for {variable} in {base}.{sequence}{filter})"),
            1 => format!("max({body} for {variable} in {base}.{sequence})"),
            _ => format!("sum({body} for {variable} in {base}.{sequence}{filter})"),
        }
    }

    fn key(&mut self, kind: ElementKind) -> String {
        // What is short shows what is missed; what is long hides it behind all else it reads.
        let depth = self.one(&[0, 0, 1, 2]);
        let mut key = self.value(("x", kind), depth);
        match self.0.below(12) {
            0 => key = format!("{key} + pinned.heat + 0.5 * degree(pinned)"),
            1 | 3 => {
                let ops = [("flip", Edge), ("turn_simply", Edge), ("open_apart", Face)];
                let (op, of) = self.one(&ops);
                let at = self.element(("x", kind), of);
                key = format!("{key} + (if can {op}({at}) {{ 1 }} else {{ 0 }})");
            }
            2 => key = format!("{key} + 0.01 * count(edges)"),
            _ => {}
        }
        key
    }

    /// A write near an element that lives.
    fn write(&mut self, from: (&str, ElementKind)) -> String {
        let kind = self.one(&ElementKind::ALL);
        let at = self.element(from, kind);
        match (kind, self.0.below(5)) {
            (Vertex, 0) => format!("{at}.heat = {at}.heat * 0.75 + 0.1"),
            (Vertex, 1) => format!("{at}.way = {at}.way + vec3(0.1, 0, 0.2)"),
            (Vertex, 2) => format!("{at}.form = {at}.form * 1.5"),
            (Vertex, 3) => format!("for w in {at}.neighbors {{ w.heat = w.heat + 0.25 }}"),
            (Vertex, _) => format!(
                "update w in {at}.neighbors {{ w.position = mix(w.position, {at}.position, 0.2) }}"
            ),
            (Edge, _) => format!("{at}.visits = {at}.visits + 1"),
            (Face, _) => format!("{at}.tint = {at}.tint + vec2(0.3, 0.1)"),
            (Halfedge, _) => format!("{at}.mark = not {at}.mark"),
        }
    }

    fn body(&mut self, kind: ElementKind) -> String {
        let mut body = String::new();
        for _ in 0..self.0.below(3) {
            body += &self.write(("x", kind));
            body += "\n";
        }
        let e = self.element(("x", kind), Edge);
        let ops = self.one(&[
            "flip(e)",
            "split(e)",
            "collapse(e, 100.0)",
            "if turns mod 3 == 0 { collapse(e, 100.0) } else { if turns mod 3 == 1 { split(e) } else { flip(e) } }",
            "if turns mod 2 == 0 { flip(e) } else { collapse(e, 100.0) }",
            "if let m = split(e) { m.heat = 2 }",
            "open_apart(e.halfedge.face)",
            "if turns mod 2 == 0 { open_apart(e.halfedge.face) } else { turn_simply(e) }",
            "",
        ]);
        format!("{body} let e = {e}\n{ops}")
    }
}

#[test]
fn random_keys_are_as_if_all_were_computed_in_each_turn() {
    let meshes = [
        shape::icosphere(1),
        shape::triangle_grid(3, 3),
        shape::triangle_torus(4, 4),
        shape::octahedron(),
    ];
    let (mut turns, mut long, mut failed, mut walked) = (0, 0, 0, 0);
    for seed in 1..=PROGRAMS {
        let mut writer = Writer(Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15)));
        let kind = writer.one(&ElementKind::ALL);
        let (key, body) = (writer.key(kind), writer.body(kind));
        let case =
            Drained { elements: kind.plural(), key: &key, condition: "turns < 18", body: &body };
        let programs = [case.quick(), case.slow()].map(|text| {
            let first = "var turns = 0\nvar pinned = argmin(v.position.x for v in vertices)";
            let text = text.replacen("var turns = 0", first, 1);
            let (_, analysis) = analyse(&format!("{OPS}{FUNCTIONS}{text}"));
            let number = analysis.script("main").unwrap();
            prepare(&analysis.program, number, &analysis.plans).unwrap()
        });
        walked += usize::from(programs[0].drains().iter().all(|(_, why)| why.is_none()));
        for mesh in &meshes {
            let [(quick, after, lines), (slow, expected_after, expected)] =
                [&programs[0], &programs[1]].map(|program| {
                    let mut mesh = mesh.clone();
                    let mut lines = Lines::default();
                    let outcome = run(program, &mut mesh, &[], &mut lines);
                    forget_keys(&mut mesh);
                    (outcome, mesh, lines.0)
                });
            let first = lines.iter().zip(&expected).position(|(x, y)| x != y);
            assert_eq!(lines, expected, "seed {seed} differs at turn {first:?}: {case:?}");
            assert_eq!(quick.is_ok(), slow.is_ok(), "seed {seed}: {quick:?}, {slow:?}: {case:?}");
            turns += lines.len();
            long += usize::from(lines.len() > 15);
            failed += usize::from(quick.is_err());
            if let (Ok(report), Ok(expected_report)) = (quick, slow) {
                assert_eq!(report, expected_report, "seed {seed}: {case:?}");
                assert!(identical(&after, &expected_after), "seed {seed}: {case:?}");
            }
        }
    }
    println!("{turns} turns, {long} long, {failed} failed, {walked} of {PROGRAMS} walk back");
    assert!(turns > 3000 && long > 100 && failed < 60, "{turns}, {long}, {failed}");
    assert!(walked > 30 && walked < PROGRAMS as usize, "{walked}");
}
