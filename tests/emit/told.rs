//! What cannot be emitted is said, with its place.

use hedgerow::analysis::Analysis;
use hedgerow::emit::{NotEmitted, Selection, Style, cpp, rust};
use hedgerow::source::Sources;

/// The first op of a sound program as C++ and as Rust, with the sources.
fn emitted(text: &str) -> ([Result<String, NotEmitted>; 2], Sources) {
    emitted_in(&Style::default(), text)
}

/// The same with the C++ in a style.
pub fn emitted_in(style: &Style, text: &str) -> ([Result<String, NotEmitted>; 2], Sources) {
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
    ([cpp(&selection, style), rust(&selection)], sources)
}

/// An op that is proved, and cannot be emitted: what that is, and its words in the text.
fn refused(text: &str) -> (String, String) {
    let ([cpp, rust], sources) = emitted(text);
    let told = cpp.expect_err("it cannot be emitted");
    assert_eq!(rust, Err(told.clone()));
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
fn what_only_a_run_can_do_is_said() {
    for (statement, what, place) in [
        ("if can g(v) { }", "`can` or `why`", "can g(v)"),
        ("if random() < 0.5 { g(v) }", "a random number", "random()"),
        ("if chosen() == 1 { g(v) }", "a random number", "random(3)"),
        (
            "for w in shuffle(v.neighbors) { g(w) }",
            "a random order",
            "for w in shuffle(v.neighbors) { g(w) }",
        ),
        ("s()", "the call of a script", "s()"),
    ] {
        let told = refused(&format!(
            "op f(v: vertex) {{ steps {{ {statement} }} }}
            op g(v: vertex) {{ steps {{ }} }}
            fn chosen() -> int {{ random(3) }}
            script s() {{ for v in vertices {{ g(v) }} }}"
        ));
        assert_eq!((told.0.as_str(), told.1.as_str()), (what, place));
    }
}

#[test]
fn a_position_is_tested_unless_its_form_says_that_it_is_finite() {
    for (value, is_tested) in [
        ("v.position * 1e300", true),
        ("v.position / 1e-300", true),
        ("v.position / length(e)", true),
        ("(v.position + w.position) / 2", false),
        ("mix(v.position, w.position, 1e3)", false),
    ] {
        let (texts, _) = emitted(&format!(
            "op f(e: edge) {{
              before {{ edge e: a | b  loop f: v -a-> w =P=> v }}
              after {{ keep e f  v.position = {value} }}
            }}"
        ));
        for text in texts.map(Result::unwrap) {
            assert_eq!(text.contains("is_finite"), is_tested, "{value}: {text}");
        }
    }
}

#[test]
fn what_nothing_reads_is_computed_where_that_may_stop_a_run() {
    for (value, may_stop) in [
        ("7 mod (degree(v) - 3)", true),
        ("mean(w.tint for w in v.neighbors where boundary(w))", true),
        ("seventh(degree(v))", true),
        ("round(v.tint)", true),
        ("v.tint / 0", false),
        ("length(v.position)", false),
        ("count(boundary(w) for w in v.neighbors)", false),
    ] {
        let ([cpp, rust], _) = emitted(&format!(
            "op f(v: vertex) {{ steps {{ let x = {value} v.tint = 1 }} }}
            attr tint: vertex real = 0
            fn seventh(n: int) -> int {{ 7 div n }}"
        ));
        assert_eq!(cpp.unwrap().contains("  static_cast<void>("), may_stop, "{value}");
        assert_eq!(rust.unwrap().contains("    let _ = "), may_stop, "{value}");
    }
}
