//! The statements as C++ that only steps and functions have.

use super::super::language::Language;
use super::super::names::invoked;
use super::super::routine::{Call, Called, Form, Held, Statement, Target};
use super::super::statement::Printing;
use super::super::term::{Attribute, Parameter, Term};
use super::function::Printer;
use super::statement::WIDTH;

impl Printer<'_> {
    /// A call that must succeed.
    pub(super) fn must(&self, call: &Call, place: Option<&Target>) -> String {
        let mut text = self.call_of(call);
        if matches!(call.of, Called::Operation | Called::Plain) {
            text = self.support("must", vec![text]);
        }
        match place {
            Some(place) => self.put(place, &text),
            None => format!("{text};"),
        }
    }

    /// A loop over elements, some of which are skipped.
    pub(super) fn visit(&mut self, head: &str, skipped: &[String], body: &[Statement]) {
        if skipped.is_empty() {
            return self.held(head, body);
        }
        self.lines.open(&format!("{head} {{"));
        self.lines.line(&format!("if ({}) continue;", skipped.join(" || ")));
        self.block(body);
        self.lines.close("}");
    }

    /// A loop whose writes are deferred.
    pub(super) fn update(&mut self, visit: &Statement, held: &[Held]) {
        for Held { list, element, ty, .. } in held {
            let (element, ty) = (self.ty(*element), self.ty(*ty));
            self.lines.line(&format!("std::vector<std::pair<{element}, {ty}>> {list};"));
        }
        self.statement(visit);
        held.iter().for_each(|held| self.release(held));
    }

    /// Performs the deferred writes.
    fn release(&mut self, held: &Held) {
        let head = format!("for (const auto& [element, value] : {})", held.list);
        let Some(attribute) = &held.attribute else {
            let line = format!("{head} journal.set_position(element, value);");
            return self.lines.line(&line);
        };
        let [of, back] = ["element", "at"].map(|name| self.style.attribute(name, &attribute.name));
        self.lines.open(&format!("{head} {{"));
        self.lines
            .line(&format!("journal.undone_by([at = element, was = {of}] {{ {back} = was; }});"));
        self.lines.line(&format!("{of} = value;"));
        self.lines.close("}");
    }

    pub(super) fn apply(
        &mut self,
        call: &Call,
        place: Option<&Parameter>,
        [then, otherwise]: [&[Statement]; 2],
    ) {
        let text = self.call_of(call);
        match (place, then, otherwise) {
            (Some(Parameter { name, ty, .. }), ..) => {
                let ty = self.ty(*ty);
                self.lines.open(&format!("if (auto made_{name} = {text}) {{"));
                self.lines.line(&format!("{ty} {name} = *made_{name};"));
                self.block(then);
                self.otherwise(otherwise);
                self.lines.close("}");
            }
            (None, [], _) => self.held(&format!("if (!{text})"), otherwise),
            (None, _, []) => self.held(&format!("if ({text})"), then),
            _ => self.branches(&text, [then, otherwise]),
        }
    }

    /// Notes elements in the journal, on as many lines as needed.
    pub(super) fn keep(&mut self, elements: &[Term]) {
        let mut line = String::new();
        for text in self.texts(elements) {
            if !line.is_empty() && line.len() + text.len() > WIDTH - 16 {
                self.lines.line(&format!("journal.keep({line});"));
                line.clear();
            }
            if !line.is_empty() {
                line.push_str(", ");
            }
            line.push_str(&text);
        }
        self.lines.line(&format!("journal.keep({line});"));
    }

    pub(super) fn keep_attribute(&self, attribute: &Attribute, element: &Term) -> String {
        let of = self.whole(element);
        let was = self.style.attribute(&of, &attribute.name);
        let (capture, name) = match element {
            Term::Name(name) => (name.clone(), name.as_str()),
            _ => (format!("at = {of}"), "at"),
        };
        let back = self.style.attribute(name, &attribute.name);
        format!("journal.undone_by([{capture}, was = {was}] {{ {back} = was; }});")
    }

    pub(super) fn put(&self, place: &Target, value: &str) -> String {
        let Target { name, ty, form } = place;
        match form {
            Form::Known => format!("{name} = {value};"),
            Form::Fixed | Form::Changing => format!("{} {name} = {value};", self.ty(*ty)),
        }
    }

    /// The call of an operation, or of a function that changes the mesh.
    pub(super) fn call_of(&self, call: &Call) -> String {
        let args = call.args.iter().map(|arg| format!(", {}", self.text(arg)));
        format!("hedgerow::{}(journal{})", invoked(&call.name), args.collect::<String>())
    }
}
