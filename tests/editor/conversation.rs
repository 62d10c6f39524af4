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
    assert_eq!(client.request("initialize", json!({})).unwrap_err().0, -32600);
    client.notify("initialized", json!({}));
    assert_eq!(client.request("no/such", json!({})).unwrap_err().0, -32601);
    assert_eq!(client.request("textDocument/hover", json!(3)).unwrap_err().0, -32602);
    let closed = json!({ "textDocument": document(), "position": { "line": 0, "character": 0 } });
    assert_eq!(client.request("textDocument/hover", closed).unwrap_err().0, -32602);
    assert_eq!(client.request("shutdown", Value::Null), Ok(Value::Null));
    assert_eq!(client.request("shutdown", Value::Null).unwrap_err().0, -32600);
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
        let hello = client.request("initialize", json!({ "capabilities": { "general": general } }));
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
    let link = published["diagnostics"][0]["codeDescription"]["href"].as_str().unwrap();
    assert!(link.ends_with("#missing-side"), "{link}");
    let change = |version: i32, text: &str| {
        json!({ "textDocument": { "uri": URI, "version": version },
                "contentChanges": [{ "text": text }] })
    };
    client.notify("textDocument/didChange", change(2, "// nothing\n"));
    let published = client.published().unwrap();
    assert_eq!((&published["version"], &published["diagnostics"]), (&json!(2), &json!([])));
    client.notify("textDocument/didChange", change(3, BROKEN));
    assert_eq!(client.published().unwrap()["version"], 3);
    client.notify("textDocument/didClose", json!({ "textDocument": document() }));
    assert_eq!(client.published().unwrap()["diagnostics"], json!([]));
    assert_eq!(client.server.text(URI), None);
}

#[test]
fn what_nothing_reads_is_shown_faint() {
    let mut client = Client::able("utf-16");
    client.open("fn f(x: real,\n  y: real) -> real { x }\n");
    let published = client.published().unwrap();
    let faint = json!({
        "range": { "start": { "line": 1, "character": 2 }, "end": { "line": 1, "character": 3 } },
        "severity": 4,
        "source": "hedgerow",
        "message": "the parameter `y` is not read",
        "tags": [1],
    });
    assert_eq!(published["diagnostics"], json!([faint]));
    // Where something is broken, it may be what reads it.
    let text = "fn f(x: real,\n  y: real) -> real { x + }\n";
    let change = json!({ "textDocument": { "uri": URI, "version": 2 },
                         "contentChanges": [{ "text": text }] });
    client.notify("textDocument/didChange", change);
    let published = client.published().unwrap();
    let severities = published["diagnostics"].as_array().unwrap().iter();
    assert!(severities.clone().count() > 0);
    assert!(severities.map(|told| &told["severity"]).all(|severity| *severity == 1));
}

#[test]
fn nobody_is_shown_the_same_twice() {
    let offered = |text: Value| {
        let mut client = Client::silent();
        let params = json!({ "capabilities": { "textDocument": text } });
        let hello = client.request("initialize", params).unwrap();
        hello["capabilities"]["diagnosticProvider"].is_object()
    };
    assert!(offered(json!({ "diagnostic": {} })));
    assert!(!offered(json!({ "diagnostic": {}, "publishDiagnostics": {} })));
}

