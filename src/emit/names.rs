//! Names in code for the elements of a drawing.
//!
//! A name is kept wherever possible. A prime becomes `_`; reserved words, and words that are taken,
//! get a suffix. A family is a list with its name, and a member an entry of it: `h[i]`,
//! `h[(i + 1) % n]`.

use std::collections::BTreeSet;

use super::print::support::CPP;
use super::reserved::{is_reserved, plain, unreserved};
use super::routine::Statement;
use super::term::{Attribute, IndexLoop, Term};
use crate::diagram::{self, Kind, NameId, Op, Role, Rule, Type};
use crate::resolve::Variable;

/// The name of a function of the program in code: in C++ it must differ from those of the support
/// functions.
pub(super) fn invoked(name: &str) -> String {
    match CPP.names().any(|known| known.trim_end_matches(".n") == name) {
        true => format!("{name}_"),
        false => unreserved(name, &[]),
    }
}

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

/// The words for one name of a drawing.
#[derive(Clone, Default)]
struct Named {
    /// That for the element, or for the first halfedge of a path; of a family, that of its list.
    word: String,
    /// That for the last halfedge of a path.
    last: String,
    /// That for whether a path is empty.
    empty: String,
    /// The distance of a member from the index.
    shift: Option<i64>,
    /// That for a member at index 0 that is bound before its family.
    begun: Option<String>,
}

/// The names of one rule.
#[derive(Clone, Default)]
pub(super) struct Names {
    /// The names of the drawing, by number.
    drawn: Vec<Named>,
    /// The index of the cycle, and its size.
    pub indices: IndexLoop,
    /// True inside of a repetition for each index.
    pub is_indexed: bool,
    /// The words of the parameters.
    pub params: Vec<String>,
    folds: Vec<(u32, String)>,
    /// The attributes of the program, and whether the rule uses them.
    attributes: Vec<(Attribute, bool)>,
    /// The names of the functions that have a value, by number, and the functions that are called.
    functions: Vec<Option<String>>,
    calls: BTreeSet<u32>,
    /// The names of the variables of steps in the program.
    variables: Vec<String>,
    /// The words that are taken; where a scope ends, it is what it was before.
    pub taken: BTreeSet<String>,
    /// Words that the mesh class reserves.
    reserved: Vec<String>,
}

impl Names {
    /// Names for everything that a rule draws. Parameters have the same names in all rules.
    pub fn new(op: &Op, rule: &Rule, functions: &[Option<String>], reserved: &[String]) -> Self {
        let mut names = Self::without(functions, reserved);
        for (at, param) in op.params.iter().enumerate() {
            let wanted = match begins_a_family(op, at) {
                true => format!("{}_0", param.name),
                false => param.name.clone(),
            };
            let word = names.fresh(&wanted);
            names.params.push(word);
        }
        for id in (0..rule.names.len() as u32).map(NameId) {
            names.name(rule, id);
        }
        names.declare_attributes(&rule.attributes);
        if let Some(cycle) = &rule.cycle {
            names.indices = IndexLoop {
                index: names.fresh(&cycle.letter),
                size: names.first_free(&["n", "count", "size"]),
            };
        }
        names
    }

    /// Names for steps or a function: the parameters come first among the variables, and are named
    /// at once. The words in `taken` are not available.
    pub fn of_body(
        variables: &[Variable],
        params: usize,
        functions: &[Option<String>],
        attributes: &[diagram::Attribute],
        (reserved, taken): (&[String], impl Iterator<Item = String>),
    ) -> Self {
        let mut names = Self::without(functions, reserved);
        names.taken.extend(taken);
        names.variables = variables.iter().map(|known| known.name.clone()).collect();
        for variable in variables.iter().take(params) {
            let word = names.fresh(&variable.name);
            names.params.push(word);
        }
        names.declare_attributes(attributes);
        names
    }

    /// Names for the attributes of the program.
    fn declare_attributes(&mut self, attributes: &[diagram::Attribute]) {
        for declared in attributes {
            let name = unreserved(&plain(&declared.name), &self.reserved);
            let attribute = Attribute {
                declared: declared.name.clone(),
                column: self.fresh(&format!("{name}_column")),
                name,
                element: declared.element,
                ty: declared.ty,
            };
            self.attributes.push((attribute, false));
        }
    }

    /// No names yet, except for those of the functions.
    fn without(functions: &[Option<String>], reserved: &[String]) -> Self {
        Self {
            functions: functions.to_vec(),
            taken: functions.iter().flatten().map(|name| invoked(name)).collect(),
            reserved: reserved.to_vec(),
            ..Self::default()
        }
    }

    /// The name of a function of the program, which counts as called; `None` if it has no value.
    pub fn call(&mut self, number: u32) -> Option<String> {
        let name = self.functions.get(number as usize)?.clone()?;
        self.calls.insert(number);
        Some(name)
    }

    /// Takes the functions that were called.
    pub fn take_calls(&mut self) -> BTreeSet<u32> {
        std::mem::take(&mut self.calls)
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
        free(wanted, &self.reserved, &mut self.taken)
    }

    /// The first of some names that is not taken yet.
    fn first_free(&mut self, wanted: &[&str]) -> String {
        let is_free = |name: &&&str| !self.taken.contains(**name) && !is_reserved(name);
        let free = wanted.iter().find(is_free);
        self.fresh(free.unwrap_or(&wanted[0]))
    }

