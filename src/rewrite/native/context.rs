//! The memory that native code and the machine share during a call.

use std::any::Any;
use std::ffi::c_void;

use crate::mesh::Mesh;
use crate::mesh::tables::Tables;
use crate::rewrite::dispatch::Place;
use crate::rewrite::{Call, Machine, Phase, Trap, Watch};

/// The part that native code reads and writes itself.
#[repr(C)]
pub(super) struct Context {
    pub(super) tables: Tables,
    /// The columns of the attributes of the program, by number.
    pub(super) columns: *const Values,
    /// The number of turns of loops so far.
    pub(super) turns: *mut u32,
    /// The registers of the call.
    pub(super) window: *mut u64,
    /// The machine's [`Run`].
    pub(super) run: *mut c_void,
    /// The element that is returned; [`NOTHING`] if none is.
    pub(super) result: u64,
    /// Where a function has put what it gives: the first register, and 16 bits further the width.
    pub(super) given: u32,
    /// The refusal that counts so far, as [`noted`] spells it.
    pub(super) noted: u32,
}

/// Where the values of a column are, and how many.
#[derive(Clone, Copy)]
#[repr(C)]
pub(super) struct Values {
    pub(super) start: *mut u8,
    pub(super) count: usize,
}

/// The result of an operation that returns nothing.
pub(super) const NOTHING: u64 = u64::MAX;

/// The part that only the machine knows.
pub(super) struct Run<'r> {
    pub(super) machine: &'r mut Machine,
    pub(super) mesh: &'r mut Mesh,
    pub(super) call: Call<'r>,
    pub(super) watch: &'r mut dyn Watch,
    pub(super) columns: Vec<Values>,
    /// Why native code was left, if by a trap.
    pub(super) trap: Option<Trap>,
    /// The reason if it was left since an operation in steps refuses.
    pub(super) refused: Option<Option<u16>>,
    /// What a function of the machine panicked with: it goes on when native code has been left.
    pub(super) panic: Option<Box<dyn Any + Send>>,
}

impl Context {
    /// The context of a call. `run` must outlive it.
    pub(super) fn new(run: &mut Run<'_>) -> Self {
        Self {
            tables: run.mesh.tables(),
            columns: run.values(),
            turns: run.machine.progress.turns(),
            window: run.window(),
            run: (&raw mut *run).cast(),
            result: NOTHING,
            given: 0,
            noted: 0,
        }
    }

    /// Looks anew for what may have moved.
    #[inline]
    pub(super) fn refresh(&mut self, run: &mut Run<'_>) {
        self.tables = run.mesh.tables();
        self.columns = run.values();
        self.window = run.window();
    }

    pub(super) fn place(&self, at: usize) -> Place {
        let noted = self.noted.checked_sub(1 << 16).map(|known| {
            let phase = match known >> 16 {
                0 => Phase::Match,
                1 => Phase::Require,
                2 => Phase::Guard,
                _ => Phase::Evaluate,
            };
            (phase, known as u16)
        });
        Place { at, noted, steps: 1 }
    }
}

impl Run<'_> {
    /// The columns, looked for anew.
    #[inline]
    fn values(&mut self) -> *const Values {
        let Self { machine, mesh, columns, .. } = self;
        columns.clear();
        if !machine.columns.is_empty() {
            columns.extend(machine.columns.iter().map(|column| {
                let (start, count) = match column {
                    Some(column) => mesh.values_in_memory(*column),
                    None => (std::ptr::null_mut(), 0),
                };
                Values { start, count }
            }));
        }
        columns.as_ptr()
    }

    /// The registers of the call: a window is never shorter than a register can name.
    fn window(&mut self) -> *mut u64 {
        let stack = &mut self.machine.stack;
        crate::rewrite::window::reserve(stack, self.call.base);
        stack[self.call.base..].as_mut_ptr()
    }
}

/// A refusal as a number: one of a later phase is greater than all of earlier ones, and 0 is none.
pub(super) fn noted(noted: Option<(Phase, u16)>) -> u32 {
    noted.map_or(0, |(phase, reason)| (phase as u32 + 1) << 16 | u32::from(reason))
}
