//! A routine as C++: the classic function over a pointer-based halfedge mesh.

use std::collections::{BTreeMap, BTreeSet};

use super::style::Style;
use super::support;
use crate::emit::item::Item;
use crate::emit::items::{Items, items};
use crate::emit::language::Language;
use crate::emit::print::support::CPP;
use crate::emit::print::{self, Part};
use crate::emit::{NotEmitted, Selection};
use crate::source::Span;

/// The namespace of what operations call, unless a style names another.
const DEFAULT: &str = "hedgerow";

/// The namespace of the functions that operations call, until its name is known: that depends on
/// their texts, since two programs may have functions of the same name.
pub(in crate::emit) const CALLED: &str = "hedgerow::p00000000::";

/// Operations as C++17, with the functions that they call. A refused operation returns
/// `std::nullopt`; one without a result returns whether it applied.
///
/// # Errors
/// [`NotEmitted`] for what cannot be expressed in such a function, and for a style that cannot
/// compile with it.
pub fn cpp(selection: &Selection<'_>, style: &Style) -> Result<String, NotEmitted> {
    let reserved = style.reserved();
    let language = Language { style: Some(style), is_outside: false, reserved: &reserved };
    let Items { called, mut ops } = items(selection, language)?;
    for Item { signature, .. } in &mut ops {
        let can_give = style.is("result", "given") && signature.result.is_none();
        signature.given = signature.given.take().filter(|_| can_give);
        signature.result = signature.result.or(signature.given.as_ref().map(|given| given.ty));
    }
    if let Some(why) = is_contradictory(style, &ops) {
        return Err(of_style(selection, why));
    }
    let fields = called.iter().chain(&ops).flat_map(|item| &item.attributes).map(|attribute| {
        let (element, ty) = (attribute.element.word(), language.ty(attribute.ty));
        let default = attribute.default.map(|span| {
            let words = selection.sources.slice(span).split_whitespace();
            format!(", by default {}", words.collect::<Vec<_>>().join(" "))
        });
        format!("//   {element}: {ty} {}{}\n", attribute.name, default.unwrap_or_default())
    });
    let fields = fields.collect();
    let outside = called.iter().map(|item| print::item(language, item, Part::Called));
    let outside = outside.collect::<Vec<_>>().join("\n");
    let part = if ops.len() == 1 { Part::Alone } else { Part::Selected };
    let shown = ops.iter().map(|item| print::item(language, item, part));
    let body = shown.collect::<Vec<_>>().join("\n");
    let needed = CPP.needed(&format!("{outside}{body}"), "hedgerow::");
    if let Some(why) = is_blind(style, &outside, &needed) {
        return Err(of_style(selection, why));
    }
    Ok(file(style, &fields, &outside, &needed, &body))
}

/// The refusal of a style that cannot compile with a selection.
fn of_style(selection: &Selection<'_>, why: String) -> NotEmitted {
    let first = selection.ops.first().and_then(|&op| selection.program.ops.get(op));
    let span = first.map_or(Span::default(), |op| op.span);
    NotEmitted { why: Some(why), ..NotEmitted::new("this style", span) }
}

/// The reason why a style names no functions for these operations: one name for all of them, or
/// the same name twice.
fn is_contradictory(style: &Style, ops: &[Item]) -> Option<String> {
    let other = style.name("function");
    if !other.is_empty() && ops.len() > 1 {
        return Some(format!(
            "`function={other}` names one operation, and there are {}: `function.{}={other}` names one of them",
            ops.len(),
            ops[0].signature.declared
        ));
    }
    let space = style.name("namespace");
    if ops.iter().any(|op| style.name_of(&op.signature, Part::Selected) == space) {
        return Some(format!(
            "`{space}` is the name of a function, and cannot be that of a namespace"
        ));
    }
    let mut named = BTreeMap::new();
    ops.iter().map(|op| &op.signature).find_map(|head| {
        let name = style.name_of(head, Part::Selected);
        let first = named.insert(name, &head.declared)?;
        Some(format!("`{first}` and `{}` would both be called `{name}`", head.declared))
    })
}

