//! The instructions.

use super::print::RealDigits;
use super::vectors::{Lanes, Matrix};
use super::{
    ElementField, Elements, HalfedgeField, Label, Math, Question, Reg, Room, Span, Triangles, Walk,
};
use crate::mesh::{ElementKind, OrbitCondition};

/// An instruction. `to` is written; everything else is read.
#[derive(Clone, Copy, Debug, PartialEq)]
#[rustfmt::skip] // A table, a line each.
pub enum Inst {
    // Values.
    Const { to: Reg, bits: u64 },
    Copy { to: Reg, from: Reg },
    CopyVec { to: Reg, from: Reg },
    /// `to = if condition { then } else { otherwise }`
    Select { to: Reg, condition: Reg, then: Reg, otherwise: Reg },
    Not { to: Reg, from: Reg },
    And { to: Reg, left: Reg, right: Reg },
    Or { to: Reg, left: Reg, right: Reg },
    /// Compares two ints, bools, elements or texts.
    Equal { to: Reg, left: Reg, right: Reg },
    /// Traps on overflow, as all arithmetic of ints does.
    AddInt { to: Reg, left: Reg, right: Reg },
    SubInt { to: Reg, left: Reg, right: Reg },
    MulInt { to: Reg, left: Reg, right: Reg },
    /// Rounds towards minus infinity. Traps on zero.
    DivInt { to: Reg, left: Reg, right: Reg },
    /// The remainder with the sign of the divisor. Traps on zero.
    ModInt { to: Reg, left: Reg, right: Reg },
    NegInt { to: Reg, from: Reg },
    AbsInt { to: Reg, from: Reg },
    MinInt { to: Reg, left: Reg, right: Reg },
    MaxInt { to: Reg, left: Reg, right: Reg },
    LessInt { to: Reg, left: Reg, right: Reg },
    LessEqualInt { to: Reg, left: Reg, right: Reg },
    IntToReal { to: Reg, from: Reg },
    /// The real by which an int is ordered as a key of a drain. Traps if others have the same.
    IntToKey { to: Reg, from: Reg },
    /// Rounds to the nearest int, half to even. Traps if it does not fit.
    RoundReal { to: Reg, from: Reg },
    AddReal { to: Reg, left: Reg, right: Reg },
    SubReal { to: Reg, left: Reg, right: Reg },
    MulReal { to: Reg, left: Reg, right: Reg },
    DivReal { to: Reg, left: Reg, right: Reg },
    MinReal { to: Reg, left: Reg, right: Reg },
    MaxReal { to: Reg, left: Reg, right: Reg },
    PowReal { to: Reg, left: Reg, right: Reg },
    Atan2Real { to: Reg, left: Reg, right: Reg },
    LessReal { to: Reg, left: Reg, right: Reg },
    LessEqualReal { to: Reg, left: Reg, right: Reg },
    EqualReal { to: Reg, left: Reg, right: Reg },
    MathReal { math: Math, to: Reg, from: Reg },
    AddVec { to: Reg, left: Reg, right: Reg },
    SubVec { to: Reg, left: Reg, right: Reg },
    MulVec { to: Reg, left: Reg, right: Reg },
    NegVec { to: Reg, from: Reg },
    /// Multiplies a vector by a real.
    ScaleVec { to: Reg, left: Reg, right: Reg },
    DivVec { to: Reg, left: Reg, right: Reg },
    MixVec { to: Reg, left: Reg, right: Reg, t: Reg },
    EqualVec { to: Reg, left: Reg, right: Reg },
    Dot { to: Reg, left: Reg, right: Reg },
    Cross { to: Reg, left: Reg, right: Reg },
    LengthVec { to: Reg, from: Reg },
    Normalize { to: Reg, from: Reg },
    /// Multiplies a vector by a power of two, so that its largest component is about 1.
    Balance { to: Reg, from: Reg },
    /// Copies a value of any width.
    CopyWide { to: Reg, from: Reg, width: u8 },
    /// Vectors and matrices of any width, component by component.
    Wide { operation: Lanes, width: u8, to: Reg, left: Reg, right: Reg },
    /// Square matrices with `size` rows, and their vectors. Operations with one operand read
    /// `left`.
    Matrix { operation: Matrix, size: u8, to: Reg, left: Reg, right: Reg },

