//! The sets that `check --aliases` prints are closed: what it says to be fine can be declared as
//! it stands, and is refused only where it says that a part of it would break.

use hedgerow::check::{Verdict, check, identifications};
use hedgerow::diagram::NameId;

use crate::aliases::applied::with_alias;
use crate::aliases::{rules, words};

#[test]
fn what_is_said_to_be_fine_can_be_declared() {
    let (mut accepted, mut refused) = (0, 0);
    for (_, op) in rules() {
        let rule = &op.rules[0];
        let all = identifications(&op, rule).0;
        for one in all.iter().filter(|one| matches!(one.verdict, Verdict::Fine)) {
            let told = || format!("{}: {}", op.name, words(rule, &one.names));
            let Err(problems) = check(&with_alias(&op, &one.names)) else {
                accepted += 1;
                continue;
            };
            refused += 1;
            assert_eq!(problems[0].code, "alias-breaks", "{}: {}", told(), problems[0].message);
            // A part of it is told to break, or not to be proved.
            let lies_within = |class: &Vec<NameId>| {
                one.names.iter().any(|of| class.iter().all(|name| of.contains(name)))
            };
            let bad = |verdict: &Verdict| {
                matches!(verdict, Verdict::Breaks { .. } | Verdict::Unproved(_))
            };
            let mut parts = all.iter().filter(|part| bad(&part.verdict));
            let known = parts.any(|part| part.names.iter().all(lies_within));
            assert!(known, "{}: {:?}", told(), problems[0].notes);
        }
    }
    println!("{accepted} sets declared, {refused} refused for a part of them");
    assert!(accepted > 60, "only {accepted}");
}

/// Where two vertices with statements are one, all that follows is told with it.
#[test]
fn two_statements_of_one_vertex_are_laid_on_each_other() {
    let mut met = 0;
    for (_, op) in rules() {
        let rule = &op.rules[0];
        let stars: Vec<NameId> = rule.before.stars.iter().map(|star| star.vertex.name).collect();
        for one in identifications(&op, rule).0 {
            let both =
                |class: &Vec<NameId>| class.iter().filter(|name| stars.contains(name)).count() > 1;
            if let Verdict::Unproved(why) = &one.verdict {
                assert!(!why.contains("two statements"), "{}: {why}", op.name);
            }
            let possible = !matches!(one.verdict, Verdict::Impossible(_));
            met += usize::from(possible && one.names.iter().any(both));
        }
    }
    assert!(met > 0, "no op has two statements of one vertex");
}
