//! The register code.
//!
//! Registers are slots of 64 bits in one window per call. An int is an `i64`, a real an
//! `f64`, a bool 0 or 1, an element its id (`u32::MAX`: none); a vector takes three
//! consecutive slots, a matrix its columns one after the other. Each instruction fixes the types of its registers, so the code is
//! typed though the slots are not. Jumps name instructions by index.

use std::sync::Arc;

use super::Function;
use super::print::RealDigits;
use super::wide::{Lanes, Matrix};
use crate::mesh::ElementKind;

/// A register: a slot of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Reg(pub u16);

impl Reg {
    /// The register `offset` slots further, for the parts of a vector.
    pub fn part(self, offset: u16) -> Reg {
        Reg(self.0 + offset)
    }
}

/// The place of an instruction, as the target of a jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Label(pub u32);

/// A pointer of a halfedge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum HalfedgeField {
    Next,
    Prev,
    Twin,
    Vertex,
    Edge,
    Face,
}

/// The `halfedge` pointer of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum ElementField {
    Vertex,
    Edge,
    Face,
}

/// The part of a buffer that belongs to an index: another buffer tells where the parts end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// What is in all parts.
    pub buffer: u16,
    /// For each index the end of its part.
    pub ends: u16,
    /// What is added to the index, around the cycle.
    pub shift: i16,
}

/// How a run of halfedges is walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Walk {
    /// Along a loop: `h.next`.
    Loop,
    /// Around a vertex, counterclockwise: `h.prev.twin`.
    Star,
}

/// The elements a loop over the whole mesh visits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Elements {
    Vertices,
    Halfedges,
    Edges,
    /// Faces that are not holes.
    Faces,
    Holes,
}

impl Elements {
    /// Their kind.
    pub fn kind(self) -> ElementKind {
        match self {
            Elements::Vertices => ElementKind::Vertex,
            Elements::Halfedges => ElementKind::Halfedge,
            Elements::Edges => ElementKind::Edge,
            Elements::Faces | Elements::Holes => ElementKind::Face,
        }
    }
}

/// What can be asked of the result before it is written: the conditions of the levels,
/// for one orbit each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Foreseen {
    /// A face has three sides or more; a hole may have fewer.
    ThreeSides,
    /// A loop meets no vertex twice.
    MeetsOnce,
    /// A loop has no more than one corner at a vertex.
    CornerOnce,
    /// A vertex has two spokes or more, or none at all.
    TwoSpokes,
    /// At most one corner of a vertex lies in a hole.
    OneHole,
    /// No loop lies around a vertex twice.
    FacesDiffer,
    /// No two edges join a vertex to the same neighbor.
    NeighborsDiffer,
    /// No other edge has the ends of that of a halfedge.
    SingleEdge,
    /// No two faces around a vertex have the same set of corners.
    CornersDiffer,
    /// No other face around a vertex of a face has the same set of corners.
    CornersOwn,
}

/// A flat program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Code {
    /// The instructions; running past the last one returns.
    pub insts: Vec<Inst>,
    /// How many slots its window has.
    pub registers: u16,
    /// How many buffers it uses.
    pub buffers: u16,
    /// Why each trapping instruction could fail, by its index: see [`Traps`].
    pub traps: Traps,
    /// The constant texts, by number; no two are equal.
    pub texts: Vec<String>,
    /// The functions that it may call, by number.
    pub functions: Arc<[Function]>,
}

impl Code {
    /// Whether a drain may run in it.
    pub(super) fn drains(&self) -> bool {
        let opens = |inst: &Inst| matches!(inst, Inst::DrainOpen { .. });
        let functions = self.functions.iter().map(|function| &function.code);
        let all = functions.chain([self]);
        all.flat_map(|code| &code.insts).any(opens)
    }

    /// The code itself, and that of the functions that it calls, directly or through others.
    pub fn with_called(&self) -> Vec<&Code> {
        let mut found = vec![self];
        let mut seen = vec![false; self.functions.len()];
        let mut looked_at = 0;
        while let Some(code) = found.get(looked_at).copied() {
            looked_at += 1;
            for inst in &code.insts {
                if let Inst::Call { function, .. } = inst
                    && let Some(seen) = seen.get_mut(usize::from(*function))
                    && !std::mem::replace(seen, true)
                {
                    found.push(&self.functions[usize::from(*function)].code);
                }
            }
        }
        found
    }

