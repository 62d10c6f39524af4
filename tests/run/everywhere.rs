//! Every op of the examples at every place of many meshes: the machine against the literal
//! reference.
//!
//! At each place the machine either refuses and leaves the mesh as it was, bit for bit, and
//! then the reference finds no match, or a `require` or `guard` said no; or it applies, the mesh passes
//! the validator, the counts change as the verdict says, and the result is that of a literal
//! rewrite of one of the matches that the reference finds, and is what `after` draws.
//!
//! On the two large meshes the validator runs at every place where `HEDGEROW_EVERYWHERE` is
//! set, otherwise at every 16th; the comparison with the reference, which covers every pointer
//! of a halfedge of the whole mesh, is made at every place.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use hedgerow::analysis::{Analysis, RuleVerdict, verdicts};
use hedgerow::check::Change;
use hedgerow::diagram::{Naming, Op, Rule, Type, Unrolled};
use hedgerow::mesh::{ElementKind, FaceId, Mesh, VertexId, read_mesh, shape, validate};
use hedgerow::rewrite::{Machine, Outcome, Phase, Plan};
use hedgerow::source::Sources;

use support::reference::examples::{elements, examples};
use support::reference::maps::{random_map, shuffle_pointers};
use support::reference::matching::{Match, bound_by, matches};
use support::reference::printing::mesh_text;
use support::reference::random::Random;
use support::reference::rewriting::rewrite;
use support::reference::same::{identical, same_positions, same_result};
use support::reference::truth::untrue;

/// An op of an example with all that is known of it.
struct Subject {
    name: String,
    op: Op,
    plan: Plan,
    rules: Vec<RuleVerdict>,
}

fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn subjects() -> Vec<Subject> {
    let mut subjects = Vec::new();
    for path in examples() {
        let text = std::fs::read_to_string(&path).expect("an example");
        let mut sources = Sources::new();
        let file = sources.add(path.display().to_string(), text);
        let analysis = Analysis::of(&sources, file);
        assert!(analysis.is_sound(), "{}: {:?}", path.display(), analysis.diagnostics);
        let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let verdicts = verdicts(&analysis);
        for (at, op) in analysis.program.ops.into_iter().enumerate() {
            subjects.push(Subject {
                name: format!("{stem}::{}", op.name),
                op: op.diagram.expect("a resolved op"),
                plan: analysis.plans[at].clone().expect("a proved op"),
                rules: verdicts[at].rules.clone(),
            });
        }
    }
    assert!(subjects.len() >= 9, "only {} ops", subjects.len());
    subjects
}

/// An alternative of an op as it is at some place: one with families is unrolled.
struct Alternative<'s> {
    rule: Cow<'s, Rule>,
    verdict: &'s RuleVerdict,
    size: i64,
}

impl Subject {
    /// The alternatives at a place. Families are as long as the orbit that is given, or a
    /// part of it.
    fn alternatives(&self, mesh: &Mesh, arguments: &[u32]) -> Vec<Alternative<'_>> {
        let mut alternatives = Vec::new();
        for (rule, verdict) in self.op.rules.iter().zip(&self.rules) {
            if !rule.has_families() {
                let rule = Cow::Borrowed(rule);
                alternatives.push(Alternative { rule, verdict, size: 0 });
                continue;
            }
            let long =
                self.op.params.iter().zip(arguments).map(|(param, &element)| match param.ty {
                    Type::Face => mesh.face_size(FaceId(element)),
                    Type::Vertex => mesh.degree(VertexId(element)),
                    _ => 1,
                });
            let long = long.max().unwrap_or(1);
            for size in (1..=long).filter(|size| long % size == 0) {
                let unrolled = Unrolled::new(rule, size as u32, Naming::Numbers);
                alternatives.push(Alternative {
                    rule: Cow::Owned(unrolled.rule),
                    verdict,
                    size: size as i64,
                });
            }
        }
        alternatives
    }
}

