//! Pages: Markdown files that contain inputs and their expected outputs.
//!
//! A page is prose with fences. A fence ```` ```hedge ```` is an input. Every other fence with a
//! word after its ticks is the expected answer of the suite for the last input, and the word
//! selects the answer (`text`, `diagnostics`, …). A fence without a word is prose.
//!
//! With `UPDATE=1` in the environment the expectations are rewritten; review the diff before
//! committing it.

use std::fs;
use std::path::Path;

/// One expectation of a page.
pub struct Case<'p> {
    /// The word after the ticks of the expectation.
    pub kind: &'p str,
    /// The input.
    pub input: &'p str,
    /// The page and the line of the expectation, for messages.
    pub place: &'p str,
}

/// Compares every page of a folder of `tests` with `answer`, and returns the number of cases.
pub fn check(folder: &str, answer: impl Fn(&Case) -> String) -> usize {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
    let mut pages: Vec<_> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "md"))
        .collect();
    pages.sort();
    let update = std::env::var_os("UPDATE").is_some_and(|value| value == "1");
    let mut wrong = Vec::new();
    let mut count = 0;
    for path in pages {
        let page = fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let (answered, differing, cases) = answered(&name, &page, &answer);
        count += cases;
        if update {
            fs::write(&path, answered).unwrap();
        } else {
            wrong.extend(differing);
        }
    }
    assert!(wrong.is_empty(), "{}\nUPDATE=1 rewrites the pages\n", wrong.join("\n"));
    count
}

/// The page with all its expectations replaced by answers, the differences, and the number of
/// cases.
fn answered(
    name: &str,
    page: &str,
    answer: &impl Fn(&Case) -> String,
) -> (String, Vec<String>, usize) {
    let mut out = String::new();
    let mut differing = Vec::new();
    let mut input = String::new();
    let mut count = 0;
    let mut lines = page.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        out.push_str(line);
        out.push('\n');
        let Some(kind) = line.strip_prefix("```") else {
            continue;
        };
        let inside = lines.by_ref().map(|(_, line)| line);
        let body: String =
            inside.take_while(|line| *line != "```").map(|line| format!("{line}\n")).collect();
        let kept = match kind {
            "hedge" => {
                input.clone_from(&body);
                body
            }
            "" => body,
            kind => {
                count += 1;
                let place = format!("{name}:{}", at + 1);
                let case = Case { kind, input: &input, place: &place };
                let answer = answer(&case);
                let answer = format!("{}\n", answer.trim_end());
                if answer != body {
                    differing
                        .push(format!("{place}: expected\n{body}\nbut the answer is\n{answer}"));
                }
                answer
            }
        };
        out.push_str(&kept);
        out.push_str("```\n");
    }
    (out, differing, count)
}
