//! The server on standard input and output.

use std::io;

use lsp_server::Connection;

use super::disk::Disk;
use super::server::Server;

/// Speaks the protocol until the client says that it is enough.
///
/// # Errors
///
/// Fails if a stream breaks, or carries something else than the protocol.
pub fn serve() -> io::Result<u8> {
    let (connection, threads) = Connection::stdio();
    let code = converse(&connection);
    drop(connection);
    threads.join()?;
    Ok(code)
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
