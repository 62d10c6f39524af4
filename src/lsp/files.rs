//! The files that programs use: the texts of open documents, else those that the client gives, else
//! those of the reader.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;
use std::rc::Rc;

use gen_lsp_types::Uri;

use super::uri;
use crate::analysis::{Disk, Reader};
use crate::library;

/// A reader of all files, shared by all documents.
#[derive(Clone)]
pub(super) struct Files {
    open: Rc<RefCell<BTreeMap<String, Held>>>,
    given: Rc<RefCell<BTreeMap<String, Held>>>,
    rest: Rc<RefCell<Box<dyn Reader>>>,
}

#[derive(Clone)]
struct Held {
    uri: Uri,
    text: Rc<str>,
}

impl fmt::Debug for Files {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.open.borrow().keys()).finish()
    }
}

/// The name of a document in messages, and for the programs that use it.
pub(super) fn name(of: &Uri) -> String {
    match uri::path(of) {
        Some(path) => path.display().to_string().replace('\\', "/"),
        // Without empty components, as the paths of used programs are joined.
        None => of.0.replace("//", "/"),
    }
}

impl Files {
    pub(super) fn new(rest: Box<dyn Reader>) -> Self {
        let (open, given) = (Rc::default(), Rc::default());
        Self { open, given, rest: Rc::new(RefCell::new(rest)) }
    }

    /// Sets the text of an open document.
    pub(super) fn hold(&self, uri: &Uri, text: &str) {
        let held = Held { uri: uri.clone(), text: text.into() };
        self.open.borrow_mut().insert(name(uri), held);
    }

    /// Sets the text of a file that is not open, from a client whose files cannot be read; `None`
    /// if there is no such file any more.
    pub(super) fn give(&self, uri: &Uri, text: Option<&str>) {
        let mut given = self.given.borrow_mut();
        match text {
            Some(text) => given.insert(name(uri), Held { uri: uri.clone(), text: text.into() }),
            None => given.remove(&name(uri)),
        };
    }

    /// True if a document of this name is open.
    pub(super) fn is_open(&self, name: &str) -> bool {
        self.open.borrow().contains_key(name)
    }

    /// Forgets the text of a closed document: from now on its file counts.
    pub(super) fn release(&self, uri: &Uri) {
        self.open.borrow_mut().remove(&name(uri));
    }

    /// The open document of this name, else the file that the client has given.
    fn held(&self, name: &str) -> Option<Held> {
        let open = self.open.borrow().get(name).cloned();
        open.or_else(|| self.given.borrow().get(name).cloned())
    }

    /// The URI at which an editor finds a file of this name and text. A file of the library is
    /// written to a temporary folder, since it is on no disk.
    pub(super) fn uri(&self, name: &str, text: &str) -> Option<Uri> {
        if let Some(held) = self.held(name) {
            return Some(held.uri);
        }
        if name.starts_with(library::FOLDER) {
            return match cfg!(target_family = "wasm") {
                true => Some(Uri(format!("hedgerow:/{name}"))),
                false => written(name, text).ok(),
            };
        }
        let path = Path::new(name);
        path.is_absolute().then(|| uri::of_path(path))
    }
}

/// Writes a file of the library where an editor can open it, whole or not at all.
fn written(name: &str, text: &str) -> std::io::Result<Uri> {
    let folder = format!("hedgerow-{}", env!("CARGO_PKG_VERSION"));
    let path = std::env::temp_dir().join(folder).join(name);
    if Disk.read(&path.display().to_string()).is_ok_and(|known| known == text) {
        return Ok(uri::of_path(&path));
    }
    let parent = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(parent)?;
    let file = tempfile::NamedTempFile::new_in(parent)?;
    std::fs::write(file.path(), text)?;
    file.persist(&path)?;
    Ok(uri::of_path(&path))
}

impl Reader for Files {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let held = self.held(name).or_else(|| {
            let own = self.identity(name);
            self.held(&own)
        });
        match held {
            Some(held) => Ok(held.text.to_string()),
            None => self.rest.borrow_mut().read(name),
        }
    }

    fn identity(&mut self, name: &str) -> String {
        self.rest.borrow_mut().identity(name)
    }

    fn beside(&mut self, name: &str) -> Vec<String> {
        let mut names = self.rest.borrow_mut().beside(name);
        let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
        let is_beside = |known: &&String| known.rsplit_once('/').map_or("", |(of, _)| of) == folder;
        for held in [&self.open, &self.given] {
            names.extend(held.borrow().keys().filter(is_beside).cloned());
        }
        names.sort();
        names.dedup();
        names
    }
    fn under(&mut self, folder: &str) -> Vec<String> {
        let mut names = self.rest.borrow_mut().under(folder);
        let inside = format!("{}/", folder.trim_end_matches('/'));
        names.extend(self.given.borrow().keys().filter(|it| it.starts_with(&inside)).cloned());
        names
    }
}