    /// A random real from 0 up to, but without, 1.
    Random { to: Reg },
    /// A random int from 0 up to, but without, `below`. Traps if there is none.
    RandomInt { to: Reg, below: Reg },
    /// Shuffles the slots of a buffer.
    BufferShuffle { buffer: u16 },

    // Loads. Each traps if there is no element or it is erased.
    Load { field: HalfedgeField, to: Reg, halfedge: Reg },
    LoadHalfedge { of: ElementField, to: Reg, element: Reg },
    LoadHole { to: Reg, face: Reg },
    LoadPosition { to: Reg, vertex: Reg },
    /// A declared attribute, by its number in the machine's table.
    LoadAttribute { attribute: u16, to: Reg, element: Reg },
    /// The number of slots of a kind, living or erased: the bound of a loop over all.
    Capacity { kind: ElementKind, to: Reg },
    /// Advances `element` to the first living element, starting with itself; jumps if there is
    /// none.
    NextLiving { of: Elements, element: Reg, otherwise: Label },
    /// Jumps if an element is erased, or if a face has become a hole or a hole a face. Never traps.
    JumpUnlessLiving { of: Elements, element: Reg, to: Label },
    /// True if an element exists. Never traps.
    Alive { kind: ElementKind, to: Reg, element: Reg },

    // Questions.
    /// A question about the first element, or about both. Traps as loads do.
    Ask { question: Question, to: Reg, elements: [Reg; 2] },
    /// The number of living elements; of faces, without holes.
    Count { kind: ElementKind, to: Reg },
    CountHoles { to: Reg },

    // Jumps.
    Jump { to: Label },
    JumpIf { condition: Reg, to: Label },
    JumpUnless { condition: Reg, to: Label },
    /// Jumps if two elements or ints differ.
    JumpUnequal { left: Reg, right: Reg, to: Label },
    /// Jumps if two elements or ints are equal.
    JumpEqual { left: Reg, right: Reg, to: Label },

