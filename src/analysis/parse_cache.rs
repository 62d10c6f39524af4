//! Parse results of the files of a program, kept from one analysis to the next.

use std::collections::HashMap;
use std::rc::Rc;

use crate::source::{FileId, Source};
use crate::syntax::{Parsed, parse};

/// The last parse result of each file, with its text at that time.
#[derive(Clone, Debug, Default)]
pub(super) struct ParseCache {
    known: HashMap<FileId, (String, Rc<Parsed>)>,
}

impl ParseCache {
    /// The parse of a file. An unchanged file is not parsed again.
    pub(super) fn read(&mut self, file: FileId, source: &Source) -> Rc<Parsed> {
        let text = source.text();
        if let Some((known, parsed)) = self.known.get(&file)
            && known == text
        {
            return Rc::clone(parsed);
        }
        let read = Rc::new(parse(file, text));
        self.known.insert(file, (text.to_owned(), Rc::clone(&read)));
        read
    }
}
