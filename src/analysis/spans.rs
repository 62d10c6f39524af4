//! The nested parts of a text, from its tree.

use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::Part;
use crate::syntax::tree::{
    Action, Block, Condition, Expr, Item, Name, Rule, Side, Spoke, Statement,
};

/// The parts around a byte, the smallest first: a word, the name, the statement, the side,
/// the rule, the op, the text.
pub fn around(snapshot: &Snapshot, offset: usize) -> Vec<Span> {
    let mut found = Spans::default();
    for item in snapshot.items() {
        if item.span().touches(offset) {
            found.item(item);
        }
    }
    let tokens = snapshot.parsed().tokens.iter().map(|token| token.span);
    let comments = snapshot.parsed().comments.iter();
    found.all.extend(tokens);
    found.all.extend(comments.map(|comment| comment.span));
    found.all.push(Span::new(snapshot.file(), 0, snapshot.text().len()));
    let mut around: Vec<_> = found
        .all
        .into_iter()
        .filter(|span| span.touches(offset) && span.start < span.end)
        .collect();
    // Of two words that meet at the cursor, the one after it counts.
    around.sort_by_key(|span| (span.end - span.start, std::cmp::Reverse(span.start)));
    let mut chain: Vec<Span> = Vec::new();
    for span in around {
        let holds_last = |last: &Span| span.start <= last.start && last.end <= span.end;
        if chain.last().is_none_or(|last| holds_last(last) && *last != span) {
            chain.push(span);
        }
    }
    chain
}

/// The blocks of scripts, functions and tests.
pub fn blocks(items: &[Item]) -> Vec<Span> {
    let mut found = Spans::default();
    items.iter().for_each(|item| found.item(item));
    found.blocks
}

#[derive(Default)]
struct Spans {
    all: Vec<Span>,
    blocks: Vec<Span>,
}

impl Spans {
    fn item(&mut self, item: &Item) {
        self.all.push(item.span());
        match item {
            Item::Op(op) => {
                self.all.extend(op.params.iter().map(|param| param.span));
                op.rules.iter().for_each(|rule| self.rule(rule));
                if let Some(steps) = &op.steps {
                    self.conditions(&steps.conditions);
                    self.block(&steps.body);
                }
            }
            Item::Script(script) => self.block(&script.body),
            Item::Fn(function) => self.block(&function.body),
            Item::Test(test) => self.block(&test.body),
            Item::Attr(attr) => attr.default.iter().for_each(|value| self.value(value)),
            Item::Use(used) => self.all.push(used.path_span),
            Item::Broken(_) => {}
        }
    }

    fn rule(&mut self, rule: &Rule) {
        self.all.push(rule.span);
        rule.before.iter().chain(&rule.after).for_each(|side| self.side(side));
        self.conditions(&rule.conditions);
    }

    fn conditions(&mut self, conditions: &[Condition]) {
        for condition in conditions {
            self.all.push(condition.span());
            match condition {
                Condition::Require { condition, .. } => self.value(condition),
                Condition::Guard { .. } => {}
                Condition::Alias { names, .. } => names.iter().for_each(|name| self.name(name)),
            }
        }
    }

    fn side(&mut self, side: &Side) {
        self.all.push(side.span);
        for statement in &side.statements {
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &Statement) {
        self.all.push(statement.span());
        match statement {
            Statement::Loop(orbit) => {
                for item in &orbit.items {
                    self.name(&item.from);
                    self.all.push(item.span);
                    self.all.push(item.from.span.to(item.span));
                }
            }
            Statement::Edge { name, halfedges, .. } => {
                self.name(name);
                halfedges.iter().for_each(|half| self.name(half));
                self.all.push(halfedges[0].span.to(halfedges[1].span));
            }
            Statement::Vertex(star) => {
                for spoke in &star.spokes {
                    match spoke {
                        Spoke::Halfedge(name) => self.name(name),
                        Spoke::Fan(_, span) => self.all.push(*span),
                    }
                }
            }
            Statement::New(names, _) | Statement::Erase(names, _) | Statement::Keep(names, _) => {
                names.iter().for_each(|name| self.name(name));
            }
            Statement::Assign { value, .. } => self.value(value),
            Statement::Broken(_) => {}
        }
    }

    fn name(&mut self, name: &Name) {
        self.all.push(name.span);
    }

    fn block(&mut self, block: &Block) {
        self.all.push(block.span);
        self.blocks.push(block.span);
        block.statements.iter().for_each(|action| self.action(action));
    }

    fn action(&mut self, action: &Action) {
        self.all.push(action.span);
        action.each_part(&mut |part| self.part(part));
    }

    fn value(&mut self, value: &Expr) {
        self.all.push(value.span);
        value.each_part(&mut |part| self.part(part));
    }

    fn part(&mut self, part: Part) {
        match part {
            Part::Expr(value) => self.value(value),
            Part::Block(block) => self.block(block),
        }
    }
}
