//! `hedgerow lsp`

use super::arguments::LspArguments;
use super::failure::Failure;
use crate::lsp::serve;

/// Serves one client until it exits.
pub(super) fn lsp(_arguments: &LspArguments) -> Result<(), Failure> {
    match serve() {
        Ok(0) => Ok(()),
        Ok(code) => Err(Failure::Silent(code.into())),
        Err(error) => {
            Err(Failure::usage(format!("the conversation with the client broke off: {error}")))
        }
    }
}
