//! From a name to where it is declared and mentioned, and renaming it.

use std::collections::HashMap;

use gen_lsp_types::*;

use super::document::Document;
use super::requests::{Answer, Refusal};
use super::server::Server;
use crate::analysis::names::{Mention, Role};
use crate::analysis::{definition, occurrences, rename, renameable};
use crate::diagnostic;

impl Server {
    /// `textDocument/definition`
    pub(super) fn definition(&mut self, params: DefinitionParams) -> Answer<DefinitionRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let found = definition(document.snapshot(), offset);
        Ok(found.map(|span| {
            let location = Location {
                uri: document.uri().clone(),
                range: document.range(span),
            };
            DefinitionResponse::Definition(location.into())
        }))
    }

    /// `textDocument/references`
    pub(super) fn references(&mut self, params: ReferenceParams) -> Answer<ReferencesRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let snapshot = document.snapshot();
        let declared = definition(snapshot, offset);
        let all = params.context.include_declaration;
        let found = occurrences(snapshot, offset);
        let found = found
            .iter()
            .filter(|mention| all || Some(mention.span) != declared);
        let locations = found.map(|mention| Location {
            uri: document.uri().clone(),
            range: document.range(mention.span),
        });
        Ok(Some(locations.collect()))
    }

    /// `textDocument/documentHighlight`
    pub(super) fn highlight(
        &mut self,
        params: DocumentHighlightParams,
    ) -> Answer<DocumentHighlightRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let found = occurrences(document.snapshot(), offset);
        let highlight = |mention: &Mention| DocumentHighlight {
            range: document.range(mention.span),
            kind: Some(match mention.role {
                Role::Declared | Role::Listed(_) | Role::Written => DocumentHighlightKind::Write,
                Role::Drawn(_) | Role::Returned | Role::Read => DocumentHighlightKind::Read,
            }),
        };
        Ok(Some(found.iter().map(highlight).collect()))
    }

    /// `textDocument/prepareRename`
    pub(super) fn prepare_rename(
        &mut self,
        params: PrepareRenameParams,
    ) -> Answer<PrepareRenameRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let snapshot = document.snapshot();
        let mention = renameable(snapshot, offset).map_err(Refusal::failed)?;
        let symbol = snapshot.names().symbol(mention.symbol);
        let found = PrepareRenamePlaceholder {
            range: document.range(mention.span),
            placeholder: symbol.name.clone(),
        };
        Ok(Some(found.into()))
    }

    /// `textDocument/rename`
    pub(super) fn rename(&mut self, params: RenameParams) -> Answer<RenameRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let edits = rename(document.snapshot(), offset, &params.new_name);
        let edits = edits.map_err(Refusal::failed)?;
        Ok(Some(self.workspace_edit(document, &edits)))
    }

    /// Changes of one document, for its version if the client heeds that.
    pub(super) fn workspace_edit(
        &self,
        document: &Document,
        edits: &[diagnostic::Edit],
    ) -> WorkspaceEdit {
        let edits = edits.iter().map(|edit| TextEdit {
            range: document.range(edit.span),
            new_text: edit.text.clone(),
        });
        if self.client.takes_versioned_edits() {
            let change = TextDocumentEdit {
                text_document: OptionalVersionedTextDocumentIdentifier {
                    version: Some(document.version()),
                    text_document_identifier: TextDocumentIdentifier {
                        uri: document.uri().clone(),
                    },
                },
                edits: edits.map(Edit::from).collect(),
            };
            WorkspaceEdit {
                document_changes: Some(vec![change.into()]),
                ..Default::default()
            }
        } else {
            WorkspaceEdit {
                changes: Some(HashMap::from([(document.uri().clone(), edits.collect())])),
                ..Default::default()
            }
        }
    }
}
