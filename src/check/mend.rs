//! Fixes that are certain: a remedy is offered only after the laws have been tested on the rule
//! with the remedy applied.

use super::fan_repair::Taken;
use super::problem::{Problem, Remedy, enumerate};
use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::diagram::{
    Drawing, Edge, Kind, Loop, LoopItem, LoopKind, Name, NameId, Ref, Role, Rule, Spoke, Star,
};
use crate::source::Span;

/// Adds to each problem the fix that removes it and causes no new one, if exactly one does.
pub(super) fn add_fixes(
    rule: &Rule,
    problems: Vec<Problem>,
    laws: impl Fn(&Rule) -> Vec<Problem>,
) -> Vec<Diagnostic> {
    let before: Vec<_> = problems.iter().map(|problem| problem.diagnostic.clone()).collect();
    let good = |remedy: &Remedy, at: usize| {
        let mended = remedy.apply(rule)?;
        let left = laws(&mended);
        let known = |problem: &Problem| {
            before.iter().enumerate().any(|(index, old)| {
                index != at
                    && old.code == problem.diagnostic.code
                    && old.message == problem.diagnostic.message
            })
        };
        // Problems of a later law may appear once the names are in order; the fix is then not
        // wrong, but no longer certain. Missing attributes of new elements do not count. What seems
        // to have been forgotten may be intended if something else is wrong: an erasure is offered
        // only if it leaves no problem.
        let good = match remedy {
            Remedy::Erase(_) => left.is_empty(),
            Remedy::Keep(_)
            | Remedy::Turn(_)
            | Remedy::Take(_)
            | Remedy::KeepAndTake { .. }
            | Remedy::Insert { .. }
            | Remedy::Pair { .. }
            | Remedy::PairAnew(_)
            | Remedy::PairAll(_)
            | Remedy::Draw { .. } => left.iter().all(|one| known(one) || lacks_attribute(one)),
            // Unknown names are certainly new if nothing but attributes of new elements is missing
            // then.
            Remedy::Create(names) => {
                // Vertices alone, without positions, may be meant to be other ones.
                let alone = names.iter().all(|&name| rule.kind(name) == Kind::Vertex);
                left.iter().all(|one| lacks_attribute(one) && !(alone && lacks_position(one)))
            }
            Remedy::CreateAndPair { .. } => left.iter().all(lacks_attribute),
        };
        let fix = good.then(|| remedy.fix(rule)).flatten()?;
        Some((fix, left.is_empty()))
    };
    let mut diagnostics = Vec::new();
    // The problems with a fix that mends all others, too.
    let mut causes = Vec::new();
    for (at, problem) in problems.into_iter().enumerate() {
        let mut diagnostic = problem.diagnostic;
        let found: Vec<_> = problem.remedies.iter().filter_map(|remedy| good(remedy, at)).collect();
        // A fix that mends everything is preferred to those that mend this problem alone.
        let all: Vec<_> = found.iter().filter(|(_, mends_all)| *mends_all).collect();
        let sure = match (found.as_slice(), all.as_slice()) {
            ([one], _) => Some(one),
            (_, &[one]) => Some(one),
            _ => None,
        };
        if let Some((fix, mends_all)) = sure {
            diagnostic.fixes.push(fix.clone());
            causes.extend(mends_all.then_some(at));
        }
        diagnostics.push(diagnostic);
    }
    match causes.as_slice() {
        &[cause] => vec![alone(diagnostics, cause)],
        _ => diagnostics,
    }
}

/// True if a new element is not given an attribute that it needs.
fn lacks_attribute(problem: &Problem) -> bool {
    problem.diagnostic.code == "missing-attribute"
}

/// True if a new vertex is given no position.
fn lacks_position(problem: &Problem) -> bool {
    lacks_attribute(problem) && problem.diagnostic.message.ends_with("has no position")
}

/// The diagnostic that is the cause of all others, with their notes about the mesh.
fn alone(mut diagnostics: Vec<Diagnostic>, cause: usize) -> Diagnostic {
    let mut told = diagnostics.swap_remove(cause);
    let of_mesh = |note: &String| {
        ["carried out literally", "whether this mesh", "on a cycle of"]
            .iter()
            .any(|words| note.starts_with(words))
    };
    let notes = diagnostics.into_iter().flat_map(|other| other.notes);
    told.notes.extend(notes.filter(of_mesh));
    told
}

