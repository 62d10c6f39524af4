//! Whole conversations over the protocol.

use lsp_server::{Message, Notification, Request, RequestId};
use serde_json::{Value, json};

use crate::client::{Client, URI, document};

const BROKEN: &str = "op f(e: edge) { before { face f: v -a-> w -b-> v edge e: a | b } }";

#[test]
fn hello_and_goodbye() {
    let mut client = Client::silent();
    let early = client.request("textDocument/hover", json!({}));
    assert_eq!(early.unwrap_err().0, -32002, "nothing before `initialize`");
    // A client may leave out everything, or say `null`.
    let null = json!({ "processId": null, "rootUri": null, "rootPath": null, "capabilities": null,
        "clientInfo": null, "workspaceFolders": null, "initializationOptions": null, "trace": null });
    let hello = client.request("initialize", null).unwrap();
    assert_eq!(hello["serverInfo"]["name"], "hedgerow");
    assert_eq!(hello["capabilities"]["positionEncoding"], "utf-16");
    assert_eq!(
        client.request("initialize", json!({})).unwrap_err().0,
        -32600
    );
    client.notify("initialized", json!({}));
    assert_eq!(client.request("no/such", json!({})).unwrap_err().0, -32601);
    assert_eq!(
        client
            .request("textDocument/hover", json!(3))
            .unwrap_err()
            .0,
        -32602
    );
    let closed = json!({ "textDocument": document(), "position": { "line": 0, "character": 0 } });
    assert_eq!(
        client.request("textDocument/hover", closed).unwrap_err().0,
        -32602
    );
    assert_eq!(client.request("shutdown", Value::Null), Ok(Value::Null));
    assert_eq!(
        client.request("shutdown", Value::Null).unwrap_err().0,
        -32600
    );
    assert_eq!(client.server.exit_code(), None);
    client.notify("exit", Value::Null);
    assert_eq!(client.server.exit_code(), Some(0));
}

#[test]
fn leaving_without_goodbye_is_a_failure() {
    let mut client = Client::new(json!({ "capabilities": {} }));
    client.notify("exit", Value::Null);
    assert_eq!(client.server.exit_code(), Some(1));
}

#[test]
fn the_encoding_is_one_that_the_client_offers() {
    for (offered, agreed) in [
        (json!(["utf-16", "utf-8"]), "utf-8"),
        (json!(["utf-32"]), "utf-32"),
        (json!(["utf-32", "utf-16"]), "utf-16"),
        (json!([]), "utf-16"),
        (json!(["ebcdic"]), "utf-16"),
    ] {
        let mut client = Client::silent();
        let general = json!({ "positionEncodings": offered });
        let hello = client.request(
            "initialize",
            json!({ "capabilities": { "general": general } }),
        );
        assert_eq!(hello.unwrap()["capabilities"]["positionEncoding"], agreed);
    }
}

#[test]
fn diagnostics_are_published_for_every_version_also_when_there_are_none() {
    let mut client = Client::able("utf-16");
    client.open(BROKEN);
    let published = client.published().unwrap();
    assert_eq!(published["version"], 1);
    assert_eq!(published["diagnostics"][0]["code"], "missing-side");
    let link = published["diagnostics"][0]["codeDescription"]["href"]
        .as_str()
        .unwrap();
    assert!(link.ends_with("#missing-side"), "{link}");
    let change = |version: i32, text: &str| {
        json!({ "textDocument": { "uri": URI, "version": version },
                "contentChanges": [{ "text": text }] })
    };
    client.notify("textDocument/didChange", change(2, "// nothing\n"));
    let published = client.published().unwrap();
    assert_eq!(
        (&published["version"], &published["diagnostics"]),
        (&json!(2), &json!([]))
    );
    client.notify("textDocument/didChange", change(3, BROKEN));
    assert_eq!(client.published().unwrap()["version"], 3);
    client.notify(
        "textDocument/didClose",
        json!({ "textDocument": document() }),
    );
    assert_eq!(client.published().unwrap()["diagnostics"], json!([]));
    assert_eq!(client.server.text(URI), None);
}

#[test]
fn changes_of_one_notification_follow_each_other() {
    let at = |line: u32, character: u32| json!({ "line": line, "character": character });
    // `𝄞` is four bytes, two UTF-16 units and one character.
    for (encoding, width) in [("utf-8", 4), ("utf-16", 2), ("utf-32", 1)] {
        let mut client = Client::able(encoding);
        client.open("// 𝄞x\n// b\n");
        let changes = json!([
            { "range": { "start": at(0, 3 + width), "end": at(0, 4 + width) }, "text": "é\n// 𝄞" },
            { "range": { "start": at(1, 3), "end": at(1, 3 + width) }, "text": "c" },
            { "range": { "start": at(2, 0), "end": at(3, 0) }, "text": "" },
            { "range": { "start": at(9, 9), "end": at(9, 9) }, "text": "// end" },
        ]);
        let document = json!({ "uri": URI, "version": 2 });
        let params = json!({ "textDocument": document, "contentChanges": changes });
        client.notify("textDocument/didChange", params);
        assert_eq!(
            client.server.text(URI),
            Some("// 𝄞é\n// c\n// end"),
            "{encoding}"
        );
    }
}

