//! A routine as C++: the classic function over a pointer-based halfedge mesh.

use std::collections::BTreeSet;

use super::super::lines::Lines;
use super::super::names::unreserved;
use super::super::routine::{Helper, Routine, Statement};
use super::super::spell::{Level, Spelled, spell};
use super::super::steps::{Item, Items, items};
use super::super::term::Term;
use super::super::{NotEmitted, Selection, build};
use super::style::Style;
use super::support;
use super::types::types;
use crate::diagram::Type;

/// Operations as C++17, with the functions that they call. What an operation refuses is
/// `std::nullopt`; one without a result tells whether it applied.
///
/// # Errors
/// [`NotEmitted`] for what has no place in such a function.
pub fn cpp(selection: &Selection<'_>, style: &Style) -> Result<String, NotEmitted> {
    let conventions = build::Conventions {
        prev: style.has_prev(),
        isolated_vertices: false,
        columns: false,
        undoes: false,
    };
    let Items { called, ops } = items(selection, conventions)?;
    let mut helpers = Vec::new();
    let mut routines = Vec::new();
    for item in called.iter().chain(&ops) {
        match item {
            Item::Function(helper) => helpers.push(helper),
            Item::Drawn(routine) => routines.push(routine),
            Item::Steps(_) => {
                let span = selection.program.ops[selection.ops[0]].span;
                return Err(NotEmitted::new("an operation in steps", span));
            }
        }
    }
    let mut printer = Printer {
        style,
        lines: Lines::new(2),
        used: Vec::new(),
        headers: BTreeSet::from(["optional"]),
        refusal: "",
        is_outside: false,
        sheet: None,
    };
    let helpers: Vec<_> = helpers
        .iter()
        .map(|helper| printer.helper(helper))
        .collect();
    for (at, routine) in routines.iter().enumerate() {
        if at > 0 {
            printer.lines.line("");
        }
        printer.routine(routine, routines.len() == 1);
    }
    Ok(printer.finish(&helpers))
}

pub(super) struct Printer<'s> {
    pub style: &'s Style,
    pub lines: Lines,
    pub used: Vec<&'static str>,
    pub headers: BTreeSet<&'static str>,
    /// What leaves the attempt.
    pub refusal: &'static str,
    /// Whether the names of the mesh class are not in sight.
    pub is_outside: bool,
    /// The sheet that pointers are noted on instead.
    pub sheet: Option<String>,
}

