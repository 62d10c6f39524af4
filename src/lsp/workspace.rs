//! The programs of the workspace that are not open: their mentions of a name count, too, when it is
//! looked up everywhere.
//!
//! They are read when such a request comes, from the folders of the workspace and along the `use`
//! of the open documents; one that has not changed since is not analyzed again.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use gen_lsp_types::{TextDocumentItem, Uri, WorkspaceFoldersChangeEvent};
use serde_json::Value;

use super::document::Document;
use super::files::{Files, name};
use super::position::Encoding;
use super::server::Documents;
use super::uri;
use crate::analysis::Reader;
use crate::library;

/// The folders of a workspace, and the programs in them that are not open.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    folders: Vec<Uri>,
    closed: BTreeMap<String, Document>,
}

impl Workspace {
    /// The workspace in the parameters of `initialize`: its folders, or else its root.
    pub(super) fn new(hello: &Value) -> Self {
        let folders = hello.get("workspaceFolders").and_then(Value::as_array).into_iter().flatten();
        let mut named: Vec<_> = folders.filter_map(|folder| folder.get("uri")).collect();
        if named.is_empty() {
            named.extend(hello.get("rootUri"));
        }
        let uris = named.into_iter().filter_map(Value::as_str);
        Self { folders: uris.map(|uri| Uri(uri.to_owned())).collect(), closed: BTreeMap::new() }
    }

    /// Removes and adds folders.
    pub(super) fn change(&mut self, change: WorkspaceFoldersChangeEvent) {
        let gone: Vec<_> = change.removed.into_iter().map(|gone| gone.uri.0).collect();
        self.folders.retain(|folder| !gone.contains(&folder.0));
        self.folders.extend(change.added.into_iter().map(|new| new.uri));
    }

    /// Reads the current texts of programs that are not open.
    pub(super) fn read(&mut self, open: &Documents, files: &Files, encoding: Encoding) {
        let mut wanted = BTreeSet::new();
        for folder in &self.folders {
            if uri::path(folder).is_some() {
                wanted.extend(files.clone().under(&name(folder)));
            }
        }
        for document in open.values() {
            let used = document.snapshot().used_names();
            wanted.extend(used.filter(|name| !name.starts_with(library::FOLDER)));
        }
        wanted.retain(|name| !files.is_open(name) && Path::new(name).is_absolute());
        self.closed.retain(|name, _| wanted.contains(name));
        let mut changed = Vec::new();
        for name in wanted {
            let Ok(text) = files.clone().read(&name) else {
                self.closed.remove(&name);
                continue;
            };
            let is_known = |known: &Document| known.text() == text;
            if self.closed.get(&name).is_some_and(is_known) {
                continue;
            }
            let item = TextDocumentItem {
                uri: uri::of_path(Path::new(&name)),
                language_id: "hedgerow".into(),
                version: 0,
                text,
            };
            let document = Document::new(item, encoding, files.clone());
            self.closed.insert(name.clone(), document);
            changed.push(name);
        }
        changed.iter().for_each(|name| self.file_changed(name));
    }

    /// Forgets a program, as it is open now.
    pub(super) fn opened(&mut self, name: &str) {
        self.closed.remove(name);
    }

    /// Discards the snapshots of those that use a file of this name.
    pub(super) fn file_changed(&mut self, name: &str) {
        for document in self.closed.values_mut() {
            document.file_changed(name);
        }
    }

    /// The programs that are not open, as they were read last.
    pub(super) fn closed(&self) -> impl Iterator<Item = &Document> {
        self.closed.values()
    }
}
