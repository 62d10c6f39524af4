//! Initialization: the capabilities of the server.

use gen_lsp_types::*;
use serde_json::Value;

use super::client::Client;
use super::lenses::{RUN_SCRIPT, RUN_TEST, SHOW_DIAGRAM};
use super::server::{Server, Stage};
use super::tokens::{MODIFIERS, TYPES};
use super::workspace::Workspace;

impl Server {
    /// Answers `initialize`.
    pub(super) fn initialize(&mut self, hello: &Value) -> InitializeResult {
        self.workspace = Workspace::new(hello);
        self.client = Client::new(hello);
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
            // Requested diagnostics are always answered; but they are offered only to clients that
            // do not show published ones.
            diagnostic_provider: (!self.client.shows_published()).then(|| {
                DiagnosticOptions {
                    identifier: Some("hedgerow".into()),
                    inter_file_dependencies: true,
                    workspace_diagnostics: false,
                    ..Default::default()
                }
                .into()
            }),
            hover_provider: Some(true.into()),
            definition_provider: Some(true.into()),
            references_provider: Some(true.into()),
            document_highlight_provider: Some(true.into()),
            rename_provider: Some(
                RenameOptions { prepare_provider: Some(true), ..Default::default() }.into(),
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
            completion_provider: Some(CompletionOptions {
                trigger_characters: Some(
                    [".", ":", "-", "=", "|", ">", "*", "[", "\"", "/", " "]
                        .map(str::to_owned)
                        .to_vec(),
                ),
                ..Default::default()
            }),
            signature_help_provider: Some(SignatureHelpOptions {
                trigger_characters: Some(["(", ","].map(str::to_owned).to_vec()),
                ..Default::default()
            }),
            code_action_provider: Some(
                CodeActionOptions {
                    code_action_kinds: Some(vec![
                        CodeActionKind::QuickFix,
                        CodeActionKind::RefactorRewrite,
                    ]),
                    ..Default::default()
                }
                .into(),
            ),
            code_lens_provider: Some(CodeLensOptions::default()),
            execute_command_provider: Some(ExecuteCommandOptions {
                commands: [SHOW_DIAGRAM, RUN_TEST, RUN_SCRIPT].map(str::to_owned).to_vec(),
                ..Default::default()
            }),
            document_formatting_provider: Some(true.into()),
            document_range_formatting_provider: Some(true.into()),
            workspace: Some(WorkspaceOptions {
                workspace_folders: Some(WorkspaceFoldersServerCapabilities {
                    supported: Some(true),
                    change_notifications: Some(true.into()),
                }),
                file_operations: Some(FileOperationOptions {
                    will_rename: Some(renamed_files()),
                    ..Default::default()
                }),
                ..Default::default()
            }),
            document_link_provider: Some(DocumentLinkOptions::default()),
            ..Default::default()
        }
    }
}

/// The files and folders of whose renaming the server is told.
fn renamed_files() -> FileOperationRegistrationOptions {
    let filter = |glob: &str, kind| FileOperationFilter {
        scheme: None,
        pattern: FileOperationPattern { glob: glob.into(), matches: Some(kind), options: None },
    };
    let programs = filter("**/*.hedge", FileOperationPatternKind::File);
    let folders = filter("**", FileOperationPatternKind::Folder);
    FileOperationRegistrationOptions { filters: vec![programs, folders] }
}
