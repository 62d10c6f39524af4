//! The statements of steps and of functions.

use std::collections::BTreeSet;

use super::super::NotEmitted;
use super::super::items::Source;
use super::super::language::Language;
use super::super::names::{Attribute, Names};
use super::super::routine::Statement;
use super::super::value::{Precedence, Term, bare};
use super::comments::comments;
use crate::diagram::{Access, Collection, Expr, ExprKind, Type};
use crate::lower::{Variables, is_surely_finite, may_stop};
use crate::resolve::{Block, Body, Statement as Step, StatementKind, Visit};
use crate::source::Span;

/// Writes the statements of one body.
pub(in crate::emit) struct Writer<'s> {
    pub source: &'s Source<'s>,
    pub body: &'s Body,
    pub names: Names<'s>,
    /// The statements of the current block so far.
    pub out: Vec<Statement>,
    /// True if the body is that of a function, not of an operation.
    pub is_function: bool,
    /// The variables that are bound so far: the first ones are parameters.
    pub bound: BTreeSet<u32>,
    pub variables: Variables,
    /// The lists of the writes that an `update` defers.
    pub held: Vec<(Access, String)>,
}

impl<'s> Writer<'s> {
    /// Runs `write`; the words that it takes are free again afterwards.
    pub fn scope<T>(&mut self, write: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.names.taken.clone();
        let written = write(self);
        self.names.taken = outer;
        written
    }

    pub fn block(&mut self, block: &'s Block) -> Result<Vec<Statement>, NotEmitted> {
        let outer = std::mem::take(&mut self.out);
        let written = self.scope(|this| {
            block.iter().try_for_each(|statement| {
                let lines = comments(this.source.selection.sources, statement.span);
                this.out.extend(lines.into_iter().map(Statement::Comment));
                this.statement(statement)
            })
        });
        let inner = std::mem::replace(&mut self.out, outer);
        written.map(|()| inner)
    }

    pub fn statement(&mut self, statement: &'s Step) -> Result<(), NotEmitted> {
        let (span, language) = (statement.span, self.names.language);
        let written = match &statement.kind {
            StatementKind::Set { variable, value } => return self.set(*variable, value),
            StatementKind::Write { target, attribute, value } => {
                return self.write_to(target, *attribute, value);
            }
            StatementKind::Repeat { count, body } => {
                let count = self.names.value(count)?;
                self.scope(|this| {
                    let (i, number) = (this.names.fresh("i"), &count.text);
                    let head = say!(
                        language,
                        "for _ in 0..{number}",
                        "for (long long {i} = {number}; {i} > 0; --{i})"
                    );
                    let head = Term::of(head, Precedence::Choice, [&count]);
                    Ok(Statement::block(head, this.block(body)?))
                })?
            }
            StatementKind::While { condition, body } if self.changing_call(condition).is_some() => {
                let inner = self.scope(|this| {
                    let outer = std::mem::take(&mut this.out);
                    let ends = this.condition(condition).map(Term::not);
                    let mut inner = std::mem::replace(&mut this.out, outer);
                    let end = Statement::lines("break;".into(), &[]);
                    inner.push(language.choose(&ends?, vec![end], Vec::new()));
                    inner.extend(this.block(body)?);
                    Ok(inner)
                })?;
                let head = say!(language, "loop", "while (true)");
                Statement::block(Term::whole(head), inner)
            }
            StatementKind::While { condition, body } => {
                let condition = self.names.value(condition)?;
                Statement::block(language.head("while", &condition), self.block(body)?)
            }
            StatementKind::For { variable, collection, filter, body, visit, parallel: false }
                if *visit != Visit::Shuffled =>
            {
                if *visit == Visit::Update {
                    self.hold(body);
                }
                let visited = self.visit((*variable, collection), filter.as_ref(), body, span)?;
                self.out.push(visited);
                for (access, list) in std::mem::take(&mut self.held) {
                    let attribute = self.names.accessed(access);
                    self.out.push(release(language, &list, attribute.as_ref()));
                }
                return Ok(());
            }
            StatementKind::If { condition, then, otherwise }
                if self.is_function
                    && let (Some(then), Some(other)) =
                        (self.value(then), self.value(otherwise)) =>
            {
                let [condition, chosen, other] =
                    [condition, then, other].map(|part| Box::new(part.clone()));
                let kind = ExprKind::If(condition, chosen, other);
                return self.leave(Some(&Expr { ty: then.ty, span, kind }));
            }
            StatementKind::If { condition, then, otherwise } => {
                let condition = self.condition(condition)?;
                let (then, otherwise) = (self.block(then)?, self.block(otherwise)?);
                language.choose(&condition, then, otherwise)
            }
            StatementKind::Apply { op, args, variable, then, otherwise } => {
                return self.apply((*op, args), *variable, [then, otherwise]);
            }
            StatementKind::Require { condition, reason } => Statement::Refuse {
                when: self.names.value(condition)?.not(),
                reason: reason.clone(),
            },
            StatementKind::Break => Statement::lines("break;".into(), &[]),
            StatementKind::Continue => Statement::lines("continue;".into(), &[]),
            StatementKind::Return(value) => return self.leave(value.as_ref()),
            StatementKind::Call { function, args, .. }
                if (*function as usize) < self.source.selection.program.functions.len() =>
            {
                let call = self.function(*function, args)?;
                self.put(None, &call);
                return Ok(());
            }
            kind => return Err(NotEmitted::new(not_emitted(kind), span)),
        };
        self.out.push(written);
        Ok(())
    }

