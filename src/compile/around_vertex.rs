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
    /// that cannot be empty; else of one found not to be empty.
    fn spoke_of(&mut self, vertex: NameId) -> Option<(Reg, String)> {
        let rule = self.drawing.rule;
        if let Some(half) = self.drawing.spoke_after(vertex) {
            return Some((self.element(half), self.word(half).into()));
        }
        let paths = self.drawing.paths_after(vertex);
        let first = *paths.first()?;
        let first_of = |path: &NameId| format!("first({})", self.word(*path));
        let certain = self.registers.home_of_empty(first).is_none();
        let text = match certain {
            true => first_of(&first),
            false => paths.iter().map(first_of).collect::<Vec<_>>().join(" or "),
        };
        if rule.is_member(first) && !certain && !rule.is_member(vertex) {
            let text = first_of(&first);
            return Some((self.first_around(first), text));
        }
        Some((self.head(&paths, 0), text))
    }
}
