//! Repairs for everything that is wrong with a rule at once.
//!
//! A person seldom forgets one name, but an `erase` line, or an edge and a name in `new`. And two
//! names that are exchanged look like many other mistakes. So whole repairs are put together and
//! tried, in tiers, the simplest first.

use strsim::damerau_levenshtein;

use super::pairing::{kept_loops, missing_loops, pairing, pairings};
use super::problem::{Repair, enumerate};
use super::unknown_names::is_unknown;
use crate::diagram::{Drawing, Expr, ExprKind, Kind, Loop, NameId, Rule};

/// The most vertices, or halfedges, of a rule that is searched for two that are exchanged.
const MOST_EXCHANGED: usize = 16;

/// The most forgotten vertices of which it is tried which are kept, and which erased.
const MOST_FORGOTTEN: usize = 4;

/// The most loops of a rule that are closed together.
const MOST_OPEN: usize = 2;

/// A tier: the repairs of a rule that are equally simple.
pub(super) type Tier = fn(&Rule) -> Vec<Repair>;

pub(super) const TIERS: [Tier; 7] = [
    misspelt,
    accounted_for,
    |rule| exchanged(rule, Kind::Vertex),
    |rule| exchanged(rule, Kind::Halfedge),
    unmoved,
    other_corner,
    outer_twins,
];

/// Writes a name that stands in `before` alone as a similar one of its kind that `after` draws.
fn misspelt(rule: &Rule) -> Vec<Repair> {
    if rule.cycle.is_some() {
        return Vec::new();
    }
    let drawing = &Drawing::new(rule);
    let is_alone = |&old: &NameId| {
        drawing.survives(old) && drawing.after.mention(old).is_none() && !is_named(rule, old)
    };
    let repairs = elements(rule).filter(is_alone).flat_map(|old| {
        let others = rule.names_of(rule.kind(old));
        let meant = others.filter(move |&new| {
            let is_drawn = drawing.before.mention(new).is_some();
            drawing.after.mention(new).is_some() && is_slip(rule, old, new, is_drawn)
        });
        meant.map(move |new| Repair::Rename { old, new })
    });
    repairs.collect()
}

/// True if a name may be a misspelling of another; where that stands beside it, only if a letter is
/// doubled, or capital.
fn is_slip(rule: &Rule, old: NameId, new: NameId, is_beside: bool) -> bool {
    let [old, new] = [old, new].map(|name| rule.name(name).text.to_lowercase());
    let letters = |word: &str| {
        let mut letters: Vec<_> = word.chars().collect();
        letters.dedup();
        letters
    };
    letters(&old) == letters(&new) || !is_beside && damerau_levenshtein(&old, &new) <= 1
}

/// True if a name is a parameter or the result, or stands in a condition or an assignment.
fn is_named(rule: &Rule, name: NameId) -> bool {
    let conditions = rule.requires.iter().map(|require| &require.condition);
    let values = rule.assignments.iter().map(|assignment| &assignment.value);
    let stands_in = |expr: &Expr| {
        let mut found = false;
        expr.each(&mut |part| found |= part.kind == ExprKind::Element(name));
        found
    };
    is_used(rule, name)
        || rule.params.contains(&Some(name))
        || conditions.chain(values).any(stands_in)
}

/// Accounts for all names: lists, draws and pairs whatever is missing. A misspelt parameter is not
/// new.
fn accounted_for(rule: &Rule) -> Vec<Repair> {
    let unknown = unknown(rule);
    let mut params = forgotten(rule);
    params.retain(|&name| rule.params.contains(&Some(name)));
    let is_misspelt = |&new: &NameId| {
        let mut same_kind = params.iter().filter(|&&old| rule.kind(old) == rule.kind(new));
        same_kind.any(|&old| is_slip(rule, old, new, false))
    };
    if unknown.iter().any(is_misspelt) {
        return Vec::new();
    }
    let mut begun = vec![Begun { repairs: Vec::new(), rule: rule.clone() }];
    if !unknown.is_empty() {
        begun = begun.iter().filter_map(|one| one.with(Repair::Create(unknown.clone()))).collect();
    }
    go_on(&mut begun, |rule| {
        let drawing = &Drawing::new(rule);
        let drawn = missing_loops(drawing).map(Repair::All);
        drawn.into_iter().chain(kept_loops(drawing)).collect()
    });
    go_on(&mut begun, |rule| pairings(&Drawing::new(rule)));
    let whole = begun.iter().flat_map(Begun::account_for_the_rest);
    whole.filter(|one| !one.repairs.is_empty()).map(|one| Repair::All(one.repairs)).collect()
}

