//! A routine as Rust: a plain function over `hedgerow::mesh`.

use std::collections::BTreeSet;

use super::cpp::number;
use super::lines::Lines;
use super::routine::{Around, Fold, Function, Routine, Statement, Step, Term, Walk};
use super::spell::{Language, Level, Spelled, spell};
use super::{NotEmitted, build};
use crate::check::Proved;
use crate::diagram::{Binary, Builtin, FoldFunction, Kind, Pointer, Type};

/// Operations as Rust. What an operation refuses is `None`; one without a result tells whether
/// it applied.
///
/// # Errors
/// [`NotEmitted`] for what has no place in such a function.
pub fn rust(ops: &[&Proved]) -> Result<String, NotEmitted> {
    let routines: Vec<_> = ops
        .iter()
        .map(|op| build::routine(op, build::Pointers::WithPrev))
        .collect::<Result<_, _>>()?;
    let mut printer = Printer {
        lines: Lines::new(4),
        used: BTreeSet::new(),
        refusal: "",
    };
    for routine in &routines {
        printer.lines.line("");
        printer.routine(routine);
    }
    let used = printer.used;
    let mut body = printer.lines.finish();
    for (name, text) in FUNCTIONS {
        if used.contains(name) {
            body.push('\n');
            body.push_str(text);
        }
    }
    let ids = ["EdgeId", "FaceId", "HalfedgeId", "Mesh", "VertexId"];
    let ids: Vec<_> = ids.into_iter().filter(|id| names(&body, id)).collect();
    let vectors = match names(&body, "DVec3") {
        true => "use glam::DVec3;\n",
        false => "",
    };
    Ok(format!(
        "{vectors}use hedgerow::mesh::{{{}}};\n{body}",
        ids.join(", ")
    ))
}

/// Whether a text has a word.
fn names(text: &str, word: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .any(|part| part == word)
}

