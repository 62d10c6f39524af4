//! Does the prover tell the truth? Thousands of ops, most of them spoilt, each judged by the
//! checker and by what really happens to meshes.
//!
//! An op that the checker accepts must not break any mesh: not by the literal rewrite of any
//! match, nor by the machine, whose result must be that of a literal rewrite; and the result
//! must be what `after` draws, and have the properties that the checker says are kept. An op that it rejects must break one, or make something that
//! `after` does not draw, or match nowhere, or be rejected for saying too little or a thing
//! twice. The meshes are random completions of the drawing before, and random maps. Some let names
//! be one, by an `alias`; others are not spoilt but drawn out of random maps. What is accepted is
//! emitted as C++ besides, a sample of it, which has to do what the machine does.
//!
//! `HEDGEROW_MUTANTS=20000 cargo test --release --test proof battery -- --nocapture` is the full
//! size; `HEDGEROW_SEED` gives other mutants, `HEDGEROW_EMITTED` is how many are emitted.

mod bases;
mod drawn;
mod emitted;
mod experience;
mod given;
mod judge;
mod kept;
mod table;
mod trial;

use bases::mutant;
use drawn::drawn;
use hedgerow::diagram::Op;
use judge::{Judged, Meshes, Verdict, judge};
use support::reference::printing::op_text;
use support::reference::random::Random;
use table::report;
use trial::Pool;

fn number(variable: &str, default: usize) -> usize {
    let value = std::env::var(variable).ok();
    value.map_or(default, |value| value.parse().expect("a number"))
}

#[test]
fn the_prover_tells_the_truth() {
    let wanted = number("HEDGEROW_MUTANTS", 2_000);
    let judged = battery(&bases::plain(), wanted);
    let [of_aliases, unfounded] = unfounded(&judged);
    // A drawing may imply more than the checker sees, but next to none does.
    assert!(unfounded * 5000 <= judged.len(), "{unfounded} rejections that no mesh bears out");
    // What holds only where names are one is not drawn with two, and random meshes seldom have
    // names that are one just so.
    assert!(of_aliases * 50 <= judged.len(), "{of_aliases} with an `alias` that none bears out");
    assert!(without_witness(&judged) * 20 <= judged.len());
}

/// A tenth as many, since each is written out for cycles of several sizes.
#[test]
fn the_prover_tells_the_truth_of_families() {
    let wanted = number("HEDGEROW_MUTANTS", 2_000) / 10;
    let judged = battery(&bases::with_families(), wanted);
    let unfounded: usize = unfounded(&judged).iter().sum();
    assert!(unfounded * 100 <= judged.len(), "{unfounded} rejections that no mesh bears out");
    assert!(without_witness(&judged) * 20 <= judged.len());
}

/// A person has thought about these: each is unusual in its own way, right or wrong by a little.
#[test]
fn unusual_ops_are_told_apart() {
    let pool = Pool::new(200, 200, 1);
    let judged = |op: &Op| {
        let text = op_text(op, &op.rules[0]);
        judge(text.clone(), &pool, None, &mut Random::new(1)).unwrap_or_else(|| panic!("{text}"))
    };
    let mut untold = Vec::new();
    let (odd, wrong) = (bases::odd(), bases::wrong());
    for op in &odd {
        let judged = judged(op);
        let is_right = judged.verdict == Verdict::Accepted && judged.complaints.is_empty();
        if !is_right || judged.applied == 0 {
            untold.push(judged);
        }
    }
    for op in &wrong {
        let judged = judged(op);
        println!("{}: {:?}", op.name, judged.verdict);
        if !matches!(judged.verdict, Verdict::Rejected(_, Meshes::Broke | Meshes::Lied)) {
            untold.push(judged);
        }
    }
    for judged in &untold {
        println!("{:?} {}{}", judged.verdict, judged.text, judged.complaints.join("\n"));
    }
    assert!(untold.is_empty(), "{} ops are judged wrongly", untold.len());
    assert!(odd.len() > 18 && wrong.len() > 18);
}

/// Judges ops and their mutants; what is accepted must be sound.
fn battery(bases: &[Op], wanted: usize) -> Vec<Judged> {
    let seed = number("HEDGEROW_SEED", 0) as u64;
    let pool = Pool::new(120, 60, seed);
    let mut judged: Vec<Judged> = Vec::new();
    for base in bases {
        let mut random = Random::new(seed);
        let text = op_text(base, &base.rules[0]);
        let one = judge(text.clone(), &pool, None, &mut random);
        judged.push(one.unwrap_or_else(|| panic!("{text}")));
    }
    let sound = judged.iter().filter(|judged| judged.verdict == Verdict::Accepted).count();
    println!("{sound} of {} ops to start from are accepted", judged.len());
    if std::env::var_os("HEDGEROW_SURVIVORS").is_some() {
        for judged in judged.iter().filter(|judged| judged.verdict != Verdict::Accepted) {
            println!("{:?} {}", judged.verdict, judged.text);
        }
    }
    judged.extend(in_parallel(wanted, seed, &|random| {
        judge(mutant(bases, random)?, &pool, None, random)
    }));
    all_are_sound(&judged, &pool, seed);
    let matches: usize = judged.iter().map(|judged| judged.matches).sum();
    assert!(matches > 50 * wanted, "only {matches} matches: that proves nothing");
    judged
}

