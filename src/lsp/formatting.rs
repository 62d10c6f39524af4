//! Formatting, as `hedgerow fmt` does it.

use gen_lsp_types::*;

use super::document::Document;
use super::requests::{Answer, Refusal};
use super::server::Server;
use crate::format::{self, edits, edits_of_lines};

impl Server {
    /// `textDocument/formatting`
    pub(super) fn format(
        &mut self,
        params: DocumentFormattingParams,
    ) -> Answer<DocumentFormattingRequest> {
        let document = self.document(&params.text_document.uri)?;
        let snapshot = document.snapshot();
        let edits = edits(snapshot.file(), document.text(), snapshot.parsed()).map_err(refused)?;
        Ok(Some(text_edits(document, &edits)))
    }

    /// `textDocument/rangeFormatting`
    pub(super) fn format_range(
        &mut self,
        params: DocumentRangeFormattingParams,
    ) -> Answer<DocumentRangeFormattingRequest> {
        let document = self.document(&params.text_document.uri)?;
        // A selection of whole lines ends where the next line begins.
        let end = params.range.end;
        let reaches = end.character > 0 || end.line == params.range.start.line;
        let last = end.line as usize + usize::from(reaches);
        let lines = params.range.start.line as usize..last;
        let snapshot = document.snapshot();
        let edits = edits_of_lines(snapshot.file(), document.text(), snapshot.parsed(), lines)
            .map_err(refused)?;
        Ok(Some(text_edits(document, &edits)))
    }
}

fn refused(refusal: format::Refusal) -> Refusal {
    Refusal::failed(refusal.to_string())
}

fn text_edits(document: &Document, edits: &[format::Edit]) -> Vec<TextEdit> {
    let edits = edits.iter().map(|edit| TextEdit {
        range: document.range_of(edit.range.clone()),
        new_text: edit.text.clone(),
    });
    edits.collect()
}
