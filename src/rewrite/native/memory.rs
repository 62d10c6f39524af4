//! Memory accesses, and calls of functions of the machine.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F64, I8, I64};
use cranelift_codegen::ir::{
    AbiParam, AliasRegion, AliasRegionData, InstBuilder, MemFlagsData, SigRef, Signature,
    StackSlotData, StackSlotKind, Type, Value,
};

use super::access::TABLES;
use super::translate::{Region, Translator};

impl Translator<'_, '_> {
    pub(super) fn flags(&mut self, region: Region) -> MemFlagsData {
        let data = AliasRegionData { user_id: region as u32, description: "".into() };
        let region: AliasRegion = self.b.func.dfg.alias_regions.insert(data);
        MemFlagsData::trusted().with_alias_region(Some(region))
    }

    /// A value in memory, at an offset in bytes.
    pub(super) fn load(&mut self, ty: Type, region: Region, place: Value, offset: usize) -> Value {
        let flags = self.flags(region);
        self.b.ins().load(ty, flags, place, offset as i32)
    }

    pub(super) fn store(&mut self, region: Region, value: Value, place: Value, offset: usize) {
        let flags = self.flags(region);
        self.b.ins().store(flags, value, place, offset as i32);
    }

    /// A field of the context.
    pub(super) fn field(&mut self, offset: usize) -> Value {
        self.load(I64, Region::Context, self.context, offset)
    }

    /// A field of the context that is constant while native code runs.
    pub(super) fn constant_field(&mut self, offset: usize) -> Value {
        let flags = self.flags(Region::Context).with_readonly().with_can_move();
        self.b.ins().load(I64, flags, self.context, offset as i32)
    }

    /// The address or length of a table; both are constant in code that adds nothing.
    pub(super) fn table_field(&mut self, offset: usize) -> Value {
        match self.may_add {
            true => self.field(TABLES + offset),
            false => self.constant_field(TABLES + offset),
        }
    }

    pub(super) fn set_field(&mut self, offset: usize, value: Value) {
        self.store(Region::Context, value, self.context, offset);
    }

    /// Moves an address in the context.
    pub(super) fn move_field(&mut self, offset: usize, by: i64) {
        if by != 0 {
            let value = self.field(offset);
            let value = self.b.ins().iadd_imm_s(value, by);
            self.set_field(offset, value);
        }
    }

    pub(super) fn leave_if_negative(&mut self, answer: Value) {
        let failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, answer, 0);
        let (leave, on) = (self.leave, self.b.create_block());
        self.b.ins().brif(failed, leave, &[], on, &[]);
        self.go_on(on);
    }

    /// Calls a stub with the place of the current instruction, and leaves if it traps.
    pub(super) fn call_here(&mut self, stub: usize) -> Value {
        let number = self.b.ins().iconst(I64, self.at as i64);
        let answer = self.call_stub(stub, &[number]);
        self.leave_if_negative(answer);
        answer
    }

    /// Continues unless a stub has answered [`LEAVE`](super::stubs::LEAVE): then the machine
    /// determines the trap.
    pub(super) fn or_fault_if_negative(&mut self, answer: Value) {
        let done = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, answer, 0);
        self.or_fault(done);
    }

    pub(super) fn signature(&mut self, params: &[Type], returns: &[Type]) -> SigRef {
        let mut signature = Signature::new(self.conv);
        signature.params.extend(params.iter().map(|&ty| AbiParam::new(ty)));
        signature.returns.extend(returns.iter().map(|&ty| AbiParam::new(ty)));
        self.b.import_signature(signature)
    }

    pub(super) fn call(&mut self, stub: usize, signature: SigRef, args: &[Value]) -> Vec<Value> {
        let stub = self.b.ins().iconst(I64, stub as i64);
        let call = self.b.ins().call_indirect(signature, stub, args);
        self.b.inst_results(call).to_vec()
    }

    /// Calls a stub with the context and ints, which answers with an int.
    pub(super) fn call_stub(&mut self, stub: usize, args: &[Value]) -> Value {
        let params = vec![I64; args.len() + 1];
        let signature = self.signature(&params, &[I64]);
        let mut all = vec![self.context];
        all.extend_from_slice(args);
        self.call(stub, signature, &all)[0]
    }

    /// Calls a function of reals.
    pub(super) fn call_real(&mut self, stub: usize, args: &[Value]) -> Value {
        let params = vec![F64; args.len()];
        let signature = self.signature(&params, &[F64]);
        self.call(stub, signature, args)[0]
    }

    /// The address of a place for three reals in the frame.
    pub(super) fn place_of_vector(&mut self) -> Value {
        let slot = StackSlotData::new(StackSlotKind::ExplicitSlot, 24, 3);
        let slot = self.b.create_sized_stack_slot(slot);
        self.b.ins().stack_addr(I64, slot, 0)
    }

    pub(super) fn byte(&mut self, flags: MemFlagsData, address: Value, offset: usize) -> Value {
        let byte = self.b.ins().load(I8, flags, address, offset as i32);
        self.b.ins().uextend(I64, byte)
    }
}
