//! Vectors and matrices from their components: `vec3(x, y, z)`, `vec4(p, 1)`, `mat4(0)`.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Binary, Builtin, Expr, ExprKind, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Ident};

use super::builtin::CONSTRUCTORS;
use super::typed::{to_real, typed};
use super::typing::Typing;
use super::vocabulary::called;

/// The type that a constructor of this name makes.
pub(super) fn constructed(word: &str) -> Option<Type> {
    CONSTRUCTORS.into_iter().find(|ty| ty.word() == word)
}

/// The types of the arguments in each form of the constructor of a type.
pub(super) fn ways(ty: Type) -> &'static [&'static [&'static str]] {
    match ty {
        Type::Vec2 => &[&["real", "real"], &["real"], &["vec3"]],
        Type::Vec3 => &[&["real", "real", "real"], &["real"], &["vec2", "real"], &["vec4"]],
        Type::Vec4 => &[&["real", "real", "real", "real"], &["real"], &["vec3", "real"]],
        Type::Mat3 => &[&["vec3", "vec3", "vec3"], &["real"], &["mat4"]],
        _ => &[&["vec4", "vec4", "vec4", "vec4"], &["real"]],
    }
}

impl Typing<'_> {
    /// The call of a constructor.
    pub(super) fn construct(
        &mut self,
        ty: Type,
        function: &Ident,
        args: &[tree::Expr],
        span: Span,
    ) -> Option<Expr> {
        let values: Vec<Option<Expr>> = args.iter().map(|arg| self.expression(arg)).collect();
        let values: Vec<Expr> = values.into_iter().collect::<Option<_>>()?;
        let values: Vec<Expr> = values.into_iter().map(to_real).collect();
        let types: Vec<Type> = values.iter().map(|value| value.ty).collect();
        let kind = match (ty, types.as_slice()) {
            (Type::Mat3 | Type::Mat4, [Type::Real]) => ExprKind::Call(Builtin::Diagonal, values),
            (Type::Mat3, [Type::Mat4]) => ExprKind::Call(Builtin::UpperLeft, values),
            (Type::Mat3, [Type::Vec3, Type::Vec3, Type::Vec3])
            | (Type::Mat4, [Type::Vec4, Type::Vec4, Type::Vec4, Type::Vec4]) => {
                ExprKind::Vector(values)
            }
            (ty, [Type::Real]) if ty.is_vector() => all_alike(ty, values, span),
            // Truncation: the first components.
            (Type::Vec2, [Type::Vec3 | Type::Vec4]) | (Type::Vec3, [Type::Vec4]) => {
                let mut values = values;
                ExprKind::Component(0, Box::new(values.pop()?))
            }
            (ty, types) if ty.is_vector() && fills(ty, types) => ExprKind::Vector(values),
            _ => return self.no_such_value(ty, function, args, &types, span),
        };
        Some(typed(ty, kind, span))
    }

    /// Reports that a value cannot be constructed from these arguments, with the forms that exist.
    fn no_such_value(
        &mut self,
        ty: Type,
        function: &Ident,
        args: &[tree::Expr],
        types: &[Type],
        span: Span,
    ) -> Option<Expr> {
        let only_reals = types.iter().all(|ty| *ty == Type::Real);
        if ty.is_vector() && only_reals {
            self.right_count(function, usize::from(ty.size()), args.len(), span)?;
        }
        let given: Vec<&str> = types.iter().map(|ty| ty.a_word()).collect();
        let given = match given.as_slice() {
            [] => "nothing".to_owned(),
            given => given.join(" and "),
        };
        let message = format!("{} cannot be made of {given}", ty.a_word());
        let error = Diagnostic::error("type-mismatch", message, span)
            .note(format!("it is made by {}", called(ty.word())));
        self.report.reject(error)
    }
}

/// A vector with the same real in every component.
fn all_alike(ty: Type, mut real: Vec<Expr>, span: Span) -> ExprKind {
    let size = usize::from(ty.size());
    if let [Expr { kind: ExprKind::Real(_), .. }] = real[..] {
        return ExprKind::Vector(vec![real.remove(0); size]);
    }
    // A value that is not constant is computed once.
    let one = typed(Type::Real, ExprKind::Real(1.0), span);
    let ones = typed(ty, ExprKind::Vector(vec![one; size]), span);
    ExprKind::Binary(Binary::ScaleVector, Box::new(ones), Box::new(real.remove(0)))
}

/// True if `types` are at least two reals or vectors whose components together fill a vector of
/// type `ty`.
fn fills(ty: Type, types: &[Type]) -> bool {
    let part = |ty: &Type| *ty == Type::Real || ty.is_vector();
    let length: u32 = types.iter().map(|ty| u32::from(ty.size())).sum();
    types.iter().all(part) && types.len() > 1 && length == u32::from(ty.size())
}
