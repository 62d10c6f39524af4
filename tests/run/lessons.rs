//! Lessons: each has a gap, and is solved by its own program only.

use std::collections::BTreeSet;

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
    assert_eq!(count, 15);
}

#[test]
fn common_mistakes_are_rejected_each_with_its_own_message() {
    let mut messages = BTreeSet::new();
    let mut titles = BTreeSet::new();
    for lesson in all() {
        assert!(!lesson.mistakes.is_empty(), "{} is about no mistake", lesson.name);
        for mistake in &lesson.mistakes {
            let rejected = judge(&lesson, &mistake.program).expect_err(mistake.title);
            assert_eq!(rejected.mistake.as_ref(), Some(mistake), "{}", rejected.why);
            assert!(rejected.to_string().contains(mistake.text), "{rejected}");
            let message = rejected.to_string();
            assert!(messages.insert(message), "{} has the message of another", mistake.title);
            titles.insert(mistake.title);
        }
    }
    assert_eq!(titles.len(), 24);
    assert_eq!(messages.len(), 24);
}

#[test]
fn a_mistake_is_known_in_other_words_and_others_are_not_taken_for_it() {
    let flip = lesson("5").expect("there is one");
    let unguarded = flip.solution().replace("guard simple", "require true else \"no\"");
    let rejected = judge(&flip, &unguarded).unwrap_err();
    let title = "An edge is flipped although the other diagonal is there";
    assert_eq!(rejected.mistake.map(|mistake| mistake.title), Some(title));
    let refusing = flip.solution().replace("guard simple", "require false else \"no\"");
    assert_eq!(judge(&flip, &refusing).unwrap_err().mistake, None);
    assert_eq!(judge(&flip, "op flip(").unwrap_err().mistake, None);
    // What two mistakes have in common, that no edge is flipped, tells of neither.
    let script = lesson("11").expect("there is one");
    let never = script.solution().replace("> pi", "> 7 * pi");
    assert_eq!(judge(&script, &never).unwrap_err().mistake, None);
    let title = |text: &str| judge(&script, text).unwrap_err().mistake.map(|mistake| mistake.title);
    let degrees = script.solution().replace("> pi", "> 180");
    assert_eq!(title(&degrees), Some("An angle is given in degrees"));
}

#[test]
fn a_program_that_ignores_its_parameter_is_none() {
    for (number, uses, ignores) in [
        ("11", "> longest", "> 0.3"),
        ("12", "repeat iterations", "repeat 3"),
        ("13", "> most", "> 8"),
    ] {
        let lesson = lesson(number).expect("there is one");
        let ignoring = lesson.solution().replace(uses, ignores);
        assert_ne!(ignoring, lesson.solution(), "{number}");
        let rejected = judge(&lesson, &ignoring).unwrap_err();
        assert!(rejected.why.contains(" with `"), "{number}: {}", rejected.why);
    }
}

#[test]
fn a_mistake_is_known_in_each_of_its_ways() {
    let steps = lesson("15").expect("there is one");
    let tried = steps.solution();
    for musts in ["must flip", "must collapse", "must"] {
        let tried = tried.replace(musts, musts.trim_start_matches("must").trim_start());
        let rejected = judge(&steps, &tried).unwrap_err();
        let title = rejected.mistake.map(|mistake| mistake.title);
        assert_eq!(title, Some("A step is only tried"), "{musts}: {}", rejected.why);
    }
}

#[test]
fn of_a_script_it_is_told_how_often_it_should_call() {
    let calls = [
        ("12", "`collapse` 41 (here 1)"),
        ("13", "`collapse` 36 (here 0)"),
        ("14", "`split` 6 (here 0)"),
    ];
    for (number, call) in calls {
        let lesson = lesson(number).expect("there is one");
        let again = lesson.program.replace("\n}\n", "\n  // Not yet.\n}\n");
        let rejected = judge(&lesson, &again).unwrap_err();
        assert_eq!(rejected.mistake, None);
        assert!(rejected.why.starts_with("the missing part is not written yet"), "{rejected}");
        assert!(rejected.why.contains(call), "{rejected}");
    }
    let drain = lesson("13").expect("there is one");
    let said = judge(&drain, &drain.solution().replace("> most", ">= most")).unwrap_err().why;
    assert!(said.ends_with("Applied on the way to that one: `collapse` 0 (here 1)"), "{said}");
}

#[test]
fn what_comes_to_no_end_is_no_solution() {
    let script = lesson("11").expect("there is one");
    let text = script.solution().replace(
        "script refine(longest: real = 0.3) {",
        "script refine(longest: real = 0.3) { while true { }",
    );
    let said = judge(&script, &text).unwrap_err().why;
    assert!(said.contains("on a tetrahedron"), "{said}");
}

#[test]
fn lessons_are_found_by_name_and_number() {
    assert_eq!(lesson("3"), lesson("03_flip"));
    assert_eq!(lesson("03").map(|lesson| lesson.title), Some("The flip"));
    assert_eq!(lesson("16"), None);
    assert_eq!(lesson("flip"), None);
}

#[test]
fn what_does_something_else_is_told_with_a_place() {
    let flip = lesson("5").expect("there is one");
    let all_refused = flip.solution().replace("guard simple", "require false else \"no\"");
    let said = judge(&flip, &all_refused).unwrap_err().why;
    assert!(said.contains("at edge 0") && said.contains("should apply"), "{said}");
    let other_name = flip.solution().replace("op flip", "op flop");
    assert!(judge(&flip, &other_name).unwrap_err().why.contains("flip"));
    let moved = lesson("6").expect("there is one");
    let text = moved.solution().replace("m.position = centroid(f)", "m.position = vec3(0, 9, 0)");
    let said = judge(&moved, &text).unwrap_err().why;
    assert!(said.contains("the mesh should be another one"), "{said}");
}
