//! A routine as Rust: a plain function over `hedgerow::mesh`.

use std::collections::BTreeSet;

use super::super::conventions::Conventions;
use super::super::item::{Alternative, Item, ItemBody, Signature};
use super::super::language::Language;
use super::super::lines::Lines;
use super::super::names::invoked;
use super::super::routine::Statement;
use super::super::statement::{Printing, rule_names};
use super::super::steps::{Items, items};
use super::super::support::{RUST, names};
use super::super::term::{Parameter, Term};
use super::super::{NotEmitted, Selection};
use super::steps::bare;
use crate::diagram::Type;

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
    let mut printer = Printer {
        lines: Lines::new(4),
        refusal: "",
        applied: "",
        wraps: true,
        is_asked: false,
        mesh: "mesh".into(),
    };
    let shown = ops.iter().map(|item| (item, "pub fn"));
    for (item, visible) in shown.chain(called.iter().map(|(_, item)| (item, "fn"))) {
        printer.lines.line("");
        printer.item(item, visible);
    }
    let mut body = printer.lines.finish();
    for (_, text) in RUST.needed(&body, "") {
        body.push('\n');
        body.push_str(text);
    }
    let all = [
        "Attribute",
        "ColumnId",
        "EdgeId",
        "ElementKind",
        "FaceId",
        "HalfedgeId",
        "Level",
        "Mesh",
        "VertexId",
        "validate_level_near",
    ];
    let used: Vec<_> = all.into_iter().filter(|word| names(&body, word)).collect();
    let vectors = ["DMat3", "DMat4", "DVec2", "DVec3", "DVec4"];
    let vectors: Vec<_> = vectors.into_iter().filter(|of| names(&body, of)).collect();
    let vectors = match vectors.as_slice() {
        [] => String::new(),
        [only] => format!("use glam::{only};\n"),
        all => format!("use glam::{{{}}};\n", all.join(", ")),
    };
    let maps = match names(&body, "HashMap") {
        true => "use std::collections::HashMap;\n",
        false => "",
    };
    Ok(format!("{maps}{vectors}use hedgerow::mesh::{{{}}};\n{body}", used.join(", ")))
}

pub(super) struct Printer {
    pub lines: Lines,
    /// The statement that leaves the current attempt.
    pub refusal: &'static str,
    /// The value of a `return` without one.
    pub applied: &'static str,
    /// True if values are returned in `Some`, since the function may refuse.
    pub wraps: bool,
    /// True if the caller has checked that the attributes exist.
    pub is_asked: bool,
    /// The mesh, or the preview of it on which pointers are noted instead.
    pub mesh: String,
}

/// The name of a type.
pub(super) fn ty(ty: Type) -> &'static str {
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

/// Parameters as they follow the mesh.
fn listed<'p>(params: impl IntoIterator<Item = &'p Parameter>) -> String {
    let params = params.into_iter();
    params.map(|param| format!(", {}: {}", param.name, ty(param.ty))).collect()
}

impl Printer {
    fn item(&mut self, item: &Item, visible: &str) {
        let signature = &item.signature;
        if let ItemBody::Function { changes, refuses, body } = &item.body {
            return self.function(signature, [*changes, *refuses], body);
        }
        self.docs(signature);
        let result = signature.result.map(ty);
        let result = result.map_or("bool".into(), |result| format!("Option<{result}>"));
        let (name, params) = (&signature.name, listed(&signature.params));
        let head = format!("{visible} {name}(mesh: &mut Mesh{params}) -> {result} {{");
        (self.refusal, self.applied) = match signature.result {
            Some(_) => ("return None;", "true"),
            None => ("return false;", "true"),
        };
        match &item.body {
            ItemBody::Steps { requires, level, steps } => {
                self.allow(steps, &signature.params);
                self.lines.open(&head);
                self.block(requires);
                self.lines.open(&format!("all_or_nothing(mesh, Level::{level:?}, |mesh| {{"));
                (self.refusal, self.applied) = ("return None;", "Some(())");
                self.body(steps);
                self.lines.close(match signature.result {
                    Some(_) => "})",
                    None => "}).is_some()",
                });
            }
            ItemBody::Drawn(rules) => match rules.as_slice() {
                [rule] => {
                    self.allow(&rule.body, &signature.params);
                    self.lines.open(&head);
                    self.alternative(&rule.body);
                }
                rules => {
                    self.lines.open(&head);
                    self.rules(signature, rules, &result);
                }
            },
            ItemBody::Function { .. } => {}
        }
        self.lines.close("}");
    }

