//! Every answer, on pages: the input has a cursor, `‸`, and what the server says about the
//! place under it stands below.

use serde_json::{Value, json};

use crate::client::{Client, document, position};
use crate::shown::{difference, edited, edits, range};
use support::pages::{self, Case};

#[test]
fn every_answer_is_as_its_page_says() {
    let count = pages::check("editor/pages", answer);
    assert!(count > 20, "only {count} cases");
}

/// The answer to the question that the fence's word asks.
fn answer(case: &Case) -> String {
    let (before, after) = case.input.split_once('‸').unwrap_or(("", case.input));
    let text = format!("{before}{after}");
    let mut client = Client::able("utf-8");
    let legend = client.hello["capabilities"]["semanticTokensProvider"]["legend"].clone();
    client.open(&text);
    let at = position(&text, before.len());
    let here = json!({ "textDocument": document(), "position": at });
    let (question, argument) = case.kind.split_once(' ').unwrap_or((case.kind, ""));
    let mut ask = |method: &str, params: &Value| {
        client.request(&format!("textDocument/{method}"), params.clone())
    };
    let answer = match question {
        "diagnostics" => ask("diagnostic", &json!({ "textDocument": document() }))
            .map(|answer| told(&text, &answer["items"])),
        "hover" => ask("hover", &here).map(|answer| hover(&text, &answer)),
        "definition" => ask("definition", &here).map(|answer| match &answer {
            Value::Null => "nothing".into(),
            answer => range(&text, &answer["range"]),
        }),
        "references" | "uses" => {
            let mut params = here.clone();
            params["context"] = json!({ "includeDeclaration": question == "references" });
            ask("references", &params).map(|answer| ranges(&text, &answer))
        }
        "highlight" => ask("documentHighlight", &here).map(|answer| {
            let kinds = ["", "text", "read", "write"];
            let lines = answer.as_array().unwrap().iter().map(|found| {
                let kind = kinds[found["kind"].as_u64().unwrap() as usize];
                format!("{kind:5} {}\n", range(&text, &found["range"]))
            });
            lines.collect()
        }),
        "prepare" => ask("prepareRename", &here).map(|answer| range(&text, &answer["range"])),
        "rename" => {
            let mut params = here.clone();
            params["newName"] = argument.into();
            ask("rename", &params).map(|answer| difference(&text, &edited(&text, &edits(&answer))))
        }
        "symbols" => ask("documentSymbol", &json!({ "textDocument": document() }))
            .map(|answer| symbols(&text, &answer, 0)),
        "folds" => ask("foldingRange", &json!({ "textDocument": document() })).map(|answer| {
            let folds = answer.as_array().unwrap().iter().map(|fold| {
                let line = |name: &str| fold[name].as_u64().unwrap() + 1;
                let kind = fold["kind"].as_str().unwrap_or("");
                format!("{}-{} {kind}\n", line("startLine"), line("endLine"))
            });
            folds.collect()
        }),
        "selection" => {
            let params = json!({ "textDocument": document(), "positions": [at] });
            ask("selectionRange", &params).map(|answer| {
                let (mut out, mut next) = (String::new(), &answer[0]);
                while !next.is_null() {
                    out.push_str(&format!("{}\n", range(&text, &next["range"])));
                    next = &next["parent"];
                }
                out
            })
        }
        "tokens" => ask("semanticTokens/full", &json!({ "textDocument": document() }))
            .map(|answer| tokens(&text, &legend, &answer["data"])),
        "hints" => {
            let end = position(&text, text.len());
            let start = json!({ "line": 0, "character": 0 });
            let params =
                json!({ "textDocument": document(), "range": { "start": start, "end": end } });
            ask("inlayHint", &params).map(|answer| {
                let mut lines: Vec<String> = text.lines().map(String::from).collect();
                let mut shown = Vec::new();
                for hint in answer.as_array().unwrap().iter().rev() {
                    let line = hint["position"]["line"].as_u64().unwrap() as usize;
                    let column = hint["position"]["character"].as_u64().unwrap() as usize;
                    let label = hint["label"].as_str().unwrap();
                    lines[line].insert_str(column, &format!("«{label}»"));
                    shown.push(line);
                }
                shown.sort();
                shown.dedup();
                shown.iter().map(|&line| format!("{}\n", lines[line])).collect()
            })
        }
        "links" => ask("documentLink", &json!({ "textDocument": document() })).map(|answer| {
            let links = answer.as_array().unwrap().iter().map(|link| {
                let target = link["target"].as_str().unwrap();
                format!("{} -> {target}\n", range(&text, &link["range"]))
            });
            links.collect()
        }),
        "completion" => ask("completion", &here).map(|answer| completion(&answer, 12)),
        "offers" => ask("completion", &here).map(|answer| {
            let items = answer["items"].as_array().unwrap();
            let lines = argument.split(' ').map(|word| match item(items, word) {
                Some(_) => format!("{word}\n"),
                None => format!("no {word}\n"),
            });
            lines.collect()
        }),
        "about" => ask("completion", &here).map(|answer| {
            let item = item(answer["items"].as_array().unwrap(), argument).unwrap();
            let detail = item["detail"].as_str().unwrap_or("no detail");
            let docs = item["documentation"]["value"].as_str().unwrap_or("no documentation");
            format!("{detail}\n{}", docs.replace("```", "~~~"))
        }),
        "snippet" => ask("completion", &here).map(|answer| {
            let items = answer["items"].as_array().unwrap();
            let item = item(items, argument).unwrap();
            let edit = |edit: &Value| {
                let written = edit["newText"].as_str()?;
                Some(format!("{}: {}", range(&text, &edit["range"]), written.trim()))
            };
            let word = edit(&item["textEdit"])
                .unwrap_or_else(|| item["insertText"].as_str().unwrap_or("no snippet").to_owned());
            let more = item["additionalTextEdits"].as_array().into_iter().flatten();
            std::iter::once(word).chain(more.filter_map(edit)).collect::<Vec<_>>().join("\n")
        }),
        "signature" => ask("signatureHelp", &here).map(|answer| signature(&answer)),
        "actions" | "action" => {
            let params = json!({ "textDocument": document(),
                "range": { "start": at, "end": at }, "context": { "diagnostics": [] } });
            ask("codeAction", &params).map(|answer| actions(&text, &answer, argument))
        }
        "lenses" => ask("codeLens", &json!({ "textDocument": document() })).map(|answer| {
            let lenses = answer.as_array().unwrap().iter().map(|lens| {
                let command = &lens["command"];
                let place = range(&text, &lens["range"]);
                let title = command["title"].as_str().unwrap();
                format!(
                    "{place}: {title} ({} {})\n",
                    command["command"].as_str().unwrap(),
                    command["arguments"][1]
                )
            });
            lenses.collect()
        }),
        "formatted" => {
            let options = json!({ "tabSize": 2, "insertSpaces": true });
            let params = json!({ "textDocument": document(), "options": options });
            ask("formatting", &params).map(|answer| edited(&text, answer.as_array().unwrap()))
        }
        "line" => {
            let line =
                |step: u64| json!({ "line": at["line"].as_u64().unwrap() + step, "character": 0 });
            let options = json!({ "tabSize": 2, "insertSpaces": true });
            let params = json!({ "textDocument": document(), "options": options,
                "range": { "start": line(0), "end": line(1) } });
            ask("rangeFormatting", &params)
                .map(|answer| difference(&text, &edited(&text, answer.as_array().unwrap())))
        }
        other => panic!("{}: nobody can answer `{other}`", case.place),
    };
    answer.unwrap_or_else(|(_, why)| format!("refused: {why}"))
}

