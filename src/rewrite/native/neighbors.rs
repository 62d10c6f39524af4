//! Loops over the neighbors of a vertex that read these from lists.
//!
//! When a loop over all vertices is run in parts, the neighbors are listed ([`Adjacency`]), and the
//! loops around a vertex read the lists until an operation is applied. To list them takes about as
//! long as to walk around all vertices: it is done where no operation has been applied since another
//! such loop, or where the loop visits most vertices and reads no pointers besides. Where there are
//! no lists, the same code walks.

use std::mem::offset_of;
use std::sync::Arc;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};

use super::Variant;
use super::context::Context;
use super::facts::jumps;
use super::operands::Surroundings;
use super::translate::{Region, Text, Translator};
use crate::mesh::{Adjacency, ElementKind, Mesh};
use crate::rewrite::{Code, Count, ElementField, HalfedgeField, Inst, Label, Reg, Walk};

/// The instructions that control a loop over the neighbors of a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct NeighborLoop {
    /// The start of the walk, the vertex, and the target of the jump if it has no neighbors.
    begin: usize,
    vertex: Reg,
    otherwise: Label,
    /// The registers of the walk; with lists, they hold the place and the end.
    at: Reg,
    turns: Reg,
    /// The register of the neighbor.
    neighbor: Reg,
    /// The instruction that steps the walk.
    next: usize,
}

/// The number of instructions at the start of a turn that find the neighbor.
const CHAIN: usize = 3;

impl NeighborLoop {
    /// The loops of a code that may use lists: its reads need not be noted.
    pub(super) fn in_text(text: &Text<'_>, variant: Variant) -> Vec<Self> {
        match variant == Variant::Plain {
            true => Self::all(text.code, &text.surroundings).collect(),
            false => Vec::new(),
        }
    }

    /// Whether there is such a loop in a code.
    pub(super) fn is_in(code: &Code, surroundings: &Surroundings) -> bool {
        Self::all(code, surroundings).next().is_some()
    }

    /// Whether a code reads no pointers but those of such loops.
    pub(super) fn reads_all_in(code: &Code, surroundings: &Surroundings) -> bool {
        let loops: Vec<_> = Self::all(code, surroundings).collect();
        code.insts.iter().enumerate().all(|(at, inst)| match inst {
            Inst::LoadHalfedge { .. } | Inst::Load { .. } | Inst::WalkBegin { .. } => {
                loops.iter().any(|one| (one.begin - 1..=one.begin + CHAIN).contains(&at))
            }
            Inst::Ask { .. } | Inst::Collect { .. } | Inst::CollectEars { .. } => false,
            Inst::Meets { .. } | Inst::MeetsAll { .. } | Inst::Try { .. } => false,
            _ => true,
        })
    }

    fn all(code: &Code, surroundings: &Surroundings) -> impl Iterator<Item = Self> {
        (1..code.insts.len()).filter_map(|begin| Self::at(code, begin, surroundings))
    }

    fn at(code: &Code, begin: usize, surroundings: &Surroundings) -> Option<Self> {
        let insts = &code.insts;
        let Inst::LoadHalfedge { of: ElementField::Vertex, to: first, element: vertex } =
            insts[begin - 1]
        else {
            return None;
        };
        let Inst::WalkBegin { walk: Walk::Star, from, at, turns, otherwise } = insts[begin] else {
            return None;
        };
        let (head, behind) = (begin + 1, begin + 1 + CHAIN);
        let Inst::Copy { to: neighbor, .. } = *insts.get(head)? else { return None };
        let load = |field| Inst::Load { field, to: neighbor, halfedge: neighbor };
        let chain = [
            Inst::Copy { to: neighbor, from: at },
            load(HalfedgeField::Twin),
            load(HalfedgeField::Vertex),
        ];
        let again = Label(u32::try_from(head).ok()?);
        let step = Inst::WalkNext { walk: Walk::Star, from, at, turns, again };
        let is_chain = insts.get(head..behind)? == chain && first == from && vertex != from;
        let next = behind + insts[behind..].iter().position(|inst| *inst == step)?;
        // The registers of the walk are used by the loop only, and the loop cannot be entered in
        // the middle.
        let is_free = |inst: &Inst| {
            let mut is_free = !matches!(inst, Inst::Turn { .. } | Inst::Tick);
            surroundings.each_operand(inst, &mut |operand| {
                is_free &= !operand.registers().any(|reg| [from, at, turns].contains(&reg));
            });
            is_free
        };
        let is_free = insts[behind..next].iter().all(is_free);
        let is_entered = jumps(code).any(|(source, to)| match to {
            _ if to == begin || (head + 1..behind).contains(&to) => true,
            _ if to == head => source != next,
            _ => (behind..=next).contains(&to) && !(behind..=next).contains(&source),
        });
        (is_chain && is_free && !is_entered).then_some(Self {
            begin,
            vertex,
            otherwise,
            at,
            turns,
            neighbor,
            next,
        })
    }
}

