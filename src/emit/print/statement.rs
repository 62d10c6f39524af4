//! Statements as text.

use super::Printer;
use super::lines::comment;
use crate::diagram::Kind;
use crate::emit::language::{WIDTH, type_of};
use crate::emit::routine::{Block, Field, Form, Statement};
use crate::emit::value::{Precedence, Term, unique};

impl Printer<'_> {
    pub fn block(&mut self, body: &[Statement]) {
        body.iter().for_each(|statement| self.statement(statement));
    }

    fn statement(&mut self, statement: &Statement) {
        let line = match statement {
            Statement::Comment(text) => return self.lines.comment(text),
            Statement::Blank => return self.lines.blank(),
            Statement::Lines { text, .. } => return self.lines.add(text),
            Statement::Block(block) => return self.holding(block),
            Statement::Refuse { when, reason } => return self.refuse(&when.text, reason),
            Statement::RefuseIn { head, reason, end } => {
                return self.refused(&head.text, reason, end);
            }
            Statement::New { kind, name, indices } => {
                let (new, is_new) = (Term::whole(self.new_element(*kind)), self.preview.is_none());
                let ty = match (self.language.style, is_new) {
                    (None, _) => "_".to_string(),
                    (Some(_), true) => self.language.ty(type_of(*kind)),
                    (Some(_), false) => format!("hedgerow::Preview::Seen{:?}", type_of(*kind)),
                };
                if let Some(indices) = indices {
                    return self.statement(&self.language.gather(&ty, name, indices, &new));
                }
                let (ty, new) = (if is_new { ty.as_str() } else { "auto" }, new.text);
                say!(self.language, "let {name} = {new};", "{ty} {name} = {new};")
            }
            Statement::Set { field, of, value } => self.set(field, of, &value.text),
            Statement::Erase { kind, element: Term { text, .. } } => match self.language.style {
                None => format!("mesh.erase_{}({text});", kind.word()),
                Some(_) if self.is_noted => format!("journal.erase({text});"),
                Some(style) => style.erase(*kind, text) + ";",
            },
            Statement::Return { value } => match self.returned(value.as_ref()).as_str() {
                "" => "return;".into(),
                value => format!("return {value};"),
            },
            Statement::Preview { preview, body } => return self.previewed(preview, body),
        };
        self.lines.line(&line);
    }

    fn set(&self, field: &Field, of: &Term, value: &str) -> String {
        let (spelled, told) = match field {
            Field::Pointer(pointer) => (pointer.word(), unique(*pointer)),
            Field::Hole => ("boundary", "hole"),
            Field::Position => ("position", "position"),
            Field::Attribute(attribute) => {
                return self.language.set_attribute(attribute, of, value);
            }
        };
        match (self.language.style, self.preview.as_deref()) {
            (Some(style), None) => style.put(&of.at(Precedence::Whole), spelled, value) + ";",
            (_, preview) => {
                let mesh = preview.unwrap_or("mesh");
                format!("{mesh}.set_{told}({}, {value});", of.text)
            }
        }
    }

    /// The value that is returned; empty for none.
    pub fn returned(&self, value: Option<&Term>) -> String {
        match value {
            Some(value) if self.wraps => format!("Some({})", value.text),
            Some(value) => value.text.clone(),
            None => self.applied.clone(),
        }
    }

    /// The call that allocates an element.
    fn new_element(&self, kind: Kind) -> String {
        let word = kind.word();
        match (self.language.style, &self.preview) {
            (None, preview) => format!("{}.add_{word}()", preview.as_deref().unwrap_or("mesh")),
            (Some(_), Some(preview)) => format!("{preview}.new_{word}()"),
            (Some(_), None) if self.is_noted => format!("journal.new_{word}()"),
            (Some(style), None) => style.allocate(kind),
        }
    }

    /// A head and its body.
    fn holding(&mut self, block: &Block) {
        let Block { form, first, head, body, last, otherwise } = block;
        let outer = self.refusal;
        if *form == Form::Attempt {
            self.refusal = "continue;";
        }
        self.lines.add(first);
        if otherwise.is_empty() {
            let text = self.apart(|this| this.block(body)) + last;
            self.lines.add(&self.language.held(&head.text, &text));
        } else {
            self.lines.open(&format!("{} {{", head.text));
            self.block(body);
            self.otherwise(otherwise);
            self.lines.close("}");
        }
        self.refusal = outer;
    }

    /// The other branches of an `if`.
    fn otherwise(&mut self, otherwise: &[Statement]) {
        match otherwise {
            [] => {}
            [Statement::Block(Block { form: Form::Branch, head, body, otherwise, .. })] => {
                self.lines.reopen(&format!("}} else {} {{", head.text));
                self.block(body);
                self.otherwise(otherwise);
            }
            _ => {
                self.lines.reopen("} else {");
                self.block(otherwise);
            }
        }
    }

    /// Refuses if a condition holds.
    fn refuse(&mut self, when: &str, reason: &str) {
        let refusal = self.refusal;
        let reason_behind = comment("//", reason);
        if when == "true" && (self.language.is_rust() || self.is_noted) {
            let line =
                say!(self.language, "{refusal} {reason_behind}", "{refusal}  {reason_behind}");
            return self.lines.line(&line);
        }
        if self.language.is_rust() {
            return self.refused(&format!("if {when} {{"), reason, "}");
        }
        let line = format!("if ({when}) {refusal}");
        if line.len() + reason.len() < WIDTH {
            return self.lines.line(&format!("{line}  {reason_behind}"));
        }
        self.lines.comment(&format!("Refused: {reason}."));
        self.lines.line(&line);
    }

    /// Refuses in a block, in Rust; the reason may be empty.
    fn refused(&mut self, head: &str, reason: &str, end: &str) {
        self.lines.open(head);
        let reason = if reason.is_empty() { String::new() } else { comment(" //", reason) };
        self.lines.line(&format!("{}{reason}", self.refusal));
        self.lines.close(end);
    }

    /// Writes a preview, and the block that looks at it.
    fn previewed(&mut self, preview: &str, body: &[Statement]) {
        if !self.language.is_rust() {
            self.lines.blank();
        }
        self.lines.comment("The guard looks at what there would be, on a preview of the mesh.");
        self.lines.open("{");
        self.lines.line(&say!(
            self.language,
            "let mut {preview} = Preview::new(mesh);",
            "hedgerow::Preview {preview};"
        ));
        let outer = self.preview.replace(preview.to_string());
        self.block(body);
        self.preview = outer;
        self.lines.close("}");
    }
}
