//! Names in code for the elements of a drawing.
//!
//! A name is kept wherever possible. A prime becomes `_`; reserved words, and words that are taken,
//! get a suffix. A family is a list with its name, and a member an entry of it: `h[i]`,
//! `h[(i + 1) % n]`.

use std::collections::{BTreeMap, BTreeSet};

use super::item::Need;
use super::items::Source;
use super::language::Language;
use super::reserved::{is_reserved, plain, unreserved};
use super::value::Term;
use crate::diagram::{self, Access, Kind, NameId, Op, Role, Rule, Type};
use crate::resolve::Body;
use crate::source::Span;

/// A name as close as possible to the one that is wanted, which is added to those that are taken;
/// `reserved` are the words that the mesh class reserves.
pub(super) fn free(wanted: &str, reserved: &[String], taken: &mut BTreeSet<String>) -> String {
    let word = plain(wanted);
    let mut free = unreserved(&word, reserved);
    let mut number = 2;
    while !taken.insert(free.clone()) {
        free = unreserved(&format!("{}_{number}", word.trim_end_matches('_')), reserved);
        number += 1;
    }
    free
}

/// A loop over the indices of a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct IndexLoop {
    /// The name of the index, which runs from 0.
    pub index: String,
    /// The name of the number of indices.
    pub size: String,
}

/// An attribute that the program declares.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Attribute {
    /// Its name in the program.
    pub declared: String,
    /// Its name in code.
    pub name: String,
    /// The name of its column, where attributes are stored in columns.
    pub column: String,
    /// The type of the elements that have it.
    pub element: Type,
    /// The type of its values.
    pub ty: Type,
    /// The place of its default in the program.
    pub default: Option<Span>,
}

/// The words for one name of a drawing.
#[derive(Clone, Default)]
pub(super) struct Named {
    /// That for the element, or for the first halfedge of a path; of a family, that of its list.
    word: String,
    /// That for the last halfedge of a path.
    pub last: String,
    /// That for whether a path is empty.
    pub empty: String,
    /// The distance of a member from the index.
    shift: Option<i64>,
    /// That for a member at index 0 that is bound before its family.
    begun: Option<String>,
}

/// The names of one rule, or of one body, in a language.
#[derive(Clone, Default)]
pub(super) struct Names<'s> {
    pub language: Language<'s>,
    /// The names of the drawing, by number.
    drawn: Vec<Named>,
    /// The index of the cycle, and its size.
    pub indices: IndexLoop,
    /// True inside of a repetition for each index.
    pub is_indexed: bool,
    /// The words of the parameters.
    pub params: Vec<String>,
    /// The words of variables, with their numbers.
    bound: Vec<(u32, String)>,
    /// The attributes of the program, and the numbers of those that are used.
    pub attributes: Vec<Attribute>,
    pub used: BTreeSet<u32>,
    /// The names of the functions that have a value, by number.
    functions: &'s [Option<String>],
    /// The functions and operations that are called.
    pub needs: BTreeSet<Need>,
    /// The names of the variables of steps in the program.
    variables: Vec<String>,
    /// The words that are taken; where a scope ends, it is what it was before.
    pub taken: BTreeSet<String>,
}

impl<'s> Names<'s> {
    /// Names for everything that a rule draws. Parameters have the same names in all rules.
    pub fn new(source: &'s Source<'s>, op: &Op, rule: &Rule) -> Self {
        let mut names = Self::without(source, source.language);
        for (at, param) in op.params.iter().enumerate() {
            let wanted = match begins_a_family(op, at) {
                true => format!("{}_0", param.name),
                false => param.name.clone(),
            };
            let word = names.fresh(&wanted);
            names.params.push(word);
        }
        for id in rule.ids() {
            names.name(rule, id);
        }
        names.declare_attributes(&rule.attributes);
        if let Some(cycle) = &rule.cycle {
            let index = names.fresh(&cycle.letter);
            let is_free = |name: &&str| !names.taken.contains(*name) && !is_reserved(name);
            let size = ["n", "count", "size"].into_iter().find(is_free).unwrap_or("n");
            names.indices = IndexLoop { index, size: names.fresh(size) };
        }
        names
    }