impl Remedy {
    /// The rule with this remedy applied, if that is possible.
    fn apply(&self, rule: &Rule) -> Option<Rule> {
        let mut mended = rule.clone();
        let span = rule.after.span;
        match self {
            Remedy::Erase(names) => {
                mended.erased.extend(names.iter().map(|&name| Ref::plain(name, span)));
            }
            Remedy::Create(names) => {
                // All members of a family are created.
                let all = (0..rule.names.len() as u32).map(NameId);
                let created = all.filter(|&name| names.contains(&rule.first_member(name)));
                mended.created.extend(created.map(|name| Ref::plain(name, span)));
            }
            Remedy::CreateAndPair { created, pairs } => {
                let created = Remedy::Create(created.clone()).apply(rule)?;
                return Remedy::PairAll(pairs.clone()).apply(&created);
            }
            Remedy::Keep(names) => {
                let before = Drawing::new(rule).before;
                for &name in names {
                    let after = &mut mended.after;
                    match rule.kind(name) {
                        Kind::Edge => after.edges.push(before.edge_statement(name)?.clone()),
                        Kind::Face => after.loops.push(before.loop_of_face(name)?.clone()),
                        Kind::Vertex => after.stars.extend(before.star(name).cloned()),
                        Kind::Halfedge | Kind::Path | Kind::Fan => return None,
                    }
                    after.kept.push(Ref::plain(name, span));
                }
            }
            Remedy::Take(erased) => {
                let taken = Taken::of(rule, *erased)?;
                mended.names.extend(taken.fan);
                mended.before.stars.extend(taken.before);
                let taker = taken.after.vertex.name;
                mended.after.stars.retain(|star| star.vertex.name != taker);
                mended.after.stars.push(taken.after);
            }
            Remedy::KeepAndTake { kept, erased } => {
                let kept = kept_beside(rule, kept, *erased)?;
                let kept = Remedy::Keep(kept).apply(rule)?;
                return Remedy::Take(*erased).apply(&kept);
            }
            Remedy::Insert { face, at, from, item } => {
                let orbits = &mut mended.after.loops;
                let orbit = orbits.iter_mut().find(|orbit| orbit.face.name == *face)?;
                let [from, item] = [*from, *item].map(|name| Ref::plain(name, span));
                orbit.items.insert(*at, LoopItem { from, item });
            }
            Remedy::PairAll(pairs) => {
                let words = edge_names(rule, pairs.len());
                for (&halfedges, text) in pairs.iter().zip(words) {
                    let edge = NameId(u32::try_from(mended.names.len()).ok()?);
                    let (kind, role) = (Kind::Edge, Role::Single);
                    mended.names.push(Name { text, kind, named: true, role, span });
                    let mention = |name| Ref::plain(name, span);
                    mended.created.push(mention(edge));
                    let halfedges = halfedges.map(mention);
                    mended.after.edges.push(Edge { edge: mention(edge), halfedges, span });
                }
            }
            Remedy::Draw { face, items } => {
                let mut drawn = Drawing::new(rule).before.loop_of_face(*face)?.clone();
                let mention = |name| Ref::plain(name, span);
                let item = |&(from, item): &(NameId, NameId)| LoopItem {
                    from: mention(from),
                    item: mention(item),
                };
                drawn.items = items.iter().map(item).collect();
                drawn.end = mention(items.first()?.0);
                drawn.span = span;
                mended.after.loops.push(drawn);
            }
            Remedy::Turn(statement) => {
                let mut orbits = mended.before.loops.iter_mut().chain(&mut mended.after.loops);
                turn(orbits.find(|orbit| orbit.span == *statement)?)?;
            }
            Remedy::PairAnew(edges) => {
                for (edge, halfedges) in edges {
                    let mut statements = mended.after.edges.iter_mut();
                    let statement = statements.find(|statement| statement.edge.name == *edge)?;
                    statement.halfedges = halfedges.map(|half| Ref::plain(half, span));
                }
            }
            Remedy::Pair { edge, halfedges } => {
                let mention = |name| Ref::plain(name, span);
                let halfedges = halfedges.map(mention);
                mended.after.edges.push(Edge { edge: mention(*edge), halfedges, span });
            }
        }
        Some(mended)
    }

