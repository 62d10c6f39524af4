//! The server: takes messages and returns messages.

use std::collections::{BTreeMap, VecDeque};

use gen_lsp_types::{LspNotificationMethod, LspRequestMethod};
use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use serde::Serialize;
use serde_json::Value;

use super::client::Client;
use super::diagram_page::DiagramPage;
use super::document::Document;
use super::files::Files;
use super::progress::Progress;
use super::subprocess::Subprocess;
use super::workspace::Workspace;
use crate::analysis::Reader;

/// The open documents, by their URIs.
pub(super) type Documents = BTreeMap<String, Document>;

/// The stage of the conversation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stage {
    /// Not initialized.
    Uninitialized,
    /// Initialized.
    Ready,
    /// The client has sent `shutdown`.
    ShutDown,
    /// The client has sent `exit`: the process may end, with this exit code.
    Exited(u8),
}

/// A request to the client that is not answered yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum PendingRequest {
    /// Its settings.
    Settings,
    /// A token for progress.
    Progress,
    /// Anything whose answer is ignored.
    Other,
}

/// The language server, without streams: takes messages and returns messages.
#[derive(Debug)]
pub struct Server {
    pub(super) stage: Stage,
    pub(super) client: Client,
    pub(super) documents: Documents,
    pub(super) workspace: Workspace,
    pub(super) files: Files,
    pub(super) preview: Option<DiagramPage>,
    pub(super) progress: Option<Progress>,
    pub(super) subprocesses: Vec<Subprocess>,
    /// True if what the client shows of documents may have changed by more than their own text.
    pub(super) is_outdated: bool,
    waiting: VecDeque<Message>,
    /// Requests that are answered when all ops of their document are proved.
    deferred: Vec<Request>,
    outgoing: Vec<Message>,
    pub(super) pending: Vec<(RequestId, PendingRequest)>,
    next_id: i32,
}

impl Server {
    /// A server that is not initialized. The reader gives it the files that no client has open.
    pub fn new(reader: Box<dyn Reader>) -> Self {
        Self {
            files: Files::new(reader),
            preview: None,
            progress: None,
            subprocesses: Vec::new(),
            is_outdated: false,
            stage: Stage::Uninitialized,
            client: Client::default(),
            documents: Documents::new(),
            workspace: Workspace::default(),
            waiting: VecDeque::new(),
            deferred: Vec::new(),
            outgoing: Vec::new(),
            pending: Vec::new(),
            next_id: 0,
        }
    }

    /// Takes in a message. [`work`](Self::work) handles it in its turn; only a cancellation takes
    /// effect at once, on requests that are still waiting.
    pub fn accept(&mut self, message: Message) {
        match message {
            Message::Notification(notice)
                if notice.method == LspNotificationMethod::CancelRequest.as_str() =>
            {
                self.cancel(&notice);
            }
            message => self.waiting.push_back(message),
        }
    }

    fn cancel(&mut self, notice: &Notification) {
        let id = notice.params.get("id").cloned().unwrap_or_default();
        let Ok(id) = serde_json::from_value::<RequestId>(id) else { return };
        let is_meant =
            |message: &Message| matches!(message, Message::Request(request) if request.id == id);
        if let Some(at) = self.waiting.iter().position(is_meant) {
            self.waiting.remove(at);
        } else if let Some(at) = self.deferred.iter().position(|request| request.id == id) {
            self.deferred.remove(at);
        } else {
            return; // it is answered already
        }
        let code = ErrorCode::RequestCanceled as i32;
        let answer = Response::new_err(id, code, "the request was cancelled".into());
        self.outgoing.push(answer.into());
    }

    /// Does one piece of work: handles the next message or, if none waits, proves an op or
    /// publishes diagnostics. Returns the messages to send; `None` if there is nothing to do.
    pub fn work(&mut self) -> Option<Vec<Message>> {
        if !self.outgoing.is_empty() {
            return Some(std::mem::take(&mut self.outgoing));
        }
        let ready = self.deferred.iter().position(|request| !self.needs_proofs(request));
        if let Some(at) = ready {
            let request = self.deferred.remove(at);
            self.request(request);
            return Some(std::mem::take(&mut self.outgoing));
        }
        match self.waiting.pop_front() {
            Some(Message::Request(request)) if self.needs_proofs(&request) => {
                self.deferred.push(request);
            }
            Some(Message::Request(request)) => self.request(request),
            Some(Message::Notification(notice)) => self.notification(notice),
            Some(Message::Response(response)) => self.response(response),
            None if self.stage == Stage::Ready => {
                if !self.publish_next() {
                    return None;
                }
            }
            None => return None,
        }
        Some(std::mem::take(&mut self.outgoing))
    }

