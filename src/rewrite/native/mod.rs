//! Native code, made by Cranelift from register code while the program runs.
//!
//! It decides nothing again: an instruction is spelled in those of the processor, or the machine
//! takes it ([`stubs::step`]). So results are the same, bit for bit, on both.
//!
//! # Safety
//!
//! This is the only place of the crate with `unsafe`. Why it is sound:
//!
//! * Native code reads and writes the window of its call, its context, the machine's progress, and
//!   the tables of the mesh; it reads buffers. A register is a constant offset into the window,
//!   which is never shorter than a register can name. The number of an element is tested against
//!   the length of its table before an address is computed from it, unless the same number has been
//!   tested in this call; tables do not become shorter while code runs that uses such a number.
//!   Nothing depends on a proof or on the mesh being valid.
//! * What native code is not given, the machine does, in safe code. After each such call the
//!   addresses of window and tables are taken anew, since they may have moved. Those of tables are
//!   kept in code that neither adds elements nor makes room for some, nor calls or asks what does ([`operands::Surroundings::may_add`]):
//!   nothing else moves them.
//! * The part of a loop keeps slots behind those of the machine's list, as long as there is room for
//!   them, and the machine adds their number to its length when native code has been left, or before
//!   it makes more room.
//! * Lists of neighbors are read for vertices that have a list, from its begin to its end, in loops
//!   that nobody enters in between ([`neighbors`]).
//! * A place in a buffer is tested against its length before it is read. The slots of a buffer are
//!   looked for anew after each instruction that may have changed it; others than those of the code
//!   that names it leave it alone.
//! * A stub tells journals and drains of a write before it is done. It notes what is there and moves
//!   no table.
//! * Native code calls a function or an operation itself only where [`Made::entries`] has its
//!   address. That place lives as long as the caller: functions stand in one list with it, which
//!   code at the top keeps; operations in the plans for which it was made ([`Expected`]), and it is
//!   entered only if these are the machine's. What is called was made for the same attributes as
//!   the caller expects of it, or the address is not there ([`Made::expected`]). Its window is
//!   within the stack, which is tested before, as is how many calls are nested, so that native code
//!   takes a bounded part of the processor's stack.
//! * An operation that a script calls runs within the context of the script, which is made that of
//!   the operation and then that of the script again; the addresses that it holds stay those of what
//!   is there. An operation with other needs has a run of its own.
//! * It may begin at a loop ([`Compiled::entry_at`]): there nothing is known, and every register
//!   that is read later is taken from the window, where the machine has left it.
//! * While native code runs, nobody else has the machine and the mesh: it is entered with `&mut` of
//!   both, which are not used until it returns but by the functions that it calls.
//! * Its memory is written, then executable, never both. It is freed with the value that owns it,
//!   which is borrowed while it runs.
//! * Where several threads take the turns of a loop, each has a machine of its own, and the mesh
//!   through a copy of its head, which says where the tables lie. The code that they run writes to
//!   no table, and the mesh is borrowed until all are done: [`spread`] says more.
//! * No panic crosses it: the functions that it calls keep one, and it goes on behind.
//!
//! What native code reads and writes can be watched: valgrind finds nothing in
//!
//! ```text
//! valgrind --smc-check=all-non-file --error-exitcode=9 \
//!   target/release/hedgerow run --engine native std/simplify.hedge --set ratio=0.5 \
//!   examples/meshes/bunny.obj
//! ```
//!
//! and the same for `std/remesh.hedge`, `std/subdivide.hedge::loop_subdivide`, `std/smooth.hedge`.
//!
//! # Processors
//!
//! It is made for x86-64 and 64-bit ARM; elsewhere the machine runs all. The tests run on the second
//! by emulation, too (Debian: `gcc-aarch64-linux-gnu`, `qemu-user-static`, which starts the programs
//! of that processor, and `rustup target add aarch64-unknown-linux-gnu`):
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
mod guards;
mod inline;
mod lists;
mod liveness;
mod matrices;
mod memory;
mod neighbors;
mod operands;
mod registers;
mod spread;
mod stubs;
mod translate;
mod values;
mod walks;
mod writes;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};

use compile::{Compiled, Expected};
pub(crate) use context::Scratch;
pub(crate) use neighbors::Neighbors;

use super::{Code, Inst};

/// The ways in which a code is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Variant {
    /// Nobody is told what is written.
    Plain,
    /// Journals and drains are told what is written.
    Careful,
    /// It ends at its first write.
    Dry,
}

/// How often a code runs on the machine, or how many turns its loops take there, before it is
/// compiled, which takes as long as some thousand do. Tests are to come there soon.
const RUNS: u32 = if cfg!(debug_assertions) { 40 } else { 2000 };

/// How deep native code may be nested: beyond, the machine runs what is called, which takes no
/// more of the stack for functions that call each other.
const DEPTH: usize = 64;

/// The native code of a code, made when it has run often enough.
#[derive(Default)]
pub struct Native(OnceLock<Box<Made>>);

#[derive(Default)]
struct Made {
    /// The number of its runs and of the turns of its loops, up to [`RUNS`].
    runs: AtomicU32,
    /// True if it may write to the mesh, or what it calls.
    writes: bool,
    /// True if it begins a drain itself.
    drains: bool,
    variants: [OnceLock<Option<Compiled>>; 3],
    /// By variant the address where native code that calls this function, or operation, may enter
    /// it; 0 if there is none.
    entries: [AtomicUsize; 3],
    /// What those may take for granted.
    expected: OnceLock<Expected>,
}

impl Clone for Native {
    /// Nothing: who copies a code may change it.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for Native {
    /// Code is the same whether it has been compiled or not.
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
    fn made(&self, code: &Code) -> &Made {
        self.0.get_or_init(|| {
            Box::new(Made {
                writes: code.insts.iter().any(may_write),
                drains: code.opens_drain(),
                ..Made::default()
            })
        })
    }
}

/// Whether an instruction may write to the mesh.
fn may_write(inst: &Inst) -> bool {
    inst.is_observed_write() || matches!(inst, Inst::Call { .. } | Inst::Apply { .. })
}

impl Made {
    /// The variant that does what is wanted of one.
    fn variant(&self, wanted: Variant) -> Variant {
        match wanted {
            Variant::Dry => Variant::Dry,
            _ if self.drains => Variant::Careful,
            _ if !self.writes => Variant::Plain,
            wanted => wanted,
        }
    }

    /// Counts a run, or a turn of a loop. True if it pays to compile the code now.
    #[inline]
    fn count(&self) -> bool {
        let runs = self.runs.load(Ordering::Relaxed);
        if runs < RUNS {
            self.runs.store(runs + 1, Ordering::Relaxed);
        }
        runs >= RUNS
    }

    /// Lets native code call it, if that expects of it what it was made for.
    fn publish(&self, variant: Variant, compiled: &Compiled) {
        if compiled.is_callable
            && self.expected.get_or_init(|| compiled.expected.clone()) == &compiled.expected
        {
            self.entries[variant as usize].store(compiled.entry as usize, Ordering::Release);
        }
    }
}
