//! Parse results of the files of a program, kept from one look at it to the next.

use std::collections::HashMap;
use std::rc::Rc;

use crate::source::{FileId, Source};
use crate::syntax::{Parsed, parse, parse_again};

/// Each file as it was read last, with its text then.
#[derive(Clone, Debug, Default)]
pub(super) struct Readings {
    known: HashMap<FileId, (String, Rc<Parsed>)>,
}

impl Readings {
    /// The parse of a file. Nothing is read twice: of a file that has changed only what has changed
    /// in it.
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
