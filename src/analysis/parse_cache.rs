//! Parse results of the files of a program, kept from one analysis to the next.

use std::collections::HashMap;
use std::rc::Rc;

use crate::source::{FileId, Source};
use crate::syntax::{Parsed, parse, parse_again};

/// The last parse result of each file, with its text at that time.
#[derive(Clone, Debug, Default)]
pub(super) struct Readings {
    known: HashMap<FileId, (String, Rc<Parsed>)>,
}

impl Readings {
    /// The parse of a file. An unchanged file is not parsed again, and of a changed one only what
    /// has changed.
    pub(super) fn read(&mut self, file: FileId, source: &Source) -> Rc<Parsed> {
        let text = source.text();
        let read = match self.known.get(&file) {
            Some((known, parsed)) if known == text => return Rc::clone(parsed),
            Some((known, parsed)) => parse_again(file, text, known, parsed),
            None => parse(file, text),
        };
        let read = Rc::new(read);
        self.known.insert(file, (text.to_owned(), Rc::clone(&read)));
        read
    }
}
