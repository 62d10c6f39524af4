//! One text of an editor, as far as it is understood.
//!
//! A snapshot answers whatever state the text is in: the tree of what can be read, the index
//! of its names, and for each op its proof. Proofs are found when they are asked for, and
//! remembered from one snapshot of a document to the next; so is the last diagram of each
//! op that could be read, for what is shown while somebody types in the middle of it.

use std::cell::{OnceCell, RefCell};
use std::collections::{BTreeMap, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::rc::Rc;
use std::sync::Arc;

use super::files::{Parts, Reader, fetch, name_of};
use super::names::Names;
use super::{Examined, files};
use crate::diagnostic::Diagnostic;
use crate::diagram;
use crate::resolve::{Program, resolve_all};
use crate::rewrite::Function;
use crate::run::Functions;
use crate::source::{FileId, Sources, Span};
use crate::syntax::Parsed;
use crate::syntax::tree::{self, Item};

/// How many proofs are remembered before those of other texts are dropped.
const MOST_REMEMBERED: usize = 1024;

/// What is known of one text.
#[derive(Clone, Debug)]
pub struct Snapshot {
    sources: Sources,
    file: FileId,
    parsed: Parsed,
    used: Vec<(FileId, tree::File)>,
    program: Program,
    functions: Arc<[Function]>,
    told: Vec<Diagnostic>,
    names: Names,
    surroundings: u64,
    examined: Vec<OnceCell<Rc<Examined>>>,
    memory: Rc<RefCell<Memory>>,
}

/// What one snapshot of a document leaves to the next.
#[derive(Clone, Debug, Default)]
struct Memory {
    proofs: HashMap<String, Remembered>,
    readable: BTreeMap<String, Rc<diagram::Op>>,
}

#[derive(Clone, Debug)]
struct Remembered {
    surroundings: u64,
    at: Span,
    examined: Rc<Examined>,
}

impl Snapshot {
    /// Reads the first text of a document. What it uses, the reader gives.
    pub fn new(name: &str, text: &str, reader: &mut dyn Reader) -> Self {
        Self::read(name, text, reader, Rc::default())
    }

    /// Reads the next text of the same document.
    pub fn next(&self, text: &str, reader: &mut dyn Reader) -> Self {
        let name = self.sources.get(self.file).name();
        Self::read(name, text, reader, Rc::clone(&self.memory))
    }

    fn read(name: &str, text: &str, reader: &mut dyn Reader, memory: Rc<RefCell<Memory>>) -> Self {
        let mut sources = Sources::new();
        let file = sources.add(name, text);
        let absent = fetch(&mut sources, file, reader);
        let Parts {
            mut parts,
            diagnostics: mut told,
            ..
        } = Parts::of(&sources, file, &absent);
        let units: Vec<_> = parts.iter().map(files::Part::unit).collect();
        let resolved = resolve_all(&units);
        told.extend(resolved.diagnostics);
        drop(units);
        let own = parts.remove(0);
        let used = parts.into_iter().map(|part| (part.file, part.parsed.tree));
        let Parsed { diagnostics, .. } = &own.parsed;
        told.extend(diagnostics.iter().cloned());
        told.retain(|told| told.span().file == file);
        let program = resolved.program;
        let (functions, too_large) = Functions::of(&program);
        told.extend(
            too_large
                .into_iter()
                .filter(|told| told.span().file == file),
        );
        for op in program.ops.iter().filter(|op| op.span.file == file) {
            if let Some(diagram) = &op.diagram {
                let readable = Rc::new(diagram.clone());
                memory
                    .borrow_mut()
                    .readable
                    .insert(op.name.clone(), readable);
            }
        }
        Self {
            names: Names::of(&own.parsed.tree),
            surroundings: surroundings(&own.parsed.tree, &sources, file),
            examined: vec![OnceCell::new(); program.ops.len()],
            sources,
            file,
            parsed: own.parsed,
            used: used.collect(),
            program,
            functions: functions.code,
            told,
            memory,
        }
    }

    /// The text.
    pub fn text(&self) -> &str {
        self.sources.get(self.file).text()
    }

    /// The texts that spans of answers point into.
    pub fn sources(&self) -> &Sources {
        &self.sources
    }

    /// The file of the text among them.
    pub fn file(&self) -> FileId {
        self.file
    }

    /// Its tree, tokens and comments.
    pub fn parsed(&self) -> &Parsed {
        &self.parsed
    }

    /// The files it uses, directly or through others.
    pub fn used(&self) -> &[(FileId, tree::File)] {
        &self.used
    }

    /// The file that a `use` of the text means, if it could be had.
    pub fn used_file(&self, path: &str) -> Option<FileId> {
        self.sources.find(&self.name_of(path))
    }

    fn name_of(&self, path: &str) -> String {
        name_of(self.sources.get(self.file).name(), path)
    }

    /// Whether it depends on a file of this name, be it there or not.
    pub fn looks_for(&self, file: &str) -> bool {
        let used = self.used.iter().map(|(_, tree)| tree);
        let own = std::iter::once(&self.parsed.tree);
        let has = self
            .sources
            .find(file)
            .is_some_and(|found| found != self.file);
        has || own
            .chain(used)
            .flat_map(|tree| &tree.items)
            .any(|item| matches!(item, Item::Use(used) if self.name_of(&used.path) == file))
    }

    /// Its items.
    pub fn items(&self) -> &[Item] {
        &self.parsed.tree.items
    }

    /// Its names.
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// What it declares.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// The program's op of an op of the tree.
    pub fn resolved(&self, op: &tree::Op) -> Option<usize> {
        let ops = &self.program.ops;
        ops.iter().position(|known| known.span == op.name.span)
    }

    /// The diagram of an op: of this text, or else of the last one in which it could be read.
    pub fn readable(&self, op: &tree::Op) -> Option<Rc<diagram::Op>> {
        self.memory.borrow().readable.get(&op.name.text).cloned()
    }

    /// Whether the diagram of an op can be read in this text.
    pub fn is_readable(&self, op: &tree::Op) -> bool {
        self.resolved(op)
            .is_some_and(|at| self.program.ops[at].diagram.is_some())
    }

    /// What came of an op of the program, by its index.
    pub fn examined(&self, op: usize) -> &Examined {
        self.examined[op].get_or_init(|| self.examine(op))
    }

    /// Proves one more op, and says whether there was one.
    pub fn examine_next(&self) -> bool {
        let left = self.own().find(|&op| self.examined[op].get().is_none());
        match left {
            Some(op) => {
                self.examined(op);
                true
            }
            None => false,
        }
    }

    /// How many ops have been looked at, and how many there are.
    pub fn progress(&self) -> (usize, usize) {
        let done = self.own().filter(|&op| self.examined[op].get().is_some());
        (done.count(), self.own().count())
    }

    /// The ops of the program that stand in this file.
    fn own(&self) -> impl Iterator<Item = usize> + '_ {
        let ops = self.program.ops.iter().enumerate();
        let own = ops.filter(|(_, op)| op.span.file == self.file);
        own.map(|(at, _)| at)
    }

    fn examine(&self, op: usize) -> Rc<Examined> {
        let op = &self.program.ops[op];
        let span = op.diagram.as_ref().map_or(op.span, |diagram| diagram.span);
        let text = self.sources.slice(span);
        if let Some(known) = self.memory.borrow().proofs.get(text)
            && known.surroundings == self.surroundings
            && op.diagram.is_some()
        {
            return moved(&known.examined, known.at, span);
        }
        let examined = Rc::new(Examined::of(op, &self.told, &self.sources, &self.functions));
        let labels = examined.diagnostics.iter().flat_map(|told| &told.labels);
        let is_alone = labels.map(|label| label.span).all(|label| {
            label.file == span.file && span.start <= label.start && label.end <= span.end
        });
        let was_read = examined.proved.is_some() || !examined.diagnostics.is_empty();
        if is_alone && was_read {
            let mut memory = self.memory.borrow_mut();
            if memory.proofs.len() > MOST_REMEMBERED {
                let here = self.text();
                memory.proofs.retain(|text, _| here.contains(text.as_str()));
            }
            let remembered = Remembered {
                surroundings: self.surroundings,
                at: span,
                examined: Rc::clone(&examined),
            };
            memory.proofs.insert(text.to_owned(), remembered);
        }
        examined
    }

    /// Everything that is wrong, in the order of the text.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let mut diagnostics = self.told.clone();
        for op in self.own() {
            diagnostics.extend(self.examined(op).diagnostics.iter().cloned());
        }
        diagnostics.sort_by_key(|diagnostic| diagnostic.span().start);
        diagnostics
    }

    /// The item that covers a byte, and its index.
    pub fn item_at(&self, offset: usize) -> Option<(usize, &Item)> {
        let mut items = self.items().iter().enumerate();
        items.find(|(_, item)| span_of(item).touches(offset))
    }

    /// The op that covers a byte, and the index of its item.
    pub fn op_at(&self, offset: usize) -> Option<(usize, &tree::Op)> {
        match self.item_at(offset)? {
            (at, Item::Op(op)) => Some((at, op)),
            _ => None,
        }
    }

    /// The rule that covers a byte, with its op, and the indices of both.
    pub fn rule_at(&self, offset: usize) -> Option<(usize, usize, &tree::Op)> {
        let (item, op) = self.op_at(offset)?;
        let rule = op.rules.iter().position(|rule| rule.span.touches(offset))?;
        Some((item, rule, op))
    }
}

