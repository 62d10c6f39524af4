//! Proofs of rules whose `alias`es let names be one.

use super::closure::{Contradiction, united};
use super::quotient::Quotient;
use super::verdict::{Failed, Sets, add, laws};
use crate::check::broken::Broken;
use crate::check::change::Change;
use crate::check::ends_agree::neighbors_are_twins;
use crate::check::facts::Facts;
use crate::check::fold::add_obligation;
use crate::check::guard::{Condition, Obligation, obligations};
use crate::check::problem::{Problem, enumerate};
use crate::check::properties::{SizeChange, degree_changes, kept, size_changes};
use crate::check::witness::{self, Outcome};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Level, NameId, Op, Rule};
use crate::source::Span;

/// The greatest number of sets of names that are examined.
const MOST: usize = 400;

/// The greatest number of these sets for which a mesh that breaks is searched.
const MOST_SEARCHES: usize = 16;

/// The number of meshes that did not break after which no further set is searched.
const MOST_MESHES: usize = 4_000;

/// Every way in which names that may be one are one, each proved.
pub(in crate::check) struct Aliased {
    quotients: Vec<Quotient>,
    cases: usize,
}

/// Proves a rule for all that its `alias`es allow, or reports what they must not allow.
pub(in crate::check) fn allowed(op: &Op, rule: &Rule) -> Result<Aliased, Broken> {
    let mut aliased = Aliased { quotients: Vec::new(), cases: 0 };
    if rule.aliases.is_empty() {
        return Ok(aliased);
    }
    let wanted = wanted(rule);
    // Of the sets that break a law, the first that also breaks a mesh is reported, if there is one.
    let mut broken: Option<(Problem, Outcome)> = None;
    let (mut searches, mut meshes) = (0, 0);
    for (names, quotients) in sets(rule, &wanted)? {
        for quotient in quotients {
            let quotient = quotient.finished();
            match laws(&quotient) {
                Ok(rings) => {
                    aliased.cases += rings.cases;
                    aliased.quotients.push(quotient);
                }
                Err(Failed::Impossible(_)) => {}
                Err(Failed::Broken { why, arcs }) => {
                    if searches == MOST_SEARCHES || meshes >= MOST_MESHES {
                        continue;
                    }
                    searches += 1;
                    let code = "alias-breaks";
                    let arcs = arcs.as_deref();
                    let found = witness::find_where_one(op, rule, &quotient, arcs, code);
                    let problem = breaks(rule, &names, &wanted, &why);
                    match found {
                        Outcome::Breaks(_) => return Err(told(problem, found)),
                        Outcome::Valid(tried) => meshes += tried,
                        Outcome::NoMesh | Outcome::NotTried => {}
                    }
                    broken.get_or_insert((problem, found));
                }
            }
        }
    }
    if let Some((problem, outcome)) = broken {
        return Err(told(problem, outcome));
    }
    let mut problems = Vec::new();
    for &(pair, span) in &wanted {
        let is_one = |quotient: &Quotient| {
            let [left, right] = pair.map(|name| quotient.stands_for(name));
            left == right
        };
        if !aliased.quotients.iter().any(is_one) {
            problems.push(never_one(rule, pair, span));
        }
    }
    if problems.is_empty() { Ok(aliased) } else { Err(problems.into()) }
}

/// The names that are one, by an `alias`, in a mesh that matches a rule which no mesh matches with
/// all names distinct: the smallest such sets.
pub(in crate::check) fn drawable_where_one(rule: &Rule) -> Option<Vec<Vec<NameId>>> {
    if rule.has_families() {
        return None;
    }
    let sets = sets(rule, &wanted(rule)).ok()?;
    let proved = |quotient: Quotient| {
        let quotient = quotient.finished();
        laws(&quotient).is_ok() && neighbors_are_twins(&Drawing::new(&quotient.rule)).is_empty()
    };
    let mut sets = sets.into_iter().filter(|(names, _)| !names.is_empty());
    sets.find_map(|(names, quotients)| quotients.into_iter().any(proved).then_some(names))
}

fn told(problem: Problem, outcome: Outcome) -> Broken {
    Broken { problems: vec![problem], arcs: None, outcome: Some(outcome) }
}

/// The pairs that may be one, each with the span of its `alias`.
fn wanted(rule: &Rule) -> Vec<([NameId; 2], Span)> {
    let mut wanted: Vec<([NameId; 2], Span)> = Vec::new();
    for alias in &rule.aliases {
        for (at, left) in alias.names.iter().enumerate() {
            for right in &alias.names[at + 1..] {
                let pair = [left.name.min(right.name), left.name.max(right.name)];
                if !wanted.iter().any(|(known, _)| *known == pair) {
                    wanted.push((pair, alias.span));
                }
            }
        }
    }
    wanted
}

/// The sets of names that can be one and no test keeps apart, from small to large.
fn sets(rule: &Rule, wanted: &[([NameId; 2], Span)]) -> Result<Sets, Vec<Problem>> {
    let is_allowed = |classes: &[Vec<NameId>]| {
        classes
            .iter()
            .all(|class| pairs_of(class).all(|pair| wanted.iter().any(|(known, _)| *known == pair)))
    };
    let mut sets: Sets = vec![(Vec::new(), vec![Quotient::of(rule)])];
    let mut at = 0;
    while at < sets.len() {
        for &(pair, span) in wanted {
            let mut found = Vec::new();
            for quotient in &sets[at].1 {
                match united(quotient, pair) {
                    Ok(quotients) => found.extend(quotients),
                    Err(Contradiction::Certain(_)) => {}
                    Err(Contradiction::Unclear(why)) => return Err(unclear(why, span)),
                }
            }
            add(&mut sets, found, rule.names.len(), is_allowed);
            if sets.len() > MOST {
                return Err(unclear("there are too many ways to look at".into(), span));
            }
        }
        at += 1;
    }
    sets.remove(0);
    Ok(sets)
}

