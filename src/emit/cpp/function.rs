//! A routine as C++: the classic function over a pointer-based halfedge mesh.

use std::collections::BTreeSet;

use super::super::conventions::Conventions;
use super::super::item::{Alternative, Item, ItemBody, Signature};
use super::super::lines::Lines;
use super::super::names::invoked;
use super::super::routine::Statement;
use super::super::statement::{Printing, rule_names};
use super::super::steps::{Items, items};
use super::super::support::CPP;
use super::super::{NotEmitted, Selection};
use super::style::Style;
use super::support;
use crate::diagram::{self, Type};
use crate::source::Span;

/// Operations as C++17, with the functions that they call. A refused operation returns
/// `std::nullopt`; one without a result returns whether it applied.
///
/// # Errors
/// [`NotEmitted`] for what cannot be expressed in such a function, and for a style that cannot
/// compile with it.
pub fn cpp(selection: &Selection<'_>, style: &Style) -> Result<String, NotEmitted> {
    let conventions = Conventions {
        prev: style.has_prev(),
        isolated_vertices: false,
        columns: false,
        undoes: false,
        exhaustive: selection.exhaustive,
        reserved: &style.reserved(),
    };
    let Items { called, mut ops } = items(selection, conventions)?;
    let mut printer = Printer {
        style,
        lines: Lines::new(2),
        refusal: "",
        applied: "",
        is_outside: false,
        is_noted: false,
        preview: None,
    };
    if style.gives_back() {
        ops.iter_mut().for_each(Item::give_back);
    }
    let mut fields = BTreeSet::new();
    for item in called.iter().map(|(_, item)| item).chain(&ops) {
        item.attributes(&mut |attribute| {
            let (element, ty) = (attribute.element.word(), printer.ty(attribute.ty));
            fields.insert(format!("//   {element}: {ty} {}\n", attribute.name));
        });
    }
    let outside = called.iter().map(|(home, item)| printer.called(home, item));
    let outside = outside.collect::<String>();
    let alone = ops.len() == 1;
    for (at, item) in ops.iter().enumerate() {
        if at > 0 {
            printer.lines.line("");
        }
        printer.item(item, alone);
    }
    let body = std::mem::take(&mut printer.lines).finish();
    let needed = CPP.needed(&format!("{outside}{body}"), "hedgerow::");
    if let Some(why) = printer.is_blind(&outside, &needed) {
        let first = selection.ops.first().and_then(|&op| selection.program.ops.get(op));
        let span = first.map_or(Span::default(), |op| op.span);
        return Err(NotEmitted::because("this style", why, span));
    }
    Ok(printer.finish(&fields, &outside, &needed, &body))
}

pub(super) struct Printer<'s> {
    pub style: &'s Style,
    pub lines: Lines,
    /// The statement that leaves the current attempt.
    pub refusal: &'static str,
    /// The statement that returns without a value.
    pub applied: &'static str,
    /// True where the names of the mesh class are not in scope.
    pub is_outside: bool,
    /// True if writes are noted in a journal.
    pub is_noted: bool,
    /// The preview on which pointers are noted instead.
    pub preview: Option<String>,
}

