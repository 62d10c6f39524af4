//! Terms as text.

use super::Printer;
use super::spelled::{Level, Spelled, infix, joined, negated, number, place, symbol, unique};
use super::spellings::{self, spelled, with_arguments, with_types};
use crate::diagram::{Binary, Builtin, Pointer, Unary};
use crate::emit::cpp::support::{qualified, with_pointers};
use crate::emit::names::invoked;
use crate::emit::term::{Attribute, Function, IndexLoop, Operation, Term};

/// From here on a number is written as a `long long` in C++.
const SHORT: i64 = 1 << 15;

impl Printer<'_> {
    /// The text of a term.
    pub fn text(&self, term: &Term) -> String {
        self.spell(term).text
    }

    /// A term that something is selected of, or that is passed to what selects it.
    pub(super) fn of(&self, term: &Term) -> String {
        match self.style {
            None => self.text(term),
            Some(_) => self.whole(term),
        }
    }

    /// A term in brackets, unless it needs none anywhere.
    pub(super) fn whole(&self, term: &Term) -> String {
        self.spell(term).at(Level::Whole)
    }

    pub(super) fn texts(&self, terms: &[Term]) -> Vec<String> {
        terms.iter().map(|term| self.text(term)).collect()
    }

    pub(super) fn spell(&self, term: &Term) -> Spelled {
        Spelled::whole(match term {
            Term::Name(name) => name.clone(),
            Term::Bool(value) => value.to_string(),
            Term::Int(value) => return self.int(*value),
            Term::Real(value) => return self.real(*value),
            Term::Follow(pointer, of) => self.follow(*pointer, &self.of(of)),
            Term::Attribute(attribute, of) => self.attribute(attribute, &self.whole(of)),
            Term::Unary(operator, of) => return self.unary(*operator, of),
            Term::Binary(operator, left, right) => {
                return self.binary(*operator, [left, right].map(|side| self.spell(side)));
            }
            Term::Call(Function::OfPreview(question), args) => {
                let args = self.texts(args);
                format!("{}.{question}({})", args[0], args[1..].join(", "))
            }
            Term::Call(function, args) => return self.call(*function, args),
            Term::Invoke(name, args) => self.invoke(name, args),
            Term::If(condition, then, otherwise) => {
                let [condition, then, otherwise] =
                    [condition, then, otherwise].map(|part| self.spell(part));
                return self.choice(condition, then, otherwise);
            }
            Term::Fold(fold) => self.aggregate(fold),
            Term::Some(IndexLoop { index, size }, condition) => {
                let condition = self.text(condition);
                say!(
                    self,
                    "(0..{size}).any(|{index}| {condition})",
                    "hedgerow::some({size}, [&](std::size_t {index}) {{ return {condition}; }})"
                )
            }
            Term::Member { list, index, shift, size } => {
                format!("{list}[{}]", place(index.as_deref(), *shift, size))
            }
        })
    }

    fn int(&self, value: i64) -> Spelled {
        match (value, self.style) {
            (i64::MIN, Some(_)) => Spelled::whole("(-9223372036854775807LL - 1)"),
            // Computations with larger ones could overflow an `int`.
            (SHORT.., Some(_)) => Spelled::whole(format!("{value}LL")),
            (0.., _) => Spelled::whole(value.to_string()),
            (_, None) => Spelled::new(value.to_string(), Level::Prefix),
            (_, Some(_)) => Spelled::new(format!("-{}", self.int(-value).text), Level::Prefix),
        }
    }

    fn real(&self, value: f64) -> Spelled {
        // With all digits, and with a decimal point or an exponent.
        let digits = format!("{:?}", value.abs());
        let Some(style) = self.style else {
            return number(value, digits, ["f64::INFINITY", "f64::NAN"]);
        };
        let real = style.name("real");
        let [infinite, none] =
            ["infinity", "quiet_NaN"].map(|what| format!("std::numeric_limits<{real}>::{what}()"));
        // With a `double`, the whole computation would be in `double`.
        let (value, digits) = match (real, value as f32) {
            ("float", short) => (short.into(), format!("{:?}f", short.abs())),
            _ => (value, digits),
        };
        number(value, digits, [&infinite, &none])
    }

    fn follow(&self, pointer: Pointer, of: &str) -> String {
        let Some(style) = self.style else {
            return format!("mesh.{}({of})", unique(pointer));
        };
        match pointer {
            Pointer::Target => style.chained(&style.chained(of, "twin"), "vertex"),
            Pointer::Prev if !style.has_prev() => format!("hedgerow::prev({of})"),
            pointer => style.chained(of, pointer.word()),
        }
    }

    /// An attribute of an element; in C++ also where it is set.
    pub(super) fn attribute(&self, attribute: &Attribute, of: &str) -> String {
        match self.style {
            None => {
                let (ty, column) = (self.ty(attribute.ty), &attribute.column);
                format!("attribute::<{ty}>(mesh, {column}, {of}.0)")
            }
            Some(style) => style.attribute(of, &attribute.name),
        }
    }

    fn choice(&self, condition: Spelled, then: Spelled, otherwise: Spelled) -> Spelled {
        let level = if self.style.is_none() { Level::Choice } else { Level::Or };
        let [condition, then] = [condition, then].map(|part| part.at(level));
        let otherwise = otherwise.text;
        let text = say!(
            self,
            "if {condition} {{ {then} }} else {{ {otherwise} }}",
            "{condition} ? {then} : {otherwise}"
        );
        Spelled::new(text, Level::Choice)
    }

    pub(super) fn to_real(&self, of: Spelled) -> Spelled {
        match self.style {
            // `as` binds more tightly than a comparison, but `x as f64 < y` reads as a type.
            None => Spelled::new(format!("{} as f64", of.at(Level::Prefix)), Level::Compare),
            Some(style) => {
                Spelled::whole(format!("static_cast<{}>({})", style.name("real"), of.text))
            }
        }
    }

    fn unary(&self, operator: Unary, of: &Term) -> Spelled {
        let sign = match operator {
            Unary::Not => {
                if let Some(negated) = negated(of) {
                    return self.spell(&negated);
                }
                "!"
            }
            Unary::NegateInt | Unary::NegateReal | Unary::NegateVector => "-",
            Unary::ToReal => return self.to_real(self.spell(of)),
        };
        if let Term::Binary(equal, left, right) = of
            && let (Unary::Not, ("==", level)) = (operator, symbol(*equal))
            && *equal != Binary::EqualVector
        {
            return joined("!=", level, [left, right].map(|side| self.spell(side)));
        }
        // In brackets if it has a sign itself: `--x` would mean something else.
        Spelled::new(format!("{sign}{}", self.whole(of)), Level::Prefix)
    }

    fn binary(&self, operator: Binary, sides: [Spelled; 2]) -> Spelled {
        let [rust, cpp] = spellings::operator(operator);
        let (call, level) = match self.style {
            None => (rust.to_string(), Level::Whole),
            Some(_) => (qualified("", cpp), Level::Choice),
        };
        match call.as_str() {
            "" => infix(operator, sides),
            call => Spelled::whole(with_arguments(call, &sides, level)),
        }
    }

    /// A builtin function of the language, or a support function of the emitted text.
    fn call(&self, function: Function, args: &[Term]) -> Spelled {
        let args: Vec<_> = args.iter().map(|arg| self.spell(arg)).collect();
        let [rust, cpp] = spelled(function);
        let call = match (self.style, function) {
            (None, Function::Of(Operation::Operator(operator), _)) => {
                let sides = args.try_into().expect("an operator has two sides");
                return infix(operator, sides);
            }
            (None, _) => rust.to_string(),
            (Some(style), _) => with_pointers(cpp, style),
        };
        let (level, inner) = match (self.style, function) {
            (None, Function::Builtin(Builtin::MixReal)) => (Level::Sum, Level::Product),
            (None, Function::Of(Operation::Negate, _)) => (Level::Prefix, Level::Choice),
            (_, Function::Named("Remainder")) => (Level::Product, Level::Choice),
            // After a call that ends with a type, `<` would begin generic arguments.
            (None, _) if call.ends_with("as i64") => (Level::Compare, Level::Choice),
            // Pointers are read of the arguments.
            (Some(_), _) if cpp.contains('[') => (Level::Whole, Level::Whole),
            _ => (Level::Whole, Level::Choice),
        };
        let call = with_types(&call, function, |ty| self.ty(ty));
        let call = if self.style.is_some() { qualified("", &call) } else { call };
        Spelled::new(with_arguments(&call, &args, inner), level)
    }

    /// A call of a function of the program.
    fn invoke(&self, name: &str, args: &[Term]) -> String {
        let args = args.iter().map(|arg| self.text(arg));
        let mesh = self.style.is_none().then(|| "mesh".to_string());
        let args = mesh.into_iter().chain(args).collect::<Vec<_>>().join(", ");
        let name = invoked(name);
        say!(self, "{name}({args})", "hedgerow::{name}({args})")
    }

    /// The elements around an element: in Rust an iterator, in C++ a list.
    pub(super) fn all_around(&self, around: &'static str, element: &Term) -> String {
        self.text(&Term::call(around, vec![element.clone()]))
    }
}
