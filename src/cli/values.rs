//! Values as one writes them: `--set t=0.5`, `--set to=1,2,3`.

use std::collections::BTreeMap;

use super::failure::Failure;
use crate::diagram::{Binary, Expr, ExprKind, Param, Type, Unary};

/// Reads all `NAME=VALUE` that parameters of value types are given; the slots, by name.
pub(super) fn read_all(
    params: &[Param],
    texts: &[String],
) -> Result<BTreeMap<String, Vec<u64>>, Failure> {
    let mut values = BTreeMap::new();
    for text in texts {
        let (name, value) = text
            .split_once('=')
            .ok_or_else(|| Failure::usage(format!("`{text}` is no setting: write NAME=VALUE")))?;
        let known = params
            .iter()
            .find(|param| param.name == name && !param.ty.is_element());
        let param = known.ok_or_else(|| {
            let names: Vec<_> = params
                .iter()
                .filter(|param| !param.ty.is_element())
                .map(|param| format!("`{}`", param.name))
                .collect();
            let has = if names.is_empty() {
                "it has none".to_string()
            } else {
                format!("it has {}", names.join(", "))
            };
            Failure::usage(format!("there is no parameter `{name}` to set; {has}"))
        })?;
        let slots = read(param.ty, value).ok_or_else(|| {
            Failure::usage(format!(
                "`{value}` is no {}, which `{name}` is",
                param.ty.word()
            ))
        })?;
        if values.insert(name.to_string(), slots).is_some() {
            return Err(Failure::usage(format!("`{name}` is set twice")));
        }
    }
    Ok(values)
}

fn read(ty: Type, text: &str) -> Option<Vec<u64>> {
    let real = |text: &str| {
        text.trim()
            .parse::<f64>()
            .ok()
            .filter(|value| value.is_finite())
            .map(f64::to_bits)
    };
    match ty {
        Type::Bool => text
            .parse::<bool>()
            .ok()
            .map(|value| vec![u64::from(value)]),
        Type::Int => text.parse::<i64>().ok().map(|value| vec![value as u64]),
        Type::Real => real(text).map(|bits| vec![bits]),
        Type::Vec3 => {
            let parts = text.split(',').map(real).collect::<Option<Vec<_>>>()?;
            (parts.len() == 3).then_some(parts)
        }
        _ => None,
    }
}

/// The slots of a default.
pub(super) fn default(param: &Param) -> Option<Vec<u64>> {
    let expr = param.default.as_ref()?;
    Some(match param.ty {
        Type::Bool => vec![u64::from(matches!(expr.kind, ExprKind::Bool(true)))],
        Type::Int => vec![int(expr)? as u64],
        Type::Real => vec![real(expr)?.to_bits()],
        Type::Vec3 => match &expr.kind {
            ExprKind::Vector(parts) => parts
                .iter()
                .map(|part| real(part).map(f64::to_bits))
                .collect::<Option<_>>()?,
            _ => return None,
        },
        _ => return None,
    })
}

fn int(expr: &Expr) -> Option<i64> {
    match &expr.kind {
        ExprKind::Int(value) => Some(*value),
        ExprKind::Unary(Unary::NegateInt, inner) => int(inner)?.checked_neg(),
        _ => None,
    }
}

fn real(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Real(value) => Some(*value),
        ExprKind::Unary(Unary::ToReal, inner) => int(inner).map(|value| value as f64),
        ExprKind::Unary(Unary::NegateReal, inner) => Some(-real(inner)?),
        ExprKind::Binary(Binary::DivideReal, left, right) => Some(real(left)? / real(right)?),
        _ => None,
    }
}
