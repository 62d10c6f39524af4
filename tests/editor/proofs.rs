//! Proofs from one text to the next.

use hedgerow::analysis::{Nowhere, Snapshot};

const PROGRAM: &str = "
attr weight: edge real = 0
attr other: edge real = 0
fn half(x: real) -> real { return x / scale() }
fn scale() -> real { return 2 }
fn apart() -> real { return 3 }
op f(e: edge) {
  before {
    loop f: v0 -a-> v1 =P=> v0
    loop g: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  require e.weight > 1
  after {
    keep f g e
    e.weight = half(e.weight)
  }
}
";

#[test]
fn a_proof_is_kept_while_what_it_names_is_as_it_was() {
    let changes = [
        ("x / scale()", "x * scale()", false),
        ("return 2", "return 4", false),
        ("weight: edge real = 0", "weight: edge real = 1", false),
        ("attr weight", "attr first: face int = 0\nattr weight", false),
        ("attr other", "attr last: vertex real\nattr other", false),
        ("> 1", "> 2", false),
        ("return 3", "return 4", true),
        ("other: edge real = 0", "other: edge int = 1", true),
        ("\nop f", "\nfn more() -> real { return 1 }\nop f", true),
        ("\nop f", "\nscript s() {}\n\nop f", true),
    ];
    for (was, is, is_kept) in changes {
        let first = Snapshot::new("a.hedge", PROGRAM, &mut Nowhere);
        let proof = first.examined(0);
        assert!(proof.proved.is_some(), "{:?}", first.diagnostics());
        let next = first.next(&PROGRAM.replace(was, is), &mut Nowhere);
        assert!(next.examined(0).proved.is_some(), "{is}");
        assert_eq!(std::ptr::eq(proof, next.examined(0)), is_kept, "{is}");
    }
}

/// An error in a default is no reason to want a value of new elements: whether an op is proved does
/// not depend on what was there before.
#[test]
fn a_default_with_an_error_is_a_default() {
    let good =
        "attr tag: vertex real = 0\nuse \"std/triangle.hedge\"\nscript s(e: edge) { split(e) }\n";
    for wrong in ["0 0", "true", "nothing"] {
        let wrong = good.replace("= 0", &format!("= {wrong}"));
        let later = Snapshot::new("a.hedge", good, &mut Nowhere);
        let split = |snapshot: &Snapshot| {
            let at = snapshot.program().ops.iter().position(|op| op.name == "split").unwrap();
            snapshot.examined(at).proved.is_some()
        };
        assert!(split(&later));
        assert!(split(&later.next(&wrong, &mut Nowhere)), "{wrong}");
        assert!(split(&Snapshot::new("a.hedge", &wrong, &mut Nowhere)), "{wrong}");
    }
}
