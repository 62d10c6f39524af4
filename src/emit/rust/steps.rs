//! Operations in steps as Rust, and the statements that only steps and functions have.

use super::super::names::invoked;
use super::super::routine::Statement;
use super::super::term::{Attribute, Parameter, Term};
use super::super::whole::{Call, Called, Form, Held, Target, Whole};
use super::function::{Printer, kind, ty};
use crate::diagram::{self, Type};

impl Printer {
    /// Writes an operation in steps, which the mesh's own journal can undo.
    pub(super) fn whole(&mut self, whole: &Whole, visible: &str) {
        self.docs(&whole.signature.docs, &whole.signature.name, &whole.signature.params);
        self.allow(&whole.body, &whole.signature.params);
        let params = whole.signature.params.iter();
        let params = params.map(|param| format!(", {}: {}", param.name, ty(param.ty)));
        let params = params.collect::<String>();
        let result = whole.signature.result.map(ty);
        let result = result.map_or("bool".into(), |result| format!("Option<{result}>"));
        let name = &whole.signature.name;
        self.lines.open(&format!("{visible} {name}(mesh: &mut Mesh{params}) -> {result} {{"));
        self.refusal = match whole.signature.result {
            Some(_) => "return None;",
            None => "return false;",
        };
        self.block(&whole.asks);
        let level = match whole.level {
            diagram::Level::Map => "Map",
            diagram::Level::Surface => "Surface",
            diagram::Level::Simple => "Simple",
        };
        self.lines.open(&format!("all_or_nothing(mesh, Level::{level}, |mesh| {{"));
        (self.refusal, self.applied) = ("return None;", "Some(())");
        let (last, others) = match whole.body.split_last() {
            Some((Statement::Return { result }, others)) => (Some(result), others),
            _ => (None, whole.body.as_slice()),
        };
        self.block(others);
        if let Some(result) = last {
            let result = result.as_ref().map(|result| self.text(result));
            let result = result.unwrap_or("()".into());
            self.lines.line(&format!("Some({result})"));
        }
        self.applied = "true";
        self.lines.close(match whole.signature.result {
            Some(_) => "})",
            None => "}).is_some()",
        });
        self.lines.close("}");
    }

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

    /// Refuses a mesh without an attribute.
    pub(super) fn ask(&mut self, attribute: &Attribute) {
        let (declared, kind) = (&attribute.declared, kind(attribute.element));
        let of = ty(attribute.ty);
        self.lines.open(&format!(
            "if mesh.find_column(ElementKind::{kind}, \"{declared}\")\
             .and_then(|c| mesh.values::<{of}>(c)).is_none() {{"
        ));
        let refusal = self.refusal;
        self.lines
            .line(&format!("{refusal} // the mesh has no attribute `{declared}` of this type"));
        self.lines.close("}");
    }

    /// Performs the deferred writes.
    fn release(&mut self, held: &Held) {
        let list = &held.list;
        self.lines.open(&format!("for (element, value) in {list} {{"));
        match &held.attribute {
            None => {
                self.lines.line("mesh.set_position(element, finite(value)?);");
            }
            Some(attribute) => {
                let column = &attribute.column;
                self.lines.line(&format!("set_attribute(mesh, {column}, element.0, value);"));
            }
        }
        self.lines.close("}");
    }

    pub(super) fn must(&mut self, call: &Call, place: Option<&Target>) {
        let text = self.called(call);
        match (call.of, place) {
            (Called::Plain, _) => {
                self.lines.open(&format!("if !{text} {{"));
                let refusal = self.refusal;
                self.lines.line(refusal);
                self.lines.close("}");
            }
            (Called::Sure, None) => self.lines.line(&format!("{text};")),
            (Called::Sure, Some(place)) => self.put(place, &text),
            (_, None) => self.lines.line(&format!("{text}?;")),
            (_, Some(place)) => self.put(place, &format!("{text}?")),
        }
    }

    pub(super) fn put(&mut self, place: &Target, value: &str) {
        let Target { name, ty: of, form } = place;
        // The type of a plain number would be ambiguous.
        let of = match of {
            Type::Int | Type::Real if value.parse::<f64>().is_ok() => format!(": {}", ty(*of)),
            _ => String::new(),
        };
        let value = bare(value);
        self.lines.line(&match form {
            Form::Fixed => format!("let {name}{of} = {value};"),
            Form::Changing => format!("let mut {name}{of} = {value};"),
            Form::Known => format!("{name} = {value};"),
        });
    }

    /// The call of an operation, or of a function that changes the mesh.
    pub(super) fn called(&mut self, call: &Call) -> String {
        let args = call.args.iter().map(|arg| format!(", {}", self.text(arg)));
        let args = args.collect::<String>();
        let name = match call.of {
            Called::Operation | Called::Plain => call.name.clone(),
            Called::Refusing | Called::Sure => invoked(&call.name),
        };
        format!("{name}(mesh{args})")
    }

    pub(super) fn held(&mut self, head: &str, body: &[Statement]) {
        self.lines.open(head);
        self.block(body);
        self.lines.close("}");
    }

    pub(super) fn branches(&mut self, condition: &str, [then, otherwise]: [&[Statement]; 2]) {
        self.lines.open(&format!("if {condition} {{"));
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
                self.lines.reopen(&format!("}} else if {condition} {{"));
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

/// True if the condition always holds.
pub(super) fn always(when: &Term) -> bool {
    *when == Term::Bool(true)
}