fn told(text: &str, items: &Value) -> String {
    let items = items.as_array().unwrap();
    if items.is_empty() {
        return "nothing is wrong".into();
    }
    let lines = items.iter().map(|item| {
        if item["tags"] == json!([1]) {
            let message = item["message"].as_str().unwrap();
            return format!("{} faint: {message}\n", range(text, &item["range"]));
        }
        let mut lines = format!(
            "{} [{}] {}\n",
            range(text, &item["range"]),
            item["code"].as_str().unwrap(),
            item["message"].as_str().unwrap().replace('\n', "\n    ")
        );
        for related in item["relatedInformation"].as_array().unwrap() {
            let place = range(text, &related["location"]["range"]);
            let message = related["message"].as_str().unwrap();
            lines.push_str(&format!("  {place}: {message}\n"));
        }
        lines
    });
    lines.collect()
}

fn hover(text: &str, answer: &Value) -> String {
    if answer.is_null() {
        return "nothing".into();
    }
    let said = answer["contents"]["value"].as_str().unwrap();
    let said = said.replace("```", "~~~");
    format!("{}\n\n{said}", range(text, &answer["range"]))
}

fn ranges(text: &str, answer: &Value) -> String {
    let all = answer.as_array().unwrap().iter();
    all.map(|found| range(text, &found["range"]) + "\n").collect()
}

fn symbols(text: &str, answer: &Value, depth: usize) -> String {
    let entries = answer.as_array().unwrap().iter().map(|entry| {
        let [whole, name] = ["range", "selectionRange"].map(|range| {
            let place = |end: &str| {
                let at = &entry[range][end];
                [&at["line"], &at["character"]].map(|number| number.as_u64().unwrap())
            };
            place("start")..=place("end")
        });
        assert!(whole.contains(name.start()) && whole.contains(name.end()), "{entry}");
        format!(
            "{}{} {} ({})\n{}",
            "  ".repeat(depth),
            entry["name"].as_str().unwrap(),
            entry["detail"].as_str().unwrap_or(""),
            range(text, &entry["selectionRange"]),
            symbols(text, &entry["children"], depth + 1)
        )
    });
    entries.collect()
}

