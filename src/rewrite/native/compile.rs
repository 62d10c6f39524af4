//! Native code in memory.

use std::sync::{Arc, Mutex, OnceLock, Weak};

use cranelift_codegen::ir::AbiParam;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{Linkage, Module, default_libcall_names};

use super::Variant;
use super::calls::gives;
use super::context::Context;
use super::operands::Environment;
use super::translate::{Translator, Unit};
use crate::mesh::{AttributeType, ElementKind};
use crate::rewrite::engine::CodeKind;
use crate::rewrite::{Code, Function, Inst, Plan, Plans, key_paths};

/// Code with more instructions or registers than this is left to the machine: compiling it would
/// take longer than running it.
const MOST_INSTS: usize = 4000;
const MOST_REGISTERS: u16 = 1000;

/// The entry point of native code. The number says where to begin: 0 at the start, others as
/// returned by [`Compiled::entry_at`]. Its answer is one of those listed in [`super::translate`].
pub(super) type Entry = unsafe extern "C" fn(*mut Context, i64) -> i64;

/// The native code of a code.
pub(super) struct Compiled {
    pub(super) entry: Entry,
    /// The expectations with which it was compiled.
    pub(super) expected: Expected,
    /// The attributes that it, or a function that it calls, uses.
    pub(super) attributes: Vec<u16>,
    /// Whether other native code may call it.
    pub(super) is_callable: bool,
    /// The instructions at which it may be entered, in order.
    entries: Vec<u32>,
    /// Keeps the functions alive that it may call, directly or indirectly; `None` for a function,
    /// which is itself among them.
    functions: Option<Arc<[Function]>>,
    first_function: usize,
    /// The operations that it may call: as long as this is kept, no other plans can be at their
    /// address.
    plans: Weak<[Option<Plan>]>,
    memory: Memory,
}

/// Everything besides the code that the operands of a code, and of the functions that it calls,
/// depend on.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Expected {
    /// The types of the attributes, by number.
    types: Vec<(u16, Option<(ElementKind, AttributeType)>)>,
    /// The number of slots of the arguments of each operation.
    params: Vec<(u16, u16)>,
    /// The address of the plans of the operations, if it calls any.
    plans: Option<usize>,
}

/// The memory of native code: it is written, then made executable, and never both.
struct Memory(Mutex<Option<JITModule>>);

impl Drop for Memory {
    fn drop(&mut self) {
        let module = self.0.get_mut().unwrap_or_else(|poisoned| poisoned.into_inner()).take();
        if let Some(module) = module {
            // SAFETY: the code runs only while the `Compiled` that owns this memory is borrowed, so
            // it does not run now; `entry`, the only address of it, is dropped with it.
            unsafe { module.free_memory() };
        }
    }
}

impl Compiled {
    /// Compiles native code; `None` for code that is left to the machine, or on a processor that
    /// Cranelift does not support.
    pub(super) fn make(unit: Unit<'_>, variant: Variant, plans: &Plans) -> Option<Self> {
        let code = unit.code;
        if code.insts.len() > MOST_INSTS || code.registers > MOST_REGISTERS {
            return None;
        }
        // The functions that it enters must be those that it keeps alive.
        let functions = unit.environment.functions.as_ptr();
        if unit.kind != CodeKind::Function && code.functions.as_ptr() != functions {
            return None;
        }
        // The same for the plans.
        if plans.as_ptr() != unit.environment.plans.as_ptr() {
            return None;
        }
        // Keys without paths need the machine, which notes their reads.
        let drains = key_paths::drains(code, unit.environment.functions, plans);
        if drains.iter().any(|(_, why)| why.is_some()) {
            return None;
        }
        let isa = isa()?;
        let conv = isa.default_call_conv();
        let mut module = JITModule::new(JITBuilder::with_isa(isa, default_libcall_names()));
        let mut context = module.make_context();
        context.func.signature.call_conv = conv;
        context.func.signature.params.extend([AbiParam::new(I64); 2]);
        context.func.signature.returns.push(AbiParam::new(I64));
        let mut builder = FunctionBuilderContext::new();
        let function = FunctionBuilder::new(&mut context.func, &mut builder);
        Translator::translate(function, unit, variant, conv).finalize(module.target_config());
        let signature = context.func.signature.clone();
        let name = module.declare_function("code", Linkage::Local, &signature).ok()?;
        module.define_function(name, &mut context).ok()?;
        module.finalize_definitions().ok()?;
        let start = module.get_finalized_function(name);
        // SAFETY: the function that has just been defined takes a pointer and a number and returns
        // a number, of 64 bits each, in the convention of `extern "C"` here.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(start) };
        let expected = Expected::of(code, &unit.environment);
        let attributes = expected.types.iter().map(|(attribute, _)| *attribute).collect();
        let functions = (unit.kind != CodeKind::Function).then(|| Arc::clone(&code.functions));
        Some(Self {
            entry,
            expected,
            attributes,
            is_callable: match unit.kind {
                CodeKind::Function => gives(code).is_some(),
                CodeKind::Whole | CodeKind::Dry => is_flat(code),
                CodeKind::Script => false,
            },
            entries: entries(code),
            functions,
            first_function: unit.environment.functions.as_ptr().addr(),
            plans: Arc::downgrade(plans),
            memory: Memory(Mutex::new(Some(module))),
        })
    }

