//! The statements that only steps and functions have, and the columns of attributes.

use super::Printer;
use super::statement::{WIDTH, bare};
use crate::diagram::Type;
use crate::emit::names::invoked;
use crate::emit::routine::{Call, Called, Form, Held, Statement, Target};
use crate::emit::term::{Attribute, Parameter, Term};

impl Printer<'_> {
    /// The call of an operation, or of a function that changes the mesh.
    pub(super) fn call_of(&self, call: &Call) -> String {
        let args = call.args.iter().map(|arg| format!(", {}", self.text(arg))).collect::<String>();
        let name = match (self.style, call.of) {
            (None, Called::Operation | Called::Plain) => call.name.clone(),
            _ => invoked(&call.name),
        };
        say!(self, "{name}(mesh{args})", "hedgerow::{name}(journal{args})")
    }

    /// The condition that a called operation applies, or else that it refuses.
    pub(super) fn outcome_of(&self, call: &Call, applies: bool) -> String {
        let text = self.call_of(call);
        match (self.style, call.of, applies) {
            (None, Called::Operation, true) => format!("{text}.is_some()"),
            (None, Called::Operation, false) => format!("{text}.is_none()"),
            (_, _, true) => text,
            (_, _, false) => format!("!{text}"),
        }
    }

    /// Calls what must succeed.
    pub(super) fn must(&mut self, call: &Call, place: Option<&Target>) {
        let text = self.call_of(call);
        let text = match (self.style, call.of) {
            (None, Called::Plain) => {
                self.lines.open(&format!("if !{text} {{"));
                self.lines.line(self.refusal);
                return self.lines.close("}");
            }
            (None, Called::Operation | Called::Refusing) => format!("{text}?"),
            (Some(_), Called::Operation | Called::Plain) => format!("hedgerow::must({text})"),
            _ => text,
        };
        self.lines.line(&match place {
            None => format!("{text};"),
            Some(place) => self.put(place, &text),
        });
    }

    /// Calls an operation, and branches on whether it applied.
    pub(super) fn apply(
        &mut self,
        call: &Call,
        place: Option<&Parameter>,
        [then, otherwise]: [&[Statement]; 2],
    ) {
        let Some(Parameter { name, ty, .. }) = place else {
            return match then {
                [] if otherwise.is_empty() => self.lines.line(&(self.call_of(call) + ";")),
                [] => self.branches(&self.outcome_of(call, false), [otherwise, &[]]),
                _ => self.branches(&self.outcome_of(call, true), [then, otherwise]),
            };
        };
        let text = self.call_of(call);
        if self.style.is_none() {
            return self.branches(&format!("let Some({name}) = {text}"), [then, otherwise]);
        }
        let ty = self.ty(*ty);
        self.lines.open(&format!("if (auto made_{name} = {text}) {{"));
        self.lines.line(&format!("{ty} {name} = *made_{name};"));
        self.block(then);
        self.otherwise(otherwise);
        self.lines.close("}");
    }

    /// The assignment of a value to a variable.
    pub(super) fn put(&self, place: &Target, value: &str) -> String {
        let Target { name, ty: of, form } = place;
        let ty = self.ty(*of);
        let bare = bare(value);
        // The type of a plain number would be ambiguous in Rust.
        let told = match of {
            Type::Int | Type::Real if value.parse::<f64>().is_ok() => format!(": {ty}"),
            _ => String::new(),
        };
        match form {
            Form::Known => say!(self, "{name} = {bare};", "{name} = {value};"),
            Form::Fixed => say!(self, "let {name}{told} = {bare};", "{ty} {name} = {value};"),
            Form::Changing => {
                say!(self, "let mut {name}{told} = {bare};", "{ty} {name} = {value};")
            }
        }
    }

    /// A loop whose writes are deferred.
    pub(super) fn update(&mut self, visit: &Statement, held: &[Held]) {
        for Held { list, element, ty, .. } in held {
            let (element, ty) = (self.ty(*element), self.ty(*ty));
            let line = say!(
                self,
                "let mut {list} = Vec::new();",
                "std::vector<std::pair<{element}, {ty}>> {list};"
            );
            self.lines.line(&line);
        }
        self.statement(visit);
        held.iter().for_each(|held| self.release(held));
    }

    /// Performs the deferred writes.
    fn release(&mut self, Held { list, attribute, .. }: &Held) {
        let head = say!(
            self,
            "for (element, value) in {list}",
            "for (const auto& [element, value] : {list})"
        );
        let text = match (self.style, attribute) {
            (None, None) => "mesh.set_position(element, finite(value)?);".to_string(),
            (None, Some(Attribute { column, .. })) => {
                format!("set_attribute(mesh, {column}, element.0, value);")
            }
            (Some(_), None) => "journal.set_position(element, value);".into(),
            (Some(_), Some(attribute)) => {
                let [of, back] = ["element", "at"].map(|of| self.attribute(attribute, of));
                format!(
                    "journal.undone_by([at = element, was = {of}] {{ {back} = was; }});\n{of} = value;"
                )
            }
        };
        self.held_text(&head, &text);
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

    /// A note of the value of an attribute in the journal.
    pub(super) fn keep_attribute(&self, attribute: &Attribute, element: &Term) -> String {
        let of = self.whole(element);
        let was = self.attribute(attribute, &of);
        let (capture, name) = match element {
            Term::Name(name) => (name.clone(), name.as_str()),
            _ => (format!("at = {of}"), "at"),
        };
        let back = self.attribute(attribute, name);
        format!("journal.undone_by([{capture}, was = {was}] {{ {back} = was; }});")
    }

    /// Finds the column of an attribute, and refuses a mesh without it.
    pub(super) fn column(&mut self, attribute: &Attribute) {
        let (column, found, ty) = (&attribute.column, found(attribute), self.ty(attribute.ty));
        if self.is_asked {
            let line = format!("let {column} = {found}.expect(\"the caller has found it\");");
            return self.lines.line(&line);
        }
        self.lines.line(&format!("let {column} = {found};"));
        let head = format!(
            "let Some({column}) = {column}.filter(|&c| mesh.values::<{ty}>(c).is_some()) else {{"
        );
        self.refused(&head, &missing(attribute), "};");
    }

    /// Refuses a mesh without an attribute.
    pub(super) fn ask(&mut self, attribute: &Attribute) {
        let (found, ty) = (found(attribute), self.ty(attribute.ty));
        let head = format!("if {found}.and_then(|c| mesh.values::<{ty}>(c)).is_none() {{");
        self.refused(&head, &missing(attribute), "}");
    }
}

/// The search for the column of an attribute.
fn found(attribute: &Attribute) -> String {
    let (declared, kind) = (&attribute.declared, attribute.element);
    format!("mesh.find_column(ElementKind::{kind:?}, \"{declared}\")")
}

/// The reason to refuse a mesh without an attribute.
fn missing(attribute: &Attribute) -> String {
    format!("the mesh has no attribute `{}` of this type", attribute.declared)
}
