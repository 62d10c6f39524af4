//! The registers that an instruction reads and writes.

use super::may_write;
use crate::mesh::{AttributeType, ElementKind};
use crate::rewrite::vectors::{Lanes, Matrix};
use crate::rewrite::{Code, Function, Inst, Plan, Reg};

/// Whether an instruction adds an element or makes room for some.
fn adds(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::New { .. }
            | Inst::BufferNew { .. }
            | Inst::ExpectRoom { .. }
            | Inst::ExpectRoomFor { .. }
    )
}

/// The way in which an instruction uses registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Use {
    Read,
    /// It is written in any case.
    Write,
    /// It may be written.
    Change,
}

/// The class of values that a register holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// Bits that are copied.
    Any,
    Real,
    /// An int, a bool, an element or a text.
    Whole,
}

/// Consecutive registers that an instruction uses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Operand {
    pub(super) used: Use,
    pub(super) first: Reg,
    pub(super) width: u16,
    pub(super) class: Class,
}

impl Operand {
    pub(super) fn registers(self) -> impl Iterator<Item = Reg> {
        (0..self.width).map(move |part| Reg(self.first.0.wrapping_add(part)))
    }
}

/// The items that a code refers to by number and on which the widths of operands depend.
#[derive(Clone, Copy, Debug)]
pub(super) struct Environment<'a> {
    pub(super) plans: &'a [Option<Plan>],
    pub(super) functions: &'a [Function],
    /// The attributes of the program: the kind of the elements, and the type of the values.
    pub(super) types: &'a [Option<(ElementKind, AttributeType)>],
}

