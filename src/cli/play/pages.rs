//! The pages that are open in browsers, each with an engine of its own.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::engine::Engine;
use super::folder::Folder;

/// The most pages that have an engine: the least recently used page loses its own.
const MOST_PAGES: usize = 8;

/// The engines of pages, by the numbers of the pages.
pub(super) struct Pages {
    folder: Arc<Folder>,
    open: Mutex<Open>,
}

/// The number of the newest page, and the engines, the most recently used last.
#[derive(Default)]
struct Open {
    newest: u64,
    engines: VecDeque<(u64, Arc<Engine>)>,
}

impl Pages {
    /// No pages yet.
    pub fn new(folder: Arc<Folder>) -> Self {
        Self { folder, open: Mutex::default() }
    }

    /// Opens a page, and returns its number.
    pub fn open(&self) -> u64 {
        let mut open = self.lock();
        if open.engines.len() == MOST_PAGES
            && let Some((_, engine)) = open.engines.pop_front()
        {
            engine.stop();
        }
        open.newest += 1;
        let page = open.newest;
        open.engines.push_back((page, Arc::new(Engine::start(Arc::clone(&self.folder)))));
        page
    }

    /// The engine of a page; `None` if the page has lost it.
    pub fn engine(&self, page: u64) -> Option<Arc<Engine>> {
        let mut open = self.lock();
        let at = open.engines.iter().position(|(known, _)| *known == page)?;
        let used = open.engines.remove(at)?;
        let engine = Arc::clone(&used.1);
        open.engines.push_back(used);
        Some(engine)
    }

    /// Ends the engine of a page that is closed.
    pub fn close(&self, page: u64) {
        self.lock().engines.retain(|(known, engine)| {
            let is_closed = *known == page;
            if is_closed {
                engine.stop();
            }
            !is_closed
        });
    }

    fn lock(&self) -> MutexGuard<'_, Open> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