/// Repairs, and the rule with them applied.
#[derive(Clone)]
struct Begun {
    repairs: Vec<Repair>,
    rule: Rule,
}

/// Adds to each of these the same with one more repair, for each that there is.
fn go_on(begun: &mut Vec<Begun>, more: impl Fn(&Rule) -> Vec<Repair>) {
    let longer = begun
        .iter()
        .flat_map(|one| more(&one.rule).into_iter().filter_map(|repair| one.with(repair)));
    let longer: Vec<_> = longer.collect();
    begun.extend(longer);
}

impl Begun {
    fn with(&self, repair: Repair) -> Option<Self> {
        let rule = repair.apply(&self.rule)?;
        let repairs = self.repairs.iter().cloned().chain([repair]).collect();
        Some(Self { repairs, rule })
    }

    /// The ways to keep or erase what is left.
    fn account_for_the_rest(&self) -> Vec<Self> {
        let forgotten = forgotten(&self.rule);
        let (vertices, others): (Vec<_>, Vec<_>) =
            forgotten.into_iter().partition(|&name| self.rule.kind(name) == Kind::Vertex);
        let (orbits, halves): (Vec<_>, Vec<_>) =
            others.iter().partition(|&&name| self.rule.kind(name) != Kind::Halfedge);
        let mut found = self.keep_or_erase(&vertices, &others);
        if !orbits.is_empty() {
            let kept = self.with(Repair::Keep(orbits));
            found.extend(kept.iter().flat_map(|kept| kept.keep_or_erase(&vertices, &[])));
        }
        if !halves.is_empty() && halves.len() < others.len() {
            found.extend(self.keep_or_erase(&vertices, &halves));
        }
        found
    }

    /// The ways to keep some vertices, and erase the others with these names.
    fn keep_or_erase(&self, vertices: &[NameId], erased: &[NameId]) -> Vec<Self> {
        let choices = match vertices.len() {
            0..=MOST_FORGOTTEN => 0..1_usize << vertices.len(),
            _ => 0..1,
        };
        choices.flat_map(|choice| self.choose(vertices, choice, erased)).collect()
    }

    /// One of these ways; and the same where another vertex takes the spokes of an erased one.
    fn choose(&self, vertices: &[NameId], choice: usize, erased: &[NameId]) -> Vec<Self> {
        let chosen = (0..vertices.len()).filter(|at| choice >> at & 1 == 1);
        let chosen: Vec<_> = chosen.map(|at| vertices[at]).collect();
        let gone: Vec<_> = chosen.into_iter().chain(erased.iter().copied()).collect();
        if gone.iter().any(|&name| is_used(&self.rule, name)) {
            return Vec::new();
        }
        let erased = match gone.is_empty() {
            true => Some(self.clone()),
            false => self.with(Repair::Erase(gone)),
        };
        let Some(erased) = erased else { return Vec::new() };
        let gone = erased.rule.erased.iter().map(|erased| erased.name);
        let gone = gone.filter(|&name| self.rule.kind(name) == Kind::Vertex);
        let taken = gone.filter_map(|vertex| erased.with(Repair::Take(vertex)));
        taken.filter_map(|taken| taken.keep_vertices()).chain(erased.keep_vertices()).collect()
    }

