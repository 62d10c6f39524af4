//! Phase 3 around vertices: where fans start, and the `halfedge` of a vertex.

use super::reassign::Reassign;
use crate::diagram::{Kind, NameId};
use crate::rewrite::{ElementField, HalfedgeField, Inst, Reg};

impl Reassign<'_, '_, '_, '_> {
    /// Every halfedge of a fan starts at its vertex.
    pub(super) fn fans(&mut self) {
        let drawing = self.drawing;
        for fan in drawing.rule.names_of(Kind::Fan) {
            let Some(vertex) = drawing.after.star_of_spoke(fan) else {
                continue;
            };
            if !drawing.rule.is_first(fan) {
                continue;
            }
            self.for_each(fan, |this| {
                let target = format!("vertex around {}", this.word(fan));
                let store = this.store_run(HalfedgeField::Vertex, fan, vertex);
                this.set(target, this.word(vertex).into(), store);
            });
        }
    }

    /// A vertex keeps its halfedge as long as none of its spokes has left.
    pub(super) fn vertices(&mut self) {
        let drawing = self.drawing;
        for vertex in drawing.rule.names_of(Kind::Vertex) {
            let drawn = drawing.after.mention(vertex).is_some();
            if !drawn || drawing.erased(vertex).is_some() || !drawing.rule.is_first(vertex) {
                continue;
            }
            self.for_each(vertex, |this| this.vertex(vertex));
        }
    }

    fn vertex(&mut self, vertex: NameId) {
        let Some((value, text)) = self.spoke_of(vertex) else {
            return;
        };
        let store =
            Inst::StoreHalfedge { of: ElementField::Vertex, element: self.element(vertex), value };
        let keeps = self.drawing.keeps_its_spokes(vertex);
        self.anchor(vertex, text, store, keeps);
    }

    /// A halfedge that starts at the vertex after: a named spoke; else the first of a path
    /// that cannot be empty; else what a path that may be begins with, be it what follows it.
    fn spoke_of(&mut self, vertex: NameId) -> Option<(Reg, String)> {
        let rule = self.drawing.rule;
        if let Some(half) = self.drawing.spoke_after(vertex) {
            return Some((self.element(half), self.word(half).into()));
        }
        let path = self.drawing.path_after(vertex)?;
        let first_of = |item: &NameId| match self.is_path(*item) {
            true => format!("first({})", self.word(*item)),
            false => self.word(*item).to_owned(),
        };
        let certain = self.registers.home_of_empty(path).is_none();
        if rule.is_member(path) && !certain && !rule.is_member(vertex) {
            let text = first_of(&path);
            return Some((self.first_around(path), text));
        }
        let items = self.drawing.heads_after(path);
        let text = items.iter().map(first_of).collect::<Vec<_>>().join(" or ");
        Some((self.head(&items, 0), text))
    }
}
