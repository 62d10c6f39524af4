//! Vectors and matrices of any width.
//!
//! Vectors of three components have instructions of their own; this file serves all others.
//! Matrices are square and stored column by column.

use glam::{DMat3, DMat4, DVec3, DVec4};

use super::Reg;
use super::window::Window;

/// Computations component by component, or over all components of one or two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lanes {
    Add,
    Subtract,
    Multiply,
    /// Multiplies by the real on the right.
    Scale,
    Divide,
    /// A bool: whether all components are equal.
    Equal,
    /// A real: the sum of the products.
    Dot,
    /// The left value divided by its length; zero if that is zero, NaN if it is not finite.
    Normalize,
    /// A bool: whether any component of the left value is not a number.
    IsNan,
    /// A bool: whether all components of the left value are finite.
    IsFinite,
}

/// Computations of matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Matrix {
    /// The real on the left on the diagonal, zero elsewhere.
    Diagonal,
    /// The left matrix, which has one more row and column, without the last ones.
    UpperLeft,
    /// The left vector as a column times the right one as a row.
    Outer,
    Transpose,
    Multiply,
    /// The product of the matrix on the left and the vector on the right.
    Transform,
    Determinant,
    /// The inverse; NaN everywhere if the matrix is singular, as for [`Matrix::Solve`].
    Inverse,
    /// The vector that the matrix on the left maps to the vector on the right; NaN everywhere if
    /// the matrix is singular.
    Solve,
}

fn real(w: &Window, from: Reg, part: usize) -> f64 {
    w.real(Reg(from.0.wrapping_add(part as u16)))
}

fn set_real(w: &mut Window, to: Reg, part: usize, value: f64) {
    w.set_real(Reg(to.0.wrapping_add(part as u16)), value);
}

/// Copies `width` slots; they may overlap.
#[inline]
pub(super) fn copy(w: &mut Window, to: Reg, from: Reg, width: u8) {
    let move_one = |w: &mut Window, part: u16| {
        let bits = w.bits(Reg(from.0.wrapping_add(part)));
        w.set_bits(Reg(to.0.wrapping_add(part)), bits);
    };
    match to.0 <= from.0 {
        true => (0..u16::from(width)).for_each(|part| move_one(w, part)),
        false => (0..u16::from(width)).rev().for_each(|part| move_one(w, part)),
    }
}

/// The columns of a vector or matrix.
pub(super) fn columns(w: &Window, from: Reg, size: u8, columns: u8) -> Vec<Vec<f64>> {
    let size = usize::from(size);
    let column = |at: usize| (0..size).map(|part| real(w, from, at * size + part)).collect();
    (0..usize::from(columns)).map(column).collect()
}

#[inline]
pub(super) fn lanes(w: &mut Window, operation: Lanes, width: u8, [to, left, right]: [Reg; 3]) {
    let width = usize::from(width);
    let mut each = |f: &dyn Fn(f64, f64) -> f64, step: usize| {
        for part in 0..width {
            let value = f(real(w, left, part), real(w, right, part * step));
            set_real(w, to, part, value);
        }
    };
    match operation {
        Lanes::Add => each(&|x, y| x + y, 1),
        Lanes::Subtract => each(&|x, y| x - y, 1),
        Lanes::Multiply => each(&|x, y| x * y, 1),
        Lanes::Scale => each(&|x, y| x * y, 0),
        Lanes::Divide => each(&|x, y| x / y, 0),
        Lanes::Equal => {
            let equal = (0..width).all(|part| real(w, left, part) == real(w, right, part));
            w.set_truth(to, equal);
        }
        Lanes::Dot => {
            let products = (0..width).map(|part| real(w, left, part) * real(w, right, part));
            w.set_real(to, products.sum());
        }
        Lanes::Normalize => normalize(w, to, left, width),
        Lanes::IsNan => {
            let any = (0..width).any(|part| real(w, left, part).is_nan());
            w.set_truth(to, any);
        }
        Lanes::IsFinite => {
            let all = (0..width).all(|part| real(w, left, part).is_finite());
            w.set_truth(to, all);
        }
    }
}

