//! The inverse of an op: `before` and `after` are exchanged, and so are `new` and `erase`.
//!
//! An assignment is inverted if its old value can be computed from the new one: each operator
//! around it has an inverse, and the other operands do not change. One without an inverse becomes a
//! comment. Attributes of elements that are new again are left to the user.

use super::edits::slice;
use super::hover::op_named;
use super::side::subject;
use super::snapshot::Snapshot;
use crate::diagnostic::Edit;
use crate::diagram::Type;
use crate::resolve::fields;
use crate::syntax::Part;
use crate::syntax::tree::{
    Attr, BinaryOp, Expr, ExprKind, Item, Name, Op, Rule, Statement, UnaryOp,
};

/// The edit that adds the inverse of an op after it.
pub(super) fn inverse(snapshot: &Snapshot, op: &Op, name: &str) -> Option<Vec<Edit>> {
    if op.rules.is_empty() || op_named(snapshot, name).is_some() {
        return None;
    }
    // A parameter that the op erases does not exist before the inverse, which cannot take it then.
    let is_erased =
        |name: &Name| op.params.iter().any(|param| param.name.ident.text == name.ident.text);
    let sides = op.rules.iter().filter_map(|rule| rule.after.as_ref());
    let erased = sides.flat_map(|side| &side.statements).filter_map(|statement| match statement {
        Statement::Erase(names, _) => Some(names),
        _ => None,
    });
    if erased.flatten().any(is_erased) {
        return None;
    }
    let params = op.params.iter().map(|param| snapshot.sources().slice(param.span));
    let params = params.collect::<Vec<_>>().join(", ");
    let mut text = format!("\n\nop {name}({params}) {{");
    for rule in &op.rules {
        let indentation = match &rule.name {
            Some(label) => {
                text.push_str(&format!("\n  rule {} {{", label.text));
                "    "
            }
            None => "  ",
        };
        text.push_str(&backwards(snapshot, rule, indentation)?);
        if rule.name.is_some() {
            text.push_str("\n  }");
        }
    }
    text.push_str("\n}");
    let span = op.span.after();
    Some(vec![Edit { span, text }])
}

fn backwards(snapshot: &Snapshot, rule: &Rule, indentation: &str) -> Option<String> {
    let (before, after) = (rule.before.as_ref()?, rule.after.as_ref()?);
    let (mut kept, mut assigned) = (Vec::new(), Vec::new());
    let (mut made, mut erased) = (Vec::new(), Vec::new());
    let mut first = Vec::new();
    for statement in &after.statements {
        match statement {
            Statement::New(names, _) => made.extend(names),
            Statement::Erase(names, _) => erased.extend(names),
            Statement::Keep(names, _) => kept.extend(names.iter().map(|name| &name.ident.text)),
            Statement::Assign { .. } => assigned.push(statement),
            Statement::Broken(_) => return None,
            drawn => first.push(slice(snapshot, drawn)),
        }
    }
    let is_kept = |statement: &&Statement| {
        subject(statement).is_some_and(|name| kept.contains(&&name.ident.text))
    };
    let stays = before.statements.iter().filter(is_kept);
    first.extend(stays.map(|statement| slice(snapshot, statement)));
    let list = |word: &str, names: &[&Name]| {
        let names = names.iter().map(|name| snapshot.sources().slice(name.span));
        let names = names.collect::<Vec<_>>().join(" ");
        (!names.is_empty()).then(|| format!("{word} {names}"))
    };
    let drawn = before.statements.iter().filter(|s| subject(s).is_some());
    let mut second: Vec<String> = list("new", &erased).into_iter().collect();
    second.extend(drawn.map(|statement| slice(snapshot, statement).to_owned()));
    second.extend(list("erase", &made));
    second.extend(restored(snapshot, &assigned, &made));
    let mut text = format!("\n{indentation}before {{");
    for statement in first {
        text.push_str(&format!("\n{indentation}  {statement}"));
    }
    text.push_str(&format!("\n{indentation}}}\n{indentation}after {{"));
    for statement in second {
        text.push_str(&format!("\n{indentation}  {statement}"));
    }
    text.push_str(&format!("\n{indentation}}}"));
    Some(text)
}

/// The assignments that undo those of a rule; a comment for each that cannot be undone. Assignments
/// to elements that the rule creates are left out, as the inverse erases these.
fn restored(snapshot: &Snapshot, assigned: &[&Statement], made: &[&Name]) -> Vec<String> {
    let is_made = |name: &Name| made.iter().any(|made| made.ident.text == name.ident.text);
    let mut lines = Vec::new();
    for statement in assigned {
        let Statement::Assign { target, attribute, value, .. } = statement else { continue };
        if is_made(target) {
            continue;
        }
        let place = Target { snapshot, target, attribute: &attribute.text, assigned, made };
        let line = match place.solved(value) {
            Some(old) => format!("{} = {old}", place.text()),
            None => format!("// has no inverse: {}", slice(snapshot, statement)),
        };
        lines.push(line);
    }
    lines
}

