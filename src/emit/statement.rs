//! Statements that are the same text wherever they stand.

use std::collections::BTreeSet;

use super::language::{Language, WIDTH};
use super::names::{Attribute, IndexLoop, Names};
use super::print::packed;
use super::routine::{Block, Form, Statement};
use super::value::{Precedence, Term};
use crate::diagram::{Level, Type};

impl Language<'_> {
    /// The binding of a value of a type, or of a list of such values.
    pub fn bind(self, (ty, is_list): (Type, bool), name: &str, value: &Term) -> Statement {
        let (ty, text) = (self.ty(ty), &value.text);
        let ty = if is_list { format!("std::vector<{ty}>") } else { ty };
        let text = say!(self, "let {name} = {text};", "{ty} {name} = {text};");
        Statement::binding(name, text, [value])
    }

    /// The binding of a list that can grow.
    pub fn list(self, ty: Type, name: &str, items: &[Term]) -> Statement {
        let texts: Vec<_> = items.iter().map(|item| item.text.as_str()).collect();
        let (ty, texts) = (self.ty(ty), texts.join(", "));
        let text = match texts.as_str() {
            "" => {
                say!(self, "let mut {name}: Vec<{ty}> = Vec::new();", "std::vector<{ty}> {name};")
            }
            texts => say!(
                self,
                "let mut {name}: Vec<{ty}> = vec![{texts}];",
                "std::vector<{ty}> {name} = {{{texts}}};"
            ),
        };
        Statement::lines(text, items)
    }

    /// An addition to a list.
    pub fn push(self, list: &str, item: &Term) -> Statement {
        let text = &item.text;
        let text = say!(self, "{list}.push({text});", "{list}.push_back({text});");
        Statement::lines(text, [item, &Term::name(list)])
    }

    /// The binding of the length of a list.
    pub fn size(self, name: &str, list: &str) -> Statement {
        let text = say!(self, "let {name} = {list}.len();", "std::size_t {name} = {list}.size();");
        Statement::binding(name, text, [&Term::name(list)])
    }

    /// The binding of a list of one item for each index; `ty` is the name of its type.
    pub fn gather(self, ty: &str, name: &str, indices: &IndexLoop, item: &Term) -> Statement {
        let text = &item.text;
        let IndexLoop { index, size } = indices;
        let index = if item.names.contains(index) { index } else { "_" };
        let text = match self.style {
            None => format!("let {name}: Vec<{ty}> = (0..{size}).map(|{index}| {text}).collect();"),
            Some(_) => {
                let push = format!("{name}.push_back({text});");
                let all = self.held(&self.each_index(indices).text, &push);
                format!("std::vector<{ty}> {name};\n{all}")
            }
        };
        Statement::binding(name, text, [item, &Term::name(size)])
    }

    /// The binding of an empty list, and the condition that of the items that are then added, one for
    /// each index in turn, one meets a condition: those behind it are not evaluated.
    pub fn gather_until(
        self,
        (ty, name): (&str, &str),
        IndexLoop { index, size }: &IndexLoop,
        [item, condition]: [&Term; 2],
    ) -> (Statement, Term) {
        let empty =
            say!(self, "let mut {name}: Vec<{ty}> = Vec::new();", "std::vector<{ty}> {name};");
        let (item_text, condition_text) = (&item.text, &condition.text);
        let text = say!(
            self,
            "(0..{size}).any(|{index}| {{ {name}.push({item_text}); {condition_text} }})",
            "hedgerow::some({size}, [&](std::size_t {index}) {{ {name}.push_back({item_text}); \
             return {condition_text}; }})"
        );
        let names = [item, condition, &Term::name(size), &Term::name(name)];
        (Statement::binding(name, empty, []), Term::of(text, Precedence::Whole, names))
    }

    /// The head of a loop over the indices.
    fn each_index(self, IndexLoop { index, size }: &IndexLoop) -> Term {
        let text = say!(
            self,
            "for {index} in 0..{size}",
            "for (std::size_t {index} = 0; {index} < {size}; ++{index})"
        );
        Term::of(text, Precedence::Choice, [&Term::name(size)])
    }

    /// A loop over the indices.
    pub fn index_loop(self, indices: &IndexLoop, body: Vec<Statement>) -> Statement {
        Statement::block(self.each_index(indices), body)
    }

    /// A list of elements: in Rust of an iterator.
    pub fn collected(self, all: &Term) -> Term {
        let text = &all.text;
        Term::of(say!(self, "{text}.collect::<Vec<_>>()", "{text}"), Precedence::Whole, [all])
    }

    /// The head of a loop over a list of elements of a type.
    pub fn over(self, ty: Type, name: &str, list: &Term) -> Term {
        let (ty, text) = (self.ty(ty), &list.text);
        let text = say!(self, "for {name} in {text}", "for ({ty} {name} : {text})");
        Term::of(text, Precedence::Choice, [list])
    }

    /// The head of an `if` or a `while`.
    pub fn head(self, word: &str, condition: &Term) -> Term {
        let test = &condition.text;
        Term::of(say!(self, "{word} {test}", "{word} ({test})"), Precedence::Choice, [condition])
    }

    /// The test before a step that the mesh has a level.
    pub fn expect(self, level: Level) -> String {
        let name = level.name();
        say!(
            self,
            "expect_level(mesh, Level::{level:?});",
            "journal.expect(hedgerow::Level::{name});"
        )
    }

    /// Branches for whether a condition holds.
    pub fn choose(
        self,
        condition: &Term,
        body: Vec<Statement>,
        otherwise: Vec<Statement>,
    ) -> Statement {
        let (form, head) = (Form::Branch, self.head("if", condition));
        Statement::Block(Block { form, head, body, otherwise, ..Block::default() })
    }

    /// Notes elements in the journal, on as many lines as needed.
    pub fn keep(self, elements: &[Term]) -> Statement {
        let texts = elements.iter().map(|element| element.text.as_str());
        let lines = packed(texts, ", ", WIDTH - 14).into_iter();
        let lines = lines.map(|line| format!("journal.keep({line});\n"));
        Statement::lines(lines.collect(), elements)
    }

    /// Notes the value of an attribute that will be written to in the journal.
    pub fn keep_attribute(self, attribute: &Attribute, element: &Term) -> String {
        let of = element.at(Precedence::Whole);
        let was = self.attribute(attribute, element).text;
        let (capture, name) = match &element.root {
            Some(name) if *name == element.text => (name.clone(), name.as_str()),
            _ => (format!("at = {of}"), "at"),
        };
        let back = self.attribute(attribute, &Term::name(name)).text;
        format!("journal.undone_by([{capture}, was = {was}] {{ {back} = was; }});")
    }

    /// `of.attribute = value`
    pub fn set_attribute(self, attribute: &Attribute, of: &Term, value: &str) -> String {
        match self.style {
            None => format!("set_attribute(mesh, {}, {}.0, {value});", attribute.column, of.text),
            Some(_) => format!("{} = {value};", self.attribute(attribute, of).text),
        }
    }

    /// The same so that it can be undone; without an attribute, of a position.
    pub fn write(self, attribute: Option<&Attribute>, of: &Term, value: &str) -> String {
        let Some(attribute) = attribute else {
            let mesh = if self.is_rust() { "mesh" } else { "journal" };
            return format!("{mesh}.set_position({}, {value});", of.text);
        };
        let set = self.set_attribute(attribute, of, value);
        if self.is_rust() { set } else { format!("{}\n{set}", self.keep_attribute(attribute, of)) }
    }
}

