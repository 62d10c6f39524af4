//! Aggregates as text: in Rust chains of iterators, in C++ calls of support functions.

use super::Printer;
use crate::diagram::{FoldFunction, Type};
use crate::emit::matrix::is_wide;
use crate::emit::term::Fold;

impl Printer<'_> {
    pub(super) fn aggregate(&self, fold: &Fold) -> String {
        let Fold { variable, function, .. } = fold;
        let (name, of) = (&variable.name, self.ty(variable.ty));
        let mut all = self.all_around(fold.around, &fold.element);
        if let Some(filter) = &fold.filter {
            let filter = self.text(filter);
            all = say!(
                self,
                "{all}.filter(|&{name}| {filter})",
                "hedgerow::only({all}, [&]({of} {name}) {{ return {filter}; }})"
            );
        }
        let body = match (fold.body_type, fold.ty) {
            (Type::Int, Type::Real) => self.to_real(self.spell(&fold.body)).text,
            _ => self.text(&fold.body),
        };
        // A count of all elements does not use the variable.
        let mut reads = false;
        fold.body.names(&mut |read| reads |= read == name);
        let bound = match reads {
            true => say!(self, "{name}", "{of} {name}"),
            false => say!(self, "_", "{of}"),
        };
        let each = say!(self, "|{bound}| {body}", "[&]({bound}) {{ return {body}; }}");
        let (ty, size) = (self.ty(fold.ty), fold.ty.size());
        let zero = match fold.ty {
            Type::Vec3 => "hedgerow::vector(0, 0, 0)".to_string(),
            Type::Int => "0LL".into(),
            _ => format!("{ty}(0)"),
        };
        let (nothing, values) = ("a value of nothing", format!("{all}.map({each})"));
        match function {
            FoldFunction::Any => say!(self, "{all}.any({each})", "hedgerow::any({all}, {each})"),
            FoldFunction::All => say!(self, "{all}.all({each})", "hedgerow::all({all}, {each})"),
            FoldFunction::Count => {
                let reference = if reads { "&" } else { "" };
                say!(
                    self,
                    "({all}.filter(|{reference}{bound}| {body}).count() as i64)",
                    "hedgerow::count({all}, {each})"
                )
            }
            FoldFunction::Sum if is_wide(fold.ty) => {
                say!(self, "{values}.sum::<{ty}>()", "hedgerow::total<{size}, {ty}>({all}, {each})")
            }
            FoldFunction::Sum => {
                say!(self, "{values}.sum::<{ty}>()", "hedgerow::sum({all}, {zero}, {each})")
            }
            FoldFunction::Mean => {
                let mean = match is_wide(fold.ty) {
                    true => format!("average<{size}, {ty}>({all}, {each})"),
                    false => format!("mean({all}, {zero}, {each})"),
                };
                say!(
                    self,
                    "{{ let all = {values}.collect::<Vec<{ty}>>(); assert!(!all.is_empty(), \"{nothing}\"); all.iter().copied().sum::<{ty}>() / all.len() as f64 }}",
                    "hedgerow::{mean}"
                )
            }
            FoldFunction::Min => say!(
                self,
                "{values}.reduce({ty}::min).expect(\"{nothing}\")",
                "hedgerow::least({all}, {zero}, {each})"
            ),
            FoldFunction::Max => say!(
                self,
                "{values}.reduce({ty}::max).expect(\"{nothing}\")",
                "hedgerow::greatest({all}, {zero}, {each})"
            ),
            FoldFunction::ArgMin => {
                say!(self, "least_of({all}, {each})", "hedgerow::least_of({all}, {each})")
            }
            FoldFunction::ArgMax => {
                say!(self, "greatest_of({all}, {each})", "hedgerow::greatest_of({all}, {each})")
            }
        }
    }
}
