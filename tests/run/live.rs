//! Variables that hold an element which is still needed.

use hedgerow::diagram::{Access, Expr, ExprKind, Type};
use hedgerow::resolve::{Digits, Print, Statement, StatementKind, Variable};
use hedgerow::run::live::{Exits, Live, Liveness};
use hedgerow::source::{FileId, Span};

const SPAN: Span = Span { file: FileId(0), start: 0, end: 0 };

fn statement(kind: StatementKind) -> Statement {
    Statement { kind, span: SPAN }
}

fn vertex(variable: u32) -> Expr {
    Expr { ty: Type::Vertex, kind: ExprKind::Local(variable), span: SPAN }
}

fn set(variable: u32, from: u32) -> Statement {
    let value = vertex(from);
    statement(StatementKind::Set { variable, value })
}

fn read(variable: u32) -> Statement {
    statement(StatementKind::Print(vec![Print::Value(vertex(variable), Digits::Few)]))
}

fn repeat(body: Vec<Statement>) -> Statement {
    let count = Expr { ty: Type::Int, kind: ExprKind::Int(2), span: SPAN };
    statement(StatementKind::Repeat { count, body })
}

fn before_each(block: &[Statement]) -> Vec<Vec<u32>> {
    let variable = |ty| Variable { name: String::new(), ty, span: SPAN };
    let variables = [Type::Vertex, Type::Edge, Type::Face, Type::Int].map(variable);
    let liveness = Liveness { variables: &variables };
    let live = liveness.before_each(block, &Exits::default());
    live.into_iter().map(|live| live.into_iter().collect()).collect()
}

#[test]
fn a_variable_is_live_from_where_it_is_set_to_where_it_is_last_read() {
    let block = [set(0, 1), read(0), read(3), set(0, 2), read(0)];
    let live: [&[u32]; 5] = [&[1, 2], &[0, 2], &[2], &[2], &[0]];
    assert_eq!(before_each(&block), live);
}

#[test]
fn what_a_loop_reads_is_live_all_through_it() {
    let again = repeat(vec![read(0), set(0, 1)]);
    let own = repeat(vec![set(2, 1), read(2)]);
    assert_eq!(before_each(&[again, own, read(3)]), [vec![0, 1], vec![1], vec![]]);
}

#[test]
fn leaving_a_loop_leaves_what_it_would_have_read() {
    let leave = repeat(vec![statement(StatementKind::Break), read(0)]);
    let stop = [statement(StatementKind::Return(None)), read(1)];
    assert!(before_each(&[leave])[0].is_empty());
    assert_eq!(before_each(&stop), [vec![], vec![1]]);
    let exits = Exits { continued: Live::from([2]), ..Exits::default() };
    let liveness = Liveness { variables: &[] };
    let go_on = [statement(StatementKind::Continue)];
    assert_eq!(liveness.before_each(&go_on, &exits), [Live::from([2])]);
}

#[test]
fn writes_read_their_target() {
    let (target, value, attribute) = (vertex(0), vertex(1), Access::Position);
    let write = statement(StatementKind::Write { target, attribute, value });
    assert_eq!(before_each(&[write]), [vec![0, 1]]);
}
