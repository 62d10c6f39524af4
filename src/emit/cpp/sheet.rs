//! Statements that are noted on a sheet over the mesh.

use super::super::routine::Statement;
use super::super::spell::field;
use super::function::Printer;
use crate::diagram::Kind;

impl Printer<'_> {
    /// A sheet, and the block in which it is looked at.
    pub(super) fn foresee(&mut self, sheet: &str, body: &[Statement]) {
        self.used.push("Sheet");
        self.lines.blank();
        self.lines
            .comment("//", "The guard looks at what there would be, on a sheet over the mesh.");
        self.lines.open("{");
        self.lines.line(&format!("hedgerow::Sheet {sheet};"));
        let outer = self.sheet.replace(sheet.to_string());
        self.block(body);
        self.sheet = outer;
        self.lines.close("}");
    }

    /// Notes what a statement would allocate or set; others are not about that.
    pub(super) fn note(&mut self, sheet: &str, statement: &Statement) -> bool {
        let line = match statement {
            Statement::New { kind, name } => {
                format!("auto {name} = {sheet}.new_{}();", kind.word())
            }
            Statement::NewEach { kind, name, turns } => {
                let ty = match kind {
                    Kind::Vertex => "hedgerow::Sheet::SeenVertex",
                    Kind::Face => "hedgerow::Sheet::SeenFace",
                    _ => "hedgerow::Sheet::SeenHalfedge",
                };
                let item = format!("{sheet}.new_{}()", kind.word());
                self.gather(ty, name, turns, &item);
                return true;
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
