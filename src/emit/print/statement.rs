//! Statements as text.

use super::Printer;
use super::lines::comment;
use super::spelled::{Level, unique};
use super::support::names;
use crate::diagram::{Kind, Pointer, Type};
use crate::emit::routine::{Field, Statement, type_of};
use crate::emit::term::{IndexLoop, Parameter, Term};
use crate::emit::walks::{HalfedgeWalk, Step};

/// The maximum length of a line in C++.
pub(super) const WIDTH: usize = 92;

impl Printer<'_> {
    pub fn block(&mut self, body: &[Statement]) {
        body.iter().for_each(|statement| self.statement(statement));
    }

    pub(super) fn statement(&mut self, statement: &Statement) {
        let line = match statement {
            Statement::Comment(text) => return self.lines.comment("//", text),
            Statement::Blank => return self.lines.blank(),
            Statement::Column(attribute) => return self.column(attribute),
            Statement::RequireColumn(attribute) => return self.ask(attribute),
            Statement::Bind { ty, name, value, is_list } => {
                let (ty, value) = (self.ty(*ty), self.text(value));
                let ty = if *is_list { format!("std::vector<{ty}>") } else { ty };
                say!(self, "let {name} = {value};", "{ty} {name} = {value};")
            }
            Statement::Attempt { kind, element, halfedge, body } => {
                return self.attempt(*kind, element, halfedge, body);
            }
            Statement::Refuse { when, reason } => return self.refuse(when, reason),
            Statement::List { ty, name, items } => {
                let (ty, items) = (self.ty(*ty), self.texts(items).join(", "));
                match items.as_str() {
                    "" => say!(
                        self,
                        "let mut {name}: Vec<{ty}> = Vec::new();",
                        "std::vector<{ty}> {name};"
                    ),
                    items => say!(
                        self,
                        "let mut {name}: Vec<{ty}> = vec![{items}];",
                        "std::vector<{ty}> {name} = {{{items}}};"
                    ),
                }
            }
            Statement::Push { list, item } => {
                let item = self.text(item);
                say!(self, "{list}.push({item});", "{list}.push_back({item});")
            }
            Statement::Size { name, list } => {
                say!(self, "let {name} = {list}.len();", "std::size_t {name} = {list}.size();")
            }
            Statement::Gather { ty, name, indices, item } => {
                let (ty, item) = (self.ty(*ty), self.text(item));
                return self.gather((&ty, name), indices, &item);
            }
            Statement::IndexLoop { indices, body } => {
                let head = self.index_loop(indices);
                return self.held(&head, body);
            }
            Statement::Choose { condition, then, otherwise } => {
                return self.branches(&self.text(condition), [then, otherwise]);
            }
            Statement::Repeat { index, count, body } => {
                let count = self.text(count);
                let head = say!(
                    self,
                    "for _ in 0..{count}",
                    "for (long long {index} = {count}; {index} > 0; --{index})"
                );
                return self.held(&head, body);
            }
            Statement::While { condition, body } => {
                let condition = self.text(condition);
                return self.held(&say!(self, "while {condition}", "while ({condition})"), body);
            }
            Statement::For { variable, around, element, may_go, filter, body } => {
                let all = self.all_around(around, element);
                let Parameter { name, ty, .. } = variable;
                let (word, ty) = (ty.word(), self.ty(*ty));
                let gone = may_go
                    .then(|| say!(self, "!mesh.{word}_alive({name})", "!journal.lives({name})"));
                let skipped = self.skipped(gone, filter.as_ref());
                let head = say!(
                    self,
                    "for {name} in {all}.collect::<Vec<_>>()",
                    "for ({ty} {name} : {all})"
                );
                return self.visit(&head, skipped, body);
            }
            Statement::Update { visit, held } => return self.update(visit, held),
            Statement::Defer { list, element, value } => {
                let (element, value) = (self.text(element), self.bare(value));
                say!(
                    self,
                    "{list}.push(({element}, {value}));",
                    "{list}.emplace_back({element}, {value});"
                )
            }
            Statement::Break => "break;".into(),
            Statement::Continue => "continue;".into(),
            Statement::Walk { walk, body } => return self.walk(walk, body),
            Statement::Preview { preview, body } => return self.previewed(preview, body),
            Statement::New { kind, name, indices } => {
                let ty = match (self.style, &self.preview) {
                    (None, _) => "_".to_string(),
                    (Some(_), None) => self.ty(type_of(*kind)),
                    (Some(_), Some(_)) => format!("hedgerow::Preview::Seen{:?}", type_of(*kind)),
                };
                let new = self.new_element(*kind);
                match indices {
                    Some(indices) => return self.gather((&ty, name), indices, &new),
                    None if self.preview.is_some() => {
                        say!(self, "let {name} = {new};", "auto {name} = {new};")
                    }
                    None => say!(self, "let {name} = {new};", "{ty} {name} = {new};"),
                }
            }
            Statement::Set { field, of, value } => self.set(field, of, &self.text(value)),
            Statement::Erase { kind, element } => {
                let (word, element) = (kind.word(), self.text(element));
                match self.style {
                    None => format!("mesh.erase_{word}({element});"),
                    Some(_) if self.is_noted => format!("journal.erase({element});"),
                    Some(style) => style.erase(*kind, &element) + ";",
                }
            }
            Statement::Return { value } => match self.returned(value.as_ref()).as_str() {
                "" => "return;".into(),
                value => format!("return {value};"),
            },
            Statement::Variable { place, value } => self.put(place, &self.text(value)),
            Statement::MustCall { call, place } => return self.must(call, place.as_ref()),
            Statement::Apply { call, place, then, otherwise } => {
                return self.apply(call, place.as_ref(), [then, otherwise]);
            }
            Statement::Move { vertex, value, is_finite } => {
                let (vertex, value) = (self.text(vertex), self.text(value));
                let checked = match is_finite {
                    true => value.clone(),
                    false => format!("finite({value})?"),
                };
                say!(
                    self,
                    "mesh.set_position({vertex}, {checked});",
                    "journal.set_position({vertex}, {value});"
                )
            }
            Statement::Journal(elements) => return self.keep(elements),
            Statement::JournalAttribute { attribute, element } => {
                self.keep_attribute(attribute, element)
            }
        };
        self.lines.line(&line);
    }

    fn set(&self, field: &Field, of: &Term, value: &str) -> String {
        let (spelled, told) = match field {
            Field::Pointer(pointer) => (pointer.word(), unique(*pointer)),
            Field::Hole => ("boundary", "hole"),
            Field::Position => ("position", "position"),
            Field::Attribute(attribute) => {
                let column = &attribute.column;
                return match self.style {
                    None => format!("set_attribute(mesh, {column}, {}.0, {value});", self.text(of)),
                    Some(_) => format!("{} = {value};", self.attribute(attribute, &self.whole(of))),
                };
            }
        };
        match (self.style, self.preview.as_deref()) {
            (Some(style), None) => style.put(&self.whole(of), spelled, value) + ";",
            (_, preview) => {
                let mesh = preview.unwrap_or("mesh");
                format!("{mesh}.set_{told}({}, {value});", self.text(of))
            }
        }
    }

    /// The value that is returned; empty for none.
    pub fn returned(&self, value: Option<&Term>) -> String {
        match value {
            Some(value) if self.wraps => format!("Some({})", self.text(value)),
            Some(value) => self.text(value),
            None => self.applied.clone(),
        }
    }

    /// A value that is used alone, without brackets around all of it.
    pub(super) fn bare(&self, value: &Term) -> String {
        bare(&self.text(value)).to_string()
    }

    /// The condition under which an element is skipped: it is gone, or a filter rejects it.
    fn skipped(&self, gone: Option<String>, filter: Option<&Term>) -> Option<String> {
        let level = if gone.is_some() { Level::Or } else { Level::Choice };
        let others = filter.map(|filter| self.spell(&filter.clone().not()).at(level));
        let all: Vec<_> = gone.into_iter().chain(others).collect();
        (!all.is_empty()).then(|| all.join(" || "))
    }

    /// A loop over elements, some of which are skipped.
    fn visit(&mut self, head: &str, skipped: Option<String>, body: &[Statement]) {
        let Some(skipped) = skipped else {
            return self.held(head, body);
        };
        self.lines.open(&format!("{head} {{"));
        self.branches(&skipped, [&[Statement::Continue], &[]]);
        self.block(body);
        self.lines.close("}");
    }

    /// The call that allocates an element.
    fn new_element(&self, kind: Kind) -> String {
        let word = kind.word();
        match (self.style, &self.preview) {
            (None, preview) => format!("{}.add_{word}()", preview.as_deref().unwrap_or("mesh")),
            (Some(_), Some(preview)) => format!("{preview}.new_{word}()"),
            (Some(_), None) if self.is_noted => format!("journal.new_{word}()"),
            (Some(style), None) => style.allocate(kind),
        }
    }

    /// A list of one item for each index.
    fn gather(&mut self, (ty, name): (&str, &str), indices: &IndexLoop, item: &str) {
        if self.style.is_some() {
            self.lines.line(&format!("std::vector<{ty}> {name};"));
            let head = self.index_loop(indices);
            return self.held_text(&head, &format!("{name}.push_back({item});"));
        }
        let IndexLoop { index, size } = indices;
        let index = if names(item, index) { index } else { "_" };
        self.lines
            .line(&format!("let {name}: Vec<{ty}> = (0..{size}).map(|{index}| {item}).collect();"));
    }

    /// The head of a loop over the indices.
    fn index_loop(&self, IndexLoop { index, size }: &IndexLoop) -> String {
        say!(
            self,
            "for {index} in 0..{size}",
            "for (std::size_t {index} = 0; {index} < {size}; ++{index})"
        )
    }

    /// A head and its body: in C++ on one line if the body is a single short statement.
    pub(super) fn held(&mut self, head: &str, body: &[Statement]) {
        let text = self.apart(|this| this.block(body));
        self.held_text(head, &text);
    }

    pub(super) fn held_text(&mut self, head: &str, text: &str) {
        let mut lines = text.lines();
        match (lines.next(), lines.next()) {
            (Some(only), None) if self.style.is_some() && head.len() + only.len() < WIDTH => {
                self.lines.line(&format!("{head} {only}"));
            }
            (None, _) if self.style.is_some() => {}
            _ => {
                self.lines.open(&format!("{head} {{"));
                self.lines.add(text);
                self.lines.close("}");
            }
        }
    }

    /// An `if`, with an `else` if there is something in it.
    pub(super) fn branches(&mut self, condition: &str, [then, otherwise]: [&[Statement]; 2]) {
        let head = self.if_head(condition);
        if otherwise.is_empty() {
            return self.held(&head, then);
        }
        self.lines.open(&format!("{head} {{"));
        self.block(then);
        self.otherwise(otherwise);
        self.lines.close("}");
    }

    /// The beginning of a line, up to the brace.
    fn if_head(&self, condition: &str) -> String {
        say!(self, "if {condition}", "if ({condition})")
    }

    /// The other branches of an `if`.
    pub(super) fn otherwise(&mut self, otherwise: &[Statement]) {
        let chained = match otherwise {
            [] => return,
            [Statement::Choose { condition, then, otherwise }] => {
                Some((self.text(condition), [then, otherwise]))
            }
            [Statement::Apply { call, place: None, then, otherwise }] if !then.is_empty() => {
                Some((self.outcome_of(call, true), [then, otherwise]))
            }
            _ => None,
        };
        match chained {
            Some((condition, [then, otherwise])) => {
                let head = self.if_head(&condition);
                self.lines.reopen(&format!("}} else {head} {{"));
                self.block(then);
                self.otherwise(otherwise);
            }
            None => {
                self.lines.reopen("} else {");
                self.block(otherwise);
            }
        }
    }

    /// Refuses if a condition holds.
    fn refuse(&mut self, when: &Term, reason: &str) {
        let (refusal, when) = (self.refusal, self.text(when));
        let reason_behind = comment("//", reason);
        let is_sure = when == "true" && (self.style.is_none() || self.is_noted);
        if is_sure {
            let line = say!(self, "{refusal} {reason_behind}", "{refusal}  {reason_behind}");
            return self.lines.line(&line);
        }
        if self.style.is_none() {
            return self.refused(&format!("if {when} {{"), reason, "}");
        }
        let line = format!("if ({when}) {refusal}");
        if line.len() + reason.len() < WIDTH {
            return self.lines.line(&format!("{line}  {reason_behind}"));
        }
        self.lines.comment("//", &format!("Refused: {reason}."));
        self.lines.line(&line);
    }

    /// Refuses in a block, in Rust.
    pub(super) fn refused(&mut self, head: &str, reason: &str, end: &str) {
        self.lines.open(head);
        self.lines.line(&format!("{} {}", self.refusal, comment("//", reason)));
        self.lines.close(end);
    }

    /// Attempts with the halfedges of an element in turn.
    fn attempt(&mut self, kind: Kind, element: &str, halfedge: &str, body: &[Statement]) {
        self.lines.line(&match kind {
            Kind::Edge => format!("// Both directions of {element} are tried."),
            Kind::Vertex => format!("// Each halfedge that starts at {element} is tried."),
            _ => format!("// Each halfedge of {element} is tried."),
        });
        let element = Term::name(element);
        let range = match kind {
            Kind::Edge => {
                let first = element.follow(Pointer::EdgeHalfedge);
                let both = self.texts(&[first.clone(), first.follow(Pointer::Twin)]).join(", ");
                say!(self, "[{both}]", "{{{both}}}")
            }
            kind => {
                let around = match kind {
                    Kind::Vertex => "VertexHalfedges",
                    _ => "FaceHalfedges",
                };
                let all = self.all_around(around, &element);
                say!(self, "{all}.collect::<Vec<_>>()", "{all}")
            }
        };
        let ty = self.ty(Type::Halfedge);
        let head = say!(self, "for {halfedge} in {range}", "for ({ty} {halfedge} : {range})");
        let outer = std::mem::replace(&mut self.refusal, "continue;");
        self.held(&head, body);
        self.refusal = outer;
    }

    fn walk(&mut self, walk: &HalfedgeWalk, body: &[Statement]) {
        let (ty, h) = (self.ty(Type::Halfedge), &walk.halfedge);
        let from = self.text(&walk.from);
        if walk.around {
            let (rust, cpp, first, whole) = match walk.step {
                Step::Clockwise => {
                    ("spokes_from", "spokes", Pointer::VertexHalfedge, Pointer::Vertex)
                }
                Step::Next => ("loop_from", "halfedges", Pointer::FaceHalfedge, Pointer::Face),
            };
            let of = match &walk.from {
                Term::Follow(pointer, of) if *pointer == first => self.text(of),
                from => self.text(&from.clone().follow(whole)),
            };
            let head = say!(
                self,
                "for {h} in mesh.{rust}({from}).collect::<Vec<_>>()",
                "for ({ty} {h} : hedgerow::{cpp}({of}))"
            );
            return self.held(&head, body);
        }
        let next = match walk.step {
            Step::Next => Term::name(h).follow(Pointer::Next),
            Step::Clockwise => Term::name(h).follow(Pointer::Twin).follow(Pointer::Next),
        };
        let (until, next) = (self.of(&walk.until), self.text(&next));
        if self.style.is_some() {
            let head = format!("for ({ty} {h} = {from}; {h} != {until}; {h} = {next})");
            return self.held(&head, body);
        }
        self.lines.line(&format!("let mut {h} = {from};"));
        self.lines.open(&format!("while {h} != {until} {{"));
        self.block(body);
        self.lines.line(&format!("{h} = {next};"));
        self.lines.close("}");
    }

    /// Writes a preview, and the block that looks at it.
    fn previewed(&mut self, preview: &str, body: &[Statement]) {
        if self.style.is_some() {
            self.lines.blank();
        }
        self.lines
            .comment("//", "The guard looks at what there would be, on a preview of the mesh.");
        self.lines.open("{");
        let line =
            say!(self, "let mut {preview} = Preview::new(mesh);", "hedgerow::Preview {preview};");
        self.lines.line(&line);
        let outer = self.preview.replace(preview.to_string());
        self.block(body);
        self.preview = outer;
        self.lines.close("}");
    }
}

/// A value that is used alone, without brackets around all of it.
pub(in crate::emit) fn bare(value: &str) -> &str {
    let inner = value.strip_prefix('(').and_then(|it| it.strip_suffix(')'));
    let Some(inner) = inner else {
        return value;
    };
    let mut depth = 0;
    let closes = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth < 0
    };
    match inner.chars().any(closes) {
        true => value,
        false => inner,
    }
}
