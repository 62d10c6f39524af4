//! A routine as Rust: a plain function over `hedgerow::mesh`.

use crate::diagram::Type;
use crate::emit::conventions::Conventions;
use crate::emit::item::{Item, ItemBody, Signature};
use crate::emit::names::invoked;
use crate::emit::print::support::{RUST, names};
use crate::emit::print::{Part, Printer};
use crate::emit::routine::Statement;
use crate::emit::steps::{Items, items};
use crate::emit::term::Parameter;
use crate::emit::{NotEmitted, Selection};

/// The modules that emitted code imports from, each with what it takes from it.
const IMPORTED: [(&str, &str); 3] = [
    ("std::collections", "HashMap"),
    ("glam", "DMat3 DMat4 DVec2 DVec3 DVec4"),
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
    let conventions = Conventions {
        prev: true,
        isolated_vertices: true,
        columns: true,
        undoes: true,
        exhaustive: selection.exhaustive,
        reserved: &[],
    };
    let Items { called, ops } = items(selection, conventions)?;
    let mut printer = Printer::new(None);
    let shown = ops.iter().map(|item| (item, Part::Selected));
    for (item, part) in shown.chain(called.iter().map(|(_, item)| (item, Part::Called))) {
        printer.lines.line("");
        printer.item(item, part);
    }
    let mut body = printer.lines.finish();
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

/// The name of a type.
pub(in crate::emit) fn ty(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "bool",
        Type::Int => "i64",
        Type::Real => "f64",
        Type::Vec3 => "DVec3",
        Type::Vec2 => "DVec2",
        Type::Vec4 => "DVec4",
        Type::Mat3 => "DMat3",
        Type::Mat4 => "DMat4",
        // Nothing of this type is built.
        Type::Text => "_",
        Type::Vertex => "VertexId",
        Type::Halfedge => "HalfedgeId",
        Type::Edge => "EdgeId",
        Type::Face => "FaceId",
    }
}

impl Printer<'_> {
    /// Parameters as they follow the mesh.
    pub fn listed<'p>(&self, params: impl IntoIterator<Item = &'p Parameter>) -> String {
        let params = params.into_iter();
        params.map(|param| format!(", {}: {}", param.name, self.ty(param.ty))).collect()
    }

    /// The first lines of an operation; the defaults, which Rust does not have, are in its doc
    /// comment.
    pub fn head_in_rust(&mut self, item: &Item, part: Part) {
        let Signature { name, docs, params, result, .. } = &item.signature;
        let none = [format!("The operation `{name}`.")];
        self.docs(if docs.is_empty() { &none } else { docs }, params.iter());
        // Alternatives are functions of their own.
        if !matches!(&item.body, ItemBody::Drawn(rules) if rules.len() > 1) {
            self.allow(item.statements(), params);
        }
        let visible = if part == Part::Called { "" } else { "pub " };
        let (params, result) = (self.listed(params), self.outcome(*result));
        self.lines.open(&format!("{visible}fn {name}(mesh: &mut Mesh{params}) -> {result} {{"));
    }

    /// The first line of a function with a body; it borrows the mesh mutably only if it changes it.
    pub fn function_in_rust(
        &self,
        signature: &Signature,
        [changes, refuses]: [bool; 2],
        body: &str,
    ) -> String {
        let mesh = if names(body, "mesh") { "mesh" } else { "_mesh" };
        let borrow = if changes { "&mut " } else { "&" };
        let result = match (signature.result.map(ty), refuses) {
            (Some(value), false) => format!(" -> {value}"),
            (Some(value), true) => format!(" -> Option<{value}>"),
            (None, true) => " -> Option<()>".to_string(),
            (None, false) => String::new(),
        };
        let (name, params) = (invoked(&signature.name), self.listed(&signature.params));
        format!("fn {name}({mesh}: {borrow}Mesh{params}){result} {{")
    }

    /// Allows the names of the drawing where Rust expects lowercase.
    pub fn allow<'i>(
        &mut self,
        body: impl IntoIterator<Item = &'i Statement>,
        params: &[Parameter],
    ) {
        let mut capital = false;
        let mut see = |name: &str| capital |= name.chars().any(char::is_uppercase);
        body.into_iter().for_each(|statement| statement.names(&mut see));
        params.iter().for_each(|param| see(&param.name));
        if capital && self.style.is_none() {
            self.lines.line("#[allow(non_snake_case)]");
        }
    }
}
