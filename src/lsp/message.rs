//! Messages on a stream: a header, and a body of JSON.
//!
//! An invalid header ends the conversation, since the beginning of the next message is unknown. The
//! length of an invalid body is known, so it is answered with an error, and the conversation goes
//! on.

use std::io::{self, BufRead, Read, Write};

use lsp_server::{ErrorCode, Message};
use serde_json::{Value, json};

/// The longest line of a header that is read, in bytes.
const LONGEST_HEADER: u64 = 4096;

/// The input: a message, or something else.
#[derive(Debug)]
pub enum Heard {
    /// A message.
    Message(Message),
    /// An invalid message, and the error that answers it.
    Refused(Spoken),
}

/// The output: a message, or an error.
#[derive(Debug)]
pub enum Spoken {
    /// A message.
    Message(Message),
    /// An error about an invalid message. Its id may be one that no request can have.
    Error { id: Value, code: ErrorCode, why: String },
}

impl Spoken {
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
/// Fails if the stream breaks, or a header is missing or invalid.
pub fn read(input: &mut impl BufRead) -> io::Result<Option<Heard>> {
    let Some(body) = body(input)? else { return Ok(None) };
    Ok(Some(match serde_json::from_slice(&body) {
        Ok(value) => message(value),
        Err(error) => {
            let why = format!("the message cannot be read: {error}");
            Heard::Refused(Spoken::Error { id: Value::Null, code: ErrorCode::ParseError, why })
        }
    }))
}

/// The bytes of the next body. Memory is taken only for bytes that have arrived, whatever length
/// the header claims.
fn body(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
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
    let mut body = Vec::new();
    if (input.take(length).read_to_end(&mut body)? as u64) < length {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    Ok(Some(body))
}

/// A value as a message, or the error that answers it.
fn message(value: Value) -> Heard {
    let refused = |id: Value, why: &str| {
        Heard::Refused(Spoken::Error { id, code: ErrorCode::InvalidRequest, why: why.to_owned() })
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
        Ok(message) => Heard::Message(message),
        Err(_) => {
            let why = "this is neither a request nor a notification nor an answer";
            refused(id.unwrap_or_default(), why)
        }
    }
}
