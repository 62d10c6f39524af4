//! The registers of one call, read and written by type.
//!
//! A window always has as many slots as a [`Reg`] can address, whatever number its code declares:
//! no register is ever out of range, and rustc knows it.

use glam::DVec3;

use super::Reg;

/// The number of slots that a register can address.
pub(super) const SLOTS: usize = 1 << 16;

/// The slots from the base of a call on. Those behind its own registers belong to the calls that it
/// makes.
pub(super) struct Window<'a>(&'a mut [u64; SLOTS]);

impl<'a> Window<'a> {
    /// The window at a base; `None` if the stack is too short; [`reserve`] makes room.
    #[inline]
    pub(super) fn at(stack: &'a mut [u64], base: usize) -> Option<Self> {
        stack.get_mut(base..)?.first_chunk_mut().map(Self)
    }

    #[inline]
    pub(super) fn bits(&self, reg: Reg) -> u64 {
        self.0[usize::from(reg.0)]
    }

    #[inline]
    pub(super) fn set_bits(&mut self, reg: Reg, bits: u64) {
        self.0[usize::from(reg.0)] = bits;
    }

    #[inline]
    pub(super) fn int(&self, reg: Reg) -> i64 {
        self.bits(reg) as i64
    }

    #[inline]
    pub(super) fn set_int(&mut self, reg: Reg, value: i64) {
        self.set_bits(reg, value as u64);
    }

    #[inline]
    pub(super) fn real(&self, reg: Reg) -> f64 {
        f64::from_bits(self.bits(reg))
    }

    #[inline]
    pub(super) fn set_real(&mut self, reg: Reg, value: f64) {
        self.set_bits(reg, value.to_bits());
    }

    #[inline]
    pub(super) fn truth(&self, reg: Reg) -> bool {
        self.bits(reg) != 0
    }

    #[inline]
    pub(super) fn set_truth(&mut self, reg: Reg, value: bool) {
        self.set_bits(reg, u64::from(value));
    }

    /// The number of an element.
    #[inline]
    pub(super) fn id(&self, reg: Reg) -> u32 {
        self.bits(reg) as u32
    }

    #[inline]
    pub(super) fn set_id(&mut self, reg: Reg, id: u32) {
        self.set_bits(reg, u64::from(id));
    }

    #[inline]
    pub(super) fn vector(&self, reg: Reg) -> DVec3 {
        let part = |offset| self.real(Reg(reg.0.wrapping_add(offset)));
        DVec3::new(part(0), part(1), part(2))
    }

    #[inline]
    pub(super) fn set_reals<const N: usize>(&mut self, reg: Reg, values: &[f64; N]) {
        for (offset, part) in (0..).zip(values) {
            self.set_real(Reg(reg.0.wrapping_add(offset)), *part);
        }
    }

    #[inline]
    pub(super) fn set_vector(&mut self, reg: Reg, value: DVec3) {
        self.set_reals(reg, &value.to_array());
    }
}

/// The number of slots by which the stack grows. What it has beyond the first window is enough for
/// most calls, and less than what is allocated in huge pages.
const MORE: usize = 1 << 14;

/// Makes the stack long enough for a window at `base`.
#[inline]
pub(super) fn reserve(stack: &mut Vec<u64>, base: usize) {
    if stack.len() < base + SLOTS {
        grow(stack, SLOTS + base.max(1).next_multiple_of(MORE));
    }
}

#[cold]
fn grow(stack: &mut Vec<u64>, length: usize) {
    if stack.is_empty() {
        // Memory that is zero as it comes, and is not taken before it is used.
        *stack = vec![0; length];
    } else {
        stack.reserve_exact(length - stack.len());
        stack.resize(length, 0);
    }
}
