//! Terms as C++.

use super::super::builtin::{self, spelled, with_arguments};
use super::super::language::{Language, Level, Spelled, number, short_number, spell};
use super::super::matrix::is_wide;
use super::super::names::invoked;
use super::super::term::{Around, Attribute, Fold, Function, IndexLoop, Term};
use super::super::wide::with_types;
use super::function::Printer;
use super::support::{qualified, with_pointers};
use crate::diagram::{Binary, FoldFunction, Pointer, Type};

/// From here on a number is written as a `long long`.
const SHORT: i64 = 1 << 15;

impl Language for Printer<'_> {
    fn real(&self, value: f64) -> Spelled {
        let real = self.style.name("real");
        let limit = |what| format!("std::numeric_limits<{real}>::{what}()");
        let [infinite, none] = ["infinity", "quiet_NaN"].map(limit);
        match real {
            // With a `double`, the whole computation would be in `double`.
            "float" => short_number(value, [&infinite, &none]),
            _ => number(value, [&infinite, &none]),
        }
    }

    fn int(&self, value: i64) -> Spelled {
        match value {
            i64::MIN => Spelled::whole("(-9223372036854775807LL - 1)"),
            // Computations with larger ones could overflow an `int`.
            0..SHORT => Spelled::whole(value.to_string()),
            SHORT.. => Spelled::whole(format!("{value}LL")),
            _ => Spelled::new(format!("-{}", self.int(-value).text), Level::Prefix),
        }
    }

    fn follow(&self, pointer: Pointer, of: Spelled) -> Spelled {
        let of = of.at(Level::Whole);
        match (pointer, self.style.read(&of, pointer)) {
            (_, Some(text)) => Spelled::whole(text),
            (Pointer::Target, None) => {
                Spelled::whole(self.style.chained(&self.style.chained(&of, "twin"), "vertex"))
            }
            (_, None) => Spelled::whole(self.support("prev", vec![of])),
        }
    }

    fn position(&self, of: Spelled) -> Spelled {
        Spelled::whole(self.style.chained(&of.at(Level::Whole), "position"))
    }

    fn attribute(&self, attribute: &Attribute, of: Spelled) -> Spelled {
        let of = of.at(Level::Whole);
        Spelled::whole(self.style.attribute(&of, &attribute.name))
    }

    fn hole(&self, of: Spelled) -> Spelled {
        Spelled::whole(self.style.chained(&of.at(Level::Whole), "boundary"))
    }

    fn vector(&self, parts: [Spelled; 3]) -> Spelled {
        let parts = parts.map(|part| part.text).join(", ");
        Spelled::whole(format!("hedgerow::vector({parts})"))
    }

    fn choice(&self, condition: Spelled, then: Spelled, otherwise: Spelled) -> Spelled {
        let (condition, then) = (condition.at(Level::Or), then.at(Level::Or));
        Spelled::new(format!("{condition} ? {then} : {}", otherwise.text), Level::Choice)
    }

    fn to_real(&self, of: Spelled) -> Spelled {
        Spelled::whole(format!("static_cast<{}>({})", self.style.name("real"), of.text))
    }

    fn call(&self, function: Function, args: Vec<Spelled>) -> Spelled {
        let level = match function {
            Function::Remainder => Level::Product,
            _ => Level::Whole,
        };
        let call = with_pointers(spelled(function)[1], self.style);
        let call = match function {
            Function::Of(operation, ty) => with_types(&call, operation, ty, |ty| self.ty(ty)),
            _ => call,
        };
        Spelled::new(with_arguments(&qualified("", &call), &args, Level::Or), level)
    }

    fn invoke(&self, name: &str, args: Vec<Spelled>) -> Spelled {
        let args = args.into_iter().map(|arg| arg.at(Level::Or));
        let args = args.collect::<Vec<_>>().join(", ");
        Spelled::whole(format!("hedgerow::{}({args})", invoked(name)))
    }

    fn operator(&self, operator: Binary, args: &[Spelled; 2]) -> Option<Spelled> {
        let name = match operator {
            Binary::Div => "floor_div",
            Binary::Mod => "floor_mod",
            Binary::MultiplyVector => "multiply",
            Binary::EqualVector => "equal",
            _ => return None,
        };
        let args = args.clone().map(|arg| arg.at(Level::Or));
        Some(Spelled::whole(self.support(name, args.to_vec())))
    }

    fn some(&self, indices: &IndexLoop, condition: &Term) -> Spelled {
        let condition = self.text(condition);
        let condition = format!("[&](std::size_t {}) {{ return {condition}; }}", indices.index);
        Spelled::whole(self.support("some", vec![indices.size.clone(), condition]))
    }

    fn fold(&self, fold: &Fold) -> Spelled {
        let mut all = self.all_around(fold.around, &fold.element);
        let head = format!("[&]({} {})", self.ty(fold.variable.ty), fold.variable.name);
        if let Some(filter) = &fold.filter {
            let filter = self.text(filter);
            all = self.support("only", vec![all, format!("{head} {{ return {filter}; }}")]);
        }
        let zero = match fold.ty {
            Type::Vec3 => self.support("vector", vec!["0, 0, 0".into()]),
            Type::Int => "0LL".into(),
            ty => format!("{}(0)", self.ty(ty)),
        };
        let body = match (fold.body_type, fold.ty) {
            (Type::Int, Type::Real) => {
                let body = spell(self, &fold.body);
                self.to_real(body).text
            }
            _ => self.text(&fold.body),
        };
        let mut reads = false;
        let variable = &fold.variable.name;
        fold.body.names(&mut |name| reads |= name == variable);
        let head = match reads {
            true => head,
            false => format!("[&]({})", self.ty(fold.variable.ty)),
        };
        let body = format!("{head} {{ return {body}; }}");
        let of = format!("{}, {}", fold.ty.size(), self.ty(fold.ty));
        let [total, average] = ["total", "average"].map(|name| format!("{name}<{of}>"));
        let (name, args) = match fold.function {
            FoldFunction::Sum if is_wide(fold.ty) => (total.as_str(), vec![all, body]),
            FoldFunction::Mean if is_wide(fold.ty) => (average.as_str(), vec![all, body]),
            FoldFunction::Count => ("count", vec![all, body]),
            FoldFunction::Any => ("any", vec![all, body]),
            FoldFunction::All => ("all", vec![all, body]),
            FoldFunction::Sum => ("sum", vec![all, zero, body]),
            FoldFunction::Mean => ("mean", vec![all, zero, body]),
            FoldFunction::Min => ("least", vec![all, zero, body]),
            FoldFunction::Max => ("greatest", vec![all, zero, body]),
            FoldFunction::ArgMin => ("least_of", vec![all, body]),
            FoldFunction::ArgMax => ("greatest_of", vec![all, body]),
        };
        Spelled::whole(self.support(name, args))
    }
}

impl Printer<'_> {
    /// The elements around an element, as a list.
    pub(super) fn all_around(&self, around: Around, element: &Term) -> String {
        let [_, call] = builtin::around(around);
        with_arguments(&qualified("", call), &[spell(self, element)], Level::Choice)
    }
}
