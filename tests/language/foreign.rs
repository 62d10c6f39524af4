//! Words and ways of other languages: known where they are wrong, and not seen where all is right.

use std::path::Path;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::diagnostic::Diagnostic;
use hedgerow::source::{FileId, Sources};
use hedgerow::syntax::foreign_syntax::mend;
use hedgerow::syntax::lex;

/// Programs that can be read are never asked about; still nothing is found in them, so that
/// nothing is told of what is right beside a mistake.
#[test]
fn nothing_is_foreign_in_what_is_right() {
    let mut tokens = 0;
    for folder in ["src/library/std", "examples"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        for file in std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()) {
            if file.extension().is_none_or(|end| end != "hedge") {
                continue;
            }
            let text = std::fs::read_to_string(&file).unwrap();
            let lexed = lex(FileId(0), &text);
            let found = mend(&text, &lexed.tokens).found;
            let told: Vec<_> = found.iter().map(|found| &found.says).collect();
            assert!(told.is_empty(), "{}: {told:?}", file.display());
            tokens += lexed.tokens.len();
        }
    }
    assert!(tokens > 10_000, "only {tokens} tokens");
}

fn diagnostics(text: &str) -> Vec<Diagnostic> {
    let mut sources = Sources::new();
    let root = sources.add("a.hedge", text);
    Analysis::with(&mut sources, root, &mut Nowhere).diagnostics
}

/// The text in the words of the language, by the fix for an unknown name; none if there is none.
fn fixed(text: &str) -> Option<String> {
    let unknown = |found: &&Diagnostic| found.code.starts_with("unknown-");
    let all = diagnostics(text);
    let found = all.iter().find(unknown).unwrap_or_else(|| panic!("nothing is unknown: {text}"));
    let edit = &found.fixes.first()?.edits[0];
    let mut text = text.to_owned();
    text.replace_range(edit.span.range(), &edit.text);
    Some(text)
}

#[test]
fn what_is_offered_for_a_foreign_word_is_there() {
    let fields = ["origin", "opposite", "previous", "pos", "v0", "v1", "he", "verts"];
    let mut offered = 0;
    let mut expect = |text: String| {
        let Some(text) = fixed(&text) else { return };
        let left = diagnostics(&text);
        let unknown = left.iter().find(|found| found.code.starts_with("unknown-"));
        assert_eq!(unknown, None, "{text}");
        offered += 1;
    };
    for elements in ["vertices", "halfedges", "edges", "faces"] {
        for field in fields {
            expect(format!("script main() {{ for x in {elements} {{ print x.{field} }} }}"));
        }
    }
    let calls = [
        "valence(v)",
        "norm(v.position)",
        "lerp(v.position, v.halfedge.target.position, 0.5)",
        "average(v)",
        "cot(v.halfedge)",
        "ln(angle(v.halfedge))",
        "vector(1.0)",
    ];
    for call in calls {
        let text = format!("script main() {{ for v in vertices {{ print {call} }} }}");
        assert!(fixed(&text).is_some(), "{call} has an equal");
        expect(text);
    }
    assert!(offered > 10, "only {offered} are offered");
}
