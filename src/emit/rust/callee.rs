//! Functions of the program as Rust.

use super::super::lines::{Lines, comment};
use super::super::names::invoked;
use super::super::routine::{Helper, Statement};
use super::super::support::names;
use super::function::{Printer, ty};
use super::steps::bare;

impl Printer {
    /// Writes a function; it borrows the mesh mutably only if it changes it.
    pub(super) fn helper(&mut self, helper: &Helper) {
        let outer = std::mem::replace(&mut self.lines, Lines::new(4));
        (self.refusal, self.gives_option) = ("return None;", helper.refuses);
        self.is_asked = true;
        if let Some((last, others)) = helper.body.split_last() {
            self.block(others);
            match last {
                Statement::Give(value) => {
                    let value = self.text(value);
                    self.lines.line(&match helper.refuses {
                        true => format!("Some({value})"),
                        false => bare(&value).to_string(),
                    });
                }
                Statement::Leave => {
                    if helper.refuses {
                        self.lines.line("Some(())");
                    }
                }
                last => self.block(std::slice::from_ref(last)),
            }
        }
        let body = std::mem::replace(&mut self.lines, outer).finish();
        (self.gives_option, self.is_asked) = (false, false);
        for line in &helper.docs {
            self.lines.line(&comment("///", line));
        }
        let mesh = if names(&body, "mesh") { "mesh" } else { "_mesh" };
        let mesh = match helper.changes {
            true => format!("{mesh}: &mut Mesh"),
            false => format!("{mesh}: &Mesh"),
        };
        let result = helper.result.map(ty);
        let result = match (result, helper.refuses) {
            (Some(value), false) => format!(" -> {value}"),
            (Some(value), true) => format!(" -> Option<{value}>"),
            (None, true) => " -> Option<()>".to_string(),
            (None, false) => String::new(),
        };
        self.allow(&helper.body, &helper.params);
        let params = helper.params.iter();
        let params = params.map(|param| format!(", {}: {}", param.name, ty(param.ty)));
        self.lines.open(&format!(
            "fn {}({mesh}{}){result} {{",
            invoked(&helper.name),
            params.collect::<String>(),
        ));
        for line in body.lines() {
            self.lines.line(line);
        }
        self.lines.close("}");
    }
}