    /// The remedy as an edit of the source text.
    fn fix(&self, rule: &Rule) -> Option<Fix> {
        let words = |names: &[NameId]| {
            names.iter().map(|&name| rule.name(name).text.as_str()).collect::<Vec<_>>().join(" ")
        };
        let (statement, edit) = match self {
            Remedy::Erase(names) => {
                let list = words(names);
                match rule.erased.iter().max_by_key(|erased| erased.span.end) {
                    Some(last) => {
                        let title = format!("erase {}", enumerate(rule, names));
                        let edits =
                            vec![Edit { span: last.span.after(), text: format!(" {list}") }];
                        return Some(Fix { title, edits });
                    }
                    None => (format!("erase {list}"), end_of_after(rule)?),
                }
            }
            Remedy::Create(names) => {
                let title = format!("list {} in `new`", enumerate(rule, names));
                let edits = vec![list_in_new(rule, &words(names))?];
                return Some(Fix { title, edits });
            }
            Remedy::Keep(names) => match names.as_slice() {
                &[edge] if rule.kind(edge) == Kind::Edge => {
                    let view = Drawing::new(rule).before;
                    let statement = view.edge_statement(edge)?;
                    let [left, right] = statement.halfedges.map(|half| &rule.name(half.name).text);
                    (
                        format!("edge {}: {left} | {right}", rule.name(edge).text),
                        end_of_after(rule)?,
                    )
                }
                names => (format!("keep {}", words(names)), end_of_after(rule)?),
            },
            Remedy::Take(erased) => return take(rule, *erased, end_of_after(rule)?),
            Remedy::KeepAndTake { kept, erased } => {
                let kept = kept_beside(rule, kept, *erased)?;
                let keep = Remedy::Keep(kept);
                let take = take(&keep.apply(rule)?, *erased, end_of_after(rule)?)?;
                return Some(both(keep.fix(rule)?, take));
            }
            Remedy::Insert { face, at, from, item } => {
                let orbit = rule.after.loops.iter().find(|orbit| orbit.face.name == *face)?;
                let behind = orbit.items.get(*at).map_or(orbit.end, |item| item.from);
                if !rule.name(*item).named {
                    return None;
                }
                let drawn = format!("{} {}", rule.name(*from).text, arrow(rule, *item));
                let loop_of = rule.quoted(*face);
                let title = format!("draw `{drawn}` in the loop of {loop_of}");
                let text = format!("{drawn} ");
                return Some(Fix { title, edits: vec![Edit { span: behind.span.before(), text }] });
            }
            Remedy::Turn(statement) => {
                let mut orbits = rule.before.loops.iter().chain(&rule.after.loops);
                let mut turned = orbits.find(|orbit| orbit.span == *statement)?.clone();
                turn(&mut turned)?;
                let text = loop_statement(rule, &turned)?;
                let title = format!("draw it the other way round: `{text}`");
                return Some(Fix { title, edits: vec![Edit { span: *statement, text }] });
            }
            Remedy::PairAnew(edges) => return pair_anew(rule, edges),
            Remedy::PairAll(pairs) => return pair_all(rule, &[], pairs),
            Remedy::CreateAndPair { created, pairs } => return pair_all(rule, created, pairs),
            Remedy::Draw { .. } => {
                let mended = self.apply(rule)?;
                (loop_statement(rule, mended.after.loops.last()?)?, end_of_after(rule)?)
            }
            Remedy::Pair { edge, halfedges } => {
                let [left, right] = halfedges.map(|half| &rule.name(half).text);
                (format!("edge {}: {left} | {right}", rule.name(*edge).text), end_of_after(rule)?)
            }
        };
        let text = format!("\n    {statement}");
        Some(Fix { title: format!("insert `{statement}`"), edits: vec![Edit { span: edit, text }] })
    }
}

/// The fix that gives edge statements other halfedges.
fn pair_anew(rule: &Rule, edges: &[(NameId, [NameId; 2])]) -> Option<Fix> {
    let mut edits = Vec::new();
    for (edge, halfedges) in edges {
        let statement = rule.after.edges.iter().find(|one| one.edge.name == *edge)?;
        let [left, right] = halfedges.map(|half| &rule.name(half).text);
        let text = format!("edge {}: {left} | {right}", rule.name(*edge).text);
        edits.push(Edit { span: statement.span, text });
    }
    let written: Vec<_> = edits.iter().map(|edit| format!("`{}`", edit.text)).collect();
    Some(Fix { title: format!("write {}", written.join(" and ")), edits })
}

