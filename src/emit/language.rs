//! Terms as text: what C++ and Rust have in common, and where brackets are needed.

use super::term::{Attribute, Fold, Function, IndexLoop, Term};
use crate::diagram::{Binary, Pointer, Unary};

/// The precedence of the outermost operator of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Choice,
    Or,
    And,
    Compare,
    Sum,
    Product,
    Prefix,
    Whole,
}

/// A text and how tightly it binds.
#[derive(Clone, Debug)]
pub(super) struct Spelled {
    pub text: String,
    pub level: Level,
}

impl Spelled {
    pub fn new(text: impl Into<String>, level: Level) -> Self {
        Self { text: text.into(), level }
    }

    /// A text that needs no brackets anywhere.
    pub fn whole(text: impl Into<String>) -> Self {
        Self::new(text, Level::Whole)
    }

    /// The text, in brackets if it binds less tightly than `level`.
    pub fn at(self, level: Level) -> String {
        match self.level >= level {
            true => self.text,
            false => format!("({})", self.text),
        }
    }
}

/// A target language: everything that it spells in its own way.
pub(super) trait Language: Sized {
    fn text(&self, term: &Term) -> String {
        spell(self, term).text
    }

    fn real(&self, value: f64) -> Spelled;
    fn int(&self, value: i64) -> Spelled;
    fn follow(&self, pointer: Pointer, of: Spelled) -> Spelled;
    fn position(&self, of: Spelled) -> Spelled;
    fn attribute(&self, attribute: &Attribute, of: Spelled) -> Spelled;
    fn hole(&self, of: Spelled) -> Spelled;
    fn vector(&self, parts: [Spelled; 3]) -> Spelled;
    fn choice(&self, condition: Spelled, then: Spelled, otherwise: Spelled) -> Spelled;
    fn to_real(&self, of: Spelled) -> Spelled;
    /// A builtin function of the language, or a support function of the emitted text.
    fn call(&self, function: Function, args: Vec<Spelled>) -> Spelled;
    /// A function of the program.
    fn invoke(&self, name: &str, args: Vec<Spelled>) -> Spelled;
    /// An operator that is a call.
    fn operator(&self, operator: Binary, args: &[Spelled; 2]) -> Option<Spelled>;
    fn fold(&self, fold: &Fold) -> Spelled;
    /// The condition that something holds for some index.
    fn some(&self, indices: &IndexLoop, condition: &Term) -> Spelled;
}

/// The conditions under which an element is skipped: it is gone, or a filter rejects it.
pub(super) fn skipped(
    language: &impl Language,
    gone: Option<String>,
    filter: Option<&Term>,
) -> Vec<String> {
    let level = if gone.is_some() { Level::Or } else { Level::Choice };
    let others = filter.map(|filter| spell(language, &filter.clone().not()).at(level));
    gone.into_iter().chain(others).collect()
}

/// The name of a pointer where it has to be unique among the pointers of all kinds of elements.
pub(super) fn field(pointer: Pointer) -> &'static str {
    match pointer {
        Pointer::VertexHalfedge => "vertex_halfedge",
        Pointer::EdgeHalfedge => "edge_halfedge",
        Pointer::FaceHalfedge => "face_halfedge",
        pointer => pointer.word(),
    }
}

/// Spells a term.
pub(super) fn spell(language: &impl Language, term: &Term) -> Spelled {
    match term {
        Term::Name(name) => Spelled::whole(name),
        Term::Bool(value) => Spelled::whole(value.to_string()),
        Term::Int(value) => language.int(*value),
        Term::Real(value) => language.real(*value),
        Term::Follow(pointer, of) => language.follow(*pointer, spell(language, of)),
        Term::Position(of) => language.position(spell(language, of)),
        Term::Attribute(attribute, of) => language.attribute(attribute, spell(language, of)),
        Term::Hole(of) => language.hole(spell(language, of)),
        Term::Component(part, of) => {
            let name = ["x", "y", "z"][usize::from((*part).min(2))];
            Spelled::whole(format!("{}.{name}", spell(language, of).at(Level::Whole)))
        }
        Term::Vector(parts) => language.vector(parts.each_ref().map(|part| spell(language, part))),
        Term::Unary(operator, of) => unary(language, *operator, of),
        Term::Binary(operator, left, right) => {
            let sides = [left, right].map(|side| spell(language, side));
            let call = language.operator(*operator, &sides);
            call.unwrap_or_else(|| infix(*operator, sides))
        }
        Term::Call(Function::OfPreview(question), args) => {
            let texts: Vec<_> = args.iter().map(|arg| language.text(arg)).collect();
            Spelled::whole(format!("{}.{question}({})", texts[0], texts[1..].join(", ")))
        }
        Term::Call(function, args) => language.call(*function, spell_all(language, args)),
        Term::Invoke(name, args) => language.invoke(name, spell_all(language, args)),
        Term::If(condition, then, otherwise) => {
            let [condition, then, otherwise] =
                [condition, then, otherwise].map(|part| spell(language, part));
            language.choice(condition, then, otherwise)
        }
        Term::Fold(fold) => language.fold(fold),
        Term::Some(indices, condition) => language.some(indices, condition),
        Term::Member { list, index, shift, size } => {
            Spelled::whole(format!("{list}[{}]", place(index.as_deref(), *shift, size)))
        }
    }
}

fn spell_all(language: &impl Language, terms: &[Term]) -> Vec<Spelled> {
    terms.iter().map(|term| spell(language, term)).collect()
}

