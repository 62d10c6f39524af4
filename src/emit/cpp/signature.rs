//! The signatures of operations as C++.

use std::collections::BTreeSet;

use super::super::item::{Item, ItemBody};
use super::super::language::Language;
use super::super::names::invoked;
use super::super::statement::Printing;
use super::super::term::Parameter;
use super::function::Printer;
use super::style::ELEMENTS;

impl Printer<'_> {
    /// The first lines of an operation: its signature, and aliases for the types that it uses.
    pub(super) fn head(&mut self, item: &Item, alone: bool) {
        let head = &item.signature;
        // Unused parameters have no name, since C++ compilers warn about them.
        let (mut used, mut seen) = (BTreeSet::new(), BTreeSet::new());
        for statement in item.statements() {
            statement.names(&mut |name| _ = used.insert(name.to_string()));
            statement.types(&mut |ty| _ = seen.insert(self.ty(ty)));
        }
        let (has_steps, has_inner) = match &item.body {
            ItemBody::Drawn(rules) => (false, rules.len() > 1),
            _ => (true, true),
        };
        let allocates = item.statements().into_iter().any(|it| it.changes_the_lists());
        // Writes are noted; an operation without writes is too rare to be a special case.
        if has_steps || self.is_noted || allocates {
            used.insert("mesh".to_string());
        }
        seen.extend(head.result.filter(|_| has_inner).map(|ty| self.ty(ty)));
        let first = self.first_default(&head.params);
        let told = head.params[..first].iter().filter(|it| !self.is_noted && !self.is_fixed(it));
        let told: Vec<_> = told.cloned().collect();
        self.docs(&head.docs, told.iter());
        self.open(item, alone, (&used, first));
        let member = self.style.is_member() && !self.is_noted;
        let is_alias = |name: &&str| {
            !member && seen.contains(self.style.name(name)) && self.style.is_nested(name)
        };
        let aliases: Vec<_> = ELEMENTS.into_iter().filter(is_alias).collect();
        for name in &aliases {
            let (short, long) = (self.style.name(name), self.style.qualified(name));
            self.lines.line(&format!("using {short} = {long};"));
        }
        if !aliases.is_empty() {
            self.lines.blank();
        }
        self.fixed(&head.params, used);
    }

    /// Opens an operation; the defaults of the parameters from `first` on are in its signature.
    fn open(&mut self, item: &Item, alone: bool, (used, first): (&BTreeSet<String>, usize)) {
        let head = &item.signature;
        let mesh = self.style.name("mesh").to_string();
        let other = self.style.name("function");
        let name = match self.style.function(&head.declared) {
            Some(name) if !self.is_noted => name,
            _ if alone && !other.is_empty() => other,
            _ => &head.name,
        };
        let member = self.style.is_member() && !self.is_noted;
        let named = |ty: &str, name: &str| match used.contains(name) {
            true => format!("{ty} {name}"),
            false => format!("{ty} /*{name}*/"),
        };
        self.is_outside = true;
        let result = self.outcome(head.result);
        self.is_outside = !member;
        let taken = head.params.iter().filter(|param| !self.is_fixed(param)).enumerate();
        let params = taken.map(|(at, param)| {
            let text = named(&self.ty(param.ty), &param.name);
            match param.default.as_ref().filter(|_| at >= first) {
                Some(default) => format!("{text} = {}", self.text(default)),
                None => text,
            }
        });
        let (name, given) = match (self.is_noted, member) {
            (true, _) => (invoked(name), Some("Journal& journal".into())),
            (false, true) => (format!("{mesh}::{name}"), None),
            (false, false) => (name.to_string(), Some(named(&format!("{mesh}&"), "mesh"))),
        };
        let params = given.into_iter().chain(params).collect::<Vec<_>>().join(", ");
        let inline = if self.style.is_inline() || self.is_noted { "inline " } else { "" };
        self.is_outside = false;
        self.lines.open(&format!("{inline}{result} {name}({params}) {{"));
    }

    /// The index of the first parameter whose default is in the signature: such parameters have to
    /// be last there, and the definition of a member of a class has none.
    fn first_default(&self, params: &[Parameter]) -> usize {
        let constant = params.iter().rev().take_while(|param| param.has_constant());
        match self.is_noted || self.style.is_member() || self.style.fixes_defaults() {
            true => params.len(),
            false => params.len() - constant.count(),
        }
    }

    /// True if a parameter always has its default value.
    fn is_fixed(&self, param: &Parameter) -> bool {
        self.style.fixes_defaults() && !self.is_noted && param.default.is_some()
    }

    /// Defines the parameters that always have their default value, as far as they are used.
    fn fixed(&mut self, params: &[Parameter], mut used: BTreeSet<String>) {
        // A default may use an earlier parameter.
        let mut lines = Vec::new();
        for param in params.iter().rev().filter(|param| self.is_fixed(param)) {
            if used.contains(&param.name)
                && let Some(default) = &param.default
            {
                default.names(&mut |name| _ = used.insert(name.to_string()));
                let (ty, value) = (self.ty(param.ty), self.text(default));
                lines.push(format!("const {ty} {} = {value};", param.name));
            }
        }
        lines.iter().rev().for_each(|line| self.lines.line(line));
    }
}
