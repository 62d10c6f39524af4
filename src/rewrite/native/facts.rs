//! Facts about the elements in registers at each instruction.
//!
//! An element that a pointer of a living element leads to lives: this holds on a valid mesh, before
//! and after every proved operation, and within one until it erases. An element that has been read
//! or written is in range. So native code tests each element once, and those reached by pointers
//! only for their range.

use super::access::pointer;
use super::compile::entries;
use super::operands::{Environment, Use};
use crate::mesh::ElementKind;
use crate::rewrite::neighbors::of_loop;
use crate::rewrite::{Code, HalfedgeField, Inst, Question, Reg};

/// Facts about the element in a register.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Fact {
    kind: Option<ElementKind>,
    in_range: bool,
    lives: bool,
    /// The upper 32 bits of the register are zero.
    is_clean: bool,
    /// A register with a halfedge that starts at the vertex.
    spoke: Option<Reg>,
}

impl Fact {
    /// The facts about an element that a pointer of a living element leads to.
    fn led_to(kind: ElementKind) -> Self {
        Self { kind: Some(kind), in_range: false, lives: true, is_clean: true, spoke: None }
    }

    /// The facts about an element that has just been added, read or written.
    fn new(kind: ElementKind) -> Self {
        Self { in_range: true, ..Self::led_to(kind) }
    }

    /// Whether the upper 32 bits of the register are zero.
    pub(super) fn is_clean(self) -> bool {
        self.is_clean
    }

    /// Whether the number is known to be that of a record of this kind.
    pub(super) fn is_in_range(self, kind: ElementKind) -> bool {
        self.in_range && self.kind == Some(kind)
    }

    /// Whether the element is known to live, if it is in range.
    pub(super) fn lives(self, kind: ElementKind) -> bool {
        self.lives && self.kind == Some(kind)
    }

    /// A register with a halfedge that starts at the vertex.
    pub(super) fn spoke(self) -> Option<Reg> {
        self.spoke
    }

    /// The same facts in the window of another call.
    pub(super) fn elsewhere(self) -> Self {
        Self { spoke: None, ..self }
    }

    fn meet(self, other: Self) -> Self {
        match self.kind == other.kind {
            true => Self {
                kind: self.kind,
                in_range: self.in_range && other.in_range,
                lives: self.lives && other.lives,
                is_clean: self.is_clean && other.is_clean,
                spoke: self.spoke.filter(|_| self.spoke == other.spoke),
            },
            false => Self::default(),
        }
    }
}

/// Facts about all registers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Facts(Vec<Fact>);

impl Facts {
    /// No facts about `registers` registers.
    pub(super) fn none(registers: usize) -> Self {
        Self(vec![Fact::default(); registers])
    }

    /// Facts about the first of `registers` registers.
    pub(super) fn of_params(registers: usize, params: impl Iterator<Item = Fact>) -> Self {
        let mut facts: Vec<Fact> = params.collect();
        facts.resize(registers, Fact::default());
        Self(facts)
    }

    pub(super) fn of(&self, reg: Reg) -> Fact {
        self.0.get(usize::from(reg.0)).copied().unwrap_or_default()
    }

    /// Notes that the element in a register has been read or written, so it exists.
    fn use_element(&mut self, reg: Reg, kind: ElementKind) {
        let Fact { is_clean, spoke, .. } = self.of(reg);
        self.set(reg, Fact { is_clean, spoke, ..Fact::new(kind) });
    }

    /// Notes that a loop visits a neighbor.
    fn visit(&mut self, [slots, neighbor]: [Reg; 2]) {
        let [_, at, _] = of_loop(slots);
        self.set(at, Fact::led_to(ElementKind::Halfedge));
        self.set(neighbor, Fact::led_to(ElementKind::Vertex));
    }

    fn set(&mut self, reg: Reg, fact: Fact) {
        if let Some(known) = self.0.get_mut(usize::from(reg.0)) {
            *known = fact;
        }
    }

