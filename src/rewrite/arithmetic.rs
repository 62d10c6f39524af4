//! Computations of single instructions for which the number types have no suitable method.

use glam::DVec3;

use super::{Fault, Math, Message};
pub use crate::mesh::direction;

/// The int, or the fault if it has overflowed.
#[inline]
pub(super) fn fits(value: Option<i64>) -> Result<i64, Fault> {
    value.ok_or(Fault::IntOverflow)
}

/// The quotient, rounded towards minus infinity.
#[inline]
pub fn divide(left: i64, right: i64) -> Result<i64, Fault> {
    if right == 0 {
        return Err(Fault::DivisionByZero);
    }
    let quotient = fits(left.checked_div(right))?;
    let inexact = quotient * right != left;
    Ok(quotient - i64::from(inexact && (left < 0) != (right < 0)))
}

/// The remainder, with the sign of the divisor.
#[inline]
pub fn modulo(left: i64, right: i64) -> Result<i64, Fault> {
    if right == 0 {
        return Err(Fault::DivisionByZero);
    }
    let rest = left.wrapping_rem(right);
    Ok(if rest != 0 && (rest < 0) != (right < 0) { rest + right } else { rest })
}

/// The nearest int, half to even.
#[inline]
pub fn round(value: f64) -> Result<i64, Fault> {
    const END: f64 = 9_223_372_036_854_775_808.0; // 2^63
    let rounded = value.round_ties_even();
    match (-END..END).contains(&rounded) {
        true => Ok(rounded as i64),
        false if rounded.is_nan() => Err(Fault::RoundsNaN),
        false => Err(Fault::IntOverflow),
    }
}

/// The largest int up to which reals tell all ints apart.
pub(super) const LARGEST_KEY: i64 = 1 << 53;

/// The real by which an int is ordered.
#[inline]
pub(super) fn key(int: i64) -> Result<f64, Message> {
    match (-LARGEST_KEY..=LARGEST_KEY).contains(&int) {
        true => Ok(int as f64),
        false => Err(Message::KeyTooLarge),
    }
}

/// A function of one real.
#[inline]
pub(super) fn math(math: Math, x: f64) -> f64 {
    match math {
        Math::Sqrt => x.sqrt(),
        Math::Sin => x.sin(),
        Math::Cos => x.cos(),
        Math::Tan => x.tan(),
        Math::Asin => x.asin(),
        Math::Acos => x.acos(),
        Math::Exp => x.exp(),
        Math::Log => x.ln(),
        Math::Floor => x.floor(),
        Math::Ceil => x.ceil(),
        Math::Abs => x.abs(),
        Math::Negate => -x,
    }
}

/// Linear interpolation, exact at both ends.
#[inline]
pub(super) fn mix(left: DVec3, right: DVec3, t: f64) -> DVec3 {
    left * (1.0 - t) + right * t
}

/// The vector times the power of two for which its largest component is at least 1 and below 2.
/// Products of such vectors neither vanish nor become infinite.
pub(super) fn balance(v: DVec3) -> DVec3 {
    let largest = |v: DVec3| v.abs().max_element();
    // The exponent is in the bits of numbers that are not subnormal.
    let v = if largest(v) < f64::MIN_POSITIVE { v / f64::EPSILON } else { v };
    let power = f64::from_bits(largest(v).to_bits() & f64::INFINITY.to_bits());
    if power > 0.0 && power.is_finite() { v / power } else { v }
}
