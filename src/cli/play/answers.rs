//! The answers to requests.

use std::io::Read;
use std::sync::Arc;

use serde::Deserialize;
use serde_json::json;
use tiny_http::{Header, Method, Request, Response, StatusCode};

use super::folder::Folder;
use super::page;
use super::pages::Pages;
use crate::lsp::uri;
use crate::play::Message;

/// The most bytes of a question, which may be a mesh.
const MOST: u64 = 2 << 30;

/// The content security policy of the page: nothing from other origins.
const POLICY: &str = "default-src 'none'; script-src 'self'; worker-src 'self'; \
    style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; connect-src 'self'; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Answers requests.
pub(super) struct Answers {
    pub port: u16,
    pub token: String,
    pub folder: Arc<Folder>,
    pub pages: Pages,
}

/// A body and its type; or a status and the reason.
type Answer = Result<(Vec<u8>, &'static str), (u16, String)>;

const JSON: &str = "application/json";
const BYTES: &str = "application/octet-stream";

impl Answers {
    /// Answers a request.
    pub fn answer(&self, mut request: Request) {
        let answer = self.answer_to(&mut request);
        let (status, (body, kind)) = match answer {
            Ok(answer) => (200, answer),
            Err((status, why)) => (status, (why.into_bytes(), "text/plain; charset=utf-8")),
        };
        let headers = [
            ("Content-Type", kind),
            ("Content-Security-Policy", POLICY),
            ("X-Content-Type-Options", "nosniff"),
            ("Referrer-Policy", "no-referrer"),
            ("Cache-Control", "no-store"),
        ];
        let mut response = Response::from_data(body).with_status_code(StatusCode(status));
        for (name, value) in headers {
            if let Ok(header) = Header::from_bytes(name, value) {
                response.add_header(header);
            }
        }
        if request.body_length().is_some_and(|bytes| bytes as u64 > MOST) {
            // Where a request is dropped, tiny_http makes room for all of the body that is left.
            std::mem::forget(request.upgrade("none", response));
            return;
        }
        // A page that has disconnected needs no answer.
        let _ = request.respond(response);
    }

    fn answer_to(&self, request: &mut Request) -> Answer {
        let refused = |why: &str| Err((403, why.to_owned()));
        let header = |name: &'static str| {
            let mut headers = request.headers().iter();
            headers.find(|header| header.field.equiv(name)).map(|header| header.value.to_string())
        };
        let hosts = [format!("127.0.0.1:{}", self.port), format!("localhost:{}", self.port)];
        if !header("Host").is_some_and(|host| hosts.contains(&host)) {
            return refused("another host");
        }
        let is_own = |origin: String| {
            origin.strip_prefix("http://").is_some_and(|origin| hosts.iter().any(|it| it == origin))
        };
        if !header("Origin").is_none_or(is_own) {
            return refused("another origin");
        }
        let url = request.url().to_owned();
        let path = url.split('?').next().unwrap_or("");
        let inside = path.strip_prefix('/').and_then(|path| path.strip_prefix(&self.token));
        let Some(asked) = inside.and_then(|path| path.strip_prefix('/')).map(str::to_owned) else {
            return refused(
                "the address is not complete: open the one that `hedgerow play` prints",
            );
        };
        if request.body_length().is_some_and(|bytes| bytes as u64 > MOST) {
            return Err((413, "the question is too large".to_owned()));
        }
        let mut body = Vec::new();
        let read = request.as_reader().take(MOST).read_to_end(&mut body);
        read.map_err(|error| (400, error.to_string()))?;
        let nothing = || (404, "nothing here".to_owned());
        if matches!(request.method(), Method::Get | Method::Head) {
            return match asked.as_str() {
                "" | "index.html" => {
                    // Who asks for the head alone opens no page.
                    let opens = *request.method() == Method::Get;
                    let number = if opens { self.pages.open() } else { 0 };
                    page::index(&format!("/{}/{number}/", self.token))
                }
                name => page::file(name),
            }
            .ok_or_else(nothing);
        }
        // The path begins with the number that the page was served with.
        let (number, asked) = asked.split_once('/').ok_or_else(nothing)?;
        let number = number.parse().map_err(|_| nothing())?;
        let engine = || {
            let engine = self.pages.engine(number);
            engine.ok_or_else(|| (410, "too many pages were opened since: reload it".to_owned()))
        };
        let ended = || (500, "it has ended".to_owned());
        match (request.method(), asked) {
            (Method::Post, "ask") => {
                let question = Message::read(&body).map_err(|why| (400, why))?;
                Some((engine()?.ask(question).ok_or_else(ended)?.write(), BYTES))
            }
            (Method::Post, "lsp") => {
                let messages = serde_json::from_slice(&body);
                let messages = messages.map_err(|error| (400, error.to_string()))?;
                Some((engine()?.speak(messages).ok_or_else(ended)?.into_bytes(), JSON))
            }
            (Method::Post, "progress") => {
                let [done, total] = engine()?.progress();
                Some((Message::of(json!({ "done": done, "total": total })).write(), BYTES))
            }
            (Method::Post, "stop") => {
                engine()?.stop();
                Some((Vec::new(), BYTES))
            }
            (Method::Post, "close") => {
                self.pages.close(number);
                Some((Vec::new(), BYTES))
            }
            (Method::Post, "start") => Some((self.start().write(), BYTES)),
            (Method::Post, "files") => Some((self.files().write(), BYTES)),
            (Method::Post, "open") => {
                Some((self.open(&body).unwrap_or_else(Message::error).write(), BYTES))
            }
            (Method::Post, "save") => {
                Some((self.save(&body).unwrap_or_else(Message::error).write(), BYTES))
            }
            _ => None,
        }
        .ok_or_else(nothing)
    }

    /// The folder, and the program and the mesh that the page begins with: if no program was given,
    /// the first of the folder.
    fn start(&self) -> Message {
        let Folder { path, program, mesh } = &*self.folder;
        let program = program.clone().or_else(|| {
            let [programs, _] = self.folder.list();
            programs.into_iter().next()
        });
        Message::of(json!({
            "folder": path.display().to_string().replace('\\', "/"),
            "uri": uri::of_path(path).0,
            "program": program,
            "mesh": mesh,
        }))
    }

    /// The files of the folder.
    fn files(&self) -> Message {
        let [programs, meshes] = self.folder.list();
        Message::of(json!({ "programs": programs, "meshes": meshes }))
    }

    /// A program of the folder.
    fn open(&self, body: &[u8]) -> Result<Message, String> {
        let Named { name, .. } = serde_json::from_slice(body).map_err(|why| why.to_string())?;
        let text = self.folder.program(&name)?;
        Ok(Message::of(json!({ "name": name, "text": text })))
    }

    /// Writes a program to the folder.
    fn save(&self, body: &[u8]) -> Result<Message, String> {
        let Named { name, was, text } =
            serde_json::from_slice(body).map_err(|why| why.to_string())?;
        self.folder.save(&name, was.as_deref(), &text)?;
        Ok(Message::of(json!({ "saved": name })))
    }
}

/// A program by its name; to write it, with its new text and the text it had.
#[derive(Deserialize)]
struct Named {
    name: String,
    #[serde(default)]
    was: Option<String>,
    #[serde(default)]
    text: String,
}
