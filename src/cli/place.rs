//! Places on a mesh as they are written: `edge:3-7`, `halfedge:3-7`, `vertex:3`, `face:12`; in
//! tables, where every element has an id, also `edge:5` and `halfedge:5`. `edge 5` is the element of
//! this id of any mesh, as scripts print it.
//!
//! Several edges may join the same two vertices. They are told apart by a number in the order of
//! the file, `edge:3-7#2`; without one the first is taken, with a note that there are others.

use super::failure::Failure;
use super::output::eprint_line;
use crate::diagnostic::quoted;
use crate::diagram::{Param, Type};
use crate::mesh::{EdgeId, ElementKind, FaceId, HalfedgeId, MeshFile, VertexId};

/// An element by the numbers of its file: from 1 in OBJ files, ids in tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// The edge between two vertices.
    Edge(Ends),
    /// The halfedge from one vertex to another.
    Halfedge(Ends),
    /// An edge or a halfedge by its id.
    OfId(ElementKind, u32),
    /// A vertex.
    Vertex(u32),
    /// A face.
    Face(u32),
    /// An element by its id, as scripts print it.
    Printed(ElementKind, u32),
}

/// Two vertices and, if given, the number of the edge between them, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Ends {
    from: u32,
    to: u32,
    which: Option<u32>,
}

/// An element that was found.
#[derive(Debug)]
pub(super) struct Found {
    /// Its id.
    pub id: u32,
    /// The other things that the place could have meant, in words.
    pub note: Option<String>,
}

/// Reads a place.
pub(super) fn read(text: &str) -> Result<Place, String> {
    let wrong = || {
        format!(
            "`{text}` is not a place: write edge:A-B, halfedge:A-B, vertex:A or face:N with the numbers of the file, or 'edge N' as scripts print it"
        )
    };
    if let Some((kind, id)) = text.split_once(' ') {
        let id = id.parse().map_err(|_| wrong())?;
        return Ok(Place::Printed(ElementKind::named(kind).ok_or_else(wrong)?, id));
    }
    let (kind, numbers) = text.split_once(':').ok_or_else(wrong)?;
    let number = |text: &str| text.parse::<u32>().map_err(|_| wrong());
    let ends = |numbers: &str| {
        let (numbers, which) = match numbers.split_once('#') {
            Some((numbers, which)) => (numbers, Some(number(which)?)),
            None => (numbers, None),
        };
        let (from, to) = numbers.split_once('-').ok_or_else(wrong)?;
        Ok::<_, String>(Ends { from: number(from)?, to: number(to)?, which })
    };
    match kind {
        "edge" if numbers.contains('-') => ends(numbers).map(Place::Edge),
        "halfedge" if numbers.contains('-') => ends(numbers).map(Place::Halfedge),
        "edge" => Ok(Place::OfId(ElementKind::Edge, number(numbers)?)),
        "halfedge" => Ok(Place::OfId(ElementKind::Halfedge, number(numbers)?)),
        "vertex" => number(numbers).map(Place::Vertex),
        "face" => number(numbers).map(Place::Face),
        _ => Err(wrong()),
    }
}

/// For each parameter that is an element, its name and the place that `--at` gives it.
pub(super) fn given(
    params: &[Param],
    at: &[String],
    set: &[(String, String)],
) -> Result<Vec<(String, Place)>, Failure> {
    let elements = || params.iter().filter(|param| param.ty.is_element());
    if let Some(param) = elements().find(|param| set.iter().any(|(name, _)| *name == param.name)) {
        let name = &param.name;
        return Err(Failure::usage(format!("`{name}` is an element: give --at {name}=PLACE")));
    }
    let mut places = places(params, at)?.into_iter();
    let given = params.iter().filter_map(|param| {
        let place = places.next()?;
        param.ty.is_element().then(|| match place {
            Some(place) => Ok((param.name.clone(), place)),
            None => {
                let (name, example) = (&param.name, example(param.ty));
                let message =
                    format!("the parameter `{name}` is missing: give --at {name}={example}");
                Err(Failure::usage(message))
            }
        })
    });
    given.collect()
}

/// The ids of the elements at places, as texts; tells what else a place could have meant.
pub(super) fn ids(
    places: Vec<(String, Place)>,
    obj: &mut MeshFile,
) -> Result<Vec<(String, String)>, Failure> {
    let id = |(name, place): (String, Place)| {
        let Found { id, note } = place.find(obj).map_err(Failure::usage)?;
        if let Some(note) = note {
            eprint_line(&format!("note: {note}"));
        }
        Ok((name, id.to_string()))
    };
    places.into_iter().map(id).collect()
}

/// An example of how a place of this type is written.
fn example(ty: Type) -> &'static str {
    match ty {
        Type::Edge => "edge:A-B",
        Type::Halfedge => "halfedge:A-B",
        Type::Face => "face:N",
        _ => "vertex:A",
    }
}

