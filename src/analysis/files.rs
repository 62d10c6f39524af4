//! The files of a program: found by `use`, each once.
//!
//! A path is looked up beside the file that uses it; one that begins with `std/` is a file of the
//! [library](crate::library). Files are accessed through a [`Reader`], which gives texts for names,
//! and says which names are of the same file.
//! No file may use itself, directly or through others.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::rc::Rc;
use std::vec::IntoIter;

use strsim::damerau_levenshtein;

use super::parse_cache::ParseCache;
use crate::diagnostic::Diagnostic;
use crate::library::{self, FOLDER};
use crate::resolve::{Unit, qualifier};
use crate::source::{FileId, Sources, Span};
use crate::syntax::Parsed;
use crate::syntax::tree::Item;

/// A source of texts, by their names.
pub trait Reader {
    /// The text of a file, by its name.
    ///
    /// # Errors
    /// The reason, in words: "there is no such file".
    fn read(&mut self, name: &str) -> Result<String, String>;

    /// The one name of a file, by whatever path it is reached.
    fn identity(&mut self, name: &str) -> String {
        name.to_owned()
    }

    /// The names of the programs beside a file, for suggestions.
    fn beside(&mut self, name: &str) -> Vec<String>;

    /// The names of the programs in a folder and its subfolders, up to a limit of the reader's.
    fn under(&mut self, _folder: &str) -> Vec<String> {
        Vec::new()
    }
}

/// A reader without files: all files that exist have already been added to the [`Sources`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Nowhere;

impl Reader for Nowhere {
    fn read(&mut self, _name: &str) -> Result<String, String> {
        Err("there is no such file".to_owned())
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }
}

/// A file that could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Missing {
    why: String,
    /// The path that was probably meant, as `use` would write it.
    meant: Option<String>,
}

/// The files that could not be read, by name.
pub(super) type Absent = HashMap<String, Missing>;

/// The words with which items begin.
const ITEMS: [&str; 7] = ["use", "private", "attr", "fn", "op", "script", "test"];

/// Adds every file that `root` uses, directly or through others, to `sources`; returns those that
/// could not be read.
pub(super) fn fetch(
    sources: &mut Sources,
    root: FileId,
    reader: &mut dyn Reader,
    parse_cache: &mut ParseCache,
) -> Absent {
    let mut absent = Absent::new();
    for file in sources.ids() {
        let own = identity(sources.get(file).name(), reader);
        sources.name(file, own);
    }
    let mut seen = HashSet::from([root]);
    let mut open = vec![root];
    while let Some(file) = open.pop() {
        let source = sources.get(file);
        let here = source.name().to_owned();
        let paths = uses(&parse_cache.read(file, source));
        for (path, _) in paths {
            let name = name_of(&here, &path);
            let found = match sources.find(&name) {
                Some(file) => Ok(file),
                None => find_or_add(sources, &name, reader),
            };
            match found {
                Ok(file) if seen.insert(file) => open.push(file),
                Ok(_) => {}
                Err(why) => {
                    let meant = meant(&path, &name, reader);
                    absent.insert(name, Missing { why, meant });
                }
            }
        }
    }
    absent
}

/// The file of a name that is new: one that is known under another, or one that is read now.
fn find_or_add(
    sources: &mut Sources,
    name: &str,
    reader: &mut dyn Reader,
) -> Result<FileId, String> {
    let own = identity(name, reader);
    let file = match sources.find(&own) {
        Some(file) => file,
        None => sources.add(name, text_of(name, reader)?),
    };
    sources.name(file, name);
    sources.name(file, own);
    Ok(file)
}

/// The one name of a file, by whatever path it is used.
fn identity(name: &str, reader: &mut dyn Reader) -> String {
    let own = library::file(name).filter(|_| name.starts_with(FOLDER));
    own.map_or_else(|| reader.identity(name), |file| file.name.to_owned())
}

fn text_of(name: &str, reader: &mut dyn Reader) -> Result<String, String> {
    if name.starts_with(FOLDER) {
        let file = library::file(name);
        let text = file.map(|file| file.text.to_owned());
        return text.ok_or_else(|| "`hedgerow std` lists the library".to_owned());
    }
    let text = reader.read(name)?;
    match is_program(&text) {
        true => Ok(text),
        false => {
            Err("it is not a program: one begins with an item, such as `op` or `use`".to_owned())
        }
    }
}

