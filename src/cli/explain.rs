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
    let text = explanation(code).ok_or_else(|| {
        Failure::usage(format!(
            "there is no diagnostic `{code}`; `hedgerow explain` lists them"
        ))
    })?;
    say(&format!("{code}\n\n{text}"));
    Ok(())
}