    fn rules(&mut self, signature: &Signature, rules: &[Alternative], result: &str) {
        let mut calls = Vec::new();
        for (rule, name) in rules.iter().zip(rule_names(rules, &signature.params)) {
            let mut used = BTreeSet::new();
            for statement in &rule.body {
                statement.names(&mut |name| _ = used.insert(name.to_string()));
            }
            let taken = signature.params.iter().filter(|param| used.contains(&param.name));
            let args: String = taken.clone().map(|param| format!(", {}", param.name)).collect();
            calls.push(format!("{name}(mesh{args})"));
            self.allow(&rule.body, &signature.params);
            let params = listed(taken);
            self.lines.open(&format!("fn {name}(mesh: &mut Mesh{params}) -> {result} {{"));
            self.alternative(&rule.body);
            self.lines.close("}");
            self.lines.line("");
        }
        self.lines.line(&match signature.result {
            None => calls.join(" || "),
            Some(_) => {
                let mut calls = calls.into_iter();
                let first = calls.next().unwrap_or_default();
                calls.fold(first, |chain, call| format!("{chain}.or_else(|| {call})"))
            }
        });
    }

    /// A function of the program; it borrows the mesh mutably only if it changes it.
    fn function(
        &mut self,
        signature: &Signature,
        [changes, refuses]: [bool; 2],
        body: &[Statement],
    ) {
        let outer = std::mem::replace(&mut self.lines, Lines::new(4));
        (self.refusal, self.wraps) = ("return None;", refuses);
        self.applied = if refuses { "Some(())" } else { "" };
        self.is_asked = true;
        self.body(body);
        (self.wraps, self.is_asked) = (true, false);
        let text = std::mem::replace(&mut self.lines, outer).finish();
        Printing::docs(self, &signature.docs, [].iter());
        let mesh = if names(&text, "mesh") { "mesh" } else { "_mesh" };
        let borrow = if changes { "&mut " } else { "&" };
        let result = match (signature.result.map(ty), refuses) {
            (Some(value), false) => format!(" -> {value}"),
            (Some(value), true) => format!(" -> Option<{value}>"),
            (None, true) => " -> Option<()>".to_string(),
            (None, false) => String::new(),
        };
        self.allow(body, &signature.params);
        let (name, params) = (invoked(&signature.name), listed(&signature.params));
        self.lines.open(&format!("fn {name}({mesh}: {borrow}Mesh{params}){result} {{"));
        text.lines().for_each(|line| self.lines.line(line));
        self.lines.close("}");
    }

    /// Writes a doc comment with the defaults, which Rust does not have.
    fn docs(&mut self, signature: &Signature) {
        let none = [format!("The operation `{}`.", signature.name)];
        let docs = if signature.docs.is_empty() { &none[..] } else { &signature.docs };
        Printing::docs(self, docs, signature.params.iter());
    }

    /// Allows the names of the drawing where Rust expects lowercase.
    fn allow(&mut self, body: &[Statement], params: &[Parameter]) {
        let mut capital = false;
        let mut see = |name: &str| capital |= name.chars().any(char::is_uppercase);
        body.iter().for_each(|statement| statement.names(&mut see));
        params.iter().for_each(|param| see(&param.name));
        if capital {
            self.lines.line("#[allow(non_snake_case)]");
        }
    }

    fn alternative(&mut self, body: &[Statement]) {
        self.lines.line("// 1. Collect: nothing is written before all of this has passed.");
        let refused = self.refusal.trim_start_matches("return ").trim_end_matches(';');
        self.body(body);
        if !matches!(body.last(), Some(Statement::Return { .. })) {
            self.lines.line(refused);
        }
    }

    /// Writes the statements of a function, whose last value is returned without `return`.
    fn body(&mut self, body: &[Statement]) {
        let Some((Statement::Return { value }, others)) = body.split_last() else {
            return self.block(body);
        };
        self.block(others);
        let value = self.returned(value.as_ref());
        if !value.is_empty() {
            self.lines.line(bare(&value));
        }
    }

    /// The value that is returned; empty for none.
    pub fn returned(&self, value: Option<&Term>) -> String {
        match value {
            Some(value) if self.wraps => format!("Some({})", self.text(value)),
            Some(value) => self.text(value),
            None => self.applied.to_string(),
        }
    }
}
