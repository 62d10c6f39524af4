//! Progress reports while many ops wait to be proved.

use gen_lsp_types::*;
use serde_json::json;

use super::server::{PendingRequest, Server};

/// The number of ops that have to wait before progress is worth showing.
const MANY: usize = 24;
/// The number of ops between two reports.
const STEP: usize = 8;

/// Progress that the client shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Progress {
    token: String,
    is_open: bool,
}

impl Server {
    /// Reports how many ops of a document have been examined, and of how many.
    pub(super) fn report_progress(&mut self, done: usize, all: usize) {
        match &self.progress {
            None if all - done > MANY && self.client.shows_progress() => {
                let token = format!("hedgerow/prove/{}", self.fresh());
                self.progress = Some(Progress { token: token.clone(), is_open: false });
                let token = ProgressToken::String(token);
                let params = WorkDoneProgressCreateParams { token };
                self.ask::<WorkDoneProgressCreateRequest>(params, PendingRequest::Progress);
            }
            Some(progress) if progress.is_open && done.is_multiple_of(STEP) => {
                let percentage = done * 100 / all.max(1);
                let message = format!("{done} of {all} operations");
                let report =
                    json!({ "kind": "report", "message": message, "percentage": percentage });
                self.tell_progress(report);
            }
            _ => {}
        }
    }

    /// Begins the progress, since the client is ready to show it.
    pub(super) fn progress_created(&mut self) {
        if let Some(progress) = &mut self.progress {
            progress.is_open = true;
            self.tell_progress(json!({ "kind": "begin", "title": "proving", "percentage": 0 }));
        }
    }

    /// Ends the progress, since all is proved.
    pub(super) fn end_progress(&mut self) {
        if self.progress.as_ref().is_some_and(|progress| progress.is_open) {
            self.tell_progress(json!({ "kind": "end" }));
        }
        self.progress = None;
    }

    fn tell_progress(&mut self, value: serde_json::Value) {
        if let Some(progress) = &self.progress {
            let token = ProgressToken::String(progress.token.clone());
            self.tell::<ProgressNotification>(ProgressParams { token, value });
        }
    }
}
