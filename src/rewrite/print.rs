//! Values as text.

use std::fmt::{self, Display, Write};

/// The number of digits of a real.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RealDigits {
    /// Six significant digits, but never fewer than there are before the point: `0.333333`,
    /// `1234568`.
    Few,
    /// The fewest digits that read back as the same number: `0.3333333333333333`.
    All,
    /// This number of digits after the point: `0.333`.
    Behind(u8),
}

/// A real: `0.1`, `2`, `1e30`.
#[derive(Clone, Copy, Debug)]
pub struct RealText(pub f64, pub RealDigits);

impl Display for RealText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(real, digits) = *self;
        match digits {
            RealDigits::Behind(count) => {
                let text = format!("{real:.0$}", usize::from(count));
                let is_zero = !text.contains(|c: char| matches!(c, '1'..='9') || c.is_alphabetic());
                f.write_str(text.strip_prefix('-').filter(|_| is_zero).unwrap_or(&text))
            }
            // `-0` would be read back as an int.
            RealDigits::All if real == 0.0 && real.is_sign_negative() => f.write_str("-0.0"),
            RealDigits::All => write_all(f, real),
            RealDigits::Few => write_all(f, rounded(real)),
        }
    }
}

fn write_all(f: &mut fmt::Formatter<'_>, real: f64) -> fmt::Result {
    // -0 is printed as 0.
    let real = if real == 0.0 { 0.0 } else { real };
    let size = real.abs();
    // Without an exponent such numbers would be mostly zeros.
    match size != 0.0 && size.is_finite() && !(1e-5..1e16).contains(&size) {
        true => write!(f, "{real:e}"),
        false => real.fmt(f),
    }
}

/// The nearest number with six significant digits, or the nearest whole number where that has more
/// digits.
fn rounded(real: f64) -> f64 {
    if !real.is_finite() || (1e5..1e16).contains(&real.abs()) {
        return real.round_ties_even();
    }
    // Decimal rounding needs the decimal text.
    let text = format!("{real:.5e}");
    text.parse().unwrap_or(real)
}

/// A vector or matrix by its columns: `(0, 1)`, `((1, 0), (0, 1))`.
#[derive(Clone, Debug)]
pub struct WideText(pub Vec<Vec<f64>>, pub RealDigits);

impl Display for WideText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let column = |parts: &Vec<f64>| {
            let parts = parts.iter().map(|x| RealText(*x, self.1).to_string());
            format!("({})", parts.collect::<Vec<_>>().join(", "))
        };
        match self.0.as_slice() {
            [one] => f.write_str(&column(one)),
            columns => {
                let columns: Vec<_> = columns.iter().map(column).collect();
                write!(f, "({})", columns.join(", "))
            }
        }
    }
}

/// Appends a value to a line.
pub(super) fn append(line: &mut String, value: impl Display) {
    // Writing to a `String` does not fail.
    let _ = write!(line, "{value}");
}
