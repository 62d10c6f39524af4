//! Statements next to the drawings: `require`, `guard`, `alias` and the assignments.

use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, quoted};
use crate::diagram::{
    Access, Alias, Assignment, Kind, Level, NameId, Ref, Require, Role, Type, Wanted, free_name,
    overloads,
};
use crate::source::Span;
use crate::syntax::tree::{self, Condition, Ident, Statement};

use super::declared::private;
use super::fields::{attribute, attributes_of, is_taken};
use super::foreign_words::{self, Here};
use super::lists::mention;
use super::names::Names;
use super::report::Report;
use super::signature::Parameter;
use super::suggestion::suggest;
use super::typing::{Place, Typing};
use super::words::not_held;

/// The requirements of a rule of `op`.
pub(super) fn requires(conditions: &[Condition], op: &str, typing: &mut Typing) -> Vec<Require> {
    let mut requires = Vec::new();
    for condition in conditions {
        let Condition::Require { condition, reason, span } = condition else { continue };
        let typed = typing.whole_as(condition, Type::Bool, "`require`");
        let reason = match reason {
            Some((text, _)) => text.clone(),
            None => not_held(op),
        };
        requires.extend(typed.map(|condition| Require {
            condition,
            reason,
            index: None,
            span: *span,
        }));
    }
    requires
}

/// The level that a rule guards and the span of its `guard`.
pub(super) fn guard(
    conditions: &[Condition],
    params: &[Parameter],
    report: &mut Report,
) -> Option<(Level, Span)> {
    let mut first: Option<Span> = None;
    let mut guard = None;
    for condition in conditions {
        let Condition::Guard { level: word, span } = condition else { continue };
        if let Some(first) = first {
            let error = Diagnostic::error("guarded-twice", "the rule has two guards", *span)
                .saying("guarded again")
                .label(first, "guarded first");
            report.add(error);
            continue;
        }
        first = Some(*span);
        match level(&word.text) {
            Some(level) => guard = Some((level, *span)),
            None => {
                let names = Level::ALL.map(Level::name);
                let message = format!("there is no level `{}`", word.text);
                let error = Diagnostic::error("unknown-level", message, word.span);
                let error = suggest(error, &word.text, word.span, names)
                    .note(format!("the levels are {}", quoted(names)))
                    .when(is_condition(&word.text), |error| asked(error, word, *span, params));
                report.add(error);
            }
        }
    }
    guard
}

/// True if a built-in function answers with a bool.
fn is_condition(word: &str) -> bool {
    overloads(word).iter().any(|way| way.result == Type::Bool)
}

/// The error that a `guard` names the function `word`, with the fix if one parameter can be asked.
fn asked(error: Diagnostic, word: &Ident, guard: Span, params: &[Parameter]) -> Diagnostic {
    let word = &word.text;
    let takes = |ty| overloads(word).iter().any(|way| way.wanted == [Wanted::Is(ty)]);
    let mut fitting = params.iter().filter(|param| param.ty.is_some_and(takes));
    match (fitting.next(), fitting.next()) {
        (Some(param), None) => {
            let text = format!("require {word}({})", param.name);
            error.fix(format!("write `{text}`"), guard, text)
        }
        _ => error.note(format!("a condition is asked by `require {word}(…)`")),
    }
}

/// The names that may stand for one element.
pub(super) fn aliases(conditions: &[Condition], names: &Names, report: &mut Report) -> Vec<Alias> {
    let mut aliases = Vec::new();
    for condition in conditions {
        let Condition::Alias { names: listed, span } = condition else { continue };
        if names.cycle().is_some() {
            let message = "a rule with families has no `alias`";
            let error = Diagnostic::error("cannot-alias", message, *span);
            report.add(error.note("its names stand for different elements on every cycle"));
            continue;
        }
        let mut known: Vec<Ref> = Vec::new();
        for name in listed {
            if let Some(found) = aliased(name, &known, names, report) {
                known.push(found);
            }
        }
        aliases.push(Alias { names: known, span: *span });
    }
    aliases
}

