//! Kinds of elements, and lists of elements by kind.

use hedgerow::mesh::{Element, ElementKind};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyType;

use super::program::Reduced;

/// The kind of a name: `vertex`, `halfedge`, `edge`, `face`, or their plurals.
pub fn kind(name: &str) -> PyResult<ElementKind> {
    let mut all = ElementKind::ALL.into_iter();
    all.find(|kind| kind.name() == name || kind.plural() == name).ok_or_else(|| {
        PyValueError::new_err(format!(
            "there is no kind of elements `{name}`: it is vertex, halfedge, edge or face"
        ))
    })
}

/// A kind with its article: `an edge`.
pub fn one(kind: ElementKind) -> String {
    let article = if kind == ElementKind::Edge { "an" } else { "a" };
    format!("{article} {kind}")
}

/// The numbers of vertices, halfedges, edges and faces.
type ByKind = (Vec<u32>, Vec<u32>, Vec<u32>, Vec<u32>);

/// The numbers of some elements, by kind.
#[pyclass(frozen, module = "hedgerow")]
pub struct Elements {
    all: Vec<Element>,
}

impl Elements {
    pub fn new(all: &[Element]) -> Self {
        Self { all: all.to_vec() }
    }

    pub fn all(&self) -> &[Element] {
        &self.all
    }

    /// Whether both have the same elements of each kind, in the same order.
    pub fn is_same(&self, other: &Self) -> bool {
        ElementKind::ALL.into_iter().all(|kind| self.of(kind) == other.of(kind))
    }

    fn of(&self, kind: ElementKind) -> Vec<u32> {
        let of_kind = self.all.iter().filter(|element| element.kind == kind);
        of_kind.map(|element| element.index).collect()
    }
}

#[pymethods]
impl Elements {
    #[new]
    #[pyo3(signature = (vertices=vec![], halfedges=vec![], edges=vec![], faces=vec![]))]
    fn made_of(vertices: Vec<u32>, halfedges: Vec<u32>, edges: Vec<u32>, faces: Vec<u32>) -> Self {
        let kinds = [
            (ElementKind::Vertex, vertices),
            (ElementKind::Halfedge, halfedges),
            (ElementKind::Edge, edges),
            (ElementKind::Face, faces),
        ];
        let elements = |(kind, all): (ElementKind, Vec<u32>)| {
            all.into_iter().map(move |index| Element { kind, index })
        };
        Self { all: kinds.into_iter().flat_map(elements).collect() }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, ByKind> {
        let all = (self.vertices(), self.halfedges(), self.edges(), self.faces());
        Ok((PyType::new::<Self>(py).into_any(), all))
    }

    #[getter]
    fn vertices(&self) -> Vec<u32> {
        self.of(ElementKind::Vertex)
    }

    #[getter]
    fn halfedges(&self) -> Vec<u32> {
        self.of(ElementKind::Halfedge)
    }

    #[getter]
    fn edges(&self) -> Vec<u32> {
        self.of(ElementKind::Edge)
    }

    #[getter]
    fn faces(&self) -> Vec<u32> {
        self.of(ElementKind::Face)
    }

    fn __len__(&self) -> usize {
        self.all.len()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let other = other.cast::<Self>().map(Bound::get);
        other.is_ok_and(|other| self.is_same(other))
    }

    /// Of elements of different kinds in another order it is the same.
    pub fn __hash__(&self) -> usize {
        let of_one = |one: &Element| 4 * one.index as usize + one.kind as usize + 1;
        self.all.iter().map(of_one).fold(0, usize::wrapping_add)
    }

    pub fn __repr__(&self) -> String {
        let kinds = ElementKind::ALL.map(|kind| (kind.plural(), self.of(kind)));
        let some = kinds.into_iter().filter(|(_, ids)| !ids.is_empty());
        let parts: Vec<_> = some.map(|(name, ids)| format!("{name}={ids:?}")).collect();
        format!("Elements({})", parts.join(", "))
    }
}
