//! From failures of the grammar to diagnostics: all messages are worded here.

use super::failure::{Failure, Mistake, Phrase};
use super::foreign_syntax::{IN_BRACES, path_meant, told_here};
use super::text::MOST_DIGITS;
use super::unclosed::Braces;
use crate::diagnostic::{Diagnostic, Edit, Fix, one_of};
use crate::source::Span;
use crate::syntax::head::place_of_use;
use crate::syntax::token::{Token, TokenKind as T};
use crate::syntax::tree::split_qualified;

/// The start of the note about a keyword used as a name.
const ANOTHER_NAME: &str = "another name is needed";

/// The label at a brace that is not closed.
const NOT_CLOSED: &str = "this `{` is not closed";

/// The context of a failure.
pub(super) struct Around<'t> {
    /// The text of the file.
    pub text: &'t str,
    pub item: &'t [Token],
    /// The token after the item, if any.
    pub next: Option<Token>,
    /// The braces of the item.
    pub braces: Braces<'t>,
}

impl<'t> Around<'t> {
    /// Collects the context in an item of a file.
    pub(super) fn new(text: &'t str, item: &'t [Token], next: Option<Token>) -> Self {
        Self { text, item, next, braces: Braces::new(text, item) }
    }

    /// The index of the first token from a place on.
    fn at(&self, span: Span) -> usize {
        self.item.partition_point(|token| token.span.start < span.start)
    }
}

/// Reports the failures of an item, but not those that follow from others: a second one on a line,
/// a leftover closing brace, the same one again, everything after a block without braces.
pub(super) fn report_all(failures: Vec<Failure>, around: &Around) -> Vec<Diagnostic> {
    let mut told: Vec<Diagnostic> = Vec::new();
    let places: Vec<u32> = failures.iter().map(|failure| failure.span.start).collect();
    for failure in failures {
        let is_mistake = failure.mistake.is_some();
        let leftover = failure.found == Some(T::RightBrace) && wanted(&failure).is_empty();
        let said = report(failure, around);
        let follows = told.iter().any(|other| {
            let same = !said.notes.is_empty()
                && said.notes == other.notes
                && said.labels[0].text == other.labels[0].text;
            let unbraced = other
                .notes
                .iter()
                .any(|note| note.starts_with(IN_BRACES) || note.starts_with(ANOTHER_NAME));
            leftover || same || unbraced || same_line(around.text, other.span(), said.span())
        });
        if is_mistake || !follows {
            told.push(said);
        }
    }
    // Where something else is wrong in a block, perhaps more than its brace is missing.
    for told in &mut told {
        let brace = told.labels.iter().find(|label| label.text == NOT_CLOSED);
        let block = brace.map(|brace| brace.span.start..told.span().start);
        if block.is_some_and(|block| places.iter().any(|place| block.contains(place))) {
            told.fixes.clear();
        }
    }
    told
}

fn same_line(text: &str, one: Span, other: Span) -> bool {
    let (start, end) = (one.start.min(other.start), one.start.max(other.start));
    text.get(start as usize..end as usize).is_some_and(|between| !between.contains('\n'))
}

fn report(failure: Failure, around: &Around) -> Diagnostic {
    match failure.mistake {
        Some(mistake) => mistaken(mistake, failure.span, around.text),
        None => unexpected(failure, around),
    }
}

