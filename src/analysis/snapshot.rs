//! The analysis of one text of an editor.
//!
//! A snapshot works whatever state the text is in: it has the tree of what can be parsed, the index
//! of its names, and for each op its proof. Proofs are found on demand, and kept from one snapshot
//! of a document to the next; so is the last diagram of each op that could be read, to be shown
//! while the op is being edited.

use std::cell::{Cell, OnceCell, RefCell};
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::rc::Rc;

use super::empty_loops::empty_loops;
use super::endless_loops::endless_loops;
use super::files::{Reader, fetch, name_of};
use super::hidden_guards::hidden_guards;
use super::kept_comments::keep_comments;
use super::names::Names;
use super::op_context::{Meanings, Read};
use super::reading::Reading;
use super::snapshot_cache::{CacheKey, SnapshotCache};
use super::{Examined, NoExample, StepsVerdict, Verdict, example, files};
use crate::check::Proved;
use crate::diagnostic::Diagnostic;
use crate::diagram::{self, Property, Type};
use crate::library;
use crate::resolve::{Fields, Program, Types, qualifier};
use crate::rewrite::Plans;
use crate::run::{Functions, calls_of_steps, plan_steps};
use crate::source::{FileId, Sources, Span};
use crate::syntax::Parsed;
use crate::syntax::tree::{self, Item, split_qualified};

/// The analysis of one text.
#[derive(Clone, Debug)]
pub struct Snapshot {
    sources: Sources,
    file: FileId,
    parsed: Rc<Parsed>,
    used: Vec<(FileId, Rc<Parsed>)>,
    seen: Vec<FileId>,
    /// For each file that it uses, directly or through others, the `use` that leads to it.
    ways: BTreeMap<FileId, Span>,
    program: Program,
    /// The meanings of the words after dots.
    fields: Fields,
    /// The types of variables, by the spans of their names.
    types: Types,
    /// The indices of the ops of the program, by the spans of their names.
    places: HashMap<Span, usize>,
    functions: Functions,
    /// The diagnostics found before anything is proved, in any file.
    told: Vec<Diagnostic>,
    /// The declarations of attributes that have errors.
    lost: Vec<Span>,
    names: OnceCell<Names>,
    /// For each op, a fingerprint of what its words mean outside of it.
    meanings: OnceCell<Vec<u64>>,
    /// The ops that have to be proved, in order: its own, what the steps of those call, and
    /// those of used files that may break here.
    due: Vec<usize>,
    /// The number of those that have been examined, from the first.
    done: Cell<usize>,
    examined: Vec<OnceCell<Rc<Examined>>>,
    planned: OnceCell<Planned>,
    /// The examples of ops in steps that have been computed.
    examples: RefCell<BTreeMap<usize, Result<Rc<diagram::Op>, NoExample>>>,
    cache: Rc<RefCell<SnapshotCache>>,
}

impl Snapshot {
    /// Analyzes the first text of a document. The reader gives the files it uses.
    pub fn new(name: &str, text: &str, reader: &mut dyn Reader) -> Self {
        Self::read(name, text, reader, Rc::default())
    }

    /// Analyzes the next text of the same document.
    pub fn next(&self, text: &str, reader: &mut dyn Reader) -> Self {
        let name = self.sources.get(self.file).name();
        let next = Self::read(name, text, reader, Rc::clone(&self.cache));
        let readable: HashSet<&str> = next.diagrams().map(|(name, _)| name).collect();
        let lost = self.diagrams().filter(|(name, _)| !readable.contains(name));
        let lost = lost.map(|(name, diagram)| (name.to_owned(), Rc::new(diagram.clone())));
        self.cache.borrow_mut().lose(lost, text);
        next
    }

    /// The diagrams of the ops of the text, by name.
    fn diagrams(&self) -> impl Iterator<Item = (&str, &diagram::Op)> {
        let own = self.program.ops.iter().filter(|op| op.span.file == self.file);
        own.filter_map(|op| Some((op.name.as_str(), op.diagram.as_ref()?)))
    }

