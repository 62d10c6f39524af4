//! The machine on code written by hand.

mod arithmetic;
mod asked;
mod assembler;
mod calls;
mod families;
mod maps;
mod mesh;
mod operations;
mod preview;
mod print;
mod queue;
mod random;
mod values;

use hedgerow::mesh::{Level, Mesh};
use hedgerow::rewrite::*;

/// A code with that many parameter slots.
fn code(params: u16, write: impl FnOnce(&mut Assembler)) -> Code {
    let mut asm = Assembler::new();
    asm.block(params);
    write(&mut asm);
    asm.finish().unwrap()
}

fn plan(name: &str, params: &[u16], refusals: &[(&str, Phase)], code: Code) -> Plan {
    let refusals =
        refusals.iter().map(|&(reason, phase)| Refusal { reason: reason.to_owned(), phase });
    Plan {
        matched: Vec::new(),
        name: name.to_owned(),
        params: params.to_vec(),
        of: None,
        result: None,
        level: Level::Map,
        keeps: Vec::new(),
        code,
        places: Vec::new(),
        refusals: refusals.collect(),
        stages: Vec::new(),
        steps: None,
    }
}

#[derive(Default)]
struct Lines(Vec<String>);

impl Watch for Lines {
    fn print(&mut self, line: &str) {
        self.0.push(line.to_owned());
    }
}

/// The lines that some code prints.
fn printed(mesh: &mut Mesh, write: impl FnOnce(&mut Assembler)) -> Vec<String> {
    let mut lines = Lines::default();
    let code = code(0, write);
    Machine::default().run(mesh, &code, &[], &mut lines).unwrap();
    lines.0
}

/// Prints a line with one value.
fn print(asm: &mut Assembler, value: impl FnOnce(Reg) -> Inst, from: Reg) {
    asm.emit(value(from));
    asm.emit(Inst::PrintEnd);
}

fn int(from: Reg) -> Inst {
    Inst::PrintInt { from }
}

fn real(from: Reg) -> Inst {
    Inst::PrintReal { from, digits: RealDigits::All }
}

fn truth(from: Reg) -> Inst {
    Inst::PrintBool { from }
}

fn vector(from: Reg) -> Inst {
    Inst::PrintWide { from, size: 3, columns: 1, digits: RealDigits::All }
}

/// Why some code traps.
fn trap(mesh: &mut Mesh, write: impl FnOnce(&mut Assembler)) -> Message {
    let code = code(0, write);
    let run = Machine::default().run(mesh, &code, &[], &mut Unwatched);
    run.unwrap_err().message
}

fn copy(asm: &mut Assembler, from: Reg) -> Reg {
    let to = asm.reg();
    asm.emit(Inst::Copy { to, from });
    to
}

fn vec3(asm: &mut Assembler, parts: [f64; 3]) -> Reg {
    let to = asm.vec();
    for (offset, part) in (0..).zip(parts) {
        let from = asm.constant_real(part);
        let to = to.part(offset);
        asm.emit(Inst::Copy { to, from });
    }
    to
}
