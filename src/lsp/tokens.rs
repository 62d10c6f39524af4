//! Semantic tokens. An element of a drawing is a variable with modifiers: its kind, and whether it
//! is new, erased or outer. Clients that do not know them colour it as a variable.

use gen_lsp_types::*;

use super::document::Document;
use super::requests::Answer;
use super::server::Server;
use crate::analysis::{Class, Coloured, tokens};
use crate::diagram::Kind;

/// The types, by their indices.
pub(super) const TYPES: [&str; 13] = [
    "keyword",
    "type",
    "class",
    "function",
    "property",
    "enumMember",
    "variable",
    "parameter",
    "typeParameter",
    "number",
    "string",
    "comment",
    "operator",
];

/// The modifiers, by their bits.
pub(super) const MODIFIERS: [&str; 12] = [
    "declaration",
    "defaultLibrary",
    "documentation",
    "new",
    "erased",
    "outer",
    "vertex",
    "halfedge",
    "edge",
    "face",
    "path",
    "fan",
];

impl Server {
    /// `textDocument/semanticTokens/full`
    pub(super) fn tokens(&mut self, params: SemanticTokensParams) -> Answer<SemanticTokensRequest> {
        let document = self.document(&params.text_document.uri)?;
        Ok(Some(encoded(document, 0..usize::MAX)))
    }

    /// `textDocument/semanticTokens/range`
    pub(super) fn tokens_of_range(
        &mut self,
        params: SemanticTokensRangeParams,
    ) -> Answer<SemanticTokensRangeRequest> {
        let document = self.document(&params.text_document.uri)?;
        Ok(Some(encoded(document, document.bytes(params.range))))
    }
}

/// The tokens of a part of a document, each relative to the one before.
fn encoded(document: &Document, part: std::ops::Range<usize>) -> SemanticTokens {
    let mut last = Position::default();
    let tokens = tokens(document.snapshot());
    let inside = tokens.iter().filter(|token| {
        let span = token.span.range();
        span.end > part.start && span.start < part.end
    });
    let data = inside.filter_map(|token| {
        let range = document.range(token.span);
        // A text that is not closed, or a comment with a lone `\r`, may span lines.
        if range.start.line != range.end.line {
            return None;
        }
        let delta_line = range.start.line - last.line;
        let from = if delta_line == 0 { last.character } else { 0 };
        last = range.start;
        Some(SemanticToken {
            delta_line,
            delta_start: range.start.character - from,
            length: range.end.character - range.start.character,
            token_type: number(TYPES.as_slice(), type_name(token.class)),
            token_modifiers_bitset: modifiers(token),
        })
    });
    SemanticTokens { result_id: None, data: data.collect() }
}

fn number(names: &[&str], name: &str) -> u32 {
    names.iter().position(|known| *known == name).map_or(0, super::position::narrow)
}

fn type_name(class: Class) -> &'static str {
    match class {
        Class::Keyword => "keyword",
        Class::Type => "type",
        Class::Op => "class",
        Class::Script | Class::Function => "function",
        Class::Attribute | Class::Field => "property",
        Class::Rule | Class::Property => "enumMember",
        Class::Element(_) | Class::Variable => "variable",
        Class::Parameter => "parameter",
        Class::Index => "typeParameter",
        Class::Number => "number",
        Class::Text => "string",
        Class::Comment => "comment",
        Class::Operator => "operator",
    }
}

fn modifiers(token: &Coloured) -> u32 {
    let marks = token.marks;
    let kind = match token.class {
        Class::Element(kind) => kind,
        _ => None,
    };
    let set = [
        (marks.declares, "declaration"),
        (marks.is_built_in, "defaultLibrary"),
        (marks.documents, "documentation"),
        (marks.is_new, "new"),
        (marks.is_erased, "erased"),
        (marks.is_outer, "outer"),
        (kind.is_some(), kind.map_or("", Kind::word)),
    ];
    set.into_iter()
        .filter(|(is_set, _)| *is_set)
        .fold(0, |bits, (_, name)| bits | 1 << number(&MODIFIERS, name))
}
