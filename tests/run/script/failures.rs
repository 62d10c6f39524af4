//! Scripts that do not come to their end.

use super::*;
use hedgerow::mesh::VertexId;
use hedgerow::mesh::shape;
use hedgerow::{Program, Session};
use std::ops::ControlFlow;

/// The code, the message and the words at the labels of a failure.
fn failure(body: &str) -> (String, String, Vec<String>) {
    let text = format!("{OPS}\nscript main() {{\n{body}\n}}");
    let (sources, analysis) = analyse(&text);
    let number = analysis.script("main").unwrap();
    let prepared = prepare(&analysis.program, number, &analysis.plans).unwrap();
    let mut mesh = shape::icosphere(1);
    let failed = run(&prepared, &mut mesh, &[], &mut Lines::default()).unwrap_err();
    let diagnostic = failed.diagnostic;
    let labels = diagnostic.labels.iter();
    let words = labels.map(|label| sources.slice(label.span).to_owned());
    (diagnostic.code.to_owned(), diagnostic.message, words.collect())
}

/// A failure in an operation has its own code, whether a script or `apply` calls it.
#[test]
fn a_failure_in_an_operation_has_its_code() {
    for (step, code) in [
        ("assert degree(v) == 1", "assertion-failed"),
        ("let x = 1 div (degree(v) - degree(v))", "division-by-zero"),
        (
            "let x = mean(degree(w) for w in v.neighbors where degree(w) > 9)",
            "aggregate-of-nothing",
        ),
        ("v.position = vec3(1 / 0)", "not-finite"),
    ] {
        let text = format!(
            "op act(v: vertex) {{ steps {{ {step} }} }}
            script main() {{ for v in vertices {{ act(v) }} }}"
        );
        let program = Program::parse("act.hedge", &text).unwrap();
        let mut session = Session::new(&program, shape::icosphere(0));
        let failed = session.apply(&program.op("act").unwrap(), VertexId(0)).unwrap_err();
        assert_eq!(failed.code(), code);
        let failed = session.run(&program.script("main").unwrap(), ()).unwrap_err();
        assert_eq!(failed.code(), code);
    }
}

#[test]
fn a_failure_points_at_its_place() {
    let cases = [
        (
            "assert count(edges) == 1 else \"too many edges\"",
            [
                "assertion-failed",
                "too many edges",
                "assert count(edges) == 1 else \"too many edges\"",
            ],
        ),
        (
            "print 1 div (count(holes))",
            ["division-by-zero", "division by zero", "1 div (count(holes))"],
        ),
        (
            "print 1 mod count(holes)",
            ["division-by-zero", "division by zero", "1 mod count(holes)"],
        ),
        (
            "print mean(1.0 for h in holes)",
            ["aggregate-of-nothing", "the mean of nothing", "mean(1.0 for h in holes)"],
        ),
        (
            "for v in vertices { print mean(1.0 for w in v.neighbors where degree(w) > 9) }",
            [
                "aggregate-of-nothing",
                "the mean of nothing around vertex 0",
                "mean(1.0 for w in v.neighbors where degree(w) > 9)",
            ],
        ),
        (
            "print max(1 for h in holes)",
            ["aggregate-of-nothing", "the greatest of nothing", "max(1 for h in holes)"],
        ),
        (
            "print 9223372036854775807 + count(edges)",
            [
                "int-overflow",
                "the number is too large for an int",
                "9223372036854775807 + count(edges)",
            ],
        ),
        (
            "for v in vertices { v.position = vec3(1, 2, 1 / count(holes)) }",
            [
                "not-finite",
                "the new position of vertex 0 is not finite",
                "v.position = vec3(1, 2, 1 / count(holes))",
            ],
        ),
        (
            "update v in vertices { v.position = vec3(1, 2, 1 / count(holes)) }",
            [
                "not-finite",
                "the new position of vertex 0 is not finite",
                "v.position = vec3(1, 2, 1 / count(holes))",
            ],
        ),
        (
            "for e in edges { collapse(e, 100.0)  print length(e) }",
            ["element-gone", "edge 0 no longer exists", "length(e)"],
        ),
        (
            "for e in edges { collapse(e, 100.0)  print e }",
            ["element-gone", "edge 0 no longer exists", "e"],
        ),
        (
            "drain v in vertices by -9007199254740992 - count(v.edges) { print v }",
            [
                "int-overflow",
                "an int as a key lies beyond 2^53, and its order among others is not certain",
                "-9007199254740992 - count(v.edges)",
            ],
        ),
        (
            "print round(sqrt(-1))",
            ["int-overflow", "what is rounded is not a number", "round(sqrt(-1))"],
        ),
        (
            "for e in edges { must collapse(e, 0.0) }",
            [
                "op-refused",
                "`collapse` refused edge 0: an edge would become too long",
                "must collapse(e, 0.0)",
            ],
        ),
    ];
    for (body, [code, message, words]) in cases {
        let expected = (code.to_owned(), message.to_owned(), vec![words.to_owned()]);
        assert_eq!(failure(body), expected);
    }
}