impl Environment<'_> {
    /// The type of an attribute on the mesh.
    pub(super) fn type_of(&self, attribute: u16) -> Option<AttributeType> {
        self.column(attribute).map(|(_, ty)| ty)
    }

    /// Whether a function does nothing but compute.
    pub(super) fn only_reads(&self, function: u16) -> bool {
        let does_more = |inst: &Inst| may_write(inst) || matches!(inst, Inst::Try { .. });
        let called = self.functions.get(usize::from(function));
        called.is_some_and(|called| !called.code.insts.iter().any(does_more))
    }

    /// Whether a code, or anything that it calls or asks, may add elements or make room for some,
    /// so that tables move.
    pub(super) fn may_add(&self, code: &Code) -> bool {
        let may_add = |inst: &Inst| match *inst {
            // An operation that is only asked makes room too, and executes steps, which are undone.
            Inst::Apply { op, .. } | Inst::Try { op, .. } => self.op_may_add(op),
            _ => adds(inst),
        };
        code.with_called_of(self.functions).iter().any(|code| code.insts.iter().any(may_add))
    }

    fn op_may_add(&self, op: u16) -> bool {
        let may_add =
            |inst: &Inst| adds(inst) || matches!(inst, Inst::Apply { .. } | Inst::Try { .. });
        let any_adds = |code: &&Code| code.insts.iter().any(may_add);
        let plan = self.plans.get(usize::from(op)).and_then(Option::as_ref);
        plan.is_none_or(|plan| plan.steps.is_some() || plan.code.with_called().iter().any(any_adds))
    }

    /// The kind of the elements that have an attribute.
    pub(super) fn kind_of(&self, attribute: u16) -> Option<ElementKind> {
        self.column(attribute).map(|(kind, _)| kind)
    }

    pub(super) fn column(&self, attribute: u16) -> Option<(ElementKind, AttributeType)> {
        self.types.get(usize::from(attribute)).copied().flatten()
    }

    /// The number of slots of the parameters of an operation.
    pub(super) fn params_of_op(&self, op: u16) -> u16 {
        let plan = self.plans.get(usize::from(op)).and_then(Option::as_ref);
        plan.map_or(0, |plan| plan.params.iter().fold(0, |sum, &one| sum.saturating_add(one)))
    }

    /// The number of slots of an attribute, and their class.
    fn attribute(&self, attribute: u16) -> (u16, Class) {
        match self.type_of(attribute) {
            Some(AttributeType::Bool | AttributeType::Int) | None => (1, Class::Whole),
            Some(ty) => (ty.width() as u16, Class::Real),
        }
    }

    /// Calls `tell` with each operand of an instruction, in any order.
    pub(super) fn each_operand(&self, inst: &Inst, tell: &mut dyn FnMut(Operand)) {
        use Class::{Any, Real, Whole};
        let mut tell = |used: Use, class: Class, first: Reg, width: u16| {
            tell(Operand { used, first, width, class });
        };
        macro_rules! operands {
            ($($used:ident $class:ident $reg:expr, $width:expr;)*) => {{
                $(tell(Use::$used, $class, $reg, $width);)*
            }};
        }
        match *inst {
            Inst::Const { to, .. } => operands! { Write Any to, 1; },
            Inst::Copy { to, from } => operands! { Read Any from, 1; Write Any to, 1; },
            Inst::CopyVec { to, from } => operands! { Read Real from, 3; Write Real to, 3; },
            Inst::CopyWide { to, from, width } => {
                operands! { Read Any from, u16::from(width); Write Any to, u16::from(width); }
            }
            Inst::Select { to, condition, then, otherwise } => operands! {
                Read Whole condition, 1; Read Any then, 1; Read Any otherwise, 1; Write Any to, 1;
            },
            Inst::Not { to, from } | Inst::NegInt { to, from } | Inst::AbsInt { to, from } => {
                operands! { Read Whole from, 1; Write Whole to, 1; }
            }
            Inst::And { to, left, right }
            | Inst::Or { to, left, right }
            | Inst::Equal { to, left, right }
            | Inst::AddInt { to, left, right }
            | Inst::SubInt { to, left, right }
            | Inst::MulInt { to, left, right }
            | Inst::DivInt { to, left, right }
            | Inst::ModInt { to, left, right }
            | Inst::MinInt { to, left, right }
            | Inst::MaxInt { to, left, right }
            | Inst::LessInt { to, left, right }
            | Inst::LessEqualInt { to, left, right } => operands! {
                Read Whole left, 1; Read Whole right, 1; Write Whole to, 1;
            },
            Inst::IntToReal { to, from } | Inst::IntToKey { to, from } => {
                operands! { Read Whole from, 1; Write Real to, 1; }
            }
            Inst::RoundReal { to, from } => operands! { Read Real from, 1; Write Whole to, 1; },
            Inst::AddReal { to, left, right }
            | Inst::SubReal { to, left, right }
            | Inst::MulReal { to, left, right }
            | Inst::DivReal { to, left, right }
            | Inst::MinReal { to, left, right }
            | Inst::MaxReal { to, left, right }
            | Inst::PowReal { to, left, right }
            | Inst::Atan2Real { to, left, right } => operands! {
                Read Real left, 1; Read Real right, 1; Write Real to, 1;
            },
            Inst::LessReal { to, left, right }
            | Inst::LessEqualReal { to, left, right }
            | Inst::EqualReal { to, left, right } => operands! {
                Read Real left, 1; Read Real right, 1; Write Whole to, 1;
            },
            Inst::MathReal { to, from, .. } => operands! { Read Real from, 1; Write Real to, 1; },
            Inst::AddVec { to, left, right }
            | Inst::SubVec { to, left, right }
            | Inst::MulVec { to, left, right }
            | Inst::Cross { to, left, right } => operands! {
                Read Real left, 3; Read Real right, 3; Write Real to, 3;
            },
            Inst::NegVec { to, from }
            | Inst::Normalize { to, from }
            | Inst::Balance { to, from } => operands! {
                Read Real from, 3; Write Real to, 3;
            },
            Inst::ScaleVec { to, left, right } | Inst::DivVec { to, left, right } => operands! {
                Read Real left, 3; Read Real right, 1; Write Real to, 3;
            },
            Inst::MixVec { to, left, right, t } => operands! {
                Read Real left, 3; Read Real right, 3; Read Real t, 1; Write Real to, 3;
            },
            Inst::EqualVec { to, left, right } => operands! {
                Read Real left, 3; Read Real right, 3; Write Whole to, 1;
            },
            Inst::Dot { to, left, right } => operands! {
                Read Real left, 3; Read Real right, 3; Write Real to, 1;
            },
            Inst::LengthVec { to, from } => operands! { Read Real from, 3; Write Real to, 1; },
            Inst::Wide { operation, width, to, left, right } => {
                let width = u16::from(width);
                match operation {
                    Lanes::Add | Lanes::Subtract | Lanes::Multiply => operands! {
                        Read Real left, width; Read Real right, width; Write Real to, width;
                    },
                    Lanes::Scale | Lanes::Divide => operands! {
                        Read Real left, width; Read Real right, 1; Write Real to, width;
                    },
                    Lanes::Equal => operands! {
                        Read Real left, width; Read Real right, width; Write Whole to, 1;
                    },
                    Lanes::Dot => operands! {
                        Read Real left, width; Read Real right, width; Write Real to, 1;
                    },
                    Lanes::Normalize => operands! {
                        Read Real left, width; Write Real to, width;
                    },
                    Lanes::IsNan | Lanes::IsFinite => operands! {
                        Read Real left, width; Write Whole to, 1;
                    },
                }
            }
            Inst::Matrix { operation, size, to, left, right } => {
                let size = u16::from(size);
                let all = size * size;
                match operation {
                    Matrix::Diagonal => operands! { Read Real left, 1; Write Real to, all; },
                    Matrix::UpperLeft => operands! {
                        Read Real left, (size + 1) * (size + 1); Write Real to, all;
                    },
                    Matrix::Outer => operands! {
                        Read Real left, size; Read Real right, size; Write Real to, all;
                    },
                    Matrix::Transpose | Matrix::Inverse => operands! {
                        Read Real left, all; Write Real to, all;
                    },
                    Matrix::Multiply => operands! {
                        Read Real left, all; Read Real right, all; Write Real to, all;
                    },
                    Matrix::Transform | Matrix::Solve => operands! {
                        Read Real left, all; Read Real right, size; Write Real to, size;
                    },
                    Matrix::Determinant => operands! { Read Real left, all; Write Real to, 1; },
                }
            }
            Inst::Random { to } => operands! { Write Real to, 1; },
            Inst::RandomInt { to, below } => operands! { Read Whole below, 1; Write Whole to, 1; },
            Inst::Load { to, halfedge: from, .. }
            | Inst::LoadHalfedge { to, element: from, .. }
            | Inst::LoadHole { to, face: from }
            | Inst::Alive { to, element: from, .. } => operands! {
                Read Whole from, 1; Write Whole to, 1;
            },
            Inst::LoadPosition { to, vertex } => operands! {
                Read Whole vertex, 1; Write Real to, 3;
            },
            Inst::LoadAttribute { attribute, to, element } => {
                let (width, class) = self.attribute(attribute);
                operands! { Read Whole element, 1; }
                tell(Use::Write, class, to, width);
            }
            Inst::Capacity { to, .. } | Inst::Count { to, .. } | Inst::CountHoles { to } => {
                operands! { Write Whole to, 1; }
            }
            Inst::NextLiving { element, .. } => operands! { Change Whole element, 1; },
            Inst::Ask { question, to, elements: [first, second] } => {
                operands! { Read Whole first, 1; Read Whole second, 1; }
                match question.reals() {
                    0 => operands! { Write Whole to, 1; },
                    reals => operands! { Write Real to, reals; },
                }
            }
            Inst::JumpIf { condition, .. }
            | Inst::JumpUnless { condition, .. }
            | Inst::Expect { condition, .. } => operands! { Read Whole condition, 1; },
            Inst::JumpUnequal { left, right, .. }
            | Inst::JumpEqual { left, right, .. }
            | Inst::ExpectEqual { left, right, .. }
            | Inst::ExpectDistinct { left, right, .. } => operands! {
                Read Whole left, 1; Read Whole right, 1;
            },
            Inst::ExpectFinite { vector, .. } => operands! { Read Real vector, 3; },
            Inst::WalkBegin { from, at, turns, .. } | Inst::WalkNext { from, at, turns, .. } => {
                operands! {
                    Read Whole from, 1; Change Whole at, 1; Change Whole turns, 1;
                }
            }
            Inst::NeighborsBegin { vertex, slots, neighbor, .. } => operands! {
                Read Whole vertex, 1; Write Whole slots, 3; Write Whole neighbor, 1;
            },
            Inst::NeighborsNext { slots, neighbor, .. } => operands! {
                Change Whole slots, 3; Write Whole neighbor, 1;
            },
            Inst::Collect { from, until, .. } => operands! {
                Read Whole from, 1; Read Whole until, 1;
            },
            Inst::Meets { to, from, goal, stop, .. } => operands! {
                Read Whole from, 1; Read Whole goal, 1; Read Whole stop, 1; Write Whole to, 1;
            },
            Inst::PreviewNew { to }
            | Inst::New { to, .. }
            | Inst::MeetsAll { to, .. }
            | Inst::ForeseeAlong { to, .. }
            | Inst::BufferLength { to, .. }
            | Inst::RefusedFor { to, .. }
            | Inst::MeshSame { to, .. } => operands! { Write Whole to, 1; },
            Inst::PreviewStore { halfedge: element, value, .. }
            | Inst::PreviewStoreHalfedge { element, value, .. }
            | Inst::Store { halfedge: element, value, .. }
            | Inst::StoreHalfedge { element, value, .. } => operands! {
                Read Whole element, 1; Read Whole value, 1;
            },
            Inst::CollectEars { face: element, .. }
            | Inst::PreviewStoreHole { face: element, .. }
            | Inst::StoreHole { face: element, .. }
            | Inst::JumpUnlessLiving { element, .. }
            | Inst::Erase { element, .. } => operands! { Read Whole element, 1; },
            Inst::PreviewStoreAll { value, .. } | Inst::StoreAll { value, .. } => operands! {
                Read Whole value, 1;
            },
            Inst::PreviewStoreSpan { index, value, .. } | Inst::StoreSpan { index, value, .. } => {
                operands! { Read Whole index, 1; Read Whole value, 1; }
            }
            Inst::Foresee { to, element, at, .. } => operands! {
                Read Whole element, 1; Read Whole at, 1; Write Whole to, 1;
            },
            Inst::NextIndex { index, .. } => operands! { Change Whole index, 1; },
            Inst::Member { index, to, .. } | Inst::BufferGet { to, index, .. } => operands! {
                Read Whole index, 1; Write Any to, 1;
            },
            Inst::BufferGetWide { index, width, to, .. } => operands! {
                Read Whole index, 1; Write Any to, width;
            },
            Inst::ExpectRoomFor { count, .. } => operands! { Read Whole count, 1; },
            Inst::Return { result: Some(result) } => operands! { Read Whole result, 1; },
            Inst::BufferPush { from, .. } | Inst::Keep { from } => operands! { Read Any from, 1; },
            Inst::BufferNext { index, to, .. } => operands! {
                Change Whole index, 1; Change Any to, 1;
            },
            Inst::Prefetch { index, .. } => operands! { Read Whole index, 1; },
            Inst::StorePosition { vertex, value } | Inst::DeferPosition { vertex, value, .. } => {
                operands! { Read Whole vertex, 1; Read Real value, 3; }
            }
            Inst::StoreAttribute { attribute, element, value }
            | Inst::DeferAttribute { attribute, element, value, .. } => {
                let (width, class) = self.attribute(attribute);
                operands! { Read Whole element, 1; }
                tell(Use::Read, class, value, width);
            }
            Inst::DrainStale { to, .. } | Inst::DrainLeast { to, .. } => operands! {
                Change Whole to, 1;
            },
            Inst::DrainKey { key } => operands! { Read Real key, 1; },
            Inst::Call { function, args, to, .. } => {
                let called = self.functions.get(usize::from(function));
                operands! {
                    Read Any args, called.map_or(0, |function| function.params);
                    Change Any to, called.map_or(0, |function| given(&function.code));
                }
            }
            Inst::ReturnValue { from, width } => operands! { Read Any from, width; },
            Inst::Apply { op, args, applied, result } => operands! {
                Read Any args, self.params_of_op(op);
                Change Whole result, 1; Write Whole applied, 1;
            },
            Inst::Try { op, args, to, .. } => operands! {
                Read Any args, self.params_of_op(op); Write Whole to, 1;
            },
            Inst::Iteration { done, total, .. } => operands! {
                Read Whole done, 1; Read Whole total, 1;
            },
            Inst::PrintTextOf { from }
            | Inst::PrintBool { from }
            | Inst::PrintInt { from }
            | Inst::PrintElement { from, .. }
            | Inst::Fail { around: Some((_, from)), .. }
            | Inst::ExpectAlive { from, .. } => operands! { Read Whole from, 1; },
            Inst::PrintReal { from, .. } => operands! { Read Real from, 1; },
            Inst::PrintWide { from, size, columns, .. } => operands! {
                Read Real from, u16::from(size) * u16::from(columns);
            },
            Inst::BufferShuffle { .. }
            | Inst::Jump { .. }
            | Inst::ExpectRoom { .. }
            | Inst::PreviewClear
            | Inst::PreviewUndo
            | Inst::BufferNew { .. }
            | Inst::BufferAppend { .. }
            | Inst::BufferStride { .. }
            | Inst::ExpectAllDistinct { .. }
            | Inst::Refuse
            | Inst::Return { result: None }
            | Inst::BufferClear { .. }
            | Inst::BufferLiving { .. }
            | Inst::WriteDeferred { .. }
            | Inst::Recycle
            | Inst::DrainOpen { .. }
            | Inst::DrainAllStale
            | Inst::DrainTake
            | Inst::DrainClose
            | Inst::Refused { .. }
            | Inst::Tick
            | Inst::BufferFree { .. }
            | Inst::Spread { .. }
            | Inst::PrintText { .. }
            | Inst::PrintEnd
            | Inst::PrintReason { .. }
            | Inst::PrintDifference { .. }
            | Inst::MeshKeep { .. }
            | Inst::FailShowing { .. }
            | Inst::Fail { around: None, .. } => {}
        }
    }
}

/// The greatest number of slots that a code gives.
fn given(code: &Code) -> u16 {
    let widths = code.insts.iter().map(|inst| match inst {
        Inst::ReturnValue { width, .. } => *width,
        _ => 0,
    });
    widths.max().unwrap_or(0)
}
