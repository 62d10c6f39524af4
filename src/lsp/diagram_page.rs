//! A page on this machine that shows the diagram under the cursor, for any editor.
//!
//! It listens on the loopback address only, on a port that the system chooses, and serves two
//! things: the page, and what it shows now. Requests with the `Host` of another machine are
//! refused, so that no web page can read along.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use serde::Serialize;

/// The most bytes of a request that are read.
const LONGEST_REQUEST: u64 = 16 * 1024;
/// The timeout for reading a request and for writing its answer.
const PATIENCE: Duration = Duration::from_secs(5);

/// The content of the page.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub(super) struct Shown {
    /// The name of the op.
    pub(super) title: String,
    pub(super) verdict: String,
    /// The picture.
    pub(super) svg: String,
}

/// The content, and the number of its changes.
#[derive(Debug, Default)]
struct Current {
    count: u64,
    shown: Shown,
}

#[derive(Debug)]
pub(super) struct DiagramPage {
    address: SocketAddr,
    current: Arc<Mutex<Current>>,
}

impl DiagramPage {
    /// Opens the page.
    pub(super) fn open() -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
        let address = listener.local_addr()?;
        let current: Arc<Mutex<Current>> = Arc::default();
        let shared = Arc::clone(&current);
        std::thread::Builder::new().name("preview".into()).spawn(move || {
            for stream in listener.incoming().flatten() {
                let shared = Arc::clone(&shared);
                // A slow client does not block the others.
                let answered = std::thread::Builder::new().spawn(move || {
                    // A client that has disconnected needs no answer.
                    let _ = answer(stream, address, &shared);
                });
                drop(answered);
            }
        })?;
        Ok(Self { address, current })
    }

    pub(super) fn address(&self) -> String {
        format!("http://{}/", self.address)
    }

    /// Replaces the content.
    pub(super) fn show(&self, shown: Shown) {
        let mut current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
        if current.shown != shown {
            current.count += 1;
            current.shown = shown;
        }
    }
}

fn answer(mut stream: TcpStream, address: SocketAddr, current: &Mutex<Current>) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let mut reader = BufReader::new(stream.try_clone()?.take(LONGEST_REQUEST));
    let mut line = String::new();
    reader.read_line(&mut line)?;
    let mut words = line.split_whitespace();
    let (method, path) = (words.next().unwrap_or(""), words.next().unwrap_or(""));
    let mut host = String::new();
    loop {
        let mut header = String::new();
        if reader.read_line(&mut header)? == 0 || header.trim().is_empty() {
            break;
        }
        if let Some((name, value)) = header.split_once(':')
            && name.eq_ignore_ascii_case("host")
        {
            host = value.trim().to_owned();
        }
    }
    let port = address.port();
    let is_own = [format!("127.0.0.1:{port}"), format!("localhost:{port}")].contains(&host);
    let (status, kind, body) = match (is_own, method, path.split('?').next().unwrap_or("")) {
        (false, _, _) => ("403 Forbidden", "text/plain", "another host".to_owned()),
        (true, "GET", "/") => ("200 OK", "text/html; charset=utf-8", PAGE.to_owned()),
        (true, "GET", "/shown") => {
            let seen = path.split_once("seen=").and_then(|(_, seen)| seen.parse().ok());
            ("200 OK", "application/json", shown(current, seen))
        }
        _ => ("404 Not Found", "text/plain", "nothing here".to_owned()),
    };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n\
         Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n\
         Content-Security-Policy: default-src 'none'; style-src 'unsafe-inline'; \
         script-src 'unsafe-inline'; connect-src 'self'\r\nConnection: close\r\n\r\n{body}",
        body.len()
    )
}

/// The current content; for a page that has it, only its number.
fn shown(current: &Mutex<Current>, seen: Option<u64>) -> String {
    let current = current.lock().unwrap_or_else(PoisonError::into_inner);
    let shown = (seen != Some(current.count)).then_some(&current.shown);
    serde_json::json!({ "count": current.count, "shown": shown }).to_string()
}

const PAGE: &str = include_str!("diagram_page.html");
