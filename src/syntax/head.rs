//! The head of a file, where it uses other files.

/// The byte at which a `use` is inserted into a text, and whether it is the end of the last `use`;
/// else it is the start of the first item and its comments.
pub fn place_of_use(text: &str) -> (usize, bool) {
    let (mut place, mut first, mut last) = (0, None, None);
    for written in text.split_inclusive('\n') {
        let line = written.trim_start_matches('\u{feff}');
        if line.starts_with("use ") {
            last = Some(place + written.trim_end().len());
        }
        if first.is_none() && !line.trim().is_empty() && !line.starts_with("//!") {
            first = Some(place + written.len() - line.len());
        }
        place += written.len();
    }
    match last {
        Some(last) => (last, true),
        None => (first.unwrap_or(0), false),
    }
}
