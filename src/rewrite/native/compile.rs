//! Native code in memory.

use std::sync::{Mutex, OnceLock};

use cranelift_codegen::ir::AbiParam;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{Linkage, Module, default_libcall_names};

use super::Variant;
use super::context::Context;
use super::operands::Surroundings;
use super::translate::{Text, Translator};
use crate::mesh::{AttributeType, ElementKind};
use crate::rewrite::{Inst, key_paths};

/// Code with more instructions or registers than this stays with the machine: to compile it would
/// take longer than it runs.
const MOST_INSTS: usize = 4000;
const MOST_REGISTERS: u16 = 1000;

/// The start of native code; its answer is one of those that [`super::translate`] lists.
pub(super) type Entry = unsafe extern "C" fn(*mut Context) -> i64;

/// The native code of a code.
pub(super) struct Compiled {
    pub(super) entry: Entry,
    /// The types of the attributes that it was made for, by number.
    types: Vec<(u16, Option<(ElementKind, AttributeType)>)>,
    /// The number of slots of the arguments of each operation that it calls.
    params: Vec<(u16, u16)>,
    memory: Memory,
}

/// The memory that native code stands in: it is written, then made executable, and never both.
struct Memory(Mutex<Option<JITModule>>);

impl Drop for Memory {
    fn drop(&mut self) {
        let module = self.0.get_mut().unwrap_or_else(|poisoned| poisoned.into_inner()).take();
        if let Some(module) = module {
            // SAFETY: the code is run by those who borrow the `Compiled` that owns this memory, so
            // nobody does now; `entry`, the only address of it, goes with it.
            unsafe { module.free_memory() };
        }
    }
}

impl Compiled {
    /// Makes native code; `None` for code that stays with the machine, or on a processor that
    /// Cranelift does not know.
    pub(super) fn make(text: Text<'_>, variant: Variant) -> Option<Self> {
        let code = text.code;
        if code.insts.len() > MOST_INSTS || code.registers > MOST_REGISTERS {
            return None;
        }
        // The machine notes what keys read that are not found by walking back.
        let drains = key_paths::drains(code, text.surroundings.functions);
        if drains.iter().any(|(_, why)| why.is_some()) {
            return None;
        }
        let variant = match variant {
            Variant::Plain if !drains.is_empty() => Variant::Careful,
            variant => variant,
        };
        let isa = isa()?;
        let conv = isa.default_call_conv();
        let mut module = JITModule::new(JITBuilder::with_isa(isa, default_libcall_names()));
        let mut context = module.make_context();
        context.func.signature.call_conv = conv;
        context.func.signature.params.push(AbiParam::new(I64));
        context.func.signature.returns.push(AbiParam::new(I64));
        let mut builder = FunctionBuilderContext::new();
        let function = FunctionBuilder::new(&mut context.func, &mut builder);
        Translator::translate(function, text, variant, conv).finalize(module.target_config());
        let signature = context.func.signature.clone();
        let name = module.declare_function("code", Linkage::Local, &signature).ok()?;
        module.define_function(name, &mut context).ok()?;
        module.finalize_definitions().ok()?;
        let start = module.get_finalized_function(name);
        // SAFETY: the function that has just been defined takes one pointer and gives one number
        // of 64 bits, in the convention of `extern "C"` here.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(start) };
        let (types, params) = expectations(text);
        Some(Self { entry, types, params, memory: Memory(Mutex::new(Some(module))) })
    }

    /// Whether it was made for these attributes and operations.
    #[inline]
    pub(super) fn fits(&self, surroundings: &Surroundings<'_>) -> bool {
        let _ = &self.memory;
        self.types.iter().all(|&(attribute, ty)| surroundings.column(attribute) == ty)
            && self.params.iter().all(|&(op, width)| surroundings.params_of_op(op) == width)
    }
}

/// The operands of these had other widths for other attributes and operations.
#[expect(clippy::type_complexity, reason = "both go to fields of one struct")]
fn expectations(
    text: Text<'_>,
) -> (Vec<(u16, Option<(ElementKind, AttributeType)>)>, Vec<(u16, u16)>) {
    let (mut types, mut params) = (Vec::new(), Vec::new());
    for inst in &text.code.insts {
        match *inst {
            Inst::LoadAttribute { attribute, .. }
            | Inst::StoreAttribute { attribute, .. }
            | Inst::HoldAttribute { attribute, .. } => {
                types.push((attribute, text.surroundings.column(attribute)));
            }
            Inst::Apply { op, .. } | Inst::Try { op, .. } => {
                params.push((op, text.surroundings.params_of_op(op)));
            }
            _ => {}
        }
    }
    types.sort_by_key(|(attribute, _)| *attribute);
    types.dedup();
    params.sort_unstable();
    params.dedup();
    (types, params)
}

/// This processor, found out once.
fn isa() -> Option<OwnedTargetIsa> {
    static ISA: OnceLock<Option<OwnedTargetIsa>> = OnceLock::new();
    let find = || {
        if !cfg!(target_pointer_width = "64") || cfg!(target_endian = "big") {
            return None;
        }
        let mut flags = settings::builder();
        flags.set("opt_level", "speed").ok()?;
        flags.set("is_pic", "false").ok()?;
        flags.set("use_colocated_libcalls", "false").ok()?;
        flags.set("unwind_info", "false").ok()?;
        // A frame of more than a page touches each, so that the stack ends at its guard.
        flags.set("enable_probestack", "true").ok()?;
        flags.set("probestack_strategy", "inline").ok()?;
        flags.set("enable_verifier", if cfg!(debug_assertions) { "true" } else { "false" }).ok()?;
        let builder = cranelift_native::builder().ok()?;
        builder.finish(settings::Flags::new(flags)).ok()
    };
    ISA.get_or_init(find).clone()
}
