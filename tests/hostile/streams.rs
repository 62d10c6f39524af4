//! What is no message gets its error, and the conversation goes on.

use hedgerow::analysis::Nowhere;
use hedgerow::lsp::serve_on;
use serde_json::{Value, json};

use support::dice::Dice;

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

/// What stands where something else was meant.
const ODD: &[&str] = &[
    "null",
    "-1",
    "1.5",
    "4294967296",
    "4294967295",
    "\"\"",
    "\"file:///b%ff\"",
    "[]",
    "{}",
    "true",
    "[[]]",
];

/// How many values there are in a value, itself among them.
fn size(value: &Value) -> usize {
    1 + match value {
        Value::Array(all) => all.iter().map(size).sum(),
        Value::Object(all) => all.values().map(size).sum::<usize>(),
        _ => 0,
    }
}

/// Puts another value in the place of the `at`-th.
fn exchange(value: &mut Value, at: &mut usize, other: &Value) {
    if *at == 0 {
        *value = other.clone();
    }
    *at = at.wrapping_sub(1);
    match value {
        Value::Array(all) => all.iter_mut().for_each(|inner| exchange(inner, at, other)),
        Value::Object(all) => all.values_mut().for_each(|inner| exchange(inner, at, other)),
        _ => {}
    }
}

#[test]
fn a_client_may_say_anything() {
    let text = std::fs::read_to_string("examples/flip.hedge").expect("it is shipped");
    let uri = "file:///a.hedge";
    let document = json!({ "uri": uri });
    let place = json!({ "line": 3, "character": 7 });
    let range = json!({ "start": place, "end": { "line": 4, "character": 1 } });
    let asked = |method: &str| {
        json!({ "jsonrpc": "2.0", "id": 7, "method": method, "params": {
            "textDocument": document, "position": place, "range": range, "positions": [place],
            "newName": "z", "query": "f", "options": { "tabSize": 2, "insertSpaces": true },
            "context": { "diagnostics": [], "includeDeclaration": true },
            "command": "hedgerow.runTest", "arguments": [uri, "f"] } })
    };
    let told = |method: &str, params: Value| json!({ "jsonrpc": "2.0", "method": method, "params": params });
    let item = json!({ "uri": uri, "languageId": "hedgerow", "version": 1, "text": text });
    let open = told("textDocument/didOpen", json!({ "textDocument": item }));
    let methods = [
        "textDocument/hover",
        "textDocument/definition",
        "textDocument/references",
        "textDocument/documentHighlight",
        "textDocument/prepareRename",
        "textDocument/rename",
        "textDocument/documentSymbol",
        "workspace/symbol",
        "textDocument/foldingRange",
        "textDocument/selectionRange",
        "textDocument/semanticTokens/full",
        "textDocument/semanticTokens/range",
        "textDocument/inlayHint",
        "textDocument/documentLink",
        "textDocument/codeAction",
        "textDocument/completion",
        "textDocument/signatureHelp",
        "textDocument/codeLens",
        "textDocument/formatting",
        "textDocument/rangeFormatting",
        "textDocument/diagnostic",
        "workspace/executeCommand",
        "hedgerow/diagram",
    ];
    let mut all: Vec<Value> = methods.iter().map(|method| asked(method)).collect();
    all.extend([
        open.clone(),
        told(
            "textDocument/didChange",
            json!({ "textDocument": { "uri": uri, "version": 2 },
            "contentChanges": [{ "range": range, "text": "x" }, { "text": text }] }),
        ),
        told("textDocument/didClose", json!({ "textDocument": document })),
        told("$/cancelRequest", json!({ "id": 7 })),
        told(
            "workspace/didChangeConfiguration",
            json!({ "settings": { "hover": { "picture": "svg" } } }),
        ),
        told("hedgerow/cursor", json!({ "textDocument": document, "position": place })),
        told("hedgerow/files", json!({ "files": [{ "uri": uri, "text": text }, { "uri": uri }] })),
        json!({ "jsonrpc": "2.0", "id": "hedgerow-1", "result": [null] }),
    ]);
    let hello = json!({ "jsonrpc": "2.0", "id": 1, "method": "initialize", "params": { "capabilities": {} } });
    let mut dice = Dice(0x2545_F491_4F6C_DD1D);
    let mut answered = 0;
    for _ in 0..60 {
        let mut said = vec![hello.to_string(), open.to_string()];
        for _ in 0..12 {
            let mut body = all[dice.below(all.len())].clone();
            for _ in 0..dice.below(3) {
                let other = serde_json::from_str(ODD[dice.below(ODD.len())]).expect("it is JSON");
                let mut at = dice.below(size(&body));
                exchange(&mut body, &mut at, &other);
            }
            said.push(body.to_string());
        }
        let said: Vec<&str> = said.iter().map(String::as_str).collect();
        let (told, _) = conversation(&said);
        answered += told.iter().filter(|told| told.get("id").is_some()).count();
    }
    assert!(answered > 200, "only {answered} answers");
}
