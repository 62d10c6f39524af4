//! Aggregates as text: in Rust chains of iterators, in C++ calls of support functions.

use super::language::is_wide;
use super::spellings::spelling;
use super::term::{Precedence, Term};
use crate::diagram::{Around, Collection, Expr, Fold, Type};
use crate::emit::NotEmitted;
use crate::emit::language::filled;
use crate::emit::names::Names;
use crate::source::Span;

impl Names<'_> {
    /// The elements around another; those of the whole mesh are not emitted.
    pub fn around(&mut self, collection: &Collection, span: Span) -> Result<Term, NotEmitted> {
        let what = match collection {
            Collection::All(_) => "a sequence of the whole mesh",
            Collection::Around(Around::FaceEars, _) => "`ears` of a face",
            Collection::Around(Around::FacePatch, _) => "the `patch` of a face",
            Collection::Around(around, element) => {
                let element = self.value(element)?;
                return Ok(self.language.call(&format!("{around:?}"), [&element]));
            }
        };
        Err(NotEmitted::new(what, span))
    }

    /// An aggregate over the elements around one.
    pub(super) fn aggregate(&mut self, fold: &Fold, whole: &Expr) -> Result<Term, NotEmitted> {
        let (language, ty) = (self.language, whole.ty);
        let elements = self.around(&fold.collection, whole.span)?;
        let name = self.declare(fold.variable, fold.collection.element());
        let filter = fold.filter.as_ref().map(|filter| self.value(filter)).transpose()?;
        let mut value = self.value(&fold.body)?;
        if (fold.body.ty, ty) == (Type::Int, Type::Real) {
            value = language.to_real(&value);
        }
        let of = language.ty(fold.collection.element());
        let mut all = elements.text.clone();
        // What does not use the variable does not name it: compilers would warn.
        let named = |term: &Term| match term.names.contains(&name) {
            true => say!(language, "{name}", "{of} {name}"),
            false => say!(language, "_", "{of}"),
        };
        let by = |bound: &str| if bound == "_" { "" } else { "&" };
        if let Some(filter) = &filter {
            let (bound, text) = (named(filter), &filter.text);
            let by = by(&bound);
            all = say!(
                language,
                "{all}.filter(|{by}{bound}| {text})",
                "hedgerow::only({all}, [&]({bound}) {{ return {text}; }})"
            );
        }
        let bound = named(&value);
        let body = &value.text;
        let each = say!(language, "|{bound}| {body}", "[&]({bound}) {{ return {body}; }}");
        let of = if is_wide(ty) { "of." } else { "" };
        let name = format!("all.{of}{:?}", fold.function);
        let text = filled(spelling(language, &name, ty), |part, _, _| {
            Some(match part {
                "all" => all.clone(),
                "each" => each.clone(),
                "by" => by(&bound).to_string(),
                "bound" => bound.clone(),
                "body" => body.clone(),
                "zero" => language.call_of("zero", (ty, 0), []).text,
                "T" => language.ty(ty),
                "N" => ty.size().to_string(),
                _ => return None,
            })
        });
        let parts = [&elements].into_iter().chain(&filter).chain([&value]);
        Ok(Term::of(text, Precedence::Whole, parts))
    }
}
