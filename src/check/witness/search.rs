//! A small mesh on which a rewrite breaks.
//!
//! First any place is searched for, from small to large: the fewest halfedges on every path, then
//! more; the arcs without further spokes, then with a few; all ways in which the arcs can run. A
//! failing case of law 7 brings its arcs along; they are tried first.
//!
//! Then all smaller meshes are examined, if there are not too many, so that the one that is shown
//! has the fewest halfedges. They have the level of the first: people draw polygon meshes, and
//! files hold them.

use super::super::alias::Quotient;
use super::super::arrangement::{Arc, ArcContent};
use super::super::port::Port;
use super::completion::{Completions, End};
use super::literal::{Carried, carry_out};
use super::outside::{Further, Join, joins_of, ways};
use super::place::Place;
use super::sketch::{Shape, Sketch, VertexRole};
use crate::diagram::{Drawing, Kind, NameId, Spoke};
use crate::mesh::{Invalid, Level, validate};
use std::ops::ControlFlow;

/// The result of a search.
pub(super) enum Found {
    /// A place where the rewrite breaks the mesh.
    Breaks(Box<Shown>),
    /// Only places where the mesh stays valid: their number.
    Valid(usize),
    /// The drawing contradicts itself: there is no place.
    NoPlace,
    /// Nothing: `after` uses a name that nothing binds, or the search would be too long.
    Unclear,
}

/// A place, and the outcome of the rewrite there.
pub(super) struct Shown {
    pub place: Place,
    /// The rewrite carried out.
    pub carried: Carried,
    /// The reason why the result is not valid.
    pub invalid: Invalid,
    /// The level for which it has the fewest halfedges of all meshes that break, if that is known.
    pub smallest_of: Option<Level>,
}

/// The greatest number of meshes that are built.
const MOST_BUILT: usize = 600;
/// The greatest number of halfedges and spokes that are added to the fewest possible.
const MOST_ADDED: usize = 4;
/// The greatest number of links that are tried in smaller meshes.
const MOST_STEPS: usize = 6_000;
/// The greatest number of combinations of arcs that are tried in one shape.
const MOST_COMBINATIONS: usize = 96;

/// The greatest number of shapes that are examined, the smallest first.
const MOST_SHAPES: usize = 10_000;

/// Searches for a place where a rewrite breaks the mesh.
pub(super) fn search(drawing: &Drawing, arcs: Option<&[Arc]>) -> Found {
    Search::new(drawing, drawing).run(drawing, arcs)
}

/// The same among the places where names are one.
pub(super) fn search_where_one(
    drawing: &Drawing,
    quotient: &Quotient,
    arcs: Option<&[Arc]>,
) -> Found {
    let laid = Drawing::new(&quotient.rule);
    let search = Search { quotient: Some(quotient), ..Search::new(drawing, &laid) };
    search.run(drawing, arcs)
}

impl<'a> Search<'a> {
    fn new(carried_out: &'a Drawing<'a>, drawing: &'a Drawing<'a>) -> Self {
        Self { drawing, carried_out, quotient: None, built: 0, valid: 0 }
    }

    fn run(mut self, drawing: &Drawing, arcs: Option<&[Arc]>) -> Found {
        let first = self.arcs(arcs).or_else(|| self.anywhere());
        let shown = self.smallest(first);
        self.found(drawing, shown)
    }

    /// A smaller mesh than the first, if one breaks, or any if there is no first; else the first.
    fn smallest(&mut self, first: Option<Shown>) -> Option<Shown> {
        let level = first.as_ref().map_or(Level::Map, |shown| shown.place.level());
        let fewest = self.drawing.rule.names_of(Kind::Halfedge).count();
        let most = first.as_ref().map(|shown| shown.place.mesh.halfedge_count());
        let ambiguous = self.has_fans_side_by_side();
        let drawing = self.drawing;
        let mut visit = |sketch: Sketch| self.attempt_closed(sketch, level);
        let mut completions =
            Completions { drawing, ambiguous, level, steps: MOST_STEPS, visit: &mut visit };
        let mut smallest_of = Some(level);
        for size in (2..most.unwrap_or(2 * fewest + 2 * MOST_ADDED)).step_by(2) {
            match completions.of_size(size) {
                ControlFlow::Continue(()) => {}
                ControlFlow::Break(End::Found(shown)) => {
                    return Some(Shown { smallest_of, ..*shown });
                }
                ControlFlow::Break(End::TooMany) => {
                    smallest_of = None;
                    break;
                }
            }
        }
        Some(Shown { smallest_of, ..first? })
    }

