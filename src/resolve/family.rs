//! Families: which names of a rule have a subscript, and whether its statements use them
//! consistently.
//!
//! A rule has one index. A name has a subscript everywhere or nowhere. A statement with a free
//! index is about a family and holds for every member; `each` repeats its period in the one orbit
//! of a single name.

use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Edit, Fix, quoted};
use crate::source::Span;
use crate::syntax::tree::{self, Arrow, Ident, Index, Name, Side, Spoke, Statement};

use super::mention::{Mention, drawn_parts, mentions};
use super::report::Report;

/// The largest constant that a subscript can add to the index. The checker examines cycles that are
/// longer than the range of one statement.
pub(super) const WIDEST: i64 = 4;

/// The index of a rule, while it is being read.
#[derive(Debug, Default)]
struct IndexReader {
    first: Option<(String, Span)>,
    /// Names that have been reported to have two forms.
    told: Vec<String>,
    /// Other letters that have been reported.
    others: Vec<String>,
}

/// Checks the subscripts of a rule. Returns its index if it has families.
pub(super) fn read_index(
    rule: &tree::Rule,
    params: &[tree::Param],
    report: &mut Report,
) -> Option<String> {
    let mut reader = IndexReader::default();
    let mut forms: HashMap<String, (bool, Span)> = HashMap::new();
    let created = created(rule);
    let is_param = |name: &&Name| params.iter().any(|of| of.name.ident.text == name.ident.text);
    for (word, names) in lists(rule) {
        // A parameter is single unless its own subscript says otherwise.
        let names: Vec<&Name> = names.iter().filter(|name| !is_param(name)).collect();
        bare_in_list(rule, word, &names, report);
    }
    for param in params {
        let name = &param.name;
        if let Some(index) = &name.index
            && let Some(message) = wrong_beginning(param, index)
        {
            report.add(Diagnostic::error("wrong-subscript", message, index.span));
        }
        let form = (name.index.is_some(), name.span);
        forms.insert(name.ident.text.clone(), form);
    }
    for side in [&rule.before, &rule.after].into_iter().flatten() {
        for mention in mentions(side) {
            if let Some(index) = mention.index {
                reader.subscript(index, report);
            }
            same_form(&mention, params, &created, &mut forms, &mut reader, report);
        }
        for statement in &side.statements {
            reader.statement(statement, report);
        }
    }
    reader.first.map(|(letter, _)| letter)
}

/// The error in the subscript of a parameter. Only a halfedge determines where a family begins: an
/// edge has two directions, and around a vertex or face every starting position is tried.
fn wrong_beginning(param: &tree::Param, index: &Index) -> Option<String> {
    let is_first = index.variable.is_none() && index.offset == 0;
    match param.ty.text.as_str() {
        "vertex" | "edge" | "face" => Some("only a halfedge says where a family begins".into()),
        _ if is_first => None,
        _ => Some(format!(
            "a parameter says where its family begins: write `{}[0]`",
            param.name.ident.text
        )),
    }
}

/// The names of `new`, each with whether it has a subscript there, and its span.
fn created(rule: &tree::Rule) -> HashMap<&str, (bool, Span)> {
    let names = lists(rule).filter(|(word, _)| *word == "new").flat_map(|(_, names)| names);
    names.map(|name| (name.ident.text.as_str(), (name.index.is_some(), name.span))).collect()
}

/// The lists of a rule, each behind its keyword.
fn lists(rule: &tree::Rule) -> impl Iterator<Item = (&'static str, &[Name])> {
    let statements = rule.after.iter().flat_map(|side| &side.statements);
    statements.filter_map(Statement::listed)
}

