//! Programs from files.

use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::files::is_same;
use super::output::{eprint_diagnostics, eprint_line};
use crate::analysis::{Analysis, Disk, meant, read_program};
use crate::diagnostic::{Diagnostic, counted, quoted};
use crate::library;
use crate::mesh::{FileFormat, Level, Mesh, validate_level};
use crate::resolve::closest;
use crate::rewrite::Plan;
use crate::run::prepare;
use crate::source::{Sources, Span};

/// A program as read from a file.
pub(super) struct Program {
    pub sources: Sources,
    pub analysis: Analysis,
}

/// Reads a program, and the files it uses. Errors inside them are in its diagnostics.
///
/// If a path leads to no file, `.hedge` is appended if that leads to one; a path may also be the
/// name of a file of the library.
pub(super) fn read(path: &Path) -> Result<Program, Failure> {
    let mut longer = path.as_os_str().to_owned();
    longer.push(".hedge");
    let longer = Path::new(&longer);
    let path = if !path.is_file() && longer.is_file() { longer } else { path };
    let shown = path.display().to_string();
    expect_program(path)?;
    let of_library = library::file(&shown).filter(|_| !path.exists());
    let text = of_library.map_or_else(|| read_program(path), |file| Ok(file.text.to_owned()));
    let text = text.map_err(|why| {
        let advice = match (path.read_link(), meant(&shown, &shown, &mut Disk)) {
            _ if path.exists() => String::new(),
            (Ok(target), _) => format!("; it is a link to `{}`", target.display()),
            (_, Some(near)) => format!("; did you mean `{near}`?"),
            _ => String::new(),
        };
        Failure::usage(format!("cannot read `{shown}`: {why}{advice}"))
    })?;
    Ok(Program::of(
        of_library.map_or_else(|| library::outside(shown), |file| file.name.to_owned()),
        text,
    ))
}

impl Program {
    /// Analyzes a text as the program of this name.
    pub(super) fn of(name: String, text: String) -> Self {
        let mut sources = Sources::new();
        let file = sources.add(name, text);
        let analysis = Analysis::with(&mut sources, file, &mut Disk);
        Self { sources, analysis }
    }

    /// Prints the diagnostics that concern the items at some places, and the number of errors in
    /// others; returns the former.
    pub fn complain_about(&self, asked: &[Span]) -> Vec<Diagnostic> {
        let (told, others) = self.analysis.concerning(asked, &self.sources);
        eprint_diagnostics(&told, &self.sources);
        if others > 0 {
            let errors = counted(others, "error", "errors");
            let file = self.sources.get(self.analysis.file).name();
            eprint_line(&format!("{errors} in other items: `hedgerow check {file}`"));
        }
        told
    }

    /// As [`find`]; what could not be read may be what is missing, and is shown.
    fn find(
        &self,
        what: &str,
        known: &[Candidate<'_>],
        wanted: (Option<&str>, Option<usize>),
    ) -> Result<usize, Failure> {
        let found = find(what, known, wanted);
        if found.is_err() && !self.analysis.is_sound() {
            self.complain_about(&[]);
        }
        found
    }

    /// Fails if an output would replace the program or a file that it uses.
    pub fn expect_apart<'o>(
        &self,
        outputs: impl IntoIterator<Item = &'o PathBuf>,
    ) -> Result<(), Failure> {
        let names = || self.sources.ids().map(|file| self.sources.get(file).name());
        let mut outputs = outputs.into_iter();
        let source = outputs.find(|output| names().any(|name| is_same(output, Path::new(name))));
        source.map_or(Ok(()), |source| {
            let shown = source.display();
            Err(Failure::usage(format!(
                "{shown}: this is a source of the program: write -o with the name of another file"
            )))
        })
    }
}