/// The lists of neighbors that a machine knows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbors {
    /// The number of operations that had been applied when a loop last wanted the lists.
    applied: Option<u64>,
    /// Whether making the lists has been tried since then.
    are_made: bool,
    lists: Option<Arc<Adjacency>>,
}

impl Neighbors {
    /// The lists of a mesh, if there are any, or if they are made now: `at_once`, or if a loop wants
    /// them a second time without an operation applied in between (as the counts of the run tell).
    /// They take no more than half of `room` bytes.
    pub(super) fn wanted(
        &mut self,
        mesh: &Mesh,
        counts: &[Count],
        room: usize,
        at_once: bool,
    ) -> Self {
        let applied = Some(counts.iter().map(|count| count.applied).sum());
        let is_of_mesh =
            |lists: &Arc<Adjacency>| lists.vertices() == mesh.capacity(ElementKind::Vertex);
        let are_new = self.applied != applied || !self.lists.as_ref().is_none_or(is_of_mesh);
        if are_new {
            *self = Self { applied, ..Self::default() };
        }
        if (at_once || !are_new) && !self.are_made {
            self.are_made = true;
            let has_room = Adjacency::bytes(mesh) <= room / 2;
            self.lists = has_room.then(|| Adjacency::of(mesh)).flatten().map(Arc::new);
        }
        self.clone()
    }

    /// Whether the lists could be made.
    pub(super) fn may_be_made(&self) -> bool {
        self.applied.is_some() && !self.are_made
    }

    /// The starts of the lists, and the neighbors in them.
    pub(super) fn tables(&self) -> [*const u32; 2] {
        self.lists.as_ref().map_or([std::ptr::null(); 2], |lists| lists.tables())
    }
}

impl Translator<'_, '_> {
    /// Translates an instruction of a loop over neighbors, both with lists and with a walk; false
    /// if it is another one.
    pub(super) fn neighbor(&mut self) -> bool {
        let at = self.at;
        let is_here = |one: &&NeighborLoop| [one.begin, one.begin + 1, one.next].contains(&at);
        let Some(&around) = self.neighbor_loops.iter().find(is_here) else { return false };
        let starts = self.lists_of_neighbors(0);
        let [listed, walks, on] = [(); 3].map(|()| self.b.create_block());
        self.b.ins().brif(starts, listed, &[], walks, &[]);
        self.b.switch_to_block(listed);
        match at {
            _ if at == around.begin => self.begin_list(around, starts),
            _ if at == around.next => self.next_in_list(around),
            _ => self.read_list(around),
        }
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(walks);
        let behind = if at == around.begin + 1 { at + CHAIN } else { at + 1 };
        let Text { code, surroundings, .. } = self.text;
        let before = self.known.facts.clone();
        for (at, inst) in (at..behind).zip(&code.insts[at..behind]) {
            (self.at, self.fault) = (at, None);
            let _ = self.value(inst) || self.access(inst);
            self.known.pass(inst, &surroundings);
        }
        self.known.facts = before;
        self.skip = behind - at - 1;
        self.join(on);
        true
    }

    fn begin_list(&mut self, around: NeighborLoop, starts: Value) {
        let id = self.id(around.vertex);
        let offset = self.b.ins().ishl_imm_u(id, 2);
        let place = self.b.ins().iadd(starts, offset);
        let [first, end] = [0, 4].map(|offset| self.listed(place, offset));
        let is_none = self.b.ins().icmp(IntCC::Equal, first, end);
        self.jump_if(is_none, around.otherwise);
        self.set_whole(around.at, first);
        self.set_whole(around.turns, end);
    }

    fn read_list(&mut self, around: NeighborLoop) {
        let all = self.lists_of_neighbors(1);
        let at = self.whole(around.at);
        let offset = self.b.ins().ishl_imm_u(at, 2);
        let place = self.b.ins().iadd(all, offset);
        let neighbor = self.listed(place, 0);
        self.set_whole(around.neighbor, neighbor);
    }

    fn next_in_list(&mut self, around: NeighborLoop) {
        let at = self.whole(around.at);
        let next = self.b.ins().iadd_imm_s(at, 1);
        self.set_whole(around.at, next);
        let end = self.whole(around.turns);
        let is_within = self.b.ins().icmp(IntCC::UnsignedLessThan, next, end);
        self.jump_if(is_within, Label(around.begin as u32 + 1));
    }

    /// The address of the starts of the lists, or of the neighbors in them; 0 if there are no
    /// lists.
    fn lists_of_neighbors(&mut self, part: usize) -> Value {
        self.constant_field(offset_of!(Context, neighbors) + part * size_of::<*const u32>())
    }

    fn listed(&mut self, place: Value, offset: usize) -> Value {
        let value = self.load(I32, Region::Neighbors, place, offset);
        self.b.ins().uextend(I64, value)
    }
}