/// What became of the calls of one op.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    places: usize,
    applied: usize,
    no_match: usize,
    refused: usize,
}

/// Compares machine and reference at one place; `mesh` is afterwards as it was.
struct Comparison<'s> {
    subject: &'s Subject,
    machine: Machine,
    /// How often an applied op is followed by the validator: at every place, or every nth.
    validate_every: usize,
    tally: Tally,
}

impl<'s> Comparison<'s> {
    fn new(subject: &'s Subject, validate_every: usize) -> Self {
        let machine = Machine::default();
        Self { subject, machine, validate_every, tally: Tally::default() }
    }

    fn at(&mut self, original: &Mesh, mesh: &mut Mesh, arguments: &[u32]) {
        let Subject { name, op, plan, .. } = self.subject;
        let alternatives = self.subject.alternatives(original, arguments);
        let place = || format!("{name} at {arguments:?}");
        let mut slots: Vec<u64> = arguments.iter().map(|&element| u64::from(element)).collect();
        let values = op.params.iter().filter(|param| !param.ty.is_element());
        // The values of the examples are bounds that shall not matter here.
        slots.extend(values.map(|_| 1e9_f64.to_bits()));
        let found: Vec<Vec<Match>> = alternatives
            .iter()
            .map(|Alternative { rule, .. }| {
                matches(rule, original, &bound_by(rule, arguments), 10_000)
            })
            .collect();
        let any = found.iter().any(|matches| !matches.is_empty());
        self.tally.places += 1;
        let outcome = self.machine.apply(mesh, plan, &slots).expect("no trap");
        let Outcome::Applied { .. } = outcome else {
            assert!(identical(original, mesh), "{} is refused, but changes the mesh", place());
            let Outcome::Refused { reason: Some(reason) } = outcome else {
                panic!("{} is refused without a reason", place());
            };
            let refusal = &plan.refusals[usize::from(reason)];
            match refusal.phase {
                Phase::Match => {
                    assert!(!any, "{} matches, but is refused: {}", place(), refusal.reason);
                    self.tally.no_match += 1;
                }
                Phase::Require | Phase::Guard | Phase::Evaluate => {
                    assert!(any, "{} does not match, but is refused: {}", place(), refusal.reason);
                    self.tally.refused += 1;
                }
            }
            return;
        };
        self.tally.applied += 1;
        if self.tally.applied % self.validate_every == 1 % self.validate_every {
            assert_eq!(validate(mesh), Ok(()), "after {}", place());
        }
        // The first rule that matches and asks nothing is the last that can be the one.
        let mut agrees = false;
        for (alternative, found) in alternatives.iter().zip(&found) {
            let (rule, verdict) = (&*alternative.rule, alternative.verdict);
            let mut candidates: Vec<&Match> = found.iter().collect();
            if !asks(rule) && !found.is_empty() {
                let first = self.first_orientations(original, rule, found, arguments);
                if !first.is_empty() {
                    candidates = first;
                }
            }
            agrees = candidates.iter().any(|found| {
                let literal = rewrite(rule, original, found).expect("every name is bound");
                untrue(rule, &literal).is_none()
                    && same_result(original, mesh, &literal.mesh)
                    && (!literal.placed || same_positions(mesh, &literal.mesh))
            });
            if agrees {
                let loops = |by: Change| by.faces + by.holes + by.loops;
                let [once, each] = [verdict.change, verdict.per_index.unwrap_or_default()]
                    .map(|by| [by.vertices, by.edges, loops(by)]);
                let expected = [0, 1, 2].map(|at| once[at] + each[at] * alternative.size);
                assert_eq!(changes(original, mesh), expected);
                break;
            }
            if !asks(rule) && !found.is_empty() {
                break;
            }
        }
        assert!(
            agrees,
            "{}: the machine does something else than the reference on\n{}it makes\n{}where a literal rewrite makes\n{}",
            place(),
            mesh_text(original),
            mesh_text(mesh),
            alternatives
                .iter()
                .zip(&found)
                .flat_map(|(alternative, found)| found.iter().map(move |found| rewrite(
                    &alternative.rule,
                    original,
                    found
                )))
                .flatten()
                .map(|literal| mesh_text(&literal.mesh) + "or\n")
                .collect::<String>(),
        );
        *mesh = original.clone();
    }