/// Reports the names in a list that lack the subscript they have wherever they are drawn.
fn bare_in_list(rule: &tree::Rule, list: &str, names: &[&Name], report: &mut Report) {
    let drawn: Vec<Mention> =
        [&rule.before, &rule.after].into_iter().flatten().flat_map(mentions).collect();
    let index_of = |word: &str| {
        let mut others =
            drawn.iter().filter(|mention| mention.kind.is_some() && mention.text == word);
        let first = others.next()?.index?;
        others.all(|mention| mention.index.is_some()).then_some(first)
    };
    let bare = names.iter().filter(|name| name.index.is_none()).filter_map(|name| {
        let word = name.ident.text.as_str();
        Some((word, name.span, index_of(word)?.variable.as_ref()?.text.as_str()))
    });
    let bare: Vec<(&str, Span, &str)> = bare.collect();
    let Some((_, first, letter)) = bare.first().copied() else { return };
    let words: Vec<&str> = bare.iter().map(|(word, ..)| *word).collect();
    let families: Vec<String> = words.iter().map(|word| format!("{word}[{letter}]")).collect();
    let (be, has) = if words.len() == 1 {
        ("is a family", "it has its")
    } else {
        ("are families", "they have their")
    };
    let message = format!("{} {be}: in `{list}` {has} subscript, too", quoted(&words));
    let mut error = Diagnostic::error("two-forms", message, first);
    for (_, span, _) in &bare[1..] {
        error = error.label(*span, "");
    }
    error.fixes.push(Fix {
        title: format!("write `{}`", families.join(" ")),
        edits: bare
            .iter()
            .zip(families)
            .map(|((_, span, _), text)| Edit { span: *span, text })
            .collect(),
    });
    report.add(error);
    for word in words {
        report.suppress(word);
    }
}

/// Reports a name that has a subscript in one place and none in another. Nothing else is reported
/// about such a name: further errors follow from this one.
fn same_form(
    mention: &Mention,
    params: &[tree::Param],
    created: &HashMap<&str, (bool, Span)>,
    forms: &mut HashMap<String, (bool, Span)>,
    reader: &mut IndexReader,
    report: &mut Report,
) {
    let word = mention.text.as_ref();
    let here = mention.index.is_some();
    let first = *forms.entry(word.to_owned()).or_insert((here, mention.span));
    let is_told = reader.told.iter().any(|told| told == word) || report.is_suppressed(word);
    if first.0 == here || !mention.is_named() || is_told {
        return;
    }
    // A value used as an element is reported elsewhere.
    let param = params.iter().find(|param| param.name.ident.text == word);
    let elements = ["vertex", "halfedge", "edge", "face"];
    if param.is_some_and(|param| !elements.contains(&param.ty.text.as_str())) {
        return;
    }
    if let Some(&(_, span)) = created.get(word).filter(|(form, _)| *form == here) {
        let (old, new) = match here {
            true => (format!("`{word}` is one element"), format!("the new family `{word}[i]`")),
            false => (format!("`{word}[i]` is a family"), format!("the new `{word}`")),
        };
        let message = format!("{old} of `before`, so {new} needs another name");
        let error = Diagnostic::error("two-forms", message, span)
            .label(first.1, "the name is taken here")
            .note("a name stands for one element, or with a subscript for a family");
        report.add(error);
        report.suppress(word);
        return;
    }
    let (message, note) = match here {
        true => (
            format!("`{word}` has a subscript here, but not where it comes first"),
            match param {
                Some(_) => format!(
                    "one element is written `{word}`; a parameter that begins a family, `{word}[0]`"
                ),
                None => "a name stands for one element, or with a subscript for a family".into(),
            },
        ),
        false => (
            format!("`{word}` is a family: it needs a subscript here"),
            format!("write `{word}[i]` for all of it"),
        ),
    };
    let label = if first.0 { "a family here" } else { "a single name here" };
    let error =
        Diagnostic::error("two-forms", message, mention.span).label(first.1, label).note(note);
    report.add(error);
    reader.told.push(word.to_owned());
}

impl IndexReader {
    fn subscript(&mut self, index: &Index, report: &mut Report) {
        match &index.variable {
            Some(variable) => self.meet(variable, report),
            None => {
                let message = "a subscript in a drawing is the index plus a constant";
                let error = Diagnostic::error("wrong-subscript", message, index.span)
                    .note("`[0]` stands only at a parameter, to say where its family begins");
                report.add(error);
            }
        }
        if index.offset.abs() > WIDEST {
            let message = format!("a subscript adds {WIDEST} at most to the index");
            report.add(Diagnostic::error("wrong-subscript", message, index.span));
        }
    }

    /// Records the index variable of the rule; reports a second one.
    fn meet(&mut self, variable: &Ident, report: &mut Report) {
        let Some((letter, first)) = &self.first else {
            self.first = Some((variable.text.clone(), variable.span));
            return;
        };
        if *letter != variable.text {
            if self.others.contains(&variable.text) {
                return report.fail();
            }
            self.others.push(variable.text.clone());
            let message = format!("a rule has one index: `{letter}`, but here `{}`", variable.text);
            let error = Diagnostic::error("wrong-subscript", message, variable.span)
                .label(*first, "it is here");
            report.add(error);
        }
    }

