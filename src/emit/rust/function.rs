//! A routine as Rust: a plain function over `hedgerow::mesh`.

use std::collections::BTreeSet;

use super::super::conventions::Conventions;
use super::super::language::spell;
use super::super::lines::{Lines, comment};
use super::super::routine::{Routine, Statement};
use super::super::steps::{Item, Items, items};
use super::super::support::{RUST, names};
use super::super::term::{Parameter, Term};
use super::super::{NotEmitted, Selection};
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
        kept: &[],
    };
    let Items { called, ops } = items(selection, conventions)?;
    let mut printer = Printer {
        lines: Lines::new(4),
        refusal: "",
        applied: "true",
        gives_option: false,
        is_asked: false,
        preview: None,
    };
    let shown = ops.iter().map(|op| (op, true));
    for (item, is_selected) in shown.chain(called.iter().map(|(_, item)| (item, false))) {
        printer.lines.line("");
        let visible = if is_selected { "pub fn" } else { "fn" };
        match item {
            Item::Function(helper) => printer.helper(helper),
            Item::Drawn(routine) => printer.routine(routine, visible),
            Item::Steps(whole) => printer.whole(whole, visible),
        }
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
    /// The value that an operation without a result returns when it has applied.
    pub applied: &'static str,
    /// True if a function returns an `Option`, since it may refuse.
    pub gives_option: bool,
    /// True if the caller has checked that the attributes exist.
    pub is_asked: bool,
    /// The preview on which pointers are noted instead.
    pub preview: Option<String>,
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

/// The name of the kind of elements of a type.
pub(super) fn kind(ty: Type) -> &'static str {
    match ty {
        Type::Vertex => "Vertex",
        Type::Halfedge => "Halfedge",
        Type::Edge => "Edge",
        _ => "Face",
    }
}

impl Printer {
    /// Writes a doc comment with the defaults, which Rust does not have.
    pub fn docs(&mut self, docs: &[String], name: &str, params: &[Parameter]) {
        for line in docs {
            self.lines.line(&comment("///", line));
        }
        if docs.is_empty() {
            self.lines.line(&format!("/// The operation `{name}`."));
        }
        let told: Vec<_> = params
            .iter()
            .filter_map(|param| {
                let default = self.text(param.default.as_ref()?);
                Some(format!("`{} = {default}`", param.name))
            })
            .collect();
        if !told.is_empty() {
            let told = told.join(", ");
            self.lines.line(&format!("/// By default {told}."));
        }
    }

    fn routine(&mut self, routine: &Routine, visible: &str) {
        self.docs(&routine.signature.docs, &routine.signature.name, &routine.signature.params);
        let result = match routine.signature.result {
            Some(result) => format!("Option<{}>", ty(result)),
            None => "bool".to_string(),
        };
        let params = |used: &BTreeSet<String>| {
            let params = routine.signature.params.iter().filter(|param| used.contains(&param.name));
            let params = params.map(|param| format!(", {}: {}", param.name, ty(param.ty)));
            params.collect::<String>()
        };
        let all: BTreeSet<_> =
            routine.signature.params.iter().map(|param| param.name.clone()).collect();
        let head = format!(
            "{visible} {}(mesh: &mut Mesh{}) -> {result} {{",
            routine.signature.name,
            params(&all)
        );
        if let [rule] = routine.rules.as_slice() {
            self.allow(&rule.body, &routine.signature.params);
            self.lines.open(&head);
            self.alternative(&rule.body, routine);
            self.lines.close("}");
            return;
        }
        let mut calls = Vec::new();
        let mut bodies = Vec::new();
        for (at, rule) in routine.rules.iter().enumerate() {
            let label = rule.label.clone().unwrap_or_else(|| format!("{}", at + 1));
            let mut name = format!("rule_{}", label.replace('\'', "_"));
            while all.contains(&name) {
                name.push('_');
            }
            let mut used = BTreeSet::new();
            rule.body.iter().for_each(|statement| {
                statement.names(&mut |name| {
                    used.insert(name.to_string());
                });
            });
            let args = routine.signature.params.iter().filter(|param| used.contains(&param.name));
            let args: String = args.map(|param| format!(", {}", param.name)).collect();
            calls.push(format!("{name}(mesh{args})"));
            bodies.push((name, params(&used), rule));
        }
        self.lines.open(&head);
        for (name, params, rule) in bodies {
            self.allow(&rule.body, &routine.signature.params);
            self.lines.open(&format!("fn {name}(mesh: &mut Mesh{params}) -> {result} {{"));
            self.alternative(&rule.body, routine);
            self.lines.close("}");
            self.lines.line("");
        }
        let chain = match routine.signature.result {
            Some(_) => {
                let mut calls = calls.into_iter();
                let first = calls.next().unwrap_or_default();
                let others = calls.map(|call| format!(".or_else(|| {call})"));
                format!("{first}{}", others.collect::<String>())
            }
            None => calls.join(" || "),
        };
        self.lines.line(&chain);
        self.lines.close("}");
    }

    /// Allows the names of the drawing where Rust expects lowercase.
    pub fn allow(&mut self, body: &[Statement], params: &[Parameter]) {
        let mut capital = false;
        let mut see = |name: &str| capital |= name.chars().any(char::is_uppercase);
        body.iter().for_each(|statement| statement.names(&mut see));
        params.iter().for_each(|param| see(&param.name));
        if capital {
            self.lines.line("#[allow(non_snake_case)]");
        }
    }

    fn alternative(&mut self, body: &[Statement], routine: &Routine) {
        let (refused, last) = match routine.signature.result {
            Some(_) => ("return None;", "None"),
            None => ("return false;", "false"),
        };
        self.refusal = refused;
        self.lines.line("// 1. Collect: nothing is written before all of this has passed.");
        let (result, rest) = match body.split_last() {
            Some((Statement::Return { result }, rest)) => (Some(result), rest),
            _ => (None, body),
        };
        self.block(rest);
        match result {
            Some(Some(result)) => {
                let result = self.text(result);
                self.lines.line(&format!("Some({result})"));
            }
            Some(None) => self.lines.line("true"),
            None => self.lines.line(last),
        }
    }

    pub fn text(&mut self, term: &Term) -> String {
        spell(self, term).text
    }
}
