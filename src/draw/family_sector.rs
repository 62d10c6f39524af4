//! Families: one sector stands out, the others are faded and have no labels.
//!
//! The members that stand out are those that the statements of index 0 mention: the members of
//! index 0, and those of the next index connected to them. A name of no family always stands out.

use crate::diagram::{NameId, Rule, Side, Spoke};

/// Whether each name stands out.
pub(super) fn sector(rule: &Rule) -> Vec<bool> {
    let Some(size) = rule.size() else {
        return vec![true; rule.names.len()];
    };
    let mut strong: Vec<_> = rule.ids().map(|name| rule.is_first(name)).collect();
    for side in [&rule.before, &rule.after] {
        mentions(rule, side, size as usize, &mut |name| {
            strong[name.index()] = true;
        });
    }
    strong
}

/// Calls `see` for every name that the statements of index 0 mention.
fn mentions(rule: &Rule, side: &Side, size: usize, see: &mut dyn FnMut(NameId)) {
    for orbit in side.loops.iter().filter(|orbit| rule.is_first(orbit.face.name)) {
        let count = if orbit.each { orbit.items.len() / size.max(1) } else { orbit.items.len() };
        for item in &orbit.items[..count] {
            see(item.from.name);
            see(item.item.name);
        }
        // The vertex where the last of them ends.
        see(orbit.items[count % orbit.items.len().max(1)].from.name);
    }
    for edge in side.edges.iter().filter(|edge| rule.is_first(edge.edge.name)) {
        edge.halfedges.iter().for_each(|half| see(half.name));
    }
    let stars = side.stars.iter().filter(|star| !star.each);
    for star in stars.filter(|star| rule.is_first(star.vertex.name)) {
        for spoke in &star.spokes {
            match spoke {
                Spoke::Halfedge(mention) | Spoke::Fan(mention) => see(mention.name),
                Spoke::Rest(_) => {}
            }
        }
    }
}
