//! Parts that operations, scripts and functions have in common to Python.

/// The methods of one of them, with those that are its own. It has the fields `item`, `program` and
/// `parameters`.
macro_rules! item {
    (
        $type:ident, $word:literal, options $options:expr,
        result |$this:ident| $result:expr, { $($methods:tt)* }
    ) => {
        impl $type {
            pub fn new(item: hedgerow::$type, program: Py<Program>) -> Self {
                let parameters = Parameters::new(item.parameters(), $word == "op");
                Self { item, program, parameters }
            }
        }

        #[pymethods]
        impl $type {
            $($methods)*

            #[getter]
            fn __name__(&self) -> &str {
                self.item.name()
            }

            #[getter]
            fn __qualname__(&self) -> &str {
                self.item.name()
            }

            #[getter]
            fn __doc__(&self, py: Python<'_>) -> PyResult<String> {
                let signature = format!("{}{}", self.item.name(), self.__signature__(py)?.str()?);
                let docs = self.item.docs().join("\n");
                Ok(if docs.is_empty() { signature } else { format!("{signature}\n\n{docs}") })
            }

            /// The parameters, in order; the mesh is not among them.
            #[getter]
            fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
                self.parameters.tuple(py)
            }

            #[getter]
            fn __signature__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                let $this = self;
                self.parameters.signature(py, &$options, $result)
            }

            /// The program that it is of.
            #[getter]
            fn program(&self, py: Python<'_>) -> Py<Program> {
                self.program.clone_ref(py)
            }

            fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, (Py<Program>, String)> {
                let get = py.import("operator")?.getattr("getitem")?;
                Ok((get, (self.program.clone_ref(py), self.item.name().to_owned())))
            }

            fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
                other.cast::<Self>().is_ok_and(|other| {
                    let other = other.get();
                    let same = self.program.is(&other.program)
                        || self.item.program().texts() == other.item.program().texts();
                    same && self.item.name() == other.item.name()
                })
            }

            fn __hash__(&self) -> isize {
                let bytes = self.item.name().bytes();
                bytes.fold(7, |hash, byte| hash * 31 % 1_000_003 + isize::from(byte))
            }

            // Python's collector finds the cycle of a program and its items.
            fn __traverse__(
                &self,
                visit: pyo3::gc::PyVisit<'_>,
            ) -> Result<(), pyo3::gc::PyTraverseError> {
                visit.call(&self.program)
            }

            fn __repr__(&self) -> String {
                format!(concat!("<", $word, " {}>"), self.item.name())
            }
        }
    };
}

pub(crate) use item;
