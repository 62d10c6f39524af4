//! An op in steps, tried at one place after the other.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

use glam::DVec3;

use super::stage::Stage;
use crate::compile::width;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Param, Type};
use crate::mesh::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, Mesh, VertexId, identical};
use crate::resolve::Program;
use crate::rewrite::{Plans, StopAfter};
use crate::run::{Application, Applied, Argument};

/// The number of times an op is tried on one mesh.
const TRIES: usize = 48;
/// The most looks of one try, and of all tries together.
const MOST_LOOKS: u32 = 64;
const MOST_LOOKS_IN_ALL: u32 = 1024;
/// The most nearby elements that are tried for a parameter after the first.
const NEARBY: usize = 12;

/// A try in which the op applied and changed something.
pub(super) struct Trial {
    /// The name of the mesh.
    pub(super) on: &'static str,
    /// For each parameter its element, if it takes one.
    pub(super) place: Vec<Option<Element>>,
    pub(super) before: Mesh,
    pub(super) after: Mesh,
    pub(super) created: Vec<Element>,
    pub(super) result: Option<Element>,
}

/// All tries of one op.
pub(super) struct Trials<'p> {
    application: Application,
    params: &'p [Param],
    tries: usize,
    left: u32,
    /// The reasons for refusals, and how often each came up.
    hindrances: BTreeMap<String, usize>,
}

impl<'p> Trials<'p> {
    /// Prepares the tries of an op.
    pub(super) fn new(program: &'p Program, op: usize, plans: &Plans) -> Result<Self, Diagnostic> {
        Ok(Self {
            application: Application::new(program, op, plans)?,
            params: &program.ops[op].params,
            tries: 0,
            left: MOST_LOOKS_IN_ALL,
            hindrances: BTreeMap::new(),
        })
    }

    /// The number of times it was tried.
    pub(super) fn tries(&self) -> usize {
        self.tries
    }

    /// The most frequent reason for a refusal.
    pub(super) fn hindrance(&self) -> Option<String> {
        let most = self.hindrances.iter();
        // Of several, the first in alphabetical order.
        most.max_by_key(|&(why, times)| (*times, Reverse(why))).map(|(why, _)| why.clone())
    }

    /// Tries it at the places of a mesh, until `see` breaks.
    pub(super) fn on(&mut self, stage: &Stage, see: &mut dyn FnMut(Trial) -> ControlFlow<()>) {
        for values in [0, 1] {
            for place in places(&stage.mesh, self.params) {
                if self.left == 0 {
                    return;
                }
                if let Some(trial) = self.once(stage, place, values)
                    && see(trial).is_break()
                {
                    return;
                }
            }
            if self.params.iter().all(|param| param.ty.is_element()) {
                return;
            }
        }
    }

    fn once(&mut self, stage: &Stage, place: Vec<Option<Element>>, values: usize) -> Option<Trial> {
        self.tries += 1;
        let params = self.params.iter().zip(&place);
        let arguments = params.filter_map(|(param, element)| {
            let value = match element {
                Some(element) => Some(Argument::Element(element.kind, element.index)),
                None if param.default.is_some() && values == 0 => None,
                None => Some(plain(param.ty, values)),
            };
            value.map(|value| (param.name.clone(), value))
        });
        let arguments: Vec<_> = arguments.collect();
        let mut after = stage.mesh.clone();
        let most = MOST_LOOKS.min(self.left);
        let mut looks = StopAfter(most);
        let applied = self.application.apply(&mut after, &arguments, &mut looks);
        self.left -= most - looks.0;
        let why = match applied {
            Ok(Applied::Done { result, created }) => {
                drop_columns(&mut after);
                if identical(&stage.mesh, &after) {
                    return None;
                }
                let element = |(kind, index)| Element { kind, index };
                return Some(Trial {
                    on: stage.name,
                    place,
                    before: stage.mesh.clone(),
                    after,
                    created: created.into_iter().map(element).collect(),
                    result: result.map(element),
                });
            }
            Ok(Applied::Refused(why)) => format!("it was refused ({why})"),
            Err(_) if looks.0 == 0 => "it did not come to an end".to_owned(),
            Err(failure) => format!("it failed ({})", failure.diagnostic.message),
        };
        *self.hindrances.entry(why).or_default() += 1;
        None
    }
}

