//! `hedgerow play`: the page in a browser, served by this process.
//!
//! The server listens on loopback only, by default at a port that the system chooses. Its address
//! contains a token that cannot be guessed; requests without it, or with a foreign `Host` or
//! `Origin`, are refused. It serves programs and meshes of one folder, and writes programs there
//! when the page asks for it: none that has changed since the page opened it, and none over
//! another. Each page that is opened has a workbench and a language server of its own.

mod answers;
mod engine;
mod folder;
mod page;
mod pages;

use std::io::{Write, stdout};
use std::sync::Arc;
use std::thread;

use tiny_http::Server;

use super::arguments::PlayArguments;
use super::failure::Failure;
use super::output::eprint_line;
use answers::Answers;
use folder::Folder;
use pages::Pages;

/// Serves the page until Ctrl-C.
pub(super) fn play(arguments: &PlayArguments) -> Result<(), Failure> {
    if page::files().is_empty() {
        return Err(Failure::usage(
            "this hedgerow was built without its page: run `npm ci` and `node build.js \
             --without-wasm` in the folder `web`, and build it again",
        ));
    }
    let folder = Arc::new(Folder::of(&arguments.files).map_err(Failure::usage)?);
    let failed = |error: &dyn std::fmt::Display| {
        Failure::usage(format!("the page cannot be served: {error}"))
    };
    let server = Server::http(("127.0.0.1", arguments.port)).map_err(|error| failed(&error))?;
    let port = server.server_addr().to_ip().map_or(0, |address| address.port());
    let token = token().map_err(|error| failed(&error))?;
    let address = format!("http://127.0.0.1:{port}/{token}/");
    let pages = Pages::new(Arc::clone(&folder));
    let answers = Arc::new(Answers { port, token, folder, pages });
    // For programs that have started this one; people read it as well.
    let _ = writeln!(stdout(), "{address}").and_then(|()| stdout().flush());
    if !arguments.no_browser && open::that_detached(&address).is_err() {
        eprint_line("no browser could be opened: open the address above");
    }
    eprint_line("Ctrl-C ends it");
    loop {
        let request = server.recv().map_err(|error| failed(&error))?;
        // Each connection has a thread already, and may keep this one waiting for its body as well.
        let answers = Arc::clone(&answers);
        // If no thread can be had, the request is dropped, which answers it as well.
        let _ = thread::Builder::new().spawn(move || answers.answer(request));
    }
}

/// 128 random bits in hexadecimal, which cannot be guessed.
fn token() -> Result<String, getrandom::Error> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