fn mistaken(mistake: Mistake, span: Span, text: &str) -> Diagnostic {
    let written = text.get(span.range()).unwrap_or("");
    let wrong = |message: &str| Diagnostic::error("syntax-error", message, span);
    let misplaced = |message: &str| Diagnostic::error("misplaced-part", message, span);
    match mistake {
        Mistake::ElseIf => {
            let told = wrong(&format!("`{written}` is written `else if`"));
            told.fix("write `else if`", span, "else if")
        }
        Mistake::Untyped => wrong(&format!("the parameter `{written}` has no type"))
            .note("a type is written behind the name: `e: edge`, `t: real`, `p: vec3`"),
        Mistake::BarePath => {
            let path = path_meant(written);
            let told = wrong("the path of a file stands in quotes");
            match path.contains('/') {
                true => told.fix(format!("write `\"{path}\"`"), span, format!("\"{path}\"")),
                false => told.note("of the library it begins with `std/`: `\"std/polygon.hedge\"`"),
            }
        }
        Mistake::ChainedComparison(middle) => {
            let message = "comparisons cannot be chained";
            let told = Diagnostic::error("chained-comparison", message, span);
            let of = |start: u32, end: u32| text.get(start as usize..end as usize).unwrap_or("");
            let ours = format!("{} and {}", of(span.start, middle.end), of(middle.start, span.end));
            told.fix(format!("write `{ours}`"), span, ours)
        }
        Mistake::TwiceDrawn(first) => {
            let message = "this side of the rule is already drawn";
            Diagnostic::error("drawn-twice", message, span)
                .label(first, "drawn here first")
                .note("alternatives are written `rule name { … }`")
        }
        Mistake::Misplaced(place) => misplaced(place),
        Mistake::CalledFamily => wrong("what is called has no subscript"),
        Mistake::QualifiedName => {
            let name = split_qualified(written).1.trim();
            wrong(&format!("a name stands alone, without what it belongs to: `{name}`")).fix(
                format!("write `{name}`"),
                span,
                name,
            )
        }
        Mistake::ValuesInText => misplaced("a text with values in it stands behind `print` only")
            .note("a brace that stands for itself is written `\\{`"),
        Mistake::UnknownFormat => {
            let told = wrong("this is not a way to print a value").note(format!(
                "`{{x:.3}}` has three digits behind the point, at most {MOST_DIGITS}, and \
                     `{{x:full}}` all there are"
            ));
            let spec = written.strip_prefix(':').and_then(|rest| rest.split('}').next());
            let digits = spec.and_then(|spec| {
                let (_, digits) = spec.rsplit_once('.')?;
                Some((spec, digits.trim_end_matches(|c: char| c.is_ascii_alphabetic())))
            });
            match digits
                .filter(|(_, digits)| digits.parse().is_ok_and(|count: u8| count <= MOST_DIGITS))
            {
                Some((spec, digits)) => {
                    let start = span.start + 1;
                    let place = Span { start, end: start + spec.len() as u32, ..span };
                    let ours = format!(".{digits}");
                    told.fix(format!("write `{{x:{ours}}}`"), place, ours)
                }
                None => told,
            }
        }
        Mistake::NoTwin => wrong("every halfedge has a twin").note(
            "beyond a boundary lies a hole, drawn `hole f: …`; an edge that is not drawn stays as \
             it is",
        ),
        Mistake::RuleAmongParts => misplaced("an op has either rules or drawings of its own")
            .note("move these drawings into a `rule name { … }`"),
    }
}

fn unexpected(failure: Failure, around: &Around) -> Diagnostic {
    let found = match failure.found {
        Some(_) => shown(failure.span, around.text),
        None => end_of(around),
    };
    let wanted = one_of(wanted(&failure));
    let anew = starts_anew(&failure);
    let closes = failure.wanted.has(T::RightBrace);
    let behind = around.item.get(around.at(failure.span) + 1).map(|next| next.kind);
    if failure.found == Some(T::Use) && behind == Some(T::Text) {
        return use_inside(failure.span, around);
    }
    if let Some(open) = around.braces.open_at(around.at(failure.span)).filter(|_| closes) {
        return not_closed(open, &failure, found, around);
    }
    if let Some(told) = keyword_as_name(&failure, around).or_else(|| no_value(&failure, around)) {
        return told;
    }
    let context = failure.context.filter(|_| !anew && !closes);
    let place = context.and_then(|context| place(context, around));
    let mut message = if wanted.is_empty() {
        format!("unexpected {found}")
    } else {
        format!("expected {wanted}, found {found}")
    };
    if let Some(place) = place {
        message = format!("{message} {place}");
    }
    let span = if anew { failure.span } else { behind_the_last_line(failure.span, around) };
    let told = Diagnostic::error("syntax-error", message, span);
    let told = if wanted.is_empty() { told } else { told.saying(format!("expected {wanted}")) };
    let told = if is_of_a_drawing(&failure) {
        told.note(
            "what is drawn, kept, new, erased or set stands in `before { … }` or `after { … }`",
        )
    } else {
        told
    };
    let told = told_here(told, &failure, around);
    match context.filter(|_| told.notes.is_empty() && told.fixes.is_empty()) {
        Some(context) => form(told, context, around),
        None => told,
    }
}

