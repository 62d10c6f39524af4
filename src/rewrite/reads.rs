//! The reads of the key of a drain, or of an operation that is asked, as [`Paths`]: an abstract
//! interpretation of the code on sets of paths.
//!
//! A register that holds an element holds here the nodes of the paths that can lead to it; a load
//! extends each path by a step, a loop around an orbit by a step to the whole orbit, and where
//! branches of the code meet, the sets are united. Calls are followed into functions. Since a path
//! is as long as its steps, code that follows pointers in a loop of its own does not reach a fixed
//! point: then the key has no tree.

use std::collections::BTreeMap;
use std::mem;

use super::inst::group;
use super::paths::{Fields, Node, Paths, START, Unbounded};
use super::{Code, ElementField, Elements, Function, HalfedgeField, Inst, Plan, Reg, Walk};
use crate::mesh::ElementKind;

/// The greatest number of instructions that are visited; a key has dozens, an operation hundreds.
const MOST_WORK: usize = 50_000;

/// The paths of the key of the drain that the instruction at `open` begins; `functions` are those
/// that the code may call, `plans` the operations that it may ask.
pub(super) fn paths(
    code: &Code,
    functions: &[Function],
    plans: &[Option<Plan>],
    open: usize,
) -> Result<Paths, Unbounded> {
    let Some(Inst::DrainOpen { of, .. }) = code.insts.get(open) else {
        return Err(Unbounded::Effects);
    };
    let key = code.insts.iter().enumerate().skip(open);
    let first = |(at, inst): (usize, &Inst)| match inst {
        Inst::DrainStale { to, .. } => Some((at, *to)),
        _ => None,
    };
    let (at, element) = key.filter_map(first).next().ok_or(Unbounded::Effects)?;
    let mut reads = Reads::new(of.kind(), functions, plans);
    let mut state = State::default();
    state.set(element, vec![START]);
    reads.follow(code, at + 1, state)?;
    reads.paths.finish();
    Ok(reads.paths)
}

/// The paths of the question whether an operation would be applied, asked of the element of the
/// given kind in a slot of its window.
///
/// # Errors
/// The reason, if the question has no paths.
pub(super) fn question_paths(
    plan: &Plan,
    kind: ElementKind,
    slot: usize,
) -> Result<Paths, Unbounded> {
    if plan.steps.is_some() {
        return Err(Unbounded::Effects);
    }
    let mut reads = Reads { is_question: true, ..Reads::new(kind, &plan.code.functions, &[]) };
    let mut state = State::at_start(&plan.code);
    for param in 0..plan.params.iter().sum::<u16>() {
        let node = match usize::from(param) == slot {
            true => START,
            false => reads.paths.variable(Reg(param))?,
        };
        state.set(Reg(param), vec![node]);
    }
    reads.follow(&plan.code, 0, state)?;
    reads.paths.finish();
    Ok(reads.paths)
}

/// Nodes in ascending order, without duplicates.
pub(super) type Nodes = Vec<Node>;

/// The nodes that registers, buffers and the pointers of a preview may hold, in this order of keys.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct State(BTreeMap<u32, Nodes>);

/// The keys of the first buffer and of the first pointer of the preview.
const BUFFERS: u32 = 1 << 16;
const PREVIEW: u32 = 2 << 16;

impl State {
    /// The state at the start of a code: its buffers are empty.
    fn at_start(code: &Code) -> Self {
        let mut state = Self::default();
        (0..code.buffers).for_each(|buffer| state.set_buffer(buffer, Nodes::new()));
        state
    }

    pub(super) fn set(&mut self, reg: Reg, nodes: Nodes) {
        self.0.insert(u32::from(reg.0), nodes);
    }

    fn buffer(&self, buffer: u16) -> Option<&Nodes> {
        self.0.get(&(BUFFERS | u32::from(buffer)))
    }

    fn set_buffer(&mut self, buffer: u16, nodes: Nodes) {
        self.0.insert(BUFFERS | u32::from(buffer), nodes);
    }

    fn push(&mut self, buffer: u16, nodes: &[Node]) {
        unite(self.0.entry(BUFFERS | u32::from(buffer)).or_default(), nodes);
    }

