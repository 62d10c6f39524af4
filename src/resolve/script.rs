//! A script: its parameters, its variables, its blocks and loops.

use std::collections::BTreeSet;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Collection, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Action, ActionKind, Ident};

use super::assignment::set_often;
use super::builtin::SHUFFLE;
use super::declared::Declared;
use super::depth::shallow_block;
use super::effects::effects_of;
use super::parameter::{Owner, parameters};
use super::program::{Block, Body, Script, Statement, StatementKind, Visit};
use super::report::Report;
use super::return_value::Returns;
use super::signature::{Effects, Parameter, Signature};
use super::test_meshes::Meshes;
use super::typing::{Place, Typing};
use super::words::not_held;

/// The state while the statements of a script, function, test or op in steps are resolved.
pub(super) struct Scripting<'a> {
    pub(super) typing: Typing<'a>,
    /// The number of enclosing loops.
    pub(super) loops: u32,
    /// True inside a `drain`.
    draining: bool,
    /// The fields that several assignments of the `update` name.
    pub(super) set_often: BTreeSet<String>,
    /// The type of value that `return` gives.
    pub(super) returns: Returns,
    /// The name of the op, if these are the steps of one.
    pub(super) steps_of: Option<&'a str>,
    /// The meshes of the test, if this is one.
    pub(super) testing: Option<Meshes>,
}

/// The head of a `for` or `update`, and its body.
pub(super) struct Loop<'a> {
    /// The place of `parallel for`.
    pub(super) parallel: Option<Span>,
    pub(super) variable: &'a Ident,
    pub(super) sequence: &'a tree::Expr,
    pub(super) filter: Option<&'a tree::Expr>,
    pub(super) body: &'a tree::Block,
}

/// Resolves a script; `None` if the report has an error.
pub(super) fn resolve_script(
    script: &tree::Script,
    ops: &[Signature],
    declared: &Declared,
    report: &mut Report,
) -> Option<Script> {
    if !declared.has_its_name(&script.name) {
        report.fail();
    }
    let params = parameters(&script.params, Owner::Script, declared, report);
    if !shallow_block(&script.body, report) {
        return None;
    }
    let mut scripting = Scripting::beginning(&params, ops, declared, report);
    let block = scripting.block(&script.body);
    let scopes = scripting.typing.scopes;
    declared.meet_variables(&scopes);
    if report.failed() {
        return None;
    }
    Some(Script {
        name: script.name.text.clone(),
        span: script.name.span,
        docs: script.docs.clone(),
        params: params.iter().map(Parameter::param).collect(),
        body: Body { variables: scopes.into_variables()?, block },
    })
}

impl<'a> Scripting<'a> {
    /// The initial state, with the parameters declared and no result.
    pub(super) fn beginning(
        params: &[Parameter],
        ops: &'a [Signature],
        declared: &'a Declared,
        report: &'a mut Report,
    ) -> Self {
        Self {
            typing: Typing { ops, ..Typing::new(Place::Script, declared, params, report) },
            loops: 0,
            draining: false,
            set_often: BTreeSet::new(),
            returns: Returns::nothing(),
            steps_of: None,
            testing: None,
        }
    }
}

