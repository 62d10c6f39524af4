//! A program as it is read: all of its files, parsed and resolved, before anything is proved.

use super::before::tell_of_before;
use super::files::{Absent, Part, Parts, without_consequences};
use super::foreign::tell_as_elsewhere;
use super::library_hints::tell_where;
use super::names::Names;
use super::open_loops::tell_how_to_close;
use super::parse_cache::ParseCache;
use super::unused::unused_variables;
use crate::diagnostic::Diagnostic;
use crate::resolve::{Fields, Program, Resolved, Types, resolve_all};
use crate::run::Functions;
use crate::source::{FileId, Sources};

/// A program that has been read.
pub(super) struct Reading {
    /// Its files, the root first.
    pub parts: Vec<Part>,
    /// The declarations of all files.
    pub program: Program,
    /// The meanings of the words after dots.
    pub fields: Fields,
    /// The types of variables.
    pub types: Types,
    /// The names of the root, if there is no error so far.
    pub names: Option<Names>,
    /// Its functions, compiled.
    pub functions: Functions,
    /// The diagnostics so far.
    pub diagnostics: Vec<Diagnostic>,
}

impl Reading {
    /// Reads the program `root` and the files of `sources` that it uses.
    pub fn of(
        sources: &Sources,
        root: FileId,
        absent: &Absent,
        parse_cache: &mut ParseCache,
    ) -> Self {
        let Parts { parts, mut diagnostics, .. } = Parts::of(sources, root, absent, parse_cache);
        let units: Vec<_> = parts.iter().map(|part| part.unit(sources)).collect();
        let Resolved { program, diagnostics: mut resolved, fields, types } = resolve_all(&units);
        without_consequences(&parts, &mut resolved, sources);
        tell_as_elsewhere(&parts, &mut resolved, sources);
        diagnostics.extend(resolved);
        tell_where(&mut diagnostics, sources, &types);
        diagnostics.extend(parts.iter().flat_map(|part| part.parsed.diagnostics.iter().cloned()));
        let (functions, too_large) = Functions::of(&program);
        diagnostics.extend(too_large);
        tell_of_before(&program, &mut diagnostics);
        tell_how_to_close(&program, &mut diagnostics);
        drop(units);
        // Broken code may be what reads them.
        let is_sound = !diagnostics.iter().any(Diagnostic::is_error);
        let names = is_sound.then(|| Names::of(&parts[0].parsed.tree, &fields));
        let unused = names.iter().flat_map(|names| unused_variables(names, &parts[0]));
        diagnostics.extend(unused);
        Self { parts, program, fields, types, names, functions, diagnostics }
    }
}
