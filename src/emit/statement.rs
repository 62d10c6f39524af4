//! Statements as text: what C++ and Rust have in common.

use super::item::Alternative;
use super::language::Language;
use super::lines::{Lines, comment};
use super::routine::Statement;
use super::term::{Parameter, Term};
use crate::diagram::Kind;

/// A printer of statements.
pub(super) trait Printing: Language {
    fn lines(&mut self) -> &mut Lines;
    fn block(&mut self, body: &[Statement]);
    /// The beginning of a line, up to the brace: `if (x)`.
    fn if_head(&self, condition: &str) -> String;
    /// The condition of a statement that can follow an `else`, and its branches.
    fn chained<'s>(&self, statement: &'s Statement) -> Option<(String, [&'s [Statement]; 2])> {
        match statement {
            Statement::Choose { condition, then, otherwise } => {
                Some((self.text(condition), [then, otherwise]))
            }
            _ => None,
        }
    }

    fn texts(&self, terms: &[Term]) -> Vec<String> {
        terms.iter().map(|term| self.text(term)).collect()
    }

    fn branches(&mut self, condition: &str, [then, otherwise]: [&[Statement]; 2]) {
        let head = self.if_head(condition);
        self.lines().open(&format!("{head} {{"));
        self.block(then);
        self.otherwise(otherwise);
        self.lines().close("}");
    }

    /// The other branches of an `if`.
    fn otherwise(&mut self, otherwise: &[Statement]) {
        let chained = match otherwise {
            [] => return,
            [only] => self.chained(only),
            _ => None,
        };
        match chained {
            Some((condition, [then, otherwise])) => {
                let head = self.if_head(&condition);
                self.lines().reopen(&format!("}} else {head} {{"));
                self.block(then);
                self.otherwise(otherwise);
            }
            None => {
                self.lines().reopen("} else {");
                self.block(otherwise);
            }
        }
    }

    /// The comment before the attempts.
    fn attempts(&mut self, kind: Kind, element: &str) {
        self.lines().line(&match kind {
            Kind::Edge => format!("// Both directions of {element} are tried."),
            Kind::Vertex => format!("// Each halfedge that starts at {element} is tried."),
            _ => format!("// Each halfedge of {element} is tried."),
        });
    }

    /// Writes a doc comment, with the defaults of these parameters.
    fn docs<'p>(&mut self, docs: &[String], params: impl Iterator<Item = &'p Parameter>) {
        for line in docs {
            self.lines().line(&comment("///", line));
        }
        let told = params.filter_map(|param| {
            let default = self.text(param.default.as_ref()?);
            Some(format!("`{} = {default}`", param.name))
        });
        let told = told.collect::<Vec<_>>().join(", ");
        if !told.is_empty() {
            self.lines().line(&format!("/// By default {told}."));
        }
    }
}

/// The names of the functions for the alternatives of an operation.
pub(super) fn rule_names(rules: &[Alternative], params: &[Parameter]) -> Vec<String> {
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