impl Names<'_> {
    /// The statement that binds a value, or if `each` the list of its values at each index.
    pub fn bound(&self, ty: Type, name: &str, value: &Term, each: bool) -> Statement {
        let language = self.language;
        match each {
            true => language.gather(&language.ty(ty), name, &self.indices, value),
            false => language.bind((ty, false), name, value),
        }
    }

    /// A statement, if `each` repeated for each index.
    pub fn repeated(&self, each: bool, statement: Statement) -> Statement {
        if each { self.language.index_loop(&self.indices, vec![statement]) } else { statement }
    }

    /// Finds the columns of the attributes that are used, and refuses a mesh without these, and
    /// without the others in `seen`, which the called functions look at. The caller of a function,
    /// `is_asked`, has done so already.
    pub fn columns(&self, seen: &BTreeSet<u32>, is_asked: bool) -> Vec<Statement> {
        let mut lines = Vec::new();
        if !self.language.is_rust() {
            return lines;
        }
        let is_used = |number: &&u32| self.used.contains(number);
        for number in self.used.iter().chain(seen.iter().filter(|number| !is_used(number))) {
            let attribute = self.attributes.get(*number as usize);
            let Some(Attribute { declared, column, element, ty, .. }) = attribute else { continue };
            let ty = self.language.ty(*ty);
            let found = format!("mesh.find_column(ElementKind::{element:?}, \"{declared}\")");
            if is_used(&number) && is_asked {
                let line = format!("let {column} = {found}.expect(\"the caller has found it\");");
                lines.push(Statement::lines(line, []));
                continue;
            }
            let (head, end) = match is_used(&number) {
                true => {
                    lines.push(Statement::lines(format!("let {column} = {found};"), []));
                    let is_there = format!("filter(|&c| mesh.values::<{ty}>(c).is_some())");
                    (format!("let Some({column}) = {column}.{is_there} else {{"), "};")
                }
                false => {
                    let values = format!("and_then(|c| mesh.values::<{ty}>(c))");
                    (format!("if {found}.{values}.is_none() {{"), "}")
                }
            };
            let reason = format!("the mesh has no attribute `{declared}` of this type");
            lines.push(Statement::RefuseIn { head: Term::whole(head), reason, end });
        }
        lines
    }
}
