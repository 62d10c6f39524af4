//! Lessons in a terminal.

use crate::bench::Bench;

#[test]
fn a_lesson_is_shown_begun_and_solved() {
    let bench = Bench::with_square();
    let run = |arguments: &[&str]| {
        let output = bench.command(arguments).output().expect("it starts");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    };
    let (code, out, _) = run(&["learn"]);
    assert_eq!(code, Some(0));
    assert!(out.contains(" 3  The flip") && out.contains("12  A whole remesher"), "{out}");
    let (code, out, _) = run(&["learn", "5"]);
    assert_eq!(code, Some(0));
    assert!(out.contains("5. Sound is not yet safe") && out.contains("op flip"), "{out}");
    let (code, ..) = run(&["learn", "5", "mine.hedge", "--start"]);
    assert_eq!(code, Some(0));
    let (code, _, err) = run(&["learn", "5", "mine.hedge", "--start"]);
    assert_eq!(code, Some(2));
    assert!(err.contains("is there already"), "{err}");
    let (code, _, err) = run(&["learn", "5", "mine.hedge"]);
    assert_eq!(code, Some(1));
    assert!(err.contains("on a tetrahedron, at edge 0") && err.contains("not solved yet"), "{err}");
    let text = bench.read("mine.hedge").replace("// Here a guard is missing.", "guard simple");
    bench.write("mine.hedge", &text);
    let (code, out, _) = run(&["learn", "5", "mine.hedge"]);
    assert_eq!(code, Some(0));
    assert!(out.contains("solved") && out.contains("next: 6."), "{out}");
    assert_eq!(run(&["learn", "3", "flip.hedge", "--start"]).0, Some(0));
    let (_, _, err) = run(&["learn", "3", "flip.hedge"]);
    assert!(err.contains("flip.hedge:") && !err.contains("03_flip.hedge"), "{err}");
    let (_, out, _) = run(&["learn", "1"]);
    assert!(out.contains("`hedgerow plan lesson.hedge`"), "{out}");
    assert!(out.contains("`hedgerow play lesson.hedge`"), "{out}");
    let (code, _, err) = run(&["learn", "99"]);
    assert_eq!(code, Some(2));
    assert!(err.contains("there is no lesson `99`"), "{err}");
    assert_eq!(run(&["learn", "5", "nowhere.hedge"]).0, Some(2));
}
