//! Names of `after` that nothing introduces, and what was probably meant.

use super::problem::Problem;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, NameId};

/// Names of `after` that neither `before` nor `new` knows.
pub(super) struct Unknown {
    /// What to tell.
    pub problems: Vec<Problem>,
    /// The names that were probably meant.
    pub meant: Vec<NameId>,
}

impl Unknown {
    /// Looks at every name of `after`.
    pub fn find(drawing: &Drawing) -> Self {
        let rule = drawing.rule;
        let mut found = Self {
            problems: Vec::new(),
            meant: Vec::new(),
        };
        for index in 0..rule.names.len() {
            let name = NameId(index as u32);
            let known = drawing.before.mention(name).is_some() || drawing.created(name).is_some();
            let Some(span) = drawing.after.mention(name).filter(|_| !known) else {
                continue;
            };
            let text = rule.quoted(name);
            let kind = rule.kind(name);
            let message = format!("{text} stands in `after`, but neither in `before` nor in `new`");
            let mut diagnostic = Diagnostic::error("unknown-name", message, span)
                .saying(format!("{} that nothing creates", kind.a_word()));
            match found.meaning(drawing, name) {
                Some(meant) => {
                    let word = &rule.name(meant).text;
                    diagnostic = diagnostic
                        .label(
                            rule.name(meant).span,
                            format!("`{word}` has a similar name"),
                        )
                        .fix(format!("write `{word}`"), span, word.clone());
                    found.meant.push(meant);
                }
                None if rule.name(name).named => {
                    diagnostic = diagnostic.note(format!(
                        "if {text} is created here, list it: `new {}`",
                        rule.name(name).text
                    ));
                }
                None => {}
            }
            found.problems.push(diagnostic.into());
        }
        found
    }

    /// The known name of the same kind that is spelt most like `name`; one that is missing
    /// from `after` comes first.
    fn meaning(&self, drawing: &Drawing, name: NameId) -> Option<NameId> {
        let rule = drawing.rule;
        let word = &rule.name(name).text;
        let missing = |other: NameId| {
            drawing.after.mention(other).is_none() && drawing.erased(other).is_none()
        };
        rule.names_of(rule.kind(name))
            .filter(|&other| {
                other != name && rule.name(other).named && !self.meant.contains(&other)
            })
            .filter(|&other| {
                drawing.before.mention(other).is_some() || drawing.created(other).is_some()
            })
            .filter(|&other| missing(other))
            .map(|other| {
                (
                    strsim::damerau_levenshtein(word, &rule.name(other).text),
                    other,
                )
            })
            .filter(|&(distance, _)| distance <= word.chars().count().max(3) / 3)
            .min()
            .map(|(_, other)| other)
    }
}
