//! Names of `after` that nothing introduces, and what was probably meant.

use super::problem::{Problem, Repair, enumerate};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId, Rule, Spoke};
use crate::source::Span;

/// Names of `after` that neither `before` nor `new` knows.
pub(super) struct Unknown {
    /// The messages.
    pub problems: Vec<Problem>,
    /// The names that were probably meant.
    pub meant: Vec<NameId>,
}

impl Unknown {
    /// Looks at every name of `after`.
    pub fn find(drawing: &Drawing) -> Self {
        let rule = drawing.rule;
        let mut found = Self { problems: Vec::new(), meant: Vec::new() };
        let mut created = Vec::new();
        let is_forgotten = rule.created.is_empty() && found.has_others(drawing);
        for index in 0..rule.names.len() {
            let name = NameId(index as u32);
            let Some(span) = drawing.after.mention(name).filter(|_| is_unknown(drawing, name))
            else {
                continue;
            };
            let meant = found.meaning(drawing, name);
            match meant.filter(|&meant| !is_forgotten || alike(rule, name, meant)) {
                Some(meant) => {
                    let word = &rule.name(meant).text;
                    let problem = unknown(drawing, (name, span), &[])
                        .label(rule.name(meant).span, format!("`{word}` has a similar name"))
                        .fix(format!("write `{word}`"), span, word.clone());
                    found.problems.push(problem.into());
                    found.meant.push(meant);
                }
                None if !rule.name(name).named => {
                    let problem = unknown(drawing, (name, span), &[]);
                    found.problems.push(problem.into());
                }
                // In an unrolled rule, the first member is reported for its family.
                None if rule.is_first(name) => created.push((name, span)),
                None => {}
            }
        }
        found.problems.extend(not_listed(drawing, created));
        found
    }

    /// True if some name has no meaning: where nothing is listed in `new`, the list is forgotten.
    fn has_others(&self, drawing: &Drawing) -> bool {
        let rule = drawing.rule;
        rule.ids().any(|name| {
            is_unknown(drawing, name)
                && rule.name(name).named
                && self.meaning(drawing, name).is_none()
        })
    }

    /// The known name of the same kind that is spelt most like `name`; one that is missing
    /// from `after` comes first.
    fn meaning(&self, drawing: &Drawing, name: NameId) -> Option<NameId> {
        let rule = drawing.rule;
        let word = &rule.name(name).text;
        let alike = |other: NameId| alike(rule, name, other);
        // `tt` for a `t` that lost its twin.
        let longer = |other: NameId| {
            let other = &rule.name(other).text;
            !word.contains('\'') && (word.starts_with(other) || other.starts_with(word))
        };
        let (before, after) = (&drawing.before, &drawing.after);
        let missing = |other: NameId| {
            alike(other)
                || longer(other) && before.twin(other).is_some() && after.twin(other).is_none()
                || drawing.after.mention(other).is_none() && drawing.erased(other).is_none()
        };
        rule.names_of(rule.kind(name))
            .filter(|&other| {
                other != name && rule.name(other).named && !self.meant.contains(&other)
            })
            .filter(|&other| {
                drawing.before.mention(other).is_some() || drawing.created(other).is_some()
            })
            .filter(|&other| missing(other))
            .map(|other| (strsim::damerau_levenshtein(word, &rule.name(other).text), other))
            .filter(|&(distance, _)| distance <= word.chars().count().max(3) / 3)
            .min()
            .map(|(_, other)| other)
    }
}

/// True if `after` draws a name that neither `before` nor `new` knows.
pub(super) fn is_unknown(drawing: &Drawing, name: NameId) -> bool {
    let is_known = drawing.before.mention(name).is_some() || drawing.created(name).is_some();
    drawing.after.mention(name).is_some() && !is_known
}

/// True if two names differ at most in capitals.
fn alike(rule: &Rule, one: NameId, other: NameId) -> bool {
    rule.name(one).text.eq_ignore_ascii_case(&rule.name(other).text)
}

/// The message about names that nothing introduces, each with a place where it occurs.
fn unknown(drawing: &Drawing, first: (NameId, Span), others: &[(NameId, Span)]) -> Diagnostic {
    let rule = drawing.rule;
    let list: Vec<_> = std::iter::once(&first).chain(others).map(|(name, _)| *name).collect();
    let stand = if list.len() == 1 { "stands" } else { "stand" };
    let message = format!(
        "{} {stand} in `after`, but neither in `before` nor in `new`",
        enumerate(rule, &list)
    );
    let (name, span) = first;
    let kind = rule.kind(name);
    let mut diagnostic = Diagnostic::error("unknown-name", message, span)
        .saying(format!("{} that nothing creates", kind.a_word()));
    // Only the first name of each kind is labeled with its kind.
    let mut shown = vec![kind];
    for (name, span) in others {
        let kind = rule.kind(*name);
        let is_first = !shown.contains(&kind);
        shown.push(kind);
        diagnostic = diagnostic.label(*span, if is_first { kind.a_word() } else { "" });
    }
    diagnostic
}

/// Names that are probably meant to be created: vertices first, faces last.
fn not_listed(drawing: &Drawing, mut names: Vec<(NameId, Span)>) -> Option<Problem> {
    let rule = drawing.rule;
    let order = [Kind::Vertex, Kind::Halfedge, Kind::Edge, Kind::Face];
    names.sort_by_key(|(name, _)| order.iter().position(|&kind| kind == rule.kind(*name)));
    let (first, others) = names.split_first()?;
    let mut diagnostic = unknown(drawing, *first, others);
    let elements = names.iter().map(|(name, _)| *name);
    let elements = elements.filter(|&name| order.contains(&rule.kind(name)));
    let (given, elements): (Vec<_>, Vec<_>) =
        elements.partition(|&name| rule.params.contains(&Some(name)));
    if let Some(&given) = given.first() {
        let text = rule.quoted(given);
        let isolated = match rule.kind(given) {
            Kind::Vertex => {
                ", with halfedges around it; where it has none, pass its position instead"
            }
            _ => "",
        };
        diagnostic = diagnostic.note(format!("{text} is a parameter: `before` draws it{isolated}"));
    }
    let mut repairs = Vec::new();
    if rule.kind(first.0) == Kind::Fan {
        diagnostic = of_before(drawing, diagnostic, &rule.name(first.0).text);
    }
    if !elements.is_empty() {
        let words: Vec<_> = elements.iter().map(|&name| &*rule.name(name).text).collect();
        let what = match names.len() {
            1 => format!("if {} is created here, list it", rule.quoted(elements[0])),
            _ => "if they are created here, list them".to_owned(),
        };
        diagnostic = diagnostic.note(format!("{what}: `new {}`", words.join(" ")));
        repairs.push(Repair::Create(elements));
    }
    Some(Problem { diagnostic, repairs })
}

/// Adds where `before` draws a fan that only `after` names.
fn of_before(drawing: &Drawing, diagnostic: Diagnostic, word: &str) -> Diagnostic {
    let stars = drawing.rule.before.stars.iter();
    let unnamed = stars.flat_map(|star| &star.spokes).filter_map(|spoke| match spoke {
        Spoke::Rest(span) => Some(*span),
        Spoke::Halfedge(_) | Spoke::Fan(_) => None,
    });
    match unnamed.collect::<Vec<_>>().as_slice() {
        &[only] => diagnostic
            .label(only, "a fan without a name")
            .fix(format!("name it: `*{word}`"), only, format!("*{word}")),
        _ => diagnostic.note(format!(
            "a fan is the spokes of a vertex that have no name, drawn in `before`: `vertex v: a *{word} b`"
        )),
    }
}
