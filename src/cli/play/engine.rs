//! The workbench and the language server of a page, each on a thread of its own.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use super::folder::Folder;
use crate::analysis::{Disk, Reader};
use crate::cli::memory;
use crate::lsp::Server;
use crate::play::{Host, Message, Workbench};

/// A workbench and a language server that answer questions.
pub(super) struct Engine {
    asked: Mutex<Sender<(Message, Sender<Message>)>>,
    spoken: Mutex<Sender<(Vec<lsp_server::Message>, Sender<String>)>>,
    run: Arc<Run>,
}

/// The progress of the running script, and whether it is to stop.
#[derive(Debug, Default)]
struct Run {
    done: AtomicU64,
    total: AtomicU64,
    is_stopped: AtomicBool,
}

impl Engine {
    /// Starts both threads.
    pub fn start(folder: Arc<Folder>) -> Self {
        let run = Arc::new(Run::default());
        let (asked, questions) = channel::<(Message, Sender<Message>)>();
        let mut host = Local { run: Arc::clone(&run), folder };
        thread::spawn(move || {
            let mut workbench = Workbench::default();
            workbench.limit_memory(memory::usual());
            for (question, reply) in questions {
                host.run.is_stopped.store(false, Ordering::SeqCst);
                // A page that has disconnected needs no answer.
                let _ = reply.send(workbench.answer(question, &mut host));
            }
        });
        let (spoken, heard) = channel::<(Vec<lsp_server::Message>, Sender<String>)>();
        thread::spawn(move || {
            let mut server = Server::new(Box::new(Disk));
            for (messages, reply) in heard {
                messages.into_iter().for_each(|message| server.accept(message));
                let mut answers = Vec::new();
                while let Some(more) = server.work() {
                    answers.extend(more);
                }
                server.take_subprocesses();
                let _ = reply.send(serde_json::to_string(&answers).unwrap_or_else(|_| "[]".into()));
            }
        });
        Self { asked: Mutex::new(asked), spoken: Mutex::new(spoken), run }
    }

    /// Answers a question to the workbench; `None` if that has ended.
    pub fn ask(&self, question: Message) -> Option<Message> {
        let (reply, answer) = channel();
        let asked = self.asked.lock().unwrap_or_else(PoisonError::into_inner).clone();
        asked.send((question, reply)).ok()?;
        answer.recv().ok()
    }

    /// Answers messages of the Language Server Protocol with a list of messages, as JSON.
    pub fn speak(&self, messages: Vec<lsp_server::Message>) -> Option<String> {
        let (reply, answer) = channel();
        let spoken = self.spoken.lock().unwrap_or_else(PoisonError::into_inner).clone();
        spoken.send((messages, reply)).ok()?;
        answer.recv().ok()
    }

    /// The iterations that the running script has done, and their total.
    pub fn progress(&self) -> [u64; 2] {
        [&self.run.done, &self.run.total].map(|number| number.load(Ordering::Relaxed))
    }

    /// Stops the running script.
    pub fn stop(&self) {
        self.run.is_stopped.store(true, Ordering::SeqCst);
    }
}

/// The host of a workbench on this machine.
struct Local {
    run: Arc<Run>,
    folder: Arc<Folder>,
}

impl Host for Local {
    fn progress(&mut self, done: u64, total: Option<u64>) -> ControlFlow<()> {
        self.run.done.store(done, Ordering::Relaxed);
        self.run.total.store(total.unwrap_or(0), Ordering::Relaxed);
        match self.run.is_stopped.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }

    fn reader(&self) -> Box<dyn Reader> {
        Box::new(Disk)
    }

    fn mesh(&self, name: &str) -> Result<Vec<u8>, String> {
        self.folder.mesh(name)
    }
}