    /// Names for steps or a function: the parameters come first among the variables, and are named
    /// at once.
    pub fn of_body(source: &'s Source<'s>, body: &Body, params: usize, is_function: bool) -> Self {
        let language = Language { is_outside: is_function, ..source.language };
        let mut names = Self::without(source, language);
        // No variable shadows what is called; in C++, calls are qualified with a namespace.
        if language.is_rust() {
            names.taken.extend(source.ops.iter().cloned());
            names.taken.extend(source.functions.iter().cloned());
        }
        names.variables = body.variables.iter().map(|known| known.name.clone()).collect();
        for variable in body.variables.iter().take(params) {
            let word = names.fresh(&variable.name);
            names.params.push(word);
        }
        names.declare_attributes(&source.selection.program.attributes);
        names
    }

    /// Names for the attributes of the program.
    fn declare_attributes(&mut self, attributes: &[diagram::Attribute]) {
        let members = self.language.style.map(|style| style.members()).unwrap_or_default();
        let mut taken = BTreeMap::new();
        for declared in attributes {
            let taken = taken.entry(declared.element.word()).or_insert_with(|| members.clone());
            let name = free(&declared.name, self.language.reserved, taken);
            let attribute = Attribute {
                declared: declared.name.clone(),
                column: self.fresh(&format!("{name}_column")),
                name,
                element: declared.element,
                ty: declared.ty,
                default: declared.default.as_ref().map(|value| value.span),
            };
            self.attributes.push(attribute);
        }
    }

    /// No names yet, except for those of the functions.
    fn without(source: &'s Source<'s>, language: Language<'s>) -> Self {
        Self {
            language,
            functions: &source.values,
            taken: source.values.iter().flatten().cloned().collect(),
            ..Self::default()
        }
    }

    /// The name of a function of the program, which counts as called; `None` if it has no value.
    pub fn call(&mut self, number: u32) -> Option<String> {
        let name = self.functions.get(number as usize)?.clone()?;
        self.needs.insert(Need::Function(number));
        Some(name)
    }

    fn name(&mut self, rule: &Rule, id: NameId) {
        let name = rule.name(id);
        let shift = rule.is_member(id).then(|| rule.offset(id));
        if shift.is_some() && !rule.is_first(id) {
            // The list of the family is named after its first member.
            let first = self.drawn[rule.first_member(id).index()].clone();
            return self.drawn.push(Named { shift, begun: None, ..first });
        }
        let param = rule.params.iter().position(|param| *param == Some(id));
        let param = param.map(|at| self.params[at].clone());
        let text = match name.named {
            true => name.text.split('[').next().unwrap_or_default().to_string(),
            false => unnamed(&name.text, name.kind),
        };
        let named = match (param, name.kind) {
            (Some(word), _) if shift.is_none() => Named { word, ..Named::default() },
            (begun, Kind::Path) => Named {
                word: self.fresh(&format!("{text}_first")),
                last: self.fresh(&format!("{text}_last")),
                empty: self.fresh(&format!("{text}_is_empty")),
                shift,
                begun,
            },
            (begun, _) => Named { word: self.fresh(&text), shift, begun, ..Named::default() },
        };
        self.drawn.push(named);
    }

    /// A name that is not taken yet, as close as possible to the one that is wanted.
    pub fn fresh(&mut self, wanted: &str) -> String {
        free(wanted, self.language.reserved, &mut self.taken)
    }

    /// The words for a name.
    pub fn named(&self, name: NameId) -> &Named {
        &self.drawn[name.index()]
    }

    /// That for an element, or for the first halfedge of a path; of a family, that of its list.
    pub fn word(&self, name: NameId) -> &str {
        &self.named(name).word
    }

