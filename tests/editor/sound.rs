//! What the editor shows is what `check` says, and what it offers for a program in order leaves
//! it so.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use hedgerow::analysis::{Action, Analysis, Nowhere, Purpose, Reader, Snapshot, actions, unused};
use hedgerow::library;
use hedgerow::source::Sources;

/// Files in memory.
#[derive(Clone)]
struct Pages(Vec<(&'static str, &'static str)>);

impl Reader for Pages {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let found = self.0.iter().find(|(known, _)| *known == name);
        found.map(|(_, text)| (*text).to_owned()).ok_or_else(|| "there is no such file".to_owned())
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }
}

/// The programs that are shipped, by name.
fn shipped() -> Vec<(String, String)> {
    let library = library::files().map(|file| (file.name.to_owned(), file.text.to_owned()));
    let paths = fs::read_dir("examples").unwrap().map(|entry| entry.unwrap().path());
    let paths = paths.filter(|path| path.extension().is_some_and(|end| end == "hedge"));
    let examples =
        paths.map(|path| (path.display().to_string(), fs::read_to_string(path).unwrap()));
    library.chain(examples).collect()
}

fn applied(text: &str, action: &Action) -> String {
    let mut edits: Vec<_> = action.edits.iter().collect();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.span.start));
    let mut text = text.to_owned();
    for edit in edits {
        text.replace_range(edit.span.range(), &edit.text);
    }
    text
}

/// Where a cursor may be that is asked about: at the head of each line, and in each name of an
/// item or a rule. What is offered changes nowhere else, but for what mends a diagnostic.
fn places(text: &str) -> Vec<usize> {
    let mut places = vec![0];
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let indent = line.len() - line.trim_start().len();
        places.push(at + indent);
        let mut words = line.trim_start().split([' ', '(']);
        if let (Some("op" | "rule" | "script" | "fn" | "attr" | "use"), Some(_)) =
            (words.next(), words.next())
        {
            places.push(at + indent + line.trim_start().find(' ').unwrap() + 1);
        }
        at += line.len();
    }
    places
}

#[test]
fn what_is_offered_leaves_a_sound_program_sound() {
    let mut offered: BTreeMap<String, usize> = BTreeMap::new();
    let mut broken = Vec::new();
    for (name, text) in shipped() {
        let snapshot = Snapshot::new(&name, &text, &mut Nowhere);
        let errors = |snapshot: &Snapshot| -> Vec<String> {
            let told = snapshot.diagnostics();
            let errors = told.into_iter().filter(|told| told.is_error());
            errors.map(|told| format!("{}: {}", told.code, told.message)).collect()
        };
        assert_eq!(errors(&snapshot), [""; 0], "{name}");
        let mut seen = Vec::new();
        let told = snapshot.diagnostics();
        let told = told.iter().map(|told| told.span().range());
        let places = places(&text)
            .into_iter()
            .map(|at| at..at)
            .chain(told)
            .chain(std::iter::once(0..text.len()));
        for place in places {
            for action in actions(&snapshot, place) {
                let now = applied(&text, &action);
                if seen.contains(&now) {
                    continue;
                }
                let left = errors(&snapshot.next(&now, &mut Nowhere));
                if !left.is_empty() {
                    broken.push(format!("{name}: {}: {left:?}", action.title));
                }
                let kind = action.title.split('`').next().unwrap_or("").trim().to_owned();
                *offered.entry(kind).or_default() += 1;
                seen.push(now);
            }
        }
    }
    println!("{offered:?}");
    assert_eq!(broken, Vec::<String>::new());
    assert!(offered.values().sum::<usize>() > 30, "{offered:?}");
}

