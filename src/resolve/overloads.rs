//! Calls of built-in functions: the overload is chosen by the types of the arguments.

use crate::diagnostic::{Diagnostic, Edit, Fix, one_of};
use crate::diagram::{Access, Expr, ExprKind, Overload, Type, Wanted, overloads};
use crate::source::Span;
use crate::syntax::tree::{self, Ident};

use super::builtin::{SHUFFLE, function_names};
use super::constructors::{constructed, ways};
use super::declared::What;
use super::foreign_words::constant_called;
use super::neighbor::near;
use super::sequence::is_sequence;
use super::sequence_names::fold_names;
use super::signature::{Parameter, Value};
use super::testing::mesh_maker;
use super::typed::{to_real, typed};
use super::typing::{Place, Typing};
use super::vocabulary::called;
use super::words::{are_given, arguments, short, subject};

/// How well a type fits a parameter.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    No,
    Converted,
    Exact,
}

fn fit(wanted: Wanted, ty: Type) -> Fit {
    match (wanted, ty) {
        (Wanted::Is(wanted), ty) if wanted == ty => Fit::Exact,
        (Wanted::Is(Type::Real), Type::Int) => Fit::Converted,
        (Wanted::Point, Type::Vec3) => Fit::Exact,
        (Wanted::Point, Type::Vertex) => Fit::Converted,
        _ => Fit::No,
    }
}

/// The worst fit among the arguments.
fn fit_all(overload: &Overload, args: &[Expr]) -> Fit {
    let fits = overload.wanted.iter().zip(args).map(|(wanted, arg)| fit(*wanted, arg.ty));
    fits.min().unwrap_or(Fit::Exact)
}

/// Converts an argument to the type of its parameter.
fn convert(wanted: Wanted, arg: Expr) -> Expr {
    match (wanted, arg.ty) {
        (Wanted::Is(Type::Real), Type::Int) => to_real(arg),
        (Wanted::Point, Type::Vertex) => {
            let span = arg.span;
            let kind = ExprKind::Read(Access::Position, Box::new(arg));
            typed(Type::Vec3, kind, span)
        }
        _ => arg,
    }
}

/// The note on what a function means for an argument of a type that it does not take in this place.
fn combined(function: &Ident, written: &tree::Expr, ty: Type) -> Option<String> {
    let (word, text) = (function.text.as_str(), short(written, 3)?);
    if word == "cotangent" && ty == Type::Edge {
        let weight = "(cotangent(h) + cotangent(h.twin)) / 2";
        return Some(format!(
            "with `let h = {text}.halfedge`, the weight of an edge is `{weight}`"
        ));
    }
    if word == "transpose" && ty.is_vector() {
        return Some("a column times a row is `outer(p, q)`".into());
    }
    let alone = overloads(word).iter().any(|way| way.wanted == [Wanted::Is(ty)]);
    alone.then(|| format!("of {} alone it is `{word}({text})`", ty.a_word()))
}

/// True if parameters take arguments of these types, as far as they are known.
pub(super) fn takes(params: &[Parameter], given: &[Option<Type>]) -> bool {
    let wanted = params.iter().map(|param| param.ty.map(Wanted::Is));
    given.len() <= params.len()
        && params[given.len()..].iter().all(|param| param.optional)
        && wanted.zip(given).all(|(wanted, ty)| may_fit(wanted, *ty))
}

/// True if a function of the language takes arguments of these types, as far as they are known.
fn language_takes(word: &str, given: &[Option<Type>]) -> bool {
    if let Some(ty) = constructed(word) {
        let fits = |(wanted, ty): (&&str, &Option<Type>)| {
            may_fit(Type::named(wanted).map(Wanted::Is), *ty)
        };
        let takes = |way: &&[&str]| way.len() == given.len() && way.iter().zip(given).all(fits);
        return ways(ty).iter().any(takes);
    }
    let takes = |way: &Overload| {
        let mut fits = way.wanted.iter().zip(given);
        way.wanted.len() == given.len() && fits.all(|(wanted, ty)| may_fit(Some(*wanted), *ty))
    };
    word == SHUFFLE
        || given.len() == 1 && fold_names().any(|known| known == word)
        || overloads(word).iter().any(takes)
}

