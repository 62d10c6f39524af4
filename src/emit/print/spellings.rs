//! Functions in Rust and C++, side by side, as `spellings.txt` spells them.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::spelled::{Level, Spelled};
use crate::diagram::{Binary, Type};
use crate::emit::term::{Function, Operation};

/// The text in Rust and in C++ by name; empty for none.
static SPELLINGS: LazyLock<BTreeMap<&str, [&str; 2]>> = LazyLock::new(|| {
    let mut rows: Vec<Vec<&str>> = Vec::new();
    for line in include_str!("spellings.txt").lines().filter(|line| !line.starts_with('#')) {
        let parts = line.split("  ").map(str::trim).filter(|part| !part.is_empty());
        match (line.starts_with(' '), rows.last_mut()) {
            (true, Some(row)) => row.extend(parts),
            _ => rows.push(parts.collect()),
        }
    }
    let texts = rows.iter().filter_map(|row| match row[..] {
        [name, rust, cpp] => {
            Some((name, [rust, cpp].map(|text| if text == "-" { "" } else { text })))
        }
        _ => None,
    });
    texts.collect()
});

/// The call of a function in Rust and in C++.
pub(super) fn spelled(function: Function) -> [&'static str; 2] {
    let name = match function {
        Function::Builtin(builtin) => format!("{builtin:?}"),
        Function::Named(name) | Function::OfPreview(name) => name.to_string(),
        Function::Of(operation, ty) => {
            let name = match operation {
                Operation::Operator(operator) => format!("of.{operator:?}"),
                Operation::Builtin(builtin) => format!("of.{builtin:?}"),
                Operation::Part(_) => "of.Part".into(),
                Operation::Column(_) => "of.Column".into(),
                Operation::First(part) => format!("of.First{}", part.size()),
                Operation::Negate | Operation::Make | Operation::Extend => {
                    format!("of.{operation:?}")
                }
            };
            let exact = format!("{name}.{ty:?}");
            if SPELLINGS.contains_key(exact.as_str()) { exact } else { name }
        }
    };
    *SPELLINGS.get(name.as_str()).expect("every function that is emitted has a spelling")
}

/// The call for an operator in Rust and in C++; empty where it stands between its sides.
pub(super) fn operator(operator: Binary) -> [&'static str; 2] {
    SPELLINGS.get(format!("{operator:?}").as_str()).copied().unwrap_or_default()
}

/// A call with the names of types, sizes and parts filled in.
pub(super) fn with_types(call: &str, function: Function, name: impl Fn(Type) -> String) -> String {
    let Function::Of(operation, ty) = function else {
        return call.to_string();
    };
    let matrix = if ty.size() == 3 { Type::Mat3 } else { Type::Mat4 };
    let part = match operation {
        Operation::Part(part) | Operation::Column(part) => part.min(3),
        _ => 0,
    };
    let axis = ["x", "y", "z", "w"][usize::from(part)];
    call.replace("{T}", &name(ty))
        .replace("{N}", &ty.size().to_string())
        .replace("{M}", &name(matrix))
        .replace("{P}", &part.to_string())
        .replace("{X}", axis)
}

/// A call with its arguments filled in. They bind as tightly as `level`, or as their place
/// requires.
pub(super) fn with_arguments(call: &str, args: &[Spelled], level: Level) -> String {
    let mut parts = call.split('{');
    let mut text = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let argument = part.split_once('}').and_then(|(number, rest)| {
            let argument = args.get(number.parse::<usize>().ok()?)?;
            Some((argument.clone(), rest))
        });
        match argument {
            Some((argument, rest)) => {
                let level = match () {
                    () if rest.starts_with(['.', '[']) || text.ends_with('-') => Level::Whole,
                    () if text.ends_with("- ") => Level::Product,
                    () if rest.starts_with(" -") => level.max(Level::Sum),
                    () => level,
                };
                text.push_str(&argument.at(level));
                text.push_str(rest);
            }
            None => text.extend(["{", part]),
        }
    }
    text
}
