//! From a text to proved and compiled operations.

use super::Examined;
use super::broken_dependencies::tell_what_is_lacking;
use super::empty_loops::empty_loops;
use super::endless_loops::endless_loops;
use super::files::{Absent, Reader, fetch, is_about_lost, lost_attributes};
use super::hidden_guards::hidden_guards;
use super::kept_comments::keep_comments;
use super::parse_cache::ParseCache;
use super::reading::Reading;
use crate::check::{Counterexample, Proved};
use crate::diagnostic::Diagnostic;
use crate::resolve::Program;
use crate::rewrite::Plans;
use crate::run::plan_steps;
use crate::source::{FileId, Sources, Span};
use crate::syntax::tree::split_qualified;

/// The analysis of one file, and of those it uses.
#[derive(Clone, Debug)]
pub struct Analysis {
    pub file: FileId,
    /// The files whose items can be named in it: itself first, then those it uses.
    pub seen: Vec<FileId>,
    /// The declarations of all files, each once, those of `file` first.
    pub program: Program,
    /// For each op of the program, its proof, if there is one.
    pub proved: Vec<Option<Proved>>,
    /// For each op of the program, its plan, if it is proved.
    pub plans: Plans,
    /// For each op of the program, the broken thing that it depends on, if that is why it is not
    /// proved.
    pub lacks: Vec<Option<String>>,
    /// A small mesh for each rejected rule that breaks one.
    pub counterexamples: Vec<Counterexample>,
    /// All diagnostics, file by file in text order.
    pub diagnostics: Vec<Diagnostic>,
}

impl Analysis {
    /// Parses, resolves, proves and compiles a file of `sources`, and the files of these that it
    /// uses.
    ///
    /// Nothing is added to `sources`, so a `use` of a missing file is an error, even if the library
    /// has it: see [`Analysis::with`].
    pub fn of(sources: &Sources, file: FileId) -> Self {
        Self::of_present(sources, file, &Absent::new(), &mut ParseCache::default())
    }

    /// As [`Analysis::of`], after adding the files it uses to `sources`: those of the library, and
    /// others from the reader.
    pub fn with(sources: &mut Sources, file: FileId, reader: &mut dyn Reader) -> Self {
        let mut parse_cache = ParseCache::default();
        let absent = fetch(sources, file, reader, &mut parse_cache);
        Self::of_present(sources, file, &absent, &mut parse_cache)
    }

    fn of_present(
        sources: &Sources,
        file: FileId,
        absent: &Absent,
        parse_cache: &mut ParseCache,
    ) -> Self {
        let reading = Reading::of(sources, file, absent, parse_cache);
        let Reading { parts, program, functions, mut diagnostics, .. } = reading;
        let used = parts.first().map(|root| root.uses.as_slice()).unwrap_or_default().iter();
        let seen = std::iter::once(file).chain(used.map(|&used| parts[used].file));
        let seen: Vec<FileId> = seen.collect();
        let mut proved = Vec::new();
        let mut plans = Vec::new();
        let mut lacks = Vec::new();
        let mut counterexamples = Vec::new();
        for op in &program.ops {
            let examined = Examined::of(op, &diagnostics, sources, &functions);
            diagnostics.extend(examined.diagnostics);
            counterexamples.extend(examined.counterexamples);
            proved.push(examined.proved);
            plans.push(examined.plan);
            lacks.push(examined.lacks);
        }
        let keeps = |op: usize| proved[op].as_ref().map(Proved::keeps).unwrap_or_default();
        diagnostics.extend(hidden_guards(&program, file, &seen, keeps));
        diagnostics.extend(endless_loops(&program));
        diagnostics.extend(empty_loops(&program));
        diagnostics.extend(plan_steps(&program, &functions, keeps, &mut plans));
        let lost = lost_attributes(&parts, &diagnostics);
        diagnostics.retain(|error| !is_about_lost(&lost, error));
        tell_what_is_lacking(&program, &parts, sources, (&plans, &diagnostics), &mut lacks);
        keep_comments(&mut diagnostics, sources);
        diagnostics.sort_by_key(|diagnostic| {
            let Span { file, start, .. } = diagnostic.span();
            (file, start)
        });
        // An error in a declaration is reported once, not for each op that it concerns.
        diagnostics.dedup_by(|next, last| {
            (next.code, &next.message, next.span()) == (last.code, &last.message, last.span())
        });
        let plans = plans.into();
        Self { file, seen, program, proved, plans, lacks, counterexamples, diagnostics }
    }

    /// True if there is no error in the file, nor in those it uses.
    pub fn is_sound(&self) -> bool {
        !self.diagnostics.iter().any(Diagnostic::is_error)
    }

    /// The index of the op that a name refers to in the file.
    pub fn op(&self, name: &str) -> Option<usize> {
        let ops = self.program.ops.iter();
        self.meant(name, ops.map(|op| (op.name.as_str(), op.span)))
    }

    /// The index of the script that a name refers to in the file.
    pub fn script(&self, name: &str) -> Option<usize> {
        let scripts = self.program.scripts.iter().map(|script| (script.name.as_str(), script.span));
        self.meant(name, scripts)
    }

    /// The index of the function that a name refers to in the file.
    pub fn function(&self, name: &str) -> Option<usize> {
        let functions = self.program.functions.iter();
        let functions = functions.map(|function| (function.name.as_str(), function.span));
        self.meant(name, functions)
    }

    /// True if the file itself declares an item at this span, not one that it uses.
    pub fn is_own(&self, item: Span) -> bool {
        item.file == self.file
    }

    /// True if the file can name an item, whose name is at this span: an own one, or one of a file
    /// that it uses that is not private.
    pub fn sees(&self, name: Span) -> bool {
        self.is_own(name) || self.seen.contains(&name.file) && !self.program.private.contains(&name)
    }

    /// The item of a name, qualified or not, that the file declares, else that of the first file it
    /// uses that has one.
    fn meant<'p>(&self, name: &str, items: impl Iterator<Item = (&'p str, Span)>) -> Option<usize> {
        let (file, name) = split_qualified(name);
        let qualifier = |span: Span| self.program.qualifiers.get(&span.file).map(String::as_str);
        let is_of = |span: Span| file.is_none() || file == qualifier(span);
        let order = |span: Span| self.seen.iter().position(|&seen| seen == span.file);
        let named = items.enumerate();
        let named =
            named.filter(|(_, (known, span))| *known == name && is_of(*span) && self.sees(*span));
        named.filter_map(|(at, (_, span))| Some((order(span)?, at))).min().map(|(_, at)| at)
    }
}