    /// The word for an element, or for the first halfedge of a path; of a family, that of its list.
    pub fn word(&self, name: NameId) -> &str {
        &self.drawn[name.index()].word
    }

    /// The word for the last halfedge of a path.
    pub fn last_word(&self, path: NameId) -> &str {
        &self.drawn[path.index()].last
    }

    /// The word for whether a path is empty.
    pub fn empty_word(&self, path: NameId) -> &str {
        &self.drawn[path.index()].empty
    }

    /// The term of an element; of a path, that of its first halfedge.
    pub fn term(&self, name: NameId) -> Term {
        self.place(name, self.word(name))
    }

    /// The last halfedge of a path.
    pub fn last(&self, path: NameId) -> Term {
        self.place(path, self.last_word(path))
    }

    /// The condition that a path is empty.
    pub fn empty(&self, path: NameId) -> Term {
        self.place(path, self.empty_word(path))
    }

    fn place(&self, name: NameId, word: &str) -> Term {
        match self.drawn[name.index()].shift {
            None => Term::name(word),
            Some(shift) => self.member(word, shift),
        }
    }

    /// The statement that binds a value, or if `each` the list of its values at each index.
    pub fn bound(&self, ty: Type, name: String, value: Term, each: bool) -> Statement {
        match each {
            true => Statement::Gather { ty, name, indices: self.indices.clone(), item: value },
            false => Statement::Bind { ty, name, value, is_list: false },
        }
    }

    /// The statement that refuses if a condition holds, or if `each` if it does for some index.
    pub fn refusal(&self, when: Term, each: bool, reason: &str) -> Statement {
        let when = if each { when.for_some(self.indices.clone()) } else { when };
        Statement::Refuse { when, reason: reason.to_string() }
    }

    /// A statement, if `each` repeated for each index.
    pub fn repeated(&self, each: bool, statement: Statement) -> Statement {
        match each {
            true => Statement::IndexLoop { indices: self.indices.clone(), body: vec![statement] },
            false => statement,
        }
    }

    /// The entry of a list at a distance from the index, or from 0 outside of a repetition.
    pub fn member(&self, list: &str, shift: i64) -> Term {
        Term::Member {
            list: list.to_string(),
            index: self.is_indexed.then(|| self.indices.index.clone()),
            shift,
            size: self.indices.size.clone(),
        }
    }

    /// The word for a member at index 0 that is bound before its family; for any other name its own
    /// word.
    pub fn begin(&mut self, name: NameId) -> String {
        let Named { word, shift, begun, .. } = &self.drawn[name.index()];
        let word = match (shift, begun) {
            (None, _) => return word.clone(),
            (_, Some(word)) => return word.clone(),
            _ => format!("{word}_0"),
        };
        let word = self.fresh(&word);
        self.drawn[name.index()].begun = Some(word.clone());
        word
    }

    /// Makes something, inside of the repetition for each index if `repeated`.
    pub fn for_each<T>(&mut self, repeated: bool, make: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.is_indexed;
        self.is_indexed |= repeated;
        let made = make(self);
        self.is_indexed = outer;
        made
    }

    /// The word of a parameter, of the variable of an aggregate, or of a variable.
    pub fn local(&self, number: u32) -> &str {
        let fold = self.folds.iter().rev().find(|fold| fold.0 == number);
        match fold {
            Some((_, word)) => word,
            None => self.params.get(number as usize).map_or("", String::as_str),
        }
    }

    /// Names the variable of an aggregate.
    pub fn declare(&mut self, number: u32, ty: Type) -> String {
        let known = self.variables.get(number as usize).cloned();
        let word = known.unwrap_or_else(|| match ty {
            Type::Vertex => "w".into(),
            Type::Halfedge => "h".into(),
            Type::Edge => "e".into(),
            _ => "f".into(),
        });
        let word = self.fresh(&word);
        self.folds.push((number, word.clone()));
        word
    }

    /// An attribute of the program, which counts as used; `None` if it is not declared.
    pub fn attribute(&mut self, number: u32) -> Option<Attribute> {
        let (attribute, is_used) = self.attributes.get_mut(number as usize)?;
        *is_used = true;
        Some(attribute.clone())
    }

    /// Finds the columns of the attributes that are used, and refuses a mesh without the others in
    /// `seen`, which the called functions look at.
    pub fn columns(&self, seen: &BTreeSet<u32>) -> Vec<Statement> {
        let all = || (0..).zip(&self.attributes);
        let used = all().filter(|(_, (_, is_used))| *is_used);
        let asked = all().filter(|(at, (_, is_used))| !is_used && seen.contains(at));
        let used = used.map(|(_, (attribute, _))| Statement::Column(attribute.clone()));
        used.chain(asked.map(|(_, (it, _))| Statement::RequireColumn(it.clone()))).collect()
    }

    /// Names a variable, or a value that is computed once.
    pub fn bind(&mut self, number: u32, wanted: &str) -> String {
        let word = self.fresh(wanted);
        self.folds.push((number, word.clone()));
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
    let of = description.split('`').nth(1).unwrap_or("");
    let of = of.split('[').next().unwrap_or("");
    let is_word =
        !of.is_empty() && of.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '\'');
    match (kind, is_word) {
        (_, true) => format!("rest_of_{}", of.replace('\'', "_")),
        (Kind::Path, false) => "rest".to_string(),
        (_, false) => "others".to_string(),
    }
}