    // Matching. A test that fails notes its refusal, if none of the same or a later phase is noted
    // yet, and jumps to the next attempt.
    /// Fails if two elements differ.
    ExpectEqual { left: Reg, right: Reg, refusal: u16, otherwise: Label },
    /// Fails if two elements are the same.
    ExpectDistinct { left: Reg, right: Reg, refusal: u16, otherwise: Label },
    /// Fails if a bool is false.
    Expect { condition: Reg, refusal: u16, otherwise: Label },
    /// Fails if a vector has a component that is not finite.
    ExpectFinite { vector: Reg, refusal: u16, otherwise: Label },
    /// Fails if the id space has no room for these new elements.
    ExpectRoom { room: Room, refusal: u16, otherwise: Label },
    /// Appends the halfedges from `from` up to, but without, `until` to a buffer. If both are the
    /// same: the whole cycle if `whole`, else nothing.
    Collect { walk: Walk, buffer: u16, from: Reg, until: Reg, whole: bool },
    /// Appends the corners of a face to a buffer, as halfedges, in an order in which they can
    /// be cut off.
    CollectEars { triangles: Triangles, buffer: u16, face: Reg },
    /// Begins a walk once around from `from`: `at` is its position, `turns` the number of its
    /// steps; jumps if `from` is no element.
    WalkBegin { walk: Walk, from: Reg, at: Reg, turns: Reg, otherwise: Label },
    /// Takes a step of the walk, and jumps unless it is back at `from`. Traps if the walk has taken
    /// as many steps as there are slots of halfedges.
    WalkNext { walk: Walk, from: Reg, at: Reg, turns: Reg, again: Label },
    /// Begins a loop over the neighbors of a vertex, with the first one in `neighbor`; jumps if
    /// there is none. The loop keeps its place in three registers.
    NeighborsBegin { vertex: Reg, slots: Reg, neighbor: Reg, otherwise: Label },
    /// Advances to the next neighbor, and jumps unless that is the first again. Traps as `WalkNext`
    /// does.
    NeighborsNext { slots: Reg, neighbor: Reg, again: Label },
    /// Whether a walk from `from` (included) meets `goal` before it comes to `stop` or back to
    /// `from`. If `from` is also `stop`, the walk goes once around.
    Meets { walk: Walk, to: Reg, from: Reg, goal: Reg, stop: Reg },
    // Previews: the values that would be written are set on the mesh without notification, queried,
    // and restored. Each traps as loads do.
    /// Begins a preview in which nothing is set.
    PreviewClear,
    /// A number for an element that would be created.
    PreviewNew { to: Reg },
    PreviewStore { field: HalfedgeField, halfedge: Reg, value: Reg },
    PreviewStoreHalfedge { of: ElementField, element: Reg, value: Reg },
    PreviewStoreHole { face: Reg, hole: bool },
    PreviewStoreAll { field: HalfedgeField, buffer: u16, value: Reg },
    /// Whether a condition would hold for an element: a face, vertex or halfedge; `at` is the
    /// vertex of a condition about a face and a vertex.
    Foresee { condition: OrbitCondition, to: Reg, element: Reg, at: Reg },
    /// Whether a condition of vertices would hold for the origins of all halfedges of a buffer.
    ForeseeAlong { condition: OrbitCondition, to: Reg, buffer: u16 },
    PreviewStoreSpan { field: HalfedgeField, span: Span, index: Reg, value: Reg },
    /// Restores the old values.
    PreviewUndo,

    // Families: a buffer holds one slot for each index of a cycle.
    /// The next index of a family, after -1 at first; jumps if there is none.
    NextIndex { buffer: u16, index: Reg, otherwise: Label },
    /// `to = buffer[index + shift]`, modulo the length. Traps if the buffer is empty.
    Member { buffer: u16, index: Reg, shift: i16, to: Reg },
    /// The `width` slots from `index * width` on. Traps out of range.
    BufferGetWide { buffer: u16, index: Reg, width: u16, to: Reg },
    /// Fills a buffer with new elements, one for each slot of `cycle`.
    BufferNew { kind: ElementKind, cycle: u16, buffer: u16 },
    /// Appends a buffer to another.
    BufferAppend { from: u16, to: u16 },
    /// Appends every `period`-th slot, from the one at `place` on, to another buffer, rotated so
    /// that the first one is at the index `turn`.
    BufferStride { from: u16, to: u16, place: u16, period: u16, turn: i16 },
    /// Fails if two slots of a buffer are the same. Reorders the slots.
    ExpectAllDistinct { buffer: u16, refusal: u16, otherwise: Label },
    /// Fails if the id space has no room for `count` new elements of a kind.
    ExpectRoomFor { kind: ElementKind, count: Reg, refusal: u16, otherwise: Label },
    /// Whether a walk once around from the first halfedge of a buffer meets all others in their
    /// order.
    MeetsAll { walk: Walk, to: Reg, buffer: u16 },
    /// The op refuses with the noted reason.
    Refuse,
    /// The op has been applied; its result, if any, is in the register.
    Return { result: Option<Reg> },

