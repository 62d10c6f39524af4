//! Statements that are noted on a preview of the mesh.

use super::super::routine::Statement;
use super::super::statement::Printing;
use super::super::term::IndexLoop;
use super::function::Printer;

impl Printer {
    /// Writes a preview, and the block that looks at it.
    pub(super) fn preview_block(&mut self, preview: &str, body: &[Statement]) {
        self.lines.line("// The guard looks at what there would be, on a preview of the mesh.");
        self.lines.open("{");
        self.lines.line(&format!("let mut {preview} = Preview::new(mesh);"));
        let outer = self.preview.replace(preview.to_string());
        self.block(body);
        self.preview = outer;
        self.lines.close("}");
    }

    /// Notes what a statement would allocate or set; returns false for other statements.
    pub(super) fn note(&mut self, preview: &str, statement: &Statement) -> bool {
        let line = match statement {
            Statement::New { kind, name } => {
                format!("let {name} = {preview}.add_{}();", kind.word())
            }
            Statement::NewEach { kind, name, indices } => {
                let (kind, IndexLoop { size, .. }) = (kind.word(), indices);
                format!(
                    "let {name}: Vec<_> = (0..{size}).map(|_| {preview}.add_{kind}()).collect();"
                )
            }
            statement => match self.noted(preview, statement) {
                Some(line) => line,
                None => return false,
            },
        };
        self.lines.line(&line);
        true
    }
}
