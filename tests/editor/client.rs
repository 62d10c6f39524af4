//! An editor without a screen: it speaks the protocol with a server in this process.

use hedgerow::analysis::{Nowhere, Reader};
use hedgerow::lsp::Server;
use lsp_server::{Message, Notification, Request, RequestId, Response};
use serde_json::{Value, json};

/// The document that tests write in.
pub const URI: &str = "file:///work/test.hedge";

pub struct Client {
    pub server: Server,
    next_id: i32,
    /// What the server has said of itself.
    pub hello: Value,
    /// What the server has let the client know, in order.
    pub told: Vec<Notification>,
    /// What the server has asked the client, in order.
    pub asked: Vec<Request>,
}

impl Client {
    /// A client that has said hello, with these capabilities.
    pub fn new(params: Value) -> Self {
        Self::over(Box::new(Nowhere), params)
    }

    /// One of a server that reads its files here.
    pub fn over(reader: Box<dyn Reader>, params: Value) -> Self {
        let mut client = Self { server: Server::new(reader), ..Self::silent() };
        client.hello = client.request("initialize", params).unwrap();
        client.notify("initialized", json!({}));
        client
    }

    /// A client that has not said anything.
    pub fn silent() -> Self {
        Self {
            server: Server::new(Box::new(Nowhere)),
            next_id: 0,
            hello: Value::Null,
            told: Vec::new(),
            asked: Vec::new(),
        }
    }

    /// A client that can do everything, with columns in this encoding.
    pub fn able(encoding: &str) -> Self {
        Self::new(json!({
            "processId": null,
            "rootUri": null,
            "clientInfo": { "name": "test" },
            "capabilities": {
                "general": { "positionEncodings": [encoding] },
                "textDocument": {
                    "hover": { "contentFormat": ["markdown", "plaintext"] },
                    "completion": { "completionItem": {
                        "snippetSupport": true, "documentationFormat": ["markdown", "plaintext"],
                    } },
                    "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
                },
                "workspace": { "workspaceEdit": { "documentChanges": true } },
            },
        }))
    }

    /// Opens the document with a text.
    pub fn open(&mut self, text: &str) {
        self.open_as(URI, text);
    }

    pub fn open_as(&mut self, uri: &str, text: &str) {
        let item = json!({ "uri": uri, "languageId": "hedgerow", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": item }));
    }

    /// Sends a notification, and lets the server finish.
    pub fn notify(&mut self, method: &str, params: Value) {
        self.server.accept(Notification::new(method.into(), params).into());
        assert!(self.settle(None).is_none());
    }

    /// Asks, and waits for the answer.
    pub fn request(&mut self, method: &str, params: Value) -> Result<Value, (i32, String)> {
        self.next_id += 1;
        let id = RequestId::from(self.next_id);
        self.server.accept(Request::new(id.clone(), method.into(), params).into());
        let answer = self.settle(Some(&id)).expect("every request is answered");
        answer.response_result.map_err(|error| (error.code, error.message))
    }

    /// Lets the server work until it has nothing to do.
    pub fn settle(&mut self, wanted: Option<&RequestId>) -> Option<Response> {
        let mut answer = None;
        while let Some(messages) = self.server.work() {
            for message in messages {
                match message {
                    Message::Response(response) if Some(&response.id) == wanted => {
                        assert!(answer.is_none(), "answered twice");
                        answer = Some(response);
                    }
                    Message::Response(response) => panic!("nobody asked: {response:?}"),
                    Message::Notification(notice) => self.told.push(notice),
                    Message::Request(request) => self.asked.push(request),
                }
            }
        }
        answer
    }

    /// The diagnostics that were published last for the document, and their version.
    pub fn published(&self) -> Option<&Value> {
        let all = self.told.iter().rev();
        let of = all.filter(|notice| notice.method == "textDocument/publishDiagnostics");
        of.map(|notice| &notice.params).find(|params| params["uri"] == URI)
    }
}

/// The document as the parameter of a question.
pub fn document() -> Value {
    json!({ "uri": URI })
}

/// The line and the column, in bytes, of a byte.
pub fn position(text: &str, offset: usize) -> Value {
    let before = &text[..offset];
    let line = before.matches('\n').count();
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    json!({ "line": line, "character": offset - start })
}

/// The byte at a position whose column counts bytes.
pub fn offset(text: &str, position: &Value) -> usize {
    let line = position["line"].as_u64().unwrap() as usize;
    let starts = text.match_indices('\n').map(|(at, _)| at + 1);
    let start = std::iter::once(0).chain(starts).nth(line).unwrap();
    start + position["character"].as_u64().unwrap() as usize
}
