//! Values that new elements take over from what was there: of the attributes that are
//! [inherited](super::Attribute::inherits) and that the rule does not set.
//!
//! A new face takes the value of the face whose halfedge it has now, or else that of a face beside
//! it; a new edge that of the only edge that lay between the faces that those at its sides come
//! from, or, beside a new hole, that of the edge to which its other halfedge belonged; a new
//! halfedge that of the corner where it starts, in the face that its own comes from.
//! Anything else has the default.

use super::{
    Access, Assignment, Drawing, Expr, ExprKind, Kind, LoopKind, NameId, Pointer, Ref, Role, Rule,
    Type, View,
};

/// The element in `before` from which a new one inherits.
enum Source {
    Drawn(Ref),
    /// The first halfedge of a path, behind a drawn one.
    Next(Ref),
}

impl Rule {
    /// The assignments by which new elements inherit.
    pub fn inherited(&self) -> Vec<Assignment> {
        let mut all = Vec::new();
        if !self.attributes.iter().any(|attribute| attribute.inherits) {
            return all;
        }
        let drawing = Drawing::new(self);
        for &target in &self.created {
            let element = self.kind(target.name).element_type();
            let (Some(element), Some(source)) = (element, drawing.source(target)) else { continue };
            let value = |ty, kind| Expr { ty, kind, span: target.span };
            for (number, attribute) in (0..).zip(self.attributes.iter()) {
                let access = Access::Declared(number);
                let has_it = attribute.inherits && attribute.element == element;
                if has_it && !self.sets(target.name, access) {
                    let source = match source {
                        Source::Drawn(drawn) => self.element(drawn),
                        Source::Next(drawn) => {
                            let drawn = value(Type::Halfedge, self.element(drawn));
                            ExprKind::Follow(Pointer::Next, Box::new(drawn))
                        }
                    };
                    let source = Box::new(value(element, source));
                    let value = value(attribute.ty, ExprKind::Read(access, source));
                    all.push(Assignment { target, attribute: access, value, span: target.span });
                }
            }
        }
        all
    }

    fn sets(&self, name: NameId, attribute: Access) -> bool {
        self.assignments.iter().any(|one| one.target.name == name && one.attribute == attribute)
    }

    /// A mention that is drawn beside `drawn`, beside `at` instead, which is of the same name.
    fn moved(&self, mention: Ref, at: Ref, drawn: Ref) -> Ref {
        match self.name(mention.name).role {
            Role::Family => Ref { shift: mention.shift + at.shift - drawn.shift, ..mention },
            _ => mention,
        }
    }

    /// A mentioned element as a value.
    fn element(&self, mention: Ref) -> ExprKind {
        match self.name(mention.name).role {
            Role::Family => ExprKind::Member(mention.name, mention.shift),
            _ => ExprKind::Element(mention.name),
        }
    }

    fn is_single(&self, mention: Ref) -> bool {
        self.name(mention.name).role == Role::Single
    }
}

