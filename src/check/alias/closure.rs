//! Consequences of names being one.
//!
//! Pointers are functions: a halfedge has one twin, one origin, one edge, one face. So what the
//! statements say of either name holds for both, which is applied until nothing new follows. Some
//! consequences leave a choice: two statements of one loop can overlap in several ways, and a named
//! spoke of a vertex is one of those that its statement lists.

use super::overlap::{Overlap, overlaps};
use super::quotient::Quotient;
use crate::check::chain::corners;
use crate::check::port::Links;
use crate::check::vertices_are_orbits::spokes_of;
use crate::diagram::{Drawing, Edge, Kind, LoopKind, NameId, Spoke, Star};

/// The reason why names cannot be one, or why that is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::check) enum Contradiction {
    /// They are one in no mesh.
    Certain(String),
    /// There are too many ways, or one that is not examined.
    Unclear(String),
}

/// A consequence of names being one.
enum Consequence {
    /// Two names are one.
    One(NameId, NameId),
    /// A name is one of these; if it cannot be, the text is the reason.
    Among(NameId, Vec<NameId>, String),
    /// Two statements of `before` describe one loop.
    Overlap([usize; 2], LoopKind, Vec<Overlap>),
    /// Two statements of `before` describe the spokes of one vertex, and name the same ones.
    OneStar([usize; 2]),
    /// The names cannot be one.
    Never(Contradiction),
}

/// The greatest number of ways of one set of names that are examined.
const MOST: usize = 64;

/// A quotient with two more names made one, and all that follows: one for each way that is
/// possible.
pub(in crate::check) fn united(
    quotient: &Quotient,
    pair: [NameId; 2],
) -> Result<Vec<Quotient>, Contradiction> {
    let [left, right] = pair.map(|name| quotient.stands_for(name));
    if left == right {
        return Ok(vec![quotient.clone()]);
    }
    let mut open = vec![quotient.clone()];
    open[0].unite(left, right);
    let mut found: Vec<Quotient> = Vec::new();
    let mut never = None;
    let mut looked_at = 0;
    while let Some(mut quotient) = open.pop() {
        looked_at += 1;
        if looked_at > 20 * MOST || found.len() > MOST {
            let why = "there are too many ways to look at".into();
            return Err(Contradiction::Unclear(why));
        }
        match consequence(&quotient) {
            None => found.push(quotient),
            Some(Consequence::One(left, right)) => {
                quotient.unite(left, right);
                open.push(quotient);
            }
            Some(Consequence::Among(name, others, otherwise)) => {
                never.get_or_insert(Contradiction::Certain(otherwise));
                let options = others.iter().map(|&other| {
                    let mut option = quotient.clone();
                    option.unite(name, other);
                    option
                });
                open.extend(options);
            }
            Some(Consequence::Overlap(loops, kind, ways)) => {
                for way in ways {
                    let mut option = quotient.clone();
                    let same = way.same.clone();
                    option.rule.before.loops[loops[0]].kind = kind;
                    option.overlay(loops, way);
                    for pair in same {
                        let [left, right] = pair.map(|name| option.stands_for(name));
                        if left != right {
                            option.unite(left, right);
                        }
                    }
                    open.push(option);
                }
            }
            Some(Consequence::OneStar(stars)) => match quotient.join_stars(stars) {
                Ok(()) => open.push(quotient),
                Err(why) => {
                    never.get_or_insert(Contradiction::Certain(why));
                }
            },
            Some(Consequence::Never(Contradiction::Unclear(why))) => {
                return Err(Contradiction::Unclear(why));
            }
            Some(Consequence::Never(why)) => {
                never.get_or_insert(why);
            }
        }
    }
    match never {
        Some(why) if found.is_empty() => Err(why),
        None if found.is_empty() => {
            let why = "their loops cannot be one".into();
            Err(Contradiction::Certain(why))
        }
        _ => Ok(found),
    }
}

fn never(why: String) -> Option<Consequence> {
    Some(Consequence::Never(Contradiction::Certain(why)))
}

/// The first consequence.
fn consequence(quotient: &Quotient) -> Option<Consequence> {
    of_loops(quotient)
        .or_else(|| of_edges(quotient))
        .or_else(|| of_origins(quotient))
        .or_else(|| of_stars(quotient))
        .or_else(|| of_rings(quotient))
}

/// A halfedge is in one place of one loop, and a face has one loop.
fn of_loops(quotient: &Quotient) -> Option<Consequence> {
    let rule = &quotient.rule;
    let loops = &rule.before.loops;
    for (at, orbit) in loops.iter().enumerate() {
        for (place, item) in orbit.items.iter().enumerate() {
            let name = item.item.name;
            let here = orbit.items[..place].iter();
            if here.clone().any(|other| other.item.name == name) {
                let (text, face) = (rule.quoted(name), rule.quoted(orbit.face.name));
                return never(format!("{text} would stand twice in the loop of {face}"));
            }
            for other in &loops[..at] {
                let mut items = other.items.iter();
                if items.any(|item| item.item.name == name) && other.face.name != orbit.face.name {
                    return Some(Consequence::One(other.face.name, orbit.face.name));
                }
            }
        }
        if orbit.items.first().map(|item| item.from.name) != Some(orbit.end.name) {
            return Some(Consequence::One(orbit.items.first()?.from.name, orbit.end.name));
        }
        for (first, other) in loops[..at].iter().enumerate() {
            if other.face.name != orbit.face.name {
                continue;
            }
            let kind = match (other.kind, orbit.kind) {
                (LoopKind::Any, kind) | (kind, LoopKind::Any) => kind,
                (one, other) if one == other => one,
                _ => {
                    let text = rule.quoted(orbit.face.name);
                    return never(format!("{text} would be a face and a hole"));
                }
            };
            return Some(match overlaps(rule, other, orbit) {
                Some(ways) => Consequence::Overlap([first, at], kind, ways),
                None => {
                    let text = rule.quoted(orbit.face.name);
                    let why = format!("the two loops of {text} can lie in many ways");
                    Consequence::Never(Contradiction::Unclear(why))
                }
            });
        }
    }
    None
}

