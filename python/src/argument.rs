//! Values of Python as arguments, by the types of the parameters.

use hedgerow::diagram::Type;
use hedgerow::mesh::{Element, ElementKind};
use hedgerow::{Argument, Arguments, Given};
use pyo3::exceptions::{PyOverflowError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyString, PyTuple};

use super::element::one;
use super::error::{Kind, saying};
use super::parameters::{Parameters, element_kind};

/// Arguments of a call, in order and by name, as the library takes them.
#[derive(Default)]
pub struct Values {
    in_order: Vec<Argument>,
    named: Vec<(String, Argument)>,
}

impl Arguments for &Values {
    fn give(self, to: &mut Given<'_>) {
        for value in &self.in_order {
            to.next(value.clone());
        }
        for (name, value) in &self.named {
            to.named(name, value.clone());
        }
    }
}

impl Values {
    /// Converts arguments; what there is no parameter for the library complains of.
    pub fn new(
        parameters: &Parameters,
        in_order: &Bound<'_, PyTuple>,
        named: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let mut values = Self::default();
        for (at, value) in in_order.iter().enumerate() {
            let value = match parameters.all.get(at) {
                Some(parameter) => parameters.argument(&value, parameter)?,
                None => Argument::Bool(false),
            };
            values.in_order.push(value);
        }
        for (name, value) in named.into_iter().flatten() {
            let name: String = name.extract()?;
            let value = match parameters.all.iter().find(|parameter| parameter.name == name) {
                Some(parameter) => parameters.argument(&value, parameter)?,
                None => Argument::Bool(false),
            };
            values.named.push((name, value));
        }
        Ok(values)
    }

    /// Whether nothing is given.
    pub fn is_empty(&self) -> bool {
        self.in_order.is_empty() && self.named.is_empty()
    }

    /// Whether the parameter of a number is given.
    pub fn gives(&self, parameters: &Parameters, at: usize) -> bool {
        let name = &parameters.all[at].name;
        at < self.in_order.len() || self.named.iter().any(|(named, _)| named == name)
    }

    /// Gives the parameter of a name another value, or one.
    pub fn put(&mut self, parameters: &Parameters, at: usize, value: Argument) {
        if let Some(place) = self.in_order.get_mut(at) {
            *place = value;
            return;
        }
        let name = &parameters.all[at].name;
        match self.named.iter_mut().find(|(named, _)| named == name) {
            Some((_, place)) => *place = value,
            None => self.named.push((name.clone(), value)),
        }
    }
}

/// A value of a type, or an exception that names the parameter.
pub fn argument(value: &Bound<'_, PyAny>, ty: Type, name: &str) -> PyResult<Argument> {
    let wrong = |wants: &str| {
        let got = value.get_type().name().map_or_else(|_| "?".to_owned(), |name| name.to_string());
        PyTypeError::new_err(format!("`{name}` wants {wants}, not {got}"))
    };
    let refused = |error: PyErr, wants: &str| {
        let py = value.py();
        match error.is_instance_of::<PyOverflowError>(py) {
            true => saying(py, Kind::Argument, "wrong-argument", format!("`{name}` is too large")),
            false => wrong(wants),
        }
    };
    let is_bool = || value.is_instance_of::<PyBool>();
    match ty {
        Type::Bool => match truth(value) {
            Some(value) => Ok(Argument::Bool(value)),
            None => Err(wrong("a bool")),
        },
        Type::Int => {
            if is_bool() || value.is_instance_of::<PyFloat>() {
                return Err(wrong("a whole number"));
            }
            let whole = value.extract::<i64>();
            whole.map(Argument::Int).map_err(|error| refused(error, "a whole number"))
        }
        Type::Real => {
            if is_bool() || value.is_instance_of::<PyString>() {
                return Err(wrong("a number"));
            }
            let real = value.extract::<f64>();
            real.map(Argument::Real).map_err(|error| refused(error, "a number"))
        }
        Type::Vec2 => {
            vector::<2>(value).map_err(|error| refused(error, "2 numbers")).map(Into::into)
        }
        Type::Vec3 => {
            vector::<3>(value).map_err(|error| refused(error, "3 numbers")).map(Into::into)
        }
        Type::Vec4 => {
            vector::<4>(value).map_err(|error| refused(error, "4 numbers")).map(Into::into)
        }
        Type::Mat3 => {
            let rows = matrix::<3>(value).map_err(|error| refused(error, "3 rows of 3 numbers"))?;
            Ok(hedgerow::mesh::glam::DMat3::from_cols_array_2d(&rows).transpose().into())
        }
        Type::Mat4 => {
            let rows = matrix::<4>(value).map_err(|error| refused(error, "4 rows of 4 numbers"))?;
            Ok(hedgerow::mesh::glam::DMat4::from_cols_array_2d(&rows).transpose().into())
        }
        Type::Text => match value.cast::<PyString>() {
            Ok(text) => Ok(Argument::Text(text.to_str()?.to_owned())),
            Err(_) => Err(wrong("a text")),
        },
        Type::Vertex | Type::Halfedge | Type::Edge | Type::Face => {
            let kind = element_kind(ty).expect("it is a type of elements");
            element(value, kind, name)
        }
    }
}

/// The number of an element.
pub fn element(value: &Bound<'_, PyAny>, kind: ElementKind, name: &str) -> PyResult<Argument> {
    let is_other = value.is_instance_of::<PyBool>() || value.is_instance_of::<PyFloat>();
    let number = match value.extract::<u32>() {
        Ok(number) if !is_other => Some(number),
        Err(error) if !is_other && error.is_instance_of::<PyOverflowError>(value.py()) => None,
        _ => {
            let message = format!("`{name}` wants the number of {}", one(kind));
            return Err(PyTypeError::new_err(message));
        }
    };
    match number {
        Some(index) => Ok(Element { kind, index }.into()),
        None => Err(saying(
            value.py(),
            Kind::Argument,
            "wrong-argument",
            format!("`{name}` is no {kind} of the mesh: {value}"),
        )),
    }
}

/// `True`, `False`, or what numpy has for them.
fn truth(value: &Bound<'_, PyAny>) -> Option<bool> {
    if let Ok(value) = value.cast::<PyBool>() {
        return Some(value.is_true());
    }
    let name = value.get_type().name().ok()?;
    let name = name.to_str().ok()?;
    (name == "bool_" || name == "bool").then(|| value.is_truthy().ok()).flatten()
}

fn vector<const LENGTH: usize>(value: &Bound<'_, PyAny>) -> PyResult<[f64; LENGTH]> {
    if value.is_instance_of::<PyString>() {
        return Err(none());
    }
    let numbers: Vec<f64> = value.try_iter()?.map(|one| one?.extract()).collect::<PyResult<_>>()?;
    numbers.try_into().map_err(|_| none())
}

fn matrix<const SIZE: usize>(value: &Bound<'_, PyAny>) -> PyResult<[[f64; SIZE]; SIZE]> {
    let rows: Vec<_> =
        value.try_iter()?.map(|row| vector::<SIZE>(&row?)).collect::<PyResult<_>>()?;
    rows.try_into().map_err(|_| none())
}

/// The exception of what is not of the type; it is told by what calls.
fn none() -> PyErr {
    PyTypeError::new_err(())
}
