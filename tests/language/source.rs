//! Places in texts: lines and columns.

use hedgerow::source::{LineTable, Sources, Span};

#[test]
fn columns_count_characters() {
    let mut sources = Sources::new();
    let file = sources.add("a", "x\né𝄞z");
    let source = sources.get(file);
    assert_eq!(source.line_column(2), (2, 1));
    assert_eq!(source.line_column(8), (2, 3));
    assert_eq!(source.line_column(3), (2, 1), "inside a character: its start");
    assert_eq!(sources.slice(Span::new(file, 4, 8)), "𝄞");
}

#[test]
fn every_byte_lies_in_the_line_that_starts_last_before_it() {
    let table = LineTable::new("ab\n\ncd");
    assert_eq!(table.line_count(), 3);
    let lines: Vec<_> = (0..=6).map(|offset| table.line(offset)).collect();
    assert_eq!(lines, [0, 0, 0, 1, 2, 2, 2]);
    assert_eq!(table.start(2), Some(4));
    assert_eq!(table.start(3), None);
}