fn may_fit(wanted: Option<Wanted>, ty: Option<Type>) -> bool {
    wanted.zip(ty).is_none_or(|(wanted, ty)| fit(wanted, ty) > Fit::No)
}

/// True for a literal, a name and its fields, and for a call of such.
fn is_simple(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Call { args, .. } => args.iter().all(is_plain),
        _ => is_plain(expr),
    }
}

/// True for a literal, a name and its fields.
fn is_plain(expr: &tree::Expr) -> bool {
    use tree::ExprKind::{Bool, Field, Int, Name, Real, Text};
    match &expr.kind {
        Bool(_) | Int(_) | Real(_) | Text(_) | Name(_) => true,
        Field(base, _) => is_plain(base),
        _ => false,
    }
}

impl Typing<'_> {
    /// The types of arguments, where they are simple and known.
    pub(super) fn simple_types(&mut self, args: &[tree::Expr]) -> Vec<Option<Type>> {
        let simple = |arg| {
            let value = is_simple(arg).then(|| self.quietly(|typing| typing.expression(arg)));
            value.flatten().map(|value| value.ty)
        };
        args.iter().map(simple).collect()
    }

    /// `f(x, y)`
    pub(super) fn call(
        &mut self,
        function: &Ident,
        args: &[tree::Expr],
        span: Span,
    ) -> Option<Expr> {
        let word = function.text.as_str();
        if let Some(ty) = constructed(word) {
            return self.construct(ty, function, args, span);
        }
        if word == "count" || (fold_names().any(|known| known == word) && args.len() == 1) {
            return self.count(function, args, span);
        }
        if let Some(value) = self.invoked(function, args, span) {
            return value;
        }
        if word == SHUFFLE {
            let message =
                "`shuffle` gives an order to what `for` visits, and stands behind its `in`";
            return self.report.reject(Diagnostic::error("not-a-value", message, span));
        }
        let known = overloads(word);
        if known.iter().any(|way| way.builtin.is_random()) && !matches!(self.place, Place::Script) {
            let message = "an op or a default does the same each time, so nothing is random here";
            let error = Diagnostic::error("misplaced-random", message, span);
            return self.report.reject(error.note("give the number to it as an argument"));
        }
        if known.is_empty() {
            let is_meant = self.unknown_function(function, args, span);
            // The arguments may contain further errors. A sequence is skipped: such a function may
            // have been expected to take one.
            for arg in args.iter().filter(|arg| is_meant && !is_sequence(arg)) {
                self.expression(arg);
            }
            return None;
        }
        let values: Vec<Option<Expr>> = args.iter().map(|arg| self.expression(arg)).collect();
        let counts = known.iter().map(|way| way.wanted.len());
        let count = counts.clone().find(|count| *count == args.len()).or(counts.max()).unwrap_or(0);
        if word == "midpoint" && args.len() == 2 {
            self.middle_of_two(args, &values, span);
            return None;
        }
        if matches!(word, "min" | "max") && args.len() > 2 {
            self.of_several(function, args, span);
            return None;
        }
        self.right_count(function, count, args.len(), span)?;
        let values: Vec<Expr> = values.into_iter().collect::<Option<_>>()?;
        // The best fit wins; among equals, the first.
        let known: Vec<&Overload> =
            known.iter().filter(|way| way.wanted.len() == values.len()).collect();
        let ranked = known.iter().rev().map(|way| (fit_all(way, &values), way));
        match ranked.max_by_key(|(fit, _)| *fit) {
            Some((fit, way)) if fit > Fit::No => {
                let values = way.wanted.iter().zip(values).map(|(w, arg)| convert(*w, arg));
                let kind = ExprKind::Call(way.builtin, values.collect());
                Some(typed(way.result, kind, span))
            }
            _ => {
                self.no_overload(function, &known, args, &values);
                None
            }
        }
    }

    /// Reports a wrong number of arguments.
    pub(super) fn right_count(
        &mut self,
        function: &Ident,
        wanted: usize,
        given: usize,
        span: Span,
    ) -> Option<()> {
        if wanted == given {
            return Some(());
        }
        let message =
            format!("`{}` takes {}, but {}", function.text, arguments(wanted), are_given(given));
        let error = Diagnostic::error("wrong-count", message, span);
        let ways = called(&function.text);
        let error = error.when(!ways.is_empty(), |error| error.note(format!("it is {ways}")));
        let is_distance = function.text == "length" && given == 2;
        self.report.reject(error.when(is_distance, |error| {
            error.note("how far two points are apart is `distance(v, w)`")
        }))
    }

    /// Reports `max(a, b, c)`, which is `max(max(a, b), c)`.
    fn of_several(&mut self, function: &Ident, args: &[tree::Expr], span: Span) {
        let word = &function.text;
        let message = format!("`{word}` takes {}, but {}", arguments(2), are_given(args.len()));
        let error = Diagnostic::error("wrong-count", message, span);
        let inner = args.len() - 2;
        let edit = |span, text| Edit { span, text };
        let first = edit(args[0].span.before(), format!("{word}(").repeat(inner));
        let closed = args[1..=inner].iter().map(|arg| edit(arg.span.after(), ")".to_owned()));
        let edits = std::iter::once(first).chain(closed).collect();
        let title = format!("write `{0}({0}(a, b), c)`", word);
        self.report.add(Diagnostic { fixes: vec![Fix { title, edits }], ..error });
    }

    /// Reports `midpoint(v, w)`, which is `mix` of the two points.
    fn middle_of_two(&mut self, args: &[tree::Expr], values: &[Option<Expr>], span: Span) {
        let message = "`midpoint` takes an edge, but 2 arguments are given";
        let error = Diagnostic::error("wrong-count", message, span)
            .note("the middle of an edge is `midpoint(e)`");
        let point = |(arg, value): (&tree::Expr, &Option<Expr>)| {
            let text = short(arg, 3)?;
            match value.as_ref()?.ty {
                Type::Vertex => Some(format!("{text}.position")),
                Type::Vec3 if !text.contains('(') => Some(text),
                _ => None,
            }
        };
        let points: Option<Vec<String>> = args.iter().zip(values).map(point).collect();
        self.report.add(match points {
            Some(points) => {
                let text = format!("mix({}, 0.5)", points.join(", "));
                error.note("the middle of two points is `mix(p, q, 0.5)`").fix(
                    format!("write `{text}`"),
                    span,
                    text,
                )
            }
            None => error.note("the middle of two points is `mix(v.position, w.position, 0.5)`"),
        });
    }

    /// Reports the first argument that rules out every remaining overload.
    fn no_overload(
        &mut self,
        function: &Ident,
        known: &[&Overload],
        args: &[tree::Expr],
        values: &[Expr],
    ) {
        let mut left: Vec<&Overload> = known.to_vec();
        for (place, (written, value)) in args.iter().zip(values).enumerate() {
            let fits = |way: &&&Overload| fit(way.wanted[place], value.ty) > Fit::No;
            let still: Vec<&Overload> = left.iter().filter(fits).copied().collect();
            if still.is_empty() {
                let mut types: Vec<Type> = Vec::new();
                for way in &left {
                    let wanted: &[Type] = match &way.wanted[place] {
                        Wanted::Is(ty) => std::slice::from_ref(ty),
                        Wanted::Point => &[Type::Vertex, Type::Vec3],
                    };
                    for ty in wanted {
                        if !types.contains(ty) {
                            types.push(*ty);
                        }
                    }
                }
                let message = format!(
                    "`{}` wants {}, but {} is {}",
                    function.text,
                    one_of(types.iter().map(|ty| ty.a_word())),
                    subject(written),
                    value.ty.a_word()
                );
                let error = Diagnostic::error("type-mismatch", message, written.span)
                    .saying(format!("this is {}", value.ty.a_word()));
                // One halfedge of several is meant least.
                types.sort_by_key(|ty| *ty == Type::Halfedge);
                let meant = types.into_iter().find_map(|ty| near(written, value.ty, ty));
                let meant = combined(function, written, value.ty).or(meant);
                self.report.add(meant.into_iter().fold(error, Diagnostic::note));
                return;
            }
            left = still;
        }
        // Unreachable as long as an overload fits if each of its arguments does.
        self.report.fail();
    }

    /// Reports a function that an expression cannot call; true if it is known what was meant, so
    /// that the arguments can be checked.
    fn unknown_function(&mut self, function: &Ident, args: &[tree::Expr], span: Span) -> bool {
        let word = function.text.as_str();
        if self.declared.op(word).is_some() {
            self.op_in_expression(word, span);
            return false;
        }
        if let Some(called) = self.declared.called(word) {
            let of = match self.place {
                Place::Default(of) => of,
                Place::Rule(_) | Place::Script => "a parameter",
            };
            let message = format!(
                "`{word}` cannot be called in the default of {of}, which calls no functions of the \
                 program"
            );
            let error = Diagnostic::error("unknown-function", message, function.span);
            self.report.add(
                error
                    .label(called.span, "it is declared here")
                    .note("such a default is computed before there are functions: write its value"),
            );
            return false;
        }
        if self.declared.lacks_files() {
            // The missing file has been reported already.
            self.report.fail();
            return false;
        }
        if mesh_maker(word).is_some() && self.report.is_suppressed("mesh") {
            // That a script cannot name a mesh has been reported.
            self.report.fail();
            return false;
        }
        if fold_names().any(|known| known == word) {
            let message = format!(
                "`{word}` wants a value for each element: `{word}(length(e) for e in edges)`"
            );
            self.report.add(Diagnostic::error("type-mismatch", message, span));
            return false;
        }
        let message = format!("there is no function `{word}`");
        let error = Diagnostic::error("unknown-function", message, function.span);
        if let Some(element) = self.declared.element_with(word) {
            let note = format!("an attribute stands behind its {}: `x.{word}`", element.word());
            self.report.add(error.note(note));
            return false;
        }
        let declared = self.declared;
        let mut candidates: Vec<&str> = function_names().chain(fold_names()).collect();
        candidates.extend(declared.called_names());
        let types = self.simple_types(args);
        let fits = |meant: &str| match (declared.called(meant), declared.function(meant)) {
            (Some(named), _) if named.what != What::Function => false,
            (_, Some(known)) => known.result != Value::Nothing && takes(&known.params, &types),
            _ => language_takes(meant, &types),
        };
        let error = constant_called(error, function, args, span)
            .unwrap_or_else(|error| declared.tell_what_is_meant(error, function, candidates, fits));
        let is_meant = !error.fixes.is_empty();
        self.report.add(error);
        is_meant
    }

    /// Reports an op inside an expression: it rewrites the mesh.
    fn op_in_expression(&mut self, op: &str, span: Span) {
        let message = format!("`{op}` is an op; it cannot be called inside of an expression");
        self.report.add(Diagnostic::error("op-in-expression", message, span).note(format!(
            "an op stands as a statement `{op}(…)`, as the condition of `if` or `if let x =`, \
             or after `let x = must`; what is done where it is refused stands in `else {{ … }}`, and \
             whether it would apply is asked by `can {op}(…)`"
        )));
    }

    /// Reports `must f(x)` where a value is required.
    pub(super) fn misplaced_must<T>(&mut self, inner: &tree::Expr, span: Span) -> Option<T> {
        match &inner.kind {
            tree::ExprKind::Call { function, .. } if self.declared.op(&function.text).is_some() => {
                self.op_in_expression(&function.text, span);
            }
            tree::ExprKind::Broken => self.report.fail(),
            _ => {
                let message = "`must` stands before the call of an op";
                self.report.add(Diagnostic::error("misplaced-must", message, span));
            }
        }
        None
    }
}
