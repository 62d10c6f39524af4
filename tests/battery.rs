//! Does the prover tell the truth? Thousands of ops, most of them spoilt, each judged by the
//! checker and by what really happens to meshes.
//!
//! An op that the checker accepts must not break any mesh: not by the literal rewrite of any
//! match, nor by the machine, whose result must be that of a literal rewrite; and the result
//! must be what `after` draws. An op that it rejects must break one, or make something that
//! `after` does not draw, or match nowhere, or be rejected for saying too little or a thing
//! twice. The meshes are random completions of the drawing before, and random maps.
//!
//! `HEDGEROW_MUTANTS=20000 cargo test --release --test battery -- --nocapture` is the full
//! size; `HEDGEROW_SEED` gives other mutants.

mod reference;

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use hedgerow::analysis::Analysis;
use hedgerow::check::{Proved, check};
use hedgerow::compile::compile;
use hedgerow::diagram::{Op, Type};
use hedgerow::mesh::{Mesh, validate};
use hedgerow::resolve::resolve;
use hedgerow::rewrite::{Machine, Outcome, Plan};
use hedgerow::source::Sources;
use hedgerow::syntax::parse;

use reference::completion::complete;
use reference::maps::random_map;
use reference::matching::{bound_by, matches};
use reference::mutating::mutate;
use reference::printing::{mesh_text, op_text};
use reference::random::Random;
use reference::rewriting::rewrite;
use reference::same::{identical, same_result};
use reference::truth::untrue;

/// Codes of rejections that do not say that a mesh breaks: the op says too little, or says a
/// thing that nobody can follow, or leaves a vertex alone.
const BY_RULE: &[&str] = &[
    "adjacent-runs",
    "erased-and-drawn",
    "erased-run",
    "missing-attribute",
    "missing-reassignment",
    "new-loop-kind",
    "spoke-twice",
    "too-many-cases",
    "unaccounted-name",
    "unknown-name",
    "unplaced-halfedge",
    "unreachable-name",
    "vertex-without-spokes",
];

/// Ops that the examples lack: every kind of change of topology, drawn as plainly as possible.
const MORE_OPS: &str = "
op pendant(a: halfedge) {
  before { loop f: v0 -a-> v1 =P=> v0 }
  after {
    new m x y e
    loop f: v0 -x-> m -y-> v0 -a-> v1 =P=> v0
    edge e: x | y
    m.position = v0.position
  }
}

op remove_pendant(x: halfedge) {
  before {
    loop f: v0 -x-> m -y-> v0 =P=> v0
    edge e: x | y
  }
  after {
    loop f: v0 =P=> v0
    erase m x y e
  }
}