/// The index at a distance from `index`, or from 0, modulo the size of a list. Intermediate results
/// are never negative, since sizes are unsigned.
fn place(index: Option<&str>, shift: i64, size: &str) -> String {
    let far = shift.unsigned_abs();
    match (index, shift) {
        (None, 0) => "0".to_string(),
        (Some(index), 0) => index.to_string(),
        (None, 1..) => format!("{far} % {size}"),
        (Some(index), 1..) => format!("({index} + {far}) % {size}"),
        (None, -1) => format!("{size} - 1"),
        (Some(index), -1) => format!("({index} + {size} - 1) % {size}"),
        (None, _) => format!("({far} * {size} - {far}) % {size}"),
        (Some(index), _) => format!("({index} + {far} * {size} - {far}) % {size}"),
    }
}

fn unary(language: &impl Language, operator: Unary, of: &Term) -> Spelled {
    let sign = match operator {
        Unary::Not => {
            if let Some(negated) = negated(of) {
                return spell(language, &negated);
            }
            "!"
        }
        Unary::NegateInt | Unary::NegateReal | Unary::NegateVector => "-",
        Unary::ToReal => return language.to_real(spell(language, of)),
    };
    if let Term::Binary(equal, left, right) = of
        && let (Unary::Not, ("==", level)) = (operator, symbol(*equal))
        && *equal != Binary::EqualVector
    {
        return joined("!=", level, [left, right].map(|side| spell(language, side)));
    }
    // In brackets if it has a sign itself: `--x` would mean something else.
    let of = spell(language, of).at(Level::Whole);
    Spelled::new(format!("{sign}{of}"), Level::Prefix)
}

/// The negation of a comparison or of joined conditions, without a `not` in front of it.
fn negated(term: &Term) -> Option<Term> {
    let (operator, left, right) = match term {
        Term::Binary(operator, left, right) => (*operator, left, right),
        Term::Unary(Unary::Not, of) => return Some((**of).clone()),
        _ => return None,
    };
    let not = |term: &Term| Box::new(term.clone().not());
    Some(match operator {
        // Only of ints: reals may be incomparable.
        Binary::LessInt => Term::Binary(Binary::LessEqualInt, right.clone(), left.clone()),
        Binary::LessEqualInt => Term::Binary(Binary::LessInt, right.clone(), left.clone()),
        Binary::And => Term::Binary(Binary::Or, not(left), not(right)),
        Binary::Or => Term::Binary(Binary::And, not(left), not(right)),
        _ => return None,
    })
}

fn symbol(operator: Binary) -> (&'static str, Level) {
    match operator {
        Binary::AddInt | Binary::AddReal | Binary::AddVector => ("+", Level::Sum),
        Binary::SubtractInt | Binary::SubtractReal | Binary::SubtractVector => ("-", Level::Sum),
        Binary::MultiplyInt
        | Binary::MultiplyReal
        | Binary::MultiplyVector
        | Binary::ScaleVector
        | Binary::Transform
        | Binary::MultiplyMatrices => ("*", Level::Product),
        Binary::DivideReal | Binary::DivideVector => ("/", Level::Product),
        Binary::EqualInt
        | Binary::EqualReal
        | Binary::EqualBool
        | Binary::EqualVector
        | Binary::EqualText
        | Binary::EqualElement => ("==", Level::Compare),
        Binary::LessInt | Binary::LessReal => ("<", Level::Compare),
        Binary::LessEqualInt | Binary::LessEqualReal => ("<=", Level::Compare),
        Binary::And => ("&&", Level::And),
        Binary::Or => ("||", Level::Or),
        Binary::Div => ("/", Level::Product),
        Binary::Mod => ("%", Level::Product),
    }
}

/// The text of an operator between its sides.
pub(super) fn infix(operator: Binary, sides: [Spelled; 2]) -> Spelled {
    let (symbol, level) = symbol(operator);
    joined(symbol, level, sides)
}

fn joined(symbol: &str, level: Level, [left, right]: [Spelled; 2]) -> Spelled {
    let (left_level, right_level) = match level {
        Level::Compare => (Level::Sum, Level::Sum),
        // Mixed `and` and `or` read better in brackets, and C++ warns without them.
        Level::Or if left.level == Level::And || right.level == Level::And => {
            (Level::Compare, Level::Compare)
        }
        Level::Or | Level::And => (level, level),
        Level::Sum => (Level::Sum, Level::Product),
        _ => (level, Level::Prefix),
    };
    let (left, right) = (left.at(left_level), right.at(right_level));
    Spelled::new(format!("{left} {symbol} {right}"), level)
}

/// A number with all its digits, and with a decimal point or an exponent; `infinite` stands for
/// infinity, and `none` for NaN.
pub(super) fn number(value: f64, [infinite, none]: [&str; 2]) -> Spelled {
    signed(value, format!("{:?}", value.abs()), [infinite, none])
}

/// The same for a `float` in C++.
pub(super) fn short_number(value: f64, [infinite, none]: [&str; 2]) -> Spelled {
    let short = value as f32;
    signed(short.into(), format!("{:?}f", short.abs()), [infinite, none])
}

fn signed(value: f64, digits: String, [infinite, none]: [&str; 2]) -> Spelled {
    let text = match value.abs() {
        size if size.is_nan() => return Spelled::whole(none),
        size if size.is_infinite() => infinite.to_string(),
        _ => digits,
    };
    match value.is_sign_negative() {
        true => Spelled::new(format!("-{text}"), Level::Prefix),
        false => Spelled::whole(text),
    }
}
