//! Calls in steps: of operations, and of functions that change the mesh.

use super::super::NotEmitted;
use super::super::cpp::CALLED;
use super::super::item::Need;
use super::super::routine::{Block, Statement};
use super::super::value::{Precedence, Term, is_plain};
use super::body::Writer;
use crate::diagram::{Expr, ExprKind, Param};
use crate::resolve::{self, Statement as Step, StatementKind};

impl<'s> Writer<'s> {
    /// The call of a function that changes the mesh or may refuse, if the value is one.
    pub fn changing_call<'e>(&self, value: &'e Expr) -> Option<(u32, &'e [Expr])> {
        match &value.kind {
            ExprKind::Invoke(function, args) => {
                let effects = self.source.effects.function(*function)?;
                (effects.changes || effects.refuses).then_some((*function, args))
            }
            _ => None,
        }
    }

    /// A value that can be passed beside the mesh in a call: where the mesh is borrowed, a value
    /// that reads it is bound to a name before.
    pub fn settled(&mut self, (value, term): (&Expr, Term), wanted: &str) -> Term {
        if !self.names.language.is_rust() || is_plain(value) {
            return term;
        }
        let name = self.names.fresh(wanted);
        self.out.push(self.names.bound(value.ty, &name, &term, false));
        Term::name(&name)
    }

    /// The text of a call with arguments for these parameters.
    fn called(&mut self, name: &str, args: &[Expr], params: &[Param]) -> Result<Term, NotEmitted> {
        let args: Vec<_> = self.scope(|this| {
            let settled = |(arg, param): (&Expr, &Param)| {
                let term = this.names.value(arg)?;
                Ok(this.settled((arg, term), &param.name))
            };
            args.iter().zip(params).map(settled).collect::<Result<_, _>>()
        })?;
        let list: String = args.iter().map(|arg: &Term| format!(", {}", arg.text)).collect();
        let text = say!(self.names.language, "{name}(mesh{list})", "{CALLED}{name}(journal{list})");
        Ok(Term::of(text, Precedence::Whole, &args))
    }

    /// The value of a call of a function.
    pub fn function(&mut self, function: u32, args: &[Expr]) -> Result<Term, NotEmitted> {
        self.names.needs.insert(Need::Function(function));
        let called = &self.source.selection.program.functions[function as usize];
        let name = &self.source.functions[function as usize];
        let refuses = self.source.effects.function(function).is_some_and(|of| of.refuses);
        let call = self.called(name, args, &called.params)?;
        Ok(match refuses && self.names.language.is_rust() {
            true => Term::of(format!("{}?", call.text), Precedence::Whole, [&call]),
            false => call,
        })
    }

    /// Sets a variable to the value of a call; without one that is read, only calls.
    pub fn put(&mut self, variable: Option<u32>, call: &Term) {
        let assigned = variable.and_then(|variable| self.assigned(variable, call));
        let alone = || Statement::lines(format!("{};", call.text), [call]);
        self.out.push(assigned.unwrap_or_else(alone));
    }

    /// Calls an operation, and goes on as the program does if it applied, or if it refused.
    pub fn apply(
        &mut self,
        (op, args): (usize, &[Expr]),
        variable: Option<u32>,
        [then, otherwise]: [&'s resolve::Block; 2],
    ) -> Result<(), NotEmitted> {
        self.names.needs.insert(Need::Op(op));
        let (called, name) = (&self.source.selection.program.ops[op], &self.source.ops[op]);
        let (language, has_result) = (self.names.language, called.result.is_some());
        if let Some(level) = self.source.level_to_expect(op) {
            self.out.push(Statement::lines(language.expect(level), []));
        }
        let call = self.called(name, args, &called.params)?;
        let text = &call.text;
        let with = |text: String| Term::of(text, Precedence::Whole, [&call]);
        let [applies, refuses] = match language.is_rust() && has_result {
            true => ["is_some", "is_none"].map(|is| format!("{text}.{is}()")),
            false => [text.clone(), format!("!{text}")],
        };
        if let [Step { kind: StatementKind::Refused { .. }, .. }] = otherwise.as_slice() {
            match language.is_rust() {
                true if has_result => self.put(variable, &with(format!("{text}?"))),
                true => self.out.push(Statement::RefuseIn {
                    head: with(format!("if {refuses} {{")),
                    reason: String::new(),
                    end: "}",
                }),
                false => self.put(variable, &with(format!("hedgerow::must({text})"))),
            }
            return then.iter().try_for_each(|statement| self.statement(statement));
        }
        let read = variable.filter(|&variable| self.variables.reads(variable));
        let (place, mut then) = self.scope(|this| {
            let place = read.map(|variable| {
                let (name, ty) = this.bind(variable);
                let made = this.names.fresh(&format!("made_{name}"));
                (name, ty, made)
            });
            Ok((place, this.block(then)?))
        })?;
        let otherwise = self.block(otherwise)?;
        self.out.push(match place {
            None if then.is_empty() && otherwise.is_empty() => {
                Statement::lines(format!("{text};"), [&call])
            }
            None if then.is_empty() => {
                Statement::block(language.head("if", &with(refuses)), otherwise)
            }
            None => language.choose(&with(applies), then, otherwise),
            Some((name, ty, made)) => {
                let given = say!(language, "let Some({name}) = {text}", "auto {made} = {text}");
                let head = language.head("if", &with(given));
                if !language.is_rust() {
                    let given = Term::whole(format!("*{made}"));
                    then.insert(0, self.names.bound(ty, &name, &given, false));
                }
                Statement::Block(Block { head, body: then, otherwise, ..Block::default() })
            }
        });
        Ok(())
    }
}
