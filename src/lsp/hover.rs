//! Hovers, as Markdown.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use gen_lsp_types::*;

use super::markdown::{fenced, quoted};
use super::requests::Answer;
use super::server::Server;
use crate::analysis::element::Element;
use crate::analysis::{Card, OpCard, RuleVerdict, Word, hover};
use crate::diagnostic::counted;
use crate::draw::{COLUMNS, draw_op, text_op};

/// The largest image that clients draw, in bytes of its text in the Markdown.
const LARGEST_IMAGE: usize = 70_000;

impl Server {
    /// `textDocument/hover`
    pub(super) fn hover(&mut self, params: HoverParams) -> Answer<HoverRequest> {
        let (document, offset) = self.place(&params.text_document_position_params)?;
        let found = hover(document.snapshot(), offset);
        let images = self.client.wants_images();
        let is_markdown = self.client.reads_markdown();
        Ok(found.map(|mut found| {
            if is_markdown && let Some(docs) = found.card.docs_mut() {
                *docs = quoted(docs);
            }
            let value = match &found.card {
                Card::Op(op) => op_text(op, images),
                Card::Element(element) => element_text(element),
                Card::Declared { head, docs } => declared_text(head, docs),
                Card::Word(word) => word_text(word),
            };
            let kind = if is_markdown { MarkupKind::Markdown } else { MarkupKind::PlainText };
            Hover {
                contents: MarkupContent { kind, value }.into(),
                range: Some(document.range(found.span)),
            }
        }))
    }
}

fn op_text(op: &OpCard, images: bool) -> String {
    let mut text = fenced("hedgerow", &op.head);
    text.push_str(&verdict(op));
    if !op.docs.is_empty() {
        text.push('\n');
        text.push_str(&docs(&op.docs));
    }
    if let Some(none) = &op.no_example {
        text.push_str(&format!("\n{none}\n"));
    }
    if let Some(diagram) = &op.diagram {
        if !op.is_current {
            text.push_str("\nThe picture is of the last text that could be read.\n");
        }
        text.push('\n');
        let image = images.then(|| image(&draw_op(diagram).compact_svg(), &diagram.name));
        match image.flatten() {
            Some(image) => text.push_str(&image),
            None => text.push_str(&fenced("text", &text_op(diagram, COLUMNS))),
        }
    }
    text
}

/// An image that is embedded in the Markdown, if it is small enough.
fn image(svg: &str, name: &str) -> Option<String> {
    let data = BASE64_STANDARD.encode(svg);
    (data.len() < LARGEST_IMAGE)
        .then(|| format!("![{name}, before and after](data:image/svg+xml;base64,{data})\n"))
}

/// The verdict, a line for each rule; or the errors.
pub(super) fn verdict(op: &OpCard) -> String {
    if let Some(steps) = &op.verdict.steps {
        let calls: Vec<_> = steps.calls.iter().map(|op| format!("`{op}`")).collect();
        return match calls.is_empty() {
            true => "**proved**, in steps\n".to_owned(),
            false => format!("**proved**, in steps: {}\n", calls.join(", ")),
        };
    }
    if op.verdict.proved {
        let rules = op.verdict.rules.iter().map(|rule| rule_text(rule) + "\n");
        return rules.collect::<Vec<_>>().join("\n");
    }
    let mut lines = vec!["**not proved**".to_owned()];
    lines.extend(quoted(&op.wrong).iter().map(|wrong| format!("- {wrong}")));
    lines.join("\n") + "\n"
}

fn rule_text(rule: &RuleVerdict) -> String {
    let mut text = match &rule.rule {
        Some(name) => format!("**proved**, `{name}`"),
        None => "**proved**".to_owned(),
    };
    text += &format!(", {}", counted(rule.cases, "case", "cases"));
    let change = |(name, by, _)| match by {
        0 => format!("{name} ±0"),
        by => format!("{name} {by:+}"),
    };
    let changes: Vec<_> = rule.counts().into_iter().map(change).collect();
    text.push_str(&format!(" · {}", changes.join(" ")));
    if rule.constant_time {
        text.push_str(" · constant time");
    } else {
        text.push_str(&format!(" · grows with {}", rule.grows_with.join(", ")));
    }
    if !rule.keeps.is_empty() {
        text.push_str(&format!(" · keeps {}", rule.keeps.join(", ")));
    }
    for (what, changes) in [("degrees", &rule.degrees), ("sides", &rule.sizes)] {
        if !changes.is_empty() {
            let changes = changes.iter().map(|(name, by)| format!("`{name}` {by}"));
            let changes = changes.collect::<Vec<_>>().join(", ");
            text.push_str(&format!(" · {what}: {changes}"));
        }
    }
    for turned in &rule.turned {
        text.push_str(&format!(" · {turned}"));
    }
    if let Some(only) = &rule.keeps_only {
        text.push_str(&format!(" · {}", only.words()));
    }
    text
}

/// A doc comment is Markdown already; for clients that draw it, it has been [`quoted`].
fn docs(lines: &[String]) -> String {
    let mut text = lines.join("\n");
    text.push('\n');
    text
}

/// An element and its pointers, before and after.
fn element_text(element: &Element) -> String {
    let outer = if element.is_outer { "outer " } else { "" };
    let mut text = format!(
        "**`{}`** — {outer}{}, {}\n",
        element.name,
        element.kind.word(),
        element.fate.word()
    );
    if let Some(rule) = &element.rule {
        text = format!("{}, in `{rule}`\n", text.trim_end());
    }
    let told = element
        .pointers
        .iter()
        .filter(|pointer| !(pointer.before.is_empty() && pointer.after.is_empty()));
    let shown = |value: &str| match value {
        "" => "—".to_owned(),
        "outside" => "*outside*".to_owned(),
        value => format!("`{}`", value.replace('|', "\\|")),
    };
    let rows: Vec<_> = told
        .map(|pointer| {
            let after = if pointer.before == pointer.after {
                "=".to_owned()
            } else {
                shown(&pointer.after)
            };
            format!("| {} | {} | {after} |\n", pointer.name, shown(&pointer.before))
        })
        .collect();
    if !rows.is_empty() {
        text.push_str("\n| | before | after |\n| --- | --- | --- |\n");
        text.push_str(&rows.concat());
    }
    text
}

fn declared_text(head: &str, about: &[String]) -> String {
    format!("{}\n{}", fenced("hedgerow", head), docs(about))
}

fn word_text(word: &Word) -> String {
    if word.forms.is_empty() {
        return format!("{}\n", word.meaning);
    }
    format!("{}\n{}\n", fenced("hedgerow", &word.forms.join("\n")), word.meaning)
}
