//! What a file declares, by name, before any of it is understood.

use std::collections::{HashMap, HashSet};

use crate::diagnostic::Diagnostic;
use crate::diagram::{Access, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Ident, Item};

use super::attribute::{Head, head};
use super::builtin::function_names;
use super::report::not_yet;
use super::sequence::fold_names;

/// The names of a file's items.
#[derive(Debug, Default)]
pub(super) struct Declared {
    /// The ops in order, each with the place of its name; of two of one name the first
    /// has it.
    ops: Vec<(String, Span)>,
    op_numbers: HashMap<String, usize>,
    scripts: HashMap<String, Span>,
    functions: HashSet<String>,
    /// The attributes in order; `None` for one that could not be understood.
    attributes: Vec<Option<Head>>,
    attribute_numbers: HashMap<(Type, String), u32>,
    /// The names of those that could not be understood.
    lost_attributes: HashSet<String>,
    uses: bool,
}

impl Declared {
    /// Collects the names of `file`, and says which are taken and which items are not
    /// understood yet.
    pub(super) fn of(file: &tree::File, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let mut declared = Self::default();
        for item in &file.items {
            match item {
                Item::Op(op) => diagnostics.extend(declared.declare_op(&op.name)),
                Item::Script(script) => diagnostics.extend(declared.declare_script(&script.name)),
                Item::Fn(function) => {
                    declared.functions.insert(function.name.text.clone());
                    let what = "functions (`fn`) are not supported yet";
                    diagnostics.push(not_yet(what, function.name.span));
                }
                Item::Attr(attr) => declared.declare_attribute(attr, diagnostics),
                Item::Use(r#use) => {
                    declared.uses = true;
                    let what = "`use` of other files is not supported yet";
                    diagnostics.push(not_yet(what, r#use.span));
                }
                Item::Test(test) => {
                    let what = "`test` blocks are not supported yet";
                    let head = Span {
                        end: test.body.span.start.max(test.span.start),
                        ..test.span
                    };
                    diagnostics.push(not_yet(what, head));
                }
                Item::Broken(_) => {}
            }
        }
        declared
    }

    fn declare_op(&mut self, name: &Ident) -> Option<Diagnostic> {
        let number = self.ops.len();
        self.ops.push((name.text.clone(), name.span));
        if function_names().chain(fold_names()).any(|f| f == name.text) {
            let message = format!(
                "`{}` is a function of the language; an op needs another name",
                name.text
            );
            return Some(Diagnostic::error("duplicate-name", message, name.span));
        }
        if let Some(first) = self.op_numbers.get(&name.text) {
            let first = self.ops[*first].1;
            return Some(duplicate("an op", name, first));
        }
        self.op_numbers.insert(name.text.clone(), number);
        None
    }

    fn declare_attribute(&mut self, attr: &tree::Attr, diagnostics: &mut Vec<Diagnostic>) {
        let head = head(attr, diagnostics).and_then(|head| {
            let key = (head.element, attr.name.text.clone());
            let number = self.attributes.len() as u32;
            let Some(first) = self.attribute_numbers.get(&key) else {
                self.attribute_numbers.insert(key, number);
                return Some(head);
            };
            let first = self.attributes[*first as usize].as_ref();
            let what = format!("a {} attribute", head.element.word());
            diagnostics.extend(first.map(|first| duplicate(&what, &attr.name, first.span)));
            None
        });
        if head.is_none() {
            self.lost_attributes.insert(attr.name.text.clone());
        }
        self.attributes.push(head);
    }

    fn declare_script(&mut self, name: &Ident) -> Option<Diagnostic> {
        if let Some(first) = self.scripts.get(&name.text) {
            return Some(duplicate("a script", name, *first));
        }
        self.scripts.insert(name.text.clone(), name.span);
        None
    }

    /// The number of the op of this name.
    pub(super) fn op(&self, name: &str) -> Option<usize> {
        self.op_numbers.get(name).copied()
    }

    /// Whether the op whose name stands here has the name, and not an earlier one.
    pub(super) fn is_op_of_its_name(&self, name: &Ident) -> bool {
        self.op(&name.text)
            .is_some_and(|number| self.ops[number].1 == name.span)
    }

    /// Whether the script whose name stands here has the name, and not an earlier one.
    pub(super) fn is_script_of_its_name(&self, name: &Ident) -> bool {
        self.scripts.get(&name.text) == Some(&name.span)
    }

    /// The names of the ops, in order.
    pub(super) fn op_names(&self) -> impl Iterator<Item = &str> {
        self.ops.iter().map(|(name, _)| name.as_str())
    }

    /// Whether there is a script of this name.
    pub(super) fn is_script(&self, name: &str) -> bool {
        self.scripts.contains_key(name)
    }

    /// Whether the name is that of something to call.
    pub(super) fn is_called(&self, name: &str) -> bool {
        self.op(name).is_some()
            || self.functions.contains(name)
            || function_names().chain(fold_names()).any(|f| f == name)
    }

    /// Whether a function of this name may stand where it cannot be seen yet.
    pub(super) fn may_be_function(&self, name: &str) -> bool {
        self.uses || self.functions.contains(name)
    }

    /// Whether an op of this name may stand where it cannot be seen yet.
    pub(super) fn may_be_op(&self) -> bool {
        self.uses
    }

    /// Whether an attribute of this name has been refused, or may stand where it cannot be
    /// seen yet.
    pub(super) fn has_attribute(&self, name: &str) -> bool {
        self.uses || self.lost_attributes.contains(name)
    }

    /// The attribute of this name of elements of a type, and the type of its values.
    pub(super) fn attribute(&self, element: Type, name: &str) -> Option<(Access, Type)> {
        let number = *self.attribute_numbers.get(&(element, name.to_owned()))?;
        let head = self.attributes[number as usize].as_ref()?;
        Some((Access::Declared(number), head.ty))
    }

    /// The names of the attributes that elements of a type are declared to have.
    pub(super) fn attributes_of(&self, element: Type) -> impl Iterator<Item = &str> {
        let known = self.attributes.iter().flatten();
        let of_element = known.filter(move |head| head.element == element);
        of_element.map(|head| head.name.as_str())
    }

    /// The attributes in order.
    pub(super) fn attributes(&self) -> &[Option<Head>] {
        &self.attributes
    }
}

/// The error for a name that `what` (with its article) has taken.
pub(super) fn duplicate(what: &str, name: &Ident, first: Span) -> Diagnostic {
    let message = format!("there is already {what} `{}`", name.text);
    Diagnostic::error("duplicate-name", message, name.span).label(first, "the first is here")
}
