//! The questions to a workbench.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value;

use crate::mesh::Element;

/// A question to a workbench.
#[derive(Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "kebab-case", deny_unknown_fields)]
pub(super) enum Ask {
    /// Sets the program, with files that it may use.
    Program {
        name: String,
        text: String,
        #[serde(default)]
        files: BTreeMap<String, String>,
    },
    /// Sets the mesh to one that has a name: `icosphere`.
    Shape { name: String },
    /// Sets the mesh to a file, whose bytes follow the JSON; or to one of the host.
    Mesh {
        name: String,
        #[serde(default)]
        repair: bool,
        #[serde(default)]
        of_host: bool,
    },
    /// The mesh as arrays; with the colours of the values of an attribute, `vertex.height`.
    View {
        #[serde(default)]
        attribute: Option<String>,
    },
    /// The elements at which an operation would be applied.
    Places {
        op: String,
        #[serde(default)]
        given: Given,
    },
    /// The elements that the names of an operation stand for at a place.
    Names {
        op: String,
        element: Element,
        #[serde(default)]
        given: Given,
    },
    /// Applies an operation at an element.
    Apply {
        op: String,
        element: Element,
        #[serde(default)]
        given: Given,
    },
    /// Runs a script.
    Run {
        script: String,
        #[serde(default)]
        given: Given,
    },
    /// The mesh after the first `to` applications of the script that was run last.
    Seek { to: u64 },
    /// Undoes a change.
    Undo,
    /// Redoes a change.
    Redo,
    /// The mesh as a file of this name.
    Save { name: String },
    /// Operations of the program in another form.
    Code { op: Option<String>, language: Language },
    /// The meshes that the operations of the program break.
    Counterexamples,
    /// All lessons.
    Lessons,
    /// Whether a text solves a lesson.
    Judge { lesson: String, text: String },
    /// The files of the library.
    Library,
}

/// The arguments of a call, by name.
pub(super) type Given = BTreeMap<String, Value>;

/// The forms in which operations are shown.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Language {
    Plan,
    Cpp,
    Rust,
}
