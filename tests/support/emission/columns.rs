//! The attributes of the meshes: those that `attributes.hedge` declares.

use hedgerow::diagram::Type;
use hedgerow::mesh::{AttributeType, ColumnId, ElementKind, Mesh, Value};

use super::subjects::Subject;
use crate::meshes::Dice;
use ElementKind::{Edge, Face, Halfedge, Vertex};

/// All attributes, with the values of a new element.
const ALL: [(ElementKind, &str, Value); 9] = [
    (Vertex, "weight", Value::Real(0.0)),
    (Vertex, "tint", Value::Vec3(glam::DVec3::ZERO)),
    (Vertex, "quadric", Value::Mat4(glam::DMat4::ZERO)),
    (Halfedge, "mark", Value::Real(0.0)),
    (Halfedge, "uv", Value::Vec2(glam::DVec2::ZERO)),
    (Edge, "fresh", Value::Bool(false)),
    (Face, "class", Value::Int(0)),
    (Face, "plane", Value::Vec4(glam::DVec4::ZERO)),
    (Face, "frame", Value::Mat3(glam::DMat3::ZERO)),
];

/// Adds the attributes to a mesh, with the values of a new element.
pub fn add(mesh: &mut Mesh) {
    for (kind, name, default) in ALL {
        mesh.add_column(kind, name, default).unwrap();
    }
}

/// Adds the attributes to a mesh, with random values.
pub fn fill(mesh: &mut Mesh, dice: &mut Dice) {
    add(mesh);
    for kind in [Vertex, Halfedge, Edge, Face] {
        let length = numbers(mesh, kind, 0).len();
        for id in living(mesh, kind) {
            // Sums and halves of eighths are exact, also in single precision.
            let numbers: Vec<_> = (0..length).map(|_| dice.below(16) as f64 / 8.0).collect();
            set_numbers(mesh, kind, id, &mut numbers.into_iter());
        }
    }
}

/// The living elements, in order.
fn living(mesh: &Mesh, kind: ElementKind) -> Vec<u32> {
    let all = 0..mesh.capacity(kind) as u32;
    all.filter(|&id| mesh.is_alive(kind, id)).collect()
}

fn column(mesh: &Mesh, kind: ElementKind, name: &str) -> ColumnId {
    mesh.find_column(kind, name).expect("the mesh has it")
}

/// The values of the attributes of an element, as numbers.
pub fn numbers(mesh: &Mesh, kind: ElementKind, id: u32) -> Vec<f64> {
    let own = ALL.iter().filter(|(of, ..)| *of == kind);
    let values = own.map(|(_, name, _)| mesh.value(column(mesh, kind, name), id).unwrap());
    let numbers = values.flat_map(|value| match value {
        Value::Bool(value) => vec![f64::from(u8::from(value))],
        Value::Int(value) => vec![value as f64],
        value => value.reals().to_vec(),
    });
    numbers.collect()
}

/// Sets the attributes of an element from numbers.
pub fn set_numbers(
    mesh: &mut Mesh,
    kind: ElementKind,
    id: u32,
    numbers: &mut impl Iterator<Item = f64>,
) {
    for (_, name, default) in ALL.iter().filter(|(of, ..)| *of == kind) {
        let value = match default {
            Value::Bool(_) => Value::Bool(numbers.next().unwrap() >= 1.0),
            Value::Int(_) => Value::Int(numbers.next().unwrap() as i64),
            default => {
                let ty: AttributeType = default.attribute_type();
                let reals: Vec<_> = numbers.take(default.reals().len()).collect();
                Value::from_reals(ty, &reals).unwrap()
            }
        };
        let at = column(mesh, kind, name);
        assert!(mesh.set_value(at, id, value));
    }
}

/// The values of all attributes of a mesh. Created elements come last, so the order is the same for
/// any other mesh that was changed in the same way.
pub fn all_numbers(mesh: &Mesh) -> Vec<f64> {
    let kinds = [Vertex, Halfedge, Edge, Face].into_iter();
    let all = kinds.flat_map(|kind| {
        let ids = living(mesh, kind).into_iter();
        ids.flat_map(move |id| numbers(mesh, kind, id))
    });
    all.collect()
}

/// The columns of the attributes of an operation, by number.
pub fn of(subject: &Subject, mesh: &Mesh) -> Vec<Option<ColumnId>> {
    let found = subject.attributes.iter().map(|attribute| {
        let kind = match attribute.element {
            Type::Vertex => Vertex,
            Type::Halfedge => Halfedge,
            Type::Edge => Edge,
            _ => Face,
        };
        mesh.find_column(kind, &attribute.name)
    });
    found.collect()
}