/// Resolves one name of an `alias`, after `others`.
fn aliased(name: &tree::Name, others: &[Ref], names: &Names, report: &mut Report) -> Option<Ref> {
    let word = &name.ident.text;
    let Some(id) = names.find(word) else {
        let message = format!("`{word}` is listed in `alias` but drawn nowhere");
        let error = Diagnostic::error("unknown-name", message, name.span);
        return report.reject(suggest(error, word, name.span, names.words()));
    };
    if let Some(first) = others.iter().find(|other| other.name == id) {
        let message = format!("`{word}` is listed twice in `alias`");
        let error = Diagnostic::error("listed-twice", message, name.span);
        return report.reject(error.label(first.span, "listed first"));
    }
    let kind = names.get(id).kind;
    let cannot = |message: String| Diagnostic::error("cannot-alias", message, name.span);
    let first = others.first().map(|first| names.get(first.name));
    let error = match (kind, first) {
        (Kind::Path | Kind::Fan, _) => {
            let what = kind.a_word();
            cannot(format!("`{word}` is {what}; `alias` names vertices, halfedges and faces"))
        }
        (Kind::Edge, _) => cannot(format!("`{word}` is an edge; `alias` names its halfedges"))
            .note("two edges are one where their halfedges are"),
        (_, Some(first)) if first.kind != kind => {
            let (one, other) = (first.kind.a_word(), kind.a_word());
            cannot(format!("`{}` is {one} and `{word}` is {other}: they are never one", first.text))
        }
        _ if !names.readable(id) => {
            cannot(format!("`{word}` is not drawn in `before`, so it is no other element"))
        }
        _ => return Some(mention(id, name)),
    };
    report.reject(error)
}

/// The level of this name.
fn level(word: &str) -> Option<Level> {
    Level::ALL.into_iter().find(|level| level.name() == word)
}

/// The assignments of `after`, whose elements must not be among the `erased`.
pub(super) fn assignments(
    after: &tree::Side,
    names: &Names,
    erased: &[Ref],
    typing: &mut Typing,
) -> Vec<Assignment> {
    let erased: HashMap<NameId, Span> = erased.iter().map(|r| (r.name, r.span)).collect();
    let mut done: HashMap<(NameId, Access), Span> = HashMap::new();
    let mut assignments = Vec::new();
    for statement in &after.statements {
        let Statement::Assign { target, attribute, value, span } = statement else { continue };
        if names.find(&target.ident.text).is_none() && is_listed_new(after, target) {
            // The list reports that it is drawn nowhere.
            typing.report.fail();
            continue;
        }
        // Errors in the value are reported in any case.
        let typed = typing.whole(value);
        let of = typed.as_ref().map(|value| value.ty);
        let Some((target, access, ty)) = assigned(target, (attribute, of), names, typing) else {
            continue;
        };
        let word = &names.get(target.name).text;
        if let Some(place) = erased.get(&target.name) {
            let message = format!("`{word}` is erased, so nothing can be assigned to it");
            let error = Diagnostic::error("assign-to-erased", message, target.span)
                .label(*place, "it is erased here");
            typing.report.add(error);
        }
        if let Some(first) = done.insert((target.name, access), *span) {
            let message = format!("`{word}.{}` is assigned twice", attribute.text);
            let error = Diagnostic::error("assigned-twice", message, *span)
                .saying("assigned again")
                .label(first, "assigned first");
            typing.report.add(error);
        }
        let whose = format!("`{word}.{}`", attribute.text);
        let value = typed.and_then(|typed| typing.convert(value, typed, ty, &whose));
        let single = names.get(target.name).role == Role::Single;
        if let Some(value) = value.as_ref().filter(|value| single && value.has_members()) {
            let message = format!("{whose} is set once, but its value has a free index");
            let error = Diagnostic::error("mixed-statement", message, value.span)
                .note("only what has a subscript is set for every index");
            typing.report.add(error);
        }
        assignments.extend(value.map(|value| Assignment {
            target,
            attribute: access,
            value,
            span: *span,
        }));
    }
    assignments
}

/// True if a `new` statement lists the name.
fn is_listed_new(after: &tree::Side, name: &tree::Name) -> bool {
    after.statements.iter().any(|statement| match statement {
        Statement::New(listed, _) => listed.iter().any(|new| new.ident.text == name.ident.text),
        _ => false,
    })
}

/// The element and the attribute that an assignment sets, and the type of the value.
fn assigned(
    target: &tree::Name,
    (attribute_name, of): (&Ident, Option<Type>),
    names: &Names,
    typing: &mut Typing,
) -> Option<(Ref, Access, Type)> {
    let word = &target.ident.text;
    let Some(id) = names.find(word) else {
        let message = format!("`{word}` is assigned to but drawn nowhere");
        let error = Diagnostic::error("unknown-name", message, target.span);
        let error = match parameter_drawn(word, names, typing) {
            Some(how) => error.note(how),
            None => suggest(error, word, target.span, names.words()),
        };
        return typing.report.reject(error);
    };
    typing.subscript(names, id, target)?;
    let kind = names.get(id).kind;
    let Some(ty) = kind.element_type() else {
        let message = format!("`{word}` is {}, which has no attributes", kind.a_word());
        let error = Diagnostic::error("unknown-attribute", message, attribute_name.span);
        return typing.report.reject(error);
    };
    let (access, value) = typing.attribute_of(ty, attribute_name, of)?;
    let target = mention(id, target);
    Some((target, access, value))
}

