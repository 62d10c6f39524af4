//! The value of an expression in a register.

use super::builtin::{Made, call};
use super::collection::each;
use super::fold::{Sum, known_count, over_neighbors, settle};
use super::operator::{binary, unary};
use super::pointer::{first, load};
use super::{Scope, copy, width};
use crate::diagram::{Access, Binary, Expr, ExprKind, Fold, FoldFunction, Pointer, Type};
use crate::rewrite::{Assembler, ElementField, HalfedgeField, Inst, Iterations, Label, Reg, Task};

/// Appends the code of an expression. The value is in the returned register and, if it is wider, in
/// those after it, until they are released. The register may be that of a variable and must not be
/// written to.
pub fn lower(asm: &mut Assembler, scope: &mut dyn Scope, expr: &Expr) -> Reg {
    match &expr.kind {
        ExprKind::Bool(value) => asm.constant_bool(*value),
        ExprKind::Int(value) => asm.constant_int(*value),
        ExprKind::Real(value) => asm.constant_real(*value),
        ExprKind::Text(value) => asm.constant_text(value),
        // Compiled rules have been unrolled, so members have names of their own.
        ExprKind::Element(name) | ExprKind::Member(name, _) => scope.element(*name),
        ExprKind::Local(variable) => scope.local(*variable),
        ExprKind::Component(part, vector) => {
            let most = width(vector.ty).saturating_sub(width(expr.ty));
            lower(asm, scope, vector).part(u16::from(*part).min(most))
        }
        _ => {
            let to = asm.block(width(expr.ty));
            lower_into(asm, scope, expr, to);
            to
        }
    }
}

/// Appends the code of an expression and puts its value into a register that nothing in the
/// expression reads.
pub fn lower_into(asm: &mut Assembler, scope: &mut dyn Scope, expr: &Expr, to: Reg) {
    let mark = asm.mark();
    match &expr.kind {
        ExprKind::Bool(_)
        | ExprKind::Int(_)
        | ExprKind::Real(_)
        | ExprKind::Text(_)
        | ExprKind::Element(_)
        | ExprKind::Member(..)
        | ExprKind::Local(_)
        | ExprKind::Component(..) => {
            let from = lower(asm, scope, expr);
            copy(asm, expr.ty, to, from);
        }
        ExprKind::Follow(pointer, base) => {
            let element = lower(asm, scope, base);
            follow(asm, scope.place(expr.span), *pointer, element, to);
        }
        ExprKind::Read(access, base) => {
            let element = lower(asm, scope, base);
            let place = scope.place(expr.span);
            let inst = match *access {
                Access::Position => Inst::LoadPosition { to, vertex: element },
                Access::Declared(number) => {
                    Inst::LoadAttribute { attribute: narrow(number), to, element }
                }
            };
            asm.trap_at(place, inst);
        }
        ExprKind::Vector(parts) => {
            let mut at = 0;
            for value in parts {
                lower_into(asm, scope, value, to.part(at));
                at += width(value.ty);
            }
        }
        ExprKind::Unary(operator, operand) => {
            let from = lower(asm, scope, operand);
            unary(asm, scope.place(expr.span), (*operator, expr.ty), to, from);
        }
        ExprKind::Binary(operator @ (Binary::And | Binary::Or), left, right) => {
            let (end, condition) = (asm.label(), to);
            lower_into(asm, scope, left, to);
            asm.emit(match operator {
                Binary::And => Inst::JumpUnless { condition, to: end },
                _ => Inst::JumpIf { condition, to: end },
            });
            lower_into(asm, scope, right, to);
            asm.bind(end);
        }
        ExprKind::Binary(operator, left, right) => {
            let ty = left.ty;
            let (left, right) = (lower(asm, scope, left), lower(asm, scope, right));
            asm.trap_at(scope.place(expr.span), binary(*operator, ty, [to, left, right]));
        }
        ExprKind::Call(builtin, args) => {
            let of = args.first().map_or(expr.ty, |first| first.ty);
            let args: Vec<Reg> = args.iter().map(|arg| lower(asm, scope, arg)).collect();
            let place = scope.place(expr.span);
            call(asm, place, *builtin, &args, Made { of, result: expr.ty, to });
        }
        ExprKind::If(condition, then, otherwise) => {
            let (second, end) = (asm.label(), asm.label());
            let condition = lower(asm, scope, condition);
            asm.emit(Inst::JumpUnless { condition, to: second });
            lower_into(asm, scope, then, to);
            asm.emit(Inst::Jump { to: end });
            asm.bind(second);
            lower_into(asm, scope, otherwise, to);
            asm.bind(end);
        }
        ExprKind::Fold(it) => fold(asm, scope, it, expr, to),
        ExprKind::Invoke(function, args) => {
            let place = scope.place(expr.span);
            let args = arguments(asm, scope, args);
            // Registers without a name may hold ids.
            asm.trap_at(place, Inst::Call { function: narrow(*function), args, to, holds: true });
        }
        ExprKind::Try(op, args) => {
            let place = scope.place(expr.span);
            let args = arguments(asm, scope, args);
            let op = narrow(*op);
            asm.trap_at(place, Inst::Try { op, args, to, why: expr.ty == Type::Text });
        }
        ExprKind::Let(variable, value, body) => {
            let from = lower(asm, scope, value);
            let kept = asm.block(width(value.ty));
            copy(asm, value.ty, kept, from);
            scope.declare(*variable, kept);
            lower_into(asm, scope, body, to);
        }
    }
    asm.release(mark);
}

