//! Reads of the key of a drain, as [`Paths`]: its code is run on sets of paths.
//!
//! A register that holds an element holds here the nodes of the paths that can lead there; a load
//! goes a step on, a loop around an orbit one to all of it, and where ways of the code meet, so do
//! the sets. Functions are followed where they are called. Since a path is as long as its steps,
//! code that follows pointers in a loop of its own never comes to an end: then the key has no
//! tree.

use std::collections::BTreeMap;

use super::paths::{Fields, Node, Paths, START, Step, Unbounded};
use super::{Code, ElementField, Elements, Function, HalfedgeField, Inst, Question, Reg, Walk};

/// The greatest number of instructions that are looked at; a key has dozens.
const MOST_WORK: usize = 50_000;

/// The paths of the key of the drain that the instruction at `open` begins; the code may call
/// these functions.
pub(super) fn paths(code: &Code, functions: &[Function], open: usize) -> Result<Paths, Unbounded> {
    let Some(Inst::DrainOpen { of, .. }) = code.insts.get(open) else {
        return Err(Unbounded::Effects);
    };
    let key = code.insts.iter().enumerate().skip(open);
    let first = |(at, inst): (usize, &Inst)| match inst {
        Inst::DrainStale { to, .. } => Some((at, *to)),
        _ => None,
    };
    let (at, element) = key.filter_map(first).next().ok_or(Unbounded::Effects)?;
    let mut reads = Reads { paths: Paths::new(of.kind()), functions, running: Vec::new(), work: 0 };
    let mut state = State::default();
    state.set(element, vec![START]);
    reads.follow(code, at + 1, state)?;
    reads.paths.finish();
    Ok(reads.paths)
}

/// Nodes in order, none twice.
type Nodes = Vec<Node>;

/// The nodes that registers, and behind them buffers, may hold.
#[derive(Clone, Debug, Default, PartialEq)]
struct State(BTreeMap<u32, Nodes>);

impl State {
    fn set(&mut self, reg: Reg, nodes: Nodes) {
        self.0.insert(u32::from(reg.0), nodes);
    }

    fn buffer(&self, buffer: u16) -> Option<&Nodes> {
        self.0.get(&(1 << 16 | u32::from(buffer)))
    }

    fn set_buffer(&mut self, buffer: u16, nodes: Nodes) {
        self.0.insert(1 << 16 | u32::from(buffer), nodes);
    }

    fn push(&mut self, buffer: u16, nodes: &[Node]) {
        let all = self.0.entry(1 << 16 | u32::from(buffer)).or_default();
        unite(all, nodes);
    }

    /// Takes in what another way brings; whether that is anything new.
    fn join(&mut self, other: &State) -> bool {
        let mut grown = false;
        for (&slot, nodes) in &other.0 {
            grown |= match self.0.entry(slot) {
                std::collections::btree_map::Entry::Vacant(free) => {
                    free.insert(nodes.clone());
                    true
                }
                std::collections::btree_map::Entry::Occupied(mut known) => {
                    unite(known.get_mut(), nodes)
                }
            };
        }
        grown
    }
}

fn unite(all: &mut Nodes, more: &[Node]) -> bool {
    let before = all.len();
    for node in more {
        if let Err(place) = all.binary_search(node) {
            all.insert(place, *node);
        }
    }
    all.len() > before
}

struct Reads<'c> {
    paths: Paths,
    functions: &'c [Function],
    /// The functions that run, the innermost last.
    running: Vec<u16>,
    work: usize,
}

