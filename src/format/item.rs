//! Items: heads, parameters, and the parts of an op.

use super::printer::{Doc, HANG, INDENT, Lines, Printer, joined, laid_out, line, nil, soft, text};
use crate::source::Span;
use crate::syntax::TokenKind as T;
use crate::syntax::tree::{Attr, Condition, Item, Name, Op, Param, Rule, Side, Steps};

impl Printer<'_> {
    /// An item without the comments before it.
    pub(super) fn item(&mut self, item: &Item, width: usize) -> Lines {
        let doc = match item {
            Item::Use(_) => self.spaced_token().append(self.token()),
            Item::Attr(attr) => self.attr(attr, width),
            Item::Fn(function) => {
                let head = self.head(function.private, &function.params, width);
                let head = match function.result {
                    Some(_) => head.append(self.result()),
                    None => head,
                };
                let body = self.block(&function.body, width);
                super::action::headed(vec![(head.append(text(" ")), body)])
            }
            Item::Op(op) => self.op(op, width),
            Item::Script(script) => {
                let head = self.head(script.private, &script.params, width);
                let body = self.block(&script.body, width);
                super::action::headed(vec![(head.append(text(" ")), body)])
            }
            Item::Test(test) => {
                let head = self.spaced_token().append(self.spaced_token());
                super::action::headed(vec![(head, self.block(&test.body, width))])
            }
            Item::Broken(_) => nil(),
        };
        laid_out(doc, width)
    }

    /// `private attr name: vertex real = 0`
    fn attr(&mut self, attr: &Attr, width: usize) -> Doc {
        let mut doc = self.private(attr.private);
        doc = doc.append(self.spaced_token()).append(self.token());
        doc = doc.append(self.spaced_token());
        doc = doc.append(self.spaced_token()).append(self.token());
        match &attr.default {
            Some(default) => doc.append(self.equals(default, width)),
            None => doc,
        }
    }

    /// `private `
    fn private(&mut self, is_there: bool) -> Doc {
        if is_there { self.spaced_token() } else { nil() }
    }

    /// `private script name(…)`
    fn head(&mut self, private: bool, params: &[Param], width: usize) -> Doc {
        let head = self.private(private).append(self.spaced_token()).append(self.token());
        let open = self.token();
        let mut inside = vec![soft()];
        for (at, param) in params.iter().enumerate() {
            if at > 0 {
                inside.push(line());
            }
            inside.push(self.tokens(param.name.span));
            inside.extend([self.spaced_token(), self.token()]);
            if let Some(default) = &param.default {
                inside.push(self.equals(default, width));
            }
            if self.peek() == Some(T::Comma) {
                inside.push(self.token());
            }
        }
        let params = open.append(joined(inside).nest(HANG)).append(soft());
        head.append(params.append(self.token()).group())
    }

    /// ` -> m`
    fn result(&mut self) -> Doc {
        text(" ").append(self.spaced_token()).append(self.token())
    }

    /// `op name(…) -> m keeps … { … }`
    fn op(&mut self, op: &Op, width: usize) -> Doc {
        let mut head = self.head(op.private, &op.params, width);
        if op.result.is_some() {
            head = head.append(self.result());
        }
        if !op.keeps.is_empty() {
            let mut keeps = vec![line(), self.spaced_token()];
            for (at, _) in op.keeps.iter().enumerate() {
                if at > 0 {
                    keeps.extend([self.token(), line()]);
                }
                keeps.push(self.token());
            }
            head = head.append(joined(keeps).nest(HANG).group());
        }
        let inner = width.saturating_sub(INDENT);
        let open = self.next_start();
        let span = Span::new(op.span.file, open, op.span.end as usize);
        let block = self.braces(span, false, |printer, lines| match op.rules.as_slice() {
            [rule] if rule.name.is_none() => printer.rule_parts(rule, lines, inner),
            rules => {
                if let Some(steps) = &op.steps {
                    printer.steps(steps, lines, inner);
                }
                for rule in rules {
                    printer.gap(lines);
                    let doc = printer.rule(rule, inner);
                    lines.extend(laid_out(doc, inner));
                }
            }
        });
        head.append(text(" ")).append(block.long())
    }

    /// `rule name { … }`
    fn rule(&mut self, rule: &Rule, width: usize) -> Doc {
        let head = self.spaced_token().append(self.spaced_token());
        let inner = width.saturating_sub(INDENT);
        let open = self.next_start();
        let span = Span::new(rule.span.file, open, rule.span.end as usize);
        let block = self.braces(span, false, |printer, lines| {
            printer.rule_parts(rule, lines, inner);
        });
        head.append(block.long())
    }

    fn rule_parts(&mut self, rule: &Rule, lines: &mut Lines, width: usize) {
        self.side_lines(rule.before.as_ref(), lines, width);
        self.conditions(&rule.conditions, lines, width);
        self.side_lines(rule.after.as_ref(), lines, width);
    }

    fn side_lines(&mut self, side: Option<&Side>, lines: &mut Lines, width: usize) {
        if let Some(side) = side {
            self.gap(lines);
            lines.extend(laid_out(self.side(side, width), width));
        }
    }

    fn conditions(&mut self, conditions: &[Condition], lines: &mut Lines, width: usize) {
        for condition in conditions {
            self.gap(lines);
            let doc = match condition {
                Condition::Require { condition, reason, .. } => {
                    self.demanded(condition, reason.is_some(), width)
                }
                Condition::Guard { .. } => self.spaced_token().append(self.token()),
                Condition::Alias { names, .. } => self.aliased(names),
            };
            lines.extend(laid_out(doc, width));
        }
    }

    /// `alias v2 v3`
    fn aliased(&mut self, names: &[Name]) -> Doc {
        let mut docs = vec![self.token()];
        docs.extend(names.iter().map(|name| text(" ").append(self.tokens(name.span))));
        joined(docs)
    }

    /// `steps { … }`, and the conditions before it
    fn steps(&mut self, steps: &Steps, lines: &mut Lines, width: usize) {
        self.conditions(&steps.conditions, lines, width);
        self.gap(lines);
        let head = self.spaced_token();
        let body = self.block(&steps.body, width);
        lines.extend(laid_out(super::action::headed(vec![(head, body)]), width));
    }
}