    /// The term of an element; of a path, that of its first halfedge.
    pub fn term(&self, name: NameId) -> Term {
        self.place(name, self.word(name))
    }

    /// The last halfedge of a path.
    pub fn last(&self, path: NameId) -> Term {
        self.place(path, &self.named(path).last)
    }

    /// The condition that a path is empty.
    pub fn empty(&self, path: NameId) -> Term {
        self.place(path, &self.named(path).empty)
    }

    fn place(&self, name: NameId, word: &str) -> Term {
        match self.drawn[name.index()].shift {
            None => Term::name(word),
            Some(shift) => self.member(word, shift),
        }
    }

    /// The entry of a list at a distance from the index, or from 0 outside of a repetition.
    pub fn member(&self, list: &str, shift: i64) -> Term {
        let index = self.is_indexed.then_some(self.indices.index.as_str());
        Term::member(list, index, shift, &self.indices.size)
    }

    /// The word for a member at index 0 that is bound before its family; for any other name its own
    /// word.
    pub fn begin(&mut self, name: NameId) -> String {
        let Named { word, shift, begun, .. } = &self.drawn[name.index()];
        if let Some(known) = begun.as_ref().or(shift.is_none().then_some(word)) {
            return known.clone();
        }
        let word = self.fresh(&format!("{word}_0"));
        self.drawn[name.index()].begun = Some(word.clone());
        word
    }

    /// The word of a parameter, of the variable of an aggregate, or of a variable.
    pub fn local(&self, number: u32) -> &str {
        let bound = self.bound.iter().rev().find(|(known, _)| *known == number);
        let word = bound.map(|(_, word)| word).or_else(|| self.params.get(number as usize));
        word.map_or("", String::as_str)
    }

    /// Names the variable of an aggregate.
    pub fn declare(&mut self, number: u32, ty: Type) -> String {
        let word = match (self.variables.get(number as usize), ty) {
            (Some(known), _) => known.clone(),
            (None, Type::Vertex) => "w".into(),
            (None, ty) => ty.word()[..1].into(),
        };
        self.bind(number, &word)
    }

    /// An attribute of the program, which counts as used; `None` if it is not declared.
    pub fn attribute(&mut self, number: u32) -> Option<Attribute> {
        let attribute = self.attributes.get(number as usize)?;
        self.used.insert(number);
        Some(attribute.clone())
    }

    /// The same for an access; `None` for a position.
    pub fn accessed(&mut self, access: Access) -> Option<Attribute> {
        match access {
            Access::Position => None,
            Access::Declared(number) => self.attribute(number),
        }
    }

    /// The attributes that are used.
    pub fn used_attributes(&self) -> Vec<Attribute> {
        self.used.iter().map(|&number| self.attributes[number as usize].clone()).collect()
    }

    /// Names a variable, or a value that is computed once.
    pub fn bind(&mut self, number: u32, wanted: &str) -> String {
        let word = self.fresh(wanted);
        self.bound.push((number, word.clone()));
        word
    }
}

/// True if a parameter is the first halfedge of a family.
fn begins_a_family(op: &Op, param: usize) -> bool {
    op.rules.iter().any(|rule| {
        let name = rule.params.get(param).copied().flatten();
        name.is_some_and(|name| rule.name(name).role == Role::Family)
    })
}

/// A word for a path or fan without a name: "the path of `f0`" is `rest_of_f0`.
fn unnamed(description: &str, kind: Kind) -> String {
    let of = description.split('`').nth(1).unwrap_or("").split('[').next().unwrap_or("");
    let is_word =
        !of.is_empty() && of.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '\'');
    match (kind, is_word) {
        (_, true) => format!("rest_of_{}", of.replace('\'', "_")),
        (Kind::Path, false) => "rest".to_string(),
        (_, false) => "others".to_string(),
    }
}