/// Divides a value by its length. It is scaled first: the square of a small length is zero, that of
/// a large one infinite.
fn normalize(w: &mut Window, to: Reg, from: Reg, width: usize) {
    let parts = (0..width).map(|part| real(w, from, part));
    let is_finite = parts.clone().all(f64::is_finite);
    let largest = parts.clone().fold(0.0, |most: f64, part| most.max(part.abs()));
    let length = parts.map(|part| part / largest).map(|part| part * part).sum::<f64>().sqrt();
    for part in 0..width {
        let value = match is_finite {
            true if largest > 0.0 => real(w, from, part) / largest / length,
            true => 0.0,
            false => f64::NAN,
        };
        set_real(w, to, part, value);
    }
}

/// Defines the function that computes with matrices and vectors of one size.
macro_rules! matrices {
    ($name:ident, $matrix:ident, $vector:ident, $size:literal) => {
        fn $name(w: &mut Window, operation: Matrix, [to, left, right]: [Reg; 3]) {
            let vector = |w: &Window, from| $vector::from_array(reals::<$size>(w, from));
            let matrix =
                |w: &Window, from| $matrix::from_cols_array(&reals::<{ $size * $size }>(w, from));
            let made = match operation {
                Matrix::Diagonal => $matrix::from_diagonal($vector::splat(w.real(left))),
                Matrix::UpperLeft => {
                    let column = |at: usize| reals(w, left.part(at as u16 * ($size + 1)));
                    $matrix::from_cols_array_2d(&std::array::from_fn(column))
                }
                Matrix::Outer => {
                    let (column, row) = (vector(w, left), vector(w, right).to_array());
                    $matrix::from_cols_array_2d(&row.map(|factor| (column * factor).to_array()))
                }
                Matrix::Transpose => matrix(w, left).transpose(),
                Matrix::Multiply => matrix(w, left) * matrix(w, right),
                Matrix::Inverse => {
                    let unit = $matrix::IDENTITY.to_cols_array_2d();
                    let inverse = eliminate(matrix(w, left).to_cols_array_2d(), unit);
                    $matrix::from_cols_array_2d(&inverse)
                }
                Matrix::Determinant => return w.set_real(to, matrix(w, left).determinant()),
                Matrix::Transform => {
                    let image = matrix(w, left) * vector(w, right);
                    return w.set_reals(to, &image.to_array());
                }
                Matrix::Solve => {
                    let wanted = [reals::<$size>(w, right)];
                    let [solution] = eliminate(matrix(w, left).to_cols_array_2d(), wanted);
                    return w.set_reals(to, &solution);
                }
            };
            w.set_reals(to, &made.to_cols_array());
        }
    };
}

matrices!(matrix3, DMat3, DVec3, 3);
matrices!(matrix4, DMat4, DVec4, 4);

#[inline]
pub(super) fn matrix(w: &mut Window, operation: Matrix, size: u8, registers: [Reg; 3]) {
    if size == 3 { matrix3(w, operation, registers) } else { matrix4(w, operation, registers) }
}

fn reals<const N: usize>(w: &Window, from: Reg) -> [f64; N] {
    std::array::from_fn(|part| real(w, from, part))
}

/// Solves for several right sides at once by Gaussian elimination with partial pivoting (Golub and
/// Van Loan, Matrix Computations, 1996, section 3.4), which loses less precision than an inverse by
/// cofactors. A matrix is singular if a pivot is lost in rounding: no larger than the number of
/// rows times the machine epsilon times the largest entry.
pub fn eliminate<const N: usize, const M: usize>(
    mut a: [[f64; N]; N],
    mut b: [[f64; N]; M],
) -> [[f64; N]; M] {
    let largest = a.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let least = N as f64 * f64::EPSILON * largest;
    for k in 0..N {
        let mut pivot = k;
        for row in k + 1..N {
            // Of equal candidates the last one is chosen; a NaN is chosen too, and fails the test
            // below.
            if a[k][row].abs() >= a[k][pivot].abs() || a[k][row].is_nan() {
                pivot = row;
            }
        }
        if !(a[k][pivot].abs() > least && a[k][pivot].is_finite()) {
            return [[f64::NAN; N]; M];
        }
        a.iter_mut().for_each(|column| column.swap(k, pivot));
        b.iter_mut().for_each(|side| side.swap(k, pivot));
        for row in k + 1..N {
            let factor = a[k][row] / a[k][k];
            a.iter_mut().for_each(|column| column[row] -= factor * column[k]);
            b.iter_mut().for_each(|side| side[row] -= factor * side[k]);
        }
    }
    for side in &mut b {
        for row in (0..N).rev() {
            let known: f64 = (row + 1..N).map(|k| a[k][row] * side[k]).sum();
            side[row] = (side[row] - known) / a[row][row];
        }
    }
    b
}
