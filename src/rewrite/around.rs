//! Families: buffers with one slot for each index of a cycle.

use super::access::load;
use super::{HalfedgeField, Message, Span, Walk};
use crate::mesh::{ElementKind, Mesh};

/// The place of an index in a cycle of `length`, counted around.
pub(super) fn place(length: usize, index: i64, shift: i16) -> Result<usize, Message> {
    let length = i64::try_from(length).unwrap_or(i64::MAX);
    match length {
        0 => Err(Message::OutOfRange),
        _ => Ok(index.saturating_add(i64::from(shift)).rem_euclid(length) as usize),
    }
}

/// Every `period`-th slot from `first` on, turned so that the first stands at the index `turn`.
pub(super) fn deal(from: &[u64], [first, period]: [u16; 2], turn: i16, to: &mut Vec<u64>) {
    let start = to.len();
    let period = usize::from(period).max(1);
    to.extend(from.iter().skip(usize::from(first)).step_by(period));
    let dealt = &mut to[start..];
    if let Ok(turn) = place(dealt.len(), 0, turn) {
        dealt.rotate_right(turn);
    }
}

/// Whether no two slots are the same.
pub(super) fn are_distinct(slots: &mut [u64]) -> bool {
    slots.sort_unstable();
    slots.windows(2).all(|pair| pair[0] != pair[1])
}

/// The part of a buffer that belongs to an index.
pub(super) fn part<'b>(
    halfedges: &'b [u64],
    ends: &[u64],
    index: i64,
    span: Span,
) -> Result<&'b [u64], Message> {
    let at = place(ends.len(), index, span.shift)?;
    let end = ends[at] as usize;
    let start = match at.checked_sub(1) {
        Some(before) => ends[before] as usize,
        None => 0,
    };
    halfedges.get(start..end).ok_or(Message::OutOfRange)
}

/// Whether a walk from the first of the halfedges, once around, meets all others in their
/// order.
pub(super) fn meets_all(mesh: &Mesh, walk: Walk, halfedges: &[u64]) -> Result<bool, Message> {
    let Some((&first, rest)) = halfedges.split_first() else {
        return Ok(true);
    };
    let mut open = rest.iter().peekable();
    let mut at = first as u32;
    for _ in 0..mesh.capacity(ElementKind::Halfedge) {
        at = match walk {
            Walk::Loop => load(mesh, HalfedgeField::Next, at)?,
            Walk::Star => load(mesh, HalfedgeField::Twin, load(mesh, HalfedgeField::Prev, at)?)?,
        };
        if u64::from(at) == first {
            return Ok(open.next().is_none());
        }
        if open.peek() == Some(&&u64::from(at)) {
            open.next();
        }
    }
    Err(Message::Endless)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_came_first_stands_at_the_turn() {
        let dealt = |turn| {
            let mut to = Vec::new();
            deal(&[1, 10, 2, 20, 3, 30], [1, 2], turn, &mut to);
            to
        };
        assert_eq!(dealt(0), [10, 20, 30]);
        assert_eq!(dealt(1), [30, 10, 20]);
        assert_eq!(dealt(-1), [20, 30, 10]);
        assert_eq!(dealt(4), dealt(1));
    }

    #[test]
    fn a_part_ends_where_the_next_begins() {
        let span = |shift| Span { buffer: 0, ends: 1, shift };
        let part = |index, shift| part(&[7, 8, 9], &[1, 1, 3], index, span(shift)).ok();
        assert_eq!(part(0, 0), Some(&[7][..]));
        assert_eq!(part(1, 0), Some(&[][..]));
        assert_eq!(part(0, -1), Some(&[8, 9][..]));
    }
}
