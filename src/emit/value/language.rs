//! Pointers, numbers and calls, which each language spells in its own way.

use super::spellings::{spelling, with_arguments, with_types};
use super::term::{Precedence, Term};
use crate::diagram::{Binary, Pointer, Type};
use crate::emit::cpp::CALLED;
use crate::emit::cpp::support::{qualified, with_pointers};
use crate::emit::language::Language;
use crate::emit::names::{Attribute, IndexLoop};

/// The name of a pointer where it has to be unique among the pointers of all kinds of elements.
pub(in crate::emit) fn unique(pointer: Pointer) -> &'static str {
    match pointer {
        Pointer::VertexHalfedge => "vertex_halfedge",
        Pointer::EdgeHalfedge => "edge_halfedge",
        Pointer::FaceHalfedge => "face_halfedge",
        pointer => pointer.word(),
    }
}

impl Language<'_> {
    pub(super) fn int(self, value: i64) -> Term {
        if value == i64::MIN && !self.is_rust() {
            return Term::whole("(-9223372036854775807LL - 1)");
        }
        let precedence = if value < 0 { Precedence::Prefix } else { Precedence::Whole };
        let number = Term::of(value.to_string(), precedence, []);
        match i32::try_from(value) {
            Ok(_) => Term { is_literal: true, ..number },
            Err(_) => self.typed(number),
        }
    }

    /// An int with its type. A literal has that of what it is computed with; of a literal alone, it
    /// would have 32 bits.
    fn typed(self, int: Term) -> Term {
        let text = format!("{}{}", int.text, if self.is_rust() { "_i64" } else { "LL" });
        Term { text, is_literal: false, ..int }
    }

    /// Two values of one type, so that not both are literals.
    fn typed_pair(self, [left, right]: [Term; 2]) -> [Term; 2] {
        let both = left.is_literal && right.is_literal;
        [if both { self.typed(left) } else { left }, right]
    }

    pub(super) fn real(self, value: f64) -> Term {
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

    /// `of.pointer`
    pub fn follow(self, pointer: Pointer, of: &Term) -> Term {
        match pointer {
            Pointer::Prev if !self.has_prev() => self.call("Prev.Walk", [of]),
            pointer => self.call(&format!("{pointer:?}"), [of]),
        }
    }

    /// An attribute of an element; in C++ also where it is set.
    pub fn attribute(self, attribute: &Attribute, of: &Term) -> Term {
        let element = of.at(Precedence::Whole);
        let text = match self.style {
            None => {
                let (ty, column) = (self.ty(attribute.ty), &attribute.column);
                format!("attribute::<{ty}>(mesh, {column}, {element}.0)")
            }
            Some(style) => style.attribute(&element, &attribute.name),
        };
        Term::of(text, Precedence::Whole, [of])
    }

    /// `condition ? then : otherwise`
    pub fn choice(self, condition: &Term, [then, otherwise]: [Term; 2]) -> Term {
        let [then, otherwise] = &self.typed_pair([then, otherwise]);
        let precedence = if self.is_rust() { Precedence::Choice } else { Precedence::Or };
        let [test, chosen] = [condition, then].map(|part| part.at(precedence));
        let other = &otherwise.text;
        let text = say!(
            self,
            "if {test} {{ {chosen} }} else {{ {other} }}",
            "{test} ? {chosen} : {other}"
        );
        Term::of(text, Precedence::Choice, [condition, then, otherwise])
    }

    pub(super) fn to_real(self, of: &Term) -> Term {
        let (text, precedence) = match self.style {
            // `as` binds more tightly than a comparison, but `x as f64 < y` reads as a type.
            None => (format!("{} as f64", of.at(Precedence::Prefix)), Precedence::Compare),
            Some(style) => {
                (format!("static_cast<{}>({})", style.name("real"), of.text), Precedence::Whole)
            }
        };
        Term::of(text, precedence, [of])
    }

    pub(super) fn negative(self, of: &Term) -> Term {
        // In brackets if it has a sign itself: `--x` would mean something else.
        let negative = Term::of(format!("-{}", of.at(Precedence::Whole)), Precedence::Prefix, [of]);
        Term { is_literal: of.is_literal, ..negative }
    }

    /// An operator between two values, of which the left one has this type.
    pub(super) fn binary(self, operator: Binary, ty: Type, sides: [Term; 2]) -> Term {
        let name = if is_wide(ty) { format!("of.{operator:?}") } else { format!("{operator:?}") };
        match spelling(self, &name, ty) {
            "" => Term::infix(operator, self.typed_pair(sides)),
            _ => self.call_of(&name, (ty, 0), &sides),
        }
    }

    /// A builtin function of the language, or a support function of the emitted text, by its name
    /// among the spellings.
    pub fn call<'t>(self, name: &str, args: impl IntoIterator<Item = &'t Term>) -> Term {
        self.call_of(name, (Type::Bool, 0), args)
    }

    /// A call whose spelling depends on a type, and on the number of a part of it.
    pub(super) fn call_of<'t>(
        self,
        name: &str,
        (ty, part): (Type, u8),
        args: impl IntoIterator<Item = &'t Term>,
    ) -> Term {
        let spelling = spelling(self, name, ty);
        let (precedence, inner) = match (self.style, name) {
            (None, "MixReal") => (Precedence::Sum, Precedence::Product),
            (None, "of.Negate") => (Precedence::Prefix, Precedence::Choice),
            (_, "Remainder") => (Precedence::Product, Precedence::Choice),
            // After a call that ends with a type, `<` would begin generic arguments.
            (None, _) if spelling.ends_with("as i64") => (Precedence::Compare, Precedence::Choice),
            // Pointers are read of the arguments.
            (Some(_), _) if spelling.contains('[') => (Precedence::Whole, Precedence::Whole),
            _ => (Precedence::Whole, Precedence::Choice),
        };
        let call = with_types(self, spelling, (ty, part));
        let call = match self.style {
            None => call,
            Some(style) => with_pointers(&qualified("", &call), style),
        };
        let args: Vec<_> = args.into_iter().collect();
        Term::of(with_arguments(&call, &args, inner), precedence, args)
    }

    /// A call of a function of the program.
    pub(super) fn invoke(self, name: &str, args: &[Term]) -> Term {
        let texts = args.iter().map(|arg| arg.text.as_str());
        let mesh = self.is_rust().then_some("mesh");
        let list = mesh.into_iter().chain(texts).collect::<Vec<_>>().join(", ");
        Term::of(say!(self, "{name}({list})", "{CALLED}{name}({list})"), Precedence::Whole, args)
    }

    /// The condition that a condition holds for some index.
    pub fn for_some(self, IndexLoop { index, size }: &IndexLoop, condition: &Term) -> Term {
        let text = &condition.text;
        let text = say!(
            self,
            "(0..{size}).any(|{index}| {text})",
            "hedgerow::some({size}, [&](std::size_t {index}) {{ return {text}; }})"
        );
        Term::of(text, Precedence::Whole, [condition, &Term::name(size)])
    }
}

/// True if a mesh class may have no type for values of the type: they are vectors of two or four
/// components, or matrices. Vectors of three components always have a type, with operators.
pub(super) fn is_wide(ty: Type) -> bool {
    ty != Type::Vec3 && (ty.is_vector() || ty.is_matrix())
}

/// A number whose size has the given digits; `infinite` stands for infinity, and `none` for NaN.
fn number(value: f64, digits: String, [infinite, none]: [&str; 2]) -> Term {
    let text = match value.abs() {
        size if size.is_nan() => return Term::whole(none),
        size if size.is_infinite() => infinite.to_string(),
        _ => digits,
    };
    match value.is_sign_negative() {
        true => Term::of(format!("-{text}"), Precedence::Prefix, []),
        false => Term::whole(text),
    }
}