op split_any(e: edge) {
  before {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  after {
    new m p q k
    loop f0: v0 -a-> m -p-> v1 =P=> v0
    loop f1: v1 -d-> m -q-> v0 =Q=> v1
    edge e: a | q
    edge k: p | d
    m.position = v0.position
  }
}

op fill(h: halfedge) {
  before {
    hole f: v0 -h-> v1 =P=> v0
    edge k: h | x
    vertex v1: x
  }
  after {
    face f: v0 -h-> v1 =P=> v0
    edge k: h | x
  }
}

op split_vertex(a: halfedge, b: halfedge) {
  before {
    loop f: v -a-> w0 =P=> v
    loop g: v -b-> w1 =Q=> v
    vertex v: a *S b *T
  }
  after {
    new u x y e
    loop f: v -a-> w0 =P=> u -y-> v
    loop g: u -b-> w1 =Q=> v -x-> u
    edge e: x | y
    vertex u: *S b y
    vertex v: x *T a
    u.position = v.position
  }
}

op poke(f: face) {
  before { face f: v0 -a-> v1 -b-> v2 -c-> v0 }
  after {
    new m f1 f2 e0 e1 e2 a1 a2 b1 b2 c1 c2
    face f: v0 -a-> v1 -a1-> m -a2-> v0
    face f1: v1 -b-> v2 -b1-> m -b2-> v1
    face f2: v2 -c-> v0 -c1-> m -c2-> v2
    edge e0: c1 | a2
    edge e1: a1 | b2
    edge e2: b1 | c2
    m.position = v0.position
  }
}

op unpoke(m: vertex) {
  before {
    face f: v0 -a-> v1 -a1-> m -a2-> v0
    face f1: v1 -b-> v2 -b1-> m -b2-> v1
    face f2: v2 -c-> v0 -c1-> m -c2-> v2
    edge e0: c1 | a2
    edge e1: a1 | b2
    edge e2: b1 | c2
  }
  after {
    face f: v0 -a-> v1 -b-> v2 -c-> v0
    erase m f1 f2 e0 e1 e2 a1 a2 b1 b2 c1 c2
  }
}

op fill(h: halfedge) {
  before { hole f: v0 -h-> v1 =P=> v0 }
  after { face f: v0 -h-> v1 =P=> v0 }
}

op triangle_at(h: halfedge) {
  before { hole f: v0 -h-> v1 -i-> v2 =P=> v0 }
  after {
    new g x y e
    face g: v0 -h-> v1 -i-> v2 -x-> v0
    hole f: v0 -y-> v2 =P=> v0
    edge e: x | y
  }
}

op dissolve_any(e: edge) {
  before {
    loop f: v0 -a-> v1 =P=> v1 -d-> v0 =Q=> v0
    edge e: a | d
    vertex v1: *S d
  }
  after {
    loop f: v0 =P=> v0 =Q=> v0
    vertex v0: *S *
    erase v1 a d e
  }
}

op zip(a: halfedge, b: halfedge) {
  before {
    hole f: v0 -a-> v1 -b-> v2 =P=> v0
    edge e: a | a'
    edge k: b | b'
    vertex v2: b' *S
    vertex v0: a *T
  }
  after {
    hole f: v0 =P=> v0
    edge e: a' | b'
    vertex v0: *T b' *S
    vertex v1: a' *
    erase v2 a b k
  }
}

op unzip(e: edge) {
  before {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  after {
    new x y k h
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    hole h: v0 -x-> v1 -y-> v0
    edge e: a | y
    edge k: d | x
  }
}

op cut_in_four(a: halfedge, b: halfedge, c: halfedge) {
  before { face f: v0 -a-> v1 =P=> v2 -b-> v3 =Q=> v4 -c-> v5 =R=> v0 }
  after {
    new x1 x2 x3 y1 y2 y3 e1 e2 e3 g1 g2 g3
    face f: v0 -x1-> v2 -x2-> v4 -x3-> v0
    face g1: v0 -a-> v1 =P=> v2 -y1-> v0
    face g2: v2 -b-> v3 =Q=> v4 -y2-> v2
    face g3: v4 -c-> v5 =R=> v0 -y3-> v4
    edge e1: x1 | y1
    edge e2: x2 | y2
    edge e3: x3 | y3
  }
}

op split_vertex_of_three(a: halfedge, b: halfedge, c: halfedge) {
  before {
    loop f: v -a-> w0 =P=> v
    loop g: v -b-> w1 =Q=> v
    loop k: v -c-> w2 =R=> v
    vertex v: a *S b *T c *U
  }
  after {
    new u x y e
    loop f: v -a-> w0 =P=> u -y-> v
    loop g: u -b-> w1 =Q=> u
    loop k: u -c-> w2 =R=> v -x-> u
    edge e: x | y
    vertex u: *S b *T c y
    vertex v: x *U a
    u.position = v.position
  }
}

op strand(x: halfedge) {
  before {
    loop f: v0 -x-> m -y-> v0 =P=> v0
    edge e: x | y
    vertex m: y
  }
  after {
    loop f: v0 =P=> v0
    vertex m: *
    erase x y e
  }
}

op swap_ears(a: halfedge, b: halfedge) {
  before {
    loop f: v -a-> v =P=> v
    loop g: v -b-> v =Q=> v
  }
  after {
    loop f: v -b-> v =P=> v
    loop g: v -a-> v =Q=> v
  }
}

op turn(a: halfedge) {
  before {
    loop f: v0 -a-> v1 -b-> v2 =P=> v0
    edge e: a | a'
    edge k: b | b'
    vertex v1: a' *S b *T
  }
  after {
    loop f: v0 -a-> v1 -b-> v2 =P=> v0
    edge e: a | a'
    edge k: b | b'
    vertex v1: a' *S b *T
  }
}
";

/// The ops to start from: each rule of the examples by itself, without requirements.
fn bases() -> Vec<Op> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let entries = std::fs::read_dir(folder).expect("the examples");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "hedge")
    });
    paths.sort();
    let mut texts: Vec<_> = paths
        .iter()
        .map(|path| std::fs::read_to_string(path).expect("an example"))
        .collect();
    texts.push(MORE_OPS.to_string());
    let mut bases = Vec::new();
    let mut known = Vec::new();
    for text in texts {
        let mut sources = Sources::new();
        let file = sources.add("an example", text);
        let analysis = Analysis::of(&sources, file);
        assert!(
            !analysis.program.ops.is_empty(),
            "no ops: {:?}",
            analysis.diagnostics
        );
        for op in analysis.program.ops.into_iter().filter_map(|op| op.diagram) {
            // Families have a battery of their own.
            for rule in op.rules.iter().filter(|rule| !rule.has_families()) {
                let mut base = op.clone();
                let mut rule = rule.clone();
                rule.requires.clear();
                rule.result = None;
                let is_element = |at: usize| op.params[at].ty.is_element();
                let kept: Vec<_> = (0..op.params.len()).filter(|&at| is_element(at)).collect();
                base.params = kept.iter().map(|&at| op.params[at].clone()).collect();
                rule.params = kept.iter().map(|&at| rule.params[at]).collect();
                for (at, name) in rule.names.iter_mut().enumerate() {
                    if !name.named {
                        name.text = format!("W{at}");
                        name.named = true;
                    }
                }
                let text = op_text(&base, &rule);
                base.result = None;
                base.rules = vec![rule];
                if !known.contains(&text) {
                    known.push(text);
                    bases.push(base);
                }
            }
        }
    }
    assert!(bases.len() > 15, "only {} ops", bases.len());
    bases
}