    /// Of an edge parameter the orientation of its halfedge comes first: the matches that begin
    /// with it, if the first halfedge of its statement says which.
    fn first_orientations<'m>(
        &self,
        mesh: &Mesh,
        rule: &hedgerow::diagram::Rule,
        found: &'m [Match],
        arguments: &[u32],
    ) -> Vec<&'m Match> {
        let edge = rule.params.iter().zip(arguments).find_map(|(name, &element)| {
            let statement = rule.before.edges.iter().find(|edge| Some(edge.edge.name) == *name)?;
            Some((statement.halfedges[0].name, element))
        });
        let Some((half, edge)) = edge else {
            return Vec::new();
        };
        let first = mesh.edge_halfedge(hedgerow::mesh::EdgeId(edge)).0;
        found.iter().filter(|found| found.elements[half.index()] == Some(first)).collect()
    }
}

/// Whether a rule may refuse where it matches.
fn asks(rule: &hedgerow::diagram::Rule) -> bool {
    !rule.requires.is_empty() || rule.guard.is_some()
}

/// How the numbers of vertices, edges, and faces with holes have changed.
fn changes(before: &Mesh, after: &Mesh) -> [i64; 3] {
    let counts = |mesh: &Mesh| {
        [mesh.vertex_count(), mesh.edge_count(), mesh.face_count() + mesh.hole_count()]
            .map(|count| count as i64)
    };
    let (before, after) = (counts(before), counts(after));
    [0, 1, 2].map(|at| after[at] - before[at])
}

/// All choices of the elements an op is given. Values come after them in all examples.
fn places(mesh: &Mesh, op: &Op) -> Vec<Vec<u32>> {
    let mut places = vec![Vec::new()];
    for param in op.params.iter().filter(|param| param.ty.is_element()) {
        let elements = elements(mesh, param.ty);
        places = places
            .iter()
            .flat_map(|place| {
                elements.iter().map(|&element| [place.as_slice(), &[element]].concat())
            })
            .collect();
    }
    places
}

fn shapes() -> Vec<(&'static str, Mesh)> {
    vec![
        ("tetrahedron", shape::tetrahedron()),
        ("cube", shape::cube()),
        ("octahedron", shape::octahedron()),
        ("icosahedron", shape::icosahedron()),
        ("grid", shape::grid(3, 2)),
        ("torus", shape::torus(3, 3)),
        ("triangle torus", shape::triangle_torus(3, 4)),
        ("tube", shape::tube(4, 2)),
        ("fan", shape::fan(5)),
        ("triangle", shape::single_polygon(3)),
        ("pentagon", shape::single_polygon(5)),
        ("triangular pillow", shape::pillow(3)),
        ("pillow", shape::pillow(4)),
    ]
}

fn report(title: &str, tallies: &BTreeMap<String, Tally>) {
    println!("{title}");
    println!("  {:<36}{:>9}{:>9}{:>10}{:>9}", "op", "places", "applied", "no match", "refused");
    let mut total = Tally::default();
    for (name, tally) in tallies {
        let Tally { places, applied, no_match, refused } = tally;
        println!("  {name:<36}{places:>9}{applied:>9}{no_match:>10}{refused:>9}");
        total.places += places;
        total.applied += applied;
        total.no_match += no_match;
        total.refused += refused;
    }
    let Tally { places, applied, no_match, refused } = total;
    println!("  {:<36}{places:>9}{applied:>9}{no_match:>10}{refused:>9}", "all");
}