    /// The number of the place in the source of an instruction that can trap.
    pub fn place(&self, inst: usize) -> Option<u32> {
        let at = u32::try_from(inst).ok()?;
        let found = self.traps.binary_search_by_key(&at, |&(inst, _)| inst);
        found.ok().map(|trap| self.traps[trap].1)
    }
}

/// For each instruction that can fail at run time the number of its place in the source:
/// an index into the spans that whoever made the code keeps. Sorted by instruction.
pub type Traps = Vec<(u32, u32)>;

/// A function of reals: `f64 -> f64`, or with two or three operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Math {
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Exp,
    Log,
    Floor,
    Ceil,
    Abs,
    Negate,
}

/// One instruction. `to` is written; everything else is read.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Inst {
    // Values.
    Const {
        to: Reg,
        bits: u64,
    },
    Copy {
        to: Reg,
        from: Reg,
    },
    CopyVec {
        to: Reg,
        from: Reg,
    },
    /// `to = if condition { then } else { otherwise }`
    Select {
        to: Reg,
        condition: Reg,
        then: Reg,
        otherwise: Reg,
    },
    Not {
        to: Reg,
        from: Reg,
    },
    And {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    Or {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    /// Two ints, bools, elements or texts.
    Equal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    /// Traps, as all arithmetic of ints does, when the result does not fit.
    AddInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    SubInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MulInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    /// Rounds towards minus infinity. Traps on zero.
    DivInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    /// Sign of the divisor. Traps on zero.
    ModInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    NegInt {
        to: Reg,
        from: Reg,
    },
    AbsInt {
        to: Reg,
        from: Reg,
    },
    MinInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MaxInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    LessInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    LessEqualInt {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    IntToReal {
        to: Reg,
        from: Reg,
    },
    /// Half to even. Traps when it does not fit.
    RoundReal {
        to: Reg,
        from: Reg,
    },
    AddReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    SubReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MulReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    DivReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MinReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MaxReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    PowReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    Atan2Real {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    LessReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    LessEqualReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    EqualReal {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MathReal {
        math: Math,
        to: Reg,
        from: Reg,
    },
    AddVec {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    SubVec {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MulVec {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    NegVec {
        to: Reg,
        from: Reg,
    },
    /// A vector by a real.
    ScaleVec {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    DivVec {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    MixVec {
        to: Reg,
        left: Reg,
        right: Reg,
        t: Reg,
    },
    EqualVec {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    Dot {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    Cross {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    LengthVec {
        to: Reg,
        from: Reg,
    },
    Normalize {
        to: Reg,
        from: Reg,
    },
    /// A value of any width.
    CopyWide {
        to: Reg,
        from: Reg,
        width: u8,
    },
    /// Vectors and matrices of any width, component by component.
    Wide {
        operation: Lanes,
        width: u8,
        to: Reg,
        left: Reg,
        right: Reg,
    },
    /// Square matrices with so many rows, and their vectors. What takes one operand reads
    /// `left`.
    Matrix {
        operation: Matrix,
        size: u8,
        to: Reg,
        left: Reg,
        right: Reg,
    },

    // Loads. Each traps if the element is none or erased.
    Load {
        field: HalfedgeField,
        to: Reg,
        halfedge: Reg,
    },
    LoadHalfedge {
        of: ElementField,
        to: Reg,
        element: Reg,
    },
    LoadHole {
        to: Reg,
        face: Reg,
    },
    LoadPosition {
        to: Reg,
        vertex: Reg,
    },
    /// A declared attribute, by its number in the machine's table.
    LoadAttribute {
        attribute: u16,
        to: Reg,
        element: Reg,
    },
    /// The number of slots of a kind, living or dead: the bound of a loop over all.
    Capacity {
        kind: ElementKind,
        to: Reg,
    },
    /// Moves `element` on to the first living one from there on, itself included; jumps
    /// if there is none.
    NextLiving {
        of: Elements,
        element: Reg,
        otherwise: Label,
    },
    /// Jumps if an element is erased, or a face no longer of its sort. Never traps.
    JumpUnlessLiving {
        of: Elements,
        element: Reg,
        to: Label,
    },
    /// Whether an element exists. Never traps.
    Alive {
        kind: ElementKind,
        to: Reg,
        element: Reg,
    },

    // Questions that walk. Each traps as loads do.
    Degree {
        to: Reg,
        vertex: Reg,
    },
    FaceSize {
        to: Reg,
        face: Reg,
    },
    BoundaryVertex {
        to: Reg,
        vertex: Reg,
    },
    BoundaryEdge {
        to: Reg,
        edge: Reg,
    },
    Adjacent {
        to: Reg,
        left: Reg,
        right: Reg,
    },
    LinkCondition {
        to: Reg,
        edge: Reg,
    },
    StarShaped {
        to: Reg,
        edge: Reg,
    },
    KernelCentroid {
        to: Reg,
        edge: Reg,
    },
    LengthEdge {
        to: Reg,
        edge: Reg,
    },
    Area {
        to: Reg,
        face: Reg,
    },
    NormalFace {
        to: Reg,
        face: Reg,
    },
    NormalVertex {
        to: Reg,
        vertex: Reg,
    },
    CentroidFace {
        to: Reg,
        face: Reg,
    },
    /// The number of living elements; of faces, without holes.
    Count {
        kind: ElementKind,
        to: Reg,
    },
    CountHoles {
        to: Reg,
    },

    // Jumps.
    Jump {
        to: Label,
    },
    JumpIf {
        condition: Reg,
        to: Label,
    },
    JumpUnless {
        condition: Reg,
        to: Label,
    },
    /// Jumps when two elements or ints differ.
    JumpUnequal {
        left: Reg,
        right: Reg,
        to: Label,
    },
    /// Jumps when two elements or ints are equal.
    JumpEqual {
        left: Reg,
        right: Reg,
        to: Label,
    },

    // Matching. A test that fails notes its refusal, if none of a later phase is noted
    // yet, and jumps to the next attempt.
    /// The refusal if two elements differ.
    ExpectEqual {
        left: Reg,
        right: Reg,
        refusal: u16,
        otherwise: Label,
    },
    /// The refusal if two elements are the same.
    ExpectDistinct {
        left: Reg,
        right: Reg,
        refusal: u16,
        otherwise: Label,
    },
    /// The refusal if a bool is false.
    Expect {
        condition: Reg,
        refusal: u16,
        otherwise: Label,
    },
    /// The refusal if a vector has a component that is not finite.
    ExpectFinite {
        vector: Reg,
        refusal: u16,
        otherwise: Label,
    },
    /// The refusal if the id space has no room for so many new elements.
    ExpectRoom {
        vertices: u16,
        halfedges: u16,
        edges: u16,
        faces: u16,
        refusal: u16,
        otherwise: Label,
    },
    /// Appends the halfedges from `from` up to, but without, `until` to a buffer; the
    /// whole cycle if both are the same and `whole`, else nothing.
    Collect {
        walk: Walk,
        buffer: u16,
        from: Reg,
        until: Reg,
        whole: bool,
    },
    /// Whether a walk from `from` meets `goal` before `stop` (which ends it). `from` counts;
    /// where it is also the `stop`, the walk goes once around. It ends when it is back.
    Meets {
        walk: Walk,
        to: Reg,
        from: Reg,
        goal: Reg,
        stop: Reg,
    },
    // Looking ahead: what would be written is noted on a sheet over the mesh, and asked
    // about. The mesh stays as it is. Each traps as loads do.
    /// An empty sheet.
    PreviewClear,
    /// A number for an element that would be created.
    PreviewNew {
        to: Reg,
    },
    PreviewStore {
        field: HalfedgeField,
        halfedge: Reg,
        value: Reg,
    },
    PreviewStoreHalfedge {
        of: ElementField,
        element: Reg,
        value: Reg,
    },
    PreviewStoreHole {
        face: Reg,
        hole: bool,
    },
    PreviewStoreAll {
        field: HalfedgeField,
        buffer: u16,
        value: Reg,
    },
    /// Whether a condition would hold for an element: a face, vertex or halfedge; `at` is
    /// the vertex, where it speaks of a face and a vertex.
    Foresee {
        condition: Foreseen,
        to: Reg,
        element: Reg,
        at: Reg,
    },
    /// Whether a condition of vertices would hold where the halfedges of a buffer start.
    ForeseeAlong {
        condition: Foreseen,
        to: Reg,
        buffer: u16,
    },
    PreviewStoreSpan {
        field: HalfedgeField,
        span: Span,
        index: Reg,
        value: Reg,
    },

    // Families: a buffer holds one slot for each index of a cycle.
    /// The next index of a family, from -1 on; jumps when there is none.
    NextIndex {
        buffer: u16,
        index: Reg,
        otherwise: Label,
    },
    /// `to = buffer[index + shift]`, counted around. Traps if the buffer is empty.
    Member {
        buffer: u16,
        index: Reg,
        shift: i16,
        to: Reg,
    },
    /// The `width` slots from `index * width` on. Traps out of range.
    BufferGetWide {
        buffer: u16,
        index: Reg,
        width: u16,
        to: Reg,
    },
    /// Appends a buffer to another.
    BufferAppend {
        from: u16,
        to: u16,
    },
    /// Appends every `period`-th slot, from the one at `place` on, to another buffer, turned
    /// so that what came first stands at the index `turn`.
    BufferDeal {
        from: u16,
        to: u16,
        place: u16,
        period: u16,
        turn: i16,
    },
    /// The refusal if two slots of a buffer are the same. Leaves the slots in some order.
    ExpectAllDistinct {
        buffer: u16,
        refusal: u16,
        otherwise: Label,
    },
    /// The refusal if the id space has no room for so many new elements of a kind.
    ExpectRoomFor {
        kind: ElementKind,
        count: Reg,
        refusal: u16,
        otherwise: Label,
    },
    /// Whether a walk from the first halfedge of a buffer, once around, meets all others in
    /// their order.
    MeetsAll {
        walk: Walk,
        to: Reg,
        buffer: u16,
    },
    /// Gives up: the op refuses with the reason noted.
    Refuse,
    /// The op has been applied; its result, if any, is in the register.
    Return {
        result: Option<Reg>,
    },

    // Buffers: growing lists of slots, empty at the start of a call.
    BufferClear {
        buffer: u16,
    },
    BufferPush {
        buffer: u16,
        from: Reg,
    },
    BufferLength {
        buffer: u16,
        to: Reg,
    },
    /// Traps out of range.
    BufferGet {
        buffer: u16,
        to: Reg,
        index: Reg,
    },
    /// `to = buffer[index]`, and `index` moves on by one; jumps when nothing is left.
    BufferNext {
        buffer: u16,
        index: Reg,
        to: Reg,
        otherwise: Label,
    },
    /// Appends all living elements, in order of their ids.
    BufferLiving {
        of: Elements,
        buffer: u16,
    },

    // Writes.
    NewVertex {
        to: Reg,
    },
    NewHalfedge {
        to: Reg,
    },
    NewEdge {
        to: Reg,
    },
    NewFace {
        to: Reg,
    },
    Store {
        field: HalfedgeField,
        halfedge: Reg,
        value: Reg,
    },
    StoreHalfedge {
        of: ElementField,
        element: Reg,
        value: Reg,
    },
    StoreHole {
        face: Reg,
        hole: bool,
    },
    /// Traps if not finite.
    StorePosition {
        vertex: Reg,
        value: Reg,
    },
    /// Keeps a position back in a buffer. Traps if it is not finite or the vertex is
    /// gone.
    HoldPosition {
        buffer: u16,
        vertex: Reg,
        value: Reg,
    },
    StoreAttribute {
        attribute: u16,
        element: Reg,
        value: Reg,
    },
    /// Keeps the value of an attribute back in a buffer. Traps if the element is gone.
    HoldAttribute {
        buffer: u16,
        attribute: u16,
        element: Reg,
        value: Reg,
    },
    /// Writes what is kept back in a buffer, in order, and clears it. Elements erased in
    /// the meantime are passed over.
    ReleaseHeld {
        buffer: u16,
    },
    /// Writes one pointer of every halfedge in a buffer.
    StoreAll {
        field: HalfedgeField,
        buffer: u16,
        value: Reg,
    },
    /// Writes one pointer of every halfedge in a part of a buffer.
    StoreSpan {
        field: HalfedgeField,
        span: Span,
        index: Reg,
        value: Reg,
    },
    Erase {
        kind: ElementKind,
        element: Reg,
    },
    /// Lets erased slots be used again: nothing can see them any more.
    Recycle,

    // Drains: loops over elements in the order of keys that are kept current. All but the
    // first concern the innermost that runs.
    /// Begins a drain: of all such elements, or of those in a buffer.
    DrainOpen {
        of: Elements,
        members: Option<u16>,
    },
    /// What all keys depend on has changed.
    DrainAllStale,
    /// The next element whose key is to be computed; jumps if there is none.
    DrainStale {
        to: Reg,
        otherwise: Label,
    },
    /// Its key, a real. Traps if it is not a number.
    DrainKey {
        key: Reg,
    },
    /// The element with the least key; jumps if there is none.
    DrainLeast {
        to: Reg,
        otherwise: Label,
    },
    /// That element leaves the queue.
    DrainTake,
    DrainClose,

    // Calls.
    /// Calls a function: arguments in consecutive slots from `args`; its value goes to `to`.
    /// If `holds`, the caller still needs ids, so that none is given out again meanwhile.
    Call {
        function: u16,
        args: Reg,
        to: Reg,
        holds: bool,
    },
    /// The function is done; its value stands in so many slots from `from`.
    Give {
        from: Reg,
        width: u16,
    },

    // Operations, progress and output (scripts).
    /// Applies an op: arguments in consecutive slots from `args`; `applied` becomes a
    /// bool; the result, if applied, goes to `result`.
    Apply {
        op: u16,
        args: Reg,
        applied: Reg,
        result: Reg,
    },
    /// The op just called refused, and the script said `must`: traps with its reason.
    Refused {
        op: u16,
    },
    /// One turn of a loop of the script: `done` of `total`. The watcher may interrupt.
    Turn {
        depth: u16,
        done: Reg,
        total: Reg,
    },
    /// One turn of an aggregate over the whole mesh. The watcher may interrupt.
    Tick,
    /// Prints a constant text.
    PrintText {
        text: u32,
    },
    /// Prints the text whose number is in the register.
    PrintTextOf {
        from: Reg,
    },
    PrintBool {
        from: Reg,
    },
    PrintInt {
        from: Reg,
    },
    PrintReal {
        from: Reg,
        digits: RealDigits,
    },
    PrintVec {
        from: Reg,
        digits: RealDigits,
    },
    /// Prints a vector or matrix with columns of this size.
    PrintWide {
        from: Reg,
        size: u8,
        columns: u8,
        digits: RealDigits,
    },
    PrintElement {
        kind: ElementKind,
        from: Reg,
    },
    PrintEnd,
    /// Prints why an op refused that was called last.
    PrintReason {
        op: u16,
    },
    /// Whether the op that was called last refused for this reason.
    RefusedFor {
        op: u16,
        text: u32,
        to: Reg,
    },
    /// Keeps the mesh as it is now, to compare it later (tests).
    MeshKeep {
        mesh: u16,
    },
    /// Whether the mesh is one that is kept, up to renumbering (tests).
    MeshSame {
        mesh: u16,
        to: Reg,
    },
    /// Traps with a constant text, and with what was printed since the last line ended.
    FailShowing {
        text: u32,
    },
    /// Traps with a constant text: an assertion, or an aggregate of nothing.
    Fail {
        text: u32,
    },
}

impl Inst {
    /// The instruction it may jump to.
    pub fn target_mut(&mut self) -> Option<&mut Label> {
        match self {
            Inst::Jump { to }
            | Inst::JumpIf { to, .. }
            | Inst::JumpUnless { to, .. }
            | Inst::JumpUnequal { to, .. }
            | Inst::JumpEqual { to, .. } => Some(to),
            Inst::JumpUnlessLiving { to, .. } => Some(to),
            Inst::NextLiving { otherwise, .. }
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
