//! Declarations: the names that are visible in a file, collected before anything is resolved.
//!
//! These are its own items and the items of the files it uses, of which an own item hides one of the
//! same name. Two used files may have items of the same name; only a call of that name is an error.
//! Each item of a used file also has a qualified name, `polygon::flip`, which nothing hides.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::rc::Rc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Access, Type};
use crate::source::{FileId, Span};
use crate::syntax::is_name;
use crate::syntax::tree::{self, Ident, Item, qualified, split_qualified};

use super::attribute_head::{Head, head};
use super::builtin::function_names;
use super::fields::is_taken;
use super::file::{Fields, Types};
use super::foreign_words::{self, Here};
use super::neighbor::path;
use super::report::Report;
use super::scopes::Scopes;
use super::sequence_names::fold_names;
use super::signature::FunctionSignature;
use super::suggestion::suggest_function;
use super::testing::mesh_maker;
use super::unit::Unit;
use super::words::{plural, short};

/// The meaning of a name of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Named {
    /// Its kind.
    pub(super) what: What,
    /// Its number among the items of its kind in the whole program.
    pub(super) number: usize,
    /// The span of its name.
    pub(super) span: Span,
    /// Whether only its file sees it.
    private: bool,
}

/// The kind of a callable item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// An operation.
    Op,
    Function,
    /// A script. Scripts are numbered after the functions.
    Script,
}

impl What {
    fn a_word(self) -> &'static str {
        match self {
            What::Op => "an op",
            What::Function => "a function",
            What::Script => "a script",
        }
    }
}

/// The names that are visible in a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Declared {
    /// The callable items by name; of two with the same name, the first.
    called: BTreeMap<String, Named>,
    /// Items of other used files with the same name as one in `called`.
    others: HashMap<String, Span>,
    /// The private items of used files, by name and by qualified name.
    hidden_items: HashMap<String, Span>,
    /// The qualifier of each used file.
    qualifiers: HashMap<FileId, String>,
    /// The signatures of functions and scripts, as far as they are known, by name.
    functions: HashMap<String, Rc<FunctionSignature>>,
    /// The visible attributes.
    attributes: Vec<Head>,
    /// The names of attributes whose declaration is invalid.
    lost_attributes: HashSet<String>,
    /// The private attributes of used files.
    hidden_attributes: Vec<Head>,
    /// The functions of the language whose names the file declares, which is an error.
    taken: HashSet<String>,
    /// The names that the file declares several times, which is an error.
    repeated: HashSet<String>,
    /// True if a used file is missing.
    lacks: bool,
    /// The meanings of the words after dots that have been seen so far.
    met: RefCell<Fields>,
    /// The types of the variables that have been seen so far.
    types: RefCell<Types>,
}

/// The numbers of items counted so far.
#[derive(Debug, Default)]
struct Numbers {
    ops: usize,
    functions: usize,
    scripts: usize,
    attributes: u32,
    /// The public attributes, whose names are unique across all files.
    public: Vec<Head>,
}

impl Declared {
    /// The declarations of each file of a program. Reports duplicate names and invalid attributes.
    pub(super) fn of_all(units: &[Unit], diagnostics: &mut Vec<Diagnostic>) -> Vec<Self> {
        let mut numbers = Numbers::default();
        let own = units.iter().map(|unit| {
            let mut own = Self::default();
            own.declare(unit.tree, &mut numbers, diagnostics);
            own
        });
        let mut own: Vec<Self> = own.collect();
        let called = own.iter_mut().flat_map(|own| own.called.values_mut());
        for script in called.filter(|named| named.what == What::Script) {
            script.number += numbers.functions;
        }
        let with_used = |(own_of, unit): (&Self, &Unit)| {
            let mut all = own_of.clone();
            all.lacks = unit.lacks;
            let used = unit.uses.iter().filter_map(|&used| own.get(used).zip(units.get(used)));
            for (used, unit) in used {
                all.take_in((used, unit.qualifier), own_of, diagnostics);
            }
            all
        };
        own.iter().zip(units).map(with_used).collect()
    }