#[test]
fn columns_of_a_long_line_are_found_at_once() {
    const COUNT: usize = 50_000;
    // `𝄞` is four bytes, two UTF-16 units and one character.
    for (encoding, width) in [("utf-8", 4), ("utf-16", 2), ("utf-32", 1)] {
        let mut client = Client::able(encoding);
        let [begins, ends] = ["if \"𝄞\" { ", "}"].map(|part| part.repeat(COUNT));
        client.open(&format!("script s() {{ {begins}{ends} // 𝄞"));
        let method = "textDocument/semanticTokens/full";
        let tokens = client.request(method, json!({ "textDocument": document() })).unwrap();
        let tokens = tokens["data"].as_array().unwrap();
        // `script s`, for each `if` a word and a text, and the comment.
        assert_eq!(tokens.len(), 5 * (2 + 2 * COUNT + 1), "{encoding}");
        let starts = tokens.chunks(5).map(|token| token[1].as_u64().unwrap());
        assert_eq!(starts.sum::<u64>(), 14 + (9 + width) * COUNT as u64, "{encoding}");
    }
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
        assert_eq!(client.server.text(URI), Some("// 𝄞é\n// c\n// end"), "{encoding}");
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
fn what_is_about_all_ops_waits_for_proofs_and_keeps_nobody_waiting() {
    let flip = std::fs::read_to_string("examples/flip.hedge").unwrap();
    let mut client = Client::able("utf-8");
    let item = json!({ "uri": URI, "languageId": "hedgerow", "version": 1, "text": flip });
    let opened = json!({ "textDocument": item });
    client.server.accept(Notification::new("textDocument/didOpen".into(), opened).into());
    let at = json!({ "line": 0, "character": 0 });
    let params = json!({ "textDocument": document(), "position": at });
    for (id, method) in [("one", "codeLens"), ("two", "codeLens"), ("three", "hover")] {
        let method = format!("textDocument/{method}");
        let request = Request::new(id.to_owned().into(), method, params.clone());
        client.server.accept(request.into());
    }
    let mut answered = Vec::new();
    while let Some(messages) = client.server.work() {
        for message in messages {
            let Message::Response(response) = message else { continue };
            answered.push((response.id.to_string(), response.response_result.map_err(|e| e.code)));
            if answered.len() == 1 {
                let cancel = Notification::new("$/cancelRequest".into(), json!({ "id": "two" }));
                client.server.accept(cancel.into());
            }
        }
    }
    let ids: Vec<_> = answered.iter().map(|(id, _)| id.as_str()).collect();
    assert_eq!(ids, ["\"three\"", "\"two\"", "\"one\""]);
    assert_eq!(answered[1].1, Err(-32800));
    let lenses = answered[2].1.as_ref().unwrap().as_array().unwrap();
    assert!(lenses.iter().any(|lens| lens["command"]["title"].to_string().contains("proved")));
}

#[test]
fn one_bad_op_blinds_no_other() {
    let flip = std::fs::read_to_string("examples/flip.hedge").unwrap();
    let mut client = Client::able("utf-8");
    client.open(&format!("op bad(e: edge) {{ before {{ face }}}} \n{flip}\nop worse(\n"));
    let line = flip.lines().position(|line| line.starts_with("op flip(")).unwrap() + 1;
    let at = json!({ "line": line, "character": 4 });
    let params = json!({ "textDocument": document(), "position": at });
    let hover = client.request("textDocument/hover", params).unwrap();
    let said = hover["contents"]["value"].as_str().unwrap();
    assert!(said.contains("**proved**"), "{said}");
}

#[test]
fn the_diagram_is_there_on_request_and_on_a_page() {
    let flip = std::fs::read_to_string("examples/flip.hedge").unwrap();
    let mut client = Client::able("utf-8");
    client.open(&flip);
    let line = flip.lines().position(|line| line.starts_with("op flip(")).unwrap();
    let here =
        json!({ "textDocument": document(), "position": { "line": line + 2, "character": 3 } });
    let diagram = client.request("hedgerow/diagram", here.clone()).unwrap();
    assert_eq!(diagram["name"], "flip");
    assert_eq!(diagram["proved"], true);
    assert!(diagram["svg"].as_str().unwrap().starts_with("<svg"));
    let named = json!({ "textDocument": document(), "name": "no_such_op" });
    assert_eq!(client.request("hedgerow/diagram", named), Ok(Value::Null));

    let command = json!({ "command": "hedgerow.showDiagram", "arguments": [URI, "flip_any"] });
    let address = client.request("workspace/executeCommand", command).unwrap();
    let address = address.as_str().unwrap().to_owned();
    assert!(address.starts_with("http://127.0.0.1:"), "{address}");
    assert!(get(&address, "/").contains("<title>hedgerow</title>"));
    assert!(get(&address, "/shown").contains("\"title\":\"flip_any\""));
    // The page follows the cursor, here the question what to highlight.
    client.request("textDocument/documentHighlight", here).unwrap();
    assert!(get(&address, "/shown?seen=1").contains("\"title\":\"flip\""));
    assert!(get(&address, "/shown?seen=2").contains("\"shown\":null"));
    assert!(get(&address, "/etc/passwd").starts_with("HTTP/1.1 404"));
    let foreign = ask_page(&address, "GET /shown HTTP/1.1\r\nHost: evil.example\r\n\r\n");
    assert!(foreign.starts_with("HTTP/1.1 403"), "{foreign}");
    let told = client.told.iter().rev();
    let mut shown = told.filter(|notice| notice.method == "window/showMessage");
    assert!(shown.next().unwrap().params["message"].as_str().unwrap().contains(&address));
}

fn get(address: &str, path: &str) -> String {
    let host = address.trim_start_matches("http://").trim_end_matches('/');
    ask_page(address, &format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n"))
}

fn ask_page(address: &str, question: &str) -> String {
    use std::io::{Read, Write};
    let host = address.trim_start_matches("http://").trim_end_matches('/');
    let mut stream = std::net::TcpStream::connect(host).unwrap();
    stream.write_all(question.as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

#[test]
fn settings_are_asked_for_and_heeded() {
    let mut client = Client::new(json!({ "capabilities": {
        "workspace": { "configuration": true, "didChangeWatchedFiles": { "dynamicRegistration": true } },
    } }));
    let methods: Vec<_> = client.asked.iter().map(|asked| asked.method.clone()).collect();
    assert_eq!(methods, ["workspace/configuration", "client/registerCapability"]);
    client.open("op f(e: edge) { before { edge e: a | d } after { keep e } }");
    let lenses = json!({ "textDocument": document() });
    let count = |client: &mut Client| {
        let lenses = client.request("textDocument/codeLens", lenses.clone()).unwrap();
        lenses.as_array().unwrap().len()
    };
    assert_eq!(count(&mut client), 2);
    let id = client.asked[0].id.clone();
    let answer = lsp_server::Response::new_ok(id, json!([{ "codeLens": { "enable": false } }]));
    client.server.accept(answer.into());
    client.settle(None);
    assert_eq!(count(&mut client), 0);
    // Settings that make no sense are as they are by default.
    client.notify("workspace/didChangeConfiguration", json!({ "settings": null }));
    let id = client.asked.last().unwrap().id.clone();
    let answer =
        lsp_server::Response::new_ok(id, json!([{ "codeLens": 7, "hover": { "picture": 3 } }]));
    client.server.accept(answer.into());
    client.settle(None);
    assert_eq!(count(&mut client), 2);
}

#[test]
fn many_proofs_show_progress() {
    let mut client =
        Client::new(json!({ "capabilities": { "window": { "workDoneProgress": true } } }));
    let flip = std::fs::read_to_string("examples/flip.hedge").unwrap();
    let ops: String =
        (0..30).map(|at| flip.replace("op flip", &format!("op r{at}_flip"))).collect();
    let item = json!({ "uri": URI, "languageId": "hedgerow", "version": 1, "text": ops });
    let open = Notification::new("textDocument/didOpen".into(), json!({ "textDocument": item }));
    client.server.accept(open.into());
    // The client agrees as soon as it is asked.
    let mut kinds = Vec::new();
    while let Some(messages) = client.server.work() {
        for message in messages {
            match message {
                Message::Request(asked) => {
                    let answer = lsp_server::Response::new_ok(asked.id, Value::Null);
                    client.server.accept(answer.into());
                }
                Message::Notification(notice) if notice.method == "$/progress" => {
                    kinds.push(notice.params["value"]["kind"].as_str().unwrap().to_owned());
                }
                _ => {}
            }
        }
    }
    assert_eq!(kinds.first().map(String::as_str), Some("begin"));
    assert_eq!(kinds.last().map(String::as_str), Some("end"));
    assert!(kinds.iter().filter(|kind| *kind == "report").count() > 2, "{kinds:?}");
}

#[test]
fn a_hover_draws_where_the_client_does_and_it_fits() {
    let mut drawn = 0;
    for name in ["flip", "split", "collapse", "contract", "connect", "dissolve"] {
        let text = std::fs::read_to_string(format!("examples/{name}.hedge")).unwrap();
        let mut client = Client::new(json!({
            "clientInfo": { "name": "Visual Studio Code" },
            "capabilities": { "textDocument": { "hover": { "contentFormat": ["markdown"] } } },
        }));
        client.open(&text);
        for (line, _) in text.lines().enumerate().filter(|(_, line)| line.starts_with("op ")) {
            let at = json!({ "line": line, "character": 4 });
            let params = json!({ "textDocument": document(), "position": at });
            let hover = client.request("textDocument/hover", params).unwrap();
            let said = hover["contents"]["value"].as_str().unwrap();
            if let Some((_, image)) = said.split_once("data:image/svg+xml;base64,") {
                assert!(image.len() < 70_000);
                drawn += 1;
            }
        }
    }
    assert!(drawn >= 5, "only {drawn} pictures are small enough");
}

#[test]
fn files_that_the_server_cannot_read_are_given_to_it() {
    let mut client = Client::able("utf-16");
    for folder in ["file:///work/", "vscode-vfs://github/somebody/meshes/"] {
        let uri = |name: &str| format!("{folder}{name}");
        let errors = |client: &mut Client| {
            client.settle(None);
            let mut told = client.told.iter().rev();
            let last = told.find(|notice| {
                notice.method == "textDocument/publishDiagnostics"
                    && notice.params["uri"] == uri("main.hedge")
            });
            last.map(|notice| notice.params["diagnostics"].as_array().map_or(0, Vec::len))
        };
        let give = |client: &mut Client, text: Value| {
            let files = json!([{ "uri": uri("part.hedge"), "text": text }]);
            client.notify("hedgerow/files", json!({ "files": files }));
        };
        client.open_as(&uri("main.hedge"), "use \"part.hedge\"\nscript go() { part() }\n");
        assert!(errors(&mut client).is_some_and(|many| many > 0), "{folder}");
        give(&mut client, json!("script part() { }\n"));
        assert_eq!(errors(&mut client), Some(0), "{folder}");
        let place = json!({ "line": 1, "character": 15 });
        let params = json!({ "textDocument": { "uri": uri("main.hedge") }, "position": place });
        let found = client.request("textDocument/definition", params).unwrap();
        assert!(found.to_string().contains(&uri("part.hedge")), "{found}");
        give(&mut client, Value::Null);
        assert!(errors(&mut client).is_some_and(|many| many > 0), "{folder}");
    }
}