/// The error for a keyword in place of a name, if the tokens around it show that it was meant as
/// one.
fn keyword_as_name(failure: &Failure, around: &Around) -> Option<Diagnostic> {
    let kind = failure.found.filter(|kind| kind.is_keyword())?;
    let names = [Phrase::Name, Phrase::Parameter, Phrase::Halfedge, Phrase::Vertex];
    failure.wanted.phrases().find(|phrase| names.contains(phrase))?;
    let at = around.at(failure.span);
    let before = around.item.get(at.checked_sub(1)?)?;
    let behind = around.item.get(at + 1);
    let apart = |one: Span, other: Span| {
        let between = around.text.get(one.end as usize..other.start as usize);
        between.is_none_or(|between| between.contains('\n'))
    };
    let goes_on =
        behind.is_some_and(|next| next.kind.is_wordlike() && !apart(failure.span, next.span));
    if goes_on || apart(before.span, failure.span) {
        return None;
    }
    let word = kind.spelling()?;
    let message = format!("`{word}` is a word of the language, so nothing else has this name");
    let told = Diagnostic::error("syntax-error", message, failure.span);
    Some(told.note(format!("{ANOTHER_NAME}, as `{word}0` or `{word}_`")))
}

/// The error for an empty `{}` in a text that is printed.
fn no_value(failure: &Failure, around: &Around) -> Option<Diagnostic> {
    let at = around.at(failure.span);
    let before = around.item.get(at.checked_sub(1)?)?;
    let is_empty = matches!(before.kind, T::TextHead | T::TextMiddle)
        && matches!(failure.found, Some(T::TextMiddle | T::TextTail));
    is_empty.then(|| {
        let message = "between braces stands the value that is printed: `{count(edges)}`";
        Diagnostic::error("syntax-error", message, failure.span)
    })
}

/// The error for a `use` within an item.
fn use_inside(used: Span, around: &Around) -> Diagnostic {
    let text = around.text;
    let message = "files are used at the head of a file, not inside of an item";
    let mut told = Diagnostic::error("syntax-error", message, used);
    let indent = line_before(text, used);
    let rest = text.get(used.start as usize..).unwrap_or("");
    let line = rest.split_inclusive('\n').next().filter(|_| indent.trim().is_empty());
    if let Some(line) = line.filter(|line| is_use(line)) {
        let start = used.start - indent.len() as u32;
        let old = Span { start, end: used.start + line.len() as u32, ..used };
        let (head, follows) = place_of_use(text);
        let path = line.trim_end();
        let new = if follows { format!("\n{path}") } else { format!("{path}\n") };
        let head = Span { start: head as u32, end: head as u32, ..used };
        told.fixes.push(Fix {
            title: "move it to the head of the file".to_owned(),
            edits: vec![Edit { span: head, text: new }, Edit { span: old, text: String::new() }],
        });
    }
    told
}

/// True if a line uses a file, and has nothing behind it but a comment.
fn is_use(line: &str) -> bool {
    let path = line.strip_prefix("use").and_then(|rest| rest.trim_start().strip_prefix('"'));
    let behind = path.and_then(|path| path.split_once('"')).map(|(_, behind)| behind.trim());
    behind.is_some_and(|behind| behind.is_empty() || behind.starts_with("//"))
}