/// An op read back from its text, so that it is one that a person could have written.
fn read_back(text: &str) -> Option<(Sources, Op)> {
    let mut sources = Sources::new();
    let file = sources.add("mutant", text);
    let parsed = parse(file, text);
    let mut resolved = resolve(&parsed.tree);
    let faulty = !parsed.diagnostics.is_empty()
        || resolved
            .diagnostics
            .iter()
            .any(|diagnostic| diagnostic.is_error());
    let op = resolved.program.ops.pop()?.diagram?;
    (!faulty).then_some((sources, op))
}

/// Where an op is tried.
struct Trial {
    mesh: Mesh,
    /// The elements given, each choice of them.
    places: Vec<Vec<u32>>,
}

/// Random maps that serve all mutants.
struct Pool {
    maps: Vec<Mesh>,
    completions: usize,
}

fn elements(mesh: &Mesh, ty: Type) -> Vec<u32> {
    match ty {
        Type::Vertex => mesh.vertices().map(|v| v.0).collect(),
        Type::Halfedge => mesh.halfedges().map(|h| h.0).collect(),
        Type::Edge => mesh.edges().map(|e| e.0).collect(),
        Type::Face => mesh.faces().map(|f| f.0).collect(),
        _ => Vec::new(),
    }
}

/// All choices of the elements given; of two or more only some.
fn places(op: &Op, mesh: &Mesh, random: &mut Random) -> Vec<Vec<u32>> {
    let choices: Vec<_> = op
        .params
        .iter()
        .map(|param| elements(mesh, param.ty))
        .collect();
    match choices.as_slice() {
        [only] => only.iter().map(|&element| vec![element]).collect(),
        many => {
            let mut pick = || {
                many.iter()
                    .map(|choice| random.pick(choice).copied())
                    .collect()
            };
            (0..12).filter_map(|_| pick()).collect()
        }
    }
}

