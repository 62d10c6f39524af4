//! A counterexample as a drawing: the whole mesh before, and what became of it.
//!
//! Elements have the names of the rule they were found with; those without a name get numbers,
//! faces and holes with the word.
//! `after` is written down as it is, even if broken: a loop continues until it comes back to a
//! halfedge it has met, an edge is a halfedge and its twin.

use super::Counterexample;
use crate::diagram::{
    Broken, Edge, Loop, LoopItem, LoopKind, Name, NameId, Op, Ref, Role, Rule, Side,
};
use crate::mesh::{Element, ElementKind, FaceId, HalfedgeId, Mesh};
use crate::source::Span;

impl Counterexample {
    /// The mesh before and after as an operation that draws all of it.
    pub fn drawn(&self) -> Op {
        let mut writer = Writer { example: self, names: Vec::new(), elements: Vec::new() };
        let before = writer.side(&self.before);
        let after = writer.side(&self.after);
        let lives = |mesh: &Mesh, element: &Element| mesh.is_alive(element.kind, element.index);
        let listed = |of: &Mesh, not_of: &Mesh| {
            let elements = writer.elements.iter().enumerate();
            let only =
                elements.filter(|(_, element)| lives(of, element) && !lives(not_of, element));
            only.map(|(at, _)| Ref::unwritten(NameId(at as u32))).collect()
        };
        let created = listed(&self.after, &self.before);
        let erased = listed(&self.before, &self.after);
        let broken = Broken { verdict: self.verdict.clone(), unchanged: writer.unchanged() };
        let rule = Rule {
            label: self.rule.clone(),
            broken: Some(broken),
            names: writer.names,
            before,
            after,
            created,
            erased,
            ..Rule::default()
        };
        Op { name: self.op.clone(), rules: vec![rule], ..Op::default() }
    }
}

/// Writes both sides, with one name for each element.
struct Writer<'a> {
    example: &'a Counterexample,
    names: Vec<Name>,
    /// For each name, its element.
    elements: Vec<Element>,
}

impl Writer<'_> {
    fn name(&mut self, element: Element) -> Ref {
        let known = self.elements.iter().position(|known| *known == element);
        if let Some(at) = known {
            return Ref::unwritten(NameId(at as u32));
        }
        let named = self.example.names.iter();
        let mut named = named.filter(|(_, elements)| elements.as_slice() == [element]);
        let text = named.next().map(|(text, _)| text.clone());
        self.names.push(Name {
            text: text.unwrap_or_else(|| self.numbered(element)),
            kind: element.kind.into(),
            named: true,
            role: Role::Single,
            span: Span::default(),
        });
        self.elements.push(element);
        Ref::unwritten(NameId(self.names.len() as u32 - 1))
    }

    /// The number of an element, after the word for a face or hole: edges may have the same.
    fn numbered(&self, element: Element) -> String {
        let Element { kind, index } = element;
        let is_hole = || self.example.before.get_is_hole(FaceId(index)) == Some(true);
        match kind {
            ElementKind::Face if is_hole() => format!("hole {index}"),
            ElementKind::Face => format!("face {index}"),
            _ => index.to_string(),
        }
    }

    /// The halfedges with the same pointers before and after.
    fn unchanged(&self) -> Vec<NameId> {
        let pointers = |mesh: &Mesh, half| {
            let ends = || (mesh.vertex(half), mesh.edge(half), mesh.face(half));
            mesh.halfedge_alive(half).then(|| (mesh.next(half), mesh.twin(half), ends()))
        };
        let is_same = |element: &Element| {
            let half = HalfedgeId(element.index);
            element.kind == ElementKind::Halfedge
                && pointers(&self.example.before, half) == pointers(&self.example.after, half)
        };
        let elements = self.elements.iter().zip(0..);
        elements.filter(|(element, _)| is_same(element)).map(|(_, at)| NameId(at)).collect()
    }

    fn side(&mut self, mesh: &Mesh) -> Side {
        let mut side = Side::default();
        let halfedges: Vec<_> = mesh.halfedges().collect();
        let mut met: Vec<HalfedgeId> = Vec::new();
        for &start in &halfedges {
            if met.contains(&start) {
                continue;
            }
            // Where the mesh is broken, `next` may lead into the loop of another face.
            let face = mesh.face(start);
            let mut items = Vec::new();
            let mut at = start;
            while mesh.halfedge_alive(at) && mesh.face(at) == face && !met.contains(&at) {
                met.push(at);
                items.push(LoopItem {
                    from: self.name(mesh.vertex(at).into()),
                    item: self.name(at.into()),
                });
                at = mesh.next(at);
            }
            if !mesh.face_alive(face) {
                continue;
            }
            let name = self.name(face.into());
            let known = side.loops.iter_mut().find(|orbit| orbit.face.name == name.name);
            if let Some(known) = known {
                let leads_there = self.elements[known.items[0].item.name.index()] == at.into();
                let place = if leads_there { 0 } else { known.items.len() };
                known.items.splice(place..place, items);
                known.end = known.items[0].from;
                continue;
            }
            side.loops.push(Loop {
                kind: if mesh.is_hole(face) { LoopKind::Hole } else { LoopKind::Face },
                face: name,
                end: items[0].from,
                items,
                each: false,
                span: Span::default(),
            });
        }
        for &half in &halfedges {
            let twin = mesh.twin(half);
            let edge = mesh.edge(half);
            if half.0 >= twin.0 || !mesh.halfedge_alive(twin) || !mesh.edge_alive(edge) {
                continue;
            }
            let edge = self.name(edge.into());
            if side.edges.iter().any(|known| known.edge.name == edge.name) {
                continue;
            }
            side.edges.push(Edge {
                edge,
                halfedges: [self.name(half.into()), self.name(twin.into())],
                span: Span::default(),
            });
        }
        side
    }
}