/// The error for an unclosed brace, at something that cannot be inside it. The lines tell where it
/// should be closed; if what cannot be inside is indented as its block is, nobody knows.
fn not_closed(open: usize, failure: &Failure, found: String, around: &Around) -> Diagnostic {
    let unclosed = around.braces.unclosed(open);
    let at = around.at(failure.span);
    let is_certain = unclosed.end <= at && unclosed.is_indented && around.braces.lack_one();
    let is_other = unclosed.brace != open || unclosed.end < at;
    let (place, found) = match around.item.get(unclosed.end).filter(|_| is_other) {
        Some(token) if token.kind == T::RightBrace => {
            (token.span, "the brace that closes what is around it".to_owned())
        }
        Some(token) => (token.span, shown(token.span, around.text)),
        None => (failure.span, found),
    };
    let place = behind_the_last_line(place, around);
    let brace = around.item[unclosed.brace].span;
    let message = match line_before(around.text, brace).trim() {
        "" => format!("a `{{` is not closed before {found}"),
        head => format!("the `{{` of `{head}` is not closed before {found}"),
    };
    let told = Diagnostic::error("syntax-error", message, place)
        .saying("a `}` is missing")
        .label(brace, NOT_CLOSED);
    let line = line_before(around.text, around.item[unclosed.head].span);
    let indent = &line[..line.len() - line.trim_start().len()];
    let end = around.item[unclosed.end - 1].span.after();
    match (is_certain, unclosed.on_one_line) {
        (true, true) => told.fix("close it here", end, " }"),
        (true, false) => {
            let end = behind_comment(end, around.text);
            told.fix("close it here", end, format!("\n{indent}}}"))
        }
        (false, _) => told,
    }
}

/// The place behind the comment that follows on the line, if there is one.
fn behind_comment(place: Span, text: &str) -> Span {
    let rest = text.get(place.end as usize..).unwrap_or("");
    let rest = rest.lines().next().unwrap_or("").trim_end();
    match rest.trim_start().starts_with("//") {
        true => Span { end: place.end + rest.len() as u32, ..place }.after(),
        false => place,
    }
}

/// True if a place is the first on its line, apart from blanks.
pub(super) fn begins_line(text: &str, place: Span) -> bool {
    let before = text.get(..place.start as usize).unwrap_or("");
    let before = before.trim_end_matches(|c: char| c.is_whitespace() && c != '\n');
    before.is_empty() || before.ends_with('\n')
}

/// The text before a place on its line.
fn line_before(text: &str, span: Span) -> &str {
    let before = text.get(..span.start as usize).unwrap_or("");
    before.rsplit('\n').next().unwrap_or("")
}

/// Adds a note with the syntax of the statement or header that failed.
fn form(told: Diagnostic, context: Span, around: &Around) -> Diagnostic {
    let at = around.item.partition_point(|token| token.span.start < context.start);
    let mut head = around.item[at..].iter().map(|token| token.kind);
    let form = match head.find(|kind| *kind != T::Private) {
        Some(T::Face) => "a face is drawn `face f: v0 -a-> v1 -b-> v2 =P=> v0`",
        Some(T::Hole) => "a hole is drawn `hole f: v0 -a-> v1 =P=> v0`",
        Some(T::Loop) => "a loop is drawn `loop f: v0 -a-> v1 =P=> v0`",
        Some(T::Edge) => "an edge is a pair of twins: `edge e: a | d`",
        Some(T::Vertex) => {
            "a vertex has its spokes, `vertex v: a *S b`, or is drawn in a loop, \
             `loop f: v -h-> other => v`"
        }
        Some(T::Attr) => "an attribute is `attr weight: edge real = 0`",
        Some(T::Op) => "an operation is `op flip(e: edge) { before { … } after { … } }`",
        Some(T::Fn) => "a function is `fn f(x: real) -> real { … }`",
        Some(T::Script) => "a script is `script go(n: int = 3) { … }`",
        Some(T::For) => "a loop is `for v in vertices where … { … }`",
        Some(T::Parallel) => "such a loop is `parallel for v in vertices where … { … }`",
        _ => return told,
    };
    told.note(form)
}

