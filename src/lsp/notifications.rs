//! Notifications of the client.

use gen_lsp_types::*;
use lsp_server::Notification as Notice;
use serde::Deserialize;
use serde_json::Value;

use super::client::Settings;
use super::document::Document;
use super::files::name;
use super::server::{PendingRequest, Server};

/// The texts of files that a server without a disk cannot read.
#[derive(Deserialize)]
struct FilesParams {
    files: Vec<FileParams>,
}

/// A file; without a text, one that is no longer there.
#[derive(Deserialize)]
struct FileParams {
    uri: Uri,
    #[serde(default)]
    text: Option<String>,
}

impl Server {
    /// Handles a notification; an invalid or unknown one is ignored.
    pub(super) fn notice(&mut self, notice: Notice) {
        use LspNotificationMethod as Method;
        let params = notice.params;
        match Method::from(notice.method.as_str()) {
            Method::Initialized => self.initialized(),
            Method::TextDocumentDidOpen => read(params, |params| self.opened(params)),
            Method::TextDocumentDidChange => read(params, |params| self.changed(params)),
            Method::TextDocumentDidClose => read(params, |params| self.closed(params)),
            Method::WorkspaceDidChangeConfiguration => self.configuration_changed(&params),
            Method::WorkspaceDidChangeWatchedFiles => read(params, |params| self.watched(params)),
            Method::WorkspaceDidChangeWorkspaceFolders => {
                read(params, |params: DidChangeWorkspaceFoldersParams| {
                    self.workspace.change(params.event);
                });
            }
            Method::Custom("hedgerow/cursor") => read(params, |params| self.cursor(params)),
            Method::Custom("hedgerow/files") => read(params, |params| self.given(params)),
            _ => {}
        }
    }

    /// `hedgerow/files`
    fn given(&mut self, params: FilesParams) {
        for FileParams { uri, text } in params.files {
            self.files.give(&uri, text.as_deref());
            self.file_changed(&name(&uri));
        }
    }

    /// Handles changes of watched files on disk.
    fn watched(&mut self, params: DidChangeWatchedFilesParams) {
        for change in params.changes {
            self.file_changed(&name(&change.uri));
        }
    }

    /// Asks the client to report when a program changes on disk.
    fn watch_files(&mut self) {
        if !self.client.watches_files() {
            return;
        }
        let options = DidChangeWatchedFilesRegistrationOptions {
            watchers: vec![FileSystemWatcher {
                glob_pattern: GlobPattern::Pattern("**/*.hedge".into()),
                kind: None,
            }],
        };
        let registration = Registration {
            id: "hedgerow-watch".into(),
            method: "workspace/didChangeWatchedFiles".into(),
            register_options: serde_json::to_value(options).ok(),
        };
        let registrations = vec![registration];
        self.ask::<RegistrationRequest>(
            RegistrationParams { registrations },
            PendingRequest::Other,
        );
    }

    fn initialized(&mut self) {
        self.ask_for_settings();
        self.watch_files();
    }

    fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let item = params.text_document;
        let name = name(&item.uri);
        self.files.hold(&item.uri, &item.text);
        self.workspace.opened(&name);
        let document = Document::new(item, self.client.encoding, self.files.clone());
        self.documents.insert(document.uri().0.clone(), document);
        self.file_changed(&name);
    }

    fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let VersionedTextDocumentIdentifier {
            version,
            text_document_identifier: TextDocumentIdentifier { uri },
        } = params.text_document;
        if let Some(document) = self.documents.get_mut(&uri.0) {
            document.change(version, params.content_changes);
            self.file_changed(&name(&uri));
        }
    }

    fn closed(&mut self, params: DidCloseTextDocumentParams) {
        let uri = params.text_document.uri;
        if self.documents.remove(&uri.0).is_some() {
            let file = name(&uri);
            // The same file may be open under another URI.
            match self.documents.values().find(|other| name(other.uri()) == file) {
                Some(other) => self.files.hold(other.uri(), other.text()),
                None => self.files.release(&uri),
            }
            self.file_changed(&file);
            // Clears its diagnostics.
            self.tell::<PublishDiagnosticsNotification>(PublishDiagnosticsParams {
                uri,
                version: None,
                diagnostics: Vec::new(),
            });
        }
    }

    /// Updates the settings: clients that can be asked for them send none here, the others send
    /// all.
    fn configuration_changed(&mut self, params: &Value) {
        if self.client.has_configuration() {
            self.ask_for_settings();
        } else if let Some(settings) = params.get("settings").filter(|value| value.is_object()) {
            self.set(Settings::read(settings));
        }
    }

    fn ask_for_settings(&mut self) {
        if self.client.has_configuration() {
            let items =
                vec![ConfigurationItem { scope_uri: None, section: Some("hedgerow".into()) }];
            self.ask::<ConfigurationRequest>(
                ConfigurationParams { items },
                PendingRequest::Settings,
            );
        }
    }

    pub(super) fn settings_arrived(&mut self, answer: &Value) {
        let own = answer.get(0).unwrap_or(answer);
        if own.is_object() {
            self.set(Settings::read(own));
        }
    }

    fn set(&mut self, settings: Settings) {
        self.is_outdated |= self.client.settings != settings;
        self.client.settings = settings;
    }
}

fn read<P: serde::de::DeserializeOwned>(params: Value, take: impl FnOnce(P)) {
    if let Ok(params) = serde_json::from_value(params) {
        take(params);
    }
}