    fn statement(&mut self, statement: &Statement, report: &mut Report) {
        let (each, subject) = match statement {
            Statement::Loop(orbit) => (orbit.each.as_ref(), &orbit.name),
            Statement::Edge { name, .. } => (None, name),
            Statement::Vertex(star) => (star.each.as_ref(), &star.name),
            _ => return,
        };
        if let Some(variable) = each {
            self.meet(variable, report);
        }
        if let (Some(each), Some(index)) = (each, &subject.index) {
            let message = "`each` runs around one face or vertex: its name has no subscript";
            let error = Diagnostic::error("mixed-statement", message, index.span)
                .label(each.span, "`each` is here");
            report.add(error);
            return;
        }
        if let Some(span) = unnamed_in_each(statement) {
            let message = "a run in `each` needs a name with a subscript";
            report.add(Diagnostic::error("mixed-statement", message, span));
        }
        if self.told.contains(&subject.ident.text) {
            return;
        }
        let free = each.is_some() || subject.index.is_some();
        let mut parts = drawn_parts(statement);
        if let Some(part) = parts.find(|part| part.index.is_some() != free) {
            let error = mixed(part, subject, free);
            report.add(match statement {
                Statement::Loop(orbit) if !free => repeated(error, orbit),
                _ => error,
            });
            return;
        }
        // The corners of a single loop have no index either.
        if let Statement::Loop(orbit) = statement
            && !free
        {
            let mut corners = orbit.items.iter().map(|item| &item.from).chain(&orbit.end);
            if let Some(corner) = corners.find(|corner| corner.index.is_some()) {
                report.add(mixed(corner, subject, free));
            }
        }
    }
}

/// Adds a fix that repeats `v[i] -h[i]-> v[i+1]` with `each`, if the loop is such a period.
fn repeated(error: Diagnostic, orbit: &tree::Loop) -> Diagnostic {
    let ([first, ..], Some(end)) = (orbit.items.as_slice(), &orbit.end) else { return error };
    let index = |name: &Name| name.index.as_ref().map(|index| index.offset);
    let is_period = end.ident.text == first.from.ident.text && index(end) > index(&first.from);
    let letter = first.from.index.as_ref().and_then(|index| index.variable.as_ref());
    let (Some(letter), true) = (letter, is_period) else { return error };
    let mut error = error;
    let title = format!("repeat it: `each {} {{ … }}`", letter.text);
    let (begin, end) = (first.from.span.before(), end.span);
    error.fixes.push(Fix {
        title,
        edits: vec![
            Edit { span: begin, text: format!("each {} {{ ", letter.text) },
            Edit { span: end, text: "}".to_owned() },
        ],
    });
    error
}

/// A path or fan without a name inside `each`.
fn unnamed_in_each(statement: &Statement) -> Option<Span> {
    match statement {
        Statement::Loop(orbit) => {
            orbit.each.as_ref()?;
            let unnamed = orbit.items.iter().find(|item| item.arrow == Arrow::Path(None))?;
            Some(unnamed.span)
        }
        Statement::Vertex(star) => {
            star.each.as_ref()?;
            star.spokes.iter().find_map(|spoke| match spoke {
                Spoke::Fan(None, span) => Some(*span),
                _ => None,
            })
        }
        _ => None,
    }
}

fn mixed(part: &Name, subject: &Name, free: bool) -> Diagnostic {
    let (word, name) = (&part.ident.text, &subject.ident.text);
    let message = match free {
        true => format!("`{word}` is single, but this statement is repeated for every index"),
        false => format!("`{word}[…]` is a family, but this statement is about `{name}` alone"),
    };
    let note = match free {
        true => "families fill their orbits: single names and families never share one".into(),
        false => {
            format!(
                "give `{name}` a subscript too, or draw its whole orbit with `each i {{ … }}`; what is \
                 done a given number of times is done in `steps`"
            )
        }
    };
    Diagnostic::error("mixed-statement", message, part.span).note(note)
}

/// True if a name is a family: many elements, so an op may not return it.
pub(super) fn is_family(side: &Side, word: &str) -> bool {
    mentions(side).iter().any(|mention| mention.text == word && mention.index.is_some())
}