    /// The exit code, once the client has sent `exit`.
    pub fn exit_code(&self) -> Option<u8> {
        match self.stage {
            Stage::Exited(code) => Some(code),
            _ => None,
        }
    }

    /// The text of an open document, as the server holds it.
    pub fn text(&self, uri: &str) -> Option<&str> {
        Some(self.documents.get(uri)?.text())
    }

    /// True if a request is about all ops of a document, and not all of them have been examined.
    /// Answering at once would block all other requests: instead, ops are proved one by one between
    /// messages.
    fn needs_proofs(&self, request: &Request) -> bool {
        let method = LspRequestMethod::from(request.method.as_str());
        let asks_all = matches!(
            method,
            LspRequestMethod::TextDocumentCodeLens | LspRequestMethod::TextDocumentDiagnostic
        );
        let uri = request.params.pointer("/textDocument/uri").and_then(Value::as_str);
        let document = uri.filter(|_| asks_all && self.stage == Stage::Ready);
        let document = document.and_then(|uri| self.documents.get(uri));
        document.is_some_and(|document| !document.is_published)
    }

    fn request(&mut self, request: Request) {
        let method = LspRequestMethod::from(request.method.as_str());
        let is_initialize = method == LspRequestMethod::Initialize;
        let refused = match self.stage {
            Stage::Uninitialized if !is_initialize => {
                Some((ErrorCode::ServerNotInitialized, "the first request must be `initialize`"))
            }
            Stage::Ready if is_initialize => {
                Some((ErrorCode::InvalidRequest, "`initialize` comes only once"))
            }
            Stage::ShutDown | Stage::Exited(_) => {
                Some((ErrorCode::InvalidRequest, "the server is shut down"))
            }
            _ => None,
        };
        let answer = match refused {
            Some((code, why)) => Response::new_err(request.id, code as i32, why.into()),
            None => self.answer(request),
        };
        self.outgoing.push(answer.into());
    }

    fn notification(&mut self, notice: Notification) {
        let method = LspNotificationMethod::from(notice.method.as_str());
        match (self.stage, method) {
            (stage, LspNotificationMethod::Exit) => {
                let was_asked = stage == Stage::ShutDown;
                self.stage = Stage::Exited(u8::from(!was_asked));
            }
            (Stage::Ready, _) => self.notice(notice),
            _ => {}
        }
    }

    fn response(&mut self, response: Response) {
        let at = self.pending.iter().position(|(id, _)| *id == response.id);
        let Some(at) = at else { return };
        let (_, pending) = self.pending.remove(at);
        match (pending, response.response_result) {
            (PendingRequest::Settings, Ok(value)) => self.settings_arrived(&value),
            (PendingRequest::Progress, Ok(_)) => self.progress_created(),
            (PendingRequest::Progress, Err(_)) => self.progress = None,
            _ => {}
        }
    }

    /// Takes the subprocesses to start: each is returned once.
    pub fn take_subprocesses(&mut self) -> Vec<Subprocess> {
        std::mem::take(&mut self.subprocesses)
    }

    /// Reads the programs of the workspace that are not open.
    pub(super) fn read_workspace(&mut self) {
        let encoding = self.client.encoding;
        self.workspace.read(&self.documents, &self.files, encoding);
    }

    /// All programs of the workspace, those first that are open.
    pub(super) fn programs(&self) -> impl Iterator<Item = &Document> {
        self.documents.values().chain(self.workspace.closed())
    }

    /// Discards the snapshots of all programs that use a file of this name.
    pub(super) fn file_changed(&mut self, name: &str) {
        for document in self.documents.values_mut() {
            self.is_outdated |= document.file_changed(name);
        }
        self.workspace.file_changed(name);
    }

    /// A number that has not been used.
    pub(super) fn fresh(&mut self) -> i32 {
        self.next_id = self.next_id.wrapping_add(1);
        self.next_id
    }

    /// Sends a notification.
    pub(super) fn tell<N: gen_lsp_types::Notification>(&mut self, params: N::Params) {
        let notice = Notification::new(N::METHOD.as_str().to_owned(), params);
        self.outgoing.push(notice.into());
    }

    /// Sends a request to the client.
    pub(super) fn ask<R: gen_lsp_types::Request>(
        &mut self,
        params: R::Params,
        pending: PendingRequest,
    ) where
        R::Params: Serialize,
    {
        let id = RequestId::from(format!("hedgerow-{}", self.fresh()));
        let request = Request::new(id.clone(), R::METHOD.as_str().to_owned(), params);
        self.pending.push((id, pending));
        self.outgoing.push(request.into());
    }
}
