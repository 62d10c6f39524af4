//! A rule in which some names are one.

use super::overlap::Overlap;
use crate::diagram::{Kind, Loop, LoopItem, NameId, Ref, Rule, Side, Spoke, Star};

/// A rule in which some names are one. The numbers of its names are those of the rule it comes
/// from; pieces of paths have further ones.
#[derive(Clone, Debug)]
pub(in crate::check) struct Quotient {
    /// The rule, written with one name for each element.
    pub rule: Rule,
    /// For each name, the one that stands for it.
    stands_for: Vec<NameId>,
    /// For each path that is cut, or holds a named halfedge, its pieces.
    runs: Vec<Option<Vec<LoopItem>>>,
    /// Contradictory statements about one element, in words.
    pub clashes: Vec<String>,
}

impl Quotient {
    /// The rule itself: no two names are one.
    pub fn of(rule: &Rule) -> Self {
        let mut rule = rule.clone();
        // Conditions on a match do not affect the drawing.
        rule.requires.clear();
        rule.aliases.clear();
        let count = rule.names.len();
        Self {
            rule,
            stands_for: (0..count as u32).map(NameId).collect(),
            runs: vec![None; count],
            clashes: Vec::new(),
        }
    }

    /// The name that stands for a name.
    pub fn stands_for(&self, name: NameId) -> NameId {
        self.stands_for[name.index()]
    }

    /// The items of a path of the rule it comes from; `None` if it is still a path.
    pub fn run(&self, path: NameId) -> Option<&[LoopItem]> {
        self.runs[path.index()].as_deref()
    }

    /// The text of the name that stands for one with some text.
    pub fn one_for<'a>(&'a self, text: &'a str) -> &'a str {
        let at = self.rule.names.iter().position(|name| name.text == text);
        at.map_or(text, |at| &self.rule.name(self.stands_for(NameId(at as u32))).text)
    }

    /// The path of the rule it comes from in which a piece lies.
    pub fn path_of(&self, piece: NameId) -> NameId {
        let holds =
            |run: &Option<Vec<LoopItem>>| run.iter().flatten().any(|item| item.item.name == piece);
        let at = self.runs.iter().position(holds);
        at.map_or(piece, |at| NameId(at as u32))
    }

    /// The names of the rule it comes from that are one, in sets; without edges, which are one
    /// where their halfedges are, and without fans, which are one where their vertices are.
    pub fn classes(&self, count: usize) -> Vec<Vec<NameId>> {
        let mut classes: Vec<Vec<NameId>> = Vec::new();
        for name in (0..count as u32).map(NameId) {
            let one = self.stands_for(name);
            if one == name || matches!(self.rule.kind(name), Kind::Edge | Kind::Fan) {
                continue;
            }
            match classes.iter_mut().find(|class| class[0] == one) {
                Some(class) => class.push(name),
                None => classes.push(vec![one, name]),
            }
        }
        for class in &mut classes {
            class.sort_unstable();
        }
        classes.sort_unstable();
        classes
    }

    /// Makes two names one. The first mentioned stays.
    pub fn unite(&mut self, left: NameId, right: NameId) {
        let (stays, goes) = (left.min(right), left.max(right));
        for one in &mut self.stands_for {
            if *one == goes {
                *one = stays;
            }
        }
        let rename = |mention: &mut Ref| {
            if mention.name == goes {
                mention.name = stays;
            }
        };
        let rule = &mut self.rule;
        for side in [&mut rule.before, &mut rule.after] {
            side.mentions_mut().for_each(rename);
        }
        for run in self.runs.iter_mut().flatten() {
            for item in run {
                rename(&mut item.from);
                rename(&mut item.item);
            }
        }
        rule.created.iter_mut().for_each(rename);
        rule.erased.iter_mut().for_each(rename);
        rule.result.iter_mut().for_each(rename);
        for assignment in &mut rule.assignments {
            rename(&mut assignment.target);
        }
        for name in rule.params.iter_mut().flatten() {
            if *name == goes {
                *name = stays;
            }
        }
        drop_repetitions(&mut self.rule.before);
    }