/// True if a text can be a program, by its first word. Other texts are not parsed, so that no
/// message quotes them.
fn is_program(text: &str) -> bool {
    let lines = text.trim_start_matches('\u{feff}').lines().map(str::trim_start);
    let mut lines = lines.filter(|line| !line.is_empty() && !line.starts_with("//"));
    let is_word = |letter: char| letter.is_alphanumeric() || letter == '_';
    let word = |line: &str| line.split(|letter| !is_word(letter)).next().unwrap_or("").to_owned();
    lines.next().is_none_or(|line| ITEMS.contains(&word(line).as_str()))
}

/// The name of the file that `path` refers to in the file `here`.
pub(super) fn name_of(here: &str, path: &str) -> String {
    if path.starts_with(FOLDER) {
        return path.to_owned();
    }
    let folder = here.rsplit_once('/').map_or("", |(folder, _)| folder);
    let folder = if path.starts_with('/') { "/" } else { folder };
    let rooted = here.starts_with('/') || path.starts_with('/');
    let mut steps: Vec<&str> = folder.split('/').filter(|step| !step.is_empty()).collect();
    for step in path.split('/') {
        match step {
            "" | "." => {}
            ".." if steps.last().is_some_and(|last| *last != "..") => {
                steps.pop();
            }
            ".." if rooted => {}
            step => steps.push(step),
        }
    }
    let root = if rooted { "/" } else { "" };
    library::outside(format!("{root}{}", steps.join("/")))
}

/// An existing path with a spelling similar to that of `path`, which does not exist. `name` is the
/// file that `path` refers to.
pub fn meant(path: &str, name: &str, reader: &mut dyn Reader) -> Option<String> {
    let last = |name: &str| name.rsplit('/').next().unwrap_or(name).to_owned();
    let folder = &path[..path.len() - last(path).len()];
    let mut known: Vec<String> = library::files().map(|file| file.name.to_owned()).collect();
    if !name.starts_with(FOLDER) {
        let beside = reader.beside(name).into_iter();
        known.extend(beside.map(|other| format!("{folder}{}", last(&other))));
    }
    if known.iter().any(|other| other == path) {
        return None; // it is there, and cannot be had for another reason
    }
    let stem = |name: &str| last(name).trim_end_matches(".hedge").to_owned();
    let distance = |other: &String| {
        let ended = format!("{path}.hedge");
        let apart = |one: &str| damerau_levenshtein(one, other);
        let alone = damerau_levenshtein(&ended, &last(other));
        // `triangel.hedge` for `std/triangle.hedge`: compared without the folder and the ending.
        let (written, known) = (stem(path), stem(other));
        let stems = damerau_levenshtein(&written, &known);
        let is_near = stems <= written.chars().count() / 4;
        let stems = if is_near { stems } else { usize::MAX };
        apart(path).min(apart(&ended)).min(alone).min(stems)
    };
    let near =
        known.into_iter().filter(|other| other != path).min_by_key(|other| distance(other))?;
    let length = stem(path).chars().count();
    // Every short name is near every other.
    (length > 1 && distance(&near) <= (length / 3).max(1)).then_some(near)
}

/// Each path that a file uses, with its span.
fn uses(parsed: &Parsed) -> Vec<(String, Span)> {
    let items = parsed.tree.items.iter();
    let uses = items.filter_map(|item| match item {
        Item::Use(used) => Some((used.path.clone(), used.path_span)),
        _ => None,
    });
    uses.collect()
}

/// A file of the program.
pub(super) struct Part {
    pub file: FileId,
    pub parsed: Rc<Parsed>,
    /// The files it uses, as indices of the parts.
    pub uses: Vec<usize>,
    /// True if a file that it uses could not be read.
    pub lacks: bool,
}

impl Part {
    /// The file as input of `resolve`.
    pub fn unit<'t>(&'t self, sources: &'t Sources) -> Unit<'t> {
        let qualifier = qualifier(sources.get(self.file).name());
        Unit { qualifier, tree: &self.parsed.tree, uses: self.uses.clone(), lacks: self.lacks }
    }
}

