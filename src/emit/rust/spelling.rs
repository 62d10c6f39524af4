//! Terms as Rust.

use super::super::builtin::{self, spelled, with_arguments};
use super::super::language::{Language, Level, Spelled, field, infix, number, spell};
use super::super::names::invoked;
use super::super::support::names;
use super::super::term::{Around, Attribute, Fold, Function, IndexLoop, Operation, Term};
use super::super::wide::with_types;
use super::function::{Printer, ty};
use crate::diagram::{Binary, Builtin, FoldFunction, Pointer, Type};

impl Language for Printer {
    fn real(&self, value: f64) -> Spelled {
        number(value, ["f64::INFINITY", "f64::NAN"])
    }

    fn int(&self, value: i64) -> Spelled {
        match value {
            0.. => Spelled::whole(value.to_string()),
            _ => Spelled::new(value.to_string(), Level::Prefix),
        }
    }

    fn follow(&self, pointer: Pointer, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.{}({})", field(pointer), of.text))
    }

    fn position(&self, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.position({})", of.text))
    }

    fn attribute(&self, attribute: &Attribute, of: Spelled) -> Spelled {
        let (ty, column) = (ty(attribute.ty), &attribute.column);
        let of = of.at(Level::Whole);
        Spelled::whole(format!("attribute::<{ty}>(mesh, {column}, {of}.0)"))
    }

    fn hole(&self, of: Spelled) -> Spelled {
        Spelled::whole(format!("mesh.is_hole({})", of.text))
    }

    fn vector(&self, parts: [Spelled; 3]) -> Spelled {
        let parts = parts.map(|part| part.text).join(", ");
        Spelled::whole(format!("DVec3::new({parts})"))
    }

    fn choice(&self, condition: Spelled, then: Spelled, otherwise: Spelled) -> Spelled {
        let text =
            format!("if {} {{ {} }} else {{ {} }}", condition.text, then.text, otherwise.text);
        Spelled::new(text, Level::Choice)
    }

    fn to_real(&self, of: Spelled) -> Spelled {
        // `as` binds more tightly than a comparison, but `x as f64 < y` reads as a type.
        Spelled::new(format!("{} as f64", of.at(Level::Prefix)), Level::Compare)
    }

    fn call(&self, function: Function, args: Vec<Spelled>) -> Spelled {
        let [call, _] = spelled(function);
        let (level, inner) = match function {
            Function::Of(Operation::Operator(operator), _) => {
                let sides = args.try_into().expect("an operator has two sides");
                return infix(operator, sides);
            }
            Function::Builtin(Builtin::MixReal) => (Level::Sum, Level::Product),
            Function::Remainder => (Level::Product, Level::Choice),
            Function::Of(Operation::Negate, _) => (Level::Prefix, Level::Choice),
            // After a call that ends with a type, `<` would begin generic arguments.
            _ if call.ends_with("as i64") => (Level::Compare, Level::Choice),
            _ => (Level::Whole, Level::Choice),
        };
        let call = match function {
            Function::Of(operation, of) => with_types(call, operation, of, |of| ty(of).into()),
            _ => call.to_string(),
        };
        Spelled::new(with_arguments(&call, &args, inner), level)
    }

    fn invoke(&self, name: &str, args: Vec<Spelled>) -> Spelled {
        let args = args.into_iter().map(|arg| format!(", {}", arg.text));
        let args = args.collect::<String>();
        Spelled::whole(format!("{}(mesh{args})", invoked(name)))
    }

    fn operator(&self, operator: Binary, args: &[Spelled; 2]) -> Option<Spelled> {
        let [left, right] = args.clone().map(|arg| arg.at(Level::Whole));
        Some(Spelled::whole(match operator {
            // Rounded down: Euclidean division does so only for a positive divisor.
            Binary::Div => format!(
                "({left} / {right} - i64::from({left} % {right} != 0 && ({left} < 0) != ({right} < 0)))"
            ),
            Binary::Mod => format!("(({left} % {right} + {right}) % {right})"),
            _ => return None,
        }))
    }

    fn some(&self, indices: &IndexLoop, condition: &Term) -> Spelled {
        let condition = self.text(condition);
        let IndexLoop { index, size } = indices;
        Spelled::whole(format!("(0..{size}).any(|{index}| {condition})"))
    }

    fn fold(&self, fold: &Fold) -> Spelled {
        let mut all = self.all_around(fold.around, &fold.element);
        let variable = &fold.variable.name;
        if let Some(filter) = &fold.filter {
            let filter = self.text(filter);
            all = format!("{all}.filter(|&{variable}| {filter})");
        }
        let body = spell(self, &fold.body);
        let body = match (fold.body_type, fold.ty) {
            (Type::Int, Type::Real) => self.to_real(body),
            _ => body,
        };
        // A count of all elements does not use the variable.
        let (body, of) = (body.text, ty(fold.ty));
        let bound = match names(&body, variable) {
            true => variable.as_str(),
            false => "_",
        };
        let (nothing, values) = ("a value of nothing", format!("{all}.map(|{bound}| {body})"));
        Spelled::whole(match fold.function {
            FoldFunction::Any => format!("{all}.any(|{bound}| {body})"),
            FoldFunction::All => format!("{all}.all(|{bound}| {body})"),
            FoldFunction::Count => {
                format!("({all}.filter(|&{bound}| {body}).count() as i64)").replace("|&_|", "|_|")
            }
            FoldFunction::Sum => format!("{values}.sum::<{of}>()"),
            FoldFunction::Mean => {
                let values = format!("{values}.collect::<Vec<{of}>>()");
                format!(
                    "{{ let all = {values}; assert!(!all.is_empty(), \"{nothing}\"); all.iter().copied().sum::<{of}>() / all.len() as f64 }}"
                )
            }
            FoldFunction::Min => format!("{values}.reduce({of}::min).expect(\"{nothing}\")"),
            FoldFunction::Max => format!("{values}.reduce({of}::max).expect(\"{nothing}\")"),
            FoldFunction::ArgMin => format!("least_of({all}, |{bound}| {body})"),
            FoldFunction::ArgMax => format!("greatest_of({all}, |{bound}| {body})"),
        })
    }
}

impl Printer {
    /// An iterator over the elements around an element.
    pub(super) fn all_around(&self, around: Around, element: &Term) -> String {
        let [call, _] = builtin::around(around);
        with_arguments(call, &[spell(self, element)], Level::Choice)
    }
}
