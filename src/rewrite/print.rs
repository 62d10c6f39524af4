//! Values as text.

use std::fmt::{self, Display, Write};

use glam::DVec3;

use crate::mesh::ElementKind;

/// A real in the shortest form that reads back as the same number: `0.1`, `2`, `1e30`.
#[derive(Clone, Copy, Debug)]
pub struct RealText(pub f64);

impl Display for RealText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        // Written out, such numbers would be mostly zeros.
        match size != 0.0 && size.is_finite() && !(1e-5..1e16).contains(&size) {
            true => write!(f, "{:e}", self.0),
            false => self.0.fmt(f),
        }
    }
}

/// A vector: `(0, 0.5, 1)`.
#[derive(Clone, Copy, Debug)]
pub struct VectorText(pub DVec3);

impl Display for VectorText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0.to_array().map(RealText);
        write!(f, "({x}, {y}, {z})")
    }
}

/// A vector or matrix by its columns: `(0, 1)`, `((1, 0), (0, 1))`.
#[derive(Clone, Debug)]
pub struct WideText(pub Vec<Vec<f64>>);

impl Display for WideText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let column = |parts: &Vec<f64>| {
            let parts: Vec<_> = parts.iter().map(|x| RealText(*x).to_string()).collect();
            format!("({})", parts.join(", "))
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

/// An element: `vertex 12`, or `no vertex`.
#[derive(Clone, Copy, Debug)]
pub struct ElementText(pub ElementKind, pub u32);

impl Display for ElementText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            ElementText(kind, u32::MAX) => write!(f, "no {kind}"),
            ElementText(kind, id) => write!(f, "{kind} {id}"),
        }
    }
}

/// Appends a value to a line.
pub(super) fn append(line: &mut String, value: impl Display) {
    // Writing to a `String` does not fail.
    let _ = write!(line, "{value}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_are_short_and_read_back() {
        let cases = [
            (2.0, "2"),
            (-0.1, "-0.1"),
            (1.0 / 3.0, "0.3333333333333333"),
            (1e15, "1000000000000000"),
            (1e300, "1e300"),
            (-1.5e-7, "-1.5e-7"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ];
        for (value, text) in cases {
            assert_eq!(RealText(value).to_string(), text);
        }
        assert_eq!(
            VectorText(DVec3::new(0.0, 0.5, 1.0)).to_string(),
            "(0, 0.5, 1)"
        );
        assert_eq!(
            ElementText(ElementKind::Edge, u32::MAX).to_string(),
            "no edge"
        );
    }
}
