//! The published drawings are accepted as printed, and each with one thing wrong is refused.
//!
//! A mutant is the text with one mention of a name replaced by another name of its kind, two
//! mentions of a side exchanged, the twins of two edges exchanged, one corner of a loop
//! relabelled, or one statement dropped. Values (`require`, right-hand sides) and the
//! signature are left alone: they say what the operation is for, not what a mesh is.
//! What is accepted all the same stands in `tests/proof/published/harmless.txt`, below the reason
//! why it breaks nothing.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use hedgerow::analysis::Analysis;
use hedgerow::diagnostic::{Diagnostic, Rendering, render};
use hedgerow::diagram::{Kind, Ref, Rule, Side, Spoke};
use hedgerow::source::{Sources, Span};

/// A text with one thing wrong.
struct Mutant {
    /// What was done.
    what: &'static str,
    /// The places that were written over, in the text as printed, with what stands there.
    edits: Vec<(Span, String)>,
}

impl Mutant {
    fn text(&self, text: &str) -> String {
        let mut edits: Vec<_> = self.edits.iter().collect();
        edits.sort_by_key(|(span, _)| span.start);
        let mut out = text.to_owned();
        for (span, word) in edits.into_iter().rev() {
            out.replace_range(span.start as usize..span.end as usize, word);
        }
        out
    }

    /// The lines that were changed, as they are now.
    fn told(&self, op: &str, text: &str) -> String {
        let mutated = self.text(text);
        let changed = text.lines().zip(mutated.lines());
        let changed = changed.filter(|(old, new)| old != new);
        let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
        let changed: Vec<_> =
            changed.map(|(old, new)| format!("{} -> {}", words(old), words(new))).collect();
        format!("{op}, {}: {}", self.what, changed.join("; "))
    }
}

fn published() -> Vec<(String, String)> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "hedge"))
        .collect();
    paths.sort();
    let named = paths.into_iter().map(|path| {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        (name, fs::read_to_string(path).unwrap())
    });
    named.collect()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/proof/published")
}

fn analysis(text: &str) -> (Sources, Analysis) {
    let mut sources = Sources::new();
    let file = sources.add("published.hedge", text);
    let analysis = Analysis::of(&sources, file);
    (sources, analysis)
}

fn told(sources: &Sources, diagnostics: &[Diagnostic]) -> String {
    let how = Rendering { colour: false, most: usize::MAX };
    render(diagnostics, sources, how)
}

/// Every mention in the statements of a side.
fn mentions(side: &Side) -> Vec<Ref> {
    let mut mentions = Vec::new();
    for orbit in &side.loops {
        mentions.push(orbit.face);
        mentions.extend(orbit.items.iter().flat_map(|item| [item.from, item.item]));
        mentions.push(orbit.end);
    }
    for edge in &side.edges {
        mentions.push(edge.edge);
        mentions.extend(edge.halfedges);
    }
    for star in &side.stars {
        mentions.push(star.vertex);
        mentions.extend(star.spokes.iter().filter_map(|spoke| match spoke {
            Spoke::Halfedge(name) | Spoke::Fan(name) => Some(*name),
            Spoke::Rest(_) => None,
        }));
    }
    mentions
}

fn mutants(rule: &Rule) -> Vec<Mutant> {
    let mut mutants = Vec::new();
    let word = |mention: Ref| rule.name(mention.name).text.clone();
    let sides = [&rule.before, &rule.after];
    for side in sides {
        let lists = if std::ptr::eq(side, &rule.after) {
            [rule.created.clone(), rule.erased.clone()].concat()
        } else {
            Vec::new()
        };
        for mention in mentions(side).into_iter().chain(lists) {
            for other in others(rule, mention) {
                mutants.push(Mutant { what: "renamed", edits: vec![(mention.span, other)] });
            }
        }
        let all = mentions(side);
        for (at, &one) in all.iter().enumerate() {
            for &two in &all[at + 1..] {
                if one.name != two.name && rule.kind(one.name) == rule.kind(two.name) {
                    mutants.push(Mutant {
                        what: "exchanged",
                        edits: vec![(one.span, word(two)), (two.span, word(one))],
                    });
                }
            }
        }
        for orbit in &side.loops {
            let first = orbit.items[0].from;
            for other in others(rule, first) {
                mutants.push(Mutant {
                    what: "relabelled",
                    edits: vec![(first.span, other.clone()), (orbit.end.span, other)],
                });
            }
        }
        let statements = side
            .loops
            .iter()
            .map(|orbit| orbit.span)
            .chain(side.edges.iter().map(|edge| edge.span))
            .chain(side.stars.iter().map(|star| star.span));
        mutants.extend(statements.map(dropped));
    }
    let rest = rule.assignments.iter().map(|assignment| assignment.span);
    let rest = rest.chain(rule.requires.iter().map(|require| require.span));
    let listed = rule.created.iter().chain(&rule.erased);
    mutants.extend(rest.chain(listed.map(|name| name.span)).map(dropped));
    mutants
}

