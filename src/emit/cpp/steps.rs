//! Operations in steps as C++, and the statements that only steps and functions have.

use std::collections::BTreeSet;

use super::super::names::invoked;
use super::super::routine::Statement;
use super::super::term::{Attribute, Parameter, Term};
use super::super::whole::{Call, Called, Form, Held, Target, Whole};
use super::function::Printer;
use crate::diagram;

/// The maximum length of a line.
const WIDTH: usize = 92;

impl Printer<'_> {
    /// Writes an operation in steps, which runs through a journal, so that it can be undone.
    pub(super) fn whole(&mut self, whole: &Whole, alone: bool) {
        self.docs(&whole.signature.docs);
        self.docs_of_defaults(&whole.signature.params);
        let mut used = BTreeSet::from(["mesh".to_string()]);
        let mut seen: Vec<_> = whole.signature.result.into_iter().collect();
        for statement in whole.asks.iter().chain(&whole.body) {
            statement.names(&mut |name| _ = used.insert(name.to_string()));
            statement.types(&mut |ty| seen.push(ty));
        }
        self.head(&whole.signature, alone, &used, &seen);
        self.refusal = match whole.signature.result {
            Some(_) => "return std::nullopt;",
            None => "return false;",
        };
        self.block(&whole.asks);
        if !self.is_noted {
            let mesh = if self.style.is_member() { "*this" } else { "mesh" };
            self.lines.line(&format!("hedgerow::Journal journal({mesh});"));
        }
        let level = match whole.level {
            diagram::Level::Map => "map",
            diagram::Level::Surface => "surface",
            diagram::Level::Simple => "simple",
        };
        let result = match whole.signature.result {
            Some(ty) => format!("std::optional<{}>", self.ty(ty)),
            None => "bool".into(),
        };
        self.lines
            .open(&format!("return journal.whole(hedgerow::Level::{level}, [&]() -> {result} {{"));
        let outer = std::mem::replace(&mut self.is_noted, true);
        self.block(&whole.body);
        self.is_noted = outer;
        self.lines.close("});");
        self.lines.close("}");
    }

    /// Writes a call that must succeed.
    pub(super) fn must(&mut self, call: &Call, place: Option<&Target>) {
        let mut text = self.call_of(call);
        if matches!(call.of, Called::Operation | Called::Plain) {
            text = self.support("must", vec![text]);
        }
        match place {
            Some(place) => self.put(place, &text),
            None => self.lines.line(&format!("{text};")),
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
        let texts: Vec<_> = elements.iter().map(|term| self.text(term)).collect();
        let mut line = String::new();
        for text in texts {
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

    pub(super) fn keep_attribute(&mut self, attribute: &Attribute, element: &Term) {
        let of = self.spelled_whole(element);
        let was = self.style.attribute(&of, &attribute.name);
        let (capture, name) = match element {
            Term::Name(name) => (name.clone(), name.as_str()),
            _ => (format!("at = {of}"), "at"),
        };
        let back = self.style.attribute(name, &attribute.name);
        self.lines
            .line(&format!("journal.undone_by([{capture}, was = {was}] {{ {back} = was; }});"));
    }

    pub(super) fn put(&mut self, place: &Target, value: &str) {
        let Target { name, ty, form } = place;
        self.lines.line(&match form {
            Form::Known => format!("{name} = {value};"),
            Form::Fixed | Form::Changing => format!("{} {name} = {value};", self.ty(*ty)),
        });
    }

    /// The call of an operation, or of a function that changes the mesh.
    pub(super) fn call_of(&mut self, call: &Call) -> String {
        let args = call.args.iter().map(|arg| format!(", {}", self.text(arg)));
        let args = args.collect::<String>();
        format!("hedgerow::{}(journal{args})", invoked(&call.name))
    }

    pub(super) fn branches(&mut self, condition: &str, [then, otherwise]: [&[Statement]; 2]) {
        self.lines.open(&format!("if ({condition}) {{"));
        self.block(then);
        self.otherwise(otherwise);
        self.lines.close("}");
    }

    /// The other branches of an `if`.
    fn otherwise(&mut self, otherwise: &[Statement]) {
        match otherwise {
            [] => {}
            [Statement::Choose { condition, then, otherwise }] => {
                let condition = self.text(condition);
                self.lines.reopen(&format!("}} else if ({condition}) {{"));
                self.block(then);
                self.otherwise(otherwise);
            }
            [Statement::Apply { call, place: None, then, otherwise }] if !then.is_empty() => {
                let text = self.call_of(call);
                self.lines.reopen(&format!("}} else if ({text}) {{"));
                self.block(then);
                self.otherwise(otherwise);
            }
            _ => {
                self.lines.reopen("} else {");
                self.block(otherwise);
            }
        }
    }
}
