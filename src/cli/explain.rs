//! `hedgerow explain`

use super::arguments::ExplainArguments;
use super::failure::Failure;
use super::output::{say, table};
use crate::diagnostic::{explain as explanation, explained};

/// Says what a diagnostic means, and what mends it.
pub(super) fn explain(arguments: &ExplainArguments) -> Result<(), Failure> {
    let Some(code) = &arguments.code else {
        let rows: Vec<_> = explained()
            .map(|(code, law)| vec![code.into(), law.into()])
            .collect();
        say(&table(&rows, &[]));
        return Ok(());
    };
    let code = bare(code);
    let text = explanation(code).ok_or_else(|| {
        Failure::usage(format!(
            "there is no diagnostic `{code}`; `hedgerow explain` lists them"
        ))
    })?;
    say(&format!("{code}\n\n{text}"));
    Ok(())
}

/// The code in what may be copied from a message: `error[stale-vertex]: …`.
fn bare(told: &str) -> &str {
    let inside = told.split_once('[').and_then(|(_, rest)| {
        let (code, _) = rest.split_once(']')?;
        Some(code)
    });
    inside.unwrap_or(told).trim()
}
