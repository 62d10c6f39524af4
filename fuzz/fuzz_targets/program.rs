//! Any text is read and formatted: nothing panics, and what is formatted stays as it is.
#![no_main]

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::diagnostic::{Rendering, render};
use hedgerow::format::format;
use hedgerow::source::{FileId, Sources};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let formatted = format(FileId(0), text).unwrap_or_else(|refusal| panic!("{refusal}"));
    let again = format(FileId(0), &formatted.text).map(|again| again.text);
    assert_eq!(again.as_deref(), Ok(formatted.text.as_str()));
    let mut sources = Sources::new();
    let file = sources.add("fuzz.hedge", text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    render(&analysis.diagnostics, &sources, Rendering { colour: false, most: 20 });
});
