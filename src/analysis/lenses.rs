//! Lenses: lines above an item with facts and commands.

use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::tree::Item;

/// The command of a lens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Offer {
    /// Whether an op is proved; the command shows its diagram.
    Proof,
    /// Show the diagram of an op.
    Diagram,
    /// Run a test.
    Test,
    /// Run a script.
    Script,
}

/// A line above an item.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lens {
    /// The name of the item.
    pub span: Span,
    /// The text of the lens.
    pub title: String,
    /// Its command.
    pub offer: Offer,
    /// The item's name.
    pub name: String,
}

/// The lenses of a text. Ops that are not examined yet are proved now.
pub fn lenses(snapshot: &Snapshot) -> Vec<Lens> {
    let mut lenses = Vec::new();
    for item in snapshot.items() {
        match item {
            Item::Op(op) => {
                let verdict = snapshot.verdict(op);
                let cases: usize = verdict.rules.iter().map(|rule| rule.cases).sum();
                let title = match (verdict.proved, cases) {
                    (false, _) => "not proved".to_owned(),
                    (true, 0) => "proved, step by step".to_owned(),
                    (true, 1) => "proved, 1 case".to_owned(),
                    (true, cases) => format!("proved, {cases} cases"),
                };
                let lens = |title: String, offer| Lens {
                    span: op.name.span,
                    title,
                    offer,
                    name: op.name.text.clone(),
                };
                lenses.push(lens(title, Offer::Proof));
                if op.steps.is_none() {
                    lenses.push(lens("show diagram".into(), Offer::Diagram));
                }
            }
            Item::Script(script) => lenses.push(Lens {
                span: script.name.span,
                title: "run script".into(),
                offer: Offer::Script,
                name: script.name.text.clone(),
            }),
            Item::Test(test) => lenses.push(Lens {
                span: Span { end: test.body.span.start.max(test.span.start), ..test.span },
                title: "run test".into(),
                offer: Offer::Test,
                name: test.name.clone(),
            }),
            Item::Use(_) | Item::Attr(_) | Item::Fn(_) | Item::Broken(_) => {}
        }
    }
    lenses
}