    fn meet(&mut self, other: &Self) -> bool {
        let mut changed = false;
        for (known, other) in self.0.iter_mut().zip(&other.0) {
            let met = known.meet(*other);
            changed |= met != *known;
            *known = met;
        }
        changed
    }

    /// Applies the effect of an instruction that continues with the next one.
    fn take(&mut self, inst: &Inst, environment: &Environment) {
        let before = match *inst {
            Inst::Copy { from, .. } | Inst::WalkBegin { from, .. } => self.of(from),
            _ => Fact::default(),
        };
        self.forget_written(inst, environment);
        if moves_spokes(inst) {
            self.0.iter_mut().for_each(|fact| fact.spoke = None);
        }
        match *inst {
            Inst::Copy { to, .. } | Inst::WalkBegin { at: to, .. } => self.set(to, before),
            Inst::WalkNext { at, .. } => self.set(at, Fact::led_to(ElementKind::Halfedge)),
            Inst::NeighborsBegin { vertex, slots, neighbor, .. } => {
                self.use_element(vertex, ElementKind::Vertex);
                self.visit([slots, neighbor]);
            }
            Inst::NeighborsNext { slots, neighbor, .. } => self.visit([slots, neighbor]),
            Inst::Load { field, to, halfedge } => {
                let (_, _, kind) = pointer(field);
                self.use_element(halfedge, ElementKind::Halfedge);
                let spoke = (field == HalfedgeField::Vertex && to != halfedge).then_some(halfedge);
                self.set(to, Fact { spoke, ..Fact::led_to(kind) });
            }
            Inst::LoadHalfedge { of, to, element } => {
                self.use_element(element, of.kind());
                self.set(to, Fact::led_to(ElementKind::Halfedge));
            }
            Inst::LoadHole { face, .. } => self.use_element(face, ElementKind::Face),
            Inst::LoadPosition { vertex, .. } | Inst::StorePosition { vertex, .. } => {
                self.use_element(vertex, ElementKind::Vertex);
            }
            Inst::Store { halfedge, .. } => self.use_element(halfedge, ElementKind::Halfedge),
            Inst::StoreHalfedge { of, element, .. } => self.use_element(element, of.kind()),
            Inst::StoreHole { face, .. } => self.use_element(face, ElementKind::Face),
            Inst::NextLiving { of, element, .. } | Inst::JumpUnlessLiving { of, element, .. } => {
                self.use_element(element, of.kind());
            }
            Inst::Ask { question, to, elements } => {
                let count = if question == Question::Adjacent { 2 } else { 1 };
                for element in elements.into_iter().take(count).filter(|element| *element != to) {
                    self.use_element(element, question.kind());
                }
            }
            Inst::New { kind, to } => self.set(to, Fact::new(kind)),
            Inst::Erase { kind, .. } => {
                for fact in self.0.iter_mut().filter(|fact| fact.kind == Some(kind)) {
                    fact.lives = false;
                }
            }
            Inst::Call { function, .. } if environment.only_reads(function) => {}
            // Other functions and operations may erase.
            Inst::Call { .. } | Inst::Apply { .. } | Inst::Try { .. } => {
                self.0.fill(Fact::default());
            }
            _ => {}
        }
    }

    fn forget_written(&mut self, inst: &Inst, environment: &Environment) {
        environment.each_operand(inst, &mut |operand| {
            if operand.used != Use::Read {
                for reg in operand.registers() {
                    if self.of(reg).kind == Some(ElementKind::Halfedge) {
                        let others = self.0.iter_mut().filter(|fact| fact.spoke == Some(reg));
                        others.for_each(|fact| fact.spoke = None);
                    }
                    self.set(reg, Fact::default());
                }
            }
        });
    }
}

/// Whether an instruction may change which halfedges start at a vertex.
fn moves_spokes(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::PreviewStore { .. }
            | Inst::PreviewStoreAll { .. }
            | Inst::PreviewStoreSpan { .. }
            | Inst::PreviewUndo
    ) || inst.writes()
}

/// For each target of a jump, the facts that hold on every path to it.
pub(super) struct KnownAt(Vec<Option<Facts>>);

