//! Dispatch of requests to the functions that answer them.

use gen_lsp_types::*;
use gen_lsp_types::{LspRequestMethod as Method, Request as Question, Uri};
use lsp_server::{ErrorCode, Request, Response};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::document::Document;
use super::server::{Server, Stage};

/// The reason why a request fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Refusal {
    /// The kind of failure.
    pub(super) code: i32,
    /// The reason, for a person.
    pub(super) why: String,
}

impl Refusal {
    /// A request that makes no sense.
    pub(super) fn invalid(why: impl Into<String>) -> Self {
        Self { code: ErrorCode::InvalidParams as i32, why: why.into() }
    }

    /// A request that makes sense, but cannot be carried out.
    pub(super) fn failed(why: impl Into<String>) -> Self {
        Self { code: ErrorCode::RequestFailed as i32, why: why.into() }
    }
}

/// The answer to a request.
pub(super) type Answer<Q> = Result<<Q as Question>::Result, Refusal>;

impl Server {
    /// Answers a request.
    pub(super) fn answer(&mut self, request: Request) -> Response {
        let method = request.method.clone();
        match Method::from(method.as_str()) {
            Method::Initialize => {
                let answer = self.initialize(&request.params);
                Response::new_ok(request.id, answer)
            }
            Method::Shutdown => {
                self.stage = Stage::ShutDown;
                Response::new_ok(request.id, Value::Null)
            }
            Method::TextDocumentDiagnostic => self.respond(request, Self::pull),
            Method::TextDocumentHover => self.respond(request, Self::hover),
            Method::TextDocumentDefinition => self.respond(request, Self::definition),
            Method::TextDocumentReferences => self.respond(request, Self::references),
            Method::TextDocumentDocumentHighlight => self.respond(request, Self::highlight),
            Method::TextDocumentPrepareRename => self.respond(request, Self::prepare_rename),
            Method::TextDocumentRename => self.respond(request, Self::rename),
            Method::WorkspaceWillRenameFiles => self.respond(request, Self::will_rename_files),
            Method::TextDocumentDocumentSymbol => self.respond(request, Self::document_symbols),
            Method::WorkspaceSymbol => self.respond(request, Self::workspace_symbols),
            Method::TextDocumentFoldingRange => self.respond(request, Self::folding),
            Method::TextDocumentSelectionRange => self.respond(request, Self::selection),
            Method::TextDocumentSemanticTokensFull => self.respond(request, Self::tokens),
            Method::TextDocumentSemanticTokensRange => self.respond(request, Self::tokens_of_range),
            Method::TextDocumentInlayHint => self.respond(request, Self::hints),
            Method::TextDocumentDocumentLink => self.respond(request, Self::links),
            Method::TextDocumentCodeAction => self.respond(request, Self::actions),
            Method::TextDocumentCompletion => self.respond(request, Self::completion),
            Method::TextDocumentSignatureHelp => self.respond(request, Self::signature),
            Method::TextDocumentCodeLens => self.respond(request, Self::lenses),
            Method::WorkspaceExecuteCommand => self.respond(request, Self::execute),
            Method::TextDocumentFormatting => self.respond(request, Self::format),
            Method::TextDocumentRangeFormatting => self.respond(request, Self::format_range),
            Method::Custom("hedgerow/diagram") => self.respond(request, Self::diagram),
            _ => Response::new_err(
                request.id,
                ErrorCode::MethodNotFound as i32,
                format!("`{method}` is not known here"),
            ),
        }
    }

    fn respond<P: DeserializeOwned, R: Serialize>(
        &mut self,
        request: Request,
        answer: fn(&mut Self, P) -> Result<R, Refusal>,
    ) -> Response {
        let params = match serde_json::from_value(request.params) {
            Ok(params) => params,
            Err(error) => {
                let why = format!("the parameters cannot be read: {error}");
                let code = ErrorCode::InvalidParams as i32;
                return Response::new_err(request.id, code, why);
            }
        };
        match answer(self, params) {
            Ok(result) => Response::new_ok(request.id, result),
            Err(refusal) => Response::new_err(request.id, refusal.code, refusal.why),
        }
    }

    /// An open document.
    pub(super) fn document(&self, uri: &Uri) -> Result<&Document, Refusal> {
        self.documents
            .get(&uri.0)
            .ok_or_else(|| Refusal::invalid(format!("`{}` is not open", uri.0)))
    }

    /// An open document and a byte in it.
    pub(super) fn place(
        &self,
        at: &TextDocumentPositionParams,
    ) -> Result<(&Document, usize), Refusal> {
        let document = self.document(&at.text_document.uri)?;
        Ok((document, document.offset(at.position)))
    }
}
