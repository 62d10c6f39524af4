//! Aggregation of values: `mean(length(e) for e in edges where boundary(e))`.

use super::operator::wide;
use super::{copy, width};
use crate::diagram::{Around, Collection, Expr, ExprKind, Fold, FoldFunction, Pointer, Type};
use crate::mesh::ElementKind;
use crate::rewrite::{Assembler, Elements, Inst, Label, Lanes, Reg};

/// The instruction for the number of all elements of a kind, which the mesh stores.
pub(super) fn known_count(fold: &Fold, to: Reg) -> Option<Inst> {
    let all = fold.filter.is_none() && fold.body.kind == ExprKind::Bool(true);
    let counts = fold.function == FoldFunction::Count && all;
    let of = fold.collection.all().filter(|_| counts)?;
    Some(match of {
        Elements::Holes => Inst::CountHoles { to },
        of => Inst::Count { kind: of.kind(), to },
    })
}

/// Ends an aggregate early with an answer.
pub(super) fn settle(asm: &mut Assembler, to: Reg, answer: bool, done: Label) {
    let from = asm.constant_bool(answer);
    asm.emit(Inst::Copy { to, from });
    asm.emit(Inst::Jump { to: done });
}

/// Puts the lesser or greater of two values into a register, of vectors in each component.
pub(super) fn better(asm: &mut Assembler, function: FoldFunction, ty: Type, all: [Reg; 3]) {
    for part in 0..width(ty) {
        let [to, left, right] = all.map(|value| value.part(part));
        asm.emit(match (function, ty) {
            (FoldFunction::Min, Type::Int) => Inst::MinInt { to, left, right },
            (FoldFunction::Min, _) => Inst::MinReal { to, left, right },
            (_, Type::Int) => Inst::MaxInt { to, left, right },
            (_, _) => Inst::MaxReal { to, left, right },
        });
    }
}

/// The aggregate of the values so far: in `to`, of type `ty`; in `seen` the number of values, where
/// that matters; and in `best` the value of the element in `to`, if the aggregate is an element.
#[derive(Clone, Copy)]
pub(super) struct Sum {
    pub(super) ty: Type,
    pub(super) to: Reg,
    pub(super) seen: Reg,
    pub(super) best: Reg,
}

impl Sum {
    pub(super) fn start(self, asm: &mut Assembler, function: FoldFunction) {
        // The bits of zero are the same for an int, a real and a bool.
        let start = asm.constant_bits(u64::from(function == FoldFunction::All));
        for part in 0..width(self.ty) {
            asm.emit(Inst::Copy { to: self.to.part(part), from: start });
        }
        let from = asm.constant_int(0);
        asm.emit(Inst::Copy { to: self.seen, from });
    }

    /// Converts a value of the body to the aggregate's type.
    pub(super) fn value(self, asm: &mut Assembler, ty: Type, from: Reg) -> Reg {
        if ty == Type::Int && self.ty == Type::Real {
            let to = asm.reg();
            asm.emit(Inst::IntToReal { to, from });
            return to;
        }
        from
    }

    /// Adds the value of an element to the aggregate, for the functions that need all values; `ty`
    /// is the type of the body.
    pub(super) fn take(
        self,
        asm: &mut Assembler,
        (function, place): (FoldFunction, u32),
        ty: Type,
        [value, element]: [Reg; 2],
        next: Label,
    ) {
        match function {
            FoldFunction::ArgMin | FoldFunction::ArgMax => {
                self.take_element(asm, (function, ty), (value, element), next);
            }
            FoldFunction::Min | FoldFunction::Max => self.take_better(asm, function, value, next),
            _ => {
                asm.trap_at(place, self.add(value));
                if function == FoldFunction::Mean {
                    self.add_one(asm, self.seen);
                }
            }
        }
    }

    fn add(self, right: Reg) -> Inst {
        let (to, left) = (self.to, self.to);
        match self.ty {
            Type::Vec3 => Inst::AddVec { to, left, right },
            Type::Int => Inst::AddInt { to, left, right },
            ty if ty.size() > 1 => wide(Lanes::Add, ty, [to, left, right]),
            _ => Inst::AddReal { to, left, right },
        }
    }

    pub(super) fn add_one(self, asm: &mut Assembler, to: Reg) {
        let (left, right) = (to, asm.constant_int(1));
        asm.emit(Inst::AddInt { to, left, right });
    }

