//! Parameters of operations, scripts and functions, as Python shows them.

use hedgerow::Parameter;
use hedgerow::mesh::ElementKind;
use pyo3::prelude::*;
use pyo3::types::PyList;

/// The type of a parameter or a value.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Type {
    Bool,
    Int,
    Real,
    Vec2,
    Vec3,
    Vec4,
    Mat3,
    Mat4,
    Text,
    Element(ElementKind),
}

impl Type {
    /// The type of a word of the language.
    fn of(word: &str) -> Self {
        match word {
            "bool" => Self::Bool,
            "int" => Self::Int,
            "vec2" => Self::Vec2,
            "vec3" => Self::Vec3,
            "vec4" => Self::Vec4,
            "mat3" => Self::Mat3,
            "mat4" => Self::Mat4,
            "text" => Self::Text,
            "vertex" => Self::Element(ElementKind::Vertex),
            "halfedge" => Self::Element(ElementKind::Halfedge),
            "edge" => Self::Element(ElementKind::Edge),
            "face" => Self::Element(ElementKind::Face),
            _ => Self::Real,
        }
    }
}

/// A parameter.
pub struct One {
    pub name: String,
    pub ty: Type,
    word: &'static str,
    default: Option<String>,
}

/// The parameters of something that is called.
pub struct Parameters {
    pub all: Vec<One>,
}

impl Parameters {
    pub fn new(parameters: Vec<Parameter<'_>>) -> Self {
        let one = |parameter: Parameter<'_>| One {
            name: parameter.name.to_owned(),
            ty: Type::of(parameter.ty),
            word: parameter.ty,
            default: parameter.default.map(str::to_owned),
        };
        Self { all: parameters.into_iter().map(one).collect() }
    }

    /// The first that is an element and not among some values: its number and its kind.
    pub fn first_free(&self, values: &super::argument::Values) -> Option<(usize, ElementKind)> {
        self.all.iter().enumerate().find_map(|(at, one)| match one.ty {
            Type::Element(kind) if !values.gives(self, at) => Some((at, kind)),
            _ => None,
        })
    }

    /// Whether one has this name.
    pub fn has(&self, name: &str) -> bool {
        self.all.iter().any(|one| one.name == name)
    }

    /// Names, types and defaults.
    pub fn list<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let all = self.all.iter().map(|one| (&one.name, one.word, &one.default));
        PyList::new(py, all)
    }

    /// The signature as `inspect` has it: the mesh, then these, then some options.
    pub fn signature<'py>(
        &self,
        py: Python<'py>,
        options: &[&str],
        result: Option<&str>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options: Vec<&str> = options.iter().copied().filter(|name| !self.has(name)).collect();
        let make = py.import("hedgerow._signature")?.getattr("signature")?;
        make.call1((self.list(py)?, options, result))
    }
}