/// The words with their types and modifiers by the server's legend, a line of the text on a line.
fn tokens(text: &str, legend: &Value, data: &Value) -> String {
    let names = |what: &str| legend[what].as_array().unwrap().iter();
    let types: Vec<&str> = names("tokenTypes").flat_map(Value::as_str).collect();
    let modifiers: Vec<&str> = names("tokenModifiers").flat_map(Value::as_str).collect();
    let numbers: Vec<usize> =
        data.as_array().unwrap().iter().map(|number| number.as_u64().unwrap() as usize).collect();
    let lines: Vec<_> = text.lines().collect();
    let (mut line, mut column) = (0, 0);
    let mut out = String::new();
    for token in numbers.chunks(5) {
        let [down, right, length, kind, marks] = token else { panic!("five numbers a token") };
        column = if *down == 0 { column + right } else { *right };
        line += down;
        if *down > 0 && !out.is_empty() {
            out.push('\n');
        }
        let word = &lines[line][column..column + length];
        let marks = modifiers.iter().enumerate().filter(|(bit, _)| marks >> bit & 1 == 1);
        let marks: String = marks.map(|(_, name)| format!(".{name}")).collect();
        out.push_str(&format!("{word}:{}{marks} ", types[*kind]));
    }
    out
}

/// The completion of this word.
fn item<'i>(items: &'i [Value], word: &str) -> Option<&'i Value> {
    items.iter().find(|item| item["label"] == word)
}

/// The first completions, a line for each rank.
pub fn completion(answer: &Value, most: usize) -> String {
    let items = answer["items"].as_array().unwrap();
    let mut ranks: std::collections::BTreeMap<&str, Vec<&str>> = Default::default();
    for item in items {
        let rank = &item["sortText"].as_str().unwrap()[..1];
        ranks.entry(rank).or_default().push(item["label"].as_str().unwrap());
    }
    if ranks.is_empty() {
        return "nothing".into();
    }
    let lines = ranks.into_iter().map(|(rank, words)| {
        let more = if words.len() > most { " …" } else { "" };
        format!("{rank}: {}{more}\n", words[..words.len().min(most)].join(" "))
    });
    lines.collect()
}

fn signature(answer: &Value) -> String {
    if answer.is_null() {
        return "nothing".into();
    }
    let signatures = answer["signatures"].as_array().unwrap();
    let lines = signatures.iter().enumerate().map(|(at, signature)| {
        let mark = if answer["activeSignature"] == json!(at) { ">" } else { " " };
        let active = &signature["parameters"][answer["activeParameter"].as_u64().unwrap() as usize];
        format!(
            "{mark} {} — {}\n",
            signature["label"].as_str().unwrap(),
            active["label"].as_str().unwrap_or("too many")
        )
    });
    lines.collect()
}

/// The titles of actions; or what the one of this title changes.
fn actions(text: &str, answer: &Value, title: &str) -> String {
    let actions = answer.as_array().unwrap();
    if !title.is_empty() {
        let action = actions.iter().find(|action| action["title"] == title);
        let Some(action) = action else {
            return "nobody offers it".into();
        };
        return difference(text, &edited(text, &edits(&action["edit"])));
    }
    let lines = actions.iter().map(|action| {
        let preferred = if action["isPreferred"] == true { "*" } else { " " };
        format!(
            "{preferred} {}: {}\n",
            action["kind"].as_str().unwrap(),
            action["title"].as_str().unwrap()
        )
    });
    lines.collect()
}

#[test]
fn the_flip_is_typed_line_by_line() {
    let count = pages::check("editor/typing", |case| {
        assert_eq!(case.kind, "steps", "{}", case.place);
        let mut client = Client::able("utf-8");
        client.open("");
        let (mut text, mut out) = (String::new(), String::new());
        for (version, line) in (2..).zip(case.input.lines()) {
            let at = position(&text, text.len());
            text.push_str(line);
            text.push('\n');
            let change =
                json!({ "range": { "start": at, "end": at }, "text": format!("{line}\n") });
            let document = json!({ "uri": crate::client::URI, "version": version });
            client.notify(
                "textDocument/didChange",
                json!({ "textDocument": document, "contentChanges": [change] }),
            );
            out.push_str(&format!("{line}\n"));
            let published = client.published().unwrap();
            assert_eq!(published["version"], version);
            for told in published["diagnostics"].as_array().unwrap() {
                let message = told["message"].as_str().unwrap().lines().next().unwrap();
                out.push_str(&format!("      | {}\n", message));
            }
            let here = json!({ "textDocument": crate::client::document(),
                "position": position(&text, text.len()) });
            let next = client.request("textDocument/completion", here).unwrap();
            let next = completion(&next, 8);
            out.push_str(&format!("      ? {}\n", next.lines().next().unwrap()));
            let params = json!({ "textDocument": crate::client::document() });
            let lenses = client.request("textDocument/codeLens", params).unwrap();
            if let Some(title) = lenses[0]["command"]["title"].as_str() {
                out.push_str(&format!("      = {title}\n"));
            }
        }
        out
    });
    assert!(count > 0);
}
