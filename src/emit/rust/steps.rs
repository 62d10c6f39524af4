//! Operations in steps as Rust, and what only steps and functions do.

use super::super::action::{Action, Call, Called, Form, Held, Target, Whole};
use super::super::language::{Level, spell};
use super::super::names::invoked;
use super::super::routine::Statement;
use super::super::term::{Parameter, Term};
use super::function::{Printer, ty};
use crate::diagram::{self, Type};

impl Printer {
    /// Writes an operation in steps: the mesh's own journal undoes them.
    pub(super) fn whole(&mut self, whole: &Whole, visible: &str) {
        self.docs(&whole.docs, &whole.name, &whole.params);
        self.allow(&whole.body, &whole.params);
        let params = whole.params.iter();
        let params = params.map(|param| format!(", {}: {}", param.name, ty(param.ty)));
        let params = params.collect::<String>();
        let result = whole.result.map(ty);
        let result = result.map_or("bool".into(), |result| format!("Option<{result}>"));
        let name = &whole.name;
        self.lines.open(&format!("{visible} {name}(mesh: &mut Mesh{params}) -> {result} {{"));
        self.refusal = match whole.result {
            Some(_) => "return None;",
            None => "return false;",
        };
        self.block(&whole.asks, true);
        self.used.insert("all_or_nothing");
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
        self.block(others, true);
        if let Some(result) = last {
            let result = result.as_ref().map(|result| self.text(result));
            let result = result.unwrap_or("()".into());
            self.lines.line(&format!("Some({result})"));
        }
        self.applied = "true";
        self.lines.close(match whole.result {
            Some(_) => "})",
            None => "}).is_some()",
        });
        self.lines.close("}");
    }

    pub(super) fn action(&mut self, action: &Action, has_result: bool) {
        match action {
            Action::Variable { place, value } => {
                let value = self.text(value);
                self.put(place, &value);
            }
            Action::Must { call, place } => self.must(call, place.as_ref()),
            Action::May { call } => {
                let call = self.called(call);
                self.lines.line(&format!("{call};"));
            }
            Action::Apply { call, place, then, otherwise } => {
                let text = self.called(call);
                let condition = match (place, call.of, then.is_empty()) {
                    (Some(Parameter { name, .. }), ..) => format!("let Some({name}) = {text}"),
                    (None, Called::Plain, true) => format!("!{text}"),
                    (None, Called::Plain, false) => text,
                    (None, _, true) => format!("{text}.is_none()"),
                    (None, _, false) => format!("{text}.is_some()"),
                };
                match place.is_none() && then.is_empty() {
                    true => self.branches(&condition, [otherwise, &[]], has_result),
                    false => self.branches(&condition, [then, otherwise], has_result),
                }
            }
            Action::Choose { condition, then, otherwise } => {
                let condition = self.text(condition);
                self.branches(&condition, [then, otherwise], has_result);
            }
            Action::Repeat { count, body, .. } => {
                let count = self.text(count);
                self.held(&format!("for _ in 0..{count} {{"), body, has_result);
            }
            Action::While { condition, body } => {
                let condition = self.text(condition);
                self.held(&format!("while {condition} {{"), body, has_result);
            }
            Action::For { variable, around, element, may_go, filter, body } => {
                let all = self.all_around(*around, element);
                let Parameter { name, ty: of, .. } = variable;
                self.lines.open(&format!("for {name} in {all}.collect::<Vec<_>>() {{"));
                let gone = may_go.then(|| format!("!mesh.{}_alive({name})", of.word()));
                let others = filter.as_ref().map(|filter| {
                    let others = spell(self, &filter.clone().not());
                    others.at(if *may_go { Level::Or } else { Level::Choice })
                });
                let skipped: Vec<_> = gone.into_iter().chain(others).collect();
                if !skipped.is_empty() {
                    self.lines.open(&format!("if {} {{", skipped.join(" || ")));
                    self.lines.line("continue;");
                    self.lines.close("}");
                }
                self.block(body, has_result);
                self.lines.close("}");
            }
            Action::Update { visit, held } => {
                for Held { list, .. } in held {
                    self.lines.line(&format!("let mut {list} = Vec::new();"));
                }
                self.action(visit, has_result);
                held.iter().for_each(|held| self.release(held));
            }
            Action::Hold { list, element, value } => {
                let (element, value) = (self.text(element), self.text(value));
                let value = bare(&value);
                self.lines.line(&format!("{list}.push(({element}, {value}));"));
            }
            Action::Break => self.lines.line("break;"),
            Action::Continue => self.lines.line("continue;"),
            Action::Move { vertex, value, is_finite } => {
                let (vertex, mut value) = (self.text(vertex), self.text(value));
                if !is_finite {
                    self.used.insert("finite");
                    value = format!("finite({value})?");
                }
                self.lines.line(&format!("mesh.set_position({vertex}, {value});"));
            }
            Action::Ask(attribute) => {
                let declared = &attribute.declared;
                let kind = match attribute.element {
                    Type::Vertex => "Vertex",
                    Type::Halfedge => "Halfedge",
                    Type::Edge => "Edge",
                    _ => "Face",
                };
                let of = ty(attribute.ty);
                self.lines.open(&format!(
                    "if mesh.find_column(ElementKind::{kind}, \"{declared}\")\
                     .and_then(|c| mesh.values::<{of}>(c)).is_none() {{"
                ));
                let refusal = self.refusal;
                self.lines.line(&format!(
                    "{refusal} // the mesh has no attribute `{declared}` of this type"
                ));
                self.lines.close("}");
            }
            // The mesh notes what is written by itself.
            Action::Keep(_) | Action::KeepAttribute { .. } => {}
            Action::Leave => self.lines.line(match self.gives_option {
                true => "return Some(());",
                false => "return;",
            }),
        }
    }