impl Pool {
    fn new(maps: usize, completions: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let maps = (0..maps)
            .map(|_| random_map(2 + 2 * random.below(7), &mut random))
            .collect();
        Self { maps, completions }
    }

    /// The meshes on which an op is tried, one after the other.
    fn trials<'a>(
        &'a self,
        op: &'a Op,
        random: &'a mut Random,
    ) -> impl Iterator<Item = Trial> + 'a {
        let rule = &op.rules[0];
        (0..self.completions + self.maps.len()).filter_map(move |at| {
            if at >= self.completions {
                let mesh = self.maps[at - self.completions].clone();
                let places = places(op, &mesh, random);
                return Some(Trial { mesh, places });
            }
            let completion = complete(rule, random)?;
            let mut places = places(op, &completion.mesh, random);
            let meant = rule
                .params
                .iter()
                .map(|name| completion.elements[(*name)?.index()]);
            if let Some(meant) = meant.collect::<Option<Vec<_>>>() {
                // Where it is meant to match, and where it nearly does.
                if op.params.iter().all(|param| param.ty == op.params[0].ty) {
                    let turns = 1..op.params.len();
                    places.extend(turns.map(|turn| [&meant[turn..], &meant[..turn]].concat()));
                    let mut swapped = meant.clone();
                    swapped.swap(0, op.params.len() - 1);
                    places.push(swapped);
                }
                places.retain(|place| *place != meant);
                places.insert(0, meant);
            }
            Some(Trial {
                mesh: completion.mesh,
                places,
            })
        })
    }
}

/// What became of an op on meshes.
#[derive(Default)]
struct Experience {
    matches: usize,
    /// Matches whose rewrite needs a name that nothing binds.
    unwritable: usize,
    /// Rewrites that make something else than `after` draws.
    lies: usize,
    /// How many rewrites broke the mesh, and the smallest mesh.
    broken: usize,
    smallest: Option<(usize, String)>,
    /// Where machine and reference differ.
    differences: Vec<String>,
    applied: usize,
}

impl Experience {
    fn breaks(&mut self, mesh: &Mesh, place: &[u32], what: String) {
        self.broken += 1;
        let size = mesh.halfedge_count();
        if self
            .smallest
            .as_ref()
            .is_none_or(|(known, _)| size < *known)
        {
            let text = format!("at {place:?} of\n{}{what}", mesh_text(mesh));
            self.smallest = Some((size, text));
        }
    }
}

/// The most matches looked at in one place.
const MOST: usize = 200;

