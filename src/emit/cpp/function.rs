//! A routine as C++: the classic function over a pointer-based halfedge mesh.

use std::collections::BTreeSet;

use super::super::lines::Lines;
use super::super::routine::{Routine, Statement, Step, Walk};
use super::super::spell::{Level, Spelled, spell};
use super::super::term::{Term, Turns};
use super::super::{NotEmitted, build};
use super::style::Style;
use super::support;
use super::types::types;
use crate::check::Proved;
use crate::diagram::{Kind, Pointer, Type};

/// Operations as C++17, with the functions that they call. What an operation refuses is
/// `std::nullopt`; one without a result tells whether it applied.
///
/// # Errors
/// [`NotEmitted`] for what has no place in such a function.
pub fn cpp(ops: &[&Proved], style: &Style) -> Result<String, NotEmitted> {
    let conventions = build::Conventions {
        prev: style.has_prev(),
        isolated_vertices: false,
        columns: false,
    };
    let routines: Vec<_> = ops
        .iter()
        .map(|op| build::routine(op, conventions))
        .collect::<Result<_, _>>()?;
    let mut printer = Printer {
        style,
        lines: Lines::new(2),
        used: Vec::new(),
        headers: BTreeSet::from(["optional"]),
        refusal: "",
    };
    for (at, routine) in routines.iter().enumerate() {
        if at > 0 {
            printer.lines.line("");
        }
        printer.routine(routine, routines.len() == 1);
    }
    Ok(printer.finish())
}

pub(super) struct Printer<'s> {
    pub style: &'s Style,
    lines: Lines,
    pub used: Vec<&'static str>,
    headers: BTreeSet<&'static str>,
    /// What leaves the attempt.
    refusal: &'static str,
}

