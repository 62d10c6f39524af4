//! Commands that run beside the server, in a process of their own.

use std::process::{Command, Stdio};

use gen_lsp_types::{
    LogMessageNotification, LogMessageParams, MessageType, Notification as _,
    ShowMessageNotification, ShowMessageParams,
};
use lsp_server::{Message, Notification};

/// A command of `hedgerow` to run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subprocess {
    pub arguments: Vec<String>,
}

impl Subprocess {
    /// Runs the command to its end; returns messages that report the result to the client.
    pub(super) fn run(&self) -> Vec<Message> {
        let shown = format!("hedgerow {}", self.arguments.join(" "));
        let program = std::env::current_exe();
        let output = program.and_then(|program| {
            Command::new(program)
                .args(&self.arguments)
                .env("NO_COLOR", "1")
                .stdin(Stdio::null())
                .output()
        });
        let (kind, ending, said) = match output {
            Err(error) => (MessageType::Error, format!("cannot be run: {error}"), String::new()),
            Ok(output) => {
                let said = [output.stdout, output.stderr]
                    .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
                    .concat();
                match output.status.success() {
                    true => (MessageType::Info, "is done".to_owned(), said),
                    false => (MessageType::Error, format!("failed: {}", output.status), said),
                }
            }
        };
        let log = LogMessageParams { kind, message: format!("$ {shown}\n{said}") };
        let show = ShowMessageParams { kind, message: format!("`{shown}` {ending}") };
        let notice = |method: &str, params: serde_json::Value| {
            Message::from(Notification::new(method.to_owned(), params))
        };
        vec![
            notice(
                LogMessageNotification::METHOD.as_str(),
                serde_json::to_value(log).unwrap_or_default(),
            ),
            notice(
                ShowMessageNotification::METHOD.as_str(),
                serde_json::to_value(show).unwrap_or_default(),
            ),
        ]
    }
}
