//! Statements of code, and their blocks.

use super::printer::{Block, Doc, HANG, INDENT, Lines, Printer, joined, laid_out, line, nil, text};
use crate::source::Span;
use crate::syntax::TokenKind as T;
use crate::syntax::tree::{self, Action, ActionKind, Expr, Shown};

impl Printer<'_> {
    /// A block of code; `width` is that of the lines around it.
    pub(super) fn block(&mut self, block: &tree::Block, width: usize) -> Block {
        let inner = width.saturating_sub(INDENT);
        let at_most_one = block.statements.len() < 2;
        self.braces(block.span, at_most_one, |printer, lines| {
            for action in &block.statements {
                printer.gap(lines);
                let doc = printer.action(action, inner);
                lines.extend(laid_out(doc, inner));
            }
        })
    }

    /// Two braces, with the lines that `inside` puts between them; `may_be_short` if they could be
    /// on one line.
    pub(super) fn braces(
        &mut self,
        span: Span,
        may_be_short: bool,
        inside: impl FnOnce(&mut Self, &mut Lines),
    ) -> Block {
        let mut lines = Lines::new();
        let bare = may_be_short && self.on_one_line(span) && !self.has_comment(span);
        let above = self.comments_before_next();
        self.word();
        let opening = self.comments_of_line();
        inside(self, &mut lines);
        self.last_gap(&mut lines);
        self.word();
        Block { above, opening, short: bare && lines.len() < 2, lines }
    }

    fn action(&mut self, action: &Action, width: usize) -> Doc {
        match &action.kind {
            ActionKind::Let { ty, value, .. } => {
                let mut doc = self.spaced_token().append(self.token());
                if ty.is_some() {
                    doc = doc.append(self.token()).append(text(" "));
                    doc = doc.append(self.token());
                }
                doc.append(self.equals(value, width))
            }
            ActionKind::Assign { target, value } => {
                let target = self.value(target, width);
                target.append(self.equals(value, width))
            }
            ActionKind::Repeat { count, body } => {
                let head = self.spaced_token().append(self.hung(count, width));
                self.with_body(head, body, width)
            }
            ActionKind::While { condition, body } => {
                let head = self.spaced_token().append(self.hung(condition, width));
                self.with_body(head, body, width)
            }
            ActionKind::For { sequence, filter, body, .. }
            | ActionKind::Update { sequence, filter, body, .. } => {
                let mut keyword = self.spaced_token();
                if matches!(action.kind, ActionKind::For { parallel: Some(_), .. }) {
                    keyword = keyword.append(self.spaced_token());
                }
                let source = self.visited(sequence, filter.as_ref(), width);
                let head = keyword.append(source).nest(HANG).group();
                self.with_body(head, body, width)
            }
            ActionKind::Drain { sequence, key, condition, body, .. } => {
                let keyword = self.spaced_token();
                let mut head = keyword.append(self.visited(sequence, None, width));
                head = head.append(line()).append(self.spaced_token());
                head = head.append(self.value(key, width));
                if let Some(condition) = condition {
                    head = head.append(line()).append(self.spaced_token());
                    head = head.append(self.value(condition, width));
                }
                self.with_body(head.nest(HANG).group(), body, width)
            }
            ActionKind::If { .. } => self.conditional(&action.kind, width),
            ActionKind::Print(values) => {
                let mut docs = vec![self.spaced_token()];
                for (at, value) in values.iter().enumerate() {
                    if at > 0 {
                        docs.extend([self.token(), line()]);
                    }
                    docs.push(match value {
                        Shown::Value(value) => self.value(value, width),
                        // It ends on the line on which it begins.
                        Shown::Text(_, span) => self.uncut(*span),
                    });
                }
                joined(docs).nest(HANG).group()
            }
            ActionKind::Assert { condition, reason }
            | ActionKind::Require { condition, reason } => {
                self.demanded(condition, reason.is_some(), width)
            }
            ActionKind::Return(Some(value)) => {
                let keyword = self.spaced_token();
                keyword.append(self.hung(value, width))
            }
            ActionKind::Return(None) | ActionKind::Break | ActionKind::Continue => self.token(),
            ActionKind::Block(block) => self.block(block, width).doc(),
            ActionKind::Expr(value) => self.hung(value, width),
            ActionKind::Broken => nil(),
        }
    }

    /// `if c { … } else if d { … } else { … }`
    fn conditional(&mut self, kind: &ActionKind, width: usize) -> Doc {
        let mut branches = Vec::new();
        let mut head = nil();
        let mut rest = kind;
        while let ActionKind::If { binding, condition, then, otherwise } = rest {
            head = head.append(self.spaced_token());
            if binding.is_some() {
                for _ in ["let", "name", "="] {
                    head = head.append(self.spaced_token());
                }
            }
            head = head.append(self.hung(condition, width)).append(text(" "));
            branches.push((head, self.block(then, width)));
            let Some(otherwise) = otherwise else { break };
            head = text(" ").append(self.spaced_token());
            if self.peek() == Some(T::If)
                && let [only] = otherwise.statements.as_slice()
            {
                rest = &only.kind;
            } else {
                branches.push((head, self.block(otherwise, width)));
                break;
            }
        }
        headed(branches)
    }

    fn with_body(&mut self, head: Doc, body: &tree::Block, width: usize) -> Doc {
        headed(vec![(head.append(text(" ")), self.block(body, width))])
    }

    /// A keyword, a value, and perhaps `else` with a reason.
    pub(super) fn demanded(&mut self, condition: &Expr, reasoned: bool, width: usize) -> Doc {
        let keyword = self.spaced_token();
        let mut doc = keyword.append(self.value(condition, width));
        if reasoned {
            doc = doc.append(line()).append(self.spaced_token());
            doc = doc.append(self.token());
        }
        doc.nest(HANG).group()
    }

    /// ` = value`
    pub(super) fn equals(&mut self, value: &Expr, width: usize) -> Doc {
        let equals = text(" ").append(self.spaced_token());
        equals.append(self.hung(value, width))
    }

    /// A token and a space.
    pub(super) fn spaced_token(&mut self) -> Doc {
        self.token().append(text(" "))
    }

    /// A value whose lines after the first are indented.
    fn hung(&mut self, value: &Expr, width: usize) -> Doc {
        match value.kind {
            // Its branches are indented like the statement.
            tree::ExprKind::If { .. } => self.value(value, width),
            _ => self.value(value, width).nest(HANG).group(),
        }
    }
}

/// Heads with their blocks: all on one line, if every block was written so and it fits.
pub(super) fn headed(branches: Vec<(Doc, Block)>) -> Doc {
    let short = branches.iter().all(|(_, block)| block.short);
    let docs = branches.into_iter().map(|(head, block)| {
        let block = if short { block.long().flat_alt(block.one_line()) } else { block.long() };
        head.append(block)
    });
    let doc = joined(docs.collect());
    if short { doc.group() } else { doc }
}