/// Functions that are written out where they are used.
const FUNCTIONS: &[(&str, &str)] = &[
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

struct Printer {
    lines: Lines,
    used: BTreeSet<&'static str>,
    /// What leaves the attempt.
    refusal: &'static str,
}

fn ty(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "bool",
        Type::Int => "i64",
        Type::Real => "f64",
        Type::Vec3 => "DVec3",
        Type::Text => "&str",
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

    fn block(&mut self, body: &[Statement], has_result: bool) {
        for statement in body {
            self.statement(statement, has_result);
        }
    }

    fn text(&mut self, term: &Term) -> String {
        spell(self, term).text
    }

    fn statement(&mut self, statement: &Statement, has_result: bool) {
        match statement {
            Statement::Comment(text) => self.lines.comment("//", text),
            Statement::Blank => self.lines.blank(),
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
            Statement::Erase { kind, name } => {
                self.lines
                    .line(&format!("mesh.erase_{}({name});", word(*kind)));
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

impl Language for Printer {
    fn real(&self, value: f64) -> Spelled {
        number(value)
    }

    fn int(&self, value: i64) -> Spelled {
        match value {
            0.. => Spelled::whole(value.to_string()),
            _ => Spelled::new(value.to_string(), Level::Prefix),
        }
    }

    fn follow(&mut self, pointer: Pointer, of: Spelled) -> Spelled {
        let name = match pointer {
            Pointer::Next => "next",
            Pointer::Prev => "prev",
            Pointer::Twin => "twin",
            Pointer::Vertex => "vertex",
            Pointer::Target => "target",
            Pointer::Edge => "edge",
            Pointer::Face => "face",
            Pointer::VertexHalfedge => "vertex_halfedge",
            Pointer::EdgeHalfedge => "edge_halfedge",
            Pointer::FaceHalfedge => "face_halfedge",
        };
        Spelled::whole(format!("mesh.{name}({})", of.text))
    }

    fn position(&mut self, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.position({})", of.text))
    }

    fn hole(&mut self, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.is_hole({})", of.text))
    }

    fn component(&mut self, part: u8, of: Spelled) -> Spelled {
        let name = ["x", "y", "z"][usize::from(part.min(2))];
        Spelled::whole(format!("{}.{name}", of.at(Level::Whole)))
    }

    fn vector(&mut self, parts: [Spelled; 3]) -> Spelled {
        let parts = parts.map(|part| part.text).join(", ");
        Spelled::whole(format!("DVec3::new({parts})"))
    }

    fn choice(&mut self, condition: Spelled, then: Spelled, otherwise: Spelled) -> Spelled {
        let text = format!(
            "if {} {{ {} }} else {{ {} }}",
            condition.text, then.text, otherwise.text
        );
        Spelled::new(text, Level::Choice)
    }

    fn to_real(&mut self, of: Spelled) -> Spelled {
        // `as` binds more tightly than a comparison, but `x as f64 < y` reads as a type.
        Spelled::new(format!("{} as f64", of.at(Level::Prefix)), Level::Compare)
    }

    fn call(&mut self, function: Function, args: Vec<Spelled>) -> Spelled {
        let builtin = match function {
            Function::Builtin(builtin) => builtin,
            function => return self.own(function, args),
        };
        let first = |args: &[Spelled]| {
            args.first()
                .map_or_else(String::new, |arg| arg.text.clone())
        };
        let of_mesh = |name: &str, args: &[Spelled]| {
            let args: Vec<_> = args.iter().map(|arg| arg.text.clone()).collect();
            Spelled::whole(format!("mesh.{name}({})", args.join(", ")))
        };
        let count = |name: &str| {
            let text = format!("mesh.{name}({}) as i64", first(&args));
            Spelled::new(text, Level::Compare)
        };
        let name = match builtin {
            Builtin::DegreeVertex => return count("degree"),
            Builtin::DegreeFace => return count("face_size"),
            Builtin::BoundaryVertex => return of_mesh("is_boundary_vertex", &args),
            Builtin::BoundaryHalfedge => return of_mesh("is_boundary_halfedge", &args),
            Builtin::BoundaryEdge => return of_mesh("is_boundary_edge", &args),
            Builtin::IsHole => return of_mesh("is_hole", &args),
            Builtin::Adjacent => return of_mesh("adjacent", &args),
            Builtin::LinkCondition => return of_mesh("link_condition", &args),
            Builtin::LengthEdge => return of_mesh("length", &args),
            Builtin::LengthHalfedge => {
                return Spelled::whole(format!("mesh.vector({}).length()", first(&args)));
            }
            Builtin::Area => return of_mesh("area", &args),
            Builtin::NormalFace => return of_mesh("normal", &args),
            Builtin::NormalVertex => return of_mesh("vertex_normal", &args),
            Builtin::CentroidFace => return of_mesh("centroid", &args),
            Builtin::CentroidEdge => {
                let half = format!("mesh.edge_halfedge({})", first(&args));
                return Spelled::whole(format!(
                    "mesh.position(mesh.vertex({half})).lerp(mesh.position(mesh.target({half})), 0.5)"
                ));
            }
            Builtin::MixVec3 => "lerp",
            Builtin::MixReal => {
                let [a, b, t] =
                    [0, 1, 2].map(|at| args.get(at).cloned().unwrap_or_else(|| Spelled::whole("")));
                let t = t.at(Level::Product);
                let text = format!(
                    "{} * (1.0 - {t}) + {} * {t}",
                    a.at(Level::Product),
                    b.at(Level::Product)
                );
                return Spelled::new(text, Level::Sum);
            }
            Builtin::LengthVec3 => "length",
            Builtin::Dot => "dot",
            Builtin::Cross => "cross",
            Builtin::Normalize => "normalize_or_zero",
            Builtin::Distance => "distance",
            Builtin::Angle => {
                let (a, b) = (
                    first(&args),
                    args.get(1).map_or_else(String::new, |b| b.text.clone()),
                );
                return Spelled::whole(format!(
                    "f64::atan2(DVec3::cross({a}, {b}).length(), DVec3::dot({a}, {b}))"
                ));
            }
            Builtin::Round => {
                let value = args
                    .into_iter()
                    .next()
                    .map_or_else(String::new, |arg| arg.at(Level::Whole));
                let text = format!("{value}.round_ties_even() as i64");
                return Spelled::new(text, Level::Compare);
            }
            Builtin::AbsInt | Builtin::AbsReal => "abs",
            Builtin::MinInt | Builtin::MinReal => "min",
            Builtin::MaxInt | Builtin::MaxReal => "max",
            Builtin::Sqrt => "sqrt",
            Builtin::Sin => "sin",
            Builtin::Cos => "cos",
            Builtin::Tan => "tan",
            Builtin::Asin => "asin",
            Builtin::Acos => "acos",
            Builtin::Atan2 => "atan2",
            Builtin::Exp => "exp",
            Builtin::Log => "ln",
            Builtin::Pow => "powf",
            Builtin::Floor => "floor",
            Builtin::Ceil => "ceil",
        };
        let whose = match builtin {
            Builtin::MixVec3
            | Builtin::LengthVec3
            | Builtin::Dot
            | Builtin::Cross
            | Builtin::Normalize
            | Builtin::Distance => "DVec3",
            Builtin::AbsInt | Builtin::MinInt | Builtin::MaxInt => "i64",
            _ => "f64",
        };
        let args: Vec<_> = args.into_iter().map(|arg| arg.text).collect();
        Spelled::whole(format!("{whose}::{name}({})", args.join(", ")))
    }

    fn operator(&mut self, operator: Binary, args: [Spelled; 2]) -> Spelled {
        let [left, right] = args;
        match operator {
            // Rounded down: Euclid's division is that for a positive divisor only.
            Binary::Div => {
                let (left, right) = (left.at(Level::Whole), right.at(Level::Whole));
                Spelled::whole(format!(
                    "({left} / {right} - i64::from({left} % {right} != 0 && ({left} < 0) != ({right} < 0)))"
                ))
            }
            Binary::Mod => {
                let (left, right) = (left.at(Level::Whole), right.at(Level::Whole));
                Spelled::whole(format!("(({left} % {right} + {right}) % {right})"))
            }
            Binary::MultiplyVec3 => {
                let text = format!("{} * {}", left.at(Level::Product), right.at(Level::Prefix));
                Spelled::new(text, Level::Product)
            }
            _ => {
                let text = format!("{} == {}", left.at(Level::Sum), right.at(Level::Sum));
                Spelled::new(text, Level::Compare)
            }
        }
    }

    fn fold(&mut self, fold: &Fold) -> Spelled {
        let element = self.text(&fold.element);
        let half = format!("mesh.edge_halfedge({element})");
        let sides = format!("[{half}, mesh.twin({half})].into_iter()");
        let real = ".filter(|&f| !mesh.is_hole(f))";
        let mut all = match fold.around {
            Around::VertexHalfedges => format!("mesh.spokes({element})"),
            Around::VertexEdges => format!("mesh.spokes({element}).map(|h| mesh.edge(h))"),
            Around::VertexFaces => format!("mesh.spokes({element}).map(|h| mesh.face(h)){real}"),
            Around::VertexNeighbors => format!("mesh.neighbors({element})"),
            Around::FaceHalfedges => format!("mesh.face_halfedges({element})"),
            Around::FaceVertices => format!("mesh.face_vertices({element})"),
            Around::FaceEdges => format!("mesh.face_halfedges({element}).map(|h| mesh.edge(h))"),
            Around::EdgeVertices => format!("{sides}.map(|h| mesh.vertex(h))"),
            Around::EdgeFaces => format!("{sides}.map(|h| mesh.face(h)){real}"),
        };
        let variable = &fold.variable.name;
        if let Some(filter) = &fold.filter {
            let filter = self.text(filter);
            all = format!("{all}.filter(|&{variable}| {filter})");
        }
        let body = spell(self, &fold.body);
        let body = match (fold.body_type, fold.ty) {
            (Type::Int, Type::Real) => self.to_real(body),
            _ => body,
        };
        // Nothing but the variable is wanted of a count of all.
        let (body, of) = (body.text, ty(fold.ty));
        let bound = match names(&body, variable) {
            true => variable.as_str(),
            false => "_",
        };
        let (nothing, values) = ("a value of nothing", format!("{all}.map(|{bound}| {body})"));
        Spelled::whole(match fold.function {
            FoldFunction::Any => format!("{all}.any(|{bound}| {body})"),
            FoldFunction::All => format!("{all}.all(|{bound}| {body})"),
            FoldFunction::Count => {
                format!("({all}.filter(|&{bound}| {body}).count() as i64)").replace("|&_|", "|_|")
            }
            FoldFunction::Sum => format!("{values}.sum::<{of}>()"),
            FoldFunction::Mean => {
                let values = format!("{values}.collect::<Vec<{of}>>()");
                format!(
                    "{{ let all = {values}; assert!(!all.is_empty(), \"{nothing}\"); all.iter().copied().sum::<{of}>() / all.len() as f64 }}"
                )
            }
            FoldFunction::Min => format!("{values}.reduce({of}::min).expect(\"{nothing}\")"),
            FoldFunction::Max => format!("{values}.reduce({of}::max).expect(\"{nothing}\")"),
        })
    }
}

impl Printer {
    /// A function that is written out, or a method of a list or vector.
    fn own(&mut self, function: Function, args: Vec<Spelled>) -> Spelled {
        let mut args: Vec<_> = args.into_iter().map(|arg| arg.text).collect();
        let name = match function {
            Function::InOrderAlongLoop => "in_order_along_loop",
            Function::InOrderAroundVertex => "in_order_around_vertex",
            Function::AllDiffer => "all_differ",
            Function::SameElements => "same_elements",
            Function::Holds => {
                let (list, item) = (args.first().cloned(), args.get(1).cloned());
                let (list, item) = (list.unwrap_or_default(), item.unwrap_or_default());
                return Spelled::whole(format!("{list}.contains(&{item})"));
            }
            Function::IsFinite | Function::Builtin(_) => {
                return Spelled::whole(format!("{}.is_finite()", args.join(", ")));
            }
        };
        self.used.insert(name);
        match function {
            Function::InOrderAlongLoop | Function::InOrderAroundVertex => {
                args.insert(0, "mesh".to_string());
            }
            _ => args.iter_mut().for_each(|arg| arg.insert(0, '&')),
        }
        Spelled::whole(format!("{name}({})", args.join(", ")))
    }
}
