//! Questions and answers as bytes: JSON, and binary data after it.

use serde_json::{Value, json};

/// JSON with binary data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Message {
    /// The question, or the answer.
    pub json: Value,
    /// Numbers, one after the other, little-endian; or a file.
    pub bytes: Vec<u8>,
}

impl Message {
    /// JSON alone.
    pub fn of(json: Value) -> Self {
        Self { json, bytes: Vec::new() }
    }

    /// An answer that reports an error.
    pub fn error(why: impl Into<String>) -> Self {
        Self::of(json!({ "error": why.into() }))
    }

    /// Reads the length of the JSON in four bytes, little-endian, the JSON, and the rest.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        let short = || "the message is too short".to_owned();
        let (length, rest) = bytes.split_first_chunk::<4>().ok_or_else(short)?;
        let length = u32::from_le_bytes(*length) as usize;
        let (text, bytes) = rest.split_at_checked(length).ok_or_else(short)?;
        let json = serde_json::from_slice(text).map_err(|error| error.to_string())?;
        Ok(Self { json, bytes: bytes.to_vec() })
    }

    /// The bytes that [`read`](Self::read) takes.
    pub fn write(&self) -> Vec<u8> {
        let text = self.json.to_string();
        let mut all = Vec::with_capacity(4 + text.len() + self.bytes.len());
        all.extend((text.len() as u32).to_le_bytes());
        all.extend(text.as_bytes());
        all.extend(&self.bytes);
        all
    }
}
