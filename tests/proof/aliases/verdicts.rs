//! Verdicts held against every match on small meshes where names are one.

use std::collections::BTreeMap;

use hedgerow::check::{Counterexample, Verdict, identifications};
use hedgerow::diagram::{Kind, NameId, Rule};
use hedgerow::mesh::validate;

use crate::aliases::{maps, one_in, places, rules, words};
use support::reference::matching::{bound_by, matches_where};
use support::reference::printing::mesh_text;
use support::reference::rewriting::rewrite;
use support::reference::truth::untrue;

/// How many matches are looked at in one place.
const MOST: usize = 40;

#[test]
fn verdicts_are_true_on_small_meshes() {
    let mut met: BTreeMap<&str, usize> = BTreeMap::new();
    let mut sets_met = 0;
    for (_, op) in rules() {
        let rule = &op.rules[0];
        let all = identifications(&op, rule).0;
        let mut seen: Vec<&Vec<Vec<NameId>>> = Vec::new();
        for mesh in maps(160, 7) {
            for place in places(&op, &mesh) {
                let bound = bound_by(rule, &place);
                for at in matches_where(rule, &mesh, &bound, MOST, &|_, _| true) {
                    let names = one_in(rule, &at);
                    if names.is_empty() {
                        continue;
                    }
                    let told = || {
                        let names = words(rule, &names);
                        format!("{}: {names} on\n{}", op.name, mesh_text(&mesh))
                    };
                    for one in &all {
                        let within = |class: &Vec<NameId>| {
                            let mut of = names.iter();
                            of.any(|of| class.iter().all(|name| of.contains(name)))
                        };
                        let impossible = matches!(one.verdict, Verdict::Impossible(_));
                        assert!(!impossible || !one.names.iter().all(within), "{}", told());
                    }
                    let Some(one) = all.iter().find(|one| one.names == names) else {
                        *met.entry("not looked at").or_default() += 1;
                        continue;
                    };
                    if !seen.contains(&&one.names) {
                        seen.push(&one.names);
                    }
                    let result = rewrite(rule, &mesh, &at).expect("all names are bound");
                    let valid = validate(&result.mesh);
                    let word = match (&one.verdict, &valid) {
                        (Verdict::Fine, Ok(())) => {
                            assert_eq!(untrue(rule, &result), None, "{}", told());
                            "fine"
                        }
                        (Verdict::Fine, Err(invalid)) => panic!("{invalid}: {}", told()),
                        (Verdict::Breaks { .. }, Ok(())) => "breaks elsewhere",
                        (Verdict::Breaks { .. }, Err(_)) => "breaks",
                        (Verdict::Unproved(_), Ok(())) => "not proved, and valid",
                        (Verdict::Unproved(_), Err(_)) => "not proved, and breaks",
                        (Verdict::Impossible(_), _) => unreachable!("asked above"),
                    };
                    *met.entry(word).or_default() += 1;
                }
            }
        }
        sets_met += seen.len();
    }
    println!("{sets_met} sets met: {met:#?}");
    assert!(sets_met > 60, "only {sets_met} sets");
    assert!(met["fine"] > 2_000 && met["breaks"] > 200, "{met:?}");
    // A search among small meshes finds nearly all there is to find.
    let missed = met.get("not proved, and breaks").copied().unwrap_or(0);
    assert!(missed * 50 < met["breaks"], "{met:?}");
}

#[test]
fn what_would_break_shows_its_mesh() {
    let mut shown = 0;
    for (_, op) in rules() {
        let rule = &op.rules[0];
        for one in identifications(&op, rule).0 {
            let Verdict::Breaks { why, example } = &one.verdict else {
                continue;
            };
            shown += 1;
            assert!(!why.is_empty());
            assert_eq!(validate(&example.before), Ok(()));
            assert_eq!(validate(&example.after), Err(example.invalid.clone()));
            for class in &one.names {
                let element = |name: &NameId| element_of(rule, example, *name);
                let first = element(&class[0]);
                assert!(first.is_some() && class.iter().all(|name| element(name) == first));
            }
            let bound: Vec<_> = rule
                .ids()
                .filter(|&name| !matches!(rule.kind(name), Kind::Path | Kind::Fan))
                .filter(|&name| rule.created.iter().all(|created| created.name != name))
                .filter_map(|name| Some((name, element_of(rule, example, name)?)))
                .collect();
            let found = matches_where(rule, &example.before, &bound, 50, &|_, _| true);
            let names = words(rule, &one.names);
            assert!(
                !found.is_empty(),
                "{}: {names}: no match in {:?} of\n{}",
                op.name,
                example.names,
                mesh_text(&example.before)
            );
            assert!(found.iter().all(|at| one_in(rule, at) == one.names));
        }
    }
    assert!(shown > 40, "only {shown}");
}

fn element_of(rule: &Rule, example: &Counterexample, name: NameId) -> Option<u32> {
    let text = &rule.name(name).text;
    let (_, elements) = example.names.iter().find(|(known, _)| known == text)?;
    elements.first().map(|element| element.index)
}