    fn read(
        name: &str,
        text: &str,
        reader: &mut dyn Reader,
        cache: Rc<RefCell<SnapshotCache>>,
    ) -> Self {
        let mut sources = Sources::new();
        let file = sources.add(name, text);
        let reading = {
            let parse_cache = &mut cache.borrow_mut().parse_cache;
            let absent = fetch(&mut sources, file, reader, parse_cache);
            Reading::of(&sources, file, &absent, parse_cache)
        };
        let Reading { mut parts, program, fields, types, names, functions, diagnostics: mut told } =
            reading;
        let lost = files::lost_attributes(&parts, &told);
        let seen = parts[0].uses.iter().map(|&used| parts[used].file).collect();
        let ways = files::ways(&sources, &parts);
        let own = parts.remove(0);
        let used = parts.into_iter().map(|part| (part.file, part.parsed)).collect();
        told.extend(endless_loops(&program));
        told.extend(empty_loops(&program));
        keep_comments(&mut told, &sources);
        let due = due(&program, &functions, (file, &sources));
        let places = program.ops.iter().enumerate().map(|(number, op)| (op.span, number));
        Self {
            names: names.map_or_else(OnceCell::new, OnceCell::from),
            meanings: OnceCell::new(),
            examined: vec![OnceCell::new(); program.ops.len()],
            sources,
            file,
            parsed: own.parsed,
            used,
            seen,
            ways,
            due,
            done: Cell::new(0),
            places: places.collect(),
            program,
            fields,
            types,
            functions,
            planned: OnceCell::new(),
            examples: RefCell::default(),
            told,
            lost,
            cache,
        }
    }

    pub fn text(&self) -> &str {
        self.sources.get(self.file).text()
    }

    /// The sources that the spans of results refer to.
    pub fn sources(&self) -> &Sources {
        &self.sources
    }

    /// The file of the text in the sources.
    pub fn file(&self) -> FileId {
        self.file
    }

    /// Its tree, tokens and comments.
    pub fn parsed(&self) -> &Parsed {
        &self.parsed
    }

    /// The files it uses, directly or through others.
    pub fn used(&self) -> impl Iterator<Item = (FileId, &tree::File)> {
        self.used.iter().map(|(file, read)| (*file, &read.tree))
    }