    /// Keeps the lesser or greater of two values; the first value is taken as it is.
    fn take_better(self, asm: &mut Assembler, function: FoldFunction, right: Reg, next: Label) {
        let compare = asm.label();
        let to = self.to;
        asm.emit(Inst::JumpIf { condition: self.seen, to: compare });
        copy(asm, self.ty, to, right);
        self.add_one(asm, self.seen);
        asm.emit(Inst::Jump { to: next });
        asm.bind(compare);
        better(asm, function, self.ty, [to, to, right]);
    }

    /// Keeps the element with the better value; of equal values, the first. NaN is worse than any
    /// number, as it is for the least and the greatest value.
    fn take_element(
        self,
        asm: &mut Assembler,
        (function, ty): (FoldFunction, Type),
        (value, element): (Reg, Reg),
        next: Label,
    ) {
        let (take, better) = (asm.label(), asm.reg());
        let condition = self.seen;
        asm.emit(Inst::Not { to: better, from: condition });
        asm.emit(Inst::JumpIf { condition: better, to: take });
        let (left, right) = match function {
            FoldFunction::ArgMin => (value, self.best),
            _ => (self.best, value),
        };
        let (to, condition) = (better, better);
        if ty == Type::Int {
            asm.emit(Inst::LessInt { to, left, right });
            asm.emit(Inst::JumpUnless { condition, to: next });
        } else {
            asm.emit(Inst::LessReal { to, left, right });
            asm.emit(Inst::JumpIf { condition, to: take });
            // Only NaN differs from itself.
            let (left, right) = (self.best, self.best);
            asm.emit(Inst::EqualReal { to, left, right });
            asm.emit(Inst::JumpIf { condition, to: next });
            let (left, right) = (value, value);
            asm.emit(Inst::EqualReal { to, left, right });
            asm.emit(Inst::JumpUnless { condition, to: next });
        }
        asm.bind(take);
        let (to, from) = (self.best, value);
        asm.emit(Inst::Copy { to, from });
        let (to, from) = (self.to, element);
        asm.emit(Inst::Copy { to, from });
        let (to, from) = (self.seen, asm.constant_int(1));
        asm.emit(Inst::Copy { to, from });
    }

    /// Sets the value of the aggregate, or fails if it has none; `around` is the element of a
    /// collection around one.
    pub(super) fn end(
        self,
        asm: &mut Assembler,
        place: u32,
        function: FoldFunction,
        around: Option<(ElementKind, Reg)>,
    ) {
        let text = match function {
            FoldFunction::Mean => "the mean of nothing",
            FoldFunction::Min | FoldFunction::ArgMin => "the least of nothing",
            FoldFunction::Max | FoldFunction::ArgMax => "the greatest of nothing",
            _ => return,
        };
        let some = asm.label();
        asm.emit(Inst::JumpIf { condition: self.seen, to: some });
        let text = asm.text(text);
        asm.trap_at(place, Inst::Fail { text, around });
        asm.bind(some);
        if function == FoldFunction::Mean {
            let (to, left, right) = (self.to, self.to, self.seen);
            let from = right;
            asm.emit(Inst::IntToReal { to: right, from });
            asm.emit(match self.ty {
                Type::Vec3 => Inst::DivVec { to, left, right },
                ty if ty.size() > 1 => wide(Lanes::Divide, ty, [to, left, right]),
                _ => Inst::DivReal { to, left, right },
            });
        }
    }
}

/// The aggregate of the neighbors of a vertex for one of its halfedges that uses nothing of them but
/// their targets, `mean(h.target.position for h in v.halfedges)`: neighbors may be listed.
pub(super) fn over_neighbors(fold: &Fold) -> Option<Fold> {
    let Collection::Around(Around::VertexHalfedges, vertex) = &fold.collection else { return None };
    let keeps_element = matches!(fold.function, FoldFunction::ArgMin | FoldFunction::ArgMax);
    let is_it =
        |expr: &Expr| matches!(expr.kind, ExprKind::Local(variable) if variable == fold.variable);
    let is_target =
        |kind: &ExprKind| matches!(kind, ExprKind::Follow(Pointer::Target, of) if is_it(of));
    let (mut mentions, mut targets) = (0, 0);
    for part in fold.filter.iter().chain([&fold.body]) {
        part.each(&mut |expr| {
            mentions += usize::from(is_it(expr));
            targets += usize::from(is_target(&expr.kind));
        });
    }
    if keeps_element || targets == 0 || targets < mentions {
        return None;
    }
    let mut found = fold.clone();
    found.collection = Collection::Around(Around::VertexNeighbors, vertex.clone());
    for part in found.filter.iter_mut().chain([&mut found.body]) {
        part.visit_mut(&mut |kind| {
            if is_target(kind) {
                *kind = ExprKind::Local(fold.variable);
            }
        });
    }
    Some(found)
}
