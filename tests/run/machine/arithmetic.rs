//! Numbers, vectors and matrices.

use glam::{DMat3, DMat4, DVec3};
use hedgerow::rewrite::Fault;
use hedgerow::rewrite::arithmetic::{direction, divide, modulo, round};
use hedgerow::rewrite::vectors::eliminate;

#[test]
fn division_rounds_down_and_the_rest_follows_the_divisor() {
    for (a, b, quotient, rest) in [(7, 2, 3, 1), (-7, 2, -4, 1), (7, -2, -4, -1), (-7, -2, 3, -1)] {
        assert_eq!(divide(a, b), Ok(quotient));
        assert_eq!(modulo(a, b), Ok(rest));
    }
    assert_eq!(divide(i64::MIN, -1), Err(Fault::IntOverflow));
    assert_eq!(modulo(i64::MIN, -1), Ok(0));
    assert_eq!(divide(1, 0), Err(Fault::DivisionByZero));
    assert_eq!(modulo(1, 0), Err(Fault::DivisionByZero));
}

#[test]
fn rounding_is_half_to_even() {
    assert_eq!([0.5, 1.5, -2.5].map(round), [Ok(0), Ok(2), Ok(-2)]);
    assert_eq!(round(f64::NAN), Err(Fault::RoundsNaN));
    for wild in [9.3e18, f64::INFINITY] {
        assert_eq!(round(wild), Err(Fault::IntOverflow));
    }
    assert_eq!(round(-9_223_372_036_854_775_808.0), Ok(i64::MIN));
}

#[test]
fn tiny_vectors_have_a_direction() {
    assert_eq!(direction(DVec3::X * 1e-200), DVec3::X);
    assert_eq!(direction(DVec3::ZERO), DVec3::ZERO);
}

#[test]
fn elimination_inverts_what_glam_multiplies() {
    let a = DMat4::from_cols_array(&[
        2.0, -1.0, 0.5, 3.0, 1.0, 4.0, -2.0, 0.25, 0.0, 1.5, 5.0, -1.0, 3.0, 0.0, 1.0, 7.0,
    ]);
    let unit = DMat4::IDENTITY.to_cols_array_2d();
    let inverse = DMat4::from_cols_array_2d(&eliminate(a.to_cols_array_2d(), unit));
    assert!((inverse * a).abs_diff_eq(DMat4::IDENTITY, 1e-12));
    // A zero on the diagonal asks for another pivot.
    let b = DMat3::from_cols_array(&[0.0, 1.0, 0.0, 2.0, 0.0, 1.0, 1.0, 1.0, 1.0]);
    let x = DVec3::new(1.0, -2.0, 3.0);
    let [solved] = eliminate(b.to_cols_array_2d(), [x.to_array()]);
    assert!((b * DVec3::from_array(solved)).abs_diff_eq(x, 1e-12));
}

#[test]
fn a_singular_matrix_has_no_inverse_at_any_scale() {
    for scale in [1e-200, 1.0, 1e200] {
        let row = [1.0, 2.0, 3.0].map(|x| x * scale);
        let singular = [row, row.map(|x| x * 1.1), [0.0, 0.0, scale]];
        assert!(eliminate(singular, [row])[0][0].is_nan());
        let regular = [row, [0.0, scale, 0.0], [0.0, 0.0, scale]];
        assert!(eliminate(regular, [row])[0][0].is_finite());
    }
    assert!(eliminate([[0.0; 4]; 4], [[0.0; 4]])[0][0].is_nan());
    assert!(eliminate([[f64::INFINITY; 3]; 3], [[0.0; 3]])[0][0].is_nan());
}