/// Turns the statement of a loop round: each item runs from where it ended to where it started.
fn turn(orbit: &mut Loop) -> Option<()> {
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

/// A loop statement as it is written; `None` if some item of it has no name.
fn loop_statement(rule: &Rule, orbit: &Loop) -> Option<String> {
    let word = |mention: Ref| &rule.name(mention.name).text;
    let kind = match orbit.kind {
        LoopKind::Face => "face",
        LoopKind::Hole => "hole",
        LoopKind::Any => "loop",
    };
    if orbit.each || orbit.items.iter().any(|item| !rule.name(item.item.name).named) {
        return None;
    }
    let mut drawn = String::new();
    for item in &orbit.items {
        drawn.push_str(&format!("{} {} ", word(item.from), arrow(rule, item.item.name)));
    }
    Some(format!("{kind} {}: {drawn}{}", word(orbit.face), word(orbit.end)))
}

/// An item of a loop as it is written.
fn arrow(rule: &Rule, item: NameId) -> String {
    let word = &rule.name(item).text;
    match rule.kind(item) {
        Kind::Path => format!("={word}=>"),
        _ => format!("-{word}->"),
    }
}

/// The vertices that are kept besides the one that takes the spokes of an erased one.
fn kept_beside(rule: &Rule, kept: &[NameId], erased: NameId) -> Option<Vec<NameId>> {
    let all = Remedy::Keep(kept.to_vec()).apply(rule)?;
    let taker = Taken::of(&all, erased)?.after.vertex.name;
    let others: Vec<_> = kept.iter().copied().filter(|&name| name != taker).collect();
    (!others.is_empty()).then_some(others)
}

/// Two fixes as one: edits at the same place are joined, those of the first one first.
fn both(one: Fix, other: Fix) -> Fix {
    let title = format!("{}, and {}", one.title, other.title);
    let mut edits = one.edits;
    for edit in other.edits {
        match edits.iter_mut().find(|known| known.span == edit.span) {
            Some(known) => known.text.push_str(&edit.text),
            None => edits.push(edit),
        }
    }
    Fix { title, edits }
}

/// Unused names for new edges.
fn edge_names(rule: &Rule, count: usize) -> Vec<String> {
    let free = (1..).map(|number| format!("e{number}"));
    let known = |name: &Name| name.text.split('[').next().unwrap_or_default().to_owned();
    let is_free = |word: &String| rule.names.iter().all(|name| known(name) != *word);
    free.filter(is_free).take(count).collect()
}

/// The pairs at the first index, of pairs that repeat at every index; `None` if a family is paired
/// with itself.
fn first_of_families(rule: &Rule, pairs: &[[NameId; 2]]) -> Option<Vec<[NameId; 2]>> {
    let mut firsts = Vec::new();
    for &[one, other] in pairs {
        let [first, second] = [one, other].map(|half| rule.first_member(half));
        if first == second {
            return None;
        }
        let [leads, follows] = if first < second { [one, other] } else { [other, one] };
        if rule.is_first(leads) {
            firsts.push([leads, follows]);
        }
    }
    Some(firsts)
}

/// The fix that pairs halfedges by new edges, and lists these in `new` behind other new elements.
fn pair_all(rule: &Rule, created: &[NameId], pairs: &[[NameId; 2]]) -> Option<Fix> {
    let pairs = first_of_families(rule, pairs)?;
    let mut words = edge_names(rule, pairs.len());
    for (word, [half, _]) in words.iter_mut().zip(&pairs) {
        if let Some(cycle) = rule.cycle.as_ref().filter(|_| rule.is_member(*half)) {
            word.push_str(&format!("[{}]", cycle.letter));
        }
    }
    let word = |name: NameId| &rule.name(name).text;
    let statements = pairs.iter().zip(&words).map(|([one, other], edge)| {
        format!("\n    edge {edge}: {} | {}", word(*one), word(*other))
    });
    let statements: String = statements.collect();
    let new = created.iter().map(|&name| word(name)).chain(&words);
    let new: Vec<_> = new.map(String::as_str).collect();
    let listed = list_in_new(rule, &new.join(" "))?;
    let end = Edit { span: end_of_after(rule)?, text: statements };
    let edits = match listed.span == end.span {
        true => vec![Edit { span: end.span, text: format!("{}{}", listed.text, end.text) }],
        false => vec![listed, end],
    };
    let title = match words.as_slice() {
        [only] => format!("pair them in a new edge `{only}`"),
        _ => format!("pair them by their ends in new edges `{}`", words.join("`, `")),
    };
    let title = match created {
        [] => title,
        names => format!("list {} in `new`, and {title}", enumerate(rule, names)),
    };
    Some(Fix { title, edits })
}

/// The fix that moves the spokes of an erased vertex to another; statements that are new in `after`
/// go to its end.
fn take(rule: &Rule, erased: NameId, end: Span) -> Option<Fix> {
    let taken = Taken::of(rule, erased)?;
    let mut named = rule.clone();
    named.names.extend(taken.fan);
    let after = statement(&named, &taken.after);
    let drawing = Drawing::new(rule);
    let written = drawing.after.star(taken.after.vertex.name);
    if written.is_some_and(|star| star.span == star.vertex.span) {
        return None; // `keep` restates it
    }
    let mut edits = vec![match written {
        Some(star) => Edit { span: star.span, text: after.clone() },
        None => Edit { span: end, text: format!("\n    {after}") },
    }];
    let mut title = match written {
        Some(_) => format!("write `{after}`"),
        None => format!("insert `{after}`"),
    };
    if let Some(before) = taken.before {
        let before = statement(&named, &before);
        title = format!("insert `{before}` in `before`, and in `after` {title}");
        edits.insert(
            0,
            Edit { span: drawing.before.end_of_statements()?, text: format!("\n    {before}") },
        );
    }
    Some(Fix { title, edits })
}

/// A vertex statement as it is written.
fn statement(rule: &Rule, star: &Star) -> String {
    let word = |mention: &Ref| &rule.name(mention.name).text;
    let spokes = star.spokes.iter().map(|spoke| match spoke {
        Spoke::Halfedge(half) => word(half).clone(),
        Spoke::Fan(fan) => format!("*{}", word(fan)),
        Spoke::Rest(_) => "*".to_owned(),
    });
    let spokes = spokes.collect::<Vec<_>>().join(" ");
    format!("vertex {}: {spokes}", word(&star.vertex))
}

/// The edit that lists names in `new`, which comes first in `after`.
fn list_in_new(rule: &Rule, words: &str) -> Option<Edit> {
    if let Some(last) = rule.created.iter().max_by_key(|created| created.span.end) {
        return Some(Edit { span: last.span.after(), text: format!(" {words}") });
    }
    let side = &rule.after;
    let loops = side.loops.iter().map(|orbit| orbit.span);
    let edges = side.edges.iter().map(|edge| edge.span);
    let stars = side.stars.iter().map(|star| star.span);
    let first = loops.chain(edges).chain(stars).min_by_key(|s| s.start)?;
    if side.kept.iter().any(|kept| kept.span.start <= first.start) {
        // The span of a kept statement is that of its name, behind the word `keep`.
        return Some(Edit { span: end_of_after(rule)?, text: format!("\n    new {words}") });
    }
    Some(Edit { span: first.before(), text: format!("new {words}\n    ") })
}

/// The place where one more statement can be written: behind the last one of `after`.
fn end_of_after(rule: &Rule) -> Option<Span> {
    let side = Drawing::new(rule).after.end_of_statements();
    let lists = rule.created.iter().chain(&rule.erased).map(|mention| mention.span.after());
    let stars = rule.after.stars.iter().flat_map(|star| &star.spokes).map(|spoke| match spoke {
        Spoke::Rest(span) => span.after(),
        Spoke::Halfedge(name) | Spoke::Fan(name) => name.span.after(),
    });
    let assignments = rule.assignments.iter().map(|assignment| assignment.span.after());
    let inside = |span: &Span| span.start <= rule.after.span.end;
    side.into_iter()
        .chain(lists)
        .chain(stars)
        .chain(assignments)
        .filter(inside)
        .max_by_key(|span| span.end)
}