    /// The values that have been set in the preview for a pointer, of any element.
    pub(super) fn foreseen(&self, pointer: u32) -> Nodes {
        self.0.get(&(PREVIEW | pointer)).cloned().unwrap_or_default()
    }

    pub(super) fn foresee(&mut self, pointer: u32, nodes: &[Node]) {
        unite(self.0.entry(PREVIEW | pointer).or_default(), nodes);
    }

    pub(super) fn clear_preview(&mut self) {
        self.0.split_off(&PREVIEW);
    }

    /// Unites this state with that of another branch; returns whether this has added anything.
    fn join(&mut self, other: &State) -> bool {
        let mut grown = false;
        for (&slot, nodes) in &other.0 {
            grown |= match self.0.get_mut(&slot) {
                Some(known) => unite(known, nodes),
                None => self.0.insert(slot, nodes.clone()).is_none(),
            };
        }
        grown
    }
}

/// Unites a state with the one known at an instruction, and puts the instruction on the worklist
/// `open` if this has added anything.
fn arrive(before: &mut [Option<State>], at: usize, state: &State, open: &mut Vec<usize>) {
    let is_new = match before.get_mut(at) {
        None => false,
        Some(Some(known)) => known.join(state),
        Some(unknown) => {
            *unknown = Some(state.clone());
            true
        }
    };
    if is_new {
        open.push(at);
    }
}

pub(super) fn unite(all: &mut Nodes, more: &[Node]) -> bool {
    let before = all.len();
    for node in more {
        if let Err(place) = all.binary_search(node) {
            all.insert(place, *node);
        }
    }
    all.len() > before
}

pub(super) struct Reads<'c> {
    pub(super) paths: Paths,
    functions: &'c [Function],
    plans: &'c [Option<Plan>],
    /// The stack of running functions, the innermost last.
    running: Vec<u16>,
    work: usize,
    /// Whether the code is an operation that is asked: its answer is known at its first write.
    is_question: bool,
}

impl<'c> Reads<'c> {
    fn new(kind: ElementKind, functions: &'c [Function], plans: &'c [Option<Plan>]) -> Self {
        let paths = Paths::new(kind);
        Self { paths, functions, plans, running: Vec::new(), work: 0, is_question: false }
    }

    /// Runs code up to the key, the answer or the ends of the function; returns the nodes that the
    /// slots of its value may hold.
    fn follow(&mut self, code: &Code, start: usize, state: State) -> Result<Vec<Nodes>, Unbounded> {
        let insts = &code.insts;
        let targets: Vec<Option<usize>> = insts.iter().map(|inst| inst.target()).collect();
        let mut is_target = vec![false; insts.len()];
        for &target in targets.iter().flatten() {
            if let Some(is_target) = is_target.get_mut(target) {
                *is_target = true;
            }
        }
        // The state before each target of a jump.
        let mut before: Vec<Option<State>> = vec![None; insts.len()];
        let mut value: Vec<Nodes> = Vec::new();
        let mut open = Vec::new();
        arrive(&mut before, start, &state, &mut open);
        while let Some(from) = open.pop() {
            let mut state = before[from].clone().unwrap_or_default();
            for at in from..insts.len() {
                if at > from && is_target[at] {
                    arrive(&mut before, at, &state, &mut open);
                    break;
                }
                self.work += 1;
                if self.work > MOST_WORK {
                    return Err(Unbounded::Endless);
                }
                match insts[at] {
                    Inst::DrainKey { .. } | Inst::Refuse | Inst::Return { .. }
                        if self.running.is_empty() =>
                    {
                        break;
                    }
                    inst if self.is_question && self.running.is_empty() && inst.writes() => break,
                    Inst::ReturnValue { from, width } if !self.running.is_empty() => {
                        value.resize(value.len().max(usize::from(width)), Nodes::new());
                        for (part, all) in (0..width).zip(&mut value) {
                            unite(all, &self.nodes(&state, Reg(from.0.wrapping_add(part)))?);
                        }
                        break;
                    }
                    Inst::Fail { .. } | Inst::FailShowing { .. } | Inst::Refused { .. } => break,
                    inst => self.take(&inst, &mut state)?,
                }
                if let Some(target) = targets[at] {
                    arrive(&mut before, target, &state, &mut open);
                }
                if let Inst::Jump { .. } = insts[at] {
                    break;
                }
            }
        }
        Ok(value)
    }

