//! What is asked again where a preview would join the stars of two vertices.

use std::sync::Arc;

use hedgerow::mesh::{ElementKind, FaceId, OrbitCondition, shape};
use support::dice::Dice;

use super::*;

/// Asks of a halfedge whether its origin would lie at one hole at most if its star were joined with
/// that of the corner after the next: by other values of one pointer alone, so that no other leads
/// from one star to the other.
fn joining(field: HalfedgeField) -> Plan {
    let written = code(1, |asm| {
        let [h, k, before, behind] = [Reg(0), asm.reg(), asm.reg(), asm.reg()];
        let [vertex, one] = [asm.reg(), asm.reg()];
        let refused = asm.label();
        let mut load = |field, to, halfedge| asm.emit(Inst::Load { field, to, halfedge });
        load(HalfedgeField::Vertex, vertex, h);
        load(HalfedgeField::Next, k, h);
        load(HalfedgeField::Next, k, k);
        load(HalfedgeField::Prev, before, h);
        load(HalfedgeField::Prev, behind, k);
        asm.emit(Inst::PreviewClear);
        let pairs = match field {
            HalfedgeField::Prev => [(h, behind), (k, before)],
            _ => {
                let [here, there] = [asm.reg(), asm.reg()];
                asm.emit(Inst::Load { field, to: here, halfedge: before });
                asm.emit(Inst::Load { field, to: there, halfedge: behind });
                [(before, there), (behind, here)]
            }
        };
        for (halfedge, value) in pairs {
            asm.emit(Inst::PreviewStore { field, halfedge, value });
        }
        let condition = OrbitCondition::OneHole;
        asm.emit(Inst::Foresee { condition, to: one, element: vertex, at: vertex });
        asm.emit(Inst::PreviewUndo);
        asm.emit(Inst::Expect { condition: one, refusal: 0, otherwise: refused });
        asm.emit(Inst::Return { result: None });
        asm.bind(refused);
        asm.emit(Inst::Refuse);
    });
    plan("joining", &[1], &[("two holes", Phase::Guard)], written)
}

#[test]
fn what_a_pointer_of_the_preview_leads_to_is_followed_back() {
    let mut dice = Dice(9);
    for field in [HalfedgeField::Prev, HalfedgeField::Twin] {
        let plan = joining(field);
        let kind = ElementKind::Halfedge;
        let question = Bounded::new(&plan, kind, 0).expect("its paths are bounded");
        for mut mesh in [shape::torus(8, 9), shape::grid(7, 8)] {
            let mut asked = Asked::new(kind, Some(Arc::new(question.clone())), [].into_iter());
            let mut machine = Machine::default();
            let mut kept = vec![None; mesh.capacity(kind)];
            let (mut refused, mut again) = (0, 0);
            for turn in 0..60 {
                let mark = mesh.open_journal();
                let face = FaceId(dice.below(mesh.capacity(ElementKind::Face)) as u32);
                mesh.set_hole(face, !mesh.is_hole(face) && dice.below(3) > 0);
                mesh.each_written(&mark, |written| asked.note(&mesh, written));
                mesh.keep(mark);
                while let Some(id) = asked.next_stale(&mesh, &[0]) {
                    let args = [u64::from(id)];
                    let (question, noted) = ((&plan, args.as_slice()), (&mut asked, id));
                    let answer = machine.ask_again(&mut mesh, question, noted, &mut Unwatched);
                    kept[id as usize] = Some(answer.unwrap());
                    again += usize::from(turn > 0);
                }
                for id in 0..kept.len() as u64 {
                    let anew = machine.ask(&mut mesh, &plan, &[id], &mut Unwatched).unwrap();
                    assert_eq!(kept[id as usize], Some(anew), "{field:?}: {id} after {face:?}");
                    refused += usize::from(matches!(anew, Outcome::Refused { .. }));
                }
            }
            assert!(refused > 500, "{refused}");
            // Most are not asked again.
            assert!(again < 60 * kept.len() / 3, "{again}");
        }
    }
}