impl Drawing<'_> {
    fn source(&self, created: Ref) -> Option<Source> {
        let rule = self.rule;
        let source = match rule.kind(created.name) {
            Kind::Face => Source::Drawn(self.origin(created)?),
            Kind::Edge => Source::Drawn(match self.sides(created) {
                Some(sides) => self.edge_between(sides),
                None => self.edge_of_rim(created),
            }?),
            Kind::Halfedge => {
                let (orbit, item) = self.after.loop_item(created.name)?;
                let origin = self.origin(rule.moved(orbit.face, created, item.item))?;
                self.corner(rule.moved(item.from, created, item.item), origin)?
            }
            _ => return None,
        };
        let (Source::Drawn(drawn) | Source::Next(drawn)) = source;
        // An element that is there once cannot take over the values of several.
        (!rule.is_single(created) || rule.is_single(drawn)).then_some(source)
    }

    /// The face in `before` that a face in `after` comes from.
    fn origin(&self, face: Ref) -> Option<Ref> {
        if self.created(face.name).is_none() {
            return Some(face);
        }
        self.own(face).or_else(|| {
            self.drawn(face)?.into_iter().find_map(|item| {
                let beside = self.face_of(&self.after, self.twin(item)?)?;
                match self.created(beside.name) {
                    Some(_) => self.own(beside),
                    None => Some(beside).filter(|face| !self.is_hole(*face)),
                }
            })
        })
    }

    /// The face, and no hole, in which a halfedge or path of a new face lay.
    fn own(&self, face: Ref) -> Option<Ref> {
        let items = self.drawn(face)?.into_iter();
        items.filter_map(|item| self.face_of(&self.before, item)).find(|face| !self.is_hole(*face))
    }

    /// The halfedges and paths of a face, and no hole, in `after`.
    fn drawn(&self, face: Ref) -> Option<Vec<Ref>> {
        let orbit = self.after.loop_of_face(face.name);
        let orbit = orbit.filter(|orbit| orbit.kind != LoopKind::Hole)?;
        let items = orbit.items.iter();
        Some(items.map(|item| self.rule.moved(item.item, face, orbit.face)).collect())
    }

    fn is_hole(&self, face: Ref) -> bool {
        self.before.loop_of_face(face.name).is_some_and(|orbit| orbit.kind == LoopKind::Hole)
    }

    /// The face of a halfedge or path on one side.
    fn face_of(&self, view: &View, item: Ref) -> Option<Ref> {
        let (orbit, drawn) = view.loop_item(item.name)?;
        Some(self.rule.moved(orbit.face, item, drawn.item))
    }

    /// The twin of a halfedge in `after`.
    fn twin(&self, halfedge: Ref) -> Option<Ref> {
        let [a, b] = self.after.pairing(halfedge.name)?.halfedges;
        let (own, other) = if a.name == halfedge.name { (a, b) } else { (b, a) };
        Some(self.rule.moved(other, halfedge, own))
    }

    /// The faces in `before` that the faces at the sides of a new edge come from.
    fn sides(&self, edge: Ref) -> Option<[Ref; 2]> {
        let drawn = self.after.edge_statement(edge.name)?;
        let [a, b] = drawn.halfedges.map(|halfedge| {
            let halfedge = self.rule.moved(halfedge, edge, drawn.edge);
            self.origin(self.face_of(&self.after, halfedge)?)
        });
        Some([a?, b?])
    }

    /// The only edge in `before` between two different faces.
    fn edge_between(&self, [one, other]: [Ref; 2]) -> Option<Ref> {
        let rule = self.rule;
        let (one, other) = if rule.is_single(one) { (other, one) } else { (one, other) };
        let mut found = rule.before.edges.iter().filter_map(|edge| {
            let [a, b] = edge.halfedges.map(|halfedge| self.face_of(&self.before, halfedge));
            let lies = |x: Ref, y: Ref| {
                let moved = |mention: Ref| rule.moved(mention, one, x);
                (x.name == one.name && same(moved(y), other)).then(|| moved(edge.edge))
            };
            lies(a?, b?).or_else(|| lies(b?, a?))
        });
        let edge = found.next().filter(|_| found.next().is_none())?;
        let is_one_of_many = rule.is_single(one) && !rule.is_single(edge);
        (!is_one_of_many && !same(one, other)).then_some(edge)
    }

    /// The edge in `before` of the halfedge that a new edge has beside a hole.
    fn edge_of_rim(&self, edge: Ref) -> Option<Ref> {
        let drawn = self.after.edge_statement(edge.name)?;
        let [a, b] = drawn.halfedges.map(|half| self.rule.moved(half, edge, drawn.edge));
        let is_outside = |half: Ref| {
            self.after.loop_item(half.name).is_some_and(|(orbit, _)| orbit.kind == LoopKind::Hole)
        };
        let inside = match [is_outside(a), is_outside(b)] {
            [true, false] => b,
            [false, true] => a,
            _ => return None,
        };
        let was = self.before.pairing(inside.name)?;
        let own = was.halfedges.into_iter().find(|half| half.name == inside.name)?;
        Some(self.rule.moved(was.edge, inside, own))
    }

    /// The halfedge of a face in `before` that starts at a vertex; best a drawn one.
    fn corner(&self, vertex: Ref, face: Ref) -> Option<Source> {
        let rule = self.rule;
        let orbit = self.before.loop_of_face(face.name)?;
        let is_drawn = |item: Ref| rule.kind(item.name) == Kind::Halfedge;
        let corners = orbit.items.iter().enumerate().filter_map(|(at, item)| {
            let moved = |mention: Ref| rule.moved(mention, vertex, item.from);
            let is_there = item.from.name == vertex.name && same(moved(orbit.face), face);
            is_there.then(|| (at, moved(item.item)))
        });
        let drawn = corners.clone().find(|(_, item)| is_drawn(*item));
        drawn.map(|(_, item)| Source::Drawn(item)).or_else(|| {
            corners.clone().find_map(|(at, path)| {
                let before = match at.checked_sub(1) {
                    Some(before) => &orbit.items[before],
                    // The last of another period with `each`.
                    None => orbit.items.last().filter(|_| !orbit.each)?,
                };
                let before = rule.moved(before.item, path, orbit.items[at].item);
                is_drawn(before).then_some(Source::Next(before))
            })
        })
    }
}

fn same(one: Ref, other: Ref) -> bool {
    one.name == other.name && one.shift == other.shift
}
