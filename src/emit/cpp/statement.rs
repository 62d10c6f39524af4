//! Statements as C++.

use super::super::language::{Language, Level, skipped, spell};
use super::super::lines::{Lines, comment};
use super::super::routine::{Statement, type_of};
use super::super::statement::Printing;
use super::super::term::{IndexLoop, Parameter, Term};
use super::super::walks::{HalfedgeWalk, Step};
use super::function::Printer;
use crate::diagram::{Kind, Pointer, Type};

/// The maximum length of a line.
pub(super) const WIDTH: usize = 92;

impl Printing for Printer<'_> {
    fn lines(&mut self) -> &mut Lines {
        &mut self.lines
    }

    fn block(&mut self, body: &[Statement]) {
        for statement in body {
            self.statement(statement);
        }
    }

    fn if_head(&self, condition: &str) -> String {
        format!("if ({condition})")
    }

    fn chained<'s>(&self, statement: &'s Statement) -> Option<(String, [&'s [Statement]; 2])> {
        match statement {
            Statement::Choose { condition, then, otherwise } => {
                Some((self.text(condition), [then, otherwise]))
            }
            Statement::Apply { call, place: None, then, otherwise } if !then.is_empty() => {
                Some((self.call_of(call), [then, otherwise]))
            }
            _ => None,
        }
    }
}

