//! Statements as C++.

use super::super::language::skipped;
use super::super::lines::{Lines, comment};
use super::super::routine::{HalfedgeWalk, Statement, Step};
use super::super::term::{IndexLoop, Parameter, Term};
use super::function::Printer;
use crate::diagram::{Kind, Pointer, Type};

impl Printer<'_> {
    pub(super) fn block(&mut self, body: &[Statement]) {
        for statement in body {
            self.statement(statement);
        }
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
            // Attributes are fields.
            Statement::Column(_) | Statement::Ask(_) => {}
            Statement::Bind { ty, name, value } => {
                let value = self.text(value);
                let ty = self.ty(*ty);
                self.lines.line(&format!("{ty} {name} = {value};"));
            }
            Statement::Attempt { kind, element, halfedge, body } => {
                self.attempt(*kind, element, halfedge, body)
            }
            Statement::Refuse { when: Term::Bool(true), reason } if self.is_noted => {
                let (refusal, reason) = (self.refusal, comment("//", reason));
                self.lines.line(&format!("{refusal}  {reason}"));
            }
            Statement::Refuse { when, reason } => {
                let when = self.text(when);
                let line = format!("if ({when}) {}", self.refusal);
                match line.len() + reason.len() < 92 {
                    true => self.lines.line(&format!("{line}  {}", comment("//", reason))),
                    false => {
                        self.lines.comment("//", &format!("Refused: {reason}."));
                        self.lines.line(&line);
                    }
                }
            }
            Statement::List { ty, name, items } => {
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
            Statement::BindList { ty, name, value } => {
                let value = self.text(value);
                let ty = self.ty(*ty);
                self.lines.line(&format!("std::vector<{ty}> {name} = {value};"));
            }
            Statement::Size { name, list } => {
                self.lines.line(&format!("std::size_t {name} = {list}.size();"));
            }
            Statement::Gather { ty, name, indices, item } => {
                let item = self.text(item);
                self.gather(&self.ty(*ty), name, indices, &item);
            }
            Statement::IndexLoop { indices, body } => self.held(&turn(indices), body),
            Statement::Change { name, value } => {
                let value = self.text(value);
                self.lines.line(&format!("{name} = {value};"));
            }
            Statement::Choose { condition, then, otherwise } => {
                let condition = self.text(condition);
                match otherwise.as_slice() {
                    [] => self.held(&format!("if ({condition})"), then),
                    _ => self.branches(&condition, [then, otherwise]),
                }
            }
            Statement::Repeat { index, count, body } => {
                let count = self.text(count);
                let head = format!("for (long long {index} = {count}; {index} > 0; --{index})");
                self.held(&head, body);
            }
            Statement::While { condition, body } => {
                let condition = self.text(condition);
                self.held(&format!("while ({condition})"), body);
            }
            Statement::For { variable, around, element, may_go, filter, body } => {
                let all = self.all_around(*around, element);
                let Parameter { name, ty, .. } = variable;
                let gone = may_go.then(|| format!("!journal.lives({name})"));
                let skipped = skipped(self, gone, filter.as_ref());
                let head = format!("for ({} {name} : {all})", self.ty(*ty));
                self.visit(&head, &skipped, body);
            }
            Statement::Update { visit, held } => self.update(visit, held),
            Statement::Hold { list, element, value } => {
                let (element, value) = (self.text(element), self.text(value));
                self.lines.line(&format!("{list}.emplace_back({element}, {value});"));
            }
            Statement::Break => self.lines.line("break;"),
            Statement::Continue => self.lines.line("continue;"),
            Statement::Walk { walk, body } => self.walk(walk, body),
            Statement::Preview { preview, body } => self.preview_block(preview, body),
            Statement::New { kind, name } => {
                let ty = self.style.name(type_name(*kind));
                let call = self.allocated(*kind);
                let line = format!("{ty} {name} = {call};");
                self.lines.line(&line);
            }
            Statement::NewEach { kind, name, indices } => {
                let ty = self.style.name(type_name(*kind)).to_string();
                let call = self.allocated(*kind);
                self.gather(&ty, name, indices, &call);
            }
            Statement::Set { pointer, of, value } => {
                let (of, value) = (self.spelled_whole(of), self.text(value));
                if let Some(line) = self.style.write(&of, *pointer, &value) {
                    self.lines.line(&format!("{line};"));
                }
            }
            Statement::SetHole { face, hole } => {
                let face = self.spelled_whole(face);
                let line = self.style.set_boundary(&face, *hole);
                self.lines.line(&format!("{line};"));
            }
            Statement::SetPosition { vertex, value } => {
                let (vertex, value) = (self.spelled_whole(vertex), self.text(value));
                let line = format!("{} = {value};", self.style.position(&vertex));
                self.lines.line(&line);
            }
            Statement::SetAttribute { attribute, element, value } => {
                let (element, value) = (self.spelled_whole(element), self.text(value));
                let line = format!("{} = {value};", self.field(attribute, &element));
                self.lines.line(&line);
            }
            Statement::Erase { kind, element } => {
                let element = self.text(element);
                let call = match self.is_noted {
                    true => format!("journal.erase({element})"),
                    false => self.style.erase(*kind, &element),
                };
                self.lines.line(&format!("{call};"));
            }
            Statement::Give(value) => {
                let value = self.text(value);
                self.lines.line(&format!("return {value};"));
            }
            Statement::Return { result } => {
                let result = result.as_ref().map_or("true".into(), |result| self.text(result));
                self.lines.line(&format!("return {result};"));
            }
            Statement::Leave => self.lines.line("return;"),
            Statement::Variable { place, value } => {
                let value = self.text(value);
                self.put(place, &value);
            }
            Statement::Must { call, place } => self.must(call, place.as_ref()),
            Statement::May { call } => {
                let text = self.call_of(call);
                self.lines.line(&format!("{text};"));
            }
            Statement::Apply { call, place, then, otherwise } => {
                self.apply(call, place.as_ref(), [then, otherwise]);
            }
            Statement::Move { vertex, value, .. } => {
                let (vertex, value) = (self.text(vertex), self.text(value));
                self.lines.line(&format!("journal.set_position({vertex}, {value});"));
            }
            Statement::Keep(elements) => self.keep(elements),
            Statement::KeepAttribute { attribute, element } => {
                self.keep_attribute(attribute, element);
            }
        }
    }

    fn allocated(&self, kind: Kind) -> String {
        match self.is_noted {
            true => format!("journal.new_{}()", kind.word()),
            false => self.style.allocate(kind),
        }
    }

    /// A list of one item for each index.
    pub(super) fn gather(&mut self, ty: &str, name: &str, indices: &IndexLoop, item: &str) {
        self.lines.line(&format!("std::vector<{ty}> {name};"));
        let (head, push) = (turn(indices), format!("{name}.push_back({item});"));
        match head.len() + push.len() < 92 {
            true => self.lines.line(&format!("{head} {push}")),
            false => {
                self.lines.open(&format!("{head} {{"));
                self.lines.line(&push);
                self.lines.close("}");
            }
        }
    }

    /// A head and its body: on one line if the body is a single short statement.
    pub(super) fn held(&mut self, head: &str, body: &[Statement]) {
        let outer = std::mem::replace(&mut self.lines, Lines::new(2));
        self.block(body);
        let text = std::mem::replace(&mut self.lines, outer).finish();
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
                self.lines.line(&format!("// Both directions of {element} are tried."));
                format!("{{{first}, {twin}}}")
            }
            Kind::Vertex => {
                self.lines.line(&format!("// Each halfedge that starts at {element} is tried."));
                self.support("spokes", vec![element.to_string()])
            }
            _ => {
                self.lines.line(&format!("// Each halfedge of {element} is tried."));
                self.support("halfedges", vec![element.to_string()])
            }
        };
        let outer = std::mem::replace(&mut self.refusal, "continue;");
        self.lines.open(&format!("for ({ty} {halfedge} : {range}) {{"));
        self.block(body);
        if matches!(body.last(), Some(Statement::Attempt { .. })) {
            self.lines.line("continue;");
        }
        self.lines.close("}");
        self.refusal = outer;
    }

    fn walk(&mut self, walk: &HalfedgeWalk, body: &[Statement]) {
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
            let (from, until, step) =
                (self.text(&walk.from), self.spelled_whole(&walk.until), self.text(&step));
            format!("for ({ty} {h} = {from}; {h} != {until}; {h} = {step})")
        };
        self.held(&head, body);
    }
}

/// The head of a loop over the indices.
fn turn(indices: &IndexLoop) -> String {
    let IndexLoop { index, size } = indices;
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
