//! Drawings that look alike from both sides of an edge.
//!
//! A half turn maps such a drawing to itself with other names, as for a flip:
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
//! If matching fails from one halfedge of the edge, it fails from the other; and if the guard
//! refuses, the result from the other would be the same mesh. So only one is tried.

use crate::diagram::{Drawing, Kind, NameId, View};

/// Whether a rule looks the same from both halfedges of an edge, tests nothing that could tell them
/// apart, and sets nothing that may be refused.
pub(super) fn is_symmetric(drawing: &Drawing, halfedge: NameId) -> bool {
    let rule = drawing.rule;
    let names = || (0..rule.names.len() as u32).map(NameId);
    let is_plain = rule.requires.is_empty()
        && rule.assignments.is_empty()
        && rule.aliases.is_empty()
        && [&rule.before, &rule.after].iter().all(|side| side.kept.is_empty())
        && rule.params.iter().flatten().count() == 1
        && names().all(|name| rule.kind(name) != Kind::Fan && !rule.is_member(name));
    let Some(twin) = drawing.before.twin(halfedge).filter(|_| is_plain) else {
        return false;
    };
    let mut turn = Turn { drawing, images: vec![None; rule.names.len()], open: Vec::new() };
    turn.maps(Some(halfedge), Some(twin))
        && turn.maps(Some(twin), Some(halfedge))
        && turn.follow()
        && turn.images.iter().all(Option::is_some)
}

/// The turn, as far as it is known.
struct Turn<'d> {
    drawing: &'d Drawing<'d>,
    /// For each name, the name that it becomes.
    images: Vec<Option<NameId>>,
    /// Names whose neighbors have not been compared yet.
    open: Vec<NameId>,
}

impl Turn<'_> {
    /// Whether a name can become another; both may be `None`.
    fn maps(&mut self, name: Option<NameId>, image: Option<NameId>) -> bool {
        let (Some(name), Some(image)) = (name, image) else {
            return name.is_none() && image.is_none();
        };
        let (drawing, rule) = (self.drawing, self.drawing.rule);
        match self.images[name.index()].replace(image) {
            Some(known) => known == image,
            None => {
                self.open.push(name);
                rule.kind(name) == rule.kind(image)
                    && drawing.created(name).is_some() == drawing.created(image).is_some()
                    && drawing.erased(name).is_some() == drawing.erased(image).is_some()
            }
        }
    }

    /// Whether all that is drawn around the names becomes what is drawn around their images.
    fn follow(&mut self) -> bool {
        let drawing = self.drawing;
        while let Some(name) = self.open.pop() {
            let Some(image) = self.images[name.index()] else {
                return false;
            };
            // Turning twice is the identity.
            if self.images[image.index()].is_some_and(|back| back != name)
                || ![&drawing.before, &drawing.after]
                    .into_iter()
                    .all(|view| self.follow_in(view, name, image))
            {
                return false;
            }
        }
        true
    }

    fn follow_in(&mut self, view: &View, name: NameId, image: NameId) -> bool {
        match self.drawing.rule.kind(name) {
            Kind::Halfedge | Kind::Path => {
                let near = |item| {
                    [
                        view.item_after(item),
                        view.item_before(item),
                        view.loop_origin(item),
                        view.loop_target(item),
                        view.face(item),
                        view.twin(item),
                        view.edge(item),
                    ]
                };
                let pairs = near(name).into_iter().zip(near(image));
                view.star_of_spoke(name).is_none()
                    && pairs.fold(true, |all, (from, to)| all && self.maps(from, to))
            }
            Kind::Face => {
                let [here, there] = [name, image].map(|face| view.loop_of_face(face));
                match (here, there) {
                    (Some(here), Some(there)) => {
                        here.kind == there.kind && here.items.len() == there.items.len()
                    }
                    (here, there) => here.is_none() && there.is_none(),
                }
            }
            Kind::Vertex => view.star(name).is_none() && view.star(image).is_none(),
            Kind::Edge => {
                view.edge_statement(name).is_some() == view.edge_statement(image).is_some()
            }
            Kind::Fan => false,
        }
    }
}
