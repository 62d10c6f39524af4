//! Declarations: the names of a file, before any of it is understood.
//!
//! Those are its own items, and the items of the files it uses. Two files that are used may
//! have items of one name; only to call it is an error then.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::rc::Rc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Access, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Ident, Item};

use super::attribute_head::{Head, head};
use super::builtin::function_names;
use super::fields::is_taken;
use super::file::Fields;
use super::report::Report;
use super::sequence_names::fold_names;
use super::signature::FunctionSignature;
use super::unit::Unit;
use super::words::a_type;

/// The meaning of a name of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Named {
    /// Its kind.
    pub(super) what: What,
    /// Its number among those of the whole program.
    pub(super) number: usize,
    /// The span of its name.
    pub(super) span: Span,
}

/// The kind of what can be called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// An operation.
    Op,
    /// A function.
    Function,
    /// A script. Its number is one behind those of the functions.
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

/// The names that stand in a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Declared {
    /// The items that can be called, by name; of two of one name the first.
    called: BTreeMap<String, Named>,
    /// Other items that a used file has under such a name.
    others: HashMap<String, Span>,
    /// The functions that are known so far, by name.
    functions: HashMap<String, Rc<FunctionSignature>>,
    /// The attributes that can be seen.
    attributes: Vec<Head>,
    /// The names of those that could not be understood.
    lost_attributes: HashSet<String>,
    /// The attributes of used files that only those see.
    hidden: Vec<Head>,
    /// True if some of what is used is not known.
    lacks: bool,
    /// The meanings of the words behind dots that have been met.
    met: RefCell<Fields>,
}

/// The number of them of what is numbered.
#[derive(Debug, Default)]
struct Numbers {
    ops: usize,
    functions: usize,
    scripts: usize,
    attributes: u32,
    /// The attributes that are not private: each has its name alone, in all files.
    public: Vec<Head>,
}

