//! Translation of a proved operation to a routine: its four phases, rule by rule.

use std::collections::BTreeSet;

use super::item::{Alternative, Item, ItemBody, Parameter, Signature, parameters};
use super::items::Source;
use super::names::Names;
use super::routine::{Block, Field, Form, Statement, without_unread};
use super::value::Term;
use super::{NotEmitted, reassign};
use crate::check::Proved;
use crate::diagram::{Binary, Drawing, Expr, ExprKind, Kind, Rule, Type};
use crate::lower::{
    Begin, Condition, Element, ORDINARY, Operation, Step, Tries, Value, is_surely_finite, may_stop,
};

/// A proved operation as a routine, with its name in code.
pub(super) fn routine<'s>(
    source: &'s Source<'s>,
    name: &str,
    proved: &Proved,
) -> Result<Item, NotEmitted> {
    let op = proved.op();
    let mut signature = Signature::new(name, &op.name, &op.docs, op.result);
    let (mut needs, mut rules, mut attributes) = (BTreeSet::new(), Vec::new(), Vec::new());
    for (rule, proof) in op.rules.iter().zip(proved.proofs()) {
        let rule = proof.drawn(rule);
        let mut names = Names::new(source, op, rule);
        signature.params = parameters(&op.params, &mut names)?;
        let drawing = &Drawing::new(rule);
        let mut writer = Writer { drawing, names, body: Vec::new() };
        writer.alternative(&Operation::new(drawing, proof), source.selection.exhaustive)?;
        let Writer { names, mut body, .. } = writer;
        body.splice(0..0, names.columns(&source.seen_by(&names.needs), false));
        attributes.extend(names.used_attributes());
        needs.extend(names.needs);
        let label = rule.label.clone();
        rules.push(Alternative { label, body: without_unread(body, false) });
    }
    let outlives = |&(at, param): &(usize, &Parameter)| {
        let erased = |rule: &Rule| {
            let name = rule.params.get(at).copied().flatten();
            name.is_none_or(|name| rule.erased.iter().any(|erased| erased.name == name))
        };
        param.ty.is_element() && !op.rules.iter().any(erased)
    };
    let given = signature.params.iter().enumerate().find(outlives);
    signature.given = given.map(|(_, param)| param.clone());
    Ok(Item { signature, attributes, needs, body: ItemBody::Drawn(rules) })
}

/// The writer of one rule.
pub(super) struct Writer<'d, 's> {
    pub drawing: &'d Drawing<'d>,
    pub names: Names<'s>,
    /// The statements so far.
    pub body: Vec<Statement>,
}

impl Writer<'_, '_> {
    /// Makes something, inside of the repetition for each index if `repeated`.
    pub fn for_each<T>(&mut self, repeated: bool, make: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.names.is_indexed;
        self.names.is_indexed |= repeated;
        let made = make(self);
        self.names.is_indexed = outer;
        made
    }

    /// Binds a value, or if `each` the list of its values at each index.
    pub fn bind(&mut self, ty: Type, name: &str, value: &Term, each: bool) {
        self.body.push(self.names.bound(ty, name, value, each));
    }

    /// Refuses if a condition holds, or if `each` if it does for some index.
    pub fn refuse(&mut self, when: Term, each: bool, reason: &str) {
        let Names { language, indices, .. } = &self.names;
        let when = if each { language.for_some(indices, &when) } else { when };
        self.body.push(Statement::Refuse { when, reason: reason.to_string() });
    }

    /// Writes a whole rule. If `exhaustive`, pointers that do not change are set, too.
    fn alternative(&mut self, operation: &Operation, exhaustive: bool) -> Result<(), NotEmitted> {
        self.phases(operation, exhaustive)?;
        let steps = &operation.matching.steps;
        // From the last attempt outwards: each contains everything after it.
        let mut end = steps.len();
        for (at, step) in steps.iter().enumerate().rev() {
            let Step::Begin(begin) = step else { continue };
            let is_tried_once = match begin.tries {
                Tries::Some(1) => true,
                Tries::AllForValues => operation.values.iter().all(|set| refusal(set).is_none()),
                Tries::All | Tries::Some(_) => false,
            };
            if !is_tried_once {
                self.before(&steps[at + 1..end]);
                self.attempt(begin);
                end = at;
            }
        }
        self.before(&steps[..end]);
        Ok(())
    }

    /// Binds names before the statements so far.
    fn before(&mut self, steps: &[Step]) {
        let rest = std::mem::take(&mut self.body);
        self.steps(steps);
        self.body.extend(rest);
    }

    /// Attempts the statements so far with the halfedges of an element in turn.
    fn attempt(&mut self, begin: &Begin) {
        let halfedge = self.names.begin(begin.halfedge);
        let (language, word) = (self.names.language, self.names.word(begin.element));
        let (around, which) = match self.drawing.rule.kind(begin.element) {
            Kind::Edge => ("EdgeHalfedges", format!("Both directions of {word} are")),
            Kind::Vertex => ("VertexHalfedges", format!("Each halfedge that starts at {word} is")),
            _ => ("FaceHalfedges", format!("Each halfedge of {word} is")),
        };
        let first = format!("// {which} tried.");
        let all = language.call(around, [&Term::name(word)]);
        // The two of an edge are a list already.
        let all = if around == "EdgeHalfedges" { all } else { language.collected(&all) };
        let head = language.over(Type::Halfedge, &halfedge, &all);
        let (form, body) = (Form::Attempt, std::mem::take(&mut self.body));
        self.body.push(Statement::Block(Block { form, first, head, body, ..Block::default() }));
    }

