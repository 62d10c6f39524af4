//! Statements that are noted on a preview of the mesh.

use super::super::language::{Language, field};
use super::super::routine::Statement;
use super::super::statement::Printing;
use super::function::Printer;
use crate::diagram::Kind;

impl Printer<'_> {
    /// Writes a preview, and the block that looks at it.
    pub(super) fn preview_block(&mut self, preview: &str, body: &[Statement]) {
        self.lines.blank();
        self.lines
            .comment("//", "The guard looks at what there would be, on a preview of the mesh.");
        self.lines.open("{");
        self.lines.line(&format!("hedgerow::Preview {preview};"));
        let outer = self.preview.replace(preview.to_string());
        self.block(body);
        self.preview = outer;
        self.lines.close("}");
    }

    /// Notes what a statement would allocate or set; returns false for other statements.
    pub(super) fn note(&mut self, preview: &str, statement: &Statement) -> bool {
        let line = match statement {
            Statement::New { kind, name } => {
                format!("auto {name} = {preview}.new_{}();", kind.word())
            }
            Statement::NewEach { kind, name, indices } => {
                let ty = match kind {
                    Kind::Vertex => "hedgerow::Preview::SeenVertex",
                    Kind::Face => "hedgerow::Preview::SeenFace",
                    _ => "hedgerow::Preview::SeenHalfedge",
                };
                let item = format!("{preview}.new_{}()", kind.word());
                self.gather(ty, name, indices, &item);
                return true;
            }
            Statement::Set { pointer, of, value } => {
                let (of, value) = (self.text(of), self.text(value));
                format!("{preview}.set_{}({of}, {value});", field(*pointer))
            }
            Statement::SetHole { face, hole } => {
                format!("{preview}.set_hole({}, {hole});", self.text(face))
            }
            _ => return false,
        };
        self.lines.line(&line);
        true
    }
}