    /// The items that a name may mean, and their own name: those of the text, then those of the files
    /// that it uses itself; a qualified name, `polygon::flip`, means those of that file.
    pub fn items_for<'n>(&self, name: &'n str) -> (impl Iterator<Item = &Item>, &'n str) {
        let (file, name) = split_qualified(name);
        let own = self.items().iter().filter(move |_| file.is_none());
        (own.chain(self.seen_items(file)), name)
    }

    /// The items that are not private of the files that it uses itself, or only of those of a
    /// qualifier.
    pub fn seen_items(&self, of: Option<&str>) -> impl Iterator<Item = &Item> {
        let is_of = move |file| of.is_none_or(|of| qualifier(self.sources.get(file).name()) == of);
        let files = self.used().filter(move |(file, _)| self.seen.contains(file) && is_of(*file));
        files.flat_map(|(_, tree)| &tree.items).filter(|item| item.private_name().is_none())
    }

    /// The names of the files it uses, directly or through others.
    pub fn used_names(&self) -> impl Iterator<Item = String> {
        self.used().map(|(file, _)| self.sources.get(file).name().to_owned())
    }

    /// The file that a `use` of the text refers to, if it could be read.
    pub fn used_file(&self, path: &str) -> Option<FileId> {
        self.sources.find(&name_of(self.sources.get(self.file).name(), path))
    }

    /// True if it depends on a file of this name, or in a folder of this name, whether that exists or
    /// not.
    pub fn looks_for(&self, file: &str) -> bool {
        let is_it = |name: &str| {
            name.strip_prefix(file).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
        };
        let has = self.sources.find(file).is_some_and(|found| found != self.file);
        let looks = |(here, tree): (FileId, &tree::File)| {
            let here = self.sources.get(here).name();
            let mut items = tree.items.iter();
            items.any(|item| matches!(item, Item::Use(used) if is_it(&name_of(here, &used.path))))
        };
        has || std::iter::once((self.file, &self.parsed.tree)).chain(self.used()).any(looks)
    }

    pub fn items(&self) -> &[Item] {
        &self.parsed.tree.items
    }

    pub fn names(&self) -> &Names {
        self.names.get_or_init(|| Names::of(&self.parsed.tree, &self.fields))
    }

    /// The declarations of the program.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// The type of the variable that is declared at a span, as far as it is known.
    pub fn type_at(&self, name: Span) -> Option<Type> {
        self.types.get(&name).copied()
    }

    /// The index in the program of an op of the tree.
    pub fn resolved(&self, op: &tree::Op) -> Option<usize> {
        self.places.get(&op.name.span).copied()
    }

    /// The diagram of an op: of this text, or else of the last one in which it could be read.
    pub fn readable(&self, op: &tree::Op) -> Option<Rc<diagram::Op>> {
        if op.span.file != self.file {
            let at = self.resolved(op)?;
            return self.program.ops[at].diagram.clone().map(Rc::new);
        }
        let name = &op.name.text;
        let own = self.resolved(op).and_then(|at| self.program.ops[at].diagram.as_ref());
        let mut here = self.diagrams();
        match own.or_else(|| here.find(|(of, _)| of == name).map(|(_, diagram)| diagram)) {
            Some(diagram) => Some(Rc::new(diagram.clone())),
            None => self.cache.borrow().lost.get(name).cloned(),
        }
    }

    /// True if the diagram of an op can be read in this text.
    pub fn is_readable(&self, op: &tree::Op) -> bool {
        self.resolved(op).is_some_and(|at| self.program.ops[at].diagram.is_some())
    }

    /// The result for an op of the program, by its index.
    pub fn examined(&self, op: usize) -> &Examined {
        self.examined[op].get_or_init(|| self.examine(op))
    }

    /// Proves one more op; false if none is left.
    pub fn examine_next(&self) -> bool {
        let left = &self.due[self.done.get()..];
        let known = left.iter().take_while(|&&op| self.examined[op].get().is_some()).count();
        self.done.set(self.done.get() + known);
        match left.get(known) {
            Some(&op) => {
                self.examined(op);
                true
            }
            None => false,
        }
    }

    /// The number of ops that have been examined, and of those to examine.
    pub fn progress(&self) -> (usize, usize) {
        (self.done.get(), self.due.len())
    }

    /// The verdict on an op of the tree.
    pub fn verdict(&self, op: &tree::Op) -> Verdict {
        let known = self.resolved(op);
        let proved = known.and_then(|at| self.examined(at).proved.as_ref());
        let steps = known.filter(|_| op.steps.is_some());
        let steps = steps.and_then(|at| StepsVerdict::of(&self.program, &self.planned().plans, at));
        let lacks = known.and_then(|at| self.examined(at).lacks.clone());
        Verdict::of(&op.name.text, proved, steps, lacks)
    }

    /// An example of a proved op in steps; `None` for any other op.
    pub fn example(&self, op: &tree::Op) -> Option<Result<Rc<diagram::Op>, NoExample>> {
        let at = self.resolved(op)?;
        self.program.ops[at].steps.as_ref()?;
        if let Some(known) = self.examples.borrow().get(&at) {
            return Some(known.clone());
        }
        let plans = match self.due.binary_search(&at).is_ok() {
            true => &self.planned().plans,
            // An op that the text does not declare, and perhaps does not call.
            false => &self.plan(&reached(&self.program, &self.functions, vec![at])).plans,
        };
        plans.get(at)?.as_ref()?;
        let found = example(&self.program, at, plans).map(Rc::new);
        self.examples.borrow_mut().insert(at, found.clone());
        Some(found)
    }

    /// The plans of ops in steps, and of those that they call.
    fn planned(&self) -> &Planned {
        self.planned.get_or_init(|| {
            let ops = &self.program.ops;
            let mut planned = match self.due.iter().all(|&op| ops[op].steps.is_none()) {
                true => Planned::default(),
                false => self.plan(&self.due),
            };
            let keeps = |op: usize| self.keeps(op);
            planned.told.extend(hidden_guards(&self.program, self.file, &self.seen, keeps));
            planned
        })
    }

    fn keeps(&self, op: usize) -> Vec<Property> {
        self.examined(op).proved.as_ref().map(Proved::keeps).unwrap_or_default()
    }

    /// The plans of the ops in `due`, which include all that their steps call.
    fn plan(&self, due: &[usize]) -> Planned {
        let mut plans = vec![None; self.program.ops.len()];
        for &op in due {
            plans[op] = self.examined(op).plan.clone();
        }
        let keeps = |op: usize| self.keeps(op);
        let told = plan_steps(&self.program, &self.functions, keeps, &mut plans);
        Planned { plans: plans.into(), told }
    }

    fn examine(&self, op: usize) -> Rc<Examined> {
        let meaning = self.meanings()[op];
        let op = &self.program.ops[op];
        let span = op.diagram.as_ref().map_or(op.span, |diagram| diagram.span);
        let key = CacheKey { text: self.sources.slice(span), span, meaning };
        let known = self.cache.borrow().get(key);
        if let Some(known) = known.filter(|_| op.diagram.is_some()) {
            return known;
        }
        let examined = Rc::new(Examined::of(op, &self.told, &self.sources, &self.functions));
        let labels = examined.diagnostics.iter().flat_map(|told| &told.labels);
        let is_alone = labels.map(|label| label.span).all(|label| {
            label.file == span.file && span.start <= label.start && label.end <= span.end
        });
        let was_read = examined.proved.is_some() || !examined.diagnostics.is_empty();
        if is_alone && was_read {
            let ops = self.program.ops.iter().filter_map(|op| op.diagram.as_ref());
            let written = ops.map(|diagram| self.sources.slice(diagram.span));
            self.cache.borrow_mut().keep(key, &examined, written);
        }
        examined
    }

    /// For each op, a fingerprint of what its words mean outside of it.
    fn meanings(&self) -> &[u64] {
        self.meanings.get_or_init(|| {
            let used = self.used.iter().map(|(file, parsed)| (*file, &**parsed));
            let files = [(self.file, &*self.parsed)].into_iter().chain(used);
            let files: BTreeMap<FileId, Read> =
                files.map(|(file, parsed)| (file, Read::of(&self.sources, file, parsed))).collect();
            let meanings = Meanings::of(&self.program, files.values().copied());
            let ops = self.program.ops.iter().map(|op| {
                let place = op.diagram.as_ref().map(|diagram| diagram.span);
                let read = place.and_then(|place| Some((*files.get(&place.file)?, place)));
                read.map_or(0, |(file, place)| meanings.fingerprint(file, place))
            });
            ops.collect()
        })
    }

    /// The diagnostics found before anything is proved, in any file.
    pub(super) fn told(&self) -> impl Iterator<Item = &Diagnostic> {
        self.told.iter()
    }

    /// All diagnostics, in text order. Errors in a file that it uses are reported at the `use`.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let proved = self.due.iter().flat_map(|&op| &self.examined(op).diagnostics);
        let planned = &self.planned().told;
        self.located(self.told.iter().chain(proved).chain(planned))
    }

    /// The diagnostics so far, without examining more ops.
    pub fn diagnostics_so_far(&self) -> Vec<Diagnostic> {
        let examined = self.due.iter().filter_map(|&op| self.examined[op].get());
        let proved = examined.flat_map(|examined| &examined.diagnostics);
        let planned = self.planned.get().into_iter().flat_map(|planned| &planned.told);
        self.located(self.told.iter().chain(proved).chain(planned))
    }

    fn located<'d>(&self, told: impl Iterator<Item = &'d Diagnostic>) -> Vec<Diagnostic> {
        let told = told.filter(|told| !files::is_about_lost(&self.lost, told));
        let (mut here, there): (Vec<_>, Vec<_>) =
            told.partition(|told| told.span().file == self.file);
        let mut broken: BTreeMap<FileId, Vec<&Diagnostic>> = BTreeMap::new();
        for told in there.into_iter().filter(|told| told.is_error()) {
            broken.entry(told.span().file).or_default().push(told);
        }
        let broken = broken.iter().filter_map(|(file, errors)| {
            let name = self.sources.get(*file).name();
            Some(files::broken_file(name, *self.ways.get(file)?, errors))
        });
        let broken: Vec<_> = broken.collect();
        here.extend(&broken);
        here.sort_by_key(|diagnostic| diagnostic.span().start);
        // An error in a declaration is reported once, not for each op that it concerns.
        here.dedup_by(|next, last| {
            (next.code, &next.message, next.span()) == (last.code, &last.message, last.span())
        });
        here.into_iter().cloned().collect()
    }

    /// The item that covers a byte, and its index.
    pub fn item_at(&self, offset: usize) -> Option<(usize, &Item)> {
        self.items().iter().enumerate().find(|(_, item)| item.span().touches(offset))
    }

    /// The op that covers a byte, and the index of its item.
    pub fn op_at(&self, offset: usize) -> Option<(usize, &tree::Op)> {
        let (at, item) = self.item_at(offset)?;
        Some((at, item.op()?))
    }

    /// The rule that covers a byte, with its op, and the indices of both.
    pub fn rule_at(&self, offset: usize) -> Option<(usize, usize, &tree::Op)> {
        let (item, op) = self.op_at(offset)?;
        let rule = op.rules.iter().position(|rule| rule.span.touches(offset))?;
        Some((item, rule, op))
    }
}

