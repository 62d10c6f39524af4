//! Hoisting of the parts of a value that are the same every time it is computed: at each index of a
//! family, or for each element of an aggregate. They are computed before the loop, and get names;
//! otherwise `centroid(f)` would walk around the face at each of its corners.

use crate::diagram::{Binary, Builtin, Expr, ExprKind, FoldFunction, Rule, Type};

/// A value with the parts that do not vary split off.
#[derive(Clone, Debug)]
pub struct Hoisted {
    /// The parts that are computed before, in order, with numbers that no variable has.
    pub parts: Vec<(u32, Expr)>,
    /// The value in terms of them.
    pub rest: Expr,
}

/// Splits a value; `repeated` if it is computed at each index. Calls of functions that may draw
/// random numbers are not hoisted: `random_calls` tells whether the functions of the program may.
pub fn hoist(expr: &Expr, repeated: bool, rule: Option<&Rule>, random_calls: bool) -> Hoisted {
    let mut finder = Finder { rule, random_calls, bound: Vec::new(), found: Vec::new() };
    finder.look(expr, repeated, true);
    let parts: Vec<_> = (0..u32::MAX).rev().zip(finder.found.into_iter().cloned()).collect();
    let mut rest = expr.clone();
    for (number, part) in &parts {
        rest.visit_mut(&mut |kind| {
            if *kind == part.kind {
                *kind = ExprKind::Local(*number);
            }
        });
    }
    Hoisted { parts, rest }
}

struct Finder<'e> {
    rule: Option<&'e Rule>,
    random_calls: bool,
    /// The variables of the enclosing aggregates.
    bound: Vec<u32>,
    found: Vec<&'e Expr>,
}

impl<'e> Finder<'e> {
    /// Finds the largest parts to hoist: those that are computed repeatedly, and that are either
    /// always computed or cannot fail.
    fn look(&mut self, expr: &'e Expr, repeated: bool, surely: bool) {
        let computes = |part: &Expr| {
            matches!(part.kind, ExprKind::Call(..) | ExprKind::Fold(_) | ExprKind::Invoke(..))
        };
        let is_same = repeated
            && some(expr, computes)
            && !some(expr, |part| self.varies(part))
            && (surely || !may_stop(expr));
        if is_same {
            self.found.push(expr);
            return;
        }
        match &expr.kind {
            ExprKind::Binary(operator, left, right) => {
                self.look(left, repeated, surely);
                let always = !matches!(operator, Binary::And | Binary::Or);
                self.look(right, repeated, surely && always);
            }
            ExprKind::If(condition, then, otherwise) => {
                self.look(condition, repeated, surely);
                self.look(then, repeated, false);
                self.look(otherwise, repeated, false);
            }
            ExprKind::Fold(fold) => {
                if let Some(base) = fold.collection.base() {
                    self.look(base, repeated, surely);
                }
                self.bound.push(fold.variable);
                for part in fold.filter.iter().chain([&fold.body]) {
                    self.look(part, true, false);
                }
                self.bound.pop();
            }
            // What a block binds is known only inside it.
            ExprKind::Let(..) | ExprKind::Try(..) => {}
            _ => expr.parts(&mut |part| self.look(part, repeated, surely)),
        }
    }

    /// True if a part by itself may differ each time.
    fn varies(&self, part: &Expr) -> bool {
        match &part.kind {
            ExprKind::Element(name) => self.rule.is_some_and(|rule| rule.is_member(*name)),
            ExprKind::Local(variable) => self.bound.contains(variable),
            ExprKind::Invoke(..) => self.random_calls,
            ExprKind::Member(..) | ExprKind::Let(..) | ExprKind::Try(..) | ExprKind::Text(_) => {
                true
            }
            ExprKind::Call(builtin, _) => builtin.is_random(),
            _ => false,
        }
    }
}

fn some(expr: &Expr, is_it: impl Fn(&Expr) -> bool) -> bool {
    let mut found = false;
    expr.each(&mut |part| found |= is_it(part));
    found
}

/// True if an expression may have no value, so that a run stops where it is computed.
pub fn may_stop(expr: &Expr) -> bool {
    some(expr, |part| match &part.kind {
        // Ints overflow.
        ExprKind::Binary(..) | ExprKind::Unary(..) => part.ty == Type::Int,
        ExprKind::Call(builtin, _) => {
            matches!(builtin, Builtin::AbsInt | Builtin::Round | Builtin::RandomInt)
        }
        ExprKind::Fold(fold) => match fold.function {
            FoldFunction::Any | FoldFunction::All | FoldFunction::Count => false,
            FoldFunction::Sum => part.ty == Type::Int,
            _ => true,
        },
        ExprKind::Invoke(..) => true,
        _ => false,
    })
}