#[test]
fn a_failure_inside_of_an_operation_leads_back_to_the_call() {
    let text = "op fails(e: edge, n: int) {
                  before { loop f: v -a-> w =P=> v  edge e: a | b }
                  require 1 div n > 0 else \"no\"
                  after { loop f: v -a-> w =P=> v  edge e: a | b }
                }
                script main() { for e in edges { fails(e, count(holes)) } }";
    let (sources, analysis) = analyse(text);
    let prepared = prepare(&analysis.program, 0, &analysis.plans).unwrap();
    let failed = run(&prepared, &mut shape::cube(), &[], &mut Lines::default());
    let diagnostic = failed.unwrap_err().diagnostic;
    assert_eq!(diagnostic.message, "division by zero");
    let words: Vec<_> = diagnostic
        .labels
        .iter()
        .map(|label| (sources.slice(label.span), label.text.as_str()))
        .collect();
    let call = ("fails(e, count(holes))", "called here");
    assert_eq!(words, [("1 div n", ""), call]);
}

#[test]
fn what_was_done_before_is_reported() {
    let failed = try_run(
        &mut shape::icosphere(1),
        "script main() { for e in edges { split(e)  assert false } }",
        &[],
    );
    let failed = failed.unwrap_err();
    assert_eq!(applied(&failed.report, "split"), 1);
    assert_eq!(failed.diagnostic.message, "the assertion does not hold");
}

#[test]
fn a_use_of_what_is_erased_names_the_operations_that_erase() {
    let notes = |text: &str| {
        let failed = try_run(&mut shape::icosphere(1), text, &[]).unwrap_err();
        assert_eq!(failed.diagnostic.code, "element-gone");
        failed.diagnostic.notes
    };
    let body = "for e in edges { split(e)  flip(e)  collapse(e, 100.0)  print length(e) }";
    let direct = format!("script main() {{ {body} }}");
    assert_eq!(notes(&direct), ["`collapse` erases edges"]);
    let nested = "op shorten(e: edge) { steps { collapse(e, 100.0) } }
                  script main() { for e in edges { shorten(e)  print length(e) } }";
    assert_eq!(notes(nested), ["`shorten` erases edges"]);
}

#[test]
fn an_operation_that_is_not_proved_cannot_be_called() {
    let mut sources = Sources::new();
    let text = "op bad(e: edge) { before { edge e: a | b } after { } }
                script main() { for e in edges { bad(e) } }";
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::of(&sources, file);
    let errors = prepare(&analysis.program, 0, &analysis.plans).unwrap_err();
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].code, "unproved-op");
    assert_eq!(errors[0].message, "`bad` is not proved, so it cannot run");
    assert_eq!(sources.slice(errors[0].span()), "bad(e)");
    let none = prepare(&analysis.program, 9, &analysis.plans).unwrap_err();
    assert_eq!(none[0].code, "unknown-script");
}

struct Stop;

impl Watch for Stop {
    fn iteration(&mut self, _: u16, _: u64, _: Option<u64>) -> ControlFlow<()> {
        ControlFlow::Break(())
    }
}

#[test]
fn an_endless_script_can_be_interrupted() {
    let (_, analysis) = analyse("script main() { while true { } }");
    let prepared = prepare(&analysis.program, 0, &analysis.plans).unwrap();
    let stopped = run(&prepared, &mut shape::cube(), &[], &mut Stop);
    assert_eq!(stopped.unwrap_err().diagnostic.code, "interrupted");
}
