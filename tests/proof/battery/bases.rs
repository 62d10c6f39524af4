//! The ops to start from, and their mutants.

use hedgerow::analysis::Analysis;
use hedgerow::diagram::Op;
use hedgerow::resolve::resolve;
use hedgerow::source::Sources;
use hedgerow::syntax::parse;

use support::reference::examples::{alone, examples};
use support::reference::mutating::mutate;
use support::reference::mutating_families::mutate_family;
use support::reference::printing::op_text;
use support::reference::random::Random;

/// What the examples lack.
const MORE: &str = include_str!("more.hedge");

/// Families that the examples lack.
const MORE_FAMILIES: &str = include_str!("../families/more.hedge");

/// Unusual ops that are right.
const ODD: &str = include_str!("odd.hedge");

/// Unusual ops that are wrong.
const WRONG: &str = include_str!("wrong.hedge");

/// The rules without families.
pub fn plain() -> Vec<Op> {
    let mut bases = bases();
    bases.retain(|op| !op.rules[0].has_families());
    assert!(bases.len() > 15, "only {} ops", bases.len());
    bases
}

/// The rules with families.
pub fn with_families() -> Vec<Op> {
    let mut bases = bases();
    bases.retain(|op| op.rules[0].has_families());
    assert!(bases.len() > 8, "only {} ops", bases.len());
    bases
}

/// Unusual ops, with and without families, that are right.
pub fn odd() -> Vec<Op> {
    rules_of(&[ODD.to_owned()])
}

/// The same, but wrong.
pub fn wrong() -> Vec<Op> {
    rules_of(&[WRONG.to_owned()])
}

/// The ops to start from.
fn bases() -> Vec<Op> {
    let mut texts: Vec<_> =
        examples().iter().map(|path| std::fs::read_to_string(path).expect("an example")).collect();
    texts.extend([MORE, MORE_FAMILIES, ODD].map(str::to_owned));
    rules_of(&texts)
}

/// Each rule of some programs by itself, without requirements.
fn rules_of(texts: &[String]) -> Vec<Op> {
    let mut bases = Vec::new();
    let mut known = Vec::new();
    for text in texts {
        let mut sources = Sources::new();
        let file = sources.add("an example", text.clone());
        let analysis = Analysis::of(&sources, file);
        assert!(!analysis.program.ops.is_empty(), "no ops: {:?}", analysis.diagnostics);
        for op in analysis.program.ops {
            let op = op.diagram.unwrap_or_else(|| panic!("{} is not understood", op.name));
            for rule in &op.rules {
                let base = alone(&op, rule);
                let text = op_text(&base, &base.rules[0]);
                if !known.contains(&text) {
                    known.push(text);
                    bases.push(base);
                }
            }
        }
    }
    bases
}

/// An op read back from its text, so that it is one that a person could have written.
pub fn read_back(text: &str) -> Option<(Sources, Op)> {
    let mut sources = Sources::new();
    let file = sources.add("mutant", text);
    let parsed = parse(file, text);
    let mut resolved = resolve(&parsed.tree);
    let faulty = !parsed.diagnostics.is_empty()
        || resolved.diagnostics.iter().any(|diagnostic| diagnostic.is_error());
    let op = resolved.program.ops.pop()?.diagram?;
    (!faulty).then_some((sources, op))
}

/// A mutant of one of the bases: one to four changes.
pub fn mutant(bases: &[Op], random: &mut Random) -> Option<String> {
    let mut op = random.pick(bases)?.clone();
    let changes = 1 + random.below(4).min(random.below(4));
    let mut done = 0;
    for _ in 0..40 {
        let mut changed = op.clone();
        let mutated = match changed.rules[0].has_families() && random.once_in(2) {
            true => mutate_family(&mut changed.rules[0], random),
            false => mutate(&mut changed, random),
        };
        if mutated.is_some() {
            op = changed;
            done += 1;
        }
        if done == changes {
            return Some(op_text(&op, &op.rules[0]));
        }
    }
    None
}
