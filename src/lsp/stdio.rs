//! The server on standard input and output.

use std::io::{self, BufRead, Read, stdin, stdout};
use std::thread::{self, JoinHandle};

use lsp_server::{Connection, Message};

use super::disk::Disk;
use super::server::Server;

/// The longest line of a header that is read, in bytes.
const LONGEST_HEADER: u64 = 4096;

/// Speaks the protocol until the client says that it is enough.
///
/// # Errors
///
/// Fails if a stream breaks, or carries something else than the protocol.
pub fn serve() -> io::Result<u8> {
    let (connection, client) = Connection::memory();
    let (said, heard) = (client.sender, client.receiver);
    let writer = thread::spawn(move || {
        let mut messages = heard.into_iter();
        messages.try_for_each(|message| message.write(&mut stdout().lock()))
    });
    let reader = thread::spawn(move || {
        let mut input = stdin().lock();
        while let Some(message) = read(&mut input)? {
            let is_exit = matches!(&message, Message::Notification(told) if told.method == "exit");
            if said.send(message).is_err() || is_exit {
                break;
            }
        }
        Ok(())
    });
    let code = converse(&connection);
    drop(connection);
    // Where nothing can be written any more, nobody waits for what is still read.
    ended(writer)?;
    ended(reader)?;
    Ok(code)
}

fn ended(thread: JoinHandle<io::Result<()>>) -> io::Result<()> {
    let done = thread.join();
    done.unwrap_or_else(|_| Err(io::Error::other("a stream was given up")))
}

/// Reads a message; `None` at the end. However long it claims to be, there is no more room
/// taken for it than has come.
fn read(input: &mut impl BufRead) -> io::Result<Option<Message>> {
    let invalid = |text: String| io::Error::new(io::ErrorKind::InvalidData, text);
    let mut length = None;
    let mut line = String::new();
    loop {
        line.clear();
        if input.take(LONGEST_HEADER).read_line(&mut line)? == 0 {
            return Ok(None);
        }
        let malformed = || invalid(format!("malformed header: {line:?}"));
        let text = line.strip_suffix("\r\n").ok_or_else(malformed)?;
        if text.is_empty() {
            break;
        }
        let (name, value) = text.split_once(": ").ok_or_else(malformed)?;
        if name.eq_ignore_ascii_case("Content-Length") {
            length = Some(value.parse::<u64>().map_err(|_| malformed())?);
        }
    }
    let length = length.ok_or_else(|| invalid("no Content-Length".to_owned()))?;
    let mut text = Vec::new();
    if (input.take(length).read_to_end(&mut text)? as u64) < length {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    serde_json::from_slice(&text).map(Some).map_err(io::Error::from)
}

/// Answers until the client is gone; the exit code says whether it took its leave.
fn converse(connection: &Connection) -> u8 {
    let mut server = Server::new(Box::new(Disk));
    loop {
        // All that waits is taken in first, so that a cancellation is seen in time.
        while let Ok(message) = connection.receiver.try_recv() {
            server.accept(message);
        }
        match server.work() {
            Some(messages) => {
                for message in messages {
                    if connection.sender.send(message).is_err() {
                        return 1;
                    }
                }
            }
            None => match connection.receiver.recv() {
                Ok(message) => server.accept(message),
                Err(_) => return 1,
            },
        }
        for errand in server.errands() {
            let sender = connection.sender.clone();
            std::thread::spawn(move || {
                for message in errand.run() {
                    // A client that is gone does not want to know.
                    let _ = sender.send(message);
                }
            });
        }
        if let Some(code) = server.exit_code() {
            return code;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(text: &str) -> Result<Option<Message>, String> {
        read(&mut text.as_bytes()).map_err(|error| error.to_string())
    }

    #[test]
    fn messages_are_read_and_nothing_else() {
        let exit = r#"{"jsonrpc":"2.0","method":"exit"}"#;
        let length = exit.len();
        let text = format!("content-length: {length}\r\nContent-Type: x\r\n\r\n{exit}{exit}");
        let Ok(Some(Message::Notification(told))) = first(&text) else {
            panic!("it is a notification");
        };
        assert_eq!(told.method, "exit");
        assert!(matches!(first(""), Ok(None)));
        for (text, wanted) in [
            ("Content-Length: 99999999999999\r\n\r\n{}", "unexpected end"),
            ("Content-Length: -1\r\n\r\n{}", "malformed header"),
            ("Content-Length: 2\n\n{}", "malformed header"),
            ("hello\r\n\r\n", "malformed header"),
            ("Content-Type: x\r\n\r\n{}", "no Content-Length"),
            ("Content-Length: 2\r\n\r\n{]", "line 1"),
        ] {
            let told = first(text).expect_err(text);
            assert!(told.contains(wanted), "{told}");
        }
        let endless = "x".repeat(10_000);
        assert!(first(&endless).is_err());
    }
}
