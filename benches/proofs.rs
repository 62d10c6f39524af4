//! The time that the checker takes for each op of the examples and of the library.
//!
//!     cargo bench --bench proofs
//!
//! The best of several rounds counts. Also printed: the number of tests that keep names distinct,
//! and the number of pairs of names of one kind; the drawing implies the rest.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use hedgerow::analysis::Analysis;
use hedgerow::check::matching::{Claim, Step};
use hedgerow::check::{Proved, check};
use hedgerow::diagram::{Kind, NameId, Op, Rule};
use hedgerow::source::Sources;

const ROUNDS: usize = 15;

/// The longest delay that is not noticeable while typing.
const LIMIT: Duration = Duration::from_millis(5);

fn main() {
    let mut lines = Vec::new();
    for path in programs() {
        let mut sources = Sources::new();
        let text = std::fs::read_to_string(&path).expect("a program");
        let file = sources.add(path.display().to_string(), text);
        let stem = path.file_stem().expect("a name").to_string_lossy();
        let analysis = Analysis::of(&sources, file);
        for op in analysis.program.ops.iter().filter_map(|op| op.diagram.as_ref()) {
            let (time, proved) = time(op);
            let (made, pairs) = tests(&proved);
            lines.push((time, format!("{stem}::{}", op.name), made, pairs));
        }
    }
    lines.sort_by_key(|&(time, ..)| std::cmp::Reverse(time));
    println!("{} ops, best of {ROUNDS} rounds", lines.len());
    println!("{:<36}{:>10}{:>22}", "", "ms", "tests of pairs");
    for (time, name, made, pairs) in &lines {
        let ms = time.as_secs_f64() * 1e3;
        println!("{name:<36}{ms:>10.3}{made:>12} of {pairs}");
    }
    let all = |count: fn(&(Duration, String, usize, usize)) -> usize| {
        lines.iter().map(count).sum::<usize>()
    };
    let late = lines.iter().filter(|(time, ..)| *time > LIMIT).count();
    println!("{late} take more than {} ms", LIMIT.as_millis());
    println!("{} tests of {} pairs", all(|line| line.2), all(|line| line.3));
}

fn programs() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = ["examples", "src/library/std"].map(|folder| root.join(folder));
    let files = folders.iter().flat_map(|folder| {
        let entries = std::fs::read_dir(folder).expect("a folder");
        entries.map(|entry| entry.expect("an entry").path())
    });
    let is_program = |path: &PathBuf| path.extension().is_some_and(|end| end == "hedge");
    let mut programs: Vec<_> = files.filter(is_program).collect();
    programs.sort();
    programs
}

fn time(op: &Op) -> (Duration, Proved) {
    let proved = check(op).expect("a proved op");
    let round = |_| {
        let start = Instant::now();
        black_box(check(black_box(op)).is_ok());
        start.elapsed()
    };
    let best = (0..ROUNDS).map(round).min();
    (best.expect("a round"), proved)
}

/// The number of tests that keep names distinct, and of pairs of names of one kind in `before`.
fn tests(proved: &Proved) -> (usize, usize) {
    let (mut made, mut pairs) = (0, 0);
    for (rule, proof) in proved.op().rules.iter().zip(proved.proofs()) {
        let apart =
            |step: &&Step| matches!(step, Step::Test(Claim::Distinct(..) | Claim::AllDistinct(_)));
        made += proof.matching().iter().filter(apart).count();
        pairs += pairs_of(rule);
    }
    (made, pairs)
}

fn pairs_of(rule: &Rule) -> usize {
    let drawn = |kind: Kind| {
        let created = |name: NameId| rule.created.iter().any(|new| new.name == name);
        let count = rule.names_of(kind).filter(|&name| !created(name)).count();
        count * count.saturating_sub(1) / 2
    };
    let kinds = [Kind::Vertex, Kind::Halfedge, Kind::Edge, Kind::Face];
    kinds.into_iter().map(drawn).sum()
}