    // Buffers: growing lists of slots, empty at the start of a call.
    BufferClear { buffer: u16 },
    /// Empties a buffer and frees its memory.
    BufferFree { buffer: u16 },
    BufferPush { buffer: u16, from: Reg },
    BufferLength { buffer: u16, to: Reg },
    /// Traps out of range.
    BufferGet { buffer: u16, to: Reg, index: Reg },
    /// `to = buffer[index]`, and increments `index`; jumps if no slot is left.
    BufferNext { buffer: u16, index: Reg, to: Reg, otherwise: Label },
    /// Requests the memory around the elements that follow in a buffer, if that is due at this
    /// index. Changes nothing.
    Prefetch { of: Elements, buffer: u16, index: Reg },
    /// Appends all living elements, in order of their ids.
    BufferLiving { of: Elements, buffer: u16 },

    // Writes.
    New { kind: ElementKind, to: Reg },
    Store { field: HalfedgeField, halfedge: Reg, value: Reg },
    StoreHalfedge { of: ElementField, element: Reg, value: Reg },
    StoreHole { face: Reg, hole: bool },
    /// Traps if not finite.
    StorePosition { vertex: Reg, value: Reg },
    /// Keeps a position back in a buffer. Traps if it is not finite or the vertex is erased.
    DeferPosition { buffer: u16, vertex: Reg, value: Reg },
    StoreAttribute { attribute: u16, element: Reg, value: Reg },
    /// Keeps the value of an attribute back in a buffer. Traps if the element is erased.
    DeferAttribute { buffer: u16, attribute: u16, element: Reg, value: Reg },
    /// Writes the values that are kept back in a buffer, in order, and clears it. Elements that
    /// have been erased since are skipped.
    WriteDeferred { buffer: u16 },
    /// Writes one pointer of every halfedge in a buffer.
    StoreAll { field: HalfedgeField, buffer: u16, value: Reg },
    /// Writes one pointer of every halfedge in a part of a buffer.
    StoreSpan { field: HalfedgeField, span: Span, index: Reg, value: Reg },
    Erase { kind: ElementKind, element: Reg },
    /// Frees erased slots for reuse: nothing refers to them any more.
    Recycle,

    // Drains: loops over elements in the order of keys that are kept current. All instructions but
    // the first are about the innermost running drain.
    /// Begins a drain of all such elements, or of those in a buffer.
    DrainOpen { of: Elements, members: Option<u16> },
    /// Marks all keys as stale, since something that they depend on has changed.
    DrainAllStale,
    /// The next element whose key is to be computed; jumps if there is none.
    DrainStale { to: Reg, otherwise: Label },
    /// Sets the key of that element, a real. Traps if it is NaN.
    DrainKey { key: Reg },
    /// The element with the least key; jumps if there is none.
    DrainLeast { to: Reg, otherwise: Label },
    /// Removes that element from the queue.
    DrainTake,
    DrainClose,

    // Calls.
    /// Calls a function with arguments in consecutive slots from `args`; its value goes to `to`. If
    /// `holds`, the caller holds ids, so that none is reused during the call.
    Call { function: u16, args: Reg, to: Reg, holds: bool },
    /// Returns from a function; its value is in `width` slots from `from`.
    ReturnValue { from: Reg, width: u16 },

