//! What the client lets the server know.

use gen_lsp_types::*;
use lsp_server::Notification as Notice;
use serde_json::Value;

use super::client::Settings;
use super::document::Document;
use super::server::{Asked, Server};

impl Server {
    /// Takes in a notification; one that cannot be read, or that nobody knows, is let be.
    pub(super) fn notice(&mut self, notice: Notice) {
        use LspNotificationMethod as Method;
        let params = notice.params;
        match Method::from(notice.method.as_str()) {
            Method::Initialized => self.initialized(),
            Method::TextDocumentDidOpen => read(params, |params| self.opened(params)),
            Method::TextDocumentDidChange => read(params, |params| self.changed(params)),
            Method::TextDocumentDidClose => read(params, |params| self.closed(params)),
            Method::WorkspaceDidChangeConfiguration => self.configuration_changed(&params),
            _ => {}
        }
    }

    fn initialized(&mut self) {
        self.ask_for_settings();
    }

    fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let item = params.text_document;
        let encoding = self.client.encoding;
        self.documents
            .open(Document::new(item.uri, item.version, item.text, encoding));
    }

    fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let VersionedTextDocumentIdentifier {
            version,
            text_document_identifier: TextDocumentIdentifier { uri },
        } = params.text_document;
        if let Some(document) = self.documents.get_mut(&uri) {
            document.change(version, params.content_changes);
        }
    }

    fn closed(&mut self, params: DidCloseTextDocumentParams) {
        let uri = params.text_document.uri;
        if self.documents.close(&uri).is_some() {
            // What was wrong with it is no longer shown.
            self.tell::<PublishDiagnosticsNotification>(PublishDiagnosticsParams {
                uri,
                version: None,
                diagnostics: Vec::new(),
            });
        }
    }

    /// Clients that can be asked send no settings, the others send all.
    fn configuration_changed(&mut self, params: &Value) {
        if self.client.has_configuration() {
            self.ask_for_settings();
        } else if let Some(settings) = params.get("settings").filter(|value| value.is_object()) {
            self.client.settings = Settings::read(settings);
        }
    }

    fn ask_for_settings(&mut self) {
        if self.client.has_configuration() {
            let items = vec![ConfigurationItem {
                scope_uri: None,
                section: Some("hedgerow".into()),
            }];
            self.ask::<ConfigurationRequest>(ConfigurationParams { items }, Asked::Settings);
        }
    }

    pub(super) fn settings_arrived(&mut self, answer: &Value) {
        let own = answer.get(0).unwrap_or(answer);
        if own.is_object() {
            self.client.settings = Settings::read(own);
        }
    }
}

fn read<P: serde::de::DeserializeOwned>(params: Value, take: impl FnOnce(P)) {
    if let Ok(params) = serde_json::from_value(params) {
        take(params);
    }
}
