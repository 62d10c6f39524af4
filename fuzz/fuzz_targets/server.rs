//! A client that says anything at all: the server answers, or ends with the stream.
//!
//! Each line of the input is the body of a message; the header is written here, since a wrong one
//! ends the conversation. The first line that begins with `#` is a raw stream instead.
#![no_main]

use hedgerow::analysis::Nowhere;
use hedgerow::lsp::serve_on;
use libfuzzer_sys::fuzz_target;

const HELLO: &str = r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}"#;

fuzz_target!(|bytes: &[u8]| {
    let mut said = format!("Content-Length: {}\r\n\r\n{HELLO}", HELLO.len()).into_bytes();
    match bytes.strip_prefix(b"#") {
        Some(raw) => said.extend(raw),
        None => {
            for body in bytes.split(|&byte| byte == b'\n') {
                said.extend(format!("Content-Length: {}\r\n\r\n", body.len()).bytes());
                said.extend(body);
            }
        }
    }
    let _ = serve_on(said.as_slice(), Vec::new(), Box::new(Nowhere));
});
