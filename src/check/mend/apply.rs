//! Repairs applied to a rule.

use super::super::fan_repair::Taken;
use super::super::problem::Repair;
use crate::diagram::{Drawing, Edge, Kind, Loop, LoopItem, Name, NameId, Ref, Role, Rule, Side};
use crate::source::Span;

impl Repair {
    /// The rule with this repair applied, if that is possible.
    pub(in super::super) fn apply(&self, rule: &Rule) -> Option<Rule> {
        let mut mended = rule.clone();
        let span = rule.after.span;
        let mention = |name: NameId| Ref::plain(name, span);
        match self {
            Repair::Erase(names) => {
                mended.erased.extend(members(rule, names).map(mention));
            }
            Repair::Create(names) => {
                if names.iter().any(|&name| rule.params.contains(&Some(name))) {
                    return None;
                }
                mended.created.extend(members(rule, names).map(mention));
            }
            Repair::Keep(names) => {
                let before = Drawing::new(rule).before;
                for name in members(rule, names) {
                    let after = &mut mended.after;
                    match rule.kind(name) {
                        Kind::Edge => after.edges.push(before.edge_statement(name)?.clone()),
                        Kind::Face => after.loops.push(before.loop_of_face(name)?.clone()),
                        Kind::Vertex => after.stars.extend(before.star(name).cloned()),
                        Kind::Halfedge | Kind::Path | Kind::Fan => return None,
                    }
                    after.kept.push(mention(name));
                }
            }
            Repair::Take(erased) => {
                let taken = Taken::of(rule, *erased)?;
                mended.names.extend(taken.fan);
                mended.before.stars.extend(taken.before);
                let taker = taken.after.vertex.name;
                mended.after.stars.retain(|star| star.vertex.name != taker);
                mended.after.stars.push(taken.after);
            }
            Repair::Insert { face, at, from, item } => {
                let orbits = &mut mended.after.loops;
                let orbit = orbits.iter_mut().find(|orbit| orbit.face.name == *face)?;
                let [from, item] = [*from, *item].map(mention);
                orbit.items.insert(*at, LoopItem { from, item });
            }
            Repair::Rename { old, new } => {
                let mentions = mended.before.mentions_mut();
                mentions.filter(|at| at.name == *old).for_each(|at| at.name = *new);
            }
            Repair::Pair(edges) => {
                for &(edge, halfedges) in edges {
                    mended.after.kept.retain(|kept| kept.name != edge);
                    pair(&mut mended.after, edge, halfedges, span);
                }
            }
            Repair::PairAll(pairs) => {
                for (&halfedges, text) in pairs.iter().zip(edge_names(rule, pairs.len())) {
                    let edge = name_edge(&mut mended, text)?;
                    mended.created.push(mention(edge));
                    pair(&mut mended.after, edge, halfedges, span);
                }
            }
            Repair::DrawTwins(halves) => {
                for &half in halves {
                    let [edge, twin] = words_of_twin(&mended, half);
                    let edge = name_edge(&mut mended, edge)?;
                    let name =
                        Name { text: twin, kind: Kind::Halfedge, ..mended.name(edge).clone() };
                    mended.names.push(name);
                    let twin = NameId(edge.0 + 1);
                    pair(&mut mended.before, edge, [half, twin], rule.before.span);
                }
            }
            Repair::Draw { face, items } => {
                let mut drawn = Drawing::new(rule).before.loop_of_face(*face)?.clone();
                let item = |&(from, item): &(NameId, NameId)| LoopItem {
                    from: mention(from),
                    item: mention(item),
                };
                drawn.items = items.iter().map(item).collect();
                drawn.end = mention(items.first()?.0);
                drawn.span = span;
                mended.after.loops.push(drawn);
            }
            Repair::Turn(statement) => {
                let mut orbits = mended.before.loops.iter_mut().chain(&mut mended.after.loops);
                turn(orbits.find(|orbit| orbit.span == *statement)?)?;
            }
            Repair::Redraw { loops, .. } => mended.after.loops.clone_from(loops),
            Repair::All(repairs) => {
                for repair in repairs {
                    mended = repair.apply(&mended)?;
                }
            }
        }
        Some(mended)
    }
}

/// All members of the families of these names, and those that are in no family.
fn members(rule: &Rule, names: &[NameId]) -> impl Iterator<Item = NameId> {
    let firsts: Vec<_> = names.iter().map(|&name| rule.first_member(name)).collect();
    rule.ids().filter(move |&name| firsts.contains(&rule.first_member(name)))
}

/// Pairs halfedges in an edge, which has others so far or no statement.
fn pair(side: &mut Side, edge: NameId, halfedges: [NameId; 2], span: Span) {
    let halfedges = halfedges.map(|half| Ref::plain(half, span));
    match side.edges.iter_mut().find(|statement| statement.edge.name == edge) {
        Some(statement) => statement.halfedges = halfedges,
        None => side.edges.push(Edge { edge: Ref::plain(edge, span), halfedges, span }),
    }
}

/// Adds the name of an edge to a rule.
fn name_edge(rule: &mut Rule, text: String) -> Option<NameId> {
    let (kind, role, span) = (Kind::Edge, Role::Single, rule.after.span);
    rule.names.push(Name { text, kind, named: true, role, span });
    Some(NameId(u32::try_from(rule.names.len()).ok()? - 1))
}

/// Turns the statement of a loop round: each item runs from where it ended to where it started.
pub(super) fn turn(orbit: &mut Loop) -> Option<()> {
    let first = orbit.items.first()?.from;
    if orbit.each || orbit.end.name != first.name {
        return None;
    }
    let ends = orbit.items.iter().skip(1).map(|item| item.from).chain([first]);
    let turned = orbit.items.iter().zip(ends).map(|(item, end)| LoopItem { from: end, ..*item });
    let mut turned: Vec<_> = turned.collect();
    // It begins where it began.
    turned.reverse();
    orbit.items = turned;
    Some(())
}

/// Unused names for new edges.
pub(super) fn edge_names(rule: &Rule, count: usize) -> Vec<String> {
    let free = (1..).map(|number| format!("e{number}"));
    let known = |name: &Name| name.text.split('[').next().unwrap_or_default().to_owned();
    let is_free = |word: &String| rule.names.iter().all(|name| known(name) != *word);
    free.filter(is_free).take(count).collect()
}

/// Unused names for the edge of a halfedge and for its outer twin.
fn words_of_twin(rule: &Rule, half: NameId) -> [String; 2] {
    let word = &rule.name(half).text;
    let mut twin = format!("{word}'");
    while rule.names.iter().any(|name| name.text == twin) {
        twin.push('\'');
    }
    [rule.free_name(&format!("e{word}")), twin]
}