    fn declare(
        &mut self,
        file: &tree::File,
        numbers: &mut Numbers,
        diagnostics: &mut Vec<Diagnostic>,
    ) {
        for item in &file.items {
            let (what, name, count) = match item {
                Item::Op(op) => (What::Op, &op.name, &mut numbers.ops),
                Item::Script(script) => (What::Script, &script.name, &mut numbers.scripts),
                Item::Fn(function) => (What::Function, &function.name, &mut numbers.functions),
                Item::Attr(attr) => {
                    let misread = file.is_misread(attr.span);
                    self.declare_attribute((attr, misread), numbers, diagnostics);
                    continue;
                }
                Item::Test(_) | Item::Use(_) | Item::Broken(_) => continue,
            };
            let private = item.private_name().is_some();
            let named = Named { what, number: *count, span: name.span, private };
            *count += 1;
            diagnostics.extend(self.declare_called(name, named));
        }
    }

    fn declare_called(&mut self, name: &Ident, named: Named) -> Option<Diagnostic> {
        if is_of_the_language(&name.text) {
            self.taken.insert(name.text.clone());
            let message = format!(
                "`{}` is a function of the language; {} needs another name",
                name.text,
                named.what.a_word()
            );
            return Some(Diagnostic::error("duplicate-name", message, name.span));
        }
        if let Some(first) = self.called.get(&name.text) {
            let told = duplicate(first.what.a_word(), name, first.span);
            self.repeated.insert(name.text.clone());
            return Some(told);
        }
        self.called.insert(name.text.clone(), named);
        None
    }

    fn declare_attribute(
        &mut self,
        (attr, misread): (&tree::Attr, bool),
        numbers: &mut Numbers,
        diagnostics: &mut Vec<Diagnostic>,
    ) {
        let number = numbers.attributes;
        numbers.attributes += 1;
        let head = head(attr, number, diagnostics).filter(|_| !misread).and_then(|head| {
            let others = self.attributes.iter();
            let public = numbers.public.iter().filter(|_| !head.private);
            match others.chain(public).find(|other| other.is_named_as(&head)) {
                None => Some(head),
                Some(other) => {
                    diagnostics.push(clash(&head, other));
                    None
                }
            }
        });
        match head {
            Some(head) => {
                numbers.public.extend((!head.private).then(|| head.clone()));
                self.attributes.push(head);
            }
            None => drop(self.lost_attributes.insert(attr.name.text.clone())),
        }
    }

    /// Adds the declarations of a used file; one that the file's `own` hide only by its qualified
    /// name. A clash of attributes is an error.
    fn take_in(
        &mut self,
        (used, qualifier): (&Self, &str),
        own: &Self,
        diagnostics: &mut Vec<Diagnostic>,
    ) {
        for (name, named) in &used.called {
            self.qualifiers.entry(named.span.file).or_insert_with(|| qualifier.to_owned());
            let qualified = qualified(qualifier, name);
            if named.private {
                self.hidden_items.extend([name.clone(), qualified].map(|name| (name, named.span)));
                continue;
            }
            let alone = (!own.called.contains_key(name)).then(|| name.clone());
            for name in alone.into_iter().chain([qualified]) {
                match self.called.get(&name) {
                    None => drop(self.called.insert(name, *named)),
                    Some(_) => drop(self.others.insert(name, named.span)),
                }
            }
        }
        for head in used.attributes.iter().filter(|head| !head.private) {
            match own.attributes.iter().find(|mine| mine.is_named_as(head)) {
                // A clash of two public attributes has been reported already.
                Some(mine) if mine.private => diagnostics.push(clash(mine, head)),
                _ => self.attributes.push(head.clone()),
            }
        }
        self.hidden_attributes.extend(used.attributes.iter().filter(|head| head.private).cloned());
        self.lost_attributes.extend(used.lost_attributes.iter().cloned());
    }

    /// The callable item of this name.
    pub(super) fn called(&self, name: &str) -> Option<Named> {
        self.called.get(name).copied()
    }

    /// The number of the op of this name.
    pub(super) fn op(&self, name: &str) -> Option<usize> {
        let named = self.called(name)?;
        (named.what == What::Op).then_some(named.number)
    }

    /// The signature of the function or script of this name, as far as it is known.
    pub(super) fn function(&self, name: &str) -> Option<&Rc<FunctionSignature>> {
        self.functions.get(name)
    }

    /// Stores what is currently known of a function if its name refers to it in this file.
    pub(super) fn learn(&mut self, signature: &Rc<FunctionSignature>) {
        let file = self.qualifiers.get(&signature.span.file);
        let qualified = file.map(|file| qualified(file, &signature.name));
        for name in [signature.name.clone()].into_iter().chain(qualified) {
            if self.called(&name).is_some_and(|named| named.span == signature.span) {
                self.functions.insert(name, Rc::clone(signature));
            }
        }
    }

