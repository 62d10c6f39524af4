//! Native code, compiled by Cranelift from register code while the program runs.
//!
//! Semantics are not defined a second time: an instruction is translated to those of the processor,
//! or the machine executes it ([`stubs::step`]). So the results of both are the same, bit for bit.
//!
//! # Safety
//!
//! Besides lists, loops in parts, prefetching and the allocator of the program, this is the only
//! module of the crate with `unsafe`. It is sound for these reasons:
//!
//! * Native code reads and writes the window of its call, its context, the machine's progress, and
//!   the tables of the mesh, and lists. A register is a constant offset into the window,
//!   which always has all slots that a register can address. The number of an element is tested
//!   against the length of its table before an address is computed from it, unless the same number
//!   has been tested in this call; tables do not shrink while code runs that uses such a number.
//!   Nothing depends on a proof or on the mesh being valid.
//! * Everything else is done by the machine, in safe code. After each call of the machine the
//!   addresses of the window and the tables are loaded again, since they may have moved. Addresses
//!   of tables are kept across such calls only in code that neither adds elements nor makes room
//!   for some, nor calls or asks anything that does ([`operands::Environment::may_add`]): nothing
//!   else moves tables.
//! * Lists of neighbors are read only for vertices that have a list, from its start to its end
//!   ([`neighbors`]). Where native code takes over in the middle of such a loop, the machine has
//!   read the same list: a machine has lists for a whole range of iterations, or for none.
//! * Native code accesses a [`List`](super::List) in place: it reads below its length, and appends
//!   within its capacity. The lists of the running code are those that it has asked for at its
//!   start; their address is loaded again after each call that may have added some.
//! * New elements are taken from spare slots behind the last element, which a stub appends to the
//!   tables ([`context::Context::append`]); until then, native code has a smaller length than the
//!   table. Whatever else looks at the mesh first gets the spare slots back
//!   ([`context::Context::settle`]).
//! * A stub notifies journals and drains of a write before the write. It only records and moves no
//!   table.
//! * Native code calls a function or an operation directly only where [`Compilation::entries`] has
//!   its address. The entry lives as long as the caller: functions are in one list with the caller,
//!   which the script or operation holds; operations are in the plans for which the caller was
//!   compiled ([`Expected`]), and native code is entered only if these are the machine's plans. The
//!   callee was compiled for the same attributes as the caller expects, or its address is not there
//!   ([`Compilation::expected`]). The window of the callee is within the stack, which is tested
//!   before the call, as is the nesting depth, so that native code uses a bounded amount of the
//!   processor's stack, which it has from where it is entered ([`LEAST_STACK`]).
//! * An operation that a script calls uses the context of the script, which becomes that of the
//!   operation and afterwards that of the script again; the addresses in it stay valid. An
//!   operation that needs more gets a run of its own.
//! * Native code may be entered at a loop ([`Compiled::entry_at`]): there nothing is known about
//!   the registers, and every register that is read later is loaded from the window, where the
//!   machine has left it.
//! * While native code runs, nothing else has access to the machine and the mesh: native code is
//!   entered with `&mut` to both, which are used only by the functions that it calls until it
//!   returns.
//! * The memory of native code is first writable, then executable, never both. It is freed with the
//!   value that owns it, which is borrowed while the code runs.
//! * Where several threads run the iterations of a loop, each has a machine of its own, and
//!   accesses the mesh through a copy of its head, which has the addresses of the tables. The code
//!   that they run writes to no table, and the mesh is borrowed until all are done: see
//!   `rewrite/spread.rs`.
//! * No panic unwinds through native code: the functions that it calls catch a panic, and it is
//!   resumed after native code has been left.
//!
//! The memory accesses of native code can be checked: valgrind reports no error in
//!
//! ```text
//! valgrind --smc-check=all-non-file --error-exitcode=9 \
//!   target/release/hedgerow run --engine native std/simplify.hedge --set ratio=0.5 \
//!   examples/meshes/bunny.obj
//! ```
//!
//! nor in the same command with `std/remesh.hedge`, `std/subdivide.hedge::loop_subdivide` or
//! `std/smooth.hedge`.
//!
//! # Processors
//!
//! Native code is available on x86-64 and 64-bit ARM; elsewhere the machine runs everything. For
//! 64-bit ARM the tests can be run by emulation (Debian: `gcc-aarch64-linux-gnu`,
//! `qemu-user-static`, which runs programs of that processor; `rustup target add
//! aarch64-unknown-linux-gnu`):
//!
//! ```text
//! export QEMU_LD_PREFIX=/usr/aarch64-linux-gnu CC_aarch64_unknown_linux_gnu=aarch64-linux-gnu-gcc
//! CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc \
//!   cargo test --target aarch64-unknown-linux-gnu
//! ```

