//! `hedgerow check --aliases`: prints which names may stand for one element.

use super::output::table;
use crate::analysis::{NamesAsOne, RuleAliases};

/// The aliases of a rule as text: a line for each set that would be fine, would break or is not
/// proved, and for the impossible ones a line for each reason.
pub(super) fn show(rule: &RuleAliases) -> String {
    let name = rule.rule.iter().map(|rule| format!(", rule {rule}"));
    let title = format!("\n{}{}", rule.op, name.collect::<String>());
    if rule.has_families {
        return format!("{title}\n  has families: their names are distinct on every cycle");
    }
    if rule.sets.is_empty() {
        return format!("{title}\n  no two names are of one kind");
    }
    let mut rows = Vec::new();
    for set in &rule.sets {
        let verdict = match set.verdict {
            "fine" => "would be fine",
            "breaks" => "would break",
            "unproved" => "is not proved",
            _ => continue,
        };
        let why = [set.why.as_ref(), set.comes_to.as_ref()];
        let why: Vec<_> = why.into_iter().flatten().map(String::as_str).collect();
        rows.push(vec![format!("  {verdict}"), names(set), why.join("; carried out literally, ")]);
    }
    let mut reasons: Vec<(&str, Vec<String>)> = Vec::new();
    for set in rule.sets.iter().filter(|set| set.verdict == "impossible") {
        let why = set.why.as_deref().unwrap_or_default();
        match reasons.iter_mut().find(|(known, _)| *known == why) {
            Some((_, sets)) => sets.push(names(set)),
            None => reasons.push((why, vec![names(set)])),
        }
    }
    let lines = if rows.is_empty() { Vec::new() } else { vec![table(&rows, &[])] };
    let impossible = reasons.iter().map(|(why, sets)| {
        let sets = sets.join(", or ");
        format!("  is impossible  {sets}: {why}")
    });
    let more = (!rule.complete).then(|| {
        "  further sets of names were not examined; an `alias` examines its own".to_owned()
    });
    let lines = std::iter::once(title).chain(lines).chain(impossible).chain(more);
    lines.collect::<Vec<_>>().join("\n")
}

/// `v0 = v2, a = b`
fn names(set: &NamesAsOne) -> String {
    set.names.iter().map(|class| class.join(" = ")).collect::<Vec<_>>().join(", ")
}
