//! Errors of the library as exceptions.
//!
//! The classes are those of `hedgerow.errors`; each carries what was rendered, the stable code, and
//! the diagnostics as data.

use std::io::ErrorKind;
use std::path::Path;

use hedgerow::diagnostic::Diagnostic;
use hedgerow::mesh::FileReason;
use hedgerow::source::Sources;
use hedgerow::{Error, Report};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use super::watch::stopped_by;

/// The class of an exception.
#[derive(Clone, Copy)]
pub enum Kind {
    Program,
    Argument,
    Mesh,
    Run,
    File,
    MissingFile,
    Busy,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Program => "ProgramError",
            Self::Argument => "ArgumentError",
            Self::Mesh => "MeshError",
            Self::Run => "RunError",
            Self::File => "FileError",
            Self::MissingFile => "MissingFileError",
            Self::Busy => "BusyError",
        }
    }
}

/// The exception of something wrong in a program, which is that of a file or of a text.
pub fn in_program(py: Python<'_>, error: &Error, path: Option<&Path>) -> PyErr {
    let kind = match error.code() {
        "missing-file" if is_there(error, path) => Kind::File,
        "missing-file" => Kind::MissingFile,
        _ => Kind::Program,
    };
    told(py, kind, error)
}

/// Whether there is something where a file cannot be read: the file of the program itself, or one
/// that it uses.
fn is_there(error: &Error, path: Option<&Path>) -> bool {
    let Some(first) = error.diagnostics().first() else { return false };
    let (span, sources) = (first.span(), error.sources());
    match sources.ids().find(|&file| file == span.file) {
        Some(file) => {
            let used = sources.slice(span).trim_matches('"');
            Path::new(sources.get(file).name()).with_file_name(used).exists()
        }
        None => path.is_some_and(Path::exists),
    }
}

/// The exception of a call that was not carried out.
pub fn in_call(py: Python<'_>, error: &Error) -> PyErr {
    let kind = match error.code() {
        "wrong-argument" | "missing-argument" | "unknown-argument" | "repeated-argument"
        | "changing-function" => Kind::Argument,
        "below-level" | "attribute-conflict" => Kind::Mesh,
        "unknown-mark" => Kind::Argument,
        "interrupted" => {
            let interrupt = || PyKeyboardInterrupt::new_err(error.to_string());
            return stopped_by().unwrap_or_else(interrupt);
        }
        _ => Kind::Run,
    };
    told(py, kind, error)
}

/// The exception of a file that cannot be read or written.
pub fn of_file(py: Python<'_>, reason: &FileReason, message: String) -> PyErr {
    let kind = match reason {
        FileReason::NoFolder(_) => Kind::MissingFile,
        FileReason::Io(error) if error.kind() == ErrorKind::NotFound => Kind::MissingFile,
        _ => Kind::File,
    };
    saying(py, kind, "bad-file", message)
}

/// An exception that says one thing.
pub fn saying(py: Python<'_>, kind: Kind, code: &str, message: String) -> PyErr {
    make(py, kind, (message, code, PyList::empty(py).unbind(), py.None()))
        .unwrap_or_else(|error| error)
}

fn told(py: Python<'_>, kind: Kind, error: &Error) -> PyErr {
    let make = || {
        let diagnostics = diagnostics(py, error.diagnostics(), error.sources())?;
        let report = match error.report() {
            Some(report) => report_dict(py, report)?.into_any().unbind(),
            None => py.None(),
        };
        // What has no place in a program is told as it is, without the word `error` before it: what
        // is wrong with an argument is wrong where the call is.
        let has_place = |one| place(one, error.sources()).is_some();
        let placed = !matches!(kind, Kind::Argument) && error.diagnostics().iter().any(has_place);
        let text = match (placed, error.diagnostics()) {
            (false, [one]) => {
                let notes = one.notes.iter().map(|note| format!("\n  note: {note}"));
                std::iter::once(one.message.clone()).chain(notes).collect()
            }
            _ => error.to_string(),
        };
        make(py, kind, (text, error.code(), diagnostics.unbind(), report))
    };
    make().unwrap_or_else(|error| error)
}

fn make(
    py: Python<'_>,
    kind: Kind,
    (text, code, diagnostics, report): (String, &str, Py<PyList>, Py<PyAny>),
) -> PyResult<PyErr> {
    let class = py.import("hedgerow.errors")?.getattr(kind.name())?;
    Ok(PyErr::from_value(class.call1((text, code, diagnostics, report))?))
}

fn place(diagnostic: &Diagnostic, sources: &Sources) -> Option<(String, usize, usize)> {
    let span = diagnostic.span();
    let file = sources.ids().find(|&file| file == span.file)?;
    let source = sources.get(file);
    let (line, column) = source.line_column(span.start as usize);
    Some((source.name().to_owned(), line, column))
}

/// Diagnostics as dictionaries.
pub fn diagnostics<'py>(
    py: Python<'py>,
    diagnostics: &[Diagnostic],
    sources: &Sources,
) -> PyResult<Bound<'py, PyList>> {
    let list = PyList::empty(py);
    for diagnostic in diagnostics {
        let dict = PyDict::new(py);
        dict.set_item("code", diagnostic.code)?;
        dict.set_item("severity", if diagnostic.is_error() { "error" } else { "warning" })?;
        dict.set_item("message", &diagnostic.message)?;
        let (file, line, column) = match place(diagnostic, sources) {
            Some((file, line, column)) => (Some(file), Some(line), Some(column)),
            None => (None, None, None),
        };
        dict.set_item("file", file)?;
        dict.set_item("line", line)?;
        dict.set_item("column", column)?;
        dict.set_item("notes", &diagnostic.notes)?;
        let fixes: Vec<&str> = diagnostic.fixes.iter().map(|fix| fix.title.as_str()).collect();
        dict.set_item("fixes", fixes)?;
        list.append(dict)?;
    }
    Ok(list)
}

/// A report as a dictionary: by operation how many calls were applied, and the refused by reason.
pub fn report_dict<'py>(py: Python<'py>, report: &Report) -> PyResult<Bound<'py, PyAny>> {
    let ops = PyDict::new(py);
    for op in &report.ops {
        let refused = PyDict::new(py);
        for (reason, times) in &op.refused {
            refused.set_item(reason, times)?;
        }
        ops.set_item(&op.name, (op.applied, refused).into_bound_py_any(py)?)?;
    }
    py.import("hedgerow._report")?.getattr("Report")?.call1((ops,))
}