/// The whole of an item.
pub fn span_of(item: &Item) -> Span {
    match item {
        Item::Use(item) => item.span,
        Item::Attr(item) => item.span,
        Item::Fn(item) => item.span,
        Item::Op(item) => item.span,
        Item::Script(item) => item.span,
        Item::Test(item) => item.span,
        Item::Broken(span) => *span,
    }
}

/// What a proof may depend on besides the op: attributes, functions, and what is used.
fn surroundings(tree: &tree::File, sources: &Sources, file: FileId) -> u64 {
    let mut hasher = DefaultHasher::new();
    for item in &tree.items {
        if matches!(item, Item::Use(_) | Item::Attr(_) | Item::Fn(_)) {
            sources.slice(span_of(item)).hash(&mut hasher);
        }
    }
    for other in sources.ids().filter(|other| *other != file) {
        sources.get(other).text().hash(&mut hasher);
    }
    hasher.finish()
}

/// The same answer for an op that stands elsewhere now.
fn moved(examined: &Rc<Examined>, was: Span, is: Span) -> Rc<Examined> {
    if was == is || examined.diagnostics.is_empty() {
        return Rc::clone(examined);
    }
    let shift = |span: &mut Span| {
        let length = span.end - span.start;
        span.start = (span.start - was.start) + is.start;
        span.end = span.start + length;
        span.file = is.file;
    };
    let mut moved = Examined::clone(examined);
    for diagnostic in &mut moved.diagnostics {
        diagnostic
            .labels
            .iter_mut()
            .for_each(|label| shift(&mut label.span));
        for fix in &mut diagnostic.fixes {
            fix.edits.iter_mut().for_each(|edit| shift(&mut edit.span));
        }
    }
    Rc::new(moved)
}