impl KnownAt {
    /// Computes the facts; `start` are those at the beginning of the code.
    pub(super) fn of(code: &Code, start: &Facts, environment: &Environment) -> Self {
        let insts = &code.insts;
        let mut known = Self(vec![None; insts.len() + 1]);
        let is_target = targets(code);
        // At the other entries nothing is known.
        for entry in entries(code) {
            known.0[entry as usize] = Some(Facts::none(start.0.len()));
        }
        // The facts only become fewer, so this ends.
        loop {
            let mut changed = false;
            let mut walk = Walk::with(start.clone());
            for (at, inst) in insts.iter().enumerate() {
                if is_target[at] {
                    walk.arrive(&mut known, at, &mut changed);
                }
                let Some(facts) = &mut walk.facts else { continue };
                if let Some(to) = inst.target() {
                    let mut there = facts.clone();
                    match inst {
                        Inst::WalkNext { .. } | Inst::NeighborsNext { .. } => {
                            there.take(inst, environment)
                        }
                        _ => there.forget_written(inst, environment),
                    }
                    known.join(to.min(insts.len()), &there, &mut changed);
                }
                facts.take(inst, environment);
                if ends(inst) {
                    walk.facts = None;
                }
            }
            if !changed {
                return known;
            }
        }
    }

    fn join(&mut self, at: usize, facts: &Facts, changed: &mut bool) {
        match &mut self.0[at] {
            Some(known) => *changed |= known.meet(facts),
            unknown => {
                *unknown = Some(facts.clone());
                *changed = true;
            }
        }
    }
}

/// The facts at the current instruction, while the instructions are visited in order.
pub(super) struct Walk {
    /// `None` where the code is not reached.
    pub(super) facts: Option<Facts>,
}

impl Walk {
    pub(super) fn new(registers: usize) -> Self {
        Self::with(Facts::none(registers))
    }

    pub(super) fn with(facts: Facts) -> Self {
        Self { facts: Some(facts) }
    }

    fn arrive(&mut self, known: &mut KnownAt, at: usize, changed: &mut bool) {
        if let Some(facts) = &self.facts {
            known.join(at, facts, changed);
        }
        self.facts = known.0[at].clone();
    }

    /// Enters an instruction that is the target of a jump.
    pub(super) fn enter(&mut self, known: &KnownAt, at: usize) {
        self.facts = known.0[at].clone();
    }

    /// Moves past an instruction.
    pub(super) fn pass(&mut self, inst: &Inst, environment: &Environment) {
        if let Some(facts) = &mut self.facts {
            facts.take(inst, environment);
        }
        if ends(inst) {
            self.facts = None;
        }
    }
}

/// Whether the code does not continue with the next instruction.
pub(super) fn ends(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::Jump { .. }
            | Inst::Refuse
            | Inst::Return { .. }
            | Inst::ReturnValue { .. }
            | Inst::Fail { .. }
            | Inst::FailShowing { .. }
    )
}

/// By index, whether an instruction, or the end of the code, is the target of a jump or an entry.
pub(super) fn targets(code: &Code) -> Vec<bool> {
    let insts = &code.insts;
    let mut targets = vec![false; insts.len() + 1];
    for entry in entries(code) {
        targets[entry as usize] = true;
    }
    for (_, to) in jumps(code) {
        targets[to.min(insts.len())] = true;
    }
    targets
}

/// The jumps of a code, from index to index.
pub(super) fn jumps(code: &Code) -> impl Iterator<Item = (usize, usize)> {
    code.insts.iter().enumerate().filter_map(|(at, inst)| Some((at, inst.target()?)))
}

/// By index, whether an instruction is reachable.
pub(super) fn reached(code: &Code) -> Vec<bool> {
    let mut reached = vec![false; code.insts.len()];
    let mut open = vec![0];
    while let Some(at) = open.pop() {
        let Some(inst) = code.insts.get(at).filter(|_| !std::mem::replace(&mut reached[at], true))
        else {
            continue;
        };
        open.extend(inst.target());
        if !ends(inst) {
            open.push(at + 1);
        }
    }
    reached
}
