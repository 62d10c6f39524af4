//! Pointers that would keep their old values.

use crate::diagnostic::some_of;
use crate::diagram::{Drawing, NameId};

/// Pointers that nothing reassigns.
pub(super) struct Stale {
    /// Pointer, value, and whether the value is erased.
    pointers: Vec<(String, String, bool)>,
}

impl Stale {
    /// `next`, `vertex` and `face` of halfedges (and the `face` of paths) without a loop,
    /// and `twin` and `edge` of those that also lack an edge.
    pub fn of_loop(drawing: &Drawing, items: &[NameId]) -> Self {
        let mut stale = Self { pointers: Vec::new() };
        for &item in items {
            let view = &drawing.before;
            if drawing.rule.kind(item) == crate::diagram::Kind::Halfedge {
                stale.add(drawing, item, "next", view.item_after(item));
                stale.add(drawing, item, "vertex", view.loop_origin(item));
            }
            stale.add(drawing, item, "face", view.face(item));
            if drawing.after.pairing(item).is_none() {
                stale.add(drawing, item, "twin", view.twin(item));
                stale.add(drawing, item, "edge", view.edge(item));
            }
        }
        stale
    }

    /// `twin` and `edge` of halfedges without an edge.
    pub fn of_edge(drawing: &Drawing, halfedges: &[NameId]) -> Self {
        let mut stale = Self { pointers: Vec::new() };
        for &half in halfedges {
            stale.add(drawing, half, "twin", drawing.before.twin(half));
            stale.add(drawing, half, "edge", drawing.before.edge(half));
        }
        stale
    }

    fn add(&mut self, drawing: &Drawing, item: NameId, pointer: &str, value: Option<NameId>) {
        let Some(value) = value else { return };
        let name = drawing.rule.name(item);
        let pointer = if name.named {
            format!("`{}.{pointer}`", name.text)
        } else {
            format!("`{pointer}` along {}", name.text)
        };
        let erased = drawing.erased(value).is_some();
        self.pointers.push((pointer, drawing.rule.quoted(value), erased));
    }

    /// The pointers in words; only those to erased elements, if there are any.
    pub fn sentence(&self) -> String {
        let dangling: Vec<_> = self.pointers.iter().filter(|pointer| pointer.2).collect();
        let say = |(pointer, value, _): &(String, String, bool)| {
            format!("{pointer} would still be {value}")
        };
        if dangling.is_empty() {
            return some_of(self.pointers.iter().map(say));
        }
        let mut values: Vec<_> = dangling.iter().map(|pointer| pointer.1.clone()).collect();
        values.sort();
        values.dedup();
        let told = some_of(dangling.iter().map(|&pointer| say(pointer)));
        match values.as_slice() {
            [_] => format!("{told}, which is erased"),
            _ => format!("{told}; {} are erased", some_of(values)),
        }
    }
}