    // Operations, progress and output (scripts).
    /// Applies an op with arguments in consecutive slots from `args`; `applied` becomes a bool; the
    /// result, if applied, goes to `result`.
    Apply { op: u16, args: Reg, applied: Reg, result: Reg },
    /// Asks an op whether it would apply, without applying it: `to` becomes a bool; or, if `why`,
    /// the number of a text, the reason of its refusal or the empty text. Arguments as for `Apply`.
    Try { op: u16, args: Reg, to: Reg, why: bool },
    /// Traps with the reason of the op just called, which refused although the script said `must`;
    /// in an op in steps, refuses with that reason.
    Refused { op: u16 },
    /// An iteration of a loop of the script: `done` of `total`. The watcher may interrupt.
    Iteration { depth: u16, done: Reg, total: Reg },
    /// An iteration of an aggregate over the whole mesh. The watcher may interrupt.
    Tick,
    /// Runs all iterations of the following loop in parts, on several threads if there are some,
    /// and writes what they keep back: see [`Part`](super::Part). Jumps behind the loop, or
    /// continues with it if it is not run in parts.
    Spread { part: u16, end: Label },
    /// Keeps a slot, in the part of a loop.
    Keep { from: Reg },
    /// Prints a constant text.
    PrintText { text: u32 },
    /// Prints the text whose number is in the register.
    PrintTextOf { from: Reg },
    PrintBool { from: Reg },
    PrintInt { from: Reg },
    PrintReal { from: Reg, digits: RealDigits },
    /// Prints a vector or matrix with columns of this size.
    PrintWide { from: Reg, size: u8, columns: u8, digits: RealDigits },
    PrintElement { kind: ElementKind, from: Reg },
    /// Traps unless the element exists.
    ExpectAlive { kind: ElementKind, from: Reg },
    PrintEnd,
    /// Prints the reason of the last refusal, which was of this op.
    PrintReason { op: u16 },
    /// Whether the last refusal, which was of this op, was for this reason.
    RefusedFor { op: u16, text: u32, to: Reg },
    /// Prints the difference of the mesh from a kept one (tests).
    PrintDifference { mesh: u16 },
    /// Keeps a copy of the mesh, to compare it later (tests).
    MeshKeep { mesh: u16 },
    /// Whether the mesh equals a kept one, up to renumbering (tests).
    MeshSame { mesh: u16, to: Reg },
    /// Traps with a constant text, and with the text printed since the last end of a line.
    FailShowing { text: u32 },
    /// Traps with a constant text, and the element around which the values of an aggregate were
    /// to be.
    Fail { text: u32, around: Option<(ElementKind, Reg)> },
}

impl Inst {
    /// The index of the instruction that it may jump to.
    pub fn target(mut self) -> Option<usize> {
        self.target_mut().map(|to| to.0 as usize)
    }

    /// The label of the instruction that it may jump to.
    pub fn target_mut(&mut self) -> Option<&mut Label> {
        match self {
            Inst::Jump { to }
            | Inst::JumpIf { to, .. }
            | Inst::JumpUnless { to, .. }
            | Inst::JumpUnequal { to, .. }
            | Inst::JumpEqual { to, .. } => Some(to),
            Inst::JumpUnlessLiving { to, .. } | Inst::WalkNext { again: to, .. } => Some(to),
            Inst::NeighborsNext { again: to, .. } => Some(to),
            Inst::Spread { end, .. } => Some(end),
            Inst::NextLiving { otherwise, .. }
            | Inst::WalkBegin { otherwise, .. }
            | Inst::NeighborsBegin { otherwise, .. }
            | Inst::BufferNext { otherwise, .. }
            | Inst::NextIndex { otherwise, .. }
            | Inst::ExpectAllDistinct { otherwise, .. }
            | Inst::ExpectRoomFor { otherwise, .. }
            | Inst::DrainStale { otherwise, .. }
            | Inst::DrainLeast { otherwise, .. } => Some(otherwise),
            Inst::ExpectEqual { otherwise, .. }
            | Inst::ExpectDistinct { otherwise, .. }
            | Inst::Expect { otherwise, .. }
            | Inst::ExpectFinite { otherwise, .. }
            | Inst::ExpectRoom { otherwise, .. } => Some(otherwise),
            _ => None,
        }
    }
}

