//! Operations as questions whose answers depend on a bounded set of paths.

use super::paths::Paths;
use super::reads::question_paths;
use super::{Code, Inst, Plan, Question, Reg, Unbounded};
use crate::mesh::{ElementKind, Value};

/// The greatest absolute value of a small int. Each sum adds at most one bit.
const SMALL: u64 = 1 << 40;

/// The greatest number of consecutive sums of small ints that surely do not overflow.
const MOST_SUMS: usize = 20;

/// Whether a value is a small int.
pub(super) fn is_small(value: Value) -> bool {
    matches!(value, Value::Int(value) if value.unsigned_abs() <= SMALL)
}

/// The question whether an operation would be applied, with the paths of its reads.
#[derive(Clone, Debug)]
pub struct Bounded {
    pub(super) paths: Paths,
    /// The code of the operation up to its first write.
    pub(super) code: Code,
    /// The attributes that it reads for anything else than to increase or decrease them.
    asked: Vec<u16>,
}

impl Bounded {
    /// The question, asked of the element of the given kind in a slot of the window.
    ///
    /// # Errors
    /// The reason, if the paths are not bounded.
    pub fn new(plan: &Plan, kind: ElementKind, slot: usize) -> Result<Self, Unbounded> {
        let paths = question_paths(plan, kind, slot)?;
        let asked = asked_attributes(&plan.code);
        let mut code = plan.code.clone();
        for inst in code.insts.iter_mut().filter(|inst| inst.writes()) {
            *inst = Inst::Return { result: None };
        }
        Ok(Self { paths, code, asked })
    }

    /// Whether an attribute is read only to be increased or decreased: then the answer does not
    /// depend on its value, unless the value is so large that the sum overflows.
    pub(super) fn only_counts(&self, attribute: u16) -> bool {
        !self.asked.contains(&attribute)
    }
}

/// The attributes that are loaded elsewhere than in a run of sums that ends at a write.
fn asked_attributes(code: &Code) -> Vec<u16> {
    let load = |inst: &Inst| match *inst {
        Inst::LoadAttribute { attribute, .. } => Some(attribute),
        _ => None,
    };
    let small = code.insts.iter().take(code.constants).filter_map(|inst| match *inst {
        Inst::Const { to, bits } => is_small(Value::Int(bits as i64)).then_some(to),
        _ => None,
    });
    let small: Vec<Reg> = small.collect();
    let mut asked = Vec::new();
    let mut since = 0;
    let mut sums = Sums { count: 0, small: small.clone() };
    for (at, inst) in code.insts.iter().enumerate() {
        if sums.take(inst) {
            continue;
        }
        if !inst.writes() {
            asked.extend(code.insts[since..=at].iter().filter_map(load));
        }
        since = at + 1;
        sums = Sums { count: 0, small: small.clone() };
    }
    asked.extend(code.insts[since..].iter().filter_map(load));
    let called = code.with_called();
    asked.extend(called[1..].iter().flat_map(|code| &code.insts).filter_map(load));
    asked
}

/// A run of sums of small ints.
struct Sums {
    count: usize,
    /// The registers that hold sums, or values that are small if the attributes are.
    small: Vec<Reg>,
}

impl Sums {
    /// Adds an instruction to the run; false if it can fail otherwise than by the overflow of a
    /// sum.
    fn take(&mut self, inst: &Inst) -> bool {
        let to = match *inst {
            Inst::LoadAttribute { to, .. }
            | Inst::Ask { question: Question::Degree | Question::FaceSize, to, .. } => to,
            Inst::Copy { to, from } if self.small.contains(&from) => to,
            Inst::AddInt { to, left, right } | Inst::SubInt { to, left, right }
                if self.count < MOST_SUMS
                    && self.small.contains(&left)
                    && self.small.contains(&right) =>
            {
                self.count += 1;
                to
            }
            // It reads no register.
            Inst::ExpectRoom { .. } => return true,
            _ => return false,
        };
        self.small.push(to);
        true
    }
}
