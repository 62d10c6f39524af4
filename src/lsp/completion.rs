//! Completions and signature help.

use gen_lsp_types::*;

use super::markdown::quoted;
use super::requests::Answer;
use super::server::Server;
use crate::analysis::{Call, Choice, Completion, completions, letters_before, signature};
use crate::diagnostic::Edit;
use crate::diagram::Kind;

fn kind(choice: Choice) -> CompletionItemKind {
    match choice {
        Choice::Keyword => CompletionItemKind::Keyword,
        Choice::Type => CompletionItemKind::TypeParameter,
        Choice::Property => CompletionItemKind::EnumMember,
        Choice::Element(Kind::Vertex) => CompletionItemKind::Value,
        Choice::Element(Kind::Face) => CompletionItemKind::Struct,
        Choice::Element(Kind::Edge) => CompletionItemKind::Unit,
        Choice::Element(_) => CompletionItemKind::Reference,
        Choice::Variable => CompletionItemKind::Variable,
        Choice::Field => CompletionItemKind::Field,
        Choice::Function => CompletionItemKind::Function,
        Choice::Op => CompletionItemKind::Class,
        Choice::File => CompletionItemKind::File,
    }
}

impl Server {
    /// `textDocument/completion`
    pub(super) fn completion(&mut self, params: CompletionParams) -> Answer<CompletionRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let found = completions(document.snapshot(), offset, &mut self.files.clone());
        let snippets = self.client.takes_snippets();
        let is_markdown = self.client.reads_markdown_of_completions();
        let item = |completion: Completion| {
            let mut item = CompletionItem {
                kind: Some(kind(completion.choice)),
                detail: Some(completion.detail).filter(|detail| !detail.is_empty()),
                sort_text: Some(format!("{}{}", completion.rank, completion.word)),
                preselect: (completion.rank == 0).then_some(true),
                ..Default::default()
            };
            if !completion.docs.is_empty() {
                item.documentation = Some(documentation(&completion.docs, is_markdown).into());
            }
            if let Some(snippet) = completion.snippet.filter(|_| snippets) {
                item.insert_text = Some(snippet);
                item.insert_text_format = Some(InsertTextFormat::Snippet);
            }
            if let Some(bytes) = completion.replaced {
                let range = document.range_of(bytes);
                item.text_edit = Some(TextEdit { range, new_text: completion.word.clone() }.into());
            }
            if let Some(Edit { span, text: new_text }) = completion.insertion {
                let range = document.range_of(span.range());
                item.additional_text_edits = Some(vec![TextEdit { range, new_text }]);
            }
            item.label = completion.word;
            item
        };
        let list = CompletionList {
            // What the library has is offered for the letters that are there.
            is_incomplete: letters_before(document.snapshot(), offset).is_empty(),
            items: found.into_iter().map(item).collect(),
            ..Default::default()
        };
        Ok(Some(list.into()))
    }

    /// `textDocument/signatureHelp`
    pub(super) fn signature(
        &mut self,
        params: SignatureHelpParams,
    ) -> Answer<SignatureHelpRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let found = signature(document.snapshot(), offset);
        Ok(found.map(|(calls, argument)| {
            // The first way that has this many parameters.
            let active = calls.iter().position(|call| call.params.len() > argument);
            SignatureHelp {
                signatures: calls.into_iter().map(information).collect(),
                active_signature: Some(active.map_or(0, super::position::narrow)),
                active_parameter: Some(ActiveParameter::Int(super::position::narrow(argument))),
            }
        }))
    }
}

/// A doc comment, as Markdown or as it is.
fn documentation(docs: &[String], is_markdown: bool) -> MarkupContent {
    match is_markdown {
        true => MarkupContent { kind: MarkupKind::Markdown, value: quoted(docs).join("\n") },
        false => MarkupContent { kind: MarkupKind::PlainText, value: docs.join("\n") },
    }
}

fn information(call: Call) -> SignatureInformation {
    let params = call
        .params
        .into_iter()
        .map(|label| ParameterInformation { label: label.into(), documentation: None });
    SignatureInformation {
        label: call.label,
        documentation: Some(call.about.into()),
        parameters: Some(params.collect()),
        active_parameter: None,
    }
}
