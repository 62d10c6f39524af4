//! Values that new elements take over from what was there: of the attributes that are
//! [inherited](super::Attribute::inherits) and that the rule does not set.
//!
//! A new face takes the value of the face whose halfedge it has now, or else that of a face beside
//! it; a new edge that of the only edge that lay between the faces that those at its sides come
//! from; a new halfedge that of the corner where it starts, in the face that its own comes from.
//! Anything else has the default.

use super::{
    Access, Assignment, Expr, ExprKind, Kind, Loop, LoopKind, NameId, Ref, Role, Rule, Side,
};

impl Rule {
    /// The assignments by which new elements inherit.
    pub fn inherited(&self) -> Vec<Assignment> {
        let mut all = Vec::new();
        if !self.attributes.iter().any(|attribute| attribute.inherits) {
            return all;
        }
        for &target in &self.created {
            let element = self.kind(target.name).element_type();
            let (Some(element), Some(source)) = (element, self.source(target)) else { continue };
            let value = |ty, kind| Expr { ty, kind, span: target.span };
            for (number, attribute) in (0..).zip(self.attributes.iter()) {
                let access = Access::Declared(number);
                let has_it = attribute.inherits && attribute.element == element;
                if has_it && !self.sets(target.name, access) {
                    let source = Box::new(value(element, self.element(source)));
                    let value = value(attribute.ty, ExprKind::Read(access, source));
                    all.push(Assignment { target, attribute: access, value, span: target.span });
                }
            }
        }
        all
    }

    fn sets(&self, name: NameId, attribute: Access) -> bool {
        let mut all = self.assignments.iter();
        all.any(|one| one.target.name == name && one.attribute == attribute)
    }

    /// The element in `before` from which a new one inherits.
    fn source(&self, created: Ref) -> Option<Ref> {
        let source = match self.kind(created.name) {
            Kind::Face => self.origin(created),
            Kind::Edge => self.edge_between(self.sides(created)?),
            Kind::Halfedge => {
                let (at, face) = self.place(&self.after, created)?;
                let origin = self.origin(face)?;
                let from = self.moved(at.0.items[at.1].from, created, at.0.items[at.1].item);
                self.corner(from, origin)
            }
            _ => None,
        };
        // An element that is there once cannot take over the values of several.
        let is_single = |name| self.name(name).role == Role::Single;
        source.filter(|source| !is_single(created.name) || is_single(source.name))
    }

    /// The face in `before` that a face in `after` comes from.
    fn origin(&self, face: Ref) -> Option<Ref> {
        if !self.is_new(face.name) {
            return Some(face);
        }
        self.own(face).or_else(|| {
            self.drawn(face)?.into_iter().find_map(|item| {
                let beside = self.place(&self.after, self.twin(item)?)?.1;
                match self.is_new(beside.name) {
                    true => self.own(beside),
                    false => Some(beside).filter(|_| !self.is_hole(beside.name)),
                }
            })
        })
    }

    /// The face, and no hole, in which a halfedge or path of a new face lay.
    fn own(&self, face: Ref) -> Option<Ref> {
        self.drawn(face)?.into_iter().find_map(|item| {
            let before = self.place(&self.before, item)?.1;
            (!self.is_hole(before.name)).then_some(before)
        })
    }

    /// The halfedges and paths of a face, and no hole, in `after`.
    fn drawn(&self, face: Ref) -> Option<Vec<Ref>> {
        let is_it = |orbit: &&Loop| orbit.face.name == face.name && orbit.kind != LoopKind::Hole;
        let orbit = self.after.loops.iter().find(is_it)?;
        let items = orbit.items.iter();
        Some(items.map(|item| self.moved(item.item, face, orbit.face)).collect())
    }

    fn is_hole(&self, face: NameId) -> bool {
        let mut all = self.before.loops.iter();
        all.any(|orbit| orbit.face.name == face && orbit.kind == LoopKind::Hole)
    }

    fn is_new(&self, name: NameId) -> bool {
        self.created.iter().any(|created| created.name == name)
    }

    /// The loop of a halfedge or path on one side, its index there, and the face.
    fn place<'r>(&self, side: &'r Side, item: Ref) -> Option<((&'r Loop, usize), Ref)> {
        side.loops.iter().find_map(|orbit| {
            let at = orbit.items.iter().position(|it| it.item.name == item.name)?;
            Some(((orbit, at), self.moved(orbit.face, item, orbit.items[at].item)))
        })
    }

    /// The twin of a halfedge in `after`.
    fn twin(&self, halfedge: Ref) -> Option<Ref> {
        self.after.edges.iter().find_map(|edge| {
            let [a, b] = edge.halfedges;
            let one =
                |x: Ref, y: Ref| (x.name == halfedge.name).then(|| self.moved(y, halfedge, x));
            one(a, b).or_else(|| one(b, a))
        })
    }

    /// The faces in `before` that the faces at the sides of a new edge come from.
    fn sides(&self, edge: Ref) -> Option<[Ref; 2]> {
        let drawn = self.after.edges.iter().find(|drawn| drawn.edge.name == edge.name)?;
        let [a, b] = drawn.halfedges.map(|halfedge| {
            let halfedge = self.moved(halfedge, edge, drawn.edge);
            self.origin(self.place(&self.after, halfedge)?.1)
        });
        Some([a?, b?])
    }

    /// The only edge in `before` between two different faces.
    fn edge_between(&self, [one, other]: [Ref; 2]) -> Option<Ref> {
        let is_single = |mention: Ref| self.name(mention.name).role == Role::Single;
        let (one, other) = if is_single(one) { (other, one) } else { (one, other) };
        let mut found = self.before.edges.iter().filter_map(|edge| {
            let [a, b] = edge.halfedges.map(|halfedge| Some(self.place(&self.before, halfedge)?.1));
            let lies = |x: Ref, y: Ref| {
                let moved = |mention: Ref| self.moved(mention, one, x);
                (x.name == one.name && self.same(moved(y), other)).then(|| moved(edge.edge))
            };
            lies(a?, b?).or_else(|| lies(b?, a?))
        });
        let edge = found.next().filter(|_| found.next().is_none())?;
        let is_one_of_many = is_single(one) && !is_single(edge);
        (!is_one_of_many && !self.same(one, other)).then_some(edge)
    }

    /// The halfedge of a face in `before` that starts at a vertex.
    fn corner(&self, vertex: Ref, face: Ref) -> Option<Ref> {
        let orbit = self.before.loops.iter().find(|orbit| orbit.face.name == face.name)?;
        let mut items = orbit.items.iter();
        items.find_map(|item| {
            let moved = |mention: Ref| self.moved(mention, vertex, item.from);
            let is_there = item.from.name == vertex.name && self.same(moved(orbit.face), face);
            let is_halfedge = self.kind(item.item.name) == Kind::Halfedge;
            (is_there && is_halfedge).then(|| moved(item.item))
        })
    }

    /// A mention that is drawn beside `drawn`, beside `at` instead, which is of the same name.
    fn moved(&self, mention: Ref, at: Ref, drawn: Ref) -> Ref {
        match self.name(mention.name).role {
            Role::Family => Ref { shift: mention.shift + at.shift - drawn.shift, ..mention },
            _ => mention,
        }
    }

    fn same(&self, one: Ref, other: Ref) -> bool {
        one.name == other.name && one.shift == other.shift
    }

    /// A mentioned element as a value.
    fn element(&self, mention: Ref) -> ExprKind {
        match self.name(mention.name).role {
            Role::Family => ExprKind::Member(mention.name, mention.shift),
            _ => ExprKind::Element(mention.name),
        }
    }
}
