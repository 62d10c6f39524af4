//! The server on streams: on standard input and output, or on any two.

use std::io::{self, BufRead, Write, stdin, stdout};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::thread::{self, JoinHandle};

use lsp_server::Message;

use super::message::{Incoming, Outgoing, read};
use super::server::Server;
use crate::analysis::{Disk, Reader};

/// Serves a client on standard input and output until it exits or disconnects; returns the exit
/// code.
///
/// # Errors
///
/// Fails if a stream breaks, or ends within a body.
pub fn serve() -> io::Result<u8> {
    let (sender, incoming) = channel();
    let (outgoing, receiver) = channel::<Outgoing>();
    let writer = thread::spawn(move || {
        receiver.into_iter().try_for_each(|message| message.write(&mut stdout().lock()))
    });
    let reader = thread::spawn(move || {
        let mut input = stdin().lock();
        while let Some(message) = read(&mut input)? {
            let is_exit = matches!(&message, Incoming::Message(Message::Notification(told)) if told.method == "exit");
            if sender.send(message).is_err() || is_exit {
                break;
            }
        }
        Ok(())
    });
    let code = serve_messages(&incoming, &outgoing);
    drop((incoming, outgoing));
    // If writing has failed, the reader is not waited for.
    ended(writer)?;
    ended(reader)?;
    Ok(code)
}

/// Serves a client on two streams: a message is read when all work on those before is done. The
/// reader gives the files that no client has open; commands are not run.
///
/// # Errors
///
/// Fails if a stream breaks, or ends within a body.
pub fn serve_on(
    mut input: impl BufRead,
    mut output: impl Write,
    reader: Box<dyn Reader>,
) -> io::Result<u8> {
    let mut server = Server::new(reader);
    while let Some(incoming) = read(&mut input)? {
        match incoming {
            Incoming::Message(message) => server.accept(message),
            Incoming::Refused(answer) => answer.write(&mut output)?,
        }
        while let Some(messages) = server.work() {
            for message in messages {
                message.write(&mut output)?;
            }
        }
        server.take_subprocesses();
        if let Some(code) = server.exit_code() {
            return Ok(code);
        }
    }
    Ok(1)
}

fn ended(thread: JoinHandle<io::Result<()>>) -> io::Result<()> {
    thread.join().unwrap_or_else(|_| Err(io::Error::other("a stream was given up")))
}

/// Serves a client until it exits or disconnects; the exit code is 0 if it sent `shutdown` before
/// `exit`.
fn serve_messages(incoming: &Receiver<Incoming>, outgoing: &Sender<Outgoing>) -> u8 {
    let mut server = Server::new(Box::new(Disk));
    let mut idle = false;
    loop {
        // All waiting messages are taken in first, so that a cancellation takes effect in time.
        let next = match idle {
            true => incoming.recv().map_err(|_| TryRecvError::Disconnected),
            false => incoming.try_recv(),
        };
        let answers = match next {
            Ok(Incoming::Message(message)) => {
                server.accept(message);
                Some(Vec::new())
            }
            Ok(Incoming::Refused(answer)) => Some(vec![answer]),
            Err(TryRecvError::Disconnected) if idle => return 1,
            Err(_) => {
                let answers = server.work();
                answers.map(|answers| answers.into_iter().map(Outgoing::Message).collect())
            }
        };
        idle = answers.is_none();
        if answers.into_iter().flatten().any(|message| outgoing.send(message).is_err()) {
            return 1;
        }
        for subprocess in server.take_subprocesses() {
            let outgoing = outgoing.clone();
            thread::spawn(move || {
                for message in subprocess.run() {
                    // A client that has disconnected needs no answer.
                    let _ = outgoing.send(Outgoing::Message(message));
                }
            });
        }
        if let Some(code) = server.exit_code() {
            return code;
        }
    }
}