/// Appends a loop that puts the aggregate into `to`.
fn fold(asm: &mut Assembler, scope: &mut dyn Scope, fold: &Fold, of: &Expr, to: Reg) {
    let over_neighbors = over_neighbors(fold);
    let fold = over_neighbors.as_ref().unwrap_or(fold);
    if let Some(inst) = known_count(fold, to) {
        return asm.emit(inst);
    }
    let done = asm.label();
    let (seen, best) = (asm.reg(), asm.reg());
    let sum = Sum { ty: of.ty, to, seen, best };
    sum.start(asm, fold.function);
    let mark = asm.mark();
    let iterations = spread(asm, scope, fold);
    let iteration = &mut |asm: &mut Assembler, scope: &mut dyn Scope, element: Reg, next: Label| {
        let mark = asm.mark();
        scope.declare(fold.variable, element);
        if let Some(filter) = &fold.filter {
            skip_unless(asm, scope, filter, next);
        }
        match fold.function {
            FoldFunction::Count => {
                skip_unless(asm, scope, &fold.body, next);
                sum.add_one(asm, to);
            }
            FoldFunction::Any => {
                skip_unless(asm, scope, &fold.body, next);
                settle(asm, to, true, done);
            }
            FoldFunction::All => {
                let condition = lower(asm, scope, &fold.body);
                asm.emit(Inst::JumpIf { condition, to: next });
                settle(asm, to, false, done);
            }
            function => {
                let value = lower(asm, scope, &fold.body);
                let value = sum.value(asm, fold.body.ty, value);
                let place = scope.place(fold.body.span);
                sum.take(asm, (function, place), fold.body.ty, [value, element], next);
            }
        }
        asm.release(mark);
    };
    let base = fold.collection.base().map(|base| lower(asm, scope, base));
    each(asm, scope, (&fold.collection, base), of.span, iteration);
    if let Some(iterations) = iterations {
        let place = scope.place(of.span);
        asm.trap_at(place, Inst::Jump { to: done });
        fold_of_threads(asm, scope, fold, (sum, iterations, place));
    }
    asm.bind(done);
    let place = scope.place(of.span);
    let kind = fold.collection.base().and_then(|base| base.ty.element_kind());
    sum.end(asm, place, fold.function, kind.zip(base));
    asm.release(mark);
}

/// Lets several threads compute the values of an aggregate if it is over all elements of a kind,
/// needs all of the values, and these take little memory.
fn spread(asm: &mut Assembler, scope: &dyn Scope, fold: &Fold) -> Option<Iterations> {
    let fits = !fold.function.ends_early() && width(fold.body.ty) <= 4 && scope.is_of_statements();
    let of = fold.collection.all().filter(|_| fits)?;
    let element = asm.reg();
    asm.spread_values(of, element, Task::Aggregate)
}

