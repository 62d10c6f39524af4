//! Random edits: the server's text is the client's, whatever is typed, in every encoding.

use serde_json::{Value, json};

use crate::client::{Client, URI, document};
use crate::shown::{edited, edits};
use support::dice::Dice;

/// What people and cats type.
const PIECES: &[&str] = &[
    "",
    " ",
    "\n",
    "\r\n",
    "\r",
    "a",
    "v0",
    "é",
    "𝄞",
    "𝄞𝄞",
    "-> v1",
    "{",
    "}",
    "{ }",
    "(",
    ")",
    "[i+1]",
    "edge e: a | d\n",
    "face f: v0 -a-> v1",
    "op x(e: edge) {\n",
    "// 𝄞 b\n",
    "\"",
    "*S",
    "new m",
    "erase v1 e",
    "keep f0",
    ".position = ",
    "rule r {",
    "before {",
    "after {",
    "= P =>",
    "\u{feff}",
    "0.5e",
    "use \"std/triangle.hedge\"\n",
    "require not ",
    "script s() { for e in ",
    "'",
    "each i {",
    "\u{0}",
    "-",
    ":",
    "|",
];

/// The line and column of a byte, for a client that counts this way and knows all line ends.
fn position(text: &str, offset: usize, encoding: &str) -> Value {
    let before = &text[..offset];
    let (mut line, mut start) = (0, 0);
    let bytes = text.as_bytes();
    for (at, byte) in before.bytes().enumerate() {
        let is_end = byte == b'\n' || byte == b'\r' && bytes.get(at + 1) != Some(&b'\n');
        if is_end {
            (line, start) = (line + 1, at + 1);
        }
    }
    let column = &before[start..];
    let character = match encoding {
        "utf-8" => column.len(),
        "utf-16" => column.encode_utf16().count(),
        _ => column.chars().count(),
    };
    json!({ "line": line, "character": character })
}

/// A place in a text where a change may begin or end: no client cuts a line end in two.
fn place(dice: &mut Dice, text: &str) -> usize {
    let at = text.floor_char_boundary(dice.below(text.len() + 1));
    let cuts = text[..at].ends_with('\r') && text[at..].starts_with('\n');
    if cuts { at - 1 } else { at }
}

fn ask(client: &mut Client, dice: &mut Dice, text: &str, encoding: &str) {
    let at = position(text, place(dice, text), encoding);
    let to = position(text, place(dice, text), encoding);
    let whole = json!({ "start": { "line": 0, "character": 0 }, "end": position(text, text.len(), encoding) });
    let methods = [
        ("hover", json!({})),
        ("definition", json!({})),
        ("references", json!({ "context": { "includeDeclaration": true } })),
        ("documentHighlight", json!({})),
        ("prepareRename", json!({})),
        ("rename", json!({ "newName": "zz'" })),
        ("completion", json!({})),
        ("signatureHelp", json!({})),
        ("documentSymbol", json!({})),
        ("foldingRange", json!({})),
        ("selectionRange", json!({ "positions": [at, to] })),
        ("semanticTokens/full", json!({})),
        ("semanticTokens/range", json!({ "range": whole })),
        ("inlayHint", json!({ "range": whole })),
        ("documentLink", json!({})),
        ("codeLens", json!({})),
        (
            "codeAction",
            json!({ "range": { "start": at, "end": to }, "context": { "diagnostics": [] } }),
        ),
        ("formatting", json!({ "options": { "tabSize": 2, "insertSpaces": true } })),
        ("diagnostic", json!({})),
    ];
    let (method, mut params) = methods[dice.below(methods.len())].clone();
    params["textDocument"] = document();
    params["position"] = at;
    let answer = client.request(&format!("textDocument/{method}"), params);
    if let Err((code, why)) = answer {
        assert_eq!(code, -32803, "{method}: {why}");
    }
}

#[test]
fn the_text_of_the_server_is_that_of_the_client() {
    let count = std::env::var("HEDGEROW_EDITS");
    let count: usize = count.map_or(300, |count| count.parse().unwrap());
    let files = ["flip", "collapse", "remesh"];
    let texts =
        files.map(|name| std::fs::read_to_string(format!("examples/{name}.hedge")).unwrap());
    let mut done = 0;
    for (seed, encoding) in ["utf-8", "utf-16", "utf-32"].into_iter().enumerate() {
        let mut dice = Dice(0x9e37_79b9_7f4a_7c15 + seed as u64);
        let mut client = Client::able(encoding);
        let mut text = texts[seed].clone();
        client.open(&text);
        for version in 2..2 + count as i32 / 3 {
            // From time to time the file is as it was, so that it is not broken for good.
            let mut changes = Vec::new();
            if dice.below(40) == 0 {
                text.clone_from(&texts[dice.below(texts.len())]);
                changes.push(json!({ "text": text }));
            }
            for _ in 0..1 + dice.below(3) {
                let (one, other) = (place(&mut dice, &text), place(&mut dice, &text));
                // Mostly short changes, as people make them.
                let end = if dice.below(8) == 0 {
                    other
                } else {
                    text.ceil_char_boundary((one + dice.below(6)).min(text.len()))
                };
                let cuts = text[..end].ends_with('\r') && text[end..].starts_with('\n');
                let end = if cuts { end + 1 } else { end };
                let (start, end) = (one.min(end), one.max(end));
                let new = PIECES[dice.below(PIECES.len())];
                let range = json!({ "start": position(&text, start, encoding), "end": position(&text, end, encoding) });
                changes.push(json!({ "range": range, "text": new }));
                text.replace_range(start..end, new);
            }
            let versioned = json!({ "uri": URI, "version": version });
            client.notify(
                "textDocument/didChange",
                json!({ "textDocument": versioned, "contentChanges": changes }),
            );
            assert_eq!(client.server.text(URI), Some(text.as_str()), "{encoding} {version}");
            assert_eq!(client.published().unwrap()["version"], version);
            client.told.clear();
            ask(&mut client, &mut dice, &text, encoding);
            done += 1;
        }
    }
    assert!(done >= count / 3 * 3 && done > 0);
}

/// What is offered for a text has its line ends.
#[test]
fn a_change_keeps_the_line_ends() {
    let text = "op turn(e: edge) {\n  rule one {\n    before { loop f: v0 -a-> v1 =P=> v0\n      \
                edge e: a | d }\n    after { keep f e }\n  }\n  rule two {\n    before { edge e: a | d }\n    \
                after { keep e }\n  }\n}\n";
    let lines = |text: &str| text.matches('\n').count();
    let ends = |text: &str| text.matches("\r\n").count();
    for text in [text.to_owned(), text.replace('\n', "\r\n")] {
        let mut client = Client::able("utf-8");
        client.open(&text);
        let at = json!({ "line": 1, "character": 8 });
        let params = json!({ "textDocument": document(), "range": { "start": at, "end": at },
            "context": { "diagnostics": [] } });
        let offered = client.request("textDocument/codeAction", params).unwrap();
        let split =
            offered.as_array().unwrap().iter().find(|action| {
                action["title"].as_str().unwrap().starts_with("move `one` to an op")
            });
        let edits = edits(&split.expect("a rule can be split out")["edit"]);
        let changed = edited(&text, &edits);
        let expected = if text.contains('\r') { lines(&changed) } else { 0 };
        assert_eq!(ends(&changed), expected, "{changed:?}");
        assert_eq!(changed.matches('\r').count(), expected, "{changed:?}");
    }
}
