//! The table of a rule's names, each with one kind and one number, shared by both sides.

use std::collections::{HashMap, HashSet};

use crate::diagnostic::Diagnostic;
use crate::diagram::{Cycle, Kind, Name, NameId, Role, Type};
use crate::source::Span;
use crate::syntax::tree::{Rule, Side, Statement};

use super::mention::{Mention, mentions};
use super::report::Report;
use super::signature::Parameter;

/// The names of one rule.
#[derive(Debug, Default)]
pub(super) struct Names {
    list: Vec<Name>,
    numbers: HashMap<String, NameId>,
    /// By number: whether the name occurs in a statement of `before`, or is a parameter.
    readable: Vec<bool>,
    /// By number: whether the name occurs in a statement of `after`.
    after: Vec<bool>,
    /// By number: whether the name occurs more than once, or is a parameter.
    again: Vec<bool>,
    /// The place of each name in `new`.
    created: HashMap<NameId, Span>,
    /// The parameters of the op, and their places.
    params: Vec<(String, Span)>,
    /// The letter of the index, if there are families.
    letter: Option<String>,
    /// The names that are used as two kinds, which has been reported.
    suppressed: HashSet<String>,
}

/// The origin of the kind of a name.
struct Origin {
    kind: Result<Kind, Type>,
    span: Span,
    told: bool,
}

impl Names {
    /// Reads the names of a rule. A name used as two kinds is reported and keeps the first.
    pub(super) fn of(
        rule: &Rule,
        params: &[Parameter],
        letter: Option<String>,
        report: &mut Report,
    ) -> Self {
        let before = rule.before.as_ref().map(mentions).unwrap_or_default();
        let after = rule.after.as_ref().map(mentions).unwrap_or_default();
        let all = || before.iter().chain(&after);
        let kinds = kinds(params, all(), report);
        let suppressed = kinds.iter().filter(|(_, origin)| origin.told);
        let mut names = Self {
            params: params.iter().map(|param| (param.name.clone(), param.span)).collect(),
            letter,
            suppressed: suppressed.map(|(word, _)| word.clone()).collect(),
            ..Self::default()
        };
        for mention in all() {
            if let Some(Ok(kind)) = kinds.get(mention.text.as_ref()).map(|o| o.kind) {
                names.add(mention, kind);
            }
        }
        for mention in before.iter().filter(|mention| mention.kind.is_some()) {
            names.mark(&mention.text, |names| &mut names.readable);
        }
        for mention in after.iter().filter(|mention| mention.kind.is_some()) {
            names.mark(&mention.text, |names| &mut names.after);
        }
        for param in params {
            names.mark(&param.name, |names| &mut names.readable);
            names.mark(&param.name, |names| &mut names.again);
        }
        names.read_created(rule.after.as_ref());
        names
    }

    fn add(&mut self, mention: &Mention, kind: Kind) {
        if let Some(known) = self.find(&mention.text) {
            self.again[known.index()] = true;
            return;
        }
        let id = NameId(self.list.len() as u32);
        let text = mention.text.as_ref().to_owned();
        self.numbers.insert(text.clone(), id);
        self.list.push(Name {
            text,
            kind,
            named: mention.is_named(),
            role: match mention.index {
                Some(_) => Role::Family,
                None => Role::Single,
            },
            span: mention.span,
        });
        self.readable.push(false);
        self.after.push(false);
        self.again.push(false);
    }

    fn mark(&mut self, word: &str, marks: impl FnOnce(&mut Self) -> &mut Vec<bool>) {
        if let Some(id) = self.find(word) {
            marks(self)[id.index()] = true;
        }
    }

    fn read_created(&mut self, after: Option<&Side>) {
        for statement in after.iter().flat_map(|side| &side.statements) {
            let Statement::New(listed, _) = statement else { continue };
            for name in listed {
                if let Some(id) = self.find(&name.ident.text) {
                    self.created.entry(id).or_insert(name.span);
                }
            }
        }
    }

    /// The number of a name.
    pub(super) fn find(&self, word: &str) -> Option<NameId> {
        self.numbers.get(word).copied()
    }

    /// A name by its number.
    pub(super) fn get(&self, id: NameId) -> &Name {
        &self.list[id.index()]
    }

