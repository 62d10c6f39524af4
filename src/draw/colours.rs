//! The colours that stand for the values of an attribute.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};

use super::shape::Group;
use super::viridis::{Range, SWATCH, number, swatches};
use crate::mesh::{ColumnId, ElementKind, FaceId, Mesh, Value};

/// The width of a legend.
pub(super) const LEGEND: f64 = 110.0;
/// The colour of faces, and of values that are not finite, where an attribute is shown.
pub(super) const PALE: [u8; 3] = [226, 230, 236];
/// The colour of a truth value that holds.
const HOLDS: [u8; 3] = [0x00, 0x65, 0xb3];
/// The colours of a few labels, which colour-blind viewers tell apart (M. Okabe and K. Ito, "Color
/// Universal Design", 2008), with grey for their black.
const LABELS: [[u8; 3]; 8] = [
    [0x56, 0xb4, 0xe9],
    [0xe6, 0x9f, 0x00],
    [0x00, 0x9e, 0x73],
    [0xf0, 0xe4, 0x42],
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0xcc, 0x79, 0xa7],
    [0x99, 0x99, 0x99],
];
/// The colour of lines.
pub(super) const LINE: [u8; 3] = [22, 30, 40];

/// An attribute, and the colours of its values.
pub(crate) struct Colours {
    column: ColumnId,
    pub(super) kind: ElementKind,
    title: String,
    scale: Scale,
}

/// The way values are shown as colours.
enum Scale {
    /// They are colours themselves.
    Own,
    /// Numbers of a range.
    Numbers(Range),
    /// A few whole numbers, in order.
    Labels(Vec<i64>),
    /// Truth values.
    Truth,
}

/// The meaning of colours.
pub(crate) enum Key {
    /// Numbers from the least to a greater one.
    Range(Range),
    /// Each of a few values with its colour.
    Swatches(Vec<(String, [u8; 3])>),
}

impl Colours {
    /// The colours of an attribute that has a finite value.
    pub(crate) fn new(mesh: &Mesh, column: ColumnId) -> Option<Self> {
        let kind = column.kind;
        let values = || {
            let slots = 0..mesh.capacity(kind) as u32;
            slots.filter_map(|slot| mesh.value(column, slot))
        };
        let title = mesh.column(column)?.name().to_string();
        let is_named_so = ["color", "colour"].contains(&title.as_str());
        let is_truth = |value| matches!(value, Value::Bool(_));
        let scale = match values().next()? {
            _ if is_named_so && values().all(|value| rgb(value).is_some()) => Scale::Own,
            first if is_truth(first) => Scale::Truth,
            _ if let Some(labels) = labels(mesh, column) => Scale::Labels(labels),
            _ => Scale::Numbers(Range::of(values().map(Value::magnitude))?),
        };
        Some(Self { column, kind, title, scale })
    }

    /// True if the values are colours themselves.
    pub(super) fn are_own(&self) -> bool {
        matches!(self.scale, Scale::Own)
    }

    /// True if an element with a value looks as if there were no colours: an edge or halfedge for
    /// which a truth value does not hold.
    pub(super) fn leaves(&self, value: DVec3) -> bool {
        self.is_line() && matches!(self.scale, Scale::Truth) && value.x != 1.0
    }

    fn is_line(&self) -> bool {
        matches!(self.kind, ElementKind::Edge | ElementKind::Halfedge)
    }

    /// The height of a picture that has room for the legend; zero without one.
    pub(super) fn height(&self) -> f64 {
        match self.key() {
            None => 0.0,
            Some(Key::Range(_)) => 3.0 * LEGEND,
            Some(Key::Swatches(values)) => 2.0 * LEGEND + values.len() as f64 * SWATCH,
        }
    }

    /// The meaning of the colours, unless the values are colours themselves.
    pub(crate) fn key(&self) -> Option<Key> {
        match &self.scale {
            Scale::Own => None,
            Scale::Numbers(range) => Some(match range.ends() {
                [only, last] if only == last => {
                    Key::Swatches(vec![(number(only), range.colour(only))])
                }
                _ => Key::Range(*range),
            }),
            Scale::Labels(labels) => Some(Key::Swatches(
                labels.iter().map(|label| number(*label as f64)).zip(LABELS).collect(),
            )),
            Scale::Truth => {
                let missing = if self.is_line() { LINE } else { PALE };
                let values = [("true", HOLDS), ("false", missing)];
                Some(Key::Swatches(values.map(|(word, colour)| (word.to_owned(), colour)).into()))
            }
        }
    }

    /// The legend around a place.
    pub(super) fn legend(&self, center: DVec2) -> Option<Group> {
        self.key().map(|key| match key {
            Key::Range(range) => range.legend(&self.title, center),
            Key::Swatches(values) => swatches(&self.title, &values, center),
        })
    }

    /// The colour of an element.
    #[cfg(feature = "play")]
    pub(crate) fn of_element(&self, mesh: &Mesh, index: u32) -> [u8; 3] {
        let value = self.value(mesh, index);
        if self.leaves(value) { LINE } else { self.colour(value) }
    }

    /// The value of an element: its colour, or three times the number; NaN if it has none.
    pub(super) fn value(&self, mesh: &Mesh, index: u32) -> DVec3 {
        let value = mesh.value(self.column, index);
        let seen = value.and_then(|value| match self.scale {
            Scale::Own => rgb(value),
            _ => Some(DVec3::splat(value.magnitude())),
        });
        seen.unwrap_or(DVec3::NAN)
    }

    pub(super) fn colour(&self, value: DVec3) -> [u8; 3] {
        match &self.scale {
            _ if !value.is_finite() => PALE,
            Scale::Own => value.to_array().map(|part| (part * 255.0).round() as u8),
            Scale::Numbers(range) => range.colour(value.x),
            Scale::Labels(labels) => {
                let at = labels.iter().position(|label| *label as f64 == value.x);
                at.map_or(PALE, |at| LABELS[at])
            }
            Scale::Truth => {
                let part = |at: usize| {
                    f64::from(PALE[at]) + (f64::from(HOLDS[at]) - f64::from(PALE[at])) * value.x
                };
                [0, 1, 2].map(|at| part(at).round() as u8)
            }
        }
    }
}

/// The values of an attribute, if they are whole numbers and few. Numbers at vertices are not
/// labels: faces show what lies between them.
fn labels(mesh: &Mesh, column: ColumnId) -> Option<Vec<i64>> {
    let mut labels = BTreeSet::new();
    let is_hole = |id: &u32| column.kind == ElementKind::Face && mesh.is_hole(FaceId(*id));
    for id in mesh.elements(column.kind).filter(|id| !is_hole(id)) {
        match mesh.value(column, id)? {
            Value::Int(label) => labels.insert(label),
            _ => return None,
        };
        if column.kind == ElementKind::Vertex || labels.len() > LABELS.len() {
            return None;
        }
    }
    (labels.len() > 1).then(|| labels.into_iter().collect())
}

/// Red, green and blue of a vector with components from 0 to 1; a fourth is ignored.
fn rgb(value: Value) -> Option<DVec3> {
    let colour = match value {
        Value::Vec3(colour) => colour,
        Value::Vec4(colour) => colour.truncate(),
        _ => return None,
    };
    (colour.cmpge(DVec3::ZERO) & colour.cmple(DVec3::ONE)).all().then_some(colour)
}
