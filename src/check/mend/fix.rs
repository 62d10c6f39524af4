//! Repairs as edits of the source text.

use super::super::fan_repair::Taken;
use super::super::joint::is_used;
use super::super::problem::{Repair, enumerate};
use super::apply::{edge_names, turn};
use super::statements::{
    arrow, edge_statement, end_of_after, list_in_new, loop_statement, star_statement,
};
use crate::diagnostic::{Edit, Fix, all_of};
use crate::diagram::{Drawing, Kind, Loop, NameId, Ref, Rule, Side};
use crate::source::Span;

impl Repair {
    /// The repair as an edit of the source text, which a rule was read from.
    pub(in super::super) fn fix(&self, rule: &Rule) -> Option<Fix> {
        self.fix_behind(rule, rule)
    }

    /// The same, behind others that have led from the rule of the text to another.
    fn fix_behind(&self, rule: &Rule, now: &Rule) -> Option<Fix> {
        let words = |names: &[NameId]| {
            names.iter().map(|&name| now.name(name).text.as_str()).collect::<Vec<_>>().join(" ")
        };
        let statement = match self {
            Repair::Erase(names) => {
                let list = words(names);
                if let Some(last) = rule.erased.iter().max_by_key(|erased| erased.span.end) {
                    let title = format!("erase {}", enumerate(now, names));
                    let edits = vec![Edit { span: last.span.after(), text: format!(" {list}") }];
                    return Some(Fix { title, edits });
                }
                format!("erase {list}")
            }
            Repair::Create(names) => {
                let title = format!("list {} in `new`", enumerate(now, names));
                let edits = vec![list_in_new(rule, &words(names))?];
                return Some(Fix { title, edits });
            }
            Repair::Keep(names) => match names.as_slice() {
                &[edge] if rule.kind(edge) == Kind::Edge => {
                    let statement = Drawing::new(rule).before.edge_statement(edge)?;
                    edge_statement(rule, edge, statement.halfedge_names())
                }
                names => format!("keep {}", words(names)),
            },
            Repair::Take(erased) => return take(now, *erased, end_of_after(rule)?),
            Repair::Insert { face, at, from, item } => {
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
            Repair::Turn(statement) => {
                let mut orbits = rule.before.loops.iter().chain(&rule.after.loops);
                let mut turned = orbits.find(|orbit| orbit.span == *statement)?.clone();
                turn(&mut turned)?;
                let text = loop_statement(rule, &turned)?;
                let title = format!("draw it the other way round: `{text}`");
                return Some(Fix { title, edits: vec![Edit { span: *statement, text }] });
            }
            Repair::Redraw { loops, how } => {
                let edits = redraw(rule, loops);
                return Some(Fix { title: how.clone(), edits });
            }
            Repair::Rename { old, new } => {
                let written = |side: &Side, name: NameId| -> Vec<Span> {
                    let mentions = side.mentions().filter(|at| at.name == name);
                    mentions.map(|at| at.span).collect()
                };
                let (before, after) = (written(&rule.before, *old), written(&rule.after, *new));
                // The side changes where the name is written less often.
                let is_slip_after = after.len() <= before.len()
                    && written(&rule.before, *new).is_empty()
                    && !rule.params.contains(&Some(*new))
                    && rule.erased.iter().chain(&rule.created).all(|listed| listed.name != *new)
                    && !is_used(rule, *new);
                let (wrong, right, side, spans) = match is_slip_after {
                    true => (*new, *old, "after", after),
                    false => (*old, *new, "before", before),
                };
                let title =
                    format!("write {} for {} in `{side}`", rule.quoted(right), rule.quoted(wrong));
                let text = &rule.name(right).text;
                let edit = |span: Span| Edit { span, text: text.clone() };
                return Some(Fix { title, edits: spans.into_iter().map(edit).collect() });
            }
            Repair::Pair(edges) => return pair(rule, now, edges),
            Repair::PairAll(pairs) => return pair_all(rule, now, pairs),
            Repair::DrawTwins(halves) => {
                let drawn = self.apply(now)?;
                let edges = &drawn.before.edges[now.before.edges.len()..];
                let edges = edges
                    .iter()
                    .map(|one| edge_statement(&drawn, one.edge.name, one.halfedge_names()));
                let text = edges.map(|edge| format!("\n    {edge}")).collect();
                let span = Drawing::new(rule).before.end_of_statements()?;
                let title = format!("draw the twins of {} in `before`", enumerate(rule, halves));
                return Some(Fix { title, edits: vec![Edit { span, text }] });
            }
            Repair::Draw { .. } => {
                let mended = self.apply(now)?;
                loop_statement(&mended, mended.after.loops.last()?)?
            }
            Repair::All(repairs) => {
                let mut now = now.clone();
                let mut fixes = Vec::new();
                for repair in repairs {
                    fixes.push(repair.fix_behind(rule, &now)?);
                    now = repair.apply(&now)?;
                }
                return fixes.into_iter().reduce(both);
            }
        };
        let title = format!("insert `{statement}`");
        let text = format!("\n    {statement}");
        Some(Fix { title, edits: vec![Edit { span: end_of_after(rule)?, text }] })
    }
}

/// The fix that gives edges these halfedges: instead of others, or in new statements at the end.
fn pair(rule: &Rule, now: &Rule, edges: &[(NameId, [NameId; 2])]) -> Option<Fix> {
    let mut edits: Vec<Edit> = Vec::new();
    let mut inserted = String::new();
    let mut told = [Vec::new(), Vec::new()];
    for &(edge, halfedges) in edges.iter().filter(|(edge, _)| now.is_first(*edge)) {
        let text = edge_statement(now, edge, halfedges);
        let drawn = rule.after.edges.iter().find(|drawn| drawn.edge.name == edge);
        let drawn = drawn.filter(|_| rule.after.kept.iter().all(|kept| kept.name != edge));
        told[usize::from(drawn.is_none())].push(format!("`{text}`"));
        match drawn {
            Some(drawn) => edits.push(Edit { span: drawn.span, text }),
            None => inserted.push_str(&format!("\n    {text}")),
        }
    }
    edits.extend(kept_no_more(rule, edges));
    if !inserted.is_empty() {
        // Where a `keep` goes, the edges take its place.
        match edits
            .iter_mut()
            .find(|edit| edit.text.is_empty() && rule.after.keeps.contains(&edit.span))
        {
            Some(gone) => gone.text = inserted.trim_start().to_owned(),
            None => edits.push(Edit { span: end_of_after(rule)?, text: inserted }),
        }
    }
    let told = ["write", "insert"].iter().zip(told).filter(|(_, edges)| !edges.is_empty());
    let told: Vec<_> = told.map(|(verb, edges)| format!("{verb} {}", all_of(edges))).collect();
    Some(Fix { title: told.join(", and "), edits })
}

/// The edits that remove edges from the `keep` statements that list them, or these altogether.
fn kept_no_more(rule: &Rule, edges: &[(NameId, [NameId; 2])]) -> Vec<Edit> {
    let mut edits = Vec::new();
    for list in &rule.after.keeps {
        let listed = rule.after.kept.iter();
        let listed: Vec<_> = listed.filter(|kept| list.touches(kept.span.start as usize)).collect();
        let is_gone = |kept: &&&Ref| edges.iter().any(|(edge, _)| *edge == kept.name);
        let gone: Vec<_> = listed.iter().filter(is_gone).collect();
        if !gone.is_empty() && gone.len() == listed.len() {
            edits.push(Edit { span: *list, text: String::new() });
            continue;
        }
        edits.extend(gone.iter().map(|kept| {
            let span = Span { start: kept.span.start - 1, ..kept.span };
            Edit { span, text: String::new() }
        }));
    }
    edits
}

/// The edits that write other names at the same places of the loops of `after`.
fn redraw(rule: &Rule, loops: &[Loop]) -> Vec<Edit> {
    let mentions = |orbit: &Loop| -> Vec<Ref> {
        orbit.items.iter().flat_map(|item| [item.from, item.item]).chain([orbit.end]).collect()
    };
    let mut edits: Vec<Edit> = Vec::new();
    for (old, new) in rule.after.loops.iter().zip(loops) {
        for (old, new) in mentions(old).into_iter().zip(mentions(new)) {
            // All members of a family are written at one place.
            let is_written = edits.iter().any(|edit| edit.span == old.span);
            if old.name != new.name && !is_written {
                edits.push(Edit { span: old.span, text: rule.name(new.name).text.clone() });
            }
        }
    }
    edits
}

/// Two fixes as one: edits at the same place are joined, what continues a list first.
fn both(one: Fix, other: Fix) -> Fix {
    let title = format!("{}, and {}", one.title, other.title);
    let mut edits = one.edits;
    for edit in other.edits {
        match edits.iter_mut().find(|known| known.span == edit.span) {
            Some(known) if known.text.starts_with('\n') && edit.text.starts_with(' ') => {
                known.text.insert_str(0, &edit.text);
            }
            Some(known) if known.text.starts_with("new ") && edit.text.starts_with("new ") => {
                let names = known.text.trim_end();
                known.text = edit.text.replacen("new", names, 1);
            }
            Some(known) => known.text.push_str(&edit.text),
            None => edits.push(edit),
        }
    }
    Fix { title, edits }
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
fn pair_all(rule: &Rule, now: &Rule, pairs: &[[NameId; 2]]) -> Option<Fix> {
    let pairs = first_of_families(rule, pairs)?;
    let mut words = edge_names(now, pairs.len());
    for (word, [half, _]) in words.iter_mut().zip(&pairs) {
        if let Some(cycle) = rule.cycle.as_ref().filter(|_| rule.is_member(*half)) {
            word.push_str(&format!("[{}]", cycle.letter));
        }
    }
    let word = |name: NameId| &now.name(name).text;
    let statements = pairs.iter().zip(&words).map(|([one, other], edge)| {
        format!("\n    edge {edge}: {} | {}", word(*one), word(*other))
    });
    let listed = list_in_new(rule, &words.join(" "))?;
    let end = Edit { span: end_of_after(rule)?, text: statements.collect() };
    let title = match words.as_slice() {
        [only] => format!("pair them in a new edge `{only}`"),
        _ => format!("pair them by their ends in new edges `{}`", words.join("`, `")),
    };
    let fix = |edit: Edit| Fix { title: title.clone(), edits: vec![edit] };
    Some(Fix { title: title.clone(), ..both(fix(listed), fix(end)) })
}

/// The fix that moves the spokes of an erased vertex to another; statements that are new in `after`
/// go to its end.
fn take(rule: &Rule, erased: NameId, end: Span) -> Option<Fix> {
    let taken = Taken::of(rule, erased)?;
    let mut named = rule.clone();
    named.names.extend(taken.fan);
    let after = star_statement(&named, &taken.after);
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
        let before = star_statement(&named, &before);
        title = format!("insert `{before}` in `before`, and in `after` {title}");
        edits.insert(
            0,
            Edit { span: drawing.before.end_of_statements()?, text: format!("\n    {before}") },
        );
    }
    Some(Fix { title, edits })
}
