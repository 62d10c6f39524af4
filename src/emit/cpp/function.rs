//! A routine as C++: the classic function over a pointer-based halfedge mesh.

use std::collections::BTreeSet;

use super::super::conventions::Conventions;
use super::super::language::{Level, spell};
use super::super::lines::{Lines, comment};
use super::super::names::invoked;
use super::super::routine::{Helper, Routine, Signature, Statement};
use super::super::steps::{Item, Items, items};
use super::super::support::CPP;
use super::super::term::{Attribute, Parameter, Term};
use super::super::{NotEmitted, Selection};
use super::style::Style;
use super::support;
use crate::diagram::Type;
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
        kept: &style.kept(),
    };
    let Items { called, mut ops } = items(selection, conventions)?;
    let mut printer = Printer {
        style,
        lines: Lines::new(2),
        fields: BTreeSet::new(),
        refusal: "",
        is_outside: false,
        is_noted: false,
        preview: None,
    };
    let outside = called.iter().map(|(home, item)| printer.called(home, item));
    let outside = outside.collect::<String>();
    let alone = ops.len() == 1;
    for (at, op) in ops.iter_mut().enumerate() {
        if at > 0 {
            printer.lines.line("");
        }
        match op {
            Item::Function(_) => {}
            Item::Drawn(routine) => {
                if style.gives_back() {
                    let bodies = routine.rules.iter_mut().map(|rule| &mut rule.body);
                    routine.signature.give_back(bodies);
                }
                printer.routine(routine, alone);
            }
            Item::Steps(whole) => {
                if style.gives_back() {
                    whole.signature.give_back(std::iter::once(&mut whole.body));
                }
                printer.whole(whole, alone);
            }
        }
    }
    let body = std::mem::take(&mut printer.lines).finish();
    let needed = CPP.needed(&format!("{outside}{body}"), "hedgerow::");
    if let Some(why) = printer.is_blind(&outside, &needed) {
        let first = selection.ops.first().and_then(|&op| selection.program.ops.get(op));
        let span = first.map_or(Span::default(), |op| op.span);
        return Err(NotEmitted::because("this style", why, span));
    }
    Ok(printer.finish(&outside, &needed, &body))
}

