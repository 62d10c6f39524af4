//! What is no message gets its error, and the conversation goes on.

use hedgerow::analysis::Nowhere;
use hedgerow::lsp::serve_on;
use serde_json::{Value, json};

/// A body with its header.
fn framed(body: &str) -> String {
    format!("Content-Length: {}\r\n\r\n{body}", body.len())
}

/// The bodies of what a server answers, and its exit code.
fn conversation(bodies: &[&str]) -> (Vec<Value>, u8) {
    let said: String = bodies.iter().map(|body| framed(body)).collect();
    let mut heard = Vec::new();
    let code =
        serve_on(said.as_bytes(), &mut heard, Box::new(Nowhere)).expect("no header is broken");
    let heard = String::from_utf8(heard).expect("it is a text");
    let parts = heard.split("Content-Length: ").skip(1);
    let bodies = parts.map(|part| {
        let (length, body) = part.split_once("\r\n\r\n").expect("a header ends");
        assert_eq!(length.parse(), Ok(body.len()));
        serde_json::from_str(body).expect("a body is JSON")
    });
    (bodies.collect(), code)
}

#[test]
fn what_is_no_message_gets_its_error() {
    let request = |id: Value, method: &str| {
        json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": { "capabilities": {} } })
            .to_string()
    };
    let hello = request(json!(1), "initialize");
    let half = request(json!(1.5), "shutdown");
    let batch = format!("[{}]", request(json!(2), "shutdown"));
    let bye = request(json!(3), "shutdown");
    let exit = json!({ "jsonrpc": "2.0", "method": "exit" }).to_string();
    let (told, code) =
        conversation(&["{\"id\":", &hello, "17", &half, &batch, "\u{0}", &bye, &exit]);
    let answers =
        told.iter().filter(|told| told.get("id").is_some() && told.get("method").is_none());
    let answers = answers.map(|told| (told["id"].clone(), told["error"]["code"].clone()));
    let none = Value::Null;
    assert_eq!(
        answers.collect::<Vec<_>>(),
        [
            (none.clone(), json!(-32700)),
            (json!(1), none.clone()),
            (none.clone(), json!(-32600)),
            (json!(1.5), json!(-32600)),
            (none.clone(), json!(-32600)),
            (none.clone(), json!(-32700)),
            (json!(3), none),
        ]
    );
    assert_eq!(code, 0);
}