impl Printer<'_> {
    /// The reason why the functions beside the operations cannot compile: the mesh that the style
    /// needs is not in scope there, or two kinds of elements have the same type.
    fn is_blind(&self, outside: &str, needed: &[(&str, &str)]) -> Option<String> {
        if let Some([one, other]) = self.style.one_type()
            && needed.iter().any(|(name, _)| ["Journal", "Preview"].contains(name))
        {
            return Some(format!(
                "`{one}` and `{other}` are one type, and overloads tell elements apart by theirs"
            ));
        }
        let (pattern, word) = self.style.needs_mesh()?;
        let looking = needed.iter().find(|(_, text)| support::looks_at_mesh(text));
        let whose = match (outside.is_empty(), looking) {
            (_, Some((name, _))) => format!("`{}`", name.trim_end_matches(".n")),
            (false, None) => "what they call".to_string(),
            (true, None) => return None,
        };
        let advice = match self.style.is_member() {
            _ if word == "this" => "there is no `this`".to_string(),
            true => format!("write `::{word}`, or where else a free function of it stands"),
            false => "elements have to lead to what the pattern wants by themselves".to_string(),
        };
        Some(format!(
            "the pattern of `{pattern}` takes `{word}` from where it stands, and {whose}, beside the operations, does not know it: {advice}"
        ))
    }

    /// Everything together; `fields` are the attributes that elements must have.
    fn finish(
        self,
        fields: &BTreeSet<String>,
        outside: &str,
        needed: &[(&str, &str)],
        body: &str,
    ) -> String {
        let functions =
            needed.iter().map(|(name, text)| once(name, &support::spelled(name, text, self.style)));
        let functions = functions.collect::<String>() + outside;
        let mut headers = BTreeSet::from(["optional"]);
        headers.extend(super::headers::headers(&functions));
        headers.extend(super::headers::headers(body));
        let include = self.style.include();
        let mut head = match include.is_empty() {
            true => include,
            false => include + "\n",
        };
        if !fields.is_empty() {
            head.push_str("// Elements have these attributes:\n");
            head.extend(fields.iter().map(String::as_str).chain(["\n"]));
        }
        head.extend(headers.iter().map(|header| format!("#include <{header}>\n")));
        if functions.is_empty() {
            return format!("{head}\n{body}");
        }
        // The functions that members call are local to the file.
        let (begin, end) = match self.style.is_member() {
            true => ("namespace {\n", "\n}  // namespace"),
            false => ("", ""),
        };
        format!(
            "{head}\n{begin}namespace hedgerow {{\n{functions}\n}}  // namespace hedgerow{end}\n\n{body}"
        )
    }

    /// The text of a called function or operation, which comes from the file `home`.
    fn called(&mut self, home: &str, item: &Item) -> String {
        self.is_noted = !matches!(item.body, ItemBody::Function { changes: false, .. });
        self.item(item, false);
        self.is_noted = false;
        let text = std::mem::replace(&mut self.lines, Lines::new(2)).finish();
        let home = home.strip_suffix(".hedge").unwrap_or(home);
        once(&format!("{home}_{}", item.signature.name), text.trim_end())
    }

    fn item(&mut self, item: &Item, alone: bool) {
        let signature = &item.signature;
        (self.refusal, self.applied) = match signature.result {
            Some(_) => ("return std::nullopt;", "return true;"),
            None => ("return false;", "return true;"),
        };
        match &item.body {
            ItemBody::Drawn(rules) => {
                self.head(item, alone);
                self.rules(signature, rules);
            }
            ItemBody::Steps { requires, level, steps } => {
                self.head(item, alone);
                self.steps(signature, requires, *level, steps);
            }
            ItemBody::Function { body, .. } => {
                (self.refusal, self.applied) = ("throw Refused();", "return;");
                self.is_outside = true;
                self.function(signature, body);
                self.is_outside = false;
            }
        }
        self.lines.close("}");
    }

    /// A function of the program.
    fn function(&mut self, signature: &Signature, body: &[Statement]) {
        self.docs(&signature.docs, [].iter());
        let params = signature.params.iter();
        let params = params.map(|param| format!("{} {}", self.ty(param.ty), param.name));
        let journal = self.is_noted.then(|| "Journal& journal".to_string());
        let params = journal.into_iter().chain(params).collect::<Vec<_>>().join(", ");
        let result = signature.result.map_or("void".into(), |ty| self.ty(ty));
        let name = invoked(&signature.name);
        self.lines.open(&format!("inline {result} {name}({params}) {{"));
        match body.split_last() {
            Some((Statement::Return { value: None }, others)) => self.block(others),
            _ => self.block(body),
        }
    }

    fn rules(&mut self, signature: &Signature, rules: &[Alternative]) {
        if let [rule] = rules {
            return self.alternative(&rule.body);
        }
        let inner = self.outcome(signature.result);
        let names = rule_names(rules, &signature.params);
        for (rule, name) in rules.iter().zip(&names) {
            self.lines.blank();
            self.lines.open(&format!("auto {name} = [&]() -> {inner} {{"));
            self.alternative(&rule.body);
            self.lines.close("};");
        }
        self.lines.blank();
        if let Some((last, others)) = names.split_last() {
            for name in others {
                self.lines.line(&match signature.result {
                    Some(_) => format!("if (auto result = {name}()) return result;"),
                    None => format!("if ({name}()) return true;"),
                });
            }
            self.lines.line(&format!("return {last}();"));
        }
    }

    fn alternative(&mut self, body: &[Statement]) {
        self.lines.line("// 1. Collect: nothing is written before all of this has passed.");
        self.block(body);
        if matches!(body.last(), Some(Statement::Attempt { .. })) {
            self.lines.line(self.refusal);
        }
    }

    /// The steps run through a journal, so that they can be undone.
    fn steps(
        &mut self,
        signature: &Signature,
        requires: &[Statement],
        level: diagram::Level,
        steps: &[Statement],
    ) {
        self.block(requires);
        if !self.is_noted {
            let mesh = if self.style.is_member() { "*this" } else { "mesh" };
            self.lines.line(&format!("hedgerow::Journal journal({mesh});"));
        }
        let (level, result) = (level.name(), self.outcome(signature.result));
        self.lines
            .open(&format!("return journal.whole(hedgerow::Level::{level}, [&]() -> {result} {{"));
        let outer = std::mem::replace(&mut self.is_noted, true);
        self.block(steps);
        self.is_noted = outer;
        self.lines.close("});");
    }

    /// The type that an operation returns.
    pub fn outcome(&self, result: Option<Type>) -> String {
        result.map_or("bool".into(), |ty| format!("std::optional<{}>", self.ty(ty)))
    }

    pub fn ty(&self, ty: Type) -> String {
        match ty {
            Type::Bool => "bool".into(),
            Type::Int => "long long".into(),
            Type::Real => self.style.name("real").into(),
            Type::Vec3 => self.style.name("Vector").into(),
            Type::Vec2 => self.style.value("Vector2"),
            Type::Vec4 => self.style.value("Vector4"),
            Type::Mat3 => self.style.value("Matrix3"),
            Type::Mat4 => self.style.value("Matrix4"),
            // Nothing of this type is built.
            Type::Text => "auto".into(),
            Type::Vertex | Type::Halfedge | Type::Edge | Type::Face => match self.is_outside {
                true => self.style.qualified(&format!("{ty:?}")),
                false => self.style.name(&format!("{ty:?}")).into(),
            },
        }
    }

    /// A call of a support function.
    pub fn support(&self, name: &str, args: Vec<String>) -> String {
        format!("hedgerow::{name}({})", args.join(", "))
    }
}

/// A text in an include guard, so that several emitted files can be combined.
fn once(name: &str, text: &str) -> String {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
    // Names that differ only in case are distinct.
    let guard = format!("HEDGEROW_{}", words.join("_"));
    format!("\n#ifndef {guard}\n#define {guard}\n{text}\n#endif\n")
}