    /// Makes one loop of two of `before`, as they overlap.
    pub(super) fn overlay(&mut self, [first, second]: [usize; 2], overlap: Overlap) {
        let count = overlap.pieces.len();
        self.rule.names.extend(overlap.pieces);
        for number in self.rule.names.len() - count..self.rule.names.len() {
            self.stands_for.push(NameId(number as u32));
            self.runs.push(None);
        }
        let loops = &mut self.rule.before.loops;
        loops[first].end = overlap.items[0].from;
        loops[first].items = overlap.items;
        loops.remove(second);
        for (path, items) in overlap.runs {
            if matches!(items.as_slice(), [item] if item.item.name == path) {
                continue;
            }
            for orbit in &mut self.rule.after.loops {
                orbit.items = written_out(&orbit.items, path, &items);
                orbit.end = orbit.items.first().map_or(orbit.end, |item| item.from);
            }
            for run in self.runs.iter_mut().flatten() {
                *run = written_out(run, path, &items);
            }
            // A path of the rule it comes from; pieces are none.
            self.runs[path.index()] = Some(items);
        }
    }

    /// Makes one statement of two of `before` that list the same spokes of one vertex: between
    /// two of them lies one fan, which is empty where one statement has none there.
    pub(super) fn join_stars(&mut self, [first, second]: [usize; 2]) -> Result<(), String> {
        let stars = &self.rule.before.stars;
        let [one, other] = [first, second].map(|at| sectors(&stars[at].spokes));
        let turn = other.iter().position(|(spoke, _)| *spoke == one[0].0).unwrap_or(0);
        let count = one.len();
        let mut spokes = Vec::new();
        let (mut same, mut empty) = (Vec::new(), Vec::new());
        for at in 0..count.max(other.len()) {
            let mine = one.get(at).copied();
            let [(half, fan), (known, also)] =
                match (mine, other.get((turn + at) % other.len()).copied()) {
                    (Some(mine), Some(theirs)) if mine.0 == theirs.0 => [mine, theirs],
                    _ => {
                        let text = self.rule.quoted(stars[first].vertex.name);
                        return Err(format!("the spokes of {text} would lie in two orders"));
                    }
                };
            debug_assert_eq!(half, known);
            let span = stars[first].span;
            spokes.extend(half.map(|half| Spoke::Halfedge(Ref::plain(half, span))));
            match (fan, also) {
                (Some(Spoke::Fan(left)), Some(Spoke::Fan(right))) => {
                    same.push([left.name, right.name]);
                    spokes.push(Spoke::Fan(left));
                }
                (Some(Spoke::Rest(_)), Some(fan)) | (Some(fan), Some(_)) => spokes.push(fan),
                (Some(Spoke::Fan(fan)), None) | (None, Some(Spoke::Fan(fan))) => {
                    empty.push(fan.name);
                }
                _ => {}
            }
        }
        self.rule.before.stars[first].spokes = spokes;
        self.rule.before.stars.remove(second);
        let is_left =
            |spoke: &Spoke| !matches!(spoke, Spoke::Fan(fan) if empty.contains(&fan.name));
        let stars = &mut self.rule.after.stars;
        stars.iter_mut().for_each(|star| star.spokes.retain(is_left));
        stars.retain(|star| !star.spokes.is_empty());
        for [left, right] in same {
            self.unite(left, right);
        }
        Ok(())
    }

    /// The same, ready for the laws: repeated statements of `after` are left out, and contradictory
    /// ones are noted. After this no more names can be made one.
    pub fn finished(mut self) -> Self {
        drop_repetitions(&mut self.rule.after);
        let mut stars: Vec<Star> = Vec::new();
        for star in std::mem::take(&mut self.rule.after.stars) {
            let known = stars.iter_mut().find(|known| known.vertex.name == star.vertex.name);
            match known {
                None => stars.push(star),
                Some(known) => match joined(known, &star) {
                    Some(spokes) => known.spokes = spokes,
                    None => {
                        let text = self.rule.quoted(star.vertex.name);
                        self.clashes.push(format!("{text} would have two stars"));
                    }
                },
            }
        }
        self.rule.after.stars = stars;
        let rule = &mut self.rule;
        let faces = rule.after.loops.iter().map(|orbit| orbit.face.name);
        let edges = rule.after.edges.iter().map(|edge| edge.edge.name);
        let stated: Vec<_> = faces.chain(edges).collect();
        for (at, &name) in stated.iter().enumerate() {
            if stated[..at].contains(&name) {
                let what = match rule.kind(name) {
                    Kind::Edge => "pairs of halfedges",
                    _ => "loops",
                };
                let text = rule.quoted(name);
                self.clashes.push(format!("{text} would have two {what}"));
            }
        }
        let mut erased: Vec<Ref> = Vec::new();
        for mention in std::mem::take(&mut rule.erased) {
            if erased.iter().any(|known| known.name == mention.name) {
                let text = rule.quoted(mention.name);
                self.clashes.push(format!("{text} would be erased twice"));
            } else {
                erased.push(mention);
            }
        }
        rule.erased = erased;
        for (at, one) in rule.assignments.iter().enumerate() {
            let same = |other: &crate::diagram::Assignment| {
                other.target.name == one.target.name && other.attribute == one.attribute
            };
            if rule.assignments[..at].iter().any(same) {
                let (text, word) = (rule.quoted(one.target.name), rule.attribute(one.attribute));
                self.clashes.push(format!("the {word} of {text} would be assigned twice"));
            }
        }
        self
    }
}