impl Reads<'_> {
    /// Runs code up to the key or the ends of the function; gives what the slots of its value
    /// may hold.
    fn follow(&mut self, code: &Code, start: usize, state: State) -> Result<Vec<Nodes>, Unbounded> {
        let mut before: Vec<Option<State>> = vec![None; code.insts.len()];
        let mut value: Vec<Nodes> = Vec::new();
        let mut open = vec![(start, state)];
        while let Some((at, state)) = open.pop() {
            let Some(known) = before.get_mut(at) else {
                continue;
            };
            let mut state = match known {
                None => known.insert(state).clone(),
                Some(known) => match known.join(&state) {
                    true => known.clone(),
                    false => continue,
                },
            };
            self.work += 1;
            if self.work > MOST_WORK {
                return Err(Unbounded::Endless);
            }
            let inst = code.insts[at];
            match inst {
                Inst::DrainKey { .. } if self.running.is_empty() => continue,
                Inst::Give { from, width } if !self.running.is_empty() => {
                    value.resize(value.len().max(usize::from(width)), Nodes::new());
                    for (part, all) in (0..width).zip(&mut value) {
                        let nodes = self.nodes(&state, Reg(from.0.wrapping_add(part)))?;
                        unite(all, &nodes);
                    }
                    continue;
                }
                Inst::Fail { .. } | Inst::FailShowing { .. } | Inst::Refused { .. } => continue,
                _ => self.take(&inst, &mut state)?,
            }
            let mut inst = inst;
            let target = inst.target_mut().map(|label| label.0 as usize);
            if !matches!(inst, Inst::Jump { .. }) {
                open.push((at + 1, state.clone()));
            }
            if let Some(target) = target {
                open.push((target, state));
            }
        }
        Ok(value)
    }

    /// The nodes that a register may hold. What the key has not set is a variable of the script.
    fn nodes(&mut self, state: &State, reg: Reg) -> Result<Nodes, Unbounded> {
        match state.0.get(&u32::from(reg.0)) {
            Some(nodes) => Ok(nodes.clone()),
            None if self.running.is_empty() => Ok(vec![self.paths.variable(reg)?]),
            None => Ok(Nodes::new()),
        }
    }

    fn buffered(&mut self, state: &State, buffer: u16) -> Result<Nodes, Unbounded> {
        // A list that was made before the key.
        state.buffer(buffer).cloned().ok_or(Unbounded::WholeMesh)
    }

    fn take(&mut self, inst: &Inst, state: &mut State) -> Result<(), Unbounded> {
        match *inst {
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
            Inst::Ask { question, to, elements } => {
                let [first, second] = elements;
                let (first, second) = (self.nodes(state, first)?, self.nodes(state, second)?);
                self.ask(question, &first, &second)?;
                state.set(to, Nodes::new());
            }
            Inst::Collect { walk, buffer, from, .. } => {
                let from = self.nodes(state, from)?;
                let orbit = self.orbit(&from, walk)?;
                state.push(buffer, &orbit);
            }
            Inst::Meets { walk, from, .. } => {
                let from = self.nodes(state, from)?;
                self.orbit(&from, walk)?;
            }
            Inst::MeetsAll { walk, buffer, .. } => {
                let from = self.buffered(state, buffer)?;
                self.orbit(&from, walk)?;
            }
            Inst::Copy { to, from } => {
                let nodes = self.nodes(state, from)?;
                state.set(to, nodes);
            }
            Inst::Select { to, then, otherwise, .. } => {
                let mut nodes = self.nodes(state, then)?;
                unite(&mut nodes, &self.nodes(state, otherwise)?);
                state.set(to, nodes);
            }
            Inst::BufferClear { buffer } => state.set_buffer(buffer, Nodes::new()),
            Inst::BufferPush { buffer, from } => {
                let nodes = self.nodes(state, from)?;
                state.push(buffer, &nodes);
            }
            Inst::BufferGet { buffer, to, .. }
            | Inst::BufferNext { buffer, to, .. }
            | Inst::Member { buffer, to, .. } => {
                let nodes = self.buffered(state, buffer)?;
                state.set(to, nodes);
            }
            Inst::BufferGetWide { buffer, to, width, .. } => {
                let nodes = self.buffered(state, buffer)?;
                for part in 0..width {
                    state.set(Reg(to.0.wrapping_add(part)), nodes.clone());
                }
            }
            Inst::BufferAppend { from, to } | Inst::BufferDeal { from, to, .. } => {
                let nodes = self.buffered(state, from)?;
                state.push(to, &nodes);
            }
            Inst::Call { function, args, to, .. } => {
                let value = self.call(state, function, args)?;
                for (part, nodes) in (0..).zip(value) {
                    state.set(Reg(to.0.wrapping_add(part)), nodes);
                }
            }
            // Which vertices are joined counts as well.
            Inst::CollectEars { .. }
            | Inst::Capacity { .. }
            | Inst::NextLiving { .. }
            | Inst::BufferLiving { .. }
            | Inst::Count { .. }
            | Inst::CountHoles { .. } => return Err(Unbounded::WholeMesh),
            Inst::Random { .. } | Inst::RandomInt { .. } | Inst::BufferShuffle { .. } => {
                return Err(Unbounded::Chance);
            }
            Inst::Try { .. } => return Err(Unbounded::Asks),
            // Values that are no elements; a line that is not printed.
            #[rustfmt::skip]
            Inst::Const { .. } | Inst::CopyVec { .. } | Inst::CopyWide { .. } | Inst::Not { .. }
            | Inst::And { .. } | Inst::Or { .. } | Inst::Equal { .. } | Inst::AddInt { .. }
            | Inst::SubInt { .. } | Inst::MulInt { .. } | Inst::DivInt { .. }
            | Inst::ModInt { .. } | Inst::NegInt { .. } | Inst::AbsInt { .. }
            | Inst::MinInt { .. } | Inst::MaxInt { .. } | Inst::LessInt { .. }
            | Inst::LessEqualInt { .. } | Inst::IntToReal { .. } | Inst::RoundReal { .. }
            | Inst::AddReal { .. } | Inst::SubReal { .. } | Inst::MulReal { .. }
            | Inst::DivReal { .. } | Inst::MinReal { .. } | Inst::MaxReal { .. }
            | Inst::PowReal { .. } | Inst::Atan2Real { .. } | Inst::LessReal { .. }
            | Inst::LessEqualReal { .. } | Inst::EqualReal { .. } | Inst::MathReal { .. }
            | Inst::AddVec { .. } | Inst::SubVec { .. } | Inst::MulVec { .. }
            | Inst::NegVec { .. } | Inst::ScaleVec { .. } | Inst::DivVec { .. }
            | Inst::MixVec { .. } | Inst::EqualVec { .. } | Inst::Dot { .. }
            | Inst::Cross { .. } | Inst::LengthVec { .. } | Inst::Normalize { .. }
            | Inst::Wide { .. } | Inst::Matrix { .. } | Inst::Jump { .. } | Inst::JumpIf { .. }
            | Inst::JumpUnless { .. } | Inst::JumpUnequal { .. } | Inst::JumpEqual { .. }
            | Inst::NextIndex { .. } | Inst::BufferLength { .. } | Inst::Turn { .. }
            | Inst::Tick | Inst::PrintText { .. } | Inst::PrintTextOf { .. }
            | Inst::PrintBool { .. } | Inst::PrintInt { .. } | Inst::PrintReal { .. }
            | Inst::PrintVec { .. } | Inst::PrintWide { .. }
            | Inst::PrintElement { .. } => {}
            // What a key has no business with.
            #[rustfmt::skip]
            Inst::ExpectEqual { .. } | Inst::ExpectDistinct { .. } | Inst::Expect { .. }
            | Inst::ExpectFinite { .. } | Inst::ExpectRoom { .. }
            | Inst::ExpectAllDistinct { .. } | Inst::ExpectRoomFor { .. } | Inst::PreviewClear
            | Inst::PreviewNew { .. } | Inst::PreviewStore { .. }
            | Inst::PreviewStoreHalfedge { .. } | Inst::PreviewStoreHole { .. }
            | Inst::PreviewStoreAll { .. } | Inst::PreviewStoreSpan { .. }
            | Inst::Foresee { .. } | Inst::ForeseeAlong { .. } | Inst::Refuse
            | Inst::Return { .. } | Inst::NewVertex { .. } | Inst::NewHalfedge { .. }
            | Inst::NewEdge { .. } | Inst::NewFace { .. } | Inst::Store { .. }
            | Inst::StoreHalfedge { .. } | Inst::StoreHole { .. }
            | Inst::StorePosition { .. } | Inst::HoldPosition { .. }
            | Inst::StoreAttribute { .. } | Inst::HoldAttribute { .. }
            | Inst::ReleaseHeld { .. } | Inst::StoreAll { .. } | Inst::StoreSpan { .. }
            | Inst::Erase { .. } | Inst::Recycle | Inst::Apply { .. } | Inst::Refused { .. }
            | Inst::PrintEnd | Inst::PrintReason { .. } | Inst::RefusedFor { .. }
            | Inst::PrintDifference { .. } | Inst::MeshKeep { .. } | Inst::MeshSame { .. }
            | Inst::Fail { .. } | Inst::FailShowing { .. } | Inst::Give { .. }
            | Inst::DrainOpen { .. } | Inst::DrainAllStale | Inst::DrainStale { .. }
            | Inst::DrainKey { .. } | Inst::DrainLeast { .. } | Inst::DrainTake
            | Inst::DrainClose => return Err(Unbounded::Effects),
        }
        Ok(())
    }

    fn call(&mut self, state: &State, function: u16, args: Reg) -> Result<Vec<Nodes>, Unbounded> {
        let functions = self.functions;
        let called = functions.get(usize::from(function)).ok_or(Unbounded::Effects)?;
        if self.running.contains(&function) {
            return Err(Unbounded::Recursion);
        }
        let mut inner = State::default();
        for part in 0..called.params {
            let nodes = self.nodes(state, Reg(args.0.wrapping_add(part)))?;
            inner.set(Reg(part), nodes);
        }
        for buffer in 0..called.code.buffers {
            inner.set_buffer(buffer, Nodes::new());
        }
        self.running.push(function);
        let value = self.follow(&called.code, 0, inner);
        self.running.pop();
        value
    }
}

