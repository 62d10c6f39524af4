//! Diagnostics: published when a text is analyzed, and answered on request.

use gen_lsp_types::*;
use serde_json::json;

use super::document::Document;
use super::requests::Answer;
use super::server::{PendingRequest, Server};
use crate::analysis::{Unused, unused};
use crate::diagnostic::{self, Severity};

/// The page that explains codes.
const EXPLAINED: &str =
    "https://github.com/hedgerow-lang/hedgerow/blob/main/src/diagnostic/explained.md";

impl Server {
    /// Proves one more op of a document that changed, or publishes its diagnostics; once all are
    /// published, lets the client update what it shows. False if there is nothing to do.
    pub(super) fn publish_next(&mut self) -> bool {
        let next = self.documents.values_mut().find(|document| !document.is_published);
        let Some(document) = next else { return self.refresh() };
        let is_left = document.snapshot().examine_next();
        let is_first = is_left && document.is_kept_waiting();
        let params = (is_first || !is_left).then(|| PublishDiagnosticsParams {
            uri: document.uri().clone(),
            version: Some(document.version()),
            diagnostics: match is_left {
                true => protocol(document, &document.snapshot().diagnostics_so_far()),
                false => diagnostics(document),
            },
        });
        if is_left {
            let (done, all) = document.snapshot().progress();
            self.report_progress(done, all);
        } else {
            document.is_published = true;
            document.waits_no_longer();
            self.end_progress();
        }
        if let Some(params) = params {
            self.tell::<PublishDiagnosticsNotification>(params);
        }
        true
    }

    /// Lets the client request again what may have changed without a change of the text; false if
    /// nothing has.
    fn refresh(&mut self) -> bool {
        let is_outdated = std::mem::take(&mut self.is_outdated);
        if is_outdated && self.client.refreshes("codeLens") {
            self.ask::<CodeLensRefreshRequest>((), PendingRequest::Other);
        }
        if is_outdated && self.client.refreshes("inlayHint") {
            self.ask::<InlayHintRefreshRequest>((), PendingRequest::Other);
        }
        if is_outdated && self.client.refreshes("semanticTokens") {
            self.ask::<SemanticTokensRefreshRequest>((), PendingRequest::Other);
        }
        is_outdated
    }

    /// `textDocument/diagnostic`
    pub(super) fn pull(
        &mut self,
        params: DocumentDiagnosticParams,
    ) -> Answer<DocumentDiagnosticRequest> {
        let document = self.document(&params.text_document.uri)?;
        let report = RelatedFullDocumentDiagnosticReport {
            related_documents: None,
            full_document_diagnostic_report: FullDocumentDiagnosticReport {
                result_id: None,
                items: diagnostics(document),
            },
        };
        Ok(report.into())
    }
}

/// All diagnostics of a document; if there is no error, also the names that nothing reads.
pub(super) fn diagnostics(document: &Document) -> Vec<Diagnostic> {
    let told = document.snapshot().diagnostics();
    let mut all = protocol(document, &told);
    // Broken code may be what reads them.
    if told.iter().all(|told| told.severity != Severity::Error) {
        let unused = unused(document.snapshot());
        all.extend(unused.iter().map(|unused| faint(document, unused)));
    }
    all
}

/// The hint that a name is not read: editors show it faint.
fn faint(document: &Document, Unused { span, name, what }: &Unused) -> Diagnostic {
    Diagnostic {
        range: document.range(*span),
        severity: Some(DiagnosticSeverity::Hint),
        source: Some("hedgerow".into()),
        message: format!("the {what} `{name}` is not read").into(),
        tags: Some(vec![DiagnosticTag::Unnecessary]),
        ..Default::default()
    }
}

fn protocol(document: &Document, told: &[diagnostic::Diagnostic]) -> Vec<Diagnostic> {
    told.iter().map(|told| diagnostic(document, told)).collect()
}

/// The codes of warnings about what could be left out: editors show it faint.
const FAINT: [&str; 2] = ["unreachable-statement", "unused-variable"];

/// A diagnostic in the protocol's form. Notes follow the message; labels become related
/// information.
pub(super) fn diagnostic(document: &Document, told: &diagnostic::Diagnostic) -> Diagnostic {
    let mut message = told.message.clone();
    for note in &told.notes {
        message.push('\n');
        message.push_str(note);
    }
    let labels = told.labels.iter().filter(|label| !label.text.is_empty());
    let related = labels.filter_map(|label| {
        Some(DiagnosticRelatedInformation {
            location: document.location(label.span)?,
            message: label.text.clone(),
        })
    });
    Diagnostic {
        range: document.range(told.span()),
        severity: Some(match told.severity {
            Severity::Error => DiagnosticSeverity::Error,
            Severity::Warning => DiagnosticSeverity::Warning,
        }),
        code: Some(told.code.to_owned().into()),
        code_description: Some(CodeDescription { href: Uri(format!("{EXPLAINED}#{}", told.code)) }),
        source: Some("hedgerow".into()),
        message: message.into(),
        related_information: Some(related.collect()),
        tags: FAINT.contains(&told.code).then(|| vec![DiagnosticTag::Unnecessary]),
        data: Some(json!({ "fixes": told.fixes.len() })),
    }
}