fn run(title: &str, meshes: &[(String, Mesh)]) {
    let mut tallies = BTreeMap::new();
    for subject in &subjects() {
        let mut comparison = Comparison::new(subject, 1);
        for (_, original) in meshes {
            let mut mesh = original.clone();
            for place in places(original, &subject.op) {
                comparison.at(original, &mut mesh, &place);
            }
        }
        tallies.insert(subject.name.clone(), comparison.tally);
    }
    report(title, &tallies);
    for (name, tally) in &tallies {
        assert!(tally.applied > 0, "{name} never applied");
    }
}

/// Named meshes, each as built and with other `halfedge` pointers.
#[test]
fn ops_do_what_is_drawn_on_small_meshes() {
    let mut random = Random::new(1);
    let mut meshes = Vec::new();
    for (name, mesh) in shapes() {
        for _ in 0..4 {
            let mut turned = mesh.clone();
            shuffle_pointers(&mut turned, &mut random);
            meshes.push((format!("{name}, turned"), turned));
        }
        meshes.push((name.to_string(), mesh));
    }
    run("named meshes", &meshes);
}

/// On maps where hardly anything is as one draws it.
#[test]
fn ops_do_what_is_drawn_on_random_maps() {
    let mut random = Random::new(2);
    let mut meshes: Vec<_> = (0..500)
        .map(|at| (format!("map {at}"), random_map(2 + 2 * random.below(7), &mut random)))
        .collect();
    // Random maps are too crooked for some ops; around these they are at home.
    for subject in &subjects() {
        for rule in &subject.op.rules {
            let sizes = if rule.has_families() { 1..=5 } else { 1..=1 };
            let unrolled: Vec<_> =
                sizes.map(|size| Unrolled::new(rule, size, Naming::Numbers).rule).collect();
            let mut turn = 0;
            let around = || {
                turn += 1;
                support::reference::completion::complete(
                    &unrolled[turn % unrolled.len()],
                    &mut random,
                )
            };
            let found = std::iter::repeat_with(around).take(40).flatten();
            let found: Vec<_> = found.map(|completion| completion.mesh).collect();
            meshes.extend(found.into_iter().map(|mesh| (format!("around {}", subject.name), mesh)));
        }
    }
    run("random maps", &meshes);
}

#[test]
fn ops_do_what_is_drawn_on_the_bunny() {
    large("examples/meshes/bunny.obj");
}

#[test]
fn ops_do_what_is_drawn_on_the_teapot() {
    large("examples/meshes/teapot.obj");
}

/// Every edge of a large mesh; of two parameters, every pair of halfedges of each face and
/// hole of few sides.
fn large(path: &str) {
    let original = read_mesh(&folder(path), None).expect("a mesh").mesh;
    let validate_every = if std::env::var_os("HEDGEROW_EVERYWHERE").is_some() { 1 } else { 16 };
    let mut tallies = BTreeMap::new();
    let mut mesh = original.clone();
    for subject in &subjects() {
        let mut comparison = Comparison::new(subject, validate_every);
        let elements_drawn = subject.op.params.iter().filter(|param| param.ty.is_element());
        match elements_drawn.count() {
            1 => {
                let families = subject.op.rules.iter().any(Rule::has_families);
                // Each of them rewrites the whole mesh many times.
                let step = if families { 7 } else { 1 };
                for place in places(&original, &subject.op).into_iter().step_by(step) {
                    comparison.at(&original, &mut mesh, &place);
                }
            }
            _ => {
                for face in original.faces().filter(|&f| original.face_size(f) <= 8).step_by(5) {
                    let around: Vec<_> = original.face_halfedges(face).map(|h| h.0).collect();
                    for &a in &around {
                        for &b in &around {
                            comparison.at(&original, &mut mesh, &[a, b]);
                        }
                    }
                }
            }
        }
        tallies.insert(subject.name.clone(), comparison.tally);
    }
    assert_eq!(original.count(ElementKind::Edge), mesh.count(ElementKind::Edge));
    report(path, &tallies);
    let applied: usize = tallies.values().map(|tally| tally.applied).sum();
    assert!(applied > original.edge_count(), "only {applied} applied");
}
