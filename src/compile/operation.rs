//! An operation: its alternatives, tried in order.

use std::sync::Arc;

use super::collect::Collect;
use super::output::Output;
use super::reassign::Reassign;
use super::registers::{Home, Registers};
use super::width;
use super::write_target::WriteTarget;
use crate::check::{Proof, Proved};
use crate::diagram::{Drawing, Property, Rule};
use crate::lower::{Element, Operation};
use crate::rewrite::{
    Cell, Code, Function, Holder, Inst, Label, Matched, Plan, Reg, Row, Stage, TooLarge,
};
use crate::source::Sources;

/// Compiles a proved operation.
///
/// `sources` gives the words of its expressions for the table; `functions` are those of the
/// program, all of which share the same texts.
///
/// # Errors
/// [`TooLarge`] if the diagrams need more registers, or more reasons to refuse, than code can
/// number.
pub fn compile(
    proved: &Proved,
    sources: &Sources,
    functions: &Arc<[Function]>,
) -> Result<Plan, TooLarge> {
    let op = proved.op();
    let texts = functions.last().map(|last| last.code.texts.as_slice());
    let mut output = Output::new(sources, texts.unwrap_or_default());
    let widths: Vec<_> = op.params.iter().map(|param| width(param.ty)).collect();
    let params: Vec<_> = widths.iter().map(|&width| output.asm.block(width)).collect();
    let mut stages = Vec::new();
    let mut matched = Vec::new();
    for (rule, proof) in op.rules.iter().zip(proved.proofs()) {
        let next_rule = output.asm.label();
        let mark = output.asm.mark();
        let rule = proof.drawn(rule);
        let (stage, names) = alternative(&mut output, rule, proof, &params, next_rule);
        stages.push(stage);
        matched.push(names);
        output.asm.release(mark);
        output.asm.bind(next_rule);
    }
    output.asm.emit(Inst::Refuse);
    // `u16::MAX` is also the number of every refusal beyond the range.
    if output.refusals.len() > usize::from(u16::MAX) {
        return Err(TooLarge);
    }
    Ok(Plan {
        name: op.name.clone(),
        params: widths,
        of: op.params.first().and_then(|param| param.ty.element_kind()),
        result: op.result.and_then(|ty| ty.element_kind()),
        level: op.level(),
        keeps: proved.keeps().into_iter().filter_map(Property::level).collect(),
        code: Code { functions: Arc::clone(functions), ..output.asm.finish()? },
        places: output.places,
        refusals: output.refusals,
        stages,
        matched,
        steps: None,
    })
}

fn alternative(
    output: &mut Output,
    rule: &Rule,
    proof: &Proof,
    params: &[Reg],
    fail: Label,
) -> (Stage, Matched) {
    let drawing = Drawing::new(rule);
    let registers = Registers::new(&mut output.asm, &drawing, params);
    let mut stage = Stage { rule: rule.label.clone(), ..Stage::default() };
    let operation = Operation::new(&drawing, proof);
    let mut collected = Collect {
        output,
        drawing: &drawing,
        registers,
        fail,
        fail_of_values: None,
        rows: &mut stage.collect,
    }
    .emit(&operation);
    let matched = matched(output, &drawing, &collected.registers);
    allocate(output, rule, &operation.created, &mut collected.registers, &mut stage.allocate);
    Reassign {
        output,
        drawing: &drawing,
        registers: collected.registers.clone(),
        collected: &collected,
        values: &operation.values,
        target: WriteTarget::Mesh,
        rows: &mut stage.reassign,
    }
    .emit();
    erase(output, rule, &operation.erased, &mut collected.registers, &mut stage.erase);
    let result = operation.result.map(|name| collected.registers.element(&mut output.asm, name));
    output.asm.emit(Inst::Return { result });
    (stage, matched)
}

/// The homes of the names of `before` after matching.
fn matched(output: &Output, drawing: &Drawing, registers: &Registers) -> Matched {
    let rule = drawing.rule;
    let bound = rule.ids().filter(|&name| drawing.before.mention(name).is_some());
    let named = bound.filter(|&name| rule.name(name).named && rule.is_first(name));
    let names = named.filter_map(|name| {
        let holder = match registers.home(name) {
            Home::Reg(reg) => Holder::Reg(reg),
            Home::Member { buffer, .. } => Holder::Buffer(buffer),
        };
        Some((rule.name(name).text.clone(), rule.kind(name).element_kind()?, holder))
    });
    Matched { from: output.asm.next_inst(), names: names.collect() }
}

fn allocate(
    output: &mut Output,
    rule: &Rule,
    created: &[Element],
    registers: &mut Registers,
    rows: &mut Vec<Row>,
) {
    let asm = &mut output.asm;
    for &Element { name, kind, .. } in created {
        let Some(element) = kind.element_kind() else { continue };
        asm.emit(match registers.home(name) {
            Home::Reg(to) => Inst::New { kind: element, to },
            Home::Member { buffer, .. } => {
                let cycle = registers.cycle.unwrap_or_default();
                Inst::BufferNew { kind: element, cycle, buffer }
            }
        });
        let target = rule.name(name).text.clone();
        rows.push(Row::set(target, format!("new {}", kind.word()), true));
    }
}

fn erase(
    output: &mut Output,
    rule: &Rule,
    erased: &[Element],
    registers: &mut Registers,
    rows: &mut Vec<Row>,
) {
    let asm = &mut output.asm;
    for &Element { name, kind, at_each_index } in erased {
        let Some(kind) = kind.element_kind() else { continue };
        let indices = at_each_index.then(|| registers.begin_index_loop(asm));
        let element = registers.element(asm, name);
        asm.emit(Inst::Erase { kind, element });
        if let Some(indices) = indices {
            registers.end_index_loop(asm, indices);
        }
        let word = &rule.name(name).text;
        rows.push(Row { cell: Cell::Note { text: format!("erase {word}") }, executed: true });
    }
}