#[test]
fn a_request_that_is_cancelled_in_time_is_not_answered() {
    let mut client = Client::able("utf-8");
    client.open(BROKEN);
    let question = |id: &str| {
        let at = json!({ "line": 0, "character": 3 });
        let params = json!({ "textDocument": document(), "position": at });
        let id = RequestId::from(id.to_owned());
        Message::from(Request::new(id, "textDocument/hover".into(), params))
    };
    client.server.accept(question("one"));
    client.server.accept(question("two"));
    let cancel = Notification::new("$/cancelRequest".into(), json!({ "id": "one" }));
    client.server.accept(cancel.into());
    let mut answers = Vec::new();
    while let Some(messages) = client.server.work() {
        answers.extend(messages.into_iter().filter_map(|message| match message {
            Message::Response(response) => Some((response.id, response.response_result)),
            _ => None,
        }));
    }
    answers.sort_by_key(|(id, _)| id.to_string());
    assert_eq!(answers.len(), 2);
    assert_eq!(answers[0].1.as_ref().unwrap_err().code, -32800);
    assert!(answers[1].1.is_ok());
}

#[test]
fn one_bad_op_blinds_no_other() {
    let flip = std::fs::read_to_string("examples/flip.hedge").unwrap();
    let mut client = Client::able("utf-8");
    client.open(&format!(
        "op bad(e: edge) {{ before {{ face }}}} \n{flip}\nop worse(\n"
    ));
    let line = flip
        .lines()
        .position(|line| line.starts_with("op flip("))
        .unwrap()
        + 1;
    let at = json!({ "line": line, "character": 4 });
    let params = json!({ "textDocument": document(), "position": at });
    let hover = client.request("textDocument/hover", params).unwrap();
    let said = hover["contents"]["value"].as_str().unwrap();
    assert!(said.contains("**proved**"), "{said}");
}

#[test]
fn names_reach_over_files() {
    let mut client = Client::able("utf-8");
    let library = "file:///work/ops.hedge";
    client.open_as(
        library,
        "op flip(e: edge) { }\nscript s() { for e in edges { flip(e) } }\n",
    );
    client.open("use \"ops.hedge\"\nuse \"std/triangle.hedge\"\nscript t() { for e in edges { flip(e) } }\n");
    let at = |line: u32, character: u32| json!({ "line": line, "character": character });
    let here = json!({ "textDocument": document(), "position": at(2, 32) });
    let found = client
        .request("textDocument/definition", here.clone())
        .unwrap();
    assert_eq!(found["uri"], library);
    assert_eq!(found["range"]["start"], at(0, 3));
    let mut params = here.clone();
    params["context"] = json!({ "includeDeclaration": true });
    let found = client
        .request("textDocument/references", params.clone())
        .unwrap();
    assert_eq!(found.as_array().unwrap().len(), 3);
    params["context"] = json!({ "includeDeclaration": false });
    let found = client.request("textDocument/references", params).unwrap();
    assert_eq!(found.as_array().unwrap().len(), 2);
    let mut params = here;
    params["newName"] = "turn".into();
    let edit = client.request("textDocument/rename", params).unwrap();
    let changes = edit["documentChanges"].as_array().unwrap();
    let count = |uri: &str| {
        let of = changes
            .iter()
            .find(|change| change["textDocument"]["uri"] == uri);
        of.map(|change| change["edits"].as_array().unwrap().len())
    };
    assert_eq!((count(library), count(URI)), (Some(2), Some(1)));
    // What a file says is heard by those who use it.
    let before = client.published().unwrap()["diagnostics"].clone();
    let change = json!({ "textDocument": { "uri": library, "version": 2 },
        "contentChanges": [{ "text": "op turn(e: edge) { }\n" }] });
    client.notify("textDocument/didChange", change);
    let after = &client.published().unwrap()["diagnostics"];
    assert_ne!(&before, after);
    let links = json!({ "textDocument": document() });
    let links = client.request("textDocument/documentLink", links).unwrap();
    assert_eq!(links[0]["target"], library);
    let std = links[1]["target"].as_str().unwrap();
    assert!(std.ends_with("/std/triangle.hedge"), "{std}");
}
