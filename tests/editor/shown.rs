//! Answers of the protocol as text for a page.

use serde_json::Value;

use crate::client::offset;

/// `2:5-2:7 word`, from 1, columns in bytes.
pub fn range(text: &str, range: &Value) -> String {
    let place = |at: &Value| {
        let part = |name: &str| at[name].as_u64().unwrap() + 1;
        format!("{}:{}", part("line"), part("character"))
    };
    let covered = &text[offset(text, &range["start"])..offset(text, &range["end"])];
    let first = covered.lines().next().unwrap_or("");
    let more = if covered.lines().count() > 1 { " …" } else { "" };
    format!("{} {first}{more}", place(&range["start"])).trim_end().to_owned()
}

/// The text with the edits of one document carried out.
pub fn edited(text: &str, edits: &[Value]) -> String {
    let mut spans: Vec<_> = edits
        .iter()
        .map(|edit| {
            let start = offset(text, &edit["range"]["start"]);
            let end = offset(text, &edit["range"]["end"]);
            (start, end, edit["newText"].as_str().unwrap())
        })
        .collect();
    spans.sort();
    for pair in spans.windows(2) {
        assert!(pair[0].1 <= pair[1].0, "edits overlap: {spans:?}");
    }
    let mut out = text.to_owned();
    for (start, end, new) in spans.into_iter().rev() {
        out.replace_range(start..end, new);
    }
    out
}

/// The edits of a workspace edit of one document.
pub fn edits(edit: &Value) -> Vec<Value> {
    let changes = edit["documentChanges"].as_array().unwrap();
    assert_eq!(changes.len(), 1);
    changes[0]["edits"].as_array().unwrap().clone()
}

/// What differs between two texts, line by line: the lines that go and those that come.
pub fn difference(old: &str, new: &str) -> String {
    let (old, new): (Vec<_>, Vec<_>) = (old.lines().collect(), new.lines().collect());
    // The longest common subsequence, from the end on.
    let mut longest = vec![vec![0; new.len() + 1]; old.len() + 1];
    for (at, line) in old.iter().enumerate().rev() {
        for (to, other) in new.iter().enumerate().rev() {
            longest[at][to] = if line == other {
                longest[at + 1][to + 1] + 1
            } else {
                longest[at + 1][to].max(longest[at][to + 1])
            };
        }
    }
    let (mut at, mut to) = (0, 0);
    let mut out = String::new();
    while at < old.len() || to < new.len() {
        if at < old.len() && to < new.len() && old[at] == new[to] {
            (at, to) = (at + 1, to + 1);
        } else if to == new.len() || at < old.len() && longest[at + 1][to] >= longest[at][to + 1] {
            out.push_str(&format!("- {}\n", old[at]));
            at += 1;
        } else {
            out.push_str(&format!("+ {}\n", new[to]));
            to += 1;
        }
    }
    out
}
