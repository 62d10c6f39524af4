//! Products, determinants and elimination as straight-line code.
//!
//! All results equal those of glam and of [`vectors`](crate::rewrite::vectors), bit for bit.

use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::types::{F64, I8, I64};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value};

use super::translate::Translator;
use crate::rewrite::Reg;
use crate::rewrite::vectors::Matrix;

impl Translator<'_, '_> {
    /// Computes with matrices as glam does, as straight-line code; `None` if that would be too
    /// long.
    pub(super) fn matrix(
        &mut self,
        operation: Matrix,
        size: u16,
        left: Reg,
        right: Reg,
    ) -> Option<Vec<Value>> {
        // The machine treats every other size as 4.
        if size != 3 && size != 4 {
            return None;
        }
        let all = size * size;
        let parts = usize::from(size);
        Some(match operation {
            Matrix::Diagonal => {
                let (value, zero) = (self.real(left), self.b.ins().f64const(0.0));
                (0..all).map(|at| if at % (size + 1) == 0 { value } else { zero }).collect()
            }
            Matrix::UpperLeft => {
                let from = self.reals(left, (size + 1) * (size + 1));
                (0..parts * parts).map(|at| from[at / parts * (parts + 1) + at % parts]).collect()
            }
            Matrix::Outer => {
                let (column, row) = (self.reals(left, size), self.reals(right, size));
                let each = row.iter().flat_map(|&factor| column.iter().map(move |&x| [x, factor]));
                each.map(|[x, factor]| self.b.ins().fmul(x, factor)).collect()
            }
            Matrix::Transpose => {
                let from = self.reals(left, all);
                (0..parts * parts).map(|at| from[at % parts * parts + at / parts]).collect()
            }
            Matrix::Multiply | Matrix::Transform => {
                let columns = if operation == Matrix::Multiply { size } else { 1 };
                let (matrix, vectors) = (self.reals(left, all), self.reals(right, size * columns));
                let mut values = Vec::new();
                for vector in vectors.chunks(parts) {
                    for row in 0..parts {
                        let mut sum = self.b.ins().fmul(matrix[row], vector[0]);
                        for (column, &factor) in vector.iter().enumerate().skip(1) {
                            let product = self.b.ins().fmul(matrix[column * parts + row], factor);
                            sum = self.b.ins().fadd(sum, product);
                        }
                        values.push(sum);
                    }
                }
                values
            }
            Matrix::Determinant if size == 3 => {
                let part = |at: u16| [0, 1, 2].map(|part| Reg(left.0.wrapping_add(at + part)));
                let [x, y, z] = [0, 3, 6].map(|at| part(at).map(|reg| self.real(reg)));
                let cross = self.cross(y, z);
                vec![self.dot(x, cross)]
            }
            Matrix::Solve => {
                let (matrix, wanted) = (self.reals(left, all), self.reals(right, size));
                self.eliminate(matrix, vec![wanted], parts)
            }
            Matrix::Inverse => {
                let matrix = self.reals(left, all);
                let [zero, one] = [0.0, 1.0].map(|value| self.b.ins().f64const(value));
                let mut unit = vec![vec![zero; parts]; parts];
                unit.iter_mut().enumerate().for_each(|(at, column)| column[at] = one);
                self.eliminate(matrix, unit, parts)
            }
            Matrix::Determinant => return None,
        })
    }