/// Removes all attributes, which examples do not show.
fn drop_columns(mesh: &mut Mesh) {
    for kind in ElementKind::ALL {
        let all: Vec<_> = mesh.columns(kind).map(|(id, _)| id).collect();
        all.into_iter().for_each(|id| mesh.remove_column(id));
    }
}

/// A value that suits most ops; if `other` is 1 another one, which may separate what the first
/// leaves at one position.
fn plain(ty: Type, other: usize) -> Argument {
    let number = [1.0, 0.4][other];
    let parts = |count: usize, is_one: &dyn Fn(usize) -> bool| {
        let part = |at| if is_one(at) { number } else { 0.0 };
        Argument::Reals(ty, (0..count).map(part).collect())
    };
    let count = usize::from(width(ty));
    match ty {
        Type::Bool => Argument::Bool(other == 0),
        Type::Int => Argument::Int([1, 2][other]),
        Type::Text => Argument::Text("a".to_owned()),
        Type::Vec2 | Type::Vec3 | Type::Vec4 => parts(count, &|at| at + 1 == count),
        Type::Mat3 => parts(count, &|at| at.is_multiple_of(4)),
        Type::Mat4 => parts(count, &|at| at.is_multiple_of(5)),
        // Elements are given by their places.
        Type::Real | Type::Vertex | Type::Halfedge | Type::Edge | Type::Face => {
            Argument::Real(number)
        }
    }
}

/// The elements to try for the parameters: for the first each of the mesh, for others those nearby,
/// unused ones before used ones.
fn places(mesh: &Mesh, params: &[Param]) -> Vec<Vec<Option<Element>>> {
    let mut places: Vec<Vec<Option<Element>>> = vec![Vec::new()];
    for param in params {
        let kind = param.ty.element_kind();
        let more = places.iter().flat_map(|place| {
            let known = place.iter().flatten().next().copied();
            let choices: Vec<Option<Element>> = match (kind, known) {
                (None, _) => vec![None],
                (Some(kind), None) => elements(mesh, kind).map(Some).collect(),
                (Some(kind), Some(first)) => {
                    let mut all: Vec<_> = elements(mesh, kind).collect();
                    let from = middle(mesh, first);
                    let key = |other: &Element| {
                        let far = (middle(mesh, *other) - from).length();
                        let is_taken = place.contains(&Some(*other));
                        (is_taken, (far * 1e6).round() as i64, *other)
                    };
                    all.sort_by_key(key);
                    all.truncate(NEARBY);
                    all.into_iter().map(Some).collect()
                }
            };
            let with = |choice| [place.as_slice(), &[choice]].concat();
            choices.into_iter().map(with).collect::<Vec<_>>()
        });
        places = more.collect();
        places.truncate(TRIES);
    }
    places
}

fn elements(mesh: &Mesh, kind: ElementKind) -> impl Iterator<Item = Element> + '_ {
    mesh.elements(kind).map(move |index| Element { kind, index })
}

/// The midpoint of an element, to compare distances between elements.
fn middle(mesh: &Mesh, of: Element) -> DVec3 {
    let mean = |vertices: &mut dyn Iterator<Item = VertexId>| {
        let (sum, count) = vertices
            .fold((DVec3::ZERO, 0.0), |(sum, count), v| (sum + mesh.position(v), count + 1.0));
        sum / f64::max(count, 1.0)
    };
    let edge = |h: HalfedgeId| mean(&mut [mesh.vertex(h), mesh.target(h)].into_iter());
    let face = |f| mean(&mut mesh.face_vertices(f));
    match of.kind {
        ElementKind::Vertex => mesh.position(VertexId(of.index)),
        ElementKind::Edge => edge(mesh.edge_halfedge(EdgeId(of.index))),
        ElementKind::Face => face(FaceId(of.index)),
        // Moved towards its face.
        ElementKind::Halfedge => {
            let h = HalfedgeId(of.index);
            edge(h).lerp(face(mesh.face(h)), 0.1)
        }
    }
}