    /// The nodes that a register may hold. A register that the key has not set is a variable of the
    /// script.
    pub(super) fn nodes(&mut self, state: &State, reg: Reg) -> Result<Nodes, Unbounded> {
        match state.0.get(&u32::from(reg.0)) {
            Some(nodes) => Ok(nodes.clone()),
            None if self.running.is_empty() && !self.is_question => {
                Ok(vec![self.paths.variable(reg)?])
            }
            None => Ok(Nodes::new()),
        }
    }

    pub(super) fn buffered(&mut self, state: &State, buffer: u16) -> Result<Nodes, Unbounded> {
        // The buffer was filled before the key.
        state.buffer(buffer).cloned().ok_or(Unbounded::WholeMesh)
    }

    fn take(&mut self, inst: &Inst, state: &mut State) -> Result<(), Unbounded> {
        match *inst {
            Inst::Const { to, .. } => state.set(to, Nodes::new()),
            Inst::Load { field, to, halfedge } => {
                let from = self.nodes(state, halfedge)?;
                state.set(to, self.load(&from, field)?);
            }
            Inst::LoadHalfedge { of, to, element } => {
                let from = self.nodes(state, element)?;
                state.set(to, self.first(&from, of)?);
            }
            Inst::LoadHole { to, face } => {
                let from = self.nodes(state, face)?;
                self.read(&from, Fields::HOLE);
                state.set(to, Nodes::new());
            }
            Inst::LoadPosition { vertex, .. } => {
                let from = self.nodes(state, vertex)?;
                self.read(&from, Fields::POSITION);
            }
            Inst::LoadAttribute { attribute, element, .. } => {
                let from = self.nodes(state, element)?;
                self.read(&from, Fields::attribute(attribute));
            }
            Inst::JumpUnlessLiving { of, element, .. } => {
                let from = self.nodes(state, element)?;
                self.read(&from, Fields::LIFE);
                if matches!(of, Elements::Faces | Elements::Holes) {
                    self.read(&from, Fields::HOLE);
                }
            }
            Inst::Alive { element, .. } | Inst::ExpectAlive { from: element, .. } => {
                let from = self.nodes(state, element)?;
                self.read(&from, Fields::LIFE);
            }
            Inst::Ask { question, to, elements: [first, second] } => {
                let (first, second) = (self.nodes(state, first)?, self.nodes(state, second)?);
                self.ask(question, &first, &second)?;
                state.set(to, Nodes::new());
            }
            Inst::Collect { walk, buffer, from, .. } => {
                let from = self.nodes(state, from)?;
                state.push(buffer, &self.orbit(&from, walk)?);
            }
            Inst::WalkBegin { walk, from, at, turns, .. } => {
                let from = self.nodes(state, from)?;
                state.set(at, self.orbit(&from, walk)?);
                state.set(turns, Nodes::new());
            }
            Inst::NeighborsBegin { vertex, slots, neighbor, .. } => {
                let vertex = self.nodes(state, vertex)?;
                let first = self.first(&vertex, ElementField::Vertex)?;
                let spokes = self.orbit(&first, Walk::Star)?;
                let twins = self.load(&spokes, HalfedgeField::Twin)?;
                state.set(neighbor, self.load(&twins, HalfedgeField::Vertex)?);
                for slot in 0..3 {
                    state.set(Reg(slots.0.wrapping_add(slot)), Nodes::new());
                }
            }
            // The position stays on the orbit.
            Inst::WalkNext { .. } | Inst::NeighborsNext { .. } => {}
            Inst::Meets { walk, from, .. } => {
                let from = self.nodes(state, from)?;
                self.orbit(&from, walk)?;
            }
            Inst::MeetsAll { walk, buffer, .. } => {
                let from = self.buffered(state, buffer)?;
                self.orbit(&from, walk)?;
            }
            Inst::Copy { to, from } => state.set(to, self.nodes(state, from)?),
            Inst::Select { to, then, otherwise, .. } => {
                let mut nodes = self.nodes(state, then)?;
                unite(&mut nodes, &self.nodes(state, otherwise)?);
                state.set(to, nodes);
            }
            Inst::BufferClear { buffer } => state.set_buffer(buffer, Nodes::new()),
            Inst::BufferPush { buffer, from } => state.push(buffer, &self.nodes(state, from)?),
            Inst::BufferGet { buffer, to, .. }
            | Inst::BufferNext { buffer, to, .. }
            | Inst::Member { buffer, to, .. } => state.set(to, self.buffered(state, buffer)?),
            Inst::BufferGetWide { buffer, to, width, .. } => {
                let nodes = self.buffered(state, buffer)?;
                for part in 0..width {
                    state.set(Reg(to.0.wrapping_add(part)), nodes.clone());
                }
            }
            Inst::BufferAppend { from, to } | Inst::BufferStride { from, to, .. } => {
                state.push(to, &self.buffered(state, from)?);
            }
            Inst::Call { function, args, to, .. } => {
                let value = self.call(state, function, args)?;
                for (part, nodes) in (0..).zip(value) {
                    state.set(Reg(to.0.wrapping_add(part)), nodes);
                }
            }
            // The result also depends on which vertices are adjacent.
            Inst::CollectEars { .. }
            | Inst::Capacity { .. }
            | Inst::NextLiving { .. }
            | Inst::BufferLiving { .. }
            | Inst::Spread { .. }
            | Inst::Count { .. }
            | Inst::CountHoles { .. } => return Err(Unbounded::WholeMesh),
            Inst::Random { .. } | Inst::RandomInt { .. } | Inst::BufferShuffle { .. } => {
                return Err(Unbounded::Random);
            }
            Inst::Try { op, args, to, .. } => {
                self.ask_operation(state, op, args)?;
                state.set(to, Nodes::new());
            }
            group!(previews) | Inst::Foresee { .. } | Inst::ForeseeAlong { .. } => {
                self.look_ahead(inst, state)?
            }
            // Values that are not elements; tests of such values; printing, which has no effect
            // here.
            #[rustfmt::skip]
            group!(computes) | group!(expects) | group!(prints) | Inst::NextIndex { .. }
            | Inst::BufferLength { .. } | Inst::Iteration { .. } | Inst::Tick
            | Inst::BufferFree { .. } | Inst::Keep { .. } | Inst::Prefetch { .. } => {}
            // The drain still holds ids, so nothing is recycled.
            Inst::Recycle => {}
            // Instructions that occur neither in a key nor in an operation up to its first write.
            group!(writes)
            | group!(defers)
            | group!(scripts)
            | Inst::Refuse
            | Inst::Return { .. } => return Err(Unbounded::Effects),
        }
        Ok(())
    }