pub(super) struct Printer<'s> {
    pub style: &'s Style,
    pub lines: Lines,
    /// The attributes that elements must have: "vertex: double weight".
    pub fields: BTreeSet<String>,
    /// The statement that leaves the current attempt.
    pub refusal: &'static str,
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
            true => format!("write `::{word}`, or where else a free function of it stands"),
            false => "elements have to lead to what the pattern wants by themselves".to_string(),
        };
        let advice = if word == "this" { "there is no `this`".to_string() } else { advice };
        Some(format!(
            "the pattern of `{pattern}` takes `{word}` from where it stands, and {whose}, beside the operations, does not know it: {advice}"
        ))
    }

    fn finish(self, outside: &str, needed: &[(&str, &str)], body: &str) -> String {
        let needed = needed.iter();
        let functions = needed
            .map(|(name, text)| once(name, &support::spelled(name, text, self.style)))
            .collect::<String>()
            + outside;
        let mut headers = BTreeSet::from(["optional"]);
        headers.extend(super::headers::headers(&functions));
        headers.extend(super::headers::headers(body));
        let headers: String =
            headers.iter().map(|header| format!("#include <{header}>\n")).collect();
        let fields = self.fields.iter();
        let fields = fields.map(|field| format!("//   {field}\n")).collect::<String>();
        let headers = match fields.is_empty() {
            true => headers,
            false => format!("// Elements have these attributes:\n{fields}\n{headers}"),
        };
        let include = self.style.include();
        let headers = match include.is_empty() {
            true => headers,
            false => format!("{include}\n{headers}"),
        };
        if functions.is_empty() {
            return format!("{headers}\n{body}");
        }
        // The functions that members call are local to the file.
        let (begin, end) = match self.style.is_member() {
            true => ("namespace {\n", "\n}  // namespace"),
            false => ("", ""),
        };
        format!(
            "{headers}\n{begin}namespace hedgerow {{\n{functions}\n}}  // namespace hedgerow{end}\n\n{body}"
        )
    }

    /// The text of a called function or operation, which comes from the file `home`.
    fn called(&mut self, home: &str, item: &Item) -> String {
        let outer = std::mem::replace(&mut self.lines, Lines::new(2));
        let name = match item {
            Item::Function(helper) => {
                self.helper(helper);
                &helper.name
            }
            Item::Drawn(routine) => {
                self.is_noted = true;
                self.routine(routine, false);
                &routine.signature.name
            }
            Item::Steps(whole) => {
                self.is_noted = true;
                self.whole(whole, false);
                &whole.signature.name
            }
        };
        self.is_noted = false;
        let text = std::mem::replace(&mut self.lines, outer).finish();
        let home = home.strip_suffix(".hedge").unwrap_or(home);
        once(&format!("{home}_{name}"), text.trim_end())
    }

    /// A function of the program.
    fn helper(&mut self, helper: &Helper) {
        self.is_outside = true;
        self.is_noted = helper.changes;
        self.refusal = "throw Refused();";
        self.docs(&helper.docs);
        let params = helper.params.iter();
        let params = params.map(|param| format!("{} {}", self.outer_type(param.ty), param.name));
        let journal = helper.changes.then(|| "Journal& journal".to_string());
        let params = journal.into_iter().chain(params);
        let params = params.collect::<Vec<_>>().join(", ");
        let result = helper.result.map(|ty| self.outer_type(ty));
        let (result, name) = (result.unwrap_or("void".into()), invoked(&helper.name));
        self.lines.open(&format!("inline {result} {name}({params}) {{"));
        match helper.body.split_last() {
            Some((Statement::Leave, others)) => self.block(others),
            _ => self.block(&helper.body),
        }
        self.lines.close("}");
        self.is_outside = false;
    }

    pub fn ty(&self, ty: Type) -> String {
        match ty {
            ty if self.is_outside && ty.is_element() => self.outer_type(ty),
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
            Type::Vertex => self.style.name("Vertex").into(),
            Type::Halfedge => self.style.name("Halfedge").into(),
            Type::Edge => self.style.name("Edge").into(),
            Type::Face => self.style.name("Face").into(),
        }
    }

    /// A type where the names of the mesh class are not in scope.
    pub fn outer_type(&self, ty: Type) -> String {
        match ty {
            Type::Vertex => self.style.qualified("Vertex"),
            Type::Halfedge => self.style.qualified("Halfedge"),
            Type::Edge => self.style.qualified("Edge"),
            Type::Face => self.style.qualified("Face"),
            ty => self.ty(ty),
        }
    }

    fn routine(&mut self, routine: &Routine, alone: bool) {
        self.docs(&routine.signature.docs);
        self.docs_of_defaults(&routine.signature.params);
        // Unused parameters have no name, since C++ compilers warn about them.
        let (mut used, mut allocates) = (BTreeSet::new(), false);
        for statement in routine.rules.iter().flat_map(|rule| &rule.body) {
            statement.names(&mut |name| _ = used.insert(name.to_string()));
            allocates |= statement.changes_the_lists();
        }
        // Writes are noted; an operation without writes is too rare to be a special case.
        allocates |= self.is_noted;
        if allocates {
            used.insert("mesh".to_string());
        }
        let several = routine.signature.result.filter(|_| routine.rules.len() > 1);
        let mut seen: Vec<_> = several.into_iter().collect();
        for rule in &routine.rules {
            rule.body.iter().for_each(|statement| statement.types(&mut |ty| seen.push(ty)));
        }
        self.head(&routine.signature, alone, &used, &seen);
        match routine.rules.as_slice() {
            [rule] => self.alternative(&rule.body, routine),
            rules => {
                let inner = match routine.signature.result {
                    Some(ty) => format!("std::optional<{}>", self.ty(ty)),
                    None => "bool".into(),
                };
                let mut names = Vec::new();
                for (at, rule) in rules.iter().enumerate() {
                    let label = rule.label.clone();
                    let name = label.map_or_else(
                        || format!("rule_{}", at + 1),
                        |label| format!("rule_{label}"),
                    );
                    let mut name = name.replace('\'', "_");
                    while routine.signature.params.iter().any(|param| param.name == name) {
                        name.push('_');
                    }
                    self.lines.blank();
                    self.lines.open(&format!("auto {name} = [&]() -> {inner} {{"));
                    self.alternative(&rule.body, routine);
                    self.lines.close("};");
                    names.push(name);
                }
                self.lines.blank();
                if let Some((last, others)) = names.split_last() {
                    for name in others {
                        self.lines.line(&match routine.signature.result {
                            Some(_) => format!("if (auto result = {name}()) return result;"),
                            None => format!("if ({name}()) return true;"),
                        });
                    }
                    self.lines.line(&format!("return {last}();"));
                }
            }
        }
        self.lines.close("}");
    }

    /// Writes a doc comment.
    pub fn docs(&mut self, docs: &[String]) {
        for line in docs {
            self.lines.line(&comment("///", line));
        }
    }

    /// The index of the first parameter whose default is in the signature: such parameters have to
    /// be last there, and the definition of a member of a class has none.
    fn first_default(&self, params: &[Parameter]) -> usize {
        let constant = params.iter().rev().take_while(|param| param.has_constant());
        match self.is_noted || self.style.is_member() || self.style.fixes_defaults() {
            true => params.len(),
            false => params.len() - constant.count(),
        }
    }

    /// Writes a doc comment with the defaults that are not in the signature.
    pub(super) fn docs_of_defaults(&mut self, params: &[Parameter]) {
        let first = self.first_default(params);
        let told: Vec<_> = params[..first]
            .iter()
            .filter_map(|param| {
                if self.is_fixed(param) {
                    return None;
                }
                let default = self.text(param.default.as_ref()?);
                Some(format!("`{} = {default}`", param.name))
            })
            .collect();
        if !told.is_empty() && !self.is_noted {
            let told = told.join(", ");
            self.lines.line(&format!("/// By default {told}."));
        }
    }

    /// The first lines of an operation: its signature, and aliases for the types that it uses.
    pub(super) fn head(
        &mut self,
        head: &Signature,
        alone: bool,
        used: &BTreeSet<String>,
        seen: &[Type],
    ) {
        let mesh = self.style.name("mesh").to_string();
        let result = match head.result {
            Some(ty) => format!("std::optional<{}>", self.outer_type(ty)),
            None => "bool".into(),
        };
        let other = self.style.name("function");
        let name = match self.style.function(&head.declared) {
            Some(name) if !self.is_noted => name.to_string(),
            _ if alone && !other.is_empty() => other.to_string(),
            _ => head.name.to_string(),
        };
        let member = self.style.is_member() && !self.is_noted;
        let first = self.first_default(&head.params);
        let (taken, fixed): (Vec<_>, Vec<_>) =
            head.params.iter().partition(|param| !self.is_fixed(param));
        let mut params = Vec::new();
        for (at, param) in taken.into_iter().enumerate() {
            let ty = match member {
                true => self.ty(param.ty),
                false => self.outer_type(param.ty),
            };
            let mut text = match used.contains(&param.name) {
                true => format!("{ty} {}", param.name),
                false => format!("{ty} /*{}*/", param.name),
            };
            if let Some(default) = param.default.as_ref().filter(|_| at >= first) {
                text = format!("{text} = {}", self.text(default));
            }
            params.push(text);
        }
        let (result, name) = match (self.is_noted, member) {
            (true, _) => {
                params.insert(0, "Journal& journal".into());
                (format!("inline {result}"), invoked(&name))
            }
            (false, true) => (result, format!("{mesh}::{name}")),
            (false, false) => {
                params.insert(
                    0,
                    match used.contains("mesh") {
                        true => format!("{mesh}& mesh"),
                        false => format!("{mesh}& /*mesh*/"),
                    },
                );
                (result, name)
            }
        };
        let inline = if self.style.is_inline() && !self.is_noted { "inline " } else { "" };
        self.lines.open(&format!("{inline}{result} {name}({}) {{", params.join(", ")));
        if member {
            self.fixed(&fixed, used);
            return;
        }
        let seen: BTreeSet<_> = seen.iter().map(|&ty| self.ty(ty)).collect();
        let aliases = ["Vertex", "Halfedge", "Edge", "Face"].into_iter();
        let aliases = aliases
            .filter(|name| seen.contains(self.style.name(name)) && self.style.is_nested(name));
        let aliases: Vec<_> = aliases
            .map(|name| {
                let (short, long) = (self.style.name(name), self.style.qualified(name));
                format!("using {short} = {long};")
            })
            .collect();
        for alias in &aliases {
            self.lines.line(alias);
        }
        if !aliases.is_empty() {
            self.lines.blank();
        }
        self.fixed(&fixed, used);
    }

    /// True if a parameter always has its default value.
    fn is_fixed(&self, param: &Parameter) -> bool {
        self.style.fixes_defaults() && !self.is_noted && param.default.is_some()
    }

    /// Defines the parameters that always have their default value, as far as they are used.
    fn fixed(&mut self, params: &[&Parameter], used: &BTreeSet<String>) {
        // A default may use an earlier parameter.
        let mut used = used.clone();
        let mut kept = Vec::new();
        for param in params.iter().rev() {
            if used.contains(&param.name)
                && let Some(default) = &param.default
            {
                default.names(&mut |name| _ = used.insert(name.to_string()));
                kept.push((param.name.clone(), param.ty, default));
            }
        }
        for (name, ty, default) in kept.into_iter().rev() {
            let (ty, value) = (self.ty(ty), self.text(default));
            self.lines.line(&format!("const {ty} {name} = {value};"));
        }
    }

    fn alternative(&mut self, body: &[Statement], routine: &Routine) {
        self.refusal = match routine.signature.result {
            Some(_) => "return std::nullopt;",
            None => "return false;",
        };
        let last = self.refusal;
        self.lines.line("// 1. Collect: nothing is written before all of this has passed.");
        self.block(body);
        if matches!(body.last(), Some(Statement::Attempt { .. })) {
            self.lines.line(last);
        }
    }

    /// An attribute of an element, to be read or set.
    pub fn field(&mut self, attribute: &Attribute, of: &str) -> String {
        let (element, ty) = (attribute.element.word(), self.ty(attribute.ty));
        let field = format!("{element}: {ty} {}", attribute.name);
        self.fields.insert(field);
        self.style.attribute(of, &attribute.name)
    }

    pub fn text(&mut self, term: &Term) -> String {
        spell(self, term).text
    }

    pub fn spelled_whole(&mut self, term: &Term) -> String {
        spell(self, term).at(Level::Whole)
    }

    /// A call of a support function.
    pub fn support(&mut self, name: &str, args: Vec<String>) -> String {
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
