//! Looking ahead: the values that an operation would write are set on the mesh, queried, and
//! restored.

use super::{Answer, LEAVE, failed};
use crate::mesh::OrbitCondition;
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::preview::Fan;
use crate::rewrite::window::Window;
use crate::rewrite::{Fault, Inst, Machine, Message};

/// Executes instructions that set or restore values of the preview: from the one in the lower half
/// of `span` up to, but without, that in its upper half.
pub(super) fn set_preview(context: &mut Context, run: &mut Run<'_>, span: i64) -> Answer {
    let call = context.call(run);
    let (first, end) = (span as u32 as usize, (span >> 32) as usize);
    let Machine { preview, stack, buffers, .. } = &mut *run.machine;
    let mut window = Window::at(stack, call.base);
    for (at, inst) in (first..end).zip(call.code.insts.get(first..end).unwrap_or_default()) {
        let mesh = &mut *run.mesh;
        let done = match (*inst, &mut window) {
            (Inst::PreviewClear, _) => {
                preview.clear();
                Ok(())
            }
            (Inst::PreviewUndo, _) => {
                preview.undo(mesh);
                Ok(())
            }
            (Inst::PreviewNew { to }, Some(w)) => {
                w.set_id(to, preview.add());
                Ok(())
            }
            (Inst::PreviewStore { field, halfedge, value }, Some(w)) => {
                preview.store(mesh, field, w.id(halfedge), w.id(value))
            }
            (Inst::PreviewStoreHalfedge { of, element, value }, Some(w)) => {
                preview.store_halfedge(mesh, of, w.id(element), w.id(value))
            }
            (Inst::PreviewStoreHole { face, hole }, Some(w)) => {
                preview.store_hole(mesh, w.id(face), hole)
            }
            (Inst::PreviewStoreAll { field, buffer, value }, Some(w)) => {
                match buffers.get(call.buffers + usize::from(buffer)) {
                    Some(all) => preview.store_all(mesh, field, all, w.id(value)),
                    None => Err(Fault::Malformed),
                }
            }
            _ => Err(Fault::Malformed),
        };
        if let Err(fault) = done {
            preview.undo(mesh);
            return Err(failed(context, run, at as i64, fault.into()));
        }
    }
    Ok(0)
}

/// Begins a preview in which nothing is set.
pub(super) fn clear_preview(_: &mut Context, run: &mut Run<'_>) -> Answer {
    run.machine.preview.clear();
    Ok(0)
}

/// Whether a condition, by its number, would hold; [`LEAVE`] if there is no answer and the machine
/// has to determine the trap.
pub(super) fn foresee(
    _: &mut Context,
    run: &mut Run<'_>,
    condition: i64,
    element: i64,
    at: i64,
) -> Answer {
    let Some(&condition) = OrbitCondition::ALL.get(condition as usize) else {
        return Ok(LEAVE);
    };
    let holds = run.machine.preview.foresees(run.mesh, condition, element as u32, at as u32);
    Ok(holds.map_or(LEAVE, i64::from))
}

/// The greatest number of conditions that [`foresee_star`] answers, and the bits of each.
pub(in super::super) const MOST_ASKED: usize = 8;
pub(in super::super) const BITS: usize = 8;

/// The number of conditions of a vertex that would hold before the first that would not: each is
/// 1 more than its number, the first in the lowest bits. The instruction at `inst` asks the first,
/// and every second one from there on the next.
pub(super) fn foresee_star(
    context: &mut Context,
    run: &mut Run<'_>,
    conditions: i64,
    vertex: i64,
    inst: i64,
) -> Answer {
    let all = (0..MOST_ASKED).map(|place| conditions >> (place * BITS) & 0xff);
    let all = all.map_while(|number| usize::try_from(number - 1).ok());
    let place_of = |asked: OrbitCondition| all.clone().position(|number| number == asked as usize);
    if let Some(corners) = place_of(OrbitCondition::CornersDiffer) {
        let fan = run.machine.preview.fan(run.mesh, vertex as u32);
        match (fan, place_of(OrbitCondition::NeighborsDiffer)) {
            (Fan::Simple, _) => return Ok(MOST_ASKED as i64),
            (Fan::Meeting, Some(place)) if place < corners => return Ok(place as i64),
            _ => {}
        }
    }
    for (count, number) in (0..).zip(all) {
        let Some(&condition) = OrbitCondition::ALL.get(number) else {
            return Err(failed(context, run, inst, Message::Malformed));
        };
        let Run { machine, mesh, .. } = &mut *run;
        match machine.preview.foresees(mesh, condition, vertex as u32, vertex as u32) {
            Ok(true) => {}
            Ok(false) => return Ok(count),
            Err(fault) => return Err(failed(context, run, inst + 2 * count, fault.into())),
        }
    }
    Ok(MOST_ASKED as i64)
}
