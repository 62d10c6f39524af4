//! Lowering of `print`: pieces of text and values, then the end of the line.

use super::lower::Lowering;
use crate::diagram::Type;
use crate::mesh::ElementKind::{Edge, Face, Halfedge, Vertex};
use crate::resolve::{Digits, Print};
use crate::rewrite::{Inst, RealDigits, Reg};

impl Lowering<'_> {
    pub(super) fn print(&mut self, pieces: &[Print]) {
        let mark = self.asm.mark();
        // All values are computed first, since a function called by one may itself print lines.
        let values = pieces.iter().map(|piece| match piece {
            Print::Text(_) => None,
            Print::Value(value, _) => {
                let from = self.value(value);
                if let Some(kind) = value.ty.element_kind() {
                    self.trap_at(value.span, Inst::ExpectAlive { kind, from });
                }
                Some(from)
            }
        });
        let values: Vec<_> = values.collect();
        for (piece, from) in pieces.iter().zip(values) {
            match (piece, from) {
                (Print::Text(text), _) => self.print_text(text),
                (Print::Value(value, digits), Some(from)) => {
                    self.asm.emit(print_value(value.ty, from, *digits));
                    if let (Type::Int, Digits::Behind(count @ 1..)) = (value.ty, *digits) {
                        self.print_text(&format!(".{}", "0".repeat(count.into())));
                    }
                }
                (Print::Value(..), None) => {}
            }
        }
        self.asm.emit(Inst::PrintEnd);
        self.asm.release(mark);
    }

    pub(super) fn print_text(&mut self, text: &str) {
        let text = self.asm.text(text);
        self.asm.emit(Inst::PrintText { text });
    }
}

/// The instruction that prints a value.
pub(super) fn print_value(ty: Type, from: Reg, digits: Digits) -> Inst {
    let digits = match digits {
        Digits::Few => RealDigits::Few,
        Digits::All => RealDigits::All,
        Digits::Behind(count) => RealDigits::Behind(count),
    };
    match ty {
        Type::Bool => Inst::PrintBool { from },
        Type::Int => Inst::PrintInt { from },
        Type::Real => Inst::PrintReal { from, digits },
        Type::Vec2 | Type::Vec3 | Type::Vec4 => {
            Inst::PrintWide { from, size: ty.size(), columns: 1, digits }
        }
        Type::Mat3 | Type::Mat4 => {
            Inst::PrintWide { from, size: ty.size(), columns: ty.size(), digits }
        }
        Type::Text => Inst::PrintTextOf { from },
        Type::Vertex => Inst::PrintElement { kind: Vertex, from },
        Type::Halfedge => Inst::PrintElement { kind: Halfedge, from },
        Type::Edge => Inst::PrintElement { kind: Edge, from },
        Type::Face => Inst::PrintElement { kind: Face, from },
    }
}
