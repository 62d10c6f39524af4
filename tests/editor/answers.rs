//! Every answer, on pages: the input has a cursor, `‸`, and what the server says about the
//! place under it stands below.

use serde_json::{Value, json};

use crate::client::{Client, document, position};
use crate::pages::{self, Case};
use crate::shown::{difference, edited, edits, range};

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
        "tokens" => ask(
            "semanticTokens/full",
            &json!({ "textDocument": document() }),
        )
        .map(|answer| tokens(&text, &answer["data"])),
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
                shown
                    .iter()
                    .map(|&line| format!("{}\n", lines[line]))
                    .collect()
            })
        }
        "links" => ask("documentLink", &json!({ "textDocument": document() })).map(|answer| {
            let links = answer.as_array().unwrap().iter().map(|link| {
                let target = link["target"].as_str().unwrap();
                format!("{} -> {target}\n", range(&text, &link["range"]))
            });
            links.collect()
        }),
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
    all.map(|found| range(text, &found["range"]) + "\n")
        .collect()
}

fn symbols(text: &str, answer: &Value, depth: usize) -> String {
    let entries = answer.as_array().unwrap().iter().map(|entry| {
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

/// The words with their types and modifiers, a line of the text on a line.
fn tokens(text: &str, data: &Value) -> String {
    let types = [
        "keyword",
        "type",
        "class",
        "function",
        "property",
        "enumMember",
        "variable",
        "parameter",
        "typeParameter",
        "number",
        "string",
        "comment",
        "operator",
    ];
    let modifiers = [
        "declaration",
        "defaultLibrary",
        "documentation",
        "new",
        "erased",
        "outer",
        "vertex",
        "halfedge",
        "edge",
        "face",
        "path",
        "fan",
    ];
    let numbers: Vec<usize> = data
        .as_array()
        .unwrap()
        .iter()
        .map(|number| number.as_u64().unwrap() as usize)
        .collect();
    let lines: Vec<_> = text.lines().collect();
    let (mut line, mut column) = (0, 0);
    let mut out = String::new();
    for token in numbers.chunks(5) {
        let [down, right, length, kind, marks] = token else {
            panic!("five numbers a token")
        };
        column = if *down == 0 { column + right } else { *right };
        line += down;
        if *down > 0 && !out.is_empty() {
            out.push('\n');
        }
        let word = &lines[line][column..column + length];
        let marks = modifiers
            .iter()
            .enumerate()
            .filter(|(bit, _)| marks >> bit & 1 == 1);
        let marks: String = marks.map(|(_, name)| format!(".{name}")).collect();
        out.push_str(&format!("{word}:{}{marks} ", types[*kind]));
    }
    out
}
