//! Statements as Rust.

use super::super::language::{Language, field, skipped};
use super::super::lines::{Lines, comment};
use super::super::routine::Statement;
use super::super::statement::Printing;
use super::super::term::{IndexLoop, Parameter, Term};
use super::super::walks::{HalfedgeWalk, Step};
use super::function::{Printer, ty};
use super::steps::bare;
use crate::diagram::{Kind, Type};

impl Printing for Printer {
    fn lines(&mut self) -> &mut Lines {
        &mut self.lines
    }

    fn block(&mut self, body: &[Statement]) {
        for (at, statement) in body.iter().enumerate() {
            match statement {
                Statement::List { ty, name, items } => {
                    let grows = body[at..].iter().any(|later| later.adds_to(name));
                    let line = self.list(*ty, if grows { "let mut" } else { "let" }, name, items);
                    self.lines.line(&line);
                }
                statement => self.statement(statement),
            }
        }
    }

    fn if_head(&self, condition: &str) -> String {
        format!("if {condition}")
    }
}

impl Printer {
    fn list(&self, of: Type, bind: &str, name: &str, items: &[Term]) -> String {
        let value = match items {
            [] => "Vec::new()".to_string(),
            items => format!("vec![{}]", self.texts(items).join(", ")),
        };
        format!("{bind} {name}: Vec<{}> = {value};", ty(of))
    }

    pub(super) fn statement(&mut self, statement: &Statement) {
        let mesh = &self.mesh;
        let line = match statement {
            Statement::Comment(text) => return self.lines.comment("//", text),
            Statement::Blank => return self.lines.blank(),
            Statement::Column(attribute) => return self.column(attribute),
            Statement::Bind { name, value, .. } => format!("let {name} = {};", self.text(value)),
            Statement::Attempt { kind, element, halfedge, body } => {
                let all = match kind {
                    Kind::Edge => format!(
                        "[mesh.edge_halfedge({element}), mesh.twin(mesh.edge_halfedge({element}))]"
                    ),
                    Kind::Vertex => format!("mesh.spokes({element}).collect::<Vec<_>>()"),
                    _ => format!("mesh.face_halfedges({element}).collect::<Vec<_>>()"),
                };
                self.attempts(*kind, element);
                let outer = std::mem::replace(&mut self.refusal, "continue;");
                self.held(&format!("for {halfedge} in {all}"), body);
                self.refusal = outer;
                return;
            }
            Statement::Refuse { when: Term::Bool(true), reason } => {
                format!("{} {}", self.refusal, comment("//", reason))
            }
            Statement::Refuse { when, reason } => {
                let when = self.text(when);
                return self.refuse(&format!("if {when} {{"), reason, "}");
            }
            Statement::List { ty, name, items } => self.list(*ty, "let mut", name, items),
            Statement::Push { list, item } => format!("{list}.push({});", self.text(item)),
            Statement::Size { name, list } => format!("let {name} = {list}.len();"),
            Statement::Gather { ty: of, name, indices: IndexLoop { index, size }, item } => {
                let (ty, item) = (ty(*of), self.text(item));
                format!("let {name}: Vec<{ty}> = (0..{size}).map(|{index}| {item}).collect();")
            }
            Statement::NewEach { kind, name, indices: IndexLoop { size, .. } } => {
                let kind = kind.word();
                format!("let {name}: Vec<_> = (0..{size}).map(|_| {mesh}.add_{kind}()).collect();")
            }
            Statement::IndexLoop { indices: IndexLoop { index, size }, body } => {
                return self.held(&format!("for {index} in 0..{size}"), body);
            }
            Statement::Choose { condition, then, otherwise } => {
                return self.branches(&self.text(condition), [then, otherwise]);
            }
            Statement::Repeat { count, body, .. } => {
                return self.held(&format!("for _ in 0..{}", self.text(count)), body);
            }
            Statement::While { condition, body } => {
                return self.held(&format!("while {}", self.text(condition)), body);
            }
            Statement::For { variable, around, element, may_go, filter, body } => {
                let all = self.all_around(*around, element);
                let Parameter { name, ty: of, .. } = variable;
                let gone = may_go.then(|| format!("!mesh.{}_alive({name})", of.word()));
                let skipped = skipped(self, gone, filter.as_ref());
                let head = format!("for {name} in {all}.collect::<Vec<_>>() {{");
                return self.visit(&head, &skipped, body);
            }
            Statement::Update { visit, held } => return self.update(visit, held),
            Statement::Defer { list, element, value } => {
                format!("{list}.push(({}, {}));", self.text(element), bare(&self.text(value)))
            }
            Statement::Break => "break;".into(),
            Statement::Continue => "continue;".into(),
            Statement::Walk { walk, body } => return self.walk(walk, body),
            Statement::Preview { preview, body } => return self.preview(preview, body),
            Statement::New { kind, name } => format!("let {name} = {mesh}.add_{}();", kind.word()),
            Statement::Set { pointer, of, value } => {
                let (of, value) = (self.text(of), self.text(value));
                format!("{mesh}.set_{}({of}, {value});", field(*pointer))
            }
            Statement::SetHole { face, hole } => {
                format!("{mesh}.set_hole({}, {hole});", self.text(face))
            }
            Statement::SetPosition { vertex, value } => {
                format!("mesh.set_position({}, {});", self.text(vertex), self.text(value))
            }
            Statement::SetAttribute { attribute, element, value } => {
                let (element, value) = (self.text(element), self.text(value));
                format!("set_attribute(mesh, {}, {element}.0, {value});", attribute.column)
            }
            Statement::Erase { kind, element } => {
                format!("mesh.erase_{}({});", kind.word(), self.text(element))
            }
            Statement::Return { value } => match self.returned(value.as_ref()).as_str() {
                "" => "return;".into(),
                value => format!("return {value};"),
            },
            Statement::Variable { place, value } => self.put(place, &self.text(value)),
            Statement::MustCall { call, place } => return self.must(call, place.as_ref()),
            Statement::TryCall { call } => format!("{};", self.called(call)),
            Statement::Apply { call, place, then, otherwise } => {
                return self.apply(call, place.as_ref(), [then, otherwise]);
            }
            Statement::Move { vertex, value, is_finite } => {
                let (vertex, value) = (self.text(vertex), self.text(value));
                match is_finite {
                    true => format!("mesh.set_position({vertex}, {value});"),
                    false => format!("mesh.set_position({vertex}, finite({value})?);"),
                }
            }
            Statement::RequireColumn(attribute) => return self.ask(attribute),
            // The mesh itself notes what is written.
            Statement::Journal(_) | Statement::JournalAttribute { .. } => return,
        };
        self.lines.line(&line);
    }

