//! Functions of the program as Rust.

use super::super::lines::Lines;
use super::super::names::unreserved;
use super::super::routine::{Helper, Statement};
use super::function::{Printer, names, ty};
use super::support;

/// What a function of the program is called: not as one that is written out.
pub(super) fn invoked(name: &str) -> String {
    match support::is_known(name) {
        true => format!("{name}_"),
        false => unreserved(name),
    }
}

impl Printer {
    /// Writes a function; it sees the mesh as it is.
    pub(super) fn helper(&mut self, helper: &Helper) {
        let outer = std::mem::replace(&mut self.lines, Lines::new(4));
        if let Some((last, others)) = helper.body.split_last() {
            self.block(others, true);
            match last {
                Statement::Give(value) => {
                    let value = self.text(value);
                    self.lines.line(&value);
                }
                last => self.block(std::slice::from_ref(last), true),
            }
        }
        let body = std::mem::replace(&mut self.lines, outer).finish();
        for line in &helper.docs {
            self.lines.line(format!("/// {line}").trim_end());
        }
        let mesh = if names(&body, "mesh") {
            "mesh"
        } else {
            "_mesh"
        };
        let params = helper.params.iter();
        let params = params.map(|param| format!(", {}: {}", param.name, ty(param.ty)));
        self.lines.open(&format!(
            "fn {}({mesh}: &Mesh{}) -> {} {{",
            invoked(&helper.name),
            params.collect::<String>(),
            ty(helper.result)
        ));
        for line in body.lines() {
            self.lines.line(line);
        }
        self.lines.close("}");
    }
}