impl Printer<'_> {
    fn finish(self) -> String {
        let needed = support::needed(&self.used);
        let mut headers = self.headers;
        let mut functions = String::new();
        for name in needed {
            let chain = |of: &str, pointer: &str| self.style.chained(of, pointer);
            let text = support::spelled(name, &chain, &|ty| self.style.qualified(ty));
            functions.push_str(&format!("\n{text}\n"));
        }
        for (word, header) in [
            ("std::vector", "vector"),
            ("std::find", "algorithm"),
            ("std::m", "algorithm"),
            ("std::reverse", "algorithm"),
            ("std::rotate", "algorithm"),
            ("std::count_if", "algorithm"),
            ("std::is_permutation", "algorithm"),
            ("std::sqrt", "cmath"),
            ("std::atan2", "cmath"),
            ("std::isfinite", "cmath"),
            ("std::size_t", "cstddef"),
            ("std::domain_error", "stdexcept"),
        ] {
            if functions.contains(word) {
                headers.insert(header);
            }
        }
        let body = self.lines.finish();
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

    pub fn ty(&self, ty: Type) -> String {
        match ty {
            Type::Bool => "bool".into(),
            Type::Int => "long long".into(),
            Type::Real => self.style.name("real").into(),
            Type::Vec3 => self.style.name("Vector").into(),
            // Nothing of these types is built.
            Type::Text | Type::Vec2 | Type::Vec4 | Type::Mat3 | Type::Mat4 => "auto".into(),
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

    fn block(&mut self, body: &[Statement]) {
        for statement in body {
            self.statement(statement);
        }
    }

    pub fn text(&mut self, term: &Term) -> String {
        spell(self, term).text
    }

    fn whole(&mut self, term: &Term) -> String {
        spell(self, term).at(Level::Whole)
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Comment(text) => self.lines.comment("//", text),
            Statement::Blank => self.lines.blank(),
            // Attributes are fields.
            Statement::Column(_) => {}
            Statement::Bind { ty, name, value } => {
                let value = self.text(value);
                let ty = self.ty(*ty);
                self.lines.line(&format!("{ty} {name} = {value};"));
            }
            Statement::Attempt {
                kind,
                element,
                halfedge,
                body,
            } => self.attempt(*kind, element, halfedge, body),
            Statement::Refuse { when, reason } => {
                let when = self.text(when);
                let line = format!("if ({when}) {}", self.refusal);
                let reason = reason.replace('\n', " ");
                match line.len() + reason.len() < 92 {
                    true => self.lines.line(&format!("{line}  // {reason}")),
                    false => {
                        self.lines.comment("//", &format!("Refused: {reason}."));
                        self.lines.line(&line);
                    }
                }
            }
            Statement::List { ty, name, items } => {
                self.headers.insert("vector");
                let items: Vec<_> = items.iter().map(|item| self.text(item)).collect();
                let ty = self.ty(*ty);
                let line = match items.is_empty() {
                    true => format!("std::vector<{ty}> {name};"),
                    false => format!("std::vector<{ty}> {name} = {{{}}};", items.join(", ")),
                };
                self.lines.line(&line);
            }
            Statement::Push { list, item } => {
                let item = self.text(item);
                self.lines.line(&format!("{list}.push_back({item});"));
            }
            Statement::Tally { ty, name, value } => {
                let value = self.text(value);
                let ty = if *ty == Type::Int { "int" } else { "bool" };
                self.lines.line(&format!("{ty} {name} = {value};"));
            }
            Statement::BindList { ty, name, value } => {
                self.headers.insert("vector");
                let value = self.text(value);
                let ty = self.ty(*ty);
                self.lines
                    .line(&format!("std::vector<{ty}> {name} = {value};"));
            }
            Statement::Size { name, list } => {
                self.headers.insert("cstddef");
                self.lines
                    .line(&format!("std::size_t {name} = {list}.size();"));
            }
            Statement::Gather {
                ty,
                name,
                turns,
                item,
            } => {
                let item = self.text(item);
                self.gather(&self.ty(*ty), name, turns, &item);
            }
            Statement::Turn { turns, body } => self.held(&turn(turns), body),
            Statement::Change { name, value } => {
                let value = self.text(value);
                self.lines.line(&format!("{name} = {value};"));
            }
            Statement::Raise { name } => self.lines.line(&format!("++{name};")),
            Statement::When { condition, body } => {
                let condition = self.text(condition);
                self.held(&format!("if ({condition})"), body);
            }
            Statement::Walk { walk, body } => self.walk(walk, body),
            Statement::Each { item, list, body } => {
                let ty = self.ty(Type::Face);
                self.held(&format!("for ({ty} {item} : {list})"), body);
            }
            Statement::New { kind, name } => {
                let ty = self.style.name(type_name(*kind));
                let call = self.style.allocate(*kind);
                let line = format!("{ty} {name} = {call};");
                self.lines.line(&line);
            }
            Statement::NewEach { kind, name, turns } => {
                let ty = self.style.name(type_name(*kind)).to_string();
                let call = self.style.allocate(*kind);
                self.gather(&ty, name, turns, &call);
            }
            Statement::Set { pointer, of, value } => {
                let (of, value) = (self.whole(of), self.text(value));
                if let Some(line) = self.style.write(&of, *pointer, &value) {
                    self.lines.line(&format!("{line};"));
                }
            }
            Statement::SetHole { face, hole } => {
                let face = self.whole(face);
                let line = self.style.set_boundary(&face, *hole);
                self.lines.line(&format!("{line};"));
            }
            Statement::SetPosition { vertex, value } => {
                let (vertex, value) = (self.whole(vertex), self.text(value));
                let line = format!("{} = {value};", self.style.position(&vertex));
                self.lines.line(&line);
            }
            Statement::SetAttribute {
                attribute,
                element,
                value,
            } => {
                let (element, value) = (self.whole(element), self.text(value));
                let line = format!(
                    "{} = {value};",
                    self.style.attribute(&element, &attribute.name)
                );
                self.lines.line(&line);
            }
            Statement::Erase { kind, element } => {
                let element = self.text(element);
                let line = format!("{};", self.style.erase(*kind, &element));
                self.lines.line(&line);
            }
            Statement::Return { result } => {
                let result = result
                    .as_ref()
                    .map_or("true".into(), |result| self.text(result));
                self.lines.line(&format!("return {result};"));
            }
        }
    }

    /// A list of what stands for each index.
    fn gather(&mut self, ty: &str, name: &str, turns: &Turns, item: &str) {
        self.headers.insert("vector");
        self.lines.line(&format!("std::vector<{ty}> {name};"));
        let (head, push) = (turn(turns), format!("{name}.push_back({item});"));
        match head.len() + push.len() < 92 {
            true => self.lines.line(&format!("{head} {push}")),
            false => {
                self.lines.open(&format!("{head} {{"));
                self.lines.line(&push);
                self.lines.close("}");
            }
        }
    }

    /// A head and what it holds: on one line if that is a single short statement.
    fn held(&mut self, head: &str, body: &[Statement]) {
        let mut inner = Printer {
            style: self.style,
            lines: Lines::new(2),
            used: Vec::new(),
            headers: BTreeSet::new(),
            refusal: self.refusal,
        };
        inner.block(body);
        let text = std::mem::take(&mut inner.lines).finish();
        self.used.append(&mut inner.used);
        self.headers.append(&mut inner.headers);
        let mut lines = text.lines();
        match (lines.next(), lines.next()) {
            (Some(only), None) if head.len() + only.len() < 92 => {
                self.lines.line(&format!("{head} {only}"));
            }
            (Some(_), _) => {
                self.lines.open(&format!("{head} {{"));
                for line in text.lines() {
                    self.lines.line(line);
                }
                self.lines.close("}");
            }
            (None, _) => {}
        }
    }

    fn attempt(&mut self, kind: Kind, element: &str, halfedge: &str, body: &[Statement]) {
        let ty = self.ty(Type::Halfedge);
        let first =
            |printer: &Self, pointer| printer.style.read(element, pointer).unwrap_or_default();
        let range = match kind {
            Kind::Edge => {
                let first = first(self, Pointer::EdgeHalfedge);
                let twin = self.style.read(&first, Pointer::Twin).unwrap_or_default();
                self.lines
                    .line(&format!("// Both directions of {element} are tried."));
                format!("{{{first}, {twin}}}")
            }
            Kind::Vertex => {
                self.lines.line(&format!(
                    "// Each halfedge that starts at {element} is tried."
                ));
                self.support("spokes", vec![element.to_string()])
            }
            _ => {
                self.lines
                    .line(&format!("// Each halfedge of {element} is tried."));
                self.support("halfedges", vec![element.to_string()])
            }
        };
        let outer = std::mem::replace(&mut self.refusal, "continue;");
        self.lines
            .open(&format!("for ({ty} {halfedge} : {range}) {{"));
        self.block(body);
        if matches!(body.last(), Some(Statement::Attempt { .. })) {
            self.lines.line("continue;");
        }
        self.lines.close("}");
        self.refusal = outer;
    }

    fn walk(&mut self, walk: &Walk, body: &[Statement]) {
        let ty = self.ty(Type::Halfedge);
        let h = &walk.halfedge;
        let head = if walk.around {
            let (name, of) = match (walk.step, &walk.from) {
                (Step::Clockwise, Term::Follow(Pointer::VertexHalfedge, of)) => {
                    ("spokes", (**of).clone())
                }
                (Step::Clockwise, from) => ("spokes", from.clone().follow(Pointer::Vertex)),
                (Step::Next, Term::Follow(Pointer::FaceHalfedge, of)) => {
                    ("halfedges", (**of).clone())
                }
                (Step::Next, from) => ("halfedges", from.clone().follow(Pointer::Face)),
            };
            let of = self.text(&of);
            let range = self.support(name, vec![of]);
            format!("for ({ty} {h} : {range})")
        } else {
            let step = Term::name(h);
            let step = match walk.step {
                Step::Next => step.follow(Pointer::Next),
                Step::Clockwise => step.follow(Pointer::Twin).follow(Pointer::Next),
            };
            let (from, until, step) = (
                self.text(&walk.from),
                self.whole(&walk.until),
                self.text(&step),
            );
            format!("for ({ty} {h} = {from}; {h} != {until}; {h} = {step})")
        };
        self.held(&head, body);
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

/// The head of a loop over the indices.
fn turn(turns: &Turns) -> String {
    let Turns { index, size } = turns;
    format!("for (std::size_t {index} = 0; {index} < {size}; ++{index})")
}

/// The name of a type in a style.
fn type_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Vertex => "Vertex",
        Kind::Halfedge => "Halfedge",
        Kind::Edge => "Edge",
        _ => "Face",
    }
}
