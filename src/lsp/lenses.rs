//! Code lenses, and the commands they offer.

use std::fs;
use std::path::PathBuf;

use gen_lsp_types::*;
use serde_json::{Value, json};

use super::requests::{Answer, Refusal};
use super::server::{PendingRequest, Server};
use super::subprocess::Subprocess;
use super::{files, uri};
use crate::analysis::{Offer, lenses, op_card, op_named};

/// Shows the diagram of an op in the preview. Arguments: document, op.
pub(super) const SHOW_DIAGRAM: &str = "hedgerow.showDiagram";
/// Runs a test. Arguments: document, name.
pub(super) const RUN_TEST: &str = "hedgerow.runTest";
/// Runs a script. Arguments: document, name, mesh, file for the result.
pub(super) const RUN_SCRIPT: &str = "hedgerow.runScript";

impl Server {
    /// `textDocument/codeLens`
    pub(super) fn lenses(&mut self, params: CodeLensParams) -> Answer<CodeLensRequest> {
        let document = self.document(&params.text_document.uri)?;
        if !self.client.settings.lenses {
            return Ok(Some(Vec::new()));
        }
        let lenses = lenses(document.snapshot()).into_iter().map(|lens| {
            let command = match lens.offer {
                Offer::Proof | Offer::Diagram => SHOW_DIAGRAM,
                Offer::Test => RUN_TEST,
                Offer::Script => RUN_SCRIPT,
            };
            CodeLens {
                range: document.range(lens.span),
                command: Some(Command {
                    title: lens.title,
                    command: command.into(),
                    arguments: Some(vec![json!(document.uri()), json!(lens.name)]),
                    tooltip: None,
                }),
                data: None,
            }
        });
        Ok(Some(lenses.collect()))
    }

    /// `workspace/executeCommand`
    pub(super) fn execute(
        &mut self,
        params: ExecuteCommandParams,
    ) -> Answer<ExecuteCommandRequest> {
        let arguments = params.arguments.unwrap_or_default();
        let text = |at: usize| arguments.get(at).and_then(Value::as_str).map(str::to_owned);
        let Some(uri) = text(0).map(Uri) else {
            return Err(Refusal::invalid("the first argument is the URI of a document"));
        };
        let name = text(1);
        match params.command.as_str() {
            SHOW_DIAGRAM => self.show_diagram(&uri, name),
            RUN_TEST => {
                let mut command = vec!["test".to_owned(), self.saved(&uri)?];
                if let Some(name) = name {
                    command.extend([format!("--filter={name}"), "--exact".to_owned()]);
                }
                Ok(Some(self.run(command)))
            }
            RUN_SCRIPT => {
                let path = self.saved(&uri)?;
                let (Some(mesh), Some(output)) = (text(2), text(3)) else {
                    let why = "which mesh, and where should the result go? Give `hedgerow.runScript` \
                               the document, the script, the mesh and the output, or run \
                               `hedgerow run FILE::SCRIPT MESH -o OUT` in a terminal";
                    return Err(Refusal::failed(why));
                };
                let program = match name {
                    Some(name) => format!("{path}::{name}"),
                    None => path,
                };
                let command = ["run", &program, &mesh, "-o", &output];
                Ok(Some(self.run(command.map(str::to_owned).to_vec())))
            }
            other => Err(Refusal::invalid(format!("there is no command `{other}`"))),
        }
    }

    fn show_diagram(&mut self, uri: &Uri, name: Option<String>) -> Answer<ExecuteCommandRequest> {
        let snapshot = self.document(uri)?.snapshot();
        let op = name.and_then(|name| op_named(snapshot, &name));
        let card = op.map(|op| op_card(snapshot, op));
        let address = self.preview_address()?;
        match card {
            Some(card) => self.show(&card),
            None => self.follow(uri, 0),
        }
        if self.client.shows_documents() {
            let params = ShowDocumentParams {
                uri: Uri(address.clone()),
                external: Some(true),
                take_focus: Some(false),
                selection: None,
            };
            self.ask::<ShowDocumentRequest>(params, PendingRequest::Other);
        } else {
            self.tell::<ShowMessageNotification>(ShowMessageParams {
                kind: MessageType::Info,
                message: format!("the diagram under the cursor is shown at {address}"),
            });
        }
        Ok(Some(json!(address)))
    }

    /// Queues a command of `hedgerow` for the process to run; the result is reported when it ends.
    fn run(&mut self, arguments: Vec<String>) -> Value {
        let shown = format!("hedgerow {}", arguments.join(" "));
        self.subprocesses.push(Subprocess { arguments });
        json!(shown)
    }

    /// The path of a document that a command can read; the text of the file must be that of the
    /// editor.
    fn saved(&self, of: &Uri) -> Result<String, Refusal> {
        let is_saved = |path: &PathBuf| match (self.document(of), fs::read_to_string(path)) {
            (Ok(document), Ok(text)) => text.trim_start_matches('\u{feff}') == document.text(),
            // The command tells of a file that cannot be read.
            _ => true,
        };
        let path = uri::path(of).filter(is_saved).map(|_| files::name(of));
        path.ok_or_else(|| Refusal::failed("save the document first: commands read files"))
    }
}
