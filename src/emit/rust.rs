//! A routine as Rust: a plain function over `hedgerow::mesh`.

use std::collections::BTreeSet;

use crate::emit::item::{Item, ItemBody, Parameter, Signature};
use crate::emit::items::{Items, items};
use crate::emit::language::Language;
use crate::emit::print::support::{RUST, names};
use crate::emit::print::{self, Part, Printer};
use crate::emit::{NotEmitted, Selection};

/// The modules that emitted code imports from, each with what it takes from it.
const IMPORTED: [(&str, &str); 3] = [
    ("std::collections", "HashMap"),
    ("hedgerow::mesh::glam", "DMat3 DMat4 DVec2 DVec3 DVec4"),
    (
        "hedgerow::mesh",
        "Attribute ColumnId EdgeId ElementKind FaceId HalfedgeId Level Mesh VertexId \
         validate_level_near",
    ),
];

/// Operations as Rust. A refused operation returns `None`; one without a result returns whether it
/// applied.
///
/// # Errors
/// [`NotEmitted`] for what cannot be expressed in such a function.
pub fn rust(selection: &Selection<'_>) -> Result<String, NotEmitted> {
    let language = Language::default();
    let Items { called, ops } = items(selection, language)?;
    let shown = ops.iter().map(|item| (item, Part::Selected));
    let shown = shown.chain(called.iter().map(|item| (item, Part::Called)));
    let shown = shown.map(|(item, part)| format!("\n{}", print::item(language, item, part)));
    let mut body: String = shown.collect();
    for (_, text) in RUST.needed(&body, "") {
        body.push('\n');
        body.push_str(text);
    }
    let imported = IMPORTED.map(|(module, words)| {
        let used = words.split_whitespace().filter(|word| names(&body, word));
        match used.collect::<Vec<_>>().as_slice() {
            [] => String::new(),
            [only] => format!("use {module}::{only};\n"),
            all => format!("use {module}::{{{}}};\n", all.join(", ")),
        }
    });
    Ok(imported.concat() + &body)
}

impl Printer<'_> {
    /// Parameters as they follow the mesh.
    pub fn listed<'p>(&self, params: impl IntoIterator<Item = &'p Parameter>) -> String {
        let params = params.into_iter();
        params.map(|param| format!(", {}: {}", param.name, self.language.ty(param.ty))).collect()
    }

    /// The first lines of an item with a body; the defaults, which Rust does not have, are in the
    /// doc comment of an operation. A function borrows the mesh mutably only if it changes it.
    pub fn head_in_rust(&mut self, item: &Item, body: &str) {
        let Signature { name, docs, params, result, changes, refuses, .. } = &item.signature;
        let is_function = matches!(item.body, ItemBody::Function(_));
        let none = [format!("The operation `{name}`.")];
        match is_function {
            true => self.docs(docs, [].iter()),
            false => self.docs(if docs.is_empty() { &none } else { docs }, params.iter()),
        }
        // Alternatives are functions of their own.
        if !matches!(&item.body, ItemBody::Drawn(rules) if rules.len() > 1) {
            self.allow(item.names(), params);
        }
        if params.iter().any(|param| !names(body, &param.name)) {
            self.lines.line("#[allow(unused_variables)]");
        }
        let list = self.listed(params);
        if !is_function {
            let visible = if self.part == Part::Called { "" } else { "pub " };
            let result = self.language.outcome(*result);
            let head = format!("{visible}fn {name}(mesh: &mut Mesh{list}) -> {result} {{");
            return self.lines.open(&head);
        }
        let mesh = if names(body, "mesh") { "mesh" } else { "_mesh" };
        let borrow = if *changes { "&mut " } else { "&" };
        let result = match (result.map(|ty| self.language.ty(ty)), refuses) {
            (Some(value), false) => format!(" -> {value}"),
            (Some(value), true) => format!(" -> Option<{value}>"),
            (None, true) => " -> Option<()>".to_string(),
            (None, false) => String::new(),
        };
        self.lines.open(&format!("fn {name}({mesh}: {borrow}Mesh{list}){result} {{"));
    }

    /// Allows the names of the drawing where Rust expects lowercase.
    pub fn allow(&mut self, names: BTreeSet<String>, params: &[Parameter]) {
        let params = params.iter().map(|param| param.name.clone());
        let is_capital = |name: String| name.chars().any(char::is_uppercase);
        if self.language.is_rust() && names.into_iter().chain(params).any(is_capital) {
            self.lines.line("#[allow(non_snake_case)]");
        }
    }
}