impl Declared {
    /// The declarations of each file of a program; says which names are taken, and which items are
    /// not understood yet.
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
            for used in unit.uses.iter().filter_map(|&used| own.get(used)) {
                all.take_in(used, own_of, diagnostics);
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
            match item {
                Item::Op(op) => {
                    let named = Named { what: What::Op, number: numbers.ops, span: op.name.span };
                    numbers.ops += 1;
                    diagnostics.extend(self.declare_called(&op.name, named));
                }
                Item::Script(script) => {
                    let named = Named {
                        what: What::Script,
                        number: numbers.scripts,
                        span: script.name.span,
                    };
                    numbers.scripts += 1;
                    diagnostics.extend(self.declare_called(&script.name, named));
                }
                Item::Fn(function) => {
                    let named = Named {
                        what: What::Function,
                        number: numbers.functions,
                        span: function.name.span,
                    };
                    numbers.functions += 1;
                    diagnostics.extend(self.declare_called(&function.name, named));
                }
                Item::Attr(attr) => {
                    self.declare_attribute(attr, numbers, diagnostics);
                }
                Item::Test(_) | Item::Use(_) | Item::Broken(_) => {}
            }
        }
    }

    fn declare_called(&mut self, name: &Ident, named: Named) -> Option<Diagnostic> {
        if is_of_the_language(&name.text) {
            let message = format!(
                "`{}` is a function of the language; {} needs another name",
                name.text,
                named.what.a_word()
            );
            return Some(Diagnostic::error("duplicate-name", message, name.span));
        }
        if let Some(first) = self.called.get(&name.text) {
            return Some(duplicate(first.what.a_word(), name, first.span));
        }
        self.called.insert(name.text.clone(), named);
        None
    }

    fn declare_attribute(
        &mut self,
        attr: &tree::Attr,
        numbers: &mut Numbers,
        diagnostics: &mut Vec<Diagnostic>,
    ) {
        let number = numbers.attributes;
        numbers.attributes += 1;
        let head = head(attr, number, diagnostics).and_then(|head| {
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

    /// Takes in what a used file declares. What the file has of its `own` clashes with it.
    fn take_in(&mut self, used: &Self, own: &Self, diagnostics: &mut Vec<Diagnostic>) {
        for (name, named) in &used.called {
            if let Some(mine) = own.called.get(name) {
                // A script of a used file gives way.
                if named.what == What::Script {
                    continue;
                }
                let name = Ident { text: name.clone(), span: mine.span };
                let error = duplicate(named.what.a_word(), &name, named.span);
                diagnostics.push(error.note("a file has the names of the files it uses"));
                continue;
            }
            match self.called.get(name) {
                None => drop(self.called.insert(name.clone(), *named)),
                Some(_) => drop(self.others.insert(name.clone(), named.span)),
            }
        }
        for head in used.attributes.iter().filter(|head| !head.private) {
            match own.attributes.iter().find(|mine| mine.is_named_as(head)) {
                // Two that are public have been told apart already.
                Some(mine) if mine.private => diagnostics.push(clash(mine, head)),
                _ => self.attributes.push(head.clone()),
            }
        }
        self.hidden.extend(used.attributes.iter().filter(|head| head.private).cloned());
        let lost = used.lost_attributes.iter().cloned();
        self.lost_attributes.extend(lost);
    }

    /// The meaning of a name that is called.
    pub(super) fn called(&self, name: &str) -> Option<Named> {
        self.called.get(name).copied()
    }

    /// The number of the op of this name.
    pub(super) fn op(&self, name: &str) -> Option<usize> {
        let named = self.called(name)?;
        (named.what == What::Op).then_some(named.number)
    }

    /// The function of this name, as far as it is known.
    pub(super) fn function(&self, name: &str) -> Option<&Rc<FunctionSignature>> {
        self.functions.get(name)
    }

    /// Takes in what is known of a function by now, if it can be named here.
    pub(super) fn learn(&mut self, signature: &Rc<FunctionSignature>) {
        let named = self.called(&signature.name);
        if named.is_some_and(|named| named.span == signature.span) {
            let name = signature.name.clone();
            self.functions.insert(name, Rc::clone(signature));
        }
    }

    /// Complains about a name that could mean two things.
    pub(super) fn expect_one(&self, name: &Ident, report: &mut Report) -> Option<()> {
        let (Some(first), Some(other)) = (self.called(&name.text), self.others.get(&name.text))
        else {
            return Some(());
        };
        let message = format!("two of the files that are used declare `{}`", name.text);
        let error = Diagnostic::error("ambiguous-name", message, name.span)
            .label(first.span, "one is here")
            .label(*other, "the other is here")
            .note(format!(
                "one of them has another name in a file of its own that uses only that: as `op \
                 other_name(…) {{ steps {{ must {}(…) }} }}`",
                name.text
            ));
        report.add(error);
        None
    }

    /// True if the op, function or script whose name stands here has the name, and not an earlier
    /// one.
    pub(super) fn has_its_name(&self, name: &Ident) -> bool {
        self.called(&name.text).is_some_and(|named| named.span == name.span)
    }

    /// The names of all that can be called.
    pub(super) fn called_names(&self) -> impl Iterator<Item = &str> {
        self.called.keys().map(String::as_str)
    }

    /// The names of the ops.
    pub(super) fn op_names(&self) -> impl Iterator<Item = &str> {
        let ops = self.called.iter().filter(|(_, named)| named.what == What::Op);
        ops.map(|(name, _)| name.as_str())
    }

    /// True if there is a script of this name.
    pub(super) fn is_script(&self, name: &str) -> bool {
        self.called(name).is_some_and(|named| named.what == What::Script)
    }

    /// True if the name is that of something to call.
    pub(super) fn is_called(&self, name: &str) -> bool {
        self.called(name).is_some() || is_of_the_language(name)
    }

    /// True if what is called may stand where it cannot be seen.
    pub(super) fn lacks_files(&self) -> bool {
        self.lacks
    }

    /// The type of the elements that have an attribute of this name.
    pub(super) fn element_with(&self, name: &str) -> Option<Type> {
        self.attributes.iter().find(|head| head.name == name).map(|head| head.element)
    }

    /// True if an attribute of this name has been refused, or may stand where it cannot be seen
    /// yet.
    pub(super) fn has_attribute(&self, name: &str) -> bool {
        self.lacks || self.lost_attributes.contains(name)
    }

    /// The place where a used file declares an attribute of this name that only it sees.
    pub(super) fn hidden_attribute(&self, element: Type, name: &str) -> Option<Span> {
        let mut hidden = self.hidden.iter();
        let head = hidden.find(|head| head.element == element && head.name == name)?;
        Some(head.span)
    }

    /// The attribute of this name of elements of a type, and the type of its values.
    pub(super) fn attribute(&self, element: Type, name: &str) -> Option<(Access, Type)> {
        let mut known = self.attributes.iter();
        let head = known.find(|head| head.element == element && head.name == name)?;
        Some((Access::Declared(head.number), head.ty))
    }

    /// Remembers what the word behind the dot of a value means, if it means something.
    pub(super) fn meet(&self, of: Type, field: &Ident) {
        let mut known = self.attributes.iter();
        let head = known.find(|head| head.element == of && head.name == field.text);
        if head.is_some() || is_taken(of, &field.text) {
            self.met.borrow_mut().insert(field.span, head.map(|head| head.span));
        }
    }

    /// The meanings of the words behind dots that have been met.
    pub(super) fn take_met(&mut self) -> Fields {
        self.met.take()
    }

    /// The names of the attributes that elements of a type are declared to have.
    pub(super) fn attributes_of(&self, element: Type) -> impl Iterator<Item = &str> {
        let of_element = self.attributes.iter().filter(move |head| head.element == element);
        of_element.map(|head| head.name.as_str())
    }

    /// The attribute whose name stands here.
    pub(super) fn attribute_at(&self, span: Span) -> Option<&Head> {
        self.attributes.iter().find(|head| head.span == span)
    }
}

fn is_of_the_language(name: &str) -> bool {
    function_names().chain(fold_names()).any(|known| known == name)
}

/// The error for an attribute whose name another has.
fn clash(head: &Head, other: &Head) -> Diagnostic {
    let what = format!("{} attribute", a_type(head.element));
    let name = Ident { text: head.name.clone(), span: head.span };
    let error = duplicate(&what, &name, other.span);
    match head.span.file == other.span.file {
        true => error,
        false => error.note("the attributes of all files of a program have one namespace"),
    }
}

/// The error for a name that `what` (with its article) has taken.
pub(super) fn duplicate(what: &str, name: &Ident, first: Span) -> Diagnostic {
    let message = format!("there is already {what} `{}`", name.text);
    Diagnostic::error("duplicate-name", message, name.span).label(first, "the first is here")
}
