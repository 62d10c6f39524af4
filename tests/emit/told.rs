//! What cannot be emitted is said, with its place.

use hedgerow::analysis::Analysis;
use hedgerow::emit::{Selection, Style, cpp, rust};
use hedgerow::source::Sources;

/// An op that is proved, and cannot be emitted: what that is, and its words in the text.
fn refused(text: &str) -> (String, String) {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::of(&sources, file);
    assert!(analysis.is_sound(), "{:?}", analysis.diagnostics);
    let selection = Selection {
        program: &analysis.program,
        proved: &analysis.proved,
        sources: &sources,
        ops: &[0],
        exhaustive: false,
    };
    let told = cpp(&selection, &Style::default()).expect_err("it cannot be emitted");
    assert_eq!(rust(&selection), Err(told.clone()));
    (told.what, sources.slice(told.span).to_string())
}

#[test]
fn a_text_is_no_value_in_pointer_code() {
    let (what, place) = refused(
        "op f(e: edge) {
          before { edge e: a | b  loop f: v -a-> w =P=> v }
          require \"a\" == \"b\" else \"no\"
          after { keep e f }
        }",
    );
    assert_eq!((what.as_str(), place.as_str()), ("a text", "\"a\""));
}
