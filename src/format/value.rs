//! Values: broken at the operators of lowest precedence, and after commas.

use super::action::headed;
use super::printer::{Doc, HANG, Printer, joined, line, nil, text};
use crate::syntax::TokenKind as T;
use crate::syntax::tree::{ActionKind, BinaryOp, Expr, ExprKind, Ident};

impl Printer<'_> {
    /// A value, with the parentheses around it.
    pub(super) fn value(&mut self, value: &Expr, width: usize) -> Doc {
        if self.peek() == Some(T::LeftParen) && self.next_start() < start_inside(value) {
            let open = self.token();
            let inside = self.value(value, width);
            let close = self.token();
            return open.append(inside.align()).append(close).group();
        }
        match &value.kind {
            ExprKind::Bool(_) | ExprKind::Int(_) | ExprKind::Real(_) | ExprKind::Text(_) => {
                self.token()
            }
            ExprKind::Name(name) => self.tokens(name.span),
            ExprKind::Field(of, _) => {
                let of = self.value(of, width);
                let dot = self.token();
                of.append(dot).append(self.token())
            }
            ExprKind::Call { function, args } => self.call(function, args, width),
            ExprKind::Aggregate { body, sequence, filter, .. } => {
                let open = self.token().append(self.token());
                let body = self.value(body, width);
                let inside = body.append(line()).append(self.token()).append(text(" "));
                let source = self.visited(sequence, filter.as_deref(), width);
                let inside = inside.append(source).align();
                open.append(inside).append(self.token()).group()
            }
            ExprKind::Must(call) | ExprKind::Asked(_, call) => {
                let must = self.token().append(text(" "));
                must.append(self.value(call, width))
            }
            ExprKind::Unary(_, operand) => {
                let apart = if self.peek() == Some(T::Not) { " " } else { "" };
                let sign = self.token().append(text(apart));
                sign.append(self.value(operand, width))
            }
            ExprKind::Range(first, end) => {
                let first = self.value(first, width).append(self.token());
                first.append(self.value(end, width))
            }
            ExprKind::Binary(op, ..) => self.chain(*op, value, width),
            ExprKind::If { .. } => self.choice(value, width),
            ExprKind::Broken => nil(),
        }
    }

    /// `f(x, y)`
    fn call(&mut self, function: &Ident, args: &[Expr], width: usize) -> Doc {
        let open = self.tokens(function.span).append(self.token());
        let mut inside = Vec::new();
        for (at, arg) in args.iter().enumerate() {
            if at > 0 {
                inside.push(line());
            }
            inside.push(self.value(arg, width));
            if self.peek() == Some(T::Comma) {
                inside.push(self.token());
            }
        }
        open.append(joined(inside).align()).append(self.token()).group()
    }

    /// `x in xs where c`
    pub(super) fn visited(&mut self, sequence: &Expr, filter: Option<&Expr>, width: usize) -> Doc {
        let variable = self.token().append(text(" "));
        let source = variable.append(self.token()).append(text(" "));
        let source = source.append(self.value(sequence, width));
        match filter {
            Some(filter) => {
                let filtered = line().append(self.token()).append(text(" "));
                source.append(filtered.append(self.value(filter, width)))
            }
            None => source,
        }
    }

    /// Operands with operators of the same precedence between them.
    fn chain(&mut self, op: BinaryOp, value: &Expr, width: usize) -> Doc {
        let rank = rank_of(op);
        let mut operands = Vec::new();
        let mut left = value;
        while let ExprKind::Binary(op, before, right) = &left.kind
            && rank_of(*op) == rank
            && (std::ptr::eq(left, value) || !in_parentheses(left))
        {
            operands.push((Some(*op), &**right));
            left = before;
        }
        operands.push((None, left));
        let mut docs = Vec::new();
        for at in (0..operands.len()).rev() {
            let (op, operand) = operands[at];
            let Some(op) = op else {
                docs.push(self.value(operand, width));
                continue;
            };
            // The fraction at the head of a product, as in `4/3 * x`, reads as one number.
            let fraction = op == BinaryOp::Divide
                && at + 2 == operands.len()
                && self.is_plain_int(operand)
                && self.is_plain_int(left)
                && !self.has_comment(operand.span);
            let operator = if fraction {
                self.token()
            } else if rank == COMPARISON && is_short(operand) {
                text(" ").append(self.spaced_token())
            } else {
                line().append(self.spaced_token())
            };
            docs.extend([operator, self.value(operand, width)]);
        }
        joined(docs).group()
    }

    /// `if c { x } else { y }`
    fn choice(&mut self, value: &Expr, width: usize) -> Doc {
        let mut branches = Vec::new();
        let mut head = nil();
        let mut rest = value;
        while let ExprKind::If { condition, then, otherwise } = &rest.kind {
            let keyword = self.token().append(text(" "));
            let condition = self.value(condition, width).nest(HANG).group();
            head = head.append(keyword).append(condition).append(text(" "));
            branches.push((head, self.block(then, width)));
            head = text(" ").append(self.token()).append(text(" "));
            if self.peek() == Some(T::If)
                && let [only] = otherwise.statements.as_slice()
                && let ActionKind::Expr(next) = &only.kind
            {
                rest = next;
            } else {
                branches.push((head, self.block(otherwise, width)));
                break;
            }
        }
        headed(branches)
    }

    fn is_plain_int(&self, value: &Expr) -> bool {
        let first = self.source.as_bytes().get(value.span.start as usize);
        matches!(value.kind, ExprKind::Int(_)) && first.is_some_and(u8::is_ascii_digit)
    }
}

/// The start of the first part of a value, inside of its parentheses.
fn start_inside(value: &Expr) -> usize {
    match &value.kind {
        ExprKind::Binary(_, first, _) | ExprKind::Field(first, _) | ExprKind::Range(first, _) => {
            first.span.start as usize
        }
        // Nothing else begins with a parenthesis.
        _ => usize::MAX,
    }
}

fn in_parentheses(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Binary(_, first, _) => first.span.start > value.span.start,
        _ => false,
    }
}

/// True if there is never a line break between a comparison operator and the value.
fn is_short(value: &Expr) -> bool {
    use ExprKind::{Bool, Int, Name, Real};
    matches!(value.kind, Bool(_) | Int(_) | Real(_) | Name(_))
}

const COMPARISON: u8 = 2;

/// The precedence of an operator.
fn rank_of(op: BinaryOp) -> u8 {
    use BinaryOp as O;
    match op {
        O::Or => 0,
        O::And => 1,
        O::Equal | O::NotEqual | O::Less | O::LessEqual | O::Greater | O::GreaterEqual => {
            COMPARISON
        }
        O::Add | O::Subtract => 3,
        O::Multiply | O::Divide | O::Div | O::Mod => 4,
    }
}