    /// The value of a block that only computes one.
    fn value<'b>(&self, block: &'b Block) -> Option<&'b Expr> {
        match block.as_slice() {
            [Step { kind: StatementKind::Return(Some(value)), .. }] => {
                self.changing_call(value).is_none().then_some(value)
            }
            _ => None,
        }
    }

    /// The term of a condition, which may be a call that changes the mesh.
    fn condition(&mut self, condition: &Expr) -> Result<Term, NotEmitted> {
        match self.changing_call(condition) {
            Some((function, args)) => self.function(function, args),
            None => self.names.value(condition),
        }
    }

    /// The term of a value, after binding the parts of it that have the same value each time.
    fn computed(&mut self, value: &Expr) -> Result<Term, NotEmitted> {
        let value = self.names.once(value, false, None, &mut self.out)?;
        self.names.value(&value)
    }

    /// Names a variable.
    pub fn bind(&mut self, variable: u32) -> (String, Type) {
        let known = self.body.variables.get(variable as usize);
        let wanted = known.map_or("x", |variable| variable.name.as_str());
        self.bound.insert(variable);
        (self.names.bind(variable, wanted), known.map_or(Type::Int, |variable| variable.ty))
    }

    /// The assignment of a value to a variable; `None` if that is never read.
    pub fn assigned(&mut self, variable: u32, value: &Term) -> Option<Statement> {
        if !self.variables.reads(variable) {
            return None;
        }
        let language = self.names.language;
        let (text, plain) = (&value.text, bare(&value.text));
        if self.bound.contains(&variable) {
            let name = self.names.local(variable);
            let text = say!(language, "{name} = {plain};", "{name} = {text};");
            return Some(Statement::lines(text, [value, &Term::name(name)]));
        }
        let (name, of) = self.bind(variable);
        let (ty, is_changed) = (language.ty(of), self.variables.sets(variable) > 1);
        // The type of a plain number would be ambiguous in Rust.
        let told = match of {
            Type::Int | Type::Real if text.parse::<f64>().is_ok() => format!("{name}: {ty}"),
            _ => name.clone(),
        };
        let told = if is_changed { format!("mut {told}") } else { told };
        let text = say!(language, "let {told} = {plain};", "{ty} {name} = {text};");
        Some(Statement::lines(text, [value]))
    }

    fn set(&mut self, variable: u32, value: &Expr) -> Result<(), NotEmitted> {
        if let Some((function, args)) = self.changing_call(value) {
            let call = self.function(function, args)?;
            self.put(Some(variable), &call);
            return Ok(());
        }
        // Computed first, since the value cannot refer to a new variable.
        let term = self.computed(value)?;
        let assigned = self.assigned(variable, &term);
        // What nothing reads is computed where that may stop a run.
        let alone = || {
            let plain = bare(&term.text);
            let text = say!(self.names.language, "let _ = {plain};", "static_cast<void>({plain});");
            Statement::lines(text, [&term])
        };
        self.out.extend(assigned.or_else(|| may_stop(value).then(alone)));
        Ok(())
    }

    /// Makes lists for the writes of an `update`, which are deferred to its end.
    fn hold(&mut self, body: &Block) {
        let language = self.names.language;
        let mut note = |statement: &Step| {
            let StatementKind::Write { target, attribute: access, value } = &statement.kind else {
                return;
            };
            if self.held.iter().any(|(held, _)| held == access) {
                return;
            }
            let attribute = self.names.accessed(*access);
            let word = attribute.as_ref().map_or("position", |it| &it.declared);
            let list = self.names.fresh(&format!("{}s", word.replace('\'', "_")));
            let (element, ty) = (language.ty(target.ty), language.ty(value.ty));
            let line = say!(
                language,
                "let mut {list} = Vec::new();",
                "std::vector<std::pair<{element}, {ty}>> {list};"
            );
            self.out.push(Statement::lines(line, []));
            self.held.push((*access, list));
        };
        body.iter().for_each(|statement| statement.each(&mut note));
    }

    fn write_to(
        &mut self,
        target: &Expr,
        attribute: Access,
        value: &Expr,
    ) -> Result<(), NotEmitted> {
        let language = self.names.language;
        let (of, term) = (self.names.value(target)?, self.names.value(value)?);
        let written = if let Some((_, list)) = self.held.iter().find(|held| held.0 == attribute) {
            let (element, plain) = (&of.text, bare(&term.text));
            let line = say!(
                language,
                "{list}.push(({element}, {plain}));",
                "{list}.emplace_back({element}, {plain});"
            );
            Statement::lines(line, [&of, &term])
        } else if let Access::Declared(number) = attribute {
            let attribute = self.names.attribute(number);
            let attribute = attribute.ok_or_else(|| NotEmitted::new("an attribute", value.span))?;
            let [of, term] = self.scope(|this| {
                let element = this.settled((target, of), target.ty.word());
                [element, this.settled((value, term), &attribute.name)]
            });
            Statement::lines(language.write(Some(&attribute), &of, &term.text), [&of, &term])
        } else {
            let is_finite = is_surely_finite(value, f64::INFINITY);
            let checked = checked(language, is_finite, &term.text);
            Statement::lines(language.write(None, &of, &checked), [&of, &term])
        };
        self.out.push(written);
        Ok(())
    }

    fn visit(
        &mut self,
        (variable, collection): (u32, &'s Collection),
        filter: Option<&'s Expr>,
        body: &'s Block,
        span: Span,
    ) -> Result<Statement, NotEmitted> {
        let language = self.names.language;
        let all = self.names.around(collection, span)?;
        let may_go = self.source.effects.erases(body, collection.element());
        self.scope(|this| {
            let (name, ty) = this.bind(variable);
            let word = ty.word();
            let gone = say!(language, "!mesh.{word}_alive({name})", "!journal.lives({name})");
            let filter = filter.map(|filter| this.names.value(filter)).transpose()?;
            let hole = (ty == Type::Face).then(|| language.call("IsHole", &[Term::name(&name)]));
            let gone = [Some(Term::whole(gone)), hole].into_iter().flatten().filter(|_| may_go);
            let skipped = gone.chain(filter.map(Term::not)).reduce(Term::or);
            let mut inner = Vec::new();
            if let Some(skipped) = skipped {
                let next = Statement::lines("continue;".into(), &[]);
                inner.push(language.choose(&skipped, vec![next], Vec::new()));
            }
            inner.extend(this.block(body)?);
            Ok(Statement::block(language.over(ty, &name, &language.collected(&all)), inner))
        })
    }

    fn leave(&mut self, value: Option<&Expr>) -> Result<(), NotEmitted> {
        let value = value.map(|value| match self.changing_call(value) {
            None => self.computed(value),
            Some((function, args)) => {
                let given = self.function(function, args)?;
                let name = self.names.fresh("result");
                self.out.push(self.names.bound(value.ty, &name, &given, false));
                Ok(Term::name(&name))
            }
        });
        self.out.push(Statement::Return { value: value.transpose()? });
        Ok(())
    }
}

/// The loop that performs the deferred writes of a list to an attribute, or to positions.
fn release(language: Language<'_>, list: &str, attribute: Option<&Attribute>) -> Statement {
    let head = say!(
        language,
        "for (element, value) in {list}",
        "for (const auto& [element, value] : {list})"
    );
    let value = checked(language, attribute.is_some(), "value");
    let text = language.write(attribute, &Term::whole("element"), &value);
    Statement::lines(language.held(&head, &text), [])
}

/// A position that is written; in Rust with a refusal unless it is finite.
fn checked(language: Language<'_>, is_finite: bool, value: &str) -> String {
    if is_finite || !language.is_rust() { value.to_string() } else { format!("finite({value})?") }
}

/// A statement that is not emitted, in words.
fn not_emitted(kind: &StatementKind) -> &'static str {
    match kind {
        StatementKind::For { visit: Visit::Shuffled, .. } => "a random order",
        StatementKind::For { .. } => "`parallel for`",
        StatementKind::Call { .. } => "the call of a script",
        StatementKind::Drain { .. } => "a `drain`",
        StatementKind::Print(_) => "a `print`",
        StatementKind::Assert { .. } => "an `assert`",
        _ => "a statement of a test",
    }
}
