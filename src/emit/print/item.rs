//! Operations and functions as text.

use std::collections::BTreeSet;

use super::Printer;
use super::lines::{Lines, comment};
use super::support::{code, names};
use crate::diagram::Level;
use crate::emit::item::{Alternative, Item, ItemBody, Parameter, Signature};
use crate::emit::language::Language;
use crate::emit::routine::{Statement, names_of};
use crate::emit::value::bare;

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

/// The text of an item.
pub(in crate::emit) fn item(language: Language<'_>, item: &Item, part: Part) -> String {
    let (signature, is_rust) = (&item.signature, language.is_rust());
    let is_function = matches!(item.body, ItemBody::Function(_));
    let given = signature.given.as_ref().filter(|_| !is_rust && part != Part::Called);
    let mut printer = Printer {
        language: Language { is_outside: is_function, ..language },
        part,
        lines: Lines::new(if is_rust { 4 } else { 2 }),
        refusal: match (signature.result, is_rust) {
            (_, false) if is_function => "throw Refused();",
            (None, _) if !is_function => "return false;",
            (_, true) => "return None;",
            (_, false) => "return std::nullopt;",
        },
        applied: match given {
            Some(given) => given.name.clone(),
            None if is_function && is_rust && signature.refuses => "Some(())".into(),
            None if is_function => String::new(),
            None => "true".into(),
        },
        wraps: is_rust && (!is_function || signature.refuses),
        is_noted: if is_function { signature.changes } else { part == Part::Called },
        preview: None,
    };
    let body = printer.apart(|this| match &item.body {
        ItemBody::Drawn(rules) => this.rules(signature, rules),
        ItemBody::Steps { requires, level, steps } => {
            this.block(requires);
            this.steps(signature, *level, steps);
        }
        ItemBody::Function(body) => this.body(body),
    });
    match language.style {
        None => printer.head_in_rust(item, &body),
        Some(style) => printer.head_in_cpp(style, item, &body),
    }
    printer.lines.add(&body);
    printer.lines.close("}");
    printer.lines.finish()
}

impl Printer<'_> {
    /// Writes a doc comment, with the defaults of these parameters.
    pub fn docs<'p>(&mut self, docs: &[String], params: impl Iterator<Item = &'p Parameter>) {
        for line in docs {
            self.lines.line(&comment("///", line));
        }
        let told = params.filter_map(|param| {
            let default = param.default.as_ref()?;
            Some(format!("`{} = {}`", param.name, default.text))
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
        let result = self.language.outcome(signature.result);
        let texts = rules.iter().map(|rule| self.apart(|this| this.alternative(&rule.body)));
        let texts: Vec<_> = texts.collect();
        let mut calls = Vec::new();
        for ((rule, name), text) in
            rules.iter().zip(rule_names(rules, signature, &texts)).zip(&texts)
        {
            let used = names_of(&rule.body);
            let taken = signature.params.iter().filter(|param| used.contains(&param.name));
            let args = taken.clone().map(|param| format!(", {}", param.name)).collect::<String>();
            calls.push(say!(self.language, "{name}(mesh{args})", "{name}()"));
            self.lines.blank();
            let params = self.listed(taken);
            self.allow(used, &signature.params);
            let head = say!(
                self.language,
                "fn {name}(mesh: &mut Mesh{params}) -> {result} {{",
                "auto {name} = [&]() -> {result} {{"
            );
            self.lines.open(&head);
            self.lines.add(text);
            self.lines.close(if self.language.is_rust() { "}" } else { "};" });
        }
        self.lines.blank();
        if self.language.is_rust() {
            let all = calls.into_iter().reduce(|all, call| match signature.result {
                None => format!("{all} || {call}"),
                Some(_) => format!("{all}.or_else(|| {call})"),
            });
            return self.lines.line(&all.unwrap_or_default());
        }
        let Some((last, others)) = calls.split_last() else { return };
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
        self.body(body);
        if !matches!(body.last(), Some(Statement::Return { .. })) {
            let refusal = self.refusal;
            let value = refusal.trim_start_matches("return ").trim_end_matches(';');
            self.lines.line(&say!(self.language, "{value}", "{refusal}"));
        }
    }

    /// The steps; in C++ they run through a journal, so that they can be undone.
    fn steps(&mut self, signature: &Signature, level: Level, steps: &[Statement]) {
        let result = self.language.outcome(signature.result);
        match self.language.style {
            None => (self.refusal, self.applied) = ("return None;", "Some(())".into()),
            Some(style) if !self.is_noted => {
                let mesh = if style.is_member() { "*this" } else { "mesh" };
                self.lines.line(&format!("hedgerow::Journal journal({mesh});"));
            }
            Some(_) => {}
        }
        let name = level.name();
        let head = say!(
            self.language,
            "all_or_nothing(mesh, Level::{level:?}, |mesh| {{",
            "return journal.whole(hedgerow::Level::{name}, [&]() -> {result} {{"
        );
        self.lines.open(&head);
        let outer = std::mem::replace(&mut self.is_noted, true);
        self.body(steps);
        self.is_noted = outer;
        self.lines.close(match (self.language.style, signature.result) {
            (Some(_), _) => "});",
            (None, Some(_)) => "})",
            (None, None) => "}).is_some()",
        });
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
            self.lines.line(&say!(self.language, "{bare}", "return {value};"));
        }
    }
}

/// The names of the functions for the alternatives of an operation, which none of them uses for
/// something else.
fn rule_names(rules: &[Alternative], signature: &Signature, texts: &[String]) -> Vec<String> {
    let texts: Vec<_> = texts.iter().map(|text| code(text)).collect();
    let mut taken: BTreeSet<_> = signature.params.iter().map(|param| param.name.clone()).collect();
    let name = |(at, rule): (usize, &Alternative)| {
        let label = rule.label.clone().unwrap_or_else(|| (at + 1).to_string());
        let word = format!("rule_{}", label.replace('\'', "_"));
        let (mut name, mut number) = (word.clone(), 2);
        while texts.iter().any(|text| names(text, &name)) || !taken.insert(name.clone()) {
            name = format!("{}_{number}", word.trim_end_matches('_'));
            number += 1;
        }
        name
    };
    rules.iter().enumerate().map(name).collect()
}
