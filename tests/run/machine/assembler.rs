//! Code as it is put together: registers, labels, traps.

use super::*;

#[test]
fn released_registers_are_taken_again_and_constants_are_not() {
    let mut asm = Assembler::new();
    let param = asm.reg();
    let mark = asm.mark();
    let (a, b) = (asm.vec(), asm.reg());
    let seven = asm.constant_int(7);
    asm.release(mark);
    assert_eq!((param, a, b, seven), (Reg(0), Reg(1), Reg(4), Reg(5)));
    let eight = asm.constant_int(8);
    assert_eq!(eight, Reg(6), "a free register may have been written to before");
    assert_eq!(asm.block(5), Reg(7), "five in a row fit only behind");
    assert_eq!(asm.vec(), Reg(1));
    assert_eq!(asm.constant_int(7), seven);
    assert_eq!(asm.finish().unwrap().registers, 12);
}

#[test]
fn labels_and_traps_move_behind_the_constants() {
    let mut asm = Assembler::new();
    let (head, end) = (asm.label(), asm.label());
    let yes = asm.constant_bool(true);
    asm.bind(head);
    asm.trap_at(9, Inst::JumpUnless { condition: yes, to: end });
    asm.emit(Inst::Jump { to: head });
    let code = asm.finish().unwrap();
    assert_eq!(
        code.insts[1..],
        [Inst::JumpUnless { condition: yes, to: Label(3) }, Inst::Jump { to: Label(1) }]
    );
    assert_eq!((code.place(1), code.place(2)), (Some(9), None));
}

#[test]
fn too_many_registers_are_an_error() {
    let mut asm = Assembler::new();
    for _ in 0..=u16::MAX {
        asm.reg();
    }
    assert_eq!(asm.finish(), Err(TooLarge));
}