/// A halfedge has one twin and one edge.
fn of_edges(quotient: &Quotient) -> Option<Consequence> {
    let rule = &quotient.rule;
    let edges = &rule.before.edges;
    for (at, edge) in edges.iter().enumerate() {
        let [left, right] = edge.halfedge_names();
        if left == right {
            return never(format!("{} would be its own twin", rule.quoted(left)));
        }
        for other in &edges[..at] {
            let shared = [left, right]
                .iter()
                .position(|half| other.halfedges.iter().any(|of| of.name == *half));
            if let Some(shared) = shared {
                if other.edge.name != edge.edge.name {
                    return Some(Consequence::One(other.edge.name, edge.edge.name));
                }
                let half = [left, right][shared];
                return Some(Consequence::One([left, right][1 - shared], partner(other, half)));
            }
        }
    }
    None
}

fn partner(edge: &Edge, half: NameId) -> NameId {
    let [left, right] = edge.halfedge_names();
    if left == half { right } else { left }
}

/// A halfedge starts at one vertex, and its twin starts where it ends.
fn of_origins(quotient: &Quotient) -> Option<Consequence> {
    let rule = &quotient.rule;
    let mut origins: Vec<Option<NameId>> = vec![None; rule.names.len()];
    let mut says = Vec::new();
    for orbit in &rule.before.loops {
        for (at, item) in orbit.items.iter().enumerate() {
            let name = item.item.name;
            says.push((name, item.from.name));
            let ends = orbit.items.get(at + 1).map_or(orbit.end, |next| next.from);
            let edges = rule.before.edges.iter();
            let of = edges.filter(|edge| edge.halfedges.iter().any(|half| half.name == name));
            says.extend(of.map(|edge| (partner(edge, name), ends.name)));
        }
    }
    for star in &rule.before.stars {
        let listed = star.spokes.iter().filter_map(Spoke::halfedge);
        says.extend(listed.map(|half| (half, star.vertex.name)));
    }
    for (half, vertex) in says {
        match origins[half.index()] {
            Some(known) if known != vertex => return Some(Consequence::One(known, vertex)),
            _ => origins[half.index()] = Some(vertex),
        }
    }
    None
}

/// A vertex has one star, which lists each of its named spokes once.
fn of_stars(quotient: &Quotient) -> Option<Consequence> {
    let rule = &quotient.rule;
    let drawing = Drawing::new(rule);
    let stars = &rule.before.stars;
    for (at, star) in stars.iter().enumerate() {
        let text = rule.quoted(star.vertex.name);
        let listed: Vec<NameId> = star.spokes.iter().filter_map(Spoke::halfedge).collect();
        for (place, half) in listed.iter().enumerate() {
            if listed[..place].contains(half) {
                let half = rule.quoted(*half);
                return never(format!("{half} would be two spokes of {text}"));
            }
        }
        for half in rule.names_of(Kind::Halfedge) {
            let here = drawing.before.mention(half).is_some()
                && drawing.origin_before(half) == Some(star.vertex.name);
            if !here || listed.contains(&half) {
                continue;
            }
            let name = rule.quoted(half);
            let otherwise =
                format!("{name} would be a spoke of {text}, whose statement does not list it");
            return Some(Consequence::Among(half, listed, otherwise));
        }
        let same = |other: &Star| other.vertex.name == star.vertex.name;
        if let Some(first) = stars[..at].iter().position(same) {
            return Some(Consequence::OneStar([first, at]));
        }
        // Counterclockwise the spoke after `a` is `a.prev.twin`.
        let count = star.spokes.len();
        for place in 0..count {
            let next = star.spokes[(place + 1) % count].halfedge();
            let (Some(spoke), Some(next)) = (star.spokes[place].halfedge(), next) else { continue };
            let named =
                |item: Option<NameId>| item.filter(|&item| rule.kind(item) == Kind::Halfedge);
            let view = &drawing.before;
            let back = named(view.item_before(spoke)).and_then(|prev| view.twin(prev));
            if let Some(back) = back.filter(|&back| back != next) {
                return Some(Consequence::One(back, next));
            }
            let ahead = view.twin(next).and_then(|twin| named(view.item_after(twin)));
            if let Some(ahead) = ahead.filter(|&ahead| ahead != spoke) {
                return Some(Consequence::One(ahead, spoke));
            }
        }
    }
    None
}

/// Spokes that close into a ring are the whole star: any other spoke is one of them.
fn of_rings(quotient: &Quotient) -> Option<Consequence> {
    let rule = &quotient.rule;
    let drawing = Drawing::new(rule);
    let links = Links::of(rule, &rule.before);
    for corner in corners(&drawing, &links) {
        let Some(ring) = corner.chains.iter().position(|chain| chain.closed) else { continue };
        let spokes = |at: usize| spokes_of(&drawing, &corner.chains[at].ports);
        let mut others = (0..corner.chains.len()).filter(|&at| at != ring).flat_map(spokes);
        if let Some(other) = others.next() {
            let (name, text) = (rule.quoted(other), rule.quoted(corner.vertex));
            let otherwise = format!("{name} would be one more spoke of {text}, which is full");
            return Some(Consequence::Among(other, spokes(ring), otherwise));
        }
    }
    None
}