    /// Writes what was put off.
    fn release(&mut self, held: &Held) {
        let list = &held.list;
        self.lines.open(&format!("for (element, value) in {list} {{"));
        match &held.attribute {
            None => {
                self.used.insert("finite");
                self.lines.line("mesh.set_position(element, finite(value)?);");
            }
            Some(attribute) => {
                self.used.insert("set_attribute");
                let column = &attribute.column;
                self.lines.line(&format!("set_attribute(mesh, {column}, element.0, value);"));
            }
        }
        self.lines.close("}");
    }

    fn must(&mut self, call: &Call, place: Option<&Target>) {
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

    fn put(&mut self, place: &Target, value: &str) {
        let Target { name, ty: of, form } = place;
        // A plain number could be of several types.
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
    fn called(&mut self, call: &Call) -> String {
        let args = call.args.iter().map(|arg| format!(", {}", self.text(arg)));
        let args = args.collect::<String>();
        let name = match call.of {
            Called::Operation | Called::Plain => call.name.clone(),
            Called::Refusing | Called::Sure => invoked(&call.name),
        };
        format!("{name}(mesh{args})")
    }

    fn held(&mut self, head: &str, body: &[Statement], has_result: bool) {
        self.lines.open(head);
        self.block(body, has_result);
        self.lines.close("}");
    }

    fn branches(
        &mut self,
        condition: &str,
        [then, otherwise]: [&[Statement]; 2],
        has_result: bool,
    ) {
        self.lines.open(&format!("if {condition} {{"));
        self.block(then, has_result);
        self.otherwise(otherwise, has_result);
        self.lines.close("}");
    }

    /// The other branches of an `if`.
    fn otherwise(&mut self, otherwise: &[Statement], has_result: bool) {
        match otherwise {
            [] => {}
            [Statement::Action(Action::Choose { condition, then, otherwise })] => {
                let condition = self.text(condition);
                self.lines.reopen(&format!("}} else if {condition} {{"));
                self.block(then, has_result);
                self.otherwise(otherwise, has_result);
            }
            _ => {
                self.lines.reopen("} else {");
                self.block(otherwise, has_result);
            }
        }
    }
}

/// A value that stands alone, without brackets around all of it.
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