/// A pattern of the instructions of a group.
#[rustfmt::skip]
macro_rules! group {
    // They only compute a value that is not an element from registers, or jump.
    (computes) => {
        Inst::CopyVec { .. } | Inst::CopyWide { .. } | Inst::Not { .. } | Inst::And { .. }
        | Inst::Or { .. } | Inst::Equal { .. } | Inst::AddInt { .. } | Inst::SubInt { .. }
        | Inst::MulInt { .. } | Inst::DivInt { .. } | Inst::ModInt { .. } | Inst::NegInt { .. }
        | Inst::AbsInt { .. } | Inst::MinInt { .. } | Inst::MaxInt { .. } | Inst::LessInt { .. }
        | Inst::LessEqualInt { .. } | Inst::IntToReal { .. } | Inst::IntToKey { .. }
        | Inst::RoundReal { .. } | Inst::AddReal { .. } | Inst::SubReal { .. } | Inst::MulReal { .. }
        | Inst::DivReal { .. } | Inst::MinReal { .. } | Inst::MaxReal { .. }
        | Inst::PowReal { .. } | Inst::Atan2Real { .. } | Inst::LessReal { .. }
        | Inst::LessEqualReal { .. } | Inst::EqualReal { .. } | Inst::MathReal { .. }
        | Inst::AddVec { .. } | Inst::SubVec { .. } | Inst::MulVec { .. } | Inst::NegVec { .. }
        | Inst::ScaleVec { .. } | Inst::DivVec { .. } | Inst::MixVec { .. }
        | Inst::EqualVec { .. } | Inst::Dot { .. } | Inst::Cross { .. } | Inst::LengthVec { .. }
        | Inst::Normalize { .. } | Inst::Balance { .. } | Inst::Wide { .. } | Inst::Matrix { .. }
        | Inst::Jump { .. } | Inst::JumpIf { .. } | Inst::JumpUnless { .. }
        | Inst::JumpUnequal { .. } | Inst::JumpEqual { .. }
    };
    // They refuse what is wrong in registers or in the room that is left.
    (expects) => {
        Inst::ExpectEqual { .. } | Inst::ExpectDistinct { .. } | Inst::ExpectAllDistinct { .. }
        | Inst::Expect { .. } | Inst::ExpectFinite { .. } | Inst::ExpectRoom { .. }
        | Inst::ExpectRoomFor { .. }
    };
    // They make, end or change the preview of a guard.
    (previews) => {
        Inst::PreviewClear | Inst::PreviewUndo | Inst::PreviewNew { .. }
        | Inst::PreviewStore { .. } | Inst::PreviewStoreHalfedge { .. }
        | Inst::PreviewStoreHole { .. } | Inst::PreviewStoreAll { .. }
        | Inst::PreviewStoreSpan { .. }
    };
    // They write to the mesh.
    (writes) => {
        Inst::New { .. } | Inst::BufferNew { .. } | Inst::Store { .. }
        | Inst::StoreHalfedge { .. } | Inst::StoreHole { .. } | Inst::StorePosition { .. }
        | Inst::StoreAttribute { .. } | Inst::StoreAll { .. } | Inst::StoreSpan { .. }
        | Inst::Erase { .. }
    };
    // They keep writes back, and make them.
    (defers) => {
        Inst::DeferPosition { .. } | Inst::DeferAttribute { .. } | Inst::WriteDeferred { .. }
    };
    // They print a part of a line.
    (prints) => {
        Inst::PrintText { .. } | Inst::PrintTextOf { .. } | Inst::PrintBool { .. }
        | Inst::PrintInt { .. } | Inst::PrintReal { .. } | Inst::PrintWide { .. }
        | Inst::PrintElement { .. }
    };
    // They occur in scripts only, apart from those above.
    (scripts) => {
        Inst::Apply { .. } | Inst::Refused { .. } | Inst::PrintEnd | Inst::PrintReason { .. }
        | Inst::RefusedFor { .. } | Inst::PrintDifference { .. } | Inst::MeshKeep { .. }
        | Inst::MeshSame { .. } | Inst::Fail { .. } | Inst::FailShowing { .. }
        | Inst::DrainOpen { .. } | Inst::DrainAllStale | Inst::DrainStale { .. }
        | Inst::DrainKey { .. } | Inst::DrainLeast { .. } | Inst::DrainTake | Inst::DrainClose
        | Inst::ReturnValue { .. }
    };
}
pub(super) use group;
