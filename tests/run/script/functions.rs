//! Functions: their values, their recursion, what they do to the mesh, and how they fail.

use hedgerow::analysis::Analysis;
use hedgerow::mesh::{ElementKind, shape, validate};
use hedgerow::run::{prepare, run};
use hedgerow::source::Sources;

use crate::script::{Lines, applied, try_run};

fn lines(functions: &str, body: &str) -> Vec<String> {
    let script = format!("{functions}\nscript main() {{\n{body}\n}}");
    try_run(&mut shape::cube(), &script, &[]).unwrap().1
}

#[test]
fn functions_give_values() {
    let functions = "
        fn square(x: real) -> real { return x * x }
        fn twice(x: real, by: real = 2) { x * by }
        fn factorial(n: int) -> int { if n <= 1 { 1 } else { n * factorial(n - 1) } }
        fn even(n: int) -> bool { if n == 0 { return true } odd(n - 1) }
        fn odd(n: int) -> bool { if n == 0 { return false } even(n - 1) }
        fn gcd(a: int, b: int) -> int {
          var x = a
          var y = b
          while y != 0 { let rest = x mod y  x = y  y = rest }
          x
        }
        fn up(v: vertex, by: real) -> vec3 { v.position + vec3(0, 0, by) }
        fn first(limit: int) -> int {
          for v in vertices { if degree(v) > limit { return 1 } }
          return 0
        }
        fn sign(x: real) -> text { if x < 0 { \"minus\" } else if x > 0 { \"plus\" } else { \"zero\" } }
        fn last_name(which: int) -> text { sign(which) }
        fn nested(x: int) -> int { { let y = x + 1  { y * 2 } } }";
    let body = "
        print square(3), square(2) + square(square(2)), twice(4), twice(4, 3)
        print factorial(10), even(10), odd(10), gcd(84, 36)
        for v in vertices { print up(v, 1).z - v.position.z  break }
        print first(2), first(3)
        print sign(-2), sign(0), last_name(3), sign(1) == sign(2)
        print nested(3), if square(2) > 3 { let x = square(2) let y = x + 1 x * y } else { 0 }
        print sum(square(degree(v)) for v in vertices where square(degree(v)) > 4)";
    let expected =
        ["9 20 8 12", "3628800 true false 12", "1", "1 0", "minus zero plus true", "8 20", "72"];
    assert_eq!(lines(functions, body), expected);
}

#[test]
fn ops_ask_functions() {
    let program = "
        fn shorter(e: edge, than: real) -> bool {
          let twice = than * 2
          var sum = 0.0
          for v in e.vertices { sum = sum + distance(v, e.halfedge.vertex) }
          sum * 2 < twice
        }
        fn middle(v: vertex, w: vertex, t: real) { mix(v.position, w.position, t) }
        op move(e: edge, limit: real) {
          before { face f0: v0 -a-> v1 =P=> v0  edge e: a | b }
          require shorter(e, limit) else \"too long\"
          after { keep f0 e  v0.position = middle(v0, v1, 0.25) }
        }
        script main() { for e in edges { move(e, 0.3) } }";
    let mut mesh = shape::icosphere(2);
    let short = mesh.edges().filter(|&e| mesh.length(e) < 0.3).count();
    let (report, _) = try_run(&mut mesh, program, &[]).unwrap();
    let op = report.ops.iter().find(|op| op.name == "move").unwrap();
    let refused: u64 = op.refused.iter().map(|(_, times)| times).sum();
    assert_eq!(op.applied + refused, mesh.edge_count() as u64);
    assert!(op.applied > 0 && refused > 0 && short > 0);
    assert_eq!(op.refused[0].0, "too long");
}

#[test]
fn functions_change_the_mesh_and_are_counted() {
    let program = "
        fn cut(limit: real) -> int {
          var done = 0
          for e in edges where length(e) > limit { if split(e) { done = done + 1 } }
          return done
        }
        fn cut_all(limit: real) {
          var more = cut(limit)
          while more > 0 { smooth()  more = cut(limit) }
        }
        fn smooth() {
          update v in vertices { v.position = mean(w.position for w in v.neighbors) }
        }
        fn middle(e: edge) -> vertex { let m = must split(e)  m }
        fn given(e: edge) -> vertex { if let m = split(e) { m } else { e.halfedge.vertex } }
        fn made(e: edge) -> vertex { must split(e) }
        script main() {
          cut_all(0.4)
          for e in edges {
            let m = middle(e)
            let n = given(m.halfedge.edge)
            let o = made(n.halfedge.edge)
            assert degree(m) >= 4 and degree(n) >= 4 and degree(o) >= 4
            break
          }
        }";
    let mut mesh = shape::icosphere(1);
    let (report, _) = try_run(&mut mesh, program, &[]).unwrap();
    assert!(applied(&report, "split") > 20);
    assert!(mesh.edges().all(|e| mesh.length(e) < 0.8));
}

#[test]
fn memory_stays_bounded_also_inside_of_functions() {
    let program = "
        fn breathe() {
          for e in edges { if split(e) { collapse(e, 100) } }
        }
        fn often(n: int) { repeat n { breathe() } }
        script main() { often(10)  repeat 10 { breathe() } }";
    let mut mesh = shape::icosphere(1);
    let (report, _) = try_run(&mut mesh, program, &[]).unwrap();
    let splits = applied(&report, "split");
    assert!(splits > 1000, "{splits} splits");
    let slots = mesh.capacity(ElementKind::Edge);
    assert!(slots < 1000, "{slots} slots");
}

#[test]
fn an_element_that_a_caller_needs_is_not_given_out_again() {
    // While `kept` is held, no new edge may take the number of an erased one.
    let program = "
        fn churn() { repeat 3 { for e in edges { split(e) } for e in edges { collapse(e, 100) } } }
        fn through(e: edge) -> int { churn()  if length(e) > 0 { 1 } else { 2 } }
        script main() {
          for kept in edges { churn()  print length(kept)  break }
        }";
    let failed = try_run(&mut shape::icosphere(1), program, &[]).unwrap_err();
    assert_eq!(failed.diagnostic.code, "element-gone");
    let inner = program.replace("churn()  print length(kept)  break", "print through(kept)  break");
    let inner = inner.replace("print through(kept)", "let x = through(kept)");
    let failed = try_run(&mut shape::icosphere(1), &inner, &[]).unwrap_err();
    assert_eq!(failed.diagnostic.code, "element-gone");
    assert_eq!(failed.diagnostic.labels.len(), 2, "with the call");
}

#[test]
fn failures_point_into_functions_and_at_their_calls() {
    let program = "
        fn low(n: int) -> int { 10 div n }
        fn high(n: int) -> int { low(n) + 1 }
        script main() { print high(0) }";
    let failed = try_run(&mut shape::cube(), program, &[]).unwrap_err();
    assert_eq!(failed.diagnostic.code, "division-by-zero");
    assert_eq!(failed.diagnostic.labels.len(), 3);

    let program = "
        fn checked(n: int) -> int { assert n > 0 else \"n is positive\"  n }
        op o(e: edge, n: int) {
          before { edge e: a | b  face f: v -a-> w =P=> v }
          require checked(n) > 1
          after { keep e f }
        }
        script main() { for e in edges { o(e, 0) } }";
    let failed = try_run(&mut shape::cube(), program, &[]).unwrap_err();
    assert_eq!(failed.diagnostic.message, "n is positive");
    assert_eq!(failed.diagnostic.code, "assertion-failed");
    assert_eq!(failed.diagnostic.labels.len(), 3);

    let program = "
        fn deeper(n: int) -> int { deeper(n + 1) }
        script main() { print deeper(0) }";
    let failed = try_run(&mut shape::cube(), program, &[]).unwrap_err();
    assert_eq!(failed.diagnostic.code, "calls-too-deep");
    assert!(failed.diagnostic.labels.len() < 10);
}

#[test]
fn functions_of_used_files_run() {
    let mut sources = Sources::new();
    let text = "use \"lib.hedge\"\nscript main() { print double(4) }";
    let file = sources.add("main.hedge", text);
    sources.add("lib.hedge", "fn double(x: int) { x * hidden() }\nfn hidden() { 2 }");
    let analysis = Analysis::of(&sources, file);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    let prepared = prepare(&analysis.program, 0, &analysis.plans).unwrap();
    let mut printed = Lines::default();
    let mut mesh = shape::cube();
    run(&prepared, &mut mesh, &[], &mut printed).unwrap();
    assert_eq!(printed.0, ["8"]);
    validate(&mesh).unwrap();
}
