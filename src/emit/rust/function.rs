//! A routine as Rust: a plain function over `hedgerow::mesh`.

use std::collections::BTreeSet;

use super::super::lines::Lines;
use super::super::routine::{Routine, Statement, Step, Walk};
use super::super::spell::spell;
use super::super::term::{Term, Turns};
use super::super::{NotEmitted, build};
use crate::check::Proved;
use crate::diagram::{Callee, Kind, Pointer, Type};

/// Operations as Rust. What an operation refuses is `None`; one without a result tells whether
/// it applied.
///
/// # Errors
/// [`NotEmitted`] for what has no place in such a function.
pub fn rust(ops: &[&Proved], functions: &[Option<Callee>]) -> Result<String, NotEmitted> {
    let conventions = build::Conventions {
        prev: true,
        isolated_vertices: true,
        columns: true,
    };
    let (helpers, routines) = build::routines(ops, functions, conventions)?;
    let mut printer = Printer {
        lines: Lines::new(4),
        used: BTreeSet::new(),
        refusal: "",
    };
    for routine in &routines {
        printer.lines.line("");
        printer.routine(routine);
    }
    for helper in &helpers {
        printer.lines.line("");
        printer.helper(helper);
    }
    let used = printer.used;
    let mut body = printer.lines.finish();
    for (name, text) in FUNCTIONS {
        if used.contains(name) {
            body.push('\n');
            body.push_str(text);
        }
    }
    let all = [
        "Attribute",
        "ColumnId",
        "EdgeId",
        "ElementKind",
        "FaceId",
        "HalfedgeId",
        "Mesh",
        "VertexId",
    ];
    let used: Vec<_> = all.into_iter().filter(|word| names(&body, word)).collect();
    let vectors = match names(&body, "DVec3") {
        true => "use glam::DVec3;\n",
        false => "",
    };
    Ok(format!(
        "{vectors}use hedgerow::mesh::{{{}}};\n{body}",
        used.join(", ")
    ))
}

/// Whether a text has a word.
pub(super) fn names(text: &str, word: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .any(|part| part == word)
}

/// Functions that are written out where they are used.
pub(super) const FUNCTIONS: &[(&str, &str)] = &[
    (
        "in_order_along_loop",
        "\
/// Whether `b` comes before `c` on the way along the loop from `a`.
fn in_order_along_loop(mesh: &Mesh, a: HalfedgeId, b: HalfedgeId, c: HalfedgeId) -> bool {
    let mut on_the_way = mesh.loop_from(a).enumerate();
    let found = on_the_way.find(|&(at, h)| h == b || (at > 0 && h == c));
    found.is_some_and(|(_, h)| h == b)
}
",
    ),
    (
        "in_order_around_vertex",
        "\
/// Whether `b` comes before `c` on the way around the vertex from `a`, counterclockwise.
fn in_order_around_vertex(mesh: &Mesh, a: HalfedgeId, b: HalfedgeId, c: HalfedgeId) -> bool {
    let mut on_the_way = mesh.spokes_from(a).enumerate();
    let found = on_the_way.find(|&(at, h)| h == b || (at > 0 && h == c));
    found.is_some_and(|(_, h)| h == b)
}
",
    ),
    (
        "all_in_order_along_loop",
        "\
/// Whether a walk along the loop from the first, once around, meets all others in their order.
fn all_in_order_along_loop(mesh: &Mesh, all: &[HalfedgeId]) -> bool {
    let mut open = all.iter().peekable();
    for h in all.first().into_iter().flat_map(|&first| mesh.loop_from(first)) {
        open.next_if_eq(&&h);
    }
    open.next().is_none()
}
",
    ),
    (
        "all_in_order_around_vertex",
        "\
/// Whether a walk around the vertex from the first, once and counterclockwise, meets all others
/// in their order.
fn all_in_order_around_vertex(mesh: &Mesh, all: &[HalfedgeId]) -> bool {
    let mut open = all.iter().peekable();
    for h in all.first().into_iter().flat_map(|&first| mesh.spokes_from(first)) {
        open.next_if_eq(&&h);
    }
    open.next().is_none()
}
",
    ),
    (
        "attribute",
        "\
/// The value of an attribute.
fn attribute<T: Attribute>(mesh: &Mesh, column: ColumnId, element: u32) -> T {
    mesh.values(column).expect(\"a column of this type\")[element as usize]
}
",
    ),
    (
        "set_attribute",
        "\
/// Sets the value of an attribute.
fn set_attribute<T: Attribute>(mesh: &mut Mesh, column: ColumnId, element: u32, value: T) {
    mesh.values_mut(column).expect(\"a column of this type\")[element as usize] = value;
}
",
    ),
    (
        "turned",
        "\
/// All, turned so that the first stands at the place, counted around.
fn turned(mut all: Vec<HalfedgeId>, place: i64) -> Vec<HalfedgeId> {
    if !all.is_empty() {
        let by = place.rem_euclid(all.len() as i64);
        all.rotate_right(by as usize);
    }
    all
}
",
    ),
    (
        "all_differ",
        "\
/// Whether nothing stands twice in `all`.
fn all_differ<T: PartialEq>(all: &[T]) -> bool {
    (1..all.len()).all(|at| !all[..at].contains(&all[at]))
}
",
    ),
    (
        "same_elements",
        "\
/// Whether `a` and `b`, neither with repetitions, hold the same.
fn same_elements<T: PartialEq>(a: &[T], b: &[T]) -> bool {
    a.len() == b.len() && a.iter().all(|x| b.contains(x))
}
",
    ),
];

pub(super) struct Printer {
    pub lines: Lines,
    pub used: BTreeSet<&'static str>,
    /// What leaves the attempt.
    refusal: &'static str,
}

/// A type.
pub(super) fn ty(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "bool",
        Type::Int => "i64",
        Type::Real => "f64",
        Type::Vec3 => "DVec3",
        // Nothing of these types is built.
        Type::Text | Type::Vec2 | Type::Vec4 | Type::Mat3 | Type::Mat4 => "_",
        Type::Vertex => "VertexId",
        Type::Halfedge => "HalfedgeId",
        Type::Edge => "EdgeId",
        Type::Face => "FaceId",
    }
}

fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Vertex | Kind::Halfedge | Kind::Edge | Kind::Face => kind.word(),
        Kind::Path | Kind::Fan => "halfedge",
    }
}