/// Judges so many ops, each by a random number of its own.
fn in_parallel(
    wanted: usize,
    seed: u64,
    judge_one: &(dyn Fn(&mut Random) -> Option<Judged> + Sync),
) -> Vec<Judged> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    // Panics are caught and counted; their traces would drown the table.
    std::panic::set_hook(Box::new(|_| {}));
    let mut judged = Vec::new();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads)
            .map(|worker| {
                scope.spawn(move || {
                    let numbers = (worker..).step_by(threads);
                    let judge_one = |number: usize| {
                        judge_one(&mut Random::new(seed.wrapping_mul(1 << 32) + number as u64 + 1))
                    };
                    let share = wanted / threads + usize::from(worker < wanted % threads);
                    numbers.filter_map(judge_one).take(share).collect::<Vec<_>>()
                })
            })
            .collect();
        judged.extend(workers.into_iter().flat_map(|worker| worker.join().expect("a worker")));
    });
    let _ = std::panic::take_hook();
    judged
}

/// What is accepted breaks nothing, by the machine and emitted.
fn all_are_sound(judged: &[Judged], pool: &Pool, seed: u64) {
    report(judged);
    let mut complaints: Vec<_> = judged
        .iter()
        .filter(|judged| !judged.complaints.is_empty())
        .map(|judged| format!("{}{}\n", judged.text, judged.complaints.join("\n")))
        .collect();
    complaints.sort_by_key(String::len);
    let shown = complaints.iter().take(number("HEDGEROW_SHOW", 5)).cloned().collect::<Vec<_>>();
    assert!(complaints.is_empty(), "{} complaints:\n{}", complaints.len(), shown.join("\n"));
    let accepted = judged.iter().filter(|it| it.verdict == Verdict::Accepted && it.applied > 0);
    let mut texts: Vec<_> = accepted.map(|judged| judged.text.as_str()).collect();
    texts.sort_unstable();
    texts.dedup();
    let step = texts.len().div_ceil(number("HEDGEROW_EMITTED", 40)).max(1);
    let sample: Vec<_> = texts.into_iter().step_by(step).collect();
    emitted::do_what_the_machine_does(&sample, pool, seed);
}

/// Whatever can be drawn in a map can be an op.
#[test]
fn the_prover_tells_the_truth_of_what_maps_show() {
    let wanted = number("HEDGEROW_MUTANTS", 2_000) / 4;
    let seed = number("HEDGEROW_SEED", 0) as u64;
    let pool = Pool::new(60, 30, seed);
    let judged = in_parallel(wanted, seed, &|random| {
        let drawn = drawn(random)?;
        judge(drawn.text, &pool, Some(&drawn.home), random)
    });
    all_are_sound(&judged, &pool, seed);
    let accepted: Vec<_> = judged.iter().filter(|it| it.verdict == Verdict::Accepted).collect();
    let with_alias = accepted.iter().filter(|it| it.text.contains("alias"));
    let (all, with_alias) = (accepted.len(), with_alias.count());
    println!("{all} of {} are accepted, {with_alias} of them with an `alias`", judged.len());
    assert!(all * 8 > judged.len() && with_alias * 80 > judged.len());
    let unfounded: usize = unfounded(&judged).iter().sum();
    assert!(unfounded * 100 <= judged.len(), "{unfounded} rejections that no mesh bears out");
    assert!(without_witness(&judged) * 20 <= judged.len());
}

/// How many ops were rejected by a law, break a mesh, and come without one; tells some.
fn without_witness(judged: &[Judged]) -> usize {
    let mut without: Vec<_> = judged.iter().filter(|judged| judged.lacks_a_witness()).collect();
    without.sort_by_key(|judged| judged.text.len());
    let broken = judged.iter().filter(|judged| judged.breaks_by_a_law()).count();
    println!("{} of {broken} that break a mesh come without one", without.len());
    for judged in without.iter().take(number("HEDGEROW_SHOW", 0)) {
        println!("{:?}, and no mesh is shown:\n{}", judged.verdict, judged.text);
    }
    without.len()
}

/// How many ops were rejected for breaking meshes that break none, those with an `alias` first;
/// tells each.
fn unfounded(judged: &[Judged]) -> [usize; 2] {
    let unfounded = judged.iter().filter(|judged| judged.is_unfounded());
    let unfounded = unfounded.inspect(|judged| {
        println!("{:?}, but no mesh breaks:\n{}", judged.verdict, judged.text);
    });
    let of_alias = |judged: &&Judged| judged.text.contains("  alias ");
    let (aliases, others): (Vec<_>, Vec<_>) = unfounded.partition(of_alias);
    [aliases.len(), others.len()]
}
