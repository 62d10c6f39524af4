//! Messages on a stream: a header, and a body of JSON.
//!
//! A header is read leniently, and lines that are none are skipped. An invalid length or body is
//! answered with an error, and the conversation goes on with the next `Content-Length`.

use std::io::{self, BufRead, Read, Write};

use lsp_server::{ErrorCode, Message};
use serde_json::{Value, json};

/// The longest line of a header that is kept, in bytes.
const LONGEST_HEADER: u64 = 4096;
/// The bytes kept of the end of a longer line, which may be a header after the rest of a body.
const KEPT: usize = 64;

/// The input: a message, or something else.
#[derive(Debug)]
pub enum Incoming {
    /// A message.
    Message(Message),
    /// An invalid message, and the error that answers it.
    Refused(Outgoing),
}

/// The output: a message, or an error.
#[derive(Debug)]
pub enum Outgoing {
    /// A message.
    Message(Message),
    /// An error about an invalid message. Its id may be one that no request can have.
    Error { id: Value, code: ErrorCode, why: String },
}

impl Outgoing {
    /// Writes it, with its header.
    pub fn write(&self, output: &mut impl Write) -> io::Result<()> {
        match self {
            Self::Message(message) => message.write(output),
            Self::Error { id, code, why } => {
                let error = json!({ "code": *code as i32, "message": why });
                let body = json!({ "jsonrpc": "2.0", "id": id, "error": error }).to_string();
                write!(output, "Content-Length: {}\r\n\r\n{body}", body.len())?;
                output.flush()
            }
        }
    }
}

/// Reads the next message; `None` at the end.
///
/// # Errors
///
/// Fails if the stream breaks, or ends within a body.
pub fn read(input: &mut impl BufRead) -> io::Result<Option<Incoming>> {
    let refused = |why: String| {
        Incoming::Refused(Outgoing::Error { id: Value::Null, code: ErrorCode::ParseError, why })
    };
    let length = match length(input)? {
        None => return Ok(None),
        Some(Err(why)) => return Ok(Some(refused(why))),
        Some(Ok(length)) => length,
    };
    // Memory is taken only for bytes that have arrived, whatever length the header claims.
    let mut body = Vec::new();
    if (input.take(length).read_to_end(&mut body)? as u64) < length {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    Ok(Some(match serde_json::from_slice(&body) {
        Ok(value) => message(value),
        Err(error) => refused(format!("the message cannot be read: {error}")),
    }))
}

/// The length of the next body, which follows, or why the header has none; `None` at the end.
fn length(input: &mut impl BufRead) -> io::Result<Option<Result<u64, String>>> {
    let mut length = None;
    while let Some(line) = line(input)? {
        if let Some(value) = claimed_length(&line) {
            // No message is larger than 4 GB.
            match value.parse::<u32>() {
                Ok(value) => length = Some(value.into()),
                Err(_) => return Ok(Some(Err(format!("`{value}` is not a length of a message")))),
            }
        } else if let (Some(length), true) = (length, line.trim_ascii().is_empty()) {
            return Ok(Some(Ok(length)));
        }
    }
    Ok(None)
}

/// The next line, or the end of a long one; `None` at the end.
fn line(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut line = Vec::new();
    loop {
        let count = input.take(LONGEST_HEADER).read_until(b'\n', &mut line)?;
        if count == 0 || line.ends_with(b"\n") {
            return Ok((!line.is_empty()).then_some(line));
        }
        line.drain(..line.len().saturating_sub(KEPT));
    }
}

/// The value of `Content-Length` in a line. It may stand behind the rest of a body whose length was
/// invalid.
fn claimed_length(line: &[u8]) -> Option<String> {
    let line = String::from_utf8_lossy(line).to_ascii_lowercase();
    let (before, value) = line.rsplit_once("content-length")?;
    let value = value.trim_ascii_start().strip_prefix(':')?;
    (!before.ends_with('-')).then(|| value.trim_ascii().to_owned())
}

/// A value as a message, or the error that answers it.
fn message(value: Value) -> Incoming {
    let refused = |id: Value, why: &str| {
        Incoming::Refused(Outgoing::Error {
            id,
            code: ErrorCode::InvalidRequest,
            why: why.to_owned(),
        })
    };
    let Value::Object(fields) = &value else {
        let why = match value {
            Value::Array(_) => "batches are not taken: send each message by itself",
            _ => "a message is an object",
        };
        return refused(Value::Null, why);
    };
    let id = fields.get("id").cloned();
    let is_id = |id: &Value| match id {
        Value::Number(number) => number.as_i64().is_some_and(|id| i32::try_from(id).is_ok()),
        id => id.is_string(),
    };
    if let Some(id) = id.as_ref().filter(|id| !is_id(id)) {
        // A number is returned as it came, so that the client may recognize it.
        let id = if id.is_number() { id.clone() } else { Value::Null };
        return refused(id, "an id is a text or a whole number of 32 bits");
    }
    match serde_json::from_value(value) {
        Ok(message) => Incoming::Message(message),
        Err(_) => {
            let why = "this is neither a request nor a notification nor an answer";
            refused(id.unwrap_or_default(), why)
        }
    }
}
