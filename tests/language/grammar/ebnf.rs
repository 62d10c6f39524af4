//! `grammar/hedgerow.ebnf`: every rule is defined once, and used.

use std::collections::BTreeMap;

const GRAMMAR: &str = include_str!("../../../grammar/hedgerow.ebnf");

/// The grammar without comments, quoted words and what is said in words.
fn bare() -> String {
    let mut bare = String::new();
    let mut rest = GRAMMAR;
    while let Some(first) = rest.chars().next() {
        let end = if rest.starts_with("(*") {
            rest.find("*)").unwrap() + 2
        } else if let '"' | '\'' | '?' = first {
            1 + rest[1..].find(first).unwrap() + 1
        } else {
            bare.push(first);
            first.len_utf8()
        };
        rest = &rest[end..];
    }
    bare
}

fn names(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphabetic()).filter(|name| !name.is_empty())
}

#[test]
fn every_rule_is_defined_once_and_used() {
    let bare = bare();
    let rules = bare.split(';').filter_map(|rule| rule.split_once('='));
    let rules: Vec<_> = rules.map(|(name, body)| (name.trim(), body)).collect();
    assert!(rules.len() > 40, "only {} rules", rules.len());
    let mut uses: BTreeMap<&str, usize> = BTreeMap::new();
    for (name, _) in &rules {
        assert!(uses.insert(name, 0).is_none(), "`{name}` is defined twice");
    }
    for (rule, body) in &rules {
        for name in names(body) {
            let uses = uses.get_mut(name);
            *uses.unwrap_or_else(|| panic!("`{rule}` uses `{name}`, which is not defined")) += 1;
        }
    }
    uses.retain(|name, uses| *uses == 0 && *name != "file");
    assert!(uses.is_empty(), "defined and not used: {uses:?}");
}