/// A text that says which of the applied ops may have left a mesh that is no surface, or not simple,
/// and which guard would refuse that.
pub(super) fn blame<'n>(
    program: &Program,
    mesh: &Mesh,
    applied: impl IntoIterator<Item = &'n str>,
) -> Option<String> {
    let level = match validate_level(mesh, Level::Surface) {
        Ok(()) => Level::Simple,
        Err(_) => Level::Surface,
    };
    let plans = || program.analysis.plans.iter().flatten();
    let keeps = |plan: &Plan| plan.keeps.contains(&level);
    let mut names: Vec<_> = applied
        .into_iter()
        .filter(|name| plans().any(|plan| plan.name == *name && !keeps(plan)))
        .map(|name| format!("`{name}`"))
        .collect();
    names.sort_unstable();
    names.dedup();
    let last = names.pop()?;
    Some(match names.as_slice() {
        [] => format!("{last} may do that, and `guard {level}` in it refuses where it would"),
        names => format!(
            "{} and {last} may do that, and `guard {level}` in them refuses where they would",
            names.join(", ")
        ),
    })
}

/// True if a file is a mesh, by its name: used where program and mesh may be swapped.
pub(super) fn is_mesh(path: &Path) -> bool {
    path.extension().is_some() && FileFormat::of(path).is_ok()
}

/// Checks that a path may lead to a program: not to a mesh, a folder or an item of a file.
pub(super) fn expect_program(path: &Path) -> Result<(), Failure> {
    let shown = path.display().to_string();
    if is_mesh(path) {
        return Err(Failure::usage(format!(
            "`{shown}` is a mesh; a program is wanted here, as in `hedgerow run FILE.hedge MESH.obj`"
        )));
    }
    if path.is_dir() {
        let folder = shown.trim_end_matches('/');
        return Err(Failure::usage(format!(
            "`{shown}` is a folder; programs are named one by one, or all of it as `{folder}/*.hedge`"
        )));
    }
    if let (file, Some(name)) = part(&shown)
        && !path.exists()
        && (file.exists() || library::file(&file.display().to_string()).is_some())
    {
        let file = file.display();
        return Err(Failure::usage(format!(
            "a whole file is wanted here: `{file}`, without `{name}`"
        )));
    }
    Ok(())
}

/// Reads a program, prints its diagnostics, and finds the script that `FILE::NAME` names; without a
/// name, the only one of the file. If there are errors, a script runs only if it is named, since
/// without a name another one may be meant, and if it does not depend on what is wrong.
pub(super) fn read_script(script: &str) -> Result<(Program, usize), Failure> {
    let (path, name) = part(script);
    let program = read(path)?;
    if let Some(script) = name.and_then(|name| program.analysis.script(name)) {
        let place = program.analysis.program.scripts[script].span;
        program.complain_about(&[place]);
        return Ok((program, script));
    }
    let failure = Failure::of(&program.analysis.diagnostics, &program.sources, 1);
    if program.analysis.is_sound() {
        let script = find_script(&program, name)?;
        return Ok((program, script));
    }
    let Analysis { program: known, plans, file, .. } = &program.analysis;
    let mut own = known.scripts.iter().enumerate().filter_map(|(number, script)| {
        let runs = script.span.file == *file && prepare(known, number, plans).is_ok();
        runs.then_some(script)
    });
    eprint_line(&match own.next().filter(|_| name.is_none()) {
        None => "nothing is run until this is fixed".to_owned(),
        Some(script) => format!(
            "nothing is run until this is fixed, but a script that does not depend on it, by its \
             name: `hedgerow run {}::{}`",
            path.display(),
            script.name
        ),
    });
    Err(failure)
}

/// Splits `FILE::NAME`; the name may be qualified.
pub(super) fn part(text: &str) -> (&Path, Option<&str>) {
    // Folders may have colons in their names.
    let mut parts =
        text.match_indices("::").map(|(at, sign)| (&text[..at], &text[at + sign.len()..]));
    match parts.find(|(_, name)| !name.contains(['/', std::path::MAIN_SEPARATOR, '.'])) {
        Some((file, name)) => (Path::new(file), Some(name)),
        None => (Path::new(text), None),
    }
}