    /// The names that are written in the program, in order of first mention.
    pub(super) fn words(&self) -> impl Iterator<Item = &str> {
        self.list.iter().filter(|name| name.named).map(|name| name.text.as_str())
    }

    /// True if, by the drawing, it exists before the rewrite.
    pub(super) fn readable(&self, id: NameId) -> bool {
        self.readable[id.index()]
    }

    /// True if a statement of `after` mentions it.
    pub(super) fn in_after(&self, id: NameId) -> bool {
        self.after[id.index()]
    }

    /// True if it is written once only.
    pub(super) fn is_alone(&self, id: NameId) -> bool {
        !self.again[id.index()]
    }

    /// The place where it is listed in `new`.
    pub(super) fn created(&self, id: NameId) -> Option<Span> {
        self.created.get(&id).copied()
    }

    /// The number of parameters of the op: the first variables, before those of aggregates.
    pub(super) fn params(&self) -> usize {
        self.params.len()
    }

    /// The place of the parameter of this name.
    pub(super) fn parameter(&self, word: &str) -> Option<Span> {
        self.params.iter().find(|(param, _)| param == word).map(|&(_, span)| span)
    }

    /// True if it is used as two kinds, which has been reported.
    pub(super) fn is_suppressed(&self, id: NameId) -> bool {
        self.suppressed.contains(&self.get(id).text)
    }

    /// The letter of the index, if there are families.
    pub(super) fn letter(&self) -> Option<&str> {
        self.letter.as_deref()
    }

    /// The index of the rule, if it has families.
    pub(super) fn cycle(&self) -> Option<Cycle> {
        let letter = self.letter.clone()?;
        Some(Cycle { letter, size: None })
    }

    /// The table.
    pub(super) fn into_list(self) -> Vec<Name> {
        self.list
    }
}

/// The kind of each name: that of its parameter, otherwise that of its first use.
fn kinds<'a>(
    params: &[Parameter],
    mentions: impl Iterator<Item = &'a Mention<'a>>,
    report: &mut Report,
) -> HashMap<String, Origin> {
    let mut kinds: HashMap<String, Origin> = HashMap::new();
    for param in params {
        if let Some(ty) = param.ty {
            let kind = ty.element_kind().map(Kind::from).ok_or(ty);
            let origin = Origin { kind, span: param.span, told: false };
            kinds.entry(param.name.clone()).or_insert(origin);
        }
    }
    let mut last = None;
    for mention in mentions {
        let Some(kind) = mention.kind else { continue };
        let first = kinds.entry(mention.text.as_ref().to_owned());
        let first = first.or_insert(Origin { kind: Ok(kind), span: mention.span, told: false });
        if first.kind != Ok(kind) && !first.told {
            first.told = true;
            // Two vertices in place of the halfedges of an edge are one mistake, not two.
            let mistaken = (first.kind, kind);
            match last == Some(mistaken) {
                true => report.fail(),
                false => report.add(two_kinds(mention, kind, first)),
            }
            last = Some(mistaken);
        }
    }
    kinds
}

fn two_kinds(mention: &Mention, kind: Kind, first: &Origin) -> Diagnostic {
    let word = &mention.text;
    let used = kind.a_word();
    let (message, first_is) = match first.kind {
        Ok(was) => {
            let was = was.a_word();
            (format!("`{word}` is {was}, but here it is {used}"), was)
        }
        Err(ty) => {
            let ty = ty.a_word();
            let message = format!(
                "the parameter `{word}` is {ty}, but here `{word}` is {used}; rename one of them"
            );
            (message, ty)
        }
    };
    let error = Diagnostic::error("two-kinds", message, mention.span);
    let error = match (first.kind, kind) {
        (Ok(Kind::Vertex), Kind::Halfedge) => error.note(
            "an edge names its halfedges, `edge e: a | d`; a vertex its spokes, `vertex v: a *S b`",
        ),
        (Ok(Kind::Halfedge), Kind::Vertex) => {
            error.note("a loop has vertices, and halfedges in its arrows: `v0 -a-> v1`")
        }
        (Ok(Kind::Halfedge), Kind::Fan) => {
            error.note(format!("the name of a fan touches its star: `*{word}`"))
        }
        _ => error,
    };
    error.saying(format!("used as {used}")).label(first.span, format!("here it is {first_is}"))
}