/// True if a statement of a drawing is among the parts of an op.
fn is_of_a_drawing(failure: &Failure) -> bool {
    failure.found.is_some_and(T::begins_drawing_statement)
        && failure.wanted.phrases().any(|phrase| phrase == Phrase::Part)
}

/// True if an item, part or statement could begin here, so that nothing is missing before.
fn starts_anew(failure: &Failure) -> bool {
    let phrases: Vec<_> = failure.wanted.phrases().collect();
    let something = !phrases.is_empty() || failure.wanted.tokens().next().is_some();
    !something
        || phrases.into_iter().any(|phrase| {
            matches!(
                phrase,
                Phrase::Item | Phrase::Part | Phrase::DrawingStatement | Phrase::Statement
            )
        })
}

/// The span to point at: if the token found is on a later line than the previous token, the place
/// after that token.
fn behind_the_last_line(span: Span, around: &Around) -> Span {
    let tokens = around.item;
    let at = tokens.partition_point(|token| token.span.start < span.start);
    let before = at.checked_sub(1).map(|at| tokens[at].span);
    let Some(before) = before.filter(|before| before.end <= span.start) else { return span };
    let between = before.end as usize..span.start as usize;
    match around.text.get(between) {
        Some(between) if between.contains('\n') => before.after(),
        _ => span,
    }
}

/// The text of a token, truncated if it is long.
fn shown(span: Span, text: &str) -> String {
    const LONGEST: usize = 24;
    let written = text.get(span.range()).unwrap_or("");
    if written.chars().count() <= LONGEST {
        format!("`{written}`")
    } else {
        let start: String = written.chars().take(LONGEST).collect();
        format!("`{start}…`")
    }
}

fn end_of(around: &Around) -> String {
    match around.next {
        Some(next) => shown(next.span, around.text),
        None => "the end of the file".to_owned(),
    }
}

/// The expected words, in order; continuations of a name or value only if nothing else was
/// expected.
fn wanted(failure: &Failure) -> Vec<String> {
    let all = failure.wanted;
    let owned = |words: &&str| (*words).to_owned();
    let strong = all.phrases().filter(|phrase| !phrase.is_weak());
    let mut words: Vec<_> = strong.flat_map(Phrase::words).map(owned).collect();
    words.extend(all.tokens().map(|kind| kind.to_string()));
    if words.is_empty() {
        words = all.phrases().flat_map(Phrase::words).map(owned).collect();
    }
    words
}

/// "in the face statement `f0`", from the tokens at the start of the context.
fn place(context: Span, around: &Around) -> Option<String> {
    let tokens = around.item;
    let at = tokens.partition_point(|token| token.span.start < context.start);
    let head = tokens.get(at..)?;
    let (first, rest) = match head {
        [private, head @ ..] if private.kind == T::Private => head.split_first()?,
        _ => head.split_first()?,
    };
    let keyword = first.kind.spelling().filter(|_| first.kind.is_keyword())?;
    let name = rest.first().filter(|token| token.kind.is_name());
    let name = name.map(|name| shown(name.span, around.text));
    let sort = match first.kind {
        T::Face | T::Hole | T::Loop | T::Edge | T::Vertex => " statement",
        T::Op | T::Script | T::Fn | T::Attr => "",
        T::Before | T::After => return Some(format!("in `{keyword}`")),
        _ => return Some(format!("in the `{keyword}` statement")),
    };
    Some(match name {
        Some(name) => format!("in the {keyword}{sort} {name}"),
        None => format!("in the {keyword}{sort}"),
    })
}
