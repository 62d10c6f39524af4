//! Lessons: each has a gap, and is solved by its own program only.

use hedgerow::lessons::{all, judge, lesson};

#[test]
fn lessons_are_solved_by_their_own_program_and_not_by_the_one_given() {
    let mut count = 0;
    for lesson in all() {
        count += 1;
        assert_eq!(lesson.number(), count, "{}", lesson.name);
        assert_eq!(judge(&lesson, lesson.solution()), Ok(()), "{}", lesson.name);
        let missing = judge(&lesson, &lesson.program);
        assert!(missing.is_err(), "{} is solved as it is given", lesson.name);
        assert!(!lesson.program.contains("//|"), "{}", lesson.name);
    }
    assert_eq!(count, 12);
}

#[test]
fn lessons_are_found_by_name_and_number() {
    assert_eq!(lesson("3"), lesson("03_flip"));
    assert_eq!(lesson("03").map(|lesson| lesson.title), Some("The flip"));
    assert_eq!(lesson("13"), None);
    assert_eq!(lesson("flip"), None);
}

#[test]
fn what_does_something_else_is_told_with_a_place() {
    let flip = lesson("5").expect("there is one");
    let all_refused = flip.solution().replace("guard simple", "require false else \"no\"");
    let said = judge(&flip, &all_refused).unwrap_err();
    assert!(said.contains("at edge 0") && said.contains("should apply"), "{said}");
    let other_name = flip.solution().replace("op flip", "op flop");
    assert!(judge(&flip, &other_name).unwrap_err().contains("flip"));
    let moved = lesson("6").expect("there is one");
    let text = moved.solution().replace("m.position = centroid(f)", "m.position = vec3(0, 9, 0)");
    let said = judge(&moved, &text).unwrap_err();
    assert!(said.contains("the mesh should be another one"), "{said}");
}
