//! Parameters of operations, scripts and functions, as Python shows them.

use hedgerow::Argument;
use hedgerow::diagram::Type;
use hedgerow::mesh::ElementKind;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString, PyTuple, PyType};

use super::argument::{Values, argument};
use super::program::Reduced;

/// A parameter of an operation, a script or a function.
#[pyclass(frozen, module = "hedgerow")]
#[derive(Clone)]
pub struct Parameter {
    /// Its name.
    #[pyo3(get)]
    pub name: String,
    pub ty: Type,
    /// Its default, as the program writes it; `None` if it has to be given.
    #[pyo3(get)]
    default: Option<String>,
}

#[pymethods]
impl Parameter {
    #[new]
    fn new(name: String, r#type: &str, default: Option<String>) -> PyResult<Self> {
        let ty = Type::ALL.into_iter().find(|ty| ty.word() == r#type);
        let ty = ty.ok_or_else(|| PyValueError::new_err(format!("there is no type `{type}`")))?;
        Ok(Self { name, ty, default })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, (String, &str, Option<String>)> {
        let class = PyType::new::<Self>(py).into_any();
        Ok((class, (self.name.clone(), self.ty.word(), self.default.clone())))
    }

    #[classattr]
    fn __match_args__() -> (&'static str, &'static str, &'static str) {
        ("name", "type", "default")
    }

    /// Its type as the language writes it: `edge`, `real`, `vec3` …
    #[getter]
    fn r#type(&self) -> &'static str {
        self.ty.word()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            (&self.name, self.ty, &self.default) == (&other.name, other.ty, &other.default)
        })
    }

    fn __hash__(&self) -> usize {
        self.name.len() + 31 * self.ty as usize
    }

    fn __str__(&self) -> String {
        let default =
            self.default.as_ref().map_or(String::new(), |default| format!(" = {default}"));
        format!("{}: {}{default}", self.name, self.ty.word())
    }

    fn __repr__(&self) -> String {
        format!("<parameter {}>", self.__str__())
    }
}

/// The kind of the elements of a type.
pub fn element_kind(ty: Type) -> Option<ElementKind> {
    ElementKind::ALL.into_iter().find(|kind| kind.name() == ty.word())
}

/// The parameters of something that is called.
pub struct Parameters {
    pub all: Vec<Parameter>,
    /// Whether they are those of an operation, which has `each`.
    of_op: bool,
}

impl Parameters {
    pub fn new(parameters: Vec<hedgerow::Parameter<'_>>, of_op: bool) -> Self {
        let one = |parameter: hedgerow::Parameter<'_>| {
            let ty = Type::ALL.into_iter().find(|ty| ty.word() == parameter.ty);
            Parameter {
                name: parameter.name.to_owned(),
                ty: ty.expect("a type has a word"),
                default: parameter.default.map(str::to_owned),
            }
        };
        Self { all: parameters.into_iter().map(one).collect(), of_op }
    }

    /// A value for one of them.
    pub fn argument(&self, value: &Bound<'_, PyAny>, parameter: &Parameter) -> PyResult<Argument> {
        let is_row = || value.len().is_ok() && !value.is_instance_of::<PyString>();
        argument(value, parameter.ty, &parameter.name).map_err(|error| {
            match self.of_op && element_kind(parameter.ty).is_some() && is_row() {
                true => {
                    let told = error.value(value.py());
                    let advice = "`each` applies the operation at several, one after the other";
                    PyTypeError::new_err(format!("{told}; {advice}"))
                }
                false => error,
            }
        })
    }

    /// The first that is an element and not among some values: its number and its kind.
    pub fn first_free(&self, values: &Values) -> Option<(usize, ElementKind)> {
        let free = self.all.iter().enumerate().filter(|&(at, _)| !values.gives(self, at));
        free.filter_map(|(at, one)| Some((at, element_kind(one.ty)?))).next()
    }

    /// Whether one has this name.
    pub fn has(&self, name: &str) -> bool {
        self.all.iter().any(|one| one.name == name)
    }

    /// Takes an option of a name out of the named arguments, unless one of them has this name.
    pub fn option<'py>(
        &self,
        kwargs: Option<&Bound<'py, PyDict>>,
        name: &str,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(kwargs) = kwargs.filter(|_| !self.has(name)) else { return Ok(None) };
        let found = kwargs.get_item(name)?;
        if found.is_some() {
            kwargs.del_item(name)?;
        }
        Ok(found.filter(|found| !found.is_none()))
    }

    /// All of them.
    pub fn tuple<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.all.iter().cloned())
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
        make.call1((self.tuple(py)?, options, result))
    }
}