/// An attribute of an element that is assigned to.
struct Target<'s> {
    snapshot: &'s Snapshot,
    target: &'s Name,
    attribute: &'s str,
    assigned: &'s [&'s Statement],
    made: &'s [&'s Name],
}

impl Target<'_> {
    fn text(&self) -> String {
        let target = self.snapshot.sources().slice(self.target.span);
        format!("{target}.{}", self.attribute)
    }

    /// The old value, as an expression of the new one, which `value` has computed.
    fn solved(&self, value: &Expr) -> Option<String> {
        let mut old = self.text();
        let mut left = value;
        loop {
            match &left.kind {
                ExprKind::Field(..) if self.is(left) => return Some(bare(old)),
                ExprKind::Unary(UnaryOp::Negate, inner) => {
                    old = format!("(-{old})");
                    left = inner;
                }
                ExprKind::Binary(operator, one, other) => {
                    let (inner, known, is_first) = match (self.reads(one), self.reads(other)) {
                        (true, false) => (one, other, true),
                        (false, true) => (other, one, false),
                        _ => return None,
                    };
                    let known = self.stays(known)?;
                    old = match (operator, is_first) {
                        (BinaryOp::Add, _) => format!("({old} - {known})"),
                        (BinaryOp::Subtract, true) => format!("({old} + {known})"),
                        (BinaryOp::Subtract, false) => format!("({known} - {old})"),
                        (BinaryOp::Multiply, _) if self.divides() => format!("({old} / {known})"),
                        (BinaryOp::Divide, true) => format!("({old} * {known})"),
                        _ => return None,
                    };
                    left = inner;
                }
                _ => return None,
            }
        }
    }

    /// True if an expression is the attribute itself.
    fn is(&self, value: &Expr) -> bool {
        let ExprKind::Field(base, field) = &value.kind else { return false };
        let slice = |span| self.snapshot.sources().slice(span);
        field.text == self.attribute && slice(base.span) == slice(self.target.span)
    }

    /// True if an expression reads the attribute.
    fn reads(&self, value: &Expr) -> bool {
        let mut found = self.is(value);
        value.each_part(&mut |part| match part {
            Part::Expr(inner) => found |= self.reads(inner),
            Part::Block(_) => found = true,
        });
        found
    }

    /// An operand as it is written, if the op does not change its value: it consists of numbers,
    /// elements that exist before and after, and attributes of these that are not set.
    fn stays(&self, value: &Expr) -> Option<String> {
        let is_set = |attribute: &str| {
            let mut assigned = self.assigned.iter();
            assigned.any(|statement| matches!(statement, Statement::Assign { attribute: set, .. } if set.text == attribute))
        };
        let mut stays = match &value.kind {
            ExprKind::Field(base, field) => {
                let is_kept = self.is_attribute(&field.text) && !is_set(&field.text);
                is_kept && matches!(base.kind, ExprKind::Name(_))
            }
            ExprKind::Name(name) => {
                !self.made.iter().any(|made| made.ident.text == name.ident.text)
            }
            ExprKind::Int(_) | ExprKind::Real(_) | ExprKind::Unary(..) => true,
            ExprKind::Binary(..) => true,
            // What a function reads may have changed.
            _ => false,
        };
        value.each_part(&mut |part| {
            stays &= matches!(part, Part::Expr(inner) if self.stays(inner).is_some());
        });
        let text = self.snapshot.sources().slice(value.span);
        let is_one = !matches!(value.kind, ExprKind::Binary(..) | ExprKind::Unary(..));
        stays.then(|| if is_one { text.to_owned() } else { format!("({text})") })
    }

    /// True if a word names an attribute, and not a property that is derived from the mesh.
    fn is_attribute(&self, word: &str) -> bool {
        let mut known = Type::ALL.into_iter().flat_map(fields);
        self.declared(word).is_some() || known.any(|field| field.name == word && field.is_attribute)
    }

    /// True if a product of the attribute can be undone by a division: not if it is a whole number.
    fn divides(&self) -> bool {
        self.declared(self.attribute).is_none_or(|attr| attr.ty.text != "int")
    }

    /// The attribute of this name that the file, or one that it uses, declares.
    fn declared(&self, word: &str) -> Option<&Attr> {
        let mut items = self.snapshot.items().iter().chain(self.snapshot.seen_items(None));
        items.find_map(|item| match item {
            Item::Attr(attr) if attr.name.text == word => Some(attr),
            _ => None,
        })
    }
}

/// A value without the parentheses around the whole of it.
fn bare(value: String) -> String {
    match value.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
        Some(inner) => inner.to_owned(),
        None => value,
    }
}
