//! Loops that may never end: a `drain` takes the elements that its own body adds, too.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Elements, ExprKind, Kind, Rule};
use crate::resolve::{Block, Program, ResolvedOp, Statement, StatementKind};

/// A warning for each `drain` without `while` that adds an element for every one it takes.
pub(super) fn endless_drains(program: &Program) -> Vec<Diagnostic> {
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