impl Printer<'_> {
    pub(super) fn statement(&mut self, statement: &Statement) {
        if let Some(preview) = self.preview.clone()
            && self.note(&preview, statement)
        {
            return;
        }
        let line = match statement {
            Statement::Comment(text) => return self.lines.comment("//", text),
            Statement::Blank => return self.lines.blank(),
            // Attributes are fields.
            Statement::Column(_) | Statement::RequireColumn(_) => return,
            Statement::Bind { ty, name, value, is_list } => {
                let ty = match is_list {
                    true => format!("std::vector<{}>", self.ty(*ty)),
                    false => self.ty(*ty),
                };
                format!("{ty} {name} = {};", self.text(value))
            }
            Statement::Attempt { kind, element, halfedge, body } => {
                return self.attempt(*kind, element, halfedge, body);
            }
            Statement::Refuse { when: Term::Bool(true), reason } if self.is_noted => {
                format!("{}  {}", self.refusal, comment("//", reason))
            }
            Statement::Refuse { when, reason } => {
                let line = format!("if ({}) {}", self.text(when), self.refusal);
                match line.len() + reason.len() < WIDTH {
                    true => format!("{line}  {}", comment("//", reason)),
                    false => {
                        self.lines.comment("//", &format!("Refused: {reason}."));
                        line
                    }
                }
            }
            Statement::List { ty, name, items } => match items.as_slice() {
                [] => format!("std::vector<{}> {name};", self.ty(*ty)),
                items => {
                    let items = self.texts(items).join(", ");
                    format!("std::vector<{}> {name} = {{{items}}};", self.ty(*ty))
                }
            },
            Statement::Push { list, item } => format!("{list}.push_back({});", self.text(item)),
            Statement::Size { name, list } => format!("std::size_t {name} = {list}.size();"),
            Statement::Gather { ty, name, indices, item } => {
                return self.gather(&self.ty(*ty), name, indices, &self.text(item));
            }
            Statement::IndexLoop { indices, body } => {
                return self.held(&index_loop_head(indices), body);
            }
            Statement::Choose { condition, then, otherwise } => {
                let condition = self.text(condition);
                return match otherwise.as_slice() {
                    [] => self.held(&format!("if ({condition})"), then),
                    _ => self.branches(&condition, [then, otherwise]),
                };
            }
            Statement::Repeat { index, count, body } => {
                let count = self.text(count);
                let head = format!("for (long long {index} = {count}; {index} > 0; --{index})");
                return self.held(&head, body);
            }
            Statement::While { condition, body } => {
                return self.held(&format!("while ({})", self.text(condition)), body);
            }
            Statement::For { variable, around, element, may_go, filter, body } => {
                let all = self.all_around(*around, element);
                let Parameter { name, ty, .. } = variable;
                let gone = may_go.then(|| format!("!journal.lives({name})"));
                let skipped = skipped(self, gone, filter.as_ref());
                let head = format!("for ({} {name} : {all})", self.ty(*ty));
                return self.visit(&head, &skipped, body);
            }
            Statement::Update { visit, held } => return self.update(visit, held),
            Statement::Defer { list, element, value } => {
                format!("{list}.emplace_back({}, {});", self.text(element), self.text(value))
            }
            Statement::Break => "break;".into(),
            Statement::Continue => "continue;".into(),
            Statement::Walk { walk, body } => return self.walk(walk, body),
            Statement::Preview { preview, body } => return self.preview_block(preview, body),
            Statement::New { kind, name } => {
                format!("{} {name} = {};", self.ty(type_of(*kind)), self.allocated(*kind))
            }
            Statement::NewEach { kind, name, indices } => {
                let (ty, call) = (self.ty(type_of(*kind)), self.allocated(*kind));
                return self.gather(&ty, name, indices, &call);
            }
            Statement::Set { pointer, of, value } => {
                match self.style.write(&self.whole(of), *pointer, &self.text(value)) {
                    Some(write) => format!("{write};"),
                    None => return,
                }
            }
            Statement::SetHole { face, hole } => {
                format!("{};", self.style.put(&self.whole(face), "boundary", &hole.to_string()))
            }
            Statement::SetPosition { vertex, value } => {
                format!("{};", self.style.put(&self.whole(vertex), "position", &self.text(value)))
            }
            Statement::SetAttribute { attribute, element, value } => {
                let field = self.style.attribute(&self.whole(element), &attribute.name);
                format!("{field} = {};", self.text(value))
            }
            Statement::Erase { kind, element } => {
                let element = self.text(element);
                match self.is_noted {
                    true => format!("journal.erase({element});"),
                    false => format!("{};", self.style.erase(*kind, &element)),
                }
            }
            Statement::Return { value: Some(value) } => format!("return {};", self.text(value)),
            Statement::Return { value: None } => self.applied.into(),
            Statement::Variable { place, value } => self.put(place, &self.text(value)),
            Statement::MustCall { call, place } => self.must(call, place.as_ref()),
            Statement::TryCall { call } => format!("{};", self.call_of(call)),
            Statement::Apply { call, place, then, otherwise } => {
                return self.apply(call, place.as_ref(), [then, otherwise]);
            }
            Statement::Move { vertex, value, .. } => {
                format!("journal.set_position({}, {});", self.text(vertex), self.text(value))
            }
            Statement::Journal(elements) => return self.keep(elements),
            Statement::JournalAttribute { attribute, element } => {
                self.keep_attribute(attribute, element)
            }
        };
        self.lines.line(&line);
    }

    /// A term that something is selected of.
    pub(super) fn whole(&self, term: &Term) -> String {
        spell(self, term).at(Level::Whole)
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
        self.held_text(&index_loop_head(indices), &format!("{name}.push_back({item});"));
    }

    /// A head and its body: on one line if the body is a single short statement.
    pub(super) fn held(&mut self, head: &str, body: &[Statement]) {
        let outer = std::mem::replace(&mut self.lines, Lines::new(2));
        self.block(body);
        let text = std::mem::replace(&mut self.lines, outer).finish();
        self.held_text(head, &text);
    }

    fn held_text(&mut self, head: &str, text: &str) {
        let mut lines = text.lines();
        match (lines.next(), lines.next()) {
            (Some(only), None) if head.len() + only.len() < WIDTH => {
                self.lines.line(&format!("{head} {only}"));
            }
            (Some(_), _) => {
                self.lines.open(&format!("{head} {{"));
                text.lines().for_each(|line| self.lines.line(line));
                self.lines.close("}");
            }
            (None, _) => {}
        }
    }

    fn attempt(&mut self, kind: Kind, element: &str, halfedge: &str, body: &[Statement]) {
        self.attempts(kind, element);
        let range = match kind {
            Kind::Edge => {
                let first = self.style.chained(element, "halfedge");
                format!("{{{first}, {}}}", self.style.chained(&first, "twin"))
            }
            Kind::Vertex => self.support("spokes", vec![element.to_string()]),
            _ => self.support("halfedges", vec![element.to_string()]),
        };
        let outer = std::mem::replace(&mut self.refusal, "continue;");
        self.lines.open(&format!("for ({} {halfedge} : {range}) {{", self.ty(Type::Halfedge)));
        self.block(body);
        if matches!(body.last(), Some(Statement::Attempt { .. })) {
            self.lines.line("continue;");
        }
        self.lines.close("}");
        self.refusal = outer;
    }

    fn walk(&mut self, walk: &HalfedgeWalk, body: &[Statement]) {
        let (ty, h) = (self.ty(Type::Halfedge), &walk.halfedge);
        let head = if walk.around {
            let (name, first, whole) = match walk.step {
                Step::Clockwise => ("spokes", Pointer::VertexHalfedge, Pointer::Vertex),
                Step::Next => ("halfedges", Pointer::FaceHalfedge, Pointer::Face),
            };
            let of = match &walk.from {
                Term::Follow(pointer, of) if *pointer == first => self.text(of),
                from => self.text(&from.clone().follow(whole)),
            };
            format!("for ({ty} {h} : {})", self.support(name, vec![of]))
        } else {
            let step = Term::name(h);
            let step = match walk.step {
                Step::Next => step.follow(Pointer::Next),
                Step::Clockwise => step.follow(Pointer::Twin).follow(Pointer::Next),
            };
            let (from, until) = (self.text(&walk.from), self.whole(&walk.until));
            format!("for ({ty} {h} = {from}; {h} != {until}; {h} = {})", self.text(&step))
        };
        self.held(&head, body);
    }
}

/// The head of a loop over the indices.
fn index_loop_head(indices: &IndexLoop) -> String {
    let IndexLoop { index, size } = indices;
    format!("for (std::size_t {index} = 0; {index} < {size}; ++{index})")
}