    /// Keeps the vertices that are still forgotten.
    fn keep_vertices(&self) -> Option<Self> {
        let vertices = forgotten(&self.rule);
        let vertices = vertices.into_iter().filter(|&name| self.rule.kind(name) == Kind::Vertex);
        let vertices: Vec<_> = vertices.collect();
        if vertices.is_empty() { Some(self.clone()) } else { self.with(Repair::Keep(vertices)) }
    }
}

/// True if a name is returned, or is given an attribute.
pub(super) fn is_used(rule: &Rule, name: NameId) -> bool {
    let targets = rule.assignments.iter().map(|assignment| assignment.target);
    let mut used = targets.chain(rule.result).map(|used| rule.first_member(used.name));
    used.any(|used| used == name)
}

/// The elements of `after` that nothing introduces; of a family the first member.
fn unknown(rule: &Rule) -> Vec<NameId> {
    let drawing = Drawing::new(rule);
    elements(rule).filter(|&name| is_unknown(&drawing, name)).collect()
}

/// The elements of `before` that stand nowhere in `after`; of a family the first member.
fn forgotten(rule: &Rule) -> Vec<NameId> {
    let drawing = Drawing::new(rule);
    let is_forgotten =
        |&name: &NameId| drawing.survives(name) && drawing.after.mention(name).is_none();
    elements(rule).filter(is_forgotten).collect()
}

/// The elements of a rule, kind by kind; of a family the first member.
fn elements(rule: &Rule) -> impl Iterator<Item = NameId> {
    let order = [Kind::Vertex, Kind::Halfedge, Kind::Edge, Kind::Face];
    order.into_iter().flat_map(|kind| rule.names_of(kind)).filter(|&name| rule.is_first(name))
}

/// Exchanges two names of a kind in all loops, or in one. If both stand in `before`, that may be what
/// is wrong; then what else is said about one of them would be about the other.
fn exchanged(rule: &Rule, kind: Kind) -> Vec<Repair> {
    let mut drawn: Vec<NameId> = Vec::new();
    for mention in rule.after.loops.iter().flat_map(mentions) {
        let first = rule.first_member(mention);
        if rule.kind(first) == kind && !drawn.contains(&first) {
            drawn.push(first);
        }
    }
    if drawn.len() > MOST_EXCHANGED || kind == Kind::Vertex && has_doubtful_corner(rule) {
        return Vec::new();
    }
    let pairs = drawn
        .iter()
        .enumerate()
        .flat_map(|(at, &one)| drawn[at + 1..].iter().map(move |&other| (one, other)));
    let drawing = Drawing::new(rule);
    let alike = pairs.filter(|&(one, other)| {
        let pair = [one, other];
        let may_be_before = pair.iter().all(|&name| drawing.before.mention(name).is_some());
        rule.is_member(one) == rule.is_member(other)
            && !(may_be_before && pair.iter().any(|&name| is_named(rule, name)))
    });
    let repairs = alike.flat_map(|(one, other)| {
        let exchange = move |name: NameId| match rule.first_member(name) {
            first if first == one => rule.turned(other, rule.index(name).into()),
            first if first == other => rule.turned(one, rule.index(name).into()),
            _ => name,
        };
        let words = format!("exchange {} and {}", rule.quoted(one), rule.quoted(other));
        let everywhere = format!("{words} in the loops of `after`");
        let everywhere = redraw(rule, |_, name| exchange(name), everywhere);
        let faces = rule.after.loops.iter().map(|orbit| orbit.face.name);
        let in_one = faces.filter(|&face| rule.is_first(face)).filter_map(move |face| {
            let how = format!("{words} in the loop of {}", rule.quoted(face));
            let in_loop = |orbit: &Loop, name| match rule.first_member(orbit.face.name) == face {
                true => exchange(name),
                false => name,
            };
            redraw(rule, in_loop, how)
        });
        everywhere.into_iter().chain(in_one)
    });
    repairs.collect()
}

