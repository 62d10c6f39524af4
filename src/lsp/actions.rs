//! Code actions: quick fixes and refactorings.

use gen_lsp_types::*;

use super::diagnostics::diagnostic;
use super::requests::Answer;
use super::server::Server;
use crate::analysis::{Purpose, actions};

impl Server {
    /// `textDocument/codeAction`
    pub(super) fn actions(&mut self, params: CodeActionParams) -> Answer<CodeActionRequest> {
        let uri = params.text_document.uri;
        let part = self.document(&uri)?.bytes(params.range);
        self.follow(&uri, part.start);
        let document = self.document(&uri)?;
        let found = actions(document.snapshot(), part);
        let wanted = params.context.only;
        let is_wanted = |kind: &CodeActionKind| {
            let kind = String::from(kind.clone());
            wanted.as_ref().is_none_or(|wanted| {
                wanted.iter().any(|wanted| {
                    let wanted = String::from(wanted.clone());
                    wanted.is_empty() || kind == wanted || kind.starts_with(&format!("{wanted}."))
                })
            })
        };
        let actions = found.into_iter().map(|action| CodeAction {
            kind: Some(match action.purpose {
                Purpose::Fix | Purpose::Proposal => CodeActionKind::QuickFix,
                Purpose::Rewrite => CodeActionKind::RefactorRewrite,
            }),
            diagnostics: action.mends.as_ref().map(|told| vec![diagnostic(document, told)]),
            is_preferred: Some(action.purpose == Purpose::Fix),
            edit: Some(self.workspace_edit(&[(document, action.edits)])),
            title: action.title,
            ..Default::default()
        });
        let actions = actions.filter(|action| action.kind.as_ref().is_some_and(is_wanted));
        Ok(Some(actions.map(CodeActionResponse::from).collect()))
    }
}