/// A hint on how to draw a parameter if only an attribute of it is set; `None` if `word` is not a
/// parameter that is an element.
fn parameter_drawn(word: &str, names: &Names, typing: &Typing) -> Option<String> {
    names.parameter(word)?;
    let (_, local) = typing.scopes.find(word)?;
    let ty = local.ty.filter(|ty| ty.is_element())?;
    let is_taken = |word: &str| names.find(word).is_some() || typing.scopes.find(word).is_some();
    let name = |of: Type, letter: &str| match of == ty {
        true => word.to_owned(),
        false => free_name(letter, is_taken),
    };
    let [f, v, h] =
        [(Type::Face, "f"), (Type::Vertex, "v"), (Type::Halfedge, "h")].map(|(of, l)| name(of, l));
    let w = free_name("w", |wanted| wanted == v || is_taken(wanted));
    let orbit = format!("loop {f}: {v} -{h}-> {w} => {v}");
    Some(match ty {
        Type::Edge => {
            let twin = free_name("g", is_taken);
            format!(
                "draw it in `before`, for example `{orbit}` and `edge {word}: {h} | {twin}`, and \
                 list `keep {f} {word}` in `after`"
            )
        }
        _ => format!("draw it in `before`, for example `{orbit}`, and list `keep {f}` in `after`"),
    })
}

/// The number of attributes that are listed where another is not known.
const MOST_LISTED: usize = 20;

impl Typing<'_> {
    /// The attribute of this name of an element, and the type of its values; a value of type `of`
    /// is assigned to it.
    pub(super) fn attribute_of(
        &mut self,
        ty: Type,
        name: &Ident,
        of: Option<Type>,
    ) -> Option<(Access, Type)> {
        self.declared.meet(ty, name);
        let found = attribute(ty, &name.text).or(self.declared.attribute(ty, &name.text));
        if found.is_some() {
            return found;
        }
        if self.declared.has_attribute(&name.text) {
            // The declaration has been rejected already.
            return self.report.fail_silently();
        }
        if let Some(declared) = self.declared.hidden_attribute(ty, &name.text) {
            return self.report.reject(private("unknown-attribute", name, declared));
        }
        if let Some(how) = self.not_assigned(ty, &name.text) {
            if self.report.says(how) {
                return self.report.fail_silently();
            }
            let message = format!("`{}` is a pointer, and pointers are not assigned", name.text);
            return self
                .report
                .reject(Diagnostic::error("unknown-attribute", message, name.span).note(how));
        }
        let element = ty.a_word();
        let message = format!("{element} has no attribute `{}`", name.text);
        let error = Diagnostic::error("unknown-attribute", message, name.span);
        let known = attributes_of(ty).into_iter();
        let known: Vec<&str> = known.chain(self.declared.attributes_of(ty)).collect();
        let here = foreign_words::field(ty, &name.text);
        let here = here.filter(|here| match here {
            Here::Written(ours) => known.contains(ours),
            Here::Said(_) => true,
        });
        let word = (name.text.as_str(), name.span);
        let error = foreign_words::tell(error, word, here, known.iter().copied());
        let belongs = self.declared.belongs(None, ty, &name.text);
        let error = match known.as_slice() {
            _ if let Some(note) = belongs => error.note(note),
            [] => error.note(format!("{element} has none; {}", declaration(&name.text, ty, of))),
            known => error.note(format!(
                "{element} has {}{}; {}",
                quoted(&known[..known.len().min(MOST_LISTED)]),
                if known.len() > MOST_LISTED { ", and others" } else { "" },
                declaration(&name.text, ty, of)
            )),
        };
        self.report.reject(error)
    }

    /// The note on how a pointer of an element is changed, if the word names a pointer, which
    /// cannot be assigned.
    fn not_assigned(&self, ty: Type, word: &str) -> Option<&'static str> {
        let foreign = match foreign_words::field(ty, word) {
            Some(Here::Written(ours)) => ours,
            _ => word,
        };
        if !is_taken(ty, foreign.split('.').next().unwrap_or(foreign))
            || attribute(ty, foreign).is_some()
        {
            return None;
        }
        Some(match self.place {
            Place::Script => "what changes a mesh is an operation, called like `flip(e)`",
            Place::Rule(_) | Place::Default(_) => {
                "`next`, `prev` and `face` follow from the loops that `after` draws, `twin` and \
                 `edge` from its edge statements, `vertex` from both"
            }
        })
    }
}

/// How an attribute of elements of type `element` with values of type `of` is declared.
pub(super) fn declaration(name: &str, element: Type, of: Option<Type>) -> String {
    let ty = of.filter(|ty| ty.zero().is_some()).unwrap_or(Type::Real);
    let (element, zero) = (element.word(), ty.zero().unwrap_or_default());
    let ty = ty.word();
    format!("an attribute of one's own is declared: `attr {name}: {element} {ty} = {zero}`")
}