impl Printer {
    fn routine(&mut self, routine: &Routine) {
        for line in &routine.docs {
            self.lines.line(format!("/// {line}").trim_end());
        }
        if routine.docs.is_empty() {
            self.lines
                .line(&format!("/// The operation `{}`.", routine.name));
        }
        let result = match routine.result {
            Some(result) => format!("Option<{}>", ty(result)),
            None => "bool".to_string(),
        };
        let params = |used: &BTreeSet<String>| {
            let params = routine
                .params
                .iter()
                .filter(|param| used.contains(&param.name));
            let params = params.map(|param| format!(", {}: {}", param.name, ty(param.ty)));
            params.collect::<String>()
        };
        let all: BTreeSet<_> = routine
            .params
            .iter()
            .map(|param| param.name.clone())
            .collect();
        let head = format!(
            "pub fn {}(mesh: &mut Mesh{}) -> {result} {{",
            routine.name,
            params(&all)
        );
        if let [rule] = routine.rules.as_slice() {
            self.allow(&rule.body, routine);
            self.lines.open(&head);
            self.alternative(&rule.body, routine);
            self.lines.close("}");
            return;
        }
        let mut calls = Vec::new();
        let mut bodies = Vec::new();
        for (at, rule) in routine.rules.iter().enumerate() {
            let label = rule.label.clone().unwrap_or_else(|| format!("{}", at + 1));
            let name = format!("{}_{}", routine.name, label.replace('\'', "_"));
            let mut used = BTreeSet::new();
            rule.body.iter().for_each(|statement| {
                statement.names(&mut |name| {
                    used.insert(name.to_string());
                });
            });
            let args = routine
                .params
                .iter()
                .filter(|param| used.contains(&param.name));
            let args: String = args.map(|param| format!(", {}", param.name)).collect();
            calls.push(format!("{name}(mesh{args})"));
            bodies.push((name, params(&used), rule));
        }
        self.lines.open(&head);
        let chain = match routine.result {
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
        for (name, params, rule) in bodies {
            self.lines.line("");
            self.allow(&rule.body, routine);
            self.lines.open(&format!(
                "fn {name}(mesh: &mut Mesh{params}) -> {result} {{"
            ));
            self.alternative(&rule.body, routine);
            self.lines.close("}");
        }
    }

    /// The names of the drawing stay, also where Rust would have them in small letters.
    fn allow(&mut self, body: &[Statement], routine: &Routine) {
        let mut capital = false;
        let mut see = |name: &str| capital |= name.chars().any(char::is_uppercase);
        body.iter().for_each(|statement| statement.names(&mut see));
        routine.params.iter().for_each(|param| see(&param.name));
        if capital {
            self.lines.line("#[allow(non_snake_case)]");
        }
    }

    fn alternative(&mut self, body: &[Statement], routine: &Routine) {
        let (refused, last) = match routine.result {
            Some(_) => ("return None;", "None"),
            None => ("return false;", "false"),
        };
        self.refusal = refused;
        self.lines
            .line("// 1. Collect: nothing is written before all of this has passed.");
        let (result, rest) = match body.split_last() {
            Some((Statement::Return { result }, rest)) => (Some(result), rest),
            _ => (None, body),
        };
        self.block(rest, routine.result.is_some());
        match result {
            Some(Some(result)) => {
                let result = self.text(result);
                self.lines.line(&format!("Some({result})"));
            }
            Some(None) => self.lines.line("true"),
            None => self.lines.line(last),
        }
    }

    pub fn block(&mut self, body: &[Statement], has_result: bool) {
        for statement in body {
            self.statement(statement, has_result);
        }
    }

    pub fn text(&mut self, term: &Term) -> String {
        spell(self, term).text
    }

    fn statement(&mut self, statement: &Statement, has_result: bool) {
        match statement {
            Statement::Comment(text) => self.lines.comment("//", text),
            Statement::Blank => self.lines.blank(),
            Statement::Column(attribute) => {
                let (declared, column) = (&attribute.declared, &attribute.column);
                let kind = match attribute.element {
                    Type::Vertex => "Vertex",
                    Type::Halfedge => "Halfedge",
                    Type::Edge => "Edge",
                    _ => "Face",
                };
                let ty = ty(attribute.ty);
                self.lines.line(&format!(
                    "let {column} = mesh.find_column(ElementKind::{kind}, \"{declared}\");"
                ));
                self.lines.open(&format!(
                    "let Some({column}) = {column}.filter(|&c| mesh.values::<{ty}>(c).is_some()) else {{"
                ));
                let refusal = self.refusal;
                self.lines.line(&format!(
                    "{refusal} // the mesh has no attribute `{declared}` of this type"
                ));
                self.lines.close("};");
            }
            Statement::Bind { name, value, .. } => {
                let value = self.text(value);
                self.lines.line(&format!("let {name} = {value};"));
            }
            Statement::Attempt {
                kind,
                element,
                halfedge,
                body,
            } => {
                let all = match kind {
                    Kind::Edge => format!(
                        "[mesh.edge_halfedge({element}), mesh.twin(mesh.edge_halfedge({element}))]"
                    ),
                    Kind::Vertex => format!("mesh.spokes({element}).collect::<Vec<_>>()"),
                    _ => format!("mesh.face_halfedges({element}).collect::<Vec<_>>()"),
                };
                self.lines.line(&match kind {
                    Kind::Edge => format!("// Both directions of {element} are tried."),
                    Kind::Vertex => format!("// Each halfedge that starts at {element} is tried."),
                    _ => format!("// Each halfedge of {element} is tried."),
                });
                let outer = std::mem::replace(&mut self.refusal, "continue;");
                self.lines.open(&format!("for {halfedge} in {all} {{"));
                self.block(body, has_result);
                self.lines.close("}");
                self.refusal = outer;
            }
            Statement::Refuse { when, reason } => {
                let when = self.text(when);
                self.lines.open(&format!("if {when} {{"));
                self.lines.line(&format!(
                    "{} // {}",
                    self.refusal,
                    reason.replace('\n', " ")
                ));
                self.lines.close("}");
            }
            Statement::List {
                ty: of,
                name,
                items,
            } => {
                let items: Vec<_> = items.iter().map(|item| self.text(item)).collect();
                let value = match items.is_empty() {
                    true => "Vec::new()".to_string(),
                    false => format!("vec![{}]", items.join(", ")),
                };
                self.lines
                    .line(&format!("let mut {name}: Vec<{}> = {value};", ty(*of)));
            }
            Statement::Push { list, item } => {
                let item = self.text(item);
                self.lines.line(&format!("{list}.push({item});"));
            }
            Statement::Tally { name, value, .. } => {
                let value = self.text(value);
                self.lines.line(&format!("let mut {name} = {value};"));
            }
            Statement::BindList { name, value, .. } => {
                let value = self.text(value);
                self.lines.line(&format!("let {name} = {value};"));
            }
            Statement::Size { name, list } => {
                self.lines.line(&format!("let {name} = {list}.len();"));
            }
            Statement::Gather {
                ty: of,
                name,
                turns: Turns { index, size },
                item,
            } => {
                let item = self.text(item);
                let ty = ty(*of);
                self.lines.line(&format!(
                    "let {name}: Vec<{ty}> = (0..{size}).map(|{index}| {item}).collect();"
                ));
            }
            Statement::NewEach {
                kind,
                name,
                turns: Turns { size, .. },
            } => {
                let kind = word(*kind);
                self.lines.line(&format!(
                    "let {name}: Vec<_> = (0..{size}).map(|_| mesh.add_{kind}()).collect();"
                ));
            }
            Statement::Turn { turns, body } => {
                let Turns { index, size } = turns;
                self.lines.open(&format!("for {index} in 0..{size} {{"));
                self.block(body, has_result);
                self.lines.close("}");
            }
            Statement::Change { name, value } => {
                let value = self.text(value);
                self.lines.line(&format!("{name} = {value};"));
            }
            Statement::Raise { name } => self.lines.line(&format!("{name} += 1;")),
            Statement::When { condition, body } => {
                let condition = self.text(condition);
                self.lines.open(&format!("if {condition} {{"));
                self.block(body, has_result);
                self.lines.close("}");
            }
            Statement::Walk { walk, body } => self.walk(walk, body, has_result),
            Statement::Each { item, list, body } => {
                self.lines.open(&format!("for &{item} in &{list} {{"));
                self.block(body, has_result);
                self.lines.close("}");
            }
            Statement::New { kind, name } => {
                self.lines
                    .line(&format!("let {name} = mesh.add_{}();", word(*kind)));
            }
            Statement::Set { pointer, of, value } => {
                let field = match pointer {
                    Pointer::Next => "next",
                    Pointer::Prev => "prev",
                    Pointer::Twin => "twin",
                    Pointer::Vertex | Pointer::Target => "vertex",
                    Pointer::Edge => "edge",
                    Pointer::Face => "face",
                    Pointer::VertexHalfedge => "vertex_halfedge",
                    Pointer::EdgeHalfedge => "edge_halfedge",
                    Pointer::FaceHalfedge => "face_halfedge",
                };
                let (of, value) = (self.text(of), self.text(value));
                self.lines
                    .line(&format!("mesh.set_{field}({of}, {value});"));
            }
            Statement::SetHole { face, hole } => {
                let face = self.text(face);
                self.lines.line(&format!("mesh.set_hole({face}, {hole});"));
            }
            Statement::SetPosition { vertex, value } => {
                let (vertex, value) = (self.text(vertex), self.text(value));
                self.lines
                    .line(&format!("mesh.set_position({vertex}, {value});"));
            }
            Statement::SetAttribute {
                attribute,
                element,
                value,
            } => {
                self.used.insert("set_attribute");
                let (element, value) = (self.text(element), self.text(value));
                let column = &attribute.column;
                self.lines.line(&format!(
                    "set_attribute(mesh, {column}, {element}.0, {value});"
                ));
            }
            Statement::Erase { kind, element } => {
                let element = self.text(element);
                self.lines
                    .line(&format!("mesh.erase_{}({element});", word(*kind)));
            }
            Statement::Give(value) => {
                let value = self.text(value);
                self.lines.line(&format!("return {value};"));
            }
            Statement::Return { result } => {
                let result = match result {
                    Some(result) => format!("Some({})", self.text(result)),
                    None => "true".to_string(),
                };
                self.lines.line(&format!("return {result};"));
            }
        }
    }

    fn walk(&mut self, walk: &Walk, body: &[Statement], has_result: bool) {
        let h = &walk.halfedge;
        let from = self.text(&walk.from);
        if walk.around {
            let all = match walk.step {
                Step::Next => format!("mesh.loop_from({from})"),
                Step::Clockwise => format!("mesh.spokes_from({from})"),
            };
            self.lines
                .open(&format!("for {h} in {all}.collect::<Vec<_>>() {{"));
            self.block(body, has_result);
        } else {
            let until = self.text(&walk.until);
            self.lines.line(&format!("let mut {h} = {from};"));
            self.lines.open(&format!("while {h} != {until} {{"));
            self.block(body, has_result);
            self.lines.line(&match walk.step {
                Step::Next => format!("{h} = mesh.next({h});"),
                Step::Clockwise => format!("{h} = mesh.next(mesh.twin({h}));"),
            });
        }
        self.lines.close("}");
    }
}
