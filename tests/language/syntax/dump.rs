//! The tree in few words: a line for each statement, values in parentheses.

use hedgerow::syntax::tree::*;

/// The whole file.
pub fn dump(file: &File) -> String {
    let mut page = Page { out: String::new(), indent: 0 };
    page.docs(&file.docs);
    for item in &file.items {
        page.item(item);
    }
    page.out
}

struct Page {
    out: String,
    indent: usize,
}

impl Page {
    fn line(&mut self, text: impl AsRef<str>) {
        let text = format!("{}{}", "  ".repeat(self.indent), text.as_ref());
        self.out.push_str(text.trim_end());
        self.out.push('\n');
    }

    fn within(&mut self, write: impl FnOnce(&mut Self)) {
        self.indent += 1;
        write(self);
        self.indent -= 1;
    }

    fn docs(&mut self, docs: &[String]) {
        for doc in docs {
            self.line(format!("doc {doc:?}"));
        }
    }

    fn item(&mut self, item: &Item) {
        match item {
            Item::Use(path) => self.line(format!("use {:?}", path.path)),
            Item::Attr(attr) => {
                self.docs(&attr.docs);
                let private = private(attr.private);
                let default = optional(" = ", attr.default.as_ref().map(value));
                let (name, kind, ty) = (&attr.name.text, &attr.kind.text, &attr.ty.text);
                self.line(format!("{private}attr {name}: {kind} {ty}{default}"));
            }
            Item::Fn(f) => {
                self.docs(&f.docs);
                let result = optional(" -> ", f.result.as_ref().map(|ty| ty.text.clone()));
                let (private, name) = (private(f.private), &f.name.text);
                self.line(format!("{private}fn {name}{}{result}", params(&f.params)));
                self.block(&f.body);
            }
            Item::Op(op) => self.op(op),
            Item::Script(script) => {
                self.docs(&script.docs);
                let (private, name) = (private(script.private), &script.name.text);
                self.line(format!("{private}script {name}{}", params(&script.params)));
                self.block(&script.body);
            }
            Item::Test(test) => {
                self.line(format!("test {:?}", test.name));
                self.block(&test.body);
            }
            Item::Broken(_) => self.line("broken item"),
        }
    }

    fn op(&mut self, op: &Op) {
        self.docs(&op.docs);
        let result = optional(" -> ", op.result.as_ref().map(|name| name.text.clone()));
        let keeps: Vec<_> = op.keeps.iter().map(|level| level.text.as_str()).collect();
        let keeps = optional(" keeps ", (!keeps.is_empty()).then(|| keeps.join(" ")));
        let (private, name) = (private(op.private), &op.name.text);
        self.line(format!("{private}op {name}{}{result}{keeps}", params(&op.params)));
        for rule in &op.rules {
            self.within(|page| match &rule.name {
                Some(name) => {
                    page.line(format!("rule {}", name.text));
                    page.within(|page| page.rule(rule));
                }
                None => page.rule(rule),
            });
        }
    }

    fn rule(&mut self, rule: &Rule) {
        if let Some(before) = &rule.before {
            self.side("before", before);
        }
        for condition in &rule.conditions {
            match condition {
                Condition::Require { condition, reason, .. } => {
                    let reason = reason.as_ref().map(|(text, _)| format!("{text:?}"));
                    let reason = optional(" else ", reason);
                    self.line(format!("require {}{reason}", value(condition)));
                }
                Condition::Guard { level, .. } => self.line(format!("guard {}", level.text)),
                Condition::Alias { names, .. } => {
                    self.line(format!("alias {}", self::names(names)))
                }
            }
        }
        if let Some(after) = &rule.after {
            self.side("after", after);
        }
    }

    fn side(&mut self, word: &str, side: &Side) {
        self.line(word);
        self.within(|page| {
            for statement in &side.statements {
                page.line(drawn(statement));
            }
        });
    }

    fn block(&mut self, block: &Block) {
        self.within(|page| {
            for action in &block.statements {
                page.action(action);
            }
        });
    }

