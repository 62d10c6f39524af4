//! The signatures of operations as C++.

use std::collections::BTreeSet;

use super::style::{ELEMENTS, Style};
use crate::emit::item::{Item, ItemBody, Parameter, Signature};
use crate::emit::language::Language;
use crate::emit::print::support::{code, names};
use crate::emit::print::{Part, Printer};

impl Printer<'_> {
    /// True for a function of a namespace beside the mesh class, which others call.
    fn is_beside(&self) -> bool {
        self.part == Part::Called
    }

    /// The first lines of an item with a body: its signature, and aliases for the types that it
    /// uses.
    pub fn head_in_cpp(&mut self, style: &Style, item: &Item, body: &str) {
        let Signature { docs, params, .. } = &item.signature;
        // Unused parameters have no name, since C++ compilers warn about them.
        let mut used = item.names();
        used.insert(self.applied.clone());
        let fixed = self.fixed(style, params, &mut used);
        let body = code(&format!("{fixed}{body}"));
        let given = params.iter().map(|param| param.name.as_str()).chain(["mesh"]);
        used.extend(given.filter(|name| names(&body, name)).map(str::to_string));
        let first = self.first_default(style, params);
        let is_told = |it: &&Parameter| !self.is_beside() && !self.is_fixed(style, it);
        let told: Vec<_> = params[..first].iter().filter(is_told).collect();
        self.docs(docs, told.into_iter());
        self.open(style, item, (&used, first));
        let has_names = self.language.is_outside || style.is_member() && !self.is_beside();
        let is_alias =
            |name: &&str| !has_names && names(&body, style.name(name)) && style.is_nested(name);
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

    /// Opens an item; the defaults of the parameters from `first` on are in its signature.
    fn open(&mut self, style: &Style, item: &Item, (used, first): (&BTreeSet<String>, usize)) {
        let (head, mesh) = (&item.signature, style.name("mesh"));
        let is_function = matches!(item.body, ItemBody::Function(_));
        let name = style.name_of(head, self.part);
        let named = |ty: &str, name: &str| match used.contains(name) {
            true => format!("{ty} {name}"),
            false => format!("{ty} /*{name}*/"),
        };
        let outside = Language { is_outside: true, ..self.language };
        let result = match head.result {
            result if !is_function => outside.outcome(result),
            Some(ty) => outside.ty(ty),
            None => "void".into(),
        };
        let is_member = style.is_member() && !self.is_beside();
        let inside = if is_member { self.language } else { outside };
        let taken = head.params.iter().enumerate();
        let params = taken.filter(|(_, param)| !self.is_fixed(style, param)).map(|(at, param)| {
            let text = named(&inside.ty(param.ty), &param.name);
            match param.default.as_ref().filter(|_| at >= first) {
                Some(default) => format!("{text} = {}", default.text),
                None => text,
            }
        });
        let (name, given) = match (self.is_beside(), is_member) {
            (true, _) => (name.to_string(), self.is_noted.then(|| "Journal& journal".into())),
            (false, true) => (format!("{mesh}::{name}"), None),
            (false, false) => (name.to_string(), Some(named(&format!("{mesh}&"), "mesh"))),
        };
        let params = given.into_iter().chain(params).collect::<Vec<_>>().join(", ");
        let inline = if style.is("inline", "yes") || self.is_beside() { "inline " } else { "" };
        self.lines.open(&format!("{inline}{result} {name}({params}) {{"));
    }

    /// The index of the first parameter whose default is in the signature: such parameters have to
    /// be last there, and the definition of a member of a class has none.
    fn first_default(&self, style: &Style, params: &[Parameter]) -> usize {
        let constant = params.iter().rev().take_while(|param| param.has_constant());
        match self.is_beside() || style.is_member() || style.is("defaults", "fixed") {
            true => params.len(),
            false => params.len() - constant.count(),
        }
    }

    /// True if a parameter always has its default value.
    fn is_fixed(&self, style: &Style, param: &Parameter) -> bool {
        style.is("defaults", "fixed") && !self.is_beside() && param.default.is_some()
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
                used.extend(default.names.iter().cloned());
                let ty = self.language.ty(param.ty);
                lines.push(format!("const {ty} {} = {};\n", param.name, default.text));
            }
        }
        lines.into_iter().rev().collect()
    }
}