/// For each parameter the place that `--at` gives it, by its name or else in order.
fn places(params: &[Param], texts: &[String]) -> Result<Vec<Option<Place>>, Failure> {
    let mut places: Vec<Option<Place>> = vec![None; params.len()];
    for text in texts {
        let (name, text) = match text.split_once('=') {
            Some((name, text)) => (Some(name), text),
            None => (None, text.as_str()),
        };
        let place = read(text).map_err(Failure::usage)?;
        let found = match name {
            Some(name) => {
                params.iter().position(|param| param.name == name && param.ty.is_element())
            }
            None => {
                let mut open = params.iter().zip(&places);
                open.position(|(param, place)| param.ty.is_element() && place.is_none())
            }
        };
        let at = found.ok_or_else(|| {
            let names = params.iter().filter(|param| param.ty.is_element());
            let known = match quoted(names.map(|param| &param.name)).as_str() {
                "" => "no parameter is an element".to_owned(),
                names => format!("the elements are {names}"),
            };
            Failure::usage(match name {
                Some(name) => format!("`{name}` is not a parameter that is an element; {known}"),
                None => format!("`{text}` is a place too many; {known}"),
            })
        })?;
        let wanted = params[at].ty;
        let place = place.as_wanted(wanted);
        if place.ty() != wanted {
            let (name, wanted, given) = (&params[at].name, wanted.word(), place.ty().word());
            return Err(Failure::usage(format!(
                "`{name}` is of type {wanted}, but the place is of type {given}: give --at {name}={}",
                example(params[at].ty)
            )));
        }
        if places[at].replace(place).is_some() {
            return Err(Failure::usage(format!("`{}` is given twice", params[at].name)));
        }
    }
    Ok(places)
}

impl Place {
    /// The type of the element.
    pub fn ty(self) -> Type {
        match self {
            Place::Edge(_) => Type::Edge,
            Place::Halfedge(_) => Type::Halfedge,
            Place::Vertex(_) => Type::Vertex,
            Place::Face(_) => Type::Face,
            Place::OfId(kind, _) | Place::Printed(kind, _) => kind.into(),
        }
    }

    /// `edge:A-B` where a halfedge is wanted is the one from A to B, and the other way around.
    pub fn as_wanted(self, wanted: Type) -> Self {
        match (self, wanted) {
            (Place::Edge(ends), Type::Halfedge) => Place::Halfedge(ends),
            (Place::Halfedge(ends), Type::Edge) => Place::Edge(ends),
            (place, _) => place,
        }
    }

    /// The element on a mesh.
    ///
    /// At an edge `A-B` this also makes the halfedge from `A` to `B` the edge's `halfedge`.
    pub fn find(self, obj: &mut MeshFile) -> Result<Found, String> {
        let alone = |id| Ok(Found { id, note: None });
        match self {
            Place::Vertex(number) => alone(vertex(obj, number)?.0),
            Place::Face(number) => match obj.face_by_number(number) {
                Some(FaceId(face)) => alone(face),
                None => Err(none_of(obj, "face", number)),
            },
            // Only tables number edges and halfedges.
            Place::OfId(kind, _) if !obj.goes_by_ids() => Err(format!(
                "the file does not number its {kind}s: write {kind}:A-B with the vertices at its ends, or \
                 '{kind} N' as scripts print it"
            )),
            Place::OfId(kind, id) | Place::Printed(kind, id) if obj.mesh.is_alive(kind, id) => {
                alone(id)
            }
            Place::OfId(kind, id) => Err(none_of(obj, kind.name(), id)),
            Place::Printed(kind, id) => Err(format!("the mesh has no {} {id}", kind.name())),
            Place::Halfedge(ends) => {
                let (HalfedgeId(id), note) = ends.halfedge(obj, "halfedge")?;
                Ok(Found { id, note })
            }
            Place::Edge(ends) => {
                let (half, note) = ends.halfedge(obj, "edge")?;
                let EdgeId(id) = obj.mesh.edge(half);
                obj.mesh.set_edge_halfedge(EdgeId(id), half);
                Ok(Found { id, note })
            }
        }
    }
}

impl Ends {
    /// The halfedge from one vertex to the other, and a note about others.
    fn halfedge(self, obj: &MeshFile, kind: &str) -> Result<(HalfedgeId, Option<String>), String> {
        let Ends { from, to, which } = self;
        let (start, end) = (vertex(obj, from)?, vertex(obj, to)?);
        let spokes = obj.mesh.spokes(start);
        let mut between: Vec<_> = spokes.filter(|&h| obj.mesh.target(h) == end).collect();
        between.sort_unstable();
        let place = |count: usize| format!("{kind}:{from}-{to}#{count}");
        let sides = |(at, &h): (usize, &HalfedgeId)| {
            let beside = [h, obj.mesh.twin(h)].map(|h| match obj.mesh.face(h) {
                f if obj.mesh.is_hole(f) => "a hole".to_owned(),
                FaceId(id) if obj.goes_by_ids() => format!("face {id}"),
                f => match obj.face_number(f) {
                    Some(number) => format!("face {number}"),
                    None => "a face".to_owned(),
                },
            });
            format!("{} between {}", place(at + 1), beside.join(" and "))
        };
        let all = || between.iter().enumerate().map(sides).collect::<Vec<_>>();
        match (between.as_slice(), which) {
            ([], _) => Err(format!("no edge joins the vertices {from} and {to}")),
            ([only], None) => Ok((*only, None)),
            ([first, ..], None) => {
                let count = between.len();
                let all = all().join(", ");
                let note = format!(
                    "{count} edges join the vertices {from} and {to}: {all}; the first is taken"
                );
                Ok((*first, Some(note)))
            }
            (several, Some(which)) => {
                let at = (which as usize).checked_sub(1);
                let found = at.and_then(|at| several.get(at));
                found.copied().map(|found| (found, None)).ok_or_else(|| {
                    let all = all().join(", ");
                    format!("there is no {}; there is {all}", place(which as usize))
                })
            }
        }
    }
}

fn vertex(obj: &MeshFile, number: u32) -> Result<VertexId, String> {
    obj.vertex_by_number(number).ok_or_else(|| none_of(obj, "vertex", number))
}

fn none_of(obj: &MeshFile, kind: &str, number: u32) -> String {
    let from_one = match number == 0 && !obj.goes_by_ids() {
        true => "; the first is 1, whatever the numbers that the file itself has",
        false => "",
    };
    format!("the mesh has no {kind} {number}{from_one}")
}
