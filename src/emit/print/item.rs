//! Operations and functions as text.

use std::collections::BTreeSet;

use super::Printer;
use super::lines::comment;
use super::statement::bare;
use crate::diagram::{Level, Type};
use crate::emit::item::{Alternative, Item, ItemBody, Signature};
use crate::emit::routine::Statement;
use crate::emit::term::Parameter;

/// The part of an item in what is emitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::emit) enum Part {
    /// The only operation that was selected.
    Alone,
    /// One of several that were selected.
    Selected,
    /// An operation or function that others call.
    Called,
}

impl Printer<'_> {
    pub fn item(&mut self, item: &Item, part: Part) {
        let signature = &item.signature;
        if let ItemBody::Function { changes, refuses, body } = &item.body {
            self.is_noted = *changes;
            self.function(signature, [*changes, *refuses], body);
            self.is_noted = false;
            return;
        }
        self.is_noted = part == Part::Called;
        self.refusal = match (signature.result, self.style) {
            (None, _) => "return false;",
            (Some(_), None) => "return None;",
            (Some(_), Some(_)) => "return std::nullopt;",
        };
        let given = signature.given.as_ref();
        let given = given.filter(|_| self.style.is_some() && part != Part::Called);
        self.applied = given.map_or("true", |given| &given.name).into();
        let body = self.apart(|this| match &item.body {
            ItemBody::Drawn(rules) => this.rules(signature, rules),
            ItemBody::Steps { requires, level, steps } => {
                this.block(requires);
                this.steps(signature, *level, steps);
            }
            ItemBody::Function { .. } => {}
        });
        match self.style {
            None => self.head_in_rust(item, part),
            Some(style) => self.head_in_cpp(style, item, part, &body),
        }
        self.lines.add(&body);
        self.lines.close("}");
        self.is_noted = false;
    }

    /// The type that an operation returns.
    pub fn outcome(&self, result: Option<Type>) -> String {
        let Some(ty) = result.map(|ty| self.ty(ty)) else {
            return "bool".into();
        };
        say!(self, "Option<{ty}>", "std::optional<{ty}>")
    }

    /// Writes a doc comment, with the defaults of these parameters.
    pub fn docs<'p>(&mut self, docs: &[String], params: impl Iterator<Item = &'p Parameter>) {
        for line in docs {
            self.lines.line(&comment("///", line));
        }
        let told = params.filter_map(|param| {
            let default = self.text(param.default.as_ref()?);
            Some(format!("`{} = {default}`", param.name))
        });
        let told = told.collect::<Vec<_>>().join(", ");
        if !told.is_empty() {
            self.lines.line(&format!("/// By default {told}."));
        }
    }

    /// The alternatives of an operation, tried in order; if there are several, as functions.
    fn rules(&mut self, signature: &Signature, rules: &[Alternative]) {
        if let [rule] = rules {
            return self.alternative(&rule.body);
        }
        let result = self.outcome(signature.result);
        let mut calls = Vec::new();
        for (rule, name) in rules.iter().zip(rule_names(rules, &signature.params)) {
            let mut used = BTreeSet::new();
            for statement in &rule.body {
                statement.names(&mut |name| _ = used.insert(name.to_string()));
            }
            let taken = signature.params.iter().filter(|param| used.contains(&param.name));
            let args = taken.clone().map(|param| format!(", {}", param.name)).collect::<String>();
            calls.push(say!(self, "{name}(mesh{args})", "{name}()"));
            self.lines.blank();
            self.allow(&rule.body, &signature.params);
            let params = self.listed(taken);
            let head = say!(
                self,
                "fn {name}(mesh: &mut Mesh{params}) -> {result} {{",
                "auto {name} = [&]() -> {result} {{"
            );
            self.lines.open(&head);
            self.alternative(&rule.body);
            self.lines.close(if self.style.is_none() { "}" } else { "};" });
        }
        self.lines.blank();
        let Some((last, others)) = calls.split_last() else {
            return;
        };
        if self.style.is_none() {
            let line = match signature.result {
                None => calls.join(" || "),
                Some(_) => {
                    let others = calls[1..].iter().map(|call| format!(".or_else(|| {call})"));
                    calls[0].clone() + &others.collect::<String>()
                }
            };
            return self.lines.line(&line);
        }
        for call in others {
            self.lines.line(&match signature.result {
                Some(_) => format!("if (auto result = {call}) return result;"),
                None => format!("if ({call}) return true;"),
            });
        }
        self.lines.line(&format!("return {last};"));
    }

    fn alternative(&mut self, body: &[Statement]) {
        self.lines.line("// 1. Collect: nothing is written before all of this has passed.");
        let refusal = self.refusal;
        self.body(body);
        if !matches!(body.last(), Some(Statement::Return { .. })) {
            let value = refusal.trim_start_matches("return ").trim_end_matches(';');
            self.lines.line(&say!(self, "{value}", "{refusal}"));
        }
    }

    /// The steps; in C++ they run through a journal, so that they can be undone.
    fn steps(&mut self, signature: &Signature, level: Level, steps: &[Statement]) {
        let result = self.outcome(signature.result);
        match self.style {
            None => (self.refusal, self.applied) = ("return None;", "Some(())".into()),
            Some(style) if !self.is_noted => {
                let mesh = if style.is_member() { "*this" } else { "mesh" };
                self.lines.line(&format!("hedgerow::Journal journal({mesh});"));
            }
            Some(_) => {}
        }
        let name = level.name();
        let head = say!(
            self,
            "all_or_nothing(mesh, Level::{level:?}, |mesh| {{",
            "return journal.whole(hedgerow::Level::{name}, [&]() -> {result} {{"
        );
        self.lines.open(&head);
        let outer = std::mem::replace(&mut self.is_noted, true);
        self.body(steps);
        self.is_noted = outer;
        self.lines.close(match (self.style, signature.result) {
            (Some(_), _) => "});",
            (None, Some(_)) => "})",
            (None, None) => "}).is_some()",
        });
    }

    /// A function of the program; in Rust it borrows the mesh mutably only if it changes it.
    fn function(
        &mut self,
        signature: &Signature,
        [changes, refuses]: [bool; 2],
        body: &[Statement],
    ) {
        self.refusal = if self.style.is_none() { "return None;" } else { "throw Refused();" };
        self.applied = if self.style.is_none() && refuses { "Some(())" } else { "" }.into();
        let outer = std::mem::replace(&mut self.wraps, self.style.is_none() && refuses);
        (self.is_asked, self.is_outside) = (true, true);
        let text = self.apart(|this| this.body(body));
        self.docs(&signature.docs, [].iter());
        self.allow(body, &signature.params);
        let head = match self.style {
            None => self.function_in_rust(signature, [changes, refuses], &text),
            Some(_) => self.function_in_cpp(signature),
        };
        self.lines.open(&head);
        self.lines.add(&text);
        self.lines.close("}");
        (self.wraps, self.is_asked, self.is_outside) = (outer, false, false);
    }

    /// Writes the statements of a function; in Rust its last value is returned without `return`.
    fn body(&mut self, body: &[Statement]) {
        let Some((Statement::Return { value }, others)) = body.split_last() else {
            return self.block(body);
        };
        self.block(others);
        let value = self.returned(value.as_ref());
        if !value.is_empty() {
            let bare = bare(&value);
            self.lines.line(&say!(self, "{bare}", "return {value};"));
        }
    }
}

/// The names of the functions for the alternatives of an operation.
fn rule_names(rules: &[Alternative], params: &[Parameter]) -> Vec<String> {
    let name = |(at, rule): (usize, &Alternative)| {
        let label = rule.label.clone().unwrap_or_else(|| (at + 1).to_string());
        let mut name = format!("rule_{}", label.replace('\'', "_"));
        while params.iter().any(|param| param.name == name) {
            name.push('_');
        }
        name
    };
    rules.iter().enumerate().map(name).collect()
}