    /// Reports a name that is ambiguous; one that the file declares several times has been reported.
    pub(super) fn expect_one(&self, name: &Ident, report: &mut Report) -> Option<()> {
        if self.repeated.contains(&name.text) {
            return report.fail_silently();
        }
        let (Some(first), Some(other)) = (self.called(&name.text), self.others.get(&name.text))
        else {
            return Some(());
        };
        let message = format!("two of the files that are used declare `{}`", name.text);
        let mut error = Diagnostic::error("ambiguous-name", message, name.span)
            .label(first.span, "one is here")
            .label(*other, "the other is here");
        let ways = [first.span, *other].map(|place| self.qualified(name, place));
        if let [Some(first), Some(other)] = &ways
            && first != other
        {
            error = error.note(format!("their qualified names are `{first}` and `{other}`"));
            for way in [first, other] {
                error = error.fix(format!("write `{way}`"), name.span, way);
            }
        } else {
            error = error.note(
                "qualified names, such as `triangle::flip(…)`, need files of different names that \
                 are names of the language, too",
            );
        }
        report.reject(error)
    }

    /// Adds to the error about an unknown function or op what may have been meant, perhaps one of
    /// the `candidates`; only one that `fits` the call is certain.
    pub(super) fn tell_what_is_meant<'a>(
        &'a self,
        error: Diagnostic,
        function: &Ident,
        candidates: impl IntoIterator<Item = &'a str>,
        fits: impl Fn(&str) -> bool,
    ) -> Diagnostic {
        if let Some(&declared) = self.hidden_items.get(&function.text) {
            return private(error.code, function, declared);
        }
        let (file, word) = split_qualified(&function.text);
        let span = function.span;
        let is_known = |file: &str| self.qualifiers.values().any(|known| known == file);
        if file.is_some() && is_of_the_language(word)
            || file.is_some_and(|file| !is_known(file)) && self.is_called(word)
        {
            return error
                .saying(format!("a name stands alone, without what it belongs to: `{word}`"))
                .fix(format!("write `{word}`"), span, word);
        }
        if let Some(file) = file.filter(|file| is_known(file)) {
            let is_there = |name: &&str| split_qualified(name).0 == Some(file);
            let there = self.called.keys().map(String::as_str).filter(is_there);
            return suggest_function(error, &function.text, span, there, fits);
        }
        let here = foreign_words::function_called(word, &fits).or_else(|| mesh_maker(word));
        match (here, foreign_words::function(word)) {
            (Some(_), _) => foreign_words::tell(error, (word, span), here, []),
            (None, Some(Here::Written(ours))) => error.note(format!("it is written `{ours}`")),
            _ => suggest_function(error, word, span, candidates, fits),
        }
    }

    /// The qualified name of an item of a used file, if it can be written.
    fn qualified(&self, name: &Ident, place: Span) -> Option<String> {
        let file = self.qualifiers.get(&place.file)?;
        let (before, name) = split_qualified(&name.text);
        (before.is_none() && is_name(file)).then(|| qualified(file, name))
    }

    /// True if the name refers to the op, function or script declared here, and not to an earlier
    /// one.
    pub(super) fn has_its_name(&self, name: &Ident) -> bool {
        self.called(&name.text).is_some_and(|named| named.span == name.span)
    }

    /// The names of all callable items, without qualified ones.
    pub(super) fn called_names(&self) -> impl Iterator<Item = &str> {
        self.called.keys().map(String::as_str).filter(|name| split_qualified(name).0.is_none())
    }

    /// The names of the ops among these.
    pub(super) fn op_names(&self) -> impl Iterator<Item = &str> {
        self.called_names().filter(|name| self.op(name).is_some())
    }

    /// True if there is a script of this name.
    pub(super) fn is_script(&self, name: &str) -> bool {
        self.called(name).is_some_and(|named| named.what == What::Script)
    }

    /// True if a callable item or a built-in function has this name.
    pub(super) fn is_called(&self, name: &str) -> bool {
        self.called(name).is_some() || is_of_the_language(name)
    }

    /// True if the name is of the language, and declared in the file nevertheless.
    pub(super) fn is_taken(&self, name: &str) -> bool {
        self.taken.contains(name)
    }

    /// True if a used file is missing, so that an unknown name may be declared there.
    pub(super) fn lacks_files(&self) -> bool {
        self.lacks
    }

    /// The type of the elements that have an attribute of this name.
    pub(super) fn element_with(&self, name: &str) -> Option<Type> {
        self.attributes.iter().find(|head| head.name == name).map(|head| head.element)
    }

    /// True if an attribute of this name has been rejected, or may be declared in a used file that
    /// is missing.
    pub(super) fn has_attribute(&self, name: &str) -> bool {
        self.lacks || self.lost_attributes.contains(name)
    }

    /// The place where a used file declares a private attribute of this name.
    pub(super) fn hidden_attribute(&self, element: Type, name: &str) -> Option<Span> {
        let mut hidden = self.hidden_attributes.iter();
        let head = hidden.find(|head| head.element == element && head.name == name)?;
        Some(head.span)
    }

    /// The attribute of this name of elements of a type, and the type of its values.
    pub(super) fn attribute(&self, element: Type, name: &str) -> Option<(Access, Type)> {
        let mut known = self.attributes.iter();
        let head = known.find(|head| head.element == element && head.name == name)?;
        Some((Access::Declared(head.number), head.ty))
    }

    /// The note on the elements to which a field belongs, if those of type `ty` lack it; `of` is
    /// what stands before the dot.
    pub(super) fn belongs(&self, of: Option<&tree::Expr>, ty: Type, name: &str) -> Option<String> {
        let mut known = self.attributes.iter().filter(|head| head.name == name);
        let owners = || known.clone().map(|head| head.element);
        let near = owners().find_map(|owner| Some((owner, path(ty, owner)?)));
        Some(match (near, of.and_then(|of| short(of, 3))) {
            (Some((owner, path)), Some(of)) => {
                format!("`{name}` belongs to {}: `{of}.{path}.{name}`", plural(owner))
            }
            _ => format!("`{name}` belongs to {}", plural(known.next()?.element)),
        })
    }

    /// Records what the word after the dot of a value means, if it means something.
    pub(super) fn meet(&self, of: Type, field: &Ident) {
        let mut known = self.attributes.iter();
        let head = known.find(|head| head.element == of && head.name == field.text);
        if head.is_some() || is_taken(of, &field.text) {
            self.met.borrow_mut().insert(field.span, head.map(|head| head.span));
        }
    }

    /// Takes the recorded meanings of the words after dots.
    pub(super) fn take_met(&mut self) -> Fields {
        self.met.take()
    }

    /// Records the types of variables, as far as they are known.
    pub(super) fn meet_variables(&self, scopes: &Scopes) {
        self.types.borrow_mut().extend(scopes.types());
    }

    /// Takes the recorded types of variables.
    pub(super) fn take_types(&mut self) -> Types {
        self.types.take()
    }

    /// The names of the declared attributes of elements of a type.
    pub(super) fn attributes_of(&self, element: Type) -> impl Iterator<Item = &str> {
        let of_element = self.attributes.iter().filter(move |head| head.element == element);
        of_element.map(|head| head.name.as_str())
    }

    /// Removes an attribute whose declaration has an error.
    pub(super) fn lose_attribute(&mut self, name: &Ident) {
        if let Some(at) = self.attributes.iter().position(|head| head.span == name.span) {
            self.attributes.remove(at);
            self.lost_attributes.insert(name.text.clone());
        }
    }

    /// The attribute declared at this span.
    pub(super) fn attribute_at(&self, span: Span) -> Option<&Head> {
        self.attributes.iter().find(|head| head.span == span)
    }
}

fn is_of_the_language(name: &str) -> bool {
    function_names().chain(fold_names()).any(|known| known == name)
}

/// The error for an attribute whose name is taken by another.
fn clash(head: &Head, other: &Head) -> Diagnostic {
    let what = format!("{} attribute", head.element.a_word());
    let name = Ident { text: head.name.clone(), span: head.span };
    let error = duplicate(&what, &name, other.span);
    error.when(head.span.file != other.span.file, |error| {
        error.note("the attributes of all files of a program have one namespace")
    })
}

/// The error for a private item of another file; `code` is that of an unknown one.
pub(super) fn private(code: &'static str, name: &Ident, declared: Span) -> Diagnostic {
    let message = format!("`{}` is private to the file that declares it", name.text);
    Diagnostic::error(code, message, name.span)
        .label(declared, "it is declared here")
        .note("without `private` all files see it that use that one")
}

/// The error for a name that is taken; `what` is the kind of item, with its article.
pub(super) fn duplicate(what: &str, name: &Ident, first: Span) -> Diagnostic {
    let message = format!("there is already {what} `{}`", name.text);
    Diagnostic::error("duplicate-name", message, name.span).label(first, "the first is here")
}
