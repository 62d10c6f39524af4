//! The signatures of operations as C++.

use std::collections::BTreeSet;

use super::style::{ELEMENTS, Style};
use crate::emit::item::{Item, Signature};
use crate::emit::names::invoked;
use crate::emit::print::support::{code, names};
use crate::emit::print::{Part, Printer};
use crate::emit::term::Parameter;

impl Printer<'_> {
    /// The first lines of an operation with a body: its signature, and aliases for the types that it
    /// uses.
    pub fn head_in_cpp(&mut self, style: &Style, item: &Item, part: Part, body: &str) {
        let Signature { docs, params, .. } = &item.signature;
        // Unused parameters have no name, since C++ compilers warn about them.
        let mut used = BTreeSet::from([self.applied.clone()]);
        for statement in item.statements() {
            statement.names(&mut |name| _ = used.insert(name.to_string()));
        }
        let fixed = self.fixed(style, params, &mut used);
        let body = code(&format!("{fixed}{body}"));
        if names(&body, "mesh") {
            used.insert("mesh".to_string());
        }
        let first = self.first_default(style, params);
        let told = params[..first].iter();
        let told = told.filter(|it| !self.is_noted && !self.is_fixed(style, it));
        let told: Vec<_> = told.cloned().collect();
        self.docs(docs, told.iter());
        self.open(style, &item.signature, part, (&used, first));
        let member = style.is_member() && !self.is_noted;
        let is_alias =
            |name: &&str| !member && names(&body, style.name(name)) && style.is_nested(name);
        let aliases: Vec<_> = ELEMENTS.into_iter().filter(is_alias).collect();
        for name in &aliases {
            let (short, long) = (style.name(name), style.qualified(name));
            self.lines.line(&format!("using {short} = {long};"));
        }
        if !aliases.is_empty() {
            self.lines.blank();
        }
        self.lines.add(&fixed);
    }

    /// Opens an operation; the defaults of the parameters from `first` on are in its signature.
    fn open(
        &mut self,
        style: &Style,
        head: &Signature,
        part: Part,
        (used, first): (&BTreeSet<String>, usize),
    ) {
        let (mesh, other) = (style.name("mesh"), style.name("function"));
        let name = match style.function(&head.declared) {
            Some(name) if !self.is_noted => name,
            _ if part == Part::Alone && !other.is_empty() => other,
            _ => &head.name,
        };
        let member = style.is_member() && !self.is_noted;
        let named = |ty: &str, name: &str| match used.contains(name) {
            true => format!("{ty} {name}"),
            false => format!("{ty} /*{name}*/"),
        };
        self.is_outside = true;
        let result = self.outcome(head.result);
        self.is_outside = !member;
        let taken = head.params.iter().enumerate();
        let taken = taken.filter(|(_, param)| !self.is_fixed(style, param));
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
        let inline = if style.is_inline() || self.is_noted { "inline " } else { "" };
        self.is_outside = false;
        self.lines.open(&format!("{inline}{result} {name}({params}) {{"));
    }

    /// The first line of a function.
    pub fn function_in_cpp(&self, signature: &Signature) -> String {
        let params = signature.params.iter();
        let params = params.map(|param| format!("{} {}", self.ty(param.ty), param.name));
        let journal = self.is_noted.then(|| "Journal& journal".to_string());
        let params = journal.into_iter().chain(params).collect::<Vec<_>>().join(", ");
        let result = signature.result.map_or("void".into(), |ty| self.ty(ty));
        format!("inline {result} {}({params}) {{", invoked(&signature.name))
    }

    /// The index of the first parameter whose default is in the signature: such parameters have to
    /// be last there, and the definition of a member of a class has none.
    fn first_default(&self, style: &Style, params: &[Parameter]) -> usize {
        let constant = params.iter().rev().take_while(|param| param.has_constant());
        match self.is_noted || style.is_member() || style.fixes_defaults() {
            true => params.len(),
            false => params.len() - constant.count(),
        }
    }

    /// True if a parameter always has its default value.
    fn is_fixed(&self, style: &Style, param: &Parameter) -> bool {
        style.fixes_defaults() && !self.is_noted && param.default.is_some()
    }

    /// The lines that define the parameters that always have their default value, as far as they
    /// are used.
    fn fixed(&self, style: &Style, params: &[Parameter], used: &mut BTreeSet<String>) -> String {
        // A default may use an earlier parameter.
        let mut lines = Vec::new();
        for param in params.iter().rev().filter(|param| self.is_fixed(style, param)) {
            if used.contains(&param.name)
                && let Some(default) = &param.default
            {
                default.names(&mut |name| _ = used.insert(name.to_string()));
                let (ty, value) = (self.ty(param.ty), self.text(default));
                lines.push(format!("const {ty} {} = {value};\n", param.name));
            }
        }
        lines.into_iter().rev().collect()
    }
}
