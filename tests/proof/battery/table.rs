//! The table of a run.

use std::collections::BTreeMap;

use crate::battery::judge::{BY_RULE, Judged, Meshes, Verdict};
use crate::battery::number;

pub fn report(judged: &[Judged]) {
    let accepted = judged.iter().filter(|judged| judged.verdict == Verdict::Accepted);
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
        let rule = if BY_RULE.contains(code) { "   by rule" } else { "" };
        println!(
            "    {code:<36}{broke:>7}{lied:>10}{unwritable:>12}{unmatched:>10}{survived:>10}{rule}"
        );
        (0..5).for_each(|at| total[at] += counts[at]);
    }
    let [broke, lied, unwritable, unmatched, survived] = total;
    println!("    {:<36}{broke:>7}{lied:>10}{unwritable:>12}{unmatched:>10}{survived:>10}", "all");
    println!("    matches rewritten literally         {rejected_runs:>7}");
    let slowest = judged.iter().max_by_key(|judged| judged.time).expect("some op");
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
