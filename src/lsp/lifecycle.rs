//! Hello: what the server can do.

use gen_lsp_types::*;
use serde_json::{Value, json};

use super::client::Client;
use super::server::{Server, Stage};
use super::tokens::{MODIFIERS, TYPES};

impl Server {
    /// The first request. What a client leaves out, or says with `null`, counts as nothing.
    pub(super) fn initialize(&mut self, mut params: Value) -> InitializeResult {
        if let Value::Object(fields) = &mut params {
            fields.retain(|_, value| !value.is_null());
            fields.entry("capabilities").or_insert_with(|| json!({}));
        }
        let params: InitializeParams = serde_json::from_value(params).unwrap_or_default();
        self.client = Client::new(&params);
        self.stage = Stage::Ready;
        InitializeResult {
            capabilities: self.capabilities(),
            server_info: Some(ServerInfo {
                name: "hedgerow".into(),
                version: Some(env!("CARGO_PKG_VERSION").into()),
            }),
        }
    }

    fn capabilities(&self) -> ServerCapabilities {
        ServerCapabilities {
            position_encoding: Some(self.client.encoding.kind()),
            text_document_sync: Some(
                TextDocumentSyncOptions {
                    open_close: Some(true),
                    change: Some(TextDocumentSyncKind::Incremental),
                    save: Some(SaveOptions::default().into()),
                    ..Default::default()
                }
                .into(),
            ),
            diagnostic_provider: Some(
                DiagnosticOptions {
                    identifier: Some("hedgerow".into()),
                    inter_file_dependencies: true,
                    workspace_diagnostics: false,
                    ..Default::default()
                }
                .into(),
            ),
            hover_provider: Some(true.into()),
            definition_provider: Some(true.into()),
            references_provider: Some(true.into()),
            document_highlight_provider: Some(true.into()),
            rename_provider: Some(
                RenameOptions {
                    prepare_provider: Some(true),
                    ..Default::default()
                }
                .into(),
            ),
            document_symbol_provider: Some(true.into()),
            workspace_symbol_provider: Some(true.into()),
            folding_range_provider: Some(true.into()),
            selection_range_provider: Some(true.into()),
            semantic_tokens_provider: Some(
                SemanticTokensOptions {
                    legend: SemanticTokensLegend {
                        token_types: TYPES.map(str::to_owned).to_vec(),
                        token_modifiers: MODIFIERS.map(str::to_owned).to_vec(),
                    },
                    range: Some(true.into()),
                    full: Some(true.into()),
                    ..Default::default()
                }
                .into(),
            ),
            inlay_hint_provider: Some(true.into()),
            document_link_provider: Some(DocumentLinkOptions::default()),
            ..Default::default()
        }
    }
}
