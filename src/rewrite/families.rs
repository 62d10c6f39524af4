//! Families: buffers with one slot for each index of a cycle.

use super::{Fault, Inst, List, Machine, Message, Span, Walk, access, memory};
use crate::mesh::{ElementKind, Mesh};

/// The index plus the shift, modulo `length`.
pub(super) fn place(length: usize, index: i64, shift: i16) -> Result<usize, Fault> {
    let length = i64::try_from(length).unwrap_or(i64::MAX);
    match length {
        0 => Err(Fault::OutOfRange),
        _ => Ok(index.saturating_add(i64::from(shift)).rem_euclid(length) as usize),
    }
}

/// Appends every `period`-th slot from `first` on, rotated so that the first one is at the index
/// `turn`.
pub fn deal(from: &[u64], [first, period]: [u16; 2], turn: i16, to: &mut Vec<u64>) {
    let start = to.len();
    let period = usize::from(period).max(1);
    to.extend(from.iter().skip(usize::from(first)).step_by(period));
    let dealt = &mut to[start..];
    if let Ok(turn) = place(dealt.len(), 0, turn) {
        dealt.rotate_right(turn);
    }
}

/// Whether no two slots are equal. Sorts the slots.
pub(super) fn are_distinct(slots: &mut [u64]) -> bool {
    slots.sort_unstable();
    slots.windows(2).all(|pair| pair[0] != pair[1])
}

/// The part of a buffer that belongs to an index.
pub fn part<'b>(
    halfedges: &'b [u64],
    ends: &[u64],
    index: i64,
    span: Span,
) -> Result<&'b [u64], Fault> {
    let at = place(ends.len(), index, span.shift)?;
    let end = ends[at] as usize;
    let start = at.checked_sub(1).map_or(0, |before| ends[before] as usize);
    halfedges.get(start..end).ok_or(Fault::OutOfRange)
}

/// Whether a walk once around from the first of the halfedges meets all others in their order.
pub(super) fn meets_all(mesh: &Mesh, walk: Walk, halfedges: &[u64]) -> Result<bool, Fault> {
    let Some((&first, rest)) = halfedges.split_first() else { return Ok(true) };
    let mut open = rest.iter().peekable();
    let mut at = first as u32;
    for _ in 0..mesh.capacity(ElementKind::Halfedge) {
        at = access::step(mesh, walk, at)?;
        if u64::from(at) == first {
            return Ok(open.next().is_none());
        }
        if open.peek() == Some(&&u64::from(at)) {
            open.next();
        }
    }
    Err(Fault::Endless)
}

impl Machine {
    /// Executes an instruction that empties a buffer of the running code or fills it with members;
    /// the buffers of the code begin at `base`.
    pub(super) fn fill(
        &mut self,
        mesh: &mut Mesh,
        base: usize,
        inst: &Inst,
    ) -> Result<(), Message> {
        let at = |buffer: u16| base + usize::from(buffer);
        let length = |buffer| self.buffers.get(at(buffer)).map_or(0, |list| list.len());
        let (to, is_emptied, count) = match *inst {
            Inst::BufferClear { buffer } => (at(buffer), true, 0),
            Inst::BufferNew { cycle, buffer, .. } => (at(buffer), true, length(cycle)),
            Inst::BufferAppend { from, to } => (at(to), false, length(from)),
            Inst::BufferStride { from, to, period, .. } => {
                (at(to), false, length(from).div_ceil(period.max(1).into()))
            }
            _ => return Err(Message::Malformed),
        };
        let list = self.buffers.get_mut(to).ok_or(Message::Malformed)?;
        if is_emptied {
            list.clear();
        }
        memory::for_list(&mut self.buffers, to, count, (mesh, &self.drains, self.memory))?;
        match *inst {
            Inst::BufferNew { kind, .. } => {
                let Self { buffers, created, drains, .. } = self;
                let new = &mut buffers[to].grow();
                access::create_all(mesh, (kind, count), new, created, drains)?;
            }
            Inst::BufferAppend { from, .. } => {
                let [from, to] = self.two_buffers(at(from), to)?;
                to.grow().extend_from_slice(from);
            }
            Inst::BufferStride { from, place, period, turn, .. } => {
                let [from, to] = self.two_buffers(at(from), to)?;
                deal(from, [place, period], turn, &mut to.grow());
            }
            _ => {}
        }
        Ok(())
    }

    fn two_buffers(&mut self, from: usize, to: usize) -> Result<[&mut List; 2], Message> {
        self.buffers.get_disjoint_mut([from, to]).map_err(|_| Message::Malformed)
    }
}