/// Removes the diagnostics of the resolver that only follow from items that cannot be parsed: those
/// inside such items, and those about unknown names that such items may declare.
pub(super) fn without_consequences(parts: &[Part], told: &mut Vec<Diagnostic>, sources: &Sources) {
    let unread: Vec<(Span, bool)> = parts.iter().flat_map(unread).collect();
    let names = unread.iter().filter(|(_, is_lost)| *is_lost);
    let names: Vec<&str> = names
        .flat_map(|(span, _)| {
            let head = sources.slice(*span).split('{').next().unwrap_or("");
            head.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
        })
        .collect();
    told.retain(|told| {
        let place = told.span();
        let inside = unread.iter().any(|(item, _)| touches(*item, place));
        let is_unknown = matches!(
            told.code,
            "unknown-op" | "unknown-function" | "unknown-attribute" | "unknown-field"
        );
        let is_lost = is_unknown && names.contains(&sources.slice(place));
        !inside && !is_lost
    });
}

/// The declarations of attributes that have errors.
pub(super) fn lost_attributes(parts: &[Part], told: &[Diagnostic]) -> Vec<Span> {
    let is_wrong = |item: Span| {
        told.iter().filter(|error| error.code != MISSING).any(|error| touches(item, error.span()))
    };
    let lost = parts.iter().flat_map(|part| {
        let tree = &part.parsed.tree;
        let declared = tree.items.iter().filter(|item| matches!(item, Item::Attr(_)));
        declared.map(Item::span).filter(|&item| tree.is_misread(item) || is_wrong(item))
    });
    lost.collect()
}

/// True if an error says that new elements lack an attribute whose declaration is among these:
/// whether it has a default is unknown.
pub(super) fn is_about_lost(lost: &[Span], error: &Diagnostic) -> bool {
    let mut labels = error.labels.iter();
    error.code == MISSING && labels.any(|label| lost.iter().any(|&item| touches(item, label.span)))
}

/// The code of errors about attributes without a value in new elements.
const MISSING: &str = "missing-attribute";

/// True if a place begins in an item, or at its end if it is empty: what stands behind an item does
/// not belong to it.
pub(super) fn touches(item: Span, place: Span) -> bool {
    let is_behind = place.start == item.end && place.start < place.end;
    item.file == place.file && item.touches(place.start as usize) && !is_behind
}

/// The items of a file that cannot be parsed as written, each with whether its name is lost too.
fn unread(part: &Part) -> Vec<(Span, bool)> {
    let items = part.parsed.tree.items.iter();
    let unread = items.filter_map(|item| {
        let is_lost = matches!(item, Item::Broken(_));
        let is_unread = is_lost || part.parsed.tree.is_misread(item.span());
        is_unread.then_some((item.span(), is_lost))
    });
    unread.collect()
}

/// The files of a program, the root first, and the errors of their `use`.
#[derive(Default)]
pub(super) struct Parts {
    pub parts: Vec<Part>,
    pub diagnostics: Vec<Diagnostic>,
    places: HashMap<FileId, usize>,
}

/// A file whose `use` are being followed.
struct Open {
    file: FileId,
    place: usize,
    /// The `use` that led to it, but for the root.
    way: Option<Span>,
    uses: IntoIter<(String, Span)>,
}

impl Parts {
    /// Collects the files of the program `root` from `sources`.
    pub fn of(
        sources: &Sources,
        root: FileId,
        absent: &Absent,
        parse_cache: &mut ParseCache,
    ) -> Self {
        let mut parts = Self::default();
        let mut open = vec![parts.open(sources, root, None, parse_cache)];
        while let Some(last) = open.last_mut() {
            let Some((path, span)) = last.uses.next() else {
                open.pop();
                continue;
            };
            let place = last.place;
            let name = name_of(sources.get(last.file).name(), &path);
            let Some(used) = sources.find(&name) else {
                parts.misses(place, missing_file(&path, &name, span, absent.get(&name)));
                continue;
            };
            let known = parts.places.get(&used).copied();
            let at = known.and_then(|_| open.iter().position(|open| open.file == used));
            if let Some(at) = at {
                parts.diagnostics.push(cycle(sources, &open[at..], span));
                continue;
            }
            let used = known.unwrap_or_else(|| {
                open.push(parts.open(sources, used, Some(span), parse_cache));
                parts.parts.len() - 1
            });
            let uses = &mut parts.parts[place].uses;
            if !uses.contains(&used) {
                uses.push(used);
            }
        }
        parts
    }

