//! What the parser makes of texts: pages of trees and messages, and noise.

mod braces;
mod dump;
mod grammar;
mod noise;
mod tokens;

use hedgerow::diagnostic::{Rendering, render};
use hedgerow::source::Sources;
use hedgerow::syntax::parse;

const PLAIN: Rendering = Rendering { colour: false, most: 20 };

#[test]
fn pages_hold() {
    let count = support::pages::check("language/syntax", |case| {
        let mut sources = Sources::new();
        let file = sources.add("page.hedge", case.input);
        let parsed = parse(file, case.input);
        match case.kind {
            "text" => dump::dump(&parsed.tree),
            "diagnostics" => render(&parsed.diagnostics, &sources, PLAIN),
            kind => panic!("{}: what is `{kind}`?", case.place),
        }
    });
    assert!(count >= 30, "only {count} cases");
}
