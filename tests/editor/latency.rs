//! How long answers take. Not part of the tests, since a clock is no oracle:
//!
//!     cargo test --release --test editor latency -- --ignored --nocapture

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use lsp_server::{Message, Notification};
use serde_json::json;

use crate::client::{Client, URI, document, position};
use support::dice::Dice;

const METHODS: [&str; 14] = [
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
    for round in 0..METHODS.len() * 40 {
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
        let notice =
            Notification::new("textDocument/didChange".into(), change(round * 2 + 2, &range, new));
        client.server.accept(notice.into());
        client.server.work();
        let method = METHODS[round % METHODS.len()];
        let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 80, "character": 0 } });
        let params = json!({ "textDocument": document(), "position": position(&text, at),
            "range": if method == "codeAction" { json!({ "start": start, "end": start }) } else { whole },
            "context": match method { "references" => json!({ "includeDeclaration": true }), "codeAction" => json!({ "diagnostics": [] }), _ => json!(null) },
            "options": { "tabSize": 2, "insertSpaces": true } });
        let id = lsp_server::RequestId::from(1_000_000 + round as i32);
        let request = lsp_server::Request::new(id, format!("textDocument/{method}"), params);
        client.server.accept(request.into());
        let asked = Instant::now();
        // What is asked of all ops is answered when they are proved.
        while !client.server.work().expect("an answer").iter().any(is_answer) {}
        times.entry(method).or_default().push(asked.elapsed());
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

fn is_answer(message: &Message) -> bool {
    matches!(message, Message::Response(answer) if answer.response_result.is_ok())
}

/// The time that this thread has been at work, which on a busy machine is less than what has
/// passed.
fn at_work() -> Duration {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = told.split(' ').next().and_then(|first| first.parse().ok());
    Duration::from_nanos(nanoseconds.unwrap_or(0))
}

/// A file of so many ops: those of the examples, again and again under other names.
fn file_of(ops: usize) -> String {
    let names = ["flip", "split", "collapse", "dissolve", "contract", "connect", "families"];
    let texts =
        names.map(|name| std::fs::read_to_string(format!("examples/{name}.hedge")).unwrap());
    let mut out = String::new();
    let mut count = 0;
    for round in 0.. {
        for text in &texts {
            for line in text.lines().filter(|line| !line.starts_with("//!")) {
                if let Some(rest) = line.strip_prefix("op ") {
                    count += 1;
                    out.push_str(&format!("op r{round}_{rest}\n"));
                } else {
                    out.push_str(&format!("{line}\n"));
                }
            }
            if count >= ops {
                return out;
            }
        }
    }
    out
}

/// What the server does until it has nothing to do: the time until the first diagnostics, all of
/// it, and the longest single piece of work.
fn worked(client: &mut Client) -> [Duration; 3] {
    let start = at_work();
    let (mut first, mut longest) = (None, Duration::ZERO);
    loop {
        let before = at_work();
        let Some(told) = client.server.work() else { break };
        longest = longest.max(at_work() - before);
        let is_published = |message: &Message| matches!(message, Message::Notification(told) if told.method == "textDocument/publishDiagnostics");
        if told.iter().any(is_published) {
            first.get_or_insert(at_work() - start);
        }
    }
    [first.unwrap_or_default(), at_work() - start, longest]
}

#[test]
#[ignore = "it measures"]
fn large_files() {
    for ops in [500, 1000, 2000, 5000] {
        let text = file_of(ops);
        println!("== {ops} ops, {} lines (time at work)", text.lines().count());
        let mut client = Client::able("utf-16");
        let item = json!({ "uri": URI, "languageId": "hedgerow", "version": 1, "text": text });
        let opened =
            Notification::new("textDocument/didOpen".into(), json!({ "textDocument": item }));
        client.server.accept(opened.into());
        let [first, all, longest] = worked(&mut client);
        println!("open: first diagnostics {first:.0?}, all {all:.0?}, longest piece {longest:.0?}");
        let mut dice = Dice(11);
        let words: Vec<usize> = text.match_indices(" v").map(|(at, _)| at + 2).collect();
        let mut times: BTreeMap<&str, Vec<Duration>> = BTreeMap::new();
        for round in 0..10 {
            let at = words[dice.below(words.len())];
            let start = position(&text, at);
            let end = position(&text, at + usize::from(round % 2 == 1));
            let new = if round % 2 == 0 { "x" } else { "" };
            let change = json!({ "textDocument": { "uri": URI, "version": round + 2 },
                "contentChanges": [{ "range": { "start": start, "end": if round % 2 == 0 { start.clone() } else { end } }, "text": new }] });
            client.server.accept(Notification::new("textDocument/didChange".into(), change).into());
            let [_, all, longest] = worked(&mut client);
            times.entry("(edit, all published)").or_default().push(all);
            times.entry("(edit, longest piece)").or_default().push(longest);
            let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 80, "character": 0 } });
            for method in METHODS {
                let params = json!({ "textDocument": document(), "position": start,
                    "range": if method == "codeAction" { json!({ "start": start, "end": start }) } else { whole.clone() },
                    "context": match method { "references" => json!({ "includeDeclaration": true }), "codeAction" => json!({ "diagnostics": [] }), _ => json!(null) },
                    "options": { "tabSize": 2, "insertSpaces": true } });
                let id = lsp_server::RequestId::from(round * 100 + 7);
                let request =
                    lsp_server::Request::new(id, format!("textDocument/{method}"), params);
                client.server.accept(request.into());
                let before = at_work();
                while !client.server.work().expect("an answer").iter().any(is_answer) {}
                times.entry(method).or_default().push(at_work() - before);
            }
        }
        for (method, mut times) in times {
            report(method, &mut times);
        }
    }
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