#![allow(unsafe_code)]

mod access;
mod by_machine;
mod calls;
mod compile;
mod context;
mod elements;
mod enter;
mod facts;
mod families;
mod guards;
mod inline;
mod lists;
mod liveness;
mod matrices;
mod memory;
mod neighbors;
mod operands;
mod registers;
mod stubs;
mod translate;
mod values;
mod walks;
mod writes;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};

use compile::{Compiled, Expected};
pub(crate) use context::Scratch;

use super::{Code, Inst};

/// The variants of the native code of a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Variant {
    /// Writes are not reported.
    Plain,
    /// Journals and drains are notified of writes.
    Careful,
    /// The code ends at its first write.
    Dry,
}

/// The number of runs of a code and of iterations of its loops on the machine before it is
/// compiled, which takes as long as a few thousand of them. It is small in debug builds, so that
/// tests reach native code soon.
const RUNS: u32 = if cfg!(debug_assertions) { 40 } else { 2000 };

/// The greatest number of functions of native code that call each other directly, and the greatest
/// number of times that native code calls the machine and that native code again: beyond it the
/// machine runs the callee, which uses no more of the processor's stack.
const DEPTH: usize = 64;

/// The bytes of the processor's stack that native code has at least when the machine enters it, and
/// those that it gets where there are fewer.
const LEAST_STACK: usize = 1 << 20;
const MORE_STACK: usize = 4 << 20;

/// The native code of a code, compiled when the code has run often enough.
#[derive(Default)]
pub struct Native(OnceLock<Box<Compilation>>);

#[derive(Default)]
struct Compilation {
    /// The number of its runs and of the iterations of its loops, up to [`RUNS`].
    runs: AtomicU32,
    /// Whether the code, or something that it calls, may write to the mesh.
    writes: bool,
    /// Whether the code itself begins a drain.
    drains: bool,
    variants: [OnceLock<Option<Compiled>>; 3],
    /// By variant, the address at which native code may enter this function or operation directly;
    /// 0 if there is none.
    entries: [AtomicUsize; 3],
    /// The expectations with which its direct callers and the code itself were compiled.
    expected: OnceLock<Expected>,
}

impl Clone for Native {
    /// Returns an empty value, since a copy of the code may be changed.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for Native {
    /// Returns true: code is equal whether it has been compiled or not.
    fn eq(&self, _other: &Self) -> bool {
        true
    }
}

impl std::fmt::Debug for Native {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Native")
    }
}

impl Native {
    fn compilation(&self, code: &Code) -> &Compilation {
        self.0.get_or_init(|| {
            Box::new(Compilation {
                writes: code.insts.iter().any(may_write),
                drains: code.opens_drain(),
                ..Compilation::default()
            })
        })
    }
}

/// Whether an instruction may write to the mesh.
fn may_write(inst: &Inst) -> bool {
    inst.is_observed_write() || matches!(inst, Inst::Call { .. } | Inst::Apply { .. })
}

impl Compilation {
    /// The variant to use where `wanted` is wanted: several variants of a code may be the same.
    fn variant(&self, wanted: Variant) -> Variant {
        match wanted {
            Variant::Dry => Variant::Dry,
            _ if self.drains => Variant::Careful,
            _ if !self.writes => Variant::Plain,
            wanted => wanted,
        }
    }

    /// Counts a run, or an iteration of a loop. Returns whether it now pays to compile the code.
    #[inline]
    fn count(&self) -> bool {
        let runs = self.runs.load(Ordering::Relaxed);
        if runs < RUNS {
            self.runs.store(runs + 1, Ordering::Relaxed);
        }
        runs >= RUNS
    }

    /// Lets native code call this code directly, if it was compiled for what the callers expect.
    fn publish(&self, variant: Variant, compiled: &Compiled) {
        if compiled.is_callable
            && self.expected.get_or_init(|| compiled.expected.clone()) == &compiled.expected
        {
            self.entries[variant as usize].store(compiled.entry as usize, Ordering::Release);
        }
    }
}
