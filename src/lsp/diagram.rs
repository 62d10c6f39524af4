//! The diagram of the op under a cursor: on request, and on a page that follows the cursor.
//!
//! The protocol does not report where the cursor is. But clients send that place all the time, with
//! requests for actions and highlights; and a client may send `hedgerow/cursor`, with a document
//! and a position.

use gen_lsp_types::{Position, TextDocumentIdentifier, Uri};
use serde::{Deserialize, Serialize};

use super::diagram_page::{DiagramPage, Shown};
use super::hover::verdict;
use super::requests::Refusal;
use super::server::Server;
use crate::analysis::{OpCard, op_card, op_here, op_named};
use crate::draw::draw_op;

/// The parameters of `hedgerow/diagram` and `hedgerow/cursor`: the op at a position, or of a name.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct DiagramParams {
    text_document: TextDocumentIdentifier,
    #[serde(default)]
    position: Option<Position>,
    #[serde(default)]
    name: Option<String>,
}

/// The diagram of an op.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Diagram {
    name: String,
    /// The picture.
    svg: String,
    /// True if it is of the current text; else of the last that could be read.
    is_current: bool,
    /// True if the op is proved.
    proved: bool,
    /// The verdict, or what is wrong, as Markdown.
    verdict: String,
}

impl Server {
    /// `hedgerow/diagram`
    pub(super) fn diagram(&mut self, params: DiagramParams) -> Result<Option<Diagram>, Refusal> {
        let document = self.document(&params.text_document.uri)?;
        let snapshot = document.snapshot();
        let op = match (&params.name, params.position) {
            (Some(name), _) => op_named(snapshot, name),
            (None, Some(position)) => op_here(snapshot, document.offset(position)),
            (None, None) => None,
        };
        Ok(op.and_then(|op| draw(&op_card(snapshot, op))))
    }

    /// `hedgerow/cursor`
    pub(super) fn cursor(&mut self, params: DiagramParams) {
        let uri = params.text_document.uri;
        let Some(document) = self.documents.get(&uri.0) else { return };
        if let Some(position) = params.position {
            let offset = document.offset(position);
            self.follow(&uri, offset);
        }
    }

    /// Shows the op around the cursor in the preview, if that is open.
    pub(super) fn follow(&mut self, uri: &Uri, offset: usize) {
        let Some(document) = self.documents.get(&uri.0) else { return };
        let snapshot = document.snapshot();
        if self.preview.is_some()
            && let Some(op) = op_here(snapshot, offset)
        {
            self.show(&op_card(snapshot, op));
        }
    }

    /// Shows an op in the preview, if it is open.
    pub(super) fn show(&self, op: &OpCard) {
        if let (Some(preview), Some(diagram)) = (&self.preview, draw(op)) {
            preview.show(Shown { title: diagram.name, verdict: diagram.verdict, svg: diagram.svg });
        }
    }

    /// The address of the preview, which is opened if it is not open yet.
    pub(super) fn preview_address(&mut self) -> Result<String, Refusal> {
        if self.preview.is_none() {
            let opened = DiagramPage::open();
            let refused = |error| Refusal::failed(format!("the preview cannot be opened: {error}"));
            self.preview = Some(opened.map_err(refused)?);
        }
        let preview = self.preview.as_ref();
        Ok(preview.map_or(String::new(), DiagramPage::address))
    }
}

fn draw(card: &OpCard) -> Option<Diagram> {
    let diagram = card.diagram.as_ref()?;
    Some(Diagram {
        name: diagram.name.clone(),
        svg: draw_op(diagram).svg(),
        is_current: card.is_current,
        proved: card.verdict.proved,
        verdict: verdict(card),
    })
}
