//! Orbits drawn with `each`, whose families are bound by a walk once around.

use super::matching::Step;
use super::pointer::Leads;
use super::reach::Reach;
use crate::diagram::{Kind, NameId, Spoke};

/// An orbit with `each`, as drawn in the unrolled rule.
struct Around {
    orbit: NameId,
    along_loop: bool,
    /// The halfedges of the whole orbit, in order; an orbit with runs cannot be walked this way.
    halfedges: Vec<NameId>,
    /// The number of halfedges in one period.
    period: usize,
}

impl Reach<'_> {
    /// Binds the families of an orbit with `each` that has a known halfedge; `false` if there is no
    /// such orbit.
    pub fn walk(&mut self) -> bool {
        let rule = self.drawing.rule;
        for around in self.orbits() {
            let first = around.halfedges.iter().position(|&half| {
                rule.is_first(half) && self.begun.contains(&half) && !self.is_bound(half)
            });
            let Some(first) = first else { continue };
            let count = around.halfedges.len();
            let turned = (0..around.period).map(|at| around.halfedges[(first + at) % count]);
            let halfedges: Vec<_> = turned.collect();
            // The walk begins where the family does.
            let known = halfedges[0];
            self.begun.retain(|&begun| begun != known);
            self.steps.push(Step::Walk { orbit: around.orbit, halfedges: halfedges.clone() });
            for half in halfedges {
                self.now_bound(half);
            }
            self.use_pointers(&around);
            return true;
        }
        false
    }

    /// Marks the pointers that the walk follows as used.
    fn use_pointers(&mut self, around: &Around) {
        let leads = if around.along_loop { Leads::Next } else { Leads::Counterclockwise };
        let count = around.halfedges.len();
        for pointer in &mut self.pointers {
            let at = around.halfedges.iter().position(|&h| h == pointer.from);
            let next = at.map(|at| around.halfedges[(at + 1) % count]);
            pointer.used |= pointer.leads == leads && next == Some(pointer.to);
        }
    }

    /// The number of halfedges of a face or vertex that are tried as the first one, if not all:
    /// with `each`, those of one period; without, as many as are drawn, if the whole orbit is
    /// drawn. If a family has a first member already, each turn of this orbit is another match.
    pub fn tries(&self, element: NameId) -> Option<u16> {
        let around = self.orbits().into_iter().find(|around| around.orbit == element);
        let walked = self.steps.iter().any(|step| matches!(step, Step::Walk { .. }));
        let tries = match around {
            Some(_) if walked || !self.begun.is_empty() => return None,
            Some(around) => around.period,
            None => self.whole_orbit(element)?,
        };
        u16::try_from(tries).ok()
    }

    /// The number of halfedges of a loop or a star that is drawn without runs.
    fn whole_orbit(&self, element: NameId) -> Option<usize> {
        let (rule, before) = (self.drawing.rule, &self.drawing.before);
        match rule.kind(element) {
            Kind::Face => {
                let items = &before.loop_of_face(element)?.items;
                let mut kinds = items.iter().map(|item| rule.kind(item.item.name));
                kinds.all(|kind| kind == Kind::Halfedge).then_some(items.len())
            }
            Kind::Vertex => {
                let spokes = &before.star(element)?.spokes;
                spokes.iter().all(|spoke| spoke.halfedge().is_some()).then_some(spokes.len())
            }
            _ => None,
        }
    }

    fn orbits(&self) -> Vec<Around> {
        let rule = self.drawing.rule;
        let size = rule.size().unwrap_or(1) as usize;
        let around = |orbit: NameId, along_loop: bool, halfedges: Vec<NameId>| {
            let period = halfedges.len() / size;
            Around { orbit, along_loop, halfedges, period }
        };
        let loops = rule.before.loops.iter().filter(|orbit| orbit.each).filter_map(|orbit| {
            let halfedges: Vec<_> = orbit.item_names().collect();
            let is_whole = halfedges.iter().all(|&item| rule.kind(item) == Kind::Halfedge);
            is_whole.then(|| around(orbit.face.name, true, halfedges))
        });
        let stars = rule.before.stars.iter().filter(|star| star.each).filter_map(|star| {
            let halfedges: Option<Vec<_>> = star.spokes.iter().map(Spoke::halfedge).collect();
            Some(around(star.vertex.name, false, halfedges?))
        });
        loops.chain(stars).collect()
    }
}
