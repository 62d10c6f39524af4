//! Expressions of a program as text.

use super::language::is_wide;
use super::term::Term;
use crate::diagram::{Access, Builtin, Expr, ExprKind, Rule, Type, Unary};
use crate::emit::NotEmitted;
use crate::emit::names::Names;
use crate::emit::routine::Statement;
use crate::lower::{Hoisted, hoist};

impl Names<'_> {
    pub fn value(&mut self, expr: &Expr) -> Result<Term, NotEmitted> {
        let language = self.language;
        let not_emitted = |what| NotEmitted::new(what, expr.span);
        Ok(match &expr.kind {
            ExprKind::Bool(value) => Term::bool(*value),
            ExprKind::Int(value) => language.int(*value),
            ExprKind::Real(value) => language.real(*value),
            ExprKind::Element(name) => self.term(*name),
            ExprKind::Local(number) => Term::name(self.local(*number)),
            ExprKind::Follow(pointer, base) => language.follow(*pointer, &self.value(base)?),
            ExprKind::Read(Access::Position, base) => {
                language.call("Position", &[self.value(base)?])
            }
            ExprKind::Read(Access::Declared(number), base) => {
                let missing = || not_emitted("an attribute in a function");
                let attribute = self.attribute(*number).ok_or_else(missing)?;
                language.attribute(&attribute, &self.value(base)?)
            }
            ExprKind::Component(part, whole) => self.component(*part, whole, expr.ty)?,
            ExprKind::Vector(parts) => self.made(expr.ty, parts)?,
            ExprKind::Unary(operator, operand) => self.unary(*operator, operand)?,
            ExprKind::Binary(operator, left, right) => {
                let sides = [self.value(left)?, self.value(right)?];
                language.binary(*operator, left.ty, sides)
            }
            ExprKind::If(condition, then, otherwise) => {
                let condition = self.value(condition)?;
                language.choice(&condition, [self.value(then)?, self.value(otherwise)?])
            }
            ExprKind::Fold(fold) => self.aggregate(fold, expr)?,
            ExprKind::Call(builtin, _) if builtin.is_random() => {
                return Err(not_emitted("a random number"));
            }
            ExprKind::Call(builtin, args) => {
                let values = self.values(args)?;
                match type_of_call(*builtin, args, expr.ty) {
                    Some(ty) => language.call_of(&format!("of.{builtin:?}"), (ty, 0), &values),
                    None => language.call(&format!("{builtin:?}"), &values),
                }
            }
            ExprKind::Invoke(number, args) => {
                let what = "a function that does more than compute a value";
                let name = self.call(*number).ok_or_else(|| not_emitted(what))?;
                language.invoke(&name, &self.values(args)?)
            }
            ExprKind::Text(_) => return Err(not_emitted("a text")),
            ExprKind::Try(..) => return Err(not_emitted("`can` or `why`")),
            ExprKind::Let(..) => return Err(not_emitted("a block within a value")),
            ExprKind::Member(..) => return Err(not_emitted("a name with an index")),
        })
    }

    fn values(&mut self, parts: &[Expr]) -> Result<Vec<Term>, NotEmitted> {
        parts.iter().map(|part| self.value(part)).collect()
    }

    fn unary(&mut self, operator: Unary, operand: &Expr) -> Result<Term, NotEmitted> {
        let (language, value) = (self.language, self.value(operand)?);
        Ok(match (operator, &operand.kind) {
            (Unary::Not, _) => value.not(),
            // Exact: an integer literal that is used as a real.
            (Unary::ToReal, ExprKind::Int(value)) => language.real(*value as f64),
            (Unary::ToReal, ExprKind::Unary(Unary::NegateInt, inner))
                if let ExprKind::Int(value) = inner.kind =>
            {
                language.real(-(value as f64))
            }
            (Unary::ToReal, _) => language.to_real(&value),
            (Unary::NegateVector, _) if is_wide(operand.ty) => {
                language.call_of("of.Negate", (operand.ty, 0), &[value])
            }
            _ => language.negative(&value),
        })
    }

    /// A part of a vector or matrix.
    fn component(&mut self, part: u8, whole: &Expr, result: Type) -> Result<Term, NotEmitted> {
        let (ty, value) = (whole.ty, self.value(whole)?);
        let (name, part) = match result {
            Type::Real => ("of.Part".to_string(), part),
            _ if ty.is_matrix() => ("of.Column".into(), part / ty.size()),
            _ => (format!("of.First{}", result.size()), 0),
        };
        Ok(self.language.call_of(&name, (ty, part), &[value]))
    }

    /// A vector by its parts, or a matrix by its columns.
    fn made(&mut self, ty: Type, parts: &[Expr]) -> Result<Term, NotEmitted> {
        let (language, values) = (self.language, self.values(parts)?);
        if let [first, last] = parts
            && first.ty.is_vector()
            && last.ty == Type::Real
        {
            return Ok(language.call_of("of.Extend", (ty, 0), &values));
        }
        let mut terms = Vec::new();
        for (part, value) in parts.iter().zip(values) {
            if ty.is_matrix() || part.ty == Type::Real {
                terms.push(value);
                continue;
            }
            // A computed term is repeated for each of its parts.
            let component = |at| language.call_of("of.Part", (part.ty, at), [&value]);
            terms.extend((0..part.ty.size()).map(component));
        }
        Ok(language.call_of("of.Make", (ty, 0), &terms))
    }

    /// The condition that all components of a position are finite.
    pub fn finite(&self, position: &Term) -> Term {
        self.language.call_of("of.IsFinite", (Type::Vec3, 0), [position])
    }

    /// The expression with names for the parts that have the same value each time; `body` computes
    /// these values.
    pub fn once(
        &mut self,
        expr: &Expr,
        repeated: bool,
        rule: Option<&Rule>,
        body: &mut Vec<Statement>,
    ) -> Result<Expr, NotEmitted> {
        let Hoisted { parts, rest } = hoist(expr, repeated, rule, false);
        for (number, part) in &parts {
            let value = self.value(part)?;
            let name = self.bind(*number, wanted(part));
            body.push(self.bound(part.ty, &name, &value, false));
        }
        Ok(rest)
    }
}

