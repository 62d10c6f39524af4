//! The statements as Rust that only steps and functions have.

use super::super::language::Language;
use super::super::names::invoked;
use super::super::routine::{Call, Called, Form, Held, Statement, Target};
use super::super::statement::Printing;
use super::super::term::{Attribute, Parameter};
use super::function::{Printer, ty};
use crate::diagram::Type;

impl Printer {
    /// Calls an operation, and branches on whether it applied.
    pub(super) fn apply(
        &mut self,
        call: &Call,
        place: Option<&Parameter>,
        [then, otherwise]: [&[Statement]; 2],
    ) {
        let text = self.called(call);
        let condition = match (place, call.of, then.is_empty()) {
            (Some(Parameter { name, .. }), ..) => format!("let Some({name}) = {text}"),
            (None, Called::Plain, true) => format!("!{text}"),
            (None, Called::Plain, false) => text,
            (None, _, true) => format!("{text}.is_none()"),
            (None, _, false) => format!("{text}.is_some()"),
        };
        match place.is_none() && then.is_empty() {
            true => self.branches(&condition, [otherwise, &[]]),
            false => self.branches(&condition, [then, otherwise]),
        }
    }

    /// A loop over elements, some of which are skipped.
    pub(super) fn visit(&mut self, head: &str, skipped: &[String], body: &[Statement]) {
        self.lines.open(head);
        if !skipped.is_empty() {
            self.lines.open(&format!("if {} {{", skipped.join(" || ")));
            self.lines.line("continue;");
            self.lines.close("}");
        }
        self.block(body);
        self.lines.close("}");
    }

    /// A loop whose writes are deferred.
    pub(super) fn update(&mut self, visit: &Statement, held: &[Held]) {
        for Held { list, .. } in held {
            self.lines.line(&format!("let mut {list} = Vec::new();"));
        }
        self.statement(visit);
        held.iter().for_each(|held| self.release(held));
    }

    /// Finds the column of an attribute, and refuses a mesh without it.
    pub(super) fn column(&mut self, attribute: &Attribute) {
        let (column, found, ty) = (&attribute.column, found(attribute), ty(attribute.ty));
        if self.is_asked {
            let line = format!("let {column} = {found}.expect(\"the caller has found it\");");
            return self.lines.line(&line);
        }
        self.lines.line(&format!("let {column} = {found};"));
        let head = format!(
            "let Some({column}) = {column}.filter(|&c| mesh.values::<{ty}>(c).is_some()) else {{"
        );
        self.refuse(&head, &missing(attribute), "};");
    }

    /// Refuses a mesh without an attribute.
    pub(super) fn ask(&mut self, attribute: &Attribute) {
        let (found, ty) = (found(attribute), ty(attribute.ty));
        let head = format!("if {found}.and_then(|c| mesh.values::<{ty}>(c)).is_none() {{");
        self.refuse(&head, &missing(attribute), "}");
    }

    /// Performs the deferred writes.
    fn release(&mut self, held: &Held) {
        self.lines.open(&format!("for (element, value) in {} {{", held.list));
        self.lines.line(&match &held.attribute {
            None => "mesh.set_position(element, finite(value)?);".to_string(),
            Some(attribute) => {
                format!("set_attribute(mesh, {}, element.0, value);", attribute.column)
            }
        });
        self.lines.close("}");
    }

    pub(super) fn must(&mut self, call: &Call, place: Option<&Target>) {
        let text = self.called(call);
        let (text, end) = match call.of {
            Called::Plain => {
                self.lines.open(&format!("if !{text} {{"));
                self.lines.line(self.refusal);
                return self.lines.close("}");
            }
            Called::Sure => (text, ""),
            Called::Operation | Called::Refusing => (text, "?"),
        };
        self.lines.line(&match place {
            None => format!("{text}{end};"),
            Some(place) => self.put(place, &format!("{text}{end}")),
        });
    }

    pub(super) fn put(&self, place: &Target, value: &str) -> String {
        let Target { name, ty: of, form } = place;
        // The type of a plain number would be ambiguous.
        let of = match of {
            Type::Int | Type::Real if value.parse::<f64>().is_ok() => format!(": {}", ty(*of)),
            _ => String::new(),
        };
        let value = bare(value);
        match form {
            Form::Fixed => format!("let {name}{of} = {value};"),
            Form::Changing => format!("let mut {name}{of} = {value};"),
            Form::Known => format!("{name} = {value};"),
        }
    }

    /// The call of an operation, or of a function that changes the mesh.
    pub(super) fn called(&self, call: &Call) -> String {
        let args = call.args.iter().map(|arg| format!(", {}", self.text(arg)));
        let args = args.collect::<String>();
        let name = match call.of {
            Called::Operation | Called::Plain => call.name.clone(),
            Called::Refusing | Called::Sure => invoked(&call.name),
        };
        format!("{name}(mesh{args})")
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

/// A value that is used alone, without brackets around all of it.
pub(super) fn bare(value: &str) -> &str {
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
