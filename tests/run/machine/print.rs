//! Values as they are printed.

use hedgerow::mesh::{Element, ElementKind};
use hedgerow::rewrite::{RealDigits, RealText, WideText};

#[test]
fn a_few_digits_are_enough_for_a_reader() {
    let cases = [
        (2.0, "2"),
        (0.1 + 0.2, "0.3"),
        (-1.0 / 3.0, "-0.333333"),
        (-0.0, "0"),
        (2.0 / 3.0 * 1e-9, "6.66667e-10"),
        (12345.678, "12345.7"),
        (123456.78, "123457"),
        (1234567.8, "1234568"),
        (99999.96, "100000"),
        (1e15 + 0.5, "1000000000000000"),
        (1.23456789e20, "1.23457e20"),
        (f64::INFINITY, "inf"),
        (f64::NAN, "NaN"),
    ];
    for (value, text) in cases {
        assert_eq!(RealText(value, RealDigits::Few).to_string(), text);
    }
    let behind = |value, count| RealText(value, RealDigits::Behind(count)).to_string();
    assert_eq!(behind(2.0 / 3.0, 3), "0.667");
    assert_eq!(behind(2.0, 2), "2.00");
    assert_eq!(behind(0.5, 0), "0");
}

#[test]
fn reals_are_short_and_read_back() {
    let cases = [
        (2.0, "2"),
        (0.0, "0"),
        (-0.0, "-0.0"),
        (-0.1, "-0.1"),
        (1.0 / 3.0, "0.3333333333333333"),
        (1e15, "1000000000000000"),
        (1e300, "1e300"),
        (-1.5e-7, "-1.5e-7"),
        (f64::INFINITY, "inf"),
        (f64::NAN, "NaN"),
    ];
    for (value, text) in cases {
        assert_eq!(RealText(value, RealDigits::All).to_string(), text);
    }
    let vector = WideText(vec![vec![0.0, 0.5, 1.0]], RealDigits::Few);
    assert_eq!(vector.to_string(), "(0, 0.5, 1)");
    let none = Element { kind: ElementKind::Edge, index: u32::MAX };
    assert_eq!(none.to_string(), "no edge");
}