impl Scripting<'_> {
    /// `{ … }`
    pub(super) fn block(&mut self, block: &tree::Block) -> Block {
        self.typing.scopes.enter();
        let kept = self.testing.as_ref().map_or(0, |meshes| meshes.kept.len());
        let mut statements = Block::new();
        self.actions(&block.statements, &mut statements);
        if let Some(meshes) = &mut self.testing {
            meshes.kept.truncate(kept);
        }
        self.typing.scopes.leave();
        statements
    }

    pub(super) fn actions(&mut self, actions: &[Action], statements: &mut Block) {
        let mut foreign = 0;
        for (at, action) in actions.iter().enumerate() {
            if foreign > 0 {
                foreign -= 1;
                continue;
            }
            if self.declared_elsewhere(action, actions.get(at + 1)) {
                continue;
            }
            if let Some(next) = actions.get(at + 1)
                && let Some(word) = leaves(&action.kind)
            {
                let message = format!("what follows `{word}` is never executed");
                let told = Diagnostic::warning("unreachable-statement", message, next.span);
                self.typing.report.add(told.label(action.span, format!("`{word}` is here")));
            }
            if let Some(beside) = self.foreign_words(action, &actions[at + 1..]) {
                foreign = beside;
                continue;
            }
            match &action.kind {
                // A block in a block is only a scope.
                ActionKind::Block(inner) => statements.extend(self.block(inner)),
                ActionKind::For { parallel, variable, sequence, filter, body }
                    if let tree::ExprKind::Range(first, end) = &sequence.kind
                        && !self.typing.updating =>
                {
                    let (parallel, filter) = (*parallel, filter.as_ref());
                    let visited = Loop { parallel, variable, sequence, filter, body };
                    let counted = self.count(&visited, (first, end), action.span);
                    statements.extend(counted.into_iter().flatten());
                }
                _ if self.testing.is_some() => {
                    statements.extend(
                        self.tested(action).map(|kind| Statement { kind, span: action.span }),
                    );
                }
                _ => statements
                    .extend(self.action(action).map(|kind| Statement { kind, span: action.span })),
            }
        }
    }

    /// A statement in a test, possibly one that only tests have.
    fn tested(&mut self, action: &Action) -> Option<StatementKind> {
        match self.testing_action(action) {
            Some(of_test) => of_test,
            None => self.action(action),
        }
    }

    /// A statement; `None` if an error has been reported.
    pub(super) fn action(&mut self, action: &Action) -> Option<StatementKind> {
        if self.typing.updating && !self.may_update(action) {
            return None;
        }
        match &action.kind {
            ActionKind::Let { .. } => self.declaration(action),
            ActionKind::Assign { target, value } => self.assignment(target, value, action.span),
            ActionKind::Repeat { count, body } => self.repeat(count, body),
            ActionKind::While { condition, body } => self.repeat_while(condition, body),
            ActionKind::For { parallel, variable, sequence, filter, body } => {
                let (parallel, filter) = (*parallel, filter.as_ref());
                self.visit_each(Loop { parallel, variable, sequence, filter, body })
            }
            ActionKind::Update { variable, sequence, filter, body } => {
                let filter = filter.as_ref();
                self.update_each(Loop { parallel: None, variable, sequence, filter, body })
            }
            ActionKind::Drain { variable, sequence, key, condition, body } => {
                self.drain(variable, sequence, (key, condition.as_ref()), body)
            }
            ActionKind::If { binding, condition, then, otherwise } => {
                self.choice(binding.as_ref(), condition, then, otherwise.as_ref())
            }
            ActionKind::Print(values) => self.print(values),
            ActionKind::Assert { condition, reason } => {
                let reason = reason.as_ref().map(|(text, _)| text.as_str());
                self.demand(condition, reason)
            }
            ActionKind::Require { condition, reason } => {
                let reason = reason.as_ref().map(|(text, _)| text.as_str());
                self.require(condition, reason, action.span)
            }
            ActionKind::Return(value) => self.exit(value.as_ref(), action.span),
            ActionKind::Break => self.of_a_loop("break", StatementKind::Break, action.span),
            ActionKind::Continue => {
                self.of_a_loop("continue", StatementKind::Continue, action.span)
            }
            ActionKind::Expr(expr) => self.alone(expr),
            ActionKind::Block(_) | ActionKind::Broken => self.typing.report.fail_silently(),
        }
    }

    /// `repeat n { … }`
    fn repeat(&mut self, count: &tree::Expr, body: &tree::Block) -> Option<StatementKind> {
        let count = self.typing.expression_as(count, Type::Int, "`repeat`");
        let body = self.repeated(body);
        let count = count?;
        Some(StatementKind::Repeat { count, body })
    }

    /// `while c { … }`
    fn repeat_while(
        &mut self,
        condition: &tree::Expr,
        body: &tree::Block,
    ) -> Option<StatementKind> {
        self.typing.may_change = true;
        let condition = self.typing.expression_as(condition, Type::Bool, "`while`");
        let body = self.repeated(body);
        let condition = condition?;
        Some(StatementKind::While { condition, body })
    }

    /// `for x in xs where c { … }`, `parallel for x in xs where c { … }`
    fn visit_each(&mut self, visited: Loop) -> Option<StatementKind> {
        if let (Some(parallel), None) = (visited.parallel, visited.filter) {
            self.typing.report.add(parallel_without_where(parallel));
        }
        if let (Some(parallel), Some(filter)) = (visited.parallel, visited.filter)
            && let Some((why, place)) = self.tested_alone(visited.sequence, filter)
        {
            let message = format!("this `where` is tested by one thread: {why}");
            let told = Diagnostic::warning("parallel-on-one-thread", message, parallel);
            self.typing.report.add(
                told.label(place, "because of this")
                    .note("`for` tests each element once, so it takes less time"),
            );
        }
        match &visited.sequence.kind {
            tree::ExprKind::Call { function, args } if function.text == SHUFFLE => {
                self.typing.right_count(function, 1, args.len(), visited.sequence.span)?;
                self.visit(Loop { sequence: args.first()?, ..visited }, Visit::Shuffled)
            }
            _ => self.visit(visited, Visit::InOrder),
        }
    }

    /// The reason why one thread alone tests the filter of a `parallel for`, and its place.
    fn tested_alone(
        &self,
        sequence: &tree::Expr,
        filter: &tree::Expr,
    ) -> Option<(&'static str, Span)> {
        match &sequence.kind {
            tree::ExprKind::Call { function, .. } if function.text == SHUFFLE => {
                return Some(("the elements are in random order", sequence.span));
            }
            tree::ExprKind::Field(..) => {
                return Some(("the elements are around another one", sequence.span));
            }
            _ if self.draining => return Some(("it is in a `drain`", sequence.span)),
            _ if self.steps_of.is_some() => {
                return Some(("it is in the steps of an operation", sequence.span));
            }
            _ => {}
        }
        let Effects { asks, prints, draws, .. } = effects_of(filter, self.typing.declared);
        let reasons = [
            ("it asks an operation", asks),
            ("it prints", prints),
            ("it draws random numbers", draws),
        ];
        reasons.into_iter().find_map(|(why, place)| Some((why, place?)))
    }

    /// `update x in xs where c { … }`
    fn update_each(&mut self, visited: Loop) -> Option<StatementKind> {
        self.typing.updating = true;
        self.set_often = set_often(visited.body);
        let update = self.visit(visited, Visit::Update);
        self.typing.updating = false;
        update
    }

    /// `assert c else "…"`
    fn demand(&mut self, condition: &tree::Expr, reason: Option<&str>) -> Option<StatementKind> {
        let typing = &mut self.typing;
        let condition = typing.expression_as(condition, Type::Bool, "`assert`")?;
        let reason = reason.unwrap_or("the assertion does not hold").to_owned();
        Some(StatementKind::Assert { condition, reason })
    }

    /// `require c else "…"`
    fn require(
        &mut self,
        condition: &tree::Expr,
        reason: Option<&str>,
        span: Span,
    ) -> Option<StatementKind> {
        let typed = self.typing.expression_as(condition, Type::Bool, "`require`");
        let Some(op) = self.steps_of else {
            let message =
                "`require` stands where an op can refuse: in its steps, or beside its drawings";
            let error = Diagnostic::error("misplaced-part", message, span)
                .note("here `assert` stops what runs");
            return self.typing.report.reject(error);
        };
        let reason = reason.map_or_else(|| not_held(op), str::to_owned);
        let condition = typed?;
        Some(StatementKind::Require { condition, reason })
    }

    /// The body of a loop.
    pub(super) fn repeated(&mut self, body: &tree::Block) -> Block {
        self.loops += 1;
        let body = self.block(body);
        self.loops -= 1;
        body
    }

    /// `drain x in xs by key while c { … }`
    fn drain(
        &mut self,
        variable: &Ident,
        sequence: &tree::Expr,
        (key, condition): (&tree::Expr, Option<&tree::Expr>),
        body: &tree::Block,
    ) -> Option<StatementKind> {
        let collection = self.typing.sequence(sequence);
        self.typing.scopes.enter();
        let ty = collection.as_ref().map(Collection::element);
        let variable = self.typing.scopes.declare_in_head(variable, ty);
        let key = self.typing.expression_as(key, Type::Real, "`by`");
        let condition = self.typing.condition(condition, "`while`");
        let outside = std::mem::replace(&mut self.draining, true);
        let body = self.repeated(body);
        self.draining = outside;
        self.typing.scopes.leave();
        let (collection, key, condition) = (collection?, key?, condition?);
        Some(StatementKind::Drain { variable, collection, key, condition, body })
    }

    fn visit(&mut self, visited: Loop, visit: Visit) -> Option<StatementKind> {
        let collection = self.typing.sequence(visited.sequence);
        self.typing.scopes.enter();
        let ty = collection.as_ref().map(Collection::element);
        let variable = self.typing.scopes.declare_in_head(visited.variable, ty);
        let filter = self.typing.condition(visited.filter, "`where`");
        let body = self.repeated(visited.body);
        self.typing.scopes.leave();
        let (collection, filter) = (collection?, filter?);
        let parallel = visited.parallel.is_some();
        Some(StatementKind::For { variable, collection, filter, body, visit, parallel })
    }
}

/// The error for `parallel for` without a filter, which has nothing to do on several threads.
fn parallel_without_where(parallel: Span) -> Diagnostic {
    let message = "a `parallel for` has no `where`, which is what it tests on all threads";
    Diagnostic::error("parallel-without-where", message, parallel)
        .note("its turns run one after the other, as those of a `for`; an `update` runs on all threads")
        .fix("drop `parallel`", parallel, "for")
}

/// The word of a statement behind which its block does not go on.
fn leaves(kind: &ActionKind) -> Option<&'static str> {
    match kind {
        ActionKind::Return(_) => Some("return"),
        ActionKind::Break => Some("break"),
        ActionKind::Continue => Some("continue"),
        _ => None,
    }
}
