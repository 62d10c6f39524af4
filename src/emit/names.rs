//! What the names of a drawing are called in code.
//!
//! A name stays what it is wherever that is possible. A prime becomes `_`; a word that the
//! languages keep to themselves, and one that is taken, get something behind them.

use std::collections::BTreeSet;

use crate::diagram::{Kind, NameId, Op, Rule, Type};

/// Words of C++ and Rust, and what emitted code uses itself.
const RESERVED: &str = "
    alignas alignof and as asm async auto await become bitand bitor bool box break case catch char
    class compl concept const consteval constexpr constinit continue crate default delete do double
    dyn else enum explicit export extern false final float fn for friend gen goto if impl in inline
    int let long loop macro match mod move mut mutable namespace new noexcept not nullptr operator
    or override priv private protected pub public ref register requires return self short signed
    sizeof static std struct super switch template this throw trait true try type typedef typeid
    typename union unsafe unsized unsigned use using virtual void volatile wchar_t where while xor
    yield mesh hedgerow main abs min max";

/// The names of one rule.
pub(super) struct Names {
    words: Vec<String>,
    lasts: Vec<String>,
    empties: Vec<String>,
    params: Vec<String>,
    folds: Vec<(u32, String)>,
    taken: BTreeSet<String>,
}

impl Names {
    /// Names for everything that a rule draws. Parameters are called the same in all rules.
    pub fn new(op: &Op, rule: &Rule) -> Self {
        let mut names = Self {
            words: Vec::new(),
            lasts: Vec::new(),
            empties: Vec::new(),
            params: Vec::new(),
            folds: Vec::new(),
            taken: RESERVED.split_whitespace().map(String::from).collect(),
        };
        for param in &op.params {
            let word = names.fresh(&param.name);
            names.params.push(word);
        }
        for id in 0..rule.names.len() as u32 {
            let name = rule.name(NameId(id));
            let param = rule
                .params
                .iter()
                .position(|param| *param == Some(NameId(id)));
            let text = match name.named {
                true => name.text.clone(),
                false => unnamed(&name.text, name.kind),
            };
            let (word, last, empty) = match (param, name.kind) {
                (Some(param), _) => (names.params[param].clone(), String::new(), String::new()),
                (None, Kind::Path) => (
                    names.fresh(&format!("{text}_first")),
                    names.fresh(&format!("{text}_last")),
                    names.fresh(&format!("{text}_is_empty")),
                ),
                (None, _) => (names.fresh(&text), String::new(), String::new()),
            };
            names.words.push(word);
            names.lasts.push(last);
            names.empties.push(empty);
        }
        names
    }

    /// A name that is not taken yet, as near as can be to the one that is wanted.
    pub fn fresh(&mut self, wanted: &str) -> String {
        let primes = wanted.chars().rev().take_while(|c| *c == '\'').count();
        let stem = wanted.trim_end_matches('\'');
        let mut word = match primes {
            0 => stem.to_string(),
            1 => format!("{stem}_"),
            _ => format!("{stem}_{primes}"),
        };
        // Two underscores in a row, and one before a capital, belong to the compiler in C++.
        while word.contains("__") {
            word = word.replace("__", "_");
        }
        if word.starts_with('_') {
            word = format!("x{word}");
        }
        let mut free = word.clone();
        let mut number = 2;
        while !self.taken.insert(free.clone()) {
            free = match self.is_reserved(&word) && number == 2 {
                true => format!("{word}_"),
                false => format!("{}_{number}", word.trim_end_matches('_')),
            };
            number += 1;
        }
        free
    }

    /// Lets go of a name that has meaning in one block only, so that it can be used again.
    pub fn release(&mut self, word: &str) {
        self.taken.remove(word);
    }

    fn is_reserved(&self, word: &str) -> bool {
        RESERVED.split_whitespace().any(|reserved| reserved == word)
    }

    /// An element; of a path its first halfedge.
    pub fn word(&self, name: NameId) -> &str {
        &self.words[name.index()]
    }

    /// The last halfedge of a path.
    pub fn last(&self, path: NameId) -> &str {
        &self.lasts[path.index()]
    }

    /// Whether a path is empty.
    pub fn empty(&self, path: NameId) -> &str {
        &self.empties[path.index()]
    }

    /// A parameter, or the variable of an aggregate.
    pub fn local(&self, number: u32) -> &str {
        let fold = self.folds.iter().rev().find(|fold| fold.0 == number);
        match fold {
            Some((_, word)) => word,
            None => self.params.get(number as usize).map_or("", String::as_str),
        }
    }

    /// Names the variable of an aggregate.
    pub fn declare(&mut self, number: u32, ty: Type) -> String {
        let wanted = match ty {
            Type::Vertex => "w",
            Type::Halfedge => "h",
            Type::Edge => "e",
            _ => "f",
        };
        let word = self.fresh(wanted);
        self.folds.push((number, word.clone()));
        word
    }

    /// The parameters of the op.
    pub fn params(&self) -> &[String] {
        &self.params
    }
}

/// A word for a path or fan without a name: "the path of `f0`" is `rest_of_f0`.
fn unnamed(description: &str, kind: Kind) -> String {
    let of = description.split('`').nth(1).unwrap_or("");
    let is_word = !of.is_empty()
        && of
            .chars()
            .all(|c| c.is_alphanumeric() || c == '_' || c == '\'');
    match (kind, is_word) {
        (_, true) => format!("rest_of_{}", of.replace('\'', "_")),
        (Kind::Path, false) => "rest".to_string(),
        (_, false) => "others".to_string(),
    }
}