    /// Writes what follows the binding of names: the tests, and phases 2 to 4.
    fn phases(&mut self, operation: &Operation, exhaustive: bool) -> Result<(), NotEmitted> {
        let rule = self.drawing.rule;
        self.empty_paths_and_tests(&operation.matching);
        for &Condition { condition, at_each_index: each, refusal } in &operation.requires {
            let condition = self.names.once(condition, each, Some(rule), &mut self.body)?;
            let mut parts = Vec::new();
            if each {
                parts.push(&condition)
            } else {
                conjuncts(&condition, &mut parts)
            }
            for part in parts {
                let holds = self.for_each(each, |this| this.names.value(part))?;
                self.refuse(holds.not(), each, refusal);
            }
        }
        self.guard(operation);
        let values = operation.values.iter().map(|value| self.value(value));
        let values = values.collect::<Result<Vec<_>, _>>()?;
        let allocation = allocation(&operation.created, &self.names);
        self.phase("2. Allocate what is new.", allocation);
        let mut sets = reassign::statements(self.drawing, &mut self.names, exhaustive);
        sets.extend(values);
        let which = match exhaustive {
            true => "3. Reassign every pointer, whether it changes or not.",
            false => "3. Reassign every pointer that changes.",
        };
        self.phase(which, sets);
        let erase = |&Element { name, kind, at_each_index: each }: &Element| {
            let element = self.for_each(each, |this| this.names.term(name));
            self.names.repeated(each, Statement::Erase { kind, element })
        };
        let erasures = operation.erased.iter().map(erase).collect();
        self.phase("4. Erase what is gone.", erasures);
        let value = operation.result.map(|name| self.names.term(name));
        self.body.push(Statement::Return { value });
        Ok(())
    }

    /// Adds the statements of a phase, unless there are none.
    fn phase(&mut self, comment: &str, statements: Vec<Statement>) {
        if !statements.is_empty() {
            self.body.extend([Statement::Blank, Statement::Comment(comment.into())]);
            self.body.extend(statements);
        }
    }

    /// Evaluates a right-hand side on the mesh before any change, and returns the statement that
    /// assigns it.
    fn value(&mut self, assigned: &Value) -> Result<Statement, NotEmitted> {
        let &Value { element, attribute, value, at_each_index: each, .. } = assigned;
        let attribute = self.names.accessed(attribute);
        let word = self.names.word(element).trim_end_matches('_');
        let called = attribute.as_ref().map_or("position", |it| &it.name);
        let name = self.names.fresh(&format!("{word}_{called}"));
        let value = self.names.once(value, each, Some(self.drawing.rule), &mut self.body)?;
        let item = self.for_each(each, |this| this.names.value(&value))?;
        let [of, value] = self.for_each(each, |this| {
            let value = if each { this.names.member(&name, 0) } else { Term::name(&name) };
            [this.names.term(element), value]
        });
        let ty = attribute.as_ref().map_or(Type::Vec3, |it| it.ty);
        let infinite = self.names.finite(&value).not();
        let reason = refusal(assigned);
        // The values behind an infinite one are not evaluated where that may stop.
        match reason.filter(|_| each && may_stop(assigned.value)) {
            Some(reason) => {
                let Names { language, indices, .. } = &self.names;
                let list = (&*language.ty(ty), &*name);
                let (empty, when) = language.gather_until(list, indices, [&item, &infinite]);
                self.body.extend([empty, Statement::Refuse { when, reason: reason.clone() }]);
            }
            None => {
                self.bind(ty, &name, &item, each);
                if let Some(reason) = reason {
                    self.refuse(infinite, each, reason);
                }
            }
        }
        let field = attribute.map_or(Field::Position, Field::Attribute);
        Ok(self.names.repeated(each, Statement::Set { field, of, value }))
    }
}

/// The statements that allocate everything new; a family is given by its first member.
pub(super) fn allocation(created: &[Element], names: &Names) -> Vec<Statement> {
    let allocate = |&Element { name, kind, at_each_index }: &Element| {
        let indices = at_each_index.then(|| names.indices.clone());
        Statement::New { kind, name: names.word(name).to_string(), indices }
    };
    created.iter().map(allocate).collect()
}

/// The conditions that an `and` joins; they are tested one by one, in the same order.
fn conjuncts<'e>(condition: &'e Expr, parts: &mut Vec<&'e Expr>) {
    match &condition.kind {
        ExprKind::Binary(Binary::And, left, right) => {
            conjuncts(left, parts);
            conjuncts(right, parts);
        }
        _ => parts.push(condition),
    }
}

/// The reason to refuse a new position, if it may be infinite.
fn refusal<'v>(assigned: &'v Value) -> Option<&'v String> {
    assigned.infinite.as_ref().filter(|_| !is_surely_finite(assigned.value, ORDINARY))
}
