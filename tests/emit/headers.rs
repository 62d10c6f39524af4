//! Everything of the standard library that emitted code names has its header.

use hedgerow::emit::cpp::headers::{headers, names};

#[test]
fn everything_that_is_written_out_has_its_header() {
    let text = [
        include_str!("../../src/emit/cpp/functions.txt"),
        include_str!("../../src/emit/cpp/values.txt"),
        include_str!("../../src/emit/cpp/preview.txt"),
        include_str!("../../src/emit/cpp/journal.txt"),
        include_str!("../../src/emit/cpp/style.rs"),
        include_str!("../../src/emit/language.rs"),
        include_str!("../../src/emit/print/item.rs"),
        include_str!("../../src/emit/print/statement.rs"),
        include_str!("../../src/emit/statement.rs"),
        include_str!("../../src/emit/steps/body.rs"),
        include_str!("../../src/emit/value/aggregate.rs"),
        include_str!("../../src/emit/value/language.rs"),
        include_str!("../../src/emit/value/spellings.txt"),
    ];
    let text = text.concat().replace("use std::collections", "");
    for name in names(&text) {
        let known = headers(&format!("std::{name}"));
        assert!(known.len() == 1 || ["mem", ""].contains(&name), "std::{name}");
    }
    assert!(headers("std::all_of(x)").contains("algorithm"));
}
