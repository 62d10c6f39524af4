//! Arguments of a call, by position or by name.

use crate::diagnostic::Diagnostic;
use crate::run::{Argument, Prepared};

/// The arguments of a call: none (`()`), one value, a tuple of values in the order of the
/// parameters, or names with values. Parameters without an argument take their defaults.
///
/// ```
/// # use hedgerow::{Argument, Program, Session};
/// # fn main() -> Result<(), hedgerow::Error> {
/// # let program = Program::parse("p", "
/// # script move(by: vec3 = vec3(0, 0, 1), times: int = 1) {
/// #   repeat times { for v in vertices { v.position = v.position + by } }
/// # }")?;
/// # let mut session = Session::new(&program, hedgerow::mesh::shape::cube());
/// # let script = program.script("move")?;
/// session.run(&script, ())?;
/// session.run(&script, ([0.0, 1.0, 0.0], 3))?;
/// session.run(&script, [("times", 3)])?;
/// session.run(&script, [("times", Argument::from(3)), ("by", [0.0, 1.0, 0.0].into())])?;
/// # Ok(())
/// # }
/// ```
pub trait Arguments {
    /// Passes the arguments to `to`, one by one.
    fn give(self, to: &mut Given<'_>);
}

/// The arguments given so far.
pub struct Given<'g> {
    takes: &'g Prepared,
    values: &'g mut Vec<Option<Argument>>,
    next: usize,
    error: Option<Diagnostic>,
}

impl<'g> Given<'g> {
    /// No arguments yet.
    pub(super) fn new(takes: &'g Prepared, values: &'g mut Vec<Option<Argument>>) -> Self {
        values.clear();
        values.resize(takes.params().len(), None);
        Self { takes, values, next: 0, error: None }
    }

    /// Ends the list; fails with the first error, if there was one.
    pub(super) fn end(self) -> Result<(), Diagnostic> {
        self.error.map_or(Ok(()), Err)
    }

    /// Gives the next parameter a value.
    pub fn next(&mut self, value: impl Into<Argument>) {
        match self.values.get_mut(self.next) {
            Some(place) => *place = Some(value.into()),
            None => {
                let error = self.takes.too_many();
                self.error.get_or_insert(error);
            }
        }
        self.next += 1;
    }

    /// Gives the parameter with the given name a value.
    pub fn named(&mut self, name: &str, value: impl Into<Argument>) {
        if let Err(error) = self.takes.give(name, value.into(), self.values) {
            self.error.get_or_insert(error);
        }
    }
}

impl Arguments for () {
    fn give(self, _to: &mut Given<'_>) {}
}

impl<A: Into<Argument>> Arguments for A {
    fn give(self, to: &mut Given<'_>) {
        to.next(self);
    }
}

impl<N: AsRef<str>, A: Into<Argument>, const COUNT: usize> Arguments for [(N, A); COUNT] {
    fn give(self, to: &mut Given<'_>) {
        for (name, value) in self {
            to.named(name.as_ref(), value);
        }
    }
}

impl<N: AsRef<str>> Arguments for Vec<(N, Argument)> {
    fn give(self, to: &mut Given<'_>) {
        for (name, value) in self {
            to.named(name.as_ref(), value);
        }
    }
}

impl Arguments for Vec<Argument> {
    fn give(self, to: &mut Given<'_>) {
        for value in self {
            to.next(value);
        }
    }
}

macro_rules! tuples {
    ($($($name:ident)+;)*) => {
        $(impl<$($name: Into<Argument>),+> Arguments for ($($name,)+) {
            #[allow(non_snake_case)]
            fn give(self, to: &mut Given<'_>) {
                let ($($name,)+) = self;
                $(to.next($name);)+
            }
        })*
    };
}

tuples! {
    A;
    A B;
    A B C;
    A B C D;
    A B C D E;
    A B C D E F;
}