    /// Adds a file.
    fn open(
        &mut self,
        sources: &Sources,
        file: FileId,
        way: Option<Span>,
        parse_cache: &mut ParseCache,
    ) -> Open {
        let parsed = parse_cache.read(file, sources.get(file));
        let uses = uses(&parsed).into_iter();
        let place = self.parts.len();
        self.places.insert(file, place);
        self.parts.push(Part { file, parsed, uses: Vec::new(), lacks: false });
        Open { file, place, way, uses }
    }

    /// Notes that a part uses a file that could not be read.
    fn misses(&mut self, place: usize, missing: Diagnostic) {
        let part = &mut self.parts[place];
        part.lacks = true;
        // If the path is not even a text, that has been reported.
        let mut told = part.parsed.diagnostics.iter();
        if !told.any(|told| told.span() == missing.span()) {
            self.diagnostics.push(missing);
        }
    }
}

fn missing_file(path: &str, name: &str, span: Span, missing: Option<&Missing>) -> Diagnostic {
    let message = format!("`{path}` cannot be used");
    let why = missing.map_or("it has not been read", |missing| &missing.why);
    let error = Diagnostic::error("missing-file", message, span);
    let error = match name == path || name.is_empty() {
        true => error.note(why.to_owned()),
        false => error.note(format!("{name}: {why}")),
    };
    error.with(missing.and_then(|missing| missing.meant.as_ref()), |error, meant| {
        let path = format!("\"{meant}\"");
        let error = error.saying(format!("did you mean `{meant}`?"));
        error.fix(format!("write `{path}`"), span, path)
    })
}

/// For each file that the first part uses, directly or through others, the first `use` in that part
/// that leads to it.
pub(super) fn ways(sources: &Sources, parts: &[Part]) -> BTreeMap<FileId, Span> {
    let mut ways = BTreeMap::new();
    let Some(root) = parts.first() else { return ways };
    let here = sources.get(root.file).name();
    for (path, span) in uses(&root.parsed) {
        let used = sources.find(&name_of(here, &path));
        let mut open: Vec<_> =
            root.uses.iter().filter(|&&at| Some(parts[at].file) == used).collect();
        while let Some(&at) = open.pop() {
            if let Entry::Vacant(way) = ways.entry(parts[at].file) {
                way.insert(span);
                open.extend(&parts[at].uses);
            }
        }
    }
    ways
}

/// The error that a used file has errors, which are reported in full where it is checked itself.
pub(super) fn broken_file(name: &str, used: Span, errors: &[&Diagnostic]) -> Diagnostic {
    let many = match errors.len() {
        1 => "an error".to_owned(),
        count => format!("{count} errors"),
    };
    let error = Diagnostic::error("broken-file", format!("`{name}` has {many}"), used);
    error.with(errors.first(), |error, first| {
        error.label(first.span(), first.message.clone()).note(first.message.clone())
    })
}

/// The error that the last file of a chain uses the first.
fn cycle(sources: &Sources, chain: &[Open], last: Span) -> Diagnostic {
    let names = chain.iter().map(|open| sources.get(open.file).name());
    let names: Vec<_> = names.map(|name| format!("`{name}`")).collect();
    let message = match names.as_slice() {
        [only] => format!("{only} uses itself"),
        [first, others @ ..] => {
            format!("{first} uses {}, which uses {first}", others.join(", which uses "))
        }
        [] => "the file uses itself".to_owned(),
    };
    let mut error = Diagnostic::error("cyclic-use", message, last);
    for way in chain.iter().skip(1).filter_map(|open| open.way) {
        error = error.label(way, "used here");
    }
    error.note("what both files need can stand in a third")
}
