//! The library of the language, and how files are found.

use hedgerow::analysis::{Analysis, Nowhere, Reader};
use hedgerow::library::{FOLDER, file, files, target, targets};
use hedgerow::source::Sources;

#[test]
fn every_file_is_found_by_all_of_its_names() {
    let mut found = 0;
    for known in files() {
        let shorter = known.name.strip_suffix(".hedge").unwrap();
        let shortest = shorter.strip_prefix(FOLDER).unwrap();
        for name in [known.name, shorter, shortest] {
            assert_eq!(file(name), Some(known));
        }
        found += 1;
    }
    assert!(found > 0);
    assert_eq!(file("std/nothing.hedge"), None);
    assert_eq!(file("std/scotty3d.target"), None);
    for name in ["scotty3d", "scotty3d.target", "std/scotty3d.target"] {
        assert_eq!(target(name), targets().next());
    }
}

#[test]
fn all_files_can_be_used_in_one_program() {
    let mut sources = Sources::new();
    let uses: String = files().map(|known| format!("use \"{}\"\n", known.name)).collect();
    let root = sources.add("a.hedge", uses);
    assert!(Analysis::with(&mut sources, root, &mut Nowhere).diagnostics.is_empty());
}

/// A reader that writes down what it is asked for.
#[derive(Default)]
struct Asked(Vec<String>);

impl Reader for Asked {
    fn read(&mut self, name: &str) -> Result<String, String> {
        self.0.push(name.to_owned());
        Ok(String::new())
    }

    fn beside(&mut self, _name: &str) -> Vec<String> {
        Vec::new()
    }
}

#[test]
fn paths_begin_at_the_folder_of_the_file() {
    for (here, path, name) in [
        ("a.hedge", "b.hedge", Some("b.hedge")),
        ("x/a.hedge", "./b.hedge", Some("x/b.hedge")),
        ("x/a.hedge", "../b.hedge", Some("b.hedge")),
        ("a.hedge", "../b.hedge", Some("../b.hedge")),
        ("/x/y/a.hedge", "../z/b.hedge", Some("/x/z/b.hedge")),
        ("x/a.hedge", "std/triangle.hedge", None),
        ("x/a.hedge", "/b.hedge", Some("/b.hedge")),
    ] {
        let mut sources = Sources::new();
        let root = sources.add(here, format!("use \"{path}\""));
        let mut asked = Asked::default();
        Analysis::with(&mut sources, root, &mut asked);
        assert_eq!(asked.0.first().map(String::as_str), name, "{path} in {here}");
    }
}

#[test]
fn a_use_is_inserted_behind_the_others_or_before_all() {
    let inserted = |text: &str| {
        let mut sources = Sources::new();
        let root = sources.add("a.hedge", text);
        let analysis = Analysis::with(&mut sources, root, &mut Nowhere);
        let mut fixes = analysis.diagnostics.iter().flat_map(|found| &found.fixes);
        let fix = fixes.next().expect("a file of the library is offered");
        let edit = &fix.edits[0];
        let (before, after) = text.split_at(edit.span.start as usize);
        format!("{before}{}{after}", edit.text)
    };
    let script = "script main() { loop_once() }";
    let used = "use \"std/subdivide.hedge\"";
    assert_eq!(
        inserted(&format!("use \"std/smooth.hedge\"\n\n{script}")),
        format!("use \"std/smooth.hedge\"\n{used}\n\n{script}")
    );
    assert_eq!(
        inserted(&format!("//! a\n\n/// b\n{script}")),
        format!("//! a\n\n{used}\n\n/// b\n{script}")
    );
}