/// The named spokes of a statement, each with the fan behind it; one entry without a name if there
/// is only a fan. Two fans never follow each other in `before`.
fn sectors(spokes: &[Spoke]) -> Vec<(Option<NameId>, Option<Spoke>)> {
    let count = spokes.len();
    let fan_at = |at: usize| Some(spokes[at % count]).filter(|spoke| spoke.halfedge().is_none());
    let named = (0..count).map(|at| (spokes[at].halfedge(), fan_at(at + 1)));
    let named: Vec<_> = named.filter(|(half, _)| half.is_some()).collect();
    if named.is_empty() { vec![(None, fan_at(0))] } else { named }
}

/// Loop items with a path replaced by its items, which start at the vertex where the path did.
fn written_out(items: &[LoopItem], path: NameId, run: &[LoopItem]) -> Vec<LoopItem> {
    let written = |item: &LoopItem| match item.item.name == path {
        false => vec![*item],
        true => {
            let mut run = run.to_vec();
            if let Some(first) = run.first_mut() {
                first.from = item.from;
            }
            run
        }
    };
    items.iter().flat_map(written).collect()
}

/// Drops statements that repeat an earlier one.
fn drop_repetitions(side: &mut Side) {
    keep_first(&mut side.loops, |one, other| {
        let names = |orbit: &Loop| -> Vec<_> {
            orbit.items.iter().map(|item| (item.from.name, item.item.name)).collect()
        };
        one.face.name == other.face.name
            && one.kind == other.kind
            && is_rotated(&names(one), &names(other))
    });
    keep_first(&mut side.edges, |one, other| {
        let [a, b] = one.halfedge_names();
        let [c, d] = other.halfedge_names();
        one.edge.name == other.edge.name && ((a, b) == (c, d) || (a, b) == (d, c))
    });
    keep_first(&mut side.stars, |one, other| {
        let names = |star: &Star| -> Vec<_> {
            let spokes = star.spokes.iter().map(|spoke| match spoke {
                Spoke::Halfedge(mention) | Spoke::Fan(mention) => Some(mention.name),
                Spoke::Rest(_) => None,
            });
            spokes.collect()
        };
        one.vertex.name == other.vertex.name && is_rotated(&names(one), &names(other))
    });
}

fn keep_first<T>(all: &mut Vec<T>, alike: impl Fn(&T, &T) -> bool) {
    let mut kept: Vec<T> = Vec::new();
    for one in all.drain(..) {
        if !kept.iter().any(|known| alike(known, &one)) {
            kept.push(one);
        }
    }
    *all = kept;
}

/// True if two cycles are the same up to rotation.
pub(in crate::check) fn is_rotated<T: PartialEq>(one: &[T], other: &[T]) -> bool {
    let rotated = |by: usize| one[by..].iter().chain(&one[..by]).eq(other);
    one.len() == other.len() && (0..one.len().max(1)).any(rotated)
}

/// The spokes of a vertex that two statements of `after` describe, if both have a rest: all of the
/// second can lie in the rest of the first.
fn joined(one: &Star, other: &Star) -> Option<Vec<Spoke>> {
    let rest = |star: &Star| {
        let is_rest = |spoke: &Spoke| matches!(spoke, Spoke::Rest(_));
        star.spokes.iter().position(is_rest)
    };
    let (at, from) = (rest(one)?, rest(other)?);
    let count = other.spokes.len();
    let inner = (1..count).map(|step| other.spokes[(from + step) % count]);
    let mut spokes = one.spokes[..=at].to_vec();
    spokes.extend(inner);
    spokes.extend(&one.spokes[at..]);
    Some(spokes)
}
