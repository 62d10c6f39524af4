//! Symbols of documents and of the workspace, folding ranges and selection ranges.

use gen_lsp_types::*;

use super::document::Document;
use super::requests::Answer;
use super::server::Server;
use crate::analysis::{Entry, EntryKind, around, folds, outline};

/// The most symbols of a workspace in one answer.
const MOST_SYMBOLS: usize = 500;

fn kind(kind: EntryKind) -> SymbolKind {
    match kind {
        EntryKind::Op => SymbolKind::Class,
        EntryKind::Rule => SymbolKind::Method,
        EntryKind::Side => SymbolKind::Namespace,
        EntryKind::Statement => SymbolKind::Field,
        EntryKind::Script | EntryKind::Function => SymbolKind::Function,
        EntryKind::Attribute => SymbolKind::Property,
        EntryKind::Test => SymbolKind::Event,
    }
}

impl Server {
    /// `textDocument/documentSymbol`
    pub(super) fn document_symbols(
        &mut self,
        params: DocumentSymbolParams,
    ) -> Answer<DocumentSymbolRequest> {
        let document = self.document(&params.text_document.uri)?;
        let entries = outline(document.snapshot());
        Ok(Some(if self.client.nests_symbols() {
            let nested = entries.iter().map(|entry| nested(document, entry));
            DocumentSymbolResponse::DocumentSymbolList(nested.collect())
        } else {
            let mut flat = Vec::new();
            flatten(document, &entries, None, &mut flat);
            DocumentSymbolResponse::SymbolInformationList(flat)
        }))
    }

    /// `workspace/symbol`: the items of all programs of the workspace whose names have the
    /// letters of the query, in order.
    pub(super) fn workspace_symbols(
        &mut self,
        params: WorkspaceSymbolParams,
    ) -> Answer<WorkspaceSymbolRequest> {
        self.read_workspace();
        let mut found = Vec::new();
        for document in self.programs() {
            for entry in outline(document.snapshot()) {
                if matches(&entry.name, &params.query) {
                    found.push(information(document, &entry, None));
                }
            }
        }
        found.truncate(MOST_SYMBOLS);
        Ok(Some(WorkspaceSymbolResponse::SymbolInformationList(found)))
    }

    /// `textDocument/foldingRange`
    pub(super) fn folding(&mut self, params: FoldingRangeParams) -> Answer<FoldingRangeRequest> {
        let document = self.document(&params.text_document.uri)?;
        let folds = folds(document.snapshot());
        let ranges = folds.into_iter().filter_map(|(span, is_comment)| {
            let range = document.range(span);
            // The line of the closing brace stays in view.
            let end = range.end.line - u32::from(!is_comment && range.end.line > 0);
            (end > range.start.line).then(|| FoldingRange {
                start_line: range.start.line,
                end_line: end,
                kind: is_comment.then_some(FoldingRangeKind::Comment),
                ..Default::default()
            })
        });
        let mut ranges: Vec<_> = ranges.collect();
        ranges.dedup_by_key(|range| (range.start_line, range.end_line));
        Ok(Some(ranges))
    }

    /// `textDocument/selectionRange`
    pub(super) fn selection(
        &mut self,
        params: SelectionRangeParams,
    ) -> Answer<SelectionRangeRequest> {
        let document = self.document(&params.text_document.uri)?;
        let grow = |position: &Position| {
            let spans = around(document.snapshot(), document.offset(*position));
            let outer_first = spans.iter().rev();
            let grown = outer_first.fold(None, |parent, span| {
                Some(Box::new(SelectionRange { range: document.range(*span), parent }))
            });
            let nothing =
                SelectionRange { range: Range { start: *position, end: *position }, parent: None };
            grown.map_or(nothing, |grown| *grown)
        };
        Ok(Some(params.positions.iter().map(grow).collect()))
    }
}

fn nested(document: &Document, entry: &Entry) -> DocumentSymbol {
    let children = entry.children.iter().map(|child| nested(document, child));
    DocumentSymbol {
        name: shown(&entry.name),
        detail: Some(entry.detail.clone()).filter(|detail| !detail.is_empty()),
        kind: kind(entry.kind),
        range: document.range(entry.span),
        selection_range: document.range(entry.name_span),
        children: Some(children.collect()),
        tags: None,
        #[allow(deprecated)]
        deprecated: None,
    }
}

/// A name as it is shown: clients reject empty ones.
fn shown(name: &str) -> String {
    if name.trim().is_empty() { "(no name)".into() } else { name.to_owned() }
}

fn flatten(
    document: &Document,
    entries: &[Entry],
    container: Option<&str>,
    flat: &mut Vec<SymbolInformation>,
) {
    for entry in entries {
        flat.push(information(document, entry, container));
        flatten(document, &entry.children, Some(&entry.name), flat);
    }
}

fn information(document: &Document, entry: &Entry, container: Option<&str>) -> SymbolInformation {
    SymbolInformation {
        #[allow(deprecated)]
        deprecated: None,
        location: Location { uri: document.uri().clone(), range: document.range(entry.name_span) },
        base_symbol_information: BaseSymbolInformation {
            name: shown(&entry.name),
            kind: kind(entry.kind),
            tags: None,
            container_name: container.map(str::to_owned),
        },
    }
}

/// True if a name has the letters of a query, in order.
fn matches(name: &str, query: &str) -> bool {
    let mut letters = name.chars().flat_map(char::to_lowercase);
    let query = query.chars().flat_map(char::to_lowercase);
    query
        .filter(|letter| !letter.is_whitespace())
        .all(|wanted| letters.any(|letter| letter == wanted))
}
