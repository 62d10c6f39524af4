//! Definitions, references, highlights, and renaming of names and files.

use std::collections::HashMap;

use gen_lsp_types::*;

use super::document::Document;
use super::files::name;
use super::requests::{Answer, Refusal};
use super::server::Server;
use crate::analysis::names::{Mention, Role};
use crate::analysis::{
    definition, edits_for_moves, mentions_of_shared, occurrences, rename, rename_shared,
    renameable, shared, stays_the_same, used_path,
};
use crate::diagnostic::{self, applied};

impl Server {
    /// `textDocument/definition`
    pub(super) fn definition(&mut self, params: DefinitionParams) -> Answer<DefinitionRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let snapshot = document.snapshot();
        let found = match used_path(snapshot, offset) {
            Some(path) => document.used_file(path),
            None => definition(snapshot, offset).and_then(|span| document.location(span)),
        };
        Ok(found.map(|found| DefinitionResponse::Definition(found.into())))
    }

    /// `textDocument/references`
    pub(super) fn references(&mut self, params: ReferenceParams) -> Answer<ReferencesRequest> {
        self.read_others(&params.text_document_position_params)?;
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let declared = definition(document.snapshot(), offset);
        let declared = declared.and_then(|span| document.location(span));
        let all = params.context.include_declaration;
        let mut found = Vec::new();
        for (document, mentions) in self.mentions(document, offset) {
            found.extend(mentions.iter().filter_map(|mention| document.location(mention.span)));
        }
        found.retain(|place| all || Some(place) != declared.as_ref());
        Ok(Some(found))
    }

    /// Reads the programs that are not open, if they may mention the name at a place.
    fn read_others(&mut self, at: &TextDocumentPositionParams) -> Result<(), Refusal> {
        let (document, offset) = self.place(at)?;
        if shared(document.snapshot(), offset).is_some() {
            self.read_workspace();
        }
        Ok(())
    }

    /// All mentions of a name: in its document, and of an item also in the other programs of
    /// the workspace.
    fn mentions<'s>(
        &'s self,
        document: &'s Document,
        offset: usize,
    ) -> Vec<(&'s Document, Vec<Mention>)> {
        let Some(shared) = shared(document.snapshot(), offset) else {
            return vec![(document, occurrences(document.snapshot(), offset))];
        };
        self.programs()
            .filter(|document| has_word(document.text(), &shared.name))
            .map(|document| (document, mentions_of_shared(document.snapshot(), &shared)))
            .filter(|(_, mentions)| !mentions.is_empty())
            .collect()
    }

    /// `textDocument/documentHighlight`
    pub(super) fn highlight(
        &mut self,
        params: DocumentHighlightParams,
    ) -> Answer<DocumentHighlightRequest> {
        let at = params.text_document_position_params;
        let (_, offset) = self.place(&at)?;
        self.follow(&at.text_document.uri, offset);
        let (document, _) = self.place(&at)?;
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
        self.read_others(&params.text_document_position_params)?;
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let to = params.new_name.trim();
        let edits = rename(document.snapshot(), offset, to).map_err(Refusal::failed)?;
        let mut changes = vec![(document, edits)];
        let mut concerned = vec![document];
        if let Some(shared) = shared(document.snapshot(), offset) {
            concerned = self.concerned(&shared.name, to);
            if !self.programs().any(|known| known.name() == shared.file) {
                return Err(Refusal::failed(format!(
                    "`{}` is declared in `{}`: open that file to rename it everywhere",
                    shared.name, shared.file
                )));
            }
            for other in &concerned {
                if other.uri() != document.uri() {
                    let edits = rename_shared(other.snapshot(), &shared, to);
                    changes.push((other, edits.map_err(Refusal::failed)?));
                }
            }
        }
        changes.retain(|(_, edits)| !edits.is_empty());
        self.try_renamed(&changes, &concerned, to).map_err(Refusal::failed)?;
        Ok(Some(self.workspace_edit(&changes)))
    }

    /// The programs that may change when an item is renamed: those that contain its name. If one
    /// contains the new name, the two may clash in any program that uses both.
    fn concerned(&self, name: &str, to: &str) -> Vec<&Document> {
        let is_new = !self.programs().any(|document| has_word(document.text(), to));
        let may_change = |document: &&Document| !is_new || has_word(document.text(), name);
        self.programs().filter(may_change).collect()
    }

    /// Tries a rename on the programs that it changes, and on those of the others that use them.
    fn try_renamed(
        &self,
        changes: &[(&Document, Vec<diagnostic::Edit>)],
        concerned: &[&Document],
        to: &str,
    ) -> Result<(), String> {
        let texts = changes.iter().filter_map(|(document, edits)| {
            let text = document.snapshot().text();
            let (renamed, _) = applied(text, 0..text.len(), edits)?;
            Some((document.name().to_owned(), renamed))
        });
        let texts: HashMap<String, String> = texts.collect();
        for document in concerned {
            let snapshot = document.snapshot();
            let mut read = snapshot.used_names().chain([document.name().to_owned()]);
            if read.any(|name| texts.contains_key(&name)) {
                stays_the_same(snapshot, &texts, to)?;
            }
        }
        Ok(())
    }

    /// `workspace/willRenameFiles`: the programs of the workspace use the files by their new paths.
    pub(super) fn will_rename_files(
        &mut self,
        params: RenameFilesParams,
    ) -> Answer<WillRenameFilesRequest> {
        self.read_workspace();
        let name = |uri: &Uri| name(uri).trim_end_matches('/').to_owned();
        let moves = params.files.iter().map(|file| (name(&file.old_uri), name(&file.new_uri)));
        let moves: Vec<_> = moves.collect();
        let moved = |file: &str| {
            let moved = moves.iter().find_map(|(old, new)| {
                let inside = file.strip_prefix(old.as_str())?;
                // The file itself, or one in the folder.
                (inside.is_empty() || inside.starts_with('/')).then(|| format!("{new}{inside}"))
            });
            moved.unwrap_or_else(|| file.to_owned())
        };
        let changes = self
            .programs()
            .map(|document| (document, edits_for_moves(document.snapshot(), &moved)));
        let changes: Vec<_> = changes.filter(|(_, edits)| !edits.is_empty()).collect();
        Ok((!changes.is_empty()).then(|| self.workspace_edit(&changes)))
    }

    /// Changes of programs; with the versions of those that are open, if the client supports that.
    pub(super) fn workspace_edit(
        &self,
        changes: &[(&Document, Vec<diagnostic::Edit>)],
    ) -> WorkspaceEdit {
        let edits = |document: &Document, edits: &[diagnostic::Edit]| -> Vec<TextEdit> {
            let edits = edits.iter().map(|edit| TextEdit {
                range: document.range(edit.span),
                new_text: document.with_own_line_ends(&edit.text),
            });
            edits.collect()
        };
        if !self.client.takes_versioned_edits() {
            let changes = changes
                .iter()
                .map(|(document, changed)| (document.uri().clone(), edits(document, changed)));
            return WorkspaceEdit { changes: Some(changes.collect()), ..Default::default() };
        }
        let changes = changes.iter().map(|(document, changed)| {
            let edits = edits(document, changed).into_iter().map(Edit::from);
            DocumentChange::from(TextDocumentEdit {
                text_document: OptionalVersionedTextDocumentIdentifier {
                    version: self.documents.get(&document.uri().0).map(Document::version),
                    text_document_identifier: TextDocumentIdentifier {
                        uri: document.uri().clone(),
                    },
                },
                edits: edits.collect(),
            })
        });
        WorkspaceEdit { document_changes: Some(changes.collect()), ..Default::default() }
    }
}

/// True if a text contains a name, with or without primes.
fn has_word(text: &str, name: &str) -> bool {
    let name = name.trim_end_matches('\'');
    text.split(|letter: char| !letter.is_alphanumeric() && letter != '_').any(|word| word == name)
}