    fn action(&mut self, action: &Action) {
        match &action.kind {
            ActionKind::Let { mutable, name, ty, value: bound } => {
                let word = if *mutable { "var" } else { "let" };
                let ty = optional(": ", ty.as_ref().map(|ty| ty.text.clone()));
                self.line(format!("{word} {}{ty} = {}", name.text, value(bound)));
            }
            ActionKind::Assign { target, value: v } => {
                self.line(format!("set {} = {}", value(target), value(v)));
            }
            ActionKind::Repeat { count, body } => {
                self.line(format!("repeat {}", value(count)));
                self.block(body);
            }
            ActionKind::For { parallel, variable, sequence, filter, body } => {
                let word = if parallel.is_some() { "parallel for" } else { "for" };
                self.visit(word, variable, sequence, filter.as_ref(), body)
            }
            ActionKind::Update { variable, sequence, filter, body } => {
                self.visit("update", variable, sequence, filter.as_ref(), body)
            }
            ActionKind::While { condition, body } => {
                self.line(format!("while {}", value(condition)));
                self.block(body);
            }
            ActionKind::Drain { variable, sequence, key, condition, body } => {
                let condition = optional(" while ", condition.as_ref().map(value));
                let (variable, sequence) = (&variable.text, value(sequence));
                let key = value(key);
                self.line(format!("drain {variable} in {sequence} by {key}{condition}"));
                self.block(body);
            }
            ActionKind::If { binding, condition, then, otherwise } => {
                let binding = binding.as_ref().map(|name| format!("let {} = ", name.text));
                let binding = binding.unwrap_or_default();
                self.line(format!("if {binding}{}", value(condition)));
                self.block(then);
                if let Some(otherwise) = otherwise {
                    self.line("else");
                    self.block(otherwise);
                }
            }
            ActionKind::Print(values) => {
                let values: Vec<_> = values.iter().map(shown).collect();
                self.line(format!("print {}", values.join(" ")));
            }
            ActionKind::Assert { condition, reason } => {
                let reason = reason.as_ref().map(|(text, _)| format!("{text:?}"));
                let reason = optional(" else ", reason);
                self.line(format!("assert {}{reason}", value(condition)));
            }
            ActionKind::Require { condition, reason } => {
                let reason = reason.as_ref().map(|(text, _)| format!("{text:?}"));
                let reason = optional(" else ", reason);
                self.line(format!("require {}{reason}", value(condition)));
            }
            ActionKind::Return(back) => {
                let back = optional(" ", back.as_ref().map(value));
                self.line(format!("return{back}"));
            }
            ActionKind::Break => self.line("break"),
            ActionKind::Continue => self.line("continue"),
            ActionKind::Block(block) => {
                self.line("block");
                self.block(block);
            }
            ActionKind::Expr(expr) => self.line(value(expr)),
            ActionKind::Broken => self.line("broken"),
        }
    }

    fn visit(
        &mut self,
        word: &str,
        variable: &Ident,
        sequence: &Expr,
        filter: Option<&Expr>,
        body: &Block,
    ) {
        let filter = optional(" where ", filter.map(value));
        self.line(format!("{word} {} in {}{filter}", variable.text, value(sequence)));
        self.block(body);
    }
}

fn private(is_private: bool) -> &'static str {
    if is_private { "private " } else { "" }
}

fn optional(before: &str, text: Option<String>) -> String {
    text.map(|text| format!("{before}{text}")).unwrap_or_default()
}

fn params(params: &[Param]) -> String {
    let each = params.iter().map(|param| {
        let default = optional(" = ", param.default.as_ref().map(value));
        format!("{}: {}{default}", name(&param.name), param.ty.text)
    });
    format!("({})", each.collect::<Vec<_>>().join(", "))
}

fn name(name: &Name) -> String {
    let word = &name.ident.text;
    let Some(Index { variable, offset, .. }) = &name.index else {
        return word.clone();
    };
    match variable {
        Some(variable) if *offset == 0 => format!("{word}[{}]", variable.text),
        Some(variable) => format!("{word}[{}{offset:+}]", variable.text),
        None => format!("{word}[{offset}]"),
    }
}

fn names(all: &[Name]) -> String {
    all.iter().map(name).collect::<Vec<_>>().join(" ")
}