/// The index of the op that `FILE::OP` names; without a name, the only one of the file.
pub(super) fn find_op(program: &Program, name: Option<&str>) -> Result<usize, Failure> {
    let analysis = &program.analysis;
    let ops = analysis.program.ops.iter().map(|op| (op.name.as_str(), op.span));
    let found = name.and_then(|name| analysis.op(name));
    if let Some(name) = name.filter(|name| found.is_none() && analysis.script(name).is_some()) {
        let file = program.sources.get(analysis.file).name();
        let message = format!(
            "`{name}` is a script, and only operations are drawn, applied and emitted; \
             `hedgerow run {file}::{name} MESH` runs it"
        );
        return Err(Failure::usage(message));
    }
    program.find("operation", &visible(analysis, ops), (name, found))
}

/// The index of the script that `FILE::SCRIPT` names; without a name, the only one of the
/// file.
pub(super) fn find_script(program: &Program, name: Option<&str>) -> Result<usize, Failure> {
    let analysis = &program.analysis;
    let scripts = analysis.program.scripts.iter().map(|script| (script.name.as_str(), script.span));
    let found = name.and_then(|name| analysis.script(name));
    if let Some(name) = name.filter(|name| found.is_none() && analysis.op(name).is_some()) {
        let message = format!("`{name}` is an operation: `hedgerow apply` does it at a place");
        return Err(Failure::usage(message));
    }
    let scripts = visible(analysis, scripts);
    if scripts.iter().all(|script| !script.own)
        && let Some(op) = analysis.program.ops.iter().find(|op| analysis.is_own(op.span))
        && name.is_none()
    {
        let (file, op) = (program.sources.get(analysis.file).name(), &op.name);
        return Err(Failure::usage(format!(
            "the file has no script, but operations: `hedgerow apply {file}::{op} MESH --at PLACE \
             -o OUT` does one at a place"
        )));
    }
    program.find("script", &scripts, (name, found))
}

/// An item that a name may mean.
struct Candidate<'p> {
    index: usize,
    name: &'p str,
    /// True if it is in the file itself, not in one that it uses.
    own: bool,
}

fn visible<'p>(
    analysis: &Analysis,
    items: impl Iterator<Item = (&'p str, Span)>,
) -> Vec<Candidate<'p>> {
    let seen = items.enumerate().filter(|(_, (_, span))| analysis.sees(*span));
    let candidates =
        seen.map(|(index, (name, span))| Candidate { index, name, own: analysis.is_own(span) });
    candidates.collect()
}

fn find(
    what: &str,
    known: &[Candidate],
    (name, found): (Option<&str>, Option<usize>),
) -> Result<usize, Failure> {
    if let Some(found) = found {
        return Ok(found);
    }
    let own: Vec<_> = known.iter().filter(|candidate| candidate.own).collect();
    let Some(name) = name else {
        return match own.as_slice() {
            [] => Err(Failure::usage(format!("the file has no {what}"))),
            [only] => Ok(only.index),
            own => Err(Failure::usage(format!(
                "which {what}? write FILE::NAME with one of {}",
                quoted(own.iter().map(|candidate| candidate.name))
            ))),
        };
    };
    if known.is_empty() {
        return Err(Failure::usage(format!("the file has no {what}")));
    }
    let names = || known.iter().map(|candidate| candidate.name);
    let near = closest(name, names());
    let near = near.or_else(|| names().find(|known| known.split('_').any(|word| word == name)));
    let advice = match near {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("it has {}", quoted(names())),
    };
    Err(Failure::usage(format!("the file has no {what} `{name}`; {advice}")))
}

/// Splits every `NAME=VALUE` of `--set`.
pub(super) fn settings(texts: &[String]) -> Result<Vec<(String, String)>, Failure> {
    let part = |text: &String| match text.split_once('=') {
        Some((name, value)) => Ok((name.trim().to_string(), value.trim().to_string())),
        None => Err(Failure::usage(format!("`{text}` is not a setting: write NAME=VALUE"))),
    };
    texts.iter().map(part).collect()
}