    fn found(self, drawing: &Drawing, shown: Option<Shown>) -> Found {
        let search = self;
        if let Some(shown) = shown {
            return Found::Breaks(Box::new(shown.finished(drawing)));
        }
        match search.valid {
            0 if search.built < MOST_BUILT && search.is_runnable() => Found::NoPlace,
            0 => Found::Unclear,
            valid => Found::Valid(valid),
        }
    }
}

impl Shown {
    fn finished(mut self, drawing: &Drawing) -> Self {
        self.place.finish();
        if let Some(carried) = carry_out(drawing, &self.place) {
            self.carried = carried;
        }
        self
    }
}

struct Search<'a> {
    /// The drawing that is laid down.
    drawing: &'a Drawing<'a>,
    /// The drawing that is carried out: the same or, where names are one, that of the rule in which
    /// they are separate.
    carried_out: &'a Drawing<'a>,
    quotient: Option<&'a Quotient>,
    built: usize,
    valid: usize,
}

/// A shape, and how many halfedges it has beyond the fewest.
type Sized = (usize, Shape);

impl Search<'_> {
    /// True if all names of `after` are known, so that the rewrite can be carried out.
    fn is_runnable(&self) -> bool {
        let known = |index: usize| {
            let name = NameId(index as u32);
            self.drawing.after.mention(name).is_none()
                || self.drawing.before.mention(name).is_some()
                || self.drawing.created(name).is_some()
        };
        (0..self.drawing.rule.names.len()).all(known)
    }

    /// Tries the arcs of the failing case of law 7.
    fn arcs(&mut self, arcs: Option<&[Arc]>) -> Option<Shown> {
        let arcs = arcs?;
        let empty = |path: NameId| {
            let around = |arc: &Arc| arc.from == Port::Out(path) && arc.to == Port::In(path);
            self.drawing.may_be_empty(path) && arcs.iter().any(around)
        };
        let mut shapes = self.shapes(&|path| usize::from(!empty(path)));
        for (_, shape) in &mut shapes {
            shape.glued = self.glued_by(arcs, shape);
        }
        self.sizes(&shapes, &|sketch| joins_of(sketch, arcs).into_iter().collect())
    }

    /// Twins that follow from arcs without a spoke.
    fn glued_by(&self, arcs: &[Arc], shape: &Shape) -> Vec<[usize; 2]> {
        let Some(sketch) = Sketch::build(self.drawing, shape) else { return Vec::new() };
        let mut glued: Vec<[usize; 2]> = Vec::new();
        for arc in arcs.iter().filter(|arc| arc.content == ArcContent::Empty) {
            let (Port::Out(from), Port::In(to)) = (arc.from, arc.to) else { continue };
            let first = |name: NameId| {
                sketch.half_of[name.index()].or(sketch.runs[name.index()].first().copied())
            };
            let last = |name: NameId| {
                sketch.half_of[name.index()].or(sketch.runs[name.index()].last().copied())
            };
            let (Some(left), Some(right)) = (first(from), last(to)) else { continue };
            let told = glued.iter().flatten().any(|&half| half == left || half == right);
            if left != right && !told {
                glued.push([left, right]);
            }
        }
        glued
    }

    /// Tries every way in which the arcs can run.
    fn anywhere(&mut self) -> Option<Shown> {
        let shapes = self.shapes(&|path| {
            let may_be_empty = self.drawing.may_be_empty(path);
            usize::from(!may_be_empty)
        });
        self.sizes(&shapes, &combinations).or_else(|| {
            let late = |(added, shape): &Sized| {
                let shape = shape.clone();
                (*added, Shape { late: true, ..shape })
            };
            let late: Vec<_> = shapes.iter().map(late).collect();
            self.has_fans_side_by_side().then(|| self.sizes(&late, &combinations))?
        })
    }

    fn has_fans_side_by_side(&self) -> bool {
        let mut stars = self.drawing.rule.before.stars.iter();
        stars.any(|star| {
            let count = star.spokes.len();
            let is_fan = |at: usize| !matches!(star.spokes[at % count], Spoke::Halfedge(_));
            count > 1 && (0..count).any(|at| is_fan(at) && is_fan(at + 1))
        })
    }

    /// The shapes with lengths of the paths from the least on, the smallest first.
    fn shapes(&self, least: &dyn Fn(NameId) -> usize) -> Vec<Sized> {
        let count = self.drawing.rule.names.len();
        let mut shapes = vec![(0, Shape { lengths: vec![0; count], ..Shape::default() })];
        for path in self.drawing.rule.names_of(Kind::Path) {
            let least = least(path);
            shapes = shapes
                .into_iter()
                .flat_map(|(added, shape)| {
                    (least..=least.max(1) + 1).map(move |length| {
                        let mut shape = shape.clone();
                        shape.lengths[path.index()] = length;
                        (added + length - least, shape)
                    })
                })
                .filter(|&(added, _)| added <= MOST_ADDED)
                .collect();
            shapes.sort_by_key(|&(added, _)| added);
            shapes.truncate(MOST_SHAPES);
        }
        shapes
    }

    /// Tries shapes with further spokes, from few to many.
    fn sizes(
        &mut self,
        shapes: &[Sized],
        ways: &dyn Fn(&Sketch) -> Vec<Vec<Join>>,
    ) -> Option<Shown> {
        for size in 0..=MOST_ADDED {
            for (added, shape) in shapes.iter().filter(|(added, _)| *added <= size) {
                let Some(sketch) = Sketch::build(self.drawing, shape) else { continue };
                for joins in ways(&sketch) {
                    for further in furthers(&sketch, &joins, size - added) {
                        if self.built == MOST_BUILT {
                            return None;
                        }
                        if let Some(broken) = self.attempt(sketch.clone(), &joins, further) {
                            return Some(broken);
                        }
                    }
                }
            }
        }
        None
    }

    fn attempt(&mut self, mut sketch: Sketch, joins: &[Join], further: Further) -> Option<Shown> {
        self.built += 1;
        sketch.close(joins, further);
        self.attempt_closed(sketch, Level::Map)
    }

    fn attempt_closed(&mut self, sketch: Sketch, level: Level) -> Option<Shown> {
        let mut place = Place::of(self.drawing, sketch)?;
        if level > Level::Map && !place.can_have(level) {
            return None;
        }
        if let Some(quotient) = self.quotient {
            place = place.with_each_name(self.carried_out.rule, quotient);
        }
        let carried = carry_out(self.carried_out, &place)?;
        self.valid += 1;
        let invalid = validate(&carried.mesh).err()?;
        Some(Shown { place, carried, invalid, smallest_of: None })
    }
}

/// The ways to add further spokes: `count` in one arc, or, for 3, one in each.
fn furthers(sketch: &Sketch, joins: &[Join], count: usize) -> Vec<Further> {
    let at_name = |join: &Join| {
        let vertex = sketch.halves[join.leaves].origin;
        matches!(sketch.vertices[vertex], VertexRole::Named(_))
    };
    let places = (0..joins.len()).filter(|&at| at_name(&joins[at]));
    match count {
        0 => vec![Further::Nowhere],
        1 | 2 => places.map(|at| Further::In(at, count)).collect(),
        3 => vec![Further::Everywhere],
        _ => Vec::new(),
    }
}

/// Every combination of the ways of all vertices.
fn combinations(sketch: &Sketch) -> Vec<Vec<Join>> {
    let Some(vertices) = ways(sketch) else { return Vec::new() };
    let mut combinations = vec![Vec::new()];
    for ways in vertices {
        let longer = combinations.iter().flat_map(|joins: &Vec<Join>| {
            ways.iter().map(move |way| [joins.as_slice(), way].concat())
        });
        combinations = longer.take(MOST_COMBINATIONS).collect();
    }
    combinations
}
