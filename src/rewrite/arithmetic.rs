//! What single instructions compute, where a method of the number would not do.

use glam::DVec3;

use super::{Math, Message};

/// An int, or the trap if it does not fit.
#[inline]
pub(super) fn fits(value: Option<i64>) -> Result<i64, Message> {
    value.ok_or(Message::IntOverflow)
}

/// Rounds towards minus infinity.
#[inline]
pub(super) fn divide(left: i64, right: i64) -> Result<i64, Message> {
    if right == 0 {
        return Err(Message::DivisionByZero);
    }
    let quotient = fits(left.checked_div(right))?;
    let inexact = quotient * right != left;
    Ok(quotient - i64::from(inexact && (left < 0) != (right < 0)))
}

/// Has the sign of the divisor.
#[inline]
pub(super) fn modulo(left: i64, right: i64) -> Result<i64, Message> {
    if right == 0 {
        return Err(Message::DivisionByZero);
    }
    let rest = left.wrapping_rem(right);
    Ok(match rest != 0 && (rest < 0) != (right < 0) {
        true => rest + right,
        false => rest,
    })
}

/// The nearest int, half to even.
#[inline]
pub(super) fn round(value: f64) -> Result<i64, Message> {
    const END: f64 = 9_223_372_036_854_775_808.0; // 2^63
    let rounded = value.round_ties_even();
    match (-END..END).contains(&rounded) {
        true => Ok(rounded as i64),
        false if rounded.is_nan() => Err(Message::RoundsNaN),
        false => Err(Message::IntOverflow),
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

/// Exact at both ends.
#[inline]
pub(super) fn mix(left: DVec3, right: DVec3, t: f64) -> DVec3 {
    left * (1.0 - t) + right * t
}

/// The direction, or zero if there is none. Scaled first: the square of a small length
/// is zero, that of a large one infinite.
#[inline]
pub(super) fn direction(v: DVec3) -> DVec3 {
    let largest = v.abs().max_element();
    match largest > 0.0 && largest.is_finite() {
        true => (v / largest).normalize_or_zero(),
        false => DVec3::ZERO,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn division_rounds_down_and_the_rest_follows_the_divisor() {
        for (a, b, quotient, rest) in
            [(7, 2, 3, 1), (-7, 2, -4, 1), (7, -2, -4, -1), (-7, -2, 3, -1)]
        {
            assert_eq!(divide(a, b), Ok(quotient));
            assert_eq!(modulo(a, b), Ok(rest));
        }
        assert_eq!(divide(i64::MIN, -1), Err(Message::IntOverflow));
        assert_eq!(modulo(i64::MIN, -1), Ok(0));
        assert_eq!(divide(1, 0), Err(Message::DivisionByZero));
        assert_eq!(modulo(1, 0), Err(Message::DivisionByZero));
    }

    #[test]
    fn rounding_is_half_to_even() {
        assert_eq!([0.5, 1.5, -2.5].map(round), [Ok(0), Ok(2), Ok(-2)]);
        assert_eq!(round(f64::NAN), Err(Message::RoundsNaN));
        for wild in [9.3e18, f64::INFINITY] {
            assert_eq!(round(wild), Err(Message::IntOverflow));
        }
        assert_eq!(round(-9_223_372_036_854_775_808.0), Ok(i64::MIN));
    }

    #[test]
    fn tiny_vectors_have_a_direction() {
        assert_eq!(direction(DVec3::X * 1e-200), DVec3::X);
        assert_eq!(direction(DVec3::ZERO), DVec3::ZERO);
    }
}
