//! How long answers take. Not part of the tests, since a clock is no oracle:
//!
//!     cargo test --release --test editor latency -- --ignored --nocapture

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde_json::json;

use crate::client::{Client, URI, document, position};
use crate::dice::Dice;

/// A file of two thousand lines: the examples, again and again under other names.
fn long_file() -> String {
    let names = ["flip", "split", "collapse", "dissolve", "contract", "connect"];
    let texts =
        names.map(|name| std::fs::read_to_string(format!("examples/{name}.hedge")).unwrap());
    let mut out = String::new();
    for round in 0.. {
        for text in &texts {
            for line in text.lines().filter(|line| !line.starts_with("//!")) {
                match line.strip_prefix("op ") {
                    Some(rest) => out.push_str(&format!("op r{round}_{rest}\n")),
                    None => out.push_str(&format!("{line}\n")),
                }
            }
            if out.lines().count() >= 2000 {
                return out;
            }
        }
    }
    out
}

#[test]
#[ignore = "it measures"]
fn latency() {
    let mut client = Client::able("utf-16");
    let mut text = long_file();
    let lines = text.lines().count();
    let started = Instant::now();
    client.open(&text);
    println!("{lines} lines, all ops proved after {:.0?}", started.elapsed());
    let mut dice = Dice(7);
    let mut times: BTreeMap<&str, Vec<Duration>> = BTreeMap::new();
    let methods = [
        "hover",
        "definition",
        "references",
        "documentHighlight",
        "completion",
        "signatureHelp",
        "documentSymbol",
        "foldingRange",
        "semanticTokens/full",
        "codeLens",
        "codeAction",
        "inlayHint",
        "diagnostic",
        "formatting",
    ];
    for round in 0..methods.len() * 40 {
        // A letter is typed at the end of a word and taken back, as in a name.
        let words: Vec<usize> = text.match_indices(" v").map(|(at, _)| at + 2).collect();
        let at = words[dice.below(words.len())];
        let start = position(&text, at);
        let typed = round.is_multiple_of(2);
        let (range, new) = if typed {
            (json!({ "start": start, "end": start }), "x")
        } else {
            (json!({ "start": start, "end": start }), "")
        };
        if typed {
            text.insert(at, 'x');
        }
        let change = |version: usize, range: &serde_json::Value, new: &str| {
            json!({ "textDocument": { "uri": URI, "version": version },
                    "contentChanges": [{ "range": range, "text": new }] })
        };
        // The change waits when the question comes: the answer pays for reading it.
        let notice = lsp_server::Notification::new(
            "textDocument/didChange".into(),
            change(round * 2 + 2, &range, new),
        );
        client.server.accept(notice.into());
        client.server.work();
        let method = methods[round % methods.len()];
        let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 80, "character": 0 } });
        let params = json!({ "textDocument": document(), "position": position(&text, at),
            "range": if method == "codeAction" { json!({ "start": start, "end": start }) } else { whole },
            "context": match method { "references" => json!({ "includeDeclaration": true }), "codeAction" => json!({ "diagnostics": [] }), _ => json!(null) },
            "options": { "tabSize": 2, "insertSpaces": true } });
        let id = lsp_server::RequestId::from(1_000_000 + round as i32);
        let request = lsp_server::Request::new(id, format!("textDocument/{method}"), params);
        client.server.accept(request.into());
        let asked = Instant::now();
        let answer = client.server.work().expect("an answer");
        times.entry(method).or_default().push(asked.elapsed());
        let is_answered = |message: &lsp_server::Message| matches!(message, lsp_server::Message::Response(answer) if answer.response_result.is_ok());
        assert!(answer.iter().any(is_answered), "{method}: {answer:?}");
        if typed {
            text.remove(at);
            let end = position(&text, at + 1);
            let range = json!({ "start": start, "end": end });
            let started = Instant::now();
            client.notify("textDocument/didChange", change(round * 2 + 3, &range, ""));
            let published = "(diagnostics published)";
            times.entry(published).or_default().push(started.elapsed());
            assert_eq!(client.server.text(URI), Some(text.as_str()));
        } else {
            client.settle(None);
        }
    }
    let mut all: Vec<Duration> = Vec::new();
    for (method, mut times) in times {
        all.extend(&times);
        report(method, &mut times);
    }
    report("all", &mut all);
}

fn report(what: &str, times: &mut [Duration]) {
    times.sort();
    let part = |hundredths: usize| times[(times.len() * hundredths / 100).min(times.len() - 1)];
    println!(
        "{what:23} p50 {:8.2?}  p99 {:8.2?}  most {:8.2?}",
        part(50),
        part(99),
        times[times.len() - 1]
    );
}