    fn call(&mut self, state: &State, function: u16, args: Reg) -> Result<Vec<Nodes>, Unbounded> {
        let called = self.functions.get(usize::from(function)).ok_or(Unbounded::Effects)?;
        if self.running.contains(&function) {
            return Err(Unbounded::Recursion);
        }
        let inner = self.called(state, args, called.params, &called.code)?;
        self.running.push(function);
        let value = self.follow(&called.code, 0, inner);
        self.running.pop();
        value
    }

    /// Notes the reads of the question whether an operation would be applied.
    fn ask_operation(&mut self, state: &State, op: u16, args: Reg) -> Result<(), Unbounded> {
        let plan = self.plans.get(usize::from(op)).and_then(Option::as_ref);
        let plan = plan.filter(|plan| plan.steps.is_none()).ok_or(Unbounded::Steps)?;
        let inner = self.called(state, args, plan.params.iter().sum(), &plan.code)?;
        let mut question = Reads {
            paths: mem::take(&mut self.paths),
            functions: &plan.code.functions,
            plans: &[],
            running: Vec::new(),
            work: self.work,
            is_question: true,
        };
        let answer = question.follow(&plan.code, 0, inner);
        (self.paths, self.work) = (question.paths, question.work);
        answer.map(drop)
    }

    /// The state in which a code that is called with arguments in slots from `args` begins.
    fn called(
        &mut self,
        state: &State,
        args: Reg,
        params: u16,
        code: &Code,
    ) -> Result<State, Unbounded> {
        let mut inner = State::at_start(code);
        for part in 0..params {
            inner.set(Reg(part), self.nodes(state, Reg(args.0.wrapping_add(part)))?);
        }
        Ok(inner)
    }
}