/// Appends the iteration of threads, and the code that combines the values they keep.
fn fold_of_threads(
    asm: &mut Assembler,
    scope: &mut dyn Scope,
    fold: &Fold,
    (sum, iterations, place): (Sum, Iterations, u32),
) {
    let Iterations { element, index, held: buffer, again, .. } = iterations;
    let keeps_element = matches!(fold.function, FoldFunction::ArgMin | FoldFunction::ArgMax);
    asm.begin_values(iterations);
    scope.declare(fold.variable, element);
    if let Some(filter) = &fold.filter {
        skip_unless(asm, scope, filter, again);
    }
    if fold.function == FoldFunction::Count {
        skip_unless(asm, scope, &fold.body, again);
        asm.emit(Inst::Keep { from: element });
        asm.end_values(iterations);
        asm.emit(Inst::BufferLength { buffer, to: sum.to });
        return asm.emit(Inst::BufferFree { buffer });
    }
    let from = lower(asm, scope, &fold.body);
    let from = sum.value(asm, fold.body.ty, from);
    // Not the register of a variable, since it is set below.
    let value = asm.block(width(fold.body.ty));
    copy(asm, fold.body.ty, value, from);
    let parts = (0..width(fold.body.ty)).map(|part| value.part(part));
    let kept: Vec<Reg> = parts.chain(keeps_element.then_some(element)).collect();
    for &from in &kept {
        asm.emit(Inst::Keep { from });
    }
    asm.end_values(iterations);
    let (from, head, over) = (asm.constant_int(0), asm.label(), asm.label());
    asm.emit(Inst::Copy { to: index, from });
    asm.bind(head);
    for to in kept {
        asm.emit(Inst::BufferNext { buffer, index, to, otherwise: over });
    }
    asm.trap_at(place, Inst::Tick);
    let place = scope.place(fold.body.span);
    sum.take(asm, (fold.function, place), fold.body.ty, [value, element], head);
    asm.emit(Inst::Jump { to: head });
    asm.bind(over);
    asm.emit(Inst::BufferFree { buffer });
}

fn skip_unless(asm: &mut Assembler, scope: &mut dyn Scope, condition: &Expr, next: Label) {
    if condition.kind != ExprKind::Bool(true) {
        let condition = lower(asm, scope, condition);
        asm.emit(Inst::JumpUnless { condition, to: next });
    }
}

/// Appends the code of arguments; their values are in consecutive registers from the returned one
/// on.
pub fn arguments(asm: &mut Assembler, scope: &mut dyn Scope, args: &[Expr]) -> Reg {
    let widths = args.iter().map(|arg| width(arg.ty));
    let all = widths.clone().fold(0, u16::saturating_add);
    let slots = asm.block(all);
    let mut offset = 0;
    for (arg, width) in args.iter().zip(widths) {
        // A block that is too wide cannot be allocated; the code is discarded then.
        lower_into(asm, scope, arg, Reg(slots.0.saturating_add(offset)));
        offset = offset.saturating_add(width);
    }
    slots
}

/// The number by which code names a function, an attribute or an operation. One that is too large
/// becomes that of none, and traps or is rejected.
pub fn narrow(number: impl TryInto<u16>) -> u16 {
    number.try_into().unwrap_or(u16::MAX)
}

/// `element.pointer`
fn follow(asm: &mut Assembler, place: u32, pointer: Pointer, element: Reg, to: Reg) {
    let both = [to, element];
    match (pointer, element_field(pointer)) {
        (Pointer::Target, _) => {
            load(asm, place, HalfedgeField::Twin, both);
            load(asm, place, HalfedgeField::Vertex, [to, to]);
        }
        (_, Some(of)) => first(asm, place, of, both),
        (pointer, None) => load(asm, place, halfedge_field(pointer), both),
    }
}

/// The element whose halfedge a pointer reads; `None` for pointers of halfedges.
pub fn element_field(pointer: Pointer) -> Option<ElementField> {
    match pointer {
        Pointer::VertexHalfedge => Some(ElementField::Vertex),
        Pointer::EdgeHalfedge => Some(ElementField::Edge),
        Pointer::FaceHalfedge => Some(ElementField::Face),
        _ => None,
    }
}

/// The field of a halfedge that a pointer reads; the vertex for pointers that read no such field.
pub fn halfedge_field(pointer: Pointer) -> HalfedgeField {
    match pointer {
        Pointer::Next => HalfedgeField::Next,
        Pointer::Prev => HalfedgeField::Prev,
        Pointer::Twin => HalfedgeField::Twin,
        Pointer::Edge => HalfedgeField::Edge,
        Pointer::Face => HalfedgeField::Face,
        _ => HalfedgeField::Vertex,
    }
}
