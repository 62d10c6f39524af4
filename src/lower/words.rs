//! Claims and refusals in words.

use crate::check::matching::{Bound, Claim, Source, Step, Way};
use crate::diagram::{Drawing, Kind, LoopKind, NameId};

/// A bound name, without backticks.
pub fn bound(drawing: &Drawing, bound: Bound) -> String {
    match bound {
        Bound::Element(name) => drawing.rule.name(name).text.clone(),
        Bound::First(path) => format!("first({})", drawing.rule.name(path).text),
        Bound::Last(path) => format!("last({})", drawing.rule.name(path).text),
    }
}

/// A pointer as it is written: `a.next`.
pub fn source(drawing: &Drawing, source: Source) -> String {
    let pointers: Vec<_> = source.pointers().iter().map(|pointer| pointer.word()).collect();
    format!("{}.{}", bound(drawing, source.from), pointers.join("."))
}

/// The words of a claim, as the table prints it.
pub(super) fn claim(drawing: &Drawing, claim: &Claim) -> String {
    let word = |name: NameId| drawing.rule.name(name).text.clone();
    let joined = |names: &[NameId], between| joined(names, word, between);
    match claim {
        Claim::Leads(from, to) => format!("{} is {}", source(drawing, *from), bound(drawing, *to)),
        Claim::Distinct(left, right) => format!("{} is not {}", word(*left), word(*right)),
        Claim::Kind(face, LoopKind::Hole) => format!("{} is a hole", word(*face)),
        Claim::Kind(face, _) => format!("{} is not a hole", word(*face)),
        Claim::InOrder { halfedges, .. } => {
            format!("{} follow each other", joined(halfedges, ", "))
        }
        Claim::NotAllEmpty(paths) => format!("{} not empty", joined(paths, " or ")),
        Claim::Listed { halfedge, vertices: [origin, vertex], spokes } => {
            let among = match spokes.is_empty() {
                true => String::new(),
                false => format!(", or {} is {}", word(*halfedge), joined(spokes, " or ")),
            };
            format!("{} is not {}{among}", word(*origin), word(*vertex))
        }
        Claim::Begins(name) => format!("{} is the one that is given", word(*name)),
        Claim::AllDistinct(names) => format!("all {} are different", joined(names, ", ")),
        Claim::AroundInOrder { halfedges, .. } => {
            format!("{} follow each other, index by index", joined(halfedges, ", "))
        }
        Claim::NotAllEmptyAround(paths) => {
            format!("{} not empty at some index", joined(paths, " or "))
        }
    }
}

/// The reason why a claim fails, as a refusal says it; the names are bound by the `steps`.
pub(super) fn refusal(drawing: &Drawing, claim: &Claim, steps: &[Step]) -> String {
    let rule = drawing.rule;
    let tick = |text: String| format!("`{text}`");
    let joined = |names: &[NameId]| joined(names, |name| rule.quoted(name), ", ");
    match claim {
        Claim::Leads(from, to) => {
            if let Source { way: Way::Next, from: Bound::Element(half) } = from
                && let Bound::Element(_) = to
                && let Some(corners) = corners_of_full_loop(drawing, *half, steps)
            {
                let face = drawing.before.face(*half).expect("it lies in a loop");
                return match corners {
                    3 => format!("{} is not a triangle", rule.quoted(face)),
                    4 => format!("{} is not a quad", rule.quoted(face)),
                    _ => format!("{} does not have {corners} corners", rule.quoted(face)),
                };
            }
            let element = bound(drawing, *to);
            let half = || tick(bound(drawing, from.from));
            let (half, fails) = match from.way {
                Way::Origin => (half(), "does not start at"),
                Way::Target => (half(), "does not end at"),
                Way::Face => (half(), "does not lie in"),
                _ => (tick(source(drawing, *from)), "is not"),
            };
            format!("{half} {fails} {}", tick(element))
        }
        Claim::Distinct(left, right) => {
            let kind = rule.kind(*left).word();
            format!("{} and {} are one {kind}", rule.quoted(*left), rule.quoted(*right))
        }
        Claim::Kind(face, LoopKind::Hole) => format!("{} is not a hole", rule.quoted(*face)),
        Claim::Kind(face, _) => format!("{} is a hole", rule.quoted(*face)),
        Claim::InOrder { halfedges, .. } => {
            let [a, b, c] = halfedges.map(|half| rule.quoted(half));
            format!("{a}, {b} and {c} follow each other in another order")
        }
        Claim::NotAllEmpty(paths) | Claim::NotAllEmptyAround(paths) => {
            let face = paths.first().and_then(|&path| drawing.after.face(path));
            let face = face.map_or_else(|| "a face".to_string(), |face| rule.quoted(face));
            format!("{face} would be left without halfedges")
        }
        Claim::Listed { halfedge, vertices: [_, vertex], .. } => {
            let (halfedge, vertex) = (rule.quoted(*halfedge), rule.quoted(*vertex));
            format!("{halfedge} is a spoke of {vertex}, whose statement does not list it")
        }
        Claim::Begins(name) => format!("{} does not begin there", rule.quoted(*name)),
        Claim::AllDistinct(names) => {
            let kind = names.first().map_or("element", |&name| rule.kind(name).word());
            format!("two of {} are one {kind}", joined(names))
        }
        Claim::AroundInOrder { halfedges, .. } => {
            format!("{} follow each other in another order", joined(halfedges))
        }
    }
}

/// Names in words, one after the other.
fn joined(names: &[NameId], word: impl Fn(NameId) -> String, between: &str) -> String {
    let words: Vec<_> = names.iter().map(|&name| word(name)).collect();
    words.join(between)
}

/// The number of corners of a halfedge's loop, if all of it is drawn, and bound along it: then only
/// another number keeps it from closing.
fn corners_of_full_loop(drawing: &Drawing, half: NameId, steps: &[Step]) -> Option<usize> {
    let items = &drawing.before.loop_of_item(half)?.items;
    let full = items.iter().all(|item| drawing.rule.kind(item.item.name) == Kind::Halfedge);
    let is_here = |bound: Bound| items.iter().any(|item| item.item.name == bound.name());
    let along = steps.iter().filter(|step| match step {
        Step::Bind { name, source } => {
            is_here(*name) && matches!(source.way, Way::Next | Way::Prev)
        }
        _ => false,
    });
    (full && along.count() + 1 == items.len()).then_some(items.len())
}
