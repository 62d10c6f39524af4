//! Columns: cells of consecutive lines, padded so that they are aligned.

use super::printer::{Lines, width_of};

/// The maximum number of characters by which the widest cell of a column may exceed the narrowest.
///
/// Beyond that a column is mostly empty, and less readable than lines that are not aligned.
const MOST_PADDING: usize = 8;

/// Lines of cells as lines of text. Consecutive lines are aligned as long as their cells have
/// similar widths; the last cell of a line is never padded.
pub(super) fn aligned(rows: &[Vec<String>]) -> Lines {
    let mut lines = Lines::with_capacity(rows.len());
    let mut rest = rows;
    while !rest.is_empty() {
        let (count, widths) = run(rest);
        let (run, behind) = rest.split_at(count);
        lines.extend(run.iter().map(|row| padded(row, &widths)));
        rest = behind;
    }
    lines
}

/// The number of leading rows that share columns, and the widths of the columns.
fn run(rows: &[Vec<String>]) -> (usize, Vec<usize>) {
    let mut narrowest: Vec<usize> = Vec::new();
    let mut widest: Vec<usize> = Vec::new();
    for (count, row) in rows.iter().enumerate() {
        let cells = row.split_last().map_or(&[][..], |(_, cells)| cells);
        let (mut low, mut high) = (narrowest.clone(), widest.clone());
        for (at, cell) in cells.iter().enumerate() {
            let width = width_of(cell);
            if at == low.len() {
                low.push(width);
                high.push(width);
            }
            low[at] = low[at].min(width);
            high[at] = high[at].max(width);
        }
        let spread = low.iter().zip(&high).any(|(low, high)| high - low > MOST_PADDING);
        if spread && count > 0 {
            return (count, widest);
        }
        (narrowest, widest) = (low, high);
    }
    (rows.len(), widest)
}

fn padded(row: &[String], widths: &[usize]) -> String {
    let mut line = String::new();
    for (at, cell) in row.iter().enumerate() {
        line.push_str(cell);
        if at + 1 < row.len() {
            let width = widths.get(at).copied().unwrap_or(0);
            let gap = width.saturating_sub(width_of(cell)) + 1;
            line.extend(std::iter::repeat_n(' ', gap));
        }
    }
    line.trim_end().to_owned()
}