/// The type that determines the spelling of a builtin, if it is one of vectors and matrices that may
/// have no type.
fn type_of_call(builtin: Builtin, args: &[Expr], result: Type) -> Option<Type> {
    let first = args.first()?.ty;
    match builtin {
        Builtin::Diagonal | Builtin::UpperLeft => Some(result),
        Builtin::Outer | Builtin::CrossPlane | Builtin::Solve => Some(first),
        Builtin::IsNan | Builtin::IsFinite if first == Type::Vec3 => Some(first),
        _ => is_wide(first).then_some(first),
    }
}

/// True if a value does not read the mesh.
pub(in crate::emit) fn is_plain(expr: &Expr) -> bool {
    let mut is_plain = true;
    expr.each(&mut |part| {
        is_plain &= match &part.kind {
            ExprKind::Bool(_) | ExprKind::Int(_) | ExprKind::Real(_) | ExprKind::Local(_) => true,
            ExprKind::Unary(..) | ExprKind::Binary(..) => true,
            ExprKind::Component(..) | ExprKind::Vector(_) => true,
            ExprKind::Call(builtin, args) => type_of_call(*builtin, args, part.ty).is_some(),
            _ => false,
        };
    });
    is_plain
}

fn wanted(part: &Expr) -> &'static str {
    match part.kind {
        ExprKind::Call(Builtin::CentroidFace, _) => "centroid",
        ExprKind::Call(Builtin::NormalFace | Builtin::NormalVertex, _) => "normal",
        ExprKind::Call(Builtin::Area, _) => "area",
        ExprKind::Call(Builtin::DegreeVertex | Builtin::DegreeFace, _) => "degree",
        _ => "part",
    }
}

/// True if emitted code has a type for these values.
pub(in crate::emit) fn is_spelled(ty: Type) -> bool {
    ty != Type::Text
}