fn dropped(span: Span) -> Mutant {
    Mutant { what: "dropped", edits: vec![(span, String::new())] }
}

/// The other names of the kind of a mention.
fn others(rule: &Rule, mention: Ref) -> Vec<String> {
    let kind: Kind = rule.kind(mention.name);
    rule.names_of(kind)
        .filter(|&name| name != mention.name && rule.name(name).named)
        .map(|name| rule.name(name).text.clone())
        .collect()
}

#[test]
fn as_printed_they_are_accepted() {
    let all = published();
    assert_eq!(all.len(), 5);
    for (name, text) in all {
        let (sources, analysis) = analysis(&text);
        let said = told(&sources, &analysis.diagnostics);
        assert!(analysis.is_sound(), "{name}:\n{said}");
        assert!(analysis.plans.iter().all(Option::is_some), "{name}");
    }
}

#[test]
fn with_one_thing_wrong_they_are_refused() {
    let mut accepted = BTreeSet::new();
    let (mut refused, mut astray) = (0, Vec::new());
    for (name, text) in published() {
        let (_, good) = analysis(&text);
        let op = good.program.ops[0].diagram.as_ref().unwrap();
        for mutant in mutants(&op.rules[0]) {
            let mutated = mutant.text(&text);
            let (sources, analysis) = analysis(&mutated);
            if analysis.is_sound() {
                assert!(analysis.plans[0].is_some(), "{mutated}");
                accepted.insert(mutant.told(&name, &text));
                continue;
            }
            refused += 1;
            let errors = analysis.diagnostics.iter().filter(|said| said.is_error());
            let errors: Vec<_> = errors.cloned().collect();
            if !errors.iter().any(|error| is_about(error, &mutant, &text, &mutated)) {
                let said = told(&sources, &errors);
                astray.push(format!("{}\n{said}", mutant.told(&name, &text)));
            }
        }
    }
    assert!(astray.is_empty(), "neither at the place nor about the name:\n{}", astray.join("\n"));
    assert!(refused > 1900, "only {refused} mutants were refused");
    let harmless = harmless();
    let wrong: Vec<_> = accepted.difference(&harmless).collect();
    let gone: Vec<_> = harmless.difference(&accepted).collect();
    assert!(wrong.is_empty(), "accepted: {wrong:#?}");
    assert!(gone.is_empty(), "no longer accepted, or no mutant: {gone:#?}");
}

/// Whether a diagnostic points at a line that was changed, or speaks of a name that stood or
/// stands there.
fn is_about(error: &Diagnostic, mutant: &Mutant, text: &str, mutated: &str) -> bool {
    let line = |offset: u32| {
        let before = &mutated[..(offset as usize).min(mutated.len())];
        before.matches('\n').count()
    };
    let points = mutant.edits.iter().any(|(span, _)| {
        let at = line(span.start);
        let mut labels = error.labels.iter();
        labels.any(|label| (line(label.span.start)..=line(label.span.end)).contains(&at))
    });
    let statements = mutant.edits.iter().map(|(span, _)| {
        let start = text[..span.start as usize].rfind('\n').unwrap_or(0);
        let end = text[span.end as usize..].find('\n').unwrap_or(0);
        &text[start..span.end as usize + end]
    });
    let is_part = |c: char| c.is_alphanumeric() || c == '\'';
    let words = statements.flat_map(|text| text.split(move |c| !is_part(c)));
    let words = words.chain(mutant.edits.iter().map(|(_, word)| word.as_str()));
    let labels = error.labels.iter().map(|label| label.text.as_str());
    let said: Vec<_> = labels.chain([error.message.as_str()]).collect();
    let speaks = words
        .filter(|word| !word.is_empty())
        .map(|word| format!("`{word}`"))
        .any(|word| said.iter().any(|said| said.contains(&word)));
    points || speaks
}

fn harmless() -> BTreeSet<String> {
    let list = fs::read_to_string(folder().join("harmless.txt")).unwrap();
    let lines = list.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(String::from).collect()
}