/// The errors of `check`, and those of the editor, by codes.
fn both(text: &str, pages: &Pages) -> [Vec<&'static str>; 2] {
    let mut sources = Sources::new();
    let file = sources.add("root.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut pages.clone());
    let snapshot = Snapshot::new("root.hedge", text, &mut pages.clone());
    [analysis.diagnostics, snapshot.diagnostics()]
        .map(|told| told.iter().filter(|told| told.is_error()).map(|told| told.code).collect())
}

#[test]
fn the_editor_hides_no_error() {
    let pages = Pages(vec![
        ("bad.hedge", "op b(e: edge) { before { edge e: a | d } }\n"),
        ("unread.hedge", "fn f( -> real {}\n"),
        ("through.hedge", "use \"bad.hedge\"\nfn g() -> real { 1.0 }\n"),
        (
            "loses.hedge",
            "op l(f: face) { before { face f: v0 -a-> v1 =P=> v0 } after { erase f } }\n",
        ),
    ]);
    let own = "script s() { print \"\" }\n";
    for (text, wanted) in [
        ("use \"std/polygon.hedge\"\nattr tag: vertex real\n", "missing-attribute"),
        ("use \"std/polygon.hedge\"\nattr tag: vertex real = 0\n", ""),
        ("use \"std/polygon.hedge\"\nattr tag: edge real = 0:5\n", "syntax-error"),
        ("use \"bad.hedge\"\n", "broken-file"),
        ("use \"unread.hedge\"\n", "broken-file"),
        ("use \"through.hedge\"\n", "broken-file"),
        ("use \"loses.hedge\"\n", "broken-file"),
    ] {
        let [checked, shown] = both(&format!("{text}{own}"), &pages);
        assert_eq!(checked.is_empty(), shown.is_empty(), "{text}: {checked:?} {shown:?}");
        let wanted: Vec<_> = Some(wanted).into_iter().filter(|code| !code.is_empty()).collect();
        assert_eq!(shown, wanted, "{text}");
    }
}

/// The texts with mistakes of the pages of the language, each with its place.
fn mistaken() -> Vec<(String, String)> {
    let paths = fs::read_dir("tests/language/files").unwrap().map(|entry| entry.unwrap().path());
    let pages = paths.filter(|path| path.extension().is_some_and(|end| end == "md"));
    let texts = pages.flat_map(|path| {
        let page = fs::read_to_string(&path).unwrap();
        let inputs = page.split("\n```hedge\n").skip(1).enumerate();
        let inputs = inputs.map(|(at, rest)| {
            let text = rest.split("\n```\n").next().unwrap().to_owned() + "\n";
            (format!("{} {at}", path.display()), text)
        });
        inputs.collect::<Vec<_>>()
    });
    texts.collect()
}

#[test]
fn the_editor_says_what_check_says() {
    let (mut differing, mut count) = (Vec::new(), 0);
    for (place, text) in mistaken() {
        let mut sources = Sources::new();
        let file = sources.add("root.hedge", &text);
        let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
        let own = analysis.diagnostics.iter().filter(|told| told.span().file == file);
        let shown = Snapshot::new("root.hedge", &text, &mut Nowhere).diagnostics();
        let checked: BTreeSet<_> = own.map(|told| (told.code, told.message.clone())).collect();
        let shown: BTreeSet<_> =
            shown.iter().map(|told| (told.code, told.message.clone())).collect();
        count += 1;
        if checked != shown && !checked.iter().any(|(code, _)| *code == "broken-file") {
            let only = checked.symmetric_difference(&shown);
            differing.push(format!("{place}: {:?}", only.collect::<Vec<_>>()));
        }
    }
    assert!(differing.is_empty(), "{}", differing.join("\n"));
    assert!(count > 300, "{count} texts");
}

/// What nothing reads in a text, by name.
fn unread(name: &str, text: &str) -> Vec<String> {
    let snapshot = Snapshot::new(name, text, &mut Nowhere);
    let faint = unused(&snapshot).into_iter().map(|one| format!("{} {}", one.what, one.name));
    let told = snapshot.diagnostics_so_far().into_iter();
    let variables = told.filter(|told| told.code == "unused-variable");
    let variables = variables.filter_map(|told| {
        let [edit, ..] = told.fixes.first()?.edits.as_slice() else { return None };
        assert_eq!(edit.span.start, told.span().start);
        Some(format!("variable {}", told.message.split('`').nth(1)?))
    });
    faint.chain(variables).collect()
}

#[test]
fn names_that_nothing_reads_are_found() {
    let flip = fs::read_to_string("examples/flip.hedge").unwrap();
    let text = flip.replacen("(e: edge)", "(e: edge, times: int, f: face) -> f0", 1)
        + "private attr old: vertex real = 0
           private attr heat: vertex real = 0
           attr shared: vertex real = 0
           private fn idle() { idle_too() }
           private fn idle_too() { }
           private script idle_script() { }
           fn twice(x: real, y: real, _z: real) -> real { let two = 2 let other = x two * x }
           script main(n: int = 1, m: int = 2) {
             var count = 0
             for v in vertices { count = n }
             for e in edges {
               if let d = flip(e, 1, e.halfedge.face) { print sum(1 for f in faces) }
             }
             var last = 0
             repeat 2 { last = last + 1 }
             for v in vertices { v.heat = 1 }
             let m = 3
           }";
    let told = [
        "attribute old",
        "function idle",
        "script idle_script",
        "parameter times",
        "parameter f",
        "parameter y",
        "variable other",
        "parameter m",
        "variable count",
        "variable d",
        "variable m",
    ];
    let mut found = unread("root.hedge", &text);
    assert_eq!(found.len(), told.len(), "{found:?}");
    found.retain(|one| !told.contains(&one.as_str()));
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn what_is_shipped_reads_all_that_it_declares() {
    let (mut names, mut told) = (0, Vec::new());
    for (name, text) in shipped() {
        told.extend(unread(&name, &text).into_iter().map(|one| format!("{name}: {one}")));
        names += Snapshot::new(&name, &text, &mut Nowhere).names().symbols().count();
    }
    assert_eq!(told, [""; 0]);
    assert!(names > 2000, "{names}");
}

/// What is offered as a sure fix at the end of a text.
fn sure(text: &str) -> Vec<Action> {
    let snapshot = Snapshot::new("root.hedge", text, &mut Nowhere);
    let found = actions(&snapshot, 0..text.len()).into_iter();
    found.filter(|action| action.purpose == Purpose::Fix).collect()
}

#[test]
fn a_use_is_a_sure_fix_only_where_it_clashes_with_nothing() {
    let mut counts = [0; 3];
    for file in library::files() {
        for line in file.text.lines() {
            let Some((name, _)) = line.strip_prefix("op ").and_then(|rest| rest.split_once('('))
            else {
                continue;
            };
            // A call, beside nothing, beside an op of another name that the file has, beside an
            // attribute that lacks a default.
            let call = format!("script s() {{ for e in edges {{ {name}(e) }} }}\n");
            let other = file.text.lines().filter_map(|line| line.strip_prefix("fn "));
            let other =
                other.filter_map(|rest| rest.split_once('(')).find(|(other, _)| *other != name);
            let clash = other
                .map_or(String::new(), |(other, _)| format!("fn {other}() -> real {{ 1.0 }}\n"));
            let beside = ["", "attr tag: vertex real\n", &clash];
            for (count, beside) in counts.iter_mut().zip(beside) {
                let text = format!("{beside}{call}");
                for fix in sure(&text).iter().filter(|fix| fix.title.contains("use \"")) {
                    *count += 1;
                    let mut sources = Sources::new();
                    let root = sources.add("root.hedge", applied(&text, fix));
                    let analysis = Analysis::with(&mut sources, root, &mut Nowhere);
                    let codes: Vec<_> = analysis.diagnostics.iter().map(|told| told.code).collect();
                    for code in
                        ["duplicate-name", "missing-attribute", "ambiguous-name", "unknown-op"]
                    {
                        assert!(!codes.contains(&code), "{text}: {codes:?}");
                    }
                }
            }
        }
    }
    assert!(counts[0] > 5 && counts[1] == 0, "{counts:?}");
}

/// A diagnostic is given only with what removes it.
#[test]
fn what_is_about_an_error_removes_it() {
    let text = "op flip(e: edge) {\n  before {\n    face f0: v0 -a-> v1 -b-> v2 -c-> v0\n    \
                face f1: v1 -d-> v0 -g-> v3 -h-> v1\n    edge e: a | d\n  }\n  after {\n    \
                face f1: v2 -d-> v3 -h-> v1 -b-> v2\n    edge e: a | d\n  }\n}\n";
    let offset = text.find("c->").unwrap();
    let snapshot = Snapshot::new("a.hedge", text, &mut Nowhere);
    let offered = actions(&snapshot, offset..offset);
    let (about, others): (Vec<_>, Vec<_>) =
        offered.iter().partition(|action| action.mends.is_some());
    for action in &about {
        let changed = Snapshot::new("a.hedge", &applied(text, action), &mut Nowhere);
        let code = action.mends.as_ref().unwrap().code;
        let mut left = changed.diagnostics().into_iter();
        assert!(!left.any(|left| left.code == code), "{}", action.title);
    }
    assert!(about.iter().any(|action| action.purpose == Purpose::Fix), "{about:?}");
    // Beside a fix that is certain, nothing is proposed that leaves errors.
    let others = others.iter().find(|action| action.purpose == Purpose::Proposal);
    assert!(others.is_none(), "{others:?}");
}