    /// Writes a preview, and the block that looks at it.
    fn preview(&mut self, preview: &str, body: &[Statement]) {
        self.lines.line("// The guard looks at what there would be, on a preview of the mesh.");
        self.lines.open("{");
        self.lines.line(&format!("let mut {preview} = Preview::new(mesh);"));
        let outer = std::mem::replace(&mut self.mesh, preview.to_string());
        self.block(body);
        self.mesh = outer;
        self.lines.close("}");
    }

    /// Refuses in a block.
    pub(super) fn refuse(&mut self, head: &str, reason: &str, end: &str) {
        self.lines.open(head);
        self.lines.line(&format!("{} {}", self.refusal, comment("//", reason)));
        self.lines.close(end);
    }

    pub(super) fn held(&mut self, head: &str, body: &[Statement]) {
        self.lines.open(&format!("{head} {{"));
        self.block(body);
        self.lines.close("}");
    }

    fn walk(&mut self, walk: &HalfedgeWalk, body: &[Statement]) {
        let (h, from) = (&walk.halfedge, self.text(&walk.from));
        if walk.around {
            let all = match walk.step {
                Step::Next => format!("mesh.loop_from({from})"),
                Step::Clockwise => format!("mesh.spokes_from({from})"),
            };
            return self.held(&format!("for {h} in {all}.collect::<Vec<_>>()"), body);
        }
        let until = self.text(&walk.until);
        self.lines.line(&format!("let mut {h} = {from};"));
        self.lines.open(&format!("while {h} != {until} {{"));
        self.block(body);
        self.lines.line(&match walk.step {
            Step::Next => format!("{h} = mesh.next({h});"),
            Step::Clockwise => format!("{h} = mesh.next(mesh.twin({h}));"),
        });
        self.lines.close("}");
    }
}