/// The reads on the way.
impl Reads<'_> {
    fn read(&mut self, nodes: &[Node], fields: Fields) {
        for &node in nodes {
            self.paths.read(node, fields);
        }
    }

    fn steps(&mut self, nodes: &[Node], step: Step) -> Result<Nodes, Unbounded> {
        let mut reached = Nodes::new();
        for &node in nodes {
            unite(&mut reached, &[self.paths.child(node, step)?]);
        }
        Ok(reached)
    }

    fn load(&mut self, nodes: &[Node], field: HalfedgeField) -> Result<Nodes, Unbounded> {
        self.read(nodes, Fields::pointer(field));
        self.steps(nodes, Step::Pointer(field))
    }

    fn first(&mut self, nodes: &[Node], of: ElementField) -> Result<Nodes, Unbounded> {
        self.read(nodes, Fields::FIRST);
        self.steps(nodes, Step::First(of))
    }

    /// All halfedges of the orbits of some.
    fn orbit(&mut self, nodes: &[Node], walk: Walk) -> Result<Nodes, Unbounded> {
        let orbit = self.steps(nodes, Step::Orbit(walk))?;
        match walk {
            Walk::Loop => {
                self.read(&orbit, Fields::pointer(HalfedgeField::Next));
            }
            Walk::Star => {
                let before = self.load(&orbit, HalfedgeField::Prev)?;
                self.read(&before, Fields::pointer(HalfedgeField::Twin));
            }
        }
        Ok(orbit)
    }

    fn spokes(&mut self, vertices: &[Node]) -> Result<Nodes, Unbounded> {
        let first = self.first(vertices, ElementField::Vertex)?;
        self.orbit(&first, Walk::Star)
    }

    /// The positions of where halfedges start.
    fn positions(&mut self, halfedges: &[Node]) -> Result<(), Unbounded> {
        let vertices = self.load(halfedges, HalfedgeField::Vertex)?;
        self.read(&vertices, Fields::POSITION);
        Ok(())
    }

    fn holes(&mut self, halfedges: &[Node]) -> Result<Nodes, Unbounded> {
        let faces = self.load(halfedges, HalfedgeField::Face)?;
        self.read(&faces, Fields::HOLE);
        Ok(faces)
    }

    /// Notes the reads of the mesh for an answer; perhaps more.
    fn ask(&mut self, question: Question, of: &[Node], and: &[Node]) -> Result<(), Unbounded> {
        match question {
            Question::Degree => drop(self.spokes(of)?),
            Question::BoundaryVertex => {
                let spokes = self.spokes(of)?;
                self.holes(&spokes)?;
            }
            Question::Adjacent => {
                for vertex in [of, and] {
                    let spokes = self.spokes(vertex)?;
                    let twins = self.load(&spokes, HalfedgeField::Twin)?;
                    self.load(&twins, HalfedgeField::Vertex)?;
                }
            }
            Question::NormalVertex => {
                let spokes = self.spokes(of)?;
                self.faces_at(&spokes)?;
            }
            Question::BoundaryEdge | Question::LengthEdge => {
                let half = self.first(of, ElementField::Edge)?;
                let twin = self.load(&half, HalfedgeField::Twin)?;
                for half in [half, twin] {
                    match question {
                        Question::BoundaryEdge => drop(self.holes(&half)?),
                        _ => self.positions(&half)?,
                    }
                }
            }
            Question::LinkCondition | Question::StarShaped | Question::KernelCentroid => {
                let half = self.first(of, ElementField::Edge)?;
                let twin = self.load(&half, HalfedgeField::Twin)?;
                for half in [half, twin] {
                    self.holes(&half)?;
                    let end = self.load(&half, HalfedgeField::Vertex)?;
                    let spokes = self.spokes(&end)?;
                    self.faces_at(&spokes)?;
                }
            }
            Question::FaceSize => {
                let first = self.first(of, ElementField::Face)?;
                self.orbit(&first, Walk::Loop)?;
            }
            Question::Area | Question::NormalFace | Question::CentroidFace => {
                let first = self.first(of, ElementField::Face)?;
                let corners = self.orbit(&first, Walk::Loop)?;
                self.positions(&corners)?;
            }
        }
        Ok(())
    }

    /// The loops at halfedges with all that is drawn of them: pointers, corners, and the ends
    /// and loops beyond their edges.
    fn faces_at(&mut self, halfedges: &[Node]) -> Result<(), Unbounded> {
        let faces = self.holes(halfedges)?;
        self.first(&faces, ElementField::Face)?;
        let sides = self.orbit(halfedges, Walk::Loop)?;
        self.load(&sides, HalfedgeField::Prev)?;
        self.positions(&sides)?;
        let twins = self.load(&sides, HalfedgeField::Twin)?;
        self.load(&twins, HalfedgeField::Vertex)?;
        Ok(())
    }
}