/// True if a corner may be mistyped in `before`: a loop meets a vertex twice there, and `after` draws
/// one that nothing introduces.
fn has_doubtful_corner(rule: &Rule) -> bool {
    let is_doubtful = |&name: &NameId| rule.kind(name) == Kind::Vertex;
    rule.before.loops.iter().any(|orbit| orbit.corner_met_twice().is_some())
        && unknown(rule).iter().any(is_doubtful)
}

/// Writes another vertex at one corner of a loop.
fn other_corner(rule: &Rule) -> Vec<Repair> {
    let vertices: Vec<_> = rule.names_of(Kind::Vertex).collect();
    if rule.cycle.is_some() || vertices.len() > MOST_EXCHANGED || has_doubtful_corner(rule) {
        return Vec::new();
    }
    let mut repairs = Vec::new();
    for orbit in &rule.after.loops {
        for at in 0..orbit.items.len() {
            let corner = orbit.items[at].from.name;
            let others = vertices.iter().filter(|&&other| other != corner);
            repairs.extend(others.filter_map(|&other| {
                let [new, old, face] =
                    [other, corner, orbit.face.name].map(|name| rule.quoted(name));
                let how = format!("write {new} for {old} in the loop of {face}");
                let mut loops = rule.after.loops.clone();
                let changed = loops.iter_mut().find(|one| one.face.name == orbit.face.name)?;
                changed.items[at].from.name = other;
                if at == 0 {
                    changed.end.name = other;
                }
                Some(Repair::Redraw { loops, how })
            }));
        }
    }
    repairs
}

/// Lets every halfedge stay where it was, if its twin is not drawn: there it stays, too.
fn unmoved(rule: &Rule) -> Vec<Repair> {
    let drawing = Drawing::new(rule);
    let moved = moved_alone(&drawing);
    let stays = |half: NameId| {
        if !moved.contains(&half) {
            return Some(half);
        }
        let place = drawing.after.loop_ends(half);
        let mut here = moved.iter().filter(|&&of| drawing.before.loop_ends(of) == place);
        here.next().copied().filter(|_| here.next().is_none())
    };
    if moved.is_empty() || rule.cycle.is_some() || moved.iter().any(|&half| stays(half).is_none()) {
        return Vec::new();
    }
    let list = enumerate(rule, &moved);
    let how =
        format!("let {list} stay where they were: change their places in the loops of `after`");
    redraw(rule, |_, name| stays(name).unwrap_or(name), how).into_iter().collect()
}

/// Draws the twins outside of halfedges that move, and pairs them anew.
fn outer_twins(rule: &Rule) -> Vec<Repair> {
    let moved = moved_alone(&Drawing::new(rule));
    if moved.is_empty() || rule.cycle.is_some() {
        return Vec::new();
    }
    let begun = Begun { repairs: Vec::new(), rule: rule.clone() };
    let drawn = begun.with(Repair::DrawTwins(moved));
    let paired = drawn.and_then(|drawn| drawn.with(pairing(&Drawing::new(&drawn.rule))?));
    paired.map(|paired| Repair::All(paired.repairs)).into_iter().collect()
}

/// The halfedges whose ends change though their twins are drawn nowhere; of a family the first.
pub(super) fn moved_alone(drawing: &Drawing) -> Vec<NameId> {
    let rule = drawing.rule;
    let firsts = rule.names_of(Kind::Halfedge).filter(|&half| rule.is_first(half));
    let moved = firsts.filter(|&half| {
        let is_alone =
            drawing.before.pairing(half).is_none() && drawing.after.pairing(half).is_none();
        let [before, after] = [&drawing.before, &drawing.after].map(|view| view.loop_ends(half));
        is_alone && before.is_some() && after.is_some() && before != after
    });
    moved.collect()
}

/// The names of the corners and items of a loop.
fn mentions(orbit: &Loop) -> impl Iterator<Item = NameId> {
    orbit.items.iter().flat_map(|item| [item.from.name, item.item.name])
}