fn drawn(statement: &Statement) -> String {
    match statement {
        Statement::Loop(one) => {
            let keyword = match one.keyword {
                LoopKeyword::Face => "face",
                LoopKeyword::Hole => "hole",
                LoopKeyword::Loop => "loop",
            };
            let mut out = format!("{keyword} {}:{}", name(&one.name), each(&one.each));
            for item in &one.items {
                let arrow = match &item.arrow {
                    Arrow::Halfedge(halfedge) => format!("-{}-", name(halfedge)),
                    Arrow::Path(Some(path)) => format!("={}=", name(path)),
                    Arrow::Path(None) => "==".to_owned(),
                };
                out.push_str(&format!(" {} {arrow}", name(&item.from)));
            }
            out + &optional(" ", one.end.as_ref().map(name))
        }
        Statement::Edge { name: edge, halfedges: [one, other], .. } => {
            format!("edge {}: {} {}", name(edge), name(one), name(other))
        }
        Statement::Vertex(star) => {
            let mut out = format!("vertex {}:{}", name(&star.name), each(&star.each));
            for spoke in &star.spokes {
                let spoke = match spoke {
                    Spoke::Halfedge(halfedge) => name(halfedge),
                    Spoke::Fan(Some(fan), _) => format!("fan({})", name(fan)),
                    Spoke::Fan(None, _) => "fan".to_owned(),
                };
                out.push_str(&format!(" {spoke}"));
            }
            out
        }
        Statement::New(all, _) => format!("new {}", names(all)),
        Statement::Erase(all, _) => format!("erase {}", names(all)),
        Statement::Keep(all, _) => format!("keep {}", names(all)),
        Statement::Assign { target, attribute, value: v, .. } => {
            format!("set {}.{} = {}", name(target), attribute.text, value(v))
        }
        Statement::Broken(_) => "broken".to_owned(),
    }
}

fn each(variable: &Option<Ident>) -> String {
    optional(" each ", variable.as_ref().map(|name| name.text.clone()))
}

/// What is printed between two commas.
fn shown(shown: &Shown) -> String {
    match shown {
        Shown::Value(printed) => value(printed),
        Shown::Text(pieces, _) => {
            let piece = |piece: &Piece| match piece {
                Piece::Text(text) => format!("{text:?}"),
                Piece::Value(of, Digits::Few) => value(of),
                Piece::Value(of, digits) => format!("({digits:?} {})", value(of)),
            };
            let pieces: Vec<_> = pieces.iter().map(piece).collect();
            format!("(text {})", pieces.join(" "))
        }
    }
}

fn value(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Bool(value) => value.to_string(),
        ExprKind::Int(value) => value.to_string(),
        ExprKind::Real(value) => format!("{value:?}"),
        ExprKind::Text(text) => format!("{text:?}"),
        ExprKind::Name(one) => name(one),
        ExprKind::Field(of, field) => format!("{}.{}", value(of), field.text),
        ExprKind::Call { function, args } => {
            let args: String = args.iter().map(|arg| format!(" {}", value(arg))).collect();
            format!("({}{args})", function.text)
        }
        ExprKind::Must(call) => format!("(must {})", value(call)),
        ExprKind::Asked(Asking::Can, call) => format!("(can {})", value(call)),
        ExprKind::Asked(Asking::Why, call) => format!("(why {})", value(call)),
        ExprKind::Unary(UnaryOp::Negate, of) => format!("(neg {})", value(of)),
        ExprKind::Unary(UnaryOp::Not, of) => format!("(not {})", value(of)),
        ExprKind::Range(first, end) => format!("(range {} {})", value(first), value(end)),
        ExprKind::Binary(op, left, right) => {
            format!("({} {} {})", operator(*op), value(left), value(right))
        }
        ExprKind::If { condition, then, otherwise } => {
            format!("(if {} {} {})", value(condition), branch(then), branch(otherwise))
        }
        ExprKind::Aggregate { function, body, variable, sequence, filter } => {
            let filter = optional(" where ", filter.as_deref().map(value));
            let (function, variable) = (&function.text, &variable.text);
            let (body, sequence) = (value(body), value(sequence));
            format!("({function} {body} for {variable} in {sequence}{filter})")
        }
        ExprKind::Broken => "broken".to_owned(),
    }
}

/// A branch in one line.
fn branch(block: &Block) -> String {
    let mut page = Page { out: String::new(), indent: 0 };
    page.block(block);
    let lines: Vec<_> = page.out.lines().map(str::trim).collect();
    format!("{{{}}}", lines.join("; "))
}

fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Div => "div",
        BinaryOp::Mod => "mod",
        BinaryOp::Equal => "==",
        BinaryOp::NotEqual => "!=",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::And => "and",
        BinaryOp::Or => "or",
    }
}
