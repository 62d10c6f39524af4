//! Variables: numbered once, visible in their block.

use std::collections::HashMap;

use crate::diagram::Type;
use crate::source::Span;
use crate::syntax::tree::Ident;

use super::program::Variable;

/// A variable, visible or not.
#[derive(Clone, Debug)]
pub(super) struct Local {
    pub(super) name: String,
    /// The place of its declaration.
    pub(super) span: Span,
    /// Its type; `None` if its declaration could not be resolved.
    pub(super) ty: Option<Type>,
    /// The kind of its binding.
    pub(super) binding: Binding,
}

/// The kind of binding of a variable, which decides whether `=` may set it again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Binding {
    /// `var`: it may be set.
    Var {
        /// Whether a type stands behind its name.
        typed: bool,
    },
    /// `let`, with the span of the keyword.
    Let(Span),
    Parameter,
    /// The variable of a loop, an aggregate or an `if let`.
    Head,
}

/// All variables of an item, and which of them are visible.
#[derive(Debug, Default)]
pub(super) struct Scopes {
    locals: Vec<Local>,
    /// The visible variables of each name, innermost last.
    visible: HashMap<String, Vec<u32>>,
    /// The variables that each open block has declared.
    open: Vec<Vec<u32>>,
}

impl Scopes {
    /// Opens a block.
    pub(super) fn enter(&mut self) {
        self.open.push(Vec::new());
    }

    /// Closes the innermost block and forgets what it declared.
    pub(super) fn leave(&mut self) {
        for number in self.open.pop().unwrap_or_default() {
            let name = &self.locals[number as usize].name;
            if let Some(numbers) = self.visible.get_mut(name) {
                numbers.pop();
            }
        }
    }

    /// True in the block of an item itself: in no loop and no branch.
    pub(super) fn is_outermost(&self) -> bool {
        self.open.len() <= 2
    }

    /// Declares a variable in the innermost block and returns its number.
    pub(super) fn declare(&mut self, local: Local) -> u32 {
        let number = self.locals.len() as u32;
        self.visible.entry(local.name.clone()).or_default().push(number);
        if let Some(block) = self.open.last_mut() {
            block.push(number);
        }
        self.locals.push(local);
        number
    }

    /// Declares the variable of a loop, an aggregate or an `if let`.
    pub(super) fn declare_in_head(&mut self, name: &Ident, ty: Option<Type>) -> u32 {
        let (name, span) = (name.text.clone(), name.span);
        self.declare(Local { name, span, ty, binding: Binding::Head })
    }

    /// The visible variable of this name.
    pub(super) fn find(&self, name: &str) -> Option<(u32, &Local)> {
        let number = *self.visible.get(name)?.last()?;
        Some((number, &self.locals[number as usize]))
    }

    /// The variable of this name that the innermost block itself has declared.
    pub(super) fn find_here(&self, name: &str) -> Option<&Local> {
        let (number, local) = self.find(name)?;
        self.open.last().is_some_and(|block| block.contains(&number)).then_some(local)
    }

    /// The visible names, in order of declaration.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        (0..).zip(&self.locals).filter_map(|(number, local)| {
            let numbers = self.visible.get(&local.name)?;
            (numbers.last() == Some(&number)).then_some(local.name.as_str())
        })
    }

    /// The types of all variables, by the spans of their names, as far as they are known.
    pub(super) fn types(&self) -> impl Iterator<Item = (Span, Type)> {
        self.locals.iter().filter_map(|local| Some((local.span, local.ty?)))
    }

    /// All variables by number; `None` if the type of one is unknown.
    pub(super) fn into_variables(self) -> Option<Vec<Variable>> {
        let variable =
            |local: Local| Some(Variable { name: local.name, ty: local.ty?, span: local.span });
        self.locals.into_iter().map(variable).collect()
    }
}
