//! `hedgerow play`: the page of a browser, with this process behind it.
//!
//! The server listens on loopback only, at a port that the system chooses. Its address holds a token
//! that nobody can guess; without it, or with a foreign `Host` or `Origin`, nothing is answered. It
//! reads programs and meshes of one folder, and writes nothing but the program that it was started
//! with, when the page asks for it.

mod answers;
mod engine;
mod page;

use std::io::{Write, stdout};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;

use tiny_http::Server;

use super::arguments::PlayArguments;
use super::failure::Failure;
use super::output::complain;
use answers::Answers;
use engine::Engine;

/// The number of requests that are answered at the same time: one runs, others ask how far it is.
const THREADS: usize = 4;

/// The files that the page begins with.
#[derive(Clone, Debug, Default)]
pub(super) struct Opened {
    pub program: Option<PathBuf>,
    pub mesh: Option<PathBuf>,
}

/// Serves the page until Ctrl-C.
pub(super) fn play(arguments: &PlayArguments) -> Result<(), Failure> {
    if page::files().is_empty() {
        return Err(Failure::usage(
            "this hedgerow was built without its page: run `npm ci` and `node build.js \
             --without-wasm` in the folder `web`, and build it again",
        ));
    }
    let opened = opened(&arguments.files)?;
    let failed = |error: &dyn std::fmt::Display| {
        Failure::usage(format!("the page cannot be served: {error}"))
    };
    let server = Server::http(("127.0.0.1", arguments.port)).map_err(|error| failed(&error))?;
    let port = server.server_addr().to_ip().map_or(0, |address| address.port());
    let token = token().map_err(|error| failed(&error))?;
    let address = format!("http://127.0.0.1:{port}/{token}/");
    let answers = Answers { port, token, opened, engine: Engine::start() };
    let (server, answers) = (Arc::new(server), Arc::new(answers));
    let threads = (0..THREADS).map(|_| {
        let (server, answers) = (Arc::clone(&server), Arc::clone(&answers));
        thread::spawn(move || server.incoming_requests().for_each(|it| answers.answer(it)))
    });
    let threads: Vec<_> = threads.collect();
    // For programs that have started this one; people read it as well.
    let _ = writeln!(stdout(), "{address}").and_then(|()| stdout().flush());
    if !arguments.no_browser && open::that_detached(&address).is_err() {
        complain("no browser could be opened: open the address above");
    }
    complain("Ctrl-C ends it");
    for thread in threads {
        let _ = thread.join();
    }
    Ok(())
}

/// The program and the mesh among some files.
fn opened(files: &[PathBuf]) -> Result<Opened, Failure> {
    let mut opened = Opened::default();
    for file in files {
        let place = match file.extension().is_some_and(|ending| ending == "hedge") {
            true => &mut opened.program,
            false => &mut opened.mesh,
        };
        if !Path::new(file).is_file() {
            return Err(Failure::usage(format!(
                "cannot read `{}`: there is no such file",
                file.display()
            )));
        }
        if place.replace(file.clone()).is_some() {
            return Err(Failure::usage("one program and one mesh can be opened, not more"));
        }
    }
    Ok(opened)
}

/// 128 bits that nobody can guess, as letters.
fn token() -> Result<String, getrandom::Error> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
