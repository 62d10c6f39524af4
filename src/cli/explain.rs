//! `hedgerow explain`

use super::arguments::ExplainArguments;
use super::failure::Failure;
use super::library::{self, declared};
use super::output::{print_line, prose, table};
use crate::analysis::{MEANINGS, Word, functions, meaning, word};
use crate::diagnostic::{explain as explanation, explained};
use crate::diagram::{Property, Type};
use crate::emit::style_patterns;
use crate::resolve::{closest, constants};

/// Explains a diagnostic and how to fix it, or a word of the language.
pub(super) fn explain(arguments: &ExplainArguments) -> Result<(), Failure> {
    let Some(asked) = arguments.word.as_deref() else {
        let rows: Vec<_> = explained().map(|(code, law)| vec![code.into(), law.into()]).collect();
        print_line(&table(&rows, &[]));
        return Ok(());
    };
    let asked = usual(bare(asked));
    if asked == "properties" {
        print_line(&table(&properties(), &[]));
        return Ok(());
    }
    if asked == "style" {
        print_line(&styles());
        return Ok(());
    }
    if let Some(words) = listed(asked) {
        list(&words);
        return Ok(());
    }
    // `half-edge`, `Halfedge` and `vertices` are written `halfedge` and `vertex`.
    let plain = asked.to_lowercase().replace(['-', '_'], "");
    let singular = match plain.strip_suffix("ices") {
        Some(stem) => format!("{stem}ex"),
        None => plain.trim_end_matches('s').to_owned(),
    };
    let known = |word: &str| {
        explanation(word).is_some() || self::word(word).is_some() || !declared(word).is_empty()
    };
    let joined = asked.to_lowercase().replace(['-', ' '], "_");
    // `flip_edge` and `make_boundary` are `flip` and `boundary` here.
    let apart = ["_edge", "_face", "_vertex"].iter().find_map(|end| joined.strip_suffix(end));
    let apart = apart.or_else(|| joined.strip_prefix("make_")).unwrap_or(asked);
    let others = [plain.as_str(), singular.as_str(), joined.as_str(), apart];
    let asked = match known(asked) {
        true => asked,
        false => others.into_iter().find(|other| known(other)).unwrap_or(asked),
    };
    let text = explanation(asked).map(str::to_owned).or_else(|| word(asked).map(described));
    let of_library = declared(asked).into_iter().map(|item| item.described());
    let texts: Vec<_> = text.into_iter().chain(of_library).chain(library::file(asked)).collect();
    if texts.is_empty() {
        if let Some(rows) = library::mentioning(&singular).filter(|_| singular.len() > 2) {
            print_line(&format!("nothing is called `{asked}`; in the library:\n\n{rows}"));
            return Ok(());
        }
        let advice = match closest(asked, explained().map(|(code, _)| code).chain(functions())) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "`hedgerow explain` lists the diagnostics, `hedgerow explain functions` the \
                     functions; likewise `types`, `constants`, `properties` and `style`; `hedgerow std` \
                     lists the library"
                .to_owned(),
        };
        let message = format!(
            "there is no diagnostic, no word and nothing in the library `{asked}`; {advice}"
        );
        return Err(Failure::usage(message));
    }
    let mut text = texts.join("\n\n");
    // `outer` begins `outer halfedge`.
    for (phrase, meaning) in MEANINGS.iter() {
        if phrase.split_once(' ').is_some_and(|(first, _)| first == asked) {
            text += &format!("\n\n{phrase}: {meaning}");
        }
    }
    print_line(&format!("{asked}\n\n{}", prose(&text)));
    Ok(())
}

/// What an operation can keep, a line each, without what else its word may mean.
fn properties() -> Vec<Vec<String>> {
    let words = Property::ALL.map(Property::word).into_iter().chain(["map"]);
    let row = |name: &str| {
        let meaning = meaning(name)?;
        let own = meaning.strip_prefix("as a property: ").and_then(|rest| rest.split(';').next());
        Some(vec![name.to_owned(), own.unwrap_or(meaning).to_owned()])
    };
    words.filter_map(row).collect()
}

/// The patterns of C++ that `--style` changes, a line each.
fn styles() -> String {
    let head = ["pattern", "--style fields", "--style accessors"];
    let rows = std::iter::once(head).chain(style_patterns());
    let rows: Vec<_> = rows.map(|row| row.map(str::to_owned).to_vec()).collect();
    let head = "How `hedgerow plan --as cpp` spells C++. `--style NAME=PATTERN` changes one; \
                `grammar/reference.md` says what each is.";
    format!("{}\n\n{}", prose(head), table(&rows, &[]))
}

/// The words of which `functions`, `types` and `constants` are lists.
fn listed(asked: &str) -> Option<Vec<&'static str>> {
    Some(match asked {
        "functions" => functions(),
        "types" => Type::ALL.map(Type::word).to_vec(),
        "constants" => constants().collect(),
        _ => return None,
    })
}

/// Words of the language, a line each.
fn list(words: &[&str]) {
    let rows = words.iter().filter_map(|name| {
        let Word { forms, meaning } = word(name)?;
        let first = forms.first().map_or(*name, String::as_str);
        let called = first.split(" -> ").next().unwrap_or(first);
        let more = if forms.len() > 1 { ", …" } else { "" };
        Some(vec![format!("{called}{more}"), meaning.to_owned()])
    });
    let rows: Vec<_> = rows.collect();
    print_line(&table(&rows, &[]));
}

fn described(Word { forms, meaning }: Word) -> String {
    if forms.is_empty() { meaning.to_owned() } else { format!("{}\n\n{meaning}", forms.join("\n")) }
}

/// The word of the language for a sign, or for a term that is usual elsewhere.
fn usual(asked: &str) -> &str {
    match asked {
        _ if asked.starts_with('*') => "fan",
        _ if asked.ends_with("=>") => "path",
        _ if asked.ends_with("->") => "halfedge",
        "|" => "edge",
        "valence" => "degree",
        "decimate" => "simplify",
        "delete" | "remove" => "erase",
        "float" | "double" => "real",
        "string" => "text",
        "sort" | "queue" | "priority" | "heap" => "drain",
        "array" | "lists" | "stack" => "list",
        "attribute" | "uv" | "uvs" | "texcoord" | "seam" | "wedge" => "attr",
        "oriented" | "orient" => "orientation",
        "poke" => "inset_vertex",
        "border" => "boundary",
        "cases" => "case",
        "styles" | "c++" | "C++" | "cpp" => "style",
        "witness" | "witnesses" => "counterexample",
        "qem" | "qslim" => "quadric",
        _ => asked,
    }
}

/// The code in a text that may be copied from a message: `error[stale-vertex]: …`.
fn bare(told: &str) -> &str {
    let inside = told.split_once('[').and_then(|(_, rest)| {
        let (code, _) = rest.split_once(']')?;
        Some(code)
    });
    inside.unwrap_or(told).trim()
}
