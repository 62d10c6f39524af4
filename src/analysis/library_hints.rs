//! Library hints: the files of the library that declare a name that is called but unknown.
//!
//! `split(e)` alone is an unknown op; the library has several of that name, each in a file that
//! only has to be used. Completion offers such names before there is an error. The library declares
//! each op, function and script at the beginning of a line, so their heads are read once from its
//! texts, when they are first asked for.

use std::collections::{BTreeSet, HashMap};
use std::sync::LazyLock;

use super::snapshot::Snapshot;
use crate::diagnostic::{Diagnostic, Edit};
use crate::diagram::Type;
use crate::library::{self, LibraryFile};
use crate::resolve::{Types, qualifier};
use crate::source::{Sources, Span};
use crate::syntax::place_of_use;
use crate::syntax::tree::split_qualified;

/// Adds to each unknown op or function which files of the library declare it.
pub(super) fn tell_where(diagnostics: &mut [Diagnostic], sources: &Sources, types: &Types) {
    for told in diagnostics {
        if matches!(told.code, "unknown-op" | "unknown-function") {
            name_files(told, sources, types);
        }
    }
}

fn name_files(told: &mut Diagnostic, sources: &Sources, types: &Types) {
    let span = told.span();
    let source = sources.get(span.file);
    let Some(word) = source.text().get(span.range()) else { return };
    let behind = source.text().get(span.end as usize..).unwrap_or_default();
    let given = behind.trim_start().strip_prefix('(').map(listed).unwrap_or_default();
    let (of, word) = split_qualified(word);
    let files = library::files().filter(|file| {
        let is_of = of.is_none_or(|of| qualifier(file.name) == of);
        is_of && declares(file, word, !given.is_empty()) && file.name != source.name()
    });
    let files: Vec<_> = files.collect();
    let [file, others @ ..] = files.as_slice() else {
        if let Some(file) =
            library::files().find(|file| of.is_none() && declares(file, word, false))
        {
            let note =
                format!("`{word}` of `{}` takes no arguments: it is for a whole mesh", file.name);
            *told = told.clone().note(note);
        }
        return;
    };
    let (line, first) = (format!("use \"{}\"", file.name), format!("`{}`", file.name));
    let variable = |word: &str| {
        let known = types.iter().filter(|(at, _)| at.file == span.file && at.start < span.start);
        let known = known.filter(|(at, _)| sources.slice(**at) == word);
        known.max_by_key(|(at, _)| at.start).map(|(_, ty)| *ty)
    };
    let fits = parameters(file, word).any(|params| takes(params, &given, variable));
    *told = match others {
        // A function of the same name may be of other things, and mean something else; so may an op
        // with other parameters.
        [] if told.code == "unknown-function" || !fits => told.clone().note(format!(
            "the library has one in {first}; to use it, write `{line}` at the head of the file"
        )),
        [] if is_welcome(file.name, source.name(), sources) => {
            let (place, text) = head(source.text(), span, &line);
            let told = told.clone().note(format!("the library has it in {first}"));
            told.fix(format!("insert `{line}`"), place, text)
        }
        [] => told.clone().note(format!(
            "the library has it in {first}, which cannot be used as it is: it declares an attribute \
             that there is already, or a name that is also in another file that is used, or makes \
             elements without an attribute that has no default"
        )),
        _ => told.clone().note(format!(
            "the library has one in {}; to use the first, write `{line}` at the head of the file",
            files.iter().map(|file| format!("`{}`", file.name)).collect::<Vec<_>>().join(", ")
        )),
    };
}

/// An item of the library that a program can call once it uses its file.
pub(super) struct Importable {
    pub name: &'static str,
    /// The file.
    pub file: &'static str,
    /// True for a function, which is called from anywhere.
    pub is_function: bool,
    /// Its parameters and its result.
    pub signature: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// The insertion of the `use`.
    pub insertion: Edit,
}

/// The items of the library whose names begin with some letters, in files that a program does not
/// use but could as they are.
pub(super) fn importable(snapshot: &Snapshot, letters: &str) -> Vec<Importable> {
    let (sources, span) = (snapshot.sources(), Span { file: snapshot.file(), start: 0, end: 0 });
    let program = sources.get(span.file);
    let used: BTreeSet<_> = snapshot.used_names().collect();
    let mut found = Vec::new();
    for heads in HEADS.chunk_by(|one, other| one.file == other.file) {
        let mut fitting = heads.iter().filter(|head| head.name.starts_with(letters)).peekable();
        let Some(&&Head { file, .. }) = fitting.peek() else { continue };
        let is_known = file == program.name() || used.contains(file);
        if is_known || !is_welcome(file, program.name(), sources) {
            continue;
        }
        let (span, text) = head(program.text(), span, &format!("use \"{file}\""));
        found.extend(fitting.map(|head| Importable {
            name: head.name,
            file,
            is_function: head.is_function,
            signature: head.signature(),
            docs: head.docs(),
            insertion: Edit { span, text: text.clone() },
        }));
    }
    found
}

