//! Loops that may never end: a `drain` takes the elements that its own body adds, too; a `while`
//! that only tries an op finds the mesh as it was where the op refuses.

use std::collections::BTreeSet;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Elements, Expr, ExprKind, Kind, Rule};
use crate::resolve::{Block, Program, ResolvedOp, Statement, StatementKind};

/// A warning for each loop that may never end.
pub(super) fn endless_loops(program: &Program) -> Vec<Diagnostic> {
    [endless_drains(program), endless_whiles(program)].concat()
}

/// A warning for each `while` that leaves all as it was where its op refuses.
fn endless_whiles(program: &Program) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    for statement in program.statements() {
        let StatementKind::While { condition, body } = &statement.kind else { continue };
        let Some((op, tried)) = only_tried(condition, body, program) else { continue };
        let name = &op.name;
        let message =
            format!("where `{name}` refuses, nothing changes, and this `while` never ends");
        let note = format!(
            "`if {name}(…) {{ }} else {{ break }}` leaves it, `must {name}(…)` stops the script, and \
             `… where can {name}(…)` chooses among the places where it applies"
        );
        warnings.push(Diagnostic::warning("endless-while", message, tried.span).note(note));
    }
    warnings
}

/// The op that a loop tries, and the first try, if the loop does nothing else, and does the same
/// again as long as the mesh is the same.
fn only_tried<'p>(
    condition: &Expr,
    body: &'p Block,
    program: &'p Program,
) -> Option<(&'p ResolvedOp, &'p Statement)> {
    let set = body.iter().filter_map(|statement| match statement.kind {
        StatementKind::Set { variable, .. } => Some(variable),
        _ => None,
    });
    // What is set in an iteration before it is read is not left over from the last one.
    let mut left_over: BTreeSet<u32> = set.collect();
    let reads_one = |value: &Expr, left_over: &BTreeSet<u32>| {
        let mut reads = false;
        value.each(&mut |part| {
            reads |= matches!(part.kind, ExprKind::Local(read) if left_over.contains(&read));
        });
        reads
    };
    let mut reads = reads_one(condition, &left_over);
    let mut first = None;
    for statement in body {
        statement.values(&mut |value| reads |= reads_one(value, &left_over));
        match &statement.kind {
            StatementKind::Set { variable, .. } => _ = left_over.remove(variable),
            StatementKind::Apply { op, then, otherwise, .. }
                if then.is_empty() && otherwise.is_empty() =>
            {
                let op = program.ops.get(*op).filter(|op| may_refuse(op))?;
                first = first.or(Some((op, statement)));
            }
            StatementKind::Print(_) => {}
            _ => return None,
        }
    }
    first.filter(|_| !reads && are_fixed(condition, body, program))
}

/// True if the values of a loop are the same as long as the mesh and the variables are, and do not
/// ask whether an op applies; nor do the functions that they call, directly or not.
fn are_fixed(condition: &Expr, body: &Block, program: &Program) -> bool {
    let (mut fixed, mut seen, mut open) = (true, BTreeSet::new(), Vec::new());
    let mut look = |value: &Expr, open: &mut Vec<u32>| {
        value.each(&mut |part| match &part.kind {
            ExprKind::Try(..) => fixed = false,
            ExprKind::Call(builtin, _) => fixed &= !builtin.is_random(),
            ExprKind::Invoke(function, _) => open.push(*function),
            _ => {}
        });
    };
    look(condition, &mut open);
    for statement in body {
        statement.values(&mut |value| look(value, &mut open));
    }
    while let Some(number) = open.pop() {
        if !seen.insert(number) {
            continue;
        }
        let function = program.functions.get(number as usize);
        let Some(body) = function.and_then(|function| function.body.as_ref()) else { return false };
        for statement in &body.block {
            statement.each(&mut |inner| inner.values(&mut |value| look(value, &mut open)));
        }
    }
    fixed
}

/// True if an op refuses at some of the places where its drawing fits.
fn may_refuse(op: &ResolvedOp) -> bool {
    let mut rules = op.diagram.iter().flat_map(|diagram| &diagram.rules);
    op.steps.is_some() || rules.any(|rule| rule.guard.is_some() || !rule.requires.is_empty())
}

/// A warning for each `drain` without `while` that adds an element for every one it takes.
fn endless_drains(program: &Program) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    for statement in program.statements() {
        let StatementKind::Drain { collection, key, condition: None, body, .. } = &statement.kind
        else {
            continue;
        };
        // Those around an element are listed once; whether an op adds a hole is not asked.
        let Some(of) = collection.all().filter(|of| *of != Elements::Holes) else { continue };
        let kind = Kind::from(of.kind());
        // A key that differs from case to case may be infinite, and then is not taken.
        let mut is_plain = true;
        key.each(&mut |part| {
            is_plain &= !matches!(part.kind, ExprKind::If(..) | ExprKind::Invoke(..));
            is_plain &= !matches!(part.kind, ExprKind::Real(value) if value.is_infinite());
        });
        let adding = adding(body, kind, program).filter(|_| is_plain && !leaves(body));
        let Some(op) = adding else { continue };
        let (name, kinds) = (&op.name, kind.plural());
        let message = format!(
            "`{name}` adds {kinds}, which this `drain` takes, too: it ends only where `{name}` refuses"
        );
        let warning = Diagnostic::warning("endless-drain", message, statement.span);
        warnings.push(warning.note("`while` in its head ends it: `drain … by … while … { … }`"));
    }
    warnings
}

/// An op that is called in every turn, and leaves more elements of a kind than it finds.
fn adding<'p>(body: &Block, kind: Kind, program: &'p Program) -> Option<&'p ResolvedOp> {
    body.iter().find_map(|statement| {
        let StatementKind::Apply { op, .. } = statement.kind else { return None };
        let op = program.ops.get(op)?;
        let rules = &op.diagram.as_ref()?.rules;
        rules.iter().all(|rule| adds(rule, kind)).then_some(op)
    })
}

fn adds(rule: &Rule, kind: Kind) -> bool {
    let [created, erased] = [&rule.created, &rule.erased]
        .map(|listed| listed.iter().filter(|mention| rule.kind(mention.name) == kind).count());
    match rule.cycle {
        Some(_) => created > 0 && erased == 0,
        None => created > erased,
    }
}

/// True if something may leave a loop, or do more than one op does.
fn leaves(body: &Block) -> bool {
    let (mut leaves, mut ops) = (false, 0);
    for statement in body {
        statement.each(&mut |part: &Statement| match part.kind {
            StatementKind::Apply { .. } => ops += 1,
            StatementKind::Break | StatementKind::Return(_) | StatementKind::Call { .. } => {
                leaves = true;
            }
            _ => {}
        });
    }
    leaves || ops > 1
}
