//! What cannot be emitted is said, with its place.

use hedgerow::analysis::Analysis;
use hedgerow::emit::{Style, cpp, rust};
use hedgerow::source::Sources;

/// An op that is proved, and cannot be emitted: what that is, and its words in the text.
fn refused(text: &str) -> (String, String) {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::of(&sources, file);
    assert!(analysis.is_sound(), "{:?}", analysis.diagnostics);
    let proved = analysis.proved[0].as_ref().expect("a proved op");
    let told = cpp(&[proved], &[], &Style::default()).expect_err("it cannot be emitted");
    assert_eq!(rust(&[proved], &[]), Err(told.clone()));
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

#[test]
fn an_attribute_is_a_field_in_cpp_and_nothing_in_rust() {
    let mut sources = Sources::new();
    let text = "attr score: vertex int = 0
        op f(e: edge) {
          before { edge e: a | b  loop f: v -a-> w =P=> v }
          after { keep e f  v.score = v.score + 1 }
        }";
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::of(&sources, file);
    let proved = analysis.proved[0].as_ref().expect("a proved op");
    let mut style = Style::default();
    let emitted = cpp(&[proved], &[], &style).expect("it is emitted");
    assert!(
        emitted.contains("long long v_score = v->score + 1;"),
        "{emitted}"
    );
    assert!(emitted.contains("\n    v->score = v_score;"), "{emitted}");
    style.set("attribute={of}->{pointer}()").expect("a pattern");
    let emitted = cpp(&[proved], &[], &style).expect("it is emitted");
    assert!(emitted.contains("v->score() = v_score;"), "{emitted}");
    let told = rust(&[proved], &[]).expect_err("it is not emitted");
    assert_eq!(told.what, "the attribute `score`");
}