/// True if a program can use a file of the library as it is: no other file that it uses declares one
/// of its names, which would be ambiguous then, and the program declares no attribute of it, and none
/// without a default, which the elements that it creates would lack. The ops and functions of the
/// program hide those of the file.
fn is_welcome(name: &str, program: &str, sources: &Sources) -> bool {
    let Some(file) = library::file(name) else { return false };
    let theirs: BTreeSet<&str> = declared(file.text).map(|(_, name)| name).collect();
    let others = sources.ids().map(|file| sources.get(file)).filter(|other| other.name() != name);
    let mut ours = others.flat_map(|other| {
        let hides = other.name() == program;
        declared(other.text()).map(move |(line, name)| (line, name, hides))
    });
    !ours.any(|(line, name, hides)| {
        let is_attribute = line.starts_with("attr ") || line.starts_with("private ");
        theirs.contains(name) && (is_attribute || !hides) || is_attribute && !line.contains('=')
    })
}

/// The lines of a text that declare an op, a function or an attribute, each with the name.
fn declared(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.lines().filter_map(|line| {
        let line = line.trim_start();
        let named = ["op ", "fn ", "attr ", "private attr "];
        let rest = named.iter().find_map(|word| line.strip_prefix(word))?;
        let is_word = |letter: char| letter.is_alphanumeric() || letter == '_';
        Some((line, rest.trim_start().split(|letter| !is_word(letter)).next()?))
    })
}

/// True if a file of the library declares an op, a function or a script of this name, with
/// parameters if it is called with arguments.
fn declares(file: &LibraryFile, word: &str, has_arguments: bool) -> bool {
    parameters(file, word).any(|params| !has_arguments || !params.is_empty())
}

/// The head of an op, a function or a script of the library.
struct Head {
    /// The name of the file.
    file: &'static str,
    name: &'static str,
    is_function: bool,
    params: Vec<&'static str>,
    /// The text of the file up to the head, and from the parameters on.
    around: [&'static str; 2],
}

impl Head {
    /// The parameters and the result, on one line.
    fn signature(&self) -> String {
        let [_, behind] = self.around;
        let head = behind.split('{').next().unwrap_or_default();
        let words: Vec<_> = head.split_whitespace().take_while(|word| *word != "keeps").collect();
        format!("({}", words.join(" "))
    }

    /// The doc comment, a line each.
    fn docs(&self) -> Vec<String> {
        let [before, _] = self.around;
        let lines = before.lines().rev().map_while(|line| line.strip_prefix("///"));
        let mut lines: Vec<_> = lines.map(|line| line.trim().to_owned()).collect();
        lines.reverse();
        lines
    }
}

/// The heads of all that the library offers.
static HEADS: LazyLock<Vec<Head>> = LazyLock::new(|| {
    let of_file = |file: LibraryFile| {
        let (name_of_file, mut rest) = (file.name, file.text);
        std::iter::from_fn(move || {
            let (line, below) = rest.split_once('\n')?;
            let whole = std::mem::replace(&mut rest, below);
            Some((line, whole))
        })
        .filter_map(move |(line, whole)| {
            let (kind, name) = line.split_once('(')?.0.split_once(' ')?;
            let behind = &whole[kind.len() + name.len() + 2..];
            matches!(kind, "op" | "fn" | "script").then(|| Head {
                file: name_of_file,
                name,
                is_function: kind == "fn",
                params: listed(behind),
                around: [&file.text[..file.text.len() - whole.len()], behind],
            })
        })
    };
    library::files().flat_map(of_file).collect()
});

/// The heads of each name.
static HEADS_BY_NAME: LazyLock<HashMap<&str, Vec<&Head>>> = LazyLock::new(|| {
    let mut heads: HashMap<_, Vec<_>> = HashMap::new();
    HEADS.iter().for_each(|head| heads.entry(head.name).or_default().push(head));
    heads
});

/// The parameters of each op, function and script of this name.
fn parameters<'h>(
    file: &LibraryFile,
    word: &str,
) -> impl Iterator<Item = &'h [&'static str]> + use<'h> {
    let heads = HEADS_BY_NAME.get(word).map_or(&[][..], Vec::as_slice);
    let name = file.name;
    heads.iter().filter(move |head| head.file == name).map(|head| head.params.as_slice())
}

/// The parts of a list with commas, up to its closing bracket.
fn listed(text: &str) -> Vec<&str> {
    let (mut depth, mut begin, mut parts) = (0, 0, Vec::new());
    for (at, sign) in text.char_indices() {
        match sign {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' if depth > 0 => depth -= 1,
            ',' | ')' if depth == 0 => {
                parts.push(text[begin..at].trim());
                begin = at + 1;
                if sign == ')' {
                    break;
                }
            }
            _ => {}
        }
    }
    parts.retain(|part| !part.is_empty());
    parts
}

/// True if parameters take these arguments, as far as the types of variables tell.
fn takes(params: &[&str], given: &[&str], variable: impl Fn(&str) -> Option<Type>) -> bool {
    let fits = |(param, arg): (&&str, &&str)| {
        let declared = param.split_once(':').map_or("", |(_, declared)| declared);
        let wanted = declared.split('=').next().unwrap_or_default().trim();
        variable(arg).is_none_or(|ty| {
            ty.word() == wanted || wanted.is_empty() || ty == Type::Int && wanted == "real"
        })
    };
    given.len() <= params.len()
        && params[given.len()..].iter().all(|param| param.contains('='))
        && params.iter().zip(given).all(fits)
}

/// The place and the text to insert a `use` into a file.
fn head(text: &str, of: Span, line: &str) -> (Span, String) {
    let (place, follows) = place_of_use(text);
    let place = u32::try_from(place).unwrap_or(u32::MAX);
    let text = if follows { format!("\n{line}") } else { format!("{line}\n\n") };
    (Span { start: place, end: place, ..of }, text)
}