/// Rewrites literally at every match; with a plan the machine has to agree.
fn experience(op: &Op, plan: Option<&Plan>, trials: impl Iterator<Item = Trial>) -> Experience {
    let rule = &op.rules[0];
    let mut experience = Experience::default();
    let mut machine = Machine::new(&[]);
    for Trial { mesh, places } in trials {
        for place in places {
            let found = matches(rule, &mesh, &bound_by(rule, &place), MOST);
            let results: Vec<_> = found.iter().map(|at| rewrite(rule, &mesh, at)).collect();
            experience.matches += found.len();
            for result in &results {
                match result {
                    None => experience.unwritable += 1,
                    Some(result) => {
                        let becomes =
                            |what: &str| format!("becomes\n{}{what}\n", mesh_text(&result.mesh));
                        if let Err(invalid) = validate(&result.mesh) {
                            experience.breaks(&mesh, &place, becomes(&invalid.to_string()));
                        } else if let Some(untrue) = untrue(rule, result) {
                            experience.lies += 1;
                            if plan.is_some() {
                                experience.breaks(&mesh, &place, becomes(&untrue));
                            }
                        }
                    }
                }
            }
            let Some(plan) = plan else {
                if experience.broken > 0 {
                    return experience; // one is enough
                }
                continue;
            };
            let mut result = mesh.clone();
            let slots: Vec<_> = place.iter().map(|&element| u64::from(element)).collect();
            let outcome = machine.apply(&mut result, plan, &slots);
            let difference = match outcome {
                Ok(Outcome::Applied { .. }) => {
                    experience.applied += 1;
                    if let Err(invalid) = validate(&result) {
                        let what = format!("the machine makes\n{}{invalid}\n", mesh_text(&result));
                        experience.breaks(&mesh, &place, what);
                    }
                    let mut literals = results.iter().flatten().map(|literal| &literal.mesh);
                    let agrees = literals.any(|literal| same_result(&mesh, &result, literal));
                    match found.len() {
                        0 => Some("the machine applies where nothing matches"),
                        MOST => None,
                        _ => (!agrees).then_some("the machine makes another mesh"),
                    }
                }
                Ok(Outcome::Refused { .. }) if !identical(&mesh, &result) => {
                    Some("the machine refuses and changes the mesh")
                }
                Ok(Outcome::Refused { .. }) if !found.is_empty() => {
                    Some("the machine refuses where the drawing matches")
                }
                Ok(Outcome::Refused { .. }) => None,
                Err(_) => Some("the machine traps"),
            };
            if let Some(difference) = difference {
                let size = mesh.halfedge_count();
                let before = mesh_text(&mesh);
                let after = mesh_text(&result);
                let text = format!(
                    "{difference}: at {place:?} of ({size} halfedges)\n{before}it makes\n{after}"
                );
                experience.differences.push(text);
            }
        }
    }
    experience
}

/// What the checker said of a mutant, and what the meshes said.
struct Judged {
    text: String,
    verdict: Verdict,
    matches: usize,
    applied: usize,
    /// How long the checker took.
    time: Duration,
    complaints: Vec<String>,
}