    /// Whether it was compiled for these attributes, operations and functions.
    #[inline]
    pub(super) fn fits(&self, environment: &Environment<'_>) -> bool {
        let (_, _, _) = (&self.memory, &self.functions, &self.plans);
        self.first_function == environment.functions.as_ptr().addr()
            && self.expected.holds(environment)
    }

    /// The number of the entry at an instruction.
    pub(super) fn entry_at(&self, inst: usize) -> Option<i64> {
        self.entries.binary_search(&u32::try_from(inst).ok()?).ok().map(|at| at as i64 + 1)
    }
}

/// The instructions after the iterations of loops, at which native code may be entered.
pub(super) fn entries(code: &Code) -> Vec<u32> {
    let insts = code.insts.iter().enumerate().take(code.insts.len().saturating_sub(1));
    let iterations = insts.filter(|(_, inst)| matches!(inst, Inst::Iteration { .. } | Inst::Tick));
    iterations.map(|(at, _)| at as u32 + 1).collect()
}

/// Whether a code calls nothing.
pub(super) fn is_flat(code: &Code) -> bool {
    let calls =
        |inst: &Inst| matches!(inst, Inst::Call { .. } | Inst::Apply { .. } | Inst::Try { .. });
    !code.insts.iter().any(calls)
}

/// The attributes that a code uses itself.
fn attributes_in(code: &Code) -> impl Iterator<Item = u16> {
    code.insts.iter().filter_map(|inst| match *inst {
        Inst::LoadAttribute { attribute, .. }
        | Inst::StoreAttribute { attribute, .. }
        | Inst::DeferAttribute { attribute, .. } => Some(attribute),
        _ => None,
    })
}

impl Expected {
    /// The expectations of a code in its current environment.
    pub(super) fn of(code: &Code, environment: &Environment<'_>) -> Self {
        let mut expected = Self::default();
        for code in code.with_called_of(environment.functions) {
            let used = attributes_in(code);
            expected.types.extend(used.map(|used| (used, environment.column(used))));
            for inst in &code.insts {
                let (Inst::Apply { op, .. } | Inst::Try { op, .. }) = *inst else { continue };
                expected.params.push((op, environment.params_of_op(op)));
                expected.plans = Some(environment.plans.as_ptr().addr());
                // Native code of the operation finds its attributes in the context of the caller.
                let plan = environment.plans.get(usize::from(op));
                if let Some(Some(plan)) = plan
                    && plan.steps.is_none()
                {
                    let used = plan.code.with_called().into_iter().flat_map(attributes_in);
                    expected.types.extend(used.map(|used| (used, environment.column(used))));
                }
            }
        }
        expected.types.sort_by_key(|(attribute, _)| *attribute);
        expected.types.dedup();
        expected.params.sort_unstable();
        expected.params.dedup();
        expected
    }

    fn holds(&self, environment: &Environment<'_>) -> bool {
        self.types.iter().all(|&(attribute, ty)| environment.column(attribute) == ty)
            && self.params.iter().all(|&(op, width)| environment.params_of_op(op) == width)
            && self.plans.is_none_or(|plans| plans == environment.plans.as_ptr().addr())
    }
}

/// The instruction set of this processor, detected once.
fn isa() -> Option<OwnedTargetIsa> {
    static ISA: OnceLock<Option<OwnedTargetIsa>> = OnceLock::new();
    let find = || {
        if !cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) {
            return None;
        }
        let mut flags = settings::builder();
        flags.set("opt_level", "speed").ok()?;
        flags.set("is_pic", "false").ok()?;
        flags.set("use_colocated_libcalls", "false").ok()?;
        flags.set("unwind_info", "false").ok()?;
        // A frame of more than a page touches each page, so that a stack overflow hits the guard
        // page.
        flags.set("enable_probestack", "true").ok()?;
        flags.set("probestack_strategy", "inline").ok()?;
        flags.set("enable_verifier", if cfg!(debug_assertions) { "true" } else { "false" }).ok()?;
        cranelift_native::builder().ok()?.finish(settings::Flags::new(flags)).ok()
    };
    ISA.get_or_init(find).clone()
}