/// The results for ops in steps.
#[derive(Clone, Debug, Default)]
struct Planned {
    plans: Plans,
    told: Vec<Diagnostic>,
}

/// The ops of a file, those of used files that may break, and all that their steps call. Ops of the
/// library may break only if a new attribute has no default.
fn due(
    program: &Program,
    functions: &Functions,
    (file, sources): (FileId, &Sources),
) -> Vec<usize> {
    let is_ours = |of: FileId| !sources.get(of).name().starts_with(library::FOLDER);
    let mut attributes = program.attributes.iter();
    let is_wanted = attributes.any(|attr| attr.lacks_default && is_ours(attr.span.file));
    let is_due = |of: FileId| of == file || is_wanted || is_ours(of);
    let own = (0..program.ops.len()).filter(|&at| is_due(program.ops[at].span.file));
    reached(program, functions, own.collect())
}

/// Some ops, and all that their steps call, directly or through others.
fn reached(program: &Program, functions: &Functions, mut open: Vec<usize>) -> Vec<usize> {
    if open.iter().all(|&at| program.ops[at].steps.is_none()) {
        return open;
    }
    let calls = calls_of_steps(program, functions);
    let mut reached = BTreeSet::new();
    while let Some(op) = open.pop() {
        if reached.insert(op) {
            open.extend(calls.get(&op).into_iter().flatten());
        }
    }
    reached.into_iter().collect()
}