impl Judged {
    /// Whether it was rejected for breaking meshes, and breaks none.
    fn is_unfounded(&self) -> bool {
        let Verdict::Rejected(code, meshes) = self.verdict else {
            return false;
        };
        meshes == Meshes::Survived && !BY_RULE.contains(&code)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Accepted,
    /// By its code, and whether a mesh broke.
    Rejected(&'static str, Meshes),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Meshes {
    Broke,
    /// No mesh broke, but it was not what `after` draws.
    Lied,
    /// The rewrite cannot even be carried out.
    Unwritable,
    NeverMatched,
    Survived,
}

fn judge(text: String, pool: &Pool, random: &mut Random) -> Option<Judged> {
    let (sources, op) = read_back(&text)?;
    let start = Instant::now();
    let checked = catch_unwind(AssertUnwindSafe(|| check(&op)));
    let time = start.elapsed();
    let mut judged = Judged {
        text,
        verdict: Verdict::Accepted,
        matches: 0,
        applied: 0,
        time,
        complaints: Vec::new(),
    };
    let Ok(checked) = checked else {
        judged.complaints.push("the checker panics".into());
        return Some(judged);
    };
    match checked {
        Ok(proved) => accepted(&proved, &sources, pool, random, &mut judged),
        Err(diagnostics) => {
            let code = diagnostics
                .first()
                .map_or("none", |diagnostic| diagnostic.code);
            let experience = experience(&op, None, pool.trials(&op, random));
            judged.matches = experience.matches;
            let meshes = if experience.broken > 0 {
                Meshes::Broke
            } else if experience.lies > 0 {
                Meshes::Lied
            } else if experience.unwritable > 0 {
                Meshes::Unwritable
            } else if experience.matches == 0 {
                Meshes::NeverMatched
            } else {
                Meshes::Survived
            };
            judged.verdict = Verdict::Rejected(code, meshes);
        }
    }
    Some(judged)
}

fn accepted(
    proved: &Proved,
    sources: &Sources,
    pool: &Pool,
    random: &mut Random,
    judged: &mut Judged,
) {
    let op = proved.op();
    let run = catch_unwind(AssertUnwindSafe(|| {
        let plan = compile(proved, sources, &Arc::default()).expect("a small op");
        experience(op, Some(&plan), pool.trials(op, random))
    }));
    let Ok(experience) = run else {
        judged
            .complaints
            .push("compiling or running it panics".into());
        return;
    };
    judged.matches = experience.matches;
    judged.applied = experience.applied;
    if let Some((_, smallest)) = experience.smallest {
        let times = experience.broken;
        judged
            .complaints
            .push(format!("accepted, but breaks {times} meshes: {smallest}"));
    }
    let smallest = experience.differences.into_iter().min_by_key(String::len);
    judged.complaints.extend(smallest);
}

/// A mutant of one of the bases: one to four changes.
fn mutant(bases: &[Op], random: &mut Random) -> Option<String> {
    let mut op = random.pick(bases)?.clone();
    let changes = 1 + random.below(4).min(random.below(4));
    let mut done = 0;
    for _ in 0..40 {
        let mut changed = op.clone();
        if mutate(&mut changed, random).is_some() {
            op = changed;
            done += 1;
        }
        if done == changes {
            return Some(op_text(&op, &op.rules[0]));
        }
    }
    None
}

fn number(variable: &str, default: usize) -> usize {
    let value = std::env::var(variable).ok();
    value.map_or(default, |value| value.parse().expect("a number"))
}

#[test]
fn the_prover_tells_the_truth() {
    let wanted = number("HEDGEROW_MUTANTS", 2_000);
    let seed = number("HEDGEROW_SEED", 0) as u64;
    let bases = bases();
    let pool = Pool::new(120, 60, seed);
    let mut judged: Vec<Judged> = Vec::new();
    for base in &bases {
        let mut random = Random::new(seed);
        let text = op_text(base, &base.rules[0]);
        judged.push(judge(text.clone(), &pool, &mut random).unwrap_or_else(|| panic!("{text}")));
    }
    let sound = judged
        .iter()
        .filter(|judged| judged.verdict == Verdict::Accepted)
        .count();
    println!("{sound} of {} ops to start from are accepted", judged.len());
    if std::env::var_os("HEDGEROW_SURVIVORS").is_some() {
        for judged in judged
            .iter()
            .filter(|judged| judged.verdict != Verdict::Accepted)
        {
            println!("{:?} {}", judged.verdict, judged.text);
        }
    }
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    // Panics are caught and counted; their traces would drown the table.
    std::panic::set_hook(Box::new(|_| {}));
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads)
            .map(|worker| {
                let (bases, pool) = (&bases, &pool);
                scope.spawn(move || {
                    let numbers = (worker..).step_by(threads);
                    let judge_one = |number: usize| {
                        let mut random =
                            Random::new(seed.wrapping_mul(1 << 32) + number as u64 + 1);
                        judge(mutant(bases, &mut random)?, pool, &mut random)
                    };
                    let share = wanted / threads + usize::from(worker < wanted % threads);
                    numbers
                        .filter_map(judge_one)
                        .take(share)
                        .collect::<Vec<_>>()
                })
            })
            .collect();
        judged.extend(
            workers
                .into_iter()
                .flat_map(|worker| worker.join().expect("a worker")),
        );
    });
    let _ = std::panic::take_hook();
    report(&judged);
    let complaints: Vec<_> = judged
        .iter()
        .filter(|judged| !judged.complaints.is_empty())
        .map(|judged| format!("{}{}\n", judged.text, judged.complaints.join("\n")))
        .collect();
    let shown = complaints
        .iter()
        .take(number("HEDGEROW_SHOW", 5))
        .cloned()
        .collect::<Vec<_>>();
    assert!(
        complaints.is_empty(),
        "{} complaints:\n{}",
        complaints.len(),
        shown.join("\n")
    );
    let matches: usize = judged.iter().map(|judged| judged.matches).sum();
    assert!(
        matches > 50 * wanted,
        "only {matches} matches: that proves nothing"
    );
    let unfounded: Vec<_> = judged
        .iter()
        .filter(|judged| judged.is_unfounded())
        .collect();
    for judged in &unfounded {
        println!("{:?}, but no mesh breaks:\n{}", judged.verdict, judged.text);
    }
    // A drawing may imply more than the checker sees, but next to none does.
    assert!(
        unfounded.len() * 5000 <= judged.len(),
        "{} rejections that no mesh bears out",
        unfounded.len()
    );
}

