//! Inlay hints, and links of `use`.

use gen_lsp_types::*;

use super::requests::Answer;
use super::server::Server;
use crate::analysis::{hints, links};

impl Server {
    /// `textDocument/inlayHint`
    pub(super) fn hints(&mut self, params: InlayHintParams) -> Answer<InlayHintRequest> {
        let document = self.document(&params.text_document.uri)?;
        if !self.client.settings.hints {
            return Ok(Some(Vec::new()));
        }
        let found = hints(document.snapshot(), document.bytes(params.range));
        let hints = found.into_iter().map(|hint| InlayHint {
            position: document.position(hint.after.end as usize),
            label: hint.label.into(),
            kind: hint.is_type.then_some(InlayHintKind::Type),
            tooltip: Some(hint.meaning.into()),
            padding_left: Some(!hint.is_type),
            padding_right: Some(false),
            text_edits: None,
            data: None,
        });
        Ok(Some(hints.collect()))
    }

    /// `textDocument/documentLink`
    pub(super) fn links(&mut self, params: DocumentLinkParams) -> Answer<DocumentLinkRequest> {
        let document = self.document(&params.text_document.uri)?;
        let links = links(document.snapshot()).into_iter().filter_map(|link| {
            Some(DocumentLink {
                range: document.range(link.span),
                target: Some(document.used_file(&link.path)?.uri),
                tooltip: None,
                data: None,
            })
        });
        Ok(Some(links.collect()))
    }
}