impl Printer<'_> {
    fn finish(self, helpers: &[String]) -> String {
        let needed = support::needed(&self.used);
        let mut headers = self.headers;
        let mut functions = String::new();
        for name in needed {
            let chain = |of: &str, pointer: &str| self.style.chained(of, pointer);
            let text = support::spelled(name, &chain, &|ty| self.style.qualified(ty));
            // So that functions of several files can stand in one.
            let guard = format!("HEDGEROW_{}", name.to_uppercase().replace('.', "_"));
            functions.push_str(&format!(
                "\n#ifndef {guard}\n#define {guard}\n{text}\n#endif\n"
            ));
        }
        for helper in helpers {
            functions.push_str(&format!("\n{helper}"));
        }
        let body = self.lines.finish();
        for (word, header) in [
            ("std::vector", "vector"),
            ("std::find", "algorithm"),
            ("std::m", "algorithm"),
            ("std::reverse", "algorithm"),
            ("std::rotate", "algorithm"),
            ("std::pair", "utility"),
            ("std::count_if", "algorithm"),
            ("std::is_permutation", "algorithm"),
            ("std::sqrt", "cmath"),
            ("std::atan2", "cmath"),
            ("std::isfinite", "cmath"),
            ("std::fabs", "cmath"),
            ("std::array", "array"),
            ("std::decay_t", "type_traits"),
            ("std::numeric_limits", "limits"),
            ("std::swap", "utility"),
            ("std::size_t", "cstddef"),
            ("std::domain_error", "stdexcept"),
        ] {
            if functions.contains(word) || body.contains(word) {
                headers.insert(header);
            }
        }
        let headers: String = headers
            .iter()
            .map(|header| format!("#include <{header}>\n"))
            .collect();
        match functions.is_empty() {
            true => format!("{headers}\n{body}"),
            false => {
                format!(
                    "{headers}\nnamespace hedgerow {{\n{functions}\n}}  // namespace hedgerow\n\n{body}"
                )
            }
        }
    }

    /// A function of the program as text.
    fn helper(&mut self, helper: &Helper) -> String {
        let outer = std::mem::replace(&mut self.lines, Lines::new(2));
        self.is_outside = true;
        self.docs(&helper.docs);
        let params = helper.params.iter();
        let params = params.map(|param| format!("{} {}", self.outer_type(param.ty), param.name));
        let params = params.collect::<Vec<_>>().join(", ");
        let (result, name) = (
            helper
                .result
                .map_or("void".into(), |ty| self.outer_type(ty)),
            invoked(&helper.name),
        );
        self.lines
            .open(&format!("inline {result} {name}({params}) {{"));
        self.block(&helper.body);
        self.lines.close("}");
        self.is_outside = false;
        std::mem::replace(&mut self.lines, outer).finish()
    }

    pub fn ty(&self, ty: Type) -> String {
        match ty {
            ty if self.is_outside && ty.is_element() => self.outer_type(ty),
            Type::Bool => "bool".into(),
            Type::Int => "long long".into(),
            Type::Real => self.style.name("real").into(),
            Type::Vec3 => self.style.name("Vector").into(),
            Type::Vec2 => self.style.value("Vector2"),
            Type::Vec4 => self.style.value("Vector4"),
            Type::Mat3 => self.style.value("Matrix3"),
            Type::Mat4 => self.style.value("Matrix4"),
            // Nothing of this type is built.
            Type::Text => "auto".into(),
            Type::Vertex => self.style.name("Vertex").into(),
            Type::Halfedge => self.style.name("Halfedge").into(),
            Type::Edge => self.style.name("Edge").into(),
            Type::Face => self.style.name("Face").into(),
        }
    }

    /// A type where the names of the mesh class are not in sight.
    fn outer_type(&self, ty: Type) -> String {
        match ty {
            Type::Vertex => self.style.qualified("Vertex"),
            Type::Halfedge => self.style.qualified("Halfedge"),
            Type::Edge => self.style.qualified("Edge"),
            Type::Face => self.style.qualified("Face"),
            ty => self.ty(ty),
        }
    }

    fn routine(&mut self, routine: &Routine, alone: bool) {
        self.docs(&routine.docs);
        let mesh = self.style.name("mesh").to_string();
        let result = match routine.result {
            Some(ty) => format!("std::optional<{}>", self.outer_type(ty)),
            None => "bool".into(),
        };
        let other = self.style.name("function");
        let name = match alone && !other.is_empty() {
            true => other.to_string(),
            false => routine.name.clone(),
        };
        let member = self.style.is_member();
        // Without a name what is not used; C++ compilers warn of it.
        let (mut used, mut allocates) = (BTreeSet::new(), false);
        for statement in routine.rules.iter().flat_map(|rule| &rule.body) {
            statement.names(&mut |name| _ = used.insert(name.to_string()));
            allocates |= statement.changes_the_lists();
        }
        let params = routine.params.iter().map(|param| {
            let ty = match member {
                true => self.ty(param.ty),
                false => self.outer_type(param.ty),
            };
            match used.contains(&param.name) {
                true => format!("{ty} {}", param.name),
                false => format!("{ty} /*{}*/", param.name),
            }
        });
        let mut params: Vec<_> = params.collect();
        let name = match member {
            true => format!("{mesh}::{name}"),
            false => {
                params.insert(
                    0,
                    match allocates {
                        true => format!("{mesh}& mesh"),
                        false => format!("{mesh}& /*mesh*/"),
                    },
                );
                name
            }
        };
        self.lines
            .open(&format!("{result} {name}({}) {{", params.join(", ")));
        if !member {
            self.aliases(routine);
        }
        match routine.rules.as_slice() {
            [rule] => self.alternative(&rule.body, routine),
            rules => {
                let inner = match routine.result {
                    Some(ty) => format!("std::optional<{}>", self.ty(ty)),
                    None => "bool".into(),
                };
                let mut names = Vec::new();
                for (at, rule) in rules.iter().enumerate() {
                    let label = rule.label.clone();
                    let name = label.map_or_else(
                        || format!("rule_{}", at + 1),
                        |label| format!("rule_{label}"),
                    );
                    let name = name.replace('\'', "_");
                    self.lines.blank();
                    self.lines
                        .open(&format!("auto {name} = [&]() -> {inner} {{"));
                    self.alternative(&rule.body, routine);
                    self.lines.close("};");
                    names.push(name);
                }
                self.lines.blank();
                if let Some((last, others)) = names.split_last() {
                    for name in others {
                        self.lines.line(&match routine.result {
                            Some(_) => format!("if (auto result = {name}()) return result;"),
                            None => format!("if ({name}()) return true;"),
                        });
                    }
                    self.lines.line(&format!("return {last}();"));
                }
            }
        }
        self.lines.close("}");
    }

    /// A doc comment. A line that ends with a backslash would swallow the next one, but not
    /// in a block.
    fn docs(&mut self, docs: &[String]) {
        if docs.iter().any(|line| line.trim_end().ends_with('\\')) {
            for (at, line) in docs.iter().enumerate() {
                let mark = if at == 0 { "/**" } else { " *" };
                let line = line.replace("*/", "* /");
                self.lines.line(format!("{mark} {line}").trim_end());
            }
            self.lines.line(" */");
        } else {
            for line in docs {
                self.lines.line(format!("/// {line}").trim_end());
            }
        }
    }

    /// Short names for the types that the function speaks of.
    fn aliases(&mut self, routine: &Routine) {
        let mut seen = BTreeSet::new();
        seen.extend(
            routine
                .result
                .filter(|_| routine.rules.len() > 1)
                .map(|ty| self.ty(ty)),
        );
        for rule in &routine.rules {
            types(&rule.body, &mut |ty| {
                if ty.is_element() {
                    seen.insert(self.ty(ty));
                }
            });
        }
        let aliases: Vec<_> = ["Vertex", "Halfedge", "Edge", "Face"]
            .into_iter()
            .filter(|name| seen.contains(self.style.name(name)) && self.style.is_nested(name))
            .map(|name| {
                format!(
                    "using {} = {};",
                    self.style.name(name),
                    self.style.qualified(name)
                )
            })
            .collect();
        for alias in &aliases {
            self.lines.line(alias);
        }
        if !aliases.is_empty() {
            self.lines.blank();
        }
    }

    fn alternative(&mut self, body: &[Statement], routine: &Routine) {
        self.refusal = match routine.result {
            Some(_) => "return std::nullopt;",
            None => "return false;",
        };
        let last = self.refusal;
        self.lines
            .line("// 1. Collect: nothing is written before all of this has passed.");
        self.block(body);
        if matches!(body.last(), Some(Statement::Attempt { .. })) {
            self.lines.line(last);
        }
    }

    pub fn text(&mut self, term: &Term) -> String {
        spell(self, term).text
    }

    pub fn whole(&mut self, term: &Term) -> String {
        spell(self, term).at(Level::Whole)
    }

    /// A call of a function that is written out.
    pub fn support(&mut self, name: &'static str, args: Vec<String>) -> String {
        self.used.push(name);
        format!("hedgerow::{name}({})", args.join(", "))
    }

    pub fn std(&mut self, header: &'static str, name: &str, args: Vec<String>) -> Spelled {
        self.headers.insert(header);
        Spelled::whole(format!("std::{name}({})", args.join(", ")))
    }
}

/// What a function of the program is called: not as one of the language.
pub(super) fn invoked(name: &str) -> String {
    match support::is_known(name) {
        true => format!("{name}_"),
        false => unreserved(name),
    }
}