fn report(judged: &[Judged]) {
    let accepted = judged
        .iter()
        .filter(|judged| judged.verdict == Verdict::Accepted);
    let (mut sound, mut unmatched, mut applied, mut runs) = (0, 0, 0, 0);
    for judged in accepted {
        sound += usize::from(judged.complaints.is_empty());
        unmatched += usize::from(judged.matches == 0);
        applied += judged.applied;
        runs += judged.matches;
    }
    let mut texts: Vec<_> = judged
        .iter()
        .filter(|judged| judged.verdict == Verdict::Accepted)
        .map(|judged| judged.text.as_str())
        .collect();
    texts.sort();
    texts.dedup();
    let different = texts.len();
    let mut codes: BTreeMap<&str, [usize; 5]> = BTreeMap::new();
    let mut examples: BTreeMap<&str, Vec<&Judged>> = BTreeMap::new();
    let mut rejected_runs = 0;
    for judged in judged {
        if let Verdict::Rejected(code, meshes) = judged.verdict {
            codes.entry(code).or_default()[meshes as usize] += 1;
            rejected_runs += judged.matches;
            if meshes == Meshes::Survived {
                examples.entry(code).or_default().push(judged);
            }
        }
    }
    let all = judged.len();
    println!("{all} ops");
    println!(
        "  accepted and sound on every mesh      {sound:>7}   ({different} different; {unmatched} matched nowhere)"
    );
    println!("    matches rewritten literally         {runs:>7}");
    println!("    applied by the machine              {applied:>7}");
    println!(
        "  rejected, by code                       broke      lied  unwritable  no match  survived"
    );
    let mut total = [0; 5];
    for (code, counts) in &codes {
        let [broke, lied, unwritable, unmatched, survived] = counts;
        let rule = if BY_RULE.contains(code) {
            "   by rule"
        } else {
            ""
        };
        println!(
            "    {code:<36}{broke:>7}{lied:>10}{unwritable:>12}{unmatched:>10}{survived:>10}{rule}"
        );
        (0..5).for_each(|at| total[at] += counts[at]);
    }
    let [broke, lied, unwritable, unmatched, survived] = total;
    println!(
        "    {:<36}{broke:>7}{lied:>10}{unwritable:>12}{unmatched:>10}{survived:>10}",
        "all"
    );
    println!("    matches rewritten literally         {rejected_runs:>7}");
    let slowest = judged
        .iter()
        .max_by_key(|judged| judged.time)
        .expect("some op");
    println!("  slowest proof: {} ms", slowest.time.as_millis());
    if std::env::var_os("HEDGEROW_SURVIVORS").is_some() {
        println!("slowest:\n{}", slowest.text);
        for (code, judged) in examples {
            let shortest = {
                let mut all = judged;
                all.sort_by_key(|judged| judged.text.len());
                all
            };
            for judged in shortest.iter().take(number("HEDGEROW_SURVIVORS", 1)) {
                println!(
                    "rejected as {code}, but no mesh breaks ({} matches):\n{}",
                    judged.matches, judged.text
                );
            }
        }
    }
}