/// The repair that writes other names in the loops of `after`; `None` if `keep` states one of these
/// loops, or nothing changes.
fn redraw(rule: &Rule, new: impl Fn(&Loop, NameId) -> NameId, how: String) -> Option<Repair> {
    let mut loops = rule.after.loops.clone();
    for (orbit, old) in loops.iter_mut().zip(&rule.after.loops) {
        for item in &mut orbit.items {
            item.from.name = new(old, item.from.name);
            item.item.name = new(old, item.item.name);
        }
        orbit.end.name = new(old, orbit.end.name);
        let is_kept = rule.after.kept.iter().any(|kept| kept.name == orbit.face.name);
        if is_kept && *orbit != *old {
            return None;
        }
    }
    (loops != rule.after.loops).then_some(Repair::Redraw { loops, how })
}

/// Closes the loops of `after` that do not end where they begin: by another end, or another
/// beginning; the vertex that is replaced may have changed places with one in between.
pub(super) fn closed(rule: &Rule) -> Vec<Repair> {
    let ways: Vec<_> = rule.after.loops.iter().map(|orbit| ways_to_close(rule, orbit)).collect();
    let is_open = |(_, ways): &(&Loop, &Vec<_>)| ways.len() > 1;
    let open = rule.after.loops.iter().zip(&ways).filter(is_open);
    // All members of a family are written in one statement.
    let mut statements: Vec<_> = open.map(|(orbit, ways)| (orbit.span, ways.len())).collect();
    statements.dedup_by_key(|(span, _)| *span);
    if statements.is_empty() || statements.len() > MOST_OPEN {
        return Vec::new();
    }
    let mut choices: Vec<Vec<usize>> = vec![Vec::new()];
    for (_, count) in &statements {
        let longer = choices.iter().flat_map(|chosen| {
            (0..*count).map(move |way| chosen.iter().copied().chain([way]).collect())
        });
        choices = longer.collect();
    }
    let repairs = choices.iter().filter_map(|chosen| {
        let chosen: Vec<_> = statements.iter().map(|(span, _)| *span).zip(chosen).collect();
        let mut loops = Vec::new();
        let mut how: Vec<String> = Vec::new();
        for (orbit, ways) in rule.after.loops.iter().zip(&ways) {
            let way = chosen.iter().find(|(span, _)| *span == orbit.span);
            let (closed, told) = ways.get(way.map_or(0, |(_, way)| **way))?;
            loops.push(closed.clone());
            how.extend(told.clone().filter(|_| rule.is_first(orbit.face.name)));
        }
        Some(Repair::Redraw { loops, how: how.join(", and ") })
    });
    repairs.collect()
}

/// The ways to close a loop, each with its words; the loop itself if it is closed.
fn ways_to_close(rule: &Rule, orbit: &Loop) -> Vec<(Loop, Option<String>)> {
    let end = orbit.end.name;
    let Some(begin) = orbit.items.first().map(|first| first.from.name) else { return Vec::new() };
    // A loop drawn with `each` is closed.
    if begin == end || orbit.each {
        return vec![(orbit.clone(), None)];
    }
    let face = rule.quoted(orbit.face.name);
    let [begins, ends] = [begin, end].map(|name| rule.quoted(name));
    let with = |corner: NameId, at: Option<usize>, other: NameId, how: String| {
        let mut closed = orbit.clone();
        if let Some(at) = at {
            closed.items[at].from.name = other;
        }
        closed.items[0].from.name = corner;
        closed.end.name = corner;
        (closed, Some(how))
    };
    let exchange = format!("exchange {begins} and {ends} in the loop of {face}");
    let corners = 1..orbit.items.len();
    let exchanged = corners.filter_map(|at| match orbit.items[at].from.name {
        name if name == end => Some(with(end, Some(at), begin, exchange.clone())),
        name if name == begin => Some(with(begin, Some(at), end, exchange.clone())),
        _ => None,
    });
    let ways = [
        with(begin, None, begin, format!("end at {begins}")),
        with(end, None, end, format!("begin at {ends}")),
    ];
    ways.into_iter().chain(exchanged).collect()
}
