//! Drawings that are refused alike from both halfedges of an edge.
//!
//! A half turn maps the names of such a drawing to each other, as for a flip:
//!
//! ```text
//!        v2                 v3              v0 <-> v1    a <-> d    f0 <-> f1
//!       /  \               /  \             v2 <-> v3    b <-> g
//!     c/ f0 \b           h/ f1 \g                        c <-> h
//!     /  a-> \           /  d-> \
//!   v0 ------ v1  turned v1 ----- v0
//!     \ <-d  /           \ <-a  /
//!     g\ f1 /h           b\ f0 /c
//!       \  /               \  /
//!        v3                 v2
//! ```
//!
//! The drawing before is mapped to itself, and so are the tests of matching: if matching fails
//! from one halfedge of the edge, it fails from the other. Of the drawing after, the `next` and
//! `twin` of halfedges are mapped to themselves, and which loops are holes. So the results from both
//! halfedges are one mesh, whose vertices, edges and faces may bear other names: a collapse keeps
//! `v0` or `v1`. The tests of the guard are asked about the same orbits of it, so it refuses both.

use super::guard::{Guard, Question};
use super::matching::{Matching, Test};
use crate::check::matching::Claim;
use crate::diagram::{Drawing, Kind, NameId, View};
use crate::mesh::OrbitCondition;

/// Whether matching and the guard of a rule refuse both halfedges of an edge if they refuse one.
pub(super) fn refuses_alike(
    drawing: &Drawing,
    halfedge: NameId,
    matching: &Matching,
    guard: &Guard,
) -> bool {
    let rule = drawing.rule;
    let is_plain = rule.requires.is_empty()
        && rule.aliases.is_empty()
        && [&rule.before, &rule.after].iter().all(|side| side.kept.is_empty())
        && rule.params.iter().flatten().count() == 1
        && rule.ids().all(|name| !rule.is_member(name));
    let Some(twin) = drawing.before.twin(halfedge).filter(|_| is_plain) else { return false };
    let mut turn = HalfTurn { drawing, images: vec![None; rule.names.len()], open: Vec::new() };
    turn.maps(Some(halfedge), Some(twin))
        && turn.maps(Some(twin), Some(halfedge))
        && turn.follow()
        && rule.ids().all(|name| !is_item(drawing, name) || turn.image(name).is_some())
        && turn.keeps_tests(&matching.tests)
        && turn.keeps_guard(guard)
}

fn is_item(drawing: &Drawing, name: NameId) -> bool {
    matches!(drawing.rule.kind(name), Kind::Halfedge | Kind::Path)
}

/// The automorphism, as far as it is known.
struct HalfTurn<'d> {
    drawing: &'d Drawing<'d>,
    /// For each name, the name that it becomes.
    images: Vec<Option<NameId>>,
    /// Names whose neighbors have not been compared yet.
    open: Vec<NameId>,
}

/// The half turn of what is drawn.
impl HalfTurn<'_> {
    fn image(&self, name: NameId) -> Option<NameId> {
        self.images[name.index()]
    }

    /// Whether a name can become another; both may be `None`.
    fn maps(&mut self, name: Option<NameId>, image: Option<NameId>) -> bool {
        let (Some(name), Some(image)) = (name, image) else {
            return name.is_none() && image.is_none();
        };
        let drawing = self.drawing;
        match self.images[name.index()].replace(image) {
            Some(known) => known == image,
            None => {
                self.open.push(name);
                let is = |name| (drawing.created(name).is_some(), drawing.erased(name).is_some());
                drawing.rule.kind(name) == drawing.rule.kind(image)
                    && (!is_item(drawing, name) || is(name) == is(image))
            }
        }
    }

    /// Whether all that is drawn around the names becomes what is drawn around their images.
    fn follow(&mut self) -> bool {
        while let Some(name) = self.open.pop() {
            let Some(image) = self.image(name) else { return false };
            // Turning twice is the identity.
            let is_turned_back = self.image(image).is_none_or(|back| back == name);
            if !(is_turned_back
                && self.follow_before(name, image)
                && self.follow_after(name, image))
            {
                return false;
            }
        }
        true
    }

    fn follow_before(&mut self, name: NameId, image: NameId) -> bool {
        let view = &self.drawing.before;
        match self.drawing.rule.kind(name) {
            Kind::Halfedge | Kind::Path => self.follow_items(name, image, |item| {
                [
                    view.item_after(item),
                    view.item_before(item),
                    view.loop_origin(item),
                    view.loop_target(item),
                    view.face(item),
                    view.twin(item),
                    view.edge(item),
                ]
            }),
            Kind::Face => same_loops(view, [name, image].map(Some)),
            Kind::Vertex => true,
            Kind::Edge => {
                view.edge_statement(name).is_some() == view.edge_statement(image).is_some()
            }
            Kind::Fan => false,
        }
    }

    fn follow_after(&mut self, name: NameId, image: NameId) -> bool {
        let view = &self.drawing.after;
        !is_item(self.drawing, name)
            || same_loops(view, [name, image].map(|item| view.face(item)))
                && self.follow_items(name, image, |item| {
                    [view.item_after(item), view.item_before(item), view.twin(item)]
                })
    }

    fn follow_items<const N: usize>(
        &mut self,
        name: NameId,
        image: NameId,
        near: impl Fn(NameId) -> [Option<NameId>; N],
    ) -> bool {
        near(name).into_iter().zip(near(image)).all(|(from, to)| self.maps(from, to))
    }
}

