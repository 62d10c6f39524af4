//! Statements as Rust.

use super::super::language::{field, skipped};
use super::super::lines::comment;
use super::super::routine::{HalfedgeWalk, Statement, Step};
use super::super::term::{IndexLoop, Parameter, Term};
use super::function::{Printer, kind, ty};
use super::steps::{always, bare};
use crate::diagram::{Kind, Type};

impl Printer {
    pub fn block(&mut self, body: &[Statement]) {
        for (at, statement) in body.iter().enumerate() {
            match statement {
                Statement::List { ty, name, items } => {
                    let grows = body[at..].iter().any(|later| later.adds_to(name));
                    self.list(*ty, if grows { "let mut" } else { "let" }, name, items);
                }
                statement => self.statement(statement),
            }
        }
    }

    fn list(&mut self, of: Type, bind: &str, name: &str, items: &[Term]) {
        let items: Vec<_> = items.iter().map(|item| self.text(item)).collect();
        let value = match items.is_empty() {
            true => "Vec::new()".to_string(),
            false => format!("vec![{}]", items.join(", ")),
        };
        let ty = ty(of);
        self.lines.line(&format!("{bind} {name}: Vec<{ty}> = {value};"));
    }

    pub(super) fn statement(&mut self, statement: &Statement) {
        if let Some(preview) = self.preview.clone()
            && self.note(&preview, statement)
        {
            return;
        }
        match statement {
            Statement::Comment(text) => self.lines.comment("//", text),
            Statement::Blank => self.lines.blank(),
            Statement::Column(attribute) => {
                let (declared, column) = (&attribute.declared, &attribute.column);
                let kind = kind(attribute.element);
                let ty = ty(attribute.ty);
                let found = format!("mesh.find_column(ElementKind::{kind}, \"{declared}\")");
                if self.is_asked {
                    let why = "the caller has found it";
                    return self.lines.line(&format!("let {column} = {found}.expect(\"{why}\");"));
                }
                self.lines.line(&format!("let {column} = {found};"));
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
            Statement::Attempt { kind, element, halfedge, body } => {
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
                self.block(body);
                self.lines.close("}");
                self.refusal = outer;
            }
            Statement::Refuse { when, reason } if always(when) => {
                let (refusal, reason) = (self.refusal, comment("//", reason));
                self.lines.line(&format!("{refusal} {reason}"));
            }
            Statement::Refuse { when, reason } => {
                let when = self.text(when);
                self.lines.open(&format!("if {when} {{"));
                self.lines.line(&format!("{} {}", self.refusal, comment("//", reason)));
                self.lines.close("}");
            }
            Statement::List { ty, name, items } => self.list(*ty, "let mut", name, items),
            Statement::Push { list, item } => {
                let item = self.text(item);
                self.lines.line(&format!("{list}.push({item});"));
            }
            Statement::BindList { name, value, .. } => {
                let value = self.text(value);
                self.lines.line(&format!("let {name} = {value};"));
            }
            Statement::Size { name, list } => {
                self.lines.line(&format!("let {name} = {list}.len();"));
            }
            Statement::Gather { ty: of, name, indices: IndexLoop { index, size }, item } => {
                let item = self.text(item);
                let ty = ty(*of);
                self.lines.line(&format!(
                    "let {name}: Vec<{ty}> = (0..{size}).map(|{index}| {item}).collect();"
                ));
            }
            Statement::NewEach { kind, name, indices: IndexLoop { size, .. } } => {
                let kind = word(*kind);
                self.lines.line(&format!(
                    "let {name}: Vec<_> = (0..{size}).map(|_| mesh.add_{kind}()).collect();"
                ));
            }
            Statement::IndexLoop { indices, body } => {
                let IndexLoop { index, size } = indices;
                self.lines.open(&format!("for {index} in 0..{size} {{"));
                self.block(body);
                self.lines.close("}");
            }
            Statement::Change { name, value } => {
                let value = self.text(value);
                self.lines.line(&format!("{name} = {};", bare(&value)));
            }
            Statement::Choose { condition, then, otherwise } => {
                let condition = self.text(condition);
                self.branches(&condition, [then, otherwise]);
            }
            Statement::Repeat { count, body, .. } => {
                let count = self.text(count);
                self.held(&format!("for _ in 0..{count} {{"), body);
            }
            Statement::While { condition, body } => {
                let condition = self.text(condition);
                self.held(&format!("while {condition} {{"), body);
            }
            Statement::For { variable, around, element, may_go, filter, body } => {
                let all = self.all_around(*around, element);
                let Parameter { name, ty: of, .. } = variable;
                let gone = may_go.then(|| format!("!mesh.{}_alive({name})", of.word()));
                let skipped = skipped(self, gone, filter.as_ref());
                self.visit(&format!("for {name} in {all}.collect::<Vec<_>>() {{"), &skipped, body);
            }
            Statement::Update { visit, held } => self.update(visit, held),
            Statement::Hold { list, element, value } => {
                let (element, value) = (self.text(element), self.text(value));
                let value = bare(&value);
                self.lines.line(&format!("{list}.push(({element}, {value}));"));
            }
            Statement::Break => self.lines.line("break;"),
            Statement::Continue => self.lines.line("continue;"),
            Statement::Walk { walk, body } => self.walk(walk, body),
            Statement::Preview { preview, body } => self.preview_block(preview, body),
            Statement::New { kind, name } => {
                self.lines.line(&format!("let {name} = mesh.add_{}();", word(*kind)));
            }
            Statement::Set { pointer, of, value } => {
                let (of, value) = (self.text(of), self.text(value));
                self.lines.line(&format!("mesh.set_{}({of}, {value});", field(*pointer)));
            }
            Statement::SetHole { face, hole } => {
                let face = self.text(face);
                self.lines.line(&format!("mesh.set_hole({face}, {hole});"));
            }
            Statement::SetPosition { vertex, value } => {
                let (vertex, value) = (self.text(vertex), self.text(value));
                self.lines.line(&format!("mesh.set_position({vertex}, {value});"));
            }
            Statement::SetAttribute { attribute, element, value } => {
                let (element, value) = (self.text(element), self.text(value));
                let column = &attribute.column;
                self.lines.line(&format!("set_attribute(mesh, {column}, {element}.0, {value});"));
            }
            Statement::Erase { kind, element } => {
                let element = self.text(element);
                self.lines.line(&format!("mesh.erase_{}({element});", word(*kind)));
            }
            Statement::Give(value) => {
                let value = self.text(value);
                self.lines.line(&match self.gives_option {
                    true => format!("return Some({value});"),
                    false => format!("return {value};"),
                });
            }
            Statement::Return { result } => {
                let result = match result {
                    Some(result) => format!("Some({})", self.text(result)),
                    None => self.applied.to_string(),
                };
                self.lines.line(&format!("return {result};"));
            }
            Statement::Leave => self.lines.line(match self.gives_option {
                true => "return Some(());",
                false => "return;",
            }),
            Statement::Variable { place, value } => {
                let value = self.text(value);
                self.put(place, &value);
            }
            Statement::Must { call, place } => self.must(call, place.as_ref()),
            Statement::May { call } => {
                let call = self.called(call);
                self.lines.line(&format!("{call};"));
            }
            Statement::Apply { call, place, then, otherwise } => {
                self.apply(call, place.as_ref(), [then, otherwise]);
            }
            Statement::Move { vertex, value, is_finite } => {
                let (vertex, mut value) = (self.text(vertex), self.text(value));
                if !is_finite {
                    value = format!("finite({value})?");
                }
                self.lines.line(&format!("mesh.set_position({vertex}, {value});"));
            }
            Statement::Ask(attribute) => self.ask(attribute),
            // The mesh itself notes what is written.
            Statement::Keep(_) | Statement::KeepAttribute { .. } => {}
        }
    }

    fn walk(&mut self, walk: &HalfedgeWalk, body: &[Statement]) {
        let h = &walk.halfedge;
        let from = self.text(&walk.from);
        if walk.around {
            let all = match walk.step {
                Step::Next => format!("mesh.loop_from({from})"),
                Step::Clockwise => format!("mesh.spokes_from({from})"),
            };
            self.lines.open(&format!("for {h} in {all}.collect::<Vec<_>>() {{"));
            self.block(body);
        } else {
            let until = self.text(&walk.until);
            self.lines.line(&format!("let mut {h} = {from};"));
            self.lines.open(&format!("while {h} != {until} {{"));
            self.block(body);
            self.lines.line(&match walk.step {
                Step::Next => format!("{h} = mesh.next({h});"),
                Step::Clockwise => format!("{h} = mesh.next(mesh.twin({h}));"),
            });
        }
        self.lines.close("}");
    }
}

fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Vertex | Kind::Halfedge | Kind::Edge | Kind::Face => kind.word(),
        Kind::Path | Kind::Fan => "halfedge",
    }
}