fn pairs_of(class: &[NameId]) -> impl Iterator<Item = [NameId; 2]> + '_ {
    let places = 0..class.len();
    places.flat_map(move |at| class[at + 1..].iter().map(move |&right| [class[at], right]))
}

fn unclear(why: String, span: Span) -> Vec<Problem> {
    let message = format!("this `alias` is not proved: {why}");
    vec![Diagnostic::error("too-many-cases", message, span).into()]
}

/// "`v2` and `v3`, and `a` and `b`"
fn words(rule: &Rule, classes: &[Vec<NameId>]) -> String {
    classes.iter().map(|class| enumerate(rule, class)).collect::<Vec<_>>().join(", and ")
}

fn breaks(
    rule: &Rule,
    classes: &[Vec<NameId>],
    wanted: &[([NameId; 2], Span)],
    why: &str,
) -> Problem {
    let of_pair = |pair: [NameId; 2]| wanted.iter().find(|(known, _)| *known == pair);
    let mut pairs = classes.iter().flat_map(|class| pairs_of(class));
    let span = pairs.find_map(of_pair).map_or(rule.span, |(_, span)| *span);
    let names = words(rule, classes);
    let message = format!("{names} must not be one");
    Diagnostic::error("alias-breaks", message, span)
        .saying("may be one here")
        .note(format!("where they are, {why}"))
        .into()
}

/// The problem of names that an `alias` lists, but that are one in no match.
fn never_one(rule: &Rule, pair: [NameId; 2], span: Span) -> Problem {
    let names = words(rule, &[pair.to_vec()]);
    let count = rule.names.len();
    match united(&Quotient::of(rule), pair) {
        Ok(quotients) => {
            let needs = quotients.iter().map(|quotient| quotient.classes(count));
            let impossible = |quotient: &Quotient| match laws(&quotient.clone().finished()) {
                Err(Failed::Impossible(why)) => Some(why),
                _ => None,
            };
            let never: Vec<_> = quotients.iter().filter_map(impossible).collect();
            if never.len() == quotients.len() {
                return impossible_alias(&names, never.first(), span);
            }
            let others = needs.min_by_key(|classes| classes.iter().map(Vec::len).sum::<usize>());
            let others: Vec<_> = others.into_iter().flatten().collect();
            let message = format!("{names} are one only where other names are one too");
            let lists = others.iter().map(|class| {
                let words = class.iter().map(|&name| rule.name(name).text.as_str());
                format!("`alias {}`", words.collect::<Vec<_>>().join(" "))
            });
            let lists = lists.collect::<Vec<_>>().join(", ");
            Diagnostic::error("alias-incomplete", message, span)
                .saying("so a test refuses it all the same")
                .note(format!("together they are {lists}"))
                .into()
        }
        Err(Contradiction::Certain(why) | Contradiction::Unclear(why)) => {
            impossible_alias(&names, Some(&why), span)
        }
    }
}

fn impossible_alias(names: &str, why: Option<&String>, span: Span) -> Problem {
    let message = format!("{names} are never one");
    let error = Diagnostic::error("alias-impossible", message, span);
    match why {
        Some(why) => error.note(why.clone()).into(),
        None => error.into(),
    }
}

impl Aliased {
    /// The number of cases that were examined beyond those where all names are distinct.
    pub fn cases(&self) -> usize {
        self.cases
    }

    /// The obligations of a level, including those where names are one. A statement is tested if it
    /// has to be tested in one of these cases: each is a condition of the level, so the further
    /// tests refuse nothing else.
    pub fn obligations(&self, mut found: Vec<Obligation>, level: Level) -> Vec<Obligation> {
        for quotient in &self.quotients {
            let drawing = Drawing::new(&quotient.rule);
            for Obligation { mut statement, because, .. } in obligations(&drawing, level) {
                if statement.condition == Condition::OneHoleAlong {
                    statement.of = quotient.path_of(statement.of);
                }
                add_obligation(statement, because, &mut found);
            }
        }
        found
    }

    /// Removes from the properties that a rule keeps those that it does not keep where names are
    /// one, and notes the degrees and sizes that change in another way there.
    pub fn keeps_no_more(&self, facts: &mut Facts) {
        for quotient in &self.quotients {
            let drawing = Drawing::new(&quotient.rule);
            let here = kept(&drawing, Change::of(&quotient.rule), &facts.grows_with);
            facts.keeps.retain(|property| here.contains(property));
            for (changes, here) in [
                (&mut facts.degrees, degree_changes(&drawing)),
                (&mut facts.sizes, size_changes(&drawing)),
            ] {
                for change in changes {
                    let one = quotient.one_for(&change.element);
                    let here = here.iter().find(|here| here.element == one);
                    let parts = |it: &SizeChange| (it.constant, it.gains.len(), it.loses.len());
                    change.varies |= here.map(parts) != Some(parts(change));
                }
            }
        }
    }
}