/// The reason why the functions beside the operations cannot compile: the mesh that the style
/// needs is not in scope there, or two kinds of elements have the same type.
fn is_blind(style: &Style, outside: &str, needed: &[(&str, &str)]) -> Option<String> {
    if let Some([one, other]) = style.one_type()
        && needed.iter().any(|(name, _)| ["Journal", "Preview"].contains(name))
    {
        return Some(format!(
            "`{one}` and `{other}` are one type, and overloads tell elements apart by theirs"
        ));
    }
    let (pattern, word) = style.needs_mesh()?;
    let looking = needed.iter().find(|(_, text)| support::looks_at_mesh(text));
    let whose = match (outside.is_empty(), looking) {
        (_, Some((name, _))) => format!("`{}`", name.trim_end_matches(".n")),
        (false, None) => "what they call".to_string(),
        (true, None) => return None,
    };
    let advice = match style.is_member() {
        _ if word == "this" => "there is no `this`".to_string(),
        true => format!("write `::{word}`, or where else a free function of it stands"),
        false => "elements have to lead to what the pattern wants by themselves".to_string(),
    };
    Some(format!(
        "the pattern of `{pattern}` takes `{word}` from where it stands, and {whose}, beside the operations, does not know it: {advice}"
    ))
}

/// Everything together; `fields` are the attributes that elements must have.
fn file(
    style: &Style,
    fields: &BTreeSet<String>,
    outside: &str,
    needed: &[(&str, &str)],
    body: &str,
) -> String {
    let space = style.name("namespace");
    // In object files for another mesh class, or by another version of hedgerow, these are others.
    let key =
        named('v', &CPP.all().map(|(_, text)| text).chain(style.patterns()).collect::<String>());
    let functions =
        needed.iter().map(|(name, text)| once(space, name, &support::spelled(name, text, style)));
    let mut functions = functions.collect::<String>();
    let called = named('p', &format!("{key}{outside}"));
    if !outside.is_empty() {
        let text = format!("namespace {called} {{\n\n{}\n}}", outside.trim_end());
        functions += &once(space, &called, &text);
    }
    let called = format!("hedgerow::{called}::");
    let [functions, body] = [&functions, body].map(|text| text.replace(CALLED, &called));
    let mut headers = BTreeSet::from(["optional"]);
    headers.extend(super::headers::headers(&functions));
    headers.extend(super::headers::headers(&body));
    let mut head = style.include();
    if !head.is_empty() {
        head.push('\n');
    }
    if !fields.is_empty() {
        head.push_str("// Elements have these attributes:\n");
        head.extend(fields.iter().map(String::as_str).chain(["\n"]));
    }
    head.extend(headers.iter().map(|header| format!("#include <{header}>\n")));
    let body = match style.name("operations") {
        "" => body,
        name => format!("namespace {name} {{\n\n{}\n\n}}  // namespace {name}\n", body.trim_end()),
    };
    if functions.is_empty() {
        return format!("{head}\n{body}");
    }
    let text = format!(
        "{head}\nnamespace hedgerow {{\ninline namespace {key} {{\n{functions}\n}}\n}}  // namespace hedgerow\n\n{body}"
    );
    if space == DEFAULT { text } else { renamed(&text, space) }
}

/// A text with another name for the namespace `hedgerow`.
fn renamed(text: &str, name: &str) -> String {
    let mut parts = text.split(DEFAULT);
    let mut out = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let is_inside = out.ends_with(|c: char| c.is_alphanumeric() || "_:\"/".contains(c));
        let is_space = part.starts_with("::") || out.ends_with("namespace ");
        out += if is_space && !is_inside { name } else { DEFAULT };
        out += part;
    }
    out
}

/// A name for a text, by its hash FNV-1a (Fowler, Noll and Vo, 1991).
fn named(letter: char, text: &str) -> String {
    let hash = |hash: u32, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    format!("{letter}{:08x}", text.bytes().fold(0x811c_9dc5, hash))
}

/// A text in an include guard of a namespace, so that several emitted files can be combined.
fn once(space: &str, name: &str, text: &str) -> String {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
    // Names that differ only in case are distinct.
    let space = match space {
        DEFAULT => String::new(),
        other => format!("_{}", other.replace("::", "_")),
    };
    let guard = format!("HEDGEROW{space}_{}", words.join("_"));
    format!("\n#ifndef {guard}\n#define {guard}\n{text}\n#endif\n")
}