/// Whether two loops of a view, if there are any, are of the same kind and length.
fn same_loops(view: &View, faces: [Option<NameId>; 2]) -> bool {
    let loops = faces.map(|face| view.loop_of_face(face?));
    let [here, there] = loops.map(|drawn| drawn.map(|drawn| (drawn.kind, drawn.items.len())));
    here == there
}

/// The half turn of tests.
impl HalfTurn<'_> {
    /// Whether each test of matching becomes one of them.
    fn keeps_tests(&self, tests: &[Test]) -> bool {
        tests.iter().all(|test| {
            let Some(image) = self.image_of_claim(&test.condition) else { return false };
            let turned = match image {
                Claim::Distinct(left, right) => Some(Claim::Distinct(right, left)),
                _ => None,
            };
            let is_image = |claim: &Claim| *claim == image || Some(claim) == turned.as_ref();
            tests.iter().any(|test| is_image(&test.condition))
        })
    }

    /// The image of a claim; `None` if it is not known.
    fn image_of_claim(&self, claim: &Claim) -> Option<Claim> {
        let is_known = claim.names().iter().all(|&name| self.image(name).is_some());
        let image = |name: NameId| self.image(name).unwrap_or(name);
        Some(match claim {
            _ if !is_known => return None,
            Claim::Leads(source, to) => Claim::Leads(source.map(image), to.map(image)),
            Claim::Distinct(left, right) => Claim::Distinct(image(*left), image(*right)),
            Claim::Kind(face, kind) => Claim::Kind(image(*face), *kind),
            _ => return None,
        })
    }

    /// Whether each question of a guard is asked after the turn too.
    fn keeps_guard(&self, guard: &Guard) -> bool {
        let is_asked = |question: Question| {
            guard.tests.iter().any(|test| match (question, test.question) {
                (Question::NotAdjacent([a, b]), Question::NotAdjacent(ends)) => {
                    let ends = ends.map(|end| self.image(end));
                    ends == [Some(a), Some(b)] || ends == [Some(b), Some(a)]
                }
                (
                    Question::Holds { condition, of, at },
                    Question::Holds { condition: turned, of: image, at: image_at },
                ) => {
                    condition == turned
                        && self.is_orbit(condition, of, image)
                        && match (at, image_at) {
                            (None, None) => true,
                            (Some(at), Some(image_at)) => self.is_orbit(condition, at, image_at),
                            _ => false,
                        }
                }
                _ => false,
            })
        };
        guard.tests.iter().all(|test| is_asked(test.question))
    }

    /// Whether the turn maps the orbit of a name to that of another: a vertex, loop or edge of the
    /// result.
    fn is_orbit(&self, condition: OrbitCondition, name: NameId, from: NameId) -> bool {
        let (drawing, view) = (self.drawing, &self.drawing.after);
        let is_drawn = |item: &NameId| is_item(drawing, *item) && view.mention(*item).is_some();
        let lies_at = |item: NameId, name: NameId| match drawing.rule.kind(name) {
            Kind::Vertex => drawing.origin_after(item) == Some(name),
            Kind::Face => view.face(item) == Some(name),
            _ => {
                condition == OrbitCondition::SingleEdge
                    && (item == name || view.twin(item) == Some(name))
            }
        };
        let mut items = drawing.rule.ids().filter(is_drawn).filter(|&item| lies_at(item, from));
        items.any(|item| self.image(item).is_some_and(|image| lies_at(image, name)))
    }
}
