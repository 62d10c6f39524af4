//! The proof of one rule.

use super::argument::{self, Argument};
use super::broken::{Broken, stop_at};
use super::facts::Facts;
use super::guard::{Obligation, obligations};
use super::matching::Step;
use super::statements::statements;
use super::vertices_are_orbits::Rings;
use super::{alias, distinct_names, property_not_kept, reach, start, vertices_are_orbits};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, Level, Op, Property, Rule};

/// The proof of one rule.
#[derive(Clone, Debug)]
pub struct Proof {
    pub(super) matching: Vec<Step>,
    pub(super) guard: Vec<Obligation>,
    pub(super) facts: Facts,
    pub(super) rings: Rings,
    /// The rule that the steps refer to, if it is not the one that was proved.
    pub(super) unrolled: Option<Box<Rule>>,
}

impl Proof {
    /// The rule that the matching and the guard refer to: the one that was proved or, if it has
    /// families, the same unrolled. What is stated there for members at index 0 holds for every
    /// index.
    pub fn drawn<'a>(&'a self, rule: &'a Rule) -> &'a Rule {
        self.unrolled.as_deref().unwrap_or(rule)
    }

    /// The steps by which the rule is matched.
    pub fn matching(&self) -> &[Step] {
        &self.matching
    }

    /// The obligations of the guard; some are left to test.
    pub fn guard(&self) -> &[Obligation] {
        &self.guard
    }

    /// A warning if the guard refuses every place.
    pub fn refuses_everywhere(&self, rule: &Rule) -> Option<Diagnostic> {
        let (level, span) = rule.guard?;
        let mut loops = rule.before.loops.iter().filter(|_| level > Level::Map);
        let impossible = loops.find_map(|orbit| {
            let face = rule.quoted(orbit.face.name);
            let has_paths = orbit.item_names().any(|name| rule.kind(name) == Kind::Path);
            match orbit.corner_met_twice() {
                Some(corner) => Some(format!("{face} meets {} twice", rule.quoted(corner))),
                None if !has_paths && !orbit.each && orbit.items.len() < 3 => {
                    Some(format!("{face} has fewer than three sides"))
                }
                None => None,
            }
        });
        let refusal = match impossible {
            Some(refusal) => refusal,
            None => {
                let never = self.guard.iter().find(|obligation| obligation.is_never)?;
                never.statement.refusal(self.drawn(rule))
            }
        };
        let message = format!("`guard {level}` refuses every place: {refusal}");
        Some(Diagnostic::warning("always-refused", message, span))
    }

    /// The facts that the proof established.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }

    /// The proof, if it bears out all that the op claims to keep.
    pub(super) fn bears_out(self, op: &Op, drawing: &Drawing) -> Result<Self, Broken> {
        stop_at(property_not_kept::broken_claims(op, drawing, &self.facts))?;
        Ok(self)
    }

    /// The argument in words, law by law. The rule is the one that was proved.
    pub fn argument(&self, rule: &Rule) -> Vec<Argument> {
        argument::argument(self.drawn(rule), &self.rings)
    }
}

/// Tests the laws in order. Each group relies on what the one before has established, so the first
/// group that fails is reported, in full.
pub(super) fn prove(op: &Op, rule: &Rule) -> Result<Proof, Broken> {
    let drawing = Drawing::new(rule);
    stop_at(start::test(op, &drawing))?;
    statements(&drawing)?;
    let rings = vertices_are_orbits::test(&drawing);
    let reached = reach::matching(op, &drawing, &distinct_names::pairs(&drawing));
    let (rings, matching) = match (rings, reached) {
        // What is not reached is probably not what is meant, and the rings follow from it.
        (Err(broken), Err(unreached)) if broken.is_of_rings() => return Err(unreached.into()),
        (rings, reached) => (rings?, reached),
    };
    let aliased = alias::allowed(op, rule)?;
    let matching = matching?;
    let guard = match rule.guard {
        Some((level, _)) => aliased.obligations(obligations(&drawing, level), level),
        None => Vec::new(),
    };
    let cases = rings.cases + aliased.cases();
    let mut facts = Facts::of(&drawing, &matching, &guard, cases);
    aliased.keeps_no_more(&mut facts);
    if !facts.keeps.contains(&Property::Level(Level::Simple)) {
        let asked = aliased.obligations(obligations(&drawing, Level::Simple), Level::Simple);
        facts.note_untested(rule, &asked);
    }
    let proof = Proof { matching, guard, facts, rings, unrolled: None };
    proof.bears_out(op, &drawing)
}
