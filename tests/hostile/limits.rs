//! What is too large is told so at once, with the limit.

use std::time::{Duration, Instant};

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::source::Sources;

/// What is too large about a program, and nothing else is.
fn told(text: &str) -> Vec<String> {
    let started = Instant::now();
    let mut sources = Sources::new();
    let file = sources.add("large.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    // Not a matter of seconds, also on a machine that has much else to do.
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
    let errors = analysis.diagnostics.iter().filter(|told| told.is_error());
    let told = errors.inspect(|told| {
        assert_eq!(told.code, "too-large", "{}", told.message);
        assert!(!told.notes.is_empty(), "{}: what is the way out?", told.message);
    });
    told.map(|told| told.message.clone()).collect()
}

fn listed(count: usize, one: impl Fn(usize) -> String, between: &str) -> String {
    (0..count).map(one).collect::<Vec<_>>().join(between)
}

const SMALL: &str = "before { edge e: a | d\n face f: v0 -a-> v1 =P=> v0 }
    after { edge e: a | d\n face f: v0 -a-> v1 =P=> v0 }";

#[test]
fn an_item_has_only_so_many_parameters() {
    let params = |count| listed(count, |at| format!("p{at}: real = 0"), ", ");
    let op = |count: usize| format!("op f(e: edge, {}) {{ {SMALL} }}", params(count - 1));
    assert_eq!(told(&op(255)), [""; 0]);
    assert_eq!(told(&op(256)), ["this has 256 parameters, and there can be 255"]);
    assert_eq!(told(&op(70_000)), ["this has 70000 parameters, and there can be 255"]);
    let of_fn =
        format!("fn f({}) -> real {{ 1.0 }}", listed(70_000, |at| format!("p{at}: real"), ", "));
    assert_eq!(told(&of_fn).len(), 1);
    let of_script = format!("script s({}) {{ print \"\" }}", params(70_000));
    assert_eq!(told(&of_script).len(), 1);
}

#[test]
fn a_drawing_has_only_so_many_halfedges() {
    let op = |count: usize| {
        let arrows = listed(count, |at| format!("-h{at}-> v{}", (at + 1) % count), " ");
        let side = format!("face f: v0 {arrows}");
        format!("op f(h0: halfedge) {{ before {{ {side} }} after {{ {side} }} }}")
    };
    assert_eq!(told(&op(256)), [""; 0]);
    for count in [257, 400, 20_000] {
        let said = told(&op(count));
        let wanted =
            format!("`before` draws {count} halfedges and statements, and there can be 256");
        assert_eq!(said.first(), Some(&wanted));
    }
}

/// The search for a counterexample has a bound, however many lengths the paths may have.
#[test]
fn a_slip_in_a_drawing_of_many_paths_is_told() {
    let count = 40;
    let next = |at: usize| (at + 1) % count;
    let sides = format!("v0 {}", listed(count, |at| format!("-a{at}-> v{}", next(at)), " "));
    let edges = listed(count, |at| format!("edge e{at}: a{at} | b{at}"), "\n");
    let face =
        |at: usize| format!("face g{at}: v{} -b{at}-> v{at} =P{at}=> v{}", next(at), next(at));
    let kept = listed(count - 1, |at| format!("e{}", at + 1), " ");
    let text = format!(
        "op p(f: face) {{ before {{ face f: {sides}\n{edges}\n{} }}
        after {{ hole f: {sides} erase e0 keep {kept} {} }} }}",
        listed(count, face, "\n"),
        listed(count, |at| format!("g{at}"), " ")
    );
    let mut sources = Sources::new();
    let file = sources.add("many.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    assert!(analysis.diagnostics.iter().any(|told| told.is_error()));
}

#[test]
fn a_drawing_has_only_so_many_spokes_and_names() {
    let names = |count| listed(count, |at| format!("a{at}"), "\n // c\n");
    let star =
        |count| format!("op f(e: edge) {{ before {{ vertex v: {} }} after {{ }} }}", names(count));
    let kept = |count| {
        format!("op f(e: edge) {{ before {{ edge e: a | d }} after {{ keep {} }} }}", names(count))
    };
    for count in [4097, 60_000] {
        let wanted =
            |side| format!("`{side}` lists {count} spokes and names, and there can be 4096");
        assert_eq!(told(&star(count)).first(), Some(&wanted("before")));
        assert_eq!(told(&kept(count)).first(), Some(&wanted("after")));
    }
}

#[test]
fn an_op_has_only_so_many_rules() {
    let rules = |count| listed(count, |at| format!("rule r{at} {{ {SMALL} }}"), "\n");
    let said = told(&format!("op f(e: edge) {{ {} }}", rules(10_000)));
    assert_eq!(said, ["this op has 10000 rules, and there can be 1024"]);
}

#[test]
fn an_op_in_steps_has_only_so_many_reasons_to_refuse() {
    let count = 3000;
    let ops = listed(
        count,
        |at| match at + 1 == count {
            true => format!("op s{at}(e: edge) {{ {SMALL} }}"),
            false => format!("op s{at}(e: edge) {{ steps {{ must s{}(e) }} }}", at + 1),
        },
        "\n",
    );
    let told = told(&ops);
    assert!(told[0].ends_with("is too large to compile"), "{}", told[0]);
    // What calls one that has no plan has none, and that is nothing new to tell.
    assert_eq!(told.len(), 1);
}

/// Each file uses the next: how far that goes is no matter of the stack.
#[test]
fn a_chain_of_files_may_be_long() {
    const COUNT: usize = 4_000;
    let text = |at: usize| match at + 1 < COUNT {
        true => format!("use \"f{}.hedge\"\n", at + 1),
        false => "fn last() { 1 }\n".to_owned(),
    };
    let read = move || {
        let mut sources = Sources::new();
        let files: Vec<_> =
            (0..COUNT).map(|at| sources.add(format!("f{at}.hedge"), text(at))).collect();
        Analysis::with(&mut sources, files[0], &mut Nowhere).is_sound()
    };
    let small = std::thread::Builder::new().stack_size(1 << 20);
    assert!(small.spawn(read).unwrap().join().unwrap());
}