    /// Solves for several right sides as [`eliminate`](crate::rewrite::vectors::eliminate) does, as
    /// straight-line code without branches.
    fn eliminate(
        &mut self,
        matrix: Vec<Value>,
        mut sides: Vec<Vec<Value>>,
        size: usize,
    ) -> Vec<Value> {
        let mut largest = self.b.ins().f64const(0.0);
        for &entry in &matrix {
            let entry = self.b.ins().fabs(entry);
            let is_larger = self.b.ins().fcmp(FloatCC::GreaterThan, entry, largest);
            largest = self.choose(is_larger, entry, largest);
        }
        let rounding = self.b.ins().f64const(size as f64 * f64::EPSILON);
        let least = self.b.ins().fmul(rounding, largest);
        let infinity = self.b.ins().f64const(f64::INFINITY);
        let mut columns: Vec<Vec<Value>> = matrix.chunks(size).map(<[_]>::to_vec).collect();
        let mut is_regular = self.b.ins().iconst(I8, 1);
        for k in 0..size {
            // By row, whether it is a better pivot than all rows before.
            let (mut pivot, mut is_better) = (columns[k][k], Vec::new());
            for &entry in &columns[k][k + 1..] {
                let [entry_size, size] = [entry, pivot].map(|entry| self.b.ins().fabs(entry));
                let is_larger = self.b.ins().fcmp(FloatCC::GreaterThanOrEqual, entry_size, size);
                let is_nan = self.b.ins().fcmp(FloatCC::Unordered, entry, entry);
                let better = self.b.ins().bor(is_larger, is_nan);
                pivot = self.choose(better, entry, pivot);
                is_better.push(better);
            }
            let pivot_size = self.b.ins().fabs(pivot);
            for (how, bound) in [(FloatCC::GreaterThan, least), (FloatCC::LessThan, infinity)] {
                let fits = self.b.ins().fcmp(how, pivot_size, bound);
                is_regular = self.b.ins().band(is_regular, fits);
            }
            for column in columns[k..].iter_mut().chain(&mut sides) {
                self.swap(column, k, &is_better);
            }
            for row in k + 1..size {
                let factor = self.b.ins().fdiv(columns[k][row], columns[k][k]);
                for column in columns[k + 1..].iter_mut().chain(&mut sides) {
                    let change = self.b.ins().fmul(factor, column[k]);
                    column[row] = self.b.ins().fsub(column[row], change);
                }
            }
        }
        let singular = self.b.ins().f64const(f64::NAN);
        for side in &mut sides {
            for row in (0..size).rev() {
                let products = (row + 1..size).map(|k| (columns[k][row], side[k]));
                let known = self.sum_of_products(products);
                let rest = self.b.ins().fsub(side[row], known);
                side[row] = self.b.ins().fdiv(rest, columns[row][row]);
            }
        }
        sides.into_iter().flatten().map(|value| self.choose(is_regular, value, singular)).collect()
    }

    /// Swaps an entry with the last of those below it that are better, if there is one.
    fn swap(&mut self, column: &mut [Value], at: usize, is_better: &[Value]) {
        let (before, mut is_chosen) = (column[at], self.b.ins().iconst(I8, 0));
        for (row, &better) in is_better.iter().enumerate().rev() {
            let is_last = self.b.ins().band_not(better, is_chosen);
            is_chosen = self.b.ins().bor(is_chosen, better);
            let entry = column[at + 1 + row];
            column[at] = self.choose(is_last, entry, column[at]);
            column[at + 1 + row] = self.choose(is_last, before, entry);
        }
    }

    /// One of two numbers, without a branch.
    fn choose(&mut self, condition: Value, then: Value, otherwise: Value) -> Value {
        let flags = MemFlagsData::new();
        let [then, otherwise] =
            [then, otherwise].map(|value| self.b.ins().bitcast(I64, flags, value));
        let bits = self.b.ins().select(condition, then, otherwise);
        self.b.ins().bitcast(F64, flags, bits)
    }

    /// The sum of products as [`Iterator::sum`] computes it: starting from the sum of an empty
    /// iterator.
    pub(super) fn sum_of_products(
        &mut self,
        products: impl Iterator<Item = (Value, Value)>,
    ) -> Value {
        let nothing: f64 = [0.0; 0].iter().sum();
        let mut sum = self.b.ins().f64const(nothing);
        for (left, right) in products {
            let product = self.b.ins().fmul(left, right);
            sum = self.b.ins().fadd(sum, product);
        }
        sum
    }

    pub(super) fn cross(&mut self, [x, y, z]: [Value; 3], [u, v, w]: [Value; 3]) -> [Value; 3] {
        [(y, w, v, z), (z, u, w, x), (x, v, u, y)].map(|(a, b, c, d)| {
            let (first, second) = (self.b.ins().fmul(a, b), self.b.ins().fmul(c, d));
            self.b.ins().fsub(first, second)
        })
    }

    pub(super) fn dot(&mut self, left: [Value; 3], right: [Value; 3]) -> Value {
        let [x, y, z] = [0, 1, 2].map(|part| self.b.ins().fmul(left[part], right[part]));
        let xy = self.b.ins().fadd(x, y);
        self.b.ins().fadd(xy, z)
    }
}
