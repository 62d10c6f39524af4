//! Statements that are noted on a sheet over the mesh.

use super::super::routine::Statement;
use super::super::spell::field;
use super::super::term::Turns;
use super::function::Printer;

impl Printer {
    /// A sheet, and the block in which it is looked at.
    pub(super) fn foresee(&mut self, sheet: &str, body: &[Statement], has_result: bool) {
        self.used.insert("Sheet");
        self.lines.line("// The guard looks at what there would be, on a sheet over the mesh.");
        self.lines.open("{");
        self.lines.line(&format!("let mut {sheet} = Sheet::new(mesh);"));
        let outer = self.sheet.replace(sheet.to_string());
        self.block(body, has_result);
        self.sheet = outer;
        self.lines.close("}");
    }

    /// Notes what a statement would allocate or set; others are not about that.
    pub(super) fn note(&mut self, sheet: &str, statement: &Statement) -> bool {
        let line = match statement {
            Statement::New { kind, name } => {
                format!("let {name} = {sheet}.add_{}();", kind.word())
            }
            Statement::NewEach { kind, name, turns } => {
                let (kind, Turns { size, .. }) = (kind.word(), turns);
                format!("let {name}: Vec<_> = (0..{size}).map(|_| {sheet}.add_{kind}()).collect();")
            }
            Statement::Set { pointer, of, value } => {
                let (of, value) = (self.text(of), self.text(value));
                format!("{sheet}.set_{}({of}, {value});", field(*pointer))
            }
            Statement::SetHole { face, hole } => {
                format!("{sheet}.set_hole({}, {hole});", self.text(face))
            }
            _ => return false,
        };
        self.lines.line(&line);
        true
    }
}
