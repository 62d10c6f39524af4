//! Diagnostics as they are shown on a terminal.

use std::borrow::Cow;

use hedgerow::diagnostic::{Diagnostic, Rendering, render, shown};
use hedgerow::source::{FileId, Sources, Span};

const PLAIN: Rendering = Rendering { colour: false, most: 2 };

#[test]
fn any_span_in_any_text_is_rendered() {
    let texts = ["", "\n", "aé𝄞\r\nz\u{2028}\u{1b}[31m\ty", "\u{FEFF}x", "é"];
    let mut sources = Sources::new();
    let files: Vec<_> = texts.iter().map(|text| sources.add("a", *text)).collect();
    let files = files.into_iter().chain([FileId(99)]);
    for file in files {
        for start in 0..16 {
            for end in start..18 {
                let span = Span::new(file, start, end);
                let other = Span::new(FileId(2), end, end + start);
                let found = Diagnostic::error("a-code", "said", span).label(other, "other");
                let found = found.label(span.after(), "after").fix("mend", span, "");
                for colour in [false, true] {
                    let how = Rendering { colour, most: 1 };
                    let text = render(std::slice::from_ref(&found), &sources, how);
                    assert!(text.contains("said") && text.contains("mend"), "{text}");
                    assert!(colour || !text.contains('\u{1b}'), "{text}");
                }
            }
        }
    }
}

#[test]
fn each_file_is_shown_once_and_remarks_follow() {
    let mut sources = Sources::new();
    let one = sources.add("one.hedge", "edge e: a | é\nedge f: b | c\n");
    let two = sources.add("two.hedge", "é\nuse x\n");
    let found = Diagnostic::error("missing-thing", "`f` is missing", Span::new(one, 20, 21))
        .saying("needed")
        .label(Span::new(two, 3, 6), "elsewhere")
        .label(Span::new(one, 0, 4), "drawn here")
        .note("a note")
        .fix("insert `g`", Span::new(one, 15, 15), "g");
    assert_eq!(
        render(&[found], &sources, PLAIN),
        "\
error[missing-thing]: `f` is missing
   ╭─[ one.hedge:2:6 ]
   │
 1 │ edge e: a | é
   │ ──┬─
   │   ╰─── drawn here
 2 │ edge f: b | c
   │      ┬
   │      ╰── needed
   │
   ├─[ two.hedge:2:1 ]
   │
 2 │ use x
   │ ─┬─
   │  ╰─── elsewhere
───╯
  note: a note
  help: insert `g` (one.hedge:2:1)

"
    );
}

#[test]
fn what_is_not_shown_is_counted() {
    let mut sources = Sources::new();
    let span = Span::new(sources.add("a", "b"), 0, 1);
    let error = Diagnostic::error("e", "m", span);
    let warning = Diagnostic::warning("w", "m", span);
    let all = [&error, &error, &error, &warning, &warning].map(Clone::clone);
    let text = render(&all, &sources, PLAIN);
    assert!(text.ends_with("… and 1 more error and 2 more warnings\n"), "{text}");
}

#[test]
fn nothing_is_left_to_obey() {
    assert!(matches!(shown("a\tb\né𝄞"), Cow::Borrowed(_)));
    assert_eq!(shown("\u{1b}[31mred\u{7}\u{9b}2J"), "\u{FFFD}[31mred\u{FFFD}\u{FFFD}2J");
    assert_eq!(shown("a\u{202e}b\u{2066}c\r\nd"), "a\u{FFFD}b\u{FFFD}c \nd");
}
