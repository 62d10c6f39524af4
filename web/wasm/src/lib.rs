//! hedgerow as WebAssembly: a language server and a workbench, behind four functions.
//!
//! A page writes a message where [`take`] says, hands it to [`lsp`] or [`ask`], and reads the answer
//! where that says: four bytes with its length, little-endian, then so many bytes. What `lsp` takes
//! and gives are lists of messages of the Language Server Protocol, as JSON; what `ask` takes and
//! gives are messages of [`hedgerow::play`]. There is one of each in an instance, and no thread but
//! its own.

use std::cell::RefCell;
use std::ops::ControlFlow;

use hedgerow::analysis::{Nowhere, Reader};
use hedgerow::lsp::Server;
use hedgerow::play::{Host, Message, Workbench};

/// The memory for a mesh and lists, in bytes. Of the 4 GiB of an instance, the rest is for the
/// history of a run, for undo, and for what is shown.
const MEMORY: usize = 1 << 30;

struct State {
    /// The message that is taken in, and the one that is given.
    input: Vec<u8>,
    output: Vec<u8>,
    server: Option<Server>,
    workbench: Option<Workbench>,
}

thread_local! {
    static STATE: RefCell<State> = const {
        RefCell::new(State { input: Vec::new(), output: Vec::new(), server: None, workbench: None })
    };
}

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// A script has gone through so many iterations of so many, or of nobody knows how many: 0.
    fn progress(done: f64, total: f64);
}

/// Room for a message of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn take(length: usize) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        state.input.clear();
        state.input.resize(length, 0);
        state.input.as_mut_ptr()
    })
}

/// Answers messages of the protocol.
#[unsafe(no_mangle)]
pub extern "C" fn lsp() -> *const u8 {
    STATE.with_borrow_mut(|state| {
        let server = state.server.get_or_insert_with(|| Server::new(Box::new(Nowhere)));
        let messages: Vec<lsp_server::Message> =
            serde_json::from_slice(&state.input).unwrap_or_default();
        messages.into_iter().for_each(|message| server.accept(message));
        let mut answers = Vec::new();
        while let Some(more) = server.work() {
            answers.extend(more);
        }
        // Commands that run beside the server have no place to run here.
        server.take_subprocesses();
        state.output.clear();
        state.output.extend([0; 4]);
        let written = serde_json::to_writer(&mut state.output, &answers);
        if written.is_err() {
            state.output.truncate(4);
            state.output.extend(b"[]");
        }
        state.ready()
    })
}

/// Answers a question to the workbench.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> *const u8 {
    STATE.with_borrow_mut(|state| {
        let workbench = state.workbench.get_or_insert_with(|| {
            let mut workbench = Workbench::default();
            workbench.limit_memory(MEMORY);
            workbench
        });
        let answer = match Message::read(&state.input) {
            Ok(question) => workbench.answer(question, &mut Page),
            Err(why) => Message::error(why),
        };
        state.output.clear();
        state.output.extend([0; 4]);
        state.output.extend(answer.write());
        state.ready()
    })
}

impl State {
    /// The answer, with its length before it.
    fn ready(&mut self) -> *const u8 {
        let length = (self.output.len() - 4) as u32;
        self.output[..4].copy_from_slice(&length.to_le_bytes());
        self.output.as_ptr()
    }
}

/// The page, which sees how far a script is. It has no files but those that it gives.
struct Page;

impl Host for Page {
    fn progress(&mut self, done: u64, total: Option<u64>) -> ControlFlow<()> {
        // SAFETY: the function takes two numbers and keeps nothing.
        unsafe { progress(done as f64, total.unwrap_or(0) as f64) };
        ControlFlow::Continue(())
    }

    fn reader(&self) -> Box<dyn Reader> {
        Box::new(Nowhere)
    }
}
